use super::*;
use crate::scalar::Real;
use crate::scalar::{external, logsumexp};

const NUMBERS: [f64; 10] = [0.0, -0.0, 1.0, -1.0, 0.3, -2.5, 3.0, 1e-310, 1e300, -1e300];

/// Derivatives of `f(x, y)`, and how it depends on both.
fn sweep(
    (x, y): (f64, f64),
    f: impl for<'t> Fn(Taped<'t>, Taped<'t>) -> Taped<'t>,
) -> (f64, [f64; 2], [Dependence; 2]) {
    let tape = Tape::default();
    tape.begin(2);
    let result = f(tape.read(x, 0), tape.read(y, 1));
    let (mut adjoints, mut dependence) = (Vec::new(), Vec::new());
    tape.differentiate(&result, &mut adjoints);
    tape.dependence(&result, &mut dependence);
    (result.plain(), [adjoints[0], adjoints[1]], [dependence[0], dependence[1]])
}

/// Every function in both arithmetics: the same values, and the same derivatives where they exist.
macro_rules! same {
    ($($name:literal: |$x:ident, $y:ident| $result:expr;)*) => {
        for (a, b) in NUMBERS.iter().flat_map(|&a| NUMBERS.map(|b| (a, b))) {
            $(
                let jet = {
                    let ($x, $y) = (Jet::<2>::seed(a, 0), Jet::<2>::seed(b, 1));
                    let _ = $y;
                    $result
                };
                let (value, derivatives, _) = sweep((a, b), |$x, $y| { let _ = $y; $result });
                let name = format!("{} of {a}, {b}", $name);
                assert!(value == jet.v || value.is_nan() && jet.v.is_nan(), "{name}: {value} {}", jet.v);
                for (derivative, tangent) in derivatives.iter().zip(jet.d) {
                    let same = *derivative == tangent || !tangent.is_finite();
                    assert!(same, "{name}: {derivatives:?} {:?}", jet.d);
                }
            )*
        }
    };
}

#[test]
fn every_operation_has_the_derivatives_of_a_jet() {
    same! {
        "add": |x, y| x + y;
        "sub": |x, y| x - y;
        "mul": |x, y| x * y;
        "div": |x, y| x / y;
        "quotient of a constant": |x, y| x.shift(2.0) / y.scale(0.0).shift(4.0);
        "neg": |x, y| -x;
        "accumulate": |x, y| { let mut sum = x; sum.accumulate(y); sum };
        "linearised": |x, y| Scalar::linearised(2.0, &[1.0, 0.5], &[x, y]);
        "shift": |x, y| x.shift(2.0);
        "scale": |x, y| x.scale(0.0) + x.scale(3.0);
        "over": |x, y| x.over(3.0);
        "limit_product": |x, y| x.limit_product(y);
        "recip": |x, y| x.recip();
        "powi": |x, y| x.powi(-3);
        "powf": |x, y| x.powf(0.5);
        "pow": |x, y| x.pow(y);
        "sqrt": |x, y| x.sqrt();
        "cbrt": |x, y| x.cbrt();
        "exp": |x, y| x.exp();
        "exp_m1": |x, y| x.exp_m1();
        "ln": |x, y| x.ln();
        "ln_1p": |x, y| x.ln_1p();
        "log10": |x, y| x.log10();
        "sin": |x, y| x.sin();
        "cos": |x, y| x.cos();
        "tan": |x, y| x.tan();
        "asin": |x, y| x.asin();
        "acos": |x, y| x.acos();
        "atan": |x, y| x.atan();
        "atan2": |x, y| x.atan2(y);
        "sinh": |x, y| x.sinh();
        "cosh": |x, y| x.cosh();
        "tanh": |x, y| x.tanh();
        "hypot": |x, y| x.hypot(y);
        "xlogx": |x, y| x.xlogx();
        "abs": |x, y| x.abs();
        "max": |x, y| x.max(y);
        "min": |x, y| x.min(y);
        "select": |x, y| Scalar::select(x, y, x);
    }
}

