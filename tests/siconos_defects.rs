//! The defects of the Siconos solvers, one test each: what Siconos 4.4 does, what must happen here.
//!
//! D1–D16 are the numbers of the comparison; D12 has a file of its own, `siconos_stagnation.rs`, and
//! D14 is `allocations.rs`. Every test fails when the guard it protects is removed from the sources.
//! Where more than one guard protects, the test looks at each.

mod common;

use common::{FREE, INF, NONNEGATIVE, affine, check_honest, dense, natural_residual, scalar};
use common::{siconos, solve, solve_from, watch, with_pattern};
use mcp_core::{
    Linear, Method, ModelError, Nonmonotone, Options, Pattern, Problem, Solution, Solver, Status,
    Verdict, examine, globalise::Reference, testing,
};

fn log(z: f64) -> (f64, f64) {
    (z.ln(), 1.0 / z)
}

/// D1: a full step to a point where `F` is NaN is accepted and reported as success
/// (`log z = 0` from 3: info 0, `z = −0.296`).
#[test]
fn d01_nan_is_never_success() {
    for method in Method::CLASSICAL {
        // The derivative 1/z is finite where log z is NaN: only F can tell.
        let mut problem = scalar(FREE, 3.0, log);
        let (solution, seen) = watch(&mut problem, None, &siconos(method));
        assert_eq!(solution.status, Status::Solved, "{method}");
        assert!((solution.z[0] - 1.0).abs() < 1e-9 && solution.f[0].abs() <= 1e-10, "{method}");
        assert!(seen.iter().all(|it| it.f[0].is_finite()), "{method}: NaN was accepted");

        let mut nowhere = dense(&[FREE, FREE], &[0.0, 0.0], |z, f, jac| {
            f.copy_from_slice(&[z[0], f64::NAN]);
            jac.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
        });
        let solution = solve(&mut nowhere, &siconos(method));
        assert_eq!(solution.status, Status::DomainError, "{method}");
        let fault = solution.fault.expect("a domain error names its equation");
        assert_eq!((fault.equation, fault.variable), (1, None));
        assert!(fault.value.is_nan());
    }
}

/// D1, of a fixed variable: its equation is not part of `Φ`, which must not hide its NaN.
#[test]
fn d01_nan_in_the_equation_of_a_fixed_variable_is_not_overlooked() {
    for method in Method::CLASSICAL {
        // The full step from 0 ends at 4, where the second equation holds and the first is NaN.
        let mut problem = dense(&[(1.0, 1.0), FREE], &[1.0, 0.0], |z, f, jac| {
            f.copy_from_slice(&[if z[1] > 3.0 { f64::NAN } else { 0.0 }, z[1] - 4.0]);
            jac.copy_from_slice(&[0.0, 0.0, 0.0, 1.0]);
        });
        let (solution, seen) = watch(&mut problem, None, &siconos(method));
        assert!(seen.len() > 1 && seen.iter().all(|it| it.f[0].is_finite()), "{method}");
        assert!(!solution.is_solved() && solution.f[0] == 0.0, "{method}: {}", solution.status);
        check_honest(&mut problem, &solution, &siconos(method), method.name());
    }
}

/// D2: `fmax(0, z − w)` drops a NaN, so a row with `w = NaN` at `z = 0` contributes nothing.
#[test]
fn d02_the_certificate_hides_no_nan() {
    for bounds in [NONNEGATIVE, (-INF, 0.0), (0.0, 0.0), (0.0, 1.0), FREE] {
        let mut problem = scalar(bounds, 0.0, |_| (f64::NAN, 1.0));
        let certificate = examine(&mut problem, &[0.0]).unwrap();
        assert!(certificate.natural_residual.is_nan(), "{bounds:?}: {certificate:?}");
        assert!(certificate.relative_residual.is_nan(), "{bounds:?}");
        assert!(!certificate.is_finite);
        for tol in [None, Some(1e10)] {
            assert_eq!(certificate.verdict(tol, 1e10), Verdict::Refused, "{bounds:?}");
        }
    }
}

