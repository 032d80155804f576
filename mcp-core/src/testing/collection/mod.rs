//! A collection of 237 problems, 231 of them solvable: MCPLIB-like models, mechanics, KKT systems,
//! networks, linear complementarity problems, badly scaled copies, and problems without solution.
//!
//! The problems are coded from their published definitions, many of them those of MCPLIB
//! ([DF95](crate#references)), of [HS81](crate#references) and of [MGH81](crate#references); names
//! that end in `-like` stand for our own data. What came from a random generator is stored as exact numbers (`data/README.md`).
//!
//! ```
//! use mcp_core::testing::{collection, judge};
//! use mcp_core::{Method, Options, Solver};
//! let josephy = collection::named("josephy-3")?.expect("it is in the collection");
//! let mut solver = Solver::new(Options::new(Method::NewtonMinFb))?;
//! let solution = solver.solve(&mut josephy.problem()?)?;
//! assert!(solution.is_solved());
//! assert!(judge(&josephy, &solution.z)?.accepts());
//! # Ok::<(), mcp_core::ModelError>(())
//! ```
//!
//! | family | instances | what |
//! | --- | --- | --- |
//! | `small` | 74 | classical problems of a few variables, several starts each |
//! | `economics` | 23 | general equilibria, a price game, an energy model |
//! | `physics` | 12 | lubrication, obstacles, torsion, Bratu, contact |
//! | `nlp` | 15 | KKT systems of nonlinear and linear programs, optimal control; one has no solution |
//! | `networks` | 12 | traffic and spatial price equilibria |
//! | `lcps` | 50 | linear complementarity problems, worst cases and random ones |
//! | `scaled` | 46 | problems of the other families in units that differ by up to 10¹⁶ |
//! | `unsolvable` | 5 | no solution exists |

mod archive;
mod economics;
mod energy;
mod exchange;
mod instance;
mod kkt;
mod lcps;
mod lubrication;
mod networks;
mod nlp;
mod physics;
mod pricing;
mod scaled;
mod small;
mod systems;
#[cfg(test)]
mod tests;
mod unsolvable;

pub use instance::Instance;
pub(crate) use small::{TEN_FIRMS, TenFirms, double_root_model, ten_firms_model};
pub(crate) use systems::powell_singular_model;

use crate::error::ModelError;

/// Names of the families, in the order of [`all`].
pub fn families() -> [&'static str; 8] {
    ["small", "economics", "physics", "nlp", "networks", "lcps", "scaled", "unsolvable"]
}

/// The instances of one family; none if there is no such family.
///
/// # Errors
/// None in practice: the problems are well formed.
pub fn family(name: &str) -> Result<Vec<Instance>, ModelError> {
    let Some(family) = families().into_iter().find(|&family| family == name) else {
        return Ok(Vec::new());
    };
    let mut instances = match family {
        "small" => small::instances()?,
        "economics" => economics::instances()?,
        "physics" => physics::instances()?,
        "nlp" => nlp::instances()?,
        "networks" => networks::instances()?,
        "lcps" => lcps::instances()?,
        "scaled" => scaled::instances()?,
        _ => unsolvable::instances()?,
    };
    for instance in &mut instances {
        instance.family = family;
    }
    Ok(instances)
}

/// All instances, family by family.
///
/// # Errors
/// As [`family`].
pub fn all() -> Result<Vec<Instance>, ModelError> {
    families().into_iter().map(family).collect::<Result<Vec<_>, _>>().map(|all| all.concat())
}

/// The instance of that name, such as `josephy-3`, if there is one.
///
/// # Errors
/// As [`family`].
pub fn named(name: &str) -> Result<Option<Instance>, ModelError> {
    Ok(all()?.into_iter().find(|instance| instance.name == name))
}
