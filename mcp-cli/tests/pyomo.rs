//! Pyomo, as its users have it, calls `mcp` and reads what it answers.
//!
//! Installs Pyomo from the Python package index in a virtual environment under `target`, once, and
//! runs `pyomo/models.py` there. Skipped, with a word, only where there is no Python.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The version the test is written for.
const PYOMO: &str = "pyomo==6.10.1";

/// What a command says; a command that fails ends the test.
fn said(command: &mut Command) -> String {
    let Output { status, stdout, stderr } = command.output().expect("the command can be started");
    let text = format!("{}{}", String::from_utf8_lossy(&stdout), String::from_utf8_lossy(&stderr));
    assert!(status.success(), "{command:?} ended with {status}:\n{text}");
    text
}

/// The Python of a virtual environment with Pyomo, made if it is not there.
fn python_with_pyomo() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pyomo-environment");
    let (python, made) = (folder.join("bin/python"), folder.join("made-for"));
    if fs::read_to_string(&made).is_ok_and(|version| version == PYOMO) {
        return python;
    }
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("a broken environment can be removed");
    }
    // On Debian this needs the package python3-venv.
    said(Command::new("python3").args(["-m", "venv"]).arg(&folder));
    said(Command::new(&python).args(["-m", "pip", "install", "--quiet", PYOMO]));
    fs::write(made, PYOMO).expect("the environment can be written");
    python
}

#[test]
#[expect(
    clippy::print_stdout,
    reason = "a skipped test says why; the others show what they compared"
)]
fn pyomo_solves_its_models_with_mcp_and_sees_failures() {
    if Command::new("python3").arg("--version").output().is_err() {
        println!("skipped: there is no python3");
        return;
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pyomo/models.py");
    let text = said(Command::new(python_with_pyomo()).arg(script).arg(env!("CARGO_BIN_EXE_mcp")));
    println!("{text}");
    let lines = |word: &str| text.lines().filter(|line| line.contains(word)).count();
    assert_eq!(lines("ok, optimal"), 7 * 4, "seven models, two writers, with and without names");
    assert_eq!(lines("warning, infeasible"), 2);
    assert_eq!(lines("warning, maxIterations"), 2);
    assert_eq!(lines("error, internalSolverError"), 2);
}
