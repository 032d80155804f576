//! The default method: a Newton method for most problems, and a cascade behind it for the rest.
//!
//! ```text
//! y = z / C, G = R F(C y): equilibrated by powers of two;  every trial point lies in the box
//! crash        Newton on the natural map, the box as active set
//! josephy      the linearised problem by pivoting, for small problems
//! leap         where the crash's full step led to other scales, not taken: take it, measure there
//! semismooth   Newton on Φ, non-monotone search, Levenberg–Marquardt where it fails;  tail
//! cascade      josephy · sized · smoothing · penalised · boxes · rescaled · proximal · starts · backtracking
//! ```
//!
//! | stage | what it is | source |
//! | --- | --- | --- |
//! | equilibrate | integer least squares on the exponents of `J` | [CR72](crate#references) |
//! | crash | projected Newton | [DF97](crate#references), [Ber82](crate#references) |
//! | leap | the crash again from where its full step leads, in the scales measured there | |
//! | semismooth | `H d = −Φ`, box function nested, largest of the last merits as reference | [DFK96](crate#references), [Bil95](crate#references), [GLL86](crate#references) |
//! | Levenberg–Marquardt | `min ‖H d + Φ‖² + μ ‖d‖²` where Newton's step is short or `H` singular | [KP04](crate#references) |
//! | tail | min-map steps: the last digits, bounds met exactly | [FP03](crate#references) |
//! | josephy | the linearised problem, solved by [pivoting](super::pivot) | [Jos79](crate#references), [FKM99](crate#references) |
//! | sized | crash and semismooth in scales by typical sizes, those of the start | [DS96](crate#references) section 7.1 |
//! | smoothing | `ab = μ → 0`, iterates inside the box | [Kan96](crate#references) |
//! | penalised | `λ φ + (1 − λ) a⁺ b⁺` | [CCK00](crate#references) |
//! | proximal | `F + μ (z − z_k)`, out of local minima of the merit | [Bil95](crate#references) |
//! | backtracking | Newton alone, with steps as short as it takes | [DFK96](crate#references) |
//!
//! No stage depends on units: iterates are the same, bit for bit, when equations or variables are
//! multiplied by powers of two, as long as nothing over- or underflows, no scale is beyond `2^±100`, no
//! absolute tolerance is set, and the start has sizes. It has none where variables that start at 0, with no
//! other finite bound than 0, are in equations that are 0 there too, or in none; and where it has to be
//! moved inside its box. A stage ends the solve only at a point the [`Certificate`](crate::Certificate)
//! accepts. Whatever happens, the best point seen is the answer, or the one where Newton alone got stuck, if it
//! shows more.
//!
//! Cost of a step: one `J`, one factorisation, one `F` for each trial point. Limits are counts
//! ([`Robust`]), so every run takes the same path.

mod ahead;
mod backtracking;
mod boxes;
mod crash;
mod diagnose;
mod direction;
mod equilibrate;
mod far;
mod josephy;
mod judge;
mod leap;
mod levenberg_marquardt;
mod map;
mod measured;
mod memory;
mod options;
mod proximal;
mod rescaled;
mod semismooth;
mod sized;
mod smoothing;
mod starts;
mod tail;
mod view;

pub(super) use measured::{Sample, Sizes};
pub(super) use memory::Memory;
pub use options::Robust;
pub(super) use view::View;

use super::monitor::Direction;
use super::run::{Fault, Flow, Run};
use super::stage::{Stage, StageEnd, StageRecord};
use super::status::Status;
use map::Map;
use std::convert::Infallible;
use std::ops::ControlFlow::{Break, Continue};

/// Runs until something ends the solve.
pub(super) fn solve(run: &mut Run<'_>) -> Flow<Infallible> {
    let n = run.problem.pattern().n();
    let mut memory = run.work.robust.take().unwrap_or_default();
    memory.resize(n, run.problem.pattern().nnz(), run.options.robust.memory);
    let mut search = Search { run, memory };
    let Break(status) = search.cascade();
    let status = search.conclude(status);
    let Search { run, memory } = search;
    run.work.robust = Some(memory);
    Break(status)
}

