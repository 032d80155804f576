use super::super::ix::{Ix, Shifted, narrow};
use super::super::layout::{Family, Made, Sparse};
use super::super::test_sets::*;
use super::*;
use crate::model::{Point, Reads, Recorder, Set};
use proptest::prelude::*;
use std::cell::RefCell;
use std::sync::LazyLock;

/// Values of variables, definitions and parameters, each in a range of its own.
static NUMBERS: LazyLock<[Vec<f64>; 3]> = LazyLock::new(|| {
    [0_u32, 10_000, 20_000].map(|first| (first..first + 2000).map(f64::from).collect())
});

/// Neither variables nor definitions nor parameters.
const NOTHING: [&[usize]; 3] = [&[]; 3];

/// What a read gives, and the numbers of the variables, definitions and parameters it asks for.
fn recorded<T>(read: impl Fn(&Reader<'_, f64>) -> T) -> (T, Reads) {
    let [z, definitions, parameters] = &*NUMBERS;
    let point = Point { z, definitions, parameters };
    let recorder = Recorder { point, reads: RefCell::default() };
    let value = read(&Reader::other(&recorder));
    (value, recorder.reads.into_inner())
}

/// What was read: variables, definitions, parameters.
fn touched(reads: &Reads) -> [&[usize]; 3] {
    [&reads.variables, &reads.definitions, &reads.parameters]
}

/// All combinations of positions below these lengths, the last running fastest.
fn combinations(lengths: &[usize]) -> Vec<Vec<usize>> {
    lengths.iter().fold(vec![vec![]], |heads, &length| {
        let extend = |head: Vec<usize>| (0..length).map(move |k| [&head[..], &[k]].concat());
        heads.into_iter().flat_map(extend).collect()
    })
}

/// The hour at a position, which a set need not have.
fn hour(position: usize) -> Shifted<Hours> {
    Ix::<Hours>::new(0) + i32::try_from(position).unwrap()
}

/// The combinations one step outside: before the first or after the last of one set.
fn outside(lengths: &[usize]) -> Vec<Vec<Shifted<Hours>>> {
    let inside = lengths.iter().map(|&length| hour(length.saturating_sub(1)));
    let inside: Vec<_> = inside.collect();
    let leave = |k: usize| {
        let (mut before, mut after) = (inside.clone(), inside.clone());
        (before[k], after[k]) = (hour(0) - 1, hour(lengths[k]));
        [before, after]
    };
    (0..lengths.len()).flat_map(leave).collect()
}

/// For one number of index sets: every kind of family over sets of these lengths, whose first
/// element has the number `offset`; a sparse one has the elements that are `chosen`.
macro_rules! check {
    ($check:ident: $rank:literal $($S:ident $k:tt),*) => {
        fn $check(lengths: &[usize], offset: usize, chosen: &[bool]) {
            type Sets = ($($S,)*);
            let all = combinations(lengths);
            let members: Vec<usize> = (0..all.len()).filter(|&dense| chosen[dense]).collect();
            let base: Vec<f64> = (0..all.len()).map(|dense| 0.5 + dense as f64).collect();

            let dense_family: Variables<Sets> = family(layout(lengths, offset));
            let some = |offset| Sparse::new(layout(lengths, offset), Some(&members));
            let filled = |offset| filled(layout(lengths, offset), &base);
            let sparse_family: Variables<Sets, Sparse> = family(some(offset));
            let counts = (dense_family.0.count, sparse_family.0.layout.count);
            assert_eq!(counts, (all.len(), members.len()));
            let definitions: Definitions<Sets> = family(layout(lengths, offset));
            let parameters: Parameters<Sets> = family(filled(offset));
            assert_eq!(parameters.0.values(), base);
            let data: Data<Sets> = family(filled(0));
            let rows: Rows<Sets> = family(layout(lengths, 0));
            let sparse_rows: Rows<Sets, Sparse> = family(some(0));

            for (dense, _at) in all.iter().enumerate() {
                let number = offset + dense;
                let value = base[dense];
                // A row number and the positions of its indices are inverse.
                assert_eq!(&rows.split(dense)[..lengths.len()], &all[dense][..]);
                assert_eq!(&definitions.split(dense)[..lengths.len()], &all[dense][..]);

                let (read, reads) = recorded(|read| dense_family.get(read, $(_at[$k].ix()),*));
                assert_eq!(touched(&reads), [&[number][..], &[], &[]]);
                assert_eq!(read.into_scalar(), number as f64);

                let (read, reads) = recorded(|read| definitions.get(read, $(_at[$k].ix()),*));
                assert_eq!(touched(&reads), [&[][..], &[number], &[]]);
                assert_eq!(read.into_scalar(), 10_000.0 + number as f64);
                let (read, reads) = recorded(|read| definitions.at(read, $(hour(_at[$k])),*));
                assert_eq!(touched(&reads), [&[][..], &[number], &[]]);
                assert!(read.exists());

                let (read, reads) = recorded(|read| parameters.get(read, $(_at[$k].ix()),*));
                assert_eq!(touched(&reads), [&[][..], &[], &[number]]);
                assert_eq!(read.into_scalar(), 20_000.0 + number as f64);
                let (read, reads) = recorded(|read| parameters.at(read, $(hour(_at[$k])),*));
                assert_eq!(touched(&reads), [&[][..], &[], &[number]]);
                assert!(read.exists());

                assert_eq!(parameters.base($(_at[$k].ix()),*), value);
                assert_eq!(data.get($(_at[$k].ix()),*), value);
                assert_eq!(data.at($(hour(_at[$k])),*), Maybe(Some(value)));

                let place = members.iter().position(|&member| member == dense);
                assert_eq!(dense_family.place($(_at[$k].ix()),*), Some(dense));
                assert_eq!(sparse_family.place($(_at[$k].ix()),*), place);
                let expected: Vec<usize> = place.map(|place| offset + place).into_iter().collect();
                let (read, reads) = recorded(|read| sparse_family.get(read, $(_at[$k].ix()),*));
                assert_eq!(touched(&reads), [&expected[..], &[], &[]]);
                assert_eq!(read.into_scalar(), expected.first().map_or(0.0, |&j| j as f64));
                let (read, reads) = recorded(|read| sparse_family.at(read, $(hour(_at[$k])),*));
                assert_eq!(touched(&reads), [&expected[..], &[], &[]]);
                assert_eq!(read.exists(), place.is_some());
            }
            for (row, &dense) in members.iter().enumerate() {
                assert_eq!(&sparse_rows.split(row)[..lengths.len()], &all[dense][..]);
            }
            for _at in outside(lengths) {
                assert!(!data.at($(_at[$k]),*).exists());
                let (exists, reads) = recorded(|read| {
                    [
                        dense_family.at(read, $(_at[$k]),*).exists(),
                        sparse_family.at(read, $(_at[$k]),*).exists(),
                        definitions.at(read, $(_at[$k]),*).exists(),
                        parameters.at(read, $(_at[$k]),*).exists(),
                    ]
                });
                assert_eq!(exists, [false; 4]);
                assert_eq!(touched(&reads), NOTHING);
            }
        }
    };
}

/// A family over sets of these lengths, whose first element has the number `offset`.
fn layout(lengths: &[usize], offset: usize) -> Layout {
    let sets: Vec<Set> = lengths.iter().map(|&length| Set::count("hours", length)).collect();
    let sets: Vec<&Set> = sets.iter().collect();
    let mut layout = Layout::new("x", &sets).unwrap();
    layout.offset = offset;
    layout
}

/// A family with these values.
fn filled(layout: Layout, values: &[f64]) -> Filled {
    let mut filled = Filled::EMPTY;
    Family::take(&mut filled, Made { values: values.to_vec(), ..layout.into() });
    filled
}

/// A family of any kind.
fn family<L, F: Over<L>>(layout: L) -> F {
    F::over(layout)
}

trait Over<L> {
    fn over(layout: L) -> Self;
}

macro_rules! over {
    ($($Family:ty: $Layout:ty),* $(,)?) => { $(
        impl<X> Over<$Layout> for $Family {
            fn over(layout: $Layout) -> Self {
                Self(layout, PhantomData)
            }
        }
    )* };
}

over! {
    Data<X>: Filled,
    Variables<X>: Layout,
    Variables<X, Sparse>: Sparse,
    Definitions<X>: Layout,
    Parameters<X>: Filled,
    Rows<X>: Layout,
    Rows<X, Sparse>: Sparse,
}

/// A position as an index.
trait AsIndex {
    fn ix(self) -> Ix<Hours>;
}
impl AsIndex for usize {
    fn ix(self) -> Ix<Hours> {
        Ix::new(narrow(self))
    }
}

check!(check_0: 0);
check!(check_1: 1 Hours 0);
check!(check_2: 2 Hours 0, Hours 1);
check!(check_3: 3 Hours 0, Hours 1, Hours 2);
check!(check_4: 4 Hours 0, Hours 1, Hours 2, Hours 3);
check!(check_5: 5 Hours 0, Hours 1, Hours 2, Hours 3, Hours 4);
check!(check_6: 6 Hours 0, Hours 1, Hours 2, Hours 3, Hours 4, Hours 5);

/// A check by lengths, offset and chosen elements.
type Check = fn(&[usize], usize, &[bool]);

/// The checks by number of index sets.
const CHECKS: [Check; 7] = [check_0, check_1, check_2, check_3, check_4, check_5, check_6];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn every_read_touches_exactly_the_element_meant(
        lengths in prop::collection::vec(0_usize..4, 6),
        offset in 0_usize..1000,
        chosen in prop::collection::vec(any::<bool>(), 729),
    ) {
        for (rank, check) in CHECKS.iter().enumerate() {
            check(&lengths[..rank], offset, &chosen);
        }
    }

    #[test]
    fn the_sum_of_a_table_is_that_of_its_values_from_the_first_to_the_last(
        values in prop::collection::vec(-1e6..1e6, 0..50),
    ) {
        let data = family::<_, Data<(Hours,)>>(filled(layout(&[values.len()], 0), &values));
        prop_assert_eq!(data.sum(), values.iter().fold(0.0, |total, value| total + value));
    }
}

