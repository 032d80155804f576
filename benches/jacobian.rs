//! Time and error of a Jacobian by where it comes from: `cargo bench --bench jacobian`.
//!
//! `J/F` is the time of `J` without `F` by the time of one `F`, both the quickest of many runs; the
//! error is the largest difference to the hand-written entry, by the largest entry of its row. `F`
//! is the same Rust function for every source.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use mcp_core::accuracy::{Budget, ByHand, Differences, Scheme, Timing};
use mcp_core::{AdProblem, Engine, ModelError, Problem, Real, Scalar, mcp, mcp_fn, sum};
use std::hint::black_box;
use std::time::Duration;

/// Kojima & Shindo (1986).
#[mcp_fn(lower = 0.0)]
fn kojima_shindo<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
        2 * x1 * x1 + x1 + x2 * x2 + 10 * x3 + 2 * x4 - 2,
        3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 9 * x4 - 9,
        x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
    ]
}

fn jacobian_of_kojima_shindo(z: &[f64], jac: &mut [f64]) {
    let (x1, x2) = (z[0], z[1]);
    jac.copy_from_slice(&[
        6.0 * x1 + 2.0 * x2,
        4.0 * x1 + 1.0,
        6.0 * x1 + x2,
        2.0 * x1,
        2.0 * x1 + 4.0 * x2,
        2.0 * x2,
        x1 + 4.0 * x2,
        6.0 * x2,
        1.0,
        10.0,
        2.0,
        2.0,
        3.0,
        2.0,
        9.0,
        3.0,
    ]);
}

const COST: [f64; 10] = [5.0, 3.0, 8.0, 5.0, 1.0, 3.0, 7.0, 4.0, 6.0, 3.0];
const BETA: [f64; 10] = [1.2, 1.0, 0.9, 0.6, 1.5, 1.0, 0.7, 1.1, 0.95, 0.75];
const GAMMA: f64 = 1.2;

/// Cournot equilibrium of ten firms, data after Harker's ten-firm example.
#[mcp_fn(lower = 1e-6, start = 10.0)]
fn cournot<D: Scalar>(q: [Real<D>; 10]) -> [Real<D>; 10] {
    let total = sum(q, |q| q);
    let price = (5000.0 / total).pow(1.0 / GAMMA);
    std::array::from_fn(|i| {
        COST[i] + (10.0 * q[i]).pow(1.0 / BETA[i]) - price + price * q[i] / (GAMMA * total)
    })
}

fn jacobian_of_cournot(q: &[f64], jac: &mut [f64]) {
    let total: f64 = q.iter().sum();
    let price = (5000.0 / total).powf(1.0 / GAMMA);
    let slope = -price / (GAMMA * total);
    for i in 0..10 {
        // ∂/∂Q of −p + p q_i/(γQ), and what q_i adds beyond the total.
        let by_total = -slope + (slope - price / total) * q[i] / (GAMMA * total);
        for j in 0..10 {
            jac[10 * j + i] = by_total;
        }
        let cost = (10.0 * q[i]).powf(1.0 / BETA[i]) / (BETA[i] * q[i]);
        jac[11 * i] += cost + price / (GAMMA * total);
    }
}

mcp! {
    /// Exchange among consumers with constant elasticities of substitution.
    model Walras {
        data {
            goods: usize, consumers: usize, sigma[consumers]: f64,
            endowment[consumers, goods]: f64, weight[consumers, goods]: f64
        }
        var p[i in goods] >= 1e-6;
        def power[c in consumers, i in goods]: p[i].pow(-sigma[c]);
        def spending[c in consumers]: sum(goods, |i| endowment[c, i] * p[i])
            / sum(goods, |i| weight[c, i] * p[i] * power[c, i]);
        eq excess[i in goods]:
            sum(consumers, |c| endowment[c, i] - spending[c] * weight[c, i] * power[c, i])
            complements p[i];
    }
}

const CONSUMERS: usize = 5;

/// Numbers in (0, 1) that look random.
fn spread(count: usize, by: f64) -> Vec<f64> {
    (1..=count).map(|k| (k as f64 * by).fract()).collect()
}

struct Exchange {
    goods: usize,
    endowment: Vec<f64>,
    weight: Vec<f64>,
    sigma: Vec<f64>,
}

impl Exchange {
    fn new(goods: usize) -> Self {
        let shifted = |by, shift: f64| -> Vec<f64> {
            spread(CONSUMERS * goods, by).iter().map(|x| x + shift).collect()
        };
        let sigma = spread(CONSUMERS, 0.381).iter().map(|x| x + 0.3).collect();
        Exchange { goods, endowment: shifted(0.618, 0.5), weight: shifted(0.414, 0.2), sigma }
    }

