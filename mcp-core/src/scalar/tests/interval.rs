//! [`Interval`]: containment of exact values, of `f64` results and of slopes.

use super::{Binary, Unary};
use crate::scalar::{Interval, Jet, Real, Scalar, logsumexp, select, smooth_max};
use proptest::prelude::*;

/// `f(x) = high + low` to 32 digits, computed with mpmath (60 digits) at random `x`.
#[rustfmt::skip]
const EXACT: [(Unary, f64, f64, f64); 88] = [
    (Unary::Recip, 5.643_825_084_518_347, 0.177_184_796_662_659_43, 1.126_834_201_722_730_6e-17),
    (Unary::Recip, 6.701_904_204_420_491, 0.149_211_324_050_321_8, -9.631_879_248_173_27e-18),
    (Unary::Recip, 7.177_222_733_534_7, 0.139_329_659_553_077_77, 1.353_504_602_765_606_4e-18),
    (Unary::Recip, 8.487_807_525_615_748, 0.117_816_055_204_132_94, 1.755_375_084_560_972_7e-18),
    (Unary::Sqrt, 6.661_688_186_911_977, 2.581_024_638_958_717_3, 1.024_880_369_873_879_6e-16),
    (Unary::Sqrt, 8.301_701_720_022_098, 2.881_267_380_862_473_4, 2.204_584_202_286_746_3e-16),
    (Unary::Sqrt, 0.270_757_002_269_696_5, 0.520_343_158_184_766_1, 3.230_864_014_503_032_7e-17),
    (Unary::Sqrt, 4.195_947_662_859_167, 2.048_401_245_571_571_7, 1.842_588_918_539_663_4e-16),
    (Unary::Cbrt, 7.980_420_905_969_645, 1.998_367_075_973_206_4, -3.023_366_260_047_194_4e-17),
    (Unary::Cbrt, 2.681_541_956_464_635, 1.389_296_256_508_501_4, -3.014_532_143_341_128e-17),
    (Unary::Cbrt, 7.216_208_851_511_208, 1.932_426_708_583_254_7, -8.424_962_098_880_81e-17),
    (Unary::Cbrt, -6.962_292_636_243_402, -1.909_490_158_980_653_2, 7.890_615_761_889_131e-17),
    (Unary::Exp, -1.237_238_088_713_450_4, 0.290_184_576_227_249_25, 1.915_621_071_101_184_4e-17),
    (Unary::Exp, -10.137_086_695_206_786, 3.958_395_513_343_812e-05, -6.836_725_738_266_715e-22),
    (Unary::Exp, 1.750_434_369_437_215_3, 5.757_102_842_490_148_5, 3.895_201_138_232_438_6e-16),
    (Unary::Exp, 2.957_647_517_124_030_4, 19.252_626_964_741_05, 1.361_758_885_201_641_6e-15),
    (Unary::ExpM1, -0.973_771_620_822_195_6, -0.622_344_026_511_464_6, -4.026_601_298_093_602e-17),
    (Unary::ExpM1, -0.566_540_399_072_303_7, -0.432_514_680_720_556_7, -4.448_344_774_709_976e-18),
    (Unary::ExpM1, -0.441_035_267_977_779_37, -0.356_629_984_186_591_7, 1.474_353_824_848_891_6e-17),
    (Unary::ExpM1, 0.832_690_743_617_103_8, 1.299_497_782_407_563, 3.246_122_467_692_774_4e-17),
    (Unary::Ln, 6.893_871_810_145_984, 1.930_632_873_513_031_8, 8.583_687_736_753_9e-17),
    (Unary::Ln, 1.444_841_869_098_763_7, 0.367_999_882_426_506_94, 1.966_600_093_188_673e-17),
    (Unary::Ln, 7.176_351_452_966_529, 1.970_791_099_723_106, 2.186_848_911_332_91e-19),
    (Unary::Ln, 1.257_519_091_406_139_4, 0.229_140_804_909_226_53, 7.282_984_123_227_788e-18),
    (Unary::Ln1p, 0.211_414_536_839_010_01, 0.191_788_715_524_912_36, 1.050_388_522_087_941e-17),
    (Unary::Ln1p, -0.671_941_381_409_514_5, -1.114_562_971_350_760_3, 1.024_662_699_386_109_9e-16),
    (Unary::Ln1p, -0.896_805_248_035_437_7, -2.271_137_280_284_302, -1.945_537_786_826_493e-16),
    (Unary::Ln1p, 0.668_528_540_503_707_7, 0.511_942_124_549_184_3, -1.555_512_954_617_568_5e-17),
    (Unary::Log10, 1.893_012_878_631_109_8, 0.277_153_568_585_772_3, 2.453_543_471_408_362e-17),
    (Unary::Log10, 1.947_175_711_330_343_2, 0.289_405_143_619_661_74, -1.468_241_793_851_471e-17),
    (Unary::Log10, 8.841_965_768_345_068, 0.946_548_829_202_786_5, 3.913_812_266_800_42e-19),
    (Unary::Log10, 7.852_945_811_276_848, 0.895_032_600_642_868_6, -2.982_129_220_556_078e-17),
    (Unary::Sin, -3.792_506_980_555_323_5, 0.605_914_033_552_433_6, 1.158_264_056_923_201_7e-17),
    (Unary::Sin, 8.306_603_801_101_502, 0.899_303_455_707_261_6, -4.200_167_169_041_016e-17),
    (Unary::Sin, 0.706_022_439_674_590_9, 0.648_812_192_545_373_1, 4.690_072_923_691_449e-17),
    (Unary::Sin, 3.200_948_590_510_661, -0.059_321_089_973_498_88, -2.953_271_446_330_673e-18),
    (Unary::Cos, -5.313_968_738_391_729, 0.565_945_598_828_154_5, -2.631_199_482_042_401e-17),
    (Unary::Cos, 7.937_568_019_583_985, -0.083_489_087_663_356_23, 3.835_594_893_584_717e-18),
    (Unary::Cos, 3.431_554_939_924_348_3, -0.958_254_659_137_780_4, -4.766_628_761_712_145_4e-17),
    (Unary::Cos, 8.398_157_621_709_519, -0.517_713_279_206_598_8, -5.320_978_693_960_400_5e-17),
    (Unary::Tan, 1.181_225_032_729_435_6, 2.435_734_006_511_302, -1.489_013_192_607_974_3e-17),
    (Unary::Tan, -0.603_633_306_438_396_7, -0.689_483_973_916_881_7, -3.769_615_836_047_09e-17),
    (Unary::Tan, -0.416_430_195_832_847_57, -0.442_297_623_464_715_96, 1.447_846_010_809_605e-18),
    (Unary::Tan, -1.002_131_828_610_763_2, -1.564_734_681_204_894_3, 8.023_573_092_590_208e-17),
    (Unary::Asin, -0.708_596_180_918_635, -0.787_506_717_259_670_4, -3.482_956_900_840_892_4e-17),
    (Unary::Asin, -0.869_720_573_248_647_5, -1.054_635_874_515_715_8, 9.608_513_960_834_185e-17),
    (Unary::Asin, -0.397_281_798_461_075_03, -0.408_552_957_665_736_35, 1.840_839_290_609_193e-17),
    (Unary::Asin, 0.206_219_994_815_308_73, 0.207_710_337_656_128_5, 6.696_241_486_232_723e-18),
    (Unary::Acos, -0.993_233_761_251_286_5, 3.025_197_783_621_220_7, -1.435_791_410_637_461_3e-16),
    (Unary::Acos, 0.355_868_499_095_382_43, 1.206_953_086_585_992, -3.248_835_855_507_252_4e-17),
    (Unary::Acos, -0.324_206_276_744_269_7, 1.900_968_891_137_368_6, -6.158_738_952_150_251e-17),
    (Unary::Acos, -0.380_084_136_793_742_4, 1.960_683_584_993_64, 9.998_767_287_973_421e-17),
    (Unary::Atan, 5.733_325_343_647_275, 1.398_114_599_291_601_3, -2.288_724_416_592_145e-17),
    (Unary::Atan, -0.346_586_640_659_298_34, -0.333_630_734_315_793_3, -2.222_607_845_193_463e-17),
    (Unary::Atan, -3.315_724_094_764_007_6, -1.277_878_478_410_997, 1.007_112_409_033_050_5e-16),
    (Unary::Atan, -0.338_069_047_736_450_3, -0.326_006_624_963_997_07, 2.095_313_493_282_817e-17),
    (Unary::Sinh, 1.228_014_804_845_456, 1.560_785_526_615_82, 6.410_976_153_019_175e-18),
    (Unary::Sinh, -2.657_994_422_785_260_5, -7.098_778_435_492_602, 3.757_137_962_140_062e-16),
    (Unary::Sinh, 2.850_597_378_865_411_5, 8.620_151_252_568_055, 8.090_839_404_547_208e-16),
    (Unary::Sinh, -2.862_806_620_483_676, -8.726_747_699_732_59, -7.536_119_633_406_67e-16),
    (Unary::Cosh, 1.498_770_133_747_639_1, 2.349_792_664_732_916_6, 8.485_436_401_782_178e-17),
    (Unary::Cosh, 2.069_285_336_328_778, 4.022_718_776_146_953, -2.158_414_077_233_668_4e-16),
    (Unary::Cosh, -2.891_594_787_728_819_5, 9.038_757_827_841_15, 7.455_831_428_576_202e-16),
    (Unary::Cosh, 1.726_429_823_882_605_2, 2.899_235_081_938_354_3, 2.152_100_004_845_547_5e-16),
    (Unary::Tanh, -0.802_893_144_948_837, -0.665_651_092_036_648, 5.419_660_002_572_032e-17),
    (Unary::Tanh, 0.471_112_974_341_247_44, 0.439_098_138_623_568_67, -1.151_514_980_040_681_4e-17),
    (Unary::Tanh, -2.945_529_679_082_829_6, -0.994_487_143_734_756_1, -1.927_173_942_251_516_7e-17),
    (Unary::Tanh, -2.719_637_287_806_351, -0.991_352_289_069_868_6, -3.080_127_976_324_893e-19),
    (Unary::Xlogx, 0.550_949_268_973_633, -0.328_427_770_836_602_96, 1.430_574_742_681_539_2e-17),
    (Unary::Xlogx, 2.865_987_899_777_587, 3.017_636_225_346_801_6, -8.944_599_486_567_377e-17),
    (Unary::Xlogx, 0.597_599_794_833_894_5, -0.307_664_685_889_381_56, -5.455_590_367_321_165e-18),
    (Unary::Xlogx, 2.269_651_873_229_44, 1.860_266_730_109_641_2, -1.577_090_358_792_226_5e-17),
    (Unary::Powf(0.3), 8.367_601_323_181_715, 1.891_386_539_616_163_3, -3.163_802_004_766_767e-17),
    (Unary::Powf(0.3), 8.478_974_026_555_017, 1.898_903_921_926_927_5, -5.377_321_728_153_484e-17),
    (Unary::Powf(0.3), 3.105_992_499_346_577_5, 1.404_947_580_658_127_3, 4.536_817_507_887_019e-17),
    (Unary::Powf(0.3), 3.199_590_913_470_631, 1.417_517_197_225_877_5, -1.087_993_964_792_457_3e-16),
    (Unary::Powf(-0.7), 4.727_069_368_031_149, 0.337_120_853_028_157_25, 3.619_871_132_549_621e-19),
    (Unary::Powf(-0.7), 6.982_671_102_143_968, 0.256_557_603_105_610_77, 2.083_069_676_797_448e-17),
    (Unary::Powf(-0.7), 0.981_395_292_892_847_9, 1.013_232_754_260_186, 8.671_011_187_140_193e-17),
    (Unary::Powf(-0.7), 6.738_098_527_797_121, 0.263_041_244_130_976_1, -2.277_068_408_873_935e-18),
    (Unary::Powi(7), 1.783_360_065_547_997_3, 57.368_469_186_124_976, -1.097_891_176_493_349_4e-15),
    (Unary::Powi(7), 2.158_165_915_125_480_6, 218.068_936_088_425_7, 2.620_906_302_940_902_7e-15),
    (Unary::Powi(7), -2.780_210_520_343_034_7, -1_283.937_184_138_454_8, -1.004_402_742_978_994_2e-13),
    (Unary::Powi(7), 2.674_801_110_253_103, 979.581_249_516_407_3, -5.391_210_426_207_624e-14),
    (Unary::Powi(-3), 0.546_185_633_263_775_2, 6.137_325_862_884_675, -4.281_805_224_215_975e-17),
    (Unary::Powi(-3), 1.219_999_445_861_4, 0.550_707_637_774_273_7, -4.668_039_112_460_193e-19),
    (Unary::Powi(-3), 1.949_234_352_850_085_5, 0.135_023_023_893_567, -9.565_320_193_479_853e-18),
    (Unary::Powi(-3), 2.778_835_400_939_943, 0.046_602_748_531_981_084, 3.583_766_907_631_933e-19),
];

