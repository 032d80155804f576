//! The derivatives of every example model, entry by entry, against num-dual and differences: at
//! random points, at corners of the box, and at huge and tiny ones.
#![allow(dead_code, clippy::print_stdout, reason = "the examples are included whole")]

#[path = "../examples/by_hand.rs"]
mod by_hand;
#[path = "../examples/cournot.rs"]
mod cournot;
#[path = "../examples/insurance.rs"]
mod insurance;
#[path = "../examples/josephy.rs"]
mod josephy;
#[path = "../examples/kojima_shindo.rs"]
mod kojima_shindo;
#[path = "../examples/template.rs"]
mod template;
#[path = "../examples/transport.rs"]
mod transport;
#[path = "../examples/walras.rs"]
mod walras;

use mcp_core::{BoundKind, Model, Shape, check_derivatives};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::path::Path;

/// Points of a box from numbers in `[0, 1]`: `Near` the start, at a `Corner`, or `Far` in
/// magnitude.
#[derive(Clone, Copy, Debug)]
enum Where {
    Near,
    Corner,
    Far,
}

/// One coordinate inside the bounds.
fn coordinate(shape: &Shape, j: usize, place: Where, t: f64) -> f64 {
    let (l, u) = (shape.bounds().lower()[j], shape.bounds().upper()[j]);
    let start = shape.start()[j];
    let free = match place {
        Where::Near => start + (start.abs() + 1.0) * (2.0 * t - 1.0),
        // 1e-12 to 1e12, of either sign where the bounds allow it.
        Where::Far => {
            10_f64.powf(24.0 * (2.0 * t).fract() - 12.0) * if t < 0.5 { 1.0 } else { -1.0 }
        }
        Where::Corner if t < 0.4 => start,
        Where::Corner if t < 0.7 => l,
        Where::Corner => u,
    };
    let inside = |z: f64| if z.is_finite() { z } else { start };
    match shape.bounds().kind(j) {
        BoundKind::Free => inside(free),
        // Mirrored at a bound rather than moved onto it.
        BoundKind::Lower => inside(l + (free - l).abs()),
        BoundKind::Upper => inside(u - (u - free).abs()),
        BoundKind::Boxed | BoundKind::Fixed => inside(free).clamp(l, u),
    }
}

/// Checks the model at many points, the same ones in every run.
fn check(model: &impl Model) {
    let shape = model.shape();
    let at = |z: &[f64]| check_derivatives(model, z).expect("z has the right length").verdict();
    let config = Config { cases: 150, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let places = prop_oneof![Just(Where::Near), Just(Where::Corner), Just(Where::Far)];
    let points = (places, prop::collection::vec(0.0..1.0, shape.n()));
    let outcome = TestRunner::new_with_rng(config, rng).run(&points, |(place, t)| {
        let z: Vec<f64> =
            t.iter().enumerate().map(|(j, &t)| coordinate(shape, j, place, t)).collect();
        match at(&z) {
            Ok(_) => Ok(()),
            Err(wrong) => Err(TestCaseError::fail(format!("{wrong} at {z:?}"))),
        }
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
    let report = at(shape.start()).expect("derivatives are right at the start");
    assert!(2 * (report.beyond_domain + report.kinks) < report.entries, "too little was compared");
}

#[test]
fn transport_has_right_derivatives() {
    let directory = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/transport"));
    check(&transport::Transport::read(directory).unwrap());
}

#[test]
fn kojima_shindo_has_right_derivatives() {
    check(&kojima_shindo::KojimaShindo::new().unwrap());
    check(&kojima_shindo::KojimaShindoByName::builder().build().unwrap());
}

#[test]
fn josephy_has_right_derivatives() {
    check(&josephy::Josephy::new().unwrap());
}

#[test]
fn cournot_has_right_derivatives() {
    check(&cournot::Cournot::new().unwrap());
}

#[test]
fn walras_has_right_derivatives() {
    check(&walras::Walras::new().unwrap());
}

#[test]
fn insurance_has_right_derivatives() {
    check(&insurance::Insurance::new().unwrap());
}

#[test]
fn by_hand_has_right_derivatives() {
    check(&by_hand::Trade::new().unwrap());
}

#[test]
fn template_has_right_derivatives() {
    check(&template::flour().unwrap());
}
