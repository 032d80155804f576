//! Variables, bounds and starts by name: `x[seattle, topeka]` for one, `x` for all of a family.

use super::{Family, Shape};
use crate::error::{ModelError, nearest};
use std::ops::Range;

impl Shape {
    /// Number of the variable with this name, such as `p` or `x[seattle, topeka]`.
    ///
    /// ```
    /// # use mcp_core::{Equation, Set, Shape, Variable};
    /// let goods = Set::new("goods", ["wheat", "iron"])?;
    /// let shape = Shape::builder()
    ///     .variable(Variable::new("p").over(&[&goods]).lower(0.0))
    ///     .equation(Equation::new("market").over(&[&goods]).complements("p"))
    ///     .build()?;
    /// assert_eq!(shape.variable_index("p[iron]")?, 1);
    /// let error = shape.variable_index("p[iren]").unwrap_err();
    /// assert_eq!(error.to_string(), "there is no label `iren`; did you mean `iron`?");
    /// # Ok::<(), mcp_core::ModelError>(())
    /// ```
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] for the family or a label, with the nearest one;
    /// [`ModelError::Length`] for the wrong number of labels.
    pub fn variable_index(&self, name: &str) -> Result<usize, ModelError> {
        let (family, labels) = self.split_name(name)?;
        Ok(family.offset() + index_in(family, labels.unwrap_or_default())?)
    }

    /// Fixes a variable, or all of a family, at a value; its equation may then have any value.
    ///
    /// # Errors
    /// As [`variable_index`](Self::variable_index), and [`ModelError::UnusableBounds`] for a value
    /// that is not finite.
    pub fn fix(&mut self, name: &str, value: f64) -> Result<(), ModelError> {
        self.bound(name, Some(value), Some(value))
    }

    /// Changes the lower bound of a variable, or of all of a family; `-inf` removes it.
    ///
    /// # Errors
    /// As [`variable_index`](Self::variable_index), and [`ModelError::UnusableBounds`],
    /// [`ModelError::CrossedBounds`], [`ModelError::Unpaired`].
    pub fn set_lower(&mut self, name: &str, lower: f64) -> Result<(), ModelError> {
        self.bound(name, Some(lower), None)
    }

    /// Changes the upper bound of a variable, or of all of a family; `+inf` removes it.
    ///
    /// # Errors
    /// As [`set_lower`](Self::set_lower).
    pub fn set_upper(&mut self, name: &str, upper: f64) -> Result<(), ModelError> {
        self.bound(name, None, Some(upper))
    }

    /// Changes the start of a variable, or of all of a family, moving it into the bounds.
    ///
    /// # Errors
    /// As [`variable_index`](Self::variable_index), and [`ModelError::StartNotFinite`].
    pub fn set_start_of(&mut self, name: &str, value: f64) -> Result<(), ModelError> {
        let mut start = self.start().to_vec();
        start[self.range_of(name)?].fill(value);
        self.set_start(&start)
    }

    /// A start from a point of another shape: variables of the same name take its values, the others
    /// keep this shape's start. For models whose sets have changed.
    ///
    /// # Errors
    /// [`ModelError::Length`] if `z` is not a point of `other`.
    pub fn start_from(&self, other: &Shape, z: &[f64]) -> Result<Vec<f64>, ModelError> {
        if z.len() != other.n() {
            let (what, expected) = ("z".to_owned(), other.n());
            return Err(ModelError::Length { what, expected, found: z.len() });
        }
        let mut start = self.start().to_vec();
        for (j, start) in start.iter_mut().enumerate() {
            if let Ok(same) = other.variable_index(&self.variable_name(j)) {
                *start = z[same];
            }
        }
        self.bounds().project(&mut start);
        Ok(start)
    }

    fn bound(
        &mut self,
        name: &str,
        lower: Option<f64>,
        upper: Option<f64>,
    ) -> Result<(), ModelError> {
        let range = self.range_of(name)?;
        let (mut l, mut u) = (self.bounds().lower().to_vec(), self.bounds().upper().to_vec());
        if let Some(lower) = lower {
            l[range.clone()].fill(lower);
        }
        if let Some(upper) = upper {
            u[range].fill(upper);
        }
        self.set_bounds(&l, &u)
    }

    /// The variables a name stands for: one, or all of a family.
    fn range_of(&self, name: &str) -> Result<Range<usize>, ModelError> {
        let (family, labels) = self.split_name(name)?;
        let offset = family.offset();
        match labels {
            None => Ok(offset..offset + family.len()),
            Some(labels) => {
                let j = offset + index_in(family, labels)?;
                Ok(j..j + 1)
            }
        }
    }

    /// The family of a name, and what stands between its brackets.
    fn split_name<'n>(&self, name: &'n str) -> Result<(&Family, Option<&'n str>), ModelError> {
        // A family of one may have brackets in its own name.
        if let Some(family) = self.variables().iter().find(|family| family.name() == name) {
            return Ok((family, None));
        }
        let (head, labels) = match name.strip_suffix(']').and_then(|rest| rest.split_once('[')) {
            Some((head, labels)) => (head, Some(labels)),
            None => (name, None),
        };
        Ok((self.variable(head.trim())?, labels))
    }
}

