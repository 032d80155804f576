//! Damaged and hostile files: an error, in bounded time, whatever the bytes.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use mcp_cli::nl::{Names, NlModel};
use mcp_core::{AdProblem, Problem};
use proptest::prelude::*;
use std::fs;
use std::sync::LazyLock;
use std::time::{Duration, Instant};
use support::FORMS;
use support::library::{directory, written};

/// All files of the library, and the written ones in all forms.
static FILES: LazyLock<Vec<Vec<u8>>> = LazyLock::new(files);

fn files() -> Vec<Vec<u8>> {
    let library = fs::read_dir(directory()).unwrap().map(|entry| entry.unwrap().path());
    let is_nl = |path: &std::path::PathBuf| path.extension().is_some_and(|e| e == "nl");
    let mut files: Vec<Vec<u8>> =
        library.filter(is_nl).map(|path| fs::read(path).unwrap()).collect();
    for entry in written() {
        files.extend(FORMS.map(|form| entry.file.write(form)));
    }
    files
}

/// Reads bytes; if they are a model, evaluates it.
fn survive(bytes: &[u8]) {
    let Ok(model) = NlModel::parse(bytes, Names::default()) else { return };
    let Ok(mut problem) = AdProblem::new(&model) else { return };
    let z = problem.shape().start().to_vec();
    let (mut f, mut jac) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(&z, Some(&mut f), Some(&mut jac));
    assert_eq!(model.row_values(&z, &f).len(), model.constraints());
    assert!(model.sol(&z, &f, "message\n\nmore", 500).contains("\nOptions\n"));
}

#[test]
fn a_file_cut_anywhere_is_an_error_or_a_model_but_no_panic() {
    for file in &*FILES {
        (0..file.len()).for_each(|length| survive(&file[..length]));
    }
}

