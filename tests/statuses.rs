//! Every way a solve can end, reached; what it says; and what is refused before iteration 0.

mod common;

use common::{
    FREE, INF, NONNEGATIVE, affine, check_honest, dense, scalar, solve, solve_from, watch,
};
use mcp_core::{
    AdProblem, Diagnosis, Iteration, Linear, LinearError, Method, ModelError, Options, Problem,
    Real, Scalar, Solution, Solver, Stage, StageEnd, Stall, Status, Verdict, examine, mcp_fn,
    testing,
};
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::time::Duration;

fn options(method: Method) -> Options {
    Options::new(method).with(|o| {
        o.tol = Some(1e-10);
        o.max_iterations = 1000;
    })
}

/// `−e^−z`: no finite solution, neither as an equation nor with `z >= l`.
fn decay(z: f64) -> (f64, f64) {
    (-(-z).exp(), (-z).exp())
}

/// `−1/z`: no finite solution either; every Newton step doubles `z`.
fn reciprocal(z: f64) -> (f64, f64) {
    (-1.0 / z, 1.0 / (z * z))
}

/// Follows them to the end: the default `ρ` refuses Newton steps of length 1 once the residual
/// is below 1e-4, which the gradient cannot replace.
fn far_sighted(method: Method) -> Options {
    options(method).with(|o| o.descent.rho = f64::MIN_POSITIVE)
}

/// `z² − 1` without its derivative at 0.
fn parabola(z: f64) -> (f64, f64) {
    (z * z - 1.0, 2.0 * z)
}

/// One run for each status.
fn endings(method: Method) -> Result<Vec<(Status, Solution)>, ModelError> {
    let o = options(method);
    let one_step = options(method).with(|o| o.max_iterations = 1);
    let mut stall = Stall::default();
    (stall.iterations, stall.factor) = (1, 1e-6);
    let impatient = options(method).with(|o| o.stall = Some(stall));
    let no_time = options(method).with(|o| o.time_limit = Some(Duration::ZERO));
    let mut billups = testing::billups()?;
    // √2 to 1e-4 is all that units of 1e12 allow: F = 4.4e-4 at the best double.
    let mut huge = scalar(NONNEGATIVE, 2.0, |z| (1e12 * (z * z - 2.0), 2e12 * z));
    let mut stopped = scalar(FREE, 3.0, parabola);
    let mut solver = Solver::new(o.clone())?;
    let mut stop = |it: &Iteration<'_>| match it.k {
        0 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let interrupted = solver.solve_monitored(&mut stopped, None, &mut stop)?.clone();
    Ok(vec![
        (Status::Solved, solve(&mut scalar(FREE, 3.0, parabola), &o)),
        (
            Status::SolvedAsymptotically,
            solve(&mut scalar(FREE, 1.0, reciprocal), &far_sighted(method)),
        ),
        (Status::StationaryPoint, solve_from(&mut billups.problem, &[0.0], &o)),
        (Status::SingularSystem, solve(&mut scalar(FREE, 0.0, parabola), &o)),
        (Status::LineSearchFailed, solve(&mut huge, &o)),
        (Status::Stalled, solve(&mut scalar(FREE, 3.0, parabola), &impatient)),
        (Status::IterationLimit, solve(&mut scalar(FREE, 3.0, parabola), &one_step)),
        (Status::TimeLimit, solve(&mut scalar(FREE, 3.0, parabola), &no_time)),
        (Status::DomainError, solve(&mut scalar(FREE, 0.0, |_| (f64::NAN, 1.0)), &o)),
        (Status::Interrupted, interrupted),
    ])
}

#[test]
fn every_status_is_reached_by_every_method() {
    for method in Method::CLASSICAL {
        let endings = endings(method).unwrap();
        for (expected, solution) in &endings {
            assert_eq!(solution.status, *expected, "{method}: {:?}", solution.stats);
            assert_eq!(solution.method, method);
            let has_fault = solution.fault.is_some();
            assert_eq!(has_fault, *expected == Status::DomainError, "{method} {expected}");
        }
        let reached: Vec<_> = endings.iter().map(|e| e.0).collect();
        assert_eq!(reached, Status::ALL[..reached.len()], "{method}");
        // The others are those of Robust and Lemke.
        assert_eq!(
            Status::ALL[reached.len()..],
            [Status::Diverged, Status::Ray, Status::NotAffine]
        );
    }
}

