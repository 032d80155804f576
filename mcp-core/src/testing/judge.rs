//! Whether a point is a solution, by code apart from the certificate.

use super::collection::Instance;
use crate::error::ModelError;
use crate::problem::Problem;

/// What [`judge`] found. All numbers are in the units of the problem before scaling; NaN if the
/// point or `F` there is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judgement {
    /// `max |z − mid(l, z − F, u)|` at the point moved into the box, or how far it lay outside.
    pub absolute: f64,
    /// The same with every row divided by the size of its own terms, `1 + Σ_j |∂F_i/∂z_j z_j|`.
    pub relative: f64,
    /// Of an affine problem of at most six variables all of whose solutions can be enumerated: the
    /// distance to the nearest, `max |z − z*| / (1 + |z*|)`; infinite if there is none.
    pub distance: Option<f64>,
}

/// Residuals up to this are accepted.
const TOLERANCE: f64 = 1e-6;
/// Distances to an enumerated solution up to this.
const NEAR: f64 = 1e-4;
/// Affine problems of at most this many variables are enumerated.
const FEW: usize = 6;

impl Judgement {
    const NOTHING: Self = Judgement { absolute: f64::NAN, relative: f64::NAN, distance: None };

    /// Whether the point is a solution: one of the two residuals at most `1e-6`, and near an
    /// enumerated solution where all of them are known.
    ///
    /// Whether a solution exists at all is another question: see [`Instance::solvable`].
    pub fn accepts(&self) -> bool {
        let small = self.absolute <= TOLERANCE || self.relative <= TOLERANCE;
        small && self.distance.is_none_or(|distance| distance <= NEAR)
    }
}

/// Judges `z`, given in the instance's own units.
///
/// # Errors
/// [`ModelError::Length`] if `z` does not have `n` entries.
pub fn judge(instance: &Instance, z: &[f64]) -> Result<Judgement, ModelError> {
    let n = instance.n();
    if z.len() != n {
        return Err(ModelError::Length { what: "z".to_owned(), expected: n, found: z.len() });
    }
    let mut problem = instance.original()?;
    let z = instance.to_original(z);
    let bounds = problem.shape().bounds();
    let (l, u) = (bounds.lower().to_vec(), bounds.upper().to_vec());
    let inside: Vec<f64> = (0..n).map(|i| z[i].max(l[i]).min(u[i])).collect();
    let (f, jacobian) = evaluate(&mut *problem, &inside);
    if !z.iter().chain(&f).all(|x| x.is_finite()) {
        return Ok(Judgement::NOTHING);
    }

    let mut terms = vec![1.0; n];
    problem.pattern().add_sizes(&jacobian, |j| inside[j], &mut terms);
    let (mut absolute, mut relative) = (0.0_f64, 0.0_f64);
    for i in 0..n {
        let residual = (inside[i] - (inside[i] - f[i]).max(l[i]).min(u[i])).abs();
        let outside = (z[i] - inside[i]).abs() / (1.0 + z[i].abs());
        let size = if terms[i].is_finite() { terms[i] } else { 1.0 };
        absolute = absolute.max(residual).max(outside);
        relative = relative.max(residual / size).max(outside);
    }
    let enumeration = enumerate_affine(&mut *problem);
    let distance = enumeration.filter(|all| all.undecided == 0).map(|all| {
        let distances = all.solutions.iter().map(|solution| {
            let apart = |(z, s): (&f64, &f64)| (z - s).abs() / (1.0 + s.abs());
            z.iter().zip(solution).map(apart).fold(0.0, f64::max)
        });
        distances.fold(f64::INFINITY, f64::min)
    });
    Ok(Judgement { absolute, relative, distance })
}

/// `F` and the values of `J`.
fn evaluate(problem: &mut dyn Problem, z: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut f, mut jacobian) = (vec![0.0; z.len()], vec![0.0; problem.pattern().nnz()]);
    problem.evaluate(z, Some(&mut f), Some(&mut jacobian));
    (f, jacobian)
}

/// The solutions of an affine problem, one active set after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Enumeration {
    /// One solution for each active set that has exactly one; degenerate ones may appear again with
    /// other rounding errors.
    pub solutions: Vec<Vec<f64>>,
    /// Active sets whose equations are singular and consistent: whether one of their solutions
    /// lies in the box was not examined.
    pub undecided: usize,
}

/// Where a variable is.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    Lower,
    Between,
    Upper,
}

