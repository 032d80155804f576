//! What models of economies need beyond the language: cost functions, laws, accounts.
//!
//! | item | for |
//! | --- | --- |
//! | [`ces`], [`ces2`], [`cobb`] | unit cost of a nest, for every elasticity of substitution |
//! | [`calibrated_cost`], [`calibrated_demand`] | the same from benchmark quantities and prices |
//! | [`Sam`] | a social accounting matrix from CSV, balanced, as data of a model |
//! | [`check_homogeneous`] | do only relative prices matter? |
//! | [`check_walras`] | does the market clear whose equation was dropped for the numeraire? |
//!
//! A model in calibrated share form has prices 1 at the benchmark and its shares from a [`Sam`]; it is
//! checked in three steps: [`check_point`](crate::check_point) at the benchmark,
//! [`check_homogeneous`], and after a solve [`check_walras`].
//!
//! References: the calibrated share form is that of Rutherford (1999), \[Rut99\]; Walras' law and the
//! choice of a numeraire as in Mathiesen (1985), \[Mat85\]; both in the
//! [list](crate#references).

mod calibrated;
mod homogeneous;
mod nest;
mod sam;
mod walras;

pub use calibrated::{calibrated_cost, calibrated_demand};
pub use homogeneous::{Homogeneity, NotHomogeneous, check_homogeneous};
pub use nest::{ces, ces2, cobb};
pub use sam::{Sam, SamError};
pub use walras::{NoWalras, WalrasCheck, check_walras};