/// D3: the error of 710 sums over the wrong rows: nothing is checked for a complementarity problem
/// (info 0 with residual 0.26), and a solved system with many equations is reported as failed.
#[test]
fn d03_solved_means_that_every_row_is_solved() {
    let options = siconos(Method::OldFb);
    let mut failures = 0;
    for mut known in [testing::kojima_shindo().unwrap(), testing::josephy().unwrap()] {
        for start in known.starts.clone() {
            let solution = solve_from(&mut known.problem, &start, &options);
            let residual = natural_residual(&mut known.problem, &solution.z);
            assert_eq!(solution.is_solved(), residual <= 1e-10, "{}: {residual:e}", known.name);
            failures += usize::from(!solution.is_solved());
        }
    }
    assert_eq!(failures, 1, "Josephy from (100, …) is the run that fails");
    let mut known = testing::rosen_suzuki().unwrap();
    assert_eq!(solve(&mut known.problem, &options).status, Status::Solved);
}

/// D4: the element at a kink is taken from `Jᵀζ`, which for a nonsymmetric `J` is no limit of
/// Jacobians.
#[test]
fn d04_the_kink_element_comes_from_j_zeta() {
    let j = [[2.0, 0.5, -1.0], [1.0, 3.0, 5.0], [4.0, -2.0, 6.0]];
    let q = vec![0.0, 0.0, -1.0];
    // Rows 0 and 1 start at a kink, ζ = (1, 1, 0); row 2 has φ(0, −1) = −2, (Da, Db) = (1, 2).
    let direction = |transposed: bool| {
        let mut h = [[0.0; 3]; 3];
        for i in 0..3 {
            let slope: f64 = (0..2).map(|k| if transposed { j[k][i] } else { j[i][k] }).sum();
            let r = 1.0_f64.hypot(slope);
            let (a, b) = if i < 2 { (1.0 - 1.0 / r, 1.0 - slope / r) } else { (1.0, 2.0) };
            for k in 0..3 {
                h[i][k] = b * j[i][k] + if i == k { a } else { 0.0 };
            }
        }
        cramer(h, [0.0, 0.0, 2.0])
    };
    let (right, wrong) = (direction(false), direction(true));
    let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum::<f64>();
    for method in [Method::NewtonFb, Method::OldFb] {
        let mut problem =
            affine(j.map(Vec::from).to_vec(), q.clone(), &[NONNEGATIVE; 3], &[0.0; 3]);
        let (_, seen) = watch(&mut problem, None, &Options::new(method));
        assert_eq!(seen[1].letter, 'F');
        let unit: Vec<f64> = seen[1].z.iter().map(|z| z / seen[1].step).collect();
        assert!(distance(&unit, &right) < 1e-12, "{method}: {unit:?} instead of {right:?}");
        assert!(distance(&unit, &wrong) > 1e-2, "{method}: the test tells the two apart");
    }
}

