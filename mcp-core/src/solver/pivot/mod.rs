//! Complementary pivoting for affine problems: `F(z) = M z + q` on a box.
//!
//! Lemke's method ([CPS92](crate#references) section 4.4) with bounded variables: free, lower, upper,
//! boxed and fixed variables in any order; see the comments of `path.rs`. It ends after finitely many
//! exchanges, in a solution or on a ray. For copositive-plus `M` a ray proves that no solution
//! exists; for others it proves nothing ([`Status::Ray`]).
//!
//! It needs no start: the point given only decides where an equation is measured for its scale. A
//! problem whose Jacobian differs between two points is [`Status::NotAffine`].
//!
//! Cost: a factorisation every `n/4` exchanges, and one solve with `n` numbers more for each exchange
//! since, usually `n/2` to `2n` exchanges in all; families exist where the number is exponential
//! ([Mur78](crate#references)). Sparse matrices stay sparse. No iterations are counted but
//! exchanges.

mod basis;
mod path;
#[cfg(test)]
mod tests;

pub(super) use basis::Basis;
pub(super) use path::{Affine, PathEnd};

use super::certificate::Verdict;
use super::diagnosis::{Diagnosis, largest_entries};
use super::monitor::Direction;
use super::robust::{Sample, Sizes, View};
use super::run::{Flow, Run};
use super::stage::Stage;
use super::status::Status;
use std::convert::Infallible;
use std::ops::ControlFlow::Break;

/// Relative change of an entry of `J` that makes a problem nonlinear.
const CHANGE: f64 = 1e-10;

/// What the method works with, kept between solves.
pub(super) struct Memory {
    view: View,
    basis: Basis,
    y: Vec<f64>,
    q: Vec<f64>,
    jac: Vec<f64>,
}

/// Runs the path to its end.
pub(super) fn solve(run: &mut Run<'_>) -> Flow<Infallible> {
    run.stage = Stage::Pivoting;
    run.start()?;
    run.begin_iteration()?;
    let Some(mut memory) = run.work.pivoting.take().or_else(|| Memory::new(run)) else {
        return Break(Status::SingularSystem);
    };
    let end = memory.pivot(run);
    run.work.pivoting = Some(memory);
    end
}

impl Memory {
    fn new(run: &Run<'_>) -> Option<Box<Self>> {
        let pattern = run.problem.pattern();
        let (n, nnz) = (pattern.n(), pattern.nnz());
        let mut view = View::default();
        view.resize(n);
        let basis = Basis::new(pattern, run.options)?;
        Some(Box::new(Memory {
            view,
            basis,
            y: vec![0.0; n],
            q: vec![0.0; n],
            jac: vec![0.0; nnz],
        }))
    }

    /// `M` and `q` in scaled variables, the path, and the certificate of its end.
    fn pivot(&mut self, run: &mut Run<'_>) -> Flow<Infallible> {
        if !self.is_affine(run) {
            return Break(Status::NotAffine);
        }
        let (shape, pattern) = (run.problem.shape(), run.problem.pattern());
        let work = &mut *run.work;
        let (z, f) = (&work.current.z[..], &work.current.f[..]);
        let sample = Sample { z, f, jac: &work.jac, start: z, sizes: Sizes::AsOneEntry };
        self.view.unscaled(shape.bounds());
        self.view.measure(shape, pattern, sample);
        self.view.scale(&work.current.z, &mut self.y);
        self.q.copy_from_slice(&work.current.f);
        self.view.scale_residual(&mut self.q);
        self.jac.copy_from_slice(&work.jac);
        self.view.scale_jacobian(pattern, &mut self.jac);
        for (k, i, j) in pattern.entries() {
            self.q[i] -= self.jac[k] * self.y[j];
        }
        let problem = Affine { q: &self.q, lower: &self.view.lower, upper: &self.view.upper };
        self.basis.set_matrix(&self.jac, 0.0);
        self.basis.start_at_bounds(problem);
        let end = self.basis.follow(problem, run.options.max_iterations);
        run.stats.factorisations += self.basis.factorisations;
        run.stats.iterations += self.basis.exchanges;
        match end {
            PathEnd::Solved => {}
            PathEnd::Ray => {
                self.view.unscale_direction(&self.basis.ray, &mut self.y);
                let direction = largest_entries(&self.y);
                run.work.diagnosis = Some(Diagnosis::Ray { direction });
                return Break(Status::Ray);
            }
            PathEnd::Limit => return Break(Status::IterationLimit),
            PathEnd::Singular => return Break(Status::SingularSystem),
        }
        let bounds = run.problem.shape().bounds();
        self.view.unscale(&self.basis.y, bounds, &mut self.y);
        if self.y.iter().any(|z| !z.is_finite()) {
            // A matrix as small as that counts as singular; the start stays.
            return Break(Status::SingularSystem);
        }
        run.work.current.z.copy_from_slice(&self.y);
        run.evaluate_current();
        run.last = (Direction::Pivoting, 1.0);
        let _ = run.report();
        let verdict = run.certify().verdict(run.options.tol, run.options.tol_relative);
        Break(match verdict {
            Verdict::Accepted => Status::Solved,
            Verdict::Asymptotic => Status::SolvedAsymptotically,
            // Rounding: a basis on the way was nearly singular.
            Verdict::Refused => Status::SingularSystem,
        })
    }

    /// Whether `J` at another point of the box is that at the start.
    fn is_affine(&mut self, run: &mut Run<'_>) -> bool {
        for (j, (to, z)) in self.y.iter_mut().zip(&run.work.current.z).enumerate() {
            *to = z + (1.0 + z.abs()) * (0.5 + 0.1 * (j % 7) as f64);
        }
        run.problem.shape().bounds().project(&mut self.y);
        run.stats.jacobian_evaluations += 1;
        run.problem.evaluate(&self.y, None, Some(&mut self.jac));
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= CHANGE * a.abs().max(b.abs());
        run.work.jac.iter().zip(&self.jac).all(same)
    }
}