    fn model(&self) -> Result<Walras, ModelError> {
        Walras::builder()
            .goods(self.goods)
            .consumers(CONSUMERS)
            .sigma(self.sigma.clone())
            .endowment(self.endowment.clone())
            .weight(self.weight.clone())
            .build()
    }

    fn jacobian(&self, p: &[f64], jac: &mut [f64]) {
        let n = self.goods;
        jac.fill(0.0);
        let mut power = vec![0.0; n];
        for c in 0..CONSUMERS {
            let of = |list| -> &[f64] { &<Vec<f64> as AsRef<[f64]>>::as_ref(list)[c * n..][..n] };
            let (endowment, weight, sigma) = (of(&self.endowment), of(&self.weight), self.sigma[c]);
            let (mut income, mut index) = (0.0, 0.0);
            for i in 0..n {
                power[i] = p[i].powf(-sigma);
                income += endowment[i] * p[i];
                index += weight[i] * p[i] * power[i];
            }
            let spending = income / index;
            for j in 0..n {
                let slope =
                    (endowment[j] - spending * (1.0 - sigma) * power[j] * weight[j]) / index;
                for i in 0..n {
                    jac[n * j + i] -= weight[i] * power[i] * slope;
                }
                jac[n * j + j] += spending * sigma * weight[j] * power[j] / p[j];
            }
        }
    }
}

/// Seconds of one call: the quickest of many runs of as many calls as take 20 µs.
fn seconds(mut call: impl FnMut()) -> f64 {
    let once = Timing::measure(Budget::default(), &mut call).minimum;
    let calls = (20e-6 / once).ceil().clamp(1.0, 1e4);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let repeated = calls as u32;
    let budget = Budget { runs: 1000, time: Duration::from_millis(300) };
    Timing::measure(budget, || (0..repeated).for_each(|_| call())).minimum / calls
}

/// Largest difference of an entry, by the largest exact entry of its row.
fn error(problem: &dyn Problem, jac: &[f64], exact: &[f64]) -> f64 {
    let mut largest = vec![0.0_f64; problem.pattern().n()];
    let entries = || problem.pattern().entries();
    entries().for_each(|(k, i, _)| largest[i] = largest[i].max(exact[k].abs()));
    entries().map(|(k, i, _)| (jac[k] - exact[k]).abs() / largest[i]).fold(0.0, f64::max)
}

fn compare<M: mcp_core::Model>(
    name: &str,
    model: impl Fn() -> Result<M, ModelError>,
    by_hand: impl Fn(&[f64], &mut [f64]),
    z: &[f64],
) -> Result<(), ModelError> {
    let problem = || AdProblem::new(model()?);
    let differences = |scheme| Ok::<_, ModelError>(Differences::new(problem()?, scheme));
    let mut sources: Vec<(&str, Box<dyn Problem>)> = vec![
        ("by hand", Box::new(ByHand::new(problem()?, &by_hand))),
        ("jet", Box::new(problem()?)),
        ("num-dual", Box::new(AdProblem::with_engine(model()?, Engine::NumDual)?)),
        ("one-sided", Box::new(differences(Scheme::OneSided)?)),
        ("central", Box::new(differences(Scheme::Central)?)),
    ];
    let mut plain = problem()?;
    let (n, nnz) = (z.len(), plain.pattern().nnz());
    assert_eq!(nnz, n * n, "{name}: the hand-written Jacobian is dense");
    let (mut f, mut jac, mut exact) = (vec![0.0; n], vec![0.0; nnz], vec![0.0; nnz]);
    let of_f = seconds(|| plain.evaluate(black_box(z), Some(&mut f), None));
    by_hand(z, &mut exact);
    println!("{name}, n = {n}: F {:.3} µs", of_f * 1e6);
    for (source, problem) in &mut sources {
        let of_j = seconds(|| problem.evaluate(black_box(z), None, Some(&mut jac)));
        let (ratio, off) = (of_j / of_f, error(&**problem, &jac, &exact));
        println!("  {source:10} {:>10.3} µs  J/F {ratio:>7.2}  error {off:>8.1e}", of_j * 1e6);
    }
    Ok(())
}

fn main() -> Result<(), ModelError> {
    let z = [1.2, 0.3, 0.1, 0.6];
    compare("Kojima–Shindo", KojimaShindo::new, jacobian_of_kojima_shindo, &z)?;
    let q: Vec<f64> = (0..10).map(|i| 8.0 + f64::from(i)).collect();
    compare("Cournot", Cournot::new, jacobian_of_cournot, &q)?;
    for goods in [5, 20, 50] {
        let exchange = Exchange::new(goods);
        let p: Vec<f64> = (0..goods).map(|i| 0.8 + 0.05 * (i % 7) as f64).collect();
        compare("Walras", || exchange.model(), |p, jac| exchange.jacobian(p, jac), &p)?;
    }
    Ok(())
}
