//! Rules that hold for every function and every point.

use super::{Binary, Unary, close};
use crate::scalar::{
    Counted, Jet, Real, Scalar, Tally, Trace, atan2, external, hypot, logsumexp, max, min, prod,
    select, smooth_max, smooth_min, sum, when,
};
use num_dual::{Dual2_64, DualSVec64, HyperDual64};
use proptest::prelude::*;

type Nested = Jet<1, Jet<1>>;

fn real<D: Scalar>(x: D) -> Real<D> {
    Real::from_scalar(x)
}

fn plain(x: f64) -> Real<f64> {
    Real::from(x)
}

fn nested(x: f64) -> Nested {
    Jet::variable(Jet::seed(x, 0), 0)
}

/// Relative to the size of the terms that were added.
fn near(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= 16.0 * f64::EPSILON * size || close(a, b, 0)
}

/// Every function, for use on `0.1..0.9` where all are smooth.
fn function() -> impl Strategy<Value = Unary> {
    prop::sample::select(Unary::ALL.to_vec())
}

/// A smooth model: all functions of several variables, products, quotients, compositions.
fn model<D: Scalar>(x: Real<D>, y: Real<D>) -> Real<D> {
    let power = x.pow(y) + x.pow(1.7) * y.pow(3) - 2 / (1.0 + x * y);
    let waves = (x * y).sin() * y.cos() + (x / 3).tan().exp() - (y / x).ln_1p();
    let angles = atan2(y, x) * hypot(x, y) + x.asin() * y.acos() - (x - y).atan();
    let rest = logsumexp([x, y, 2.0 * x], |t| t) + smooth_max(x, y, 0.1) * smooth_min(x, 0.5, 0.2);
    power + waves + angles + rest + (1.5 + x.xlogx() + y.tanh() - x.cbrt()).sqrt().sinh()
}

