//! Derivatives against closed forms evaluated with twice the digits.

use super::wide::Wide;
use super::{Binary, Random, Unary, points};
use crate::scalar::{Jet, Scalar};

/// `f', f'', f'''` at `x`; `None` outside the domain or the reach of the reference.
pub(super) fn closed_form(f: Unary, x: f64) -> Option<[Wide; 3]> {
    let w = Wide::from;
    let (one, z) = (w(1.0), w(x));
    let within = |condition: bool| condition.then_some(());
    within(x.is_finite() && x.abs() > 0.0)?;
    Some(match f {
        Unary::Recip => {
            let r = one / z;
            [-(r * r), w(2.0) * r * r * r, -(w(6.0) * r * r * r * r)]
        }
        Unary::Sqrt => return power(x, 0.5.into()),
        Unary::Cbrt => {
            let d = power(x.abs(), one / w(3.0))?;
            if x > 0.0 { d } else { [d[0], -d[1], d[2]] }
        }
        Unary::Exp | Unary::ExpM1 => {
            within(x.abs() < 1e3)?;
            [z.exp(); 3]
        }
        Unary::Ln | Unary::Log10 => {
            within(x > 0.0)?;
            let c = if f == Unary::Ln { one } else { one / w(10.0).ln() };
            let r = one / z;
            [c * r, -(c * r * r), w(2.0) * c * r * r * r]
        }
        Unary::Ln1p => {
            within(x > -1.0)?;
            let r = one / (one + z);
            [r, -(r * r), w(2.0) * r * r * r]
        }
        Unary::Sin | Unary::Cos | Unary::Tan => {
            within(x.abs() < 1e6)?;
            let (s, c) = z.sin_cos();
            let (t, q) = (s / c, one / (c * c));
            match f {
                Unary::Sin => [c, -s, -c],
                Unary::Cos => [-s, -c, s],
                _ => [q, w(2.0) * t * q, q * (w(2.0) * q + w(4.0) * t * t)],
            }
        }
        Unary::Asin | Unary::Acos => {
            within(x.abs() < 1.0)?;
            let r = one / (one - z * z);
            let d = r.sqrt();
            let d = [d, z * d * r, (one + w(2.0) * z * z) * d * r * r];
            if f == Unary::Asin { d } else { d.map(|d| -d) }
        }
        Unary::Atan => {
            let r = one / (one + z * z);
            [r, -(w(2.0) * z * r * r), (w(6.0) * z * z - w(2.0)) * r * r * r]
        }
        Unary::Sinh | Unary::Cosh | Unary::Tanh => {
            within(x.abs() < 1e3)?;
            let (plus, minus) = (z.exp(), (-z).exp());
            let c = (plus + minus) / w(2.0);
            let s = if x.abs() > 1e-5 {
                (plus - minus) / w(2.0)
            } else {
                let zz = z * z;
                z * (one + zz / w(6.0) * (one + zz / w(20.0) * (one + zz / w(42.0))))
            };
            let (t, q) = (s / c, one / (c * c));
            match f {
                Unary::Sinh => [c, s, c],
                Unary::Cosh => [s, c, s],
                _ => [q, -(w(2.0) * t * q), q * (w(4.0) * t * t - w(2.0) * q)],
            }
        }
        Unary::Xlogx => {
            within(x > 0.0)?;
            [z.ln() + one, one / z, -(one / (z * z))]
        }
        Unary::Abs => return None,
        Unary::Powf(p) => return power(x, p.into()),
        Unary::Powi(n) => {
            let d = power(x.abs(), f64::from(n).into())?;
            let odd = [-d[0], d[1], -d[2]];
            if x > 0.0 {
                d
            } else if n % 2 == 0 {
                odd
            } else {
                odd.map(|d| -d)
            }
        }
    })
}

/// Derivatives of `xᵖ`.
fn power(x: f64, p: Wide) -> Option<[Wide; 3]> {
    if x <= 0.0 {
        return None;
    }
    let z = Wide::from(x);
    let logarithm = p * z.ln();
    if logarithm.round().abs() > 1e5 {
        return None;
    }
    let d1 = p * logarithm.exp() / z;
    let d2 = d1 * (p - 1.0.into()) / z;
    Some([d1, d2, d2 * (p - 2.0.into()) / z])
}

/// `|computed − exact|` in units of `eps · scale + smallest`.
fn error(computed: f64, exact: Wide, scale: Wide, smallest: Wide) -> f64 {
    if exact.overflows() {
        return if computed.is_infinite() && (computed > 0.0) == (exact.round() > 0.0) {
            0.0
        } else {
            f64::INFINITY
        };
    }
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    let unit = Wide::from(f64::EPSILON) * scale.abs() + smallest;
    ((Wide::from(computed) - exact).abs() / unit).round()
}

