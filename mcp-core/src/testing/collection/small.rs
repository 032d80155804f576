//! Classical complementarity problems of a few variables, from several starts each.

use super::super::classic::{billups_model, josephy_model, kojima_shindo_model, watson4_model};
use super::{Instance, kkt, systems};
use crate::error::ModelError;
use crate::model::Model;
use crate::scalar::{Real, Scalar, sum};
use crate::{mcp, mcp_fn};

/// The starts of `kojshin` and `josephy` in MCPLIB.
const STARTS: [[f64; 4]; 8] = [
    [0.0, 0.0, 0.0, 0.0],
    [1.0, 1.0, 1.0, 1.0],
    [100.0, 100.0, 100.0, 100.0],
    [1.0, 0.0, 1.0, 0.0],
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0, 1.0],
    [1.25, 0.0, 0.0, 0.5],
];

/// Mathiesen's economy with the price of good 1 as numeraire: activity, two prices.
#[mcp_fn(lower = [0.0, 1e-6, 0.0])]
fn mathiesen<D: Scalar>([y, p2, p3]: [Real<D>; 3]) -> [Real<D>; 3] {
    let income = 5 * p2 + 3 * p3;
    [-1 + p2 + p3, 5 - y - 0.1 * income / p2, 3 - y]
}

/// The same without numeraire: homogeneous of degree 0 in the prices, `J` singular everywhere.
#[mcp_fn(lower = [0.0, 1e-6, 1e-6, 0.0])]
fn mathiesen_ray<D: Scalar>([y, p1, p2, p3]: [Real<D>; 4]) -> [Real<D>; 4] {
    let income = 5 * p2 + 3 * p3;
    [-p1 + p2 + p3, y - 0.9 * income / p1, 5 - y - 0.1 * income / p2, 3 - y]
}

/// The same with demands that are finite at price 0.
#[mcp_fn(lower = 0.0)]
fn mathiesen_modified<D: Scalar>([y, p1, p2, p3]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        -p1 + p2 + p3,
        y - (4.5 * p2 + 2.7 * p3) / (p1 + 1),
        5 - y - (0.5 * p2 + 0.3 * p3) / (p2 + 1),
        3 - y,
    ]
}

mcp! {
    /// Nash–Cournot game: marginal cost − marginal revenue ⟂ quantity.
    model Cournot {
        data { firms: Set, c[firms]: f64, l[firms]: f64, beta[firms]: f64, gamma: f64 }
        /// quantity
        var q[i in firms] >= 0.0;
        def total: sum(firms, |i| q[i]);
        def price: (5000.0 / total).pow(1.0 / gamma);
        eq profit[i in firms]:
            c[i] + (l[i] * q[i]).pow(1.0 / beta[i]) - price + q[i] / gamma * price / total  complements q[i];
    }
}

impl Cournot {
    fn new<const N: usize>(
        c: [f64; N],
        l: f64,
        beta: [f64; N],
        gamma: f64,
    ) -> Result<Self, ModelError> {
        let firms: Vec<String> = (1..=N).map(|i| i.to_string()).collect();
        Cournot::builder().firms(firms).c(c).l([l; N]).beta(beta).gamma(gamma).build()
    }
}

/// The ten firms of `nash10`.
pub(crate) struct TenFirms {
    pub(crate) c: [f64; 10],
    pub(crate) l: f64,
    pub(crate) beta: [f64; 10],
    pub(crate) gamma: f64,
}

pub(crate) const TEN_FIRMS: TenFirms = TenFirms {
    c: [5.0, 3.0, 8.0, 5.0, 1.0, 3.0, 7.0, 4.0, 6.0, 3.0],
    l: 10.0,
    beta: [1.2, 1.0, 0.9, 0.6, 1.5, 1.0, 0.7, 1.1, 0.95, 0.75],
    gamma: 1.2,
};

pub(crate) fn ten_firms_model() -> Result<impl Model + Send + Sync + 'static, ModelError> {
    let TenFirms { c, l, beta, gamma } = TEN_FIRMS;
    Cournot::new(c, l, beta, gamma)
}

