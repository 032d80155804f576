//! [`MoreauJean`]: bodies with contacts, step by step.

use super::active_sets::ActiveSets;
use super::error::{DynamicsError, positive, share};
use super::inertia::Column;
use super::mechanics::Mechanics;
use super::motion::{Active, Motion};
use super::step_problem::{Solved, StepProblem};
use super::stepper::{StepReport, StepSize, TimeStepper};
use crate::scalar::{Counted, Scalar, Tally};
use crate::solver::Options;

/// A contact that does not move, or was pressed in the last step, takes part up to this gap \[m\]:
/// rounding neither delays a rest nor ends it.
const RESTING: f64 = 1e-9;

/// Step size and parameters of [`MoreauJean`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// Step size `h` \[s\].
    pub h: f64,
    /// `θ`; default ½, which conserves the energy of a flight.
    pub theta: f64,
    /// `γ`: a contact takes part where `gap + γ h u <= 0`, or `1e-9` m where it does not move or was
    /// pressed in the last step; default ½.
    pub gamma: f64,
}

impl Scheme {
    /// The defaults with this step size.
    pub fn new(h: f64) -> Self {
        Scheme { h, theta: 0.5, gamma: 0.5 }
    }
}

/// The Moreau–Jean(θ, γ) scheme for bodies with contacts ([Mor88](crate#references),
/// [Jean99](crate#references)):
///
/// ```text
/// M (v⁺ − v) = h [θ f⁺ + (1−θ) f] + Hᵀ r,    q⁺ = q + h (θ v⁺ + (1−θ) v)
/// 0 <= u⁺ + e u   ⟂   r_n >= 0               contacts with gap + γ h u <= 0
/// r_t = clamp(r_t − ρ u_t⁺, −μ r_n, μ r_n)   their friction
/// u⁺ = 0                                     joints, r free
/// ```
///
/// With `M̂ = M + hθ C + (hθ)² K` the free velocity is `v° = v + M̂⁻¹ h (f(q, v) − hθ K v)`, and the
/// problem of a step is `u⁺ = H v° + H M̂⁻¹ Hᵀ r`: one unknown for each contact that takes part, one
/// more with friction, one for each joint. Where nothing takes part there is no problem and
/// `v⁺ = v°`. Rows of joints are taken at `q + h v`, where they end: lengths of rods drift
/// by `O(h²)`. Rows of contacts are taken at `q`.
///
/// The order of summation is part of the scheme, so that an effect which is not there does not change a
/// bit: forces are summed from 0 as constant forces (gravity among them), springs, dampers and drag,
/// each in the order in which they were added; rows stand as joints, then contacts with their friction.
///
/// ```
/// use mcp_core::dynamics::{
///     Axis, Body, Contact, Mechanics, MoreauJean, Obstacle, Scheme, TimeStepper, step_options,
/// };
/// let mut system = Mechanics::new();
/// let ball = system.add_body(&Body::new("ball", 1.0).moving(Axis::Y, 1.0, 0.0))?;
/// system.add_gravity(9.81)?;
/// let floor = Obstacle::Plane { normal: [0.0, 1.0], offset: 0.0 };
/// system.add_contact(Contact::new("floor", ball, floor).restitution(0.9))?;
/// let mut stepper = MoreauJean::new(system, Scheme::new(0.005), &step_options())?;
/// assert_eq!(stepper.step()?.unknowns, 0); // in flight
/// let impact = loop {
///     let report = stepper.step()?;
///     if report.unknowns > 0 {
///         break report;
///     }
/// };
/// assert_eq!((impact.unknowns, impact.active), (1, 1));
/// # Ok::<(), mcp_core::dynamics::DynamicsError>(())
/// ```
pub struct MoreauJean {
    pub(super) motion: Motion,
    options: Options,
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
    /// State before the last step.
    pub(super) before: (Vec<f64>, Vec<f64>),
    free: Vec<f64>,
    column: Column<f64>,
    pub(super) active: Active<f64>,
    sets: ActiveSets,
    /// Last multiplier of every joint and, normal and tangential, of every contact.
    pub(super) multipliers: Vec<f64>,
    steps: u64,
}

impl MoreauJean {
    /// The system with this scheme, its steps solved with these options
    /// ([`step_options`](super::step_options)).
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for the scheme, [`DynamicsError::Linear`] if `M̂` is not positive
    /// definite in the range of numbers.
    pub fn new(
        system: Mechanics,
        scheme: Scheme,
        options: &Options,
    ) -> Result<Self, DynamicsError> {
        positive("step", "the scheme", scheme.h)?;
        share("theta", "the scheme", scheme.theta)?;
        share("gamma", "the scheme", scheme.gamma)?;
        let (q, v) = system.start.clone();
        let motion = Motion::new(system, scheme)?;
        let (n, multipliers) = (q.len(), motion.multipliers());
        Ok(MoreauJean {
            options: options.clone(),
            before: (q.clone(), v.clone()),
            free: vec![0.0; n],
            column: Column::new(0.0, n),
            active: Active::with_capacity(motion.system.contacts.len(), multipliers),
            sets: ActiveSets::default(),
            multipliers: vec![0.0; multipliers],
            steps: 0,
            q,
            v,
            motion,
        })
    }

    /// Positions, in the order in which bodies and their coordinates were added.
    pub fn positions(&self) -> &[f64] {
        &self.q
    }

    /// Velocities, in the same order.
    pub fn velocities(&self) -> &[f64] {
        &self.v
    }

