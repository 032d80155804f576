//! Seconds: the only clock of the crate that is not a time limit. Nothing but tables and figures
//! depends on it.

use std::time::{Duration, Instant};

/// How long something took, over several runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// Seconds of the run in the middle.
    pub median: f64,
    /// Seconds of the quickest run.
    pub minimum: f64,
    /// Runs.
    pub runs: usize,
}

/// How often to run: until `runs` or `time` are used up, but 3 times if `runs` allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Most runs.
    pub runs: usize,
    /// Time after which no further run begins.
    pub time: Duration,
}

impl Default for Budget {
    /// 15 runs, 5 ms.
    fn default() -> Self {
        Budget { runs: 15, time: Duration::from_millis(5) }
    }
}

impl Timing {
    /// Runs `task` as often as the budget says; run it once before, to warm up.
    pub fn measure(budget: Budget, mut task: impl FnMut()) -> Self {
        let begin = Instant::now();
        let mut seconds = Vec::new();
        while seconds.len() < budget.runs && (seconds.len() < 3 || begin.elapsed() < budget.time) {
            let start = Instant::now();
            task();
            seconds.push(start.elapsed().as_secs_f64());
        }
        Self::of(seconds)
    }

    /// Median and minimum; NaN of nothing.
    fn of(mut seconds: Vec<f64>) -> Self {
        seconds.sort_by(f64::total_cmp);
        let at = |k: usize| seconds.get(k).copied().unwrap_or(f64::NAN);
        Timing { median: at(seconds.len() / 2), minimum: at(0), runs: seconds.len() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn median_and_minimum_are_those_of_the_runs() {
        let timing = Timing::of(vec![3.0, 1.0, 2.0]);
        assert_eq!(timing, Timing { median: 2.0, minimum: 1.0, runs: 3 });
        assert!(Timing::of(Vec::new()).median.is_nan());
    }

    #[test]
    fn a_task_runs_no_more_than_allowed_and_three_times_if_time_is_short() {
        let mut calls = 0;
        let budget = Budget { runs: 4, time: Duration::from_hours(1) };
        let timing = Timing::measure(budget, || calls += 1);
        assert_eq!((timing.runs, calls), (4, 4));
        let timing = Timing::measure(Budget { time: Duration::ZERO, ..budget }, || ());
        assert_eq!(timing.runs, 3);
    }
}
