//! Scenes against models written by hand that know their own effects and no other.

use super::files::scene::Scene;
use super::scene;
use mcp_core::dynamics::{StepSize, step_options};
use mcp_core::{
    AdProblem, Equation, Model, ModelError, Problem, Reader, Real, Scalar, Shape, Solver, Variable,
};

/// `u° + r/m ⟂ r >= 0`: a ball on a floor, without restitution and friction.
struct Touch {
    shape: Shape,
    free: f64,
}

impl Model for Touch {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        self.free + INVERSE_MASS * read.var(0)
    }
}

const INVERSE_MASS: f64 = 1.0;

fn touch(free: f64) -> Result<AdProblem<Touch>, ModelError> {
    let shape = Shape::builder()
        .variable(Variable::new("r").lower(0.0))
        .equation(Equation::new("impact").complements("r"))
        .build()?;
    AdProblem::new(Touch { shape, free })
}

/// A rolling ball: normal impulse, and friction within `±μ r`.
struct Roll {
    shape: Shape,
    free: [f64; 2],
}

/// `1/m` and `1/m + R²/I` of the ball of the scene.
const ROLLING: f64 = 1.0 + 0.5 * 0.5 / 0.1;

impl Model for Roll {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, law: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        let (rn, rt) = (read.var(0), read.var(1));
        // Normal and tangent of a disc are orthogonal, but a scene does not know: M₁₂ = 0 is data.
        if law == 0 {
            self.free[0] + (1.0 * rn + 0.0 * rt)
        } else {
            let slip = self.free[1] + (0.0 * rn + ROLLING * rt);
            let limit = 0.1 * rn;
            rt - (rt - 1.0 / ROLLING * slip).clamp(-limit, limit)
        }
    }
}

fn roll(free: [f64; 2]) -> Result<AdProblem<Roll>, ModelError> {
    let shape = Shape::builder()
        .variable(Variable::new("rn").lower(0.0))
        .variable(Variable::new("rt"))
        .equation(Equation::new("impact").complements("rn"))
        .equation(Equation::new("slip").complements("rt"))
        .build()?;
    AdProblem::new(Roll { shape, free })
}

/// `x° + 2 h λ`, λ in [−1, 1]: two relays with an integrator each.
struct Relays {
    shape: Shape,
    free: [f64; 2],
}

impl Model for Relays {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, k: usize, _: usize, read: &Reader<'_, D>) -> Real<D> {
        self.free[k] + 0.002 * read.var(k)
    }
}

fn relays(free: [f64; 2]) -> Result<AdProblem<Relays>, ModelError> {
    let relay = |name: &str| Variable::new(name).lower(-1.0).upper(1.0);
    let shape = Shape::builder()
        .variable(relay("s1"))
        .variable(relay("s2"))
        .equation(Equation::new("y1").complements("s1"))
        .equation(Equation::new("y2").complements("s2"))
        .build()?;
    AdProblem::new(Relays { shape, free })
}

/// Size of a problem with the operations of the free motion beside it.
fn size(problem: &AdProblem<impl Model>, free: u64) -> (usize, usize, u64) {
    let operations = problem.operations().total() + free;
    (problem.shape().n(), problem.pattern().nnz(), operations)
}

fn parts(size: StepSize) -> (usize, usize, u64) {
    (size.unknowns, size.nonzeros, size.operations)
}

/// `v° = v − h g`, one operation.
const FALL: u64 = 1;

#[test]
fn a_ball_with_gravity_and_contact_is_the_model_of_these_two() {
    let text = super::text_of("bouncing_ball").replace(", \"restitution\"", "");
    let mut scene = Scene::parse("ball", &text).unwrap();
    let mut solver = Solver::new(step_options()).unwrap();
    let (h, g, mut q, mut v, mut r) = (0.005, 9.81, 1.0_f64, 0.0_f64, 0.0);
    for _ in 0..1000 {
        let report = scene.stepper.step().unwrap();
        let free = v + h * -g;
        let (mut next, mut reaction) = (free, 0.0);
        if q + 0.5 * h * v <= 0.0 {
            let mut problem = touch(free).unwrap();
            assert_eq!(parts(scene.stepper.size()), size(&problem, FALL));
            let solution = solver.solve_from(&mut problem, &[r]).unwrap();
            assert_eq!(report.iterations, solution.stats.iterations);
            reaction = solution.z[0];
            next = free + INVERSE_MASS * reaction;
        } else {
            assert_eq!(parts(scene.stepper.size()), (0, 0, FALL));
        }
        q += h * (0.5 * next + 0.5 * v);
        (v, r) = (next, reaction);
        assert_eq!(scene.stepper.state(), [q, v, r], "t = {}", report.time);
    }
}

#[test]
fn a_ball_with_friction_is_the_model_of_its_effects() {
    let mut scene = scene("ball_with_friction");
    let mut compared = 0;
    for _ in 0..scene.steps {
        let before = scene.stepper.state();
        let report = scene.stepper.step().unwrap();
        if report.unknowns == 0 {
            assert_eq!(parts(scene.stepper.size()), (0, 0, FALL));
            continue;
        }
        let (vx, vy, omega) = (before[1], before[3], before[5]);
        let fall = vy - 0.005 * 9.81;
        let mut problem = roll([fall + 0.9 * vy, vx + 0.5 * omega]).unwrap();
        assert_eq!(parts(scene.stepper.size()), size(&problem, FALL));
        let mut solver = Solver::new(step_options()).unwrap();
        let solution = solver.solve_from(&mut problem, &before[6..]).unwrap();
        let state = scene.stepper.state();
        for (a, b) in solution.z.iter().zip(&state[6..]) {
            assert!((a - b).abs() <= 1e-12, "{a} {b}");
        }
        compared += 1;
    }
    assert!(compared > 100, "{compared}");
}

#[test]
fn two_relays_are_the_model_of_two_relays() {
    let mut scene = scene("two_relays");
    let mut solver = Solver::new(step_options()).unwrap();
    let (mut x, mut lambda) = ([1.0, -1.0], vec![0.0, 0.0]);
    for _ in 0..scene.steps {
        let report = scene.stepper.step().unwrap();
        let mut problem = relays(x).unwrap();
        // x° = x and y = x°: their rows are products by 1, one each.
        assert_eq!(parts(scene.stepper.size()), size(&problem, 4));
        let solution = solver.solve_from(&mut problem, &lambda).unwrap();
        assert_eq!(report.iterations, solution.stats.iterations);
        lambda.clone_from(&solution.z);
        for (x, lambda) in x.iter_mut().zip(&lambda) {
            *x += 0.002 * lambda;
        }
        assert_eq!(scene.stepper.state(), [x[0], x[1], lambda[0], lambda[1]]);
    }
}

#[test]
fn a_circuit_without_its_diode_is_an_oscillator() {
    let text = super::text_of("rlc_diode").replace("[\"diode\"]", "[]");
    let mut scene = Scene::parse("rlc", &text).unwrap();
    // Each of the two states reads both: four products, two sums.
    assert_eq!(parts(scene.stepper.size()), (0, 0, 6));
    let energy = scene.stepper.energy().unwrap();
    for _ in 0..500 {
        assert_eq!(scene.stepper.step().unwrap().unknowns, 0);
    }
    let change = scene.stepper.energy().unwrap() / energy - 1.0;
    assert!(change.abs() < 1e-9, "{change:e}"); // θ is ½ + 1e-13
}
