//! Problems of four variables and more under bounds and nonlinear inequalities.

use super::{FREE, HockSchittkowski, INF, problems};
use crate::error::ModelError;
use crate::kkt::Constraint;
use crate::scalar::{Real, Scalar, prod, sum};

/// `0.4 (x1/x7)^0.67 + 0.4 (x2/x8)^0.67 + 10 − x1 − x2`, of problem 104.
fn reactor<D: Scalar>([x1, x2, x7, x8]: [Real<D>; 4]) -> Real<D> {
    0.4 * x1.pow(0.67) * x7.pow(-0.67) + 0.4 * x2.pow(0.67) * x8.pow(-0.67) + 10 - x1 - x2
}

/// `1 − 4 p/r − 2 p^(−0.71)/r − 0.0588 p^(−1.3) s`, of problem 104.
fn stage<D: Scalar>([p, r, s]: [Real<D>; 3]) -> Real<D> {
    1 - 4 * p / r - 2 * p.pow(-0.71) / r - 0.0588 * p.pow(-1.3) * s
}

/// `x4 (x1 + x2 + x3) x1` and `x2 x3 (x1 + 1.57 x2 + x4)`, of problem 93.
fn transformer<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 2] {
    [x1 * x4 * (x1 + x2 + x3), x2 * x3 * (x1 + 1.57 * x2 + x4)]
}

/// `1000 sin(x)`.
fn power<D: Scalar>(x: Real<D>) -> Real<D> {
    1000 * x.sin()
}

/// Cost of problems 74 and 75.
fn generation<D: Scalar>(x1: Real<D>, x2: Real<D>) -> Real<D> {
    3 * x1 + 1e-6 * x1.powi(3) + 2 * x2 + 2e-6 / 3.0 * x2.powi(3)
}

/// The three expressions of Colville's problem 3.
fn colville3<D: Scalar>([x1, x2, x3, x4, x5]: [Real<D>; 5]) -> [Real<D>; 3] {
    [
        85.334_407 + 0.005_685_8 * x2 * x5 + 0.000_626_2 * x1 * x4 - 0.002_205_3 * x3 * x5,
        80.512_49 + 0.007_131_7 * x2 * x5 + 0.002_995_5 * x1 * x2 + 0.002_181_3 * x3.powi(2) - 90,
        9.300_961 + 0.004_702_6 * x3 * x5 + 0.001_254_7 * x1 * x3 + 0.001_908_5 * x3 * x4 - 20,
    ]
}

