//! A start taken over, by name, from a solution of a model with other sets.

use super::{BoundKind, Family, Set, Shape};
use crate::error::ModelError;
use crate::solver::Solution;
use std::collections::HashMap;

impl Shape {
    /// Starts from another solution: variables of the same name take its levels, moved into the
    /// bounds, the others keep their start. For models whose sets have changed. Returns how many
    /// variables took a level.
    ///
    /// Takes time proportional to the variables of this shape and the labels of both, not to their
    /// product.
    ///
    /// ```
    /// use mcp_core::{Equation, Model, ModelError, Options, Reader, Real, Scalar, Set, Shape};
    /// use mcp_core::{Variable, solve};
    /// # struct Demand(Shape);
    /// # impl Model for Demand {
    /// #     fn shape(&self) -> &Shape { &self.0 }
    /// #     fn row<D: Scalar>(&self, _: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
    /// #         read.var(i) - 3.0
    /// #     }
    /// # }
    /// fn shape(goods: &[&str]) -> Result<Shape, ModelError> {
    ///     let goods = Set::new("goods", goods.iter().copied())?;
    ///     Shape::builder()
    ///         .variable(Variable::new("p").over(&[&goods]).start(1.0))
    ///         .equation(Equation::new("market").over(&[&goods]).complements("p"))
    ///         .build()
    /// }
    /// let old = solve(&Demand(shape(&["wheat", "iron"])?), &Options::default())?; // p = 3
    /// let mut new = shape(&["iron", "coal"])?;
    /// assert_eq!(new.start_from(&old)?, 1);
    /// assert!((new.start()[0] - 3.0).abs() < 1e-9 && new.start()[1] == 1.0);
    /// # Ok::<(), ModelError>(())
    /// ```
    ///
    /// # Errors
    /// [`ModelError::Length`] if the solution does not have one level for each of its variables;
    /// [`ModelError::StartNotFinite`] names a variable whose level is not finite. The start is
    /// unchanged then.
    pub fn start_from(&mut self, other: &Solution) -> Result<usize, ModelError> {
        let (theirs, z) = (&*other.shape, &other.z);
        theirs.check_length("levels", z)?;
        let families: HashMap<&str, &Family> =
            theirs.variables().iter().map(|family| (family.name(), family)).collect();
        let mut start = self.start().to_vec();
        let mut taken = 0;
        for family in self.variables() {
            let mut take = |k: usize, j: usize| {
                start[family.offset() + k] = z[j];
                taken += 1;
            };
            match families.get(family.name()) {
                Some(same) => {
                    for_each_common(family, same, |k, other| take(k, same.offset() + other));
                }
                None => for_each_named(family, theirs, &families, &mut take),
            }
        }
        self.set_start(&start)?;
        Ok(taken)
    }
}

/// Calls `take(k, other)` for every element `k` of `own` that `other` has under the same labels.
fn for_each_common(own: &Family, other: &Family, mut take: impl FnMut(usize, usize)) {
    if own.sets() == other.sets() && own.elements() == other.elements() {
        (0..own.len()).for_each(|k| take(k, k));
        return;
    }
    if own.sets().len() != other.sets().len() {
        return;
    }
    let places: Vec<(usize, &Set, Vec<Option<usize>>)> = own
        .sets()
        .iter()
        .zip(other.sets())
        .map(|(own, other)| (own.len(), other, own.positions_in(other)))
        .collect();
    for k in 0..own.len() {
        // From the last index to the first: its position there, and how far apart positions are.
        let (mut rest, mut combination, mut stride) = (own.combination(k), Some(0), 1);
        for (len, set, place) in places.iter().rev() {
            combination = combination.zip(place[rest % len]).map(|(sum, at)| sum + at * stride);
            rest /= len;
            stride *= set.len();
        }
        if let Some(found) = combination.and_then(|combination| other.position(combination)) {
            take(k, found);
        }
    }
}

/// The same for a family that the other shape does not have by name: `z[1]` may be a family of one
/// there and an element of `z` here, or the other way round.
fn for_each_named(
    own: &Family,
    other: &Shape,
    families: &HashMap<&str, &Family>,
    take: &mut impl FnMut(usize, usize),
) {
    if own.sets().is_empty() && !own.is_empty() {
        let has_head =
            own.name().split_once('[').is_some_and(|(head, _)| families.contains_key(head));
        if let Some(j) = has_head.then(|| other.variable_index(own.name()).ok()).flatten() {
            take(0, j);
        }
        return;
    }
    for k in 0..own.len() {
        if let Some(single) = families.get(own.element_name(k).as_str())
            && single.sets().is_empty()
            && !single.is_empty()
        {
            take(k, single.offset());
        }
    }
}