/// The worst error seen, and where.
#[derive(Debug)]
struct Worst {
    error: f64,
    at: String,
    points: usize,
}

impl Worst {
    fn new() -> Self {
        Worst { error: 0.0, at: String::new(), points: 0 }
    }

    fn update(&mut self, error: f64, at: impl FnOnce() -> String) {
        self.points += 1;
        if error > self.error {
            self.error = error;
            self.at = at();
        }
    }

    /// The promise of the module page: 4 units, at no fewer than `points` points.
    #[allow(clippy::print_stdout, reason = "the figures, under --nocapture")]
    fn keeps_the_bound(&self, name: &str, points: usize) {
        println!("{name}: {:.2} units at {}, {} points", self.error, self.at, self.points);
        assert!(self.error <= 4.0, "{name}: {} units at {}", self.error, self.at);
        assert!(self.points >= points, "{name}: only {} points", self.points);
    }
}

/// The subnormal of a power is multiplied by its exponent, and so is its rounding.
fn smallest(f: Unary) -> Wide {
    let factor = match f {
        Unary::Powf(p) => p.abs().max(1.0),
        Unary::Powi(n) => f64::from(n).abs().max(1.0),
        _ => 1.0,
    };
    Wide::smallest() * factor.into()
}

/// `f'` by `Jet<1>` in units of `eps (|f'| + |x f''|)` plus one subnormal.
fn first_derivative(f: Unary, x: f64, worst: &mut Worst) {
    if let Some([d1, d2, _]) = closed_form(f, x) {
        let computed = f.of(Jet::<1>::seed(x, 0)).d[0];
        let scale = d1.abs() + (Wide::from(x) * d2).abs();
        worst.update(error(computed, d1, scale, smallest(f)), || format!("{f:?}({x:e})"));
    }
}

/// Far enough from over- and underflow that intermediate results do neither.
fn ordinary(d: Wide) -> bool {
    (1e-300..1e300).contains(&d.abs().round())
}

/// `f''` by nested jets in units of `eps (|f''| + |x f'''|)`.
fn second_derivative(f: Unary, x: f64, worst: &mut Worst) {
    if let Some([d1, d2, d3]) = closed_form(f, x).filter(|d| d.iter().all(|&d| ordinary(d))) {
        let computed = f.of(Jet::<1, Jet<1>>::variable(Jet::seed(x, 0), 0));
        let by_inner = computed.v.d[0];
        let scale = d1.abs() + (Wide::from(x) * d2).abs();
        worst.update(error(by_inner, d1, scale, smallest(f)), || format!("{f:?}({x:e}), inner"));
        let scale = d2.abs() + (Wide::from(x) * d3).abs();
        worst.update(error(computed.d[0].d[0], d2, scale, smallest(f)), || format!("{f:?}({x:e})"));
    }
}

#[test]
fn first_derivatives_are_exact_to_four_units() {
    let points = points(8000);
    for f in Unary::ALL.into_iter().filter(|&f| f != Unary::Abs) {
        let mut worst = Worst::new();
        for &x in &points {
            first_derivative(f, x, &mut worst);
        }
        worst.keeps_the_bound(&format!("{f:?}"), 2000);
    }
}

#[test]
fn second_derivatives_of_nested_jets_are_exact_to_four_units() {
    let points = points(6000);
    for f in Unary::ALL.into_iter().filter(|&f| f != Unary::Abs) {
        let straight = matches!(f, Unary::Powf(0.0 | 1.0 | 2.0) | Unary::Powi(0..=2));
        if !straight {
            let mut worst = Worst::new();
            for &x in &points {
                second_derivative(f, x, &mut worst);
            }
            worst.keeps_the_bound(&format!("{f:?}''"), 1000);
        }
    }
}

#[test]
fn powers_are_exact_to_four_units_for_every_exponent() {
    let mut random = Random(3);
    let (mut real, mut integer, mut nested) = (Worst::new(), Worst::new(), Worst::new());
    for k in 0..30_000_u32 {
        let center = [0.0, 0.0, 1.0, 1.0, 2.0, -1.0][k as usize % 6];
        let p = match k % 3 {
            0 => random.uniform(-6.0, 6.0),
            1 => center + random.magnitude(-60.0, 0.0),
            _ => random.magnitude(-300.0, 12.0),
        };
        let x = if k % 2 == 0 {
            random.magnitude(-1074.0, 1024.0)
        } else {
            random.magnitude(-9.0, 9.0)
        };
        first_derivative(Unary::Powf(p), x.abs(), &mut real);
        second_derivative(Unary::Powf(p), x.abs(), &mut nested);
        #[allow(clippy::cast_possible_truncation, reason = "an exponent below 4096")]
        let n = random.uniform(-40.0, 40.0) as i32 * if k % 7 == 0 { 100 } else { 1 };
        first_derivative(Unary::Powi(n), x, &mut integer);
        second_derivative(Unary::Powi(n), x, &mut integer);
    }
    real.keeps_the_bound("powf", 10_000);
    nested.keeps_the_bound("powf''", 10_000);
    integer.keeps_the_bound("powi", 20_000);
}