/// A solve in progress, in the scaled problem.
struct Search<'r, 'a> {
    run: &'r mut Run<'a>,
    memory: Box<Memory>,
}

impl Search<'_, '_> {
    /// All stages, in order, until one ends the solve.
    fn cascade(&mut self) -> Flow<Infallible> {
        let budget = self.run.options.robust;
        self.start()?;
        let crash = self.stage(Stage::Crash, budget.crash, Self::crash)?;
        self.stage(Stage::Josephy, budget.josephy_first, Self::josephy_first)?;
        if crash == Some(StageEnd::Drifted) {
            self.stage(Stage::Leap, budget.rescale, Self::leap)?;
        }
        self.newton()?;
        self.keep_stuck();

        let (start, stuck) = (Memory::go_to_start, Memory::go_to_stuck);
        self.stage_from(start, Stage::Josephy, budget.josephy, Self::josephy)?;
        self.stage_from(start, Stage::Sized, budget.sized, Self::sized)?;
        self.stage_from(start, Stage::Smoothing, budget.smoothing, Self::smoothing_and_newton)?;
        self.stage_from(start, Stage::Penalised, budget.penalised, Self::penalised)?;
        self.stage(Stage::Boxes, budget.boxes, Self::boxes)?;
        self.stage(Stage::Rescaled, budget.rescale, Self::rescaled)?;
        self.stage_from(start, Stage::Proximal, budget.proximal, Self::proximal)?;
        self.stage_from(stuck, Stage::Proximal, budget.proximal, Self::proximal)?;
        self.stage(Stage::Starts, budget.starts, Self::starts)?;
        // The last stage leaves room for the diagnosis.
        let left = budget.jacobians.saturating_sub(self.run.stats.jacobian_evaluations) / 2;
        let steps = budget.backtracking.min(left);
        self.stage_from(start, Stage::Backtracking, steps, Self::backtracking)?;
        Break(self.diagnose())
    }

    /// Semismooth Newton; where the scales of `J` drift away, they are measured again.
    fn newton(&mut self) -> Flow {
        let budget = self.run.options.robust;
        for _ in 0..=budget.rescale {
            let end = self.stage(Stage::Semismooth, budget.semismooth, Self::semismooth)?;
            if end != Some(StageEnd::Drifted) {
                break;
            }
            self.measure_scales();
        }
        Continue(())
    }

    /// Runs a stage with its budget, unless that is 0, and records what became of it.
    fn stage(
        &mut self,
        stage: Stage,
        budget: usize,
        run: fn(&mut Self, usize) -> Flow<StageEnd>,
    ) -> Flow<Option<StageEnd>> {
        if budget == 0 {
            return Continue(None);
        }
        self.run.stage = stage;
        self.memory.leave = None;
        let before = self.run.stats;
        let flow = run(self, budget);
        self.memory.proximal = None;
        let stats = self.run.stats;
        let end = match flow {
            Break(_) => StageEnd::Ended,
            Continue(end) => end,
        };
        self.memory.records.push(StageRecord {
            stage,
            iterations: stats.iterations - before.iterations,
            residual_evaluations: stats.residual_evaluations - before.residual_evaluations,
            jacobian_evaluations: stats.jacobian_evaluations - before.jacobian_evaluations,
            end,
        });
        flow.map_continue(Some)
    }

    /// A stage that begins at another point than the iterate.
    fn stage_from(
        &mut self,
        go: fn(&mut Memory),
        stage: Stage,
        budget: usize,
        run: fn(&mut Self, usize) -> Flow<StageEnd>,
    ) -> Flow {
        if budget > 0 {
            go(&mut self.memory);
            if self.restart()? {
                self.stage(stage, budget, run)?;
            }
        }
        Continue(())
    }

