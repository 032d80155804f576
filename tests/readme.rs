//! The errors that the README shows are those of the compiler.

use std::fs;
use std::path::Path;

/// What the compiler says to a test case of the macros.
fn compiler_says(case: &str) -> String {
    let ui = Path::new(env!("CARGO_MANIFEST_DIR")).join("mcp-core/tests/ui");
    fs::read_to_string(ui.join(case).with_extension("stderr")).expect("the case has been compiled")
}

/// The errors in the README, line by line.
fn shown() -> Vec<Vec<String>> {
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let readme = fs::read_to_string(readme).expect("there is a README");
    let blocks = readme.split("```text\n").skip(1).filter_map(|rest| rest.split("```").next());
    let errors = blocks.filter(|block| block.trim_start().starts_with("error"));
    // Blocks in lists are indented by three blanks.
    let line = |line: &str| line.strip_prefix("   ").unwrap_or(line).to_owned();
    errors.map(|block| block.trim_end().lines().map(line).collect()).collect()
}

#[test]
fn errors_in_the_readme_are_real() {
    let shown = shown();
    let cases = ["typo", "swapped"];
    assert_eq!(shown.len(), cases.len());
    for (lines, case) in shown.iter().zip(cases) {
        let said = compiler_says(case);
        let mut rest = said.lines();
        for line in lines {
            assert!(
                rest.any(|said| said == line),
                "`{line}` is not what the compiler says:\n{said}"
            );
        }
    }
}
