//! `mcp batch`: many models, a line for each.

mod line;
mod table;

use crate::args::Batch;
use crate::error::CliError;
use crate::exit::Outcome;
use crate::files;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use line::Line;
use mcp_core::{Options, batch};
use std::collections::BTreeMap;
use std::io::{self, IsTerminal, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Instant;
use table::Table;

/// A model, or the line of a folder that gives none.
type Listed = Result<PathBuf, Line>;

/// Carries out `mcp batch`.
pub(crate) fn run(args: &Batch, out: &mut impl Write) -> Result<Outcome, CliError> {
    let models = listed(&args.models);
    if let Some(csv) = &args.csv {
        files::are_distinct(models.iter().flatten().map(PathBuf::as_path), [csv.as_path()])?;
        // Nobody wants to learn of a wrong path when all is solved.
        files::can_be_written(csv)?;
    }
    let processors = || std::thread::available_parallelism().map_or(1, NonZero::get);
    let jobs = args.jobs.map_or_else(processors, usize::from).min(models.len());
    let began = Instant::now();
    let mut table = Table::new(&models);
    table.write_header(out)?;
    let bar = progress(models.len());
    let mut written = Ok(());
    in_order(&models, &args.settings.options(), jobs, |line| {
        let shown = bar.suspend(|| table.write_line(line, out).and_then(|()| out.flush()));
        if written.is_ok() {
            written = shown;
        }
        bar.inc(1);
    });
    bar.finish_and_clear();
    written?;
    table.write_summary(began.elapsed(), out)?;
    if let Some(path) = &args.csv {
        files::write(path, |out| table.write_csv(out))?;
    }
    Ok(Outcome::of(table.all_solved()))
}

/// The models themselves, and those of folders in the order of their names.
fn listed(given: &[PathBuf]) -> Vec<Listed> {
    let models = |path: &PathBuf| {
        if !path.is_dir() {
            return vec![Ok(path.clone())];
        }
        match models_in(path) {
            Ok(models) if models.is_empty() => {
                vec![Err(Line::unreadable(path, "there is no .nl file".to_owned()))]
            }
            Ok(models) => models.into_iter().map(Ok).collect(),
            Err(error) => vec![Err(Line::unreadable(path, error.to_string()))],
        }
    };
    given.iter().flat_map(models).collect()
}

fn models_in(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let paths = std::fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut paths: Vec<PathBuf> = paths.collect::<Result<_, _>>()?;
    paths.retain(|path| path.extension().is_some_and(|end| end == "nl"));
    paths.sort();
    Ok(paths)
}

/// On standard error, if that is a terminal.
fn progress(models: usize) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(models as u64), ProgressDrawTarget::stderr());
    match ProgressStyle::with_template("{bar:40} {pos} of {len}, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Solves the models on `jobs` threads and shows the lines in the order of the models, each as soon
/// as all before it are there.
fn in_order(models: &[Listed], options: &Options, jobs: usize, mut show: impl FnMut(Line)) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    std::thread::scope(|scope| {
        let (send, receive) = mpsc::channel();
        scope.spawn(move || {
            let solve = |(k, model): &(usize, &Listed)| {
                let line = model.as_ref().map_or_else(Line::clone, |path| Line::of(path, options));
                // The receiver below takes every line.
                let _ = send.send((*k, line));
            };
            let models: Vec<_> = models.iter().enumerate().collect();
            let all = || batch(&models, || (), |(), model| solve(model));
            match pool {
                Ok(pool) => pool.install(all),
                // No threads of its own: those there are.
                Err(_) => all(),
            }
        });
        let (mut waiting, mut shown) = (BTreeMap::new(), 0);
        for (k, line) in receive {
            waiting.insert(k, line);
            while let Some(line) = waiting.remove(&shown) {
                shown += 1;
                show(line);
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_in_the_order_of_the_models_however_many_jobs() {
        let names: Vec<String> = (0..40).map(|k| format!("missing-{k}.nl")).collect();
        let models: Vec<Listed> = names.iter().map(|name| Ok(name.into())).collect();
        for jobs in [1, 2, 7] {
            let mut files = Vec::new();
            in_order(&models, &Options::default(), jobs, |line| {
                files.push(line.file);
            });
            assert_eq!(files, names);
        }
    }
}
