//! Problems 1–24 of two variables.

use super::{FREE, HockSchittkowski, INF, problems};
use crate::error::ModelError;
use crate::kkt::Constraint;
use crate::scalar::{Real, Scalar};
use std::f64::consts::PI;

/// Rosenbrock's valley, of problems 1, 2, 15, 16, 17 and 20.
fn valley<D: Scalar>(x1: Real<D>, x2: Real<D>) -> Real<D> {
    100 * (x2 - x1.powi(2)).powi(2) + (1 - x1).powi(2)
}

/// `x1` of problem 2: the root of `400 x1³ − 598 x1 − 2` that is largest.
fn hs2_x1() -> f64 {
    let a = (598.0_f64 / 1200.0).sqrt();
    2.0 * a * ((1.0 / (400.0 * a.powi(3))).acos() / 3.0).cos()
}

/// `x1` of problem 11: the root of `2 x1³ + x1 − 5`.
fn hs11_x1() -> f64 {
    let a = (7.5 * 6.0_f64.sqrt() + 338.5_f64.sqrt()).cbrt();
    (a - 1.0 / a) / 6.0_f64.sqrt()
}

/// `x1` of problem 8: `x1²` is a root of `t² − 25 t + 81`.
fn hs8_x1() -> f64 {
    (12.5 + 75.25_f64.sqrt()).sqrt()
}

