use super::*;
use crate::model::{Block, Definition, Equation, Parameter, Set, Variable};
use crate::scalar::{external, sum};
use crate::solver::{Options, Solver};

/// `price = a − Σq` is a definition, `markup[i] = price · q[i]` another that reads it;
/// `F_i = c_i + q_i² − price + markup_i`, and one wide equation `s − Σ q_i³` for `s`.
struct Market {
    shape: Shape,
    n: usize,
}

fn market(n: usize) -> Market {
    let firms = Set::count("firms", n);
    let shape = Shape::builder()
        .variable(Variable::new("s").start(0.5))
        .variable(Variable::new("q").over(&[&firms]).lower(0.0).start(0.25))
        .equation(Equation::new("profit").over(&[&firms]).complements("q"))
        .equation(Equation::new("total").complements("s"))
        .definition(Definition::new("price"))
        .definition(Definition::new("markup").over(&[&firms]))
        .parameter(Parameter::new("a", 10.0))
        .parameter(
            Parameter::new("c", (0..n).map(|i| i as f64).collect::<Vec<_>>()).over(&[&firms]),
        )
        .build()
        .unwrap();
    Market { shape, n }
}

impl Model for Market {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn def<D: Scalar>(&self, family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.param(0) - sum(1..=self.n, |j| read.var(j)),
            _ => read.def(0) * read.var(1 + i),
        }
    }
    fn row<D: Scalar>(&self, family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 => read.param(1 + i) + read.var(1 + i).powi(2) - read.def(0) + read.def(1 + i),
            _ => read.var(0) - sum(1..=self.n, |j| read.var(j).powi(3)),
        }
    }
}

/// The same by hand: `(F, J)` with `J` dense, row by row.
fn by_hand(n: usize, z: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let price = 10.0 - z[1..].iter().sum::<f64>();
    let mut f = vec![z[0] - z[1..].iter().map(|q| q.powi(3)).sum::<f64>()];
    let mut first = vec![1.0];
    first.extend(z[1..].iter().map(|q| -3.0 * q * q));
    let mut jac = vec![first];
    for i in 0..n {
        let q = z[1 + i];
        f.push(i as f64 + q * q - price + price * q);
        let mut row = vec![0.0];
        row.extend((0..n).map(|j| 1.0 - q + if i == j { 2.0 * q + price } else { 0.0 }));
        jac.push(row);
    }
    (f, jac)
}

#[test]
fn rows_with_definitions_agree_with_the_formulas_at_every_lane_count() {
    for n in [1, 2, 3, 7, 15, 16, 17, 40] {
        let mut problem = AdProblem::new(market(n)).unwrap();
        let z: Vec<f64> = (0..=n).map(|j| 0.1 + j as f64 / 8.0).collect();
        let (mut f, mut jac) = (vec![0.0; n + 1], vec![0.0; problem.pattern().nnz()]);
        problem.evaluate(&z, Some(&mut f), Some(&mut jac));
        let (f_hand, jac_hand) = by_hand(n, &z);
        for i in 0..=n {
            assert!((f[i] - f_hand[i]).abs() <= 1e-13 * (1.0 + f_hand[i].abs()), "n = {n}, F_{i}");
            for j in 0..=n {
                let entry = problem.pattern().position(i, j).map_or(0.0, |k| jac[k]);
                assert!((entry - jac_hand[i][j]).abs() <= 1e-13, "n = {n}, J_{i}{j}");
            }
        }
        let mut second = AdProblem::with_engine(market(n), Engine::NumDual).unwrap();
        let mut jac_second = vec![0.0; jac.len()];
        second.evaluate(&z, None, Some(&mut jac_second));
        for (one, other) in jac.iter().zip(&jac_second) {
            assert!((one - other).abs() <= 1e-13, "n = {n}: engines differ");
        }
        let mut alone = vec![0.0; n + 1];
        problem.evaluate(&z, Some(&mut alone), None);
        assert_eq!(f, alone, "F alone has the same bits as F with J");
    }
}

#[test]
fn the_pattern_goes_through_definitions_and_leaves_out_what_is_not_read() {
    let problem = AdProblem::new(market(3)).unwrap();
    assert_eq!(problem.pattern().position(1, 0), None, "profit does not read s");
    assert!(problem.pattern().position(1, 3).is_some(), "profit reads q[3] through price");
    assert!(problem.pattern().position(0, 0).is_some());
    assert_eq!(problem.pattern().nnz(), 4 + 9);
}

