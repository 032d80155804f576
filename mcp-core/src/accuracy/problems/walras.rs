//! An exchange economy with consumers of constant elasticity of substitution.

use super::super::{AccuracyError, Case};
use crate::mcp;

mcp! {
    /// Endowments are at least what is asked for: supply − demand ⟂ price.
    model Exchange {
        data {
            goods: Set, consumers: Set,
            endowment[goods, consumers]: f64, share[goods, consumers]: f64, sigma[consumers]: f64,
            floor[goods]: f64,
        }
        var p[g in goods] >= floor[g] start 1.0;
        def income[h in consumers]: sum(goods, |g| endowment[g, h] * p[g]);
        /// `P^(1−σ)` of the price index `P`
        def index[h in consumers]:
            sum(goods, |g| when(share[g, h] > 0.0, || share[g, h] * p[g].pow(1.0 - sigma[h])));
        eq market[g in goods]: sum(consumers, |h| endowment[g, h])
            - sum(consumers, |h| when(share[g, h] > 0.0,
                || share[g, h] * income[h] / index[h] * p[g].pow(-sigma[h])))    complements p[g];
    }
}

/// Five consumers and `n >= 2` goods, of which every tenth is wanted by nobody and has the price 0;
/// good 1 is the numeraire. Data of this study.
///
/// # Errors
/// As [`Case::refined`].
pub fn walras(n: usize) -> Result<Case, AccuracyError> {
    const CONSUMERS: usize = 5;
    let is_free = |g: usize| g % 10 == 9;
    let number = |a: usize, b: usize, m: usize| 1.0 + ((a + b) % m) as f64 / 10.0;
    let table = |entry: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..n).map(|g| (0..CONSUMERS).map(|h| entry(g, h)).collect()).collect()
    };
    let names = |n: usize| (1..=n).map(|k| k.to_string()).collect::<Vec<_>>();
    let mut model = Exchange::builder()
        .goods(names(n))
        .consumers(names(CONSUMERS))
        .endowment(table(&|g, h| number(7 * g, 3 * h, 11)))
        .share(table(&|g, h| if is_free(g) { 0.0 } else { number(5 * g, 2 * h, 7) / n as f64 }))
        .sigma((0..CONSUMERS).map(|h| 0.5 + 0.25 * h as f64).collect::<Vec<_>>())
        .floor((0..n).map(|g| if is_free(g) { 0.0 } else { 1e-6 }).collect::<Vec<_>>())
        .build()?;
    model.fix("p[1]", 1.0)?;
    Case::new(format!("walras {n}"), model).refined()
}
