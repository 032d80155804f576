//! The effects a scene can name.

use super::effects;
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

impl effects::Effect<SceneFile> for Effect {
    const ALL: &'static [Effect] = &[
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

    fn name(self) -> &'static str {
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

    fn requires(self) -> Option<Effect> {
        match self {
            Effect::Restitution | Effect::Friction => Some(Effect::Contact),
            _ => None,
        }
    }

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
