//! [`Linear`]: the choice of a linear solver.

use std::fmt;
use std::str::FromStr;

use super::{FaerDenseLu, FaerSparseLu, LinearError, LinearSolver, NalgebraLu, StackLu};
use crate::problem::Pattern;

/// Orders below this are solved on the stack by [`Linear::Auto`].
const STACK_BELOW: usize = 16;

/// Orders up to this are solved densely without blocks by [`Linear::Auto`].
const UNBLOCKED_UP_TO: usize = 100;

/// Patterns with more than this share of nonzeros are solved densely by [`Linear::Auto`].
const SPARSE_UP_TO: f64 = 0.2;

/// Which [`LinearSolver`] to use. Written and read as `auto`, `stack`, `nalgebra`, `faer-dense`,
/// `faer-sparse`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Linear {
    /// By order and density: [`StackLu`] for `n < 16`, [`NalgebraLu`] for `n <= 100`, above that
    /// [`FaerSparseLu`] for at most 20 % of nonzeros and [`FaerDenseLu`] for more. Newton systems that are
    /// sparse and whose `J` is symmetric, up to factors of its rows, are given to
    /// [`FaerCholesky`](super::FaerCholesky) first.
    #[default]
    Auto,
    /// [`StackLu`], for `n <= 16`.
    Stack,
    /// [`NalgebraLu`].
    Nalgebra,
    /// [`FaerDenseLu`].
    FaerDense,
    /// [`FaerSparseLu`].
    FaerSparse,
}

impl Linear {
    /// Every choice, [`Linear::Auto`] first.
    pub const ALL: [Linear; 5] =
        [Linear::Auto, Linear::Stack, Linear::Nalgebra, Linear::FaerDense, Linear::FaerSparse];

    /// What [`Linear::Auto`] stands for with this pattern; any other choice is itself. `O(1)`.
    #[must_use]
    pub fn resolve(self, pattern: &Pattern) -> Linear {
        let n = pattern.n();
        match self {
            Linear::Auto if n < STACK_BELOW => Linear::Stack,
            Linear::Auto if n <= UNBLOCKED_UP_TO => Linear::Nalgebra,
            Linear::Auto if density(pattern) <= SPARSE_UP_TO => Linear::FaerSparse,
            Linear::Auto => Linear::FaerDense,
            chosen => chosen,
        }
    }

    /// This choice, or [`Linear::Auto`] where the order is too large for it.
    #[must_use]
    pub(crate) fn for_order(self, pattern: &Pattern) -> Linear {
        if self == Linear::Stack && pattern.n() > StackLu::LIMIT { Linear::Auto } else { self }
    }

    /// A solver for matrices of this pattern, not yet analysed. Cost: the allocation of the box.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`] if [`Linear::Stack`] is asked for more than 16 unknowns.
    pub fn solver_for(self, pattern: &Pattern) -> Result<Box<dyn LinearSolver>, LinearError> {
        let n = pattern.n();
        Ok(match self.resolve(pattern) {
            Linear::Stack if n > StackLu::LIMIT => {
                return Err(LinearError::TooLarge { n, limit: StackLu::LIMIT });
            }
            Linear::Stack => Box::new(StackLu::new()),
            Linear::Nalgebra => Box::new(NalgebraLu::new()),
            Linear::FaerDense => Box::new(FaerDenseLu::new()),
            Linear::FaerSparse | Linear::Auto => Box::new(FaerSparseLu::new()),
        })
    }

    fn as_str(self) -> &'static str {
        match self {
            Linear::Auto => "auto",
            Linear::Stack => "stack",
            Linear::Nalgebra => "nalgebra",
            Linear::FaerDense => "faer-dense",
            Linear::FaerSparse => "faer-sparse",
        }
    }
}

/// Share of structural nonzeros; 1 for the matrix of order 0.
fn density(pattern: &Pattern) -> f64 {
    let n = pattern.n() as f64;
    if n > 0.0 { pattern.nnz() as f64 / (n * n) } else { 1.0 }
}

impl fmt::Display for Linear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A word that names no linear solver.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{word}` is no linear solver: auto, stack, nalgebra, faer-dense or faer-sparse expected")]
pub struct UnknownLinear {
    /// The word.
    pub word: String,
}

impl FromStr for Linear {
    type Err = UnknownLinear;

    fn from_str(word: &str) -> Result<Self, UnknownLinear> {
        Linear::ALL
            .into_iter()
            .find(|choice| choice.as_str() == word)
            .ok_or_else(|| UnknownLinear { word: word.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tridiagonal(n: usize) -> Pattern {
        Pattern::from_columns((0..n).map(|j| (j.saturating_sub(1)..n.min(j + 2)).collect()))
    }

    /// The first `filled` columns full, nothing else.
    fn columns_filled(n: usize, filled: usize) -> Pattern {
        Pattern::from_columns((0..n).map(|j| if j < filled { (0..n).collect() } else { vec![] }))
    }

    #[test]
    fn auto_goes_by_order_and_density() {
        let chosen = |pattern: &Pattern| Linear::Auto.resolve(pattern);
        assert_eq!(chosen(&Pattern::dense(0)), Linear::Stack);
        assert_eq!(chosen(&Pattern::dense(15)), Linear::Stack);
        assert_eq!(chosen(&Pattern::dense(16)), Linear::Nalgebra);
        assert_eq!(chosen(&tridiagonal(100)), Linear::Nalgebra);
        assert_eq!(chosen(&tridiagonal(101)), Linear::FaerSparse);
        assert_eq!(chosen(&Pattern::dense(101)), Linear::FaerDense);
        assert_eq!(chosen(&columns_filled(200, 40)), Linear::FaerSparse);
        assert_eq!(chosen(&columns_filled(200, 41)), Linear::FaerDense);
    }

    #[test]
    fn an_explicit_choice_is_kept_whatever_the_pattern() {
        for choice in Linear::ALL {
            for pattern in [Pattern::dense(3), tridiagonal(300)] {
                let kept = choice.resolve(&pattern) == choice;
                assert_eq!(kept, choice != Linear::Auto);
            }
        }
    }

    #[test]
    fn every_choice_makes_its_solver() {
        let name = |choice: Linear| choice.solver_for(&Pattern::dense(16)).unwrap().name();
        assert_eq!(name(Linear::Auto), "nalgebra dense LU");
        assert_eq!(name(Linear::Stack), "stack LU");
        assert_eq!(name(Linear::Nalgebra), "nalgebra dense LU");
        assert_eq!(name(Linear::FaerDense), "faer dense LU");
        assert_eq!(name(Linear::FaerSparse), "faer sparse LU");
    }

    #[test]
    fn the_stack_solver_is_refused_above_its_limit() {
        let error = Linear::Stack.solver_for(&Pattern::dense(17)).err();
        assert_eq!(error, Some(LinearError::TooLarge { n: 17, limit: 16 }));
    }

    #[test]
    fn names_are_read_as_they_are_written() {
        for choice in Linear::ALL {
            assert_eq!(choice.to_string().parse(), Ok(choice));
        }
        let unknown = UnknownLinear { word: "umfpack".to_owned() };
        assert_eq!("umfpack".parse::<Linear>(), Err(unknown));
        assert_eq!(format!("{:>8}", Linear::Stack), "   stack");
    }
}
