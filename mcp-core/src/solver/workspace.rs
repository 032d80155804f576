//! Memory of a solver, kept between solves, and the linear algebra of one iterate.

use super::certificate::{Certificate, Certifier};
use super::diagnosis::Diagnosis;
use super::newton_system::NewtonSystem;
use super::options::{Method, Options};
use super::{pivot, robust};
use crate::error::ModelError;
use crate::globalise::Reference;
use crate::linalg::LinearSolver;
use crate::model::{BoundKind, Bounds, Shape};
use crate::ncp::{Branch, Reformulation, mid};
use crate::problem::{Pattern, Problem};

/// A point with `F`, `Φ` and the merit `θ = ½‖Φ‖²`; NaN where `F` is not finite or `θ` overflows.
#[derive(Clone, Debug, Default)]
pub(super) struct Point {
    pub(super) z: Vec<f64>,
    pub(super) f: Vec<f64>,
    pub(super) phi: Vec<f64>,
    pub(super) merit: f64,
}

impl Point {
    pub(super) fn resize(&mut self, n: usize) {
        for list in [&mut self.z, &mut self.f, &mut self.phi] {
            resize(list, n);
        }
    }

    /// Becomes a copy of a point of the same length.
    pub(super) fn copy_from(&mut self, other: &Point) {
        self.z.copy_from_slice(&other.z);
        self.f.copy_from_slice(&other.f);
        self.phi.copy_from_slice(&other.phi);
        self.merit = other.merit;
    }

    /// `F`, `Φ` and `θ` at `z`, NaN where a step has overflowed.
    pub(super) fn evaluate(&mut self, problem: &mut dyn Problem, kinds: &[BoundKind]) {
        if self.z.iter().all(|z| z.is_finite()) {
            problem.evaluate(&self.z, Some(&mut self.f), None);
        } else {
            self.f.fill(f64::NAN);
        }
        self.weigh(problem.shape().bounds(), kinds);
    }

    /// `Φ` and `θ` from `z` and `F`.
    fn weigh(&mut self, bounds: &Bounds, kinds: &[BoundKind]) {
        let mut square = 0.0;
        for (i, &kind) in kinds.iter().enumerate() {
            let row = Reformulation::of_kind(kind, bounds, i);
            self.phi[i] = row.value(self.z[i], self.f[i]);
            square += self.phi[i] * self.phi[i];
        }
        self.merit = 0.5 * square;
        if !(self.merit.is_finite() && self.f.iter().all(|f| f.is_finite())) {
            self.merit = f64::NAN;
        }
    }

    /// Largest natural residual, its variable, and the number of variables on a bound branch.
    pub(super) fn natural(&self, shape: &Shape) -> Natural {
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
        let mut natural = Natural { residual: 0.0, worst: 0, active: 0 };
        for i in 0..self.z.len() {
            let (value, branch) = mid(self.z[i], self.f[i], lower[i], upper[i]);
            natural.active += usize::from(branch != Branch::Equation);
            if !(value.abs() <= natural.residual) {
                natural.residual = value.abs();
                natural.worst = i;
            }
        }
        natural
    }
}

/// Zeros of another length, or else the list as it is. Fresh zeros cost no memory before they are
/// written.
pub(super) fn resize(list: &mut Vec<f64>, len: usize) {
    if list.len() != len {
        *list = vec![0.0; len];
    }
}

/// The min map at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Natural {
    pub(super) residual: f64,
    pub(super) worst: usize,
    pub(super) active: usize,
}

/// Whether other numbers have taken the place of `J`, and of `∇θ`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lost {
    pub(super) jacobian: bool,
    pub(super) gradient: bool,
}

