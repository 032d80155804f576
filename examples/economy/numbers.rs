//! Numbers of a scenario file, checked: those of known names, in their range.

use super::effects::{At, FileError, Source};
use super::file::Numbers;

/// Parts of a whole sum to 1 up to the rounding of decimals.
const ROUNDING: f64 = 1e-12;

/// What a number may be.
#[derive(Clone, Copy)]
pub(crate) enum Range {
    /// At least 0, and 0 where the file has none.
    Rate,
    /// Above 0, and infinite where the file has none.
    Limit,
}

/// What stands under a key of a file, such as `tax.rate`.
pub(crate) struct Key<'a> {
    source: &'a Source<'a>,
    key: String,
}

impl<'a> Key<'a> {
    pub(crate) fn new(source: &'a Source<'a>, key: impl Into<String>) -> Self {
        Key { source, key: key.into() }
    }

    /// The numbers of these names; the file need not have all.
    pub(crate) fn named<const N: usize>(
        &self,
        numbers: &Numbers,
        names: [&str; N],
        range: Range,
    ) -> Result<[f64; N], FileError> {
        let otherwise = match range {
            Range::Rate => 0.0,
            Range::Limit => f64::INFINITY,
        };
        Ok(self.found(numbers, names, range)?.map(|number| number.unwrap_or(otherwise)))
    }

    /// The numbers of these names, each of which the file has.
    pub(crate) fn all<const N: usize>(
        &self,
        numbers: &Numbers,
        names: [&str; N],
        range: Range,
    ) -> Result<[f64; N], FileError> {
        let found = self.found(numbers, names, range)?;
        if let Some(missing) = found.iter().position(Option::is_none) {
            let message = format!("has no number for {}", names[missing]);
            return Err(self.source.error(numbers.span(), &*self.key, message));
        }
        Ok(found.map(Option::unwrap_or_default))
    }

    /// The parts of a whole that these names have.
    pub(crate) fn parts<const N: usize>(
        &self,
        numbers: &Numbers,
        names: [&str; N],
    ) -> Result<[f64; N], FileError> {
        let parts = self.named(numbers, names, Range::Rate)?;
        let sum: f64 = parts.iter().sum();
        if !((sum - 1.0).abs() <= ROUNDING) {
            let message = format!("the parts sum to {sum}, but must sum to 1");
            return Err(self.source.error(numbers.span(), &*self.key, message));
        }
        Ok(parts)
    }

    fn found<const N: usize>(
        &self,
        numbers: &Numbers,
        names: [&str; N],
        range: Range,
    ) -> Result<[Option<f64>; N], FileError> {
        let mut found = [None; N];
        for (name, number) in numbers.get_ref() {
            let position = self.position(name, &names)?;
            let key = Key::new(self.source, format!("{}.{}", self.key, name.get_ref()));
            found[position] = Some(key.number(number, range)?);
        }
        Ok(found)
    }

    /// Where a name stands among these.
    pub(crate) fn position(&self, name: &At<String>, names: &[&str]) -> Result<usize, FileError> {
        let found = names.iter().position(|known| known == name.get_ref());
        found.ok_or_else(|| {
            let message = format!("there is no `{}`: choose {}", name.get_ref(), names.join(", "));
            self.source.error(name.span(), &*self.key, message)
        })
    }

    /// A number in its range.
    pub(crate) fn number(&self, number: &At<f64>, range: Range) -> Result<f64, FileError> {
        let x = *number.get_ref();
        let (is_within, allowed) = match range {
            Range::Rate => (x >= 0.0 && x.is_finite(), "finite and at least 0"),
            Range::Limit => (x > 0.0, "positive"),
        };
        if !is_within {
            let message = format!("is {x}, but must be {allowed}");
            return Err(self.source.error(number.span(), &*self.key, message));
        }
        Ok(x)
    }
}