/// Price and quantities of five firms: the same game with the price as a variable.
#[mcp_fn(lower = 0.0)]
fn oligopoly<D: Scalar>([p, q1, q2, q3, q4, q5]: [Real<D>; 6]) -> [Real<D>; 6] {
    let q = [q1, q2, q3, q4, q5];
    let (c, beta) = ([10.0, 8.0, 6.0, 4.0, 2.0], [1.2, 1.1, 1.0, 0.9, 0.8]);
    let profit = |i: usize| c[i] + (q[i] / 5.0).pow(1.0 / beta[i]) - p + q[i] * p.pow(2.1) / 5500.0;
    [sum(q, |q| q) - 5000.0 * p.pow(-1.1), profit(0), profit(1), profit(2), profit(3), profit(4)]
}

/// `x³ − 2x + 2 = 0`: Newton's method from 0 cycles between 0 and 1.
#[mcp_fn]
fn cycle<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [x.powi(3) - 2 * x + 2]
}

/// An LCP with a P-matrix.
#[mcp_fn(lower = 0.0)]
fn cycle_lcp<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x - 2 * y, 2 * x + y - 1]
}

/// An LCP of three variables.
#[mcp_fn(lower = 0.0)]
fn munson<D: Scalar>([x, y, z]: [Real<D>; 3]) -> [Real<D>; 3] {
    [x + 2 * y + 3 * z - 1, y - z + 1, x + y + 1]
}

/// Both variables between two bounds.
#[mcp_fn(lower = [0.0, -1.0], upper = [1.0, 5.0], start = [0.5, 0.0])]
fn tiny_box<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x * x - 2 + y, y - x]
}

/// A double root inside the bounds: rank 0.
#[mcp_fn(lower = 0.0, start = 3.0)]
fn double_root<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [(x - 1).powi(2)]
}

pub(crate) fn double_root_model() -> Result<impl Model + 'static, ModelError> {
    DoubleRoot::new()
}

/// A double root at the bound.
#[mcp_fn(lower = 0.0, start = 1.0)]
fn square_at_bound<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [x * x]
}

/// A degenerate solution where `J` vanishes but for one entry.
#[mcp_fn(lower = 0.0, start = 1.0)]
fn cubic_degenerate<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x.powi(3) + y, y.powi(3)]
}

/// A root at `6 ln 10 = 13.8` where `F` is nearly flat.
#[mcp_fn(lower = 0.0)]
fn flat_exponential<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [(-x).exp() - 1e-6]
}

const MATHIESEN: &str = "Mathiesen (1987), Math. Programming 37";
const COURNOT: &str = "Murphy, Sherali & Soyster (1982), Math. Programming 24; MCPLIB";

fn quadratics() -> Result<Vec<Instance>, ModelError> {
    let degenerate = [1.5_f64.sqrt(), 0.0, 0.0, 0.5];
    let source = "Kojima & Shindo (1986), J. Oper. Res. Soc. Japan 29; MCPLIB";
    let kojshin = Instance::new("kojshin", source, kojima_shindo_model()?)
        .solved_by(degenerate)
        .solved_by([1.0, 0.0, 3.0, 0.0]);
    let source = "Josephy (1979), Mathematics Research Center, Wisconsin; MCPLIB";
    let josephy = Instance::new("josephy", source, josephy_model()?).solved_by(degenerate);
    let pairs = kojshin.at_starts(&STARTS).into_iter().zip(josephy.at_starts(&STARTS));
    Ok(pairs.flat_map(|(kojshin, josephy)| [kojshin, josephy]).collect())
}

