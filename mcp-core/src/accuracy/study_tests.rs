use super::*;
use crate::accuracy::problems;

fn run(case: &Case, edit: impl FnOnce(&mut Setting)) -> Run {
    let mut setting = Setting::default();
    edit(&mut setting);
    Run::new(case, setting, None).unwrap()
}

#[test]
fn names_tell_what_differs() {
    assert_eq!(Setting::default().name(), "robust");
    let other = Setting { method: Method::OldFb, warm: true, tail: false, ..Setting::default() };
    assert_eq!(other.name(), "old_fb, no tail, warm");
}

#[test]
fn every_setting_of_a_study_is_another_and_valid() {
    let case = problems::murty(8).unwrap();
    let all = Setting::all(&case, &TOLERANCES);
    // 5 methods, 4 sources beside jets and none by hand, 4 others.
    assert_eq!(all.len(), TOLERANCES.len() * (5 + 4 + 4));
    for (k, setting) in all.iter().enumerate() {
        assert!(!all[..k].contains(setting));
        assert_eq!(setting.options().validate(), Ok(()));
    }
}

#[test]
fn the_last_digits_of_a_regular_solution_cost_two_iterations() {
    let case = problems::walras(20).unwrap();
    for method in [Method::NewtonFb, Method::NewtonMinFb] {
        let at = |tolerance| run(&case, |s| (s.method, s.tolerance) = (method, tolerance));
        let (loose, tight) = (at(1e-4), at(1e-12));
        assert!(loose.error > 1e-8 && tight.error < 1e-12, "{loose:?} {tight:?}");
        assert!(tight.cost.jacobian <= loose.cost.jacobian + 2);
    }
}

#[test]
fn digits_of_a_double_root_cost_iterations_each() {
    let case = problems::double_root().unwrap();
    let at = |tolerance| run(&case, |s| (s.method, s.tolerance) = (Method::NewtonFb, tolerance));
    let (loose, tight) = (at(1e-4), at(1e-12));
    // A factor 10⁸ by halves.
    assert!(tight.cost.jacobian >= loose.cost.jacobian + 20, "{loose:?} {tight:?}");
    assert!(loose.error > 100.0 * loose.residual, "the error is the root of the residual");
}

#[test]
fn differences_stall_where_a_step_suits_no_two_variables() {
    let case = problems::weak_acid().unwrap();
    assert!(run(&case, |_| ()).is_solved());
    for source in [Source::OneSided, Source::Central] {
        assert!(!run(&case, |s| s.source = source).is_solved(), "{source}");
    }
}

#[test]
fn a_warm_start_costs_less() {
    let case = problems::walras(20).unwrap();
    let (cold, warm) = (run(&case, |_| ()), run(&case, |s| s.warm = true));
    assert!(warm.is_solved() && warm.cost.jacobian < cold.cost.jacobian);
}

#[test]
fn runs_are_timed_if_asked_for() {
    let case = problems::kojima_shindo(true).unwrap();
    let budget = Budget { runs: 3, ..Budget::default() };
    let timed = Run::new(&case, Setting::default(), Some(budget)).unwrap();
    let timing = timed.timing.unwrap();
    assert!(timing.runs == 3 && timing.minimum <= timing.median && timing.minimum > 0.0);
    assert_eq!(run(&case, |_| ()).timing, None);
}
