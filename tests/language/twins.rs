//! A part that is off costs nothing: the model has the unknowns, the nonzeros, the operations and the
//! iterates of a text, or of a program by hand, that never heard of it.

use super::economy::{
    DIRT, LIMIT, MOST, cap, cap_quota, full, plain, quota, tax, tax_cap, tax_quota,
};
use mcp_core::{
    AdProblem, Definition, Equation, Iteration, Method, Model, OperationCounts, Options, Parameter,
    Pattern, Problem, Reader, Real, Scalar, Set, Shape, Solver, Variable, sum,
};
use std::ops::ControlFlow;

/// Everything about a model that a part could change.
#[derive(Debug, PartialEq)]
struct Footprint {
    names: Vec<(String, String)>,
    pattern: Pattern,
    operations: OperationCounts,
    jacobian_operations: u64,
    /// Bits of every iterate of every method, and of `F` there.
    iterates: Vec<Vec<u64>>,
}

fn footprint(model: &impl Model) -> Footprint {
    let shape = model.shape();
    let mut problem = AdProblem::new(model).unwrap();
    let mut iterates = Vec::new();
    for method in [Method::NewtonFb, Method::NewtonMinFb, Method::OldFb, Method::Robust] {
        let mut note = |iteration: &Iteration<'_>| {
            let numbers = iteration.z.iter().chain(iteration.f);
            iterates.push(numbers.map(|number| number.to_bits()).collect());
            ControlFlow::Continue(())
        };
        let mut solver = Solver::new(Options::new(method)).unwrap();
        let solution = solver.solve_monitored(&mut problem, None, &mut note).unwrap();
        assert!(method != Method::Robust || solution.is_solved());
    }
    Footprint {
        names: (0..shape.n()).map(|j| (shape.variable_name(j), shape.equation_name(j))).collect(),
        pattern: problem.pattern().clone(),
        operations: problem.operations(),
        jacobian_operations: problem.jacobian_operations().unwrap(),
        iterates,
    }
}

/// The model with these parts on is that of the text without the others.
macro_rules! twin {
    ($of:ident, $($part:expr),*) => {{
        let on = full::economy().with(($({ use full::*; $part },)*)).unwrap();
        let twin = $of::economy().with(($({ use $of::*; $part },)*)).unwrap();
        assert_eq!(footprint(&on), footprint(&twin));
    }};
}

#[test]
fn with_all_parts_off_the_model_is_that_without_them() {
    assert_eq!(footprint(&full::economy()), footprint(&plain::economy()));
    assert_eq!(footprint(&full::economy().with(()).unwrap()), footprint(&plain::economy()));
}

#[test]
fn a_part_that_is_on_leaves_its_print() {
    let base = footprint(&full::economy());
    let cap = footprint(&full::economy().with(full::Cap { limit: LIMIT, dirt: DIRT }).unwrap());
    assert_eq!((base.names.len(), cap.names.len()), (5, 6));
    let tax = footprint(&full::economy().with(full::Tax).unwrap());
    assert_eq!((&tax.names, &tax.pattern), (&base.names, &base.pattern));
    assert!(tax.operations.multiplications == base.operations.multiplications + 2 + 4);
    assert!(tax.jacobian_operations > base.jacobian_operations);
    assert_ne!(tax.iterates, base.iterates);
}

#[test]
fn with_one_part_on_the_others_cost_nothing() {
    twin!(tax, Tax);
    twin!(cap, Cap { limit: LIMIT, dirt: DIRT });
    twin!(quota, Quota { most: MOST });
}

#[test]
fn with_two_parts_on_the_third_costs_nothing() {
    twin!(tax_cap, Cap { limit: LIMIT, dirt: DIRT }, Tax);
    twin!(tax_quota, Tax, Quota { most: MOST });
    twin!(cap_quota, Quota { most: MOST }, Cap { limit: LIMIT, dirt: DIRT });
}

#[test]
fn whatever_the_order_of_the_caller_the_bits_are_the_same() {
    use full::{Cap, Quota, Tax, economy};
    let (cap, quota) = (Cap { limit: LIMIT, dirt: DIRT }, Quota { most: MOST });
    let first = economy().with((Tax, cap.clone(), quota.clone())).unwrap();
    let expected = footprint(&first);
    let second = economy().with((quota.clone(), cap.clone(), Tax)).unwrap();
    assert_eq!(footprint(&second), expected);
    let third = economy().with(quota).unwrap().with(Tax).unwrap().with(cap).unwrap();
    assert_eq!(footprint(&third), expected);
}