fn walras() -> Result<Vec<Instance>, ModelError> {
    let numeraire = Instance::new("mathinum", MATHIESEN, Mathiesen::new()?)
        .solved_by([3.0, 1.0 / 6.0, 5.0 / 6.0])
        .at_starts(&[[1.0, 1.0, 1.0], [0.0, 0.5, 0.5], [10.0, 0.1, 10.0], [3.0, 1.0, 5.0]]);
    let starts =
        [[1.0, 1.0, 1.0, 1.0], [0.0, 0.4, 0.3, 0.3], [10.0, 1.0, 0.1, 10.0], [3.0, 6.0, 1.0, 5.0]];
    let ray = Instance::new("mathiray", MATHIESEN, MathiesenRay::new()?)
        .solved_by([3.0, 6.0, 1.0, 5.0])
        .at_starts(&starts);
    let modified = Instance::new("mathimod", MATHIESEN, MathiesenModified::new()?)
        .at_starts(&[[1.0; 4], [10.0; 4], [100.0; 4], [0.0; 4]]);
    Ok([numeraire, ray, modified].concat())
}

fn cournot() -> Result<Vec<Instance>, ModelError> {
    let ten = Instance::new("nash10", COURNOT, ten_firms_model()?).at_starts(&[
        [1.0; 10],
        [10.0; 10],
        [1.0, 1.2, 1.4, 1.6, 1.8, 2.1, 2.3, 2.5, 2.7, 2.9],
        [7.0, 4.0, 3.0, 1.0, 18.0, 4.0, 1.0, 6.0, 3.0, 2.0],
    ]);
    let five = Cournot::new([10.0, 8.0, 6.0, 4.0, 2.0], 0.2, [1.2, 1.1, 1.0, 0.9, 0.8], 1.1)?;
    let five = Instance::new("nash5", COURNOT, five)
        .at_starts(&[[1.0; 5], [10.0; 5], [1e-3; 5], [100.0; 5]]);
    let start = [100_f64.powf(1.0 / 1.1), 10.0, 10.0, 10.0, 10.0, 10.0];
    let price = Instance::new("oligomcp", COURNOT, Oligopoly::new()?).starting_at(start);
    Ok([ten, five, vec![price]].concat())
}

/// Problems with local minima of the merit, and problems that show one difficulty each.
fn traps() -> Result<Vec<Instance>, ModelError> {
    let watson = Instance::new(
        "watson4",
        "Watson (1979), SIAM J. Control Optim. 17; MCPLIB",
        watson4_model()?,
    )
    .solved_by([0.0, 0.0, 1.0, 2.0, 3.0])
    .at_starts(&[[0.0; 5], [1.0; 5], [3.0; 5], [-1.0, 0.0, 1.0, 2.0, 3.5], [5.0; 5]]);
    let billups = Instance::new("billups", "Billups (1995), thesis, Wisconsin", billups_model()?)
        .solved_by([1.0 + 1.01_f64.sqrt()])
        .at_starts(&[[0.0], [0.5], [1.0], [3.0], [100.0]]);
    let own = "test of this collection";
    let others = vec![
        Instance::new("cycle", "textbook example of a Newton cycle", Cycle::new()?)
            .solved_by([-1.769_292_354_238_631_4]),
        Instance::new("cycle-lcp", own, CycleLcp::new()?).solved_by([0.4, 0.2]),
        Instance::new("munson1", own, Munson::new()?).solved_by([1.0, 0.0, 0.0]),
        Instance::new("tiny-box", own, TinyBox::new()?).solved_by([1.0, 1.0]),
        Instance::new("dblroot", own, DoubleRoot::new()?).solved_by([1.0]),
        Instance::new("sqbound", own, SquareAtBound::new()?).solved_by([0.0]),
        Instance::new("cubic-deg", own, CubicDegenerate::new()?).solved_by([0.0, 0.0]),
    ];
    Ok([watson, billups, others].concat())
}

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    let flat = Instance::new("neg-exp-box", "test of this collection", FlatExponential::new()?)
        .solved_by([6.0 * 10_f64.ln()]);
    let families = [
        quadratics()?,
        walras()?,
        cournot()?,
        kkt::powell_instances()?,
        traps()?,
        systems::instances()?,
    ];
    Ok([families.concat(), vec![flat]].concat())
}
