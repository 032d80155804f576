use super::super::test_sets::*;
use super::*;
use std::collections::HashSet;

fn hour(position: u32) -> Ix<Hours> {
    Ix::new(position)
}

/// Where a neighbour stands in a day of four hours.
fn stands(t: impl Near<Hours>) -> Option<usize> {
    usize::try_from(t.position_near()).ok().filter(|&position| position < 4)
}

#[test]
fn neighbours_exist_only_within_the_set() {
    assert_eq!(stands(hour(0)), Some(0));
    assert_eq!(stands(hour(0) - 1), None);
    assert_eq!(stands(hour(0) + 3), Some(3));
    assert_eq!(stands(hour(0) + 4), None);
    assert_eq!(stands(hour(3) + 1), None);
    assert_eq!(stands(hour(3) - 3), Some(0));
    assert_eq!(stands(hour(3) - 4), None);
}

#[test]
fn steps_add_up_even_when_they_leave_the_set_in_between() {
    assert_eq!(stands(hour(0) - 1 + 1), Some(0));
    assert_eq!(stands(hour(3) + 5 - 6), Some(2));
    assert_eq!(stands(hour(2) - -1), Some(3));
    assert_eq!(stands(hour(2) + -1), Some(1));
}

#[test]
fn the_longest_steps_do_not_overflow() {
    for t in [hour(0), hour(3), hour(u32::MAX)] {
        assert_eq!(stands(t + i32::MIN + i32::MIN + i32::MIN), None);
        assert_eq!(stands(t - i32::MIN - i32::MIN), None);
        assert_eq!(stands(t + i32::MAX), None);
    }
    assert_eq!(stands(hour(3) + i32::MAX - i32::MAX), Some(3));
    assert_eq!(stands(hour(3) - i32::MIN + i32::MIN), Some(3));
}

#[test]
fn indices_compare_and_hash_by_position() {
    assert!(hour(1) < hour(2) && hour(2) == hour(2) && hour(2) != hour(3));
    let nodes = nodes(4);
    let towns = towns(&nodes, &[1, 3]);
    let all: Vec<Ix<Towns>> = towns.iter().collect();
    assert!(all[0] < all[1]);
    assert_eq!(all.iter().chain(&all).copied().collect::<HashSet<_>>().len(), 2);
    assert_eq!(format!("{:?}", all[1]), "Ix(1)");
}

#[test]
fn a_value_that_does_not_exist_is_the_one_that_stands_in() {
    assert_eq!(Maybe(Some(2.0)).or(1.0), 2.0);
    assert_eq!(Maybe::<f64>(None).or(1), 1.0);
    assert!(Maybe(Some(0.0)).exists() && !Maybe::<f64>(None).exists());
}
