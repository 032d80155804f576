//! The calibrated share form of a nest: [Rut99](crate#references).

use super::ces;
use crate::scalar::{Real, Scalar};

/// Unit cost from the benchmark quantity, the benchmark price and the price of each input:
///
/// ```text
/// c = c̄ (Σ θ_i (p_i/p̄_i)^(1−σ))^(1/(1−σ)),   c̄ = Σ x̄_i p̄_i,   θ_i = x̄_i p̄_i / c̄.
/// ```
///
/// `c̄` at benchmark prices. Quantities for one unit of output; units of the result: those of
/// `x̄_i p̄_i`. Corners and accuracy as of [`ces`].
///
/// ```
/// use mcp_core::Real;
/// use mcp_core::economics::{calibrated_cost, calibrated_demand};
/// // 2 h of labor at 10 $/h and 5 kg of flour at 4 $/kg make 10 loaves; labor now costs 12 $/h.
/// let inputs = [(0.2, 10.0, 12.0), (0.5, 4.0, 4.0)].map(|(x0, p0, p)| (x0, p0, Real::<f64>::from(p)));
/// let cost = calibrated_cost(0.5, inputs, |input| input);
/// let labor = calibrated_demand(0.5, (0.2, 10.0), cost / 4.0, inputs[0].2);
/// let flour = calibrated_demand(0.5, (0.5, 4.0), cost / 4.0, inputs[1].2);
/// assert!((12.0 * labor + 4.0 * flour - cost).into_scalar().abs() < 1e-15); // Euler
/// ```
pub fn calibrated_cost<D: Scalar, I: IntoIterator + Clone>(
    sigma: f64,
    inputs: I,
    mut quantity_and_prices: impl FnMut(I::Item) -> (f64, f64, Real<D>),
) -> Real<D> {
    let mut benchmark = 0.0;
    for i in inputs.clone() {
        let (quantity, price0, _) = quantity_and_prices(i);
        benchmark += quantity * price0;
    }
    benchmark
        * ces(sigma, inputs, |i| {
            let (quantity, price0, price) = quantity_and_prices(i);
            (quantity * price0, price / price0)
        })
}

/// Demand for an input of [`calibrated_cost`] for one unit of output, its derivative by the price
/// (Shephard's lemma): `x̄ (index · p̄/p)^σ` with the cost index `c/c̄`. For `σ = 0` and for
/// `x̄ = 0` it is `x̄` at any price, 0 included.
///
/// `benchmark` is the pair `(x̄, p̄)`.
pub fn calibrated_demand<D: Scalar>(
    sigma: f64,
    benchmark: (f64, f64),
    cost_index: Real<D>,
    price: Real<D>,
) -> Real<D> {
    let (quantity, price0) = benchmark;
    if sigma == 0.0 || quantity == 0.0 {
        return Real::from(quantity);
    }
    quantity * (cost_index * price0 / price).pow(sigma)
}
