//! The small PIES model: coal and crude oil are mined, refined and shipped to two consumers.

use super::Instance;
use crate::error::ModelError;
use crate::mcp;
use crate::model::{Model, Reader, Row, Shape};
use crate::scalar::{Real, Scalar, prod};

mcp! {
    /// Quantities, prices of coal, light and heavy oil, and multipliers.
    model Pies {
        data {
            sources: 2, grades: 3, wells: 2, consumers: 2, refineries: 2, resources: 2,
            coal_cost[sources, grades]: f64, coal_limit[sources, grades]: f64,
            oil_cost[sources, wells]: f64, oil_limit[sources, wells]: f64,
            coal_use[resources, sources, grades]: f64, oil_use[resources, sources, wells]: f64,
            coal_ship[sources, consumers]: f64, oil_ship[sources, refineries]: f64,
            light_ship[refineries, consumers]: f64, heavy_ship[refineries, consumers]: f64,
            refining[refineries]: f64, light_yield[refineries]: f64, heavy_yield[refineries]: f64,
            supply[resources]: f64,
        }
        var c[i in sources, j in grades] in 0.0..=coal_limit[i, j];
        var o[i in sources, j in wells] in 0.0..=oil_limit[i, j];
        var ct[i in sources, j in consumers] >= 0.0;
        var ot[i in sources, r in refineries] >= 0.0;
        var lt[r in refineries, j in consumers] >= 0.0;
        var ht[r in refineries, j in consumers] >= 0.0;
        var pc[j in consumers] >= 0.1;
        var pl[j in consumers] >= 0.1;
        var ph[j in consumers] >= 0.1;
        var mu[s in resources] >= 0.0;
        var cv[i in sources] free;
        var ov[i in sources] free;
        var lv[r in refineries] free;
        var hv[r in refineries] free;

        eq coal[i in sources, j in grades]:
            coal_cost[i, j] + sum(resources, |s| coal_use[s, i, j] * mu[s]) - cv[i]    complements c[i, j];
        eq oil[i in sources, j in wells]:
            oil_cost[i, j] + sum(resources, |s| oil_use[s, i, j] * mu[s]) - ov[i]      complements o[i, j];
        eq coal_arbitrage[i in sources, j in consumers]: coal_ship[i, j] + cv[i] - pc[j]
                                                                                       complements ct[i, j];
        eq refine[i in sources, r in refineries]: oil_ship[i, r] + refining[r] + ov[i]
            - light_yield[r] * lv[r] - heavy_yield[r] * hv[r]                          complements ot[i, r];
        eq light_arbitrage[r in refineries, j in consumers]: light_ship[r, j] + lv[r] - pl[j]
                                                                                       complements lt[r, j];
        eq heavy_arbitrage[r in refineries, j in consumers]: heavy_ship[r, j] + hv[r] - ph[j]
                                                                                       complements ht[r, j];
        eq coal_market[j in consumers]:
            sum(sources, |i| ct[i, j]) - demand(0, [pc[j], pl[j], ph[j]])              complements pc[j];
        eq light_market[j in consumers]:
            sum(refineries, |r| lt[r, j]) - demand(1, [pc[j], pl[j], ph[j]])           complements pl[j];
        eq heavy_market[j in consumers]:
            sum(refineries, |r| ht[r, j]) - demand(2, [pc[j], pl[j], ph[j]])           complements ph[j];
        eq coal_balance[i in sources]: sum(grades, |j| c[i, j]) - sum(consumers, |j| ct[i, j])
                                                                                       complements cv[i];
        eq oil_balance[i in sources]: sum(wells, |j| o[i, j]) - sum(refineries, |r| ot[i, r])
                                                                                       complements ov[i];
        eq light_balance[r in refineries]: sum(sources, |i| ot[i, r]) * light_yield[r]
            - sum(consumers, |j| lt[r, j])                                             complements lv[r];
        eq heavy_balance[r in refineries]: sum(sources, |i| ot[i, r]) * heavy_yield[r]
            - sum(consumers, |j| ht[r, j])                                             complements hv[r];
        eq capacity[s in resources]: supply[s]
            - sum(sources, |i| sum(grades, |j| c[i, j] * coal_use[s, i, j]))
            - sum(sources, |i| sum(wells, |j| o[i, j] * oil_use[s, i, j]))             complements mu[s];
    }
}

