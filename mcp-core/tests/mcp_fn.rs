//! `#[mcp_fn]`: a function stays a function and gets a model beside it.

#![allow(clippy::float_cmp, reason = "these numbers are exact")]

use mcp_core::{BoundKind, Jet, Model, Real, Scalar, mcp_fn};

const INF: f64 = f64::INFINITY;

/// Names of variables and equations.
fn names(model: &impl Model) -> (Vec<String>, Vec<String>) {
    let shape = model.shape();
    let variables = (0..shape.n()).map(|j| shape.variable_name(j)).collect();
    (variables, (0..shape.n()).map(|i| shape.equation_name(i)).collect())
}

fn size<M: Model>(_: &M) -> Option<usize> {
    M::WHOLE
}

/// Four equations of Kojima and Shindo.
#[mcp_fn(lower = 0.0)]
fn kojima_shindo<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
    [
        3.0 * x1 * x1 + 2.0 * x1 * x2 + 2.0 * x2 * x2 + x3 + 3.0 * x4 - 6.0,
        2.0 * x1 * x1 + x1 + x2 * x2 + 10.0 * x3 + 2.0 * x4 - 2.0,
        3.0 * x1 * x1 + x1 * x2 + 2.0 * x2 * x2 + 2.0 * x3 + 9.0 * x4 - 9.0,
        x1 * x1 + 3.0 * x2 * x2 + 2.0 * x3 + 3.0 * x4 - 3.0,
    ]
}

#[test]
fn the_pattern_names_variables_and_equations() {
    let model = KojimaShindo::new().unwrap();
    let (variables, equations) = names(&model);
    assert_eq!(variables, ["x1", "x2", "x3", "x4"]);
    assert_eq!(equations, ["f[x1]", "f[x2]", "f[x3]", "f[x4]"]);
    assert_eq!(size(&model), Some(4));
    assert_eq!(model.shape().bounds().lower(), [0.0; 4]);
    assert_eq!(model.shape().bounds().upper(), [INF; 4]);
    assert_eq!(model.shape().start(), [0.0; 4]);
}

#[test]
fn models_are_cloned_and_printed() {
    let model = KojimaShindo::new().unwrap();
    assert!(format!("{:?}", model.clone()).starts_with("KojimaShindo {"));
}

#[test]
fn the_function_is_called_with_any_numbers() {
    let f = kojima_shindo([1.0, 0.0, 3.0, 0.0].map(Real::<f64>::from));
    assert_eq!(f.map(Real::into_scalar), [0.0, 31.0, 0.0, 4.0]);

    let at = [1.0, 0.0, 3.0, 0.0];
    let z = std::array::from_fn(|j| Real::from_scalar(Jet::<4>::seed(at[j], j)));
    let f = kojima_shindo(z).map(Real::into_scalar);
    assert_eq!(f.map(|f| f.value()), [0.0, 31.0, 0.0, 4.0]);
    assert_eq!([0, 1, 2, 3].map(|j| f[1].tangent(j)), [5.0, 0.0, 10.0, 2.0]);
}

const LOW: [i32; 3] = [-1, 0, 1];
fn high(n: usize) -> f64 {
    if n == 3 { 10.0 } else { INF }
}

#[mcp_fn(lower = LOW, upper = high(3), start = [0.5, f64::from(2), 20])]
fn bounded<D: Scalar>([a, b, c]: [Real<D>; 3]) -> [Real<D>; 3] {
    [a, b, c]
}

#[mcp_fn]
fn free<D: Scalar>([x]: [Real<D>; 1]) -> [Real<D>; 1] {
    [x - 1]
}

#[mcp_fn(lower = -1, upper = [1; 2], start = [0.25_f32; 2],)]
fn cycled<D: Scalar>(z: [Real<D>; 2]) -> [Real<D>; 2] {
    let [x, y] = z;
    [y, -x]
}

#[test]
fn bounds_and_starts_are_any_expressions() {
    let model = Bounded::new().unwrap();
    let shape = model.shape();
    assert_eq!(shape.bounds().lower(), [-1.0, 0.0, 1.0]);
    assert_eq!(shape.bounds().upper(), [10.0; 3]);
    assert_eq!(shape.start(), [0.5, 2.0, 10.0]);

    let model = Free::new().unwrap();
    assert_eq!(model.shape().bounds().kind(0), BoundKind::Free);

    let model = Cycled::new().unwrap();
    assert_eq!(model.shape().bounds().lower(), [-1.0; 2]);
    assert_eq!(model.shape().bounds().upper(), [1.0; 2]);
    assert_eq!(model.shape().start(), [0.25; 2]);
}

#[mcp_fn(lower = [0.0, 2.0], upper = 1.0)]
fn crossed<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x, y]
}

#[mcp_fn(lower = f64::NAN)]
fn unusable<D: Scalar>(z: [Real<D>; 2]) -> [Real<D>; 2] {
    z
}

#[mcp_fn(start = [0.0, INF])]
fn far<D: Scalar>(z: [Real<D>; 2]) -> [Real<D>; 2] {
    z
}

