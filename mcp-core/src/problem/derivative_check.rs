//! Is the Jacobian right? A second engine and differences with a step sweep, entry by entry.

use super::{AdProblem, Engine, Problem};
use crate::error::ModelError;
use crate::model::Model;
use std::fmt;

/// Two engines may differ by this many rounding errors of the absolute terms of an entry.
const ENGINE_TOLERANCE: f64 = 64.0 * f64::EPSILON;
/// Differences may differ by this many times their own estimated error,
const ERRORS: f64 = 8.0;
/// and by this share of the absolute terms.
const SHARE: f64 = 1e-9;
/// Differences that can not tell a derivative to this share of its absolute terms are no evidence.
const EVIDENCE: f64 = 1e-3;
/// Steps are the scale of the variable times `4⁻ᵏ`.
const STEPS: std::ops::RangeInclusive<i32> = 2..=13;
/// Where left and right slope differ by more than this share at two small steps, there is a kink.
const KINK: f64 = 1e-3;

/// One entry `∂F_i/∂z_j` and what it was compared with.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Name of the equation.
    pub equation: String,
    /// Name of the variable.
    pub variable: String,
    /// The derivative by [`Engine::Jet`].
    pub derivative: f64,
    /// What the other source gives.
    pub reference: f64,
    /// `|derivative − reference|` relative to the sum of the absolute terms of the entry.
    pub relative_difference: f64,
    /// Whether the difference is within what rounding and truncation explain.
    pub agrees: bool,
}

/// What [`check_derivatives`] found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DerivativeReport {
    /// Structural nonzeros compared.
    pub entries: usize,
    /// Entries at a kink of `F`, where differences mean nothing; engines were compared.
    pub kinks: usize,
    /// Entries where `F` is not finite, here or on both sides, or `J` is not; where `F` is finite
    /// here, engines were compared.
    pub beyond_domain: usize,
    /// Entries too small beside the other terms of their equation for differences to tell; engines
    /// were compared.
    pub drowned: usize,
    /// An equation and a variable it depends on although the pattern says it does not.
    pub missing: Option<(String, String)>,
    /// The worst entry against num-dual.
    pub worst_engine: Option<Comparison>,
    /// The worst entry against differences.
    pub worst_difference: Option<Comparison>,
}

/// What is wrong with a Jacobian.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WrongDerivative {
    /// Another source contradicts an entry.
    #[error(
        "∂ {} / ∂ {} is {:e}, but {source_name} gives {:e}",
        .entry.equation, .entry.variable, .entry.derivative, .entry.reference
    )]
    Contradicted {
        /// The worst entry.
        entry: Comparison,
        /// `num-dual` or `differences`.
        source_name: &'static str,
    },
    /// An entry is missing from the pattern: the model reads a variable only sometimes.
    #[error("`{equation}` depends on `{variable}`, which it did not read when it was recorded")]
    Missing {
        /// The equation.
        equation: String,
        /// The variable.
        variable: String,
    },
}

impl DerivativeReport {
    /// The report if every entry agrees with both sources.
    ///
    /// # Errors
    /// [`WrongDerivative`] names the missing entry, or the worst one that does not agree.
    pub fn verdict(self) -> Result<Self, WrongDerivative> {
        if let Some((equation, variable)) = self.missing.clone() {
            return Err(WrongDerivative::Missing { equation, variable });
        }
        let sources = [(&self.worst_engine, "num-dual"), (&self.worst_difference, "differences")];
        for (worst, source_name) in sources {
            if let Some(entry) = worst.as_ref().filter(|entry| !entry.agrees) {
                return Err(WrongDerivative::Contradicted { entry: entry.clone(), source_name });
            }
        }
        Ok(self)
    }
}

impl fmt::Display for DerivativeReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} entries", self.entries)?;
        let sources = [(&self.worst_engine, "num-dual"), (&self.worst_difference, "differences")];
        for (worst, name) in sources {
            if let Some(worst) = worst {
                let Comparison { equation, variable, relative_difference, .. } = worst;
                write!(
                    f,
                    ", worst relative difference to {name} {relative_difference:.0e} \
                     (∂ {equation} / ∂ {variable})"
                )?;
            }
        }
        let DerivativeReport { kinks, beyond_domain, drowned, .. } = self;
        write!(f, "; {kinks} at kinks, {beyond_domain} beyond the domain, {drowned} drowned")
    }
}

