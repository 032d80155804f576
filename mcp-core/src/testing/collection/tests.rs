use super::archive::{Archive, fnv1a};
use super::*;
use crate::testing::{enumerate_affine, judge};
use crate::{Options, Problem, Proof, Solver, certify, solve_from};

const RANDOM_BYTES: &[u8] = include_bytes!("../data/random.bin");
const VALUES_BYTES: &[u8] = include_bytes!("../data/values.bin");
/// Bounds, two points and `F` there, of every instance, computed by the Python study.
const VALUES: Archive = Archive::new(VALUES_BYTES);

#[test]
fn the_data_are_those_that_were_exported() {
    assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8, "test vector of the authors");
    assert_eq!(fnv1a(RANDOM_BYTES), 0x819c_30c6_4869_1e4b);
    assert_eq!(fnv1a(VALUES_BYTES), 0x3a77_f3f1_95fa_d6f3);
}

#[test]
fn there_are_237_instances_231_of_them_solvable() {
    let counts = families().map(|name| family(name).unwrap().len());
    assert_eq!(counts, [74, 23, 12, 15, 12, 50, 46, 5]);
    let all = all().unwrap();
    assert_eq!((all.len(), all.iter().filter(|p| p.solvable).count()), (237, 231));
    assert!(family("smal").unwrap().is_empty());
    assert!(all.iter().all(|p| families().contains(&p.family) && !p.source.is_empty()));
}

#[test]
fn names_and_their_order_are_those_of_the_study() {
    let names: Vec<String> = all().unwrap().into_iter().map(|p| p.name).collect();
    let stored: Vec<String> =
        VALUES.names().filter_map(|name| name.strip_suffix("/z0").map(str::to_owned)).collect();
    assert_eq!(names, stored);
    assert_eq!(named("josephy-3").unwrap().unwrap().start, [100.0; 4]);
    assert!(named("josephy").unwrap().is_none());
}

/// The definitions of the model, the price indices, are read over intervals as well.
#[test]
fn scarfs_equilibrium_is_proved() {
    let model = exchange::scarf_with_numeraire().unwrap();
    let start = named("scarfmcp-1").unwrap().unwrap().start;
    let solution = solve_from(&model, &start, &Options::default()).unwrap().solved().unwrap();
    let accuracy = certify(&model, &solution).unwrap();
    assert!(matches!(accuracy.proof, Proof::Proved { radius } if radius < 1e-6), "{accuracy}");
}