#[test]
fn errors_name_the_variable() {
    assert_eq!(
        Crossed::new().unwrap_err().to_string(),
        "variable `y` has crossed bounds: lower 2 is above upper 1"
    );
    assert_eq!(
        Unusable::new().unwrap_err().to_string(),
        "variable `z[1]` has the bounds [NaN, inf], which no number satisfies"
    );
    assert_eq!(
        Far::new().unwrap_err().to_string(),
        "the start of variable `z[2]` is inf: give a finite number"
    );
}

const N: usize = 2;

#[mcp_fn(lower = [0.0; 2 * N], start = [1.0, 2.0, 3.0, 4.0])]
fn computed<S: Scalar>(z: [Real<S>; 2 * N]) -> [Real<S>; 2 * N] {
    z.map(|z| z * z)
}

mod sizes {
    pub(super) const LARGE: usize = 7;

    #[mcp_core::mcp_fn]
    pub(super) fn pathed<Number>(
        mut q: [mcp_core::Real<Number>; LARGE],
    ) -> [mcp_core::Real<Number>; crate::N + 5]
    where
        Number: mcp_core::Scalar,
    {
        q.reverse();
        q
    }
}

#[mcp_fn(lower = [0.0, 1.0])]
fn paired<D: Scalar>([mut x, y]: [Real<D>; N]) -> [Real<D>; 4 / N] {
    x += y;
    [x, y]
}

#[test]
fn sizes_are_any_constants() {
    let model = Computed::new().unwrap();
    let (variables, equations) = names(&model);
    assert_eq!(variables, ["z[1]", "z[2]", "z[3]", "z[4]"]);
    assert_eq!(equations, ["f[1]", "f[2]", "f[3]", "f[4]"]);
    assert_eq!(model.shape().start(), [1.0, 2.0, 3.0, 4.0]);

    let model = sizes::Pathed::new().unwrap();
    assert_eq!(size(&model), Some(sizes::LARGE));
    assert_eq!(sizes::pathed([Real::<f64>::from(2.0); 7]).len(), 7);
    assert_eq!(names(&model).0[6], "q[7]");

    assert_eq!(names(&Paired::new().unwrap()).0, ["x", "y"]);
}

#[mcp_fn(lower = 0, upper = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11], start = 1)]
fn row<S: Scalar>(
    [f, read, shape, lower, self_, index, family, rows, r#type, new, row]: [Real<S>; 11],
) -> [Real<S>; 11] {
    [f, read, shape, lower, self_, index, family, rows, r#type, new, row]
}

#[mcp_fn]
#[allow(non_snake_case, reason = "any name can be a variable")]
fn read<D: Scalar>([D, S]: [Real<D>; 2]) -> [Real<D>; 2] {
    [D + S, S]
}

#[mcp_fn(start = 3)]
fn f<D: Scalar>(f: [Real<D>; 2]) -> [Real<D>; 2] {
    f
}

#[test]
fn variables_and_functions_have_any_name() {
    let model = Row::new().unwrap();
    let (variables, equations) = names(&model);
    assert_eq!(variables[..5], ["f", "read", "shape", "lower", "self_"]);
    assert_eq!(variables[8], "type");
    assert_eq!(equations[8], "f[type]");
    assert_eq!(model.shape().bounds().upper()[10], 11.0);
    assert_eq!(names(&Read::new().unwrap()).0, ["D", "S"]);

    let (variables, equations) = names(&F::new().unwrap());
    assert_eq!(variables, ["f[1]", "f[2]"]);
    assert_eq!(equations, ["F[1]", "F[2]"]);
}

mod shadowed {
    //! Nothing of the prelude is needed by generated code.
    #![allow(dead_code, reason = "these types are only in the way")]

    struct Option;
    struct Result;
    struct Shape;
    struct Clone;
    trait Model {}
    type Numbers<D, const N: usize> = [super::Real<D>; N];

    #[mcp_core::mcp_fn(lower = 0.0, crate = ::mcp_core)]
    pub(super) fn some<D: mcp_core::Scalar>(
        [x, y]: [mcp_core::Real<D>; 2],
    ) -> [mcp_core::Real<D>; 2] {
        let z: Numbers<D, 2> = [x, y];
        z
    }
}

#[test]
fn the_model_is_as_visible_as_the_function() {
    assert_eq!(names(&shadowed::Some::new().unwrap()).0, ["x", "y"]);
    assert_eq!(shadowed::some([Real::<f64>::from(1.0); 2]).len(), 2);
}

#[test]
fn models_stand_inside_functions() {
    const M: usize = 3;
    const HALF: f64 = 0.5;
    #[mcp_fn(lower = HALF)]
    fn inner<D: Scalar>(z: [Real<D>; M]) -> [Real<D>; M] {
        z
    }
    assert_eq!(Inner::new().unwrap().shape().start(), [0.5; M]);
}

macro_rules! power {
    ($name:ident, $n:expr, $T:ty, $lower:expr) => {
        #[mcp_fn(lower = $lower)]
        fn $name<D: Scalar>(z: [Real<D>; $n]) -> [$T; $n] {
            z.map(|z| z.powi(3))
        }
    };
}
power!(cubes, 2, Real<D>, [0, 1]);

#[test]
fn models_come_out_of_other_macros() {
    assert_eq!(Cubes::new().unwrap().shape().bounds().lower(), [0.0, 1.0]);
}
