//! Colours of what the commands print themselves: on a terminal only.

use std::io::{self, IsTerminal, Write};

/// Whether to colour: standard output is a terminal that can, and `NO_COLOR` is not set.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    colors: bool,
}

impl Style {
    /// For standard output.
    pub(crate) fn of_stdout() -> Self {
        let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
        let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
        Style { colors: io::stdout().is_terminal() && !is_set("NO_COLOR") && !is_dumb }
    }

    /// Green if good, red if not.
    pub(crate) fn verdict(self, text: &str, is_good: bool) -> String {
        match (self.colors, is_good) {
            (false, _) => text.to_owned(),
            (true, true) => format!("\u{1b}[32m{text}\u{1b}[0m"),
            (true, false) => format!("\u{1b}[31m{text}\u{1b}[0m"),
        }
    }

    /// Writes a report, its line of status coloured.
    pub(crate) fn report(
        self,
        text: &str,
        is_solved: bool,
        out: &mut impl Write,
    ) -> io::Result<()> {
        for line in text.lines() {
            if line.starts_with(" status ") {
                writeln!(out, "{}", self.verdict(line, is_solved))?;
            } else {
                writeln!(out, "{line}")?;
            }
        }
        Ok(())
    }
}
