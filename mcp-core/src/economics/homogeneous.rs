//! [`check_homogeneous`]: do only relative prices matter?

use crate::error::ModelError;
use crate::generic::generic;
use crate::model::{Model, Shape};
use crate::problem::{AdProblem, Problem};
use std::fmt;

/// Points that Euler's identity is checked at.
const POINTS: usize = 5;

/// An equation is homogeneous if Euler's identity holds to this part of its terms.
const TOLERANCE: f64 = 1e-10;

/// Degrees an equation may have: values of degree 1, quantities of degree 0, and what products and
/// quotients of them give.
const DEGREES: [i32; 5] = [0, 1, -1, 2, -2];

/// What [`check_homogeneous`] found: the degree of each equation. `Display` lists the degrees by
/// family, and the equations that have none.
#[derive(Clone, Debug, PartialEq)]
pub struct Homogeneity {
    /// The variables that were scaled together.
    pub names: Vec<String>,
    /// Each equation with its degree, in the order of the variables they are paired with; `None` for
    /// one that is not homogeneous.
    pub degrees: Vec<(String, Option<i32>)>,
}

/// An equation that is not homogeneous.
#[derive(Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "equation `{equation}` is not homogeneous in {}: it reads something in units of money that does \
     not move with them",
    .names.join(", ")
)]
pub struct NotHomogeneous {
    /// The first such equation.
    pub equation: String,
    /// The variables that were scaled together.
    pub names: Vec<String>,
}

/// As [`Display`](fmt::Display): what `main` prints of an error it returns.
impl fmt::Debug for NotHomogeneous {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Whether every equation is homogeneous in the named variables together, whatever the others:
/// `F_i(λ p, y) = λ^k F_i(p, y)` with an integer `k` from −2 to 2. Then only relative prices matter,
/// and one of them has to be fixed.
///
/// Names are those of variables or of families: prices, incomes, everything in units of money. Checked
/// is Euler's identity `Σ p_j ∂F_i/∂p_j = k F_i` with exact derivatives at five points near the
/// start, to `1e-10` of its terms. An equation that is not finite at one of them has no degree, and
/// what lies beyond a kink that none of them reaches is not seen. Cost: five evaluations of `F` and `J`.
///
/// ```
/// use mcp_core::{Real, Scalar, mcp_fn};
/// use mcp_core::economics::check_homogeneous;
/// /// Supply y of a good at the price p, made by labor at the wage w; 3 h of labor.
/// #[mcp_fn(lower = 0.0, start = 1.0)]
/// fn economy<D: Scalar>([y, p, w]: [Real<D>; 3]) -> [Real<D>; 3] {
///     [w - p, y - 3 * w / p, 3 - y]
/// }
/// let model = Economy::new()?;
/// let check = check_homogeneous(&model, &["p", "w"])?;
/// check.verdict()?;
/// assert_eq!(check.degrees[0], ("f[y]".to_owned(), Some(1)));
/// assert_eq!(check.degrees[1].1, Some(0));
/// assert!(check_homogeneous(&model, &["p"])?.verdict().is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ModelError::UnknownName`] for a name, with the nearest.
pub fn check_homogeneous<M: Model>(model: &M, names: &[&str]) -> Result<Homogeneity, ModelError> {
    degrees(&mut AdProblem::new(model)?, names)
}

fn degrees(problem: &mut dyn Problem, names: &[&str]) -> Result<Homogeneity, ModelError> {
    let shape = problem.shape().clone();
    let mut is_scaled = vec![false; shape.n()];
    for name in names {
        is_scaled[shape.range_of(name)?].fill(true);
    }
    let equations: Vec<usize> =
        (0..shape.n()).filter(|&i| shape.row_of_variable(i).is_some()).collect();
    let mut candidates = vec![DEGREES.to_vec(); shape.n()];
    let (mut f, mut jac) = (vec![0.0; shape.n()], vec![0.0; problem.pattern().nnz()]);
    for point in 0..POINTS {
        let z = near_start(&shape, point);
        problem.evaluate(&z, Some(&mut f), Some(&mut jac));
        let (mut euler, mut terms) = (vec![0.0; shape.n()], vec![0.0; shape.n()]);
        for (k, i, j) in problem.pattern().entries().filter(|&(.., j)| is_scaled[j]) {
            euler[i] += jac[k] * z[j];
        }
        problem.pattern().add_sizes(&jac, |j| z[j], &mut terms);
        for &i in &equations {
            let tolerance = TOLERANCE * terms[i].max(f[i].abs());
            let holds = |k: i32| (euler[i] - f64::from(k) * f[i]).abs() <= tolerance;
            candidates[i].retain(|&k| tolerance.is_finite() && holds(k));
        }
    }
    let degree = |&i: &usize| (shape.equation_name(i), candidates[i].first().copied());
    let names = names.iter().map(|&name| name.to_owned()).collect();
    Ok(Homogeneity { names, degrees: equations.iter().map(degree).collect() })
}

/// A point near the start, inside the bounds: each number is moved by its own part, up to a third.
fn near_start(shape: &Shape, point: usize) -> Vec<f64> {
    let moved = |(j, &start): (usize, &f64)| {
        let part = 2.0 * generic(j + point * shape.n()) - 1.0;
        if start == 0.0 { 0.5 + part / 3.0 } else { start * (1.0 + part / 3.0) }
    };
    let mut z: Vec<f64> = shape.start().iter().enumerate().map(moved).collect();
    for (j, z) in z.iter_mut().enumerate() {
        let (lower, upper) = (shape.bounds().lower()[j], shape.bounds().upper()[j]);
        // A fixed numeraire is one point of a ray.
        if lower < upper {
            *z = z.clamp(lower, upper);
        }
    }
    z
}

impl Homogeneity {
    /// Whether all equations are homogeneous.
    ///
    /// # Errors
    /// [`NotHomogeneous`] names the first that is not.
    pub fn verdict(&self) -> Result<(), NotHomogeneous> {
        match self.degrees.iter().find(|(_, degree)| degree.is_none()) {
            None => Ok(()),
            Some((equation, _)) => {
                Err(NotHomogeneous { equation: equation.clone(), names: self.names.clone() })
            }
        }
    }
}

impl fmt::Display for Homogeneity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "scaled together: {}", self.names.join(", "))?;
        let family = |name: &str| name.split('[').next().unwrap_or(name).to_owned();
        let mut families: Vec<(String, Option<i32>, usize)> = Vec::new();
        for (equation, degree) in &self.degrees {
            let name = if degree.is_some() { family(equation) } else { equation.clone() };
            match families.iter_mut().find(|(known, with, _)| *known == name && with == degree) {
                Some((.., count)) => *count += 1,
                None => families.push((name, *degree, 1)),
            }
        }
        for (name, degree, count) in families {
            match degree {
                Some(degree) => writeln!(f, "  {name} ({count}): degree {degree}")?,
                None => writeln!(f, "  {name}: not homogeneous")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
#[path = "homogeneous_tests.rs"]
mod tests;
