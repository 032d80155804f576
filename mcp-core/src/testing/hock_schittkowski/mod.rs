//! Karush–Kuhn–Tucker systems of problems of [HS81](crate#references), with their published starts
//! and solutions: 76 problems, 1 to 53 without 13 and 25, and 25 of those after.
//!
//! Constraints are numbered as in the book, equations after inequalities, bounds apart; the variables
//! are `x[1]`, …, `lambda[1]`, …. Multipliers start at 0. Where the book prints a solution in few
//! digits, it is given as printed; closed forms are evaluated.
//!
//! ```
//! use mcp_core::testing::hock_schittkowski;
//! let hs71 = hock_schittkowski::all()?.into_iter().find(|p| p.number == 71).expect("it is here");
//! assert!((hs71.objective(&hs71.x) - hs71.f).abs() < 1e-5);
//! let problem = hs71.problem()?;
//! assert_eq!(problem.shape().start(), [1.0, 5.0, 5.0, 1.0, 0.0, 0.0]);
//! # Ok::<(), mcp_core::ModelError>(())
//! ```

mod equations;
mod mixed;
mod quadratic;
#[cfg(test)]
mod tests;
mod three;
mod two;

use crate::error::ModelError;
use crate::kkt::{Constraint, Kkt, Program};
use crate::model::{Set, Variable};
use crate::problem::{AdProblem, Problem};
use crate::scalar::{Real, Scalar};
use std::fmt;

const FREE: f64 = f64::NEG_INFINITY;
const INF: f64 = f64::INFINITY;

/// A problem of the book as its Karush–Kuhn–Tucker system.
pub struct HockSchittkowski {
    /// Its number in the book.
    pub number: u16,
    /// The solution `x*`, in the digits of the book or evaluated from its closed form.
    pub x: Vec<f64>,
    /// The optimal value `f*`, likewise.
    pub f: f64,
    system: Box<dyn System>,
}

/// What a problem asks of its model, whatever its type.
trait System: Send + Sync {
    fn problem(&self) -> Result<Box<dyn Problem + '_>, ModelError>;
    fn objective(&self, x: &[f64]) -> f64;
}

impl<P: Program + Send + Sync> System for Kkt<P> {
    fn problem(&self) -> Result<Box<dyn Problem + '_>, ModelError> {
        Ok(Box::new(AdProblem::new(self)?))
    }
    fn objective(&self, x: &[f64]) -> f64 {
        let x: Vec<Real<f64>> = x.iter().map(Real::from).collect();
        self.program().objective(&x).into_scalar()
    }
}

impl HockSchittkowski {
    /// Name for tables, such as `hs71`.
    pub fn name(&self) -> String {
        format!("hs{}", self.number)
    }

    /// Number of variables, without multipliers.
    pub fn n(&self) -> usize {
        self.x.len()
    }

    /// The system, with exact derivatives, starting as the book does with all multipliers 0.
    ///
    /// # Errors
    /// None in practice: the problems are well formed.
    pub fn problem(&self) -> Result<Box<dyn Problem + '_>, ModelError> {
        self.system.problem()
    }

    /// `f(x)` of the first `n` numbers of `z`.
    ///
    /// # Panics
    /// If `z` has fewer than [`n`](Self::n) numbers.
    pub fn objective(&self, z: &[f64]) -> f64 {
        self.system.objective(&z[..self.n()])
    }

    fn new<P: Program + Send + Sync + 'static>(
        (number, program): (u16, P),
        kinds: &[fn(String, f64) -> Constraint],
        (lower, upper): (Vec<f64>, Vec<f64>),
        start: &[f64],
        (x, f): (Vec<f64>, f64),
    ) -> Result<Self, ModelError> {
        let numbers = Set::count("variables", x.len());
        let variable = Variable::new("x").over(&[&numbers]).lower(lower).upper(upper).start(start);
        let mut system = Kkt::minimise(program).variable(variable);
        for (k, constraint) in kinds.iter().enumerate() {
            system = system.constraint(constraint((k + 1).to_string(), 0.0));
        }
        let system = Box::new(system.build()?);
        Ok(HockSchittkowski { number, x, f, system })
    }
}

impl fmt::Debug for HockSchittkowski {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("HockSchittkowski")
            .field("number", &self.number)
            .field("x", &self.x)
            .field("f", &self.f)
            .finish_non_exhaustive()
    }
}

/// Functions of the problem with this number.
struct Hs<const NUMBER: u16>;

/// All variables of a problem of fixed size.
fn variables<D: Scalar, const N: usize>(x: &[Real<D>]) -> [Real<D>; N] {
    std::array::from_fn(|j| x[j])
}

/// Problems as `number [variables] min f(x), [kind g(x), …], bounds (l, u), start, x*, f*`, and the
/// function `problems` that makes them all.
macro_rules! problems {
    ($(
        $(#[$about:meta])*
        $number:literal [$($x:ident),*] min $f:expr,
        [$($kind:ident $g:expr),* $(,)?],
        in ($lower:expr, $upper:expr), start $start:expr, x $solution:expr, f $value:expr;
    )*) => {
        $(
            $(#[$about])*
            #[allow(unused_variables, unused_mut, reason = "a function need not use all, or be there")]
            impl $crate::kkt::Program for super::Hs<$number> {
                fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
                    let [$($x),*] = super::variables(x);
                    Real::from(0.0) + $f
                }
                fn constraint<D: Scalar>(&self, k: usize, x: &[Real<D>]) -> Real<D> {
                    let [$($x),*] = super::variables::<D, { [$(stringify!($x)),*].len() }>(x);
                    let mut number = 0..;
                    $(
                        if number.next() == Some(k) {
                            return $g;
                        }
                    )*
                    Real::from(f64::NAN)
                }
            }
        )*

        pub(super) fn problems() -> Result<Vec<HockSchittkowski>, ModelError> {
            Ok(vec![$(
                HockSchittkowski::new(
                    ($number, super::Hs::<$number>),
                    &[$(Constraint::$kind),*],
                    ($lower.to_vec(), $upper.to_vec()),
                    &$start,
                    ($solution.to_vec(), $value),
                )?
            ),*])
        }
    };
}
use problems;

/// All problems in the order of their numbers.
///
/// # Errors
/// None in practice: the problems are well formed.
pub fn all() -> Result<Vec<HockSchittkowski>, ModelError> {
    let mut all = two::problems()?;
    all.extend(three::problems()?);
    all.extend(quadratic::problems()?);
    all.extend(equations::problems()?);
    all.extend(mixed::problems()?);
    all.sort_by_key(|problem| problem.number);
    Ok(all)
}
