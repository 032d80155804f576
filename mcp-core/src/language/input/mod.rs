//! What a user gives a model: labels for its sets, numbers for its tables.
//!
//! | declared | given | made of it |
//! | --- | --- | --- |
//! | `Set`, `Ordered` | [`Labels`] | a [`Set`](crate::Set) |
//! | `Subset(a)` | [`LabelSubset`] | positions in `a` |
//! | `Pairs(a, b)` | [`LabelPairs`] | a [`Set`](crate::Set) and the positions of both ends |
//! | `Map(a, b)` | [`LabelMap`] | for each element of `a` its position in `b` |
//! | `f64` over sets | [`Table`] | numbers, the last index running fastest |
//!
//! Each is made of lists in the program or of a CSV file (feature `serde`). Files are UTF-8 with a
//! header line and commas; cells are trimmed, blank lines and lines that begin with `#` are skipped.
//! A file is read when the model is built. Whatever does not fit is a [`DataError`] that says where.

mod cells;
#[cfg(feature = "serde")]
mod csv_source;
mod error;
mod labels;
mod map;
mod pairs;
mod positions;
mod subset;
mod table;

#[cfg(feature = "serde")]
pub(crate) use csv_source::{CsvSource, Sheet};
pub use error::{DataError, Place};
pub use labels::Labels;
pub use map::LabelMap;
pub use pairs::LabelPairs;
pub use subset::LabelSubset;
pub use table::{Key, Number, Table};
