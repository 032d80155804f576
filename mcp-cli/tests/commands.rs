//! The commands of `mcp`: what they print, write and return.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod calls;
mod support;

use calls::{Said, folder_with, is_golden, mcp, mcp_unheard};
use serde_json::Value;
use std::fs;
use std::path::Path;
use support::node::{n, op, plus, power, v};
use support::{File, Form, INF, Kind, Row};

/// `1 + x² = 0`: no solution, which is proved.
fn positive() -> File {
    File {
        variables: vec![(-INF, INF, 1.0)],
        rows: vec![Row(Kind::Equal(0.0), Vec::new(), plus(n(1.0), power(v(0), 2.0)))],
        ..File::default()
    }
}

/// `exp(−x) = 0`: no solution, but smaller and smaller residuals.
fn at_infinity() -> File {
    File {
        variables: vec![(-INF, INF, 1.0)],
        rows: vec![Row(Kind::Equal(0.0), Vec::new(), op(44, [op(16, [v(0)])]))],
        ..File::default()
    }
}

/// `ln(x) = 0` from −1, where it is not defined.
fn outside() -> File {
    File {
        variables: vec![(-INF, INF, -1.0)],
        rows: vec![Row(Kind::Equal(0.0), Vec::new(), op(43, [v(0)]))],
        ..File::default()
    }
}

fn write(folder: &Path, name: &str, file: &File) {
    fs::write(folder.join(name), file.write(Form::Text)).unwrap();
}

fn json(folder: &Path, name: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join(name)).unwrap()).unwrap()
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn solve_prints_statement_iterations_and_report() {
    let folder = folder_with("solve", &["kojima_shindo"]);
    let Said { code, out, err } = mcp(&folder, &["solve", "kojima_shindo.nl"]);
    assert_eq!((code, err.as_str()), (0, ""));
    is_golden("solve", &out);
}

#[test]
fn log_final_prints_the_report_alone_and_none_nothing() {
    let folder = folder_with("log", &["rows"]);
    let last = mcp(&folder, &["solve", "rows.nl", "--log", "final"]);
    is_golden("solve_final", &last.out);
    let none = mcp(&folder, &["solve", "rows.nl", "--log", "none"]);
    assert_eq!((none.code, none.out.as_str(), none.err.as_str()), (0, "", ""));
}

#[test]
fn a_proof_that_there_is_no_solution_stands_below_the_report() {
    let folder = folder_with("infeasible", &[]);
    write(&folder, "positive.nl", &positive());
    let said = mcp(&folder, &["solve", "positive.nl", "--log", "final"]);
    assert_eq!(said.code, 1);
    let proof = "no solution, proved: `_scon[1]` is positive wherever its variables may be, but \
                 `_svar[1]` has no lower bound to be at\n";
    assert!(said.out.ends_with(proof), "{}", said.out);
}