#[test]
fn a_status_says_what_happened_and_what_to_do() {
    let mut sentences = BTreeSet::new();
    for status in Status::ALL {
        let text = status.to_string();
        assert!(text.starts_with(&format!("{}: {}", status.name(), status.meaning())), "{text}");
        assert!(text.ends_with(status.advice()), "{text}");
        let needs_none = matches!(status, Status::Solved | Status::Interrupted);
        assert_eq!(status.advice().is_empty(), needs_none, "{status:?}");
        assert!(status.meaning().len() > 15 && !text.ends_with("; "), "{text}");
        assert!(sentences.insert(status.meaning()), "two statuses mean the same: {text}");
    }
}

#[test]
fn an_unsolved_solution_is_an_error_that_reads_as_a_sentence() {
    for (expected, solution) in endings(Method::NewtonFb).unwrap() {
        let iterations = solution.stats.iterations;
        match solution.solved() {
            Ok(solution) => assert_eq!(solution.status, Status::Solved),
            Err(error) => {
                let text = error.to_string();
                assert_ne!(expected, Status::Solved);
                assert!(text.starts_with(&error.solution.status.to_string()), "{text}");
                assert!(text.contains(&format!("(iterations: {iterations}, natural residual: ")));
                assert!(text.contains(expected.meaning()), "{text}");
            }
        }
    }
}

#[test]
fn a_solution_at_infinity_is_never_solved() {
    for method in Method::CLASSICAL {
        for bounds in [FREE, NONNEGATIVE] {
            let mut problem = scalar(bounds, 1.0, reciprocal);
            let solution = solve(&mut problem, &far_sighted(method));
            assert_eq!(solution.status, Status::SolvedAsymptotically, "{method} {bounds:?}");
            let certificate = solution.certificate;
            assert_eq!((certificate.diverging, certificate.vanishing_row), (Some(0), None));
            assert!(certificate.natural_residual <= 1e-10 && certificate.relative_residual > 0.1);

            // e^−z is gone before z is large. The search of OldFb ends where the merit underflows.
            if method != Method::OldFb {
                let solution = solve(&mut scalar(bounds, 0.0, decay), &far_sighted(method));
                assert_eq!(solution.status, Status::SolvedAsymptotically, "{method} {bounds:?}");
                assert_eq!(solution.certificate.vanishing_row, Some(0));
            }
        }
        // Bounded, the same equation has a solution at the bound.
        let solution = solve(&mut scalar((-INF, 5.0), 0.0, decay), &options(method));
        assert_eq!((solution.status, solution.z[0]), (Status::Solved, 5.0), "{method}");
    }
}

/// A point that is no solution is not asymptotic either, with or without an absolute tolerance.
#[test]
fn a_large_residual_is_never_asymptotic() {
    for method in Method::CLASSICAL {
        for tol in [None, Some(1e-10)] {
            let o = options(method).with(|o| o.tol = tol);
            let solution = solve(&mut scalar(FREE, 0.0, |z| (z * z + 1.0, 2.0 * z)), &o);
            assert_eq!(solution.status, Status::SingularSystem, "{method} {tol:?}");
            assert_eq!(solution.certificate.vanishing_row, Some(0));
            let mut far = dense(&[FREE, FREE], &[0.0, 0.0], |z, f, jac| {
                f.copy_from_slice(&[1e-14 * z[0] - 1.0, z[1] - 2.0]);
                jac.copy_from_slice(&[1e-14, 0.0, 0.0, 1.0]);
            });
            let certificate = examine(&mut far, &[1e14, -3e15]).unwrap();
            assert!(certificate.diverging.is_some());
            assert_eq!(certificate.verdict(tol, 1e-8), Verdict::Refused, "{method} {tol:?}");
        }
    }
}

