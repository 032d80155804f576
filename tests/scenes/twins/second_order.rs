//! A Moreau–Jean step by hand, around the formulas of a scene.

use super::problems::Solved;
use super::{Facts, Number, Twin, bits};
use mcp_core::{Scalar, Tally};

/// A row of `H`: coordinates and entries.
pub(super) type Row<'t> = Vec<(usize, Number<'t>)>;

/// Adds a force at position and velocity.
type Force<'t> = Box<dyn Fn(&[Number<'t>], &[Number<'t>], &mut [Number<'t>])>;
/// Gap and normal row at a position.
type Place<'t> = Box<dyn Fn(&[Number<'t>]) -> (Number<'t>, Row<'t>) + 't>;
/// The tangential row to a normal one.
type Tangent<'t> = Box<dyn Fn(&Row<'t>) -> Row<'t> + 't>;
/// `x ← M̂⁻¹ x`.
type Apply<'t> = Box<dyn Fn(&mut [Number<'t>])>;
/// The row of a rod at a position.
type Rod<'t> = Box<dyn Fn(&[Number<'t>]) -> Row<'t>>;
/// Solves a step problem from the last impulses.
type Solve = Box<dyn Fn(&Condensed, &[f64]) -> Solved>;

/// A contact: gap and normal row at a position; with friction the tangential row.
pub(super) struct Contact<'t> {
    pub(super) place: Place<'t>,
    pub(super) restitution: Option<f64>,
    pub(super) tangent: Option<Tangent<'t>>,
    /// Normal and, with friction, tangential impulse of the last step.
    pub(super) impulses: Vec<f64>,
}

/// `q` and `M` of a step problem, and which contacts are in it.
pub(super) struct Condensed {
    pub(super) q: Vec<f64>,
    pub(super) m: Vec<Vec<f64>>,
    pub(super) contacts: Vec<usize>,
}