impl Shape {
    /// Takes over, by name, bounds, starts and parameters in which `before` differs from the shape as
    /// which it was `built`. A variable that a part fixes from now on, `fixed`, keeps the bounds of this
    /// shape and starts where it is fixed. Returns the variables whose start was taken over.
    ///
    /// # Errors
    /// [`ModelError::FixedByName`] for a variable that is fixed by name in `before`, and by a part from
    /// now on; and as [`set_bounds`](Self::set_bounds).
    pub(crate) fn take_changes(
        &mut self,
        built: &Shape,
        before: &Shape,
        fixed: &HashMap<usize, &str>,
    ) -> Result<Vec<usize>, ModelError> {
        let [mut lower, mut upper] =
            [self.bounds().lower(), self.bounds().upper()].map(<[f64]>::to_vec);
        let mut start = self.start().to_vec();
        let mut taken = Vec::new();
        // Bounds that were changed may have moved the start: that is no change of its own.
        let mut start_as_built = built.start().to_vec();
        before.bounds().project(&mut start_as_built);
        for (i, j) in common(self.variables(), before.variables()) {
            let bounds =
                [built, before].map(|shape| (shape.bounds().lower()[j], shape.bounds().upper()[j]));
            if let Some(part) = fixed.get(&i) {
                if bounds[0] != bounds[1] && before.bounds().kind(j) == BoundKind::Fixed {
                    let (variable, part) = (self.variable_name(i), (*part).to_owned());
                    return Err(ModelError::FixedByName { variable, part });
                }
                continue;
            }
            (lower[i], upper[i]) = bounds[1];
            if start_as_built[j] != before.start()[j] {
                start[i] = before.start()[j];
                taken.push(i);
            }
        }
        for (i, j) in common(self.parameters(), before.parameters()) {
            if built.parameter_values()[j] != before.parameter_values()[j] {
                self.parameter_values[i] = before.parameter_values()[j];
            }
        }
        self.set_bounds(&lower, &upper)?;
        self.set_start(&start)?;
        Ok(taken)
    }

    /// Whether a solution's levels are those of a model with the same variables and parameters:
    /// same names, same sets.
    pub(crate) fn check_levels_of(&self, solution: &Solution) -> Result<(), ModelError> {
        self.check_length("levels", &solution.z)?;
        same_families(self.variables(), solution.shape.variables())?;
        same_families(self.parameters(), solution.shape.parameters())
    }

    /// The same, and whether there is a value of `F` for each.
    pub(crate) fn check_solution(&self, solution: &Solution) -> Result<(), ModelError> {
        self.check_levels_of(solution)?;
        self.check_length("values of F", &solution.f)
    }

    fn check_length(&self, what: &str, list: &[f64]) -> Result<(), ModelError> {
        let (expected, found) = (self.n(), list.len());
        if expected == found {
            return Ok(());
        }
        Err(ModelError::Length { what: format!("{what} of the solution"), expected, found })
    }
}

/// Elements of families of the same name: their numbers here and there.
fn common(own: &[Family], others: &[Family]) -> Vec<(usize, usize)> {
    let of_same_name = |own: &Family| {
        let other = others.iter().find(|other| other.has_elements_of(own))?;
        Some((own.offset()..own.offset() + own.len()).zip(other.offset()..))
    };
    own.iter().filter_map(of_same_name).flatten().collect()
}

fn same_families(own: &[Family], others: &[Family]) -> Result<(), ModelError> {
    let differs = |k: &usize| match (own.get(*k), others.get(*k)) {
        (Some(own), Some(other)) => !own.has_elements_of(other),
        _ => true,
    };
    let Some(k) = (0..own.len().max(others.len())).find(differs) else { return Ok(()) };
    let family = own.get(k).or(others.get(k)).map(|family| family.name().to_owned());
    Err(ModelError::OtherModel { family: family.unwrap_or_default() })
}

#[cfg(test)]
#[path = "transfer_tests.rs"]
mod tests;