/// Whether the gradient vanishes is a question without units.
#[test]
fn a_stationary_point_is_told_in_all_units() {
    for method in Method::CLASSICAL {
        for scale in [1e-6, 1.0, 1e6] {
            let hill = |z: f64| (scale * (z * z + 1.0), scale * 2.0 * z);
            let o = options(method).with(|o| o.descent.rho = 1e-300);
            let solution = solve(&mut scalar(FREE, 3.0, hill), &o);
            let (status, stats) = (solution.status, solution.stats);
            assert_eq!(status, Status::StationaryPoint, "{method} {scale:e} {stats:?}");
            assert!(solution.z[0].abs() < 1e-4, "{method} {scale:e}: {:?}", solution.z);
        }
    }
    // In units of 1e-12 OldFb refuses its Newton direction, and the gradient, 1e-23, leads nowhere in
    // one step; it does not vanish for that.
    let mut small = scalar(NONNEGATIVE, 2.0, |z| (1e-12 * (z * z - 1.0), 2e-12 * z));
    let status = solve(&mut small, &options(Method::OldFb)).status;
    assert_eq!(status, Status::LineSearchFailed);
}

#[mcp_fn(lower = [-1.0, 0.0], start = [-0.5, 0.0])]
fn logarithms<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + 0.25, (x + y).ln()]
}

#[test]
fn a_domain_error_at_the_start_names_equation_point_and_value() {
    for method in Method::CLASSICAL {
        // x + y = −0.5; moving y inside gives ln 0.5: the solve goes on from there.
        let mut problem = AdProblem::new(Logarithms::new().unwrap()).unwrap();
        let solution = solve(&mut problem, &options(method));
        assert!(solution.start_was_moved && solution.is_solved(), "{method}: {}", solution.status);
        assert!(solution.fault.is_none());
        // A fixed variable cannot be moved.
        let mut fixed = AdProblem::new(Logarithms::new().unwrap()).unwrap();
        fixed.set_bounds(&[-1.0, 0.25], &[INF, 0.25]).unwrap();
        let solution = solve_from(&mut fixed, &[-0.5, 0.25], &options(method));
        assert_eq!(solution.status, Status::DomainError, "{method}");
        assert!(!solution.start_was_moved && !solution.certificate.is_finite);
        let fault = solution.fault.unwrap();
        assert_eq!(fixed.shape().equation_name(fault.equation), "f[y]");
        assert_eq!((fault.variable, fault.z.as_slice()), (None, &[-0.5, 0.25][..]));
        assert!(!fault.value.is_finite());
    }
}

#[test]
fn an_infinite_derivative_at_the_start_moves_the_start_or_is_named() {
    let root = |z: f64| (z.sqrt() - 2.0, 0.5 / z.sqrt());
    for method in Method::CLASSICAL {
        let solution = solve(&mut scalar(NONNEGATIVE, 0.0, root), &options(method));
        assert!(solution.start_was_moved, "{method}");
        assert_eq!(solution.status, Status::Solved, "{method}");
        assert!((solution.z[0] - 4.0).abs() < 1e-8);

        let stuck = solve(&mut scalar(FREE, 0.0, root), &options(method));
        assert_eq!((stuck.status, stuck.start_was_moved), (Status::DomainError, false));
        let fault = stuck.fault.unwrap();
        assert_eq!((fault.equation, fault.variable, fault.value), (0, Some(0), INF), "{method}");
        assert_eq!(stuck.certificate.natural_residual, 2.0, "F itself is finite");
    }
}

#[test]
fn moving_the_start_stays_in_the_box_and_happens_once() {
    // Undefined everywhere: each bound kind is moved once, by a tenth of the box or by 1.
    let bounds = [(0.0, INF), (-INF, 0.0), (0.0, 2.0), (0.0, 0.0), FREE];
    let mut problem = dense(&bounds, &[0.0, 0.0, 2.0, 0.0, 0.0], |_, f, _| f.fill(f64::NAN));
    for method in Method::CLASSICAL {
        let (solution, seen) = watch(&mut problem, None, &options(method));
        assert_eq!(solution.status, Status::DomainError, "{method}");
        assert!(solution.start_was_moved && seen.is_empty());
        assert_eq!(solution.z, [1.0, -1.0, 1.8, 0.0, 0.0], "{method}");
        assert_eq!(solution.stats.residual_evaluations, 2, "{method}");
        check_honest(&mut problem, &solution, &options(method), method.name());
    }
}

