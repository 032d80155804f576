//! One solve in progress: evaluations with their bookkeeping, trial points, endings.

mod directions;

use super::certificate::{Certificate, Verdict};
use super::monitor::{Direction, Iteration, Monitor};
use super::options::{Criterion, Options};
use super::solution::Stats;
use super::stage::Stage;
use super::status::Status;
use super::workspace::Workspace;
use crate::globalise::{Forcing, StallWatch};
use crate::problem::{Pattern, Problem};
use directions::ZERO_GRADIENT;
use std::ops::ControlFlow::{self, Break, Continue};
use std::time::Instant;

/// What a step of a method results in: the status that ends the solve, or a value to go on with.
pub(super) type Flow<T = ()> = ControlFlow<Status, T>;

/// A failed search at a gradient this small has ended near a stationary point.
const SMALL_GRADIENT: f64 = 1e-5;

/// Which trial point a step leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Candidate {
    /// The full Newton step.
    Full,
    /// The trial point evaluated last.
    Trial,
}

/// A non-finite `F`, or entry of `J` by the given variable.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fault {
    pub(super) equation: usize,
    pub(super) variable: Option<usize>,
    pub(super) value: f64,
}

impl Fault {
    /// Of the first entry of `J` that is not finite.
    pub(super) fn of_jacobian(pattern: &Pattern, jac: &[f64]) -> Option<Self> {
        let (k, equation, column) = pattern.first_not_finite(jac)?;
        Some(Fault { equation, variable: Some(column), value: jac[k] })
    }

    /// Of the first `F_i` that is not finite. With a finite `F` it is the merit that overflows: the
    /// largest `Φ_i` is to blame.
    pub(super) fn of_residual(f: &[f64], phi: &[f64]) -> Option<Self> {
        let largest =
            || (0..phi.len()).max_by(|&i, &j| f64::total_cmp(&phi[i].abs(), &phi[j].abs()));
        let equation = f.iter().position(|f| !f.is_finite()).or_else(largest)?;
        Some(Fault { equation, variable: None, value: f[equation] })
    }
}

/// A solve in progress.
pub(super) struct Run<'a> {
    pub(super) problem: &'a mut dyn Problem,
    pub(super) options: &'a Options,
    pub(super) work: &'a mut Workspace,
    pub(super) monitor: Option<&'a mut dyn Monitor>,
    pub(super) stats: Stats,
    /// The last non-finite value seen; its point stands in `work.fault_point`.
    pub(super) fault: Option<Fault>,
    pub(super) start_was_moved: bool,
    /// The certificate of the point that ended the solve, if it was asked.
    pub(super) certificate: Option<Certificate>,
    began: Option<Instant>,
    stall: StallWatch,
    forcing: Forcing,
    /// How accurately iterative linear solvers solve the system at hand.
    accuracy: f64,
    /// What the step to the iterate was.
    pub(super) last: (Direction, f64),
    pub(super) stage: Stage,
    system_is_singular: bool,
    /// The iterate the monitor saw last.
    reported: Option<usize>,
}

impl<'a> Run<'a> {
    /// A solve of `problem` from the iterate in `work`.
    pub(super) fn new(
        problem: &'a mut dyn Problem,
        options: &'a Options,
        work: &'a mut Workspace,
        monitor: Option<&'a mut dyn Monitor>,
    ) -> Self {
        Run {
            problem,
            options,
            work,
            monitor,
            stats: Stats::default(),
            fault: None,
            start_was_moved: false,
            certificate: None,
            // The only clock, and only where a limit is set.
            began: options.time_limit.map(|_| Instant::now()),
            stall: StallWatch::new(f64::INFINITY),
            forcing: Forcing::default(),
            accuracy: 0.0,
            last: (Direction::Start, 0.0),
            stage: Stage::default(),
            system_is_singular: false,
            reported: None,
        }
    }

    /// `F`, and `J` unless the start is a solution. Where they are not finite, variables at a bound
    /// are moved inside once.
    pub(super) fn start(&mut self) -> Flow {
        loop {
            self.stats.residual_evaluations += 1;
            let work = &mut *self.work;
            work.current.evaluate(self.problem, &work.kinds);
            let merit = work.current.merit;
            if merit.is_nan() {
                self.note_fault_of_residual(None);
            } else {
                self.work.reference.accept(merit);
                self.stall = StallWatch::new(merit);
                if !self.options.criterion.needs_gradient() {
                    self.end_if_solved()?;
                }
                if self.evaluate_jacobian() {
                    return Continue(());
                }
            }
            if self.start_was_moved || !self.move_inside() {
                return Break(Status::DomainError);
            }
            self.work.reference.reset();
            self.fault = None;
        }
    }

