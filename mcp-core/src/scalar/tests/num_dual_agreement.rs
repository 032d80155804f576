//! Jets against num-dual, an independent implementation of the same calculus.
//!
//! num-dual is called directly here, not through its [`Scalar`] implementation, whose fallback is a
//! jet. Points where num-dual is wrong (a value more than 4 ulp from `f64`, a derivative more than
//! 2 ulp from the closed form) are left out and counted: the share that is compared must stay
//! large.

use super::closed_forms::{closed_form, closed_form_of_two};
use super::wide::Wide;
use super::{Binary, Random, Unary, close, pairs, points};
use crate::scalar::{Jet, Scalar};
use num_dual::{Dual2_64, Dual64, DualNum, DualSVec64, HyperDual64};

/// num-dual's own function; `None` where it has none.
fn raw<D: DualNum<Primitive = f64> + Copy>(f: Unary, x: D) -> Option<D> {
    Some(match f {
        Unary::Recip => x.recip(),
        Unary::Sqrt => x.sqrt(),
        Unary::Cbrt => x.cbrt(),
        Unary::Exp => x.exp(),
        Unary::ExpM1 => x.exp_m1(),
        Unary::Ln => x.ln(),
        Unary::Ln1p => x.ln_1p(),
        Unary::Log10 => x.log10(),
        Unary::Sin => x.sin(),
        Unary::Cos => x.cos(),
        Unary::Tan => x.tan(),
        Unary::Asin => x.asin(),
        Unary::Acos => x.acos(),
        Unary::Atan => x.atan(),
        Unary::Sinh => x.sinh(),
        Unary::Cosh => x.cosh(),
        Unary::Tanh => x.tanh(),
        Unary::Powf(p) => x.powf(p),
        Unary::Powi(n) => x.powi(n),
        Unary::Xlogx | Unary::Abs => return None,
    })
}

/// Points in the interior of the domain, of ordinary size.
fn ordinary_points(f: Unary) -> Vec<f64> {
    let mut random = Random(5);
    let mut draw = || match f {
        // `p − 3` is rounded there: digits are lost in proportion to `ln x`.
        Unary::Powf(p) if p.fract() != 0.0 && p.abs() < 1.0 => random.magnitude(-2.0, 2.0).abs(),
        Unary::Sqrt | Unary::Ln | Unary::Log10 | Unary::Powf(_) => {
            random.magnitude(-20.0, 20.0).abs()
        }
        Unary::Ln1p => random.uniform(-0.9, 10.0),
        Unary::Asin | Unary::Acos => random.uniform(-0.9, 0.9),
        Unary::Exp | Unary::ExpM1 | Unary::Sinh | Unary::Cosh => random.uniform(-100.0, 100.0),
        Unary::Sin | Unary::Cos | Unary::Tan => random.uniform(-20.0, 20.0),
        Unary::Tanh => random.uniform(-1.0, 1.0),
        _ => random.magnitude(-20.0, 20.0),
    };
    (0..2000).map(|_| draw()).collect()
}

/// Whether num-dual's derivative is right: within 2 ulp of the closed form. Its formulas round more
/// often than ours for some functions (`tan` and `tanh` by the quotient rule, `powf` as
/// `x^(p−3) x x`), so not every answer is.
fn is_right(derivative: f64, exact: Wide) -> bool {
    close(derivative, exact.round(), 2)
}

/// ulp to which second derivatives agree: num-dual's formulas round about twice as often.
const SECOND_ORDER_ULPS: u64 = 16;

#[test]
fn jets_agree_with_num_dual_in_every_lane_and_order() {
    for f in Unary::ALL {
        let all = ordinary_points(f);
        let mut compared = 0;
        for &x in &all {
            let Some(dual) = raw(f, Dual64::new(x, 1.0)) else { continue };
            let Some([exact, ..]) = closed_form(f, x) else { continue };
            if !close(dual.re, f.of(x), 4) || !is_right(dual.eps, exact) {
                continue;
            }
            compared += 1;
            let what = format!("{f:?}({x:e})");
            let jet = f.of(Jet::<2, Jet<1>>::variable(Jet::seed(x, 0), 1));
            let [passive, active] = jet.d;
            assert!(close(active.v, dual.eps, 4), "{what}: {:e}, {:e}", active.v, dual.eps);

            let vector = raw(f, DualSVec64::<2>::from_re(x).derivative(1)).unwrap();
            let lanes = [0, 1].map(|k| vector.tangent(k));
            assert!(close(passive.v, lanes[0], 0), "{what}: {:e}, {:e}", passive.v, lanes[0]);
            assert!(close(active.v, lanes[1], 4), "{what}: {:e}, {:e}", active.v, lanes[1]);

            let second = raw(f, Dual2_64::new(x, 1.0, 0.0)).unwrap().v2;
            let mixed = raw(f, HyperDual64::new(x, 1.0, 1.0, 0.0)).unwrap().eps1eps2;
            for other in [second, mixed] {
                let near = close(active.d[0], other, SECOND_ORDER_ULPS);
                assert!(near, "{what}'': {:e}, {other:e}", active.d[0]);
            }
        }
        let absent = matches!(f, Unary::Xlogx | Unary::Abs);
        assert!(absent || compared * 100 >= all.len() * 90, "{f:?}: only {compared} compared");
    }
}