/// The same bits, or the last digits of a product of sines raised to a power.
fn assert_same(found: &[f64], expected: &[f64], last_digits: bool, case: &str) {
    assert_eq!(found.len(), expected.len(), "{case}");
    for (&found, &expected) in found.iter().zip(expected) {
        let near = last_digits && (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs();
        assert!(found.to_bits() == expected.to_bits() || near, "{case}: {found:e}, {expected:e}");
    }
}

#[test]
fn starts_and_bounds_are_those_of_the_study_bit_for_bit() {
    for instance in all().unwrap() {
        let Instance { name, start, .. } = &instance;
        let get = |what| VALUES.get(&format!("{name}/{what}"));
        let problem = instance.problem().unwrap();
        let bounds = problem.shape().bounds();
        let last_digits = name.starts_with("obstacle");
        assert_same(start, &get("z0"), last_digits, name);
        assert_same(bounds.lower(), &get("l"), last_digits, name);
        assert_same(bounds.upper(), &get("u"), last_digits, name);
        let mut moved = start.clone();
        bounds.project(&mut moved);
        assert_eq!(problem.shape().start(), moved, "{name}");
    }
}

/// Sizes of the terms of every row: `|F_i| + Σ_j |∂F_i/∂z_j z_j|`.
fn terms(problem: &mut dyn Problem, z: &[f64], f: &mut [f64]) -> Vec<f64> {
    let mut jacobian = vec![0.0; problem.pattern().nnz()];
    problem.evaluate(z, Some(f), Some(&mut jacobian));
    let mut terms: Vec<f64> = f.iter().map(|f| f.abs()).collect();
    for (k, i, j) in problem.pattern().entries() {
        terms[i] += (jacobian[k] * z[j]).abs();
    }
    terms
}

#[test]
fn f_has_the_values_of_the_study_at_the_start_and_at_a_second_point() {
    for instance in all().unwrap() {
        let mut problem = instance.problem().unwrap();
        for (point, values) in [("z0", "f0"), ("z1", "f1")] {
            let get = |what| VALUES.get(&format!("{}/{what}", instance.name));
            let (z, expected) = (get(point), get(values));
            let mut f = vec![0.0; z.len()];
            let terms = terms(&mut *problem, &z, &mut f);
            for i in 0..z.len() {
                let same = f[i].to_bits() == expected[i].to_bits();
                let near = (f[i] - expected[i]).abs() <= 1e-12 * terms[i];
                assert!(
                    same || near,
                    "{} at {point}, row {i}: {:e} is not {:e}",
                    instance.name,
                    f[i],
                    expected[i]
                );
            }
        }
    }
}

#[test]
fn jacobians_agree_with_a_second_arithmetic_and_with_differences() {
    for instance in all().unwrap().into_iter().filter(|p| p.family != "scaled") {
        let problem = instance.problem().unwrap();
        let report = instance.check_derivatives(problem.shape().start()).unwrap();
        let name = &instance.name;
        let report = report.verdict().unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        // The start of the helical valley lies on the cut of `atan2`.
        assert_eq!(report.kinks, usize::from(name == "helical"), "{name}: {report}");
        assert_eq!(report.beyond_domain, 0, "{name}: {report}");
    }
}

#[test]
fn the_jacobian_of_a_scaled_instance_is_the_scaled_jacobian() {
    let scaled = named("kojshin-1~rc4").unwrap().unwrap();
    let get = |what| archive::RANDOM.get(&format!("kojshin-1~rc4/{what}"));
    let (rows, columns) = (get("rows"), get("columns"));
    let (mut problem, mut original) = (scaled.problem().unwrap(), scaled.original().unwrap());
    let z = [0.5, 1.5, 0.25, 2.0];
    let y: Vec<f64> = z.iter().zip(&columns).map(|(z, c)| z / c).collect();
    let (mut jac, mut expected) = ([0.0; 16], [0.0; 16]);
    problem.evaluate(&y, None, Some(&mut jac));
    original.evaluate(&scaled.to_original(&y), None, Some(&mut expected));
    for (k, i, j) in original.pattern().entries() {
        let expected = rows[i] * expected[k] * columns[j];
        assert!((jac[k] - expected).abs() <= 1e-15 * expected.abs());
    }
}

#[test]
fn known_solutions_satisfy_the_judge() {
    let mut count = 0;
    for instance in all().unwrap() {
        for solution in &instance.solutions {
            let judgement = judge(&instance, solution).unwrap();
            assert!(judgement.accepts(), "{}: {judgement:?}", instance.name);
            count += 1;
        }
    }
    assert_eq!(count, 130, "solutions, those of scaled instances included");
}

#[test]
fn enumeration_finds_what_is_known_of_small_affine_instances_and_nothing_where_nothing_exists() {
    let mut enumerated = Vec::new();
    for instance in all().unwrap() {
        let mut problem = instance.original().unwrap();
        let Some(found) = enumerate_affine(&mut *problem) else { continue };
        assert_eq!(found.undecided, 0, "{}", instance.name);
        assert_eq!(found.solutions.len(), usize::from(instance.solvable), "{}", instance.name);
        for known in &instance.solutions {
            let known = instance.to_original(known);
            let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-14;
            assert!(found.solutions[0].iter().zip(&known).all(near), "{}", instance.name);
        }
        enumerated.push(instance.name.clone());
    }
    let affine = ["cycle-lcp", "munson1", "cyc3", "munson1~rc4", "munson1~rc8"];
    assert_eq!(enumerated[..5], affine);
    assert_eq!(enumerated[5..], ["none-lcp", "none-lcp2", "none-singular"]);
}

/// Published values in the order of the variables, from the first on, and half a unit of their last
/// digit.
const PUBLISHED: [(&str, &[f64], f64); 3] = [
    ("nash5-2", &[36.9325, 41.8181, 43.7066, 42.6592, 39.1790], 0.5e-4),
    ("colvnlp-2", &[0.3, 0.333_467_61, 0.4, 0.428_310_10, 0.223_964_87], 0.5e-8),
    (
        "hs100",
        &[2.330_499, 1.951_372, -0.477_541_4, 4.365_726, -0.624_487_0, 1.038_131, 1.594_227],
        0.5e-6,
    ),
];

#[test]
fn what_is_solved_agrees_with_what_is_published_to_the_printed_digits() {
    for (name, published, half_a_digit) in PUBLISHED {
        let instance = named(name).unwrap().unwrap();
        let mut solver = Solver::new(Options::default()).unwrap();
        let solution = solver.solve(&mut *instance.problem().unwrap()).unwrap();
        assert!(solution.is_solved(), "{name}: {}", solution.status);
        for (z, published) in solution.z.iter().zip(published) {
            assert!((z - published).abs() <= half_a_digit, "{name}: {z} is not {published}");
        }
    }
}
