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
    let mut sets = active_sets::ActiveSets::new(step_options());
    let unknown = step_problem::Unknown {
        name: "r".to_owned(),
        lower: 0.0,
        upper: f64::INFINITY,
        law: step_problem::Law::Bounds,
    };
    for k in 0..200 {
        assert!(!sets.select(&[k]));
        sets.insert(&[k], std::slice::from_ref(&unknown), &[vec![0]]).unwrap();
        assert!(sets.select(&[k]) && sets.current().is_some());
    }
    assert!(sets.select(&[199]) && sets.select(&[140]) && !sets.select(&[100]));
}
