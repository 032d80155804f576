use super::*;
use crate::model::{Definition, Equation, Model, Reader, Set, Shape, Variable};
use crate::problem::AdProblem;
use crate::scalar::{Real, Scalar};
use crate::solver::{Method, Options, solve};

/// `x_i − i ⟂ x_i >= 0` with `double_i = 2 x_i` and the report `total = Σ double_i`.
struct Doubled(Shape);

impl Model for Doubled {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        0.5 * read.def(i) - i as f64
    }
    fn def<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        2.0 * read.var(i)
    }
    fn report(&self, _: usize, _: usize, read: &Reader<'_, f64>) -> Real<f64> {
        (0..self.0.n()).map(|i| read.def(i)).sum()
    }
}

fn doubled(n: usize) -> Report {
    let set = Set::count("i", n);
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&set]).lower(0.0))
        .definition(Definition::new("double").over(&[&set]).unit("t"))
        .report(Definition::new("total").unit("t"))
        .equation(Equation::new("f").over(&[&set]).complements("x"))
        .build()
        .unwrap();
    let model = Doubled(shape);
    let solution = solve(&model, &Options::new(Method::NewtonMinFb)).unwrap();
    Report::new(&mut AdProblem::new(model).unwrap(), &solution).unwrap()
}

#[test]
fn reports_and_definitions_follow_the_solution() {
    let report = doubled(3);
    let rows: Vec<DerivedRow> = report.derived().collect();
    assert_eq!(rows[0].name, "total");
    assert_eq!((rows[0].kind, rows[0].value), (DerivedKind::Report, 6.0));
    assert_eq!(rows[3].name, "double[3]");
    assert_eq!((rows[3].kind, rows[3].value), (DerivedKind::Definition, 4.0));
    let text = report.to_string();
    let tail = text.split("\nreports\n").nth(1).unwrap();
    assert_eq!(
        tail,
        " name   value  unit\n total      6  t\n\ndefinitions\n name       value  unit\n \
         double[1]      0  t\n double[2]      2  t\n double[3]      4  t\n"
    );
}

#[test]
fn a_long_family_of_definitions_is_cut_and_says_so() {
    let text = doubled(53).to_string();
    assert!(text.contains("double[50]") && !text.contains("double[51]"));
    assert!(text.contains("… 3 of 53 `double`"), "{text}");
}

#[cfg(feature = "serde")]
#[test]
fn csv_and_json_have_them_all() {
    let report = doubled(53);
    let (mut csv, mut json) = (Vec::new(), Vec::new());
    report.write_csv(&mut csv).unwrap();
    report.write_json(&mut json).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    assert!(csv.contains("\ntotal,,2756,,,,report,t,\n"), "{csv}");
    assert!(csv.contains("\ndouble[53],,104,,,,definition,t,\n"));
    let json: serde_json::Value = serde_json::from_slice(&json).unwrap();
    assert_eq!(json["derived"][0]["name"], "total");
    assert_eq!(json["derived"][53]["kind"], "definition");
    assert_eq!(json["derived"][53]["value"], 104.0);
}
