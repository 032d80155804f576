//! The files of `examples/data/nl`: written as they stand there, solved with the digits that stand
//! in `solutions.txt`.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use mcp_cli::nl::{Names, NlModel};
use mcp_core::{Model, Options, Solution, check_derivatives, solve};
use std::fmt::Write as _;
use std::fs;
use support::library::{directory, written};

/// The library, in the order of its names.
fn library() -> Vec<(String, NlModel)> {
    let files = fs::read_dir(directory()).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> =
        files.filter(|path| path.extension().is_some_and(|e| e == "nl")).collect();
    files.sort();
    let name = |path: &std::path::Path| path.file_stem().unwrap().to_str().unwrap().to_owned();
    files.iter().map(|path| (name(path), NlModel::read(path).unwrap())).collect()
}

fn solved(name: &str) -> (NlModel, Solution) {
    let model = NlModel::read(&directory().join(name)).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    (model, solution)
}

#[test]
fn written_files_are_those_of_the_library() {
    for entry in written() {
        let stub = directory().join(entry.name);
        assert_eq!(entry.file.write(entry.form), fs::read(stub.with_extension("nl")).unwrap());
        if let Some((columns, rows)) = entry.names {
            for (suffix, names) in [("col", columns), ("row", rows)] {
                let text = fs::read_to_string(stub.with_extension(suffix)).unwrap();
                assert!(text.lines().eq(names), "{}.{suffix}", entry.name);
            }
        }
    }
}

#[test]
fn every_file_of_the_library_is_solved_with_the_digits_of_solutions_txt() {
    let mut found = String::new();
    for (name, model) in library() {
        let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
        for (j, z) in model.file_levels(&solution.z).iter().enumerate() {
            // No sign on zero.
            let z = (z * 1e7).round() / 1e7 + 0.0;
            writeln!(found, "{name} {} {z:.7}", model.shape().variable_name(j)).unwrap();
        }
    }
    let expected = fs::read_to_string(directory().join("solutions.txt")).unwrap();
    let difference =
        expected.lines().zip(found.lines()).find(|(expected, found)| expected != found);
    assert!(expected == found, "first difference {difference:?}; now:\n{found}");
}

#[test]
fn derivatives_of_every_file_are_right_at_its_start_and_at_its_solution() {
    for (name, model) in library() {
        let solution = solve(&model, &Options::default()).unwrap();
        for z in [model.shape().start(), &solution.z] {
            let report = check_derivatives(&model, z).unwrap();
            report.verdict().unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        }
    }
}

#[test]
fn dantzig_ships_for_153_675_thousand_dollars() {
    let (_, solution) = solved("transport");
    // The published prices of GAMS model library `transmcp`; shipments are not unique.
    for (market, price, demand) in
        [("new-york", 0.225, 325.0), ("chicago", 0.153, 300.0), ("topeka", 0.126, 275.0)]
    {
        assert!((solution.level(&format!("p[{market}]")).unwrap() - price).abs() < 1e-9);
        let shipped = ["seattle", "san-diego"]
            .map(|plant| solution.level(&format!("x[{plant},{market}]")).unwrap());
        assert!((shipped[0] + shipped[1] - demand).abs() < 1e-6);
    }
}

#[test]
fn five_firms_produce_what_murphy_sherali_and_soyster_published() {
    let (_, solution) = solved("nash");
    for (i, published) in [36.9325, 41.8181, 43.7066, 42.6592, 39.1790].into_iter().enumerate() {
        let quantity = solution.level(&format!("q[{i}]")).unwrap();
        assert!((quantity - published).abs() < 5.1e-5, "q[{i}] = {quantity}");
    }
}

#[test]
fn kojima_and_shindo_have_a_degenerate_and_a_regular_solution() {
    let degenerate = [1.5_f64.sqrt(), 0.0, 0.0, 0.5];
    let regular = [1.0, 0.0, 3.0, 0.0];
    let files = [
        ("kojima_shindo", "x"),
        ("kojima_shindo_little_endian", "_svar"),
        ("kojima_shindo_big_endian", "_svar"),
    ];
    for (name, family) in files {
        let (_, solution) = solved(name);
        let z: Vec<f64> =
            (1..=4).map(|k| solution.level(&format!("{family}[{k}]")).unwrap()).collect();
        let is = |expected: [f64; 4]| z.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(is(degenerate) || is(regular), "{name}: {z:?}");
    }
}

#[test]
fn every_kind_of_row_gives_the_solution_by_hand() {
    for name in ["rows", "rows_little_endian"] {
        let (model, solution) = solved(name);
        for (z, expected) in solution.z.iter().zip([2.0, 5.0, 1.0, 3.0, 2.0, 3.0, 3.0, 2.0, 0.0]) {
            assert!((z - expected).abs() < 1e-8);
        }
        let rows = model.row_values(&solution.z, &solution.f);
        for (row, expected) in rows.iter().zip([0.0, -4.0, -4.0, 0.0, 13.0, 0.0, 0.0, 6.0, 1.0]) {
            assert!((row - expected).abs() < 1e-8);
        }
    }
}

#[test]
fn text_and_binary_give_the_same_bits() {
    for entry in written() {
        let models = support::FORMS
            .map(|form| NlModel::parse(&entry.file.write(form), Names::default()).unwrap());
        let solutions = models.each_ref().map(|model| solve(model, &Options::default()).unwrap().z);
        assert_eq!(solutions[0], solutions[1]);
        assert_eq!(solutions[0], solutions[2]);
    }
}
