use super::*;
use crate::model::{Equation, Reader, Set, Variable};
use crate::scalar::{Real, Scalar};

/// Two goods and a wage; `wrong` adds a payment of fixed money.
struct Exchange {
    shape: Shape,
    wrong: f64,
}

fn exchange(wrong: f64) -> Exchange {
    let goods = Set::new("goods", ["wheat", "iron"]).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("p").over(&[&goods]).lower(0.0).start(1.0))
        .variable(Variable::new("m").start(2.0))
        .variable(Variable::new("x").over(&[&goods]).lower(0.0))
        .equation(Equation::new("market").over(&[&goods]).complements("p"))
        .equation(Equation::new("income").complements("m"))
        .equation(Equation::new("demand").over(&[&goods]).complements("x"))
        .build()
        .unwrap();
    Exchange { shape, wrong }
}

impl Model for Exchange {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        let (p, m, x) = (|k| read.var(k), read.var(2), |k| read.var(3 + k));
        match family {
            0 => 1.0 - x(index),
            1 => m - p(0) - p(1) - if index == 0 { self.wrong } else { 0.0 },
            _ => x(index) - 0.5 * m / p(index),
        }
    }
}

#[test]
fn values_have_degree_one_and_quantities_degree_zero() {
    let check = check_homogeneous(&exchange(0.0), &["p", "m"]).unwrap();
    assert_eq!(check.verdict(), Ok(()));
    let degrees: Vec<Option<i32>> = check.degrees.iter().map(|(_, degree)| *degree).collect();
    assert_eq!(degrees, [Some(0), Some(0), Some(1), Some(0), Some(0)]);
    assert_eq!(
        check.to_string(),
        "scaled together: p, m\n  market (2): degree 0\n  income (1): degree 1\n  \
         demand (2): degree 0\n"
    );
}

#[test]
fn a_payment_of_fixed_money_is_found() {
    let check = check_homogeneous(&exchange(0.1), &["p", "m"]).unwrap();
    assert_eq!(
        check.verdict().unwrap_err().to_string(),
        "equation `income` is not homogeneous in p, m: it reads something in units of money that \
         does not move with them"
    );
    assert!(check.to_string().contains("income: not homogeneous"));
}

#[test]
fn a_forgotten_income_is_found() {
    let check = check_homogeneous(&exchange(0.0), &["p"]).unwrap();
    assert_eq!(check.verdict().unwrap_err().equation, "income");
    assert_eq!(
        check_homogeneous(&exchange(0.0), &["money"]).unwrap_err().to_string(),
        "there is no variable `money`"
    );
}

#[test]
fn an_equation_that_is_not_finite_has_no_degree() {
    struct Overflow(Shape);
    impl Model for Overflow {
        fn shape(&self) -> &Shape {
            &self.0
        }
        fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
            (2000.0 * read.var(0)).exp()
        }
    }
    let shape = Shape::builder()
        .variable(Variable::new("p").start(1.0))
        .equation(Equation::new("f").complements("p"))
        .build()
        .unwrap();
    // Euler's identity reads inf = k inf.
    assert_eq!(check_homogeneous(&Overflow(shape), &["p"]).unwrap().degrees[0].1, None);
}

#[test]
fn a_fixed_numeraire_is_scaled_too() {
    let mut model = exchange(0.0);
    model.shape.fix("p[wheat]", 1.0).unwrap();
    assert_eq!(check_homogeneous(&model, &["p", "m"]).unwrap().verdict(), Ok(()));
}
