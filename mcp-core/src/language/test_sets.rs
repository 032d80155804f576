//! Index sets for tests, with the code that `mcp!` generates for them.

use super::{Domain, Element, IndexSet, Ix, Members, Near, OrderedDomain, Subset};
use crate::model::Set;

macro_rules! domain {
    ($(#[$about:meta])* $name:ident = $Place:ty) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug)]
        pub(super) enum $name {}
        impl Domain for $name {
            type Place = $Place;
        }
    };
}

macro_rules! within {
    ($($name:ident in $larger:ident),*) => { $(
        impl Element<$larger> for Ix<$name> {
            fn position_in(self) -> usize {
                Element::<$larger>::position_in(self.of_larger_set())
            }
        }
        impl Near<$larger> for Ix<$name> {
            fn position_near(self) -> i64 {
                Near::<$larger>::position_near(self.of_larger_set())
            }
        }
    )* };
}

domain! {
    /// `hours: Ordered`
    Hours = u32
}
domain! {
    /// `nodes: Set`
    Nodes = u32
}
domain! {
    /// `towns: Subset(nodes)`
    Towns = (u32, Ix<Nodes>)
}
domain! {
    /// `ports: Subset(towns)`
    Ports = (u32, Ix<Towns>)
}
domain! {
    /// `arcs: Pairs(…)`
    Arcs = u32
}
impl OrderedDomain for Hours {}
within!(Towns in Nodes, Ports in Towns, Ports in Nodes);

/// Hours `1`, …, `n`.
pub(super) fn hours(n: usize) -> IndexSet<Hours> {
    IndexSet::new(Set::count("hours", n))
}

/// Nodes `1`, …, `n`.
pub(super) fn nodes(n: usize) -> IndexSet<Nodes> {
    IndexSet::new(Set::count("nodes", n))
}

/// Nodes at these positions.
pub(super) fn towns(nodes: &IndexSet<Nodes>, positions: &[usize]) -> Subset<Towns> {
    let labels = positions.iter().map(|&position| nodes.label(nodes.ix(position)));
    Subset::new(Set::new("towns", labels).unwrap(), nodes, positions.to_vec())
}

/// Towns at these positions.
pub(super) fn ports(towns: &Subset<Towns>, positions: &[usize]) -> Subset<Ports> {
    let labels = positions.iter().map(|&position| towns.label(towns.ix(position)));
    Subset::new(Set::new("ports", labels).unwrap(), towns, positions.to_vec())
}
