use super::{Constraint, Kkt, Program};
use crate::scalar::{Real, Scalar, external, sum};
use crate::{
    AdProblem, Method, Model, ModelError, Options, Problem, Report, Set, Solution, Variable,
    check_derivatives, check_point, solve,
};

type Kind = fn(&'static str, f64) -> Constraint;

fn x(start: &[f64]) -> Variable {
    Variable::new("x").over(&[&Set::count("i", start.len())]).start(start)
}

fn solved<P: Program>(model: &Kkt<P>) -> Solution {
    let options = Options::new(Method::NewtonMinFb).with(|o| o.tol = Some(1e-12));
    solve(model, &options).unwrap().solved().unwrap()
}

fn assert_near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9, "{found} is not {expected}");
}

/// `J` at `z`, dense.
fn jacobian<P: Program>(model: &Kkt<P>, z: &[f64]) -> Vec<Vec<f64>> {
    let mut problem = AdProblem::new(model).unwrap();
    let mut values = vec![0.0; problem.pattern().nnz()];
    problem.evaluate(z, None, Some(&mut values));
    let mut dense = vec![vec![0.0; z.len()]; z.len()];
    for (k, i, j) in problem.pattern().entries() {
        dense[i][j] = values[k];
    }
    dense
}

/// Example 16.4 of [NW06]: `min (x1 − 1)² + (x2 − 2.5)²` under five inequalities.
struct Nocedal;

impl Program for Nocedal {
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
        (x[0] - 1).powi(2) + (x[1] - 2.5).powi(2)
    }
    fn constraint<D: Scalar>(&self, k: usize, x: &[Real<D>]) -> Real<D> {
        [x[0] - 2 * x[1] + 2, -x[0] - 2 * x[1] + 6, -x[0] + 2 * x[1] + 2][k]
    }
}

#[test]
fn a_published_quadratic_program_has_the_published_multiplier() {
    let mut model = Kkt::minimise(Nocedal).variable(x(&[2.0, 0.0]).lower(0.0));
    for name in ["left", "right", "below"] {
        model = model.constraint(Constraint::at_least(name, 0.0));
    }
    let model = model.build().unwrap();
    let solution = solved(&model);
    assert_near(solution.level("x[1]").unwrap(), 1.4);
    assert_near(solution.level("x[2]").unwrap(), 1.7);
    assert_near(solution.level("lambda[left]").unwrap(), 0.8);
    assert_near(solution.level("lambda[right]").unwrap(), 0.0);
    assert_near(solution.marginal("lambda[right]").unwrap(), 6.0 - 1.4 - 3.4);
    let report = Report::new(&mut AdProblem::new(&model).unwrap(), &solution).unwrap();
    assert!(report.to_string().contains("objective"));
    let shape = model.shape();
    assert_eq!(shape.equation_name(1), "dL/dx[2]");
    assert_eq!(shape.equation_name(3), "constraint[right]");
}

/// `x1² + 3 x2²` with `x1 + x2` bounded.
#[derive(Debug)]
struct Bowl;

impl Program for Bowl {
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
        x[0].powi(2) + 3 * x[1].powi(2)
    }
    fn constraint<D: Scalar>(&self, _k: usize, x: &[Real<D>]) -> Real<D> {
        x[0] + x[1]
    }
}

/// `min x1² + 3 x2²` on `x1 + x2 = b` is `¾ b²` at `(¾, ¼) b`, with the multiplier `1½ b`.
#[test]
fn a_multiplier_is_the_derivative_of_the_optimal_value_for_every_kind_of_constraint() {
    let binding: [(Kind, f64); 4] = [
        (Constraint::at_least, 2.0),
        (Constraint::at_most, -2.0),
        (Constraint::equal, 2.0),
        (Constraint::equal, -2.0),
    ];
    for (constraint, b) in binding {
        let model = Kkt::minimise(Bowl).variable(x(&[1.0, 1.0]));
        let model = model.constraint(constraint("sum", b)).build().unwrap();
        let solution = solved(&model);
        assert_near(solution.level("x[1]").unwrap(), 0.75 * b);
        assert_near(solution.level("lambda[sum]").unwrap(), 1.5 * b);
    }
    let slack: [(Kind, f64); 2] = [(Constraint::at_least, -2.0), (Constraint::at_most, 2.0)];
    for (constraint, b) in slack {
        let model = Kkt::minimise(Bowl).variable(x(&[1.0, 1.0]));
        let model = model.constraint(constraint("sum", b).start(1.0)).build().unwrap();
        let solution = solved(&model);
        assert_near(solution.level("x[1]").unwrap(), 0.0);
        assert_near(solution.level("lambda[sum]").unwrap(), 0.0);
    }
}

