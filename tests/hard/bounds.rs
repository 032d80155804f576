//! Bounds that are equal, infinite, one unit in the last place apart, crossed, tiny or far away.

use crate::case::{Case, Expect};
use crate::common::{INF, scalar};
use mcp_core::Status;

pub(crate) fn cases() -> Vec<Case> {
    let line = |bounds, start| scalar(bounds, start, |z| (z - 3.0, 1.0));
    let falling = |bounds, start| scalar(bounds, start, |z| (3.0 - z, -1.0));
    let mut cases = Vec::new();
    let mut push = |name: &str, bounds: (f64, f64), solution: f64| {
        for start in [-1e100, -5.0, 0.0, 1e9] {
            let name = format!("{name} from {start:e}");
            let exact = Expect::Near { solutions: vec![vec![solution]], within: f64::EPSILON };
            cases.push(Case::new(name, line(bounds, start), &[start], exact));
        }
    };
    let up = f64::next_up;
    push("fixed at 2", (2.0, 2.0), 2.0);
    push("one ulp above 2", (2.0, up(2.0)), up(2.0));
    push("one ulp above 4", (4.0, up(4.0)), 4.0);
    push("one ulp around 3", (3.0, up(3.0)), 3.0);
    push("one ulp below 3", (f64::next_down(3.0), 3.0), 3.0);
    push("one ulp above 0", (0.0, f64::from_bits(1)), f64::from_bits(1));
    push("a box of 1e-300", (0.0, 1e-300), 1e-300);
    push("a box of 1e-300 around 0", (-1e-300, 1e-300), 1e-300);
    push("a lower bound of 1e15", (1e15, INF), 1e15);
    push("an upper bound of −1e15", (-INF, -1e15), -1e15);
    // 3 − z falls: both ends of the box solve it, and so does the root between them.
    let any = vec![vec![0.0], vec![3.0], vec![10.0]];
    for start in [-1.0, 1.0, 5.0, 20.0] {
        let name = format!("a falling line in a box from {start}");
        let expect = Expect::Near { solutions: any.clone(), within: 1e-9 };
        cases.push(Case::new(name, falling((0.0, 10.0), start), &[start], expect));
    }
    // −1 pushes z up: to the bound if there is one.
    let push_up = |bounds| scalar(bounds, 0.0, |_| (-1.0, 0.0));
    cases.push(Case::at("a force against a far bound", push_up((0.0, 1e12)), &[0.0], &[1e12]));
    let nowhere = Expect::Fails(&[Status::Diverged, Status::SingularSystem]);
    cases.push(Case::new("a force against no bound", push_up((0.0, INF)), &[0.0], nowhere));
    cases
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::solve;
    use mcp_core::{Method, ModelError, Options, Shape};

    #[test]
    fn bounds_hold_to_one_unit_in_the_last_place() {
        crate::check::check_all(cases());
    }

    /// A known limit: the start says how large a variable is, so from −1e100 the answer is right to
    /// `1e-12` of that, which is nothing. The classical methods ask for `1e-10` in the model's units.
    #[test]
    fn an_absurd_start_makes_the_relative_tolerance_absurd() {
        let line = || scalar((-f64::MAX, f64::MAX), -1e100, |z| (z - 3.0, 1.0));
        let relative = solve(&mut line(), &Options::new(Method::Robust));
        assert!(relative.is_solved() && (relative.z[0] - 3.0).abs() <= 1e-12 * 1e100);
        let strict = Options::new(Method::Robust).with(|o| o.tol = Some(1e-10));
        let solution = solve(&mut line(), &strict);
        assert!(!solution.is_solved() || (solution.z[0] - 3.0).abs() <= 1e-10, "{:?}", solution.z);
    }

    #[test]
    fn crossed_undefined_and_impossible_bounds_are_refused_before_any_solve() {
        let bad =
            [(1.0, 0.0), (f64::next_up(2.0), 2.0), (f64::NAN, 1.0), (0.0, f64::NAN), (INF, INF)];
        for (lower, upper) in bad.into_iter().chain([(-INF, -INF)]) {
            let shape = Shape::anonymous(&[lower], &[upper], &[0.0]);
            assert!(shape.is_err(), "[{lower}, {upper}]");
        }
        let start = Shape::anonymous(&[0.0], &[1.0], &[f64::NAN]);
        assert!(matches!(start, Err(ModelError::StartNotFinite { .. })), "{start:?}");
    }
}