/// Whether it contains `high + low`, `|low|` being less than half a unit of `high`.
fn contains_exactly(x: Interval, high: f64, low: f64) -> bool {
    let above = x.lower() < high || x.lower() == high && low >= 0.0;
    let below = high < x.upper() || high == x.upper() && low <= 0.0;
    above && below
}

#[test]
fn functions_of_a_point_contain_the_exact_value_within_nine_units() {
    for (f, x, high, low) in EXACT {
        let y = f.of(Interval::point(x));
        assert!(contains_exactly(y, high, low), "{f:?} {x}: {y:?}");
        let products = if matches!(f, Unary::Powi(_)) { 4.0 } else { 1.0 };
        let width = y.upper() - y.lower();
        assert!(width <= products * 9.0 * high.abs() * f64::EPSILON, "{f:?} {x}: {y:?}");
    }
}

#[test]
fn ranges_contain_their_extremes() {
    let over = |lower, upper| Interval::new(lower, upper);
    assert_eq!(over(1.0, 2.0).sin().upper(), 1.0);
    assert!(over(1.0, 1.5).sin().upper() < 1.0);
    assert_eq!(over(3.0, 3.2).cos().lower(), -1.0);
    assert_eq!(over(-0.1, 0.1).cos().upper(), 1.0);
    assert_eq!(over(-1e20, 1e20).sin(), over(-1.0, 1.0));
    assert_eq!(over(1.5, 1.6).tan(), Interval::WHOLE);
    assert_eq!(over(-2.0, 1.0).powi(2).lower(), 0.0);
    assert_eq!(over(-2.0, 1.0).abs(), over(0.0, 2.0));
    assert_eq!(over(-2.0, 3.0).cosh().lower(), 1.0);
    assert!(over(0.1, 1.0).xlogx().contains(-(-1_f64).exp()));
    assert!(over(3.0, 4.0).hypot(over(-4.0, 4.0)).contains(3.0));
    assert_eq!(over(-1.0, 2.0).max(over(0.0, 1.0)), over(0.0, 2.0));
    assert_eq!(over(-1.0, 2.0).min(over(0.0, 1.0)), over(-1.0, 1.0));
    let arms = (over(1.0, 2.0), over(5.0, 6.0));
    assert_eq!(Interval::select(over(-1.0, 1.0), arms.0, arms.1), over(1.0, 6.0));
    assert_eq!(Interval::select(over(0.5, 1.0), arms.0, arms.1), arms.0);
    assert_eq!(Interval::select(over(-1.0, 0.0), arms.0, arms.1), arms.1);
}

