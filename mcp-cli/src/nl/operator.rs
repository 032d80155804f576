//! Operators of expressions: their numbers in a file, their operands, their values.
//!
//! Numbers and meanings are those of [Gay05](mcp_core#references). Logical values are 1 and 0.

use mcp_core::{Real, Scalar, external, select};

/// Functions of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unary {
    Floor,
    Ceil,
    Abs,
    Neg,
    Not,
    /// Whether a number used as a logical value is not 0.
    Truth,
    Tanh,
    Tan,
    Sqrt,
    Sinh,
    Sin,
    Log10,
    Log,
    Exp,
    Cosh,
    Cos,
    Atanh,
    Atan,
    Asinh,
    Asin,
    Acosh,
    Acos,
}

/// Functions of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    /// `x − y trunc(x/y)`.
    Rem,
    Pow,
    /// `max(x − y, 0)`.
    Less,
    Or,
    And,
    Lt,
    Le,
    Eq,
    Ge,
    Gt,
    Ne,
    Iff,
    Atan2,
    /// `trunc(x/y)`.
    IntDiv,
    /// `x` to `y` significant digits.
    Precision,
    /// `x` to `y` decimals.
    Round,
    /// `x` cut after `y` decimals.
    Trunc,
    Min,
    Max,
}

/// What an operator makes of its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Unary(Unary),
    Binary(Binary),
    /// Any number of operands, two at a time from the left.
    Fold(Binary),
    /// How many operands are true.
    Count,
    /// How many of the operands equal the first.
    NumberOf,
    /// `x²`.
    Square,
    /// If the first operand is true the second, else the third.
    If,
    /// The same for logical values, `c ==> a else b`.
    Implies,
    /// Slopes and breakpoints, then a variable.
    Piecewise,
    /// What a complementarity problem does not have, and why.
    Unsupported(&'static str),
}

const STRINGS: &str = "operators on strings are for imported functions";
const DIFFERENT: &str = "`alldiff` is for integer variables, which a complementarity problem lacks";

impl Action {
    /// The operator with this number in a file.
    pub(super) fn of_code(code: usize) -> Option<Self> {
        use Action::{Count, Fold, If, Implies, NumberOf, Piecewise, Square, Unsupported};
        use Binary::{
            Add, And, Atan2, Div, Eq, Ge, Gt, Iff, IntDiv, Le, Less, Lt, Max, Min, Mul, Ne, Or,
            Pow, Precision, Rem, Round, Sub, Trunc,
        };
        use Unary::{
            Abs, Acos, Acosh, Asin, Asinh, Atan, Atanh, Ceil, Cos, Cosh, Exp, Floor, Log, Log10,
            Neg, Not, Sin, Sinh, Sqrt, Tan, Tanh,
        };
        let (unary, binary) = (Action::Unary, Action::Binary);
        Some(match code {
            0 => binary(Add),
            1 => binary(Sub),
            2 => binary(Mul),
            3 => binary(Div),
            4 => binary(Rem),
            // 76: the exponent is a constant, 78: the base is.
            5 | 76 | 78 => binary(Pow),
            6 => binary(Less),
            11 => Fold(Min),
            12 => Fold(Max),
            13 => unary(Floor),
            14 => unary(Ceil),
            15 => unary(Abs),
            16 => unary(Neg),
            20 => binary(Or),
            21 => binary(And),
            // 62 to 69: `atmost` and so on compare a number with a count.
            22 | 68 => binary(Lt),
            23 | 62 => binary(Le),
            24 | 66 => binary(Eq),
            28 | 63 => binary(Ge),
            29 | 67 => binary(Gt),
            30 | 69 => binary(Ne),
            34 => unary(Not),
            35 => If,
            72 => Implies,
            37 => unary(Tanh),
            38 => unary(Tan),
            39 => unary(Sqrt),
            40 => unary(Sinh),
            41 => unary(Sin),
            42 => unary(Log10),
            43 => unary(Log),
            44 => unary(Exp),
            45 => unary(Cosh),
            46 => unary(Cos),
            47 => unary(Atanh),
            48 => binary(Atan2),
            49 => unary(Atan),
            50 => unary(Asinh),
            51 => unary(Asin),
            52 => unary(Acosh),
            53 => unary(Acos),
            54 => Fold(Add),
            55 => binary(IntDiv),
            56 => binary(Precision),
            57 => binary(Round),
            58 => binary(Trunc),
            59 => Count,
            60 => NumberOf,
            64 => Piecewise,
            70 => Fold(And),
            71 => Fold(Or),
            73 => binary(Iff),
            74 | 75 => Unsupported(DIFFERENT),
            77 => Square,
            61 | 65 => Unsupported(STRINGS),
            _ => return None,
        })
    }

    /// Whether operand number `k` is a logical value.
    pub(super) fn takes_truth(self, k: usize) -> bool {
        match self {
            Action::Unary(Unary::Not)
            | Action::Binary(Binary::And | Binary::Or | Binary::Iff)
            | Action::Fold(Binary::And | Binary::Or)
            | Action::Implies
            | Action::Count => true,
            Action::If => k == 0,
            _ => false,
        }
    }
}

