use super::super::layout::Filled;
use super::*;

/// What is wrong with a family over sets of these lengths.
fn told(lengths: &[usize]) -> Option<String> {
    let sets: Vec<Set> = lengths.iter().map(|&length| Set::count("s", length)).collect();
    let sets: Vec<&Set> = sets.iter().collect();
    Layout::new("x", &sets).err().map(|error| error.to_string())
}

#[test]
fn as_many_combinations_as_an_index_can_tell_are_allowed() {
    for lengths in [&[][..], &[1 << 31], &[1 << 16, 1 << 15], &[1 << 20, 0, 3]] {
        assert_eq!(told(lengths), None, "{lengths:?}");
    }
}

#[test]
fn more_combinations_are_an_error_even_if_their_number_overflows() {
    let many = Some("`x` has more than 2^31 elements".to_owned());
    // 2^64 and 2^96 are 0 modulo 2^64.
    for lengths in [
        &[(1 << 31) + 1][..],
        &[1 << 16, (1 << 15) + 1],
        &[usize::MAX, 2],
        &[1 << 31, 1 << 31, 4],
        &[1 << 16; 6],
    ] {
        assert_eq!(told(lengths), many, "{lengths:?}");
    }
}

/// What was made last.
fn made<F: Family>(assembly: &mut Assembly, mut family: F) -> F {
    assembly.fill(&mut family);
    family
}

#[test]
fn families_stand_one_after_the_other() {
    let (two, three) = (Set::count("two", 2), Set::count("three", 3));
    let mut assembly = Assembly::default();
    let corner = |at: &At| at[0] == 1 && at[1] != 0;
    let x = assembly.variables(&["x", "", ""], &[&two, &three], Some(&corner));
    let x = made(x, Sparse::EMPTY);
    let y = made(assembly.variables(&["y", "", ""], &[], None), Layout::EMPTY);
    assert_eq!((x.layout.offset, x.layout.count, x.members()), (0, 2, Some(vec![4, 5])));
    assert_eq!((y.offset, y.count), (2, 1));
    let first = made(assembly.definition(&["a", "", ""], &[&three]), Layout::EMPTY);
    let second = made(assembly.definition(&["b", "", ""], &[]), Layout::EMPTY);
    assert_eq!((first.offset, second.offset), (0, 3));
    assembly.give(0, Table::from([0.1, 0.2]));
    let rate = made(assembly.parameter(0, &["rate", "", ""], &[&two], None), Filled::EMPTY);
    let scale = assembly.parameter(1, &["scale", "", ""], &[], Some(&|_: &At| 3.0));
    let scale = made(scale, Filled::EMPTY);
    let offsets = (rate.layout.offset, scale.layout.offset);
    assert_eq!((offsets, scale.values()), ((0, 2), &[3.0][..]));
}

#[test]
fn an_equation_like_its_variable_has_a_row_for_each_of_its_elements() {
    let three = Set::count("three", 3);
    let mut assembly = Assembly::default();
    let odd = |at: &At| at[0] != 1;
    let x = assembly.variables(&["x", "", ""], &[&three], Some(&odd));
    let x = made(x, Sparse::EMPTY);
    let rows = assembly.equation_like(&["e", "", ""], &[&three], "x", Some(&x));
    let rows = made(rows, Sparse::EMPTY);
    assert_eq!((rows.layout.count, rows.members()), (2, Some(vec![0, 2])));
    let mut shape = Shape::default();
    assembly.finish(&mut shape).unwrap();
    assert_eq!((shape.n(), shape.row_count()), (2, 2));
}

#[test]
fn a_field_that_is_not_given_is_named() {
    let mut assembly = Assembly::default();
    assert_eq!(assembly.required("cost", Some(2.0)), Ok(2.0));
    let error = assembly.required::<f64>("cost", None).unwrap_err();
    assert_eq!(error.to_string(), "`cost` is not given: call `.cost(…)` before `.build()`");
}

#[test]
fn the_first_error_is_told_and_nothing_is_called_after_it() {
    let mut assembly = Assembly::default();
    let nodes = assembly.set(0, "nodes");
    assert!(nodes.is_empty() && assembly.map(1, "site", [&nodes, &nodes]).is_empty());
    let called = |_: &At| -> f64 { unreachable!("called after an error") };
    assembly.variables(&["x", "", ""], &[], None).fill(&mut Layout::EMPTY.clone());
    assembly.values(Side::Lower, &called);
    let not_given = "`nodes` is not given: call `.nodes(…)` before `.build()`";
    let error = assembly.finish(&mut Shape::default()).unwrap_err();
    assert_eq!(error.to_string(), not_given);

    assembly.set(0, "nodes");
    let error = assembly.required("cost", Some(2.0)).unwrap_err();
    assert_eq!(error.to_string(), not_given);
}