#[test]
fn poles_are_unbounded_and_outside_the_domain_nothing_is_defined() {
    let around_0 = Interval::new(-1.0, 1.0);
    assert_eq!(around_0.recip(), Interval::WHOLE);
    assert_eq!(Interval::point(1.0) / Interval::point(0.0), Interval::WHOLE);
    assert_eq!(Interval::new(0.0, 1.0).ln().lower(), f64::NEG_INFINITY);
    assert_eq!(Interval::point(710.0).exp().upper(), f64::INFINITY);
    for undefined in [
        around_0.sqrt(),
        around_0.ln(),
        around_0.powf(0.5),
        (around_0 + around_0).asin(),
        around_0.atan2(Interval::point(-1.0)),
        around_0.atan2(around_0),
        Interval::new(0.0, 1.0).pow(around_0),
        Interval::WHOLE.sin(),
        Interval::linearised(1.0, &[1.0], &[around_0]),
        Interval::point(f64::NAN),
    ] {
        assert!(undefined.is_undefined(), "{undefined:?}");
        let hidden = Interval::point(0.0) * undefined.max(around_0).abs().exp() + undefined.powi(0);
        assert!(hidden.is_undefined(), "nothing hides it");
    }
}

#[test]
fn sums_with_zero_and_first_powers_are_exact() {
    let x = Interval::new(0.1, 0.3);
    assert_eq!(x + Interval::point(0.0), x);
    assert_eq!((x.powi(1), x.powf(1.0), x.powi(0)), (x, x, Interval::point(1.0)));
    assert_eq!(x * Interval::point(0.0), Interval::point(0.0));
}