    /// `F` and `J` at the start, inside the box where they are not finite, and the scales.
    fn start(&mut self) -> Flow {
        loop {
            let Search { run, memory } = self;
            memory.view.unscaled(run.problem.shape().bounds());
            memory.start.copy_from_slice(&run.work.current.z);
            memory.here.z.copy_from_slice(&memory.start);
            if self.evaluate_here() {
                if self.jacobian() {
                    break;
                }
                self.judge_on_bounds()?;
            }
            if self.run.start_was_moved || !self.run.move_inside() {
                return Break(Status::DomainError);
            }
        }
        self.run.fault = None;
        self.measure_scales();
        let memory = &mut *self.memory;
        memory.unit.copy_from_slice(memory.view.units());
        self.judge_zeros()?;
        self.judge()?;
        self.begin()?;
        Continue(())
    }

    /// Keeps the iterate as the point where Newton got stuck.
    pub(super) fn keep_stuck(&mut self) {
        let Search { run, memory } = self;
        let bounds = run.problem.shape().bounds();
        memory.view.unscale(&memory.here.z, bounds, &mut memory.stuck);
    }

    /// Goes back to the scales of the start.
    fn scale_as_at_start(&mut self) -> Flow {
        self.memory.go_to_start();
        if self.restart()? {
            self.measure_scales();
        }
        Continue(())
    }

    /// Measures the scales at the iterate, where `F` and `J` are known, and goes over to them.
    fn measure_scales(&mut self) {
        self.measure_scales_by(Sizes::AsOneEntry);
    }

    /// The same, with more or less weight on the sizes of known variables.
    fn measure_scales_by(&mut self, sizes: Sizes) {
        let Search { run, memory } = self;
        if run.options.robust.equilibrate {
            let (shape, pattern) = (run.problem.shape(), run.problem.pattern());
            // Back to the units of the model.
            memory.view.unscale(&memory.here.z, shape.bounds(), &mut memory.model_z);
            memory.view.unscale_residual(&memory.here.f, &mut memory.slope);
            memory.view.unscale_jacobian(pattern, &mut memory.jac);
            let sample = Sample {
                z: &memory.model_z,
                f: &memory.slope,
                jac: &memory.jac,
                start: &memory.start,
                sizes,
            };
            memory.view.measure(shape, pattern, sample);
            memory.view.scale(&memory.model_z, &mut memory.here.z);
            memory.here.f.copy_from_slice(&memory.slope);
            memory.view.scale_residual(&mut memory.here.f);
            memory.view.scale_jacobian(pattern, &mut memory.jac);
        }
        let Search { run, memory } = self;
        memory.level_measured = memory.level(run.problem.pattern());
        memory.view.scale(&memory.start, &mut memory.start_y);
        memory.view.weigh(memory.map, &mut memory.here);
    }

    /// Goes on from `here.z`: `F` and `J` there; false if they are not finite.
    fn restart(&mut self) -> Flow<bool> {
        let memory = &mut *self.memory;
        memory.leave = None;
        memory.map = Map::FischerBurmeister;
        memory.view.project(&mut memory.here.z);
        self.run.last = (Direction::Start, 0.0);
        if !self.evaluate_here() {
            return Continue(false);
        }
        if !self.jacobian() {
            return Continue(false);
        }
        self.judge()?;
        Continue(true)
    }

    /// Evaluates the iterate; false where `F` is not finite.
    fn evaluate_here(&mut self) -> bool {
        let Search { run, memory } = self;
        run.stats.residual_evaluations += 1;
        memory.view.residual(run.problem, &mut memory.here);
        memory.view.weigh(memory.map, &mut memory.here);
        if memory.here.merit.is_nan() {
            note_fault(run, &memory.here.f, &memory.here.phi, memory.view.argument());
            return false;
        }
        true
    }