#[test]
fn a_trial_outside_the_domain_is_a_shorter_step_not_an_end() {
    // The full step from 3 to −0.3 is outside, half of it is not.
    for method in Method::CLASSICAL {
        let mut known = testing::log_equation().unwrap();
        let (solution, seen) = watch(&mut known.problem, Some(&[3.0]), &options(method));
        assert_eq!((solution.status, solution.fault.is_some()), (Status::Solved, false));
        assert!(seen[1].step < 1.0, "{method}");
    }
}

#[test]
fn trials_that_are_all_outside_the_domain_end_as_a_domain_error() {
    for method in Method::CLASSICAL {
        // Defined up to 0, where it starts; Newton's step 1 leads out, however short.
        let mut edge =
            scalar(FREE, 0.0, |z| if z > 0.0 { (f64::NAN, 1.0) } else { (z - 1.0, 1.0) });
        let o = options(method).with(|o| o.armijo.smallest_step = 1e-10);
        let solution = solve(&mut edge, &o);
        assert_eq!(solution.status, Status::DomainError, "{method}");
        let fault = solution.fault.unwrap();
        assert!(fault.value.is_nan() && fault.variable.is_none() && fault.z[0] > 0.0);
        assert_eq!(solution.z, [0.0], "{method}: the answer is the last good point");

        // The same with a finite F and an infinite J.
        let mut edge = scalar(FREE, 0.0, |z| (z - 1.0, if z > 0.0 { INF } else { 1.0 }));
        let solution = solve(&mut edge, &o);
        assert_eq!(solution.status, Status::DomainError, "{method}");
        let fault = solution.fault.unwrap();
        assert_eq!((fault.equation, fault.variable, fault.value), (0, Some(0), INF), "{method}");
        assert_eq!((solution.z[0], solution.stats.iterations), (0.0, 0), "{method}");
        assert_eq!(solution.stats.gradient_steps, 0);
    }
}

#[test]
fn an_infinite_derivative_at_one_trial_is_a_shorter_step() {
    for method in Method::CLASSICAL {
        // Beyond 1.5 the derivative is infinite; the root is 1, the first full step goes to 2.
        let f = |z: f64| (z * z - 1.0, if z > 1.2 { INF } else { 2.0 * z });
        let mut problem = scalar(FREE, 0.28, f);
        let (solution, seen) = watch(&mut problem, None, &options(method));
        assert_eq!(solution.status, Status::Solved, "{method}");
        assert!(seen.iter().all(|it| it.z[0] <= 1.2), "{method}");
        assert!(solution.fault.is_none(), "{method}");
    }
}

#[test]
fn input_that_is_wrong_is_an_error_before_iteration_0() {
    let mut known = testing::kojima_shindo().unwrap();
    let mut solver = Solver::new(Options::default()).unwrap();
    let short = solver.solve_from(&mut known.problem, &[0.0; 3]).err();
    assert!(matches!(short, Some(ModelError::Length { expected: 4, found: 3, .. })), "{short:?}");
    for value in [f64::NAN, INF] {
        match solver.solve_from(&mut known.problem, &[0.0, value, 0.0, 0.0]).err() {
            Some(error @ ModelError::StartNotFinite { .. }) => {
                assert!(error.to_string().contains("z[2]"), "{error}");
            }
            other => panic!("{other:?}"),
        }
    }
    let bad = Options::default().with(|o| o.full_step = 2.0);
    assert!(matches!(
        mcp_core::solve(&Logarithms::new().unwrap(), &bad),
        Err(ModelError::Option { option: "full_step", .. })
    ));
    let mut large = testing::murty(17).unwrap();
    let mut stack = Solver::new(Options::default().with(|o| o.linear = Linear::Stack)).unwrap();
    let error = stack.solve(&mut large.problem).err();
    assert_eq!(error, Some(ModelError::Linear(LinearError::TooLarge { n: 17, limit: 16 })));
    // The solver is as good as new after its refusals.
    assert!(solver.solve(&mut known.problem).unwrap().is_solved());
    assert!(stack.solve(&mut known.problem).unwrap().is_solved());
}

