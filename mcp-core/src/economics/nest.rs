//! Unit costs of nests with constant elasticity of substitution.

use crate::scalar::{Real, Scalar, absent};

/// Unit cost of a nest with constant elasticity of substitution `σ >= 0`, from the weight and the
/// price of each input:
///
/// ```text
/// c = (Σ θ_i p_i^(1−σ))^(1/(1−σ)),   θ_i = w_i / Σ w;
/// ```
///
/// the mean `Σ θ_i p_i` for `σ = 0` (Leontief), the product `Π p_i^θ_i` for `σ = 1`
/// (Cobb–Douglas). It is 1 where all prices are 1. With benchmark values as weights and prices
/// relative to the benchmark this is the *calibrated share form*; the demand for input `i` at output
/// `y` is then `x̄_i y (c/p_i)^σ`.
///
/// Weights are scaled to sum to 1 here: a sum of `1 + 10⁻¹⁶` to the power `1/(1−σ)` is wrong in
/// all digits near `σ = 1`. An input of weight 0 is left out; a nest of none costs 1. Weights below 0
/// or with an infinite sum, prices below 0 (for `σ > 0`), prices that are NaN, and an `σ` that is
/// negative or infinite give NaN.
///
/// | at | cost | derivative |
/// | --- | --- | --- |
/// | `p_i = 0`, `σ < 1` | of the other inputs | `+inf` by `p_i`, for `σ = 0`: `θ_i` |
/// | `p_i = 0`, `σ = 1` | 0 | `+inf` by `p_i` |
/// | `p_i = 0`, `σ > 1` | 0 | `θ_i^(1/(1−σ))` by `p_i`, 0 by the others |
/// | all `p_i = 0` | 0 | `θ_i` (kink) |
///
/// Cost: the inputs are gone through twice, first for the largest and the smallest price. Error: a few
/// `eps (1 + ln(p_max / p_min))`, for every `σ` and ratios of prices up to `1e300`; the formula as it
/// stands loses all digits near `σ = 1`.
///
/// ```
/// use mcp_core::Real;
/// use mcp_core::economics::ces;
/// let cost = |sigma| {
///     ces(sigma, [(1.0, 4.0), (1.0, 1.0)], |(weight, price)| (weight, Real::<f64>::from(price)))
///         .into_scalar()
/// };
/// assert_eq!(cost(0.0), 2.5);
/// assert_eq!(cost(1.0), 2.0);
/// // c(1 + h) = 2 − h (ln 2)² / 2 · 2 + O(h²)
/// assert!((cost(1.0 + 1e-9) - (2.0 - 1e-9 * 2_f64.ln().powi(2))).abs() < 1e-15);
/// ```
pub fn ces<D: Scalar, I: IntoIterator + Clone>(
    sigma: f64,
    inputs: I,
    mut weight_and_price: impl FnMut(I::Item) -> (f64, Real<D>),
) -> Real<D> {
    if D::ENCLOSES {
        return textbook_cost(sigma, inputs, weight_and_price);
    }
    let mut survey = Survey::default();
    for i in inputs.clone() {
        let (weight, price) = weight_and_price(i);
        survey.add(weight, price.0.value());
    }
    let mut nest = Nest::new(sigma, &survey);
    for i in inputs {
        let (weight, price) = weight_and_price(i);
        nest.add(weight, price);
    }
    nest.cost()
}

/// The formula as it stands, for sets of numbers: the forms of [`Nest`] are chosen by the values of
/// the prices, and its exponents are rounded.
fn textbook_cost<D: Scalar, I: IntoIterator>(
    sigma: f64,
    inputs: I,
    mut weight_and_price: impl FnMut(I::Item) -> (f64, Real<D>),
) -> Real<D> {
    let rho: Real<D> = 1.0 - Real::from(sigma);
    let (mut weights, mut total): (Real<D>, Real<D>) = (Real::from(0.0), Real::from(0.0));
    for i in inputs {
        let (weight, price) = weight_and_price(i);
        if weight != 0.0 {
            weights += weight;
            total += weight
                * match sigma {
                    0.0 => price,
                    1.0 => price.ln(),
                    _ => price.pow(rho),
                };
        }
    }
    match sigma {
        _ if weights.0.is_zero() => Real::from(1.0),
        0.0 => total / weights,
        1.0 => (total / weights).exp(),
        _ => (total / weights).pow(1.0 / rho),
    }
}

/// Unit cost of a nest of two inputs, of which the first has this share of the benchmark value:
/// [`ces`].
pub fn ces2<D: Scalar>(sigma: f64, share: f64, first: Real<D>, second: Real<D>) -> Real<D> {
    ces(sigma, [(share, first), (1.0 - share, second)], |input| input)
}

