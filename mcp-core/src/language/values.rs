//! [`FamilyValues`]: bounds and starts of a variable family while it is declared.

/// What a variable family has one of for each element.
#[derive(Clone, Copy, Debug)]
pub enum Side {
    /// Lower bound.
    Lower,
    /// Upper bound.
    Upper,
    /// Where a solve starts.
    Start,
}

/// Bounds and starts of a variable family, one for each element, while it is declared.
#[derive(Default)]
pub(super) struct FamilyValues {
    pub(super) lower: Vec<f64>,
    pub(super) upper: Vec<f64>,
    pub(super) start: Vec<f64>,
}

impl FamilyValues {
    /// Free variables starting at 0.
    pub(super) fn free(count: usize) -> Self {
        FamilyValues {
            lower: vec![f64::NEG_INFINITY; count],
            upper: vec![f64::INFINITY; count],
            start: vec![0.0; count],
        }
    }

    pub(super) fn of(&mut self, side: Side) -> &mut Vec<f64> {
        match side {
            Side::Lower => &mut self.lower,
            Side::Upper => &mut self.upper,
            Side::Start => &mut self.start,
        }
    }

    /// Fixes an element.
    pub(super) fn fix(&mut self, place: usize, value: f64) {
        (self.lower[place], self.upper[place], self.start[place]) = (value, value, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fixing_an_element_sets_its_bounds_and_its_start_and_no_others() {
        let mut values = FamilyValues::free(3);
        values.fix(1, 2.5);
        let (minus, plus) = (f64::NEG_INFINITY, f64::INFINITY);
        assert_eq!(values.lower, [minus, 2.5, minus]);
        assert_eq!(values.upper, [plus, 2.5, plus]);
        assert_eq!(values.start, [0.0, 2.5, 0.0]);
        values.fix(1, -1.0);
        assert_eq!((values.lower[1], values.upper[1], values.start[1]), (-1.0, -1.0, -1.0));
    }

    #[test]
    fn a_family_without_elements_has_no_values() {
        let values = FamilyValues::free(0);
        assert!(values.lower.is_empty() && values.upper.is_empty() && values.start.is_empty());
    }
}
