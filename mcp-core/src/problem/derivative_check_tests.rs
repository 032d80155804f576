use super::*;
use crate::mcp_fn;
use crate::scalar::{Real, Scalar, external};

#[mcp_fn(lower = 0.0)]
fn smooth<D: Scalar>([x, y, z]: [Real<D>; 3]) -> [Real<D>; 3] {
    [
        x * y.exp() - z.pow(1.3) / (1.0 + x),
        (x * x + y * y).sqrt() - 1e6 * z,
        (x - y).tanh() * z.ln() + 1e-6 * y,
    ]
}

#[test]
fn a_smooth_model_passes_at_many_points() {
    let model = Smooth::new().unwrap();
    for k in 1..50 {
        let t = f64::from(k) / 10.0;
        let z = [t, 5.1 - t, 1e-3 * t * t];
        let report = check_derivatives(&model, &z).unwrap().verdict().unwrap();
        assert_eq!((report.entries, report.kinks, report.beyond_domain), (9, 0, 0), "{t}");
        assert!(report.worst_difference.unwrap().relative_difference < 1e-6);
    }
}

/// `wrong` is the gradient given to an external function whose derivative is 2x.
fn table<D: Scalar>(x: Real<D>, wrong: f64) -> Real<D> {
    external(&[x], |v, gradient| {
        gradient[0] = 2.0 * v[0] + wrong;
        v[0] * v[0]
    })
}

#[mcp_fn]
fn right<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + y, table(x, 0.0) - y]
}

#[mcp_fn]
fn wrong<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + y, table(x, 1e-5) - y]
}

#[test]
fn a_wrong_external_gradient_is_named() {
    let z = [1.5, 0.5];
    check_derivatives(&Right::new().unwrap(), &z).unwrap().verdict().unwrap();
    let error = check_derivatives(&Wrong::new().unwrap(), &z).unwrap().verdict().unwrap_err();
    assert!(matches!(error, WrongDerivative::Contradicted { source_name: "differences", .. }));
    let message = "∂ f[y] / ∂ x is 3.00001e0, but differences gives 3e0";
    assert_eq!(error.to_string(), message);
}

#[mcp_fn]
fn kinked<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [(x - 1.0).abs() + y, x.max(y) + x * x]
}

#[test]
fn kinks_are_counted_and_left_out_and_found_only_where_they_are() {
    let model = Kinked::new().unwrap();
    let at = |z: [f64; 2]| check_derivatives(&model, &z).unwrap().verdict().unwrap().kinks;
    assert_eq!(at([1.0, 3.0]), 1, "|x − 1|");
    assert_eq!(at([2.0, 2.0]), 2, "max(x, y), by x and by y");
    assert_eq!(at([1.0, 1.0]), 3);
    assert_eq!(at([1.5, 0.25]), 0);
}

#[mcp_fn(lower = 0.0)]
fn corner<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x.sqrt() + y, x.pow(1.5) + y.xlogx()]
}

#[test]
fn the_edge_of_the_domain_is_counted_or_differentiated_from_inside() {
    let model = Corner::new().unwrap();
    let report = check_derivatives(&model, &[0.0, 1.0]).unwrap().verdict().unwrap();
    assert_eq!(report.beyond_domain, 1, "√x has an infinite slope at 0");
    let report = check_derivatives(&model, &[1.0, 0.0]).unwrap().verdict().unwrap();
    assert_eq!(report.beyond_domain, 1, "y ln y has an infinite slope at 0");
}

#[test]
fn the_report_reads_as_a_sentence() {
    let report = check_derivatives(&Right::new().unwrap(), &[1.5, 0.5]).unwrap();
    let text = report.to_string();
    assert!(text.starts_with("4 entries, worst relative difference to num-dual 0e0"), "{text}");
    assert!(text.ends_with("0 at kinks, 0 beyond the domain, 0 drowned"), "{text}");
}

#[test]
fn a_point_of_the_wrong_length_is_an_error() {
    let error = check_derivatives(&Right::new().unwrap(), &[1.0]).unwrap_err();
    assert_eq!(error.to_string(), "the length of `start` is 1, expected 2");
}

#[mcp_fn]
fn two_scales<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x - 1.0, table(y, -20.0)]
}

#[mcp_fn]
fn drowned<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + y, table(y, -20.0) + x]
}

#[test]
fn a_large_variable_elsewhere_does_not_hide_a_wrong_derivative() {
    let model = TwoScales::new().unwrap();
    assert!(check_derivatives(&model, &[1e15, 1.0]).unwrap().verdict().is_err());
}

#[test]
fn an_entry_drowned_by_other_terms_is_counted_and_not_called_right() {
    let model = Drowned::new().unwrap();
    let report = check_derivatives(&model, &[1e15, 1.0]).unwrap().verdict().unwrap();
    assert_eq!(report.drowned, 2, "∂f[x]/∂y and ∂f[y]/∂y beside 1e15");
    assert!(check_derivatives(&model, &[1.0, 1.0]).unwrap().verdict().is_err());
}

/// Reads `y` only where `x > 1`: a branch on a value, which models must not have.
#[mcp_fn]
fn hidden<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [if x.into_scalar().value() > 1.0 { x + 3.0 * y } else { x }, y]
}

#[test]
fn a_variable_that_is_read_only_sometimes_is_named() {
    let error = check_derivatives(&Hidden::new().unwrap(), &[2.0, 1.0]).unwrap().verdict();
    let message = "`f[x]` depends on `y`, which it did not read when it was recorded";
    assert_eq!(error.unwrap_err().to_string(), message);
}
