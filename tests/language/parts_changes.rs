//! What was changed by name, and what parts make of it.

use mcp_core::{Model, ModelError, Options, Report, mcp, solve};

mcp! {
    /// A tank whose inflow is what the parts make it.
    model Tank {
        data { stages: Set }
        param scale = 2.0;
        var level[s in stages] >= 0.0 start 1.0;
        var flow free start 3.0;
        def demand lifted: scale * flow;
        def loss lifted: 10.0 * demand;
        eq balance[s in stages]: level[s] + loss - demand     complements level[s];
        eq inflow: flow - 0.5                                 complements flow;
        part leak { param rate = 0.25; adds demand: rate * flow; report lost: rate * flow; }
        part seep { adds demand: -0.5 * flow; adds loss: flow; }
        part pump { fix flow = 7.0; fix level[s in stages] = 4.0; }
        part valve { fix flow = 8.0; }
        part gate { fix flow = 9.0; }
        part store {
            data { size: f64 }
            var stored[s in stages] >= 0.0 start 2.0;
            def full: size - sum(stages, |s| stored[s]);
            eq fill[s in stages]: stored[s] - size            complements stored[s];
        }
    }
}

fn tank() -> Tank {
    Tank::builder().stages(["a", "b"]).build().unwrap()
}

fn start(model: &impl Model, name: &str) -> f64 {
    model.shape().start()[model.shape().variable_index(name).unwrap()]
}

fn said<T>(result: Result<T, ModelError>) -> String {
    result.err().expect("it is refused").to_string()
}

#[test]
fn what_a_part_fixes_starts_there_and_without_the_part_where_it_was_told() {
    let mut base = tank();
    base.set_start_of("flow", 5.0).unwrap();
    base.set_start_of("level[b]", 6.0).unwrap();
    base.set_upper("level[b]", 20.0).unwrap();
    let fixed = base.with(Pump).unwrap();
    assert_eq!(fixed.shape().start()[..3], [4.0, 4.0, 7.0]);
    assert_eq!(fixed.shape().bounds().upper()[..3], [4.0, 4.0, 7.0]);
    for without in [&base, &base.with(Leak).unwrap()] {
        assert_eq!(without.shape().start()[..3], [1.0, 6.0, 5.0]);
        assert_eq!(without.shape().bounds().upper()[..2], [f64::INFINITY, 20.0]);
    }
}

#[test]
fn what_was_fixed_by_name_is_not_fixed_by_a_part() {
    let mut base = tank();
    base.fix("level[b]", 4.0).unwrap();
    assert_eq!(
        said(base.with(Pump)),
        "`level[b]` was fixed by name, and the part `pump` fixes it: fix it by name after the part is \
         on, or not at all"
    );
    assert!(base.with(Valve).is_ok());
    let mut after = tank().with(Pump).unwrap();
    after.fix("level[b]", 5.0).unwrap();
    let more = after.with(Leak).unwrap();
    assert_eq!(more.shape().bounds().lower()[..3], [4.0, 5.0, 7.0]);
    assert_eq!(more.shape().start()[..3], [4.0, 5.0, 7.0]);
}

#[test]
fn of_three_parts_that_fix_an_element_two_are_named() {
    let twice = "`flow` is fixed twice, by the part `pump` and by the part `valve`";
    assert_eq!(said(tank().with((Gate, Valve, Pump))), twice);
    assert_eq!(said(tank().with((Valve, Gate, Pump))), twice);
    assert_eq!(
        said(tank().with(Gate).unwrap().with(Valve)),
        "`flow` is fixed twice, by the part `valve` and by the part `gate`"
    );
}

#[test]
fn lifted_definitions_start_where_they_hold_with_what_was_changed() {
    let mut base = tank();
    assert_eq!((start(&base, "demand"), start(&base, "loss")), (6.0, 60.0));
    base.set_parameter("scale", &[3.0]).unwrap();
    base.set_start_of("flow", 4.0).unwrap();
    // (3 + 1/4) 4, and ten times as much.
    let leaking = base.with(Leak).unwrap();
    assert_eq!((start(&leaking, "demand"), start(&leaking, "loss")), (13.0, 130.0));
    let mut leaking = leaking;
    leaking.set_parameter("rate", &[1.0]).unwrap();
    let stored = leaking.with(Store { size: 1 }).unwrap();
    assert_eq!((start(&stored, "demand"), start(&stored, "loss")), (16.0, 160.0));
    // With the flow that the part fixes.
    let pumped = leaking.with(Pump).unwrap();
    assert_eq!((start(&pumped, "demand"), start(&pumped, "loss")), (28.0, 280.0));
}

