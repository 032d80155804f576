//! [`ComplementaritySystem`]: linear dynamics with complementary pairs.

use super::error::{DynamicsError, finite};

/// A multiplier `λ_i` and its output `y_i`, complementary by the bounds of `λ_i`.
///
/// | law | bounds |
/// | --- | --- |
/// | ideal diode, `0 <= y ⟂ λ >= 0` | `[0, ∞)` |
/// | relay, `−λ ∈ Sign(y)` | `[−1, 1]` |
/// | algebraic equation, `y = 0` | free |
///
/// The relay is at its lower bound where `y > 0`: this is the sign of the feedback `u = −sign(y)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    pub(super) name: String,
    pub(super) input: Vec<f64>,
    pub(super) output: Vec<f64>,
    pub(super) offset: f64,
    pub(super) lower: f64,
    pub(super) upper: f64,
}

impl Pair {
    /// `λ` enters `x'` through `input`, a column of `B`, and `y = output · x` is a row of `C`; free.
    pub fn new(
        name: impl Into<String>,
        input: impl Into<Vec<f64>>,
        output: impl Into<Vec<f64>>,
    ) -> Self {
        Pair {
            name: name.into(),
            input: input.into(),
            output: output.into(),
            offset: 0.0,
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
        }
    }
    /// Bounds of `λ`.
    #[must_use]
    pub fn within(mut self, lower: f64, upper: f64) -> Self {
        (self.lower, self.upper) = (lower, upper);
        self
    }
    /// The constant `a_i` of `y_i`; default 0.
    #[must_use]
    pub fn offset(mut self, offset: f64) -> Self {
        self.offset = offset;
        self
    }
}

/// A linear complementarity system, or, with bounds of other kinds, a relay system:
///
/// ```text
/// x' = A x + b + B λ,    y = C x + a + D λ,    y complementary to λ by its bounds
/// ```
///
/// `n` states, `m` pairs. Without pairs it is a linear differential equation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ComplementaritySystem {
    pub(super) states: Vec<String>,
    pub(super) start: Vec<f64>,
    pub(super) a: Vec<Vec<f64>>,
    pub(super) drift: Vec<f64>,
    pub(super) pairs: Vec<Pair>,
    /// Entries `(i, j, D_ij)`.
    pub(super) feedthrough: Vec<(usize, usize, f64)>,
    /// `E = ½ Σ s_i x_i²`.
    pub(super) storage: Option<Vec<f64>>,
}

impl ComplementaritySystem {
    /// `x' = A x` from `start`, with `A` row by row.
    ///
    /// # Errors
    /// [`DynamicsError::Length`], and [`DynamicsError::OutOfRange`] for a number that is not finite.
    pub fn new<N: Into<String>>(
        states: impl IntoIterator<Item = N>,
        start: &[f64],
        a: &[Vec<f64>],
    ) -> Result<Self, DynamicsError> {
        let states: Vec<String> = states.into_iter().map(Into::into).collect();
        let n = states.len();
        check_length(|| "the start".to_owned(), n, start.len())?;
        check_length(|| "A".to_owned(), n, a.len())?;
        check_finite("the start", start)?;
        for (i, row) in a.iter().enumerate() {
            check_length(|| format!("row {} of A", i + 1), n, row.len())?;
            check_finite("A", row)?;
        }
        Ok(ComplementaritySystem {
            drift: vec![0.0; n],
            start: start.to_vec(),
            a: a.to_vec(),
            states,
            ..Self::default()
        })
    }

