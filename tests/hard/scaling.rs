//! Known problems in other units: every other equation, or every other variable, multiplied by `2^k` or
//! `10^k`.

use crate::case::{Case, Expect};
use crate::common::{dense, evaluate};
use mcp_core::ModelError;
use mcp_core::testing::{self, Known};

/// A problem, made anew for every case.
type Make = fn() -> Result<Known, ModelError>;

const PROBLEMS: [Make; 4] =
    [testing::kojima_shindo, testing::josephy, testing::watson4, testing::rosen_suzuki];

/// What is measured in another unit.
#[derive(Clone, Copy, Debug)]
enum Units {
    Equations,
    Variables,
}

pub(crate) fn cases() -> Vec<Case> {
    let powers = [-12, -4, 4, 12].map(|k| (format!("10^{k}"), 10_f64.powi(k)));
    let binary = [-33, 33].map(|k| (format!("2^{k}"), 2_f64.powi(k)));
    let mut cases = Vec::new();
    for make in PROBLEMS {
        for (power, factor) in powers.iter().chain(&binary) {
            for units in [Units::Equations, Units::Variables] {
                cases.push(in_units(make, 0, units, power, *factor));
            }
        }
    }
    cases
}

/// `y_j = c_j z_j`, `G_i(y) = r_i F_i(z)`, from one of the problem's starts; solved where `z` is known to
/// be a solution.
fn in_units(make: Make, start: usize, units: Units, power: &str, factor: f64) -> Case {
    let mut known = make().expect("the problem is well formed");
    let n = known.problem.pattern().n();
    let every_other = |i: usize| if i.is_multiple_of(2) { factor } else { 1.0 };
    let factors: Vec<f64> = (0..n).map(every_other).collect();
    let (r, c) = match units {
        Units::Equations => (factors, vec![1.0; n]),
        Units::Variables => (vec![1.0; n], factors),
    };
    let bounds = known.problem.shape().bounds();
    let pair = |j: usize| (bounds.lower()[j] * c[j], bounds.upper()[j] * c[j]);
    let pairs: Vec<_> = (0..n).map(pair).collect();
    let scaled: Vec<f64> = known.starts[start].iter().zip(&c).map(|(z, c)| z * c).collect();
    let name = match units {
        Units::Equations => format!("{}, equations × {power}", known.name),
        Units::Variables => format!("{}, variables × {power}", known.name),
    };

    let (solutions, unit) = (known.solutions, c.clone());
    let is_solution = move |y: &[f64]| {
        let near = |(j, s): (usize, &f64)| (y[j] / unit[j] - s).abs() <= 1e-6 * s.abs().max(1.0);
        solutions.iter().any(|solution| solution.iter().enumerate().all(near))
    };
    let problem = dense(&pairs, &scaled, move |y, f, jac| {
        let z: Vec<f64> = (0..n).map(|j| y[j] / c[j]).collect();
        let (g, h) = evaluate(&mut *known.problem, &z);
        for i in 0..n {
            f[i] = g[i] * r[i];
            for j in 0..n {
                jac[i + n * j] = h[i + n * j] * r[i] / c[j];
            }
        }
    });
    Case::new(name, problem, &scaled, Expect::Member(Box::new(is_solution)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mcp_core::Method;

    #[test]
    fn units_do_not_matter() {
        crate::check::check_all(cases());
    }

    /// Decimal units round every number of the problem; the answer is the same point.
    #[test]
    fn decimal_units_matter_from_no_start() {
        for make in PROBLEMS {
            let starts = make().unwrap().starts.len();
            for start in 0..starts {
                for k in [-12, -7, -3, 3, 7, 12] {
                    for units in [Units::Equations, Units::Variables] {
                        let power = format!("10^{k}");
                        let mut case = in_units(make, start, units, &power, 10_f64.powi(k));
                        let solution = case.solve(Method::Robust);
                        let z = &solution.z;
                        assert!(case.is_met_by(&solution), "{}, start {start}: {z:?}", case.name);
                    }
                }
            }
        }
    }
}
