//! Strong regularity of degenerate solutions, by the signs of determinants.

use super::accuracy::Degeneracy;
use super::krawczyk::relative_block;
use super::pairs::Pairs;
use crate::model::Shape;
use crate::problem::Pattern;
use crate::solver::Certifier;
use nalgebra::DMatrix;

/// Most degenerate pairs whose `2^k` choices are looked at.
const MOST: usize = 10;
/// A determinant below this, relative to the product of the lengths of its rows, has no sign.
const NO_SIGN: f64 = 1e-10;

/// Whether `det J_SS` has one sign for `S = α ∪ σ`, all `σ ⊂ β`: `α` are the pairs off their bounds
/// that are not degenerate, `β` the degenerate ones. With the Schur complement
/// `M = J_ββ − J_βα J_αα⁻¹ J_αβ` that is `det M_σσ > 0` for all `σ`: `M` is a P-matrix, which
/// [Rob80](crate#references) calls strong regularity. Upper bounds turn two signs in every minor.
pub(super) fn of(
    shape: &Shape,
    pairs: &Pairs,
    beta: &[usize],
    certifier: &Certifier,
    pattern: &Pattern,
) -> Degeneracy {
    if beta.len() > MOST {
        return Degeneracy::TooMany;
    }
    let alpha: Vec<usize> = pairs.off.iter().copied().filter(|i| !beta.contains(i)).collect();
    let block =
        |rows: &[usize], columns: &[usize]| relative_block(pattern, certifier, rows, columns);
    let within = block(&alpha, &alpha).lu();
    let Some(response) = (match alpha.len() {
        0 => Some(DMatrix::zeros(0, beta.len())),
        _ => within.solve(&block(&alpha, beta)),
    }) else {
        return Degeneracy::Singular;
    };
    let schur = block(beta, beta) - block(beta, &alpha) * response;
    for chosen in 1..1_usize << beta.len() {
        let sigma: Vec<usize> = (0..beta.len()).filter(|k| chosen >> k & 1 == 1).collect();
        let minor = schur.select_rows(&sigma).select_columns(&sigma);
        let lengths: f64 = minor.row_iter().map(|row| row.norm()).product();
        if !(minor.determinant() > NO_SIGN * lengths) {
            let pairs = sigma.iter().map(|&k| shape.variable_name(beta[k])).collect();
            return Degeneracy::Irregular { pairs };
        }
    }
    Degeneracy::Regular
}