problems! {
    /// Colville's problem 4, Wood's function.
    38 [x1, x2, x3, x4]
    min 100 * (x2 - x1.powi(2)).powi(2) + (1 - x1).powi(2) + 90 * (x4 - x3.powi(2)).powi(2)
        + (1 - x3).powi(2) + 10.1 * ((x2 - 1).powi(2) + (x4 - 1).powi(2)) + 19.8 * (x2 - 1) * (x4 - 1),
    [],
    in ([-10.0; 4], [10.0; 4]), start [-3.0, -1.0, -3.0, -1.0], x [1.0; 4], f 0.0;

    /// Rosen and Suzuki.
    43 [x1, x2, x3, x4]
    min x1.powi(2) + x2.powi(2) + 2 * x3.powi(2) + x4.powi(2) - 5 * x1 - 5 * x2 - 21 * x3 + 7 * x4,
    [
        at_least 8 - x1.powi(2) - x2.powi(2) - x3.powi(2) - x4.powi(2) - x1 + x2 - x3 + x4,
        at_least 10 - x1.powi(2) - 2 * x2.powi(2) - x3.powi(2) - 2 * x4.powi(2) + x1 + x4,
        at_least 5 - 2 * x1.powi(2) - x2.powi(2) - x3.powi(2) - 2 * x1 + x2 + x4,
    ],
    in ([FREE; 4], [INF; 4]), start [0.0; 4], x [0.0, 1.0, 2.0, -1.0], f -44.0;

    45 [x1, x2, x3, x4, x5] min 2 - x1 * x2 * x3 * x4 * x5 / 120, [],
    in ([0.0; 5], [1.0, 2.0, 3.0, 4.0, 5.0]), start [2.0; 5], x [1.0, 2.0, 3.0, 4.0, 5.0], f 1.0;

    71 [x1, x2, x3, x4] min x1 * x4 * (x1 + x2 + x3) + x3,
    [at_least x1 * x2 * x3 * x4 - 25, equal x1.powi(2) + x2.powi(2) + x3.powi(2) + x4.powi(2) - 40],
    in ([1.0; 4], [5.0; 4]), start [1.0, 5.0, 5.0, 1.0],
    x [1.0, 4.742_999_4, 3.821_150_3, 1.379_408_2], f 17.014_017_3;

    72 [x1, x2, x3, x4] min 1 + x1 + x2 + x3 + x4,
    [
        at_least 0.0401 - 4 / x1 - 2.25 / x2 - 1 / x3 - 0.25 / x4,
        at_least 0.010_085 - 0.16 / x1 - 0.36 / x2 - 0.64 / x3 - 0.64 / x4,
    ],
    in ([0.001; 4], [4e5, 3e5, 2e5, 1e5]), start [1.0; 4],
    x [193.4071, 179.5475, 185.0186, 168.7062], f 727.679_37;

    /// Cattle feed.
    73 [x1, x2, x3, x4] min 24.55 * x1 + 26.75 * x2 + 39 * x3 + 40.50 * x4,
    [
        at_least 2.3 * x1 + 5.6 * x2 + 11.1 * x3 + 1.3 * x4 - 5,
        at_least 12 * x1 + 11.9 * x2 + 41.8 * x3 + 52.1 * x4 - 21
            - 1.645 * (0.28 * x1.powi(2) + 0.19 * x2.powi(2) + 20.5 * x3.powi(2) + 0.62 * x4.powi(2)).sqrt(),
        equal x1 + x2 + x3 + x4 - 1,
    ],
    in ([0.0; 4], [INF; 4]), start [1.0; 4],
    x [0.635_521_6, 0.0, 0.312_701_9, 0.051_776_55], f 29.894_378;

    74 [x1, x2, x3, x4] min generation(x1, x2),
    [
        at_least x4 - x3 + 0.55,
        at_least x3 - x4 + 0.55,
        equal power(-x3 - 0.25) + power(-x4 - 0.25) + 894.8 - x1,
        equal power(x3 - 0.25) + power(x3 - x4 - 0.25) + 894.8 - x2,
        equal power(x4 - 0.25) + power(x4 - x3 - 0.25) + 1294.8,
    ],
    in ([0.0, 0.0, -0.55, -0.55], [1200.0, 1200.0, 0.55, 0.55]), start [0.0; 4],
    x [679.9453, 1026.067, 0.118_876_4, -0.396_233_6], f 5_126.498_1;

    75 [x1, x2, x3, x4] min generation(x1, x2),
    [
        at_least x4 - x3 + 0.48,
        at_least x3 - x4 + 0.48,
        equal power(-x3 - 0.25) + power(-x4 - 0.25) + 894.8 - x1,
        equal power(x3 - 0.25) + power(x3 - x4 - 0.25) + 894.8 - x2,
        equal power(x4 - 0.25) + power(x4 - x3 - 0.25) + 1294.8,
    ],
    in ([0.0, 0.0, -0.48, -0.48], [1200.0, 1200.0, 0.48, 0.48]), start [0.0; 4],
    x [776.1592, 925.1949, 0.051_108_79, -0.428_891_1], f 5_174.412_9;

    /// Colville's problem 3.
    83 [x1, x2, x3, x4, x5]
    min 5.357_854_7 * x3.powi(2) + 0.835_689_1 * x1 * x5 + 37.293_239 * x1 - 40_792.141,
    [
        at_least colville3([x1, x2, x3, x4, x5])[0],
        at_least 92 - colville3([x1, x2, x3, x4, x5])[0],
        at_least colville3([x1, x2, x3, x4, x5])[1],
        at_least 20 - colville3([x1, x2, x3, x4, x5])[1],
        at_least colville3([x1, x2, x3, x4, x5])[2],
        at_least 5 - colville3([x1, x2, x3, x4, x5])[2],
    ],
    in ([78.0, 33.0, 27.0, 27.0, 27.0], [102.0, 45.0, 45.0, 45.0, 45.0]),
    start [78.0, 33.0, 27.0, 27.0, 27.0],
    x [78.0, 33.0, 29.995_26, 45.0, 36.775_81], f -30_665.538_67;

    /// Design of a transformer.
    93 [x1, x2, x3, x4, x5, x6]
    min 0.0204 * transformer([x1, x2, x3, x4])[0] + 0.0187 * transformer([x1, x2, x3, x4])[1]
        + 0.0607 * transformer([x1, x2, x3, x4])[0] * x5.powi(2)
        + 0.0437 * transformer([x1, x2, x3, x4])[1] * x6.powi(2),
    [
        at_least 0.001 * x1 * x2 * x3 * x4 * x5 * x6 - 2.07,
        at_least 1 - 0.000_62 * transformer([x1, x2, x3, x4])[0] * x5.powi(2)
            - 0.000_58 * transformer([x1, x2, x3, x4])[1] * x6.powi(2),
    ],
    in ([0.0; 6], [INF; 6]), start [5.54, 4.4, 12.02, 11.82, 0.702, 0.852],
    x [5.332_666, 4.656_744, 10.432_99, 12.082_30, 0.752_607_4, 0.878_650_84], f 135.075_961;

    /// Wong 1.
    100 [x1, x2, x3, x4, x5, x6, x7]
    min (x1 - 10).powi(2) + 5 * (x2 - 12).powi(2) + x3.powi(4) + 3 * (x4 - 11).powi(2) + 10 * x5.powi(6)
        + 7 * x6.powi(2) + x7.powi(4) - 4 * x6 * x7 - 10 * x6 - 8 * x7,
    [
        at_least 127 - 2 * x1.powi(2) - 3 * x2.powi(4) - x3 - 4 * x4.powi(2) - 5 * x5,
        at_least 282 - 7 * x1 - 3 * x2 - 10 * x3.powi(2) - x4 + x5,
        at_least 196 - 23 * x1 - x2.powi(2) - 6 * x6.powi(2) + 8 * x7,
        at_least -4 * x1.powi(2) - x2.powi(2) + 3 * x1 * x2 - 2 * x3.powi(2) - 5 * x6 + 11 * x7,
    ],
    in ([FREE; 7], [INF; 7]), start [1.0, 2.0, 0.0, 4.0, 0.0, 1.0, 1.0],
    x [2.330_499, 1.951_372, -0.477_541_4, 4.365_726, -0.624_487_0, 1.038_131, 1.594_227],
    f 680.630_057_3;

    /// Design of a reactor.
    104 [x1, x2, x3, x4, x5, x6, x7, x8] min reactor([x1, x2, x7, x8]),
    [
        at_least 1 - 0.0588 * x5 * x7 - 0.1 * x1,
        at_least 1 - 0.0588 * x6 * x8 - 0.1 * x1 - 0.1 * x2,
        at_least stage([x3, x5, x7]),
        at_least stage([x4, x6, x8]),
        at_least reactor([x1, x2, x7, x8]) - 1,
        at_least 4.2 - reactor([x1, x2, x7, x8]),
    ],
    in ([0.1; 8], [10.0; 8]), start [6.0, 3.0, 0.4, 0.2, 6.0, 6.0, 1.0, 0.5],
    x [6.465_114, 2.232_709, 0.667_397_5, 0.595_756_4, 5.932_676, 5.527_235, 1.013_322, 0.400_668_2],
    f 3.951_163_439_6;

    110 [x1, x2, x3, x4, x5, x6, x7, x8, x9, x10]
    min sum([x1, x2, x3, x4, x5, x6, x7, x8, x9, x10], |x| (x - 2).ln().powi(2) + (10 - x).ln().powi(2))
        - prod([x1, x2, x3, x4, x5, x6, x7, x8, x9, x10], |x| x).pow(0.2),
    [],
    in ([2.001; 10], [9.999; 10]), start [9.0; 10], x [9.350_256_55; 10], f -45.778_469_71;

    /// Wong 2.
    113 [x1, x2, x3, x4, x5, x6, x7, x8, x9, x10]
    min x1.powi(2) + x2.powi(2) + x1 * x2 - 14 * x1 - 16 * x2 + (x3 - 10).powi(2) + 4 * (x4 - 5).powi(2)
        + (x5 - 3).powi(2) + 2 * (x6 - 1).powi(2) + 5 * x7.powi(2) + 7 * (x8 - 11).powi(2)
        + 2 * (x9 - 10).powi(2) + (x10 - 7).powi(2) + 45,
    [
        at_least 105 - 4 * x1 - 5 * x2 + 3 * x7 - 9 * x8,
        at_least -10 * x1 + 8 * x2 + 17 * x7 - 2 * x8,
        at_least 8 * x1 - 2 * x2 - 5 * x9 + 2 * x10 + 12,
        at_least -3 * (x1 - 2).powi(2) - 4 * (x2 - 3).powi(2) - 2 * x3.powi(2) + 7 * x4 + 120,
        at_least -5 * x1.powi(2) - 8 * x2 - (x3 - 6).powi(2) + 2 * x4 + 40,
        at_least -0.5 * (x1 - 8).powi(2) - 2 * (x2 - 4).powi(2) - 3 * x5.powi(2) + x6 + 30,
        at_least -x1.powi(2) - 2 * (x2 - 2).powi(2) + 2 * x1 * x2 - 14 * x5 + 6 * x6,
        at_least 3 * x1 - 6 * x2 - 12 * (x9 - 8).powi(2) + 7 * x10,
    ],
    in ([FREE; 10], [INF; 10]), start [2.0, 3.0, 5.0, 5.0, 1.0, 2.0, 7.0, 3.0, 6.0, 10.0],
    x [2.171_996, 2.363_683, 8.773_926, 5.095_984, 0.990_654_8, 1.430_574, 1.321_644, 9.828_726,
        8.280_092, 8.375_927],
    f 24.306_209_1;
}