/// The bodies of a scene with the effects that are on.
pub(super) struct Bodies<'t> {
    pub(super) tally: &'t Tally,
    pub(super) h: f64,
    pub(super) gamma: f64,
    pub(super) q: Vec<Number<'t>>,
    pub(super) v: Vec<Number<'t>>,
    /// With the coordinates they act on.
    pub(super) forces: Vec<(Vec<usize>, Force<'t>)>,
    /// `1 / M̂_ii`, where nothing couples coordinates.
    pub(super) inverse: Vec<f64>,
    /// Where coordinates are coupled.
    pub(super) coupled: Option<Apply<'t>>,
    /// A rod, by its row at the position where the step would end without forces, and its impulse.
    pub(super) joint: Option<(Rod<'t>, f64)>,
    pub(super) contacts: Vec<Contact<'t>>,
    pub(super) solve: Solve,
}

/// `Σ h_i v_i`.
fn times<'t>(row: &Row<'t>, v: &[Number<'t>]) -> Number<'t> {
    let mut sum = row[0].1 * v[row[0].0];
    for &(i, h) in &row[1..] {
        sum = sum + h * v[i];
    }
    sum
}

impl<'t> Bodies<'t> {
    fn free_velocity(&self) -> Vec<Number<'t>> {
        let mut free = self.v.clone();
        if self.forces.is_empty() {
            return free;
        }
        let mut f = vec![self.tally.variable(0.0); free.len()];
        let mut forced = vec![false; free.len()];
        for (coordinates, force) in &self.forces {
            force(&self.q, &self.v, &mut f);
            for &i in coordinates {
                forced[i] = true;
            }
        }
        for i in (0..f.len()).filter(|&i| forced[i]) {
            f[i] = f[i].scale(self.h);
        }
        if let Some(solve) = &self.coupled {
            solve(&mut f);
            for (v, dv) in free.iter_mut().zip(f) {
                *v = *v + dv;
            }
        } else {
            for i in (0..f.len()).filter(|&i| forced[i]) {
                free[i] = free[i] + f[i].scale(self.inverse[i]);
            }
        }
        free
    }

    /// `h_iᵀ M̂⁻¹ h_j`, for all rows `j` that row `i` acts on; the others are 0.
    fn influence(&self, rows: &[Row<'t>], i: usize) -> Vec<Number<'t>> {
        let nothing = Number::constant(0.0);
        let mut of = vec![nothing; rows.len()];
        if let Some(solve) = &self.coupled {
            let mut column = vec![self.tally.variable(0.0); self.q.len()];
            for &(a, h) in &rows[i] {
                column[a] = h;
            }
            solve(&mut column);
            for (j, of) in of.iter_mut().enumerate() {
                *of = times(&rows[j], &column);
            }
            return of;
        }
        for (j, of) in of.iter_mut().enumerate() {
            let mut sum: Option<Number<'t>> = None;
            for &(a, ha) in &rows[i] {
                for &(b, hb) in &rows[j] {
                    if a == b {
                        let term = ha.scale(self.inverse[a]) * hb;
                        sum = Some(sum.map_or(term, |sum| sum + term));
                    }
                }
            }
            *of = sum.unwrap_or(nothing);
        }
        of
    }

    /// `v += M̂⁻¹ Σ h_i r_i`.
    fn push(&self, rows: &[Row<'t>], impulses: &[Number<'t>], v: &mut [Number<'t>]) {
        let Some(solve) = &self.coupled else {
            for (row, &r) in rows.iter().zip(impulses) {
                for &(i, h) in row {
                    v[i] = v[i] + h.scale(self.inverse[i]) * r;
                }
            }
            return;
        };
        let mut column = vec![self.tally.variable(0.0); v.len()];
        for (row, &r) in rows.iter().zip(impulses) {
            for &(i, h) in row {
                column[i] = column[i] + h * r;
            }
        }
        solve(&mut column);
        for (v, dv) in v.iter_mut().zip(column) {
            *v = *v + dv;
        }
    }
}

impl Twin for Bodies<'_> {
    fn step(&mut self) -> Facts {
        let before = self.tally.counts().total();
        let (h, gamma) = (self.h, self.gamma);
        let mut free = self.free_velocity();

        let (mut rows, mut start, mut offsets) = (vec![], vec![], vec![]);
        let (mut closed, mut tangents) = (vec![], vec![]);
        if let Some((row, impulse)) = &self.joint {
            let position = self.q.iter().zip(&self.v);
            let ahead: Vec<Number<'_>> = position.map(|(&q, v)| q + v.scale(h)).collect();
            rows.push(row(&ahead));
            start.push(*impulse);
            offsets.push(None);
        }
        for (c, contact) in self.contacts.iter().enumerate() {
            let (gap, row) = (contact.place)(&self.q);
            let rate = times(&row, &self.v);
            let rests = rate.value() == 0.0 || contact.impulses[0] > 0.0;
            if (gap + rate.scale(gamma * h)).value() <= if rests { 1e-9 } else { 0.0 } {
                closed.push(c);
                offsets.push(contact.restitution.map(|e| (rate, e)));
                let tangent = contact.tangent.as_ref().map(|tangent| tangent(&row));
                rows.push(row);
                if let Some(tangent) = tangent {
                    tangents.push(rows.len());
                    rows.push(tangent);
                    offsets.push(None);
                }
                start.extend_from_slice(&contact.impulses);
            }
        }

        let mut facts = (0, 0, 0.0_f64, 0, 0);
        for contact in &mut self.contacts {
            contact.impulses.fill(0.0);
        }
        if !rows.is_empty() {
            let q: Vec<Number<'_>> = rows.iter().map(|row| times(row, &free)).collect();
            let m: Vec<_> = (0..rows.len()).map(|i| self.influence(&rows, i)).collect();
            for &i in &tangents {
                // The impulse by which a unit of slip sticks; the problem takes it from `m`.
                let _ = m[i][i].recip();
            }
            let bounce = |(q, offset): (Number<'_>, &Option<(Number<'_>, f64)>)| match offset {
                Some((rate, e)) => (q + rate.scale(*e)).value(),
                None => q.value(),
            };
            let q = q.into_iter().zip(&offsets).map(bounce).collect();
            let m: Vec<Vec<f64>> =
                m.iter().map(|row| row.iter().map(Scalar::value).collect()).collect();
            let solved = (self.solve)(&Condensed { q, m, contacts: closed.clone() }, &start);
            let impulses: Vec<_> = solved.z.iter().map(|&r| self.tally.variable(r)).collect();
            self.push(&rows, &impulses, &mut free);
            let mut impulses = solved.z.into_iter();
            if let Some((_, impulse)) = &mut self.joint {
                *impulse = impulses.next().unwrap();
            }
            for &c in &closed {
                for r in &mut self.contacts[c].impulses {
                    *r = impulses.next().unwrap();
                }
            }
            let Solved { iterations, residual, nonzeros, operations, .. } = solved;
            facts = (rows.len(), iterations, residual, nonzeros, operations);
        }

        let velocities = self.v.iter().zip(&free);
        for (q, (v, next)) in self.q.iter_mut().zip(velocities) {
            *q = *q + (next.scale(0.5) + v.scale(0.5)).scale(h);
        }
        self.v = free;
        let motion = self.q.iter().zip(&self.v).flat_map(|(q, v)| [q.value(), v.value()]);
        let joint = self.joint.iter().map(|(_, impulse)| *impulse);
        let contacts = self.contacts.iter().flat_map(|contact| contact.impulses.clone());
        let state: Vec<f64> = motion.chain(joint).chain(contacts).collect();
        let (unknowns, iterations, residual, nonzeros, of_problem) = facts;
        Facts {
            unknowns,
            active: closed.len(),
            iterations,
            residual: residual.to_bits(),
            nonzeros,
            operations: self.tally.counts().total() - before + of_problem,
            state: bits(&state),
        }
    }
}
