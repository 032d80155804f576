//! The answer to a modelling system: `.sol` files.
//!
//! ```text
//! message                       any number of lines, none empty
//!
//! Options
//! 3                             the options of the first line of the .nl file,
//! 1                             two more announced if a tolerance follows
//! 1
//! 0
//! 4                             rows
//! 4                             values of rows that follow
//! 4                             variables
//! 4                             levels that follow
//! 0.5                           values of rows, then levels
//! …
//! objno 0 0                     objective 0: none; the solve result
//! ```
//!
//! Solve results are those of AMPL: 0–99 solved, 100–199 doubtful, 200–299 infeasible, 300–399
//! unbounded, 400–499 stopped by a limit, 500–599 failed. Source: [Gay97](mcp_core#references).

use super::NlModel;
use std::io::{self, Write};

impl NlModel {
    /// The text of a `.sol` file; arguments as for [`write_sol`](Self::write_sol).
    pub fn sol(&self, z: &[f64], f: &[f64], message: &str, solve_result: u16) -> String {
        let mut text = Vec::new();
        // Writing to memory does not fail.
        let _ = self.write_sol(&mut text, z, f, message, solve_result);
        String::from_utf8_lossy(&text).into_owned()
    }

    /// Writes a `.sol` file: `message`, the [values of the rows](Self::row_values) as dual values,
    /// the levels of the file's variables, AMPL's code `solve_result`. Numbers have all their
    /// digits. With an empty `z`, for a model without an answer, there are no values.
    ///
    /// ```
    /// use mcp_cli::nl::{Names, NlModel};
    /// let nl = "g3 1 1 0\n 1 1 0 0 1\n 0 0\n 0 0\n 0 0 0\n 0 0 0 1\n 0 0 0 0 0\n 1 0\n 0 0\n 0 0 0 0 0\n\
    ///           C0\nn0\nr\n4 6\nb\n3\nJ0 1\n0 2\n"; // 2 z = 6
    /// let model = NlModel::parse(nl.as_bytes(), Names::default())?;
    /// let sol = model.sol(&[3.0], &[0.0], "solved", 0);
    /// assert_eq!(sol, "solved\n\nOptions\n3\n1\n1\n0\n1\n1\n1\n1\n0\n3\nobjno 0 0\n");
    /// # Ok::<(), mcp_cli::nl::NlError>(())
    /// ```
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_sol(
        &self,
        out: &mut impl Write,
        z: &[f64],
        f: &[f64],
        message: &str,
        solve_result: u16,
    ) -> io::Result<()> {
        // An empty line would end the message.
        for line in message.trim_end().lines() {
            writeln!(out, "{}", if line.trim().is_empty() { " " } else { line })?;
        }
        let (options, tolerance) = self.sol_options();
        let announced = options.len() + if tolerance.is_some() { 2 } else { 0 };
        writeln!(out, "\nOptions\n{announced}")?;
        for option in options {
            writeln!(out, "{option}")?;
        }
        let (rows, levels) = if z.is_empty() {
            (Vec::new(), z)
        } else {
            (self.row_values(z, f), self.file_levels(z))
        };
        for count in [self.constraints(), rows.len(), self.variables(), levels.len()] {
            writeln!(out, "{count}")?;
        }
        if let Some(tolerance) = tolerance {
            writeln!(out, "{}", Digits(tolerance))?;
        }
        for &value in rows.iter().chain(levels) {
            writeln!(out, "{}", Digits(value))?;
        }
        writeln!(out, "objno 0 {solve_result}")
    }
}

/// The shortest decimal number that is read as the same `f64`.
struct Digits(f64);

impl std::fmt::Display for Digits {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-5..1e16).contains(&size) || !size.is_finite() {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}
