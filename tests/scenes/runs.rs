//! What a run leaves behind: CSV with any names, the last line, and which runs have a progress bar.

use super::files::scene::{Scene, is_long};
use super::output::{Output, Row};
use super::{all, scene, text_of};
use mcp_core::dynamics::StepReport;

/// The scene's first steps.
fn run(scene: &mut Scene, steps: u64) -> Output {
    let mut output = Output::new(scene.stepper.state_names());
    output.push(Row::of(StepReport::default(), scene.stepper.as_ref()));
    for _ in 0..steps {
        let report = scene.stepper.step().expect("it is solved");
        output.push(Row::of(report, scene.stepper.as_ref()));
    }
    output
}

#[test]
fn names_with_commas_quotes_and_line_breaks_come_back_from_csv() {
    let text = text_of("bouncing_ball")
        .replace("name = \"floor\"", "name = 'a floor, \"wet\"'")
        .replace("\"ball\"", "\"a\\nball\"");
    let mut scene = Scene::parse("scene", &text).unwrap();
    let output = run(&mut scene, 100);
    let path = std::env::temp_dir().join(format!("scenes-{}.csv", std::process::id()));
    output.write_csv(&path).unwrap();
    let mut csv = csv::Reader::from_path(&path).unwrap();
    let names: Vec<String> = csv.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(names[..2], ["time", "unknowns"]);
    assert_eq!(names[6..], ["a\nball.y", "a\nball.y'", "r[a floor, \"wet\"]"]);
    let last = csv.records().map(Result::unwrap).last().unwrap();
    let state: Vec<f64> = last.iter().skip(6).map(|x| x.parse().unwrap()).collect();
    assert_eq!(state, scene.stepper.state());
    std::fs::remove_file(&path).unwrap();
}

#[test]
fn the_last_line_has_twelve_significant_digits() {
    let line = run(&mut scene("two_relays"), 1000).last_line();
    let numbers = line.strip_prefix("final t=1.00000000000e0 state=").expect("the time is first");
    assert_eq!(numbers.split(',').count(), 4);
    for number in numbers.split(',') {
        let mantissa = number.split('e').next().unwrap();
        assert_eq!(mantissa.chars().filter(char::is_ascii_digit).count(), 12, "{number}");
    }
}

#[test]
fn long_runs_are_those_that_compute_many_numbers() {
    let is_long = |name: &String| {
        let scene = scene(name);
        is_long(scene.steps, scene.stepper.state_names().len())
    };
    let long: Vec<String> = all().into_iter().filter(is_long).collect();
    assert_eq!(long, ["column_of_beads", "zhuravlev_ivanov"]);
}