/// Compares every entry of the Jacobian at `z` with the second engine and with differences.
///
/// Two engines must agree to `64 eps` times the sum of the absolute terms of the entry
/// ([`Magnitude`](crate::Magnitude)). Differences are central, with steps from `1/16` to `4⁻¹³` of
/// the variable, the step with the smallest estimated error taken; one-sided where `F` is not
/// finite on one side. Kinks are recognised by left and right slopes that stay apart and are left
/// out of the comparison with differences. Cost: three passes for `J`, and `24 n` evaluations of
/// `F`.
///
/// As a test of a model, in one line:
///
/// ```
/// use mcp_core::{Real, Scalar, check_derivatives, mcp_fn};
/// #[mcp_fn(lower = 0.0)]
/// fn demand<D: Scalar>([p, q]: [Real<D>; 2]) -> [Real<D>; 2] {
///     [q - 10.0 * p.pow(-1.5), p.exp() - q.sqrt()]
/// }
/// check_derivatives(&Demand::new()?, &[0.7, 2.0])?.verdict()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`AdProblem::new`], and [`ModelError::Length`], [`ModelError::StartNotFinite`] for `z`.
pub fn check_derivatives<M: Model>(model: &M, z: &[f64]) -> Result<DerivativeReport, ModelError> {
    let mut problem = AdProblem::new(model)?;
    problem.shape().check_start(z)?;
    let (jacobian, f) = evaluate(&mut problem, z);
    let (reference, _) = evaluate(&mut AdProblem::with_engine(model, Engine::NumDual)?, z);
    let (magnitude, _) = evaluate(&mut AdProblem::of_magnitudes(model)?, z);

    let mut report = DerivativeReport {
        entries: jacobian.len(),
        kinks: 0,
        beyond_domain: 0,
        drowned: 0,
        missing: None,
        worst_engine: None,
        worst_difference: None,
    };
    let mut terms: Vec<f64> = f.iter().map(|f| f.abs()).collect();
    for (k, i, j) in problem.pattern().entries() {
        let term = (magnitude[k] * z[j]).abs();
        terms[i] += if term.is_finite() { term } else { 0.0 };
    }
    let mut sweep = Sweep::new(z, f, terms);
    for j in 0..z.len() {
        sweep.run(&mut problem, j);
        if let Some(i) = sweep.depends(|i| problem.pattern().position(i, j).is_none()) {
            let names = (problem.shape().equation_name(i), problem.shape().variable_name(j));
            report.missing.get_or_insert(names);
        }
        for k in problem.pattern().column(j) {
            let i = problem.pattern().row(k);
            let (size, derivative) = (magnitude[k], jacobian[k]);
            let compare = |reference: f64, tolerance: f64| {
                let difference = (derivative - reference).abs();
                let neither_finite = !derivative.is_finite() && !reference.is_finite();
                let same = derivative == reference || neither_finite;
                Comparison {
                    equation: problem.shape().equation_name(i),
                    variable: problem.shape().variable_name(j),
                    derivative,
                    reference,
                    relative_difference: if same { 0.0 } else { difference / size },
                    agrees: same || difference <= tolerance,
                }
            };
            if !sweep.f[i].is_finite() {
                report.beyond_domain += 1;
                continue;
            }
            let tolerance = ENGINE_TOLERANCE * size + f64::MIN_POSITIVE;
            keep_worst(&mut report.worst_engine, compare(reference[k], tolerance));
            match sweep.slope(i, size) {
                _ if !derivative.is_finite() => report.beyond_domain += 1,
                Slope::Unknown => report.beyond_domain += 1,
                Slope::Kink => report.kinks += 1,
                Slope::Estimate { error, .. } if ERRORS * error > EVIDENCE * size => {
                    report.drowned += 1;
                }
                Slope::Estimate { slope, error } => {
                    let tolerance = ERRORS * error + SHARE * size;
                    keep_worst(&mut report.worst_difference, compare(slope, tolerance));
                }
            }
        }
    }
    Ok(report)
}

/// `J` and `F` at `z`.
fn evaluate(problem: &mut dyn Problem, z: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(z, Some(&mut f), Some(&mut jac));
    (jac, f)
}

/// An entry that disagrees is worse than one that agrees; NaN is worst.
fn keep_worst(worst: &mut Option<Comparison>, entry: Comparison) {
    let is_worse = worst.as_ref().is_none_or(|kept| match (kept.agrees, entry.agrees) {
        (true, false) => true,
        (false, true) => false,
        _ => !(entry.relative_difference <= kept.relative_difference),
    });
    if is_worse {
        *worst = Some(entry);
    }
}

/// `F` at `z ± h e_j` for all steps of the sweep.
struct Sweep {
    z: Vec<f64>,
    f: Vec<f64>,
    /// Sum of the absolute terms of every `F_i`.
    terms: Vec<f64>,
    steps: Vec<Step>,
}