impl Unary {
    /// Whether the value is 0 or 1.
    pub(super) fn is_logical(self) -> bool {
        matches!(self, Unary::Not | Unary::Truth)
    }

    pub(super) fn of<D: Scalar>(self, x: Real<D>) -> Real<D> {
        match self {
            Unary::Floor => external(&[x], |[x], _| x.floor()),
            Unary::Ceil => external(&[x], |[x], _| x.ceil()),
            Unary::Abs => x.abs(),
            Unary::Neg => -x,
            Unary::Not => 1.0 - x,
            Unary::Truth => is_positive(x.abs()),
            Unary::Tanh => x.tanh(),
            Unary::Tan => x.tan(),
            Unary::Sqrt => x.sqrt(),
            Unary::Sinh => x.sinh(),
            Unary::Sin => x.sin(),
            Unary::Log10 => x.log10(),
            Unary::Log => x.ln(),
            Unary::Exp => x.exp(),
            Unary::Cosh => x.cosh(),
            Unary::Cos => x.cos(),
            // artanh x = ½ ln((1 + x)/(1 − x)).
            Unary::Atanh => 0.5 * (2.0 * x / (1.0 - x)).ln_1p(),
            Unary::Atan => x.atan(),
            Unary::Asinh => select(x, asinh_of_positive(x), -asinh_of_positive(-x)),
            Unary::Asin => x.asin(),
            Unary::Acosh => acosh(x),
            Unary::Acos => x.acos(),
        }
    }
}

impl Binary {
    /// Whether the value is 0 or 1.
    pub(super) fn is_logical(self) -> bool {
        use Binary::{And, Eq, Ge, Gt, Iff, Le, Lt, Ne, Or};
        matches!(self, And | Or | Lt | Le | Eq | Ge | Gt | Ne | Iff)
    }

    pub(super) fn of<D: Scalar>(self, x: Real<D>, y: Real<D>) -> Real<D> {
        match self {
            Binary::Add => x + y,
            Binary::Sub => x - y,
            Binary::Mul => x * y,
            Binary::Div => x / y,
            Binary::Rem => external(&[x, y], |&[x, y], slope| {
                *slope = [1.0, -(x / y).trunc()];
                x % y
            }),
            Binary::Pow => x.pow(y),
            Binary::Less => (x - y).max(0.0),
            // Of 0 and 1; the second operand may be undefined where the first decides.
            Binary::And => select(x, y, 0.0),
            Binary::Or => select(x, 1.0, y),
            Binary::Min => x.min(y),
            Binary::Max => x.max(y),
            Binary::Lt => is_positive(y - x),
            Binary::Le => 1.0 - is_positive(x - y),
            Binary::Eq => 1.0 - is_positive((x - y).abs()),
            Binary::Ge => 1.0 - is_positive(y - x),
            Binary::Gt => is_positive(x - y),
            Binary::Ne => is_positive((x - y).abs()),
            Binary::Iff => 1.0 - (x - y).abs(),
            Binary::Atan2 => x.atan2(y),
            Binary::IntDiv => external(&[x, y], |[x, y], _| (x / y).trunc()),
            Binary::Precision => external(&[x, y], |&[x, y], _| to_digits(x, y)),
            Binary::Round => external(&[x, y], |&[x, y], _| at_decimals(x, y, f64::round)),
            Binary::Trunc => external(&[x, y], |&[x, y], _| at_decimals(x, y, f64::trunc)),
        }
    }
}

/// 1 where `s > 0`, 0 where `s <= 0`.
fn is_positive<D: Scalar>(s: Real<D>) -> Real<D> {
    select(s, 1.0, 0.0)
}

/// `arsinh x = ln(x + √(1 + x²))` for `x >= 0`, as `ln(1 + x + x²/(1 + √(1 + x²)))`, which does not
/// cancel near 0.
fn asinh_of_positive<D: Scalar>(x: Real<D>) -> Real<D> {
    (x + x * (x / (1.0 + x.hypot(1.0)))).ln_1p()
}

/// `arcosh x = ln(x + √(x² − 1))`, as `ln(1 + t + √t √(t + 2))` with `t = x − 1`.
fn acosh<D: Scalar>(x: Real<D>) -> Real<D> {
    let t = x - 1.0;
    (t + t.sqrt() * (t + 2.0).sqrt()).ln_1p()
}

/// `x` to so many significant decimal digits.
fn to_digits(x: f64, digits: f64) -> f64 {
    if !(x.is_finite() && (1.0..17.0).contains(&digits)) {
        return x;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked above")]
    let behind_the_point = digits as usize - 1;
    format!("{x:.behind_the_point$e}").parse().unwrap_or(x)
}

/// `x` rounded to so many decimals; to tens, hundreds, … if their number is negative.
fn at_decimals(x: f64, decimals: f64, round: fn(f64) -> f64) -> f64 {
    let unit = 10_f64.powf(decimals.round().abs());
    let rounded = if decimals >= 0.0 { round(x * unit) / unit } else { round(x / unit) * unit };
    // More decimals than a number has change nothing.
    if rounded.is_finite() { rounded } else { x }
}
