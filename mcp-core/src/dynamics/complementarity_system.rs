//! [`ComplementaritySystem`]: linear dynamics with complementary pairs.

use super::error::{DynamicsError, check, finite, unused};

/// What errors call a [`ComplementaritySystem`].
const SYSTEM: &str = "the system";

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
    /// [`DynamicsError::Length`], [`DynamicsError::OutOfRange`] for a number that is not finite,
    /// [`DynamicsError::NameTwice`].
    pub fn new<N: Into<String>>(
        states: impl IntoIterator<Item = N>,
        start: &[f64],
        a: &[Vec<f64>],
    ) -> Result<Self, DynamicsError> {
        let states: Vec<String> = states.into_iter().map(Into::into).collect();
        let n = states.len();
        for (i, name) in states.iter().enumerate() {
            unused(name, states[..i].iter().map(String::as_str))?;
        }
        check_list("start", SYSTEM, n, start)?;
        check_length("matrix", SYSTEM, n, a.len())?;
        for row in a {
            check_list("matrix", SYSTEM, n, row)?;
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
        check_list("drift", SYSTEM, self.states.len(), drift)?;
        self.drift = drift.to_vec();
        Ok(self)
    }

    /// Stored energy `½ Σ s_i x_i²`, for the energy column of a table.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn storage(mut self, weights: &[f64]) -> Result<Self, DynamicsError> {
        check_list("storage", SYSTEM, self.states.len(), weights)?;
        self.storage = Some(weights.to_vec());
        Ok(self)
    }

    /// Adds a pair and returns its number.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`DynamicsError::OutOfRange`] for bounds that no number satisfies,
    /// [`DynamicsError::NameTwice`].
    pub fn pair(&mut self, pair: Pair) -> Result<usize, DynamicsError> {
        let n = self.states.len();
        let names = self.states.iter().chain(self.pairs.iter().map(|pair| &pair.name));
        unused(&pair.name, names.map(String::as_str))?;
        check_list("input", &pair.name, n, &pair.input)?;
        check_list("output", &pair.name, n, &pair.output)?;
        finite("offset", &pair.name, pair.offset)?;
        let Pair { lower, upper, .. } = pair;
        check("lower", &pair.name, lower, lower < f64::INFINITY, "must be below infinity")?;
        check("upper", &pair.name, upper, lower <= upper, "must not be below the lower bound")?;
        check("upper", &pair.name, upper, upper > f64::NEG_INFINITY, "must be above −infinity")?;
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
            check("pair", SYSTEM, k as f64, exists, "does not exist")?;
        }
        finite("coupling", SYSTEM, d)?;
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
    quantity: &'static str,
    of: &str,
    expected: usize,
    found: usize,
) -> Result<(), DynamicsError> {
    if expected == found {
        return Ok(());
    }
    Err(DynamicsError::Length { quantity, of: of.to_owned(), expected, found })
}

/// As many finite numbers as expected.
fn check_list(
    quantity: &'static str,
    of: &str,
    expected: usize,
    values: &[f64],
) -> Result<(), DynamicsError> {
    check_length(quantity, of, expected, values.len())?;
    values.iter().try_for_each(|&value| finite(quantity, of, value).map(drop))
}
