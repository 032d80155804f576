//! From a scene file to a system on its way through time.

use super::effect::Effect;
use super::effects::{FileError, Source, named};
use super::file::{SceneFile, System};
use super::mechanics;
use mcp_core::dynamics::{
    Circuit, ComplementaritySystem, Element, ElementKind, EulerMoreau, Pair, TimeStepper,
    step_options,
};
use mcp_core::testing::{ZhuravlevIvanov, ZhuravlevIvanovStepper};
use mcp_core::{Method, Options};
use std::path::Path;

/// A scene, read and checked.
pub(crate) struct Scene {
    pub(crate) title: String,
    pub(crate) effects: Vec<Effect>,
    pub(crate) steps: u64,
    pub(crate) stepper: Box<dyn TimeStepper>,
}

impl Scene {
    /// Reads a scene file.
    pub(crate) fn read(path: &Path) -> Result<Self, FileError> {
        Source::read(path, |source| Self::parse(source.file, source.text))
    }

    /// The scene in `text`; `file` is its name in errors.
    pub(crate) fn parse(file: &str, text: &str) -> Result<Self, FileError> {
        let source = Source { file, text };
        let scene: SceneFile = toml::from_str(text).map_err(|error| source.syntax(&error))?;
        let effects = named(&scene.effects, &scene, &source)?;
        let step = &scene.time.step;
        if !(*step.get_ref() > 0.0 && step.get_ref().is_finite()) {
            let message = format!("is {}, but must be a positive number", step.get_ref());
            return Err(source.error(step.span(), "time.step", message));
        }
        let stepper = stepper(&scene, &effects, &source)?;
        Ok(Scene { title: scene.title, effects, steps: scene.time.steps, stepper })
    }
}

/// The one base of the scene with its effects.
fn stepper(
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<Box<dyn TimeStepper>, FileError> {
    let bases = [
        !scene.body.is_empty(),
        !scene.element.is_empty(),
        scene.system.is_some(),
        scene.zhuravlev_ivanov.is_some(),
    ];
    if bases.into_iter().filter(|&base| base).count() != 1 {
        let message = "a scene has one of [[body]], [[element]], [system], [zhuravlev_ivanov]";
        return Err(source.error(0..0, "body", message));
    }
    if !scene.body.is_empty() {
        return Ok(Box::new(mechanics::stepper(scene, effects, source)?));
    }
    if let Some(mass) = &scene.zhuravlev_ivanov {
        if !effects.contains(&Effect::ZhuravlevIvanov) {
            let message = "the mass has no other law: name `zhuravlev_ivanov`";
            return Err(source.error(mass.span(), "effects", message));
        }
        let mass = mass.get_ref();
        let mut first = ZhuravlevIvanov::new(mass.start).map_err(|error| source.refused(error))?;
        (first.h, first.kappa) = (*scene.time.step.get_ref(), mass.kappa);
        first.gravity = mass.acceleration;
        let stepper = ZhuravlevIvanovStepper::new(first, Options::new(Method::Robust), true);
        return Ok(Box::new(stepper.map_err(|error| source.refused(error))?));
    }
    let system = match &scene.system {
        Some(system) => linear(system.get_ref(), scene, effects, source)?,
        None => circuit(scene, effects, source)?,
    };
    let theta = scene.time.theta.as_ref().map_or(0.5, |theta| *theta.get_ref());
    let stepper = EulerMoreau::new(&system, *scene.time.step.get_ref(), theta, &step_options());
    Ok(Box::new(stepper.map_err(|error| source.refused(error))?))
}

/// A circuit; without the effect `diode` its diodes do not conduct: they are not there.
fn circuit(
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<ComplementaritySystem, FileError> {
    let mut circuit = Circuit::new();
    for element in &scene.element {
        let at = element.span();
        let element = element.get_ref();
        let value = || {
            let missing = || {
                let message = format!("{} needs a value", element.name);
                source.error(at.clone(), "element.value", message)
            };
            element.value.as_ref().map(|value| *value.get_ref()).ok_or_else(missing)
        };
        let kind = match element.kind.get_ref().as_str() {
            "resistor" => ElementKind::Resistor(value()?),
            "capacitor" => ElementKind::Capacitor(value()?, element.start),
            "inductor" => ElementKind::Inductor(value()?, element.start),
            "source" => ElementKind::Source(value()?),
            "diode" if effects.contains(&Effect::Diode) => ElementKind::Diode,
            "diode" => continue,
            other => {
                let message = format!(
                    "there is no `{other}`: choose resistor, capacitor, inductor, source, diode"
                );
                return Err(source.error(element.kind.span(), "element.kind", message));
            }
        };
        let [from, to] = element.between.clone();
        let element = Element { name: element.name.clone(), kind, from, to };
        circuit.add(element).map_err(|error| source.error(at, "element", error.to_string()))?;
    }
    circuit.system().map_err(|error| source.refused(error))
}

/// A linear system with relays and controllers.
fn linear(
    system: &System,
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<ComplementaritySystem, FileError> {
    let at = scene.system.as_ref().map_or(0..0, toml::Spanned::span);
    let fault = |error: mcp_core::dynamics::DynamicsError| {
        source.error(at.clone(), "system", error.to_string())
    };
    let System { states, start, matrix, drift } = system;
    let mut linear =
        ComplementaritySystem::new(states.iter().cloned(), start, matrix).map_err(fault)?;
    if let Some(drift) = drift {
        linear = linear.drift(drift).map_err(fault)?;
    }
    if effects.contains(&Effect::Relay) {
        for relay in &scene.relay {
            let (at, relay) = (relay.span(), relay.get_ref());
            let pair = Pair::new(&relay.name, &relay.input[..], &relay.output[..]);
            let added = linear.pair(pair.within(relay.lower, relay.upper));
            added.map_err(|error| source.error(at, "relay", error.to_string()))?;
        }
    }
    if effects.contains(&Effect::SlidingMode) {
        for controller in &scene.sliding_mode {
            let (at, controller) = (controller.span(), controller.get_ref());
            let times_gain = |input: &Vec<f64>| input.iter().map(|b| controller.gain * b).collect();
            let inputs = controller.inputs.each_ref().map(times_gain);
            let outputs = controller.outputs.clone();
            let h = *scene.time.step.get_ref();
            let added = linear.twisting(&controller.name, h, inputs, outputs);
            added.map_err(|error| source.error(at, "sliding_mode", error.to_string()))?;
        }
    }
    Ok(linear)
}