#[test]
fn parameters_are_reads_and_can_be_changed_and_differentiated() {
    let mut problem = AdProblem::new(market(2)).unwrap();
    let z = [0.0, 1.0, 2.0];
    let mut f = [0.0; 3];
    problem.evaluate(&z, Some(&mut f), None);
    let before = f[1];
    // F_1 = c_1 + q² − price + price q with price = a − Σq: ∂F_1/∂a = q_1 − 1 = 0, ∂F_2/∂a = 1.
    let by_parameters = problem.parameter_jacobian(&z).unwrap();
    assert_eq!(by_parameters, [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
    problem.set_parameter("c", &[5.0, 0.0]).unwrap();
    problem.evaluate(&z, Some(&mut f), None);
    assert_eq!(f[1], before + 5.0);
}

struct Faulty(Shape, usize);

impl Model for Faulty {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn def<D: Scalar>(&self, _: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        read.def(index + self.1)
    }
    fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        read.var(self.1)
    }
}

#[test]
fn reads_that_point_nowhere_are_errors_with_names() {
    let one = || {
        Shape::builder()
            .variable(Variable::new("x"))
            .equation(Equation::new("balance").complements("x"))
    };
    let error = AdProblem::new(Faulty(one().build().unwrap(), 3)).err().unwrap();
    assert_eq!(error.to_string(), "`balance` reads variable number 3, but there are only 1");
    let shape = one().definition(Definition::new("cost")).build().unwrap();
    let error = AdProblem::new(Faulty(shape, 0)).err().unwrap();
    assert_eq!(error.to_string(), "definition `cost` reads `cost`, which is not defined before it");
}

struct Table(Shape);

impl Model for Table {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn def<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        external(&[read.var(1)], |v, gradient| {
            gradient[0] = 2.0 * v[0];
            v[0] * v[0]
        })
    }
    fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        if family == 0 { read.var(0) - 1.0 } else { read.def(0) * read.var(0) - 4.0 }
    }
}

#[test]
fn equations_with_external_functions_are_named_where_second_order_is_needed() {
    let shape = Shape::builder()
        .variable(Variable::new("x"))
        .variable(Variable::new("y").start(3.0))
        .equation(Equation::new("first").complements("x"))
        .equation(Equation::new("second").complements("y"))
        .definition(Definition::new("table"))
        .build()
        .unwrap();
    let mut problem = AdProblem::new(Table(shape)).unwrap();
    let error = problem.check_second_order().unwrap_err();
    assert_eq!(
        error.to_string(),
        "equation `second` calls an external function, which has no second derivatives"
    );
    let mut jac = vec![0.0; problem.pattern().nnz()];
    problem.evaluate(&[2.0, 3.0], None, Some(&mut jac));
    assert_eq!(jac[problem.pattern().position(1, 1).unwrap()], 12.0);
}

#[test]
fn operations_are_counted_with_definitions_once() {
    let problem = AdProblem::new(market(2)).unwrap();
    let counts = problem.operations();
    // price: 2 additions; markup: 2 products; profit: 3 additions and 1 product each;
    // total: 2 additions, 2 cubes of 2 products.
    assert_eq!((counts.additions, counts.multiplications), (2 + 6 + 2, 2 + 2 + 4));
    assert_eq!(counts.total(), counts.additions + counts.multiplications);
}

#[test]
fn a_fixed_variable_without_equation_has_an_empty_row() {
    let shape = Shape::builder()
        .variable(Variable::new("x").fixed(1.0))
        .variable(Variable::new("y"))
        .equation(Equation::new("balance").complements("y"))
        .build()
        .unwrap();
    let mut problem = AdProblem::new(Faulty(shape, 0)).unwrap();
    let (mut f, mut jac) = (vec![7.0; 2], vec![0.0; 1]);
    problem.evaluate(&[1.0, 5.0], Some(&mut f), Some(&mut jac));
    assert_eq!(f, [0.0, 1.0]);
    assert_eq!(problem.pattern().position(1, 0), Some(0));
}

/// Trade on some routes between two places: `cost_k + price − 2 ⟂ flow_k`, where `price` is the sum
/// of the flows into the destination, a definition with one element for each place.
struct Routes(Shape);

const PAIRS: Block<2> = Block::new(0, [2, 2]);

fn routes(only: &[usize]) -> Routes {
    let places = Set::new("places", ["a", "b"]).unwrap();
    let over = [&places, &places];
    let shape = Shape::builder()
        .variable(Variable::new("flow").over(&over).only(only).lower(0.0).start(0.5))
        .equation(Equation::new("profit").over(&over).only(only).complements("flow"))
        .definition(Definition::new("price").over(&[&places]))
        .parameter(Parameter::new("cost", vec![1.0; only.len()]).over(&over).only(only))
        .build()
        .unwrap();
    Routes(shape)
}

impl Model for Routes {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn def<D: Scalar>(&self, _: usize, to: usize, read: &Reader<'_, D>) -> Real<D> {
        let flow = &self.0.variables()[0];
        let routes = (0..2).filter_map(|from| flow.position(PAIRS.at([from, to])));
        routes.map(|k| read.var(k)).sum()
    }
    fn row<D: Scalar>(&self, _: usize, k: usize, read: &Reader<'_, D>) -> Real<D> {
        let [_, to] = PAIRS.split(self.0.variables()[0].combination(k));
        read.param(k) + read.def(to) - 2.0
    }
}

