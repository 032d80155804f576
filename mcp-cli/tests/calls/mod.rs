//! Running the command line, and places for its files.
#![allow(dead_code, reason = "every test uses a part")]

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a call gave.
#[derive(Clone, Debug)]
pub(crate) struct Said {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// Calls `mcp` in `folder`, with `mcp_options` as given.
pub(crate) fn mcp_with(options: &str, folder: &Path, arguments: &[impl AsRef<OsStr>]) -> Said {
    said(
        Command::new(env!("CARGO_BIN_EXE_mcp")).args(arguments).env("mcp_options", options),
        folder,
    )
}

/// Calls `mcp` in `folder`, with nobody who reads what it prints.
pub(crate) fn mcp_unheard(folder: &Path, arguments: &[&str]) -> Said {
    let (reader, writer) = std::io::pipe().expect("a pipe can be made");
    drop(reader);
    let mut command = Command::new(env!("CARGO_BIN_EXE_mcp"));
    said(command.args(arguments).env("mcp_options", "").stdout(Stdio::from(writer)), folder)
}

fn said(command: &mut Command, folder: &Path) -> Said {
    let output = command.current_dir(folder).output().expect("mcp can be started");
    let text = |bytes| String::from_utf8(bytes).expect("mcp writes UTF-8");
    Said {
        code: output.status.code().expect("mcp is not killed"),
        out: text(output.stdout),
        err: text(output.stderr),
    }
}

/// Calls `mcp` in `folder`.
pub(crate) fn mcp(folder: &Path, arguments: &[impl AsRef<OsStr>]) -> Said {
    mcp_with("", folder, arguments)
}

/// An empty folder of this name.
pub(crate) fn empty_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("an old folder can be removed");
    }
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// A folder of this name with these models of `examples/data/nl`, names included.
pub(crate) fn folder_with(name: &str, models: &[&str]) -> PathBuf {
    let folder = empty_folder(name);
    let library = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/data/nl");
    for model in models {
        for end in ["nl", "col", "row"] {
            let file = format!("{model}.{end}");
            if library.join(&file).exists() {
                fs::copy(library.join(&file), folder.join(&file)).expect("a file can be copied");
            }
        }
    }
    folder
}

/// Compares with `tests/golden/NAME.txt`, digit by digit, so models are small: from 16 variables on
/// the linear algebra is other people's and may round differently on another
/// processor. With `MCP_GOLDEN=write` in the environment writes it.
#[track_caller]
pub(crate) fn is_golden(name: &str, found: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    let path = path.with_extension("txt");
    if std::env::var_os("MCP_GOLDEN").is_some_and(|wish| wish == "write") {
        fs::write(&path, found).expect("a golden file can be written");
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    let line = expected.lines().zip(found.lines()).position(|(expected, found)| expected != found);
    assert!(
        expected == found,
        "{} differs, first in line {}; found:\n{found}",
        path.display(),
        line.map_or("the last".to_owned(), |line| (line + 1).to_string()),
    );
}
