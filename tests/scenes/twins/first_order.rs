//! An Euler–Moreau step by hand, around the formulas of a scene.

use super::problems::Solved;
use super::{Facts, Number, Twin, bits};
use mcp_core::{Scalar, Tally};

type Map<'t> = Box<dyn Fn(&[Number<'t>]) -> Vec<Number<'t>>>;
type Push<'t> = Box<dyn Fn(&[Number<'t>], &mut [Number<'t>])>;
type Solve = Box<dyn Fn(&[f64], &[f64]) -> Solved>;

/// The multipliers of a system that has any.
pub(super) struct Multipliers<'t> {
    pub(super) bounds: Vec<[f64; 2]>,
    /// `C x° + a`.
    pub(super) output: Map<'t>,
    /// `x° += h W B λ`.
    pub(super) push: Push<'t>,
    /// Solves the step problem of this `C x° + a` from the last multipliers.
    pub(super) solve: Solve,
}

/// A linear system, with multipliers or without.
pub(super) struct Linear<'t> {
    tally: &'t Tally,
    x: Vec<Number<'t>>,
    free: Map<'t>,
    multipliers: Option<(Multipliers<'t>, Vec<f64>)>,
}

impl<'t> Linear<'t> {
    /// From `start`, with the free state `x°` as a function of the state.
    pub(super) fn boxed(
        tally: &'t Tally,
        start: &[f64],
        free: impl Fn(&[Number<'t>]) -> Vec<Number<'t>> + 'static,
        multipliers: Option<Multipliers<'t>>,
    ) -> Box<dyn Twin + 't> {
        let x = start.iter().map(|&x| tally.variable(x)).collect();
        let at_zero = |all: Multipliers<'t>| {
            let zeros = vec![0.0; all.bounds.len()];
            (all, zeros)
        };
        Box::new(Linear { tally, x, free: Box::new(free), multipliers: multipliers.map(at_zero) })
    }
}

impl Twin for Linear<'_> {
    fn step(&mut self) -> Facts {
        let before = self.tally.counts().total();
        let mut free = (self.free)(&self.x);
        let (mut active, mut solved, mut lambda) = (0, None, vec![]);
        if let Some((all, last)) = &mut self.multipliers {
            let q: Vec<f64> = (all.output)(&free).iter().map(Scalar::value).collect();
            let of = (all.solve)(&q, last);
            let numbers: Vec<_> = of.z.iter().map(|&z| self.tally.variable(z)).collect();
            (all.push)(&numbers, &mut free);
            last.clone_from(&of.z);
            lambda.clone_from(&of.z);
            let is_inside = |&k: &usize| {
                let [lower, upper] = all.bounds[k];
                of.f[k].abs() < (of.z[k] - lower).min(upper - of.z[k])
            };
            active = (0..all.bounds.len()).filter(is_inside).count();
            solved = Some(of);
        }
        self.x = free;
        let state: Vec<f64> =
            self.x.iter().map(Scalar::value).chain(lambda.iter().copied()).collect();
        let own = self.tally.counts().total() - before;
        Facts {
            unknowns: lambda.len(),
            active,
            iterations: solved.as_ref().map_or(0, |solved| solved.iterations),
            residual: solved.as_ref().map_or(0.0, |solved| solved.residual).to_bits(),
            nonzeros: solved.as_ref().map_or(0, |solved| solved.nonzeros),
            operations: own + solved.as_ref().map_or(0, |solved| solved.operations),
            state: bits(&state),
        }
    }
}