/// Position of the element with these labels, `a, b`, in its family.
fn index_in(family: &Family, labels: &str) -> Result<usize, ModelError> {
    let given: Vec<&str> = if labels.is_empty() { Vec::new() } else { labels.split(',').collect() };
    if given.len() == family.sets().len() {
        let mut index = 0;
        for (set, label) in family.sets().iter().zip(given) {
            index = index * set.len() + set.index_of(label.trim())?;
        }
        return Ok(index);
    }
    // Labels may contain commas: then only the whole name can tell.
    let whole = format!("{}[{labels}]", family.name());
    let names: Vec<String> = (0..family.len()).map(|k| family.element_name(k)).collect();
    if let Some(index) = names.iter().position(|name| *name == whole) {
        return Ok(index);
    }
    match nearest(&whole, names.iter().map(String::as_str)) {
        Some(near) => {
            Err(ModelError::UnknownName { kind: "variable", name: whole, nearest: Some(near) })
        }
        None => Err(ModelError::Length {
            what: format!("labels of {}", family.name()),
            expected: family.sets().len(),
            found: given.len(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Equation, Set, Variable};

    fn trade(markets: &[&str]) -> Shape {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let markets = Set::new("markets", markets.iter().copied()).unwrap();
        Shape::builder()
            .variable(Variable::new("x").over(&[&plants, &markets]).lower(0.0).start(1.0))
            .variable(Variable::new("p").lower(0.0).start(2.0))
            .equation(Equation::new("profit").over(&[&plants, &markets]).complements("x"))
            .equation(Equation::new("balance").complements("p"))
            .build()
            .unwrap()
    }

    #[test]
    fn every_variable_is_found_by_its_own_name() {
        let shape = trade(&["new-york", "chicago", "x, y"]);
        for j in 0..shape.n() {
            assert_eq!(shape.variable_index(&shape.variable_name(j)), Ok(j));
        }
        assert_eq!(shape.variable_index("x[ san-diego,chicago ]"), Ok(4));
    }

    #[test]
    fn faults_in_names_are_named() {
        let shape = trade(&["new-york", "chicago"]);
        let cases = [
            ("q", "there is no variable `q`; did you mean `p`?"),
            ("quantity[a]", "there is no variable `quantity`"),
            ("x[seatle, chicago]", "there is no label `seatle`; did you mean `seattle`?"),
            ("x[seattle]", "the length of `labels of x` is 1, expected 2"),
            ("x", "the length of `labels of x` is 0, expected 2"),
            ("p[1]", "the length of `labels of p` is 1, expected 0"),
        ];
        for (name, message) in cases {
            assert_eq!(shape.variable_index(name).unwrap_err().to_string(), message);
        }
    }

    #[test]
    fn bounds_and_starts_change_for_one_or_for_all() {
        let mut shape = trade(&["new-york", "chicago"]);
        shape.set_upper("x", 5.0).unwrap();
        shape.fix("x[seattle, chicago]", 3.0).unwrap();
        shape.set_lower("p", f64::NEG_INFINITY).unwrap();
        shape.set_start_of("x", 9.0).unwrap();
        assert_eq!(shape.bounds().lower(), [0.0, 3.0, 0.0, 0.0, f64::NEG_INFINITY]);
        assert_eq!(shape.bounds().upper(), [5.0, 3.0, 5.0, 5.0, f64::INFINITY]);
        assert_eq!(shape.start(), [5.0, 3.0, 5.0, 5.0, 2.0]);
        let crossed = shape.set_upper("x[seattle, chicago]", 1.0).unwrap_err().to_string();
        assert!(crossed.starts_with("variable `x[seattle, chicago]` has crossed bounds"));
        assert!(shape.fix("p", f64::NAN).is_err());
        assert_eq!(shape.bounds().upper()[1], 3.0, "nothing changes on error");
    }

    #[test]
    fn a_start_is_taken_over_by_name() {
        let old = trade(&["new-york", "chicago"]);
        let new = trade(&["chicago", "topeka"]);
        let start = new.start_from(&old, &[1.0, 20.0, 3.0, 40.0, -5.0]).unwrap();
        // chicago from the point, topeka from the own start, p moved into its bounds.
        assert_eq!(start, [20.0, 1.0, 40.0, 1.0, 0.0]);
        assert!(new.start_from(&old, &[1.0]).is_err());
    }
}