struct Step {
    /// The steps actually taken: `z + h − z` is not `h`.
    up: f64,
    down: f64,
    f_up: Vec<f64>,
    f_down: Vec<f64>,
}

enum Slope {
    Estimate { slope: f64, error: f64 },
    Kink,
    Unknown,
}

impl Sweep {
    fn new(z: &[f64], f: Vec<f64>, terms: Vec<f64>) -> Self {
        let step =
            |_| Step { up: 0.0, down: 0.0, f_up: vec![0.0; f.len()], f_down: vec![0.0; f.len()] };
        Sweep { z: z.to_vec(), steps: STEPS.map(step).collect(), f, terms }
    }

    fn run(&mut self, problem: &mut dyn Problem, j: usize) {
        let centre = self.z[j];
        let scale = if centre == 0.0 { 1.0 } else { centre.abs() };
        for (step, k) in self.steps.iter_mut().zip(STEPS) {
            let h = scale * 0.25_f64.powi(k);
            self.z[j] = centre + h;
            step.up = self.z[j] - centre;
            problem.evaluate(&self.z, Some(&mut step.f_up), None);
            self.z[j] = centre - h;
            step.down = centre - self.z[j];
            problem.evaluate(&self.z, Some(&mut step.f_down), None);
        }
        self.z[j] = centre;
    }

    /// The first of the equations `of` whose value changed at any step.
    fn depends(&self, of: impl Fn(usize) -> bool) -> Option<usize> {
        let same = |a: f64, b: f64| a == b || a.is_nan() && b.is_nan();
        let changed =
            |i: usize, s: &Step| !same(s.f_up[i], self.f[i]) || !same(s.f_down[i], self.f[i]);
        (0..self.f.len()).find(|&i| of(i) && self.steps.iter().any(|s| changed(i, s)))
    }

    /// Derivative of `F_i` with the smallest estimated error: what the last changes from step to step
    /// leave to come, plus rounding. `size` is the sum of the absolute terms.
    fn slope(&self, i: usize, size: f64) -> Slope {
        let f = self.f[i];
        let right = |s: &Step| (s.f_up[i] - f) / s.up;
        let left = |s: &Step| (f - s.f_down[i]) / s.down;
        let central = |s: &Step| (s.f_up[i] - s.f_down[i]) / (s.up + s.down);
        let rounding = |s: &Step| {
            let values = f.abs() + s.f_up[i].abs() + s.f_down[i].abs();
            let values = if values.is_finite() { values } else { f.abs() };
            f64::EPSILON * (values + self.terms[i] + size * s.up) / s.up
        };
        if self.is_kink(&right, &left, &rounding) {
            return Slope::Kink;
        }
        let mut best = (f64::NAN, f64::INFINITY);
        let sides: [&dyn Fn(&Step) -> f64; 3] = [&central, &right, &left];
        for side in sides {
            for (k, three) in self.steps.windows(3).enumerate() {
                let [coarse, middle, fine] = [0, 1, 2].map(|k| side(&three[k]));
                // The rest of a geometric series: at a corner of the domain it converges slowly.
                let (before, last) = ((middle - coarse).abs(), (fine - middle).abs());
                let ratio = (last / before).min(0.99);
                let estimate = last / (1.0 - ratio) + rounding(&three[2]);
                // Finer steps that contradict beyond their rounding.
                let contradiction = |s: &Step| (side(s) - fine).abs() - 2.0 * rounding(s);
                let error = self.steps[k + 3..].iter().map(contradiction).fold(estimate, f64::max);
                if error < best.1 {
                    best = (fine, error);
                }
            }
            if best.1.is_finite() {
                break;
            }
        }
        if best.1.is_finite() {
            Slope::Estimate { slope: best.0, error: best.1 }
        } else {
            Slope::Unknown
        }
    }

    /// Left and right slopes differ by a share of their size that does not shrink with the step.
    fn is_kink(
        &self,
        right: &dyn Fn(&Step) -> f64,
        left: &dyn Fn(&Step) -> f64,
        rounding: &dyn Fn(&Step) -> f64,
    ) -> bool {
        let gap = |s: &Step| right(s) - left(s);
        let size = |s: &Step| right(s).abs() + left(s).abs();
        // Small steps, but above rounding.
        let usable = |s: &&Step| 100.0 * rounding(s) < KINK * size(s);
        let mut small = self.steps.iter().rev().filter(usable);
        let (Some(fine), Some(coarse)) = (small.next(), small.next()) else { return false };
        gap(fine).abs() > KINK * size(fine) && gap(fine).abs() > 0.5 * gap(coarse).abs()
    }
}

#[cfg(test)]
#[path = "derivative_check_tests.rs"]
mod tests;
