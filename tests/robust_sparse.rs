//! The stages of the default method on sparse problems: all but pivoting take them.

mod common;
#[path = "../benches/scaling/doubled.rs"]
mod doubled;

use common::solve;
use doubled::Doubled;
use mcp_core::{AdProblem, Method, Options, Robust, Stage, mcp};

mcp! {
    /// A membrane between the floor 0 and a ceiling, with a stiffening spring:
    /// `−Δz + z³/2 + 10 ⟂ 0 <= z <= 1`, `z = 0.3` on the rim.
    model Spring {
        data { nodes: usize, h: f64 }
        var z[i in nodes, j in nodes] in 0.0..=1.0 start 0.3;

        eq force[i in nodes, j in nodes]:
            4.0 * z[i, j] - z.at(i - 1, j).or(0.3) - z.at(i + 1, j).or(0.3)
                - z.at(i, j - 1).or(0.3) - z.at(i, j + 1).or(0.3)
                + h * h * (z[i, j] * z[i, j] * z[i, j] * 0.5 + 10.0)
            complements z[i, j];
    }
}

/// What `edit` switches on and nothing else.
fn alone(edit: impl FnOnce(&mut Robust)) -> Options {
    Options::new(Method::Robust).with(|o| {
        let r = &mut o.robust;
        for budget in [
            &mut r.crash,
            &mut r.josephy_first,
            &mut r.josephy,
            &mut r.semismooth,
            &mut r.sized,
            &mut r.smoothing,
            &mut r.penalised,
            &mut r.boxes,
            &mut r.rescale,
            &mut r.proximal,
            &mut r.starts,
            &mut r.backtracking,
        ] {
            *budget = 0;
        }
        edit(r);
    })
}

#[test]
fn every_stage_but_pivoting_solves_a_sparse_problem_alone() {
    type SwitchOn = fn(&mut Robust, &Robust);
    let nodes = 70;
    let model = Spring::builder().nodes(nodes).h(1.0 / (nodes as f64 + 1.0)).build().unwrap();
    let mut problem = AdProblem::new(&model).unwrap();
    let defaults = Robust::default();
    let stages: [(Stage, SwitchOn); 10] = [
        (Stage::Crash, |r, d| r.crash = d.crash),
        (Stage::Semismooth, |r, d| r.semismooth = d.semismooth),
        (Stage::Sized, |r, d| r.sized = d.sized),
        (Stage::Smoothing, |r, d| r.smoothing = d.smoothing),
        (Stage::Penalised, |r, d| r.penalised = d.penalised),
        (Stage::Boxes, |r, d| r.boxes = d.boxes),
        (Stage::Rescaled, |r, d| r.rescale = d.rescale),
        (Stage::Proximal, |r, d| r.proximal = d.proximal),
        (Stage::Starts, |r, d| r.starts = d.starts),
        (Stage::Backtracking, |r, d| r.backtracking = d.backtracking),
    ];
    for (stage, switch_on) in stages {
        let solution = solve(&mut problem, &alone(|r| switch_on(r, &defaults)));
        let ended_by = solution.stages.last().map(|record| record.stage);
        assert!(solution.is_solved(), "{stage}: {}", solution.status);
        assert_eq!(ended_by, Some(stage));
    }
}

#[test]
fn levenberg_marquardt_solves_a_sparse_problem_whose_matrix_is_singular() {
    let model = Doubled::on(70).unwrap();
    let mut problem = AdProblem::new(&model).unwrap();
    let options = alone(|r| r.semismooth = Robust::default().semismooth);
    let solution = solve(&mut problem, &options);
    assert!(solution.is_solved(), "{}", solution.status);
    assert!(solution.stats.iterations < 12, "{}", solution.stats.iterations);
    let without = options.with(|o| o.robust.levenberg_marquardt = 0);
    let by_gradient = solve(&mut problem, &without).stats;
    assert!(by_gradient.iterations > 2 * solution.stats.iterations, "{}", by_gradient.iterations);
}
