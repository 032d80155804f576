use crate::model::{Definition, Equation, Model, Parameter, Reader, Set, Shape, Variable};
use crate::problem::{AdProblem, Engine, Problem};
use crate::scalar::{Real, Scalar, sum};

/// Rows that mix constant and varying derivatives: of variables, of parameters times variables, and
/// through the definitions `mean = Σ x/n`, `share = tax mean`, `power = x₀ mean`.
struct Mixed {
    shape: Shape,
    n: usize,
}

fn mixed(n: usize) -> Mixed {
    let set = Set::count("set", n);
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&set]).start(0.5))
        .equation(Equation::new("f").over(&[&set]).complements("x"))
        .definition(Definition::new("mean"))
        .definition(Definition::new("share"))
        .definition(Definition::new("power"))
        .parameter(Parameter::new("tax", 0.0))
        .build()
        .unwrap();
    Mixed { shape, n }
}

impl Model for Mixed {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn def<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => sum(0..self.n, |j| read.var(j)) / self.n as f64,
            1 => read.param(0) * read.def(0),
            _ => read.var(0) * read.def(0),
        }
    }
    fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let (x, next) = (read.var(i), read.var((i + 1) % self.n));
        match i % 4 {
            0 => 3 * x - next + read.param(0) * next,
            1 => x * x + read.def(1) - 2 * read.def(0),
            2 => read.def(2) + read.def(0) * x + next,
            _ => read.def(2).exp() + read.def(1) + x,
        }
    }
}

fn jacobian(problem: &mut AdProblem<Mixed>, z: &[f64]) -> Vec<f64> {
    let mut jac = vec![f64::NAN; problem.pattern().nnz()];
    problem.evaluate(z, None, Some(&mut jac));
    jac
}

#[test]
fn constant_and_carried_derivatives_make_up_the_jacobian_at_every_point() {
    for n in [1, 2, 4, 12] {
        let mut problem = AdProblem::new(mixed(n)).unwrap();
        let mut second = AdProblem::with_engine(mixed(n), Engine::NumDual).unwrap();
        for (tax, by) in [(0.0, 0.3), (0.0, -0.7), (2.0, 0.4), (0.5, 1.1), (0.5, -0.2)] {
            problem.set_parameter("tax", &[tax]).unwrap();
            second.set_parameter("tax", &[tax]).unwrap();
            let z: Vec<f64> = (1..=n).map(|j| (j as f64 * by).sin()).collect();
            let (jac, reference) = (jacobian(&mut problem, &z), jacobian(&mut second, &z));
            for (one, other) in jac.iter().zip(&reference) {
                assert!(
                    (one - other).abs() <= 1e-14 * (1.0 + other.abs()),
                    "{n}, {tax}: {one} {other}"
                );
            }
        }
    }
}

#[test]
fn a_problem_without_memory_of_other_parameters_gives_the_same_bits() {
    let z = [0.1, 0.7, -0.3, 2.0];
    let mut changed = AdProblem::new(mixed(4)).unwrap();
    jacobian(&mut changed, &[0.5; 4]);
    changed.set_parameter("tax", &[0.3]).unwrap();
    let mut fresh = AdProblem::new(mixed(4)).unwrap();
    fresh.set_parameter("tax", &[0.3]).unwrap();
    assert_eq!(jacobian(&mut changed, &z), jacobian(&mut fresh, &z));
}

/// `F` has a kink that the row makes itself, by the value of `x`.
struct Looks(Shape);

impl Model for Looks {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        let (x, y) = (read.var(0), read.var(1));
        match family {
            0 if x.into_scalar().value() > 1.0 => 2 * x + y,
            0 => x + 3 * y,
            _ => y - 1,
        }
    }
}

#[test]
fn nothing_is_constant_in_a_row_that_looks_at_values() {
    let shape = Shape::builder()
        .variable(Variable::new("x").start(0.0))
        .variable(Variable::new("y"))
        .equation(Equation::new("f").complements("x"))
        .equation(Equation::new("g").complements("y"));
    let mut problem = AdProblem::new(Looks(shape.build().unwrap())).unwrap();
    let mut jac = [0.0; 4];
    assert_eq!(problem.pattern().nnz(), 4);
    problem.evaluate(&[2.0, 0.0], None, Some(&mut jac));
    assert_eq!(jac, [2.0, 0.0, 1.0, 1.0]);
    problem.evaluate(&[0.0, 0.0], None, Some(&mut jac));
    assert_eq!(jac, [1.0, 0.0, 3.0, 1.0]);
}
