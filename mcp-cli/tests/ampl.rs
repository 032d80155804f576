//! The convention of AMPL: `mcp MODEL -AMPL [key=value …]`.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod calls;
mod support;

use calls::{folder_with, is_golden, mcp, mcp_with};
use std::fs;
use std::path::Path;
use support::node::{n, op, plus, power, v};
use support::{File, Form, INF, Kind, Node, Row};

/// One equation `node(x) = 0`, `x` free from 1.
fn equation(node: Node) -> Vec<u8> {
    let rows = vec![Row(Kind::Equal(0.0), Vec::new(), node)];
    File { variables: vec![(-INF, INF, 1.0)], rows, ..File::default() }.write(Form::Text)
}

/// The solve-result code: the end of the last line.
fn code(folder: &Path, name: &str) -> u16 {
    let text = fs::read_to_string(folder.join(name)).unwrap();
    let last = text.lines().rfind(|line| line.starts_with("objno ")).unwrap();
    last.split(' ').nth(2).unwrap().parse().unwrap()
}

#[test]
fn a_stub_is_solved_into_its_sol_file() {
    let folder = folder_with("ampl", &["rows"]);
    for model in ["rows", "rows.nl"] {
        let said = mcp(&folder, &[model, "-AMPL"]);
        assert_eq!((said.code, said.out.as_str(), said.err.as_str()), (0, "", ""));
        let text = fs::read_to_string(folder.join("rows.sol")).unwrap();
        is_golden("rows_sol", &text.replace(env!("CARGO_PKG_VERSION"), "VERSION"));
        fs::remove_file(folder.join("rows.sol")).unwrap();
    }
}

#[test]
fn every_end_has_its_solve_result_and_exit_code_zero() {
    let folder = folder_with("ampl_codes", &["kojima_shindo"]);
    fs::write(folder.join("none.nl"), equation(plus(n(1.0), power(v(0), 2.0)))).unwrap();
    fs::write(folder.join("infinity.nl"), equation(op(44, [op(16, [v(0)])]))).unwrap();
    let calls: [(&[&str], &str, u16); 5] = [
        (&["kojima_shindo", "-AMPL"], "kojima_shindo.sol", 0),
        (&["none", "-AMPL"], "none.sol", 200),
        (&["kojima_shindo", "-AMPL", "max_iterations=1"], "kojima_shindo.sol", 400),
        (&["infinity", "-AMPL"], "infinity.sol", 500),
        (&["kojima_shindo", "-AMPL", "method=lemke"], "kojima_shindo.sol", 500),
    ];
    for (arguments, file, result) in calls {
        let said = mcp(&folder, arguments);
        assert_eq!((said.code, code(&folder, file)), (0, result), "{arguments:?}: {}", said.err);
    }
}

#[test]
fn the_message_says_what_happened_and_what_to_do() {
    let folder = folder_with("ampl_message", &[]);
    fs::write(folder.join("none.nl"), equation(plus(n(1.0), power(v(0), 2.0)))).unwrap();
    mcp(&folder, &["none", "-AMPL"]);
    let text = fs::read_to_string(folder.join("none.sol")).unwrap();
    let message: Vec<&str> = text.lines().take_while(|line| !line.is_empty()).collect();
    assert_eq!(message.len(), 3, "{message:?}");
    assert!(message[0].starts_with(concat!("mcp ", env!("CARGO_PKG_VERSION"), ": ")));
    assert!(message[0].contains("proved: `_scon[1]` is positive"), "{}", message[0]);
    assert!(message[2].starts_with("advice: "), "{}", message[2]);
}

