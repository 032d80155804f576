//! The test of Krawczyk on the active system ([Kra69](crate#references)).

use super::accuracy::Refusal;
use super::boxes::OverBoxes;
use super::pairs::{Pairs, Side};
use super::points;
use crate::linalg::smallest_singular;
use crate::model::Shape;
use crate::problem::Pattern;
use crate::scalar::{Interval, Scalar};
use crate::solver::Certifier;
use nalgebra::DMatrix;

/// `F_I(x_I, c_A) = 0` near a point.
pub(super) struct ActiveSystem<'a> {
    z: &'a [f64],
    /// `w`
    weight: &'a [f64],
    /// The box `|x_j − z_j| <= ρ h_j`; at first `h = w`.
    half: Vec<f64>,
    /// `s`
    size: &'a [f64],
    /// `c`: `z`, at the bounds in `A`.
    centre: Vec<f64>,
    /// `F_I(c)`
    f: Vec<Interval>,
    /// `B`, which is `F_I'(c)` between the relative quantities `x/w` and `F/s`.
    block: DMatrix<f64>,
    /// `‖B‖₁ ‖B⁻¹‖₁`; infinite if there is no inverse.
    pub(super) condition: f64,
    /// `max_j |F_I'(c)⁻¹ F_I(c)|_j / w_j`, rounding errors of `F` included.
    pub(super) newton_step: f64,
}

/// What came out of one box.
pub(super) enum Attempt {
    /// `enclosure` holds exactly one solution.
    Proved {
        enclosure: Vec<Interval>,
        radius: f64,
    },
    /// The active system has a solution, but these pairs may be on either side.
    Undecided(Vec<usize>),
    Refused(Refusal),
}

impl<'a> ActiveSystem<'a> {
    pub(super) fn new(
        problem: &dyn OverBoxes,
        z: &'a [f64],
        pairs: &Pairs,
        certifier: &'a Certifier,
    ) -> Self {
        let (off, bounds) = (&pairs.off, problem.shape().bounds());
        let centre: Vec<f64> = (0..z.len())
            .map(|i| match pairs.side[i] {
                Side::Off => z[i],
                Side::AtLower | Side::Fixed => bounds.lower()[i],
                Side::AtUpper => bounds.upper()[i],
            })
            .collect();
        let (f, _) = problem.over(&points(&centre), &[]);
        let mut system = ActiveSystem {
            z,
            weight: certifier.weight(),
            half: certifier.weight().to_vec(),
            size: certifier.row_size(),
            centre,
            f: off.iter().map(|&i| f[i]).collect(),
            block: relative_block(problem.pattern(), certifier, off, off),
            condition: f64::INFINITY,
            newton_step: f64::INFINITY,
        };
        if let Some(inverse) = inverse(&system.block) {
            system.condition =
                if off.is_empty() { 1.0 } else { norm_1(&system.block) * norm_1(&inverse) };
            let step = system.newton(&system.in_units(&inverse, off));
            let relative =
                step.iter().zip(off).map(|(step, &j)| step.magnitude() / system.weight[j]);
            system.newton_step = relative.fold(0.0, largest);
        }
        system
    }

    /// `Y`, row by row, from the inverse between relative quantities.
    fn in_units(&self, inverse: &DMatrix<f64>, off: &[usize]) -> Vec<f64> {
        let m = off.len();
        let entry = |k: usize| self.weight[off[k / m]] * inverse[(k / m, k % m)];
        (0..m * m).map(|k| entry(k) / self.size[off[k % m]].max(f64::MIN_POSITIVE)).collect()
    }

    /// `−Y F_I(c)`
    fn newton(&self, y: &[f64]) -> Vec<Interval> {
        let m = self.f.len();
        (0..m)
            .map(|i| {
                let terms = self.f.iter().zip(&y[i * m..]).map(|(&f, &y)| Interval::point(-y) * f);
                terms.fold(Interval::point(0.0), |sum, term| sum + term)
            })
            .collect()
    }

    /// `Y` for slopes `G`: near the inverse of their midpoints ([Neu90](crate#references)
    /// section 5.1), so that kinks cost least.
    fn preconditioner(&self, g: &[Interval], off: &[usize]) -> Option<Vec<f64>> {
        let m = off.len();
        let middle = DMatrix::from_fn(m, m, |i, k| {
            let (s, w) = (self.size[off[i]].max(f64::MIN_POSITIVE), self.weight[off[k]]);
            g[i * m + k].value() * w / s
        });
        Some(self.in_units(&inverse(&middle)?, off))
    }

