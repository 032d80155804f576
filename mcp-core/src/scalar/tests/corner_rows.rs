//! What each row of the corner table promises, at points of its region.

use super::{Binary, CORNERS, Unary};
use crate::scalar::{Real, Scalar, logsumexp, smooth_max, smooth_min};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};

const INF: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;

/// A function of any number of variables.
#[derive(Clone, Copy, Debug)]
pub(super) enum Call {
    One(Unary),
    Two(Binary),
    Clamp,
    Select,
    SmoothMax(f64),
    SmoothMin(f64),
    LogSumExp,
    Scale(f64),
    Over(f64),
    /// `0.0 · √x`.
    ZeroTimesRoot,
}

impl Call {
    pub(super) fn of<D: Scalar>(self, x: &[D]) -> D {
        let real = |i: usize| Real::from_scalar(x[i]);
        match self {
            Call::One(f) => f.of(x[0]),
            Call::Two(f) => f.of(x[0], x[1]),
            Call::Clamp => real(0).clamp(real(1), real(2)).into_scalar(),
            Call::Select => D::select(x[0], x[1], x[2]),
            Call::SmoothMax(width) => smooth_max(real(0), real(1), width).into_scalar(),
            Call::SmoothMin(width) => smooth_min(real(0), real(1), width).into_scalar(),
            Call::LogSumExp => logsumexp(0..x.len(), real).into_scalar(),
            Call::Scale(c) => x[0].scale(c),
            Call::Over(c) => x[0].over(c),
            Call::ZeroTimesRoot => x[0].sqrt().scale(0.0),
        }
    }
}

/// What a row promises at one point.
pub(super) struct Check {
    pub(super) call: Call,
    pub(super) at: Vec<f64>,
    pub(super) value: f64,
    pub(super) gradient: Vec<f64>,
}

fn one(f: Unary, x: f64, value: f64, slope: f64) -> Check {
    Check { call: Call::One(f), at: vec![x], value, gradient: vec![slope] }
}

fn two(f: Binary, at: [f64; 2], value: f64, gradient: [f64; 2]) -> Check {
    Check { call: Call::Two(f), at: at.to_vec(), value, gradient: gradient.to_vec() }
}

fn call<const K: usize>(call: Call, at: [f64; K], value: f64, gradient: [f64; K]) -> Check {
    Check { call, at: at.to_vec(), value, gradient: gradient.to_vec() }
}

/// The same at `x` and `-x`, for odd functions.
fn odd(f: Unary, x: f64, value: f64, slope: f64) -> Vec<Check> {
    vec![one(f, x, value, slope), one(f, -x, -value, slope)]
}

