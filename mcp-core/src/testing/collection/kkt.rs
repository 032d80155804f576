//! Powell's problem: minimise `exp(x1 x2 x3 x4 x5)` under three equations, as a KKT system.

use super::Instance;
use crate::error::ModelError;
use crate::mcp_fn;
use crate::scalar::{Real, Scalar, prod, sum};
use std::array::from_fn;

/// `Σ x² = 10`, `x2 x3 = 5 x4 x5`, `x1³ + x2³ = −1`.
fn constraints<D: Scalar>(x: [Real<D>; 5]) -> [Real<D>; 3] {
    let [x1, x2, x3, x4, x5] = x;
    [sum(x, |x| x * x) - 10, x2 * x3 - 5 * x4 * x5, x1.powi(3) + x2.powi(3) + 1]
}

/// `∇ exp(Π x) − Σ λ_k ∇h_k`.
fn lagrangian_gradient<D: Scalar>(x: [Real<D>; 5], lambda: [Real<D>; 3]) -> [Real<D>; 5] {
    let [x1, x2, x3, x4, x5] = x;
    let zero = 0.0 * x1;
    let e = prod(x, |x| x).exp();
    let objective: [Real<D>; 5] = from_fn(|i| e * prod((0..5).filter(|&j| j != i), |j| x[j]));
    let h2 = [zero, x3, x2, -5 * x5, -5 * x4];
    let h3 = [3 * x1 * x1, 3 * x2 * x2, zero, zero, zero];
    from_fn(|i| objective[i] - (2 * x[i] * lambda[0] + h2[i] * lambda[1] + h3[i] * lambda[2]))
}

/// Equations with free multipliers.
#[mcp_fn]
fn powell<D: Scalar>([x1, x2, x3, x4, x5, l1, l2, l3]: [Real<D>; 8]) -> [Real<D>; 8] {
    let x = [x1, x2, x3, x4, x5];
    let [f1, f2, f3, f4, f5] = lagrangian_gradient(x, [l1, l2, l3]);
    let [h1, h2, h3] = constraints(x);
    [f1, f2, f3, f4, f5, h1, h2, h3]
}

const FREE: f64 = f64::NEG_INFINITY;

/// Every equation as two inequalities: multipliers are not unique, `J` is singular at the solution.
#[mcp_fn(lower = [FREE, FREE, FREE, FREE, FREE, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])]
fn powell_split<D: Scalar>(
    [x1, x2, x3, x4, x5, u1, u2, u3, v1, v2, v3]: [Real<D>; 11],
) -> [Real<D>; 11] {
    let x = [x1, x2, x3, x4, x5];
    let [f1, f2, f3, f4, f5] = lagrangian_gradient(x, [u1 - v1, u2 - v2, u3 - v3]);
    let [h1, h2, h3] = constraints(x);
    [f1, f2, f3, f4, f5, h1, h2, h3, -h1, -h2, -h3]
}

/// Both forms from six starts of `x`; multipliers start at 0.
pub(super) fn powell_instances() -> Result<Vec<Instance>, ModelError> {
    let starts = [
        [-2.0, 2.0, 2.0, -1.0, -1.0],
        [-1.0, 1.0, 1.0, -1.0, -1.0],
        [1.0, 1.0, 1.0, 1.0, 1.0],
        [-3.0, 3.0, 3.0, -3.0, -3.0],
        [0.5, -2.0, 1.0, 2.0, 1.0],
        [0.0, 0.0, 0.0, 0.0, 0.0],
    ];
    let source = "Powell (1969); Hock & Schittkowski (1981), problem 80 without bounds";
    let equations = Instance::new("powell-kkt", source, Powell::new()?);
    let split = Instance::new("powell-split", source, PowellSplit::new()?);
    let both = starts.iter().enumerate().flat_map(|(k, start)| {
        let with_multipliers = |m: usize| [&start[..], &vec![0.0; m]].concat();
        [
            equations.numbered(k + 1, &with_multipliers(3)),
            split.numbered(k + 1, &with_multipliers(6)),
        ]
    });
    Ok(both.collect())
}
