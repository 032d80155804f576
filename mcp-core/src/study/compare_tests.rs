use super::*;
use crate::model::{Definition, Equation, Model, Reader, Set, Variable};
use crate::problem::AdProblem;
use crate::scalar::{Real, Scalar};
use crate::solver::{Options, solve};

/// `x_i = i + 1 + shift`, and their sum as a report.
struct Levels {
    shape: Shape,
    shift: f64,
}

impl Model for Levels {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        read.var(index) - (index as f64 + self.shift)
    }
    fn report(&self, _: usize, _: usize, read: &Reader<'_, f64>) -> Real<f64> {
        read.var(0) + read.var(1)
    }
}

fn levels(labels: [&str; 2], shift: f64) -> Levels {
    let goods = Set::new("goods", labels).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&goods]).unit("t"))
        .equation(Equation::new("f").over(&[&goods]).complements("x"))
        .report(Definition::new("total").unit("t"))
        .build()
        .unwrap();
    Levels { shape, shift }
}

fn report(model: &Levels) -> Report {
    let solution = solve(model, &Options::default()).unwrap().solved().unwrap();
    Report::new(&mut AdProblem::new(model).unwrap(), &solution).unwrap()
}

#[test]
fn the_largest_change_in_percent_comes_first() {
    let changes = compare(&report(&levels(["a", "b"], 1.0)), &report(&levels(["a", "b"], 1.5)));
    let names: Vec<&str> = changes.rows.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(names, ["x[a]", "total", "x[b]"]);
    assert!((changes.get("total").unwrap().percent() - 100.0 / 3.0).abs() < 1e-9);
    assert_eq!(
        changes.to_string(),
        " name   before  after  change       %  unit\n \
         x[a]        1    1.5     0.5  +50.00  t\n \
         total       3    4       1    +33.33  t\n \
         x[b]        2    2.5     0.5  +25.00  t\n"
    );
}

#[test]
fn what_does_not_change_is_counted_and_zero_has_no_percentage() {
    let changes = compare(&report(&levels(["a", "b"], 0.0)), &report(&levels(["a", "b"], 0.0)));
    assert_eq!(changes.to_string().lines().last(), Some(" unchanged: 3"));
    let changes = compare(&report(&levels(["a", "b"], 0.0)), &report(&levels(["a", "b"], 1.0)));
    assert_eq!(changes.rows[0].name, "x[a]");
    assert!(changes.to_string().contains("new"), "{changes}");
    let fall =
        Change { name: "y".into(), before: -2.0, after: -3.0, unit: String::new(), size: 3.0 };
    assert_eq!(fall.percent(), -50.0);
    let change = |before, after| Change { before, after, ..fall.clone() };
    let inf = f64::INFINITY;
    assert!(!change(inf, inf).is_change() && change(inf, -inf).is_change());
    assert!(change(1.0, f64::NAN).is_change());
}

#[test]
fn numbers_of_one_side_only_have_dashes() {
    let changes = compare(&report(&levels(["a", "b"], 1.0)), &report(&levels(["b", "c"], 1.0)));
    let only = |lone: &[Lone]| (lone.len(), lone[0].name.clone(), lone[0].value.round());
    assert_eq!(only(&changes.only_before), (1, "x[a]".to_owned(), 1.0));
    assert_eq!(only(&changes.only_after), (1, "x[c]".to_owned(), 2.0));
    assert_eq!(
        changes.to_string(),
        " name  before  after  change       %  unit\n \
         x[b]       2      1      -1  -50.00  t\n \
         x[a]       1      -       -    -     t\n \
         x[c]       -      2       -    -     t\n \
         unchanged: 1\n"
    );
}

/// `x_i = i + shift` over so many goods from number `first` on.
fn many(first: usize, count: usize, shift: f64) -> Report {
    let goods = Set::new("goods", (first..first + count).map(|k| k.to_string())).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&goods]))
        .equation(Equation::new("f").over(&[&goods]).complements("x"))
        .build()
        .unwrap();
    report(&Levels { shape, shift: shift + first as f64 })
}

#[test]
fn names_of_one_side_are_listed_however_many_numbers_changed() {
    let changes = compare(&many(0, 100, 1.0), &many(20, 100, 2.0));
    let counts = [changes.rows.len(), changes.only_before.len(), changes.only_after.len()];
    assert_eq!(counts, [80, 20, 20]);
    let text = changes.to_string();
    let alone = text.lines().filter(|line| line.contains(" - "));
    assert_eq!(alone.count(), 40);
    assert_eq!(text.lines().filter(|line| line.contains("x[")).count(), 50 + 40);
    assert!(text.contains("\n … and 30 more that changed\n x[0] "), "{text}");
}

#[test]
fn names_of_one_side_beyond_fifty_are_counted() {
    let text = compare(&many(0, 40, 1.0), &many(100, 60, 1.0)).to_string();
    assert_eq!(text.lines().filter(|line| line.contains(" - ")).count(), 50);
    assert!(text.ends_with(" … and 50 more that only one has\n"), "{text}");
}

#[test]
fn solutions_have_variables_only() {
    let [one, two] = [1.0, 2.0].map(|shift| report(&levels(["a", "b"], shift)));
    let changes = compare(one.solution(), &two);
    assert_eq!(changes.rows.len(), 2);
    assert_eq!(changes.get("totl").unwrap_err().to_string(), "there is no number `totl`");
    assert!(changes.only_after.is_empty());
}

#[cfg(feature = "serde")]
#[test]
fn csv_has_every_row() {
    let changes = compare(&report(&levels(["a", "b"], 1.0)), &report(&levels(["a", "b"], 1.0)));
    let mut out = Vec::new();
    changes.write_csv(&mut out).unwrap();
    let text = String::from_utf8(out).unwrap();
    assert!(text.starts_with("name,before,after,change,percent,unit\n"));
    assert_eq!(text.lines().count(), 4);
}
