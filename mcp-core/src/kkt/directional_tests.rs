use super::*;
use crate::economics::ces;
use crate::scalar::{Interval, Real};

type Held = Jet<1, Interval>;

/// The same numbers as a variable of a jet over `Directional` and over the jet that it holds.
fn variables(lower: f64, upper: f64) -> (Jet<1, Directional<Interval>>, Jet<1, Held>) {
    let held = Jet::variable(Interval::new(lower, upper), 0);
    (Jet::variable(Directional(held), 0), Jet::variable(held, 0))
}

fn held(number: Jet<1, Directional<Interval>>) -> Jet<1, Held> {
    Jet { v: number.v.0, d: number.d.map(|d| d.0) }
}

/// Interval by interval, unlike `==` also where they are undefined.
fn assert_same(found: Jet<1, Held>, expected: Jet<1, Held>) {
    assert_eq!(format!("{found:?}"), format!("{expected:?}"));
}

#[test]
fn an_undecided_kink_has_the_slopes_of_both_sides() {
    let (x, expected) = variables(-1.0, 2.0);
    assert_same(held(x.abs()), expected.abs());
    let slopes = x.abs().d[0].value_in_base();
    assert!(slopes.contains(-1.0) && slopes.contains(1.0), "{slopes:?}");

    let (half, expected_half) = (Jet::constant(0.5), Jet::constant(0.5));
    assert_same(held(x.max(half)), expected.max(expected_half));
    assert_same(held(x.min(half)), expected.min(expected_half));
    assert_same(held(Jet::select(x, x, half)), Jet::select(expected, expected, expected_half));
}

#[test]
fn a_constant_of_mathematics_is_rounded() {
    let number = Directional::<Interval>::rounded(0.1).value_in_base();
    assert!(number.lower() < 0.1 && number.upper() > 0.1, "{number:?}");
    let (x, expected) = variables(2.0, 3.0);
    assert_same(held(x.log10()), expected.log10());
}

#[test]
fn a_nest_over_intervals_has_the_form_that_encloses() {
    fn cost<D: Scalar>(p: D) -> D {
        let prices = [(1.0, Real::from_scalar(p)), (2.0, Real::from(1.5))];
        ces(0.7, prices, |(weight, price)| (weight, price)).into_scalar()
    }
    let p = Jet::variable(Interval::new(1.0, 2.0), 0);
    assert_same(Jet::variable(cost(Directional(p)).0, 0), Jet::variable(cost(p), 0));
}
