use super::*;
use crate::model::Set;
use crate::problem::Pattern;
use crate::{Equation, Reader, Real, Scalar, Variable};

const INF: f64 = f64::INFINITY;

/// `F = J z + c` with a diagonal `J`.
struct Diagonal {
    shape: Arc<Shape>,
    pattern: Pattern,
    c: Vec<f64>,
    slopes: Vec<f64>,
}

impl Problem for Diagonal {
    fn shape(&self) -> &Arc<Shape> {
        &self.shape
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn evaluate(&mut self, z: &[f64], f: Option<&mut [f64]>, jac: Option<&mut [f64]>) {
        for (i, f) in f.into_iter().flatten().enumerate() {
            let slope = if self.slopes[i].is_finite() { self.slopes[i] } else { 0.0 };
            *f = slope * z[i] + self.c[i];
        }
        if let Some(jac) = jac {
            jac.copy_from_slice(&self.slopes[..self.pattern.nnz()]);
        }
    }
}

fn diagonal(bounds: &[(f64, f64)], slopes: &[f64], c: &[f64]) -> Diagonal {
    let (lower, upper): (Vec<f64>, Vec<f64>) = bounds.iter().copied().unzip();
    let shape = Shape::anonymous(&lower, &upper, &vec![0.0; bounds.len()]).unwrap();
    let pattern = Pattern::from_columns((0..bounds.len()).map(|j| vec![j]));
    Diagonal { shape: shape.into(), pattern, c: c.to_vec(), slopes: slopes.to_vec() }
}

/// Checks `z` of `z_i + c_i ⟂ bounds`.
fn check(bounds: &[(f64, f64)], c: &[f64], z: &[f64]) -> PointCheck {
    PointCheck::new(&mut diagonal(bounds, &vec![1.0; c.len()], c), z).unwrap()
}

#[test]
fn every_violation_has_its_sentence() {
    use Violation::{
        AboveUpper, BelowLower, NegativeAtLower, NotFinite, NotZeroBetween, NotZeroFree,
        PositiveAtUpper,
    };
    let cases = [
        (
            (0.0, INF),
            -3.0,
            0.0,
            NegativeAtLower,
            3.0,
            "F = -3 is negative although `z[1]` is at its lower bound 0 (residual 3)",
        ),
        (
            (0.0, 1.0),
            2.0,
            1.0,
            PositiveAtUpper,
            1.0,
            "F = 3 is positive although `z[1]` is at its upper bound 1 (residual 1)",
        ),
        (
            (0.0, 9.0),
            2.0,
            1.0,
            NotZeroBetween,
            1.0,
            "F = 3 is not 0 although `z[1]` = 1 is between its bounds 0 and 9 (residual 1)",
        ),
        (
            (-INF, INF),
            2.0,
            1.0,
            NotZeroFree,
            3.0,
            "F = 3 is not 0 although `z[1]` is free (residual 3)",
        ),
        (
            (0.0, INF),
            2.0,
            -0.5,
            BelowLower,
            0.5,
            "the level -0.5 is below the lower bound 0 (residual 0.5)",
        ),
        (
            (0.0, 1.0),
            -1.5,
            1.5,
            AboveUpper,
            0.5,
            "the level 1.5 is above the upper bound 1 (residual 0.5)",
        ),
        ((0.0, INF), f64::NAN, 1.0, NotFinite, f64::NAN, "F = NaN is not finite"),
        ((0.0, INF), 0.0, INF, NotFinite, f64::NAN, "the level inf is not finite"),
    ];
    for (bounds, c, z, violation, residual, sentence) in cases {
        let check = check(&[bounds], &[c], &[z]);
        let row = check.rows().next().unwrap();
        assert_eq!(row.violation, Some(violation), "{sentence}");
        assert_eq!(row.residual.to_bits(), residual.to_bits(), "{sentence}");
        assert_eq!(row.to_string(), format!("`F[1]` ⟂ `z[1]`: {sentence}"));
        assert!(!check.is_solution());
        let error = check.verdict().unwrap_err();
        assert_eq!(error.to_string(), format!("the point is not a solution: {row}"));
    }
}

#[test]
fn an_infinite_bound_is_not_spoken_of() {
    let sentence = |bounds| check(&[bounds], &[2.0], &[1.0]).rows().next().unwrap().to_string();
    assert!(sentence((0.0, INF)).contains("`z[1]` = 1 is above its lower bound 0 (residual 1)"));
    assert!(sentence((-INF, 4.0)).contains("`z[1]` = 1 is below its upper bound 4 (residual 3)"));
}

#[test]
fn a_solution_is_said_to_be_one() {
    // At its lower bound, at its upper bound, between, free, fixed.
    let bounds = [(0.0, INF), (0.0, 1.0), (0.0, 9.0), (-INF, INF), (2.0, 2.0)];
    let check = check(&bounds, &[5.0, -7.0, -3.0, 4.0, 6.0], &[0.0, 1.0, 3.0, -4.0, 2.0]);
    assert_eq!(check.to_string(), "the point is a solution: residual 0");
    assert_eq!((check.violated().count(), check.residual()), (0, 0.0));
    assert!(check.rows().all(|row| row.to_string().ends_with("holds (residual 0)")));
    assert!(check.verdict().is_ok());
}

#[test]
fn rounding_is_no_violation_that_counts() {
    let check = check(&[(-INF, INF)], &[-(0.1 + 0.2)], &[0.3]);
    assert!(check.is_solution());
    assert_eq!(check.to_string(), "the point is a solution: residual 5.6e-17");
}

#[test]
fn the_worst_come_first_and_ten_are_listed() {
    let c: Vec<f64> = (0..14).map(|i| if i == 3 { f64::NAN } else { f64::from(i % 13) }).collect();
    let check = check(&[(-INF, INF); 14], &c, &[0.0; 14]);
    let residuals: Vec<f64> = check.rows().map(|row| row.residual).collect();
    assert!(residuals[0].is_nan() && residuals[1..].is_sorted_by(|a, b| a >= b));
    let text = check.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "the point is not a solution: residual NaN");
    assert_eq!(lines[1], " `F[4]` ⟂ `z[4]`: F = NaN is not finite");
    assert_eq!(
        lines[2],
        " `F[13]` ⟂ `z[13]`: F = 12 is not 0 although `z[13]` is free (residual 12)"
    );
    // F[1] and F[14] hold.
    assert_eq!((lines.len(), lines[11]), (12, " … and 2 more"));
}

