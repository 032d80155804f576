//! The transport problem as a mixed complementarity problem.

use crate::data::TransportData;
use mcp_core::{Block, Equation, Model, ModelError, Reader, Real, Scalar, Shape, Variable, sum};

/// Freight [dollars per case and thousand miles].
const FREIGHT: f64 = 90.0;

/// Shipments and prices, all in cases and thousand dollars per case.
pub(crate) struct Transport {
    shape: Shape,
    pub(crate) data: TransportData,
    /// Transport cost of each pair [thousand dollars per case].
    pub(crate) cost: Vec<f64>,
    /// Where shipments, capacity prices and market prices stand among the variables.
    pub(crate) x: Block<2>,
    pub(crate) w: Block<1>,
    pub(crate) p: Block<1>,
}

impl Transport {
    pub(crate) fn new(data: TransportData) -> Result<Self, ModelError> {
        let (plants, markets) = (&data.plants, &data.markets);
        let price = "thousand dollars per case";
        let shape = Shape::builder()
            .variable(
                Variable::new("x")
                    .over(&[plants, markets])
                    .lower(0.0)
                    .start(100.0)
                    .about("shipment")
                    .unit("cases"),
            )
            .variable(
                Variable::new("w").over(&[plants]).lower(0.0).about("capacity price").unit(price),
            )
            .variable(
                Variable::new("p")
                    .over(&[markets])
                    .lower(0.0)
                    .start(0.2)
                    .about("delivered price")
                    .unit(price),
            )
            .equation(Equation::new("profit").over(&[plants, markets]).complements("x"))
            .equation(Equation::new("supply").over(&[plants]).complements("w"))
            .equation(Equation::new("demand").over(&[markets]).complements("p"))
            .build()?;
        let (x, w, p) = (
            shape.variable("x")?.block(),
            shape.variable("w")?.block(),
            shape.variable("p")?.block(),
        );
        let cost = data.distance.iter().map(|miles| FREIGHT * miles / 1000.0).collect();
        Ok(Transport { shape, data, cost, x, w, p })
    }

    /// `Σ c_ij x_ij` [thousand dollars].
    pub(crate) fn total_cost(&self, z: &[f64]) -> f64 {
        let shipments = self.plants().flat_map(|i| self.markets().map(move |j| [i, j]));
        sum(shipments.zip(&self.cost), |(ij, cost)| cost * z[self.x.at(ij)])
    }

    pub(crate) fn plants(&self) -> std::ops::Range<usize> {
        0..self.data.plants.len()
    }

    pub(crate) fn markets(&self) -> std::ops::Range<usize> {
        0..self.data.markets.len()
    }
}

impl Model for Transport {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn row<D: Scalar>(&self, family: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let x = |i, j| read.var(self.x.at([i, j]));
        let w = |i| read.var(self.w.at([i]));
        let p = |j| read.var(self.p.at([j]));
        match family {
            0 => {
                let [i, j] = self.x.split(k);
                w(i) + self.cost[k] - p(j)
            }
            1 => self.data.capacity[k] - sum(self.markets(), |j| x(k, j)),
            _ => sum(self.plants(), |i| x(i, k)) - self.data.demand[k],
        }
    }
}