/// The checks of each row, under the row's text.
pub(super) fn checks() -> Vec<(&'static str, Vec<Check>)> {
    use Binary::{Atan2, Hypot, Max, Min, Pow};
    use Unary::{
        Abs, Acos, Asin, Atan, Cbrt, Cos, Cosh, Exp, ExpM1, Ln, Ln1p, Log10, Powf, Powi, Recip,
        Sin, Sinh, Sqrt, Tan, Tanh, Xlogx,
    };
    let each = |f: &[Unary], x: f64, value: f64, slope: f64| -> Vec<Check> {
        f.iter().map(|&f| one(f, x, value, slope)).collect()
    };
    vec![
        ("`sqrt` | 0 | 0 | +inf", vec![one(Sqrt, 0.0, 0.0, INF), one(Sqrt, -0.0, -0.0, INF)]),
        ("`sqrt` | x < 0 | NaN | NaN", vec![one(Sqrt, -1e-9, NAN, NAN), one(Sqrt, -INF, NAN, NAN)]),
        ("`sqrt` | +inf | +inf | 0", vec![one(Sqrt, INF, INF, 0.0)]),
        ("`cbrt` | 0 | 0 | +inf", odd(Cbrt, 0.0, 0.0, INF)),
        ("`cbrt` | +-inf | +-inf | 0", odd(Cbrt, INF, INF, 0.0)),
        (
            "`recip` | 0 | +inf | -inf",
            vec![one(Recip, 0.0, INF, -INF), one(Powi(-1), 0.0, INF, -INF)],
        ),
        ("`recip` | -0 | -inf | -inf", vec![one(Recip, -0.0, -INF, -INF)]),
        ("`recip` | +-inf | 0 | 0", odd(Recip, INF, 0.0, 0.0)),
        ("`recip` | abs(x) < 5e-309 | +-inf | -inf", odd(Recip, 4.9e-309, INF, -INF)),
        (
            "`pow(p)`, p > 1 | 0 | 0 | 0",
            each(&[Powf(1.1), Powf(1.5), Powf(2.0), Powf(2.5), Powf(7.0), Powi(2)], 0.0, 0.0, 0.0),
        ),
        (
            "`pow(p)`, p > 1 | +inf | +inf | +inf",
            each(&[Powf(1.1), Powf(2.0), Powi(3)], INF, INF, INF),
        ),
        (
            "`pow(1)` | 0, +-inf or NaN | x | 1",
            [0.0, INF, -INF, NAN]
                .into_iter()
                .flat_map(|x| [one(Powf(1.0), x, x, 1.0), one(Powi(1), x, x, 1.0)])
                .collect(),
        ),
        (
            "`pow(p)`, 0 < p < 1 | 0 | 0 | +inf",
            each(&[Powf(0.5), Powf(0.9), Powf(1e-3)], 0.0, 0.0, INF),
        ),
        ("`pow(p)`, 0 < p < 1 | +inf | +inf | 0", each(&[Powf(0.5), Powf(0.9)], INF, INF, 0.0)),
        (
            "`pow(0)` | any x: 0, +-inf and NaN included | 1 | 0",
            CORNERS
                .into_iter()
                .flat_map(|x| [one(Powf(0.0), x, 1.0, 0.0), one(Powi(0), x, 1.0, 0.0)])
                .collect(),
        ),
        (
            "`pow(p)`, p < 0 | 0 | +inf | -inf",
            each(&[Powf(-0.5), Powf(-1.0), Powf(-2.5), Powi(-2)], 0.0, INF, -INF),
        ),
        (
            "`pow(p)`, p < 0 | +inf | 0 | 0",
            each(&[Powf(-0.5), Powf(-1.0), Powi(-2)], INF, 0.0, 0.0),
        ),
        (
            "`pow(p)`, p not an integer | x < 0 | NaN | NaN",
            vec![one(Powf(1.5), -2.0, NAN, NAN), one(Powf(-0.5), -1e-300, NAN, NAN)],
        ),
        (
            "`pow(p)` | result over- or underflows | +inf or 0 | limit of `p x^(p-1)`",
            vec![
                one(Powf(2.0), 1e200, INF, 2e200),
                one(Powf(2.0), 1e-200, 0.0, 2e-200),
                one(Powf(3.0), 1e160, INF, INF),
                one(Powf(3.0), 1e-170, 0.0, 0.0),
                one(Powf(-2.0), 1e-200, INF, -INF),
                one(Powf(-2.0), 1e200, 0.0, 0.0),
                one(Powf(0.5), 1e-130, 1e-65, 5e64),
            ],
        ),
        (
            "`powi(n)` | as `pow(p)` with integer p, any sign of x | |",
            vec![
                one(Powi(2), 1e200, INF, 2e200),
                one(Powi(2), -1e-200, 0.0, -2e-200),
                one(Powi(3), -INF, -INF, INF),
                one(Powi(-3), -0.0, -INF, -INF),
                one(Powi(-1), 1e-80, 1e80, -1e160),
                one(Powi(-1), 1e100, 1e-100, -1e-200),
                one(Powi(-2), 1e155, 1e-310, -0.0),
                one(Powi(i32::MIN), 1.0, 1.0, f64::from(i32::MIN)),
                one(Powi(i32::MAX), -1.0, -1.0, f64::from(i32::MAX)),
            ],
        ),
        (
            "`pow(y)`, y a `Real` > 0 | 0 | 0 | by x as `pow(p)`; by y: 0",
            vec![
                two(Pow, [0.0, 2.0], 0.0, [0.0, 0.0]),
                two(Pow, [0.0, 1.0], 0.0, [1.0, 0.0]),
                two(Pow, [0.0, 0.5], 0.0, [INF, 0.0]),
            ],
        ),
        (
            "`pow(y)`, y = 0 | 0 | 1 | by x: 0; by y: -inf",
            vec![two(Pow, [0.0, 0.0], 1.0, [0.0, -INF])],
        ),
        (
            "`pow(y)`, y < 0 | 0 | +inf | by x: -inf; by y: -inf",
            vec![
                two(Pow, [0.0, -0.5], INF, [-INF, -INF]),
                two(Pow, [0.0, -2.0], INF, [-INF, -INF]),
            ],
        ),
        (
            "`pow(y)`, y > 0 | +inf | +inf | by x as `pow(p)`; by y: +inf",
            vec![two(Pow, [INF, 2.0], INF, [INF, INF]), two(Pow, [INF, 0.5], INF, [0.0, INF])],
        ),
        (
            "`pow(y)`, y < 0 | +inf | 0 | by x: 0; by y: 0",
            vec![two(Pow, [INF, -2.0], 0.0, [0.0, 0.0])],
        ),
        (
            "`pow(y)`, y = +inf | x > 1 | +inf | by x: +inf; by y: +inf",
            vec![two(Pow, [2.0, INF], INF, [INF, INF])],
        ),
        (
            "`pow(y)`, y = -inf | x > 1 | 0 | by x: NaN; by y: 0",
            vec![two(Pow, [2.0, -INF], 0.0, [NAN, 0.0])],
        ),
        (
            "`pow(y)`, y = NaN | 1 | 1 | by x: NaN; by y: 0",
            vec![two(Pow, [1.0, NAN], 1.0, [NAN, 0.0])],
        ),
        (
            "`pow(y)` | x < 0, y an integer | x^y | by x: y x^(y-1); by y: NaN",
            vec![
                two(Pow, [-2.0, 2.0], 4.0, [-4.0, NAN]),
                two(Pow, [-2.0, -1.0], -0.5, [-0.25, NAN]),
            ],
        ),
        ("`exp` | > 709.8 | +inf | +inf", vec![one(Exp, 709.8, INF, INF), one(Exp, INF, INF, INF)]),
        ("`exp` | < -745.2 | 0 | 0", vec![one(Exp, -745.2, 0.0, 0.0), one(Exp, -INF, 0.0, 0.0)]),
        (
            "`exp_m1` | > 709.8 | +inf | +inf",
            vec![one(ExpM1, 709.8, INF, INF), one(ExpM1, INF, INF, INF)],
        ),
        (
            "`exp_m1` | < -745.2 | -1 | 0",
            vec![one(ExpM1, -745.2, -1.0, 0.0), one(ExpM1, -INF, -1.0, 0.0)],
        ),
        (
            "`ln`, `log10` | 0 | -inf | +inf",
            [each(&[Ln, Log10], 0.0, -INF, INF), each(&[Ln, Log10], -0.0, -INF, INF)].concat_all(),
        ),
        (
            "`ln`, `log10` | x < 0 | NaN | NaN",
            [each(&[Ln, Log10], -1e-300, NAN, NAN), each(&[Ln, Log10], -INF, NAN, NAN)]
                .concat_all(),
        ),
        ("`ln`, `log10` | +inf | +inf | 0", each(&[Ln, Log10], INF, INF, 0.0)),
        (
            "`ln`, `log10` | 0 < x < 2e-309 | finite | +inf",
            vec![
                one(Ln, 1.9e-309, 1.9e-309_f64.ln(), INF),
                one(Log10, 1.9e-309, 1.9e-309_f64.log10(), INF),
            ],
        ),
        ("`ln_1p` | -1 | -inf | +inf", vec![one(Ln1p, -1.0, -INF, INF)]),
        (
            "`ln_1p` | x < -1 | NaN | NaN",
            vec![one(Ln1p, -1.5, NAN, NAN), one(Ln1p, -INF, NAN, NAN)],
        ),
        ("`ln_1p` | +inf | +inf | 0", vec![one(Ln1p, INF, INF, 0.0)]),
        ("`asin` | +-1 | +-pi/2 | +inf", odd(Asin, 1.0, FRAC_PI_2, INF)),
        ("`acos` | +-1 | 0, pi | -inf", vec![one(Acos, 1.0, 0.0, -INF), one(Acos, -1.0, PI, -INF)]),
        (
            "`asin`, `acos` | abs(x) > 1 | NaN | NaN",
            [1.1, -1.1, INF, -INF].map(|x| each(&[Asin, Acos], x, NAN, NAN)).concat_all(),
        ),
        ("`atan` | +-inf | +-pi/2 | 0", odd(Atan, INF, FRAC_PI_2, 0.0)),
        (
            "`sin`, `cos`, `tan` | +-inf | NaN | NaN",
            [INF, -INF].map(|x| each(&[Sin, Cos, Tan], x, NAN, NAN)).concat_all(),
        ),
        (
            "`tanh` | abs(x) > 20 | +-1 | `sech^2 x`, down to 0",
            [
                odd(Tanh, 20.5, 1.0, 4.0 * (-41.0_f64).exp()),
                odd(Tanh, 300.0, 1.0, 4.0 * (-600.0_f64).exp()),
                odd(Tanh, 800.0, 1.0, 0.0),
                odd(Tanh, INF, 1.0, 0.0),
            ]
            .concat_all(),
        ),
        (
            "`sinh` | abs(x) > 711 | +-inf | +inf",
            [711.0, INF].map(|x| odd(Sinh, x, INF, INF)).concat_all(),
        ),
        (
            "`cosh` | abs(x) > 711 | +inf | +-inf",
            [711.0, INF]
                .map(|x| vec![one(Cosh, x, INF, INF), one(Cosh, -x, INF, -INF)])
                .concat_all(),
        ),
        (
            "`atan2(y, x)` | (0, 0) | as `f64` | NaN",
            vec![
                two(Atan2, [0.0, 0.0], 0.0, [NAN, NAN]),
                two(Atan2, [0.0, -0.0], PI, [NAN, NAN]),
                two(Atan2, [-0.0, 0.0], -0.0, [NAN, NAN]),
            ],
        ),
        (
            "`atan2(y, x)` | (0, x) | 0 or pi | by y: 1/x; by x: 0",
            vec![
                two(Atan2, [0.0, 4.0], 0.0, [0.25, 0.0]),
                two(Atan2, [0.0, -4.0], PI, [-0.25, 0.0]),
            ],
        ),
        (
            "`atan2(y, x)` | (y, 0) | +-pi/2 | by y: 0; by x: -1/y",
            vec![
                two(Atan2, [1.0, 0.0], FRAC_PI_2, [0.0, -1.0]),
                two(Atan2, [-4.0, 0.0], -FRAC_PI_2, [0.0, 0.25]),
            ],
        ),
        (
            "`atan2(y, x)` | one of them +-inf | as `f64` | 0",
            vec![
                two(Atan2, [INF, 1.0], FRAC_PI_2, [0.0, 0.0]),
                two(Atan2, [-INF, 1.0], -FRAC_PI_2, [0.0, 0.0]),
                two(Atan2, [1.0, INF], 0.0, [0.0, 0.0]),
                two(Atan2, [1.0, -INF], PI, [0.0, 0.0]),
            ],
        ),
        (
            "`atan2(y, x)` | both +-inf | as `f64` | NaN",
            vec![
                two(Atan2, [INF, INF], FRAC_PI_4, [NAN, NAN]),
                two(Atan2, [INF, -INF], 3.0 * FRAC_PI_4, [NAN, NAN]),
            ],
        ),
        (
            "`atan2(y, x)` | 1/x^2 over- or underflows | as `f64` | by y: 1/x; by x: 0 or -inf",
            vec![
                two(Atan2, [1.0, 1e200], 1e-200, [1e-200, 0.0]),
                two(Atan2, [1e-170, 1e-160], 1e-10, [1e160, -1e150]),
                two(Atan2, [1e-308, 1e-307], 0.1_f64.atan(), [1e307 / 1.01, -1e306 / 1.01]),
                two(Atan2, [1e-310, 1e-310], FRAC_PI_4, [INF, -INF]),
            ],
        ),
        (
            "`hypot(x, y)` | (0, 0) | 0 | 0, an element of the generalised derivative",
            vec![two(Hypot, [0.0, 0.0], 0.0, [0.0, 0.0]), two(Hypot, [-0.0, 0.0], 0.0, [0.0, 0.0])],
        ),
        (
            "`hypot(x, y)` | (x, 0) | abs(x) | by x: +-1; by y: 0",
            vec![
                two(Hypot, [3.0, 0.0], 3.0, [1.0, 0.0]),
                two(Hypot, [-3.0, 0.0], 3.0, [-1.0, 0.0]),
                two(Hypot, [0.0, -1e-300], 1e-300, [0.0, -1.0]),
            ],
        ),
        (
            "`hypot(x, y)` | (+-inf, y) | +inf | by x: +-1; by y: 0",
            vec![
                two(Hypot, [INF, 2.0], INF, [1.0, 0.0]),
                two(Hypot, [-INF, 2.0], INF, [-1.0, 0.0]),
            ],
        ),
        ("`hypot(x, y)` | both +-inf | +inf | NaN", vec![two(Hypot, [INF, -INF], INF, [NAN, NAN])]),
        ("`hypot(x, y)` | (inf, NaN) | +inf | NaN", vec![two(Hypot, [INF, NAN], INF, [NAN, NAN])]),
        (
            "`hypot(x, y)` | result overflows | +inf | x/r, y/r",
            vec![two(Hypot, [1.7e308, 1.7e308], INF, [FRAC_1_SQRT_2, FRAC_1_SQRT_2])],
        ),
        (
            "`hypot(x, y)` | subnormal x and y | as `f64` | x/r, y/r",
            vec![two(
                Hypot,
                [5e-324, 5e-324],
                5e-324_f64.hypot(5e-324),
                [FRAC_1_SQRT_2, FRAC_1_SQRT_2],
            )],
        ),
        ("`abs` | 0 | 0 | 1 (kink)", vec![one(Abs, 0.0, 0.0, 1.0), one(Abs, -0.0, 0.0, 1.0)]),
        ("`abs` | +-inf | +inf | +-1", vec![one(Abs, INF, INF, 1.0), one(Abs, -INF, INF, -1.0)]),
        (
            "`max`, `min` | tie | the common value | of the first argument (kink)",
            vec![
                two(Max, [2.0, 2.0], 2.0, [1.0, 0.0]),
                two(Min, [2.0, 2.0], 2.0, [1.0, 0.0]),
                two(Max, [-0.0, 0.0], -0.0, [1.0, 0.0]),
                two(Min, [INF, INF], INF, [1.0, 0.0]),
            ],
        ),
        (
            "`max`, `min` | an argument +-inf | of the winner | of the winner",
            vec![
                two(Max, [1.0, INF], INF, [0.0, 1.0]),
                two(Max, [-INF, 1.0], 1.0, [0.0, 1.0]),
                two(Min, [1.0, INF], 1.0, [1.0, 0.0]),
                two(Min, [-INF, 1.0], -INF, [1.0, 0.0]),
            ],
        ),
        (
            "`clamp(l, u)` | at a limit | the limit | 1: ties go to x (kink)",
            vec![
                call(Call::Clamp, [0.0, 0.0, 1.0], 0.0, [1.0, 0.0, 0.0]),
                call(Call::Clamp, [1.0, 0.0, 1.0], 1.0, [1.0, 0.0, 0.0]),
                call(Call::Clamp, [2.0, 0.0, 1.0], 1.0, [0.0, 0.0, 1.0]),
                call(Call::Clamp, [-INF, 0.0, INF], 0.0, [0.0, 1.0, 0.0]),
            ],
        ),
        (
            "`clamp(l, u)` | l > u | l | of l",
            [0.0, 1.5, 3.0].map(|x| call(Call::Clamp, [x, 2.0, 1.0], 2.0, [0.0, 1.0, 0.0])).into(),
        ),
        (
            "`select(s, a, b)` | s = 0 | b | of b (kink where a and b differ)",
            vec![
                call(Call::Select, [0.0, 3.0, 4.0], 4.0, [0.0, 0.0, 1.0]),
                call(Call::Select, [5e-324, 3.0, NAN], 3.0, [0.0, 1.0, 0.0]),
            ],
        ),
        (
            "`select(s, a, b)` | s = NaN | NaN | NaN",
            vec![call(Call::Select, [NAN, 3.0, 4.0], NAN, [NAN, NAN, NAN])],
        ),
        (
            "`smooth_max`, `smooth_min`, width 0 | tie | the common value | of the first argument \
             (kink)",
            vec![
                call(Call::SmoothMax(0.0), [3.0, 3.0], 3.0, [1.0, 0.0]),
                call(Call::SmoothMin(0.0), [3.0, 3.0], 3.0, [1.0, 0.0]),
            ],
        ),
        (
            "`smooth_max`, `smooth_min`, width > 0 | tie | above, below by the width | 1/2 of each",
            vec![
                call(Call::SmoothMax(0.25), [3.0, 3.0], 3.25, [0.5, 0.5]),
                call(Call::SmoothMin(0.25), [3.0, 3.0], 2.75, [0.5, 0.5]),
            ],
        ),
        ("`xlogx` | 0 | 0 | -inf", vec![one(Xlogx, 0.0, 0.0, -INF), one(Xlogx, -0.0, 0.0, -INF)]),
        (
            "`xlogx` | x < 0 | NaN | NaN",
            vec![one(Xlogx, -1e-300, NAN, NAN), one(Xlogx, -INF, NAN, NAN)],
        ),
        ("`xlogx` | +inf | +inf | +inf", vec![one(Xlogx, INF, INF, INF)]),
        ("`logsumexp` | no terms | -inf | 0", vec![call(Call::LogSumExp, [], -INF, [])]),
        (
            "`logsumexp` | all terms -inf | -inf | 0",
            vec![call(Call::LogSumExp, [-INF, -INF], -INF, [0.0, 0.0])],
        ),
        (
            "`logsumexp` | one term -inf | of the others | 0 by that term",
            vec![
                call(Call::LogSumExp, [-INF, 3.0], 3.0, [0.0, 1.0]),
                call(Call::LogSumExp, [3.0, -INF], 3.0, [1.0, 0.0]),
            ],
        ),
        (
            "`logsumexp` | one term +inf | +inf | 1 by that term, 0 by the others",
            vec![call(Call::LogSumExp, [1.0, INF, 2.0], INF, [0.0, 1.0, 0.0])],
        ),
        (
            "`x / 0.0`, `x * inf` | x > 0 | +inf | +inf",
            vec![
                call(Call::Over(0.0), [2.0], INF, [INF]),
                call(Call::Scale(INF), [2.0], INF, [INF]),
            ],
        ),
        (
            "`x * 0.0` | finite x | 0 | 0, also of infinite tangents",
            vec![
                call(Call::Scale(0.0), [2.0], 0.0, [0.0]),
                call(Call::ZeroTimesRoot, [0.0], 0.0, [0.0]),
            ],
        ),
        ("any other function | NaN | NaN | NaN", nan_checks()),
    ]
}

