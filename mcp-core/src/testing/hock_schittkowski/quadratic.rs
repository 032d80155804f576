//! Problems with a quadratic objective and linear constraints, of four variables and more.

use super::{FREE, HockSchittkowski, INF, problems};
use crate::error::ModelError;
use crate::kkt::Constraint;
use crate::scalar::{Real, Scalar};

problems! {
    44 [x1, x2, x3, x4] min x1 - x2 - x3 - x1 * x3 + x1 * x4 + x2 * x3 - x2 * x4,
    [
        at_least 8 - x1 - 2 * x2,
        at_least 12 - 4 * x1 - x2,
        at_least 12 - 3 * x1 - 4 * x2,
        at_least 8 - 2 * x3 - x4,
        at_least 8 - x3 - 2 * x4,
        at_least 5 - x3 - x4,
    ],
    in ([0.0; 4], [INF; 4]), start [0.0; 4], x [0.0, 3.0, 0.0, 4.0], f -15.0;

    48 [x1, x2, x3, x4, x5] min (x1 - 1).powi(2) + (x2 - x3).powi(2) + (x4 - x5).powi(2),
    [equal x1 + x2 + x3 + x4 + x5 - 5, equal x3 - 2 * (x4 + x5) + 3],
    in ([FREE; 5], [INF; 5]), start [3.0, 5.0, -3.0, 2.0, -2.0], x [1.0; 5], f 0.0;

    51 [x1, x2, x3, x4, x5]
    min (x1 - x2).powi(2) + (x2 + x3 - 2).powi(2) + (x4 - 1).powi(2) + (x5 - 1).powi(2),
    [equal x1 + 3 * x2 - 4, equal x3 + x4 - 2 * x5, equal x2 - x5],
    in ([FREE; 5], [INF; 5]), start [2.5, 0.5, 2.0, -1.0, 0.5], x [1.0; 5], f 0.0;

    52 [x1, x2, x3, x4, x5]
    min (4 * x1 - x2).powi(2) + (x2 + x3 - 2).powi(2) + (x4 - 1).powi(2) + (x5 - 1).powi(2),
    [equal x1 + 3 * x2, equal x3 + x4 - 2 * x5, equal x2 - x5],
    in ([FREE; 5], [INF; 5]), start [2.0; 5],
    x [-33.0, 11.0, 180.0, -158.0, 11.0].map(|x| x / 349.0), f 1859.0 / 349.0;

    53 [x1, x2, x3, x4, x5]
    min (x1 - x2).powi(2) + (x2 + x3 - 2).powi(2) + (x4 - 1).powi(2) + (x5 - 1).powi(2),
    [equal x1 + 3 * x2, equal x3 + x4 - 2 * x5, equal x2 - x5],
    in ([-10.0; 5], [10.0; 5]), start [2.0; 5],
    x [-33.0, 11.0, 27.0, -5.0, 11.0].map(|x| x / 43.0), f 176.0 / 43.0;

    76 [x1, x2, x3, x4]
    min x1.powi(2) + 0.5 * x2.powi(2) + x3.powi(2) + 0.5 * x4.powi(2) - x1 * x3 + x3 * x4
        - x1 - 3 * x2 + x3 - x4,
    [
        at_least 5 - x1 - 2 * x2 - x3 - x4,
        at_least 4 - 3 * x1 - x2 - 2 * x3 + x4,
        at_least x2 + 4 * x3 - 1.5,
    ],
    in ([0.0; 4], [INF; 4]), start [0.5; 4],
    x [0.272_727_3, 2.090_909, 0.0, 0.545_454_5], f -4.681_818_181;
}