/// Tries all active sets of an affine problem: every variable at a finite bound or between, the
/// linear equations of those between, and then the signs of the rest. `None` if the problem has
/// more than six variables or is not affine, as far as `J` at two points can tell.
pub fn enumerate_affine(problem: &mut dyn Problem) -> Option<Enumeration> {
    let n = problem.shape().n();
    if n > FEW {
        return None;
    }
    let (q, values) = evaluate(problem, &vec![0.0; n]);
    // Not a multiple of any symmetry of a formula.
    let elsewhere: Vec<f64> = (0..n).map(|i| 0.7 + 0.31 * i as f64).collect();
    if !q.iter().chain(&values).all(|x| x.is_finite()) || evaluate(problem, &elsewhere).1 != values
    {
        return None;
    }
    let mut m = vec![vec![0.0; n]; n];
    for (k, i, j) in problem.pattern().entries() {
        m[i][j] = values[k];
    }
    let bounds = problem.shape().bounds();
    let (l, u) = (bounds.lower(), bounds.upper());
    let mut all = Enumeration { solutions: Vec::new(), undecided: 0 };
    let mut places = vec![Place::Lower; n];
    loop {
        let exists = |i: usize| match places[i] {
            Place::Lower => l[i].is_finite(),
            Place::Between => l[i] < u[i],
            Place::Upper => u[i].is_finite() && l[i] < u[i],
        };
        if (0..n).all(exists) {
            match at_places(&m, &q, (l, u), &places) {
                Linear::One(z) => {
                    if signs_hold(&m, &q, (l, u), &places, &z) && !all.solutions.contains(&z) {
                        all.solutions.push(z);
                    }
                }
                Linear::None => {}
                Linear::Many => all.undecided += 1,
            }
        }
        if !advance(&mut places) {
            return Some(all);
        }
    }
}

/// The next of the `3ⁿ` active sets, counted like a number of base 3; false after the last.
fn advance(places: &mut [Place]) -> bool {
    for place in places {
        *place = match *place {
            Place::Lower => Place::Between,
            Place::Between => Place::Upper,
            Place::Upper => Place::Lower,
        };
        if *place != Place::Lower {
            return true;
        }
    }
    false
}

/// How many solutions linear equations have.
enum Linear {
    One(Vec<f64>),
    None,
    Many,
}

/// Rounding errors of eliminations of a few rows, relative to the terms of a row.
const ROUNDING: f64 = 1e-12;

/// `z_i` at its bound, or `(M z + q)_i = 0`, by Gaussian elimination with complete pivoting.
fn at_places(m: &[Vec<f64>], q: &[f64], (l, u): (&[f64], &[f64]), places: &[Place]) -> Linear {
    let n = q.len();
    // Rows scaled to a largest entry of 1; the last column is the right-hand side.
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let mut row = match places[i] {
                Place::Between => [&m[i][..], &[-q[i]]].concat(),
                Place::Lower | Place::Upper => {
                    let mut row = vec![0.0; n + 1];
                    row[i] = 1.0;
                    row[n] = if places[i] == Place::Lower { l[i] } else { u[i] };
                    row
                }
            };
            let largest = row[..n].iter().fold(0.0_f64, |largest, a| largest.max(a.abs()));
            if largest > 0.0 {
                for a in &mut row {
                    *a /= largest;
                }
            }
            row
        })
        .collect();
    let mut columns: Vec<usize> = (0..n).collect();
    for step in 0..n {
        let size = |&(i, k): &(usize, usize)| rows[i][columns[k]].abs();
        let places = (step..n).flat_map(|i| (step..n).map(move |k| (i, k)));
        let Some((i, k)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
        if size(&(i, k)) <= ROUNDING {
            let consistent = rows[step..].iter().all(|row| row[n].abs() <= ROUNDING);
            return if consistent { Linear::Many } else { Linear::None };
        }
        rows.swap(step, i);
        columns.swap(step, k);
        let (above, below) = rows.split_at_mut(step + 1);
        let pivot = &above[step];
        for row in below {
            let factor = row[columns[step]] / pivot[columns[step]];
            for (a, p) in row.iter_mut().zip(pivot) {
                *a -= factor * p;
            }
        }
    }
    let mut z = vec![0.0; n];
    for step in (0..n).rev() {
        let row = &rows[step];
        let known: f64 = columns[step + 1..].iter().map(|&j| row[j] * z[j]).sum();
        z[columns[step]] = (row[n] - known) / row[columns[step]];
    }
    Linear::One(z)
}

