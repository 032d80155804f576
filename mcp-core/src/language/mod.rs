//! What a model written with [`mcp!`](crate::mcp) is made of: typed indices, sets, tables and views.
//!
//! A user meets [`Labels`] and [`Table`] when data are given, and [`Levels`] when a solution is
//! read; the rest is what the names inside the block stand for. An index of `plants` is a type of
//! its own, [`Ix<plants>`](Ix), so that `x[j, i]` does not compile even when the sets have equal
//! size; reading costs one multiplication for each further index.
//!
//! | in the block | type | what it can do |
//! | --- | --- | --- |
//! | `plants: Set`, `hours: Ordered`, `dof: 3` | [`IndexSet`] | `sum(plants, \|i\| …)`, `plants.len()`, `hours.wrap(t, -1)`, `hours.is_first(t)` |
//! | `thermal: Subset(gens)` | [`Subset`] | its indices are also indices of `gens`; `thermal.contains(g)` |
//! | `lines: Pairs(nodes, nodes)` | [`Pairs`] | `l @ (i, j) in lines`, `lines.into(n)`, `lines.out_of(n)`, `lines.ends(l)` |
//! | `site: Map(gens, nodes)` | [`Map`] | `site[g]`, `site.of(n)` |
//! | `cost[plants, markets]: f64` | [`Data`] | `cost[i, j]`, `cost.sum()`, `load.at(t - 1).or(0.0)` |
//! | `param tax[s in sectors]` | [`Parameters`] | `tax[s]`, `tax.base(s)` |
//! | `var x[…]`, `def c[…]` | [`Variables`], [`Definitions`] | `x[i, j]`, `x.at(t - 1).or(x0)` |
//! | `part cap { … }` | a type `Cap` beside the model, with the data of the part | `model.with(Cap { … })`: [`PartsOf`] |

mod additions;
mod assemble;
mod expression;
mod families;
mod given;
pub mod input;
mod instances;
mod ix;
mod layout;
mod lifted;
mod pairs;
mod parts;
mod resolve;
mod sets;
#[cfg(test)]
mod test_sets;
mod values;
mod view;

#[doc(hidden)]
pub use additions::Term;
#[doc(hidden)]
pub use assemble::{Assembly, Condition, Each, PerElement, Text};
#[doc(hidden)]
pub use expression::{Expression, expression};
pub use families::{Data, Definitions, Parameters, Rows, Variables};
#[doc(hidden)]
pub use given::Input;
pub use input::{DataError, LabelMap, LabelPairs, LabelSubset, Labels, Table};
pub use ix::{Domain, Element, Ix, Listed, Maybe, Near, OrderedDomain, Place, Shifted};
#[doc(hidden)]
pub use layout::{At, Elements, Family, Filled, Layout, Made, Sparse};
#[doc(hidden)]
pub use lifted::{LiftedStart, start_of_lifted};
pub use pairs::{Map, Pairs};
pub use parts::PartsOf;
#[doc(hidden)]
pub use parts::{PartText, Parts};
#[doc(hidden)]
pub use sets::Places;
pub use sets::{IndexSet, Indices, Members, Subset};
#[doc(hidden)]
pub use values::Side;
pub use view::{Key, Levels, VariableLevels};
#[doc(hidden)]
pub use view::{Numbers, ViewedTable, viewed, viewed_with_parts};