    /// Gaps, the contacts that take part, and the rows of `H`.
    fn find_contacts(&mut self) {
        let MoreauJean { motion, q, v, active, multipliers, .. } = self;
        let takes_part = |c: usize, approach: f64, rate: f64| {
            let rests = rate == 0.0 || multipliers[motion.slot(c)] > 0.0;
            approach <= if rests { RESTING } else { 0.0 }
        };
        motion.constrain(q, v, |x| x, takes_part, active);
    }

    /// Solves for the reactions and adds them to the free velocity.
    fn react(&mut self, step: u64, time: f64) -> Result<Solved, DynamicsError> {
        let MoreauJean { motion, options, free, column, active, sets, multipliers, .. } = self;
        let problem = sets.select(&active.contacts, || {
            StepProblem::new(&motion.unknowns(active), &motion.columns(active), options)
        })?;
        motion.condense(active, free, column, problem.data_mut());
        for (start, &slot) in problem.lambda.iter_mut().zip(&active.slots) {
            *start = multipliers[slot];
        }
        let solved = problem.solve(step, time)?;
        motion.inertia.react(&active.rows, &problem.lambda, column, free);
        multipliers.fill(0.0);
        for (&slot, &lambda) in active.slots.iter().zip(&problem.lambda) {
            multipliers[slot] = lambda;
        }
        Ok(solved)
    }

    /// The problem of the last step.
    fn problem(&self) -> Option<&StepProblem> {
        self.sets.current().filter(|_| !self.active.rows.is_empty())
    }

    /// Operations of the last step outside its problem: it is done again in the counting arithmetic, all
    /// data being numbers that count.
    fn operations(&self) -> u64 {
        let tally = Tally::new();
        let number = |x: f64| tally.variable(x);
        let numbers = |x: &[f64]| x.iter().map(|&x| number(x)).collect::<Vec<Counted<'_>>>();
        let (mut q, v) = (numbers(&self.before.0), numbers(&self.before.1));
        let (mut column, mut free) = (Column::new(number(0.0), q.len()), v.clone());
        self.motion.free_velocity(&q, &v, &mut column, &mut free);
        let mut active = Active::with_capacity(0, 0);
        let takes_part = |c: usize, _, _| self.active.contacts.contains(&c);
        self.motion.constrain(&q, &v, number, takes_part, &mut active);
        if let Some(problem) = self.problem() {
            let mut data = problem.data().zeros_like();
            self.motion.condense(&active, &free, &mut column, &mut data);
            let lambda = numbers(&problem.lambda);
            self.motion.inertia.react(&active.rows, &lambda, &mut column, &mut free);
        }
        self.motion.advance(&mut q, &v, &free);
        tally.counts().total()
    }
}

impl TimeStepper for MoreauJean {
    fn step(&mut self) -> Result<StepReport, DynamicsError> {
        let (step, time) = (self.steps + 1, (self.steps + 1) as f64 * self.motion.scheme.h);
        self.motion.free_velocity(&self.q, &self.v, &mut self.column, &mut self.free);
        if let Some(i) = self.free.iter().position(|v| !v.is_finite()) {
            let name = format!("the velocity of {}", self.motion.system.names[i]);
            return Err(DynamicsError::NotFinite { name, time });
        }
        self.find_contacts();
        let solved = if self.active.rows.is_empty() {
            self.multipliers.fill(0.0);
            Solved::default()
        } else {
            self.react(step, time)?
        };
        self.before.0.copy_from_slice(&self.q);
        self.motion.advance(&mut self.q, &self.v, &self.free);
        std::mem::swap(&mut self.before.1, &mut self.v);
        std::mem::swap(&mut self.v, &mut self.free);
        self.steps = step;
        Ok(StepReport {
            step,
            time,
            unknowns: self.active.rows.len(),
            active: self.active.contacts.len(),
            iterations: solved.iterations,
            residual: solved.residual,
        })
    }

    fn step_size(&self) -> f64 {
        self.motion.scheme.h
    }

    /// Each coordinate with its velocity, then the impulses of all joints and contacts.
    fn state_names(&self) -> Vec<String> {
        let system = &self.motion.system;
        let motion = system.names.iter().flat_map(|name| [name.clone(), format!("{name}'")]);
        let joints = system.joints.iter().map(|joint| format!("r[{}]", joint.name));
        let contacts = system.contacts.iter().flat_map(|contact| {
            let tangential = contact.friction.map(|_| format!("rt[{}]", contact.name));
            [Some(format!("r[{}]", contact.name)), tangential].into_iter().flatten()
        });
        motion.chain(joints).chain(contacts).collect()
    }

    fn write_state(&self, state: &mut Vec<f64>) {
        let system = &self.motion.system;
        state.clear();
        state.extend(self.q.iter().zip(&self.v).flat_map(|(&q, &v)| [q, v]));
        state.extend_from_slice(&self.multipliers[..system.joints.len()]);
        for (c, contact) in system.contacts.iter().enumerate() {
            let slot = self.motion.slot(c);
            let rows = 1 + usize::from(contact.friction.is_some());
            state.extend_from_slice(&self.multipliers[slot..slot + rows]);
        }
    }

    fn energy(&self) -> Option<f64> {
        Some(self.motion.system.energy(&self.q, &self.v))
    }

    fn size(&self) -> Result<StepSize, DynamicsError> {
        StepSize::of(self.operations(), self.problem())
    }
}
