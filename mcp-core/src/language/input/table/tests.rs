use super::*;
use proptest::prelude::*;

pub(super) fn sets() -> [Set; 2] {
    let plants = Set::new("plants", ["seattle", "san-diego"]).unwrap();
    let markets = Set::new("markets", ["new-york", "chicago", "topeka"]).unwrap();
    [plants, markets]
}

/// Distances of Dantzig's plants and markets.
pub(super) const DISTANCES: [((&str, &str), f64); 6] = [
    (("seattle", "new-york"), 2.5),
    (("seattle", "chicago"), 1.7),
    (("seattle", "topeka"), 1.8),
    (("san-diego", "new-york"), 2.5),
    (("san-diego", "chicago"), 1.8),
    (("san-diego", "topeka"), 1.4),
];

pub(super) const NUMBERS: [f64; 6] = [2.5, 1.7, 1.8, 2.5, 1.8, 1.4];

/// The numbers of `cost[plants, markets]`, or what is wrong with them.
fn cost(table: impl Into<Table>) -> Result<Vec<f64>, String> {
    let [plants, markets] = sets();
    table.into().resolve("cost", &[&plants, &markets]).map_err(|error| error.to_string())
}

/// The numbers of `capacity[plants]`, or what is wrong with them.
fn capacity(table: impl Into<Table>) -> Result<Vec<f64>, String> {
    table.into().resolve("capacity", &[&sets()[0]]).map_err(|error| error.to_string())
}

/// The number `eta`, or what is wrong with it.
fn eta(table: impl Into<Table>) -> Result<Vec<f64>, String> {
    table.into().resolve("eta", &[]).map_err(|error| error.to_string())
}

#[test]
fn every_list_gives_the_same_numbers() {
    let expected = Ok(NUMBERS.to_vec());
    assert_eq!(cost(NUMBERS), expected);
    assert_eq!(cost(NUMBERS.to_vec()), expected);
    assert_eq!(cost(NUMBERS.as_slice()), expected);
    assert_eq!(cost([[2.5, 1.7, 1.8], [2.5, 1.8, 1.4]]), expected);
    assert_eq!(cost(vec![vec![2.5, 1.7, 1.8], vec![2.5, 1.8, 1.4]]), expected);
    assert_eq!(cost(DISTANCES), expected);
    assert_eq!(cost(DISTANCES.to_vec()), expected);
    let owned = DISTANCES.map(|((i, j), number)| ((i.to_owned(), j.to_owned()), number));
    assert_eq!(cost(owned.to_vec()), expected);
}

#[test]
fn one_number_is_that_of_every_element() {
    assert_eq!(cost(2.0), Ok(vec![2.0; 6]));
    assert_eq!(cost(2), Ok(vec![2.0; 6]));
    assert_eq!(eta(0.9), Ok(vec![0.9]));
}

#[test]
fn keys_have_one_label_for_each_set() {
    assert_eq!(capacity([("san-diego", 600), ("seattle", 350)]), Ok(vec![350.0, 600.0]));
    let owned = vec![("san-diego".to_owned(), 600.0), ("seattle".to_owned(), 350.0)];
    assert_eq!(capacity(owned), Ok(vec![350.0, 600.0]));
    let (hours, [plants, _]) = (Set::count("hours", 1), sets());
    let table = Table::from([(("1", "san-diego", "1"), 2.0), (("1", "seattle", "1"), 1.0)]);
    assert_eq!(table.resolve("t", &[&hours, &plants, &hours]), Ok(vec![1.0, 2.0]));
}

#[test]
fn infinities_are_numbers() {
    let (inf, ninf) = (f64::INFINITY, f64::NEG_INFINITY);
    assert_eq!(capacity([inf, ninf]), Ok(vec![inf, ninf]));
}

#[test]
fn a_table_over_an_empty_set_is_empty() {
    let lines = Set::new("lines", [""; 0]).unwrap();
    for table in [Table::from(1.0), Table::from(Vec::<f64>::new())] {
        assert_eq!(table.resolve("limit", &[&lines]), Ok(vec![]));
    }
}

#[test]
fn missing_numbers_are_counted_and_the_first_is_named() {
    let told = "`cost[seattle, chicago]` has no value (missing: 5 of 6)";
    assert_eq!(cost(DISTANCES[..1].to_vec()).unwrap_err(), told);
    let told = "`capacity[seattle]` has no value (missing: 1 of 2)";
    assert_eq!(capacity([("san-diego", 1.0)]).unwrap_err(), told);
}

