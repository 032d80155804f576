//! Ten firms with their Jacobian by hand.

use super::super::{AccuracyError, Case};
use crate::testing::collection::{TEN_FIRMS, TenFirms, ten_firms_model};

/// The Cournot game of ten firms ([`collection`](crate::testing::collection), `nash10-2`), with the
/// Jacobian by hand. With `p = (5000/Q)^(1/γ)`, `p' = −p/(γQ)`:
///
/// ```text
/// F_i      = c_i + (L q_i)^(1/β_i) − p + q_i p/(γQ)
/// ∂F_i/∂q_j = −p' + q_i (p' − p/Q)/(γQ) + [i = j] ((L q_i)^(1/β_i)/(β_i q_i) + p/(γQ))
/// ```
///
/// # Errors
/// As [`Case::refined`].
pub fn cournot_10() -> Result<Case, AccuracyError> {
    let case = Case::new("cournot 10", ten_firms_model()?).from(&[10.0; 10]);
    let case = case.by_hand(|q, jac| {
        let TenFirms { l, beta, gamma, .. } = TEN_FIRMS;
        let total: f64 = q.iter().sum();
        let p = (5000.0 / total).powf(1.0 / gamma);
        let slope = -p / (gamma * total);
        for (j, column) in jac.chunks_mut(q.len()).enumerate() {
            for (i, entry) in column.iter_mut().enumerate() {
                *entry = -slope + q[i] * (slope - p / total) / (gamma * total);
                if i == j {
                    let power = (l * q[i]).powf(1.0 / beta[i]);
                    *entry += power / (beta[i] * q[i]) + p / (gamma * total);
                }
            }
        }
    });
    case.refined()
}