    /// Moves variables at a bound by `min(u − l, 10) / 10` into the box; false if there are none.
    pub(super) fn move_inside(&mut self) -> bool {
        let bounds = self.problem.shape().bounds();
        for (i, z) in self.work.current.z.iter_mut().enumerate() {
            let (l, u) = (bounds.lower()[i], bounds.upper()[i]);
            let inward = 0.1 * (u - l).min(10.0);
            if inward > 0.0 && (*z == l || *z == u) {
                let inside = if *z == l { l + inward } else { u - inward };
                self.start_was_moved |= inside != *z;
                *z = inside;
            }
        }
        self.start_was_moved
    }

    /// Monitor, limits, stall; then `Da`, `Db` and `∇θ` at the iterate. Iterations begin here.
    pub(super) fn begin_iteration(&mut self) -> Flow {
        self.linearise();
        self.accuracy = self.forcing.next(self.work.current.merit);
        if self.options.criterion.needs_gradient() {
            self.end_if_solved()?;
        }
        self.report()?;
        self.check_limits()?;
        match self.options.stall {
            Some(rule) if self.stall.observe(self.work.current.merit, rule) => {
                Break(self.status_without_progress(Status::Stalled))
            }
            _ => Continue(()),
        }
    }

    /// Ends the solve at the limits the caller set.
    pub(super) fn check_limits(&self) -> Flow {
        if self.stats.iterations >= self.options.max_iterations {
            return Break(Status::IterationLimit);
        }
        match (self.began, self.options.time_limit) {
            (Some(began), Some(limit)) if began.elapsed() >= limit => Break(Status::TimeLimit),
            _ => Continue(()),
        }
    }

    /// `F` and the merit at the iterate, for the monitor.
    pub(super) fn evaluate_current(&mut self) {
        self.stats.residual_evaluations += 1;
        let work = &mut *self.work;
        work.current.evaluate(self.problem, &work.kinds);
    }

    /// Tells the monitor about the iterate.
    pub(super) fn report(&mut self) -> Flow {
        let Some(monitor) = &mut self.monitor else { return Continue(()) };
        if self.reported.replace(self.stats.iterations) == Some(self.stats.iterations) {
            return Continue(());
        }
        let point = &self.work.current;
        let natural = point.natural(self.problem.shape());
        let iteration = Iteration {
            k: self.stats.iterations,
            residual_evaluations: self.stats.residual_evaluations,
            jacobian_evaluations: self.stats.jacobian_evaluations,
            fb_norm: (2.0 * point.merit).sqrt(),
            natural_residual: natural.residual,
            step: self.last.1,
            direction: self.last.0,
            stage: self.stage,
            active: natural.active,
            worst: natural.worst,
            z: &point.z,
            f: &point.f,
            problem: &*self.problem,
        };
        match monitor.iteration(&iteration) {
            Continue(()) => Continue(()),
            Break(()) => Break(Status::Interrupted),
        }
    }

    /// Ends the solve if the criterion is met and the certificate agrees. A criterion never decides
    /// by itself: if the certificate refuses, the iteration goes on.
    fn end_if_solved(&mut self) -> Flow {
        if !self.criterion_is_met() {
            return Continue(());
        }
        let certificate = self.certify();
        let status = match certificate.verdict(self.options.tol, self.options.tol_relative) {
            Verdict::Accepted => Status::Solved,
            Verdict::Asymptotic => Status::SolvedAsymptotically,
            Verdict::Refused => {
                self.certificate = None;
                return Continue(());
            }
        };
        // The last iterate is shown as well; the solve ends whatever the monitor answers.
        let _ = self.report();
        Break(status)
    }

    /// NaN never meets a criterion.
    fn criterion_is_met(&self) -> bool {
        // Without an absolute tolerance only the certificate can tell.
        let Some(tol) = self.options.tol else { return true };
        let point = &self.work.current;
        let fb_norm = || (2.0 * point.merit).sqrt();
        let gradient = || norm(&self.work.gradient);
        let measure = match self.options.criterion {
            Criterion::NaturalResidual => point.natural(self.problem.shape()).residual,
            Criterion::FbNorm => fb_norm(),
            Criterion::Stationarity => gradient(),
            Criterion::FbNormAndStationarity => fb_norm().max(gradient()),
        };
        measure <= tol
    }