#[test]
fn limits_of_zero_end_at_the_start_unless_it_is_a_solution() {
    for method in Method::CLASSICAL {
        for limit in [
            options(method).with(|o| o.max_iterations = 0),
            options(method).with(|o| o.time_limit = Some(Duration::ZERO)),
        ] {
            let solution = solve(&mut scalar(FREE, 3.0, parabola), &limit);
            assert!(matches!(solution.status, Status::IterationLimit | Status::TimeLimit));
            assert_eq!((solution.stats.iterations, solution.z[0]), (0, 3.0), "{method}");
            assert_eq!(solve(&mut scalar(FREE, 1.0, parabola), &limit).status, Status::Solved);
        }
    }
}

/// `5x + 25y ⟂ x >= 0; 5x + 25y + 2 ⟂ y <= 1.23`: on `x = −5y` both equations hold but for 2, which is
/// small beside terms as large as one likes.
#[test]
fn a_singular_pair_without_solution_is_not_solved_from_afar() {
    let robust = Options::new(Method::Robust);
    let m = vec![vec![5.0, 25.0]; 2];
    for start in [[0.0, -1000.0], [0.0, -300.0], [1e4, 0.0], [0.0, 0.0], [1e6, 1.0], [-3e5, 7.0]] {
        let bounds = [NONNEGATIVE, (-INF, 1.23)];
        let mut problem = affine(m.clone(), vec![0.0, 2.0], &bounds, &start);
        let solution = solve(&mut problem, &robust);
        assert_ne!(solution.status, Status::Solved, "{start:?}: {:?}", solution.z);
    }
}

/// `√z arctan z + 3.9 z + 1.1 ⟂ z >= 0`: at 0, the solution, the derivative is not defined.
#[test]
fn a_solution_on_a_bound_without_derivatives_is_met_exactly() {
    let f = |z: f64| {
        let slope = z.atan() * 0.5 / z.sqrt() + z.sqrt() / (1.0 + z * z) + 3.9;
        (z.sqrt() * z.atan() + 3.9 * z + 1.1, slope)
    };
    for start in [0.0, 0.1, 1.0, 3.0, 10.0, 1000.0] {
        let solution = solve(&mut scalar(NONNEGATIVE, start, f), &Options::new(Method::Robust));
        assert_eq!((solution.status, solution.z[0]), (Status::Solved, 0.0), "{start}");
        assert!(solution.stats.residual_evaluations <= 2, "{start}: {:?}", solution.stats);
    }
}

/// `−e^−z ⟂ z >= 0` and the KKT system of problem 13 of Hock & Schittkowski (1981), which has no
/// multipliers: both have points with a residual as small as one likes, far away, and no solution.
#[test]
fn robust_does_not_claim_a_solution_at_infinity() {
    let robust = Options::new(Method::Robust);
    for bounds in [FREE, NONNEGATIVE] {
        for start in [0.0, 1.0, 30.0] {
            let solution = solve(&mut scalar(bounds, start, decay), &robust);
            assert!(!solution.is_solved(), "{bounds:?} {start}: {:?}", solution.z);
            let solution = solve(&mut scalar(bounds, start.max(1.0), reciprocal), &robust);
            assert!(!solution.is_solved(), "{bounds:?} {start}: {:?}", solution.z);
        }
    }
    // min (x − 2)² + y² under (1 − x)³ − y >= 0, x, y >= 0: the cusp (1, 0).
    for start in [[0.0, 0.0, 0.0], [-2.0, -2.0, 0.0], [1.0, 0.0, 1.0], [0.5, 0.5, 100.0]] {
        let mut hs13 = dense(&[NONNEGATIVE; 3], &start, |z, f, jac| {
            let [x, y, u] = [z[0], z[1], z[2]];
            let gap = 1.0 - x;
            f.copy_from_slice(&[
                2.0 * (x - 2.0) + 3.0 * u * gap * gap,
                2.0 * y + u,
                gap * gap * gap - y,
            ]);
            jac.copy_from_slice(&[
                2.0 - 6.0 * u * gap,
                0.0,
                -3.0 * gap * gap,
                0.0,
                2.0,
                -1.0,
                3.0 * gap * gap,
                1.0,
                0.0,
            ]);
        });
        let solution = solve(&mut hs13, &robust);
        assert!(!solution.is_solved(), "{start:?}: {:?}", solution.z);
    }
}

