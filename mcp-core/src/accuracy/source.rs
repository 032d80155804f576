//! Where derivatives come from: exact ones, written by hand, or differences.

use crate::model::Shape;
use crate::problem::{Derived, Pattern, Problem};
use std::fmt;
use std::sync::Arc;

/// Where a Jacobian comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Source {
    /// [`Jet`](crate::Jet)s: [`Engine::Jet`](crate::Engine::Jet).
    #[default]
    Jet,
    /// num-dual: [`Engine::NumDual`](crate::Engine::NumDual).
    NumDual,
    /// Written by hand, for the problem at hand: [`ByHand`].
    ByHand,
    /// One-sided differences with the step `√ε max(|z|, 1)`.
    OneSided,
    /// Central differences with the step `∛ε max(|z|, 1)`.
    Central,
    /// Central differences with the best step of each variable, as nobody knows who has not the exact
    /// derivative: [`Differences::best_steps`].
    BestCentral,
}

impl Source {
    /// All of them.
    pub const ALL: [Source; 6] = [
        Source::Jet,
        Source::NumDual,
        Source::ByHand,
        Source::OneSided,
        Source::Central,
        Source::BestCentral,
    ];

    /// Name in tables: `jet`, `num-dual`, `by hand`, `one-sided`, `central`, `central, best step`.
    pub fn name(self) -> &'static str {
        match self {
            Source::Jet => "jet",
            Source::NumDual => "num-dual",
            Source::ByHand => "by hand",
            Source::OneSided => "one-sided",
            Source::Central => "central",
            Source::BestCentral => "central, best step",
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The formula of a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// `(F(z + h) − F(z))/h`, with `h < 0` where `z + h` would leave the box.
    OneSided,
    /// `(F(z + h) − F(z − h))/(2h)`; one-sided where `F` is not finite on one side.
    Central,
}

impl Scheme {
    /// Step relative to `max(|z|, 1)` that balances truncation and rounding where `F` and its
    /// derivatives are near 1: `√ε` and `∛ε` ([NW06](crate#references), section 8.1).
    pub fn default_step(self) -> f64 {
        match self {
            Scheme::OneSided => f64::EPSILON.sqrt(),
            Scheme::Central => f64::EPSILON.cbrt(),
        }
    }
}

/// A problem with its Jacobian by differences. Columns that share no row are moved at once
/// ([CPR74](crate#references)), so that a sparse Jacobian takes few evaluations of `F`.
pub struct Differences<P> {
    problem: P,
    scheme: Scheme,
    /// Relative step of every variable.
    steps: Vec<f64>,
    groups: Vec<Vec<usize>>,
    z: Vec<f64>,
    h: Vec<f64>,
    f: Vec<f64>,
    plus: Vec<f64>,
    minus: Vec<f64>,
}

impl<P: Problem> Differences<P> {
    /// With the default steps of the scheme.
    pub fn new(problem: P, scheme: Scheme) -> Self {
        let n = problem.shape().n();
        let groups = groups(problem.pattern());
        let [z, h, f, plus, minus] = std::array::from_fn(|_| vec![0.0; n]);
        let steps = vec![scheme.default_step(); n];
        Differences { problem, scheme, steps, groups, z, h, f, plus, minus }
    }

    /// The same with a relative step for each variable, by which `max(|z_j|, 1)` is multiplied.
    ///
    /// # Panics
    /// If there is not one step for each variable.
    #[must_use]
    pub fn with_steps(mut self, steps: &[f64]) -> Self {
        self.steps.copy_from_slice(steps);
        self
    }

    /// Evaluations of `F` that one Jacobian takes.
    pub fn passes_per_jacobian(&self) -> usize {
        1 + self.groups.len() * if self.scheme == Scheme::OneSided { 1 } else { 2 }
    }

    /// For each variable the step of `2⁻², 2⁻⁴, …, 2⁻⁵⁰` that brings its column at `z` nearest to the
    /// exact one: what an oracle would choose.
    ///
    /// # Panics
    /// If `z` or `exact` have other lengths than the problem.
    pub fn best_steps(mut self, z: &[f64], exact: &[f64]) -> Vec<f64> {
        let n = z.len();
        let (mut best, mut least) = (self.steps.clone(), vec![f64::INFINITY; n]);
        let mut jac = vec![0.0; exact.len()];
        for step in (1..=25).map(|k| 4_f64.powi(-k)) {
            self.steps.fill(step);
            self.evaluate(z, None, Some(&mut jac));
            for j in 0..n {
                let column = self.problem.pattern().column(j);
                let off =
                    column.map(|k| (jac[k] - exact[k]).abs()).fold(0.0, super::reference::worse);
                if off < least[j] {
                    (least[j], best[j]) = (off, step);
                }
            }
        }
        best
    }

