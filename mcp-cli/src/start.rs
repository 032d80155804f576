//! Starts by name, from CSV and JSON.
//!
//! A CSV file has the columns `name` or `variable`, and `level`, under these headers in any order,
//! or without headers first the name and then the level; so what `--csv` wrote is one. A JSON file is
//! what `--json` wrote: its `variables` have a `name` and a `level`.

use mcp_core::error::{did_you_mean, nearest};
use mcp_core::{ModelError, Shape};
use serde_json::Value;
use std::collections::HashMap;
use std::io;
use std::path::Path;

/// What is wrong with a start.
#[derive(Debug, thiserror::Error)]
pub(crate) enum StartError {
    /// The file cannot be read.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// It is no CSV.
    #[error("{0}")]
    Csv(#[from] csv::Error),
    /// It is no JSON.
    #[error("{0}")]
    Json(#[from] serde_json::Error),
    /// A JSON file has no list of variables.
    #[error("expected an object with `variables`, each with a `name` and a `level`")]
    NoVariables,
    /// A line has no level.
    #[error("line {line}: expected a name and a level, found `{found}`")]
    NoLevel {
        /// Its number.
        line: u64,
        /// What stands there.
        found: String,
    },
    /// The model has no variable of that name.
    #[error("the model has no variable `{name}`{}", did_you_mean(.nearest.as_deref()))]
    Unknown {
        /// The name.
        name: String,
        /// The nearest name of a variable, if one is near.
        nearest: Option<String>,
    },
    /// A name stands twice.
    #[error("`{name}` has two levels")]
    Twice {
        /// The name.
        name: String,
    },
    /// A level is not finite.
    #[error(transparent)]
    Level(#[from] ModelError),
}

/// Levels by name.
type Levels = Vec<(String, f64)>;

/// The start of this shape with the levels of a file, not yet moved into the bounds.
pub(crate) fn read(path: &Path, shape: &Shape) -> Result<Vec<f64>, StartError> {
    let text = std::fs::read_to_string(path)?;
    let levels = if text.trim_start().starts_with(['{', '[']) {
        from_json(&text)?
    } else {
        from_csv(&text)?
    };
    place(levels, shape)
}

/// Puts the levels where their names are.
fn place(levels: Levels, shape: &Shape) -> Result<Vec<f64>, StartError> {
    let names: Vec<String> = (0..shape.n()).map(|i| shape.variable_name(i)).collect();
    let index: HashMap<&str, usize> = names.iter().map(String::as_str).zip(0..).collect();
    let mut start = shape.start().to_vec();
    let mut is_given = vec![false; names.len()];
    for (name, level) in levels {
        let place = index.get(name.as_str());
        if place.is_some_and(|&i| std::mem::replace(&mut is_given[i], true)) {
            return Err(StartError::Twice { name });
        }
        match place {
            Some(&i) if level.is_finite() => start[i] = level,
            Some(_) => {
                return Err(ModelError::StartNotFinite { variable: name, value: level }.into());
            }
            None => {
                let nearest = nearest(&name, names.iter().map(String::as_str));
                return Err(StartError::Unknown { name, nearest });
            }
        }
    }
    Ok(start)
}

fn from_json(text: &str) -> Result<Levels, StartError> {
    let document: Value = serde_json::from_str(text)?;
    let variables = document.get("variables").and_then(Value::as_array);
    let level = |variable: &Value| {
        let (name, level) = (variable.get("name")?.as_str()?, variable.get("level")?.as_f64()?);
        Some((name.to_owned(), level))
    };
    let levels = variables.and_then(|variables| variables.iter().map(level).collect());
    levels.ok_or(StartError::NoVariables)
}

fn from_csv(text: &str) -> Result<Levels, StartError> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let (mut levels, mut columns, mut state) = (Vec::new(), (0, 1), None);
    for (k, record) in reader.records().enumerate() {
        let record = record?;
        let column = |headers: &[&str]| record.iter().position(|cell| headers.contains(&cell));
        if let (0, Some(name), Some(level)) = (k, column(&["name", "variable"]), column(&["level"]))
        {
            (columns, state) = ((name, level), column(&["state"]));
            continue;
        }
        // Reports and definitions, which follow the variables in what `--csv` wrote.
        if state
            .and_then(|state| record.get(state))
            .is_some_and(|state| matches!(state, "report" | "definition"))
        {
            continue;
        }
        let name = record.get(columns.0).filter(|name| !name.is_empty());
        let level = record.get(columns.1).and_then(|level| level.parse().ok());
        let Some((name, level)) = name.zip(level) else {
            let found = record.iter().collect::<Vec<_>>().join(",");
            let line = record.position().map_or(0, csv::Position::line);
            return Err(StartError::NoLevel { line, found });
        };
        levels.push((name.to_owned(), level));
    }
    Ok(levels)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape() -> Shape {
        Shape::anonymous(&[0.0; 3], &[f64::INFINITY; 3], &[1.0; 3]).unwrap()
    }

    fn placed(levels: Result<Levels, StartError>) -> Result<Vec<f64>, String> {
        levels.and_then(|levels| place(levels, &shape())).map_err(|error| error.to_string())
    }

    #[test]
    fn csv_is_read_with_and_without_headers() {
        assert_eq!(placed(from_csv("z[2],7\nz[1], 0.5\n")), Ok(vec![0.5, 7.0, 1.0]));
        assert_eq!(placed(from_csv("name,level\nz[3],2e3\n")), Ok(vec![1.0, 1.0, 2e3]));
        let table = "variable,lower,level,state\nz[1],0,4,interior\ncost,,9,report\n";
        assert_eq!(placed(from_csv(table)), Ok(vec![4.0, 1.0, 1.0]));
    }

    #[test]
    fn a_name_may_begin_with_a_hash() {
        assert_eq!(from_csv("#1,7\n").unwrap(), [("#1".to_owned(), 7.0)]);
    }

    #[test]
    fn json_is_read_by_its_variables() {
        let text = r#"{"status": "solved", "variables": [{"name": "z[2]", "level": 3}]}"#;
        assert_eq!(placed(from_json(text)), Ok(vec![1.0, 3.0, 1.0]));
        assert!(matches!(from_json("[]"), Err(StartError::NoVariables)));
        assert!(matches!(from_json("{"), Err(StartError::Json(_))));
    }

    #[test]
    fn wrong_lines_are_named() {
        let unknown = "the model has no variable `z[4]`; did you mean `z[1]`?";
        assert_eq!(placed(from_csv("z[4],1\n")), Err(unknown.to_owned()));
        let level = "line 2: expected a name and a level, found `z[2],high`";
        assert_eq!(placed(from_csv("z[1],1\nz[2],high\n")), Err(level.to_owned()));
        let twice = "`z[2]` has two levels";
        assert_eq!(placed(from_csv("z[2],1\nz[1],1\nz[2],1\n")), Err(twice.to_owned()));
        assert!(placed(from_csv("z[1],inf\n")).unwrap_err().contains("give a finite number"));
    }
}
