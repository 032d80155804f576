//! Options and entry points: every setting is used, every way in gives the same bits.

mod common;

use common::{FREE, NONNEGATIVE, scalar, siconos, solve, solve_from, watch};
use mcp_core::linalg::{FactorInfo, NalgebraLu};
use mcp_core::testing;
use mcp_core::{
    AdProblem, Criterion, LinearError, LinearSolver, Method, ModelError, Nonmonotone, Options,
    Pattern, Real, Scalar, Solver, Stall, Status, mcp_fn,
};
use std::cell::Cell;
use std::rc::Rc;
use std::time::Duration;

/// Josephy (1979).
#[mcp_fn(lower = 0.0, start = 1.0)]
fn josephy<D: Scalar>([a, b, c, d]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3 * a * a + 2 * a * b + 2 * b * b + c + 3 * d - 6,
        2 * a * a + a + b * b + 3 * c + 2 * d - 2,
        3 * a * a + a * b + 2 * b * b + 2 * c + 3 * d - 1,
        a * a + 3 * b * b + 2 * c + 3 * d - 3,
    ]
}

#[test]
fn every_entry_point_gives_the_same_solution() {
    let model = Josephy::new().unwrap();
    for method in Method::CLASSICAL {
        let options = siconos(method);
        let mut problem = AdProblem::new(&model).unwrap();
        let reference = mcp_core::solve(&model, &options).unwrap();
        assert!(reference.is_solved(), "{method}");
        let start = [1.0; 4];
        assert_eq!(mcp_core::solve_from(&model, &start, &options).unwrap(), reference);
        assert_eq!(solve(&mut problem, &options), reference);
        assert_eq!(solve_from(&mut problem, &start, &options), reference);
        assert_eq!(watch(&mut problem, None, &options).0, reference);
        assert_eq!(watch(&mut problem, Some(&start), &options).0, reference);
        assert_eq!(
            *Solver::new(options).unwrap().solve_from(&mut problem, &start).unwrap(),
            reference
        );
    }
}

#[test]
fn every_criterion_ends_a_solve() {
    let criteria = [
        Criterion::FbNorm,
        Criterion::Stationarity,
        Criterion::FbNormAndStationarity,
        Criterion::NaturalResidual,
    ];
    for method in Method::CLASSICAL {
        for criterion in criteria {
            let mut problem = AdProblem::new(Josephy::new().unwrap()).unwrap();
            let options = siconos(method).with(|o| o.criterion = criterion);
            let (solution, seen) = watch(&mut problem, None, &options);
            assert_eq!(solution.status, Status::Solved, "{method} {criterion:?}");
            // A criterion on the gradient needs J at the last point.
            let at_end =
                usize::from(!matches!(criterion, Criterion::FbNorm | Criterion::NaturalResidual));
            let stats = solution.stats;
            assert_eq!(stats.jacobian_evaluations, stats.iterations + at_end, "{criterion:?}");
            assert_eq!(seen.len(), stats.iterations + 1, "{criterion:?}");
            assert!(stats.certificate_evaluations <= 2, "{criterion:?}: the judge is asked rarely");
        }
    }
}

/// At a stationary point that is no solution the criterion is met and the certificate refuses.
#[test]
fn a_criterion_does_not_decide() {
    for method in Method::CLASSICAL {
        let options = siconos(method).with(|o| o.criterion = Criterion::Stationarity);
        let mut hill = scalar(FREE, 0.0, |z| (z * z + 1.0, 2.0 * z));
        assert_eq!(solve(&mut hill, &options).status, Status::SingularSystem, "{method}");
        // Siconos ends such a run with a mismatch: ‖Φ‖ <= tol < ‖min‖.
        let loose = siconos(method).with(|o| o.tol = Some(1.45));
        let mut known = testing::kojima_shindo().unwrap();
        let solution =
            solve_from(&mut known.problem, &[0.0; 4], &loose.with(|o| o.tol_relative = 1.0));
        assert!(solution.is_solved(), "{method}: {}", solution.status);
        assert!(solution.certificate.natural_residual <= 1.45);
    }
}