/// `h⁻¹ r` by Cramer's rule.
fn cramer(h: [[f64; 3]; 3], r: [f64; 3]) -> [f64; 3] {
    let det = |m: [[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
            - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    std::array::from_fn(|k| {
        let mut replaced = h;
        for i in 0..3 {
            replaced[i][k] = r[i];
        }
        det(replaced) / det(h)
    })
}

/// D5: with `α_min = 0` a search that meets only NaN never ends.
#[test]
fn d05_every_line_search_ends() {
    for method in Method::CLASSICAL {
        let none = Options::new(method).with(|o| o.armijo.smallest_step = 0.0);
        let error = Solver::new(none).err();
        assert!(matches!(error, Some(ModelError::Option { option: "armijo.smallest_step", .. })));

        let tiny = Options::new(method).with(|o| o.armijo.smallest_step = 5e-324);
        let mut island = scalar(FREE, 3.0, |z| if z == 3.0 { (1.0, 1.0) } else { (f64::NAN, 1.0) });
        let solution = solve(&mut island, &tiny);
        // 3 + t d = 3 again once t is small: F is finite there, but no smaller.
        assert_eq!(solution.status, Status::LineSearchFailed, "{method}");
        assert!(solution.stats.residual_evaluations < 1100, "{method}");
    }
}

/// D6: a sparse Jacobian aborts (700) or crashes (701).
#[test]
fn d06_sparse_jacobians_are_solved_by_a_sparse_solver() {
    let mut known = testing::obstacle(12).unwrap();
    let with_diagonal = known.problem.pattern().with_diagonal();
    assert_eq!(Linear::Auto.resolve(with_diagonal.pattern()), Linear::FaerSparse);
    for method in Method::CLASSICAL {
        let dense =
            solve(&mut known.problem, &siconos(method).with(|o| o.linear = Linear::Nalgebra));
        for linear in [Linear::Auto, Linear::FaerSparse, Linear::FaerDense] {
            let solution = solve(&mut known.problem, &siconos(method).with(|o| o.linear = linear));
            assert_eq!(solution.status, Status::Solved, "{method} {linear}");
            assert_eq!(solution.stats, dense.stats, "{method} {linear}");
            let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
            assert!(solution.z.iter().zip(&dense.z).all(near), "{method} {linear}");
        }
    }
}

/// D7: a singular system ends 700 at once and keeps 701 and 710 in place for 1000 iterations.
#[test]
fn d07_a_singular_system_is_left_or_named() {
    for method in Method::CLASSICAL {
        let parabola = |z: f64| (z * z - 1.0, 2.0 * z);
        let stuck = solve(&mut scalar(FREE, 0.0, parabola), &siconos(method));
        assert_eq!(stuck.status, Status::SingularSystem, "{method}");
        assert_eq!((stuck.stats.iterations, stuck.stats.residual_evaluations), (0, 1), "{method}");
        for (start, root) in [(0.1, 1.0), (-0.1, -1.0)] {
            let solution = solve(&mut scalar(FREE, start, parabola), &siconos(method));
            assert_eq!(solution.status, Status::Solved, "{method}");
            assert!((solution.z[0] - root).abs() < 1e-9, "{method}");
        }
        // (x² − 1, x + y) at (0, 1): J = [0 0; 1 1] is singular, the gradient (1, 1) is not zero.
        let mut leaves = dense(&[FREE, FREE], &[0.0, 1.0], |z, f, jac| {
            f.copy_from_slice(&[z[0] * z[0] - 1.0, z[0] + z[1]]);
            jac.copy_from_slice(&[2.0 * z[0], 1.0, 0.0, 1.0]);
        });
        let (solution, seen) = watch(&mut leaves, None, &siconos(method));
        assert_eq!((solution.status, seen[1].letter), (Status::Solved, 'G'), "{method}");
        assert_eq!(solution.stats.gradient_steps, 1, "{method}");
    }
}

/// D8: `√(a²+b²) − (a+b)` cancels: `φ(1e8, −1e-9)` is 0, and the loop ends too early.
#[test]
fn d08_a_small_residual_beside_a_large_variable_is_seen() {
    for method in Method::CLASSICAL {
        let mut problem = scalar(NONNEGATIVE, 1e8, |z| (1e-17 * (z - 2e8), 1e-17));
        let (_, seen) = watch(&mut problem, None, &siconos(method));
        assert!((seen[0].fb_norm / 1e-9 - 1.0).abs() < 1e-9, "{method}: {}", seen[0].fb_norm);
        let newton = siconos(method).with(|o| o.descent.rho = f64::MIN_POSITIVE);
        let solution = solve(&mut problem, &newton);
        assert_eq!((solution.status, solution.z[0]), (Status::Solved, 2e8), "{method}");
    }
}

/// D9: the non-monotone reference is `min(θ, mean)`, stricter than none; type 3 exits the process.
#[test]
fn d09_a_nonmonotone_reference_never_demands_more_than_descent() {
    for kind in [Nonmonotone::Max, Nonmonotone::Mean, Nonmonotone::ZhangHager] {
        let mut reference = Reference::new(kind, 4);
        for merit in [1.0, 5.0, 2.0, 9.0, 3.0] {
            reference.accept(merit);
            assert!(reference.value(merit) >= merit, "{kind:?} at {merit}");
        }
        assert!(reference.value(3.0) > 3.0, "{kind:?} allows an increase after larger merits");
        for method in Method::CLASSICAL {
            let mut known = testing::kojima_shindo().unwrap();
            let options = siconos(method).with(|o| o.nonmonotone = kind);
            for start in &known.starts[..3] {
                let solution = solve_from(&mut known.problem, start, &options);
                assert_eq!(solution.status, Status::Solved, "{method} {kind:?} {start:?}");
            }
        }
    }
}

/// D10: the state of 710 is global: two problems in turn, and the last one is solved twice.
#[test]
fn d10_solves_do_not_know_of_each_other() {
    // Same order, same number of nonzeros, other places: F_i = 2 z_i ± z_{i±1} − 1.
    let chain = |up: bool| {
        let n = 6;
        let other = move |i: usize| if up { (i + 1) % n } else { (i + n - 1) % n };
        let rows: Vec<_> = (0..n).map(|i| vec![i, other(i)]).collect();
        let pattern = Pattern::from_rows(&rows);
        let entries: Vec<_> = pattern.entries().map(|(_, i, j)| (i, j)).collect();
        with_pattern(pattern, &[NONNEGATIVE; 6], &[0.0; 6], move |z, f, jac| {
            for i in 0..n {
                f[i] = 2.0 * z[i] + z[other(i)] * z[other(i)] - 1.0 - i as f64;
            }
            for (value, &(i, j)) in jac.iter_mut().zip(&entries) {
                *value = if i == j { 2.0 } else { 2.0 * z[j] };
            }
        })
    };
    let (mut a, mut b) = (chain(true), chain(false));
    assert_eq!(a.pattern().nnz(), b.pattern().nnz());
    for method in Method::CLASSICAL {
        let alone = [solve(&mut a, &siconos(method)), solve(&mut b, &siconos(method))];
        assert!(alone.iter().all(Solution::is_solved) && alone[0].z != alone[1].z, "{method}");
        let mut shared = Solver::new(siconos(method)).unwrap();
        let mut own = [0, 1].map(|_| Solver::new(siconos(method)).unwrap());
        for _ in 0..2 {
            assert_eq!(*shared.solve(&mut a).unwrap(), alone[0], "{method}");
            assert_eq!(*shared.solve(&mut b).unwrap(), alone[1], "{method}");
            assert_eq!(*own[1].solve(&mut b).unwrap(), alone[1], "{method}");
            assert_eq!(*own[0].solve(&mut a).unwrap(), alone[0], "{method}");
        }
    }
}

/// D11: after falling back to the gradient, 710 demands the decrease of the rejected direction.
#[test]
fn d11_the_slope_belongs_to_the_direction_taken() {
    // F(0) = 1, F'(0) = −1e-5: the Newton step 1e5 is refused; its slope is −1, that of the
    // gradient −1e-10. The gradient step gains 1e-6, and Newton's method does the rest.
    let mut problem = scalar(FREE, 0.0, |z| (1.0 - 1e-5 * z - 1e4 * z * z, -1e-5 - 2e4 * z));
    let (solution, seen) = watch(&mut problem, None, &siconos(Method::OldFb));
    assert_eq!((solution.status, seen[1].letter), (Status::Solved, 'G'));
    assert!((solution.z[0] - 0.01).abs() < 1e-8);

    // Monotone search: the merit never rises, whatever direction is taken.
    for mut known in [testing::kojima_shindo().unwrap(), testing::josephy().unwrap()] {
        for start in known.starts.clone() {
            for method in Method::CLASSICAL {
                let (_, seen) = watch(&mut known.problem, Some(&start), &siconos(method));
                assert!(seen.windows(2).all(|two| two[1].fb_norm < two[0].fb_norm), "{method}");
            }
        }
    }
}

/// D13: without inequalities, LAPACK complains in every iteration.
#[test]
fn d13_pure_equations_are_solved() {
    for method in Method::CLASSICAL {
        // x² + y² = 5, x y = 2: (2, 1) from (3, 0.5).
        let mut problem = dense(&[FREE, FREE], &[3.0, 0.5], |z, f, jac| {
            f.copy_from_slice(&[z[0] * z[0] + z[1] * z[1] - 5.0, z[0] * z[1] - 2.0]);
            jac.copy_from_slice(&[2.0 * z[0], z[1], 2.0 * z[1], z[0]]);
        });
        let (solution, seen) = watch(&mut problem, None, &siconos(method));
        assert_eq!(solution.status, Status::Solved, "{method}");
        assert!((solution.z[0] - 2.0).abs() + (solution.z[1] - 1.0).abs() < 1e-9, "{method}");
        // Φ = F.
        let norm = seen[0].f[0].hypot(seen[0].f[1]);
        assert!((seen[0].fb_norm - norm).abs() <= 1e-15 * norm, "{method}");
    }
}

/// D15: the sparse LU does not pivot, and a second factorisation of the same matrix is refused.
#[test]
fn d15_factorisations_pivot_and_can_be_repeated() {
    // Pairs of rows [ε 1; 1 1] x + x³-terms: without pivoting, ε = 1e-20 loses all digits.
    for (n, linears) in [
        (12, vec![Linear::Stack, Linear::Nalgebra, Linear::FaerDense, Linear::FaerSparse]),
        (140, vec![Linear::Auto, Linear::FaerSparse, Linear::FaerDense]),
    ] {
        for epsilon in [0.0, 1e-20] {
            let rows: Vec<_> = (0..n).map(|i| vec![i - i % 2, i - i % 2 + 1]).collect();
            let mut problem = with_pattern(
                Pattern::from_rows(&rows),
                &vec![FREE; n],
                &vec![0.0; n],
                |z, f, jac| {
                    for k in (0..n).step_by(2) {
                        let (x, y) = (z[k], z[k + 1]);
                        f[k] = epsilon * x + y + y * y * y - 10.0;
                        f[k + 1] = x + y - 5.0;
                        jac[2 * k..2 * k + 4].copy_from_slice(&[
                            epsilon,
                            1.0,
                            1.0 + 3.0 * y * y,
                            1.0,
                        ]);
                    }
                },
            );
            for &linear in &linears {
                let mut solver =
                    Solver::new(siconos(Method::NewtonFb).with(|o| o.linear = linear)).unwrap();
                for round in 0..3 {
                    let solution = solver.solve(&mut problem).unwrap();
                    assert_eq!(solution.status, Status::Solved, "{linear} {n} {epsilon} {round}");
                    assert!(solution.stats.factorisations > 3 && solution.stats.iterations < 20);
                    let right = |z: &[f64]| (z[0] - 3.0).abs() + (z[1] - 2.0).abs() < 1e-9;
                    assert!(solution.z.chunks(2).all(right), "{linear} {n} {epsilon}");
                }
            }
        }
    }
}

/// D16: the tests of Siconos are affine with symmetric matrices, or solve nothing.
#[test]
fn d16_the_known_problems_are_nonlinear_and_nonsymmetric() {
    let nonlinear = |known: &mut testing::Known| {
        let nnz = known.problem.pattern().nnz();
        let (mut a, mut b) = (vec![0.0; nnz], vec![0.0; nnz]);
        let solution = known.solutions[0].clone();
        let beside: Vec<f64> = solution.iter().map(|z| z + 0.125).collect();
        known.problem.evaluate(&solution, None, Some(&mut a));
        known.problem.evaluate(&beside, None, Some(&mut b));
        a != b
    };
    let mut solved = 0;
    for mut known in testing::all().unwrap() {
        if known.solutions.is_empty() || !nonlinear(&mut known) {
            continue;
        }
        for method in Method::CLASSICAL {
            for start in known.starts.clone() {
                let solution = solve_from(&mut known.problem, &start, &siconos(method));
                let near = |known: &Vec<f64>| {
                    known.iter().zip(&solution.z).all(|(a, b)| (a - b).abs() < 1e-6)
                };
                let listed = known.solutions.iter().any(near);
                assert!(!solution.is_solved() || listed, "{} {method} {start:?}", known.name);
                solved += usize::from(solution.is_solved() && solution.stats.iterations > 1);
            }
        }
    }
    assert!(solved >= 30, "only {solved} nonlinear runs were solved");
}
