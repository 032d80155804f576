//! # Scenes: only the effects they name
//!
//! A scene file names bodies, circuit elements or a linear system, and the effects that act on them;
//! an effect that is not named adds no unknown, no equation and no operation. Every time step is one
//! mixed complementarity problem, built from what is active ([`mcp_core::dynamics`]):
//!
//! ```sh
//! cargo run --release --example scenes -- examples/scenes/bouncing_ball.toml
//! ```
//!
//! prints a table of steps and the final state, and writes all steps as CSV and a picture to
//! `target/scenes`. A run that computes 50 000 numbers or more, such as that of `column_of_beads.toml`,
//! has a progress bar on a terminal. Without argument all scenes of `examples/scenes` run, with one
//! line each.
//!
//! | effect | what it needs |
//! | --- | --- |
//! | `gravity`, `spring`, `damper`, `drag` | `[gravity]`, `[[spring]]`, … and bodies |
//! | `contact`, and with it `restitution`, `friction` | `[[contact]]` with a plane or a body |
//! | `joint` | `[[joint]]`: a rail, a rod to a point or to a body |
//! | `diode` | elements of this kind in a circuit |
//! | `relay`, `sliding_mode` | `[[relay]]`, `[[sliding_mode]]` of a linear system |
//! | `zhuravlev_ivanov` | the mass of this name |
//!
//! Scenes and their published trajectories are those of Siconos (`mechanics`, `electronics`,
//! `control` of its examples, by the comment in each file); `tests/scenes.rs` compares with them.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

#[path = "scenes/mod.rs"]
mod files;
#[path = "scenes/output.rs"]
mod output;

use files::effect::Effect;
use files::effects::{Effect as _, FileError, files_in};
use files::scene::{Scene, is_long};
use indicatif::ProgressBar;
use mcp_core::dynamics::{DynamicsError, StepReport};
use output::{Output, Row};
use std::error::Error;
use std::path::Path;

/// Rows of the step table.
const ROWS: u64 = 25;

/// Steps of each scene when all are run.
const BRIEFLY: u64 = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    match std::env::args_os().nth(1) {
        Some(path) => run(Path::new(&path)),
        None => run_all(),
    }
}

/// A step that failed, with the file of its scene.
fn failed(path: &Path, error: DynamicsError) -> FileError {
    FileError::Refused { file: path.display().to_string(), error: Box::new(error) }
}

/// One scene with its table, CSV file and picture.
fn run(path: &Path) -> Result<(), Box<dyn Error>> {
    let mut scene = Scene::read(path)?;
    let effects: Vec<&str> = scene.effects.iter().map(|&effect| Effect::name(effect)).collect();
    println!("{}: {}", scene.title, effects.join(", "));
    let every = scene.steps.div_ceil(ROWS).max(1);
    let mut output = Output::new(scene.stepper.state_names());
    output.push(Row::of(StepReport::default(), scene.stepper.as_ref()));
    // Drawn on a terminal only.
    let bar = if is_long(scene.steps, scene.stepper.state_names().len()) {
        ProgressBar::new(scene.steps)
    } else {
        ProgressBar::hidden()
    };
    println!("{}", output::HEADER);
    for step in 1..=scene.steps {
        let report = scene.stepper.step().map_err(|error| failed(path, error))?;
        let row = Row::of(report, scene.stepper.as_ref());
        if step % every == 0 || step == scene.steps {
            bar.suspend(|| println!("{row}"));
        }
        output.push(row);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/scenes");
    std::fs::create_dir_all(&directory)?;
    let target = directory.join(path.file_stem().unwrap_or_default());
    output.write_csv(&target.with_extension("csv"))?;
    output.write_svg(&scene.title, &target.with_extension("svg"))?;
    println!("steps in {0}.csv, picture in {0}.svg", target.display());
    println!("{}", output.last_line());
    Ok(())
}

/// All scenes, briefly.
fn run_all() -> Result<(), Box<dyn Error>> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    println!("scene                    steps  problems  unknowns  iterations  worst residual");
    for path in files_in(&directory)? {
        let mut scene = Scene::read(&path)?;
        let steps = scene.steps.min(BRIEFLY);
        let (mut problems, mut unknowns, mut iterations, mut worst) = (0, 0, 0, 0.0_f64);
        for _ in 0..steps {
            let report = scene.stepper.step().map_err(|error| failed(&path, error))?;
            problems += u64::from(report.unknowns > 0);
            unknowns = unknowns.max(report.unknowns);
            iterations += report.iterations;
            worst = worst.max(report.residual);
        }
        let title = scene.title;
        println!("{title:<24}{steps:>6}{problems:>10}{unknowns:>10}{iterations:>12}{worst:>16.1e}");
    }
    Ok(())
}
