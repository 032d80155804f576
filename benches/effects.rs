//! What the effects of a scene cost, off and on: `cargo bench --bench effects`.
//!
//! Unknowns and nonzeros are those of the largest step, operations those of one `F` of its problem, and of this
//! whole step with one `F` and one `J`; times are the best of several runs of all steps, so that other work
//! on the machine disturbs least. Behind the table stands what was to be reached, and whether it is.
#![allow(clippy::print_stdout, reason = "a benchmark prints its results")]

#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code, reason = "the example uses more of it")]
mod files;

use files::effect::Effect;
use files::effects::Effect as _;
use files::scene::Scene;
use mcp_core::dynamics::{StepSize, TimeStepper, step_options};
use mcp_core::{
    AdProblem, Equation, Model, Parameter, Reader, Real, Scalar, Shape, Solver, Variable,
};
use std::error::Error;
use std::ffi::OsStr;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Runs of a scene; the best counts.
const RUNS: usize = 7;

/// Where the scenes are.
fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes")
}

/// The names of all scenes.
fn names() -> Result<Vec<String>, Box<dyn Error>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(scenes())? {
        let path = entry?.path();
        if path.extension().is_some_and(|end| end == "toml") {
            names.extend(path.file_stem().and_then(OsStr::to_str).map(str::to_owned));
        }
    }
    names.sort();
    Ok(names)
}

/// The effects a scene names, each after those it makes no sense without.
fn effects(name: &str) -> Result<Vec<&'static str>, Box<dyn Error>> {
    let text = fs::read_to_string(scenes().join(name).with_extension("toml"))?;
    let named = Scene::parse(name, &text)?.effects;
    Ok(named.into_iter().map(Effect::name).collect())
}

/// Size of the largest step, and the best time of all steps.
struct Cost {
    size: StepSize,
    time: Duration,
    steps: u64,
}

/// The scene with these effects alone; `steps`: other than its own number.
fn cost(name: &str, effects: &[&str], steps: Option<u64>) -> Result<Cost, Box<dyn Error>> {
    let text = fs::read_to_string(scenes().join(name).with_extension("toml"))?;
    let mut table: toml::Table = text.parse()?;
    table.insert("effects".to_owned(), effects.to_vec().into());
    cost_of(name, &toml::to_string(&table)?, steps)
}

/// The scene in `text`.
fn cost_of(name: &str, text: &str, steps: Option<u64>) -> Result<Cost, Box<dyn Error>> {
    let read = || Scene::parse(name, text);
    let steps = steps.unwrap_or(read()?.steps);

    let mut scene = read()?;
    let mut size = scene.stepper.size()?;
    for _ in 0..steps {
        scene.stepper.step()?;
        let next = scene.stepper.size()?;
        if (next.unknowns, next.operations) > (size.unknowns, size.operations) {
            size = next;
        }
    }
    let mut time = Duration::MAX;
    for _ in 0..RUNS {
        let mut scene = read()?;
        let began = Instant::now();
        run(scene.stepper.as_mut(), steps)?;
        time = time.min(began.elapsed());
    }
    Ok(Cost { size, time, steps })
}

fn run(stepper: &mut dyn TimeStepper, steps: u64) -> Result<(), Box<dyn Error>> {
    for _ in 0..steps {
        black_box(stepper.step()?);
    }
    Ok(())
}

impl Cost {
    fn micros_per_step(&self) -> f64 {
        self.time.as_secs_f64() * 1e6 / self.steps as f64
    }
}

/// `q + m r ⟂ r >= 0`, one unknown.
struct One(Shape);

impl Model for One {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        read.param(0) + 1.0 * read.var(0)
    }
}

