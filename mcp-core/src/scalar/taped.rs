//! [`Taped`]: a number that knows how it was made, for derivatives by all variables in one sweep back.

use super::{Jet, Scalar};
use std::array::from_fn;
use std::cell::{Cell, RefCell};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Marks a slope that depends on variables, beside the number of a node.
const VARIES: u32 = 1 << 31;

/// A number made of two nodes: `∂/∂aₖ = slopes[k]`.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// Numbers of earlier nodes, with [`VARIES`].
    of: [u32; 2],
    slopes: [f64; 2],
}

/// The memory of a [`Tape`] between evaluations.
#[derive(Debug, Default)]
pub(crate) struct TapeMemory(Vec<Node>);

/// What [`Taped`] numbers of one row were made of, in order: the tape of the reverse mode of
/// [GW08](crate#references).
///
/// Nodes `0..lanes` are what the row reads; every further one is made of two before it. Functions of
/// one number make none, because a number is a slope times a node.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    lanes: Cell<u32>,
    nodes: RefCell<Vec<Node>>,
    /// Whether somebody asked for the value of a number: what follows may depend on it.
    was_looked_at: Cell<bool>,
}

/// How a number depends on another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Dependence {
    None,
    /// With a derivative that is the same everywhere.
    Constant,
    /// With a derivative that may depend on variables.
    Varying,
}

/// A value whose derivatives are `slope` times those of a node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Taped<'t> {
    v: f64,
    slope: f64,
    /// Number of the node, with [`VARIES`]; nothing for a constant.
    node: u32,
    tape: Option<&'t Tape>,
}

impl Tape {
    /// Over this memory, which comes back [`into_memory`](Self::into_memory).
    pub(crate) fn over(memory: TapeMemory) -> Self {
        Tape { nodes: RefCell::new(memory.0), ..Tape::default() }
    }

    pub(crate) fn into_memory(self) -> TapeMemory {
        TapeMemory(self.nodes.into_inner())
    }

    /// Forgets everything; a row follows that reads this many numbers, or more by [`leaf`](Self::leaf).
    pub(crate) fn begin(&self, lanes: u32) {
        self.lanes.set(lanes);
        self.nodes.borrow_mut().clear();
        self.was_looked_at.set(false);
    }

    /// The number that is read in this lane.
    #[inline]
    pub(crate) fn read(&self, v: f64, lane: u32) -> Taped<'_> {
        debug_assert!(lane < self.len());
        Taped { v, slope: 1.0, node: lane, tape: Some(self) }
    }

    /// A number that is read in a lane of its own.
    pub(crate) fn leaf(&self, v: f64) -> Taped<'_> {
        let node = self.len();
        self.push(v, [node, node], [0.0, 0.0])
    }

    /// Number of lanes and nodes.
    #[allow(clippy::cast_possible_truncation, reason = "a row has fewer than 2^31 operations")]
    pub(crate) fn len(&self) -> u32 {
        self.lanes.get() + self.nodes.borrow().len() as u32
    }

    /// `v` with `∂v/∂of[k] = slopes[k]`.
    #[inline]
    #[allow(clippy::cast_possible_truncation, reason = "a row has fewer than 2^31 operations")]
    fn push(&self, v: f64, of: [u32; 2], slopes: [f64; 2]) -> Taped<'_> {
        let mut nodes = self.nodes.borrow_mut();
        let node = self.lanes.get() + nodes.len() as u32;
        nodes.push(Node { of, slopes });
        Taped { v, slope: 1.0, node, tape: Some(self) }
    }

    /// Derivatives of `result` by all lanes, then by all nodes: one sweep from the last to the first.
    ///
    /// A zero slope stays zero where an adjoint is not finite, as in [`Jet`].
    pub(crate) fn differentiate(&self, result: &Taped<'_>, adjoints: &mut Vec<f64>) {
        self.sweep(result, adjoints, |adjoint, slope| adjoint * slope);
        // What is not finite in between shows in the lanes; without lanes of their own all are leaves.
        let lanes = match self.lanes.get() as usize {
            0 => &adjoints[..],
            lanes => &adjoints[..lanes],
        };
        if !lanes.iter().copied().all(f64::is_finite) {
            self.sweep(result, adjoints, limit_product);
        }
    }

    fn sweep(
        &self,
        result: &Taped<'_>,
        adjoints: &mut Vec<f64>,
        product: impl Fn(f64, f64) -> f64,
    ) {
        let (lanes, nodes) = (self.lanes.get() as usize, self.nodes.borrow());
        adjoints.clear();
        adjoints.resize(lanes + nodes.len(), 0.0);
        if result.tape.is_none() {
            return;
        }
        adjoints[number(result.node)] = result.slope;
        for (k, Node { of, slopes }) in nodes.iter().enumerate().rev() {
            let adjoint = adjoints[lanes + k];
            for (&of, &slope) in of.iter().zip(slopes) {
                adjoints[number(of)] += product(adjoint, slope);
            }
        }
    }

    /// How `result` depends on all lanes, then on all nodes. Who looks at values may do anything by them.
    pub(crate) fn dependence(&self, result: &Taped<'_>, dependence: &mut Vec<Dependence>) {
        let (lanes, nodes) = (self.lanes.get() as usize, self.nodes.borrow());
        let unseen = if self.was_looked_at.get() { Dependence::Varying } else { Dependence::None };
        dependence.clear();
        dependence.resize(lanes + nodes.len(), unseen);
        if result.tape.is_none() {
            return;
        }
        let along = |node: u32| match node & VARIES {
            0 => Dependence::Constant,
            _ => Dependence::Varying,
        };
        dependence[number(result.node)] = along(result.node).max(unseen);
        for (k, Node { of, .. }) in nodes.iter().enumerate().rev() {
            let own = dependence[lanes + k];
            if own != Dependence::None {
                for &of in of {
                    let of_node = &mut dependence[number(of)];
                    *of_node = own.max(along(of)).max(*of_node);
                }
            }
        }
    }
}

