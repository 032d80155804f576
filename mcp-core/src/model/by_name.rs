//! Variables, bounds and starts by name: `x[seattle, topeka]` for one, `x` for all of a family.

use super::builder::name_among;
use super::{Family, Set, Shape};
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
    /// [`ModelError::Length`] for the wrong number of labels; [`ModelError::NoSuchElement`] for a
    /// combination of labels that the family does not have; [`ModelError::PartOff`] for a name of a
    /// part that is off.
    pub fn variable_index(&self, name: &str) -> Result<usize, ModelError> {
        let found = split_name("variable", self.variables(), name);
        let (family, labels) = found.map_err(|error| self.unknown_or_off(error))?;
        Ok(family.offset() + index_in("variable", family, labels.unwrap_or_default())?)
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

    /// Changes the values of a parameter family, or the one value of an element: `tax[iron]`.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`], [`ModelError::PartOff`], [`ModelError::NoSuchElement`],
    /// [`ModelError::Length`], [`ModelError::ParameterNotFinite`].
    pub fn set_parameter(&mut self, name: &str, values: &[f64]) -> Result<(), ModelError> {
        let range = self.elements("parameter", self.parameters(), name)?;
        if values.len() != range.len() {
            let (what, expected) = (format!("parameter {name}"), range.len());
            return Err(ModelError::Length { what, expected, found: values.len() });
        }
        if let Some(k) = values.iter().position(|value| !value.is_finite()) {
            let parameter = name_among(self.parameters(), range.start + k);
            return Err(ModelError::ParameterNotFinite { parameter, value: values[k] });
        }
        self.parameter_values[range].copy_from_slice(values);
        Ok(())
    }

    /// Changes a parameter, or all of a family, to one value.
    ///
    /// # Errors
    /// As [`set_parameter`](Self::set_parameter), whatever the number of elements.
    pub fn fill_parameter(&mut self, name: &str, value: f64) -> Result<(), ModelError> {
        let count = self.elements("parameter", self.parameters(), name)?.len();
        self.set_parameter(name, &vec![value; count])
    }

    /// The variables a name stands for: one, or all of a family.
    pub(crate) fn range_of(&self, name: &str) -> Result<Range<usize>, ModelError> {
        self.elements("variable", self.variables(), name)
    }

    /// The elements a name stands for, among those of all families: one, or all of a family.
    pub(super) fn elements(
        &self,
        kind: &'static str,
        families: &[Family],
        name: &str,
    ) -> Result<Range<usize>, ModelError> {
        let found = split_name(kind, families, name);
        let (family, labels) = found.map_err(|error| self.unknown_or_off(error))?;
        let offset = family.offset();
        match labels {
            None => Ok(offset..offset + family.len()),
            Some(labels) => {
                let k = offset + index_in(kind, family, labels)?;
                Ok(k..k + 1)
            }
        }
    }
}

/// The family of a name, and what stands between its brackets.
fn split_name<'f, 'n>(
    kind: &'static str,
    families: &'f [Family],
    name: &'n str,
) -> Result<(&'f Family, Option<&'n str>), ModelError> {
    // A family of one may have brackets in its own name, and so may a label.
    if let Some(family) = families.iter().find(|family| family.name() == name) {
        return Ok((family, None));
    }
    let mut labelled = families.iter().filter(|family| family.is_labelled);
    if let Some(family) = labelled.find(|family| family.sets()[0].find(name).is_some()) {
        return Ok((family, Some(name)));
    }
    let (head, labels) = match name.strip_suffix(']').and_then(|rest| rest.split_once('[')) {
        Some((head, labels)) => (head, Some(labels)),
        None => (name, None),
    };
    let family = families.iter().find(|family| family.name() == head.trim());
    family.map(|family| (family, labels)).ok_or_else(|| unknown(kind, families, name, head))
}

/// Nothing is called `name`: the nearest family of that `head`, or the nearest label that is a name.
fn unknown(kind: &'static str, families: &[Family], name: &str, head: &str) -> ModelError {
    let labelled = families.iter().filter(|family| family.is_labelled);
    let labels: Vec<String> = labelled.flat_map(|family| family.sets()[0].labels()).collect();
    if let Some(near) = nearest(name, labels.iter().map(String::as_str)) {
        return ModelError::UnknownName { kind, name: name.to_owned(), nearest: Some(near) };
    }
    let nearest = nearest(head.trim(), families.iter().map(Family::name));
    ModelError::UnknownName { kind, name: head.trim().to_owned(), nearest }
}

impl Family {
    /// A label as it is, or without the spaces around it.
    fn position_of(set: &Set, label: &str) -> Result<usize, ModelError> {
        set.index_of(label).or_else(|_| set.index_of(label.trim()))
    }

