//! `J` at the iterate, and the directions that follow from it.
//!
//! Where lists serve in turn (`Workspace::is_thrifty`), a system takes the place of its `J`, which is
//! evaluated again in the rare case that it is asked for once more.

use super::{Fault, Flow, Run, dot};
use crate::solver::monitor::Direction;
use crate::solver::status::Status;
use crate::solver::workspace::resize;
use std::ops::ControlFlow::{Break, Continue};

/// A gradient this small relative to its terms is zero up to rounding.
pub(super) const ZERO_GRADIENT: f64 = 1e-12;

impl Run<'_> {
    /// `J` at the iterate; the old one stays, and the fault is noted, if it is not finite.
    pub(super) fn evaluate_jacobian(&mut self) -> bool {
        self.stats.jacobian_evaluations += 1;
        let work = &mut *self.work;
        let jac = if work.is_thrifty { &mut work.jac } else { work.certifier.spare() };
        self.problem.evaluate(&work.current.z, None, Some(jac));
        if let Some(fault) = Fault::of_jacobian(self.problem.pattern(), jac) {
            self.fault = Some(fault);
            work.lost.jacobian = work.is_thrifty;
            work.fault_point.clone_from(&work.current.z);
            return false;
        }
        work.lost.jacobian = false;
        if !work.is_thrifty {
            std::mem::swap(&mut work.jac, work.certifier.spare());
        }
        true
    }

    /// `J` at the iterate anew, if it is lost: it was finite there.
    fn recover_jacobian(&mut self) {
        let work = &mut *self.work;
        if work.lost.jacobian {
            self.stats.jacobian_evaluations += 1;
            self.problem.evaluate(&work.current.z, None, Some(&mut work.jac));
            work.lost.jacobian = false;
        }
    }

    /// `a`, `b` and `∇θ` at the iterate.
    pub(super) fn linearise(&mut self) {
        self.recover_jacobian();
        self.work.lend_full(true);
        self.work.lost.gradient = false;
        self.work.linearise(self.problem);
    }

    /// Newton direction of the Fischer–Burmeister equations, `H d = −Φ`, if `H` is not singular.
    pub(in crate::solver) fn fb_direction(&mut self) -> Option<Direction> {
        self.newton_direction(Direction::FischerBurmeister)
    }

    /// Newton direction of the min map, if its linearisation is not singular.
    pub(in crate::solver) fn min_direction(&mut self) -> Option<Direction> {
        self.work.linearise_min(self.problem.shape());
        let direction = self.newton_direction(Direction::MinMap);
        if direction.is_none() {
            // The rows of the equations `Φ = 0` are asked for next.
            self.linearise();
        }
        direction
    }

    /// Solves the system of a direction, whose rows are in place.
    fn newton_direction(&mut self, direction: Direction) -> Option<Direction> {
        self.stats.factorisations += 1;
        self.work.system.set_accuracy(self.accuracy);
        let solved = self.solve_in_place(direction) || self.solve_beside(direction);
        self.system_is_singular = !solved;
        solved.then_some(direction)
    }

    /// Solves a system in the memory of `J`, if that is how this solver works.
    fn solve_in_place(&mut self, direction: Direction) -> bool {
        if !self.work.is_thrifty {
            return false;
        }
        self.recover_jacobian();
        let work = &mut *self.work;
        let r = if direction == Direction::MinMap { &work.answer } else { &work.current.phi };
        let rows = (&work.a[..], &work.b[..]);
        if !work.system.is_symmetric(&work.jac, rows) {
            return false;
        }
        work.lost.jacobian = true;
        work.system.solve_in_place(&mut work.jac, rows, r, &mut work.direction)
    }

    /// Solves a system with memory beside `J`.
    fn solve_beside(&mut self, direction: Direction) -> bool {
        self.recover_jacobian();
        let work = &mut *self.work;
        let r = if direction == Direction::MinMap { &work.answer } else { &work.current.phi };
        let (rows, spare) = ((&work.a[..], &work.b[..]), work.certifier.spare());
        resize(spare, work.jac.len());
        work.system.solve(&work.jac, spare, rows, r, &mut work.direction)
    }

    /// `d = −∇θ` and its slope `−‖∇θ‖²`; ends the solve where the gradient vanishes.
    pub(in crate::solver) fn gradient_direction(&mut self) -> Flow<(Direction, f64)> {
        if self.relative_gradient() <= ZERO_GRADIENT {
            return Break(self.status_without_progress(Status::LineSearchFailed));
        }
        let work = &mut *self.work;
        for (d, g) in work.direction.iter_mut().zip(&work.gradient) {
            *d = -g;
        }
        Continue((Direction::Gradient, -dot(&work.gradient, &work.gradient)))
    }

    /// The slope `∇θ·d` if the direction is one of sufficient descent.
    pub(in crate::solver) fn descent_slope(&mut self) -> Option<f64> {
        if self.work.lost.gradient {
            self.linearise();
        }
        let (rule, d) = (self.options.descent, &self.work.direction);
        let (slope, square) = (dot(&self.work.gradient, d), dot(d, d));
        // ‖d‖ᵖ <= ‖d‖² for p >= 2 and ‖d‖ <= 1: mostly the power is not needed.
        let is_descent = square <= 1.0 && slope <= -rule.rho * square
            || slope <= -rule.rho * square.sqrt().powf(rule.p);
        is_descent.then_some(slope)
    }

    /// `‖∇θ‖∞` at the iterate relative to its terms, whatever was linearised last.
    pub(super) fn relative_gradient(&mut self) -> f64 {
        self.linearise();
        self.work.relative_gradient(self.problem.pattern())
    }
}

#[cfg(test)]
#[path = "directions_tests.rs"]
mod tests;
