//! The corner table of the module page, row by row.

use super::corner_rows::{Check, checks};
use super::{Binary, CORNERS, Unary, close, pairs, same};
use crate::scalar::{Jet, Scalar};
use num_dual::{Dual2_64, Dual64, DualSVec64, HyperDual64};

const INF: f64 = f64::INFINITY;

/// The rows of the table, read out of the documentation itself.
fn table() -> Vec<&'static str> {
    include_str!("../mod.rs")
        .lines()
        .filter_map(|line| line.strip_prefix("//! | ")?.strip_suffix(" |"))
        .filter(|row| !row.starts_with("function |") && !row.starts_with("---"))
        .collect()
}

/// Seeds each argument in turn and compares value and derivative.
fn holds<D: Scalar>(check: &Check, arithmetic: &str, ulps: u64) {
    let value = |x: &[D]| check.call.of(x).value();
    let constants: Vec<D> = check.at.iter().map(|&x| D::constant(x)).collect();
    let what = format!("{arithmetic}: {:?} at {:?}", check.call, check.at);
    let plain = check.call.of(&check.at);
    assert!(close(plain, check.value, 1), "{what}: f64 gives {plain:e}");
    assert!(close(value(&constants), plain, ulps), "{what}: {:e}", value(&constants));
    for i in 0..constants.len() {
        let mut x = constants.clone();
        x[i] = D::seed(check.at[i], 0);
        let y = check.call.of(&x);
        assert!(ulps > 0 || same(y.value(), plain), "{what}: value {:e}", y.value());
        assert!(close(y.value(), plain, ulps), "{what}: value {:e}", y.value());
        let (got, promised) = (y.tangent(0), check.gradient[i]);
        assert!(close(got, promised, 8), "{what}: derivative {i} is {got:e}, not {promised:e}");
    }
}

#[test]
fn every_row_of_the_corner_table_holds() {
    let (rows, checks) = (table(), checks());
    for row in &rows {
        assert!(checks.iter().any(|(text, _)| text == row), "no check for the row: {row}");
    }
    for (row, points) in &checks {
        assert_eq!(rows.iter().filter(|text| *text == row).count(), 1, "not in the table: {row}");
        assert!(!points.is_empty(), "no point for the row: {row}");
        for point in points {
            holds::<Jet<1>>(point, "Jet<1>", 0);
            holds::<Jet<4>>(point, "Jet<4>", 0);
            holds::<Jet<1, Jet<1>>>(point, "Jet<1, Jet<1>>", 0);
            holds::<Dual64>(point, "Dual64", 4);
            holds::<DualSVec64<3>>(point, "DualSVec64<3>", 4);
            holds::<Dual2_64>(point, "Dual2_64", 4);
            holds::<HyperDual64>(point, "HyperDual64", 4);
        }
    }
    assert_eq!(rows.len(), checks.len());
    assert!(rows.len() >= 75, "only {} rows were found in the table", rows.len());
}

/// A lane in which no argument has a tangent.
fn untouched_lane_stays_zero<D: Scalar>(arithmetic: &str) {
    let last = D::LANES - 1;
    for x in CORNERS {
        for f in Unary::ALL {
            let passive = f.of(D::seed(x, 0)).tangent(last);
            assert!(passive.abs().to_bits() == 0, "{arithmetic}: {f:?}({x:e}) has {passive:e}");
        }
        for c in CORNERS {
            let x = D::seed(x, 0);
            for y in [x.scale(c), x.over(c), x.shift(c)] {
                let passive = y.tangent(last);
                assert!(passive.abs().to_bits() == 0, "{arithmetic}: {x:?} and {c:e}: {passive:e}");
            }
        }
    }
    for (x, y) in pairs(0) {
        let (a, b, c) = (D::seed(x, 0), D::seed(y, 0), D::constant(y));
        for f in Binary::ALL {
            for result in [f.of(a, b), f.of(a, c), f.of(c, a)] {
                let passive = result.tangent(last);
                let zero = passive.abs().to_bits() == 0;
                assert!(zero, "{arithmetic}: {f:?}({x:e}, {y:e}) has {passive:e}");
            }
        }
        let passive = D::select(a, b, c).tangent(last);
        assert!(passive.abs().to_bits() == 0, "{arithmetic}: select({x:e}, {y:e}) has {passive:e}");
    }
}