const COST: [f64; 2] = [1.0, 2.0];
const SLOPE: [f64; 2] = [0.5, 0.25];
const DEMAND: [f64; 2] = [10.0, 12.0];

/// The families of the economy without parts.
fn families(goods: &Set) -> mcp_core::ShapeBuilder {
    let over = [goods];
    Shape::builder()
        .variable(Variable::new("y").over(&over).lower(0.0).start(1.0))
        .variable(Variable::new("p").over(&over).lower(0.0).start(1.0))
        .variable(Variable::new("income").start(10.0))
        .equation(Equation::new("profit").over(&over).complements("y"))
        .equation(Equation::new("market").over(&over).complements("p"))
        .equation(Equation::new("earned").complements("income"))
        .definition(Definition::new("price").over(&over))
        .definition(Definition::new("unit_cost").over(&over))
}

fn goods() -> Set {
    Set::new("goods", ["bread", "steel"]).unwrap()
}

/// The economy without parts.
struct Plain(Shape);

/// `y`, `p`, `income`; definitions `price` and `unit_cost`.
impl Model for Plain {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, family: usize, g: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.def(2 + g) - read.var(2 + g),
            1 => read.var(g) - (DEMAND[g] - read.def(g)),
            _ => read.var(4) - sum(0..2, |g| read.var(2 + g) * read.var(g)),
        }
    }
    fn def<D: Scalar>(&self, family: usize, g: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.var(2 + g),
            _ => COST[g] + SLOPE[g] * read.var(g),
        }
    }
}

#[test]
fn by_hand_without_parts() {
    let twin = Plain(families(&goods()).build().unwrap());
    assert_eq!(footprint(&full::economy()), footprint(&twin));
}

/// The economy with a cap on steel: `y`, `p`, `income`, `permit`.
struct Capped(Shape);

impl Model for Capped {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, family: usize, g: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.def(2 + g) - read.var(2 + g),
            1 => read.var(g) - (DEMAND[g] - read.def(g)),
            2 => {
                let sales = read.var(4) - sum(0..2, |g| read.var(2 + g) * read.var(g));
                sales + -read.var(5) * LIMIT
            }
            _ => LIMIT - sum(1..2, |g| DIRT * read.var(g)),
        }
    }
    fn def<D: Scalar>(&self, family: usize, g: usize, read: &Reader<'_, D>) -> Real<D> {
        match (family, g) {
            (0, _) => read.var(2 + g),
            (_, 0) => COST[0] + SLOPE[0] * read.var(0),
            _ => COST[1] + SLOPE[1] * read.var(1) + DIRT * read.var(5),
        }
    }
}

#[test]
fn by_hand_with_the_cap() {
    let shape = families(&goods())
        .variable(Variable::new("permit").lower(0.0))
        .equation(Equation::new("within").complements("permit"))
        .build()
        .unwrap();
    let on = full::economy().with(full::Cap { limit: LIMIT, dirt: DIRT }).unwrap();
    assert_eq!(footprint(&on), footprint(&Capped(shape)));
}

/// The economy with the tax and quotas: `y`, `p`, `income`, `rent`; the parameter `rate`.
struct TaxedWithQuotas(Shape);

impl Model for TaxedWithQuotas {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, family: usize, g: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.def(2 + g) - read.var(2 + g) + read.var(5 + g),
            1 => read.var(g) - (DEMAND[g] - read.def(g)),
            2 => {
                let sales = read.var(4) - sum(0..2, |g| read.var(2 + g) * read.var(g));
                let taxes = sum(0..2, |g| read.param(g) * read.var(2 + g) * read.var(g));
                let rents = sum(0..2, |g| read.var(5 + g) * read.var(g));
                sales + -taxes + -rents
            }
            _ => MOST[g] - read.var(g),
        }
    }
    fn def<D: Scalar>(&self, family: usize, g: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.var(2 + g) + read.param(g) * read.var(2 + g),
            _ => COST[g] + SLOPE[g] * read.var(g),
        }
    }
}

#[test]
fn by_hand_with_the_tax_and_quotas() {
    let goods = goods();
    let shape = families(&goods)
        .variable(Variable::new("rent").over(&[&goods]).lower(0.0))
        .equation(Equation::new("under").over(&[&goods]).complements("rent"))
        .parameter(Parameter::new("rate", [0.25; 2]).over(&[&goods]))
        .build()
        .unwrap();
    let on = full::economy().with((full::Quota { most: MOST }, full::Tax)).unwrap();
    assert_eq!(footprint(&on), footprint(&TaxedWithQuotas(shape)));
}