#[test]
fn terms_of_several_parts_belong_to_the_start_of_a_lifted_definition() {
    for seeping in [tank().with((Seep, Leak)), tank().with(Leak).unwrap().with(Seep)] {
        let seeping = seeping.unwrap();
        // (2 + 1/4 − 1/2) 3, and ten times as much and the flow.
        assert_eq!((start(&seeping, "demand"), start(&seeping, "loss")), (5.25, 55.5));
    }
}

#[test]
fn a_start_of_a_lifted_definition_stays_where_it_was_put() {
    for told in [0.0, 5.0] {
        let mut base = tank();
        base.set_start_of("demand", told).unwrap();
        let one = base.with(Leak).unwrap();
        let two = one.with(Store { size: 1 }).unwrap();
        for model in [&one, &two] {
            assert_eq!((start(model, "demand"), start(model, "loss")), (told, 10.0 * told));
        }
    }
}

#[test]
fn one_part_after_the_other_starts_as_both_at_once() {
    let mut base = tank();
    base.set_parameter("scale", &[0.3]).unwrap();
    base.set_upper("level", 0.125).unwrap();
    let at_once = base.with((Store { size: 1 }, Leak)).unwrap();
    let in_turn = base.with(Store { size: 1 }).unwrap().with(Leak).unwrap();
    let bits = |model: &Tank| model.shape().start().iter().map(|z| z.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&at_once), bits(&in_turn));
    assert_eq!(in_turn.shape().start()[..2], [0.125; 2]);
}

#[test]
fn a_name_of_a_part_that_is_off_is_answered_with_the_part() {
    let off = |name: &str, part: &str| {
        format!("`{name}` exists only with the part `{part}`, which is off")
    };
    let mut base = tank();
    assert_eq!(said(base.set_parameter("rate", &[0.1])), off("rate", "leak"));
    assert_eq!(said(base.fix("stored[a]", 0.0)), off("stored", "store"));
    assert_eq!(said(base.set_start_of("stored", 0.0)), off("stored", "store"));
    assert_eq!(said(base.shape().definition("full")), off("full", "store"));
    assert_eq!(said(base.set_upper("stord", 0.0)), "there is no variable `stord`");
    assert_eq!(said(mcp_core::study::sweep(&base, "rate", &[0.1])), off("rate", "leak"));
    let solution = solve(&base, &Options::default()).unwrap().solved().unwrap();
    assert_eq!(said(solution.level("stored[a]")), off("stored", "store"));
    let mut on = base.with((Leak, Store { size: 1 })).unwrap();
    assert_eq!(on.set_parameter("rate", &[0.1]), Ok(()));
    assert_eq!(said(on.set_lower("rate", 0.0)), "there is no variable `rate`");
}

#[test]
fn the_shape_knows_the_parts_that_are_on_and_reports_name_them() {
    let base = tank();
    let on = base.with((Store { size: 1 }, Leak)).unwrap();
    assert_eq!(base.shape().parts(), [""; 0]);
    assert_eq!(on.shape().parts(), ["leak", "store"]);
    let report = |model: &Tank| {
        let solution = solve(model, &Options::default()).unwrap().solved().unwrap();
        let mut problem = mcp_core::AdProblem::new(model.clone()).unwrap();
        Report::new(&mut problem, &solution).unwrap()
    };
    let (without, with) = (report(&base), report(&on));
    assert!(with.to_string().contains("\nparts: leak, store\n"), "{with}");
    assert!(!without.to_string().contains("parts"), "{without}");
    assert!(!without.to_string().contains("lost"), "{without}");
    let changes = mcp_core::study::compare(&without, &with);
    assert!(changes.to_string().contains("parts: - → leak, store"), "{changes}");
    let only: Vec<&str> = changes.only_after.iter().map(|lone| &lone.name[..]).collect();
    assert_eq!(only, ["stored[a]", "stored[b]", "lost", "full"]);
    let mut problem = mcp_core::AdProblem::new(on).unwrap();
    let statement = mcp_core::Statement::new(&mut problem);
    assert_eq!(statement.parts, ["leak", "store"]);
    assert!(statement.to_string().contains("\nparts: leak, store\n"), "{statement}");
}