    /// Index in the family of the element with these labels, one for each index set.
    ///
    /// # Errors
    /// [`ModelError::UnknownName`] with the nearest label, [`ModelError::NoSuchElement`] for a
    /// combination that does not exist, [`ModelError::Length`] for the wrong number of labels.
    pub fn index_of(&self, labels: &[&str]) -> Result<usize, ModelError> {
        let (expected, found) = (self.sets().len(), labels.len());
        if expected != found {
            let what = format!("labels of {}", self.name());
            return Err(ModelError::Length { what, expected, found });
        }
        let mut combination = 0;
        for (set, label) in self.sets().iter().zip(labels) {
            combination = combination * set.len() + Family::position_of(set, label)?;
        }
        self.position(combination).ok_or_else(|| ModelError::NoSuchElement {
            element: self.combination_name(combination),
            family: self.name().to_owned(),
        })
    }
}

/// Position of the element with these labels, `a, b`, in its family.
fn index_in(kind: &'static str, family: &Family, labels: &str) -> Result<usize, ModelError> {
    if family.is_labelled {
        return family.index_of(&[labels]);
    }
    let given: Vec<&str> = if labels.is_empty() { Vec::new() } else { labels.split(',').collect() };
    if given.len() == family.sets().len() {
        return family.index_of(&given);
    }
    // Labels may contain commas: then only the whole name can tell, if anything can.
    let whole = format!("{}[{labels}]", family.name());
    let names: Vec<String> = (0..family.len()).map(|k| family.element_name(k)).collect();
    let mut same = (0..names.len()).filter(|&k| names[k] == whole);
    match (same.next(), same.next()) {
        (Some(index), None) => return Ok(index),
        (Some(_), Some(_)) => return Err(ModelError::AmbiguousName { name: whole }),
        (None, _) => {}
    }
    match nearest(&whole, names.iter().map(String::as_str)) {
        Some(near) => Err(ModelError::UnknownName { kind, name: whole, nearest: Some(near) }),
        None => Err(ModelError::Length {
            what: format!("labels of {}", family.name()),
            expected: family.sets().len(),
            found: given.len(),
        }),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::model::{Equation, Variable};

    /// `x[plants, markets]` and `p`.
    pub(in crate::model) fn trade(markets: &[&str]) -> Shape {
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
    fn a_name_that_two_elements_have_is_ambiguous() {
        let left = Set::new("left", ["a", "a, b"]).unwrap();
        let right = Set::new("right", ["b, c", "c"]).unwrap();
        let shape = Shape::builder()
            .variable(Variable::new("x").over(&[&left, &right]))
            .equation(Equation::new("f").over(&[&left, &right]).complements("x"))
            .build()
            .unwrap();
        assert_eq!(shape.variable_index("x[a, c]"), Ok(1));
        assert_eq!(
            shape.variable_index("x[a, b, c]").unwrap_err().to_string(),
            "two elements are called `x[a, b, c]`, because labels contain commas: rename one"
        );
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
    fn labels_of_a_labelled_family_are_names() {
        let columns = Set::new("columns", ["x['a','b']", "x['a','c']", "price"]).unwrap();
        let mut shape = Shape::builder()
            .variable(Variable::new("column").labelled(&columns))
            .equation(Equation::new("row").over(&[&columns]).complements("column"))
            .build()
            .unwrap();
        for j in 0..3 {
            assert_eq!(shape.variable_index(&shape.variable_name(j)), Ok(j));
        }
        shape.set_lower("x['a','c']", 1.0).unwrap();
        shape.set_upper("column", 5.0).unwrap();
        assert_eq!(shape.bounds().lower()[1], 1.0);
        assert_eq!(shape.bounds().upper(), [5.0; 3]);
        let error = shape.variable_index("prise").unwrap_err();
        assert_eq!(error.to_string(), "there is no variable `prise`; did you mean `price`?");
        let error = shape.variable_index("quantity").unwrap_err();
        assert_eq!(error.to_string(), "there is no variable `quantity`");
    }

    #[test]
    fn an_absent_combination_is_answered_with_its_name() {
        let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
        let ports = Set::count("ports", 3);
        let mut shape = Shape::builder()
            .variable(Variable::new("x").over(&[&plants, &ports]).only([0, 4]))
            .equation(Equation::new("f").over(&[&plants, &ports]).only([0, 4]).complements("x"))
            .build()
            .unwrap();
        for j in 0..2 {
            assert_eq!(shape.variable_index(&shape.variable_name(j)), Ok(j));
        }
        let absent =
            "there is no `x[seattle, 2]`: `x` has only some of the combinations of its sets";
        assert_eq!(shape.variable_index("x[seattle,2]").unwrap_err().to_string(), absent);
        assert_eq!(shape.fix("x[seattle, 2]", 1.0).unwrap_err().to_string(), absent);
        shape.set_lower("x", -1.0).unwrap();
        shape.fix("x[san-diego, 2]", 3.0).unwrap();
        assert_eq!(shape.bounds().lower(), [-1.0, 3.0]);
        let unknown = shape.variable_index("x[seattle, 7]").unwrap_err();
        assert_eq!(unknown.to_string(), "there is no label `7`");
    }
}