/// The number of a node, which may be marked with [`VARIES`].
#[inline]
fn number(node: u32) -> usize {
    (node & !VARIES) as usize
}

/// `adjoint · slope`, 0 where the slope is 0.
fn limit_product(adjoint: f64, slope: f64) -> f64 {
    if slope == 0.0 { 0.0 } else { adjoint * slope }
}

impl Taped<'_> {
    /// The value, by a look that nothing can depend on.
    pub(crate) fn plain(&self) -> f64 {
        self.v
    }

    /// Notes that the value is asked for.
    fn look(&self) {
        if let Some(tape) = self.tape {
            tape.was_looked_at.set(true);
        }
    }

    /// `f(x)` by its value and slope, found by [`Jet`].
    #[inline]
    fn unary(self, f: impl FnOnce(Jet<1>) -> Jet<1>) -> Self {
        let y = f(Jet { v: self.v, d: [1.0] });
        self.chain(y.v, y.d[0])
    }

    /// `f(x) = v` with `f'(x) = slope`, which depends on `x`.
    #[inline]
    fn chain(self, v: f64, slope: f64) -> Self {
        Taped { v, slope: limit_product(slope, self.slope), node: self.node | VARIES, ..self }
    }

    /// `f(x, y)` by its value and slopes, found by [`Jet`].
    #[inline]
    fn binary(self, other: Self, f: impl FnOnce(Jet<2>, Jet<2>) -> Jet<2>) -> Self {
        let y = f(Jet { v: self.v, d: [1.0, 0.0] }, Jet { v: other.v, d: [0.0, 1.0] });
        self.chain2(other, y.v, y.d)
    }

    /// `f(x, y) = v` with these slopes, which depend on `x` and `y`.
    #[inline]
    fn chain2(self, other: Self, v: f64, [by_x, by_y]: [f64; 2]) -> Self {
        match (self.tape, other.tape) {
            (_, None) => self.chain(v, by_x),
            (None, _) => other.chain(v, by_y),
            (Some(tape), _) => {
                let slopes = [limit_product(by_x, self.slope), limit_product(by_y, other.slope)];
                tape.push(v, [self.node | VARIES, other.node | VARIES], slopes)
            }
        }
    }

    /// `v = ±x ± y` with `slopes` those of its nodes.
    #[inline]
    fn linear(self, other: Self, v: f64, slopes: [f64; 2]) -> Self {
        match (self.tape, other.tape) {
            (_, None) => Taped { v, slope: slopes[0], ..self },
            (None, _) => Taped { v, slope: slopes[1], ..other },
            (Some(tape), _) => {
                if (self.node ^ other.node) & !VARIES == 0 {
                    let node = self.node | other.node;
                    return Taped { v, slope: slopes[0] + slopes[1], node, ..self };
                }
                tape.push(v, [self.node, other.node], slopes)
            }
        }
    }
}