fn jet(x: Interval) -> Jet<1, Interval> {
    Jet::variable(x, 0)
}

#[test]
fn undecided_kinks_have_the_slopes_of_both_sides_and_jumps_none() {
    let x = jet(Interval::new(-1.0, 2.0));
    assert_eq!(x.abs().d[0], Interval::new(-1.0, 1.0));
    assert_eq!(x.max(x.scale(3.0)).d[0], Interval::new(1.0, 3.0).union(x.scale(3.0).d[0]));
    assert!(x.hypot(Jet::constant(0.0)).d[0].contains(-1.0));
    assert!(x.sqrt().v.is_undefined());
    let jump = Jet::select(x, x.shift(1.0), x);
    assert!(!jump.d[0].is_finite() && jump.v.is_finite());
    let elsewhere = Jet::select(Jet::constant(-1.0), x.scale(2.0), x);
    assert_eq!(elsewhere.d[0], Interval::point(1.0));
    // |x| x′ of second order: the slope of the slope jumps.
    let twice = Jet::<1, Jet<1, Interval>>::variable(x, 0).abs();
    assert!(!twice.d[0].is_finite());
}

/// A function with everything that nests.
fn expression<D: Scalar>(x: Real<D>, y: Real<D>) -> Real<D> {
    let kinks = (x - y).abs() + x.max(y * 0.5) + smooth_max(x, y, 0.1);
    let chosen = select(x + 10.0, x.atan2(y + 3.0), y);
    (x * y - 0.3 * x).exp() / (1.0 + y * y)
        + kinks * chosen
        + logsumexp([x, y, x * y], |t| t)
        + (x + 3.0).pow(y + 0.25)
        + (x + 3.0).pow(-1.7)
}

