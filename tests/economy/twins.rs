//! An effect that is off costs nothing: the economy with some of its parts on, and a text that never
//! heard of the others, have the same unknowns, equations, parameters, nonzeros and operations, and
//! take the same path to the solution, bit for bit.

use super::economy::data::{CIF, FOB, HOURS, HOUSEHOLDS, LABOR, REFERENCE, SECTORS, SHARE, TRADED};
use super::economy::effect::Effect;
use super::texts::text;
use super::{economy_with, sample};
use mcp_core::economics::cobb;
use mcp_core::{AdProblem, Iteration, Model, Options, Problem, Solver, mcp};
use std::ops::ControlFlow;

/// All iterates of a solve, and `F` there.
fn path<M: Model>(problem: &mut AdProblem<M>) -> Vec<[Vec<u64>; 2]> {
    let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect();
    let mut path = Vec::new();
    let mut keep = |iteration: &Iteration<'_>| {
        path.push([bits(iteration.z), bits(iteration.f)]);
        ControlFlow::Continue(())
    };
    let mut solver = Solver::new(Options::default()).unwrap();
    let solution = solver.solve_monitored(problem, None, &mut keep).unwrap();
    assert!(solution.is_solved(), "{}", solution.status);
    path
}

/// Names of variables with their equations, of definitions, and of parameters with their values.
type Names = (Vec<(String, String)>, Vec<String>, Vec<(String, usize)>, Vec<f64>);

fn names<M: Model>(problem: &AdProblem<M>) -> Names {
    let shape = problem.shape();
    let pair = |i| (shape.variable_name(i), shape.equation_name(i));
    let families = shape.parameters().iter().filter(|family| !family.is_empty());
    (
        (0..shape.n()).map(pair).collect(),
        (0..shape.definition_count()).map(|k| shape.definition_name(k)).collect(),
        families.map(|family| (family.name().to_owned(), family.len())).collect(),
        shape.parameter_values().to_vec(),
    )
}

/// Both models have the same unknowns, parameters, nonzeros, operations and iterates.
pub(crate) fn assert_twins(case: &str, one: &impl Model, other: &impl Model) {
    let mut one = AdProblem::new(one).unwrap();
    let mut other = AdProblem::new(other).unwrap();
    assert_eq!(names(&one), names(&other), "{case}");
    assert_eq!(one.pattern(), other.pattern(), "{case}");
    assert_eq!(one.operations(), other.operations(), "{case}");
    assert_eq!(one.jacobian_operations(), other.jacobian_operations(), "{case}");
    assert_eq!(path(&mut one), path(&mut other), "{case}");
}

/// Hands the data of an effect to the builder of a text.
macro_rules! given {
    ($builder:ident tax) => {
        $builder.tax_rate(sample::TAX).tax_to(sample::TO_BOTH)
    };
    ($builder:ident tariff) => {
        $builder.duty_rate(sample::DUTY).duty_to(sample::TO_BOTH)
    };
    ($builder:ident quota) => {
        $builder.import_limit(sample::QUOTA).licences_to(sample::TO_MERCHANTS)
    };
    ($builder:ident emission_cap) => {
        $builder
            .emission_limit(sample::EMISSIONS)
            .intensity(sample::INTENSITY)
            .permits_to(sample::TO_BOTH)
    };
    ($builder:ident markup) => {
        $builder.markup_rate(sample::MARKUP).profits_to(sample::TO_MERCHANTS)
    };
    ($builder:ident rationing) => {
        $builder.ration(sample::RATION)
    };
}

/// The economy with these effects and the text that knows these alone are twins.
macro_rules! assert_text_is_twin {
    ($($effect:ident)*) => {{
        text!(Twin $($effect [+ , ;])*);
        let builder = Twin::builder()
            .households(HOUSEHOLDS)
            .sectors(SECTORS)
            .traded(TRADED)
            .labor(LABOR)
            .share(SHARE)
            .hours(HOURS)
            .cif(CIF)
            .fob(FOB)
            .reference(REFERENCE);
        $(let builder = given!(builder $effect);)*
        let twin = builder.build().unwrap();
        assert_twins(stringify!($($effect)*), &economy_with(&[$(sample::$effect()),*]), &twin);
    }};
}

#[test]
fn an_effect_that_is_off_costs_nothing() {
    assert_text_is_twin!();
    assert_text_is_twin!(tax);
    assert_text_is_twin!(tariff);
    assert_text_is_twin!(quota);
    assert_text_is_twin!(emission_cap);
    assert_text_is_twin!(markup);
    assert_text_is_twin!(rationing);
    assert_text_is_twin!(tax tariff quota emission_cap markup rationing);
}

#[test]
fn two_effects_cost_what_the_two_cost() {
    assert_text_is_twin!(tax tariff);
    assert_text_is_twin!(tax quota);
    assert_text_is_twin!(tax emission_cap);
    assert_text_is_twin!(tax markup);
    assert_text_is_twin!(tax rationing);
    assert_text_is_twin!(tariff quota);
    assert_text_is_twin!(tariff emission_cap);
    assert_text_is_twin!(tariff markup);
    assert_text_is_twin!(tariff rationing);
    assert_text_is_twin!(quota emission_cap);
    assert_text_is_twin!(quota markup);
    assert_text_is_twin!(quota rationing);
    assert_text_is_twin!(emission_cap markup);
    assert_text_is_twin!(emission_cap rationing);
    assert_text_is_twin!(markup rationing);
}

/// Unknowns, nonzeros and operations.
fn size(effects: &[Effect]) -> (usize, usize, u64) {
    let problem = AdProblem::new(economy_with(effects)).unwrap();
    (problem.shape().n(), problem.pattern().nnz(), problem.operations().total())
}

#[test]
fn an_effect_that_is_on_costs_something() {
    let base = size(&[]);
    for (effect, unknowns) in sample::all().into_iter().zip([1, 0, 1, 1, 0, 2]) {
        let size = size(std::slice::from_ref(&effect));
        assert_eq!(size.0, base.0 + unknowns, "{effect:?}");
        assert!(size.1 > base.1 && size.2 > base.2, "{effect:?}: {size:?}, {base:?}");
    }
}

#[test]
fn the_order_in_which_effects_are_named_changes_nothing() {
    let all = sample::all();
    let mut orders = vec![all.iter().rev().cloned().collect::<Vec<_>>()];
    for k in 1..all.len() {
        let mut order = all.to_vec();
        order.rotate_left(k);
        orders.push(order);
    }
    for order in &orders {
        assert_twins(&format!("{order:?}"), &economy_with(&all), &economy_with(order));
    }
    for first in &all {
        for second in &all {
            if first != second {
                let [one, other] = [[first, second], [second, first]]
                    .map(|effects| economy_with(&effects.map(Effect::clone)));
                assert_twins(&format!("{first:?}, {second:?}"), &one, &other);
            }
        }
    }
}
