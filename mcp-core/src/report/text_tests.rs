use super::super::samples::{Broken, Linear, fault, linear, transport};
use super::*;
use crate::error::ModelError;
use crate::model::{Equation, Set, Shape, Variable};
use crate::solver::{Solution, Status};

fn text(problem: &mut Linear, solution: &Solution) -> String {
    Report::new(problem, solution).unwrap().to_string()
}

#[test]
fn a_solution_is_reported_by_name() {
    let mut problem = transport();
    // Only 300 of 325 cases fit: the price of capacity is at its bound, with a rent of 25.
    let solution = problem.ended(&[325.0, -0.0, 1.0, 1.25, 1.5, 1.0], Status::Solved);
    let report = Report::new(&mut problem, &solution).unwrap().named("transport");
    let expected = "\
transport: mixed complementarity problem, 6 variables
sign convention: at a lower bound F >= 0, at an upper bound F <= 0, in between F = 0; the marginal is F

 status             solved: the certificate accepts the point as a solution
 natural residual   0 (units of the model), in every equation
 relative residual  0 (no units), in every equation
 method             newton_fb
 work               1 iteration, 3 evaluations of F, 2 of J, 1 factorisation, 0 gradient steps, 1 of both by the certificate

final statistics (largest absolute value)
 complementarity          0
 normal map               0
 minimum map              0
 Fischer function         0
 Fischer gradient         0
 Siconos error            0  2-norm

solution
 variable     lower   level  upper  unit    marginal  rent  state     ⟂ equation
 x[new-york]      0  325       inf  cases          0        interior  profit[new-york]
 x[topeka]        0    0       inf  cases          0        at lower  profit[topeka]
 w                0    1         1  $/case       -25    25  at upper  supply
 p[new-york]   -inf    1.25    inf  $/case         0        free      demand[new-york]
 p[topeka]     -inf    1.5     inf  $/case         0        free      demand[topeka]
 money            1    1         1                          fixed
";
    assert_eq!(report.to_string(), expected);
}

#[test]
fn no_negative_zero_is_ever_printed() {
    let mut problem = linear(3);
    let solution = problem.ended(&[-0.0, 0.0, 1.0], Status::Solved);
    let text = text(&mut problem, &solution);
    let bad = |word: &str| word.starts_with("-0") && word.parse::<f64>() == Ok(0.0);
    assert!(!text.split_whitespace().any(bad), "{text}");
}

#[test]
fn fifty_variables_are_all_shown_and_fifty_one_are_abbreviated() {
    let solution_of = |problem: &mut Linear| {
        let z: Vec<f64> = (0..problem.shape.n()).map(|i| i.saturating_sub(1) as f64).collect();
        problem.ended(&z, Status::Solved)
    };
    let mut problem = linear(50);
    let solution = solution_of(&mut problem);
    let all = text(&mut problem, &solution);
    assert!((1..=50).all(|i| all.contains(&format!(" z[{i}] "))), "{all}");
    assert!(!all.contains("left out"));

    let mut problem = linear(51);
    let solution = solution_of(&mut problem);
    let some = text(&mut problem, &solution);
    assert!(!some.contains(" z[1] ") && !some.contains(" z[2] "), "{some}");
    assert!((3..=51).all(|i| some.contains(&format!(" z[{i}] "))));
    assert!(some.ends_with(
        " … 2 of 51 `z`\nleft out: 2 of 51 variables (at a lower bound, fixed, zero, or beyond 50 \
         of a family); the CSV has all\n"
    ));

    let mut problem = linear(200);
    let solution = solution_of(&mut problem);
    let few = text(&mut problem, &solution);
    assert!(few.contains(" z[52] ") && !few.contains(" z[53] "), "{few}");
    assert!(few.contains("left out: 150 of 200 variables"));
}

#[test]
fn a_domain_error_shows_equation_value_and_what_it_reads() {
    let mut problem = transport();
    let mut solution = problem.ended(&[0.0, 0.0, 0.0, 0.0, -0.0, 1.0], Status::DomainError);
    let z = [1.0, 2.0, 0.5, -0.3, -0.0, 1.0];
    solution.fault = Some(fault(0, None, f64::NAN, &z));
    let shown = text(&mut problem, &solution);
    let line =
        " not finite         equation `profit[new-york]`: F = NaN at w = 0.5, p[new-york] = -0.3\n";
    assert!(shown.contains(line), "{shown}");
    assert!(shown.contains(" advice             a `Report` names the equation"));

    solution.fault = Some(fault(1, Some(4), f64::INFINITY, &z));
    let shown = text(&mut problem, &solution);
    let line =
        "equation `profit[topeka]`: derivative by `p[topeka]` = inf at p[topeka] = 0, w = 0.5\n";
    assert!(shown.contains(line), "{shown}");
}

