//! Problems of four variables and more, most of them under nonlinear equations.

use super::{FREE, HockSchittkowski, INF, problems};
use crate::error::ModelError;
use crate::kkt::Constraint;
use crate::scalar::{Real, Scalar};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// `x` of problem 40.
fn hs40_x() -> [f64; 4] {
    let two = |exponent: f64| exponent.exp2();
    [two(-1.0 / 3.0), two(-0.5), two(-11.0 / 12.0), two(-0.25)]
}

/// Start and solution of problem 56: four angles after three lengths.
fn hs56(lengths: [f64; 3], angles: [f64; 4]) -> [f64; 7] {
    let ([x1, x2, x3], [x4, x5, x6, x7]) = (lengths, angles);
    [x1, x2, x3, x4, x5, x6, x7]
}

/// `arcsin √(a/b)`.
fn angle(a: f64, b: f64) -> f64 {
    (a / b).sqrt().asin()
}

problems! {
    39 [x1, x2, x3, x4] min -x1,
    [equal x2 - x1.powi(3) - x3.powi(2), equal x1.powi(2) - x2 - x4.powi(2)],
    in ([FREE; 4], [INF; 4]), start [2.0; 4], x [1.0, 1.0, 0.0, 0.0], f -1.0;

    40 [x1, x2, x3, x4] min -x1 * x2 * x3 * x4,
    [equal x1.powi(3) + x2.powi(2) - 1, equal x1.powi(2) * x4 - x3, equal x4.powi(2) - x2],
    in ([FREE; 4], [INF; 4]), start [0.8; 4], x hs40_x(), f -0.25;

    41 [x1, x2, x3, x4] min 2 - x1 * x2 * x3, [equal x1 + 2 * x2 + 2 * x3 - x4],
    in ([0.0; 4], [1.0, 1.0, 1.0, 2.0]), start [2.0; 4],
    x [2.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 2.0], f 52.0 / 27.0;

    42 [x1, x2, x3, x4]
    min (x1 - 1).powi(2) + (x2 - 2).powi(2) + (x3 - 3).powi(2) + (x4 - 4).powi(2),
    [equal x1 - 2, equal x3.powi(2) + x4.powi(2) - 2],
    in ([FREE; 4], [INF; 4]), start [1.0; 4],
    x [2.0, 2.0, 0.6 * SQRT_2, 0.8 * SQRT_2], f 28.0 - 10.0 * SQRT_2;

    46 [x1, x2, x3, x4, x5]
    min (x1 - x2).powi(2) + (x3 - 1).powi(2) + (x4 - 1).powi(4) + (x5 - 1).powi(6),
    [equal x1.powi(2) * x4 + (x4 - x5).sin() - 1, equal x2 + x3.powi(4) * x4.powi(2) - 2],
    in ([FREE; 5], [INF; 5]), start [SQRT_2 / 2.0, 1.75, 0.5, 2.0, 2.0], x [1.0; 5], f 0.0;

    47 [x1, x2, x3, x4, x5]
    min (x1 - x2).powi(2) + (x2 - x3).powi(3) + (x3 - x4).powi(4) + (x4 - x5).powi(4),
    [
        equal x1 + x2.powi(2) + x3.powi(3) - 3,
        equal x2 - x3.powi(2) + x4 - 1,
        equal x1 * x5 - 1,
    ],
    in ([FREE; 5], [INF; 5]), start [2.0, SQRT_2, -1.0, 2.0 - SQRT_2, 0.5], x [1.0; 5], f 0.0;

    49 [x1, x2, x3, x4, x5]
    min (x1 - x2).powi(2) + (x3 - 1).powi(2) + (x4 - 1).powi(4) + (x5 - 1).powi(6),
    [equal x1 + x2 + x3 + 4 * x4 - 7, equal x3 + 5 * x5 - 6],
    in ([FREE; 5], [INF; 5]), start [10.0, 7.0, 2.0, -3.0, 0.8], x [1.0; 5], f 0.0;

    50 [x1, x2, x3, x4, x5]
    min (x1 - x2).powi(2) + (x2 - x3).powi(2) + (x3 - x4).powi(4) + (x4 - x5).powi(2),
    [
        equal x1 + 2 * x2 + 3 * x3 - 6,
        equal x2 + 2 * x3 + 3 * x4 - 6,
        equal x3 + 2 * x4 + 3 * x5 - 6,
    ],
    in ([FREE; 5], [INF; 5]), start [35.0, -31.0, 11.0, 5.0, -5.0], x [1.0; 5], f 0.0;

    /// The six equations have rank five: the multipliers are not unique.
    55 [x1, x2, x3, x4, x5, x6] min x1 + 2 * x2 + 4 * x5 + (x1 * x4).exp(),
    [
        equal x1 + 2 * x2 + 5 * x5 - 6,
        equal x1 + x2 + x3 - 3,
        equal x4 + x5 + x6 - 2,
        equal x1 + x4 - 1,
        equal x2 + x5 - 2,
        equal x3 + x6 - 2,
    ],
    in ([0.0; 6], [1.0, INF, INF, 1.0, INF, INF]), start [1.0, 2.0, 0.0, 0.0, 0.0, 2.0],
    x [0.0, 4.0 / 3.0, 5.0 / 3.0, 1.0, 2.0 / 3.0, 1.0 / 3.0], f 19.0 / 3.0;

    56 [x1, x2, x3, x4, x5, x6, x7] min -x1 * x2 * x3,
    [
        equal x1 - 4.2 * x4.sin().powi(2),
        equal x2 - 4.2 * x5.sin().powi(2),
        equal x3 - 4.2 * x6.sin().powi(2),
        equal x1 + 2 * x2 + 2 * x3 - 7.2 * x7.sin().powi(2),
    ],
    in ([FREE; 7], [INF; 7]),
    start hs56([1.0; 3], [angle(1.0, 4.2), angle(1.0, 4.2), angle(1.0, 4.2), angle(5.0, 7.2)]),
    x hs56([2.4, 1.2, 1.2], [angle(4.0, 7.0), angle(2.0, 7.0), angle(2.0, 7.0), FRAC_PI_2]), f -3.456;

    77 [x1, x2, x3, x4, x5]
    min (x1 - 1).powi(2) + (x1 - x2).powi(2) + (x3 - 1).powi(2) + (x4 - 1).powi(4) + (x5 - 1).powi(6),
    [
        equal x1.powi(2) * x4 + (x4 - x5).sin() - 2.0 * SQRT_2,
        equal x2 + x3.powi(4) * x4.powi(2) - 8 - SQRT_2,
    ],
    in ([FREE; 5], [INF; 5]), start [2.0; 5],
    x [1.166_172, 1.182_111, 1.380_257, 1.506_036, 0.610_920_3], f 0.241_505_13;

    78 [x1, x2, x3, x4, x5] min x1 * x2 * x3 * x4 * x5,
    [
        equal x1.powi(2) + x2.powi(2) + x3.powi(2) + x4.powi(2) + x5.powi(2) - 10,
        equal x2 * x3 - 5 * x4 * x5,
        equal x1.powi(3) + x2.powi(3) + 1,
    ],
    in ([FREE; 5], [INF; 5]), start [-2.0, 1.5, 2.0, -1.0, -1.0],
    x [-1.717_142, 1.595_708, 1.827_248, -0.763_642_9, -0.763_643_5], f -2.919_700_41;

    79 [x1, x2, x3, x4, x5]
    min (x1 - 1).powi(2) + (x1 - x2).powi(2) + (x2 - x3).powi(2) + (x3 - x4).powi(4)
        + (x4 - x5).powi(4),
    [
        equal x1 + x2.powi(2) + x3.powi(3) - 2 - 3.0 * SQRT_2,
        equal x2 - x3.powi(2) + x4 + 2 - 2.0 * SQRT_2,
        equal x1 * x5 - 2,
    ],
    in ([FREE; 5], [INF; 5]), start [2.0; 5],
    x [1.191_127, 1.362_603, 1.472_818, 1.635_017, 1.679_081], f 0.078_776_820_9;

    /// Powell.
    80 [x1, x2, x3, x4, x5] min (x1 * x2 * x3 * x4 * x5).exp(),
    [
        equal x1.powi(2) + x2.powi(2) + x3.powi(2) + x4.powi(2) + x5.powi(2) - 10,
        equal x2 * x3 - 5 * x4 * x5,
        equal x1.powi(3) + x2.powi(3) + 1,
    ],
    in ([-2.3, -2.3, -3.2, -3.2, -3.2], [2.3, 2.3, 3.2, 3.2, 3.2]),
    start [-2.0, 2.0, 2.0, -1.0, -1.0],
    x [-1.717_143, 1.595_709, 1.827_247, -0.763_641_3, -0.763_645_0], f 0.053_949_847_8;
}
