//! Each effect once, with data that bind.

use super::economy::effect::Effect;

const FREE: f64 = f64::INFINITY;

pub(crate) const TAX: [f64; 3] = [0.05, 0.0, 0.2];
pub(crate) const DUTY: [f64; 2] = [0.1, 0.0];
pub(crate) const QUOTA: [f64; 2] = [2.5, FREE];
pub(crate) const EMISSIONS: f64 = 5.4;
pub(crate) const INTENSITY: [f64; 3] = [1.0, 2.5, 0.0];
pub(crate) const MARKUP: [f64; 3] = [0.0, 0.0, 0.25];
pub(crate) const RATION: [[f64; 3]; 2] = [[2.3, FREE, FREE], [0.4, FREE, FREE]];
pub(crate) const TO_BOTH: [f64; 2] = [0.8, 0.2];
pub(crate) const TO_MERCHANTS: [f64; 2] = [0.0, 1.0];

pub(crate) fn tax() -> Effect {
    Effect::Tax { rate: TAX, to: TO_BOTH }
}

pub(crate) fn tariff() -> Effect {
    Effect::Tariff { rate: DUTY, to: TO_BOTH }
}

pub(crate) fn quota() -> Effect {
    Effect::Quota { limit: QUOTA, to: TO_MERCHANTS }
}

pub(crate) fn emission_cap() -> Effect {
    Effect::EmissionCap { limit: EMISSIONS, intensity: INTENSITY, to: TO_BOTH }
}

pub(crate) fn markup() -> Effect {
    Effect::Markup { rate: MARKUP, to: TO_MERCHANTS }
}

pub(crate) fn rationing() -> Effect {
    Effect::Rationing { limit: RATION }
}

/// All, in the order in which the economy declares them.
pub(crate) fn all() -> [Effect; 6] {
    [tax(), tariff(), quota(), emission_cap(), markup(), rationing()]
}

/// The same with data that do not bind: rates of 0, limits beyond what is wanted.
pub(crate) fn slack() -> [Effect; 6] {
    [
        Effect::Tax { rate: [0.0; 3], to: TO_BOTH },
        Effect::Tariff { rate: [0.0; 2], to: TO_BOTH },
        Effect::Quota { limit: [4.0, 4.0], to: TO_MERCHANTS },
        Effect::EmissionCap { limit: 10.0, intensity: INTENSITY, to: TO_BOTH },
        Effect::Markup { rate: [0.0; 3], to: TO_MERCHANTS },
        Effect::Rationing { limit: [[4.0, 4.0, 600.0]; 2] },
    ]
}