proptest! {
    #[test]
    fn chain_rule_holds(f in function(), g in function(), x in 0.1..0.9) {
        let inner = g.of(Jet::<1>::seed(x, 0));
        let outer = f.of(Jet::<1>::seed(inner.v, 0));
        let both = f.of(g.of(Jet::<1>::seed(x, 0)));
        prop_assert!(close(both.v, outer.v, 0));
        let product = outer.d[0] * inner.d[0];
        prop_assert!(close(both.d[0], product, 0) || inner.d[0] == 0.0, "{} {product}", both.d[0]);
    }

    #[test]
    fn product_and_quotient_rules_hold(f in function(), g in function(), x in 0.1..0.9) {
        let (a, b) = (f.of(Jet::<1>::seed(x, 0)), g.of(Jet::<1>::seed(x, 0)));
        prop_assume!(a.is_finite() && b.is_finite());
        let terms = [a.d[0] * b.v, a.v * b.d[0]];
        let size = terms[0].abs() + terms[1].abs();
        prop_assert!(near((a * b).d[0], terms[0] + terms[1], size));
        prop_assume!(b.v != 0.0);
        let square = b.v * b.v;
        prop_assert!(near((a / b).d[0], (terms[0] - terms[1]) / square, size / square));
    }

    #[test]
    fn derivatives_are_linear(
        f in function(), g in function(), x in 0.1..0.9, s in -9.0..9.0, t in -9.0..9.0,
    ) {
        let (a, b) = (f.of(Jet::<1>::seed(x, 0)), g.of(Jet::<1>::seed(x, 0)));
        prop_assume!(a.is_finite() && b.is_finite());
        let sum = a.scale(s) + b.scale(t) - Jet::constant(3.0);
        prop_assert!(close(sum.d[0], a.d[0] * s + b.d[0] * t, 0));
    }

    #[test]
    fn nested_jets_and_num_dual_agree_on_a_whole_model(x in 0.3..0.9, y in 0.1..0.9) {
        let jet = model(
            real(Jet::<2, Jet<2>>::variable(Jet::seed(x, 0), 0)),
            real(Jet::variable(Jet::seed(y, 1), 1)),
        ).0;
        prop_assert!(jet.is_finite());
        let gradient = [jet.d[0].v, jet.d[1].v];
        let hessian = [jet.d[0].d[0], jet.d[0].d[1], jet.d[1].d[0], jet.d[1].d[1]];
        prop_assert!(close(jet.v.v, model(plain(x), plain(y)).0, 0));
        prop_assert!(near(hessian[1], hessian[2], 100.0 * (1.0 + hessian[1].abs())), "{hessian:?}");

        let vector = model(real(DualSVec64::<2>::seed(x, 0)), real(DualSVec64::seed(y, 1))).0;
        for k in 0..2 {
            let size = 100.0 * (1.0 + gradient[k].abs());
            prop_assert!(near(vector.tangent(k), gradient[k], size), "{vector:?} {gradient:?}");
        }
        let size = |d: f64| 1000.0 * (1.0 + d.abs());
        let second = model(real(Dual2_64::seed(x, 0)), real(Dual2_64::constant(y))).0;
        prop_assert!(near(second.v2, hessian[0], size(hessian[0])), "{second:?} {hessian:?}");
        let second = model(real(Dual2_64::constant(x)), real(Dual2_64::seed(y, 0))).0;
        prop_assert!(near(second.v2, hessian[3], size(hessian[3])), "{second:?} {hessian:?}");
        let mixed = model(real(HyperDual64::seed(x, 0)), real(HyperDual64::seed(y, 1))).0;
        prop_assert!(near(mixed.eps1eps2, hessian[1], size(hessian[1])), "{mixed:?} {hessian:?}");
    }

    #[test]
    fn second_derivatives_by_nested_jets_agree_with_dual2(f in function(), x in 0.1..0.9) {
        let jet = f.of(nested(x));
        let dual = f.of(Dual2_64::seed(x, 0));
        let size = 1.0 + dual.v1.abs() + dual.v2.abs();
        prop_assert!(near(jet.d[0].v, dual.v1, size), "{jet:?} {dual:?}");
        prop_assert!(near(jet.d[0].d[0], dual.v2, 4.0 * size), "{jet:?} {dual:?}");
    }

    #[test]
    fn the_trace_holds_every_nonzero_tangent(
        f in function(), g in function(), h in prop::sample::select(Binary::ALL.to_vec()),
        x in -2.0..2.0, y in -2.0..2.0,
    ) {
        fn expression<D: Scalar>(f: Unary, g: Unary, h: Binary, x: [D; 3]) -> D {
            D::select(x[2], h.of(f.of(x[0]), g.of(x[1])), f.of(x[1]) * x[0].scale(2.0).shift(1.0))
        }
        let v = [x, y, x - y];
        let trace = expression(f, g, h, [0, 1, 2].map(|k| Trace::seed(v[k], k)));
        let jet = expression(f, g, h, [0, 1, 2].map(|k| Jet::<3>::seed(v[k], k)));
        for k in 0..3 {
            prop_assert!(trace.depends_on(k) || jet.d[k] == 0.0);
        }
        prop_assert!(!trace.depends_on(3));
        let half = expression(f, g, h, [Trace::seed(x, 7), Trace::constant(y), Trace::constant(1.0)]);
        prop_assert!(half.depends_on(7) && (0..128).filter(|&k| half.depends_on(k)).count() == 1);
    }

    #[test]
    fn every_function_counts_once(f in function(), x in 0.1..0.9) {
        let tally = Tally::new();
        f.of(tally.variable(x));
        let expected = match f {
            Unary::Powi(n) => [0, 0, 1, 4, 3][[0, 1, 2, 7, -3].iter().position(|&m| m == n).unwrap()],
            _ => 1,
        };
        prop_assert_eq!(tally.counts().total(), expected);
        f.of(Counted::constant(x));
        prop_assert_eq!(tally.counts().total(), expected);
    }

    #[test]
    fn logsumexp_is_the_logarithm_of_the_sum(x in prop::collection::vec(-5.0..5.0_f64, 1..6), c in -1e3..1e3_f64) {
        let seeds = |k: usize| real(Jet::<6>::seed(x[k] + c, k));
        let jet = logsumexp(0..x.len(), seeds).0;
        let naive: f64 = x.iter().map(|x| x.exp()).sum();
        prop_assert!((jet.v - c - naive.ln()).abs() <= 1e-12, "{} {}", jet.v - c, naive.ln());
        for k in 0..6 {
            let share = x.get(k).map_or(0.0, |x| x.exp() / naive);
            prop_assert!((jet.d[k] - share).abs() <= 1e-12, "{} {share}", jet.d[k]);
        }
    }

    #[test]
    fn smooth_max_and_min_enclose_max_and_min(a in -5.0..5.0, b in -5.0..5.0, width in 0.0..2.0) {
        let (x, y) = (real(Jet::<2>::seed(a, 0)), real(Jet::<2>::seed(b, 1)));
        let (above, below) = (smooth_max(x, y, width).0, smooth_min(x, y, width).0);
        let rounding = 1e-14;
        prop_assert!((-rounding..=width + rounding).contains(&(above.v - a.max(b))));
        prop_assert!((-rounding..=width + rounding).contains(&(a.min(b) - below.v)));
        for smooth in [above, below] {
            prop_assert!(smooth.d.iter().all(|d| (-rounding..=1.0 + rounding).contains(d)));
            prop_assert!((smooth.d[0] + smooth.d[1] - 1.0).abs() <= rounding);
        }
        prop_assert!((above.v + below.v - a - b).abs() <= 4.0 * rounding);
    }

    #[test]
    fn clamp_stays_between_its_limits(x in -3.0..3.0, l in -2.0..2.0, u in -2.0..2.0) {
        let [a, b, c] = [(x, 0), (l, 1), (u, 2)].map(|(v, k)| real(Jet::<3>::seed(v, k)));
        let clamped = a.clamp(b, c).0;
        prop_assert!(close(a.clamp(l, u).0.v, clamped.v, 0));
        let winner = if l > u || x < l { 1 } else if x > u { 2 } else { 0 };
        prop_assert!(close(clamped.v, [x, l, u][winner], 0));
        let expected = |k| f64::from(u8::from(k == winner));
        prop_assert!((0..3).all(|k| close(clamped.d[k], expected(k), 0)));
    }

    #[test]
    fn operators_agree_on_either_side_by_value_and_reference(a in -9.0..9.0_f64, k in 1..9, y in 0.5..9.0) {
        let (x, c) = (real(Jet::<1>::seed(y, 0)), f64::from(k));
        let (r, b) = (Real::from(a), Real::from(c));
        macro_rules! agree {
            ($($op:tt $assign:tt),*) => {$(
                for (got, expected) in [
                    (a $op x, r $op x), (&a $op x, r $op x), (a $op &x, r $op x), (&a $op &x, r $op x),
                    (x $op c, x $op b), (&x $op c, x $op b), (x $op &c, x $op b), (&x $op &c, x $op b),
                    (k $op x, b $op x), (&k $op x, b $op x), (k $op &x, b $op x), (&k $op &x, b $op x),
                    (x $op k, x $op b), (&x $op k, x $op b), (x $op &k, x $op b), (&x $op &k, x $op b),
                    (&x $op x, x $op x), (x $op &x, x $op x), (&x $op &x, x $op x),
                    ({ let mut z = x; z $assign c; z }, x $op b),
                    ({ let mut z = x; z $assign k; z }, x $op b),
                    ({ let mut z = x; z $assign &x; z }, x $op x),
                ] {
                    prop_assert!(close(got.0.v, expected.0.v, 0));
                    prop_assert!(close(got.0.d[0], expected.0.d[0], 2), "{:?} {:?}", got, expected);
                }
            )*};
        }
        agree! { + +=, - -=, * *=, / /= }
        prop_assert!(close((-x).0.v, -y, 0) && close((-&x).0.d[0], -1.0, 0));
        prop_assert!(close(x.pow(k).0.v, x.powi(k).0.v, 0));
        prop_assert!(close(max(a, x).0.v, a.max(y), 0) && close(min(x, a).0.v, a.min(y), 0));
        let larger = a.max(y);
        prop_assert!(close(select(x - a, x, a).0.v, larger, 0));
    }

    #[test]
    fn sums_and_products_are_those_of_data(x in prop::collection::vec(-3.0..3.0, 0..5)) {
        let total = x.iter().skip(1).fold(x.first().copied().unwrap_or(0.0), |s, x| s + x);
        let product = x.iter().skip(1).fold(x.first().copied().unwrap_or(1.0), |s, x| s * x);
        let of = |x: &f64| real(Jet::<1>::seed(*x, 0));
        prop_assert!(close(sum(&x, of).0.v, total, 0) && close(sum(&x, |x| *x), total, 0));
        prop_assert!(close(prod(&x, of).0.v, product, 0) && close(prod(&x, |x| *x), product, 0));
        prop_assert!(close(sum(&x, of).0.d[0], x.len() as f64, 0));
        prop_assert!(close(x.iter().map(of).sum::<Real<_>>().0.v, total, 0));
        prop_assert!(close(x.iter().map(of).product::<Real<_>>().0.v, product, 0));
    }

    #[test]
    fn an_external_function_is_right_to_first_order_and_unknown_to_second(x in 0.5..2.0, y in 0.5..2.0) {
        fn outside<D: Scalar>(x: Real<D>, y: Real<D>) -> Real<D> {
            external(&[x.exp(), y], |v, gradient| {
                *gradient = [v[1].powi(2), 2.0 * v[0] * v[1]];
                v[0] * v[1].powi(2)
            })
        }
        let expected = (real(Jet::<2>::seed(x, 0)).exp() * real(Jet::<2>::seed(y, 1)).powi(2)).0;
        let jet = outside(real(Jet::<2>::seed(x, 0)), real(Jet::seed(y, 1))).0;
        let dual = outside(real(DualSVec64::<2>::seed(x, 0)), real(DualSVec64::seed(y, 1))).0;
        for k in 0..2 {
            prop_assert!(close(jet.d[k], expected.d[k], 4) && close(dual.tangent(k), expected.d[k], 4));
        }
        let jet = outside(real(nested(x)), real(Nested::constant(y))).0;
        prop_assert!(close(jet.d[0].v, expected.d[0], 4) && jet.d[0].d[0].is_nan());
        let dual = outside(real(Dual2_64::seed(x, 0)), real(Dual2_64::constant(y))).0;
        prop_assert!(close(dual.v1, expected.d[0], 4) && dual.v2.is_nan());
        let dual = outside(real(HyperDual64::seed(x, 0)), real(HyperDual64::seed(y, 1))).0;
        prop_assert!(close(dual.eps2, expected.d[1], 4) && dual.eps1eps2.is_nan());
        let passive = outside(real(Nested::constant(x)), real(Nested::constant(y))).0;
        prop_assert!(passive.is_finite() && passive.d[0].is_zero());
        let passive = outside(real(Dual2_64::constant(x)), real(Dual2_64::constant(y))).0;
        prop_assert!(Scalar::is_finite(&passive));
        let trace = outside(real(Trace::seed(x, 0)), real(Trace::seed(y, 1))).0;
        prop_assert!(trace.depends_on(0) && trace.depends_on(1) && !trace.has_second_order());
    }
}

