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
use std::io::{IsTerminal, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::time::Instant;
use table::Table;

/// Carries out `mcp batch`.
pub(crate) fn run(args: &Batch, out: &mut impl Write) -> Result<Outcome, CliError> {
    let models = listed(&args.models)?;
    let processors = || std::thread::available_parallelism().map_or(1, NonZero::get);
    let jobs = args.jobs.map_or_else(processors, usize::from).min(models.len());
    let began = Instant::now();
    let mut table = Table::new(&models);
    table.write_header(out)?;
    let bar = progress(models.len());
    let mut failed = Ok(());
    in_order(&models, &args.settings.options(), jobs, |line| {
        failed = bar.suspend(|| table.write_line(line, out).and_then(|()| out.flush()));
        bar.inc(1);
        failed.is_ok()
    });
    bar.finish_and_clear();
    failed?;
    table.write_summary(began.elapsed(), out)?;
    if let Some(path) = &args.csv {
        files::write(path, |out| table.write_csv(out))?;
    }
    Ok(Outcome::of(table.all_solved()))
}

/// The models themselves, and those of folders in the order of their names.
fn listed(given: &[PathBuf]) -> Result<Vec<PathBuf>, CliError> {
    let mut models = Vec::new();
    for path in given {
        if path.is_dir() {
            models.extend(models_in(path)?);
        } else {
            models.push(path.clone());
        }
    }
    Ok(models)
}

fn models_in(folder: &Path) -> Result<Vec<PathBuf>, CliError> {
    let failed = |reason: String| CliError::Folder { path: folder.to_owned(), reason };
    let entries = std::fs::read_dir(folder).map_err(|error| failed(error.to_string()))?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path()));
    let mut paths: Vec<PathBuf> =
        paths.collect::<Result<_, _>>().map_err(|error| failed(error.to_string()))?;
    paths.retain(|path| path.extension().is_some_and(|end| end == "nl"));
    paths.sort();
    if paths.is_empty() { Err(failed("there is no .nl file".to_owned())) } else { Ok(paths) }
}

/// On standard error, if that is a terminal.
fn progress(models: usize) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(models as u64), ProgressDrawTarget::stderr());
    match ProgressStyle::with_template("{bar:40} {pos} of {len}, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Solves the models on `jobs` threads and shows the lines in the order of the models, each as soon
/// as all before it are there, until `show` says no.
fn in_order(
    models: &[PathBuf],
    options: &Options,
    jobs: usize,
    mut show: impl FnMut(Line) -> bool,
) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    let has_enough = &AtomicBool::new(false);
    std::thread::scope(|scope| {
        let (send, receive) = mpsc::channel();
        scope.spawn(move || {
            let solve = |(k, path): &(usize, &PathBuf)| {
                // Nobody listens any more once the reader has enough.
                if !has_enough.load(Ordering::Relaxed) {
                    let _ = send.send((*k, Line::of(path, options)));
                }
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
                if !show(line) {
                    has_enough.store(true, Ordering::Relaxed);
                    return;
                }
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_in_the_order_of_the_models_however_many_jobs() {
        let models: Vec<PathBuf> = (0..40).map(|k| format!("missing-{k}.nl").into()).collect();
        for jobs in [1, 2, 7] {
            let mut files = Vec::new();
            in_order(&models, &Options::default(), jobs, |line| {
                files.push(PathBuf::from(line.file));
                true
            });
            assert_eq!(files, models);
        }
    }

    #[test]
    fn a_reader_that_has_enough_ends_the_batch() {
        let models: Vec<PathBuf> = (0..1000).map(|k| format!("missing-{k}.nl").into()).collect();
        let mut lines = 0;
        in_order(&models, &Options::default(), 2, |_| {
            lines += 1;
            lines < 3
        });
        assert_eq!(lines, 3);
    }
}