/// Everything a solve needs; kept for the next problem of the same pattern, made anew for another.
pub(super) struct Workspace {
    /// What the bounds of every variable mean.
    pub(super) kinds: Vec<BoundKind>,
    /// The iterate.
    pub(super) current: Point,
    /// The trial point at hand.
    pub(super) trial: Point,
    /// The full Newton step, kept while the search looks at others.
    pub(super) full: Point,
    /// The iterate moved into the box: what is judged and returned. Between two judgements, the min map
    /// at the iterate.
    pub(super) answer: Vec<f64>,
    /// Where `F` or `J` was last seen not to be finite.
    pub(super) fault_point: Vec<f64>,
    /// `J` at the iterate, unless it is lost.
    pub(super) jac: Vec<f64>,
    /// Whether lists serve several purposes in turn: with an iterative solver, which has no factors, they are
    /// most of what a solve takes.
    pub(super) is_thrifty: bool,
    pub(super) lost: Lost,
    /// Whether `a`, `b` and `answer` stand in the lists of the full step.
    full_is_lent: bool,
    /// `H = diag(a) + diag(b) J`: of the Fischer–Burmeister equations, or of the min map.
    pub(super) a: Vec<f64>,
    pub(super) b: Vec<f64>,
    /// `∇θ = HᵀΦ`.
    pub(super) gradient: Vec<f64>,
    pub(super) direction: Vec<f64>,
    /// `ζ` and `Jζ` at kinks; before that, how large the terms of `F` are.
    zeta: Vec<f64>,
    slope: Vec<f64>,
    pub(super) system: NewtonSystem,
    pub(super) reference: Reference,
    pub(super) certifier: Certifier,
    /// Memory of the methods that need more.
    pub(super) robust: Option<Box<robust::Memory>>,
    pub(super) pivoting: Option<Box<pivot::Memory>>,
    /// Of [`Method::Robust`](super::Method::Robust) and [`Method::Lemke`](super::Method::Lemke).
    pub(super) diagnosis: Option<Diagnosis>,
}

impl Workspace {
    /// For the pattern of a problem, with the solver the options choose or the caller brought. That
    /// one stays in `custom` if it refuses the pattern.
    pub(super) fn new(
        pattern: &Pattern,
        options: &Options,
        custom: &mut Option<Box<dyn LinearSolver>>,
    ) -> Result<Self, ModelError> {
        let system = NewtonSystem::new(pattern, options, custom)?;
        let (n, nnz) = (pattern.n(), pattern.nnz());
        let is_thrifty =
            Method::CLASSICAL.contains(&options.method) && system.takes_place_of_jacobian();
        // Lists that may never be used.
        let rare = || vec![0.0; if is_thrifty { 0 } else { n }];
        let mut workspace = Workspace {
            kinds: Vec::with_capacity(n),
            current: Point::default(),
            trial: Point::default(),
            full: Point::default(),
            answer: rare(),
            fault_point: rare(),
            jac: vec![0.0; nnz],
            is_thrifty,
            lost: Lost::default(),
            full_is_lent: false,
            a: rare(),
            b: rare(),
            gradient: vec![0.0; n],
            direction: vec![0.0; n],
            zeta: rare(),
            slope: rare(),
            system,
            reference: Reference::new(options.nonmonotone, options.memory),
            certifier: Certifier::default(),
            robust: None,
            pivoting: None,
            diagnosis: None,
        };
        workspace.current.resize(n);
        workspace.full.resize(n);
        if !is_thrifty {
            workspace.trial.resize(n);
            workspace.certifier.resize(n, nnz);
        }
        Ok(workspace)
    }

    /// Where lists serve in turn: those of the full step, between two such steps, for `a`, `b` and `answer`.
    pub(super) fn lend_full(&mut self, to_rows: bool) {
        if self.is_thrifty && self.full_is_lent != to_rows {
            self.full_is_lent = to_rows;
            std::mem::swap(&mut self.full.z, &mut self.answer);
            std::mem::swap(&mut self.full.f, &mut self.a);
            std::mem::swap(&mut self.full.phi, &mut self.b);
        }
    }

    /// Judges the iterate, moved into the box as `answer`. Where lists serve in turn, it costs `J`, `∇θ` and,
    /// but for `z`, the full step, and the linear solver gives its memory back.
    pub(super) fn certify(&mut self, problem: &mut dyn Problem) -> Certificate {
        resize(&mut self.answer, self.current.z.len());
        self.answer.copy_from_slice(&self.current.z);
        problem.shape().bounds().project(&mut self.answer);
        if !self.is_thrifty {
            return self.certifier.judge(problem, &self.answer);
        }
        self.system.release();
        self.lost = Lost { jacobian: true, gradient: true };
        self.exchange_with_certifier();
        let certificate = self.certifier.judge(problem, &self.answer);
        self.exchange_with_certifier();
        self.current.weigh(problem.shape().bounds(), &self.kinds);
        certificate
    }

    fn exchange_with_certifier(&mut self) {
        let Point { f, phi, .. } = &mut self.full;
        let lists = [&mut self.gradient, &mut self.current.phi, f, phi];
        self.certifier.exchange(&mut self.jac, lists);
    }

    /// Whether this workspace was made for that pattern.
    pub(super) fn fits(&self, pattern: &Pattern) -> bool {
        self.system.fits(pattern)
    }

