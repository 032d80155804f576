use super::*;
use crate::scalar::Scalar;

const NUMBERS: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.3,
    -2.5,
    1e-310,
    1e300,
    -1e300,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// `x` or `y` as functions of three lanes.
fn pair(x: f64, y: f64) -> [Lanes; 2] {
    let mut pair = [Lanes::seed(x, 0), Lanes::seed(y, 15)];
    pair[0].d[3] = -0.5;
    pair[1].d[3] = 2.0;
    pair
}

fn assert_same(name: &str, wide: Wide, lanes: Lanes) {
    let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    assert!(same(wide.value(), lanes.v), "{name}: {wide:?} {lanes:?}");
    assert!((0..16).all(|k| same(wide.tangent(k), lanes.d[k])), "{name}: {wide:?} {lanes:?}");
}

/// Every operation on jets in both arithmetics.
macro_rules! same {
    ($($name:literal: |$x:ident, $y:ident| $result:expr;)*) => {
        for (a, b) in NUMBERS.iter().flat_map(|&a| NUMBERS.map(|b| (a, b))) {
            let [x, y] = pair(a, b);
            $(
                let lanes = { let ($x, $y) = (x, y); let _ = $y; $result };
                let wide = { let ($x, $y) = (Wide(x), Wide(y)); let _ = $y; $result };
                assert_same(&format!("{} of {a}, {b}", $name), wide, lanes);
            )*
        }
    };
}

#[test]
fn every_operation_has_the_bits_of_16_lanes() {
    same! {
        "add": |x, y| x + y;
        "sub": |x, y| x - y;
        "mul": |x, y| x * y;
        "div": |x, y| x / y;
        "neg": |x, y| -x;
        "accumulate": |x, y| { let mut sum = x; sum.accumulate(y); sum };
        "linearised": |x, y| Scalar::linearised(2.0, &[1.0, 0.0], &[x, y]);
        "unknown": |x, y| x.with_unknown_tangents();
        "shift": |x, y| x.shift(2.0);
        "scale": |x, y| x.scale(0.0) + x.scale(3.0);
        "over": |x, y| x.over(3.0);
        "over 0": |x, y| x.over(0.0);
        "limit_product": |x, y| x.limit_product(y);
        "recip": |x, y| x.recip();
        "powi": |x, y| x.powi(-3);
        "powf": |x, y| x.powf(0.5);
        "powf_slope": |x, y| x.powf_slope(1.5, y);
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
