//! What the contacts of a step did, and where its energy went.

use super::moreau_jean::MoreauJean;

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

impl MoreauJean {
    /// Gaps of all contacts, at the state there is now.
    pub fn gaps(&self) -> Vec<f64> {
        let system = &self.motion.system;
        let gap = |contact| system.gap(contact, &self.q, |x| x).gap;
        system.contacts.iter().map(gap).collect()
    }

    /// The contacts of the last step.
    pub fn reactions(&self) -> Vec<Reaction> {
        let system = &self.motion.system;
        let mut next = system.joints.len();
        let reaction = |&c: &usize| {
            let contact = &system.contacts[c];
            let slot = self.motion.slot(c);
            let [normal, tangential] = [slot, slot + 1].map(|slot| self.multipliers[slot]);
            let row = self.active.rows[next];
            next += 1;
            let slip = contact.friction.map_or(0.0, |_| {
                next += 1;
                self.active.rows[next - 1].times(&self.v)
            });
            let (gap, before) = self.active.gaps[c];
            Reaction {
                contact: contact.name.clone(),
                gap: gap.gap,
                rate: (before, row.times(&self.v)),
                normal,
                tangential,
                slip,
            }
        };
        self.active.contacts.iter().map(reaction).collect()
    }

    /// Where the energy of the last step went.
    pub fn balance(&self) -> EnergyBalance {
        let (system, (q, v)) = (&self.motion.system, &self.before);
        let mean = |i: usize| 0.5 * (v[i] + self.v[i]);
        let rows = self.active.slots.iter().zip(&self.active.rows);
        let reactions = rows.map(|(&slot, row)| {
            let rate: f64 = row.entries().iter().map(|&(i, h)| h * mean(i)).sum();
            rate * self.multipliers[slot]
        });
        EnergyBalance {
            change: system.energy(&self.q, &self.v) - system.energy(q, v),
            reactions: reactions.sum(),
            damping: self.motion.scheme.h * system.damping_power(mean),
        }
    }
}
