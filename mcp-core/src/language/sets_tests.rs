use super::super::ix::Near;
use super::super::test_sets::*;
use super::*;
use proptest::prelude::*;

fn hour(position: u32) -> Ix<Hours> {
    Ix::new(position)
}

/// Positions in the nodes, as a family over nodes sees them.
fn among_nodes(indices: impl IntoIterator<Item = impl Element<Nodes>>) -> Vec<usize> {
    indices.into_iter().map(Element::position_in).collect()
}

#[test]
fn a_set_hands_out_its_indices_in_order() {
    let nodes = nodes(3);
    assert_eq!(among_nodes(&nodes), [0, 1, 2]);
    assert_eq!((nodes.iter().len(), nodes.len(), nodes.count()), (3, 3, 3));
    assert_eq!(nodes.iter().map(|i| nodes.label(i)).collect::<Vec<_>>(), ["1", "2", "3"]);
    assert!((0..3).all(|k| nodes.ix(k).position() == k));
}

#[test]
fn an_index_of_a_subset_is_one_of_the_larger_set() {
    let nodes = nodes(6);
    let towns = towns(&nodes, &[1, 2, 5]);
    assert_eq!(towns.iter().map(Ix::position).collect::<Vec<_>>(), [0, 1, 2]);
    assert_eq!(among_nodes(&towns), [1, 2, 5]);
    for i in &towns {
        assert_eq!(towns.label(i), nodes.label(i));
        let (near, at) = (Near::<Nodes>::position_near(i), Element::<Nodes>::position_in(i));
        assert_eq!(usize::try_from(near), Ok(at));
        assert_eq!(towns.ix(i.position()), i);
    }
}

#[test]
fn an_index_of_a_subset_of_a_subset_is_one_of_both_larger_sets() {
    let nodes = nodes(6);
    let towns = towns(&nodes, &[1, 2, 5]);
    let ports = ports(&towns, &[0, 2]);
    assert_eq!(among_nodes(&ports), [1, 5]);
    for (i, place_in_towns) in ports.iter().zip([0, 2]) {
        assert_eq!(Element::<Towns>::position_in(i), place_in_towns);
        assert_eq!(usize::try_from(Near::<Towns>::position_near(i)), Ok(place_in_towns));
        let (near, at) = (Near::<Nodes>::position_near(i), Element::<Nodes>::position_in(i));
        assert_eq!(usize::try_from(near), Ok(at));
        assert_eq!(ports.label(i), nodes.label(i));
        assert!(towns.contains(i.of_larger_set()));
    }
}

#[test]
fn an_empty_subset_has_no_indices_and_contains_nothing() {
    let nodes = nodes(3);
    let towns = towns(&nodes, &[]);
    let ports = ports(&towns, &[]);
    assert!(towns.is_empty() && ports.is_empty());
    assert_eq!((towns.len(), towns.count(), ports.iter().count()), (0, 0, 0));
    assert!(nodes.iter().all(|i| !towns.contains(i)));
}

#[test]
fn the_first_and_the_last_element_are_told_apart_except_in_a_set_of_one() {
    let day = hours(4);
    assert_eq!((day.first(), day.last()), (hour(0), hour(3)));
    let ends = |t| (day.is_first(t), day.is_last(t));
    assert_eq!(
        day.iter().map(ends).collect::<Vec<_>>(),
        [(true, false), (false, false), (false, false), (false, true)]
    );
    let one = hours(1);
    assert_eq!(one.first(), one.last());
    assert_eq!((one.wrap(hour(0), 1), one.wrap(hour(0), -7)), (hour(0), hour(0)));
}

#[test]
fn around_the_end_comes_the_beginning() {
    let day = hours(4);
    assert_eq!(day.wrap(day.last(), 1), day.first());
    assert_eq!(day.wrap(day.first(), -1), day.last());
    assert_eq!(day.wrap(hour(1), 0), hour(1));
    assert_eq!(day.wrap(hour(1), 8), hour(1));
    assert_eq!(day.wrap(hour(1), -8), hour(1));
}

#[test]
fn the_last_of_the_most_elements_an_index_can_tell_is_told() {
    let many = hours(1 << 31);
    assert_eq!(many.last().position(), (1 << 31) - 1);
    assert_eq!(many.iter().len(), 1 << 31);
    assert_eq!(many.wrap(many.last(), 1), many.first());
    assert_eq!(many.wrap(many.last(), i32::MAX).position(), (1 << 31) - 2);
    assert_eq!(many.wrap(many.first(), i32::MIN), many.first());
}

proptest! {
    #[test]
    fn a_subset_contains_exactly_its_members(chosen in prop::collection::vec(any::<bool>(), 1..20)) {
        let nodes = nodes(chosen.len());
        let positions: Vec<usize> = (0..chosen.len()).filter(|&k| chosen[k]).collect();
        let towns = towns(&nodes, &positions);
        prop_assert_eq!(among_nodes(&towns), positions);
        for i in &nodes {
            prop_assert_eq!(towns.contains(i), chosen[i.position()]);
        }
    }

    #[test]
    fn wrapping_is_addition_modulo_the_length(n in 1_u32..50, t in 0_u32..50, by in any::<i32>()) {
        let (day, t) = (hours(n as usize), t % n);
        let there = day.wrap(hour(t), by);
        let expected = (i64::from(t) + i64::from(by)).rem_euclid(n.into());
        prop_assert_eq!(signed(there.position()), expected);
        if by > i32::MIN {
            prop_assert_eq!(day.wrap(there, -by), hour(t));
        }
    }
}
