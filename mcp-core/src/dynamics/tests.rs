//! Steppers: what they refuse, what they say when a step fails, and small systems in closed form.

use super::*;
use crate::solver::Status;

fn circuit(elements: &[(&str, ElementKind, &str, &str)]) -> Circuit {
    let mut circuit = Circuit::new();
    for &(name, kind, from, to) in elements {
        let (name, from, to) = (name.to_owned(), from.to_owned(), to.to_owned());
        circuit.add(Element { name, kind, from, to }).unwrap();
    }
    circuit
}

fn run(stepper: &mut dyn TimeStepper, steps: usize) {
    for _ in 0..steps {
        stepper.step().unwrap();
    }
}

#[test]
fn a_step_without_solution_names_time_and_unknowns() {
    // −1 ⟂ λ >= 0 has no solution.
    let mut system = ComplementaritySystem::new(["x"], &[0.0], &[vec![0.0]]).unwrap();
    let wall = Pair::new("wall", [0.0], [0.0]).offset(-1.0).within(0.0, f64::INFINITY);
    system.pair(wall).unwrap();
    let mut stepper = EulerMoreau::new(&system, 0.1, 0.5, &step_options()).unwrap();
    for _ in 0..2 {
        match stepper.step().unwrap_err() {
            DynamicsError::NotSolved { step, time, active, status, .. } => {
                assert_eq!((step, time, active.as_str()), (1, 0.1, "wall"));
                assert_ne!(status, Status::Solved);
            }
            other => panic!("{other}"),
        }
        assert_eq!(stepper.state()[0], 0.0);
    }
}

#[test]
fn a_state_that_overflows_is_named() {
    let system = ComplementaritySystem::new(["x"], &[1e300], &[vec![1e10]]).unwrap();
    let mut stepper = EulerMoreau::new(&system, 1.0, 0.0, &step_options()).unwrap();
    let error = stepper.step().unwrap_err();
    assert_eq!(error, DynamicsError::NotFinite { name: "x".to_owned(), time: 1.0 });
}

#[test]
fn numbers_out_of_range_are_refused_by_name() {
    let said = |error: DynamicsError| error.to_string();
    let mut system = Mechanics::new();
    let error = system.add_body(&Body::new("ball", -1.0)).unwrap_err();
    assert_eq!(said(error), "the mass of ball is -1, but must be a positive number");
    let ball = system.add_body(&Body::new("ball", 1.0).moving(Axis::Y, 0.0, 0.0)).unwrap();
    let link = Link { axis: Axis::X, body: ball, to: None, coefficient: 1.0, rest: 0.0 };
    let error = system.add_spring(link).unwrap_err();
    assert_eq!(said(error), "a spring needs the coordinate ball.x");
    let floor = Obstacle::Plane { normal: [0.0, 0.0], offset: 0.0 };
    let error = system.add_contact(Contact::new("floor", ball, floor)).unwrap_err();
    assert_eq!(said(error), "the normal of floor is 0, but must be a positive number");
    for h in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let stepper = MoreauJean::new(system.clone(), Scheme::new(h), &step_options());
        assert!(matches!(stepper.err(), Some(DynamicsError::OutOfRange { .. })), "{h}");
    }
    assert!(ComplementaritySystem::new(["x"], &[0.0], &[vec![0.0, 1.0]]).is_err());
    let singular = ComplementaritySystem::new(["x"], &[0.0], &[vec![2.0]]).unwrap();
    let error = EulerMoreau::new(&singular, 1.0, 0.5, &step_options()).err();
    assert!(matches!(error, Some(DynamicsError::Linear(_))), "{error:?}");
}

#[test]
fn a_circuit_discharges_as_in_closed_form() {
    // R C u' = −u by the implicit midpoint rule: u (1 − h/2RC)/(1 + h/2RC) each step.
    let parts = [
        ("C", ElementKind::Capacitor(0.5, 3.0), "a", "g"),
        ("R", ElementKind::Resistor(4.0), "a", "g"),
    ];
    let system = circuit(&parts).system().unwrap();
    let mut stepper = EulerMoreau::new(&system, 0.1, 0.5, &step_options()).unwrap();
    run(&mut stepper, 20);
    let factor: f64 = (1.0 - 0.1 / 4.0) / (1.0 + 0.1 / 4.0);
    assert!((stepper.state()[0] - 3.0 * factor.powi(20)).abs() < 1e-14);
}

