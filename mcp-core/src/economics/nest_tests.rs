use super::*;
use crate::scalar::Interval;
use crate::scalar::Jet;
use proptest::prelude::*;

type Dual = Jet<3>;

/// Cost and its derivatives by the three prices.
fn cost(sigma: f64, weights: [f64; 3], prices: [f64; 3]) -> (f64, [f64; 3]) {
    let inputs: [(f64, Real<Dual>); 3] =
        std::array::from_fn(|k| (weights[k], Real::from_scalar(Dual::seed(prices[k], k))));
    let jet = ces(sigma, inputs, |input| input).into_scalar();
    (jet.v, jet.d)
}

/// `ln c` by the series in `h = ρ x_i` around the logarithmic mean, to the third order:
/// `ln c = m + ρ v/2 + ρ² s/6 + …` with the variance `v` and the third moment `s` of `ln p`.
fn near_one(rho: f64, shares: [f64; 3], prices: [f64; 3]) -> f64 {
    let logs = prices.map(f64::ln);
    let mean: f64 = (0..3).map(|k| shares[k] * logs[k]).sum();
    let moment = |n: i32| -> f64 { (0..3).map(|k| shares[k] * (logs[k] - mean).powi(n)).sum() };
    (mean + rho * moment(2) / 2.0 + rho * rho * moment(3) / 6.0).exp()
}

const SHARES: [f64; 3] = [0.5, 0.3, 0.2];
const PRICES: [f64; 3] = [1.2, 0.7, 2.5];

fn near(a: f64, b: f64, units: f64) -> bool {
    (a - b).abs() <= units * f64::EPSILON * a.abs().max(b.abs())
}

#[test]
fn leontief_and_cobb_douglas_are_the_mean_and_the_product() {
    let (c, d) = cost(0.0, SHARES, PRICES);
    assert!(near(c, 0.5 * 1.2 + 0.3 * 0.7 + 0.2 * 2.5, 2.0));
    assert!((0..3).all(|k| near(d[k], SHARES[k], 4.0)), "{d:?}");
    let (c, d) = cost(1.0, SHARES, PRICES);
    let product: f64 = (0..3).map(|k| PRICES[k].powf(SHARES[k])).product();
    assert!(near(c, product, 4.0));
    assert!((0..3).all(|k| near(d[k], SHARES[k] * product / PRICES[k], 8.0)), "{d:?}");
}

#[test]
fn elasticity_two_is_the_harmonic_mean() {
    let (c, _) = cost(2.0, SHARES, PRICES);
    let harmonic = 1.0 / (0.5 / 1.2 + 0.3 / 0.7 + 0.2 / 2.5);
    assert!(near(c, harmonic, 4.0));
}

#[test]
fn no_digit_is_lost_near_elasticity_one() {
    for exponent in 4..=300 {
        for sign in [1.0, -1.0] {
            let rho = sign * 10_f64.powi(-exponent);
            let sigma = 1.0 - rho;
            let (c, _) = cost(sigma, SHARES, PRICES);
            // The next term of the series is below ρ³.
            let expected = near_one(1.0 - sigma, SHARES, PRICES);
            let slack = 1e3 * rho.abs().powi(3) / f64::EPSILON;
            assert!(near(c, expected, 8.0 + slack), "{rho:e}: {c} {expected}");
        }
    }
}

#[test]
fn cost_is_continuous_where_the_formula_changes() {
    for edge in [0.75_f64, 1.25] {
        let (below, above) = (cost(edge.next_down(), SHARES, PRICES), cost(edge, SHARES, PRICES));
        assert!(near(below.0, above.0, 16.0));
        assert!((0..3).all(|k| near(below.1[k], above.1[k], 64.0)));
    }
}

#[test]
fn the_benchmark_costs_exactly_one() {
    for sigma in [0.0, 0.3, 0.9, 1.0, 1.0 + 1e-12, 1.1, 2.0, 30.0] {
        assert_eq!(cost(sigma, [10.0, 30.0, 20.0], [1.0; 3]).0, 1.0, "{sigma}");
    }
}

