//! [`Manufactured`]: any model with a solution of your choice.

use super::{AccuracyError, DoubleDouble};
use crate::error::ModelError;
use crate::model::{BoundKind, Model, Reader, Shape};
use crate::problem::AdProblem;
use crate::scalar::{Real, Scalar};

/// Where a variable of the chosen solution is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At its lower bound, with `F = margin >= 0`; a margin of 0 makes the pair degenerate.
    Lower {
        /// `F` there.
        margin: f64,
    },
    /// Between its bounds, with `F = 0`.
    Between,
    /// At its upper bound, with `F = −margin <= 0`.
    Upper {
        /// `−F` there.
        margin: f64,
    },
}

/// How many variables are at bounds: parts of all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mix {
    /// At the lower bound.
    pub lower: f64,
    /// At the upper bound.
    pub upper: f64,
    /// Of those at a bound, the part that is degenerate.
    pub degenerate: f64,
    /// `|F|` of the others at a bound.
    pub margin: f64,
}

impl Mix {
    /// Places for `n` variables, spread evenly: variable `i` goes by the fractional parts of `i`
    /// golden sections and of `i √2`.
    pub fn places(&self, n: usize) -> Vec<Place> {
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let place = |i: usize| {
            let part = (i as f64 * GOLDEN).fract();
            let inner = (i as f64 * std::f64::consts::SQRT_2).fract();
            let margin = if inner < self.degenerate { 0.0 } else { self.margin };
            match part {
                part if part < self.lower => Place::Lower { margin },
                part if part < self.lower + self.upper => Place::Upper { margin },
                _ => Place::Between,
            }
        };
        (0..n).map(place).collect()
    }
}

/// `F(z) = f(z) − f(z*) + w*` in bounds that make the chosen `z*` a solution.
///
/// `f` is a given model, `w*_i` is the margin of variable `i`: positive at a lower bound, negative at
/// an upper one, 0 between. At a place at a bound the bound becomes `z*_i`; elsewhere the model's
/// bounds are kept on the sides that leave room for `z*_i` and dropped on others. Fixed variables stay
/// where they are. `f(z*)` is known to 31 digits, so that `z*` solves the problem as it stands, and
/// not only up to rounding; whether there are further solutions is not known.
///
/// ```
/// use mcp_core::accuracy::{Manufactured, Place};
/// use mcp_core::{Options, Real, Scalar, mcp_fn, solve};
/// #[mcp_fn(start = 0.5)]
/// fn waves<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
///     [x.exp() + y, x + y.powi(3)]
/// }
/// let places = [Place::Between, Place::Lower { margin: 2.0 }];
/// let problem = Manufactured::new(Waves::new()?, &[0.3, 0.7], &places)?;
/// let solution = solve(&problem, &Options::default())?.solved()?;
/// assert!((solution.z[0] - 0.3).abs() < 1e-14 && solution.z[1] == 0.7);
/// assert!((solution.f[1] - 2.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Manufactured<M> {
    model: M,
    shape: Shape,
    solution: Vec<f64>,
    /// `f(z*)` of every row.
    at_solution: Vec<DoubleDouble>,
    /// `w*` of every row.
    margins: Vec<f64>,
}

impl<M: Model> Manufactured<M> {
    /// With the solution `z`, one number and one place for each variable; it starts where the model
    /// does, moved into the bounds.
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::StartNotFinite`] for `z`;
    /// [`AccuracyError::Margin`] for a margin that is negative or not finite;
    /// [`AccuracyError::NotFinite`] if the model is not defined at `z`.
    pub fn new(model: M, z: &[f64], places: &[Place]) -> Result<Self, AccuracyError> {
        let mut shape = model.shape().clone();
        let n = shape.n();
        shape.check_start(z)?;
        if places.len() != n {
            let (what, found) = ("places".to_owned(), places.len());
            return Err(ModelError::Length { what, expected: n, found }.into());
        }
        let mut solution = z.to_vec();
        let mut lower = shape.bounds().lower().to_vec();
        let mut upper = shape.bounds().upper().to_vec();
        let mut margin_of = vec![0.0; n];
        for j in 0..n {
            if shape.bounds().kind(j) == BoundKind::Fixed {
                solution[j] = lower[j];
                continue;
            }
            if !(lower[j] < z[j]) {
                lower[j] = f64::NEG_INFINITY;
            }
            if !(z[j] < upper[j]) {
                upper[j] = f64::INFINITY;
            }
            match places[j] {
                Place::Lower { margin } => (lower[j], margin_of[j]) = (z[j], margin),
                Place::Upper { margin } => (upper[j], margin_of[j]) = (z[j], -margin),
                Place::Between => {}
            }
            if let Place::Lower { margin } | Place::Upper { margin } = places[j]
                && !(margin >= 0.0 && margin.is_finite())
            {
                return Err(AccuracyError::Margin { variable: shape.variable_name(j), margin });
            }
        }
        let at_solution = rows_at(&model, &solution)?;
        for (row, f) in at_solution.iter().enumerate() {
            if !f.is_finite() {
                let equation = shape.equation_name(shape.variable_of_row(row));
                return Err(AccuracyError::NotFinite { equation });
            }
        }
        shape.set_bounds(&lower, &upper)?;
        let margins = (0..at_solution.len()).map(|row| margin_of[shape.variable_of_row(row)]);
        let margins = margins.collect();
        Ok(Manufactured { model, shape, solution, at_solution, margins })
    }

    /// The same, starting at `start`, moved into the bounds.
    ///
    /// # Errors
    /// [`ModelError::Length`], [`ModelError::StartNotFinite`].
    pub fn starting_at(mut self, start: &[f64]) -> Result<Self, ModelError> {
        self.shape.set_start(start)?;
        Ok(self)
    }

    /// `z*`.
    pub fn solution(&self) -> &[f64] {
        &self.solution
    }

    /// `f(z) − f(z*) + w*` of a row.
    fn shifted<D: Scalar>(&self, row: usize, f: Real<D>) -> Real<D> {
        let at = self.at_solution[row];
        f - at.to_f64() - at.low() + self.margins[row]
    }
}

/// All rows of a model at `z`, with 31 digits.
pub(super) fn rows_at<M: Model>(model: &M, z: &[f64]) -> Result<Vec<DoubleDouble>, ModelError> {
    let z: Vec<Real<DoubleDouble>> = z.iter().map(|&z| Real::from(z)).collect();
    Ok(AdProblem::new(model)?.rows_at(&z).into_iter().map(Real::into_scalar).collect())
}

impl<M: Model> Model for Manufactured<M> {
    const WHOLE: Option<usize> = M::WHOLE;

    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        let first =
            self.shape.equations().find(|e| e.entry() == family).map_or(0, crate::Family::offset);
        self.shifted(first + index, self.model.row(family, index, read))
    }
    fn def<D: Scalar>(&self, family: usize, index: usize, read: &Reader<'_, D>) -> Real<D> {
        self.model.def(family, index, read)
    }
    fn report(&self, family: usize, index: usize, read: &Reader<'_, f64>) -> Real<f64> {
        self.model.report(family, index, read)
    }
    fn whole<D: Scalar>(&self, read: &Reader<'_, D>, f: &mut [Real<D>]) {
        self.model.whole(read, f);
        for (row, f) in f.iter_mut().enumerate() {
            *f = self.shifted(row, *f);
        }
    }
}

#[cfg(test)]
#[path = "manufactured_tests.rs"]
mod tests;
