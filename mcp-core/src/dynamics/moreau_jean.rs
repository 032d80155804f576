//! [`MoreauJean`]: bodies with contacts, step by step.

use super::active_sets::ActiveSets;
use super::constraint::{Gap, Row};
use super::error::{DynamicsError, positive, share};
use super::inertia::Inertia;
use super::mechanics::Mechanics;
use super::step_problem::{Law, Solved, StepProblem, Unknown};
use super::stepper::{StepReport, StepSize, TimeStepper};
use crate::scalar::{Counted, OperationCounts, Scalar, Tally};
use crate::solver::Options;

/// A contact that was pressed in the last step takes part up to this gap \[m\]: rounding does not end
/// a rest.
const RESTING: f64 = 1e-9;

/// Step size and parameters of [`MoreauJean`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// Step size `h` \[s\].
    pub h: f64,
    /// `θ`; default ½, which conserves the energy of a flight.
    pub theta: f64,
    /// `γ`: a contact takes part where `gap + γ h u <= 0`, or `1e-9` m after a step in which it was
    /// pressed; default ½.
    pub gamma: f64,
}

impl Scheme {
    /// The defaults with this step size.
    pub fn new(h: f64) -> Self {
        Scheme { h, theta: 0.5, gamma: 0.5 }
    }
}

/// A contact that took part in the last step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reaction {
    /// Its name.
    pub contact: String,
    /// Gap at the start of the step \[m\].
    pub gap: f64,
    /// Rate of the gap before and after.
    pub rate: (f64, f64),
    /// Normal impulse \[N s\].
    pub normal: f64,
    /// Tangential impulse; 0 without friction.
    pub tangential: f64,
    /// Slip after the step \[m/s\]; 0 without friction.
    pub slip: f64,
}

/// Where the energy of the last step went; with `θ = ½`, `change = reactions + damping`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EnergyBalance {
    /// `E⁺ − E`.
    pub change: f64,
    /// Work of contacts and joints, `½ (v⁺ + v) · Hᵀ r`.
    pub reactions: f64,
    /// Work of dampers and drag, `−h v̄ᵀ C v̄` at the mean velocity.
    pub damping: f64,
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
    system: Mechanics,
    scheme: Scheme,
    forced: Vec<usize>,
    inertia: Inertia,
    q: Vec<f64>,
    v: Vec<f64>,
    /// State before the last step.
    before: (Vec<f64>, Vec<f64>),
    free: Vec<f64>,
    force: Vec<f64>,
    /// Gap and normal row of every contact, at the start of the step.
    gaps: Vec<(Gap, Row)>,
    /// Contacts that take part.
    active: Vec<usize>,
    /// `H`: joints, then for each active contact its normal and, with friction, its tangent.
    rows: Vec<Row>,
    /// Where the multiplier of each row stands.
    slots: Vec<usize>,
    sets: ActiveSets,
    /// Last multiplier of every joint and, normal and tangential, of every contact.
    multipliers: Vec<f64>,
    steps: u64,
}

