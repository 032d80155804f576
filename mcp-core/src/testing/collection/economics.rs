//! General equilibria and markets; the von Thünen economy of land use stands here.

use super::{Instance, energy, exchange, pricing};
use crate::error::ModelError;
use crate::mcp;

mcp! {
    /// Land use in rings around a city (von Thünen): four crops, land rents, transport to the city.
    model LandUse {
        data {
            rings: Set, crops: 4, distance[rings]: f64, area[rings]: f64,
            phi[crops]: f64, beta[crops]: f64, weight[crops]: f64,
            worker[crops]: f64, owner[crops]: f64, porter[crops]: f64,
        }
        /// unit cost
        var cost[r in rings, c in crops] >= 0.0;
        /// output
        var y[r in rings, c in crops] >= 0.0;
        /// idle land
        var idle[r in rings] >= 0.0;
        /// rent of land
        var rent[r in rings] >= 0.001;
        /// price of transport
        var freight >= 0.0;
        /// wage
        var wage >= 0.0;
        fix wage = 1.0;
        /// price in the city
        var price[c in crops] >= 0.1;

        eq technology[r in rings, c in crops]: phi[c] * cost[r, c]
            - (wage / beta[c]).pow(beta[c]) * (rent[r] / (1.0 - beta[c])).pow(1.0 - beta[c])
                                                                                complements cost[r, c];
        eq profit[r in rings, c in crops]:
            cost[r, c] + weight[c] * distance[r] * freight - price[c]           complements y[r, c];
        eq reservation[r in rings]: rent[r] - 0.0001 * wage                     complements idle[r];
        eq land[r in rings]: area[r] - idle[r]
            - sum(crops, |c| y[r, c] * (1.0 - beta[c]) * cost[r, c]) / rent[r]  complements rent[r];
        eq transport: 20.0 - sum(rings, |r| sum(crops, |c| weight[c] * distance[r] * y[r, c]))
                                                                                complements freight;
        eq labor: wage * 30.0 - sum(rings, |r| sum(crops, |c| y[r, c] * beta[c] * cost[r, c]))
                                                                                complements wage;
        eq market[c in crops]: price[c] * sum(rings, |r| y[r, c]) - porter[c] * 20.0 * freight
            - worker[c] * 30.0 * wage
            - owner[c] * sum(rings, |r| rent[r] * (area[r] - idle[r]))          complements price[c];
    }
}

impl LandUse {
    #[allow(clippy::approx_constant, reason = "the model has 3.1415 for π")]
    fn new(rings: usize) -> Result<Self, ModelError> {
        let distance: Vec<f64> = (1..=rings).map(|r| 5.0 * (2.0 * r as f64 - 1.0)).collect();
        let area: Vec<f64> = distance.iter().map(|d| 2.0 * 3.1415 * d).collect();
        LandUse::builder()
            .rings((1..=rings).map(|r| r.to_string()).collect::<Vec<_>>())
            .distance(distance)
            .area(area)
            .phi([1.0, 2.0, 3.0, 4.0])
            .beta([0.9, 0.7, 0.5, 0.3])
            .weight([0.015, 0.006, 0.004, 0.01])
            .worker([0.2, 0.3, 0.1, 0.3])
            .owner([0.3, 0.3, 0.2, 0.2])
            .porter([0.6, 0.2, 0.1, 0.1])
            .build()
    }
}

/// Starts at 1 with no land idle, and three variations of it for twelve rings.
fn von_thuenen() -> Result<Vec<Instance>, ModelError> {
    let source = "von Thünen's isolated state as a general equilibrium: vonthmcp, pgvon of MCPLIB";
    let instance = |rings: usize| -> Result<Instance, ModelError> {
        let crops = 4 * rings;
        let mut start = vec![1.0; 2 * crops + 2 * rings + 6];
        start[2 * crops..2 * crops + rings].fill(0.0);
        let model = LandUse::new(rings)?;
        Ok(Instance::new(format!("vonthmcp-{rings}"), source, model).starting_at(start))
    };
    let twelve = instance(12)?;
    let varied = |name: &str, parts: &[(std::ops::Range<usize>, f64)]| {
        let mut start = twelve.start.clone();
        for (part, value) in parts {
            start[part.clone()].fill(*value);
        }
        twelve.clone().renamed(name).starting_at(start)
    };
    Ok(vec![
        twelve.clone(),
        varied("vonthmcp-12b", &[(0..48, 2.0), (108..120, 0.1)]),
        varied("vonthmcp-12c", &[(48..96, 0.0)]),
        varied("vonthmcp-12d", &[(122..126, 10.0), (48..96, 10.0)]),
        instance(5)?,
        instance(8)?,
        instance(10)?,
    ])
}

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let parts = [
        exchange::scarf()?,
        exchange::hansen()?,
        von_thuenen()?,
        pricing::choi()?,
        energy::pies()?,
    ];
    Ok(parts.concat())
}