#[test]
fn a_false_condition_on_data_evaluates_nothing() {
    let x = real(Jet::<1>::seed(3.0, 0));
    let off = when(false, || -> Real<Jet<1>> { unreachable!("the condition is false") });
    assert!(off.0.is_zero());
    assert!(close(when(true, || x * x).0.d[0], 6.0, 0));
    assert_eq!(when(true, || 7) + when(false, || 8), 7);
}

#[test]
fn the_pattern_of_logsumexp_does_not_depend_on_the_point() {
    for point in [[0.0, 1.0], [f64::NEG_INFINITY; 2], [f64::INFINITY, 0.0], [f64::NAN, 0.0]] {
        let trace = logsumexp(0..2, |k| real(Trace::seed(point[k], k))).0;
        assert!(trace.depends_on(0) && trace.depends_on(1), "{point:?}: {trace:?}");
        assert!(close(trace.value(), logsumexp(point, plain).0, 0));
    }
}

#[test]
fn a_lane_outside_the_range_is_passive() {
    assert!(
        close(Jet::<2>::seed(3.0, 2).d[0], 0.0, 0) && close(Jet::<2>::seed(3.0, 2).d[1], 0.0, 0)
    );
    assert!(!(0..128).any(|lane| Trace::seed(1.0, 128).depends_on(lane)));
}
