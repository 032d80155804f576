//! [`Motion`]: what a Moreau–Jean step computes outside the solver, in any arithmetic. The code that
//! runs in `f64` is the code whose operations are counted.

use super::constraint::{Gap, Row};
use super::error::DynamicsError;
use super::inertia::{Column, Inertia};
use super::mechanics::Mechanics;
use super::moreau_jean::Scheme;
use super::step_problem::{Law, StepData, Unknown};
use crate::scalar::Scalar;

/// The rows of `H` that take part in a step.
pub(super) struct Active<D> {
    /// Gap and rate of every contact, at the start of the step.
    pub(super) gaps: Vec<(Gap<D>, D)>,
    /// Contacts that take part.
    pub(super) contacts: Vec<usize>,
    /// `H`: joints, then for each of these contacts its normal and, with friction, its tangent.
    pub(super) rows: Vec<Row<D>>,
    /// Which multiplier belongs to each row.
    pub(super) slots: Vec<usize>,
}

impl<D> Active<D> {
    pub(super) fn with_capacity(contacts: usize, rows: usize) -> Self {
        Active {
            gaps: Vec::with_capacity(contacts),
            contacts: Vec::with_capacity(contacts),
            rows: Vec::with_capacity(rows),
            slots: Vec::with_capacity(rows),
        }
    }
}

/// A system with its scheme and the matrix of its free motion.
pub(super) struct Motion {
    pub(super) system: Mechanics,
    pub(super) scheme: Scheme,
    pub(super) inertia: Inertia,
    /// Coordinates on which any force acts.
    forced: Vec<usize>,
}

impl Motion {
    pub(super) fn new(system: Mechanics, scheme: Scheme) -> Result<Self, DynamicsError> {
        let inertia = Inertia::new(&system, scheme.h * scheme.theta)?;
        Ok(Motion { forced: system.forced(), inertia, scheme, system })
    }

    /// Multipliers of the system: of every joint, then normal and tangential of every contact.
    pub(super) fn multipliers(&self) -> usize {
        self.slot(self.system.contacts.len())
    }

    /// The normal multiplier of a contact; its tangential one is the next.
    pub(super) fn slot(&self, contact: usize) -> usize {
        self.system.joints.len() + 2 * contact
    }

    /// `v° = v + M̂⁻¹ h (f(q, v) − hθ K v)`.
    pub(super) fn free_velocity<D: Scalar>(
        &self,
        q: &[D],
        v: &[D],
        column: &mut Column<D>,
        free: &mut [D],
    ) {
        let Scheme { h, theta, .. } = self.scheme;
        free.copy_from_slice(v);
        if self.forced.is_empty() {
            return;
        }
        let force = column.cleared();
        self.system.forces(h * theta, q, v, force);
        for &i in &self.forced {
            force[i] = force[i].scale(h);
        }
        self.inertia.accelerate(&self.forced, force, free);
    }

    /// Gaps, the contacts that take part, and the rows of `H`. `takes_part` decides by the number of a
    /// contact, its `gap + γ h u` and `u`; `number` makes a number of the data.
    pub(super) fn constrain<D: Scalar>(
        &self,
        q: &[D],
        v: &[D],
        number: impl Fn(f64) -> D + Copy,
        mut takes_part: impl FnMut(usize, f64, f64) -> bool,
        active: &mut Active<D>,
    ) {
        let (system, Scheme { h, gamma, .. }) = (&self.system, self.scheme);
        let Active { gaps, contacts, rows, slots } = active;
        gaps.clear();
        contacts.clear();
        rows.clear();
        slots.clear();
        let predicted = |i: usize| q[i] + v[i].scale(h);
        rows.extend(system.joints.iter().map(|joint| system.joint_row(joint, predicted, number)));
        slots.extend(0..system.joints.len());
        for (c, contact) in system.contacts.iter().enumerate() {
            let at = system.gap(contact, q, number);
            let row = system.normal_row(contact, at);
            let rate = row.times(v);
            if takes_part(c, (at.gap + rate.scale(gamma * h)).value(), rate.value()) {
                contacts.push(c);
                rows.push(row);
                slots.push(self.slot(c));
                if contact.friction.is_some() {
                    rows.push(system.tangential_row(contact, at, number));
                    slots.push(self.slot(c) + 1);
                }
            }
            gaps.push((at, rate));
        }
    }

    /// The numbers of the step problem: `q = H v° + e H v`, `M = H M̂⁻¹ Hᵀ`.
    pub(super) fn condense<D: Scalar>(
        &self,
        active: &Active<D>,
        free: &[D],
        column: &mut Column<D>,
        data: &mut StepData<D>,
    ) {
        for (i, row) in active.rows.iter().enumerate() {
            data.q[i] = row.times(free);
            self.inertia.delassus(&active.rows, i, column, data.m.row_mut(i));
        }
        let mut i = self.system.joints.len();
        for &c in &active.contacts {
            let contact = &self.system.contacts[c];
            if contact.restitution != 0.0 {
                data.q[i] = data.q[i] + active.gaps[c].1.scale(contact.restitution);
            }
            i += 1;
            if contact.friction.is_some() {
                let diagonal = data.m.row(i).find(|&(j, _)| j == i);
                data.rho[i] = diagonal.map_or(D::constant(0.0), |(_, m)| m.recip());
                i += 1;
            }
        }
    }

    /// `q⁺ = q + h (θ v⁺ + (1−θ) v)`.
    pub(super) fn advance<D: Scalar>(&self, q: &mut [D], v: &[D], next: &[D]) {
        let Scheme { h, theta, .. } = self.scheme;
        for ((q, v), next) in q.iter_mut().zip(v).zip(next) {
            *q = *q + (next.scale(theta) + v.scale(1.0 - theta)).scale(h);
        }
    }

    /// The unknowns of the rows of `H`.
    pub(super) fn unknowns<D>(&self, active: &Active<D>) -> Vec<Unknown> {
        let free = |name: String| Unknown {
            name,
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            law: Law::Bounds,
        };
        let joints = self.system.joints.iter().map(|joint| free(joint.name.clone()));
        let mut unknowns: Vec<Unknown> = joints.collect();
        for &c in &active.contacts {
            let contact = &self.system.contacts[c];
            let (name, friction) = contact.multipliers();
            let normal = unknowns.len();
            unknowns.push(Unknown { lower: 0.0, ..free(name) });
            if let (Some(mu), Some(name)) = (contact.friction, friction) {
                unknowns.push(Unknown { law: Law::Coulomb { normal, mu }, ..free(name) });
            }
        }
        unknowns
    }

    /// The unknowns that each row reads.
    pub(super) fn columns(&self, active: &Active<f64>) -> Vec<Vec<usize>> {
        let rows = &active.rows;
        let reads = |a| (0..rows.len()).filter(|&j| self.inertia.couples(a, &rows[j])).collect();
        rows.iter().map(reads).collect()
    }
}