#[test]
fn a_source_charges_a_capacitor_through_a_diode_and_not_back() {
    for (from, to, last) in [("s", "d", 5.0), ("d", "s", 0.0)] {
        let parts = [
            ("V", ElementKind::Source(5.0), "s", "g"),
            ("D", ElementKind::Diode, from, to),
            ("R", ElementKind::Resistor(1.0), "d", "c"),
            ("C", ElementKind::Capacitor(1.0, 0.0), "c", "g"),
        ];
        let system = circuit(&parts).system().unwrap();
        assert_eq!(system.pair_count(), 1);
        let mut stepper = EulerMoreau::new(&system, 0.1, 0.5, &step_options()).unwrap();
        run(&mut stepper, 1000);
        assert!((stepper.state()[0] - last).abs() < 1e-9, "{:?}", stepper.state());
    }
}

#[test]
fn a_circuit_that_determines_nothing_is_refused() {
    let source = ElementKind::Source(5.0);
    let loops = [("V", source, "a", "g"), ("C", ElementKind::Capacitor(1.0, 0.0), "a", "g")];
    let coil = |i| ElementKind::Inductor(1.0, i);
    let node = [("L", coil(0.0), "a", "b"), ("M", coil(0.0), "b", "a")];
    let star = [
        ("L", coil(1.0), "a", "b"),
        ("M", coil(1.0), "b", "c"),
        ("R", ElementKind::Resistor(1.0), "c", "a"),
    ];
    for circuit in [circuit(&loops), circuit(&node), circuit(&star), Circuit::new()] {
        let error = circuit.system().unwrap_err();
        assert!(matches!(error, DynamicsError::Circuit { .. }), "{error}");
    }
}

#[test]
fn a_part_of_a_circuit_needs_no_connection() {
    let parts = [
        ("R", ElementKind::Resistor(1.0), "a", "g"),
        ("C", ElementKind::Capacitor(1.0, 2.0), "c", "d"),
        ("S", ElementKind::Resistor(2.0), "c", "d"),
    ];
    let system = circuit(&parts).system().unwrap();
    let mut stepper = EulerMoreau::new(&system, 0.1, 1.0, &step_options()).unwrap();
    stepper.step().unwrap();
    assert!((stepper.state()[0] - 2.0 / 1.05).abs() < 1e-15);
}

#[test]
fn two_balls_of_one_mass_exchange_their_velocities() {
    let mut system = Mechanics::new();
    let ball = |name: &str, x, v| Body::new(name, 2.0).radius(0.1).moving(Axis::X, x, v);
    let a = system.add_body(&ball("a", 0.0, 1.0)).unwrap();
    let b = system.add_body(&ball("b", 1.0, -0.5)).unwrap();
    system.add_contact(Contact::new("ab", a, Obstacle::Body(b)).restitution(1.0)).unwrap();
    let mut stepper = MoreauJean::new(system, Scheme::new(0.01), &step_options()).unwrap();
    run(&mut stepper, 100);
    let v = stepper.velocities();
    assert!((v[0] + 0.5).abs() < 1e-12 && (v[1] - 1.0).abs() < 1e-12, "{v:?}");
}

#[test]
fn sets_of_contacts_beyond_those_remembered_are_built_again() {
    let mut sets = active_sets::ActiveSets::default();
    let unknown = step_problem::Unknown {
        name: "r".to_owned(),
        lower: 0.0,
        upper: f64::INFINITY,
        law: step_problem::Law::Bounds,
    };
    let mut built = 0;
    let mut select = |k| {
        let before = built;
        let build = || {
            built += 1;
            step_problem::StepProblem::new(
                std::slice::from_ref(&unknown),
                &[vec![0]],
                &step_options(),
            )
        };
        sets.select(&[k], build).unwrap();
        built > before
    };
    for k in 0..200 {
        assert!(select(k) && !select(k));
    }
    assert!(!select(199) && !select(140) && select(100));
}

