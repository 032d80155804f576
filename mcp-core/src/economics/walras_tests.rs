use super::*;
use crate::model::{Equation, Reader, Set, Shape, Variable};
use crate::scalar::{Real, Scalar};
use crate::solver::{Options, solve, solve_from};

/// Two goods, endowments 1 and 2, half of the income `p₁ + 2 p₂ − leak` spent on each.
struct Exchange {
    shape: Shape,
    leak: f64,
}

fn exchange(leak: f64) -> Exchange {
    let goods = Set::new("goods", ["wheat", "iron"]).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("p").over(&[&goods]).lower(0.0).start(0.6))
        .equation(Equation::new("market").over(&[&goods]).complements("p"))
        .build()
        .unwrap();
    Exchange { shape, leak }
}

impl Model for Exchange {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        let income = read.var(0) + 2.0 * read.var(1) - self.leak;
        (1.0 + index as f64) - 0.5 * income / read.var(index)
    }
}

fn solved(leak: f64) -> WalrasCheck {
    let mut model = exchange(leak);
    model.shape.fix("p[wheat]", 1.0).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    check_walras(&model, &solution).unwrap()
}

#[test]
fn the_market_of_the_numeraire_clears() {
    let check = solved(0.0);
    assert_eq!(check.verdict(), Ok(()));
    assert_eq!((check.dropped.len(), check.dropped[0].equation.as_str()), (1, "market[wheat]"));
    assert!(
        check.to_string().starts_with("p[wheat] is fixed; market[wheat], which was dropped, is ")
    );
}

#[test]
fn income_that_leaks_is_found() {
    // Iron clears at p = (1 − leak)/2; of wheat (1 + 2p − leak)/2 = 1 − leak is demanded.
    let check = solved(0.1);
    assert!((check.dropped[0].f - 0.1).abs() < 1e-9);
    let told = check.verdict().unwrap_err().to_string();
    assert!(told.starts_with("the market of the numeraire does not clear: `market[wheat]` is "));
}

#[test]
fn without_a_numeraire_all_prices_can_move_together() {
    let model = exchange(0.0);
    let solution = solve_from(&model, &[1.0, 0.51], &Options::default()).unwrap();
    let told = check_walras(&model, &solution).unwrap().verdict().unwrap_err().to_string();
    assert_eq!(
        told,
        "all prices can move together: fix one; p[wheat], p[iron] keep their equations when they grow \
         in proportion"
    );
}

#[test]
fn money_that_is_fixed_in_the_model_is_a_numeraire_of_its_own() {
    let model = exchange(0.1);
    let mut other = exchange(0.1);
    other.shape.fix("p[wheat]", 1.0).unwrap();
    let solution = solve(&other, &Options::default()).unwrap();
    let verdict = check_walras(&model, &solution).unwrap().verdict();
    assert!(matches!(verdict, Err(NoWalras::Gap(_))), "{verdict:?}");
}

#[test]
fn nothing_is_said_of_a_point_that_is_no_solution() {
    let mut model = exchange(0.0);
    model.shape.fix("p[wheat]", 1.0).unwrap();
    let mut solution = solve(&model, &Options::default()).unwrap();
    solution.status = Status::IterationLimit;
    let verdict = check_walras(&model, &solution).unwrap().verdict();
    assert_eq!(verdict, Err(NoWalras::NotSolved { status: Status::IterationLimit }));
}

#[test]
fn an_equation_that_is_not_finite_does_not_hold() {
    let mut model = exchange(f64::INFINITY);
    model.shape.fix("p[wheat]", 1.0).unwrap();
    let mut other = exchange(0.0);
    other.shape.fix("p[wheat]", 1.0).unwrap();
    let solution = solve(&other, &Options::default()).unwrap().solved().unwrap();
    let check = check_walras(&model, &solution).unwrap();
    assert_eq!(check.dropped[0].relative, f64::INFINITY);
    assert!(matches!(check.verdict(), Err(NoWalras::Gap(_))));
}

#[test]
fn a_solution_of_another_model_is_refused() {
    let towns = Set::new("towns", ["paris", "rome"]).unwrap();
    let rents = Shape::builder()
        .variable(Variable::new("rent").over(&[&towns]).start(0.6))
        .equation(Equation::new("market").over(&[&towns]).complements("rent"))
        .build()
        .unwrap();
    let rents = solve(&Exchange { shape: rents, leak: 0.0 }, &Options::default()).unwrap();
    assert!(matches!(check_walras(&exchange(0.0), &rents), Err(ModelError::OtherModel { .. })));

    let mut other = solve(&exchange(0.0), &Options::default()).unwrap();
    other.z.pop();
    let told = check_walras(&exchange(0.0), &other).unwrap_err().to_string();
    assert_eq!(told, "the length of `levels of the solution` is 1, expected 2");
}