#[test]
fn a_shared_number_collects_all_its_uses() {
    // f = s e^s + s/y with s = x y: f_x = y (e^s + s e^s + 1/y), f_y = x (e^s + s e^s).
    let (x, y) = (0.7_f64, 1.3_f64);
    let (value, by, _) = sweep((x, y), |x, y| {
        let s = x * y;
        s * s.exp() + s / y
    });
    let s = x * y;
    let slope = s.exp() * (1.0 + s);
    assert!((value - (s * s.exp() + x)).abs() < 1e-15);
    assert!((by[0] - (y * slope + 1.0)).abs() < 1e-14);
    assert!((by[1] - x * slope).abs() < 1e-14);
}

#[test]
fn a_variable_that_does_not_matter_has_no_slope_at_a_corner() {
    let (_, by, _) = sweep((0.0, 2.0), |x, y| x.sqrt() + y.scale(0.0).sqrt());
    assert_eq!(by, [f64::INFINITY, 0.0]);
    // √(x · 0) where √ has an infinite slope, behind a node.
    let (_, by, _) = sweep((3.0, 0.0), |x, y| (x.scale(0.0) + y).sqrt());
    assert_eq!(by, [0.0, f64::INFINITY]);
}

#[test]
fn affine_functions_have_constant_derivatives_and_others_vary() {
    use Dependence::{Constant, None, Varying};
    let of = |f: for<'t> fn(Taped<'t>, Taped<'t>) -> Taped<'t>| sweep((0.5, 2.0), f).2;
    assert_eq!(of(|x, y| x.scale(3.0) - y.over(2.0) + x.shift(1.0)), [Constant, Constant]);
    assert_eq!(of(|x, _| -x), [Constant, None]);
    assert_eq!(of(|x, y| x * x + y), [Varying, Constant]);
    assert_eq!(of(|x, y| x * y), [Varying, Varying]);
    assert_eq!(of(|x, y| (x + y).exp()), [Varying, Varying]);
    assert_eq!(of(|x, y| x / y), [Varying, Varying]);
    // The arm that is not taken may be taken elsewhere.
    assert_eq!(of(|x, y| x.max(y)), [Varying, Varying]);
    assert_eq!(of(|x, _| x.max(Taped::constant(1.0))), [Varying, None]);
    assert_eq!(of(|x, y| Taped::select(x, y, Taped::constant(1.0))), [Varying, Varying]);
    assert_eq!(of(|x, _| x.abs()), [Varying, None]);
}

#[test]
fn who_looks_at_values_may_do_anything_by_them() {
    use Dependence::Varying;
    let looks = |x: Taped<'_>| x.value() > 1.0;
    let (_, by, dependence) =
        sweep((0.5, 2.0), |x, y| if looks(x) { x.scale(2.0) } else { x + y.scale(0.0) });
    assert_eq!((by, dependence), ([1.0, 0.0], [Varying, Varying]));
    let (value, by, dependence) = sweep((3.0, 5.0), |x, y| {
        let product = external(&[Real::from_scalar(x), Real::from_scalar(y)], |v, gradient| {
            *gradient = [v[1], v[0]];
            v[0] * v[1]
        });
        product.into_scalar()
    });
    assert_eq!((value, by, dependence), (15.0, [5.0, 3.0], [Varying, Varying]));
    let (_, by, dependence) =
        sweep((1.0, 1.0), |x, y| logsumexp([x, y], Real::from_scalar).into_scalar());
    assert_eq!((by, dependence), ([0.5, 0.5], [Varying, Varying]));
}

#[test]
fn leaves_are_lanes_of_their_own() {
    let tape = Tape::default();
    tape.begin(0);
    let x = tape.leaf(2.0);
    let square = x * x;
    let y = tape.leaf(3.0);
    let result = square * y;
    let mut adjoints = Vec::new();
    tape.differentiate(&result, &mut adjoints);
    assert_eq!((adjoints[0], adjoints[1]), (12.0, 4.0));
}
