//! The reference value of non-monotone line searches.

/// How the reference value follows from the merits of accepted points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Nonmonotone {
    /// The current merit: monotone descent. Default. Siconos type 0.
    #[default]
    Off,
    /// The largest of the last merits ([GLL86](crate#references)). Siconos type 1.
    Max,
    /// The larger of the current merit and the mean of the last ones. Siconos type 2, whose code
    /// takes the smaller, which is stricter than monotone.
    Mean,
    /// A weighted mean of all merits so far ([ZH04](crate#references), η = 0.85). Siconos type 3, which is not
    /// implemented there. The memory is not used.
    ZhangHager,
}

/// Merits of accepted points and the reference value that follows from them.
#[derive(Clone, Debug)]
pub struct Reference {
    kind: Nonmonotone,
    memory: usize,
    history: Vec<f64>,
    next: usize,
    mean: f64,
    weight: f64,
}

/// Weight of the past in [`Nonmonotone::ZhangHager`]; [ZH04](crate#references) uses 0.85 in its experiments.
const ETA: f64 = 0.85;

/// Monotone: the current merit.
impl Default for Reference {
    fn default() -> Self {
        Reference::new(Nonmonotone::Off, 1)
    }
}

impl Reference {
    /// Nothing accepted yet; `memory` merits are remembered, at least one.
    pub fn new(kind: Nonmonotone, memory: usize) -> Self {
        let memory = memory.max(1);
        let history = Vec::with_capacity(memory);
        Reference { kind, memory, history, next: 0, mean: 0.0, weight: 0.0 }
    }

    /// Whether it is of this kind and remembers this many merits.
    pub(crate) fn remembers(&self, kind: Nonmonotone, memory: usize) -> bool {
        self.kind == kind && self.memory == memory.max(1)
    }

    /// Forgets everything; keeps its memory allocated.
    pub fn reset(&mut self) {
        self.history.clear();
        self.next = 0;
        self.mean = 0.0;
        self.weight = 0.0;
    }

    /// Takes note of the merit of an accepted point.
    pub fn accept(&mut self, merit: f64) {
        // C ← (η Q C + θ) / (η Q + 1), Q ← η Q + 1.
        let weight = ETA * self.weight + 1.0;
        self.mean = (ETA * self.weight * self.mean + merit) / weight;
        self.weight = weight;
        if self.history.len() < self.memory {
            self.history.push(merit);
        } else {
            self.history[self.next] = merit;
        }
        self.next = (self.next + 1) % self.memory;
    }

    /// The reference value at a point with this merit, which was accepted last.
    pub fn value(&self, merit: f64) -> f64 {
        match self.kind {
            Nonmonotone::Off => merit,
            Nonmonotone::Max => self.history.iter().copied().fold(merit, f64::max),
            Nonmonotone::Mean => {
                let mean = self.history.iter().sum::<f64>() / self.history.len().max(1) as f64;
                merit.max(mean)
            }
            Nonmonotone::ZhangHager => merit.max(self.mean),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(kind: Nonmonotone, memory: usize, merits: &[f64]) -> f64 {
        let mut reference = Reference::new(kind, memory);
        for &merit in merits {
            reference.accept(merit);
        }
        reference.value(*merits.last().unwrap())
    }

    #[test]
    fn only_the_memory_counts() {
        assert_eq!(after(Nonmonotone::Max, 3, &[9.0, 5.0, 4.0, 1.0]), 5.0);
        assert_eq!(after(Nonmonotone::Mean, 3, &[9.0, 5.0, 4.0, 0.0]), 3.0);
        assert_eq!(after(Nonmonotone::Off, 3, &[9.0, 5.0, 4.0, 1.0]), 1.0);
    }

    #[test]
    fn the_mean_is_never_stricter_than_monotone_descent() {
        // Siconos takes min(θ, mean) where it documents the maximum.
        assert_eq!(after(Nonmonotone::Mean, 4, &[1.0, 2.0, 3.0]), 3.0);
        assert_eq!(after(Nonmonotone::Mean, 4, &[3.0, 2.0, 1.0]), 2.0);
    }

    #[test]
    fn zhang_hager_is_the_weighted_mean() {
        let expected = (ETA * 4.0 + 2.0) / (ETA + 1.0);
        assert!((after(Nonmonotone::ZhangHager, 1, &[4.0, 2.0]) - expected).abs() < 1e-15);
    }

    #[test]
    fn reset_forgets() {
        for kind in [Nonmonotone::Max, Nonmonotone::Mean, Nonmonotone::ZhangHager] {
            let mut reference = Reference::new(kind, 3);
            reference.accept(f64::INFINITY);
            reference.reset();
            reference.accept(4.0);
            reference.accept(2.0);
            assert_eq!(reference.value(2.0), after(kind, 3, &[4.0, 2.0]));
        }
    }
}