/// Gradient `(f_x, f_y)` and second derivatives `(f_xx, f_xy, f_yy)`.
pub(super) fn closed_form_of_two(f: Binary, x: f64, y: f64) -> Option<([Wide; 2], [Wide; 3])> {
    let w = Wide::from;
    let (a, b) = (w(x), w(y));
    let squares = a * a + b * b;
    match f {
        Binary::Pow => {
            let [d1, d2, _] = power(x, b)?;
            let l = a.ln();
            let v = (b * l).exp();
            Some(([d1, v * l], [d2, v / a * (w(1.0) + b * l), v * l * l]))
        }
        Binary::Atan2 => {
            let (q, mixed) = (squares * squares, a * a - b * b);
            let double = w(2.0) * a * b / q;
            // The first argument is the ordinate: f = atan2(x, y).
            Some(([b / squares, -(a / squares)], [-double, mixed / q, double]))
        }
        Binary::Hypot => {
            let r = squares.sqrt();
            let cube = r * squares;
            Some(([a / r, b / r], [b * b / cube, -(a * b / cube), a * a / cube]))
        }
        Binary::Max | Binary::Min => None,
    }
}

#[test]
fn partial_derivatives_are_exact_to_four_units() {
    for f in [Binary::Pow, Binary::Atan2, Binary::Hypot] {
        let mut random = Random(4);
        let (mut first, mut second) = (Worst::new(), Worst::new());
        for k in 0..20_000 {
            let range = if k % 2 == 0 { 500.0 } else { 4.0 };
            let (x, y) = (random.magnitude(-range, range), random.magnitude(-range, range));
            let (x, y) = match f {
                Binary::Pow if k % 4 == 0 => (x.abs(), y),
                Binary::Pow => (x.abs(), random.uniform(-3.0, 3.0)),
                _ => (x, y),
            };
            let Some((gradient, [xx, xy, yy])) = closed_form_of_two(f, x, y) else { continue };
            let (a, b) = (Wide::from(x), Wide::from(y));
            let at = || format!("({x:e}, {y:e})");
            // The subnormal of `xʸ` is multiplied by `y` or `ln x`.
            let factor = if f == Binary::Pow { y.abs().max(x.ln().abs()).max(1.0) } else { 1.0 };
            let small = Wide::smallest() * factor.into();

            let jet = f.of(Jet::<2>::seed(x, 0), Jet::seed(y, 1));
            let change = |by_x: Wide, by_y: Wide| (a * by_x).abs() + (b * by_y).abs();
            let scales = [gradient[0].abs() + change(xx, xy), gradient[1].abs() + change(xy, yy)];
            for i in 0..2 {
                first.update(error(jet.d[i], gradient[i], scales[i], small), at);
            }
            let nested = f.of(
                Jet::<2, Jet<2>>::variable(Jet::seed(x, 0), 0),
                Jet::variable(Jet::seed(y, 1), 1),
            );
            let parts = [gradient[0], gradient[1], xx, xy, yy];
            if f != Binary::Pow && parts.iter().all(|&d| ordinary(d)) {
                // Homogeneous functions: x f_xxx and its like are of the size of the second
                // derivatives, measured here by the largest of them in the units of x and y.
                let largest = [a * a * xx, a * b * xy, b * b * yy].map(Wide::abs);
                let largest = largest[0] + largest[1] + largest[2];
                for (d, exact, unit) in [
                    (nested.d[0].d[0], xx, largest / (a * a)),
                    (nested.d[0].d[1], xy, largest / (a * b)),
                    (nested.d[1].d[0], xy, largest / (a * b)),
                    (nested.d[1].d[1], yy, largest / (b * b)),
                ] {
                    second.update(error(d, exact, unit, Wide::ZERO), at);
                }
            }
        }
        first.keeps_the_bound(&format!("{f:?}"), 10_000);
        if f != Binary::Pow {
            second.keeps_the_bound(&format!("{f:?}''"), 5_000);
        }
    }
}
