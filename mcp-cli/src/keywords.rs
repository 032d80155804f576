//! Keywords of the AMPL convention: `key=value` behind `-AMPL` and in `mcp_options`.

use crate::args::{Files, Log, Settings, output, seconds, tolerance};
use clap::ValueEnum;
use mcp_core::Method;
use mcp_core::error::{did_you_mean, nearest};
use std::ffi::OsString;
use std::fmt::Write;

/// A keyword.
#[derive(Debug)]
struct Keyword {
    name: &'static str,
    /// What PATH calls it, where that is another name.
    path_name: Option<&'static str>,
    value: &'static str,
    about: &'static str,
    /// All values, where they are few.
    choices: Option<fn() -> Vec<String>>,
    set: fn(&mut Assigned, &str) -> Result<(), String>,
}

/// All keywords.
const KEYWORDS: [Keyword; 8] = [
    Keyword {
        name: "csv",
        path_name: None,
        value: "FILE",
        about: "write all variables as CSV",
        choices: None,
        set: |to, value| {
            to.files.csv = Some(output(value.into())?);
            Ok(())
        },
    },
    Keyword {
        name: "json",
        path_name: None,
        value: "FILE",
        about: "write status, point, residuals and costs as JSON",
        choices: None,
        set: |to, value| {
            to.files.json = Some(output(value.into())?);
            Ok(())
        },
    },
    Keyword {
        name: "log",
        path_name: None,
        value: "WHAT",
        about: "what is printed (default none)",
        choices: Some(log_names),
        set: |to, value| {
            let wrong = |_| format!("expected {}", listed(&log_names()));
            to.log = Log::from_str(value, false).map_err(wrong)?;
            Ok(())
        },
    },
    Keyword {
        name: "max_iterations",
        path_name: Some("major_iteration_limit"),
        value: "N",
        about: "iterations before giving up (default by method)",
        choices: None,
        set: |to, value| {
            let limit = value.parse().map_err(|_| "expected a whole number".to_owned())?;
            to.settings.max_iterations = Some(limit);
            Ok(())
        },
    },
    Keyword {
        name: "method",
        path_name: None,
        value: "NAME",
        about: "the algorithm (default robust)",
        choices: Some(method_names),
        set: |to, value| {
            to.settings.method =
                value.parse().map_err(|e: mcp_core::UnknownMethod| e.to_string())?;
            Ok(())
        },
    },
    Keyword {
        name: "plot",
        path_name: None,
        value: "FILE.svg",
        about: "draw residual, steps and changes of the active set",
        choices: None,
        set: |to, value| {
            to.files.plot = Some(output(value.into())?);
            Ok(())
        },
    },
    Keyword {
        name: "time_limit",
        path_name: None,
        value: "S",
        about: "seconds before giving up (default none)",
        choices: None,
        set: |to, value| {
            to.settings.time_limit = Some(seconds(value)?);
            Ok(())
        },
    },
    Keyword {
        name: "tol",
        path_name: Some("convergence_tolerance"),
        value: "T",
        about: "largest natural residual, or none (default 1e-6)",
        choices: None,
        set: |to, value| {
            to.settings.tol = tolerance(value)?;
            Ok(())
        },
    },
];

/// What keywords were given.
#[derive(Debug)]
pub(crate) struct Assigned {
    /// How the model is solved.
    pub(crate) settings: Settings,
    /// Files beside the model.
    pub(crate) files: Files,
    /// What is printed; nothing by default, since AMPL prints the message of the `.sol` file.
    pub(crate) log: Log,
    /// The assignments that hold, to be echoed.
    pub(crate) echo: Vec<String>,
}

/// What is wrong with an assignment.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum KeywordError {
    /// There is no such keyword.
    #[error("there is no keyword `{name}`{} (mcp -= lists all)", did_you_mean(.nearest.as_deref()))]
    Unknown {
        /// What was given.
        name: String,
        /// The nearest keyword, if one is near.
        nearest: Option<String>,
    },
    /// A keyword stands without a value.
    #[error("the keyword `{name}` has no value: write {name}=value")]
    NoValue {
        /// The keyword.
        name: String,
    },
    /// A value that the keyword cannot have.
    #[error("{name}={value}: {reason}")]
    Value {
        /// The keyword.
        name: String,
        /// What was given.
        value: String,
        /// What is expected.
        reason: String,
    },
    /// An assignment that is no text.
    #[error("{0} is not UTF-8")]
    NotText(String),
    /// An option of AMPL's command line that is not understood, or no model.
    #[error("{0}; usage: mcp MODEL -AMPL [key=value ...]")]
    Usage(String),
}

impl Assigned {
    /// From `mcp_options` and then the command line, so that the latter wins.
    ///
    /// # Errors
    /// [`KeywordError`] names the first assignment that cannot be understood.
    pub(crate) fn from(environment: &str, arguments: &[OsString]) -> Result<Self, KeywordError> {
        let (settings, files) = (Settings::default(), Files::default());
        let mut assigned = Assigned { settings, files, log: Log::None, echo: Vec::new() };
        let mut rest = environment.trim_start();
        while !rest.is_empty() {
            let (name, value, behind) = first_assignment(rest)?;
            assigned.assign(name, value)?;
            rest = behind;
        }
        for argument in arguments {
            let text = argument.to_str();
            let text = text.ok_or_else(|| KeywordError::NotText(argument.display().to_string()))?;
            let (name, value) = text
                .split_once('=')
                .ok_or_else(|| KeywordError::NoValue { name: text.to_owned() })?;
            assigned.assign(name.trim(), value.trim())?;
        }
        Ok(assigned)
    }

