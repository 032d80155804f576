//! Problems of three variables: 26–37 and 60–66.

use super::{FREE, HockSchittkowski, INF, problems};
use crate::error::ModelError;
use crate::kkt::Constraint;
use crate::scalar::{Real, Scalar};
use std::f64::consts::SQRT_2;

problems! {
    26 [x1, x2, x3] min (x1 - x2).powi(2) + (x2 - x3).powi(4),
    [equal (1 + x2.powi(2)) * x1 + x3.powi(4) - 3],
    in ([FREE; 3], [INF; 3]), start [-2.6, 2.0, 2.0], x [1.0; 3], f 0.0;

    27 [x1, x2, x3] min 0.01 * (x1 - 1).powi(2) + (x2 - x1.powi(2)).powi(2),
    [equal x1 + x3.powi(2) + 1],
    in ([FREE; 3], [INF; 3]), start [2.0; 3], x [-1.0, 1.0, 0.0], f 0.04;

    28 [x1, x2, x3] min (x1 + x2).powi(2) + (x2 + x3).powi(2), [equal x1 + 2 * x2 + 3 * x3 - 1],
    in ([FREE; 3], [INF; 3]), start [-4.0, 1.0, 1.0], x [0.5, -0.5, 0.5], f 0.0;

    29 [x1, x2, x3] min -x1 * x2 * x3,
    [at_least 48 - x1.powi(2) - 2 * x2.powi(2) - 4 * x3.powi(2)],
    in ([FREE; 3], [INF; 3]), start [1.0; 3], x [4.0, 2.0 * SQRT_2, 2.0], f -16.0 * SQRT_2;

    30 [x1, x2, x3] min x1.powi(2) + x2.powi(2) + x3.powi(2),
    [at_least x1.powi(2) + x2.powi(2) - 1],
    in ([1.0, -10.0, -10.0], [10.0; 3]), start [1.0; 3], x [1.0, 0.0, 0.0], f 1.0;

    31 [x1, x2, x3] min 9 * x1.powi(2) + x2.powi(2) + 9 * x3.powi(2), [at_least x1 * x2 - 1],
    in ([-10.0, 1.0, -10.0], [10.0, 10.0, 1.0]), start [1.0; 3],
    x [1.0 / 3.0_f64.sqrt(), 3.0_f64.sqrt(), 0.0], f 6.0;

    32 [x1, x2, x3] min (x1 + 3 * x2 + x3).powi(2) + 4 * (x1 - x2).powi(2),
    [at_least 6 * x2 + 4 * x3 - x1.powi(3) - 3, equal 1 - x1 - x2 - x3],
    in ([0.0; 3], [INF; 3]), start [0.1, 0.7, 0.2], x [0.0, 0.0, 1.0], f 1.0;

    33 [x1, x2, x3] min (x1 - 1) * (x1 - 2) * (x1 - 3) + x3,
    [
        at_least x3.powi(2) - x2.powi(2) - x1.powi(2),
        at_least x1.powi(2) + x2.powi(2) + x3.powi(2) - 4,
    ],
    in ([0.0; 3], [INF, INF, 5.0]), start [0.0, 0.0, 3.0], x [0.0, SQRT_2, SQRT_2], f SQRT_2 - 6.0;

    34 [x1, x2, x3] min -x1, [at_least x2 - x1.exp(), at_least x3 - x2.exp()],
    in ([0.0; 3], [100.0, 100.0, 10.0]), start [0.0, 1.05, 2.9],
    x [10.0_f64.ln().ln(), 10.0_f64.ln(), 10.0], f -10.0_f64.ln().ln();

    /// Beale.
    35 [x1, x2, x3] min 9 - 8 * x1 - 6 * x2 - 4 * x3 + 2 * x1.powi(2) + 2 * x2.powi(2) + x3.powi(2)
        + 2 * x1 * x2 + 2 * x1 * x3,
    [at_least 3 - x1 - x2 - 2 * x3],
    in ([0.0; 3], [INF; 3]), start [0.5; 3], x [4.0 / 3.0, 7.0 / 9.0, 4.0 / 9.0], f 1.0 / 9.0;

    36 [x1, x2, x3] min -x1 * x2 * x3, [at_least 72 - x1 - 2 * x2 - 2 * x3],
    in ([0.0; 3], [20.0, 11.0, 42.0]), start [10.0; 3], x [20.0, 11.0, 15.0], f -3300.0;

    37 [x1, x2, x3] min -x1 * x2 * x3,
    [at_least 72 - x1 - 2 * x2 - 2 * x3, at_least x1 + 2 * x2 + 2 * x3],
    in ([0.0; 3], [42.0; 3]), start [10.0; 3], x [24.0, 12.0, 12.0], f -3456.0;

    60 [x1, x2, x3] min (x1 - 1).powi(2) + (x1 - x2).powi(2) + (x2 - x3).powi(4),
    [equal x1 * (1 + x2.powi(2)) + x3.powi(4) - 4 - 3.0 * SQRT_2],
    in ([-10.0; 3], [10.0; 3]), start [2.0; 3],
    x [1.104_859_024, 1.196_674_194, 1.535_262_257], f 0.032_568_200_25;

    61 [x1, x2, x3] min 4 * x1.powi(2) + 2 * x2.powi(2) + 2 * x3.powi(2) - 33 * x1 + 16 * x2 - 24 * x3,
    [equal 3 * x1 - 2 * x2.powi(2) - 7, equal 4 * x1 - x3.powi(2) - 11],
    in ([FREE; 3], [INF; 3]), start [0.0; 3],
    x [5.326_770_157, -2.118_998_639, 3.210_464_239], f -143.646_142_2;

    62 [x1, x2, x3] min -32.174 * (
        255 * ((x1 + x2 + x3 + 0.03) / (0.09 * x1 + x2 + x3 + 0.03)).ln()
            + 280 * ((x2 + x3 + 0.03) / (0.07 * x2 + x3 + 0.03)).ln()
            + 290 * ((x3 + 0.03) / (0.13 * x3 + 0.03)).ln()
    ),
    [equal x1 + x2 + x3 - 1],
    in ([0.0; 3], [1.0; 3]), start [0.7, 0.2, 0.1],
    x [0.617_812_690_8, 0.328_202_223_0, 0.053_985_086_06], f -26_272.514_48;

    63 [x1, x2, x3] min 1000 - x1.powi(2) - 2 * x2.powi(2) - x3.powi(2) - x1 * x2 - x1 * x3,
    [equal 8 * x1 + 14 * x2 + 7 * x3 - 56, equal x1.powi(2) + x2.powi(2) + x3.powi(2) - 25],
    in ([0.0; 3], [INF; 3]), start [2.0; 3],
    x [3.512_118_414, 0.216_988_174_1, 3.552_174_034], f 961.715_172_1;

    64 [x1, x2, x3] min 5 * x1 + 50_000 / x1 + 20 * x2 + 72_000 / x2 + 10 * x3 + 144_000 / x3,
    [at_least 1 - 4 / x1 - 32 / x2 - 120 / x3],
    in ([1e-5; 3], [300.0; 3]), start [1.0; 3],
    x [108.734_717_5, 85.126_139_42, 204.324_707_8], f 6_299.842_428;

    65 [x1, x2, x3] min (x1 - x2).powi(2) + (x1 + x2 - 10).powi(2) / 9 + (x3 - 5).powi(2),
    [at_least 48 - x1.powi(2) - x2.powi(2) - x3.powi(2)],
    in ([-4.5, -4.5, -5.0], [4.5, 4.5, 5.0]), start [-5.0, 5.0, 0.0],
    x [3.650_461_821, 3.650_461_820, 4.620_417_050_7], f 0.953_528_856_7;

    66 [x1, x2, x3] min 0.2 * x3 - 0.8 * x1, [at_least x2 - x1.exp(), at_least x3 - x2.exp()],
    in ([0.0; 3], [100.0, 100.0, 10.0]), start [0.0, 1.05, 2.9],
    x [0.184_126_487_9, 1.202_167_873, 3.327_322_322], f 0.518_163_274_1;
}