#[test]
fn a_zero_tangent_stays_zero_at_every_corner_of_every_function() {
    untouched_lane_stays_zero::<Jet<2>>("Jet<2>");
    untouched_lane_stays_zero::<Jet<2, Jet<2>>>("Jet<2, Jet<2>>");
    untouched_lane_stays_zero::<DualSVec64<2>>("DualSVec64<2>");
    untouched_lane_stays_zero::<HyperDual64>("HyperDual64");
}

#[test]
fn a_zero_tangent_of_a_jet_stays_zero_under_the_operators() {
    for (x, y) in pairs(0) {
        let (a, b, c) = (Jet::<2>::seed(x, 0), Jet::<2>::seed(y, 0), Jet::<2>::constant(y));
        for result in [a + b, a - b, a / b, a / c, c / a, -a, a.limit_product(b)] {
            assert!(result.d[1].abs().to_bits() == 0, "{x:e}, {y:e}: {result:?}");
        }
        for product in [a * b, a * c] {
            let unpoisoned = product.d[1].abs().to_bits() == 0;
            assert!(unpoisoned || !product.v.is_finite(), "{x:e}, {y:e}: {product:?}");
        }
    }
}

#[test]
fn second_derivatives_by_passive_variables_stay_zero_at_the_corners() {
    type Hessian = Jet<2, Jet<2>>;
    for f in Unary::ALL {
        for x in CORNERS {
            let [active, passive] = f.of(Hessian::variable(Jet::seed(x, 0), 0)).d;
            let rest = [active.d[1], passive.v, passive.d[0], passive.d[1]];
            let zero = rest.iter().all(|d| d.abs().to_bits() == 0);
            assert!(zero, "{f:?}({x:e}): {rest:?}");
        }
    }
}

#[test]
fn second_derivatives_take_their_limits_at_the_corners() {
    for (f, x, limit) in [
        (Unary::Sqrt, 0.0, -INF),
        (Unary::Cbrt, 0.0, -INF),
        (Unary::Recip, 0.0, INF),
        (Unary::Ln, 0.0, -INF),
        (Unary::Log10, 0.0, -INF),
        (Unary::Ln1p, -1.0, -INF),
        (Unary::Xlogx, 0.0, INF),
        (Unary::Asin, 1.0, INF),
        (Unary::Asin, -1.0, -INF),
        (Unary::Acos, 1.0, -INF),
        (Unary::Powf(0.5), 0.0, -INF),
        (Unary::Powf(1.5), 0.0, INF),
        (Unary::Powf(2.0), 0.0, 2.0),
        (Unary::Powf(2.5), 0.0, 0.0),
        (Unary::Powi(2), 0.0, 2.0),
        (Unary::Powi(3), 0.0, 0.0),
        (Unary::Exp, 800.0, INF),
        (Unary::Tanh, 800.0, 0.0),
        (Unary::Tanh, INF, 0.0),
        (Unary::Atan, INF, 0.0),
        (Unary::Sqrt, INF, 0.0),
        (Unary::Recip, INF, 0.0),
    ] {
        let jet = f.of(Jet::<1, Jet<1>>::variable(Jet::seed(x, 0), 0)).d[0].d[0];
        assert!(close(jet, limit, 0), "{f:?}''({x:e}) is {jet:e} by Jet");
        let dual = f.of(Dual2_64::new(x, 1.0, 0.0)).v2;
        assert!(close(dual, limit, 0), "{f:?}''({x:e}) is {dual:e} by Dual2_64");
        let dual = f.of(HyperDual64::new(x, 1.0, 1.0, 0.0)).eps1eps2;
        assert!(close(dual, limit, 0), "{f:?}''({x:e}) is {dual:e} by HyperDual64");
    }
}