/// `max −(x1² + 3 x2²)`.
struct Dome;

impl Program for Dome {
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
        -Bowl.objective(x)
    }
    fn constraint<D: Scalar>(&self, k: usize, x: &[Real<D>]) -> Real<D> {
        Bowl.constraint(k, x)
    }
}

#[test]
fn so_it_is_where_the_objective_is_maximised() {
    let kinds: [(Kind, f64); 3] =
        [(Constraint::at_least, 2.0), (Constraint::at_most, -2.0), (Constraint::equal, 2.0)];
    for (constraint, b) in kinds {
        let model = Kkt::maximise(Dome).variable(x(&[1.0, 1.0]));
        let model = model.constraint(constraint("sum", b)).build().unwrap();
        let solution = solved(&model);
        assert_near(solution.level("x[2]").unwrap(), 0.25 * b);
        assert_near(solution.level("lambda[sum]").unwrap(), -1.5 * b);
    }
}

/// With `x1 <= u` the optimal value is `u² + 3 (2 − u)²`, with the derivative `8 u − 12`.
#[test]
fn a_marginal_is_the_derivative_of_the_optimal_value_by_the_bound() {
    for u in [0.0, 0.5, 1.0] {
        let model = Kkt::minimise(Bowl).variable(x(&[0.0, 0.0]).upper([u, f64::INFINITY]));
        let model = model.constraint(Constraint::at_least("sum", 2.0)).build().unwrap();
        assert_near(solved(&model).marginal("x[1]").unwrap(), 8.0 * u - 12.0);
        let model = Kkt::maximise(Dome).variable(x(&[0.0, 0.0]).upper([u, f64::INFINITY]));
        let model = model.constraint(Constraint::at_least("sum", 2.0)).build().unwrap();
        assert_near(solved(&model).marginal("x[1]").unwrap(), 8.0 * u - 12.0);
    }
}

/// Entropy under a curved constraint, a chain of products, a function of one variable.
struct Curved;

impl Program for Curved {
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
        sum(x, |&x| x.xlogx()) + (x[0] * x[1]).sqrt() / x[2]
    }
    fn constraint<D: Scalar>(&self, k: usize, x: &[Real<D>]) -> Real<D> {
        match k {
            0 => x[0].pow(x[1]) + x[2].exp() * x[3],
            1 => (x[1] / x[2]).atan(),
            _ => x[3].powi(3),
        }
    }
}

fn curved() -> Kkt<Curved> {
    let model = Kkt::minimise(Curved).variable(x(&[0.5, 1.5, 0.8, 2.0]).lower(1e-3));
    let model = model.constraint(Constraint::at_least("mixed", 1.0).start(0.7));
    let model = model.constraint(Constraint::equal("angle", 0.5).start(-0.4));
    model.constraint(Constraint::at_most("cube", 9.0).start(-1.3)).build().unwrap()
}

#[test]
fn second_derivatives_agree_with_another_arithmetic_and_with_differences() {
    let model = curved();
    let report = check_derivatives(&model, model.shape().start()).unwrap().verdict().unwrap();
    // Neither f nor a constraint has a term of x1 and x4, or x2 and x4, together: zeros.
    assert_eq!((report.kinks, report.beyond_domain, report.drowned), (0, 0, 4), "{report}");
    assert_eq!(report.entries, 4 * 4 + 2 * (4 + 2 + 1));
}

/// `J = [H, −Aᵀ; A, 0]` with a symmetric `H`; all of it negated where the program maximises.
#[test]
fn the_jacobian_is_the_hessian_of_the_lagrangian_beside_the_gradients_of_the_constraints() {
    let model = curved();
    let z = model.shape().start().to_vec();
    let j = jacobian(&model, &z);
    for row in 0..4 {
        for column in 0..4 {
            assert!((j[row][column] - j[column][row]).abs() < 1e-13, "({row}, {column})");
        }
        for k in 4..7 {
            assert_eq!(j[row][k], -j[k][row]);
        }
    }
    // ∂²L/∂x4² = 1/x4 − λ_cube 6 x4, with λ_cube = −1.3 and x4 = 2.
    assert!((j[3][3] - (0.5 + 1.3 * 12.0)).abs() < 1e-13);
    assert_eq!(j[6][3], 12.0);
    let maximised = Kkt::maximise(Curved).variable(x(&[0.5, 1.5, 0.8, 2.0]).lower(1e-3));
    let maximised = ["a", "b", "c"]
        .into_iter()
        .fold(maximised, |model, name| model.constraint(Constraint::equal(name, 0.0)));
    let negated = jacobian(&maximised.build().unwrap(), &z);
    assert!(j.iter().flatten().zip(negated.iter().flatten()).all(|(a, b)| *a == -b));
}

