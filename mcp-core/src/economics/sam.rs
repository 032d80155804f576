//! [`Sam`]: a social accounting matrix.

use crate::error::{did_you_mean, nearest};
#[cfg(feature = "serde")]
use crate::language::input::{CsvSource, Sheet};
use crate::language::{DataError, Table};
use crate::model::Set;
use std::fmt;
#[cfg(feature = "serde")]
use std::path::Path;

/// Receipts and payments of an account may differ by this part of all its flows.
const BALANCE: f64 = 1e-9;

/// A social accounting matrix: the account of a row receives what the account of a column pays.
///
/// It is balanced: every account receives as much as it pays, to `1e-9` of the sizes of its flows. Units are
/// those of the data, all the same. In a file an empty cell is 0.
///
/// ```
/// use mcp_core::economics::Sam;
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let sam = Sam::new(["bread", "labor", "household"], [
///     [0.0, 0.0, 100.0], // bread is sold to the household,
///     [100.0, 0.0, 0.0], // labor to bakers,
///     [0.0, 100.0, 0.0], // and the household receives wages.
/// ])?;
/// assert_eq!(sam.get("bread", "household")?, 100.0);
/// assert_eq!(sam.total("labor")?, 100.0);
///
/// let told = Sam::new(["bread", "labor"], [[0.0, 90.0], [100.0, 0.0]]).unwrap_err();
/// assert_eq!(told.to_string(), "account `bread` receives 90 but pays 100");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sam {
    accounts: Set,
    /// Rows one after the other.
    flows: Vec<f64>,
    #[cfg(feature = "serde")]
    file: Option<String>,
}

/// What is wrong with a social accounting matrix. Every message names the account or the cell.
///
/// `file` is the file and a colon, or nothing.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SamError {
    /// An account receives more or less than it pays.
    #[error("{file}account `{account}` receives {receipts} but pays {payments}")]
    Unbalanced {
        /// The account.
        account: String,
        /// Sum of its row.
        receipts: f64,
        /// Sum of its column.
        payments: f64,
        /// The file.
        file: String,
    },
    /// A flow that has to be positive or 0 is negative.
    #[error("{file}cell [{row}, {column}] is {flow}: this flow may not be negative")]
    Negative {
        /// The account that receives.
        row: String,
        /// The account that pays.
        column: String,
        /// The flow.
        flow: f64,
        /// The file.
        file: String,
    },
    /// A flow is NaN or infinite.
    #[error("{file}cell [{row}, {column}] is {flow}: give a number")]
    NotFinite {
        /// The account that receives.
        row: String,
        /// The account that pays.
        column: String,
        /// The flow.
        flow: f64,
        /// The file.
        file: String,
    },
    /// An account has a row but no column.
    #[error("{file}account `{account}` has a row but no column{}", did_you_mean(.nearest.as_deref()))]
    NoColumn {
        /// The account.
        account: String,
        /// A column with a similar name.
        nearest: Option<String>,
        /// The file.
        file: String,
    },
    /// An account has a column but no row.
    #[error("{file}account `{account}` has a column but no row{}", did_you_mean(.nearest.as_deref()))]
    NoRow {
        /// The account.
        account: String,
        /// A row with a similar name.
        nearest: Option<String>,
        /// The file.
        file: String,
    },
    /// An account that the matrix does not have.
    #[error("{file}there is no account `{account}`{}", did_you_mean(.nearest.as_deref()))]
    UnknownAccount {
        /// The name asked for.
        account: String,
        /// The nearest account.
        nearest: Option<String>,
        /// The file.
        file: String,
    },
    /// Labels, shape or file, as in any table.
    #[error(transparent)]
    Data(#[from] DataError),
    /// Accounts that make no set.
    #[error(transparent)]
    Accounts(crate::ModelError),
}

/// As [`Display`](fmt::Display): what `main` prints of an error it returns.
impl fmt::Debug for SamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Sam {
    /// A matrix from a list of accounts and one row of flows for each, the columns in the same order.
    ///
    /// # Errors
    /// [`SamError`] names the account or the cell.
    pub fn new<L: Into<String>>(
        accounts: impl IntoIterator<Item = L>,
        flows: impl Into<Table>,
    ) -> Result<Self, SamError> {
        let accounts = Set::new("accounts", accounts).map_err(SamError::Accounts)?;
        let flows = flows.into().resolve("flow", &[&accounts, &accounts])?;
        let sam = Sam {
            accounts,
            flows,
            #[cfg(feature = "serde")]
            file: None,
        };
        sam.checked()
    }

    /// The matrix in a CSV file: the accounts stand in the first column and, in any order, in the
    /// header.
    ///
    /// # Errors
    /// [`SamError`] names the account or the cell.
    #[cfg(feature = "serde")]
    pub fn csv(path: impl AsRef<Path>) -> Result<Self, SamError> {
        Self::from_sheet(&CsvSource::file(path).sheet("sam")?)
    }

    /// The matrix in a CSV text; messages call the text `name`.
    ///
    /// # Errors
    /// As [`Sam::csv`].
    #[cfg(feature = "serde")]
    pub fn csv_text(name: impl Into<String>, text: impl Into<String>) -> Result<Self, SamError> {
        Self::from_sheet(&CsvSource::text(name, text).sheet("sam")?)
    }

    #[cfg(feature = "serde")]
    fn from_sheet(sheet: &Sheet) -> Result<Self, SamError> {
        let file = || format!("{}: ", sheet.file);
        let rows = sheet.rows.iter().map(|(_, row)| row[0].to_owned());
        let accounts = Set::new("accounts", rows).map_err(SamError::Accounts)?;
        let headers = &sheet.header[1..];
        let mut column_of = vec![None; accounts.len()];
        for (column, header) in headers.iter().enumerate() {
            let Ok(account) = accounts.index_of(header) else {
                let (account, nearest) = (header.clone(), nearest_label(&accounts, header));
                return Err(SamError::NoRow { account, nearest, file: file() });
            };
            if column_of[account].replace(column + 1).is_some() {
                let (column, place) = (header.clone(), sheet.place(sheet.header_line));
                return Err(DataError::DuplicateColumn { column, place }.into());
            }
        }
        if let Some(account) = column_of.iter().position(Option::is_none) {
            let account = accounts.label(account);
            let nearest = nearest(&account, headers.iter().map(String::as_str));
            return Err(SamError::NoColumn { account, nearest, file: file() });
        }
        let mut flows = Vec::with_capacity(accounts.len().pow(2));
        for (line, row) in &sheet.rows {
            for column in column_of.iter().flatten() {
                flows.push(if row[*column].is_empty() {
                    0.0
                } else {
                    sheet.number(*line, row, *column)?
                });
            }
        }
        Sam { accounts, flows, file: Some(sheet.file.clone()) }.checked()
    }

    fn checked(self) -> Result<Self, SamError> {
        let n = self.accounts.len();
        if let Some(cell) = self.flows.iter().position(|flow| !flow.is_finite()) {
            let (row, column) = (self.accounts.label(cell / n), self.accounts.label(cell % n));
            return Err(SamError::NotFinite {
                row,
                column,
                flow: self.flows[cell],
                file: self.file(),
            });
        }
        for account in 0..n {
            let (receipts, payments) = (self.receipts(account), self.payments(account));
            // Sums that overflow are not balanced.
            let is_balanced = (receipts - payments).abs() <= BALANCE * self.size(account);
            if !is_balanced {
                let (account, file) = (self.accounts.label(account), self.file());
                return Err(SamError::Unbalanced { account, receipts, payments, file });
            }
        }
        Ok(self)
    }

    fn receipts(&self, account: usize) -> f64 {
        let n = self.accounts.len();
        self.flows[account * n..][..n].iter().sum()
    }

    fn payments(&self, account: usize) -> f64 {
        self.flows.iter().skip(account).step_by(self.accounts.len()).sum()
    }

    /// `Σ |flow|` of what the account receives or of what it pays, the larger: negative flows cancel in
    /// the sums, rounding errors do not.
    fn size(&self, account: usize) -> f64 {
        let n = self.accounts.len();
        let row: f64 = self.flows[account * n..][..n].iter().map(|flow| flow.abs()).sum();
        let column = self.flows.iter().skip(account).step_by(n).map(|flow| flow.abs());
        row.max(column.sum())
    }

    /// Where the matrix comes from, to stand before a message.
    fn file(&self) -> String {
        #[cfg(feature = "serde")]
        return self.file.as_ref().map(|file| format!("{file}: ")).unwrap_or_default();
        #[cfg(not(feature = "serde"))]
        String::new()
    }

    /// The accounts in the order of the rows.
    pub fn accounts(&self) -> &Set {
        &self.accounts
    }

    fn account(&self, name: &str) -> Result<usize, SamError> {
        self.accounts.index_of(name).map_err(|_| {
            let (account, nearest) = (name.to_owned(), nearest_label(&self.accounts, name));
            SamError::UnknownAccount { account, nearest, file: self.file() }
        })
    }

    /// What the account of the row receives from the account of the column.
    ///
    /// # Errors
    /// [`SamError::UnknownAccount`] with the nearest name.
    pub fn get(&self, row: &str, column: &str) -> Result<f64, SamError> {
        Ok(self.flows[self.account(row)? * self.accounts.len() + self.account(column)?])
    }

    /// What an account receives in all, which is what it pays.
    ///
    /// # Errors
    /// [`SamError::UnknownAccount`] with the nearest name.
    pub fn total(&self, account: &str) -> Result<f64, SamError> {
        Ok(self.receipts(self.account(account)?))
    }

    /// Flows from some accounts to others as data of a model, `value[rows, columns]`: rows receive,
    /// columns pay.
    ///
    /// # Errors
    /// [`SamError::Negative`] for a negative flow, [`SamError::UnknownAccount`].
    pub fn block(&self, rows: &[&str], columns: &[&str]) -> Result<Table, SamError> {
        let cells = rows.iter().flat_map(|&row| columns.iter().map(move |&column| (row, column)));
        let keyed = cells.map(|cell| Ok((cell, self.flow(cell.0, cell.1)?)));
        Ok(Table::from(keyed.collect::<Result<Vec<_>, SamError>>()?))
    }

    /// What one account receives from some others, `value[columns]`.
    ///
    /// # Errors
    /// As [`block`](Self::block).
    pub fn row(&self, row: &str, columns: &[&str]) -> Result<Table, SamError> {
        let keyed = columns.iter().map(|&column| Ok((column, self.flow(row, column)?)));
        Ok(Table::from(keyed.collect::<Result<Vec<_>, SamError>>()?))
    }

    /// What one account pays to some others, `value[rows]`.
    ///
    /// # Errors
    /// As [`block`](Self::block).
    pub fn column(&self, rows: &[&str], column: &str) -> Result<Table, SamError> {
        let keyed = rows.iter().map(|&row| Ok((row, self.flow(row, column)?)));
        Ok(Table::from(keyed.collect::<Result<Vec<_>, SamError>>()?))
    }

    /// A flow that may not be negative.
    fn flow(&self, row: &str, column: &str) -> Result<f64, SamError> {
        let flow = self.get(row, column)?;
        if flow < 0.0 {
            let (row, column) = (row.to_owned(), column.to_owned());
            return Err(SamError::Negative { row, column, flow, file: self.file() });
        }
        Ok(flow)
    }
}

/// The label of a set that is nearest to a name, if one is near.
fn nearest_label(set: &Set, name: &str) -> Option<String> {
    let labels: Vec<String> = set.labels().collect();
    nearest(name, labels.iter().map(String::as_str))
}

#[cfg(test)]
#[path = "sam_tests.rs"]
mod tests;