#[test]
fn options_come_from_the_environment_and_the_command_line_wins() {
    let folder = folder_with("ampl_options", &["kojima_shindo"]);
    let options = "max_iterations=1 json='from options.json'";
    let said = mcp_with(options, &folder, &["kojima_shindo", "-AMPL"]);
    assert_eq!(said.out, "max_iterations=1\njson=from options.json\n");
    assert_eq!(code(&folder, "kojima_shindo.sol"), 400);
    assert!(folder.join("from options.json").exists());
    let said = mcp_with(options, &folder, &["kojima_shindo", "-AMPL", "max_iterations=99"]);
    assert_eq!(said.out, "json=from options.json\nmax_iterations=99\n");
    assert_eq!(code(&folder, "kojima_shindo.sol"), 0);
    assert_eq!(mcp_with(options, &folder, &["-e", "kojima_shindo", "-AMPL"]).out, "");
}

#[test]
fn a_file_of_the_keywords_that_fails_costs_no_answer() {
    let folder = folder_with("ampl_side", &["kojima_shindo"]);
    fs::write(folder.join("outside.nl"), equation(op(43, [op(16, [v(0)])]))).unwrap();
    let calls: [(&[&str], &str, &str); 3] = [
        (&["kojima_shindo", "-AMPL", "plot=no/a.svg"], "kojima_shindo.sol", "no/a.svg"),
        (
            &["kojima_shindo", "-AMPL", "json=no/a.json", "csv=a.csv"],
            "kojima_shindo.sol",
            "no/a.json",
        ),
        (&["outside", "-AMPL", "plot=a.svg"], "outside.sol", "a.svg"),
    ];
    for (arguments, solution, failed) in calls {
        let said = mcp(&folder, arguments);
        assert_eq!(said.code, 0, "{arguments:?}: {}", said.err);
        let warning = format!("warning: {failed} cannot be written: ");
        assert!(said.err.starts_with(&warning), "{arguments:?}: {}", said.err);
        fs::remove_file(folder.join(solution)).unwrap();
    }
    assert!(folder.join("a.csv").exists());
}

#[test]
fn what_is_not_understood_is_said_and_writes_no_file() {
    let folder = folder_with("ampl_wrong", &["kojima_shindo"]);
    fs::write(folder.join("damaged.nl"), "g3 1 1 0\n 2 2 0\n").unwrap();
    for stale in ["kojima_shindo.sol", "damaged.sol"] {
        fs::write(folder.join(stale), "objno 0 0").unwrap();
    }
    let calls: [(&[&str], i32, &str); 6] = [
        (
            &["kojima_shindo", "-AMPL", "csv=kojima_shindo.sol"],
            2,
            "error: kojima_shindo.sol would be written over another file of this call",
        ),
        (
            &["kojima_shindo", "-AMPL", "metod=robust"],
            2,
            "error: there is no keyword `metod`; did you mean `method`? (mcp -= lists all)\n",
        ),
        (
            &["kojima_shindo", "-AMPL", "tol=tight"],
            2,
            "error: tol=tight: expected a positive number, or none\n",
        ),
        (
            &["-x", "kojima_shindo", "-AMPL"],
            2,
            "error: there is no option `-x`; usage: mcp MODEL -AMPL [key=value ...]\n",
        ),
        (&["-AMPL"], 2, "error: no model is named; usage: mcp MODEL -AMPL [key=value ...]\n"),
        (&["damaged", "-AMPL"], 3, "error: damaged.nl: line 3, "),
    ];
    for (arguments, code, message) in calls {
        let said = mcp(&folder, arguments);
        assert_eq!(said.code, code, "{arguments:?}");
        assert!(said.err.starts_with(message), "{arguments:?}: {}", said.err);
    }
    assert!(!folder.join("kojima_shindo.sol").exists() && !folder.join("damaged.sol").exists());
}

#[test]
fn version_keywords_and_usage_are_told() {
    let folder = folder_with("ampl_told", &[]);
    let version = concat!("mcp ", env!("CARGO_PKG_VERSION"), " (mixed complementarity problems)\n");
    assert_eq!(mcp(&folder, &["-v"]).out, version);
    is_golden("keywords", &mcp(&folder, &["-="]).out);
    assert!(mcp(&folder, &["-?"]).out.starts_with("usage: mcp [-e] MODEL -AMPL"));
}
