//! Which variable every row goes with.
//!
//! Row `i` of a file has a body `g_i(z)` and an entry in segment `r`; variable `j` has bounds
//! `l_j <= z_j <= u_j` in segment `b`. The rows become `F` like this:
//!
//! ```text
//! 5 k j   g_i(z) ⟂ l_j <= z_j <= u_j       g_i >= 0 at l_j, <= 0 at u_j, = 0 in between
//! 4 c     g_i(z) − c = 0  ⟂  z_j free      j: a free variable that no row complements
//! 3       g_i(z) unbounded                 says nothing, has no variable
//! others  an inequality                    an error that names the row
//! ```
//!
//! The sign is that of AMPL ([FFG99](mcp_core#references)), whose solver library puts the body into
//! `[0, ∞)` for `k = 1` and into `(−∞, 0]` for `k = 2`. Bodies carry their own constants. The bits of `k` repeat which bounds of `z_j` are
//! finite; where they do not, row and bounds contradict each other, and that is an error: Pyomo
//! writes `k = 1` for `x >= 0` also where `x` has an upper bound `u` from its declaration, at
//! which the user still asks for `g >= 0`.
//!
//! Conditions between two expressions, `f(x) >= 0 ⟂ h(x) >= 0`, come with auxiliary variables of
//! their own: AMPL and Pyomo write `v` and an equation for one side, `h(x) − v = 0`, and Pyomo a
//! second pair for the other.
//!
//! Which free variable an equation goes with changes neither solutions nor signs. It is chosen by a
//! largest matching on the nonzeros of segment `J`, so that the diagonal of the Jacobian is
//! structurally nonzero wherever that is possible; what is left over goes in order.

use super::error::NlError;
use super::matching;
use super::segments::RowKind;
use mcp_core::BoundKind;

/// Names for messages.
pub(super) trait NameOf {
    fn row(&self, i: usize) -> String;
    fn variable(&self, j: usize) -> String;
}

/// What a file says about rows and variables.
pub(super) struct System<'a> {
    pub(super) rows: &'a [RowKind],
    pub(super) bounds: &'a [(f64, f64)],
    pub(super) names: &'a dyn NameOf,
    /// Equations and the free variables they must go with.
    pub(super) defining: &'a [(usize, usize)],
}

impl System<'_> {
    /// The variable of every row, `None` for rows that say nothing. `columns(i)` lists the variables
    /// of row `i`.
    pub(super) fn pairs(
        &self,
        columns: impl Fn(usize) -> Vec<u32>,
    ) -> Result<Vec<Option<usize>>, NlError> {
        let mut pairs = vec![None; self.rows.len()];
        let mut row_of = vec![None; self.bounds.len()];
        let mut equations = Vec::new();
        for (i, row) in self.rows.iter().enumerate() {
            match *row {
                RowKind::Complements { bits, variable } => {
                    self.check_bits(i, bits, variable)?;
                    if let Some(first) = row_of[variable].replace(i) {
                        return Err(NlError::ComplementedTwice {
                            variable: self.names.variable(variable),
                            first: self.names.row(first),
                            second: self.names.row(i),
                        });
                    }
                    pairs[i] = Some(variable);
                }
                kind if kind.is_equation() => equations.push(i),
                RowKind::Between { lower: f64::NEG_INFINITY, upper: f64::INFINITY } => {}
                RowKind::Between { .. } => {
                    return Err(NlError::Inequality { row: self.names.row(i) });
                }
            }
        }
        let mut free = self.free_variables(&row_of)?;
        self.check_square(&equations, &free)?;
        for &(i, j) in self.defining {
            pairs[i] = Some(j);
            row_of[j] = Some(i);
        }
        equations.retain(|&i| pairs[i].is_none());
        free.retain(|&j| row_of[j].is_none());
        let found = match_equations(&equations, &free, self.bounds.len(), columns);
        for (i, j) in equations.into_iter().zip(found) {
            pairs[i] = Some(j);
        }
        Ok(pairs)
    }

    /// The bounds that a row says are finite must be those that are.
    fn check_bits(&self, row: usize, bits: u8, variable: usize) -> Result<(), NlError> {
        let (lower, upper) = self.bounds[variable];
        let finite = u8::from(lower > f64::NEG_INFINITY) + 2 * u8::from(upper < f64::INFINITY);
        if bits == finite {
            return Ok(());
        }
        let said = match bits {
            0 => "no finite bound",
            1 => "a lower bound only",
            2 => "an upper bound only",
            _ => "both bounds",
        };
        let (row, variable) = (self.names.row(row), self.names.variable(variable));
        Err(NlError::BoundsOfPair { row, variable, said, lower, upper })
    }

    /// Free variables that no row complements. Those with bounds must be fixed.
    fn free_variables(&self, row_of: &[Option<usize>]) -> Result<Vec<usize>, NlError> {
        let mut free = Vec::new();
        for (j, &(lower, upper)) in self.bounds.iter().enumerate() {
            if row_of[j].is_some() {
                continue;
            }
            match kind(lower, upper) {
                BoundKind::Free => free.push(j),
                BoundKind::Fixed => {}
                _ => {
                    let variable = self.names.variable(j);
                    return Err(NlError::BoundedWithoutRow { variable, lower, upper });
                }
            }
        }
        Ok(free)
    }

    fn check_square(&self, equations: &[usize], free: &[usize]) -> Result<(), NlError> {
        if equations.len() == free.len() {
            return Ok(());
        }
        let first = match (equations.get(free.len()), free.get(equations.len())) {
            (Some(&row), _) => self.names.row(row),
            (_, Some(&variable)) => self.names.variable(variable),
            (None, None) => String::new(),
        };
        Err(NlError::NotSquare { equations: equations.len(), variables: free.len(), first })
    }
}

fn kind(lower: f64, upper: f64) -> BoundKind {
    match (lower > f64::NEG_INFINITY, upper < f64::INFINITY) {
        (false, false) => BoundKind::Free,
        (true, true) if lower == upper => BoundKind::Fixed,
        (true, true) => BoundKind::Boxed,
        (true, false) => BoundKind::Lower,
        (false, true) => BoundKind::Upper,
    }
}

/// A variable for every equation: a largest matching, and what is left over in order.
fn match_equations(
    equations: &[usize],
    free: &[usize],
    variables: usize,
    columns: impl Fn(usize) -> Vec<u32>,
) -> Vec<usize> {
    let mut place = vec![u32::MAX; variables];
    for (k, &j) in (0..).zip(free) {
        place[j] = k;
    }
    let places = |&i: &usize| -> Vec<u32> {
        let all = columns(i).into_iter().map(|j| place[j as usize]);
        all.filter(|&place| place != u32::MAX).collect()
    };
    let lists: Vec<Vec<u32>> = equations.iter().map(places).collect();
    let matched = matching::maximum(equations.len(), free.len(), |e| &lists[e]);
    let mut is_taken = vec![false; free.len()];
    matched.iter().flatten().for_each(|&place| is_taken[place] = true);
    let mut left = (0..free.len()).filter(|&place| !is_taken[place]);
    let place = |found: Option<usize>| found.or_else(|| left.next()).expect("as many as equations");
    matched.into_iter().map(place).map(|place| free[place]).collect()
}