/// A body that falls, one that falls and turns, and one that moves in the plane.
fn three_bodies() -> (Mechanics, [BodyId; 3]) {
    let mut system = Mechanics::new();
    let falling = |name: &str| Body::new(name, 1.0).radius(0.5).moving(Axis::Y, 1.0, 0.0);
    let bodies = [
        falling("drop"),
        falling("wheel").turning(0.1, 0.0, 0.0),
        falling("ball").moving(Axis::X, 0.0, 0.0),
    ];
    let bodies = bodies.map(|body| system.add_body(&body).unwrap());
    (system, bodies)
}

#[test]
fn friction_is_refused_where_nothing_can_slip() {
    let (system, [drop, wheel, ball]) = three_bodies();
    let floor = Obstacle::Plane { normal: [0.0, 1.0], offset: 0.0 };
    let add = |body, with| {
        let contact = Contact::new("floor", body, with).friction(0.1);
        system.clone().add_contact(contact)
    };
    let refused = |error: Result<(), DynamicsError>| {
        matches!(error, Err(DynamicsError::NoMotion { direction: "tangent", .. }))
    };
    assert!(refused(add(drop, floor)));
    assert!(add(wheel, floor).is_ok() && add(ball, floor).is_ok());
    assert!(add(drop, Obstacle::Body(wheel)).is_ok());
    assert!(add(drop, Obstacle::Body(ball)).is_ok());
    let mut two = Mechanics::new();
    let [a, b] = ["a", "b"].map(|name| {
        two.add_body(&Body::new(name, 1.0).radius(0.1).moving(Axis::X, 0.0, 0.0)).unwrap()
    });
    let contact = Contact::new("ab", a, Obstacle::Body(b));
    assert!(refused(two.clone().add_contact(contact.clone().friction(0.1))));
    assert!(two.add_contact(contact).is_ok());
}

#[test]
fn a_contact_or_joint_along_which_nothing_can_move_is_refused() {
    let (mut system, [drop, _, _]) = three_bodies();
    let wall = Obstacle::Plane { normal: [1.0, 0.0], offset: 0.0 };
    let error = system.add_contact(Contact::new("wall", drop, wall)).unwrap_err();
    let said = "wall acts along its normal, where its bodies cannot move";
    assert_eq!(error.to_string(), said);
    let rail = Joint::new("rail", drop, Hold::Rail([1.0, 0.0]));
    let error = system.add_joint(rail).unwrap_err();
    assert!(matches!(error, DynamicsError::NoMotion { direction: "normal", .. }));
}

#[test]
fn nothing_is_between_a_body_and_itself() {
    let (mut system, [drop, _, _]) = three_bodies();
    let link = Link { axis: Axis::Y, body: drop, to: Some(drop), coefficient: 1.0, rest: 0.0 };
    for (error, what) in [
        (system.add_contact(Contact::new("c", drop, Obstacle::Body(drop))), "c"),
        (system.add_joint(Joint::new("j", drop, Hold::Body(drop))), "j"),
        (system.add_spring(link), "a spring"),
        (system.add_damper(link), "a damper"),
    ] {
        assert_eq!(error.unwrap_err().to_string(), format!("{what} is between drop and itself"));
    }
}

