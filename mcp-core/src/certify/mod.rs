//! Certificate of accuracy: a proof, by interval arithmetic, that exactly one solution is near.
//!
//! A residual says how well equations hold, not how far a solution is. [`certify`] evaluates the model
//! over boxes around the point, with every rounding outwards ([`Interval`] states
//! the assumption), and either proves that a box holds exactly one solution or says why it cannot.
//!
//! # The proof
//!
//! The point `z` says which pairs are active: `A`, at a bound or nearer to it, in relative terms, than
//! their `F` to 0; the others are `I`. `X` is the box of all `x` in the bounds with
//! `|x_j − z_j| <= ρ h_j`, where `h_j` are at first the weights `w_j` of the
//! [`Certificate`](crate::Certificate). With `c` the point `z`, moved to the bounds in `A`, any matrix
//! `Y` (near the inverse of the midpoints of `G`) and an interval matrix `G` that contains `F_I'(x)` by `x_I` for all `x` in
//! `X`, the operator of Krawczyk ([Kra69](crate#references), [Neu90](crate#references) section 5.1) is
//!
//! ```text
//! K(X) = c_I − Y F_I(c) + (1 − Y G)(X_I − c_I).
//! ```
//!
//! If `K(X)` lies in the interior of `X_I`, then `F_I(x_I, c_A) = 0` has exactly one solution in
//! `X_I`. If moreover `F_i > 0` on all of `X` for pairs active at a lower bound, `F_i < 0` at an upper
//! one, and `X_I` touches no bound, then in `X` the complementarity problem has that solution and no
//! other: where `F_i` has a strict sign the variable must be at its bound, and off the bounds
//! `F_i` must be 0. Boxes grow from twice the Newton step, and
//! change their shape where they are not mapped nearer, until one succeeds or growing is in vain.
//!
//! # What it refuses
//!
//! - **Degenerate pairs**, whose variable is at its bound while `F` is 0: no box decides them, and none
//!   is widened until it does. For at most ten of them the answer says whether the solution is *strongly
//!   regular* ([Rob80](crate#references)), isolated and stable: whether `det J` of the pairs in `I`
//!   and any of the degenerate ones has one sign, for all `2^k` choices. This is computed in ordinary
//!   numbers, and it is no proof that a solution exists.
//! - **Singular active blocks**: rays of solutions, double roots.
//! - Functions that are undefined, jump or have an infinite slope in the box, and
//!   [`external`](crate::external()) functions, which are known at points only.
//!
//! The proof is about `F` with the numbers of the model as they are: data are `f64`, and what a model
//! computes from data alone, in `f64`, is data.
//!
//! Cost: dense; for `m` pairs in `I` a box takes `m/8` evaluations of `F` with 8 interval lanes
//! and `m³` interval products. More than 500 such pairs are refused ([`Refusal::TooLarge`]).

mod accuracy;
mod boxes;
mod infeasible;
mod krawczyk;
mod pairs;
mod regularity;
#[cfg(test)]
mod tests;

pub use accuracy::{Accuracy, Degeneracy, Proof, Refusal, Weakest};
pub use infeasible::{Infeasible, infeasible};

use crate::error::ModelError;
use crate::model::{Model, Shape};
use crate::problem::{AdProblem, Pattern};
use crate::scalar::Interval;
use crate::solver::{Certifier, Solution};
use boxes::OverBoxes;
use krawczyk::{ActiveSystem, Attempt};
use pairs::Pairs;

/// Most pairs off their bounds: beyond, dense interval matrices take minutes.
const MOST_OFF: usize = 500;
/// Condition beyond which a block counts as singular: no digit of its inverse is right.
const SINGULAR: f64 = 1e15;
/// A margin below which a pair that could not be decided is called degenerate: `√eps`.
const DEGENERATE: f64 = 1.5e-8;
/// How often boxes change their shape.
const SHAPES: usize = 8;
/// Boxes are tried up to this size, relative to the point.
const LARGEST_RADIUS: f64 = 1e-2;

