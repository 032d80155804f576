//! What a scenario of one effect comes to, by hand.
//!
//! As long as tools are exported and food is imported, zero profits give the wage
//! `w = fob_tools / hours_tools`, and households spend the part `α_hs` of their means on good `s`.

use super::data::{CIF, FOB, HOURS, LABOR, SHARE};
use super::effect::Effect;

const FOOD: usize = 0;
const TOOLS: usize = 1;

/// Wage while tools are exported [$/h].
pub(crate) const WAGE: f64 = FOB[TOOLS] / HOURS[TOOLS];

/// A number of a scenario by its name, and what it comes to.
pub(crate) type Expected = (&'static str, f64);

/// What is known about a scenario: nothing, unless it has no effect, or a tax or a quota on food.
pub(crate) fn expected(effects: &[Effect]) -> Vec<Expected> {
    match effects {
        [] => taxed([0.0; 3], [0.0; 2]).to_vec(),
        [Effect::Tax { rate, to }] => {
            let revenue = revenue(*rate, *to);
            [&taxed(*rate, to.map(|part| part * revenue))[..], &[("revenue", revenue)]].concat()
        }
        [Effect::Quota { limit: [limit, f64::INFINITY], to }] => under_quota(*limit, *to).to_vec(),
        _ => Vec::new(),
    }
}

/// What a tax on consumption yields [M$]: of what a household spends, the part
/// `k_h = Σ_s α_hs τ_s/(1 + τ_s)`, and its part of the yield is income again,
///
/// ```text
/// R = Σ_h k_h (w L_h + to_h R) = Σ_h k_h w L_h / (1 − Σ_h k_h to_h)
/// ```
fn revenue(rate: [f64; 3], to: [f64; 2]) -> f64 {
    let k = SHARE.map(|share| (0..3).map(|s| share[s] * rate[s] / (1.0 + rate[s])).sum::<f64>());
    let of_wages = k[0] * WAGE * LABOR[0] + k[1] * WAGE * LABOR[1];
    of_wages / (1.0 - (k[0] * to[0] + k[1] * to[1]))
}

/// Prices are those of free trade; households have transfers beside their wages.
fn taxed(rate: [f64; 3], transfer: [f64; 2]) -> [Expected; 8] {
    let income = [0, 1].map(|h| WAGE * LABOR[h] + transfer[h]);
    let price = [CIF[FOOD], FOB[TOOLS], WAGE * HOURS[2]];
    let demand = |s: usize| {
        (0..2).map(|h| SHARE[h][s] * income[h]).sum::<f64>() / (price[s] * (1.0 + rate[s]))
    };
    [
        ("w", WAGE),
        ("p[food]", price[0]),
        ("p[tools]", price[1]),
        ("p[services]", price[2]),
        ("income[workers]", income[0]),
        ("income[merchants]", income[1]),
        ("m[food]", demand(FOOD)),
        ("y[services]", demand(2)),
    ]
}

/// A quota `Q` on food. While it is not made in the country, what is spent on it is `p Q`, with the rent
/// `(p − cif) Q` in the incomes:
///
/// ```text
/// p Q = Σ_h α_h (w L_h + to_h (p − cif) Q)
/// ```
///
/// The price so found, but at least `cif` (the quota does not bind) and at most the cost `w a` of food
/// made in the country.
fn under_quota(limit: f64, to: [f64; 2]) -> [Expected; 7] {
    let alpha = SHARE.map(|share| share[FOOD]);
    let by_wages: f64 = (0..2).map(|h| alpha[h] * WAGE * LABOR[h]).sum();
    let by_rent = alpha[0] * to[0] + alpha[1] * to[1];
    let scarce = (by_wages - by_rent * CIF[FOOD] * limit) / (limit * (1.0 - by_rent));
    let price = scarce.clamp(CIF[FOOD], WAGE * HOURS[FOOD]);
    let rent = price - CIF[FOOD];
    let income = [0, 1].map(|h| WAGE * LABOR[h] + to[h] * rent * limit);
    let demand = (alpha[0] * income[0] + alpha[1] * income[1]) / price;
    let imports = demand.min(limit);
    [
        ("w", WAGE),
        ("p[food]", price),
        ("rent[food]", rent),
        ("m[food]", imports),
        ("y[food]", demand - imports),
        ("income[workers]", income[0]),
        ("income[merchants]", income[1]),
    ]
}