    /// Adds the constant drift `b`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn drift(mut self, drift: &[f64]) -> Result<Self, DynamicsError> {
        check_length(|| "the drift b".to_owned(), self.states.len(), drift.len())?;
        check_finite("the drift b", drift)?;
        self.drift = drift.to_vec();
        Ok(self)
    }

    /// Stored energy `½ Σ s_i x_i²`, for the energy column of a table.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn storage(mut self, weights: &[f64]) -> Result<Self, DynamicsError> {
        check_length(|| "the storage".to_owned(), self.states.len(), weights.len())?;
        check_finite("the storage", weights)?;
        self.storage = Some(weights.to_vec());
        Ok(self)
    }

    /// Adds a pair and returns its number.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn pair(&mut self, pair: Pair) -> Result<usize, DynamicsError> {
        let n = self.states.len();
        check_length(|| format!("the input of {}", pair.name), n, pair.input.len())?;
        check_length(|| format!("the output of {}", pair.name), n, pair.output.len())?;
        check_finite(&pair.name, &pair.input)?;
        check_finite(&pair.name, &pair.output)?;
        finite(|| format!("the offset of {}", pair.name), pair.offset)?;
        self.pairs.push(pair);
        Ok(self.pairs.len() - 1)
    }

    /// Adds `d` to `D_ij`: `y_i` reads `λ_j`.
    ///
    /// # Errors
    /// [`DynamicsError::OutOfRange`] for a pair that does not exist or a `d` that is not finite.
    pub fn couple(&mut self, i: usize, j: usize, d: f64) -> Result<(), DynamicsError> {
        for k in [i, j] {
            let exists = k < self.pairs.len();
            super::error::check(|| "a pair".to_owned(), k as f64, exists, "does not exist")?;
        }
        finite(|| format!("D[{i}, {j}]"), d)?;
        self.feedthrough.push((i, j, d));
        Ok(())
    }

    /// The twisting controller `λ ∈ P`, `−y ∈ N_P(λ)`, for the step size `h`, on two outputs:
    ///
    /// ```text
    /// P = { λ : H λ >= −1 },   H = [1 0; −h/2 1; −1 0; h/2 −1]
    /// y − Hᵀ μ = 0,   λ free;      0 <= H λ + 1   ⟂   μ >= 0
    /// ```
    ///
    /// Two equations and four inequalities: mixed by nature. `inputs` are the columns of `B`,
    /// `outputs` the rows of `C`. It is the implicit discretisation of the Siconos example
    /// `control/Relay/Twisting`.
    ///
    /// # Errors
    /// As [`pair`](Self::pair).
    pub fn twisting(
        &mut self,
        name: &str,
        h: f64,
        inputs: [Vec<f64>; 2],
        outputs: [Vec<f64>; 2],
    ) -> Result<(), DynamicsError> {
        let first = self.pairs.len();
        for (k, (input, output)) in inputs.into_iter().zip(outputs).enumerate() {
            self.pair(Pair::new(format!("{name}.{}", k + 1), input, output))?;
        }
        let nothing = vec![0.0; self.states.len()];
        let polygon = [[1.0, 0.0], [-h / 2.0, 1.0], [-1.0, 0.0], [h / 2.0, -1.0]];
        for (k, row) in polygon.into_iter().enumerate() {
            let name = format!("{name}.mu{}", k + 1);
            let side = Pair::new(name, nothing.clone(), nothing.clone());
            let mu = self.pair(side.offset(1.0).within(0.0, f64::INFINITY))?;
            for (j, entry) in row.into_iter().enumerate().filter(|(_, entry)| *entry != 0.0) {
                self.couple(first + j, mu, -entry)?;
                self.couple(mu, first + j, entry)?;
            }
        }
        Ok(())
    }

    /// Number of pairs.
    pub fn pair_count(&self) -> usize {
        self.pairs.len()
    }
}

fn check_length(
    what: impl FnOnce() -> String,
    expected: usize,
    found: usize,
) -> Result<(), DynamicsError> {
    if expected == found {
        return Ok(());
    }
    Err(DynamicsError::Length { what: what(), expected, found })
}

fn check_finite(what: &str, values: &[f64]) -> Result<(), DynamicsError> {
    values.iter().try_for_each(|&value| finite(|| what.to_owned(), value).map(drop))
}
