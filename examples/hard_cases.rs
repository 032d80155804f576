//! # Hard cases: what is solved, and what is said where nothing can be
//!
//! One line for each hard case of `tests/hard`: what must come out, then what each method answers:
//! `ok` with the residual where the answer is right, the status otherwise, `WRONG` for a false claim.
//! The program fails if `Robust` misses an expectation or any method claims what is not.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{Method, Solution};

#[path = "../tests/hard/bounds.rs"]
mod bounds;
#[path = "../tests/hard/case.rs"]
mod case;
#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/hard/cycling.rs"]
mod cycling;
#[path = "../tests/hard/degenerate.rs"]
mod degenerate;
#[path = "../tests/hard/families.rs"]
mod families;
#[path = "../tests/hard/kinks.rs"]
mod kinks;
#[path = "../tests/hard/overflow.rs"]
mod overflow;
#[path = "../tests/hard/powers.rs"]
mod powers;
#[path = "../tests/hard/scaling.rs"]
mod scaling;
#[path = "../tests/hard/several.rs"]
mod several;
#[path = "../tests/hard/singular.rs"]
mod singular;
#[path = "../tests/hard/traps.rs"]
mod traps;
#[path = "../tests/hard/weak.rs"]
mod weak;

use case::Case;

/// What a method made of a case, in one word.
fn outcome(case: &Case, solution: &Solution) -> String {
    let residual = solution.certificate.natural_residual;
    match () {
        () if case.is_false_claim(solution) => "WRONG".to_owned(),
        () if solution.is_solved() => format!("ok {residual:.0e}"),
        () => solution.status.name().to_owned(),
    }
}

fn main() {
    let groups = [
        ("degenerate pairs", degenerate::cases()),
        ("traps of the merit", traps::cases()),
        ("cycling of the plain method", cycling::cases()),
        ("ill-conditioned families", families::cases()),
        ("other units", scaling::cases()),
        ("singular Jacobians", singular::cases()),
        ("bounds", bounds::cases()),
        ("powers at zero", powers::cases()),
        ("overflow and walls", overflow::cases()),
        ("kinks in F", kinks::cases()),
        ("several solutions and none", several::cases()),
        ("weakly active pairs", weak::cases()),
    ];
    let (mut met, mut total, mut wrong) = ([0; Method::ALL.len()], 0, 0);
    for (group, cases) in groups {
        print!("\n{group:<40} {:<18}", "expected");
        for method in Method::ALL {
            print!(" {:<21}", method.name());
        }
        println!();
        for mut case in cases {
            total += 1;
            print!("{:<40} {:<18}", case.name, case.expectation());
            for (m, method) in Method::ALL.into_iter().enumerate() {
                let solution = case.solve(method);
                met[m] += usize::from(case.is_met_by(&solution));
                wrong += usize::from(case.is_false_claim(&solution));
                print!(" {:<21}", outcome(&case, &solution));
            }
            println!();
        }
    }
    println!();
    for (method, met) in Method::ALL.into_iter().zip(met) {
        println!("{method:?}: {met} of {total} as expected");
    }
    println!("false claims: {wrong}");
    assert_eq!(met[0], total, "Robust answers every hard case as expected");
    assert_eq!(wrong, 0);
}
