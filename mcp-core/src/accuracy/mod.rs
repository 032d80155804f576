//! What accuracy costs: true errors against counts and seconds (feature `testing`).
//!
//! A study needs solutions that are known better than any solver returns them: a [`Reference`] is a
//! closed form, the solution a problem was [`Manufactured`] for, or the result of Newton's method with
//! `F` in [`DoubleDouble`]. A [`Case`] is a model with such references, a start, and derivatives from
//! every [`Source`]; a [`Run`] solves it in one [`Setting`] and tells the true error, the residuals,
//! the [`Cost`] in counts and, if asked for, seconds. [`problems`] has the cases of
//! `cargo run --release --example accuracy`, whose figures `docs/accuracy.md` explains.
//!
//! ```
//! use mcp_core::accuracy::{Case, Run, Setting};
//! use mcp_core::{Real, Scalar, mcp_fn};
//! /// Two firms share a market.
//! #[mcp_fn(lower = 0.0)]
//! fn duopoly<D: Scalar>([q1, q2]: [Real<D>; 2]) -> [Real<D>; 2] {
//!     [q1.exp() - 10.0 + 2.0 * q1 + q2, 1.0 - 10.0 + q1 + 2.0 * q2]
//! }
//! let case = Case::new("duopoly", Duopoly::new()?).refined()?;
//! assert!(case.references[0].error < 1e-22); // known to 22 digits and more
//! for tolerance in [1e-4, 1e-8, 1e-12] {
//!     let run = Run::new(&case, Setting { tolerance, ..Setting::default() }, None)?;
//!     assert!(run.error < 1e-14 && run.cost.jacobian < 12);
//! }
//! # Ok::<(), mcp_core::accuracy::AccuracyError>(())
//! ```

mod case;
mod cost;
mod derivatives;
mod double_double;
mod error;
#[cfg(feature = "plots")]
pub mod figures;
mod manufactured;
pub mod phi;
pub mod problems;
mod profile;
mod reference;
mod source;
mod study;
mod table;
mod timing;

pub use case::{Arithmetic, Case};
pub use cost::Cost;
pub use derivatives::{DerivativeRun, derivatives};
pub use double_double::DoubleDouble;
pub use error::AccuracyError;
pub use manufactured::{Manufactured, Mix, Place};
pub use profile::{Steps, data_profile, evaluations, performance_profile};
pub use reference::{Origin, Reference};
pub use source::{ByHand, Differences, Scheme, Source};
pub use study::{Run, Setting, TOLERANCES};
pub use table::{csv, table};
pub use timing::{Budget, Timing};