    fn assign(&mut self, name: &str, value: &str) -> Result<(), KeywordError> {
        let is_meant = |keyword: &&Keyword| {
            [Some(keyword.name), keyword.path_name]
                .iter()
                .flatten()
                .any(|known| known.eq_ignore_ascii_case(name))
        };
        let Some(keyword) = KEYWORDS.iter().find(is_meant) else {
            let names = KEYWORDS.iter().flat_map(|k| [Some(k.name), k.path_name]).flatten();
            return Err(KeywordError::Unknown {
                name: name.to_owned(),
                nearest: nearest(name, names),
            });
        };
        if value.is_empty() {
            return Err(KeywordError::NoValue { name: name.to_owned() });
        }
        (keyword.set)(self, value).map_err(|reason| KeywordError::Value {
            name: name.to_owned(),
            value: value.to_owned(),
            reason,
        })?;
        let assigned_before = format!("{}=", keyword.name);
        self.echo.retain(|line| !line.starts_with(&assigned_before));
        self.echo.push(format!("{}={value}", keyword.name));
        Ok(())
    }
}

/// The first of `key=value`, `key = value` or `key value`, the value possibly in quotes, and what is
/// behind it.
fn first_assignment(text: &str) -> Result<(&str, &str, &str), KeywordError> {
    let end = text.find(|c: char| c == '=' || c.is_whitespace()).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    let rest = rest.trim_start();
    let rest = rest.strip_prefix('=').unwrap_or(rest).trim_start();
    let no_value = || KeywordError::NoValue { name: name.to_owned() };
    let (value, behind) = match rest.chars().next() {
        None => return Err(no_value()),
        Some(quote @ ('"' | '\'')) => rest[1..].split_once(quote).ok_or_else(no_value)?,
        Some(_) => rest.split_once(char::is_whitespace).unwrap_or((rest, "")),
    };
    Ok((name, value, behind.trim_start()))
}

fn log_names() -> Vec<String> {
    let names = Log::value_variants().iter().filter_map(Log::to_possible_value);
    names.map(|value| value.get_name().to_owned()).collect()
}

fn method_names() -> Vec<String> {
    Method::ALL.map(|method| method.name().to_owned()).to_vec()
}

/// `a, b or c`.
fn listed(names: &[String]) -> String {
    match names {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => names.concat(),
    }
}

/// The text of `mcp -=`.
pub(crate) fn listing() -> String {
    let mut text =
        "Keywords, in the option mcp_options or behind -AMPL, as key=value:\n\n".to_owned();
    for Keyword { name, path_name, value, about, choices, .. } in &KEYWORDS {
        let choices = choices.map_or(String::new(), |names| format!(": {}", listed(&names())));
        let alias = path_name.map_or(String::new(), |alias| format!("; PATH: {alias}"));
        let form = format!("{name}={value}");
        // Writing to a string does not fail.
        let _ = writeln!(text, "  {form:<17} {about}{choices}{alias}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    fn given(environment: &str, arguments: &[&str]) -> Result<Assigned, String> {
        let arguments: Vec<OsString> = arguments.iter().map(OsString::from).collect();
        Assigned::from(environment, &arguments).map_err(|error| error.to_string())
    }

    #[test]
    fn the_command_line_wins_over_the_environment() {
        let assigned = given("tol=1e-3 method=lemke", &["tol=1e-9"]).unwrap();
        assert_eq!(assigned.settings.tol.0, Some(1e-9));
        assert_eq!(assigned.settings.method, Method::Lemke);
        assert_eq!(assigned.echo, ["method=lemke", "tol=1e-9"]);
    }

    #[test]
    fn every_form_of_an_assignment_is_read() {
        let text =
            " tol = 1e-9  time_limit 60 json=\"my file.json\"\tlog='final' max_iterations= 7";
        let assigned = given(text, &["csv=a b.csv"]).unwrap();
        assert_eq!(assigned.settings.tol.0, Some(1e-9));
        assert_eq!(assigned.settings.time_limit, Some(Duration::from_mins(1)));
        assert_eq!(assigned.settings.max_iterations, Some(7));
        assert_eq!(assigned.files.json, Some("my file.json".into()));
        assert_eq!(assigned.files.csv, Some("a b.csv".into()));
        assert_eq!(assigned.log, Log::Final);
    }

    #[test]
    fn names_of_path_are_understood() {
        let assigned = given("Convergence_Tolerance=1e-8 major_iteration_limit=5", &[]).unwrap();
        assert_eq!(assigned.settings.tol.0, Some(1e-8));
        assert_eq!(assigned.settings.max_iterations, Some(5));
    }

    #[test]
    fn what_cannot_be_understood_is_named() {
        let wrong = |text| given(text, &[]).unwrap_err();
        assert_eq!(
            wrong("metod=robust"),
            "there is no keyword `metod`; did you mean `method`? (mcp -= lists all)"
        );
        assert!(wrong("tol=tight").starts_with("tol=tight: expected a positive number"));
        assert!(wrong("method=path").contains("choose robust"));
        assert_eq!(wrong("tol"), "the keyword `tol` has no value: write tol=value");
        assert_eq!(wrong("json=\"a"), "the keyword `json` has no value: write json=value");
        assert_eq!(wrong("log=finl"), "log=finl: expected iterations, final or none");
        assert!(wrong("csv=-").starts_with("csv=-: expected a file"));
        assert!(given("", &["fast"]).is_err());
    }

    #[test]
    fn the_listing_has_every_keyword() {
        let text = listing();
        for keyword in &KEYWORDS {
            assert!(text.contains(&format!("\n  {}=", keyword.name)), "{}", keyword.name);
        }
    }
}