#[test]
fn without_an_absolute_tolerance_the_relative_one_decides() {
    for method in Method::CLASSICAL {
        for relative in [1e-3, 1e-8, 1e-13] {
            let options = siconos(method).with(|o| {
                o.tol = None;
                o.tol_relative = relative;
            });
            let solution = mcp_core::solve(&Josephy::new().unwrap(), &options).unwrap();
            assert_eq!(solution.status, Status::Solved, "{method}");
            assert!(solution.certificate.relative_residual <= relative, "{method}");
            // The judge is asked at every iterate, the start included.
            assert_eq!(solution.stats.certificate_evaluations, solution.stats.iterations + 1);
        }
        let last = |relative: f64| {
            let o = siconos(method).with(|o| (o.tol, o.tol_relative) = (None, relative));
            mcp_core::solve(&Josephy::new().unwrap(), &o).unwrap().stats.iterations
        };
        assert!(last(1e-3) < last(1e-13), "{method}: a looser tolerance ends earlier");
    }
}

/// Iterates of a run that needs its line search.
fn path(method: Method, edit: impl FnOnce(&mut Options)) -> Vec<common::Seen> {
    let mut known = testing::kojima_shindo().expect("well formed");
    watch(&mut known.problem, Some(&[100.0; 4]), &siconos(method).with(edit)).1
}

#[test]
fn every_constant_is_used() {
    type Edit = fn(&mut Options);
    let edits: [(&str, Edit, &[Method]); 8] = [
        ("armijo.first_step", |o| o.armijo.first_step = 0.5, &Method::CLASSICAL),
        ("armijo.reduction", |o| o.armijo.reduction = 0.3, &Method::CLASSICAL),
        ("armijo.slope_share", |o| o.armijo.slope_share = 0.45, &Method::CLASSICAL[..2]),
        ("descent.rho", |o| o.descent.rho = 1e3, &Method::CLASSICAL),
        ("descent.p", |o| o.descent.p = 30.0, &Method::CLASSICAL),
        ("full_step", |o| o.full_step = 1e-3, &Method::CLASSICAL[..2]),
        ("nonmonotone", |o| o.nonmonotone = Nonmonotone::Max, &Method::CLASSICAL[..2]),
        ("max_iterations", |o| o.max_iterations = 3, &Method::CLASSICAL),
    ];
    for (name, edit, methods) in edits {
        for &method in methods {
            assert_ne!(
                path(method, |_| ()),
                path(method, edit),
                "{method}: {name} changes nothing"
            );
        }
    }
}

#[test]
fn the_reference_of_the_search_depends_on_kind_and_memory() {
    let run = |kind: Nonmonotone, memory: usize| {
        path(Method::NewtonFb, |o| (o.nonmonotone, o.memory) = (kind, memory))
    };
    let kinds = [Nonmonotone::Max, Nonmonotone::Mean, Nonmonotone::ZhangHager];
    let rises = |path: &[common::Seen]| path.windows(2).any(|two| two[1].fb_norm > two[0].fb_norm);
    assert!(!rises(&run(Nonmonotone::Off, 8)), "monotone is monotone");
    for kind in kinds {
        assert_ne!(run(kind, 8), run(Nonmonotone::Off, 8), "{kind:?}");
        assert!(rises(&run(kind, 8)), "{kind:?} accepts an increase on this run");
    }
    assert_ne!(run(Nonmonotone::Max, 8), run(Nonmonotone::Max, 1), "the memory is used");
    assert_eq!(run(Nonmonotone::Max, 1), run(Nonmonotone::Off, 8), "of one, it is monotone");
    assert_eq!(run(Nonmonotone::ZhangHager, 1), run(Nonmonotone::ZhangHager, 8));
}

#[test]
fn stall_and_time_limit_end_a_solve_and_without_them_nothing_does() {
    let stalled = path(Method::NewtonFb, |_| ());
    let quick = path(Method::NewtonFb, |o| {
        o.stall = Some(Stall::default()).map(|mut stall| {
            stall.iterations = 5;
            stall
        });
    });
    let endless = path(Method::NewtonFb, |o| o.stall = None);
    assert!(quick.len() < stalled.len() && stalled.len() < endless.len());
    // A generous limit does not change the path: the clock is only read.
    let limited = path(Method::NewtonFb, |o| o.time_limit = Some(Duration::from_hours(1)));
    assert_eq!(limited, stalled);
}

/// Passes everything on and counts; `refuses` makes it refuse an order.
struct Spy {
    inner: NalgebraLu,
    calls: Rc<Cell<[usize; 3]>>,
    refuses: usize,
}

impl Spy {
    fn count(&self, call: usize) {
        let mut calls = self.calls.get();
        calls[call] += 1;
        self.calls.set(calls);
    }
}