problems! {
    1 [x1, x2] min valley(x1, x2), [],
    in ([FREE, -1.5], [INF, INF]), start [-2.0, 1.0], x [1.0, 1.0], f 0.0;

    2 [x1, x2] min valley(x1, x2), [],
    in ([FREE, 1.5], [INF, INF]), start [-2.0, 1.0], x [hs2_x1(), 1.5], f 0.050_426_187_9;

    3 [x1, x2] min x2 + 1e-5 * (x2 - x1).powi(2), [],
    in ([FREE, 0.0], [INF, INF]), start [10.0, 1.0], x [0.0, 0.0], f 0.0;

    4 [x1, x2] min (x1 + 1).powi(3) / 3 + x2, [],
    in ([1.0, 0.0], [INF, INF]), start [1.125, 0.125], x [1.0, 0.0], f 8.0 / 3.0;

    5 [x1, x2] min (x1 + x2).sin() + (x1 - x2).powi(2) - 1.5 * x1 + 2.5 * x2 + 1, [],
    in ([-1.5, -3.0], [4.0, 3.0]), start [0.0, 0.0],
    x [0.5 - PI / 3.0, -0.5 - PI / 3.0], f -3.0_f64.sqrt() / 2.0 - PI / 3.0;

    6 [x1, x2] min (1 - x1).powi(2), [equal 10 * (x2 - x1.powi(2))],
    in ([FREE; 2], [INF; 2]), start [-1.2, 1.0], x [1.0, 1.0], f 0.0;

    7 [x1, x2] min (1 + x1.powi(2)).ln() - x2,
    [equal (1 + x1.powi(2)).powi(2) + x2.powi(2) - 4],
    in ([FREE; 2], [INF; 2]), start [2.0, 2.0], x [0.0, 3.0_f64.sqrt()], f -3.0_f64.sqrt();

    8 [x1, x2] min -1.0, [equal x1.powi(2) + x2.powi(2) - 25, equal x1 * x2 - 9],
    in ([FREE; 2], [INF; 2]), start [2.0, 1.0], x [hs8_x1(), 9.0 / hs8_x1()], f -1.0;

    /// Of the solutions `(12 k − 3, 16 k − 4)` that with `k = 0`.
    9 [x1, x2] min (PI / 12.0 * x1).sin() * (PI / 16.0 * x2).cos(), [equal 4 * x1 - 3 * x2],
    in ([FREE; 2], [INF; 2]), start [0.0, 0.0], x [-3.0, -4.0], f -0.5;

    10 [x1, x2] min x1 - x2, [at_least -3 * x1.powi(2) + 2 * x1 * x2 - x2.powi(2) + 1],
    in ([FREE; 2], [INF; 2]), start [-10.0, 10.0], x [0.0, 1.0], f -1.0;

    11 [x1, x2] min (x1 - 5).powi(2) + x2.powi(2) - 25, [at_least x2 - x1.powi(2)],
    in ([FREE; 2], [INF; 2]), start [4.9, 0.1],
    x [hs11_x1(), hs11_x1().powi(2)], f -8.498_464_223;

    12 [x1, x2] min 0.5 * x1.powi(2) + x2.powi(2) - x1 * x2 - 7 * x1 - 7 * x2,
    [at_least 25 - 4 * x1.powi(2) - x2.powi(2)],
    in ([FREE; 2], [INF; 2]), start [0.0, 0.0], x [2.0, 3.0], f -30.0;

    14 [x1, x2] min (x1 - 2).powi(2) + (x2 - 1).powi(2),
    [at_least 1 - 0.25 * x1.powi(2) - x2.powi(2), equal x1 - 2 * x2 + 1],
    in ([FREE; 2], [INF; 2]), start [2.0, 2.0],
    x [(7.0_f64.sqrt() - 1.0) / 2.0, (7.0_f64.sqrt() + 1.0) / 4.0], f 9.0 - 2.875 * 7.0_f64.sqrt();

    15 [x1, x2] min valley(x1, x2), [at_least x1 * x2 - 1, at_least x1 + x2.powi(2)],
    in ([FREE; 2], [0.5, INF]), start [-2.0, 1.0], x [0.5, 2.0], f 306.5;

    16 [x1, x2] min valley(x1, x2), [at_least x1 + x2.powi(2), at_least x1.powi(2) + x2],
    in ([-0.5, FREE], [0.5, 1.0]), start [-2.0, 1.0], x [0.5, 0.25], f 0.25;

    17 [x1, x2] min valley(x1, x2), [at_least x2.powi(2) - x1, at_least x1.powi(2) - x2],
    in ([-0.5, FREE], [0.5, 1.0]), start [-2.0, 1.0], x [0.0, 0.0], f 1.0;

    18 [x1, x2] min 0.01 * x1.powi(2) + x2.powi(2),
    [at_least x1 * x2 - 25, at_least x1.powi(2) + x2.powi(2) - 25],
    in ([2.0, 0.0], [50.0, 50.0]), start [2.0, 2.0], x [250.0_f64.sqrt(), 2.5_f64.sqrt()], f 5.0;

    19 [x1, x2] min (x1 - 10).powi(3) + (x2 - 20).powi(3),
    [
        at_least (x1 - 5).powi(2) + (x2 - 5).powi(2) - 100,
        at_least 82.81 - (x2 - 5).powi(2) - (x1 - 6).powi(2),
    ],
    in ([13.0, 0.0], [100.0, 100.0]), start [20.1, 5.84], x [14.095, 0.842_960_79], f -6_961.813_81;

    20 [x1, x2] min valley(x1, x2),
    [at_least x1 + x2.powi(2), at_least x1.powi(2) + x2, at_least x1.powi(2) + x2.powi(2) - 1],
    in ([-0.5, FREE], [0.5, INF]), start [-2.0, 1.0],
    x [0.5, 3.0_f64.sqrt() / 2.0], f 81.5 - 25.0 * 3.0_f64.sqrt();

    21 [x1, x2] min 0.01 * x1.powi(2) + x2.powi(2) - 100, [at_least 10 * x1 - x2 - 10],
    in ([2.0, -50.0], [50.0, 50.0]), start [-1.0, -1.0], x [2.0, 0.0], f -99.96;

    22 [x1, x2] min (x1 - 2).powi(2) + (x2 - 1).powi(2),
    [at_least 2 - x1 - x2, at_least x2 - x1.powi(2)],
    in ([FREE; 2], [INF; 2]), start [2.0, 2.0], x [1.0, 1.0], f 1.0;

    23 [x1, x2] min x1.powi(2) + x2.powi(2),
    [
        at_least x1 + x2 - 1,
        at_least x1.powi(2) + x2.powi(2) - 1,
        at_least 9 * x1.powi(2) + x2.powi(2) - 9,
        at_least x1.powi(2) - x2,
        at_least x2.powi(2) - x1,
    ],
    in ([-50.0; 2], [50.0; 2]), start [3.0, 1.0], x [1.0, 1.0], f 2.0;

    24 [x1, x2] min ((x1 - 3).powi(2) - 9) * x2.powi(3) / (27.0 * 3.0_f64.sqrt()),
    [
        at_least x1 / 3.0_f64.sqrt() - x2,
        at_least x1 + 3.0_f64.sqrt() * x2,
        at_least 6 - x1 - 3.0_f64.sqrt() * x2,
    ],
    in ([0.0; 2], [INF; 2]), start [1.0, 0.5], x [3.0, 3.0_f64.sqrt()], f -1.0;
}
