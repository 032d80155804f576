//! Known problems with published starts and solutions (feature `testing`).
//!
//! [`collection`] has 237 problems and [`judge()`] says whether a point solves one of them; below are
//! problems of the Siconos comparison, in sizes of your choice.
//!
//! For tests and benchmarks of solvers: every problem says where it comes from, and a solution found
//! is accepted by the certificate, not by comparison with one known point: several problems have
//! more than one solution.
//!
//! ```
//! use mcp_core::{Method, Options, Solver, testing};
//! let mut known = testing::kojima_shindo()?;
//! let mut solver = Solver::new(Options::new(Method::NewtonMinFb))?;
//! for start in &known.starts {
//!     assert!(solver.solve_from(&mut known.problem, start)?.is_solved());
//! }
//! # Ok::<(), mcp_core::ModelError>(())
//! ```

pub(crate) mod affine;
pub(crate) mod classic;
pub mod collection;
pub mod hock_schittkowski;
mod judge;
mod kkt;
mod zhuravlev_ivanov;

pub use affine::{
    Affine, ahn, cyclic, fathi, hilbert, murty, obstacle, siconos_2x2, siconos_tridiagonal,
};
pub use classic::{billups, josephy, kojima_shindo, log_equation, watson4};
pub use judge::{Enumeration, Judgement, enumerate_affine, judge};
pub use kkt::{nocedal_16_4, rosen_suzuki};
pub use zhuravlev_ivanov::{ZhuravlevIvanov, ZhuravlevIvanovStepper, zhuravlev_ivanov_step};

use crate::error::ModelError;
use crate::model::{Equation, Model, Set, Shape, Variable};
use crate::problem::{AdProblem, Problem};

/// A problem with what is known about it.
pub struct Known {
    /// Name for tables, such as `murty-8`.
    pub name: String,
    /// The problem.
    pub problem: Box<dyn Problem>,
    /// Published starts.
    pub starts: Vec<Vec<f64>>,
    /// Known solutions; there may be others.
    pub solutions: Vec<Vec<f64>>,
}

impl Known {
    fn new<M: Model + 'static>(
        name: impl Into<String>,
        model: M,
        starts: Vec<Vec<f64>>,
        solutions: Vec<Vec<f64>>,
    ) -> Result<Self, ModelError> {
        let problem = Box::new(AdProblem::new(model)?);
        Ok(Known { name: name.into(), problem, starts, solutions })
    }
}

/// `n` variables of which the first `equalities` are free and the others nonnegative, as Siconos
/// orders them.
fn equalities_first(n: usize, equalities: usize) -> Result<Shape, ModelError> {
    let lower: Vec<f64> =
        (0..n).map(|i| if i < equalities { f64::NEG_INFINITY } else { 0.0 }).collect();
    let rows = Set::count("rows", n);
    Shape::builder()
        .variable(Variable::new("z").over(&[&rows]).lower(lower))
        .equation(Equation::new("w").over(&[&rows]).complements("z"))
        .build()
}

/// The small problems, the tests of Siconos and the LCP families at order 8.
///
/// # Errors
/// None in practice: the problems are well formed.
pub fn all() -> Result<Vec<Known>, ModelError> {
    Ok(vec![
        siconos_2x2(1)?,
        siconos_2x2(0)?,
        siconos_tridiagonal(5, false)?,
        siconos_tridiagonal(7, true)?,
        zhuravlev_ivanov_step()?,
        kojima_shindo()?,
        josephy()?,
        watson4()?,
        nocedal_16_4()?,
        rosen_suzuki()?,
        murty(8)?,
        fathi(8)?,
        ahn(8)?,
        cyclic(1.0)?,
        cyclic(-1.0)?,
        hilbert(8)?,
        obstacle(8)?,
    ])
}