#[test]
fn a_price_of_zero_gives_the_limit() {
    let free = |sigma| cost(sigma, SHARES, [0.0, 1.0, 1.0]);
    let (c, d) = free(0.0);
    assert!(near(c, 0.5, 2.0) && near(d[0], 0.5, 2.0));
    let (c, d) = free(0.5);
    assert!(near(c, 0.25, 4.0) && d[0] == f64::INFINITY && d[1].is_finite(), "{c} {d:?}");
    let (c, d) = free(0.9);
    assert!(near(c, 0.5_f64.powi(10), 16.0) && d[0] == f64::INFINITY && d[1].is_finite());
    let (c, d) = free(1.0);
    assert_eq!((c, d[0]), (0.0, f64::INFINITY));
    let (c, d) = free(2.0);
    assert_eq!((c, d), (0.0, [2.0, 0.0, 0.0]));
    let (c, d) = cost(1.5, SHARES, [0.0; 3]);
    assert_eq!(c, 0.0);
    assert!((0..3).all(|k| near(d[k], SHARES[k], 2.0)), "{d:?}");
}

#[test]
fn inputs_of_weight_zero_are_left_out() {
    for sigma in [0.0, 0.5, 1.0, 1.0 + 1e-9, 3.0] {
        let (c, d) = cost(sigma, [1.0, 0.0, 1.0], [2.0, 0.0, 2.0]);
        assert!(near(c, 2.0, 4.0) && d[1] == 0.0, "{sigma}: {c} {d:?}");
        assert_eq!(cost(sigma, [0.0; 3], PRICES), (1.0, [0.0; 3]));
    }
}

#[test]
fn what_is_no_nest_is_nan() {
    assert!(cost(-0.5, SHARES, PRICES).0.is_nan());
    assert!(cost(f64::INFINITY, SHARES, PRICES).0.is_nan());
    assert!(cost(f64::NAN, SHARES, PRICES).0.is_nan());
    assert!(cost(0.5, SHARES, [-1.0, 1.0, 1.0]).0.is_nan());
    assert!(cost(0.5, SHARES, [f64::NAN, 1.0, 1.0]).0.is_nan());
    assert!(cost(0.9, SHARES, [-1.0, 1.0, 1.0]).0.is_nan());
    assert!(cost(1.0, SHARES, [-1.0, 1.0, 1.0]).0.is_nan());
    for sigma in [0.5, 0.9, 1.0, 2.0] {
        assert!(cost(sigma, SHARES, [-1.0, -2.0, -3.0]).0.is_nan(), "{sigma}");
        assert!(cost(sigma, SHARES, [0.0, -1.0, 0.0]).0.is_nan(), "{sigma}");
        assert!(cost(sigma, SHARES, [0.0, f64::NAN, 0.0]).0.is_nan(), "{sigma}");
        assert!(cost(sigma, [-1.0, 2.0, 3.0], PRICES).0.is_nan(), "{sigma}");
        assert!(cost(sigma, [1e308, 1e308, 1.0], PRICES).0.is_nan(), "{sigma}");
    }
}

#[test]
fn prices_of_a_mean_have_any_sign() {
    let (c, d) = cost(0.0, SHARES, [0.0, -1.0, -1.0]);
    assert!(near(c, -0.5, 2.0) && (0..3).all(|k| near(d[k], SHARES[k], 4.0)), "{c} {d:?}");
    let (c, _) = cost(0.0, SHARES, [-4.0, 1.0, 1.0]);
    assert!(near(c, -1.5, 2.0));
}

#[test]
fn what_is_free_costs_nothing_even_where_its_slope_overflows() {
    let (c, d) = cost(1.0 + 1e-12, SHARES, [0.0, 1.0, 1.0]);
    assert!(c == 0.0 && d[0] > 1e300, "{c} {d:?}");
}