#[test]
fn exit_codes_tell_solved_unsolved_misunderstood_and_unreadable_apart() {
    let folder = folder_with("codes", &["kojima_shindo"]);
    write(&folder, "infinity.nl", &at_infinity());
    fs::write(folder.join("damaged.nl"), "g3 1 1 0\n 2 2 0\n").unwrap();
    let calls: [(&[&str], i32, &str); 17] = [
        (&["solve", "kojima_shindo.nl"], 0, ""),
        (&["solve", "kojima_shindo"], 0, ""),
        (&["solve", "kojima_shindo.nl", "--max-iterations", "1"], 1, ""),
        (&["solve", "infinity.nl"], 1, ""),
        (&["solve", "damaged.nl"], 3, "error: damaged.nl: "),
        (&["solve", "missing.nl"], 3, "error: missing.nl: No such file or directory"),
        (&["solve", "missing"], 3, "error: missing.nl: No such file or directory"),
        (&["solve", "kojima_shindo.nl", "--json", "no/f"], 3, "error: no/f cannot be written: "),
        (&["solve", "kojima_shindo.nl", "--start", "none.csv"], 3, "error: none.csv: "),
        (&["solve", "kojima_shindo.nl", "--tol", "0"], 2, "error: invalid value '0'"),
        (&["solve", "kojima_shindo.nl", "--json", "-"], 2, "error: invalid value '-'"),
        (
            &["solve", "kojima_shindo", "--csv", "./kojima_shindo.nl"],
            2,
            "error: ./kojima_shindo.nl wou",
        ),
        (
            &["solve", "kojima_shindo", "--csv", "a", "--json", "./a"],
            2,
            "error: a would be written ",
        ),
        (
            &["batch", "kojima_shindo.nl", "--csv", "kojima_shindo.nl"],
            2,
            "error: kojima_shindo.nl wo",
        ),
        (&["batch", "kojima_shindo.nl", "--csv", "no/f"], 3, "error: no/f cannot be written: "),
        (&["solve"], 2, "error: the following required arguments"),
        (&["kojima_shindo.nl"], 2, "error: what is to be done with kojima_shindo.nl?"),
    ];
    for (arguments, code, message) in calls {
        let said = mcp(&folder, arguments);
        assert_eq!(said.code, code, "{arguments:?}: {said:?}");
        assert!(said.err.starts_with(message), "{arguments:?}: {}", said.err);
        assert!(code < 2 || said.out.is_empty() || arguments[0] == "solve", "{}", said.out);
        assert_eq!(said.err.is_empty(), code < 2, "{arguments:?}: {}", said.err);
    }
}

#[test]
fn the_nearest_option_method_and_command_are_suggested() {
    let folder = folder_with("nearest", &[]);
    let calls: [(&[&str], &str); 4] = [
        (&["solve", "a.nl", "--time-limt", "1"], "'--time-limit'"),
        (&["solve", "a.nl", "--method", "robst"], "'robust'"),
        (&["solve", "a.nl", "--log", "finl"], "'final'"),
        (&["slove", "a.nl"], "'solve'"),
    ];
    for (arguments, nearest) in calls {
        let said = mcp(&folder, arguments);
        assert_eq!(said.code, 2);
        assert!(said.err.contains("a similar"), "{}", said.err);
        assert!(said.err.contains(nearest), "{}", said.err);
    }
}

#[test]
fn json_has_the_documented_keys_and_all_digits() {
    let folder = folder_with("json", &["kojima_shindo"]);
    mcp(&folder, &["solve", "kojima_shindo.nl", "--json", "a.json", "--log", "none"]);
    let document = json(&folder, "a.json");
    let expected = [
        "f",
        "factorisations",
        "iterations",
        "jacobian_evaluations",
        "natural_residual",
        "relative_residual",
        "residual_evaluations",
        "seconds",
        "status",
        "variables",
        "z",
    ];
    assert_eq!(keys(&document), expected);
    assert_eq!(document["status"], "solved");
    let variables = document["variables"].as_array().unwrap();
    let of_variable = ["equation", "level", "lower", "marginal", "name", "state", "upper"];
    for (k, variable) in variables.iter().enumerate() {
        assert_eq!(keys(variable), of_variable);
        assert_eq!(variable["level"], document["z"][k]);
        assert_eq!(variable["marginal"], document["f"][k]);
    }
    let named = |name: &str| variables.iter().find(|variable| variable["name"] == name).unwrap();
    assert!((named("x[3]")["level"].as_f64().unwrap() - 3.0).abs() < 1e-12);
    assert!((named("x[2]")["marginal"].as_f64().unwrap() - 31.0).abs() < 1e-12);
    assert_eq!(named("x[2]")["state"], "at_lower");
    assert_eq!(named("x[2]")["upper"], "inf");
}

