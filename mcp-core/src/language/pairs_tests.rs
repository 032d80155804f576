use super::super::test_sets::*;
use super::*;
use proptest::prelude::*;

type Graph = Pairs<Arcs, Nodes, Nodes>;

/// Arcs `1`, …, between these nodes.
fn graph(nodes: usize, ends: &[(usize, usize)]) -> Graph {
    let nodes = super::super::test_sets::nodes(nodes);
    Pairs::new(Set::count("arcs", ends.len()), &nodes, &nodes, ends.to_vec())
}

fn positions<S: Domain>(indices: impl Iterator<Item = Ix<S>>) -> Vec<usize> {
    indices.map(Ix::position).collect()
}

/// What a filter of a list of targets finds.
fn filtered(targets: impl Iterator<Item = usize>, wanted: usize) -> Vec<usize> {
    targets.enumerate().filter(|&(_, target)| target == wanted).map(|(k, _)| k).collect()
}

#[test]
fn arcs_know_their_ends_and_nodes_their_arcs() {
    // 0 → 1 twice, a loop at 1, and 1 → 0; nothing at 2.
    let arcs = &graph(3, &[(0, 1), (1, 1), (1, 0), (0, 1)]);
    let ends = |l| (arcs.ends(l).0.position(), arcs.ends(l).1.position());
    assert_eq!(arcs.iter().map(ends).collect::<Vec<_>>(), [(0, 1), (1, 1), (1, 0), (0, 1)]);
    let node = |k| Ix::<Nodes>::new(k);
    assert_eq!(positions(arcs.out_of(node(0))), [0, 3]);
    assert_eq!(positions(arcs.into(node(1))), [0, 1, 3]);
    assert_eq!(positions(arcs.out_of(node(1))), [1, 2]);
    assert_eq!(positions(arcs.into(node(0))), [2]);
    assert!(positions(arcs.into(node(2)).chain(arcs.out_of(node(2)))).is_empty());
    assert_eq!(arcs.iter().map(|l| arcs.label(l)).collect::<Vec<_>>(), ["1", "2", "3", "4"]);
    assert_eq!((arcs.len(), arcs.count(), arcs.into_iter().len()), (4, 4, 4));
}

#[test]
fn without_arcs_every_node_is_alone() {
    let arcs = &graph(3, &[]);
    assert!(arcs.is_empty() && arcs.iter().next().is_none());
    for node in &nodes(3) {
        assert_eq!((arcs.into(node).count(), arcs.out_of(node).count()), (0, 0));
    }
}

#[test]
fn ends_in_a_subset_are_found_by_indices_of_its_subsets() {
    let nodes = nodes(4);
    let towns = towns(&nodes, &[1, 3]);
    let ports = ports(&towns, &[1]);
    // From towns to nodes: 3 → 0, 1 → 3, 3 → 3.
    let arcs: &Pairs<Arcs, Towns, Nodes> =
        &Pairs::new(Set::count("arcs", 3), &towns, &nodes, vec![(1, 0), (0, 3), (1, 3)]);
    let port = ports.ix(0);
    assert_eq!(positions(arcs.out_of(port)), [0, 2]);
    assert_eq!(positions(arcs.into(port)), [1, 2]);
    let starts: Vec<usize> =
        arcs.iter().map(|l| Element::<Nodes>::position_in(arcs.ends(l).0)).collect();
    assert_eq!(starts, [3, 1, 3]);
}

#[test]
fn arcs_that_start_in_an_empty_subset_are_none() {
    let nodes = nodes(2);
    let nowhere = towns(&nodes, &[]);
    let arcs: &Pairs<Arcs, Towns, Nodes> =
        &Pairs::new(Set::count("arcs", 0), &nowhere, &nodes, vec![]);
    assert!(arcs.is_empty() && nodes.iter().all(|i| arcs.into(i).next().is_none()));
}

#[test]
fn a_map_of_an_empty_subset_sends_nothing_anywhere() {
    let nodes = nodes(2);
    let map: Map<Towns, Nodes> = Map::new(&towns(&nodes, &[]), &nodes, vec![]);
    assert!(nodes.iter().all(|i| map.of(i).next().is_none()));
}

#[test]
fn a_map_of_a_subset_hands_out_indices_of_the_larger_set_too() {
    let nodes = nodes(4);
    let towns = towns(&nodes, &[1, 3]);
    let map: Map<Towns, Nodes> = Map::new(&towns, &nodes, vec![2, 2]);
    let sent_here: Vec<usize> = map.of(nodes.ix(2)).map(Element::<Nodes>::position_in).collect();
    assert_eq!(sent_here, [1, 3]);
    assert_eq!(map.get(towns.ix(1)), nodes.ix(2));
}

prop_compose! {
    /// The number of nodes and arcs between them: with parallel ones and loops.
    fn graphs()(nodes in 1_usize..8)(
        ends in prop::collection::vec((0..nodes, 0..nodes), 0..40),
        nodes in Just(nodes),
    ) -> (usize, Vec<(usize, usize)>) {
        (nodes, ends)
    }
}

proptest! {
    #[test]
    fn incidence_lists_are_what_a_filter_gives_in_order((count, ends) in graphs()) {
        let arcs = &graph(count, &ends);
        for node in &nodes(count) {
            let k = node.position();
            prop_assert_eq!(positions(arcs.out_of(node)), filtered(ends.iter().map(|end| end.0), k));
            prop_assert_eq!(positions(arcs.into(node)), filtered(ends.iter().map(|end| end.1), k));
        }
        for (l, &(from, to)) in arcs.iter().zip(&ends) {
            let (i, j) = arcs.ends(l);
            prop_assert_eq!((i.position(), j.position()), (from, to));
            prop_assert!(arcs.out_of(i).any(|arc| arc == l) && arcs.into(j).any(|arc| arc == l));
        }
    }

    #[test]
    fn the_preimages_of_a_map_are_what_a_filter_gives(targets in prop::collection::vec(0_usize..5, 0..20)) {
        let (from, to) = (hours(targets.len()), nodes(5));
        let map: Map<Hours, Nodes> = Map::new(&from, &to, targets.clone());
        for t in &from {
            prop_assert_eq!(map.get(t).position(), targets[t.position()]);
        }
        for i in &to {
            prop_assert_eq!(positions(map.of(i)), filtered(targets.iter().copied(), i.position()));
        }
    }
}
