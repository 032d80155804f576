//! A [`PointCheck`] as text.

use super::{PointCheck, PointRow, Violation, WrongPoint};
use crate::report::format::{clean, number, size};
use std::fmt;

/// Equations that `Display` lists.
const LISTED: usize = 10;

/// Such as ``F = -3 is negative although `x` is at its lower bound 0 (residual 3)``, after the names.
impl fmt::Display for PointRow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let variable = clean(&self.variable);
        if let Some(equation) = &self.equation {
            write!(f, "`{}` ⟂ ", clean(equation))?;
        }
        write!(f, "`{variable}`: ")?;
        let (level, value) = (number(self.level), number(self.f.unwrap_or(f64::NAN)));
        let (lower, upper) = (number(self.lower), number(self.upper));
        match self.violation {
            None => write!(f, "holds")?,
            Some(Violation::NotFinite) if !self.level.is_finite() => {
                return write!(f, "the level {level} is not finite");
            }
            Some(Violation::NotFinite) => return write!(f, "F = {value} is not finite"),
            Some(Violation::BelowLower) => {
                write!(f, "the level {level} is below the lower bound {lower}")?;
            }
            Some(Violation::AboveUpper) => {
                write!(f, "the level {level} is above the upper bound {upper}")?;
            }
            Some(Violation::NegativeAtLower) => write!(
                f,
                "F = {value} is negative although `{variable}` is at its lower bound {lower}"
            )?,
            Some(Violation::PositiveAtUpper) => write!(
                f,
                "F = {value} is positive although `{variable}` is at its upper bound {upper}"
            )?,
            Some(Violation::NotZeroBetween) => {
                write!(f, "F = {value} is not 0 although `{variable}` = {level} is ")?;
                match (self.lower.is_finite(), self.upper.is_finite()) {
                    (true, false) => write!(f, "above its lower bound {lower}")?,
                    (false, true) => write!(f, "below its upper bound {upper}")?,
                    _ => write!(f, "between its bounds {lower} and {upper}")?,
                }
            }
            Some(Violation::NotZeroFree) => {
                write!(f, "F = {value} is not 0 although `{variable}` is free")?;
            }
        }
        write!(f, " (residual {})", size(self.residual))
    }
}

impl fmt::Display for PointCheck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (certificate, residual) = (&self.certificate, size(self.residual()));
        let Some(fault) = self.default_fault() else {
            return write!(f, "the point is a solution: residual {residual}");
        };
        write!(f, "the point is not a solution: residual {residual}")?;
        if certificate.is_finite && certificate.worst_relative < self.z.len() {
            let (relative, i) = (certificate.relative_residual, certificate.worst_relative);
            let name = self.shape.equation_name(i);
            write!(f, ", relative residual {} (`{}`)", size(relative), clean(&name))?;
        }
        if !matches!(fault, WrongPoint::Violated { .. }) {
            write!(f, "\n{fault}")?;
        }
        for row in self.violated().take(LISTED) {
            write!(f, "\n {row}")?;
        }
        let violated = self.order.iter().filter(|(i, _)| self.violation(*i).is_some());
        match violated.count().saturating_sub(LISTED) {
            0 => Ok(()),
            more => write!(f, "\n … and {more} more"),
        }
    }
}