#[test]
fn names_are_unique_when_they_are_given() {
    let twice = |error: Result<(), DynamicsError>, name: &str| {
        assert_eq!(error, Err(DynamicsError::NameTwice { name: name.to_owned() }));
    };
    let (mut system, [drop, wheel, ball]) = three_bodies();
    twice(system.add_body(&Body::new("drop", 1.0)).map(forget), "drop");
    let floor = Obstacle::Plane { normal: [0.0, 1.0], offset: 0.0 };
    system.add_contact(Contact::new("a", ball, floor).friction(0.1)).unwrap();
    twice(system.add_contact(Contact::new("a", wheel, floor)), "a");
    twice(system.add_contact(Contact::new("a friction", drop, floor)), "a friction");
    system.add_joint(Joint::new("b", ball, Hold::Anchor([0.0, 0.0]))).unwrap();
    twice(system.add_contact(Contact::new("b", drop, floor)), "b");
    twice(system.add_joint(Joint::new("a friction", drop, Hold::Rail([0.0, 1.0]))), "a friction");

    let mut relays = ComplementaritySystem::new(["x"], &[0.0], &[vec![0.0]]).unwrap();
    twice(relays.pair(Pair::new("x", [1.0], [1.0])).map(forget), "x");
    relays.twisting("u", 0.1, [vec![1.0], vec![1.0]], [vec![1.0], vec![1.0]]).unwrap();
    twice(relays.pair(Pair::new("u.mu3", [1.0], [1.0])).map(forget), "u.mu3");
    let states = ComplementaritySystem::new(["x", "x"], &[0.0; 2], &[vec![0.0; 2], vec![0.0; 2]]);
    twice(states.map(forget), "x");
}

/// Forgets what was added.
fn forget<T>(_: T) {}

#[test]
fn bounds_that_no_multiplier_satisfies_are_refused() {
    let mut relays = ComplementaritySystem::new(["x"], &[0.0], &[vec![0.0]]).unwrap();
    for (lower, upper) in
        [(1.0, -1.0), (f64::NAN, 1.0), (0.0, f64::NAN), (f64::INFINITY, f64::INFINITY)]
    {
        let pair = Pair::new("s", [1.0], [1.0]).within(lower, upper);
        let error = relays.pair(pair).unwrap_err();
        assert!(matches!(error, DynamicsError::OutOfRange { .. }), "{error}");
    }
}

#[test]
fn active_are_the_relays_that_slide() {
    // x' = λ from 0.25 with h = 0.1: two steps at the bound, then x = 0 is held.
    let mut system = ComplementaritySystem::new(["x"], &[0.25], &[vec![0.0]]).unwrap();
    system.pair(Pair::new("s", [1.0], [1.0]).within(-1.0, 1.0)).unwrap();
    let mut stepper = EulerMoreau::new(&system, 0.1, 0.5, &step_options()).unwrap();
    let reports = [0; 5].map(|_| stepper.step().unwrap());
    assert_eq!(reports.map(|report| report.active), [0, 0, 1, 1, 1]);
    assert_eq!(reports.map(|report| report.unknowns), [1; 5]);
}

#[test]
fn coupled_masses_accelerate_as_their_matrix_says() {
    // Three masses with springs 0–1, 1–2, 0–2 and θ = 1: M̂ v⁺ = M v + h f(q, v⁺) by substitution.
    let (mut system, h) = (Mechanics::new(), 0.1);
    let masses = [1.0, 2.0, 3.0];
    let bodies = [0, 1, 2].map(|k: u8| {
        let body = Body::new(k.to_string(), masses[usize::from(k)]);
        system.add_body(&body.moving(Axis::X, f64::from(k * k), 0.5)).unwrap()
    });
    let springs = [(0, 1, 7.0), (1, 2, 5.0), (0, 2, 3.0)];
    for (a, b, k) in springs {
        let (body, to) = (bodies[a], Some(bodies[b]));
        system.add_spring(Link { axis: Axis::X, body, to, coefficient: k, rest: 0.0 }).unwrap();
    }
    let scheme = Scheme { theta: 1.0, ..Scheme::new(h) };
    let mut stepper = MoreauJean::new(system, scheme, &step_options()).unwrap();
    let v = [0.5; 3];
    stepper.step().unwrap();
    let (q, next) = (stepper.positions(), stepper.velocities());
    for i in 0..3 {
        let pull = |&(a, b, k): &(usize, usize, f64)| match i {
            _ if i == a => -k * (q[a] - q[b]),
            _ if i == b => k * (q[a] - q[b]),
            _ => 0.0,
        };
        let force: f64 = springs.iter().map(pull).sum();
        assert!((masses[i] * (next[i] - v[i]) - h * force).abs() < 1e-13, "{i}");
    }
}