    /// Evaluates `P(y + t d)` as trial point and returns its merit, NaN where `F` is not finite.
    fn evaluate(&mut self, t: f64) -> f64 {
        let memory = &mut *self.memory;
        for ((to, y), d) in memory.trial.z.iter_mut().zip(&memory.here.z).zip(&memory.direction) {
            *to = y + t * d;
        }
        memory.view.project(&mut memory.trial.z);
        self.evaluate_trial()
    }

    /// Evaluates the trial point that is set.
    fn evaluate_trial(&mut self) -> f64 {
        let Search { run, memory } = self;
        run.stats.residual_evaluations += 1;
        memory.view.residual(run.problem, &mut memory.trial);
        if let Some(mu) = memory.proximal {
            for i in 0..memory.center.len() {
                memory.trial.f[i] += mu * (memory.trial.z[i] - memory.center[i]);
            }
        }
        memory.view.weigh(memory.map, &mut memory.trial);
        if memory.trial.merit.is_nan() {
            note_fault(run, &memory.trial.f, &memory.trial.phi, memory.view.argument());
        }
        memory.trial.merit
    }

    /// `J` at the iterate; the old one stays, and the fault is noted, if it is not finite.
    fn jacobian(&mut self) -> bool {
        let Search { run, memory } = self;
        run.stats.jacobian_evaluations += 1;
        let jac = run.work.certifier.spare();
        memory.view.jacobian(run.problem, &memory.here.z, jac);
        if let Some(fault) = Fault::of_jacobian(run.problem.pattern(), jac) {
            run.fault = Some(fault);
            run.work.fault_point.copy_from_slice(memory.view.argument());
            return false;
        }
        std::mem::swap(&mut memory.jac, jac);
        true
    }

    /// Makes the trial point the iterate; ends the solve if it is a solution. False, with the old
    /// iterate back, if `J` is not finite there.
    fn accept(&mut self, direction: Direction, t: f64) -> Flow<bool> {
        self.swap();
        let before = (self.run.stats, self.run.last);
        self.run.stats.iterations += 1;
        self.run.stats.gradient_steps += usize::from(direction == Direction::Gradient);
        self.run.last = (direction, t);
        if self.memory.proximal.is_none() {
            self.judge()?;
        }
        if self.memory.leave.is_some() || self.jacobian() {
            self.run.fault = None;
            self.memory.reference.accept(self.memory.here.merit);
            return Continue(true);
        }
        self.run.stats.iterations = before.0.iterations;
        self.run.stats.gradient_steps = before.0.gradient_steps;
        self.run.last = before.1;
        self.swap();
        Continue(false)
    }

    fn swap(&mut self) {
        let memory = &mut *self.memory;
        std::mem::swap(&mut memory.here, &mut memory.trial);
    }

    /// Monitor and limits, before every step.
    fn begin(&mut self) -> Flow {
        self.report()?;
        if self.run.stats.jacobian_evaluations >= self.run.options.robust.jacobians {
            return Break(Status::IterationLimit);
        }
        self.run.check_limits()
    }

    /// Tells the monitor about the iterate, in the units of the model.
    fn report(&mut self) -> Flow {
        if self.run.monitor.is_none() {
            return Continue(());
        }
        let Search { run, memory } = self;
        let current = &mut run.work.current;
        memory.view.unscale(&memory.here.z, run.problem.shape().bounds(), &mut current.z);
        memory.slope.copy_from_slice(&memory.here.f);
        if let Some(mu) = memory.proximal {
            for i in 0..memory.center.len() {
                memory.slope[i] -= mu * (memory.here.z[i] - memory.center[i]);
            }
        }
        memory.view.unscale_residual(&memory.slope, &mut current.f);
        current.merit = memory.here.merit;
        run.report()
    }
}

/// Notes what is not finite at a point: `F`, or else the largest `Φ`, whose square overflows.
fn note_fault(run: &mut Run<'_>, f: &[f64], phi: &[f64], z: &[f64]) {
    if let Some(fault) = Fault::of_residual(f, phi) {
        run.fault = Some(fault);
        run.work.fault_point.copy_from_slice(z);
    }
}
