//! Tests of the arithmetics: corners, closed forms, agreement with num-dual, properties.

mod closed_forms;
mod corner_rows;
mod corners;
mod interval;
mod num_dual_agreement;
mod properties;
mod wide;

use super::{Counted, Jet, Scalar, Tally, Trace};

/// The functions of one variable, so that a test can run over all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Unary {
    Recip,
    Sqrt,
    Cbrt,
    Exp,
    ExpM1,
    Ln,
    Ln1p,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Xlogx,
    Abs,
    Powf(f64),
    Powi(i32),
}

impl Unary {
    const ALL: [Unary; 31] = [
        Unary::Recip,
        Unary::Sqrt,
        Unary::Cbrt,
        Unary::Exp,
        Unary::ExpM1,
        Unary::Ln,
        Unary::Ln1p,
        Unary::Log10,
        Unary::Sin,
        Unary::Cos,
        Unary::Tan,
        Unary::Asin,
        Unary::Acos,
        Unary::Atan,
        Unary::Sinh,
        Unary::Cosh,
        Unary::Tanh,
        Unary::Xlogx,
        Unary::Abs,
        Unary::Powf(0.0),
        Unary::Powf(0.3),
        Unary::Powf(1.0),
        Unary::Powf(1.5),
        Unary::Powf(2.0),
        Unary::Powf(-0.7),
        Unary::Powf(-2.0),
        Unary::Powi(0),
        Unary::Powi(1),
        Unary::Powi(2),
        Unary::Powi(7),
        Unary::Powi(-3),
    ];

    fn of<D: Scalar>(self, x: D) -> D {
        match self {
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
            Unary::Xlogx => x.xlogx(),
            Unary::Abs => x.abs(),
            Unary::Powf(p) => x.powf(p),
            Unary::Powi(n) => x.powi(n),
        }
    }
}

/// The functions of two variables.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Binary {
    Pow,
    Atan2,
    Hypot,
    Max,
    Min,
}

impl Binary {
    const ALL: [Binary; 5] = [Binary::Pow, Binary::Atan2, Binary::Hypot, Binary::Max, Binary::Min];

    fn of<D: Scalar>(self, x: D, y: D) -> D {
        match self {
            Binary::Pow => x.pow(y),
            Binary::Atan2 => x.atan2(y),
            Binary::Hypot => x.hypot(y),
            Binary::Max => x.max(y),
            Binary::Min => x.min(y),
        }
    }
}

/// Points at and around every corner of every function.
const CORNERS: [f64; 34] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    -2.0,
    3.0,
    5e-324,
    -5e-324,
    1e-310,
    2.3e-308,
    -1e-200,
    1e-130,
    1e-17,
    -1e-17,
    0.999_999_999_999_999_9,
    -0.999_999_999_999_999_9,
    1.000_000_000_000_000_2,
    19.5,
    20.5,
    -372.5,
    709.7,
    709.9,
    711.0,
    -745.0,
    -746.0,
    800.0,
    1e17,
    -1e200,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// Equal bit by bit; NaN equals NaN.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Equal to `ulps` units in the last place; NaN equals NaN, 0 equals −0.
fn close(a: f64, b: f64, ulps: u64) -> bool {
    let zeros = a.abs().to_bits() == 0 && b.abs().to_bits() == 0;
    let near = a.is_sign_negative() == b.is_sign_negative()
        && a.to_bits().abs_diff(b.to_bits()) <= ulps
        && a.is_finite() == b.is_finite();
    same(a, b) || zeros || near
}

/// splitmix64: a fixed sequence, so that a failure can be repeated.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// Uniform in `lower..upper`.
    fn uniform(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * ((self.bits() >> 11) as f64 / 9_007_199_254_740_992.0)
    }
    /// Either sign, magnitude log-uniform in `2^lower..2^upper`.
    fn magnitude(&mut self, lower: f64, upper: f64) -> f64 {
        let sign = if self.bits() & 1 == 0 { 1.0 } else { -1.0 };
        sign * self.uniform(lower, upper).exp2()
    }
    /// A number from one of the regions where something happens.
    fn point(&mut self) -> f64 {
        match self.bits() % 5 {
            0 => self.magnitude(-1074.0, 1024.0),
            1 => self.uniform(-30.0, 30.0),
            2 => self.uniform(-800.0, 800.0),
            3 => self.magnitude(-40.0, 40.0),
            _ => (1.0 - self.magnitude(-52.0, -1.0)).copysign(self.uniform(-1.0, 1.0)),
        }
    }
}

/// Corner points and `count` random ones.
fn points(count: usize) -> Vec<f64> {
    let mut random = Random(1);
    CORNERS.into_iter().chain((0..count).map(|_| random.point())).collect()
}

/// The value of `f(x)` in each arithmetic that promises the bits of `f64`.
macro_rules! values {
    ($x:expr, $f:expr) => {{
        let (x, tally): (&[f64], Tally) = (&$x, Tally::new());
        [
            ("Jet<1>", $f(&x.iter().map(|&x| Jet::<1>::seed(x, 0)).collect::<Vec<_>>()).value()),
            ("Jet<3>", $f(&x.iter().map(|&x| Jet::<3>::seed(x, 1)).collect::<Vec<_>>()).value()),
            (
                "Jet<2, Jet<1>>",
                $f(&x
                    .iter()
                    .map(|&x| Jet::<2, Jet<1>>::variable(Jet::seed(x, 0), 1))
                    .collect::<Vec<_>>())
                .value(),
            ),
            ("Trace", $f(&x.iter().map(|&x| Trace::seed(x, 0)).collect::<Vec<_>>()).value()),
            (
                "Counted",
                $f(&x.iter().map(|&x| tally.variable(x)).collect::<Vec<Counted<'_>>>()).value(),
            ),
        ]
    }};
}

#[test]
fn values_of_one_variable_are_those_of_f64_bit_by_bit() {
    for f in Unary::ALL {
        for x in points(3000) {
            let plain = f.of(x);
            for (arithmetic, value) in values!([x], |x: &[_]| f.of(x[0])) {
                assert!(same(value, plain), "{arithmetic} {f:?}({x:e}): {value:e}, f64 {plain:e}");
            }
        }
    }
}

/// Pairs of corner points, and random ones.
fn pairs(count: usize) -> Vec<(f64, f64)> {
    let mut random = Random(2);
    let corners = CORNERS.into_iter().flat_map(|x| CORNERS.map(|y| (x, y)));
    corners.chain((0..count).map(|_| (random.point(), random.point()))).collect()
}

#[test]
fn values_of_two_variables_are_those_of_f64_bit_by_bit() {
    macro_rules! check {
        ($($name:literal $f:expr),*) => {$(
            for (x, y) in pairs(1000) {
                let plain: f64 = $f(x, y);
                for (arithmetic, value) in values!([x, y], |x: &[_]| $f(x[0], x[1])) {
                    let name = $name;
                    assert!(same(value, plain), "{arithmetic} {name} {x:e} {y:e}: {value:e}, f64 {plain:e}");
                }
            }
        )*};
    }
    for f in Binary::ALL {
        check! { "binary" |x, y| f.of(x, y) }
    }
    check! {
        "+" |x, y| x + y, "-" |x, y| x - y, "*" |x, y| x * y, "/" |x, y| x / y,
        "neg" |x, _| negated(x), "scale" |x, _| Scalar::scale(x, 0.3),
        "over" |x, _| Scalar::over(x, 0.3),
        "select" |x, y| Scalar::select(x, y, x)
    }
}

fn negated<D: Scalar>(x: D) -> D {
    -x
}