/// Best times in microseconds of a step of a ball at rest on the floor, of the solve in it, which starts
/// from its solution, and of a solve with one unknown that takes an iteration. They take turns in short
/// rounds, so that other work on the machine meets all of them alike.
fn step_and_solves() -> Result<[f64; 3], Box<dyn Error>> {
    const ROUNDS: usize = 300;
    const REPEATED: u32 = 500;
    let shape = Shape::builder()
        .variable(Variable::new("r").lower(0.0))
        .parameter(Parameter::new("q", -1.0))
        .equation(Equation::new("y").complements("r"))
        .build()?;
    let mut problem = AdProblem::new(One(shape))?;
    let mut solver = Solver::new(step_options())?;
    let mut solve = |start: f64| -> Result<(), Box<dyn Error>> {
        for _ in 0..REPEATED {
            black_box(solver.solve_from(&mut problem, &[start])?.z[0]);
        }
        Ok(())
    };
    let mut rest = Scene::parse("at rest", AT_REST)?.stepper;
    rest.step()?;
    let mut best = [f64::INFINITY; 3];
    for _ in 0..ROUNDS {
        for (k, best) in best.iter_mut().enumerate() {
            let began = Instant::now();
            match k {
                0 => run(rest.as_mut(), u64::from(REPEATED))?,
                1 => solve(1.0)?,
                _ => solve(0.0)?,
            }
            *best = best.min(began.elapsed().as_secs_f64() * 1e6 / f64::from(REPEATED));
        }
    }
    Ok(best)
}

/// A ball at rest on the floor, whose reaction is that of the step before.
const AT_REST: &str = "title = \"at rest\"\neffects = [\"gravity\", \"contact\"]\n\
    [time]\nstep = 1e-3\nsteps = 1\n\
    [gravity]\nacceleration = 9.81\n\
    [[body]]\nname = \"ball\"\nmass = 1.0\ny = [0.0, 0.0]\n\
    [[contact]]\nname = \"floor\"\nbody = \"ball\"\n";

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| scene | effects | unknowns | nonzeros | operations of F | of the step | µs per step |"
    );
    println!("| --- | --- | ---: | ---: | ---: | ---: | ---: |");
    for name in names()? {
        let effects = effects(&name)?;
        // A scene that is one effect has nothing without it.
        let fewest = usize::from(effects == [Effect::ZhuravlevIvanov.name()]);
        for on in fewest..=effects.len() {
            let cost = cost(&name, &effects[..on], None)?;
            let added = if on == 0 { "none" } else { effects[on - 1] };
            let added = if on > 1 { format!("+ {added}") } else { added.to_owned() };
            let StepSize { unknowns, nonzeros, operations, operations_of_f, .. } = cost.size;
            let time = cost.micros_per_step();
            let size = format!("{unknowns} | {nonzeros} | {operations_of_f} | {operations}");
            println!("| {name} | {added} | {size} | {time:.3} |");
        }
    }
    print_reach()
}

/// What was to be reached, and what is.
fn print_reach() -> Result<(), Box<dyn Error>> {
    let all = [Effect::Gravity, Effect::Contact, Effect::Restitution].map(Effect::name);
    let ball = cost("bouncing_ball", &all, Some(10_000))?.time.as_secs_f64() * 1e3;
    let beads = cost("column_of_beads", &all, Some(4000))?.time.as_secs_f64() * 1e3;
    let flight = flight()?;
    let [rest, warm, one] = step_and_solves()?;
    let share = 100.0 * (rest - warm) / one;
    println!("\n| reached | measured | asked for | met |");
    println!("| --- | ---: | ---: | --- |");
    for (what, measured, most, unit) in [
        ("bouncing ball, 10 000 steps", ball, 20.0, "ms"),
        ("column of ten beads, 4000 steps", beads, 100.0, "ms"),
        ("a step in flight, with a contact to look at", flight, 0.5, "µs"),
        ("the stepper around its solve, as a share of a solve", share, 50.0, "%"),
    ] {
        let met = if measured <= most { "yes" } else { "no" };
        println!("| {what} | {measured:.3} {unit} | {most} {unit} | {met} |");
    }
    println!(
        "\nThe share: a step of a ball at rest, {rest:.3} µs, less the solve of its problem with"
    );
    println!("one unknown from its solution, {warm:.3} µs, is the stepper. A solve is that of one");
    println!("unknown from 0, which takes an iteration, {one:.3} µs.");
    println!(
        "Of the solve from its solution the stepper is {:.0} %.",
        100.0 * (rest - warm) / warm
    );
    Ok(())
}

/// Best time of a step of a ball in flight over a floor, in microseconds.
fn flight() -> Result<f64, Box<dyn Error>> {
    let text = fs::read_to_string(scenes().join("bouncing_ball.toml"))?;
    // It would take 4 hours to come down.
    let high = text.replace("y = [1.0, 0.0]", "y = [1e9, 0.0]");
    let cost = cost_of("in flight", &high, Some(100_000))?;
    if cost.size.unknowns > 0 {
        return Err("the ball is not in flight".into());
    }
    Ok(cost.micros_per_step())
}
