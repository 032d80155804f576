//! What stands in a scenario file.

use super::effects::At;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Numbers by the names of sectors or households.
pub(crate) type Numbers = At<BTreeMap<At<String>, At<f64>>>;

/// A scenario: the effects it names, and their data.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScenarioFile {
    pub(crate) title: String,
    pub(crate) effects: Vec<At<String>>,
    pub(crate) tax: Option<Rates>,
    pub(crate) tariff: Option<Rates>,
    pub(crate) quota: Option<Quotas>,
    pub(crate) emission_cap: Option<EmissionCap>,
    pub(crate) markup: Option<Rates>,
    pub(crate) rationing: Option<Rations>,
}

/// Rates by sector, 0 for a sector that is not named, and the parts of the yield that go to the
/// households: effects `tax`, `tariff`, `markup`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rates {
    pub(crate) rate: Numbers,
    pub(crate) to: Numbers,
}

/// Effect `quota`: most imports [M], and whose the licences are.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Quotas {
    pub(crate) limit: Numbers,
    pub(crate) to: Numbers,
}

/// Effect `emission_cap`: most emissions [Mt CO2], what a unit of each sector emits [t CO2], and who
/// gets what the permits bring.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct EmissionCap {
    pub(crate) limit: At<f64>,
    pub(crate) intensity: Numbers,
    pub(crate) to: Numbers,
}

/// Effect `rationing`: the most a household may buy of a good [M], by household and sector.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rations {
    pub(crate) limit: BTreeMap<At<String>, Numbers>,
}