#[test]
fn robust_says_that_only_the_absolute_tolerance_is_not_met() {
    let mut huge = scalar(NONNEGATIVE, 2.0, |z| (1e12 * (z * z - 2.0), 2e12 * z));
    let relative = Options::new(Method::Robust);
    assert_eq!(solve(&mut huge, &relative).status, Status::Solved);
    let solution = solve(&mut huge, &relative.with(|o| o.tol = Some(1e-10)));
    assert_eq!(solution.status, Status::LineSearchFailed);
    assert!(solution.certificate.relative_residual < 1e-14, "{:?}", solution.certificate);
    assert!(solution.stats.jacobian_evaluations < 20, "{:?}", solution.stats);
}

#[test]
fn robust_names_what_can_move_together() {
    // Only the difference of the two is determined, and it would have to be 0 and 1.
    let mut problem = dense(&[FREE, FREE], &[3.0, 1.0], |z, f, jac| {
        f.copy_from_slice(&[z[0] - z[1], z[0] - z[1] - 1.0]);
        jac.copy_from_slice(&[1.0, 1.0, -1.0, -1.0]);
    });
    let solution = solve(&mut problem, &Options::new(Method::Robust));
    assert_eq!(solution.status, Status::SingularSystem);
    let Some(Diagnosis::Singular { null_vector, .. }) = &solution.diagnosis else {
        panic!("{:?}", solution.diagnosis);
    };
    let mut entries = null_vector.clone();
    entries.sort_by_key(|entry| entry.0);
    assert_eq!([entries[0].0, entries[1].0], [0, 1]);
    assert!((entries[0].1 / entries[1].1 - 1.0).abs() < 1e-6, "{entries:?}");
    let text = solution.diagnosis.as_ref().unwrap().describe(problem.shape());
    assert!(text.contains("`z[1]`") && text.contains("`z[2]`"), "{text}");
    assert_eq!(solution.stages.last().unwrap().stage, Stage::Backtracking);
}

#[test]
fn lemke_reports_a_ray_and_refuses_what_is_not_affine() {
    let lemke = Options::new(Method::Lemke);
    // −1 ⟂ z₁ >= 0: positive semidefinite, so no solution exists.
    let mut infeasible = affine(
        vec![vec![0.0, 0.0], vec![0.0, 1.0]],
        vec![-1.0, -1.0],
        &[NONNEGATIVE; 2],
        &[0.0; 2],
    );
    let solution = solve(&mut infeasible, &lemke);
    assert_eq!(solution.status, Status::Ray);
    let Some(Diagnosis::Ray { direction }) = &solution.diagnosis else {
        panic!("{:?}", solution.diagnosis);
    };
    assert!(direction[0].0 == 0 && direction[0].1 > 0.0, "{direction:?}");
    let solution = solve(&mut scalar(FREE, 3.0, parabola), &lemke);
    assert_eq!(solution.status, Status::NotAffine);
}

#[test]
fn robust_records_its_stages_and_ends_at_limits() {
    let mut billups = testing::billups().unwrap();
    let robust = Options::new(Method::Robust);
    let solution = solve_from(&mut billups.problem, &[0.0], &robust);
    assert!(solution.is_solved());
    assert_eq!(solution.stages[0].stage, Stage::Crash);
    let last = solution.stages.last().unwrap();
    assert_eq!(last.end, StageEnd::Ended);
    let steps: usize = solution.stages.iter().map(|stage| stage.iterations).sum();
    assert_eq!(steps, solution.stats.iterations);

    let few = robust.clone().with(|o| o.robust.jacobians = 5);
    let solution = solve_from(&mut billups.problem, &[0.0], &few);
    assert_eq!(solution.status, Status::IterationLimit);
    assert!(solution.stats.jacobian_evaluations <= 6, "{:?}", solution.stats);
    assert_eq!(solution.diagnosis, Some(Diagnosis::Unfinished { worst: vec![0] }));
    let none = robust.with(|o| o.max_iterations = 0);
    let solution = solve_from(&mut billups.problem, &[0.0], &none);
    assert_eq!((solution.status, solution.stats.iterations), (Status::IterationLimit, 0));
}
