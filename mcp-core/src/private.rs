//! What the macros call: not part of the interface. What `mcp!` calls beside [`number`] stands in
//! [`language`](crate::language).

use crate::error::ModelError;
use crate::model::{Equation, Set, Shape, Variable};

/// A number in a bound or a start: any float or integer.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number",
    label = "expected a number",
    note = "bounds and starts are numbers: floats or integers"
)]
pub trait Number {
    /// The number as a float.
    fn to_f64(self) -> f64;
}

/// Bounds or starts of `N` variables.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot give a number to each of {N} variables",
    label = "expected a number or an array of {N} numbers",
    note = "bounds and starts are a number, or an array with one number for each variable"
)]
pub trait PerVariable<const N: usize> {
    /// One number for each variable.
    fn numbers(self) -> [f64; N];
}

macro_rules! number {
    ($($T:ty: $to_f64:expr),* $(,)?) => { $(
        #[diagnostic::do_not_recommend]
        impl Number for $T {
            fn to_f64(self) -> f64 {
                let convert: fn($T) -> f64 = $to_f64;
                convert(self)
            }
        }
        #[diagnostic::do_not_recommend]
        impl<const N: usize> PerVariable<N> for $T {
            fn numbers(self) -> [f64; N] {
                [self.to_f64(); N]
            }
        }
    )* };
}

number!(
    f64: |v| v,
    f32: f64::from,
    i32: f64::from,
    u32: f64::from,
    i64: |v| v as f64,
    u64: |v| v as f64,
    isize: |v| v as f64,
    usize: |v| v as f64,
);

#[diagnostic::do_not_recommend]
impl<T: Number, const N: usize> PerVariable<N> for [T; N] {
    fn numbers(self) -> [f64; N] {
        self.map(T::to_f64)
    }
}

/// One number of an array that is written out.
pub fn number(value: impl Number) -> f64 {
    value.to_f64()
}

/// Bounds and start of a function of `N` variables: free and starting at 0 unless said otherwise.
#[derive(Clone, Debug)]
pub struct FunctionShape<const N: usize> {
    lower: [f64; N],
    upper: [f64; N],
    start: [f64; N],
}

impl<const N: usize> Default for FunctionShape<N> {
    fn default() -> Self {
        FunctionShape { lower: [f64::NEG_INFINITY; N], upper: [f64::INFINITY; N], start: [0.0; N] }
    }
}

impl<const N: usize> FunctionShape<N> {
    /// Free variables starting at 0.
    pub fn new() -> Self {
        Self::default()
    }

    /// Lower bounds.
    #[must_use]
    pub fn lower(mut self, lower: impl PerVariable<N>) -> Self {
        self.lower = lower.numbers();
        self
    }
    /// Upper bounds.
    #[must_use]
    pub fn upper(mut self, upper: impl PerVariable<N>) -> Self {
        self.upper = upper.numbers();
        self
    }
    /// Where a solve starts.
    #[must_use]
    pub fn start(mut self, start: impl PerVariable<N>) -> Self {
        self.start = start.numbers();
        self
    }

    /// Variables with names of their own: `f[x1]` complements `x1`. A name is an identifier, so no
    /// equation is called like a variable.
    ///
    /// # Errors
    /// As [`ShapeBuilder::build`](crate::ShapeBuilder::build).
    pub fn named(self, names: &[&str]) -> Result<Shape, ModelError> {
        let mut shape = Shape::builder();
        for (i, &name) in names.iter().enumerate() {
            let variable =
                Variable::new(name).lower(self.lower[i]).upper(self.upper[i]).start(self.start[i]);
            let equation = Equation::new(format!("f[{name}]")).complements(name);
            shape = shape.variable(variable).equation(equation);
        }
        shape.build()
    }

    /// Numbered variables: `f[1]` complements `z[1]`; for variables called `f` it is `F[1]`.
    ///
    /// # Errors
    /// As [`ShapeBuilder::build`](crate::ShapeBuilder::build).
    pub fn indexed(self, name: &str) -> Result<Shape, ModelError> {
        let rows = Set::count("rows", N);
        let variable = Variable::new(name)
            .over(&[&rows])
            .lower(self.lower)
            .upper(self.upper)
            .start(self.start);
        let equation = Equation::new(if name == "f" { "F" } else { "f" });
        Shape::builder()
            .variable(variable)
            .equation(equation.over(&[&rows]).complements(name))
            .build()
    }
}

#[cfg(all(test, feature = "macros"))]
#[path = "private_tests.rs"]
mod tests;
