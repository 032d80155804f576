//! The effects a scenario can name, with their data.

use super::data::{HOUSEHOLDS, SECTORS, TRADED};
use super::effects::{self, FileError, Source, named};
use super::file::{EmissionCap, Quotas, Rates, Rations, ScenarioFile};
use super::numbers::{Key, Range};

/// What an effect is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EffectName {
    Tax,
    Tariff,
    Quota,
    EmissionCap,
    Markup,
    Rationing,
}

impl effects::Effect<ScenarioFile> for EffectName {
    const ALL: &'static [EffectName] = &[
        EffectName::Tax,
        EffectName::Tariff,
        EffectName::Quota,
        EffectName::EmissionCap,
        EffectName::Markup,
        EffectName::Rationing,
    ];

    fn name(self) -> &'static str {
        match self {
            EffectName::Tax => "tax",
            EffectName::Tariff => "tariff",
            EffectName::Quota => "quota",
            EffectName::EmissionCap => "emission_cap",
            EffectName::Markup => "markup",
            EffectName::Rationing => "rationing",
        }
    }

    fn has_data(self, file: &ScenarioFile) -> bool {
        match self {
            EffectName::Tax => file.tax.is_some(),
            EffectName::Tariff => file.tariff.is_some(),
            EffectName::Quota => file.quota.is_some(),
            EffectName::EmissionCap => file.emission_cap.is_some(),
            EffectName::Markup => file.markup.is_some(),
            EffectName::Rationing => file.rationing.is_some(),
        }
    }
}

/// An effect with its data, in the order of households, sectors and traded goods; `to` are the parts
/// of what it brings that go to the households.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Effect {
    Tax { rate: [f64; 3], to: [f64; 2] },
    Tariff { rate: [f64; 2], to: [f64; 2] },
    Quota { limit: [f64; 2], to: [f64; 2] },
    EmissionCap { limit: f64, intensity: [f64; 3], to: [f64; 2] },
    Markup { rate: [f64; 3], to: [f64; 2] },
    Rationing { limit: [[f64; 3]; 2] },
}

impl Effect {
    /// The effects that a file names, in its order.
    pub(crate) fn of_file(
        file: &ScenarioFile,
        source: &Source<'_>,
    ) -> Result<Vec<Self>, FileError> {
        let mut effects = Vec::new();
        for name in named(&file.effects, file, source)? {
            effects.extend(match name {
                EffectName::Tax => file.tax.as_ref().map(|tax| tax.tax(source)),
                EffectName::Tariff => file.tariff.as_ref().map(|tariff| tariff.tariff(source)),
                EffectName::Quota => file.quota.as_ref().map(|quotas| quotas.effect(source)),
                EffectName::EmissionCap => file.emission_cap.as_ref().map(|cap| cap.effect(source)),
                EffectName::Markup => file.markup.as_ref().map(|markup| markup.markup(source)),
                EffectName::Rationing => file.rationing.as_ref().map(|table| table.effect(source)),
            });
        }
        effects.into_iter().collect()
    }
}

impl Rates {
    fn tax(&self, source: &Source<'_>) -> Result<Effect, FileError> {
        let (rate, to) = self.of("tax", SECTORS, source)?;
        Ok(Effect::Tax { rate, to })
    }

    fn tariff(&self, source: &Source<'_>) -> Result<Effect, FileError> {
        let (rate, to) = self.of("tariff", TRADED, source)?;
        Ok(Effect::Tariff { rate, to })
    }

    fn markup(&self, source: &Source<'_>) -> Result<Effect, FileError> {
        let (rate, to) = self.of("markup", SECTORS, source)?;
        Ok(Effect::Markup { rate, to })
    }

    /// The rates of these goods in the table of this name, and whose the yield is.
    fn of<const N: usize>(
        &self,
        table: &str,
        goods: [&str; N],
        source: &Source<'_>,
    ) -> Result<([f64; N], [f64; 2]), FileError> {
        let rate = Key::new(source, format!("{table}.rate"));
        let to = Key::new(source, format!("{table}.to"));
        Ok((rate.named(&self.rate, goods, Range::Rate)?, to.parts(&self.to, HOUSEHOLDS)?))
    }
}

impl Quotas {
    fn effect(&self, source: &Source<'_>) -> Result<Effect, FileError> {
        let limit = Key::new(source, "quota.limit").named(&self.limit, TRADED, Range::Limit)?;
        let to = Key::new(source, "quota.to").parts(&self.to, HOUSEHOLDS)?;
        Ok(Effect::Quota { limit, to })
    }
}

impl EmissionCap {
    fn effect(&self, source: &Source<'_>) -> Result<Effect, FileError> {
        let limit = Key::new(source, "emission_cap.limit").number(&self.limit, Range::Limit)?;
        let intensity = Key::new(source, "emission_cap.intensity");
        let intensity = intensity.all(&self.intensity, SECTORS, Range::Rate)?;
        let to = Key::new(source, "emission_cap.to").parts(&self.to, HOUSEHOLDS)?;
        Ok(Effect::EmissionCap { limit, intensity, to })
    }
}

impl Rations {
    fn effect(&self, source: &Source<'_>) -> Result<Effect, FileError> {
        let mut limit = [[f64::INFINITY; 3]; 2];
        let households = Key::new(source, "rationing.limit");
        for (name, numbers) in &self.limit {
            let household = households.position(name, &HOUSEHOLDS)?;
            let goods = Key::new(source, format!("rationing.limit.{}", name.get_ref()));
            limit[household] = goods.named(numbers, SECTORS, Range::Limit)?;
        }
        Ok(Effect::Rationing { limit })
    }
}