#[test]
fn a_model_with_absent_combinations_is_solved_and_read_by_name() {
    let mut problem = AdProblem::new(routes(&[1, 2])).unwrap();
    assert_eq!((problem.shape().n(), problem.pattern().nnz()), (2, 2));
    problem.set_parameter("cost", &[1.5, 3.0]).unwrap();
    let mut solver = Solver::new(Options::default()).unwrap();
    let solution = solver.solve(&mut problem).unwrap().clone().solved().unwrap();
    assert!((solution.level("flow[a, b]").unwrap() - 0.5).abs() < 1e-9);
    assert!((solution.marginal("flow[b, a]").unwrap() - 1.0).abs() < 1e-9);
    assert!(solution.level("flow[a, a]").is_err());

    let mut more = AdProblem::new(routes(&[0, 1])).unwrap();
    assert_eq!(more.start_from(&solution), Ok(1));
    assert_eq!(more.shape().start(), [0.5, solution.z[0]]);
}

#[test]
fn a_solution_keeps_the_shape_it_was_solved_with() {
    let mut problem = AdProblem::new(market(2)).unwrap();
    let mut solver = Solver::new(Options::default()).unwrap();
    let solution = solver.solve(&mut problem).unwrap().clone();
    assert!(Arc::ptr_eq(&solution.shape, problem.shape()));
    problem.set_parameter("a", &[20.0]).unwrap();
    assert_eq!(solution.shape.parameter_values()[0], 10.0);
    assert_eq!(problem.shape().parameter_values()[0], 20.0);
}

/// `F_x = x − 1`, which beyond a limit of `x` reads `y` as well.
struct Switch {
    shape: Shape,
    is_beyond: fn(f64) -> bool,
}

impl Model for Switch {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        let x = if family == 0 { read.var(0) } else { return read.var(1) - 2.0 };
        if (self.is_beyond)(x.into_scalar().value()) { x - read.var(1) } else { x - 1.0 }
    }
}

fn switch(is_beyond: fn(f64) -> bool) -> Switch {
    let shape = Shape::builder()
        .variable(Variable::new("x").lower(0.0).start(1.0))
        .variable(Variable::new("y"))
        .equation(Equation::new("f").complements("x"))
        .equation(Equation::new("g").complements("y"));
    Switch { shape: shape.build().unwrap(), is_beyond }
}

#[test]
fn a_row_that_reads_by_value_is_refused_with_its_name() {
    let varies = ModelError::ReadsVary { row: "f".to_owned(), read: "y".to_owned() };
    // Right above the start, right below it, far away.
    let limits: [fn(f64) -> bool; 3] = [|x| x > 1.0, |x| x < 1.0, |x| x > 4.0];
    for is_beyond in limits {
        assert_eq!(AdProblem::new(switch(is_beyond)).err(), Some(varies.clone()));
    }
    assert_eq!(AdProblem::new(switch(|_| false)).err(), None);
}

/// A definition `d = 2 x`, and `F_x = x − 1`, which reads `y` as well where `d` is above 2.
struct SwitchByDefinition(Shape);

impl Model for SwitchByDefinition {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn row<D: Scalar>(&self, family: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        match family {
            0 if read.def(0).into_scalar().value() > 2.0 => read.var(0) - read.var(1),
            0 => read.var(0) - 1.0,
            _ => read.var(1) - 2.0,
        }
    }
    fn def<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        2.0 * read.var(0)
    }
}

#[test]
fn a_row_that_reads_by_the_value_of_a_definition_is_refused() {
    let shape = Shape::builder()
        .variable(Variable::new("x").lower(0.0).start(1.0))
        .variable(Variable::new("y"))
        .equation(Equation::new("f").complements("x"))
        .equation(Equation::new("g").complements("y"))
        .definition(Definition::new("d"));
    let refused = AdProblem::new(SwitchByDefinition(shape.build().unwrap())).err();
    let varies = ModelError::ReadsVary { row: "f".to_owned(), read: "y".to_owned() };
    assert_eq!(refused, Some(varies));
}

#[test]
fn reads_given_by_hand_complete_the_pattern() {
    let mut problem = AdProblem::reading(switch(|x| x > 1.0), &[(0, 1)]).unwrap();
    assert_eq!(problem.pattern(), &Pattern::from_rows(&[vec![0, 1], vec![1]]));
    let mut jac = [0.0; 3];
    problem.evaluate(&[2.0, 5.0], None, Some(&mut jac));
    assert_eq!(jac, [1.0, -1.0, 1.0]);
    problem.evaluate(&[0.5, 5.0], None, Some(&mut jac));
    assert_eq!(jac, [1.0, 0.0, 1.0]);
    assert!(matches!(
        AdProblem::reading(switch(|x| x > 1.0), &[(0, 2)]).err(),
        Some(ModelError::Length { expected: 2, found: 3, .. })
    ));
}