#[test]
fn partial_derivatives_of_jets_agree_with_num_dual() {
    let mut random = Random(6);
    let mut compared = 0;
    for k in 0..4000 {
        let (x, y) = (random.magnitude(-2.0, 2.0), random.magnitude(-2.0, 2.0));
        let power = k % 2 == 0;
        let f = if power { Binary::Pow } else { Binary::Atan2 };
        let x = if power { x.abs() } else { x };
        let (a, b) =
            (DualSVec64::<2>::from_re(x).derivative(0), DualSVec64::from_re(y).derivative(1));
        let dual = if power { a.powd(b) } else { DualNum::atan2(&a, b) };
        let jet = f.of(Jet::<2>::seed(x, 0), Jet::seed(y, 1));
        let Some((exact, _)) = closed_form_of_two(f, x, y) else { continue };
        for lane in 0..2 {
            let (ours, other) = (jet.d[lane], dual.tangent(lane));
            if close(dual.re, jet.v, 4) && is_right(other, exact[lane]) {
                compared += 1;
                assert!(close(ours, other, 4), "{f:?}({x:e}, {y:e}): {ours:e}, {other:e}");
            }
        }
    }
    assert!(compared > 7800, "only {compared} compared");
}

/// The value of the [`Scalar`] implementation against `f64`, at every corner and everywhere else.
fn values_are_those_of_f64<D: Scalar>(arithmetic: &str) {
    for f in Unary::ALL {
        for x in points(2000) {
            let (value, plain) = (f.of(D::seed(x, 0)).value(), f.of(x));
            assert!(close(value, plain, 4), "{arithmetic} {f:?}({x:e}): {value:e}, f64 {plain:e}");
        }
    }
    for f in Binary::ALL {
        for (x, y) in pairs(2000) {
            let (a, b) = (D::seed(x, 0), D::seed(y, D::LANES - 1));
            let (value, plain) = (f.of(a, b).value(), f.of(x, y));
            let near = close(value, plain, 4);
            assert!(near, "{arithmetic} {f:?}({x:e}, {y:e}): {value:e}, f64 {plain:e}");
        }
    }
}

#[test]
fn values_of_num_dual_types_are_within_four_ulp_of_f64_everywhere() {
    values_are_those_of_f64::<Dual64>("Dual64");
    values_are_those_of_f64::<DualSVec64<2>>("DualSVec64<2>");
    values_are_those_of_f64::<Dual2_64>("Dual2_64");
    values_are_those_of_f64::<HyperDual64>("HyperDual64");
}

#[test]
fn derivatives_of_num_dual_types_are_finite_wherever_those_of_jets_are() {
    for f in Unary::ALL {
        for x in points(2000) {
            let jet = f.of(Jet::<1>::seed(x, 0)).d[0];
            let dual = f.of(Dual64::seed(x, 0)).eps;
            assert_eq!(jet.is_finite(), dual.is_finite(), "{f:?}({x:e}): {jet:e}, {dual:e}");
            assert_eq!(jet.is_nan(), dual.is_nan(), "{f:?}({x:e}): {jet:e}, {dual:e}");
        }
    }
}

#[test]
fn seeds_and_parts_of_num_dual_types_are_those_of_the_trait() {
    fn check<D: Scalar>(lanes: usize) {
        assert_eq!(D::LANES, lanes);
        for lane in 0..lanes {
            for k in 0..=lanes {
                let x = D::seed(3.0, k);
                assert!(close(x.tangent(lane), if k == lane { 1.0 } else { 0.0 }, 0));
            }
        }
        let zero = D::constant(0.0);
        assert!(zero.is_zero() && zero.is_finite() && !D::seed(0.0, 0).is_zero());
        assert!(!D::constant(1.0).is_zero() && !D::constant(f64::INFINITY).is_finite());
        let unknown = D::seed(3.0, 0).with_unknown_tangents();
        assert!(close(unknown.value(), 3.0, 0) && !unknown.is_finite());
        assert!((0..lanes).all(|lane| unknown.tangent(lane).is_nan()));
    }
    check::<Dual64>(1);
    check::<DualSVec64<3>>(3);
    check::<Dual2_64>(1);
    check::<HyperDual64>(2);
    assert!(Dual2_64::seed(1.0, 0).with_unknown_tangents().v2.is_nan());
    assert!(HyperDual64::seed(1.0, 0).with_unknown_tangents().eps1eps2.is_nan());
    assert!(close(Dual2_64::seed(1.0, 0).v1, 1.0, 0));
}

#[test]
fn large_integer_powers_do_not_overflow_inside_num_dual() {
    for n in [i32::MIN, -46_342, -32_768, 32_768, 46_341, i32::MAX] {
        let x = Dual2_64::new(1.0, 1.0, 0.0);
        let y = Scalar::powi(x, n);
        let n = f64::from(n);
        assert!(close(y.re, 1.0, 0) && close(y.v1, n, 0), "{n}: {y:?}");
        assert!(close(y.v2, n * (n - 1.0), 4), "{n}: {y:?}");
    }
}
