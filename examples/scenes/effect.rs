//! The effects a scene can name.

use super::error::{SceneError, Source};
use super::file::SceneFile;

/// An effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    Gravity,
    Spring,
    Damper,
    Drag,
    Contact,
    Restitution,
    Friction,
    Joint,
    Diode,
    Relay,
    SlidingMode,
    ZhuravlevIvanov,
}

impl Effect {
    const ALL: [Effect; 12] = [
        Effect::Gravity,
        Effect::Spring,
        Effect::Damper,
        Effect::Drag,
        Effect::Contact,
        Effect::Restitution,
        Effect::Friction,
        Effect::Joint,
        Effect::Diode,
        Effect::Relay,
        Effect::SlidingMode,
        Effect::ZhuravlevIvanov,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Effect::Gravity => "gravity",
            Effect::Spring => "spring",
            Effect::Damper => "damper",
            Effect::Drag => "drag",
            Effect::Contact => "contact",
            Effect::Restitution => "restitution",
            Effect::Friction => "friction",
            Effect::Joint => "joint",
            Effect::Diode => "diode",
            Effect::Relay => "relay",
            Effect::SlidingMode => "sliding_mode",
            Effect::ZhuravlevIvanov => "zhuravlev_ivanov",
        }
    }

    /// The effect without which this one makes no sense.
    fn requires(self) -> Option<Effect> {
        match self {
            Effect::Restitution | Effect::Friction => Some(Effect::Contact),
            _ => None,
        }
    }

    /// Whether the file has the data of the effect.
    fn has_data(self, file: &SceneFile) -> bool {
        match self {
            Effect::Gravity => file.gravity.is_some(),
            Effect::Spring => !file.spring.is_empty(),
            Effect::Damper => !file.damper.is_empty(),
            Effect::Drag => !file.drag.is_empty(),
            Effect::Contact => !file.contact.is_empty(),
            Effect::Restitution => file.contact.iter().any(|c| c.get_ref().restitution.is_some()),
            Effect::Friction => file.contact.iter().any(|c| c.get_ref().friction.is_some()),
            Effect::Joint => !file.joint.is_empty(),
            Effect::Diode => file.element.iter().any(|e| e.get_ref().kind.get_ref() == "diode"),
            Effect::Relay => !file.relay.is_empty(),
            Effect::SlidingMode => !file.sliding_mode.is_empty(),
            Effect::ZhuravlevIvanov => file.zhuravlev_ivanov.is_some(),
        }
    }
}

/// The effects that a file names, each known, with its data, and with what it requires.
pub(crate) fn named(file: &SceneFile, source: &Source<'_>) -> Result<Vec<Effect>, SceneError> {
    let mut effects = Vec::new();
    for name in &file.effects {
        let fault = |message: String| source.error(name.span(), "effects", message);
        let known = Effect::ALL.into_iter().find(|effect| effect.name() == name.get_ref());
        let Some(effect) = known else {
            let all = Effect::ALL.map(Effect::name).join(", ");
            return Err(fault(format!("there is no effect `{}`: choose {all}", name.get_ref())));
        };
        if effects.contains(&effect) {
            return Err(fault(format!("`{}` is named twice", effect.name())));
        }
        if !effect.has_data(file) {
            return Err(fault(format!("the scene has no data for `{}`", effect.name())));
        }
        effects.push(effect);
    }
    for (effect, name) in effects.iter().zip(&file.effects) {
        if let Some(other) = effect.requires().filter(|other| !effects.contains(other)) {
            let message = format!("`{}` makes no sense without `{}`", effect.name(), other.name());
            return Err(source.error(name.span(), "effects", message));
        }
    }
    Ok(effects)
}