#[test]
fn an_equation_that_reads_much_is_cut_short() {
    let shape = Shape::anonymous(&[0.0; 12], &[1.0; 12], &[0.5; 12]).unwrap();
    let entries: Vec<(usize, usize, f64)> = (0..12).map(|j| (0, j, 1.0)).collect();
    let mut problem = Linear::new(shape, &entries, &[0.0; 12]);
    let mut solution = problem.ended(&[0.5; 12], Status::DomainError);
    solution.fault = Some(fault(0, None, f64::NAN, &[0.5; 12]));
    assert!(text(&mut problem, &solution).contains("z[8] = 0.5, and 4 variables more\n"));
}

#[test]
fn an_end_at_infinity_names_equation_and_variable() {
    let mut problem = linear(2);
    let mut solution = problem.ended(&[3e13, 0.0], Status::SolvedAsymptotically);
    (solution.certificate.vanishing_row, solution.start_was_moved) = (Some(1), true);
    let shown = text(&mut problem, &solution);
    assert!(shown.contains(" vanishing          equation `F[2]` has lost all its derivatives\n"));
    assert!(shown.contains(" diverging          variable `z[1]` has run away to 3e13\n"));
    assert!(shown.contains(" start              variables at a bound were moved inside: F or J"));
}

#[test]
fn a_failure_lists_its_worst_equations_first() {
    let mut problem = linear(9);
    let solution = problem.ended(&[0.5; 9], Status::IterationLimit);
    let shown = text(&mut problem, &solution);
    let lines: Vec<&str> = shown.lines().skip_while(|line| !line.starts_with("worst")).collect();
    assert!(lines[2].starts_with(" F[9]           6.5  -6.5  z[9]          0.5"), "{shown}");
    assert_eq!(lines[7], "");
}

#[test]
fn columns_align_under_wide_labels() {
    let towns = Set::new("towns", ["東京", "a, \"b\"", "Zürich"]).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&towns]).lower(0.0).start([1.0, 0.25, 1e6]))
        .equation(Equation::new("f").over(&[&towns]).complements("x"))
        .build()
        .unwrap();
    let mut problem = Linear::diagonal(shape, &[1.0; 3], &[-1.0, -0.25, -1e6]);
    let solution = problem.ended(&[1.0, 0.25, 1e6], Status::Solved);
    let shown = text(&mut problem, &solution);
    let table: Vec<&str> = shown.lines().skip_while(|line| *line != "solution").skip(1).collect();
    let place =
        |line: &str, word: &str| super::super::format::width(&line[..line.find(word).unwrap()]);
    let states: Vec<usize> = table[1..].iter().map(|line| place(line, "interior")).collect();
    assert_eq!(states, [place(table[0], "state"); 3]);
    let equations: Vec<usize> = table[1..].iter().map(|line| place(line, "f[")).collect();
    assert_eq!(equations, [place(table[0], "⟂ equation"); 3]);
}

#[test]
fn an_empty_problem_has_an_empty_table() {
    let shape = Shape::builder().build().unwrap();
    let mut problem = Linear::new(shape, &[], &[]);
    let solution = problem.ended(&[], Status::Solved);
    assert!(text(&mut problem, &solution).contains("0 variables\n"));
}

#[test]
fn a_solution_of_another_problem_is_refused() {
    let solution = linear(3).ended(&[0.0, 0.0, 1.0], Status::Solved);
    let error = Report::new(&mut linear(2), &solution).unwrap_err();
    let what = "levels of the solution".to_owned();
    assert_eq!(error, ModelError::Length { what, expected: 2, found: 3 });
}

#[test]
fn an_error_of_the_writer_is_returned() {
    let mut problem = linear(3);
    let solution = problem.ended(&[0.0, 0.0, 1.0], Status::Solved);
    let report = Report::new(&mut problem, &solution).unwrap();
    for lines in [0, 1, 5, 15] {
        let error = report.write_text(&mut Broken { lines }).unwrap_err();
        assert_eq!(error.to_string(), "disk full");
    }
}