/// Unit cost of a Cobb–Douglas nest from the weight and the price of each input: `Π p_i^θ_i` with
/// `θ_i = w_i / Σ w`, the [`ces`] nest with `σ = 1`.
pub fn cobb<D: Scalar, I: IntoIterator + Clone>(
    inputs: I,
    weight_and_price: impl FnMut(I::Item) -> (f64, Real<D>),
) -> Real<D> {
    ces(1.0, inputs, weight_and_price)
}

/// What decides how the sums are computed.
#[derive(Default)]
struct Survey {
    /// `Σ w`
    weight: f64,
    /// Smallest and largest price, and the weight of the inputs that cost nothing.
    prices: Option<(f64, f64)>,
    free: f64,
}

impl Survey {
    fn add(&mut self, weight: f64, price: f64) {
        if weight != 0.0 {
            self.weight += if weight < 0.0 { f64::NAN } else { weight };
            let (smallest, largest) = self.prices.unwrap_or((price, price));
            self.prices = Some((smallest.min(price), largest.max(price)));
            if price == 0.0 {
                self.free += weight;
            }
        }
    }
}

/// `c = r (Σ θ_i (p_i/r)^ρ)^(1/ρ)` with `ρ = 1 − σ`. The reference `r` is a constant: `c` does not
/// depend on it. With the price of the largest `p^ρ` as `r` no term exceeds 1.
#[derive(Clone, Copy)]
enum Form {
    /// `Σ θ_i (p_i/r)^ρ`
    Power,
    /// `Σ θ_i ((p_i/r)^ρ − 1)`, accurate for small `ρ`.
    Excess,
    /// `Π (p_i/r)^θ_i`, for `ρ = 0`.
    Product,
    /// `r = 0`: the inputs that cost nothing decide. The slope `θ^(1/ρ)` may overflow, but not the cost.
    Free,
    /// There are no inputs.
    Empty,
    /// `σ`, a weight or a price is no number that it may be.
    Undefined,
}

struct Nest<D: Scalar> {
    form: Form,
    rho: f64,
    /// `Σ w`; of the form `Free` over the inputs that cost nothing.
    weight: f64,
    free_share: f64,
    reference: f64,
    total: Real<D>,
}

impl<D: Scalar> Nest<D> {
    fn new(sigma: f64, survey: &Survey) -> Self {
        let rho = 1.0 - sigma;
        let (smallest, largest) = survey.prices.unwrap_or((1.0, 1.0));
        // A mean takes prices of any sign.
        let reference = if rho < 0.0 {
            smallest
        } else if sigma == 0.0 {
            largest.max(-smallest)
        } else {
            largest
        };
        // Terms of the form `Excess` lie between 1/e − 1 and 0: nothing cancels, and the error of the
        // logarithm is divided by ρ like the logarithm itself. Elsewhere 1/ρ multiplies the error of
        // the sum, by 4 or by the logarithm of the price ratio at most.
        let is_near_product = rho.abs() < 0.25 && rho.abs() * (largest / smallest).ln() <= 1.0;
        let is_defined = sigma >= 0.0 && sigma.is_finite() && survey.weight.is_finite();
        let form = if !is_defined || smallest < 0.0 && sigma > 0.0 {
            Form::Undefined
        } else if survey.prices.is_none() {
            Form::Empty
        } else if reference == 0.0 {
            Form::Free
        } else if rho == 0.0 {
            Form::Product
        } else if is_near_product {
            Form::Excess
        } else {
            Form::Power
        };
        let weight = if matches!(form, Form::Free) { survey.free } else { survey.weight };
        let total = Real::from(if matches!(form, Form::Product) { 1.0 } else { 0.0 });
        Nest { form, rho, weight, free_share: survey.free / survey.weight, reference, total }
    }

    fn add(&mut self, weight: f64, price: Real<D>) {
        if weight == 0.0 {
            return;
        }
        let ratio = || price / self.reference;
        match self.form {
            Form::Power => self.total += weight * ratio().pow(self.rho),
            Form::Excess => self.total += weight * (self.rho * ratio().ln()).exp_m1(),
            Form::Product => self.total *= ratio().pow(weight / self.weight),
            Form::Free if price.0.value() == 0.0 => self.total += weight * price,
            // The pattern must not depend on the prices.
            Form::Free if price.0.value() > 0.0 => self.total += Real(absent(price.0)),
            Form::Free | Form::Undefined => self.total += f64::NAN * price,
            Form::Empty => {}
        }
    }

    fn cost(self) -> Real<D> {
        let mean = self.total / self.weight;
        match self.form {
            Form::Power => self.reference * mean.pow(1.0 / self.rho),
            Form::Excess => self.reference * (mean.ln_1p() / self.rho).exp(),
            Form::Product => self.reference * self.total,
            Form::Free => self.free_share.powf(1.0 / self.rho).min(f64::MAX) * mean,
            Form::Empty => Real::from(1.0),
            Form::Undefined => self.total,
        }
    }
}

#[cfg(test)]
#[path = "nest_tests.rs"]
mod tests;