#[test]
fn an_input_that_is_not_used_is_not_demanded_at_any_price() {
    let [index, price]: [Real<Dual>; 2] =
        [(1.0, 0), (0.0, 1)].map(|(v, k)| Real::from_scalar(Dual::seed(v, k)));
    let demand = crate::economics::calibrated_demand(0.5, (0.0, 1.0), index, price).into_scalar();
    assert_eq!((demand.v, demand.d), (0.0, [0.0; 3]));
}

#[test]
fn two_inputs_are_a_nest_of_two() {
    let [a, b] = [2.0, 3.0].map(Real::<f64>::from);
    let two = ces2(0.4, 0.25, a, b).into_scalar();
    assert_eq!(two, ces(0.4, [(1.0, a), (3.0, b)], |input| input).into_scalar());
    let product = cobb([(1.0, a), (3.0, b)], |input| input).into_scalar();
    assert!(near(product, 2_f64.powf(0.25) * 3_f64.powf(0.75), 4.0));
}

proptest! {
    #[test]
    fn cost_is_homogeneous_and_its_slopes_are_demands(
        sigma in prop_oneof![0.0..3.0, 0.99..1.01, Just(0.0), Just(1.0), 3.0..40.0],
        weights in prop::array::uniform3(0.01..10.0),
        exponents in prop::array::uniform3(-3.0..3.0),
    ) {
        let prices = exponents.map(|x: f64| 10_f64.powf(x));
        let (c, d) = cost(sigma, weights, prices);
        let total: f64 = weights.iter().sum();
        // Euler, Shephard, between the smallest and the largest price.
        let euler: f64 = (0..3).map(|k| d[k] * prices[k]).sum();
        prop_assert!(near(euler, c, 200.0), "{} {}", euler, c);
        for k in 0..3 {
            let demand = weights[k] / total * (c / prices[k]).powf(sigma);
            // ln (c/p) is at most 14, and σ multiplies its error.
            prop_assert!(near(d[k], demand, 100.0 * (1.0 + sigma) * 14.0), "{} {}", d[k], demand);
        }
        let (low, high) = (prices.iter().copied().fold(f64::INFINITY, f64::min), prices.iter().copied().fold(0.0, f64::max));
        prop_assert!(low * (1.0 - 1e-13) <= c && c <= high * (1.0 + 1e-13));
        let (scaled, _) = cost(sigma, weights, prices.map(|p| 8.0 * p));
        prop_assert_eq!(scaled, 8.0 * c);
    }

    #[test]
    fn a_larger_elasticity_costs_no_more(
        sigma in 0.0..3.0,
        more in 1e-6..1.0,
        exponents in prop::array::uniform3(-1.0..1.0),
    ) {
        let prices = exponents.map(|x: f64| 10_f64.powf(x));
        let (before, after) = (cost(sigma, SHARES, prices).0, cost(sigma + more, SHARES, prices).0);
        prop_assert!(after <= before * (1.0 + 1e-14));
    }
}

/// Over sets the formula as it stands is evaluated, outwards: near `σ = 1` wide, never wrong.
#[test]
fn costs_over_intervals_contain_the_costs_inside() {
    let cost = |sigma: f64, p: Real<Jet<1, Interval>>| {
        ces(sigma, [(1.0, p), (3.0, 2.0 * p), (0.0, p), (2.0, Real::from(0.7))], |x| x)
            .into_scalar()
    };
    for sigma in [0.0, 0.3, 0.5, 0.999, 1.0, 1.2, 2.0, 7.5] {
        let prices = Jet::variable(Interval::new(0.9, 1.1), 0);
        let c = cost(sigma, Real::from_scalar(prices));
        for p in [0.9, 0.95, 1.0, 1.1] {
            let x = Real::from_scalar(Jet::<1>::seed(p, 0));
            let inputs = [(1.0, x), (3.0, 2.0 * x), (0.0, x), (2.0, Real::from(0.7))];
            let exact = ces(sigma, inputs, |input| input).into_scalar();
            assert!(c.v.contains(exact.v) && c.v.is_finite(), "{sigma} {p}: {c:?} {exact:?}");
            assert!(c.d[0].contains(exact.d[0]), "{sigma} {p}: {c:?} {exact:?}");
        }
    }
}
