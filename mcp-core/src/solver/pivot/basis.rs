//! [`Basis`]: factors of a complementary basis, with updates.

use crate::linalg::LinearSolver;
use crate::problem::{Pattern, WithDiagonal};
use crate::solver::options::Options;

/// A variable of the system `M y − s + t g = −q`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variable {
    /// `y_i`.
    Level(usize),
    /// `s_i`.
    Slack(usize),
    /// `t`.
    Cover,
}

/// A bound of a level that is not basic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Lower,
    Upper,
}

/// The basis matrix `B`, one column for each pair: `M_·i` or `−e_i`, with `g` in place of one of
/// them while the covering variable is basic.
///
/// `B` has the pattern of `M` with its diagonal, whatever the basis: the linear solver analyses it
/// once. Exchanges of columns since the last factorisation are kept in product form
/// (\[GV13\] calls the factors Gauss–Jordan transformations): an exchange costs `O(n)`, a solve
/// `O(n)` more for each exchange, and no row of the inverse is ever needed.
pub(in crate::solver) struct Basis {
    pub(super) source: Pattern,
    with_diagonal: WithDiagonal,
    values: Vec<f64>,
    linear: Box<dyn LinearSolver>,
    /// `M` on the pattern with the diagonal.
    pub(super) m: Vec<f64>,
    /// Exchanges: their positions, and the columns `B⁻¹ a` one after the other.
    pivots: Vec<usize>,
    columns: Vec<f64>,
    /// Variable in every position.
    pub(super) basic: Vec<Variable>,
    pub(super) side: Vec<Side>,
    /// Values of the basic variables; the covering column `g`; a working column.
    pub(super) x: Vec<f64>,
    pub(super) cover: Vec<f64>,
    pub(super) column: Vec<f64>,
    /// The result: the levels, and the direction of a ray.
    pub(in crate::solver) y: Vec<f64>,
    pub(in crate::solver) ray: Vec<f64>,
    /// Exchanges and factorisations of the last run.
    pub(in crate::solver) exchanges: usize,
    pub(in crate::solver) factorisations: usize,
}

impl Basis {
    /// Of matrices with this pattern; `None` if no linear solver takes it.
    pub(in crate::solver) fn new(source: &Pattern, options: &Options) -> Option<Self> {
        let n = source.n();
        let with_diagonal = source.with_diagonal();
        let pattern = with_diagonal.pattern();
        let mut linear = options.linear.for_order(pattern).solver_for(pattern).ok()?;
        linear.analyse(pattern).ok()?;
        let nnz = pattern.nnz();
        Some(Basis {
            source: source.clone(),
            with_diagonal,
            values: vec![0.0; nnz],
            linear,
            m: vec![0.0; nnz],
            pivots: Vec::new(),
            columns: Vec::new(),
            basic: vec![Variable::Cover; n],
            side: vec![Side::Lower; n],
            x: vec![0.0; n],
            cover: vec![0.0; n],
            column: vec![0.0; n],
            y: vec![0.0; n],
            ray: vec![0.0; n],
            exchanges: 0,
            factorisations: 0,
        })
    }

    /// Whether this basis was made for that pattern.
    pub(in crate::solver) fn fits(&self, pattern: &Pattern) -> bool {
        self.source == *pattern
    }

    /// `M = J + ε I`.
    pub(in crate::solver) fn set_matrix(&mut self, jac: &[f64], epsilon: f64) {
        self.m.fill(0.0);
        for (k, &value) in jac.iter().enumerate() {
            self.m[self.with_diagonal.entry(k)] = value;
        }
        for j in 0..self.basic.len() {
            self.m[self.with_diagonal.diagonal(j)] += epsilon;
        }
    }

    /// Factors the basis with every variable at the position of its pair, the covering one at that
    /// of the pair without. False if it is singular.
    pub(super) fn factor(&mut self) -> bool {
        self.order_by_pairs();
        self.pivots.clear();
        self.columns.clear();
        let mut open = None;
        for j in 0..self.basic.len() {
            self.set_column(j, matches!(self.basic[j], Variable::Level(_)));
            if self.basic[j] == Variable::Cover {
                open = Some(j);
            }
        }
        let Some(position) = open else { return self.factor_values() };
        // Until the covering column replaces it, one of the open pair's own stands there.
        if !self.factor_values() {
            self.set_column(position, true);
            if !self.factor_values() {
                return false;
            }
        }
        self.column.copy_from_slice(&self.cover);
        self.solve();
        if self.column[position] == 0.0 || !self.column[position].is_finite() {
            return false;
        }
        self.exchange(position, Variable::Cover);
        true
    }

    /// Column `j` of the basis: `M_·j`, or else `−e_j`.
    fn set_column(&mut self, j: usize, is_level: bool) {
        let column = self.with_diagonal.pattern().column(j);
        if is_level {
            self.values[column.clone()].copy_from_slice(&self.m[column]);
        } else {
            self.values[column].fill(0.0);
            self.values[self.with_diagonal.diagonal(j)] = -1.0;
        }
    }

    fn factor_values(&mut self) -> bool {
        self.factorisations += 1;
        self.linear.factor(&self.values).is_ok_and(|info| info.pivot_ratio > 1e-15)
    }

    /// Moves every basic variable to the position of its pair; `x` is not kept.
    fn order_by_pairs(&mut self) {
        let n = self.basic.len();
        for position in 0..n {
            // Follow the cycle of wrong places.
            while let Variable::Level(i) | Variable::Slack(i) = self.basic[position] {
                if i == position {
                    break;
                }
                self.basic.swap(i, position);
            }
        }
    }

    /// `column ← B⁻¹ column`.
    pub(super) fn solve(&mut self) {
        let n = self.column.len();
        self.linear.solve(&mut self.column);
        for (&position, eta) in self.pivots.iter().zip(self.columns.chunks_exact(n)) {
            let pivot = self.column[position] / eta[position];
            if pivot != 0.0 {
                for (x, e) in self.column.iter_mut().zip(eta) {
                    *x -= pivot * e;
                }
            }
            self.column[position] = pivot;
        }
    }

    /// Puts a variable, whose `B⁻¹ a` is in `column`, in place of the one at a position.
    pub(super) fn exchange(&mut self, position: usize, entering: Variable) {
        self.pivots.push(position);
        self.columns.extend_from_slice(&self.column);
        self.basic[position] = entering;
    }

    /// Exchanges since the last factorisation.
    pub(super) fn age(&self) -> usize {
        self.pivots.len()
    }

    /// `column ←` the column of a variable in the system.
    pub(super) fn load(&mut self, variable: Variable) {
        self.column.fill(0.0);
        match variable {
            Variable::Level(j) => {
                let pattern = self.with_diagonal.pattern();
                for k in pattern.column(j) {
                    self.column[pattern.row(k)] = self.m[k];
                }
            }
            Variable::Slack(i) => self.column[i] = -1.0,
            Variable::Cover => self.column.copy_from_slice(&self.cover),
        }
    }

    /// `column += factor · M_·j`.
    pub(super) fn add_level(&mut self, j: usize, factor: f64) {
        let pattern = self.with_diagonal.pattern();
        for k in pattern.column(j) {
            self.column[pattern.row(k)] += factor * self.m[k];
        }
    }
}