#[test]
fn a_cut_in_front_of_the_bounds_of_the_variables_is_an_error() {
    for file in &*FILES {
        let ends = [b"\nb\n".as_slice(), b"\nb\t#"];
        let cut = file.windows(3).position(|window| ends.iter().any(|end| end[..3] == *window));
        if let Some(cut) = cut {
            let error = NlModel::parse(&file[..cut], Names::default()).unwrap_err().to_string();
            assert!(error.contains("expected a segment b, found the end of the file"), "{error}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 6000,
        rng_seed: proptest::test_runner::RngSeed::Fixed(20_260_101),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// Up to eight bytes replaced, removed or doubled, or a piece copied elsewhere.
    #[test]
    fn a_mutated_file_is_an_error_or_a_model_but_no_panic(
        which in any::<prop::sample::Index>(),
        changes in prop::collection::vec(
            (any::<prop::sample::Index>(), 0..5_u8, any::<u8>(), 1..40_usize), 1..8),
    ) {
        let mut bytes = which.get(&FILES).clone();
        for (place, kind, byte, length) in changes {
            if bytes.is_empty() {
                break;
            }
            let at = place.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => { bytes.remove(at); }
                2 => bytes.insert(at, byte),
                // Digits and letters of the format are more telling than any byte.
                3 => bytes[at] = b"0123456789-+.enovslCVJOGFSLrbkKxdhf \n#"[usize::from(byte) % 38],
                _ => {
                    let piece = bytes[at..bytes.len().min(at + length)].to_vec();
                    let to = usize::from(byte) * bytes.len() / 256;
                    bytes.splice(to..to, piece);
                }
            }
        }
        survive(&bytes);
    }

    /// The header of a text file and anything behind it.
    #[test]
    fn any_bytes_behind_a_header_are_an_error_or_a_model(rest in prop::collection::vec(any::<u8>(), 0..60)) {
        for arithmetic in 0..3 {
            let letter = if arithmetic == 0 { 'g' } else { 'b' };
            let mut bytes = header(letter, arithmetic, 2, 2).into_bytes();
            bytes.extend_from_slice(&rest);
            survive(&bytes);
        }
    }
}

fn header(letter: char, arithmetic: usize, variables: u64, rows: u64) -> String {
    format!(
        "{letter}3 1 1 0\n {variables} {rows} 0 0 0\n {rows} 0\n 0 0\n {variables} 0 0\n \
         0 0 {arithmetic} 1\n 0 0 0 0 0\n 0 0\n 0 0\n 0 0 0 0 0\n"
    )
}

/// Runs and gives the seconds it took.
fn seconds(run: impl FnOnce()) -> Duration {
    let clock = Instant::now();
    run();
    clock.elapsed()
}

#[test]
fn nothing_is_allocated_for_what_a_header_or_a_count_claims() {
    let huge = 1_u64 << 31;
    let claims = [
        header('g', 0, huge, huge),
        header('g', 0, huge, huge) + "r\n3\n",
        header('g', 0, huge, huge) + "C2147483646\nn0\n",
        header('g', 0, huge, huge) + "J2147483646 2147483647\n0 1\n",
        header('g', 0, 1, 1) + "C0\no54\n999999999999\nv0\n",
        header('g', 0, 1, 1) + "C0\no64\n999999999999\nn1\n",
        header('g', 0, 1, 1) + "S0 999999999999 a\n0 1\n",
        header('g', 0, 1, 1) + "x999999999999\n0 1\n",
    ];
    for claim in claims {
        let time = seconds(|| {
            let error = NlModel::parse(claim.as_bytes(), Names::default()).unwrap_err().to_string();
            assert!(error.contains("found the end of the file"), "{error}");
        });
        assert!(time < Duration::from_secs(1), "{time:?}");
    }
    let too_many = NlModel::parse(header('g', 0, huge + 1, 1).as_bytes(), Names::default());
    assert_eq!(
        too_many.unwrap_err().to_string(),
        "line 2, header line 2: expected counts up to 2^31, found `2147483649`"
    );
    let mut name = header('b', 1, 1, 1).into_bytes();
    name.extend_from_slice(b"S\0\0\0\0\x01\0\0\0\xff\xff\xff\x7fabc");
    assert!(NlModel::parse(&name, Names::default()).unwrap_err().to_string().contains("a name"));
}

/// `z0` behind a million operators, in front of, or between, their other operands.
fn nested(open: &str, close: &str) -> String {
    let depth = 1_000_000;
    let mut text = header('g', 0, 1, 1) + "C0\n";
    text += &open.repeat(depth);
    text += "v0\n";
    text += &close.repeat(depth);
    text + "r\n4 1\nb\n3\nk0\nJ0 1\n0 0\n"
}

#[test]
fn expressions_nested_a_million_deep_are_read_evaluated_cloned_and_dropped() {
    let cases = [
        ("o16\n", "", -1.0 + 1.0),         // −(−(… z0))
        ("o0\n", "n1\n", 1e6),             // ((z0 + 1) + 1) …
        ("o0\nn1\n", "", 1e6),             // 1 + (1 + (… + z0))
        ("o35\nn1\n", "n0\n", 0.0),        // if 1 then (if 1 then …)
        ("o54\n2\nv0\n", "", 1_000_000.0), // z0 + (z0 + …)
    ];
    for (open, close, added) in cases {
        let bytes = nested(open, close);
        let model = NlModel::parse(bytes.as_bytes(), Names::default()).unwrap();
        let copy = model.clone();
        drop(model);
        let mut problem = AdProblem::new(&copy).unwrap();
        let (mut f, mut jac) = ([0.0], [0.0]);
        problem.evaluate(&[1.0], Some(&mut f), Some(&mut jac));
        assert_eq!(f[0], 1.0 + added - 1.0, "{open:?}");
        let slope = if open.contains("v0") { 1e6 + 1.0 } else { 1.0 };
        assert_eq!(jac[0], slope, "{open:?}");
    }
}

#[test]
fn operators_that_never_end_are_an_error_at_the_end_of_the_file() {
    let bytes = header('g', 0, 1, 1) + "C0\n" + &"o0\n".repeat(1_000_000);
    let error = NlModel::parse(bytes.as_bytes(), Names::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 1000012, segment C0: expected an expression, found the end of the file"
    );
}