impl LinearSolver for Spy {
    fn name(&self) -> &'static str {
        "spy"
    }
    fn analyse(&mut self, pattern: &Pattern) -> Result<(), LinearError> {
        self.count(0);
        if pattern.n() == self.refuses {
            return Err(LinearError::TooLarge { n: pattern.n(), limit: 4 });
        }
        self.inner.analyse(pattern)
    }
    fn factor(&mut self, values: &[f64]) -> Result<FactorInfo, LinearError> {
        self.count(1);
        self.inner.factor(values)
    }
    fn solve(&mut self, rhs: &mut [f64]) {
        self.count(2);
        self.inner.solve(rhs);
    }
    fn solve_transposed(&mut self, rhs: &mut [f64]) {
        self.inner.solve_transposed(rhs);
    }
}

#[test]
fn the_callers_linear_solver_is_used_and_kept() {
    for method in Method::CLASSICAL {
        let calls = Rc::new(Cell::new([0; 3]));
        let spy = Spy { inner: NalgebraLu::new(), calls: calls.clone(), refuses: 8 };
        let mut solver = Solver::with_linear_solver(siconos(method), Box::new(spy)).unwrap();
        let mut small = AdProblem::new(Josephy::new().unwrap()).unwrap();
        let mut large = testing::murty(20).unwrap();
        let mut refused = testing::murty(8).unwrap();

        let first = solver.solve(&mut small).unwrap().clone();
        assert!(first.is_solved(), "{method}");
        let f = first.stats.factorisations;
        assert_eq!(calls.get(), [1, f, f], "{method}");
        solver.solve(&mut small).unwrap();
        assert_eq!(calls.get(), [1, 2 * f, 2 * f], "{method}: the pattern is analysed once");

        let more = solver.solve(&mut large.problem).unwrap().stats.factorisations;
        assert_eq!(
            calls.get(),
            [2, 2 * f + more, 2 * f + more],
            "{method}: kept for another shape"
        );

        // A refusal is reported, every time, and does not lose the solver.
        for k in [3, 4] {
            let error = solver.solve(&mut refused.problem).err();
            let expected = ModelError::Linear(LinearError::TooLarge { n: 8, limit: 4 });
            assert_eq!((error, calls.get()[0]), (Some(expected), k), "{method}");
        }
        assert_eq!(*solver.solve(&mut small).unwrap(), first, "{method}");
        assert_eq!(calls.get(), [5, 3 * f + more, 3 * f + more], "{method}: the spy again");
    }
}

#[test]
fn a_solver_that_saw_other_problems_gives_the_bits_of_a_new_one() {
    for method in Method::CLASSICAL {
        for kind in [Nonmonotone::Off, Nonmonotone::Max, Nonmonotone::ZhangHager] {
            let options = siconos(method).with(|o| o.nonmonotone = kind);
            let mut shared = Solver::new(options.clone()).unwrap();
            let mut problems = testing::all().unwrap();
            problems.extend([testing::billups().unwrap(), testing::log_equation().unwrap()]);
            for mut known in problems {
                for start in known.starts.clone() {
                    let fresh = solve_from(&mut known.problem, &start, &options);
                    let reused = shared.solve_from(&mut known.problem, &start).unwrap();
                    assert_eq!(*reused, fresh, "{} {method} {kind:?}", known.name);
                }
            }
        }
    }
}

#[test]
fn bounds_changed_between_solves_are_seen() {
    let mut problem = AdProblem::new(Josephy::new().unwrap()).unwrap();
    for method in Method::CLASSICAL {
        let mut solver = Solver::new(siconos(method)).unwrap();
        let inf = f64::INFINITY;
        for upper in [inf, 1.0, 0.25, inf] {
            problem.set_bounds(&[0.0; 4], &[upper, inf, inf, inf]).unwrap();
            let solution = solver.solve(&mut problem).unwrap();
            assert!(solution.is_solved(), "{method} {upper}");
            let expected = upper.min(1.5_f64.sqrt());
            assert!((solution.z[0] - expected).abs() < 1e-8, "{method} {upper}: {:?}", solution.z);
        }
    }
}

#[test]
fn an_overflowing_merit_is_no_solution() {
    for method in Method::CLASSICAL {
        // F = e^400 at the start: its square overflows.
        let mut steep = scalar(FREE, 400.0, |z| (z.exp() - 1.0, z.exp()));
        let solution = solve(&mut steep, &siconos(method));
        let honest = solution.is_solved() == (solution.f[0].abs() <= 1e-10);
        assert!(honest, "{method}: {} at {:?}", solution.status, solution.z);
        let mut flat = scalar(NONNEGATIVE, 2.0, |z| (1e-200 * (z - 1.0), 1e-200));
        let solution = solve(&mut flat, &siconos(method));
        assert_eq!(solution.is_solved(), (solution.z[0] - 1.0).abs() < 1e-7, "{method}");
    }
}