impl Neg for Taped<'_> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Taped { v: -self.v, slope: -self.slope, ..self }
    }
}

impl Add for Taped<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.linear(other, self.v + other.v, [self.slope, other.slope])
    }
}

impl Sub for Taped<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.linear(other, self.v - other.v, [self.slope, -other.slope])
    }
}

impl Mul for Taped<'_> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the product rule adds")]
    fn mul(self, other: Self) -> Self {
        let v = self.v * other.v;
        let slopes = [self.slope * other.v, other.slope * self.v];
        match (self.tape, other.tape) {
            (_, None) => Taped { v, slope: slopes[0], ..self },
            (None, _) => Taped { v, slope: slopes[1], ..other },
            (Some(tape), _) => {
                let of = [self.node | VARIES, other.node | VARIES];
                if of[0] == of[1] {
                    return Taped { v, slope: slopes[0] + slopes[1], node: of[0], ..self };
                }
                tape.push(v, of, slopes)
            }
        }
    }
}

impl Div for Taped<'_> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.tape.is_none() {
            return self.over(other.v);
        }
        self.binary(other, |x, y| x / y)
    }
}

macro_rules! functions {
    ($($kind:ident: $($name:ident($x:ident $(, $other:ident)? $(; $c:ident: $C:ty)?))*;)*) => {
        $($(
            fn $name(self $(, $other: Self)? $(, $c: $C)?) -> Self {
                self.$kind($($other,)? |$x $(, $other)?| $x.$name($($other)? $($c)?))
            }
        )*)*
    };
}

impl Scalar for Taped<'_> {
    const LANES: usize = u32::MAX as usize;

    #[inline]
    fn constant(v: f64) -> Self {
        Taped { v, slope: 0.0, node: 0, tape: None }
    }
    /// A constant: variables come from a [`Tape`].
    #[inline]
    fn seed(v: f64, _lane: usize) -> Self {
        Self::constant(v)
    }
    fn tangent(&self, lane: usize) -> f64 {
        self.look();
        let mut adjoints = Vec::new();
        self.tape.map_or(0.0, |tape| {
            tape.differentiate(self, &mut adjoints);
            adjoints[lane]
        })
    }
    fn value(&self) -> f64 {
        self.look();
        self.v
    }
    fn is_zero(&self) -> bool {
        self.look();
        self.v == 0.0 && (self.tape.is_none() || self.slope == 0.0)
    }
    fn is_finite(&self) -> bool {
        self.look();
        self.v.is_finite() && self.slope.is_finite()
    }
    fn with_unknown_tangents(self) -> Self {
        Taped { slope: f64::NAN, node: self.node | VARIES, ..self }
    }
    fn linearised<const K: usize>(value: f64, gradient: &[f64; K], arguments: &[Self; K]) -> Self {
        let mut sum = Self::constant(value);
        for (argument, &slope) in arguments.iter().zip(gradient) {
            sum = argument.chain(0.0, slope).chain2(sum, value, [1.0, 1.0]);
        }
        sum
    }

    #[inline]
    fn shift(self, c: f64) -> Self {
        Taped { v: self.v + c, ..self }
    }
    fn scale(self, c: f64) -> Self {
        Taped { v: self.v * c, slope: limit_product(self.slope, c), ..self }
    }
    fn over(self, c: f64) -> Self {
        let slope = if self.slope == 0.0 { 0.0 } else { self.slope / c };
        Taped { v: self.v / c, slope, ..self }
    }

    functions! {
        unary: recip(x) powi(x; n: i32) powf(x; p: f64) sqrt(x) cbrt(x) exp(x) exp_m1(x) ln(x) ln_1p(x)
            log10(x) sin(x) cos(x) tan(x) asin(x) acos(x) atan(x) sinh(x) cosh(x) tanh(x) xlogx(x) abs(x);
        binary: pow(x, y) atan2(x, y) hypot(x, y) max(x, y) min(x, y);
    }
    fn powf_slope(self, p: f64, v: Self) -> Self {
        self.unary(|x| x.powf_slope(p, Jet::constant(v.v)))
    }
    fn select(s: Self, a: Self, b: Self) -> Self {
        let [s1, a1, b1] = from_fn(|k| Jet::<3>::seed([s.v, a.v, b.v][k], k));
        let y = Jet::select(s1, a1, b1);
        Self::linearised(y.v, &y.d, &[s, a, b])
    }
}

#[cfg(test)]
#[path = "taped_tests.rs"]
mod tests;