/// Demand for coal, light or heavy oil: constant elasticities around a reference point.
fn demand<D: Scalar>(good: usize, p: [Real<D>; 3]) -> Real<D> {
    let (quantity, price) = ([1000.0, 1200.0, 1000.0], [12.0, 16.0, 12.0]);
    let elasticity = [[-0.75, 0.1, 0.2], [0.1, -0.5, 0.2], [0.2, 0.1, -0.5]][good];
    quantity[good] * prod(0..3, |h| (p[h] / price[h]).pow(elasticity[h]))
}

impl Pies {
    fn new() -> Result<Self, ModelError> {
        let shipping = [[1.0, 1.2], [1.0, 1.5]];
        Pies::builder()
            .coal_cost([[5.0, 6.0, 8.0], [4.0, 5.0, 7.0]])
            .coal_limit([[300.0, 300.0, 400.0], [200.0, 300.0, 600.0]])
            .oil_cost([[1.0, 1.5], [1.25, 1.5]])
            .oil_limit([[1100.0, 1200.0], [1300.0, 1100.0]])
            .coal_use(vec![1.0, 5.0, 10.0, 1.0, 5.0, 6.0, 1.0, 2.0, 3.0, 1.0, 4.0, 5.0])
            .oil_use(vec![0.0, 10.0, 0.0, 15.0, 0.0, 4.0, 0.0, 2.0])
            .coal_ship([[1.0, 2.5], [0.75, 2.75]])
            .oil_ship([[2.0, 3.0], [4.0, 2.0]])
            .light_ship(shipping)
            .heavy_ship(shipping)
            .refining([6.5, 5.0])
            .light_yield([0.6, 0.5])
            .heavy_yield([0.4, 0.5])
            .supply([35000.0, 12000.0])
            .build()
    }
}

/// The rows of a model paired with its variables in the order in which both are written.
///
/// The study pairs PIES so: each balance with the variable two places before its own multiplier,
/// and the capacities with the free multipliers of the heavy balances. At the solution of PIES both
/// capacities bind, so that it solves either problem; this pairing is the harder.
struct InOrder {
    pies: Pies,
    shape: Shape,
}

impl InOrder {
    fn new(pies: Pies) -> Result<Self, ModelError> {
        let (bounds, start) = (pies.shape().bounds(), pies.shape().start());
        let shape = Shape::anonymous(bounds.lower(), bounds.upper(), start)?;
        Ok(InOrder { pies, shape })
    }
}

impl Model for InOrder {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let Row { family, index } = self.pies.shape().row(i);
        self.pies.row(family, index, read)
    }
}

/// From the published start, from no quantities at prices of 10, and from 1.
pub(super) fn pies() -> Result<Vec<Instance>, ModelError> {
    let quantities = [
        300.0, 300.0, 400.0, 200.0, 300.0, 600.0, 1100.0, 1000.0, 1300.0, 1000.0, 0.0, 828.0,
        1016.0, 84.0, 2075.0, 0.0, 0.0, 2358.0, 22.0, 1223.0, 1179.0, 0.0, 0.0, 830.0, 998.0,
        180.0,
    ];
    let prices = [11.7, 13.7, 15.8, 16.0, 11.9, 12.4];
    let published = [&quantities[..], &prices, &[1.0; 10]].concat();
    let empty = [&[0.0; 26][..], &[10.0; 6], &[0.0; 10]].concat();
    let source = "Project Independence Evaluation System, Hogan (1975), paired in order; MCPLIB";
    Ok(Instance::new("pies", source, InOrder::new(Pies::new()?)?).at_starts(&[
        published,
        empty,
        vec![1.0; 42],
    ]))
}
