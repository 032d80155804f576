//! Cases whose solutions are known: closed forms, manufactured ones, and refined ones.
//!
//! | case | solution | what it shows |
//! | --- | --- | --- |
//! | [`kojima_shindo`], regular and degenerate | closed form | the usual small problem |
//! | [`cournot_10`] | refined | powers, dense |
//! | [`walras`] | refined | sums of powers, dense, free goods at price 0 |
//! | [`murty`] | closed form | worst case of pivoting |
//! | [`hilbert`] | refined | condition 10¹⁰ |
//! | [`obstacle`] | refined | sparse, large |
//! | [`badly_scaled`] | manufactured | units that differ by 10¹², degenerate pairs |
//! | [`double_root`], [`powell_singular`] | closed form | singular: linear convergence |
//! | [`weak_acid`] | refined | differences stall: a concentration of 1e-10 |

mod acid;
mod cournot;
mod scaled;
mod walras;

pub use acid::weak_acid;
pub use cournot::cournot_10;
pub use scaled::{badly_scaled, chain};
pub use walras::walras;

use super::{AccuracyError, Case, DoubleDouble, Reference};
use crate::scalar::Scalar;
use crate::testing::affine::{Affine, hilbert_matrix, murty_matrix, obstacle_model};
use crate::testing::classic::kojima_shindo_model;
use crate::testing::collection::{double_root_model, powell_singular_model};

/// Kojima & Shindo (1986) from `(1, 1, 1, 1)`, which leads to the regular solution, or from
/// `(1, 0, 0, 0)`, which leads to the degenerate one; both are references of both. With the Jacobian
/// by hand.
///
/// # Errors
/// None in practice.
pub fn kojima_shindo(regular: bool) -> Result<Case, AccuracyError> {
    let root = DoubleDouble::from(1.5).sqrt();
    let degenerate = Reference::closed_form([root, 0.0.into(), 0.0.into(), 0.5.into()]);
    let (name, start) = if regular {
        ("kojima-shindo", [1.0; 4])
    } else {
        ("kojima-shindo degenerate", [1.0, 0.0, 0.0, 0.0])
    };
    let case = Case::new(name, kojima_shindo_model()?)
        .from(&start)
        .solved_by(Reference::closed_form([1.0, 0.0, 3.0, 0.0]))
        .solved_by(degenerate)
        .by_hand(|z, jac| {
            let [x1, x2] = [z[0], z[1]];
            // Column by column.
            jac.copy_from_slice(
                &[
                    [6.0 * x1 + 2.0 * x2, 4.0 * x1 + 1.0, 6.0 * x1 + x2, 2.0 * x1],
                    [2.0 * x1 + 4.0 * x2, 2.0 * x2, x1 + 4.0 * x2, 6.0 * x2],
                    [1.0, 10.0, 2.0, 2.0],
                    [3.0, 2.0, 9.0, 3.0],
                ]
                .concat(),
            );
        });
    Ok(case)
}

/// Murty's family ([Mur78](crate#references)), solved by `e_n`.
///
/// # Errors
/// None in practice.
pub fn murty(n: usize) -> Result<Case, AccuracyError> {
    let solution = (0..n).map(|i| if i + 1 == n { 1.0 } else { 0.0 });
    let model = Affine::new(0, vec![-1.0; n], murty_matrix)?;
    Ok(Case::new(format!("murty {n}"), model).affine().solved_by(Reference::closed_form(solution)))
}

/// The Hilbert matrix with `q = −1`.
///
/// # Errors
/// As [`Case::refined`].
pub fn hilbert(n: usize) -> Result<Case, AccuracyError> {
    let model = Affine::new(0, vec![-1.0; n], hilbert_matrix)?;
    Case::new(format!("hilbert {n}"), model).affine().refined()
}

/// The membrane over an obstacle of [`testing::obstacle`](crate::testing::obstacle) on `k × k` nodes.
///
/// # Errors
/// As [`Case::refined`].
pub fn obstacle(k: usize) -> Result<Case, AccuracyError> {
    Case::new(format!("obstacle {k}x{k}"), obstacle_model(k)?).affine().refined()
}

/// `(x − 1)² ⟂ x >= 0` from 3: a double root, where Newton's method gains a factor 2 a step. The
/// bound is a solution as well.
///
/// # Errors
/// None in practice.
pub fn double_root() -> Result<Case, AccuracyError> {
    let case = Case::new("double root", double_root_model()?);
    let [root, bound] = [1.0, 0.0].map(|x| Reference::closed_form([x]));
    Ok(case.solved_by(root).solved_by(bound))
}

/// Powell's singular function ([MGH81](crate#references)): `J` has rank 2 at the root 0.
///
/// # Errors
/// None in practice.
pub fn powell_singular() -> Result<Case, AccuracyError> {
    let case = Case::new("powell singular", powell_singular_model()?);
    Ok(case.solved_by(Reference::closed_form([0.0; 4])))
}

/// All cases of the study; `nodes` are those of a side of the obstacle problem.
///
/// # Errors
/// Of the cases.
pub fn all(nodes: usize) -> Result<Vec<Case>, AccuracyError> {
    Ok(vec![
        kojima_shindo(true)?,
        kojima_shindo(false)?,
        cournot_10()?,
        walras(50)?,
        murty(32)?,
        hilbert(8)?,
        obstacle(nodes)?,
        badly_scaled(24)?,
        double_root()?,
        powell_singular()?,
        weak_acid()?,
    ])
}

#[cfg(test)]
mod tests {
    use super::super::Source;
    use super::*;
    use crate::problem::Problem;

    #[test]
    fn references_solve_their_cases_to_the_last_digit_of_plain_numbers() {
        for case in all(10).unwrap() {
            let z = case.solution().unwrap();
            let mut problem = case.problem(Source::Jet).unwrap();
            let certificate = crate::examine(&mut problem, &z).unwrap();
            assert!(certificate.relative_residual < 1e-14, "{}: {certificate:?}", case.name);
            assert_eq!(case.error(&z).unwrap(), 0.0_f64.max(case.error(&z).unwrap()));
            assert!(case.error(&z).unwrap() <= f64::EPSILON, "{}", case.name);
        }
    }

    #[test]
    fn jacobians_by_hand_agree_with_jets() {
        for case in [kojima_shindo(true).unwrap(), cournot_10().unwrap(), badly_scaled(24).unwrap()]
        {
            let z: Vec<f64> = case.solution().unwrap().iter().map(|z| 1.01 * z + 0.1).collect();
            let of = |source| {
                let mut problem = case.problem(source).unwrap();
                let mut jac = vec![0.0; problem.pattern().nnz()];
                problem.evaluate(&z, None, Some(&mut jac));
                jac
            };
            for (jet, by_hand) in of(Source::Jet).into_iter().zip(of(Source::ByHand)) {
                assert!(
                    (jet - by_hand).abs() <= 1e-13 * jet.abs(),
                    "{}: {jet} {by_hand}",
                    case.name
                );
            }
        }
    }
}