#[test]
fn a_key_given_twice_is_an_error() {
    let told = "`cost[seattle, topeka]` is given twice";
    assert_eq!(cost([DISTANCES[2], DISTANCES[0], DISTANCES[2]]).unwrap_err(), told);
}

#[test]
fn an_unknown_label_is_answered_with_its_set_and_the_nearest() {
    let told = "`cost` names `topekka`, which is no label of `markets`; did you mean `topeka`?";
    assert_eq!(cost([(("seattle", "topekka"), 1.0)]).unwrap_err(), told);
    let told = "`cost` names `berlin`, which is no label of `plants`";
    assert_eq!(cost([(("berlin", "topeka"), 1.0)]).unwrap_err(), told);
}

#[test]
fn a_key_of_another_length_is_an_error() {
    let told = "the key `cost[seattle]` does not fit `cost[plants, markets]`";
    assert_eq!(cost([("seattle", 1.0)]).unwrap_err(), told);
    let told = "the key `eta[seattle]` does not fit `eta`";
    assert_eq!(eta([("seattle", 1.0)]).unwrap_err(), told);
}

#[test]
fn nan_is_refused_by_name() {
    let told = "`cost[seattle, topeka]` is NaN: give a number";
    assert_eq!(cost([1.0, 2.0, f64::NAN, 4.0, 5.0, 6.0]).unwrap_err(), told);
    assert_eq!(cost([[1.0, 2.0, f64::NAN], [4.0, 5.0, 6.0]]).unwrap_err(), told);
    assert_eq!(cost([(("seattle", "topeka"), f64::NAN)]).unwrap_err(), told);
    assert_eq!(eta(f64::NAN).unwrap_err(), "`eta` is NaN: give a number");
}

#[test]
fn another_shape_is_an_error() {
    let form = "`cost[plants, markets]` has the wrong shape: expected 2 x 3, found";
    assert_eq!(cost([[1.0, 2.0], [3.0, 4.0]]).unwrap_err(), format!("{form} 2 x 2"));
    assert_eq!(cost([[1.0, 2.0, 3.0]; 3]).unwrap_err(), format!("{form} 3 x 3"));
    assert_eq!(cost([1.0, 2.0]).unwrap_err(), format!("{form} 2"));
    let uneven = vec![vec![1.0], vec![], vec![2.0, 3.0]];
    assert_eq!(cost(uneven).unwrap_err(), format!("{form} 3 rows"));
    let told = "`capacity[plants]` has the wrong shape: expected 2, found 1 x 2";
    assert_eq!(capacity([[1.0, 2.0]]).unwrap_err(), told);
}

#[test]
fn a_row_of_another_length_is_named() {
    let told = "`cost[san-diego]` has the wrong length: expected 3, found 2";
    assert_eq!(cost(vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0]]).unwrap_err(), told);
}

#[test]
fn a_table_without_index_sets_is_one_number() {
    assert_eq!(eta([0.9]), Ok(vec![0.9]));
    assert_eq!(eta([[0.9]]), Ok(vec![0.9]));
    let told = "`eta` has no index sets: give one number, not 2";
    assert_eq!(eta([0.9, 0.8]).unwrap_err(), told);
    assert_eq!(eta([[0.9, 0.8]]).unwrap_err(), told);
}

#[test]
fn a_table_of_too_many_elements_is_an_error() {
    let big = Set::count("cells", 1 << 20);
    for sets in [vec![&big; 2], vec![&big; 8]] {
        let error = Table::from(0.0).resolve("k", &sets).unwrap_err().to_string();
        assert!(error.ends_with("]` has more than 2^31 elements"), "{error}");
    }
}

#[test]
fn ninety_thousand_keys_find_their_places() {
    let label = |k: usize| format!("label {k}");
    let set = Set::new("nodes", (0..300).map(label)).unwrap();
    let entry = |k: usize| ((label(k % 300), label(k / 300)), k as f64);
    let table = Table::from((0..90_000).map(entry).collect::<Vec<_>>());
    let numbers = table.resolve("cost", &[&set, &set]).unwrap();
    let place = |k: usize| (k % 300 * 300 + k / 300) as f64;
    assert!(numbers.iter().enumerate().all(|(k, &number)| number == place(k)));
}

proptest! {
    #[test]
    fn keys_come_in_any_order(entries in Just(DISTANCES.to_vec()).prop_shuffle()) {
        prop_assert_eq!(cost(entries), Ok(NUMBERS.to_vec()));
    }
}