/// Every function at NaN; `pow(0)`, `pow(1)`, `1^NaN` and `hypot(inf, NaN)` have their own rows.
fn nan_checks() -> Vec<Check> {
    let own_row = |f| matches!(f, Unary::Powf(0.0 | 1.0) | Unary::Powi(0 | 1));
    let unary = Unary::ALL.into_iter().filter(|&f| !own_row(f)).map(|f| one(f, NAN, NAN, NAN));
    let binary = Binary::ALL
        .into_iter()
        .flat_map(|f| [[NAN, 2.0], [2.0, NAN], [NAN, NAN]].map(|at| two(f, at, NAN, [NAN, NAN])));
    let others = [
        call(Call::Clamp, [NAN, 0.0, 1.0], NAN, [NAN; 3]),
        call(Call::SmoothMax(0.25), [NAN, 0.0], NAN, [NAN; 2]),
        call(Call::SmoothMin(0.25), [0.0, NAN], NAN, [NAN; 2]),
    ];
    unary.chain(binary).chain(others).collect()
}

trait ConcatAll {
    fn concat_all(self) -> Vec<Check>;
}

impl<const K: usize> ConcatAll for [Vec<Check>; K] {
    fn concat_all(self) -> Vec<Check> {
        self.into_iter().flatten().collect()
    }
}
