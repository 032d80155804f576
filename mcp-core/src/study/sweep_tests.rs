use super::*;
use crate::model::{Definition, Equation, Parameter, Reader, Shape, Variable};
use crate::scalar::{Real, Scalar};

/// A mine with room for 3 at cost `4 + tax`, and buyers who take `10 − p`; revenue of the tax.
struct Mine(Shape);

fn mine() -> Mine {
    let shape = Shape::builder()
        .variable(Variable::new("q").lower(0.0).upper(3.0).unit("t"))
        .variable(Variable::new("p").lower(0.0).start(1.0).unit("$/t"))
        .equation(Equation::new("profit").complements("q"))
        .equation(Equation::new("market").complements("p"))
        .parameter(Parameter::new("tax", 0.0))
        .report(Definition::new("revenue"))
        .build()
        .unwrap();
    Mine(shape)
}

impl Model for Mine {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        let (q, p, tax) = (read.var(0), read.var(1), read.param(0));
        // A tax of 100 is outside the domain.
        let wall = (50.0 - tax).sqrt() * 0.0;
        if family == 0 { 4.0 + tax - p + wall } else { q + p - 10.0 }
    }
    fn report(&self, _: usize, _: usize, read: &Reader<'_, f64>) -> Real<f64> {
        read.param(0) * read.var(0)
    }
}

#[test]
fn prices_quantities_and_revenue_follow_the_tax() {
    let values: Vec<f64> = (0..=8).map(f64::from).collect();
    let sweep = sweep(&mine(), "tax", &values).unwrap();
    assert!(sweep.is_solved());
    let table = sweep.of(&["q", "p", "revenue"]).unwrap();
    for (k, &tax) in values.iter().enumerate() {
        // p = max(7, 4 + tax) where the mine works.
        let q = (6.0 - tax).clamp(0.0, 3.0);
        let expected = [q, 10.0 - q, tax * q];
        for (column, expected) in table.columns.iter().zip(expected) {
            assert!((column.values[k] - expected).abs() < 1e-7, "{} at {tax}", column.name);
        }
    }
}

#[test]
fn the_active_set_is_marked_where_it_changes() {
    let sweep = sweep(&mine(), "tax", &[0.0, 2.0, 4.0, 5.0, 7.0, 8.0]).unwrap();
    let changes: Vec<Vec<String>> = sweep
        .points
        .iter()
        .map(|point| point.changes.iter().map(ToString::to_string).collect())
        .collect();
    let empty: Vec<String> = Vec::new();
    let expected = [
        empty.clone(),
        empty.clone(),
        vec!["q interior".to_owned()],
        empty.clone(),
        vec!["q at lower".to_owned()],
        empty,
    ];
    assert_eq!(changes, expected);
}

#[test]
fn every_solve_after_the_first_is_warm() {
    let values: Vec<f64> = (0..=10).map(|k| 3.0 + 0.01 * f64::from(k)).collect();
    let mut seen = 0;
    let sweep =
        sweep_with(&mine(), "tax", &values, &Options::default(), &mut |_| seen += 1).unwrap();
    assert_eq!(seen, 11);
    assert!(!sweep.points[0].is_warm && sweep.points[1..].iter().all(|point| point.is_warm));
    let warm: usize = sweep.points.iter().map(|point| point.solution.stats.iterations).sum();
    let cold = values.iter().map(|&value| {
        let alone = super::sweep(&mine(), "tax", &[value]).unwrap();
        alone.points[0].solution.stats.iterations
    });
    assert!(warm < cold.sum());
}

#[test]
fn a_point_without_solution_is_shown_and_the_sweep_goes_on() {
    let sweep = sweep(&mine(), "tax", &[4.0, 100.0, 5.0]).unwrap();
    let solved: Vec<bool> = sweep.points.iter().map(|point| point.solution.is_solved()).collect();
    assert_eq!(solved, [true, false, true]);
    let table = sweep.of(&["q"]).unwrap();
    assert!(table.columns[0].values[1].is_nan());
    let text = table.to_string();
    assert!(text.contains("status") && text.contains("domain_error"), "{text}");
    assert!(sweep.points[2].is_warm, "from the last solution, not from the failure");
}

#[test]
fn percentages_are_of_the_first_solution() {
    let sweep = sweep(&mine(), "tax", &[4.0, 5.0]).unwrap();
    let table = sweep.of(&["p", "revenue"]).unwrap().in_percent();
    assert!((table.columns[0].values[1] - 12.5).abs() < 1e-6);
    assert_eq!(table.columns[0].unit, "%");
    let text = table.to_string();
    assert!(text.contains("p [%]") && text.contains("+12.50"), "{text}");
}

#[test]
fn reports_are_what_a_sweep_shows() {
    let text = sweep(&mine(), "tax", &[0.0, 4.0]).unwrap().to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with(" tax  revenue  iterations  now"), "{text}");
    assert!(lines[2].trim_start().starts_with('4'), "{text}");
    assert!(lines[2].ends_with("q interior"), "{text}");
}

#[test]
fn wrong_names_and_values_are_named() {
    let told = |result: Result<Sweep, ModelError>| result.unwrap_err().to_string();
    assert_eq!(
        told(sweep(&mine(), "taxes", &[0.0])),
        "there is no parameter `taxes`; did you mean `tax`?"
    );
    assert!(told(sweep(&mine(), "tax", &[f64::NAN])).contains("tax"));
    assert!(told(sweep(&mine(), "taxes", &[])).contains("taxes"));
    let mut solves = 0;
    let values = [0.0, 1.0, f64::NAN];
    let late = sweep_with(&mine(), "tax", &values, &Options::default(), &mut |_| solves += 1);
    assert!(late.is_err() && solves == 0);
    let sweep = sweep(&mine(), "tax", &[0.0]).unwrap();
    assert_eq!(
        sweep.of(&["revenu"]).unwrap_err().to_string(),
        "there is no variable, report or definition `revenu`; did you mean `revenue`?"
    );
}

#[cfg(feature = "serde")]
#[test]
fn csv_has_every_digit_and_the_changes() {
    let sweep = sweep(&mine(), "tax", &[0.0, 7.0]).unwrap();
    let mut out = Vec::new();
    sweep.of(&["q"]).unwrap().write_csv(&mut out).unwrap();
    let text = String::from_utf8(out).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "tax,status,iterations,changes,q");
    assert!(lines[1].starts_with("0,solved,"));
    assert!(lines[2].starts_with("7,solved,") && lines[2].contains(",q at lower,"), "{text}");
}

#[cfg(feature = "plots")]
#[test]
fn a_picture_has_a_line_for_each_number_and_a_mark_for_each_change() {
    let sweep = sweep(&mine(), "tax", &[0.0, 2.0, 4.0, 7.0]).unwrap();
    let table = sweep.of(&["q", "p"]).unwrap();
    let svg = table.svg().unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    let lines = |stroke: &str| svg.matches(stroke).count();
    // Each line stands in the picture and in its legend.
    assert_eq!(lines("stroke-width=\"2\""), 4, "{svg}");
    let one = super::super::sweep(&mine(), "tax", &[0.0]).unwrap();
    let told = one.of(&["q"]).unwrap().svg().unwrap_err().to_string();
    assert_eq!(told, "there is nothing to plot: no number has two finite values");
    let mut endless = table;
    endless.columns[0].values = vec![-1e308, 1e308, 0.0, 0.0];
    assert!(matches!(endless.svg(), Err(super::super::PlotError::TooWide)));
}