    /// Tries the box of this relative radius; if it is not mapped into itself, the factor by which
    /// `1 − Y G` shrinks distances relative to `h`. Where it does not, `h ← h + |1 − Y G| h`, a step
    /// towards the Perron vector, the box it shrinks most.
    pub(super) fn attempt(
        &mut self,
        problem: &dyn OverBoxes,
        pairs: &Pairs,
        radius: f64,
    ) -> Result<Attempt, f64> {
        let (off, shape) = (&pairs.off, problem.shape());
        let m = off.len();
        let x = self.around(shape, radius);
        let (f, g) = problem.over(&x, off);
        if let Some(refusal) = not_smooth(shape, pairs, &f, &g) {
            return Ok(Attempt::Refused(refusal));
        }
        let Some(y) = self.preconditioner(&g, off) else {
            return Err(f64::INFINITY);
        };
        let step = self.newton(&y);
        let (mut inside, mut factor) = (true, 0.0_f64);
        let mut shrunk = vec![0.0; m];
        for i in 0..m {
            let mut row = vec![Interval::point(0.0); m];
            row[i] = Interval::point(1.0);
            for k in 0..m {
                let y = Interval::point(-y[i * m + k]);
                for (entry, &g) in row.iter_mut().zip(&g[k * m..(k + 1) * m]) {
                    *entry = *entry + y * g;
                }
            }
            let centre = Interval::point(self.centre[off[i]]);
            let mut image = centre + step[i];
            for (&entry, &j) in row.iter().zip(off) {
                image = image + entry * (x[j] - Interval::point(self.centre[j]));
                shrunk[i] += entry.magnitude() * self.half[j];
            }
            inside &= image.is_inside(&x[off[i]]);
            factor = largest(factor, shrunk[i] / self.half[off[i]]);
        }
        if !inside {
            if !(factor < 1.0) {
                self.reshape(off, &shrunk);
            }
            return Err(factor);
        }
        let undecided = undecided(shape, pairs, &x, &f);
        Ok(if undecided.is_empty() {
            let radius = self.relative_radius(&x);
            Attempt::Proved { enclosure: x, radius }
        } else {
            Attempt::Undecided(undecided)
        })
    }

    /// `h ← h + |1 − Y G| h`, with the largest `h_j / w_j` again 1.
    fn reshape(&mut self, off: &[usize], shrunk: &[f64]) {
        let mut most = 0.0;
        for (&j, shrunk) in off.iter().zip(shrunk) {
            self.half[j] += shrunk;
            most = largest(most, self.half[j] / self.weight[j]);
        }
        for &j in off {
            self.half[j] /= most;
        }
    }

    /// The box `|x_j − z_j| <= radius h_j`, in the bounds, with `c` in it.
    fn around(&self, shape: &Shape, radius: f64) -> Vec<Interval> {
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
        (0..self.z.len())
            .map(|j| {
                let x = Interval::around(self.z[j], radius * self.half[j]);
                let centre = Interval::point(self.centre[j]);
                let x = Interval::new(x.lower().max(lower[j]), x.upper().min(upper[j]));
                if x.is_undefined() { centre } else { x.union(centre) }
            })
            .collect()
    }

    /// The largest distance from `z` in the box, relative to `w`, rounded upwards.
    fn relative_radius(&self, x: &[Interval]) -> f64 {
        let distance = |j: usize| {
            let away = x[j] - Interval::point(self.z[j]);
            (Interval::point(away.magnitude()) / Interval::point(self.weight[j])).upper()
        };
        (0..x.len()).map(distance).fold(0.0, largest)
    }

    /// Variables that can move with the least change of the equations: the large entries of the right
    /// singular vector of the smallest singular value. None are known where the block overflows.
    pub(super) fn movable(&self, shape: &Shape, off: &[usize]) -> Vec<String> {
        let Some((_, direction)) = smallest_singular(self.block.clone()) else {
            return Vec::new();
        };
        let most = direction.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
        let moves = |k: &usize| direction[*k].abs() >= 0.1 * most;
        (0..off.len()).filter(moves).map(|k| shape.variable_name(off[k])).collect()
    }
}

/// An equation that is not defined in the box, or has no finite slope.
fn not_smooth(shape: &Shape, pairs: &Pairs, f: &[Interval], g: &[Interval]) -> Option<Refusal> {
    let finite = |x: &Interval| x.lower().is_finite() && x.upper().is_finite();
    let unknown = |&i: &usize| match pairs.side[i] {
        Side::Fixed => false,
        Side::Off | Side::AtLower | Side::AtUpper => !finite(&f[i]),
    };
    if let Some(i) = (0..f.len()).find(unknown) {
        return Some(Refusal::NotDefined { equation: shape.equation_name(i) });
    }
    let m = pairs.off.len();
    let k = g.iter().position(|slope| !finite(slope))?;
    Some(Refusal::NoSlope {
        equation: shape.equation_name(pairs.off[k / m]),
        variable: shape.variable_name(pairs.off[k % m]),
    })
}

/// Pairs whose side is not the same in all of the box.
fn undecided(shape: &Shape, pairs: &Pairs, x: &[Interval], f: &[Interval]) -> Vec<usize> {
    let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
    let is_decided = |i: usize| match pairs.side[i] {
        Side::Off => lower[i] < x[i].lower() && x[i].upper() < upper[i],
        Side::AtLower => f[i].lower() > 0.0,
        Side::AtUpper => f[i].upper() < 0.0,
        Side::Fixed => true,
    };
    (0..x.len()).filter(|&i| !is_decided(i)).collect()
}

/// `J_ij w_j / s_i` for these rows and columns.
pub(super) fn relative_block(
    pattern: &Pattern,
    certifier: &Certifier,
    rows: &[usize],
    columns: &[usize],
) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        let (i, j) = (rows[i], columns[j]);
        // A row without derivatives has size 0.
        let s = certifier.row_size()[i].max(f64::MIN_POSITIVE);
        pattern.position(i, j).map_or(0.0, |k| certifier.jac()[k] * certifier.weight()[j] / s)
    })
}

/// The inverse, by LU factors; `None` if a pivot is 0.
fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    if matrix.is_empty() { Some(matrix.clone()) } else { matrix.clone().lu().try_inverse() }
}

fn norm_1(matrix: &DMatrix<f64>) -> f64 {
    matrix.column_iter().map(|column| column.lp_norm(1)).fold(0.0, largest)
}

/// The larger; NaN if either is.
fn largest(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