#[test]
fn json_of_a_failure_has_reason_and_advice() {
    let folder = folder_with("json_failure", &[]);
    write(&folder, "outside.nl", &outside());
    let said = mcp(&folder, &["solve", "outside.nl", "--json", "a.json", "--log", "none"]);
    assert_eq!(said.code, 1);
    let document = json(&folder, "a.json");
    assert_eq!(document["status"], "domain_error");
    assert_eq!(keys(&document).len(), 13);
    assert_eq!(document["natural_residual"], "NaN");
    let reason = document["reason"].as_str().unwrap();
    assert!(reason.contains("equation `_scon[1]`: F = NaN at _svar[1] = -1"), "{reason}");
    assert!(document["advice"].as_str().unwrap().contains("start inside its domain"));
}

#[test]
fn what_csv_and_json_wrote_are_starts() {
    let folder = folder_with("start", &["kojima_shindo"]);
    let solve = |more: &[&str]| {
        let said = mcp(&folder, &[&["solve", "kojima_shindo.nl", "--log", "none"], more].concat());
        assert_eq!((said.code, said.err.as_str()), (0, ""));
    };
    solve(&["--json", "a.json", "--csv", "a.csv"]);
    assert!(json(&folder, "a.json")["iterations"].as_u64().unwrap() > 0);
    for start in ["a.json", "a.csv"] {
        solve(&["--start", start, "--json", "b.json"]);
        let document = json(&folder, "b.json");
        assert_eq!(document["iterations"], 0, "{start}");
        assert_eq!(document["z"], json(&folder, "a.json")["z"], "{start}");
    }
    fs::write(folder.join("wrong.csv"), "x[3],1\nx[33],2\n").unwrap();
    let said = mcp(&folder, &["solve", "kojima_shindo.nl", "--start", "wrong.csv"]);
    let message = "error: wrong.csv: the model has no variable `x[33]`; did you mean `x[3]`?\n";
    assert_eq!((said.code, said.err.as_str()), (3, message));
}