/// The box where a variable is between its bounds, the sign of `F` where it is at one.
fn signs_hold(
    m: &[Vec<f64>],
    q: &[f64],
    (l, u): (&[f64], &[f64]),
    places: &[Place],
    z: &[f64],
) -> bool {
    (0..q.len()).all(|i| {
        let f = q[i] + m[i].iter().zip(z).map(|(m, z)| m * z).sum::<f64>();
        let terms: f64 = m[i].iter().zip(z).map(|(m, z)| (m * z).abs()).sum();
        let (slack, room) = (ROUNDING * (q[i].abs() + terms), ROUNDING * (1.0 + z[i].abs()));
        match places[i] {
            _ if l[i] == u[i] => true,
            Place::Lower => f >= -slack,
            Place::Upper => f <= slack,
            Place::Between => l[i] - room <= z[i] && z[i] <= u[i] + room,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::problem::AdProblem;
    use crate::testing::{Affine, collection};

    fn josephy() -> Instance {
        collection::named("josephy-1").unwrap().unwrap()
    }

    #[test]
    fn a_solution_is_accepted_and_what_is_beside_it_is_not() {
        let josephy = josephy();
        let solution = josephy.solutions[0].clone();
        let moved = |by: f64| {
            let mut z = solution.clone();
            z[3] += by;
            judge(&josephy, &z).unwrap()
        };
        assert!(moved(0.0).accepts() && moved(0.0).absolute <= 1e-15);
        assert!(moved(1e-8).accepts());
        assert!(!moved(1e-4).accepts());
        assert!(!moved(-1.0).accepts(), "outside the box");
        assert!((moved(1e-4).absolute - 3e-4).abs() < 1e-12, "∂F/∂z4 is 3 in three of four rows");
    }

    #[test]
    fn a_point_that_is_not_finite_or_too_short_is_no_solution() {
        let josephy = josephy();
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(!judge(&josephy, &[1.0, bad, 0.0, 0.0]).unwrap().accepts());
        }
        assert!(judge(&josephy, &[1.0]).is_err());
    }

    #[test]
    fn a_large_row_is_judged_by_its_own_terms() {
        let ring = collection::named("vonthmcp-5").unwrap().unwrap();
        let judgement = judge(&ring, &ring.start).unwrap();
        assert!(judgement.relative < judgement.absolute && !judgement.accepts());
    }

    #[test]
    fn a_scaled_instance_is_judged_in_its_original_units() {
        let scaled = collection::named("josephy-1~rc8").unwrap().unwrap();
        assert!(judge(&scaled, &scaled.solutions[0]).unwrap().accepts());
        assert!(!judge(&scaled, &[0.0; 4]).unwrap().accepts());
    }

    /// `M z + q` in a box.
    fn enumerated(m: [[f64; 2]; 2], q: [f64; 2], l: [f64; 2], u: [f64; 2]) -> Enumeration {
        let row = |i: usize| (0..2).map(|j| (j, m[i][j])).collect();
        let model = Affine::boxed((&l, &u), &[0.0; 2], q.to_vec(), vec![row(0), row(1)]).unwrap();
        enumerate_affine(&mut AdProblem::new(model).unwrap()).unwrap()
    }

    #[test]
    fn all_solutions_of_an_affine_box_problem_are_enumerated() {
        // z − ½ with the wrong sign: both bounds and the point between are solutions, each alone.
        let found = enumerated([[-1.0, 0.0], [0.0, 1.0]], [0.5, -3.0], [0.0; 2], [1.0, 2.0]);
        let mut solutions = found.solutions;
        solutions.sort_by(|a, b| a[0].total_cmp(&b[0]));
        assert_eq!(solutions, [[0.0, 2.0], [0.5, 2.0], [1.0, 2.0]]);
        assert_eq!(found.undecided, 0);
    }

    #[test]
    fn a_line_of_solutions_is_undecided_and_inconsistent_equations_have_none() {
        let (m, free) = ([[1.0, 1.0], [1.0, 1.0]], [f64::INFINITY; 2]);
        let lower = free.map(|u| -u);
        let line = enumerated(m, [-1.0, -1.0], lower, free);
        assert_eq!((line.solutions.len(), line.undecided), (0, 1));
        let none = enumerated(m, [-1.0, -2.0], lower, free);
        assert_eq!((none.solutions.len(), none.undecided), (0, 0));
    }

    #[test]
    fn what_is_not_affine_or_has_many_variables_is_not_enumerated() {
        assert!(enumerate_affine(&mut *josephy().problem().unwrap()).is_none());
        let murty = collection::named("murty-16").unwrap().unwrap();
        assert!(enumerate_affine(&mut *murty.problem().unwrap()).is_none());
    }
}