    /// Judges the projection of the iterate into the box, which becomes the answer.
    pub(super) fn certify(&mut self) -> Certificate {
        self.stats.certificate_evaluations += 1;
        let certificate = self.work.certify(self.problem);
        self.certificate = Some(certificate);
        certificate
    }

    /// Evaluates `z + t d` and returns its merit, NaN where `F` is not finite.
    pub(super) fn evaluate(&mut self, candidate: Candidate, t: f64) -> f64 {
        self.stats.residual_evaluations += 1;
        let work = &mut *self.work;
        let point = match candidate {
            Candidate::Full => {
                work.lend_full(false);
                &mut work.full
            }
            Candidate::Trial => {
                work.trial.resize(work.current.z.len());
                &mut work.trial
            }
        };
        for ((to, z), d) in point.z.iter_mut().zip(&work.current.z).zip(&work.direction) {
            *to = z + t * d;
        }
        point.evaluate(self.problem, &work.kinds);
        let merit = point.merit;
        if merit.is_nan() {
            self.note_fault_of_residual(Some(candidate));
        }
        merit
    }

    /// Searches along the direction; the full step, if it is known, is not evaluated again. Ends
    /// the solve if no step is accepted.
    pub(super) fn search(&mut self, direction: Direction, slope: f64, full_is_known: bool) -> Flow {
        let armijo = self.options.armijo;
        let reference = self.work.reference.value(self.work.current.merit);
        let mut nothing_was_defined = true;
        for t in armijo.steps() {
            let candidate =
                if full_is_known && t == 1.0 { Candidate::Full } else { Candidate::Trial };
            let merit = match candidate {
                Candidate::Full => self.work.full.merit,
                Candidate::Trial => self.evaluate(Candidate::Trial, t),
            };
            if merit.is_nan() {
                continue;
            }
            let accepted = armijo.accepts(merit, reference, t, slope);
            if accepted && self.take(candidate, t, direction)? {
                return Continue(());
            }
            // An accepted point that was not taken has no finite J.
            nothing_was_defined &= accepted;
        }
        Break(if nothing_was_defined {
            Status::DomainError
        } else {
            self.status_without_progress(Status::LineSearchFailed)
        })
    }

    /// Makes a candidate the iterate and ends the solve if it is a solution. False, with the old
    /// iterate back, if `J` is not finite there.
    pub(super) fn take(
        &mut self,
        candidate: Candidate,
        t: f64,
        direction: Direction,
    ) -> Flow<bool> {
        self.exchange(candidate);
        let before = (self.stats, self.last);
        self.stats.iterations += 1;
        self.stats.gradient_steps += usize::from(direction == Direction::Gradient);
        self.last = (direction, t);
        if !self.options.criterion.needs_gradient() {
            self.end_if_solved()?;
        }
        if self.evaluate_jacobian() {
            self.fault = None;
            self.work.reference.accept(self.work.current.merit);
            return Continue(true);
        }
        self.stats.iterations = before.0.iterations;
        self.stats.gradient_steps = before.0.gradient_steps;
        self.last = before.1;
        // A search that comes to this point again must not take it.
        self.work.current.merit = f64::NAN;
        self.exchange(candidate);
        if self.work.is_thrifty {
            // The certificate may have taken the place of F.
            self.evaluate_current();
        }
        Continue(false)
    }

    fn exchange(&mut self, candidate: Candidate) {
        let work = &mut *self.work;
        let point = match candidate {
            Candidate::Full => &mut work.full,
            Candidate::Trial => &mut work.trial,
        };
        std::mem::swap(&mut work.current, point);
    }

    /// Notes the first non-finite `F` of a candidate, or of the iterate.
    fn note_fault_of_residual(&mut self, candidate: Option<Candidate>) {
        let work = &mut *self.work;
        let point = match candidate {
            None => &work.current,
            Some(Candidate::Full) => &work.full,
            Some(Candidate::Trial) => &work.trial,
        };
        if let Some(fault) = Fault::of_residual(&point.f, &point.phi) {
            self.fault = Some(fault);
            work.fault_point.clone_from(&point.z);
        }
    }

    /// Why the merit does not fall any further: for lack of a direction, or `otherwise`.
    fn status_without_progress(&mut self, otherwise: Status) -> Status {
        let gradient = self.relative_gradient();
        if self.system_is_singular && gradient <= ZERO_GRADIENT {
            Status::SingularSystem
        } else if gradient.min(self.work.relative_slope()) <= SMALL_GRADIENT {
            Status::StationaryPoint
        } else {
            otherwise
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