    /// The linear solver the caller brought, if it was one.
    pub(super) fn into_custom(self) -> Option<Box<dyn LinearSolver>> {
        self.system.into_custom()
    }

    /// Bounds of a new solve.
    pub(super) fn set_bounds(&mut self, shape: &Shape) {
        self.kinds.clear();
        self.kinds.extend((0..shape.n()).map(|i| shape.bounds().kind(i)));
    }

    /// `a`, `b` and `∇θ` of the Fischer–Burmeister equations at the iterate, from its `J`.
    pub(super) fn linearise(&mut self, problem: &dyn Problem) {
        let (bounds, pattern) = (problem.shape().bounds(), problem.pattern());
        let Point { z, f, phi, .. } = &self.current;
        let (mut has_kinks, mut has_sizes) = (false, false);
        for (i, &kind) in self.kinds.iter().enumerate() {
            let row = Reformulation::of_kind(kind, bounds, i);
            (self.a[i], self.b[i]) = row.derivative(z[i], f[i]);
            let kink = row.kink(z[i], f[i], || {
                if !has_sizes {
                    resize(&mut self.slope, z.len());
                    self.slope.fill(0.0);
                    pattern.add_sizes(&self.jac, |j| z[j], &mut self.slope);
                    has_sizes = true;
                }
                self.slope[i]
            });
            if let Some(direction) = kink {
                if !has_kinks {
                    resize(&mut self.zeta, z.len());
                    resize(&mut self.slope, z.len());
                    self.zeta.fill(0.0);
                    has_kinks = true;
                }
                self.zeta[i] = direction;
            }
        }
        if has_kinks {
            // (Jζ)_i decides which element of the generalised derivative is taken.
            self.slope.fill(0.0);
            for j in (0..z.len()).filter(|&j| self.zeta[j] != 0.0) {
                for k in pattern.column(j) {
                    self.slope[pattern.row(k)] += self.jac[k] * self.zeta[j];
                }
            }
            for i in (0..z.len()).filter(|&i| self.zeta[i] != 0.0) {
                let row = Reformulation::of_kind(self.kinds[i], bounds, i);
                (self.a[i], self.b[i]) = row.kink_derivative(self.zeta[i], self.slope[i]);
            }
        }
        for j in 0..z.len() {
            let mut sum = self.a[j] * phi[j];
            for k in pattern.column(j) {
                let i = pattern.row(k);
                if self.b[i] != 0.0 {
                    sum += self.b[i] * self.jac[k] * phi[i];
                }
            }
            self.gradient[j] = sum;
        }
    }

    /// The min map at the iterate in `answer`, and `a` and `b` of its linearisation in the place of those of the
    /// Fischer–Burmeister equations.
    pub(super) fn linearise_min(&mut self, shape: &Shape) {
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
        let Point { z, f, .. } = &self.current;
        for i in 0..z.len() {
            let (value, branch) = mid(z[i], f[i], lower[i], upper[i]);
            let identity = branch != Branch::Equation;
            self.answer[i] = value;
            self.a[i] = f64::from(u8::from(identity));
            self.b[i] = f64::from(u8::from(!identity));
        }
    }

    /// `‖∇θ‖∞` relative to the terms it is summed from: 0 at a stationary point, whatever the
    /// scaling of the merit. With `a` and `b` as [`linearise`](Self::linearise) leaves them.
    pub(super) fn relative_gradient(&self, pattern: &Pattern) -> f64 {
        let phi = &self.current.phi;
        let (mut largest, mut terms) = (0.0_f64, 0.0_f64);
        for j in 0..phi.len() {
            let mut sum = (self.a[j] * phi[j]).abs();
            for k in pattern.column(j) {
                let i = pattern.row(k);
                sum += (self.b[i] * self.jac[k] * phi[i]).abs();
            }
            largest = largest.max(self.gradient[j].abs());
            terms = terms.max(sum);
        }
        if terms > 0.0 { largest / terms } else { 0.0 }
    }

    /// `max_j |∂θ/∂z_j| max(|z_j|, 1) / 2θ`: the relative change of the merit, to first order, when a
    /// variable changes by its own size. Small where the Jacobian itself vanishes, which
    /// [`relative_gradient`](Self::relative_gradient) does not see.
    pub(super) fn relative_slope(&self) -> f64 {
        let Point { z, merit, .. } = &self.current;
        let change = |(g, z): (&f64, &f64)| g.abs() * z.abs().max(1.0);
        self.gradient.iter().zip(z).map(change).fold(0.0, f64::max) / (2.0 * merit)
    }
}