/// Proves that exactly one solution of `model` lies near `solution`, or says why not; the
/// [module page](self) has the proof.
///
/// The point, the bounds and the parameters are those of the solution, whatever its status and
/// whatever the model says now.
///
/// # Errors
/// [`ModelError::Length`] if the solution belongs to another model; as [`AdProblem::new`].
///
/// ```
/// use mcp_core::{Options, Proof, Real, Scalar, certify, mcp_fn, solve};
/// /// x² = 2 and 1 + x ⟂ y >= 0.
/// #[mcp_fn(lower = [0, 0], start = 1)]
/// fn root<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
///     [x * x - 2.0, 1.0 + x - y]
/// }
/// let model = Root::new()?;
/// let solution = solve(&model, &Options::default())?;
/// let accuracy = certify(&model, &solution)?;
/// assert!(matches!(accuracy.proof, Proof::Proved { radius } if radius < 1e-8));
/// assert!(accuracy.enclosure[0].contains(2_f64.sqrt()));
/// println!("{accuracy}"); // a unique solution lies within … (relative) of the point
/// # Ok::<(), mcp_core::ModelError>(())
/// ```
pub fn certify<M: Model>(model: &M, solution: &Solution) -> Result<Accuracy, ModelError> {
    let mut problem = AdProblem::of_solution(model, solution)?;
    let external = match problem.check_second_order() {
        Err(ModelError::NoSecondOrder { equation }) => Some(equation),
        other => other.map(|()| None)?,
    };
    Ok(accuracy_at(&mut problem, &solution.z, external))
}

/// Not generic: compiled here, not with every model.
fn accuracy_at(problem: &mut dyn OverBoxes, z: &[f64], external: Option<String>) -> Accuracy {
    let mut certifier = Certifier::default();
    certifier.resize(z.len(), problem.pattern().nnz());
    let found = certifier.judge(problem, z);
    let shape = problem.shape().clone();
    if !found.is_finite {
        let is_infinite = |i: &usize| !certifier.f()[*i].is_finite();
        let by_slope = || Some(problem.pattern().first_not_finite(certifier.jac())?.1);
        let i = (0..z.len()).find(is_infinite).or_else(by_slope);
        let equation = shape.equation_name(i.unwrap_or(found.worst));
        return Accuracy::unknown(Refusal::NotFinite { equation });
    }
    let pairs = Pairs::at(z, &shape, &certifier);
    let weakest =
        pairs.weakest().map(|(i, margin)| Weakest { variable: shape.variable_name(i), margin });
    let off = pairs.off.len();
    if off > MOST_OFF {
        let refusal = Refusal::TooLarge { off, limit: MOST_OFF };
        return Accuracy { weakest, ..Accuracy::unknown(refusal) };
    }
    let mut system = ActiveSystem::new(problem, z, &pairs, &certifier);
    let mut accuracy = Accuracy {
        weakest,
        condition: system.condition,
        newton_step: system.newton_step,
        ..Accuracy::unknown(Refusal::Singular { movable: Vec::new() })
    };
    let attempt = match external {
        Some(equation) => Attempt::Refused(Refusal::External { equation }),
        None => attempts(problem, &mut system, &pairs),
    };
    accuracy.proof = match attempt {
        Attempt::Proved { enclosure, radius } => {
            accuracy.enclosure = enclosure;
            Proof::Proved { radius }
        }
        Attempt::Refused(refusal @ (Refusal::External { .. } | Refusal::NotDefined { .. })) => {
            Proof::Refused(refusal)
        }
        Attempt::Undecided(undecided) => {
            Proof::Refused(degenerate(&shape, &pairs, &undecided, &certifier, problem.pattern()))
        }
        Attempt::Refused(refusal) => {
            let weak = pairs.weaker_than(DEGENERATE);
            Proof::Refused(if weak.is_empty() {
                refusal
            } else {
                degenerate(&shape, &pairs, &weak, &certifier, problem.pattern())
            })
        }
    };
    accuracy
}

/// Boxes of growing size, until one decides.
fn attempts(problem: &dyn OverBoxes, system: &mut ActiveSystem<'_>, pairs: &Pairs) -> Attempt {
    if !(system.condition <= SINGULAR) {
        let movable = system.movable(problem.shape(), &pairs.off);
        return Attempt::Refused(Refusal::Singular { movable });
    }
    let mut radius = (2.0 * system.newton_step).max(pairs.gap).max(4.0 * f64::EPSILON);
    let mut shapes = 0;
    loop {
        match system.attempt(problem, pairs, radius) {
            Ok(attempt) => return attempt,
            Err(contraction) if contraction < 1.0 && radius < LARGEST_RADIUS => radius *= 8.0,
            Err(contraction)
                if contraction.is_finite() && contraction >= 1.0 && shapes < SHAPES =>
            {
                shapes += 1;
            }
            Err(contraction) => {
                return Attempt::Refused(Refusal::NoContraction { radius, contraction });
            }
        }
    }
}

fn degenerate(
    shape: &Shape,
    pairs: &Pairs,
    undecided: &[usize],
    certifier: &Certifier,
    pattern: &Pattern,
) -> Refusal {
    let regularity = regularity::of(shape, pairs, undecided, certifier, pattern);
    let pairs = undecided.iter().map(|&i| shape.variable_name(i)).collect();
    Refusal::Degenerate { pairs, regularity }
}

/// Interval `z` without width.
fn points(z: &[f64]) -> Vec<Interval> {
    z.iter().map(|&z| Interval::point(z)).collect()
}
