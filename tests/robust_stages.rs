//! The stages of the default method: each can be switched off, and each is there for a problem.

mod common;

use common::{NONNEGATIVE, dense, solve, solve_from};
use mcp_core::testing::{self, Known};
use mcp_core::{Method, ModelError, Options, Robust, Solver, Stage, StageEnd, Status};

/// Crash and semismooth Newton, and what `edit` switches on.
fn only(edit: impl FnOnce(&mut Robust)) -> Options {
    Options::new(Method::Robust).with(|o| {
        let r = &mut o.robust;
        for budget in [
            &mut r.josephy_first,
            &mut r.josephy,
            &mut r.smoothing,
            &mut r.penalised,
            &mut r.boxes,
            &mut r.rescale,
            &mut r.sized,
            &mut r.proximal,
            &mut r.starts,
            &mut r.backtracking,
        ] {
            *budget = 0;
        }
        edit(r);
    })
}

type Make = fn() -> Result<Known, ModelError>;

/// The stage that ends a solve, if it ends in a solution.
fn ended_by(make: Make, start: usize, options: &Options) -> Option<Stage> {
    let mut known = make().expect("the problems are well formed");
    let start = known.starts[start].clone();
    let solution = solve_from(&mut known.problem, &start, options);
    solution.is_solved().then(|| solution.stages.last().map_or(Stage::Newton, |s| s.stage))
}

#[test]
fn the_crash_alone_solves_most_problems_and_exactly() {
    let mut by_crash = 0;
    let mut runs = 0;
    for mut known in testing::all().unwrap() {
        for start in known.starts.clone() {
            let solution = solve_from(&mut known.problem, &start, &Options::new(Method::Robust));
            assert!(solution.is_solved(), "{} {start:?}", known.name);
            let relative = solution.certificate.relative_residual;
            assert!(relative <= 1e-15, "{} {start:?}: {relative:e}", known.name);
            runs += 1;
            by_crash += usize::from(solution.stages.iter().all(|s| s.stage == Stage::Crash));
        }
    }
    assert!(3 * by_crash > 2 * runs, "{by_crash} of {runs}");
}

#[test]
fn descent_is_trapped_by_billups_and_proximal_points_and_other_starts_get_out() {
    for start in 0..3 {
        assert_eq!(ended_by(testing::billups, start, &only(|_| ())), None);
        let proximal = only(|r| r.proximal = 25);
        assert_eq!(ended_by(testing::billups, start, &proximal), Some(Stage::Proximal));
    }
    let starts = only(|r| r.starts = 6);
    assert_eq!(ended_by(testing::billups, 2, &starts), Some(Stage::Starts));
}

#[test]
fn one_linearisation_solves_an_affine_problem_where_the_crash_does_not() {
    for make in
        [|| testing::fathi(8), || testing::cyclic(-1.0), || testing::hilbert(8)] as [Make; 3]
    {
        let linearised = only(|r| {
            r.crash = 0;
            r.josephy_first = 1;
        });
        assert_eq!(ended_by(make, 0, &linearised), Some(Stage::Josephy));
    }
}

#[test]
fn smoothing_and_penalties_alone_solve_a_monotone_problem() {
    for (edit, stage) in [
        ((|r| r.smoothing = 70) as fn(&mut Robust), Stage::Smoothing),
        (|r| r.penalised = 120, Stage::Penalised),
        (|r| r.sized = 40, Stage::Sized),
    ] {
        let alone = only(|r| {
            (r.crash, r.semismooth) = (0, 0);
            edit(r);
        });
        assert_eq!(ended_by(testing::nocedal_16_4, 0, &alone), Some(stage));
        assert_eq!(ended_by(testing::rosen_suzuki, 0, &alone), Some(stage));
    }
}

#[test]
fn backtracking_solves_an_economy_in_exponents_of_prices_where_other_stages_run_away() {
    // Excess supply of two goods at prices e^z; it hardly changes with the level of prices.
    let owned = [1e4, 1e2];
    let demand = [[4000.0, 70.0], [5000.0, 20.0]];
    let mut economy = dense(&[common::FREE; 2], &[2.0, 2.0], move |z, f, jac| {
        for i in 0..2 {
            let spent = |j: usize| demand[i][j] * (z[j] - z[i]).exp();
            let (fixed, other) = (0.1 * (-z[i]).exp(), spent(1 - i));
            f[i] = owned[i] - fixed - spent(i) - other;
            jac[i + 2 * i] = fixed + other;
            jac[i + 2 * (1 - i)] = -other;
        }
    });
    let solution = solve(&mut economy, &Options::default());
    assert_eq!(solution.stages.last().map(|s| s.stage), Some(Stage::Backtracking));
    assert!(solution.is_solved(), "{}", solution.status);
    let alone = only(|r| (r.crash, r.semismooth, r.backtracking) = (0, 0, 80));
    assert!(solve(&mut economy, &alone).is_solved());
    let without = Options::default().with(|o| o.robust.backtracking = 0);
    assert!(!solve(&mut economy, &without).is_solved());
}

#[test]
fn levenberg_marquardt_goes_on_where_the_jacobian_is_singular() {
    // x² + y² = 1 twice: H is singular everywhere.
    let mut circle = dense(&[common::FREE; 2], &[3.0, 1.0], |z, f, jac| {
        f.fill(z[0] * z[0] + z[1] * z[1] - 1.0);
        jac.copy_from_slice(&[2.0 * z[0], 2.0 * z[0], 2.0 * z[1], 2.0 * z[1]]);
    });
    let with = only(|_| ());
    let without = with.clone().with(|o| o.robust.levenberg_marquardt = 0);
    let solution = solve(&mut circle, &with);
    assert_eq!(solution.status, Status::Solved);
    let gradient_only = solve(&mut circle, &without).stats;
    assert!(solution.stats.jacobian_evaluations < gradient_only.jacobian_evaluations);
}

#[test]
fn a_degenerate_double_root_is_found_and_a_stage_too_large_is_skipped() {
    let mut double = dense(&[NONNEGATIVE], &[3.0], |z, f, jac| {
        f[0] = z[0] * z[0];
        jac[0] = 2.0 * z[0];
    });
    let solution = solve(&mut double, &Options::new(Method::Robust));
    assert!(solution.is_solved() && solution.z[0] < 1e-3, "{:?}", solution.z);

    let mut billups = testing::billups().unwrap();
    let tiny = Options::new(Method::Robust).with(|o| o.robust.josephy_size = 0);
    let solution = solve_from(&mut billups.problem, &[0.0], &tiny);
    let skipped = solution.stages.iter().find(|s| s.stage == Stage::Josephy).unwrap();
    assert_eq!(skipped.end, StageEnd::Skipped);
    assert!(solution.is_solved());
}

#[test]
fn a_solver_that_saw_other_problems_takes_the_path_of_a_new_one() {
    for method in [Method::Robust, Method::Lemke] {
        let options = Options::new(method);
        let mut shared = Solver::new(options.clone()).unwrap();
        let mut problems = testing::all().unwrap();
        problems.push(testing::billups().unwrap());
        for mut known in problems {
            for start in known.starts.clone() {
                let fresh = solve_from(&mut known.problem, &start, &options);
                let reused = shared.solve_from(&mut known.problem, &start).unwrap();
                assert_eq!(*reused, fresh, "{} {method}", known.name);
            }
        }
    }
}
