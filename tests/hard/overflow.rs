//! Numbers that overflow, walls beyond which `F` is NaN, and directions that are NaN.

use crate::case::{Case, Expect};
use crate::common::{FREE, INF, NONNEGATIVE, dense, scalar};
use mcp_core::{AdProblem, Problem, Real, Scalar, Status, logsumexp, mcp_fn};

/// A logit of two goods with utilities ±10⁴: the share of the worse one is 0 to all digits.
#[mcp_fn(lower = 0.0, upper = 1.0, start = 0.5)]
fn logit<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    let total = logsumexp([1e4, -1e4], Real::<D>::from);
    [x - (1e4 - total).exp(), y - (-1e4 - total).exp()]
}

/// Ends that claim nothing.
const FAILS: Expect = Expect::Fails(&[
    Status::Stalled,
    Status::StationaryPoint,
    Status::SolvedAsymptotically,
    Status::Diverged,
    Status::SingularSystem,
    Status::DomainError,
    Status::IterationLimit,
]);

/// `y + 1 + x ⟂ x >= 0`, `g(x) ⟂ y >= 0`, for a `g` with a wall next to 0.
fn beside_a_wall(g: fn(f64) -> (f64, f64), start: [f64; 2]) -> impl Problem {
    dense(&[NONNEGATIVE; 2], &start, move |z, f, jac| {
        let (value, slope) = g(z[0]);
        f.copy_from_slice(&[z[1] + 1.0 + z[0], value]);
        jac.copy_from_slice(&[1.0, slope, 1.0, 0.0]);
    })
}

/// Slopes next to a wall are so steep that a root seems near.
fn walls() -> Vec<Case> {
    let mut cases = Vec::new();
    for c in [0.01, 1.0, 7.0] {
        for start in [0.1, 1.0, 10.0] {
            let root = move |x: f64| (x.sqrt() + c, 0.5 / x.sqrt());
            let power = move |x: f64| (x.powf(0.3) + c, 0.3 * x.powf(-0.7));
            let name = |what: &str| format!("{what} + {c} = 0 from {start}");
            cases.push(Case::new(name("√x"), scalar(FREE, start, root), &[start], FAILS));
            cases.push(Case::new(name("x^0.3"), scalar(FREE, start, power), &[start], FAILS));
        }
    }
    let logarithm = |x: f64| ((x + 1e-12).ln() + 1.0, 1.0 / (x + 1e-12));
    let problem = beside_a_wall(logarithm, [1.0, 1.0]);
    cases.push(Case::new("ln(x + 1e-12) + 1 at a bound of x", problem, &[1.0, 1.0], FAILS));
    cases
}

pub(crate) fn cases() -> Vec<Case> {
    let exponential = |z: f64| (z.exp() - 10.0, z.exp());
    // Undefined beyond 3; the full step from 0 goes to 3.2 and further.
    let wall = |z: f64| if z > 3.0 { (f64::NAN, f64::NAN) } else { (z * z * z - 8.0, 3.0 * z * z) };
    let cliff = |z: f64| ((3.0 - z).sqrt() - 0.1, -0.5 / (3.0 - z).sqrt());
    let huge = |z: f64| (1e300 * (z - 2.0), 1e300);
    let tiny = |z: f64| (1e-300 * (z - 2.0), 1e-300);
    let nan = |_: f64| (f64::NAN, f64::NAN);
    let nan_slope = |z: f64| (z - 1.0, f64::NAN);
    let domain = || Expect::Fails(&[Status::DomainError]);
    let logit = AdProblem::new(Logit::new().expect("well formed")).expect("well formed");
    let line = |z: f64| (z - 3.0, 1.0);
    let mut cases = vec![
        Case::at("e^z = 10 from 100", scalar(FREE, 100.0, exponential), &[100.0], &[10_f64.ln()]),
        Case::at("e^z = 10 from −20", scalar(FREE, -20.0, exponential), &[-20.0], &[10_f64.ln()]),
        Case::new("e^z = 10 from 800", scalar(FREE, 800.0, exponential), &[800.0], domain()),
        Case::at("logit of utilities ±10⁴", logit, &[0.5, 0.5], &[1.0, 0.0]),
        Case::at("a wall beyond 3, from 1", scalar(FREE, 1.0, wall), &[1.0], &[2.0]),
        Case::at("a wall beyond 3, from 3", scalar(FREE, 3.0, wall), &[3.0], &[2.0]),
        // F(3) = −0.1 <= 0: the bound is a solution too.
        Case::new("a cliff at 3", scalar((-INF, 3.0), 0.0, cliff), &[0.0], {
            Expect::Near { solutions: vec![vec![2.99], vec![3.0]], within: 1e-8 }
        }),
        Case::new("F = 1e300 (z − 2)", scalar(NONNEGATIVE, 0.0, huge), &[0.0], domain()),
        Case::at("F = 1e-300 (z − 2)", scalar(NONNEGATIVE, 0.0, tiny), &[0.0], &[2.0]),
        Case::new("z = 3 from −1e300", scalar(FREE, -1e300, line), &[-1e300], domain()),
        Case::new("NaN everywhere", scalar(NONNEGATIVE, 0.0, nan), &[0.0], domain()),
        Case::new("a derivative that is NaN", scalar(FREE, 0.0, nan_slope), &[0.0], domain()),
    ];
    cases.extend(walls());
    cases
}

#[cfg(test)]
#[test]
fn overflow_and_walls_end_in_a_solution_or_a_domain_error() {
    crate::check::check_all(cases());
}