#[test]
fn reads_do_not_depend_on_whether_all_elements_are_listed() {
    for (rank, check) in CHECKS.iter().enumerate() {
        for chosen in [true, false] {
            check(&[2, 1, 3, 1, 2, 2][..rank], 7, &[chosen; 24]);
        }
    }
}

#[test]
fn a_family_without_index_sets_may_be_absent() {
    let absent: Variables<(), Sparse> = family(Sparse::new(layout(&[], 4), Some(&[])));
    assert_eq!((absent.0.layout.count, absent.place()), (0, None));
    let (values, reads) = recorded(|read| (absent.get(read), absent.at(read)));
    assert_eq!(values.0.into_scalar(), 0.0);
    assert!(!values.1.exists() && reads.variables.is_empty());
}

#[test]
fn the_base_of_a_parameter_is_its_value_in_the_data_whatever_is_read() {
    let tax: Parameters<(Hours,)> = family(filled(layout(&[2], 0), &[0.25, 0.5]));
    let (value, reads) = recorded(|_| tax.base(1.ix()));
    assert_eq!(value, 0.5);
    assert_eq!(touched(&reads), NOTHING);
}

#[test]
fn an_index_of_a_subset_reads_the_element_of_the_larger_set() {
    let nodes = nodes(4);
    let towns = towns(&nodes, &[1, 3]);
    let ports = ports(&towns, &[1]);
    let values: Vec<f64> = (0..8).map(f64::from).collect();
    let load: Data<(Nodes, Towns)> = family(filled(layout(&[4, 2], 0), &values));
    for port in &ports {
        assert_eq!(load.get(port, port), 7.0);
        assert_eq!(load.at(port, port), Maybe(Some(7.0)));
    }
}

#[test]
fn an_empty_table_sums_to_nothing() {
    let data: Data<(Hours, Hours)> = family(filled(layout(&[0, 3], 0), &[]));
    assert_eq!(data.sum(), 0.0);
    assert!(data.values().is_empty());
    assert!(!data.at(hour(0), hour(0)).exists());
}
