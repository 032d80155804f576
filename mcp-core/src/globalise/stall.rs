//! When a method has stopped making progress.

/// A solve has stalled when the merit has not fallen by a factor within a number of iterations.
///
/// Newton's method on a problem it can solve halves the merit within a few iterations; crawling
/// towards a local minimum or a kink of the merit would otherwise use up the iteration limit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Stall {
    /// Iterations that may pass without progress. Default 100.
    pub iterations: usize,
    /// Progress is a merit below this factor times the last best. Default 0.9.
    pub factor: f64,
}

impl Default for Stall {
    fn default() -> Self {
        Stall { iterations: 100, factor: 0.9 }
    }
}

/// Watches the merit of a running solve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StallWatch {
    best: f64,
    since: usize,
}

impl StallWatch {
    pub(crate) fn new(merit: f64) -> Self {
        StallWatch { best: merit, since: 0 }
    }

    /// Takes note of an iteration; true if the solve has stalled.
    pub(crate) fn observe(&mut self, merit: f64, rule: Stall) -> bool {
        if merit <= rule.factor * self.best {
            *self = StallWatch::new(merit);
        } else {
            self.since += 1;
        }
        self.since >= rule.iterations
    }

    /// Whether this many iterations have passed without progress.
    pub(crate) fn lasts(&self, iterations: usize) -> bool {
        self.since >= iterations
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_progress_is_progress_and_crawling_is_not() {
        let rule = Stall { iterations: 10, factor: 0.9 };
        let mut watch = StallWatch::new(1.0);
        // 2 % an iteration: 10 % within 6 iterations.
        assert!((1..200).all(|k| !watch.observe(0.98_f64.powi(k), rule)));
        let mut watch = StallWatch::new(1.0);
        let stalled = (1..200).position(|k| watch.observe(1.0 + 1e-3 / f64::from(k), rule));
        assert_eq!(stalled, Some(9));
    }
}