#[test]
fn infinite_values_stand_before_large_residuals() {
    let check = check(&[(0.0, INF), (-INF, INF)], &[INF, 9.0], &[0.0, 0.0]);
    let row = check.rows().next().unwrap();
    assert_eq!(
        (row.equation.as_deref(), row.violation),
        (Some("F[1]"), Some(Violation::NotFinite))
    );
}

#[test]
fn the_equation_that_refuses_the_point_is_named() {
    // The second is off by more, the first by a larger share of its terms.
    let mut problem = diagonal(&[(-INF, INF); 2], &[1e-6, 1e9], &[-1e-6, -1e9]);
    let check = PointCheck::new(&mut problem, &[1.5, 1.0 + 1e-13]).unwrap();
    assert_eq!(check.rows().next().unwrap().equation.as_deref(), Some("F[2]"));
    assert!(check.to_string().contains("(`F[1]`)\n "), "{check}");
    let named = |error: WrongPoint| match error {
        WrongPoint::Violated { row } => row.equation.unwrap(),
        other => panic!("{other}"),
    };
    assert_eq!(named(check.clone().verdict().unwrap_err()), "F[1]");
    assert_eq!(named(check.clone().verdict_within(Some(1e-10), 1e-8).unwrap_err()), "F[2]");
    assert!(check.verdict_within(None, 0.9).is_ok());
}

#[test]
fn a_point_barely_outside_is_named_whatever_the_tolerance() {
    let check = check(&[(-INF, INF), (0.0, INF)], &[1e-9, 1.0], &[0.0, -1e-12]);
    let error = check.verdict_within(None, 1.0).unwrap_err().to_string();
    assert!(error.contains("`z[2]`: the level -1e-12 is below the lower bound 0"), "{error}");
}

#[test]
fn a_derivative_that_is_not_finite_is_named() {
    let mut problem = diagonal(&[(-INF, INF)], &[INF], &[0.0]);
    let check = PointCheck::new(&mut problem, &[0.0]).unwrap();
    let message = "the point is not a solution: its residual is 0.0e0, but the derivative of \
                   `F[1]` by `z[1]` is not finite";
    assert!(check.to_string().contains(message), "{check}");
    assert_eq!(check.verdict().unwrap_err().to_string(), message);
}

#[test]
fn a_solution_at_infinity_is_named() {
    let mut problem = diagonal(&[(-INF, INF); 2], &[1.0, 0.0], &[0.0, 0.0]);
    let check = PointCheck::new(&mut problem, &[0.0, 1.0]).unwrap();
    let error = check.verdict().unwrap_err().to_string();
    assert!(error.contains("equation `F[2]` has lost all its derivatives"), "{error}");
}

#[test]
fn a_fixed_variable_without_equation_has_bounds_alone() {
    let variables = Variable::new("x").over(&[&Set::count("rows", 2)]).fixed(2.0);
    let shape = Arc::new(Shape::builder().variable(variables).build().unwrap());
    let pattern = Pattern::from_rows(&[vec![], vec![]]);
    let mut problem = Diagonal { shape, pattern, c: vec![0.0; 2], slopes: vec![0.0; 2] };
    let check = PointCheck::new(&mut problem, &[2.0, 1.0]).unwrap();
    let row = check.rows().next().unwrap();
    assert_eq!((&row.equation, row.f), (&None, None));
    let sentence = "`x[2]`: the level 1 is below the lower bound 2 (residual 1)";
    assert_eq!(row.to_string(), sentence);
}

struct Line(Shape);

impl Model for Line {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        2.0 * read.var(0) - 4.0
    }
}

#[test]
fn a_model_is_checked_and_wrong_lengths_are_errors() {
    let shape = Shape::builder()
        .variable(Variable::new("x").lower(0.0))
        .equation(Equation::new("f").complements("x"))
        .build()
        .unwrap();
    let line = Line(shape);
    assert!(check_point(&line, &[2.0]).unwrap().is_solution());
    let error = check_point(&line, &[2.0, 1.0]).unwrap_err();
    assert_eq!(error.to_string(), "the length of `z` is 2, expected 1");
}
