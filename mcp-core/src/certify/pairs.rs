//! Which side every complementary pair is on, and how clearly.

use crate::model::Shape;
use crate::solver::Certifier;

/// The side of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Side {
    /// `F_i = 0`, off the bounds.
    Off,
    /// `z_i = l_i`, `F_i > 0`.
    AtLower,
    /// `z_i = u_i`, `F_i < 0`.
    AtUpper,
    /// `l_i = u_i`: any `F_i`.
    Fixed,
}

/// The sides of all pairs at a point, as the relative natural residual
/// `mid((z − l)/w, F/s, (z − u)/w)` chooses them.
pub(super) struct Pairs {
    pub(super) side: Vec<Side>,
    /// The larger of the distance to the bound and of the right-signed `F`, both relative; infinite for
    /// free and fixed variables.
    margin: Vec<f64>,
    /// The pairs off their bounds.
    pub(super) off: Vec<usize>,
    /// The largest relative distance of a variable to the bound where it belongs.
    pub(super) gap: f64,
}

impl Pairs {
    pub(super) fn at(z: &[f64], shape: &Shape, certifier: &Certifier) -> Self {
        let (lower, upper) = (shape.bounds().lower(), shape.bounds().upper());
        let mut pairs = Pairs { side: vec![], margin: vec![], off: vec![], gap: 0.0 };
        for i in 0..z.len() {
            let (w, s, f) = (certifier.weight()[i], certifier.row_size()[i], certifier.f()[i]);
            let f = if f == 0.0 { 0.0 } else { f / s.min(f64::MAX) };
            let (above, below) = ((z[i] - lower[i]) / w, (upper[i] - z[i]) / w);
            let (side, margin, gap) = if lower[i] == upper[i] {
                (Side::Fixed, f64::INFINITY, above.abs())
            } else if lower[i].is_finite() && f >= above {
                (Side::AtLower, f, above.abs())
            } else if upper[i].is_finite() && -f >= below {
                (Side::AtUpper, -f, below.abs())
            } else {
                (Side::Off, above.min(below), 0.0)
            };
            if side == Side::Off {
                pairs.off.push(i);
            }
            pairs.side.push(side);
            pairs.margin.push(margin);
            pairs.gap = pairs.gap.max(gap);
        }
        pairs
    }

    /// The pair of the smallest margin, if there is a bound at all.
    pub(super) fn weakest(&self) -> Option<(usize, f64)> {
        let pairs = self.margin.iter().copied().enumerate();
        pairs.filter(|(_, margin)| margin.is_finite()).min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// All pairs of a smaller margin.
    pub(super) fn weaker_than(&self, margin: f64) -> Vec<usize> {
        (0..self.margin.len()).filter(|&i| self.margin[i] <= margin).collect()
    }
}
