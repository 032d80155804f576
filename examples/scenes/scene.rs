//! From a scene file to a system on its way through time.

use super::effect::Effect;
use super::effects::{At, FileError, Source, named};
use super::file::{self, SceneFile, System, or};
use super::mechanics;
use super::place::{Entry, finite};
use mcp_core::dynamics::{
    Circuit, ComplementaritySystem, DynamicsError, Element, ElementKind, EulerMoreau, Pair,
    TimeStepper, step_options,
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

/// A run is long if its steps have this many numbers in all.
const LONG: u64 = 50_000;

/// Whether a run of so many steps is long: what it computes, keeps and writes grows with the steps and
/// with the numbers of a state. Long runs have a progress bar.
pub(crate) fn is_long(steps: u64, numbers: usize) -> bool {
    steps.saturating_mul(numbers as u64) >= LONG
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
        return Ok(Box::new(transformed_mass(mass, scene, effects, source)?));
    }
    let system = match &scene.system {
        Some(system) => linear(system, scene, effects, source)?,
        None => circuit(scene, effects, source)?,
    };
    let theta = or(scene.time.theta.as_ref(), 0.5);
    let stepper = EulerMoreau::new(&system, *scene.time.step.get_ref(), theta, &step_options());
    Ok(Box::new(stepper.map_err(|error| scene.time.entry(source).fault(&error))?))
}

/// The transformed bouncing mass.
fn transformed_mass(
    mass: &At<file::ZhuravlevIvanov>,
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<ZhuravlevIvanovStepper, FileError> {
    if !effects.contains(&Effect::ZhuravlevIvanov) {
        let message = "the mass has no other law: name `zhuravlev_ivanov`";
        return Err(source.error(mass.span(), "effects", message));
    }
    let mass = mass.get_ref();
    let number = |key: &str, value| finite(source, &format!("zhuravlev_ivanov.{key}"), value);
    let [x, v] = &mass.start.0;
    let start = [number("start", x)?, number("start", v)?];
    let mut first = ZhuravlevIvanov::new(start).map_err(|error| source.refused(error))?;
    first.h = *scene.time.step.get_ref();
    first.kappa = number("kappa", &mass.kappa)?;
    first.gravity = number("acceleration", &mass.acceleration)?;
    let stepper = ZhuravlevIvanovStepper::new(first, Options::new(Method::Robust), true);
    stepper.map_err(|error| source.refused(error))
}

/// A circuit; without the effect `diode` its diodes do not conduct: they are not there.
fn circuit(
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<ComplementaritySystem, FileError> {
    let mut circuit = Circuit::new();
    for given in &scene.element {
        let (at, element) = (given.span(), given.get_ref());
        let name = element.name.get_ref();
        let value = || {
            let missing =
                || source.error(at.clone(), "element.value", format!("{name} needs a value"));
            element.value.as_ref().map(|value| *value.get_ref()).ok_or_else(missing)
        };
        let start = or(element.start.as_ref(), 0.0);
        let kind = match element.kind.get_ref().as_str() {
            "resistor" => ElementKind::Resistor(value()?),
            "capacitor" => ElementKind::Capacitor(value()?, start),
            "inductor" => ElementKind::Inductor(value()?, start),
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
        let mut entry = Entry::new(source, "element", at.clone())
            .has("name", "name", &element.name)
            .may("start", "start", element.start.as_ref());
        for word in ["resistance", "capacity", "inductance", "voltage"] {
            entry = entry.may(word, "value", element.value.as_ref());
        }
        let [from, to] = element.between.clone();
        let added = circuit.add(Element { name: name.clone(), kind, from, to });
        added.map_err(|error| entry.fault(&error))?;
    }
    circuit.system().map_err(|error| {
        let named = match &error {
            DynamicsError::Circuit { element, .. } => element.as_ref(),
            _ => None,
        };
        let is_named =
            |element: &&At<file::Element>| Some(element.get_ref().name.get_ref()) == named;
        let element = scene.element.iter().find(is_named).or(scene.element.first());
        source.error(element.map_or(0..0, At::span), "element", error.to_string())
    })
}

/// A linear system with relays and controllers.
fn linear(
    system: &At<System>,
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<ComplementaritySystem, FileError> {
    let System { states, start, matrix, drift } = system.get_ref();
    let entry = Entry::new(source, "system", system.span())
        .has("name", "states", states)
        .has("start", "start", start)
        .has("matrix", "matrix", matrix)
        .may("drift", "drift", drift.as_ref());
    let names = states.get_ref().iter().cloned();
    let mut linear = ComplementaritySystem::new(names, start.get_ref(), matrix.get_ref())
        .map_err(|error| entry.fault(&error))?;
    if let Some(drift) = drift {
        linear = linear.drift(drift.get_ref()).map_err(|error| entry.fault(&error))?;
    }
    if effects.contains(&Effect::Relay) {
        for relay in &scene.relay {
            let (at, relay) = (relay.span(), relay.get_ref());
            let entry = Entry::new(source, "relay", at)
                .has("name", "name", &relay.name)
                .has("input", "input", &relay.input)
                .has("output", "output", &relay.output)
                .may("lower", "lower", relay.lower.as_ref())
                .may("upper", "upper", relay.upper.as_ref())
                .may("upper", "lower", relay.lower.as_ref());
            let bounds = [or(relay.lower.as_ref(), -1.0), or(relay.upper.as_ref(), 1.0)];
            let (input, output) = (&relay.input.get_ref()[..], &relay.output.get_ref()[..]);
            let pair = Pair::new(relay.name.get_ref(), input, output);
            let added = linear.pair(pair.within(bounds[0], bounds[1]));
            added.map_err(|error| entry.fault(&error))?;
        }
    }
    if effects.contains(&Effect::SlidingMode) {
        for controller in &scene.sliding_mode {
            let (at, controller) = (controller.span(), controller.get_ref());
            let entry = Entry::new(source, "sliding_mode", at)
                .has("name", "name", &controller.name)
                .has("input", "inputs", &controller.inputs)
                .has("output", "outputs", &controller.outputs);
            let gain = finite(source, "sliding_mode.gain", &controller.gain)?;
            let times_gain = |input: &Vec<f64>| input.iter().map(|b| gain * b).collect();
            let inputs = controller.inputs.get_ref().each_ref().map(times_gain);
            let outputs = controller.outputs.get_ref().0.clone();
            let h = *scene.time.step.get_ref();
            let added = linear.twisting(controller.name.get_ref(), h, inputs, outputs);
            added.map_err(|error| entry.fault(&error))?;
        }
    }
    Ok(linear)
}
