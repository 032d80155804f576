//! Traffic and trade: user equilibria and spatial price equilibria.

use super::Instance;
use super::archive::RANDOM;
use crate::error::ModelError;
use crate::mcp;
use crate::scalar::{Real, Scalar};

/// Delay on a link with flow `t`.
fn delay<D: Scalar>(t: Real<D>) -> Real<D> {
    1.0 + t + t * t
}

mcp! {
    /// Traffic of five origins on a ring with an inner and an outer road: path flows `x` and `z`,
    /// travel times `y`; `gamma` couples a path to the flows that cross it.
    model Ring {
        data { nodes: Ordered, gamma: f64, demand[nodes]: f64 }
        var x[i in nodes] >= 0.0;
        var z[i in nodes] >= 0.0;
        var y[i in nodes] free;
        eq outer[i in nodes]: {
            let own = x[i];
            let (next, second) = (x[nodes.wrap(i, 1)], x[nodes.wrap(i, 2)]);
            let (third, last) = (x[nodes.wrap(i, 3)], x[nodes.wrap(i, 4)]);
            delay(own) + gamma * delay(third + last) + 10.0 * delay(own + third + last)
                + 2.0 * gamma * delay(third) + delay(own + last) + 10.0 * delay(own + next + last)
                + 2.0 * gamma * delay(last) + delay(own + next) + 10.0 * delay(own + next + second)
                + 2.0 * gamma * delay(own) + delay(own) - y[i]
        } complements x[i];
        eq inner[i in nodes]: {
            let (own, next, last) = (z[i], z[nodes.wrap(i, 1)], z[nodes.wrap(i, 4)]);
            delay(own) + gamma * delay(next) + 10.0 * delay(own + next) + 2.0 * gamma * delay(next)
                + delay(own) + 10.0 * delay(own + last) + 2.0 * gamma * delay(own) + delay(own) - y[i]
        } complements z[i];
        eq flow[i in nodes]: x[i] + z[i] - demand[i]   complements y[i];
    }
}

/// Travel times free from 0, and nonnegative from 1.
fn bertsekas() -> Result<Vec<Instance>, ModelError> {
    let source = "after Bertsekas & Gafni (1982), Math. Programming Study 17";
    let mut all = Vec::new();
    for gamma in [0.0, 1.0, 10.0] {
        let ring = || {
            Ring::builder()
                .nodes(["1", "2", "3", "4", "5"])
                .gamma(gamma)
                .demand([0.1, 0.2, 0.3, 0.4, 0.5])
                .build()
        };
        all.push(Instance::new(format!("bertsekas-g{gamma}"), source, ring()?));
        let mut nonnegative = ring()?;
        nonnegative.set_lower("y", 0.0)?;
        let name = format!("bertsekas-ncp-g{gamma}");
        all.push(Instance::new(name, source, nonnegative).starting_at([1.0; 15]));
    }
    Ok(all)
}

mcp! {
    /// Regions trade a good at convex costs; supply and demand are powers of the prices.
    model Trade {
        data {
            regions: Set, cost[regions, regions]: f64, demand[regions]: f64, supply[regions]: f64,
        }
        var x[i in regions, j in regions] >= 0.0;
        /// price at the place of supply
        var pi[i in regions] >= 0.0;
        /// price at the place of demand
        var rho[j in regions] >= 0.0;
        eq arbitrage[i in regions, j in regions]: pi[i] + cost[i, j] + 0.1 * x[i, j].powi(2) - rho[j]
                                                                                   complements x[i, j];
        eq supplied[i in regions]: supply[i] * pi[i].pow(1.5) - sum(regions, |j| x[i, j])   complements pi[i];
        eq demanded[j in regions]: sum(regions, |i| x[i, j]) - demand[j] * (rho[j] + 0.1).pow(-0.7) * 5.0
                                                                                   complements rho[j];
    }
}

fn tobin(regions: usize) -> Result<Vec<Instance>, ModelError> {
    let name = format!("tobin-like-R{regions}");
    let get = |what| RANDOM.get(&format!("{name}/{what}"));
    let model = Trade::builder()
        .regions((1..=regions).map(|i| i.to_string()).collect::<Vec<_>>())
        .cost(get("cost"))
        .demand(get("demand"))
        .supply(get("supply"))
        .build()?;
    let n = regions * (regions + 2);
    let starts = [vec![1.0; n], vec![0.0; n], vec![20.0; n]];
    Ok(Instance::new(name, "after Tobin (1988), with random data", model).at_starts(&starts))
}

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    Ok([bertsekas()?, tobin(3)?, tobin(6)?].concat())
}