/// An interval and numbers in it.
fn interval() -> impl Strategy<Value = (f64, f64, [f64; 3])> {
    (-3.0..3.0_f64, prop_oneof![0.0..1e-9_f64, 0.0..1.0_f64], [0.0..1.0_f64, 0.0..1.0, 0.0..1.0])
        .prop_map(|(lower, width, t)| {
            let upper = lower + width;
            (lower, upper, t.map(|t| (lower + t * width).clamp(lower, upper)))
        })
}

/// Contained, or missed by no more than the stated error of the `f64` derivative.
fn contains_slope(x: Interval, slope: f64) -> bool {
    !x.is_finite() || Interval::around(slope, 1e-12 * (1.0 + slope.abs())).overlaps(&x)
}

proptest! {
    #[test]
    fn sums_products_quotients_and_roots_contain_the_exact_result(
        a in -1e3..1e3_f64, b in -1e3..1e3_f64,
    ) {
        let (x, y) = (Interval::point(a), Interval::point(b));
        let rounded = a + b;
        let tail = { let t = rounded - a; (a - (rounded - t)) + (b - t) };
        prop_assert!(contains_exactly(x + y, rounded, tail));
        prop_assert!(contains_exactly(x * y, a * b, a.mul_add(b, -(a * b))));
        // a = b q + r exactly: the quotient lies beyond q in the direction of r/b.
        let q = a / b;
        prop_assert!(contains_exactly(x / y, q, -q.mul_add(b, -a) * b.signum()));
        let s = a.abs().sqrt();
        prop_assert!(contains_exactly(x.abs().sqrt(), s, -s.mul_add(s, -a.abs())));
    }

    #[test]
    fn ranges_contain_values_and_slopes_inside((lower, upper, inside) in interval()) {
        for f in Unary::ALL {
            let y = f.of(jet(Interval::new(lower, upper)));
            let outside = f.of(lower).is_nan() || f.of(upper).is_nan();
            prop_assert!(!y.v.is_undefined() || outside, "{f:?}");
            for x in inside {
                let point = f.of(Jet::<1>::seed(x, 0));
                if !y.v.is_undefined() {
                    prop_assert!(y.v.contains(point.v), "{f:?} {x}: {y:?} {point:?}");
                    prop_assert!(contains_slope(y.d[0], point.d[0]), "{f:?} {x}: {y:?} {point:?}");
                }
            }
        }
    }

    #[test]
    fn boxes_contain_values_and_slopes_inside(
        (lower, upper, xs) in interval(), (below, above, ys) in interval(),
    ) {
        type Lanes = Jet<2, Interval>;
        for f in Binary::ALL {
            let x = Lanes::variable(Interval::new(lower, upper), 0);
            let z = f.of(x, Lanes::variable(Interval::new(below, above), 1));
            if z.v.is_undefined() {
                continue;
            }
            for (x, y) in xs.into_iter().zip(ys) {
                let point = f.of(Jet::<2>::seed(x, 0), Jet::<2>::seed(y, 1));
                prop_assert!(z.v.contains(point.v), "{f:?} {x} {y}: {z:?} {point:?}");
                for k in 0..2 {
                    prop_assert!(contains_slope(z.d[k], point.d[k]), "{f:?} {x} {y}: {z:?}");
                }
            }
        }
    }

    /// Values, first and second derivatives of a composition.
    #[test]
    fn compositions_contain_what_their_parts_contain(
        (lower, upper, xs) in interval(), (below, above, ys) in interval(),
    ) {
        type Inner = Jet<2, Interval>;
        let (a, b) = (Interval::new(lower, upper), Interval::new(below, above));
        // The base 3 + x of the powers stays positive, and so does 3 + y of the angle.
        prop_assume!(lower > -2.9 && below > -2.9);
        let outer = |v, k| Real::from_scalar(Jet::<2, Inner>::variable(Inner::variable(v, k), k));
        let z = expression(outer(a, 0), outer(b, 1)).into_scalar();
        prop_assert!(!z.v.v.is_undefined());
        for (x, y) in xs.into_iter().zip(ys) {
            let point = |v, k| {
                Real::from_scalar(Jet::<2, Jet<2>>::variable(Jet::<2>::seed(v, k), k))
            };
            let exact = expression(point(x, 0), point(y, 1)).into_scalar();
            prop_assert!(contains_slope(z.v.v, exact.v.v), "{z:?} {exact:?}");
            for k in 0..2 {
                prop_assert!(contains_slope(z.d[k].v, exact.d[k].v), "{z:?} {exact:?}");
                for l in 0..2 {
                    let (set, one) = (z.d[k].d[l], exact.d[k].d[l]);
                    prop_assert!(contains_slope(set, one), "{set:?} {one:?}");
                }
            }
        }
    }
}