/// `x_1²` under constraints on the products of neighbours.
struct Chain;

impl Program for Chain {
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
        x[0].powi(2)
    }
    fn constraint<D: Scalar>(&self, k: usize, x: &[Real<D>]) -> Real<D> {
        x[k] * x[k + 1]
    }
}

#[test]
fn a_row_reads_only_what_its_functions_use() {
    let n = 300; // more than one window of the tracer
    let mut model = Kkt::minimise(Chain).variable(x(&vec![1.0; n]));
    for k in 1..n {
        model = model.constraint(Constraint::at_least(format!("{k}"), 1.0));
    }
    let model = model.build().unwrap();
    let problem = AdProblem::new(&model).unwrap();
    let of_slopes = 3 * n - 2 + 2 * (n - 1);
    assert_eq!(problem.pattern().nnz(), of_slopes + 2 * (n - 1));
    // At x = 1, λ_1 = 2: ∂L/∂x_1 = 2 x_1 − λ_1 x_2 = 0 and ∂L/∂x_2 = −λ_1 x_1 = −2.
    let z: Vec<f64> = [vec![1.0; n], vec![2.0], vec![0.0; n - 2]].concat();
    let check = check_point(&model, &z).unwrap();
    let violated: Vec<String> = check.violated().filter_map(|row| row.equation).collect();
    assert_eq!(violated, ["dL/dx[2]"]);
}

#[test]
fn the_right_hand_side_is_a_parameter() {
    let model = Kkt::minimise(Bowl).variable(x(&[1.0, 1.0]));
    let model = model.constraint(Constraint::equal("sum", 2.0)).build().unwrap();
    let mut problem = AdProblem::new(&model).unwrap();
    let mut f = [0.0; 3];
    problem.evaluate(&[1.0, 1.0, 0.0], Some(&mut f), None);
    assert_eq!(f, [2.0, 6.0, 0.0]);
    problem.set_parameter("rhs[sum]", &[5.0]).unwrap();
    problem.evaluate(&[1.0, 1.0, 0.0], Some(&mut f), None);
    assert_eq!(f, [2.0, 6.0, -3.0]);
}

#[test]
fn names_are_checked() {
    let twice = Kkt::minimise(Bowl).variable(x(&[0.0; 2]));
    let twice = twice.constraint(Constraint::equal("sum", 0.0));
    let error = twice.constraint(Constraint::equal("sum", 1.0)).build().unwrap_err();
    assert_eq!(error.to_string(), "set `constraints` has the label `sum` twice");
    let taken = Kkt::minimise(Bowl).variable(Variable::new("lambda").over(&[&Set::count("i", 2)]));
    let error = taken.build().unwrap_err();
    assert_eq!(error, ModelError::DuplicateName { name: "lambda".to_owned() });
}

#[test]
fn variables_of_several_families_are_one_list_under_their_own_names() {
    let model = Kkt::minimise(Bowl)
        .variable(Variable::new("work").lower(1.0))
        .variable(Variable::new("capital").lower(2.0))
        .build()
        .unwrap();
    let solution = solved(&model);
    assert_near(solution.level("work").unwrap(), 1.0);
    assert_near(solution.marginal("capital").unwrap(), 12.0);
    assert_eq!(model.shape().equation_name(1), "dL/dcapital");
}

/// A function that tells only its gradient.
struct Told;

impl Program for Told {
    fn objective<D: Scalar>(&self, x: &[Real<D>]) -> Real<D> {
        external(&[x[0]], |x, gradient| {
            gradient[0] = 2.0 * x[0];
            x[0] * x[0]
        })
    }
}

#[test]
fn an_external_function_has_no_second_derivatives() {
    let model = Kkt::minimise(Told).variable(x(&[3.0])).build().unwrap();
    assert!(jacobian(&model, &[3.0])[0][0].is_nan());
}