impl MoreauJean {
    /// The system with this scheme, its steps solved with these options
    /// ([`step_options`](super::step_options)).
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for the scheme, [`DynamicsError::Linear`] if `M̂` is singular.
    pub fn new(
        system: Mechanics,
        scheme: Scheme,
        options: &Options,
    ) -> Result<Self, DynamicsError> {
        positive(|| "the step h".to_owned(), scheme.h)?;
        share(|| "theta".to_owned(), scheme.theta)?;
        share(|| "gamma".to_owned(), scheme.gamma)?;
        let (q, v) = system.start.clone();
        let (n, multipliers) = (q.len(), system.joints.len() + 2 * system.contacts.len());
        Ok(MoreauJean {
            forced: system.forced(),
            inertia: Inertia::new(&system, scheme.h * scheme.theta)?,
            before: (q.clone(), v.clone()),
            free: vec![0.0; n],
            force: vec![0.0; n],
            gaps: Vec::with_capacity(system.contacts.len()),
            active: Vec::with_capacity(system.contacts.len()),
            rows: Vec::with_capacity(multipliers),
            slots: Vec::with_capacity(multipliers),
            sets: ActiveSets::new(options.clone()),
            multipliers: vec![0.0; multipliers],
            steps: 0,
            q,
            v,
            scheme,
            system,
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

    /// Gaps of all contacts, at the state there is now.
    pub fn gaps(&self) -> Vec<f64> {
        let gap = |contact| self.system.gap(contact, &self.q).gap;
        self.system.contacts.iter().map(gap).collect()
    }

    /// The contacts of the last step.
    pub fn reactions(&self) -> Vec<Reaction> {
        let mut next = self.system.joints.len();
        let reaction = |&c: &usize| {
            let contact = &self.system.contacts[c];
            let [normal, tangential] = [0, 1].map(|k| self.multipliers[self.slot(c) + k]);
            let row = self.rows[next];
            next += 1;
            let slip = contact.friction.map_or(0.0, |_| {
                next += 1;
                self.rows[next - 1].times(&self.v)
            });
            let rate = (row.times(&self.before.1), row.times(&self.v));
            let gap = self.gaps[c].0.gap;
            Reaction { contact: contact.name.clone(), gap, rate, normal, tangential, slip }
        };
        self.active.iter().map(reaction).collect()
    }

    /// Where the energy of the last step went.
    pub fn balance(&self) -> EnergyBalance {
        let (q, v) = &self.before;
        let mean = |i: usize| 0.5 * (v[i] + self.v[i]);
        let reactions = self.slots.iter().zip(&self.rows).map(|(&slot, row)| {
            let rate: f64 = row.entries().iter().map(|&(i, h)| h * mean(i)).sum();
            rate * self.multipliers[slot]
        });
        EnergyBalance {
            change: self.system.energy(&self.q, &self.v) - self.system.energy(q, v),
            reactions: reactions.sum(),
            damping: self.scheme.h * self.system.damping_power(mean),
        }
    }

    /// Where the multipliers of a contact stand.
    fn slot(&self, contact: usize) -> usize {
        self.system.joints.len() + 2 * contact
    }

    /// Impulse of the forces, `h (f(q, v) − hθ K v)`, in any arithmetic.
    fn impulse<D: Scalar>(
        &self,
        q: impl Fn(usize) -> D,
        v: impl Fn(usize) -> D,
        impulse: &mut [D],
    ) {
        let Scheme { h, theta, .. } = self.scheme;
        impulse.fill(D::constant(0.0));
        self.system.forces(h * theta, q, v, impulse);
        for &i in &self.forced {
            impulse[i] = D::constant(h) * impulse[i];
        }
    }

    /// `v°`.
    fn fly(&mut self) {
        let mut force = std::mem::take(&mut self.force);
        self.impulse(|i| self.q[i], |i| self.v[i], &mut force);
        self.free.copy_from_slice(&self.v);
        if !self.forced.is_empty() {
            self.inertia.accelerate(&self.forced, &mut force, &mut self.free);
        }
        self.force = force;
    }

    /// Gaps, the contacts that take part, and the rows of `H`.
    fn find_contacts(&mut self) {
        let Scheme { h, gamma, .. } = self.scheme;
        let (system, q, v) = (&self.system, &self.q, &self.v);
        self.gaps.clear();
        self.active.clear();
        self.rows.clear();
        self.slots.clear();
        let predicted = |i: usize| q[i] + h * v[i];
        self.rows.extend(system.joints.iter().map(|joint| system.joint_row(joint, predicted)));
        self.slots.extend(0..system.joints.len());
        for (c, contact) in system.contacts.iter().enumerate() {
            let at = system.gap(contact, q);
            let row = system.normal_row(contact, at);
            let pressed = self.multipliers[system.joints.len() + 2 * c] > 0.0;
            let margin = if pressed { RESTING } else { 0.0 };
            if at.gap + gamma * h * row.times(v) <= margin {
                self.active.push(c);
                self.rows.push(row);
                self.slots.push(system.joints.len() + 2 * c);
                if contact.friction.is_some() {
                    self.rows.push(system.tangential_row(contact, at));
                    self.slots.push(system.joints.len() + 2 * c + 1);
                }
            }
            self.gaps.push((at, row));
        }
    }

    /// The unknowns of the rows of `H`.
    fn unknowns(&self) -> Vec<Unknown> {
        let free = |name: String| Unknown {
            name,
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            law: Law::Bounds,
        };
        let joints = self.system.joints.iter().map(|joint| free(joint.name.clone()));
        let mut unknowns: Vec<Unknown> = joints.collect();
        for &c in &self.active {
            let contact = &self.system.contacts[c];
            let normal = unknowns.len();
            unknowns.push(Unknown { lower: 0.0, ..free(contact.name.clone()) });
            if let Some(mu) = contact.friction {
                let law = Law::Coulomb { normal, mu };
                unknowns.push(Unknown { law, ..free(format!("{} friction", contact.name)) });
            }
        }
        unknowns
    }

    /// Solves for the reactions and adds them to the free velocity.
    fn react(&mut self, step: u64, time: f64) -> Result<Solved, DynamicsError> {
        if !self.sets.select(&self.active) {
            let reads = |a: &Row| {
                (0..self.rows.len()).filter(|&j| self.inertia.couples(a, &self.rows[j])).collect()
            };
            let columns: Vec<Vec<usize>> = self.rows.iter().map(reads).collect();
            self.sets.insert(&self.active, &self.unknowns(), &columns)?;
        }
        let Some(mut problem) = self.sets.take() else { return Ok(Solved::default()) };
        let model = problem.model_mut();
        for (i, row) in self.rows.iter().enumerate() {
            model.q[i] = row.times(&self.free);
            self.inertia.delassus(&self.rows, i, model.m.row_mut(i));
        }
        let mut i = self.system.joints.len();
        for &c in &self.active {
            let contact = &self.system.contacts[c];
            // u⁺ + e u
            if contact.restitution != 0.0 {
                model.q[i] += contact.restitution * self.rows[i].times(&self.v);
            }
            i += 1 + usize::from(contact.friction.is_some());
        }
        problem.scale_friction();
        for (start, &slot) in problem.lambda.iter_mut().zip(&self.slots) {
            *start = self.multipliers[slot];
        }
        let result = problem.solve(step, time);
        if result.is_ok() {
            self.inertia.react(&self.rows, &problem.lambda, &mut self.free);
            self.multipliers.fill(0.0);
            for (&slot, &lambda) in self.slots.iter().zip(&problem.lambda) {
                self.multipliers[slot] = lambda;
            }
        }
        self.sets.put_back(problem);
        result
    }

    /// Operations of the free velocity.
    fn free_operations(&self) -> OperationCounts {
        let tally = Tally::new();
        let variables = |x: &[f64]| x.iter().map(|&x| tally.variable(x)).collect::<Vec<_>>();
        let (q, v) = (variables(&self.q), variables(&self.v));
        let mut impulse: Vec<Counted<'_>> = vec![Counted::constant(0.0); q.len()];
        self.impulse(|i| q[i], |i| v[i], &mut impulse);
        for &i in &self.forced {
            // v + M̂⁻¹ · impulse, where M̂ is diagonal
            let _ = v[i] + Counted::constant(1.0) * impulse[i];
        }
        tally.counts()
    }
}

impl TimeStepper for MoreauJean {
    fn step(&mut self) -> Result<StepReport, DynamicsError> {
        let Scheme { h, theta, .. } = self.scheme;
        let (step, time) = (self.steps + 1, (self.steps + 1) as f64 * h);
        self.fly();
        if let Some(i) = self.free.iter().position(|v| !v.is_finite()) {
            let name = format!("the velocity of {}", self.system.names[i]);
            return Err(DynamicsError::NotFinite { name, time });
        }
        self.find_contacts();
        let solved = if self.rows.is_empty() {
            self.multipliers.fill(0.0);
            Solved::default()
        } else {
            self.react(step, time)?
        };
        self.before.0.copy_from_slice(&self.q);
        for ((q, v), next) in self.q.iter_mut().zip(&self.v).zip(&self.free) {
            *q += h * (theta * next + (1.0 - theta) * v);
        }
        std::mem::swap(&mut self.before.1, &mut self.v);
        std::mem::swap(&mut self.v, &mut self.free);
        self.steps = step;
        Ok(StepReport {
            step,
            time,
            unknowns: self.rows.len(),
            active: self.active.len(),
            iterations: solved.iterations,
            residual: solved.residual,
        })
    }

    fn step_size(&self) -> f64 {
        self.scheme.h
    }

    /// Each coordinate with its velocity, then the impulses of all joints and contacts.
    fn state_names(&self) -> Vec<String> {
        let motion = self.system.names.iter().flat_map(|name| [name.clone(), format!("{name}'")]);
        let joints = self.system.joints.iter().map(|joint| format!("r[{}]", joint.name));
        let contacts = self.system.contacts.iter().flat_map(|contact| {
            let tangential = contact.friction.map(|_| format!("rt[{}]", contact.name));
            [Some(format!("r[{}]", contact.name)), tangential].into_iter().flatten()
        });
        motion.chain(joints).chain(contacts).collect()
    }

    fn write_state(&self, state: &mut Vec<f64>) {
        state.clear();
        state.extend(self.q.iter().zip(&self.v).flat_map(|(&q, &v)| [q, v]));
        state.extend_from_slice(&self.multipliers[..self.system.joints.len()]);
        for (c, contact) in self.system.contacts.iter().enumerate() {
            let rows = 1 + usize::from(contact.friction.is_some());
            state.extend_from_slice(&self.multipliers[self.slot(c)..self.slot(c) + rows]);
        }
    }

    fn energy(&self) -> Option<f64> {
        Some(self.system.energy(&self.q, &self.v))
    }

    fn size(&self) -> StepSize {
        let problem = if self.rows.is_empty() { None } else { self.sets.current() };
        let nonzeros = problem.map_or(0, StepProblem::nonzeros);
        let of_problem = problem.map(StepProblem::operations);
        let counts = std::iter::once(self.free_operations()).chain(of_problem);
        StepSize::new(self.rows.len(), nonzeros, counts)
    }
}