#[test]
fn a_plot_is_an_svg_with_its_panels() {
    let folder = folder_with("plot", &["transport"]);
    mcp(&folder, &["solve", "transport.nl", "--plot", "a.svg", "--log", "none"]);
    let picture = fs::read_to_string(folder.join("a.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
    for label in ["transport: solved", "natural residual", "tol 1e-6", "josephy", "iteration"] {
        assert!(picture.contains(label), "{label}");
    }
}

#[test]
fn all_methods_can_be_asked_for() {
    let folder = folder_with("methods", &["nash"]);
    for method in ["robust", "newton_fb", "newton-min-fb", "710", "lemke"] {
        let arguments =
            ["solve", "nash.nl", "--method", method, "--json", "a.json", "--log", "none"];
        let said = mcp(&folder, &arguments);
        assert!(said.code < 2, "{method}: {}", said.err);
        let status = json(&folder, "a.json")["status"].clone();
        assert_eq!(said.code == 0, status == "solved", "{method}: {status}");
    }
}

#[test]
fn check_states_structure_pairs_start_and_derivatives() {
    let folder = folder_with("check", &["rows"]);
    let said = mcp(&folder, &["check", "rows.nl"]);
    assert_eq!(said.code, 0);
    is_golden("check_rows", &said.out);
}

#[test]
fn check_names_what_stops_a_solve() {
    let folder = folder_with("check_fault", &[]);
    write(&folder, "outside.nl", &outside());
    let said = mcp(&folder, &["check", "outside.nl"]);
    assert_eq!(said.code, 1);
    assert!(
        said.out.contains("\nfault: not finite at the start: F of `_scon[1]` = NaN"),
        "{}",
        said.out
    );
    let inside = "name,level\n_svar[1],2\n";
    fs::write(folder.join("inside.csv"), inside).unwrap();
    let said = mcp(&folder, &["check", "outside.nl", "--start", "inside.csv"]);
    assert!(said.code == 0 && said.out.ends_with("no faults, no warnings\n"), "{}", said.out);
}

#[test]
fn info_counts() {
    let folder = folder_with("info", &["defined", "transport"]);
    let text = |model| mcp(&folder, &["info", model]).out;
    is_golden("info", &(text("defined.nl") + "\n" + &text("transport.nl")));
}

/// The lines of a batch without their seconds, which are their last column.
fn without_seconds(text: &str) -> String {
    let cut = |line: &str| match line.trim_end().rsplit_once("  ") {
        Some((rest, last)) if last.trim().parse::<f64>().is_ok() => rest.trim_end().to_owned(),
        _ => line.rsplit_once("; ").map_or(line, |(rest, _)| rest).to_owned(),
    };
    text.lines().map(cut).collect::<Vec<_>>().join("\n") + "\n"
}

#[test]
fn batch_goes_on_behind_bad_files() {
    let folder = folder_with("batch", &["bounds", "kojima_shindo", "rows"]);
    fs::write(folder.join("damaged.nl"), "g3 1 1 0\n 2 2 0\n").unwrap();
    write(&folder, "positive.nl", &positive());
    let arguments = ["batch", ".", "missing.nl", "--jobs", "2", "--csv", "summary.csv"];
    let said = mcp(&folder, &[&arguments[..], &["--time-limit", "30"]].concat());
    assert_eq!((said.code, said.err.as_str()), (1, ""));
    is_golden("batch", &without_seconds(&said.out));

    let table = fs::read_to_string(folder.join("summary.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let columns = "file,n,nnz,status,residual,relative_residual,iterations,residual_evaluations,\
                   jacobian_evaluations,seconds,message";
    assert_eq!(rows[0].join(","), columns);
    let statuses: Vec<&str> = rows[1..].iter().map(|row| row[3]).collect();
    let expected = ["solved", "unreadable", "solved", "stationary_point", "solved", "unreadable"];
    assert_eq!(statuses, expected);
}

#[test]
fn batch_returns_zero_only_if_all_are_solved() {
    let folder = folder_with("batch_good", &["bounds", "free"]);
    assert_eq!(mcp(&folder, &["batch", "bounds.nl", "free.nl"]).code, 0);
    assert_eq!(mcp(&folder, &["batch", "bounds.nl", "--max-iterations", "0"]).code, 1);
    let folder = folder_with("batch_empty", &["bounds"]);
    fs::create_dir(folder.join("empty")).unwrap();
    let said = mcp(&folder, &["batch", "empty", "bounds.nl", "--csv", "a.csv"]);
    assert_eq!((said.code, said.err.as_str()), (1, ""));
    let lines = fs::read_to_string(folder.join("a.csv")).unwrap();
    assert!(
        lines.contains("\nempty,,,unreadable,,") && lines.contains("\nbounds.nl,7,"),
        "{lines}"
    );
}

#[test]
fn files_are_written_and_codes_true_if_nobody_reads_the_output() {
    let folder = folder_with("unheard", &["bounds", "kojima_shindo"]);
    write(&folder, "infinity.nl", &at_infinity());
    let calls: [(&[&str], i32); 3] = [
        (&["solve", "bounds.nl", "--json", "a"], 0),
        (&["solve", "infinity.nl", "--json", "b", "--csv", "c", "--plot", "d"], 1),
        (&["batch", "infinity.nl", "bounds.nl", "kojima_shindo.nl", "--csv", "e"], 1),
    ];
    for (arguments, code) in calls {
        let said = mcp_unheard(&folder, arguments);
        assert_eq!((said.code, said.err.as_str()), (code, ""), "{arguments:?}");
    }
    assert!(["a", "b", "c", "d"].iter().all(|file| folder.join(file).exists()));
    assert_eq!(fs::read_to_string(folder.join("e")).unwrap().lines().count(), 4);
}

#[test]
fn a_picture_of_nothing_is_a_warning_and_leaves_the_old_one() {
    let folder = folder_with("no_picture", &[]);
    write(&folder, "outside.nl", &outside());
    fs::write(folder.join("a.svg"), "old").unwrap();
    let arguments = ["solve", "outside.nl", "--plot", "a.svg", "--csv", "a.csv", "--log", "none"];
    let said = mcp(&folder, &arguments);
    let warning = "warning: a.svg cannot be written: there is nothing to plot: no iterate has a \
                   finite residual\n";
    assert_eq!((said.code, said.err.as_str()), (1, warning));
    assert_eq!(fs::read_to_string(folder.join("a.svg")).unwrap(), "old");
}

#[test]
fn json_has_the_variables_of_the_file_only() {
    let folder = folder_with("json_auxiliary", &[]);
    // d_0 = z_0, d_k = d_{k−1}/4 + z_k, so long a chain that the d are auxiliary variables; d_k = 1.
    let size = 3000;
    let definition = |k: usize| match k {
        0 => (vec![(0, 1.0)], n(0.0)),
        _ => (vec![(k, 1.0)], op(3, [v(size + k - 1), n(4.0)])),
    };
    let file = File {
        variables: vec![(-INF, INF, 0.25); size],
        rows: (0..size).map(|k| Row(Kind::Equal(1.0), Vec::new(), v(size + k))).collect(),
        definitions: (0..size).map(definition).collect(),
        is_incomplete: true,
    };
    write(&folder, "chain.nl", &file);
    mcp(&folder, &["solve", "chain.nl", "--json", "a.json", "--csv", "a.csv", "--log", "none"]);
    let table = fs::read_to_string(folder.join("a.csv")).unwrap();
    assert!(table.contains("_sdef[3000]"), "the chain is too short to show anything");
    let document = json(&folder, "a.json");
    for list in ["z", "f", "variables"] {
        assert_eq!(document[list].as_array().unwrap().len(), size, "{list}");
    }
    assert_eq!(document["variables"][size - 1]["name"], "_svar[3000]");
    let again = ["solve", "chain.nl", "--start", "a.json", "--json", "b.json", "--log", "none"];
    assert_eq!(mcp(&folder, &again).code, 0);
    assert_eq!(json(&folder, "b.json")["iterations"], 0, "auxiliary variables start there too");
}

#[test]
#[cfg(unix)]
fn paths_need_not_be_utf_8() {
    use std::ffi::OsString;
    use std::os::unix::ffi::OsStringExt;
    let folder = folder_with("not_utf8", &["kojima_shindo"]);
    let path = |bytes: &[u8]| OsString::from_vec(bytes.to_vec());
    let (model, stub) = (path(b"a\xff.nl"), path(b"a\xff"));
    fs::rename(folder.join("kojima_shindo.nl"), folder.join(&model)).unwrap();
    let said = mcp(&folder, std::slice::from_ref(&model));
    assert_eq!(said.code, 2);
    assert!(said.err.starts_with("error: what is to be done with a\u{fffd}.nl?"), "{}", said.err);
    assert_eq!(mcp(&folder, &["solve".into(), model.clone()]).code, 0);
    assert_eq!(mcp(&folder, &[stub, "-AMPL".into()]).code, 0);
    assert!(folder.join(path(b"a\xff.sol")).exists());
    let said = mcp(&folder, &[model, "-AMPL".into(), path(b"csv=\xff")]);
    assert_eq!((said.code, said.err.as_str()), (2, "error: csv=\u{fffd} is not UTF-8\n"));
}

#[test]
fn help_teaches_by_examples() {
    let folder = folder_with("help", &[]);
    for (arguments, example) in [
        (&["--help"][..], "mcp solve transport.nl "),
        (&["solve", "--help"], "mcp solve transport.nl --log final --csv solution.csv"),
        (&["check", "--help"], "mcp check transport.nl"),
        (&["info", "--help"], "mcp info transport.nl"),
        (&["batch", "--help"], "mcp batch models/*.nl"),
    ] {
        let said = mcp(&folder, arguments);
        assert_eq!(said.code, 0);
        assert!(said.out.contains(example), "{}", said.out);
        // Colours are for terminals.
        assert!(!said.out.contains('\u{1b}'), "{}", said.out);
    }
}