    /// `F` at `z`, with the variables of a group moved by `sign · h`.
    fn moved(&mut self, z: &[f64], group: usize, sign: f64) {
        for &j in &self.groups[group] {
            self.z[j] = z[j] + sign * self.h[j];
        }
        let f = if sign > 0.0 { &mut self.plus } else { &mut self.minus };
        self.problem.evaluate(&self.z, Some(f), None);
        for &j in &self.groups[group] {
            self.z[j] = z[j];
        }
    }

    fn differences(&mut self, z: &[f64], jac: &mut [f64]) {
        let shape = Arc::clone(self.problem.shape());
        self.z.copy_from_slice(z);
        for j in 0..z.len() {
            // So that z + h − z is h.
            let h = (z[j] + self.steps[j] * z[j].abs().max(1.0)) - z[j];
            let leaves = self.scheme == Scheme::OneSided && z[j] + h > shape.bounds().upper()[j];
            self.h[j] = if leaves { -h } else { h };
        }
        for group in 0..self.groups.len() {
            self.moved(z, group, 1.0);
            if self.scheme == Scheme::Central {
                self.moved(z, group, -1.0);
            }
            for &j in &self.groups[group] {
                for k in self.problem.pattern().column(j) {
                    let i = self.problem.pattern().row(k);
                    let (plus, minus, f, h) = (self.plus[i], self.minus[i], self.f[i], self.h[j]);
                    jac[k] = match self.scheme {
                        Scheme::Central if !plus.is_finite() => (f - minus) / h,
                        Scheme::Central if minus.is_finite() => (plus - minus) / (2.0 * h),
                        _ => (plus - f) / h,
                    };
                }
            }
        }
    }
}

/// Groups of columns without a common row, each column in the first that fits
/// ([CPR74](crate#references)).
fn groups(pattern: &Pattern) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    // For every row the groups it has an entry in.
    let mut taken: Vec<Vec<usize>> = vec![Vec::new(); pattern.n()];
    for j in 0..pattern.n() {
        let is_free = |group: &usize| pattern.column_rows(j).all(|i| !taken[i].contains(group));
        let group = (0..groups.len()).find(is_free).unwrap_or(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(j);
        for i in pattern.column_rows(j) {
            taken[i].push(group);
        }
    }
    groups
}

impl<P: Problem> Problem for Differences<P> {
    fn shape(&self) -> &Arc<Shape> {
        self.problem.shape()
    }
    fn pattern(&self) -> &Pattern {
        self.problem.pattern()
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        let Some(jac) = jac else { return self.problem.evaluate(z, f, None) };
        self.problem.evaluate(z, Some(&mut self.f), None);
        self.differences(z, jac);
        if let Some(f) = f {
            f.copy_from_slice(&self.f);
        }
    }
    fn derived(&self, z: &[f64]) -> Derived {
        self.problem.derived(z)
    }
}

/// A problem with a Jacobian written by hand: `jacobian(z, values)` in the order of the pattern.
pub struct ByHand<P, J> {
    problem: P,
    jacobian: J,
}

impl<P: Problem, J: FnMut(&[f64], &mut [f64])> ByHand<P, J> {
    /// `F` of the problem, `J` of the function.
    pub fn new(problem: P, jacobian: J) -> Self {
        ByHand { problem, jacobian }
    }
}

impl<P: Problem, J: FnMut(&[f64], &mut [f64])> Problem for ByHand<P, J> {
    fn shape(&self) -> &Arc<Shape> {
        self.problem.shape()
    }
    fn pattern(&self) -> &Pattern {
        self.problem.pattern()
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        self.problem.evaluate(z, f, None);
        if let Some(jac) = jac {
            (self.jacobian)(z, jac);
        }
    }
    fn derived(&self, z: &[f64]) -> Derived {
        self.problem.derived(z)
    }
}

#[cfg(test)]
#[path = "source_tests.rs"]
mod tests;
