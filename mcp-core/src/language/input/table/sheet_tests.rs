use super::tests::{DISTANCES, NUMBERS, sets};
use super::*;
use proptest::prelude::*;
use std::fmt::Write;

const LONG: &str = "plants,markets,miles
seattle,new-york,2.5
seattle,chicago,1.7
seattle,topeka,1.8
san-diego,new-york,2.5
san-diego,chicago,1.8
san-diego,topeka,1.4
";

const WIDE: &str = "plants,new-york,chicago,topeka
seattle,2.5,1.7,1.8
san-diego,2.5,1.8,1.4
";

/// The numbers of `cost[plants, markets]`, or what is wrong with the text.
fn cost(text: &str) -> Result<Vec<f64>, String> {
    let [plants, markets] = sets();
    resolve(text, "cost", &[&plants, &markets])
}

/// The numbers of `capacity[plants]`, or what is wrong with the text.
fn capacity(text: &str) -> Result<Vec<f64>, String> {
    resolve(text, "capacity", &[&sets()[0]])
}

fn resolve(text: &str, table: &str, sets: &[&Set]) -> Result<Vec<f64>, String> {
    let given = Table::csv_text(format!("{table}.csv"), text);
    given.resolve(table, sets).map_err(|error| error.to_string())
}

#[test]
fn long_and_wide_give_the_same_numbers() {
    assert_eq!(cost(LONG), Ok(NUMBERS.to_vec()));
    assert_eq!(cost(WIDE), Ok(NUMBERS.to_vec()));
}

#[test]
fn a_table_over_one_set_is_long_or_one_row() {
    assert_eq!(capacity("plant,cases\nsan-diego,600\nseattle,350\n"), Ok(vec![350.0, 600.0]));
    assert_eq!(capacity("san-diego,seattle\n600,350\n"), Ok(vec![350.0, 600.0]));
}

#[test]
fn a_table_over_three_sets_is_long_or_wide() {
    let ([plants, markets], hours) = (sets(), Set::count("hours", 2));
    let number = |k: usize| (k as f64) + 0.5;
    let (mut long, mut wide) = ("a,b,c,value\n".to_owned(), "markets,plants,2,1\n".to_owned());
    for (k, ((plant, market), _)) in DISTANCES.into_iter().enumerate() {
        let (first, second) = (number(2 * k), number(2 * k + 1));
        writeln!(long, "{plant},{market},2,{second}\n{plant},{market},1,{first}").unwrap();
        writeln!(wide, "{market},{plant},{second},{first}").unwrap();
    }
    let expected: Vec<f64> = (0..12).map(number).collect();
    let sets = [&plants, &markets, &hours];
    assert_eq!(resolve(&long, "load", &sets), Ok(expected.clone()));
    assert_eq!(resolve(&wide, "load", &sets), Ok(expected));
}

#[test]
fn a_table_without_index_sets_is_one_cell() {
    assert_eq!(resolve("eta\n0.9\n", "eta", &[]), Ok(vec![0.9]));
    let told = "eta.csv: `eta` has no index sets: give one number, not 2";
    assert_eq!(resolve("eta\n0.9\n0.8\n", "eta", &[]).unwrap_err(), told);
    let told = "eta.csv, line 1: `eta` needs the columns value; found 2";
    assert_eq!(resolve("name,eta\na,0.9\n", "eta", &[]).unwrap_err(), told);
}

#[test]
fn keys_are_found_by_header_or_stand_in_order() {
    let by_name = "markets,plants,miles\nnew-york,seattle,2.5\n";
    let in_order = "from,to,miles\nseattle,new-york,2.5\n";
    let told = "cost.csv: `cost[seattle, chicago]` has no value (missing: 5 of 6)";
    assert_eq!(cost(by_name).unwrap_err(), told);
    assert_eq!(cost(in_order).unwrap_err(), told);
}

#[test]
fn the_same_set_twice_stands_in_order() {
    let nodes = Set::new("nodes", ["a", "b"]).unwrap();
    let text = "nodes,nodes,km\na,a,0\na,b,1\nb,a,2\nb,b,3\n";
    assert_eq!(resolve(text, "way", &[&nodes, &nodes]), Ok(vec![0.0, 1.0, 2.0, 3.0]));
}

#[test]
fn comments_blanks_and_a_byte_order_mark_are_skipped() {
    let text = format!("\u{feff}# miles\n\n{}", LONG.replace(',', " ,\t").replace("1.4\n", "1.4"));
    assert_eq!(cost(&text), Ok(NUMBERS.to_vec()));
}

#[test]
fn infinities_are_numbers_and_nan_is_not() {
    let numbers = capacity("plant,cases\nseattle,inf\nsan-diego,-inf\n");
    assert_eq!(numbers, Ok(vec![f64::INFINITY, f64::NEG_INFINITY]));
    let told = "capacity.csv, line 2: `capacity[seattle]` is NaN: give a number";
    assert_eq!(capacity("plant,cases\nseattle,nan\n").unwrap_err(), told);
}

#[test]
fn an_empty_cell_is_a_missing_number() {
    let told = "cost.csv: `cost[seattle, topeka]` has no value (missing: 1 of 6)";
    assert_eq!(cost(&LONG.replacen("1.8", "", 1)).unwrap_err(), told);
    assert_eq!(cost(&WIDE.replacen("1.8", "", 1)).unwrap_err(), told);
}

#[test]
fn a_missing_column_is_missing_numbers() {
    let told = "cost.csv: `cost[seattle, new-york]` has no value (missing: 4 of 6)";
    assert_eq!(cost("plants,topeka\nseattle,1\nsan-diego,2\n").unwrap_err(), told);
}

#[test]
fn a_key_given_twice_is_told_with_both_lines() {
    let told = "cost.csv, line 8: `cost[seattle, chicago]` is given twice, first in line 3";
    assert_eq!(cost(&format!("{LONG}seattle,chicago,1.7\n")).unwrap_err(), told);
    let told = "cost.csv, line 4: `cost[seattle, new-york]` is given twice, first in line 2";
    assert_eq!(cost(&format!("{WIDE}seattle,1,1,1\n")).unwrap_err(), told);
}

#[test]
fn a_column_given_twice_is_an_error() {
    let told = "cost.csv, line 1: there are two columns `topeka`";
    assert_eq!(cost("plants,topeka,topeka\n").unwrap_err(), told);
}

#[test]
fn an_unknown_label_is_told_with_its_line() {
    let told = "cost.csv, line 3: `cost` names `seatle`, which is no label of `plants`; \
                did you mean `seattle`?";
    assert_eq!(cost(&LONG.replace("seattle,c", "seatle,c")).unwrap_err(), told);
    let told = "cost.csv, line 1: `cost` names `topekka`, which is no label of `markets`; \
                did you mean `topeka`?";
    assert_eq!(cost(&WIDE.replace("topeka", "topekka")).unwrap_err(), told);
}

#[test]
fn a_wrong_number_of_columns_is_an_error() {
    let told = "cost.csv, line 2: `cost` needs the columns plants, markets, value; or plants, \
                one column for each label of markets; found 2";
    assert_eq!(cost("# miles\nplants,miles\nseattle,1\n").unwrap_err(), told);
    let told = "cost.csv, line 4: expected 3 columns as in the header, found 2";
    assert_eq!(cost(&LONG.replace("topeka,1.8", "topeka")).unwrap_err(), told);
}

#[test]
fn a_cell_that_is_no_number_is_told_with_line_and_column() {
    let told = "cost.csv, line 4, column `miles`: `1.8x` is not a number";
    assert_eq!(cost(&LONG.replacen("1.8", "1.8x", 1)).unwrap_err(), told);
    let told = "cost.csv, line 3, column `topeka`: `far` is not a number";
    assert_eq!(cost(&WIDE.replace("1.4", "far")).unwrap_err(), told);
}

#[test]
fn a_file_that_is_not_there_is_an_error_with_its_path() {
    let error = Table::csv("no/such/cost.csv").resolve("cost", &[]).unwrap_err().to_string();
    assert!(error.starts_with("`cost` cannot be read from no/such/cost.csv: "), "{error}");
}

#[test]
fn the_example_data_are_read_as_they_are() {
    let file = |name: &str| {
        format!("{}/../examples/data/transport/{name}.csv", env!("CARGO_MANIFEST_DIR"))
    };
    let [plants, markets] = sets();
    let capacity = Table::csv(file("plants")).resolve("capacity", &[&plants]);
    assert_eq!(capacity, Ok(vec![350.0, 600.0]));
    let distance = Table::csv(file("distances")).resolve("distance", &[&plants, &markets]);
    assert_eq!(distance, Ok(NUMBERS.to_vec()));
}

#[test]
fn ninety_thousand_rows_are_the_same_long_and_wide() {
    let (mut long, mut wide) = ("i,j,km\n".to_owned(), "nodes".to_owned());
    (1..=300).for_each(|j| write!(wide, ",{j}").unwrap());
    for i in 1..=300 {
        write!(wide, "\n{i}").unwrap();
        for j in 1..=300 {
            let number = i * 1000 + j;
            writeln!(long, "{i},{j},{number}").unwrap();
            write!(wide, ",{number}").unwrap();
        }
    }
    let nodes = Set::count("nodes", 300);
    let long = resolve(&long, "way", &[&nodes, &nodes]).unwrap();
    assert_eq!(resolve(&wide, "way", &[&nodes, &nodes]).unwrap(), long);
    assert_eq!(long[301], 2002.0);
}

/// A text of the header and the rows, each with its cells in the order of `columns`.
fn text(rows: &[Vec<String>], columns: &[usize]) -> String {
    let line = |row: &Vec<String>| columns.iter().map(|&c| row[c].clone()).collect::<Vec<_>>();
    rows.iter().map(|row| line(row).join(",") + "\n").collect()
}

fn cells(text: &str) -> Vec<Vec<String>> {
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

proptest! {
    #[test]
    fn rows_and_key_columns_of_a_long_table_come_in_any_order(
        mut rows in Just(cells(LONG)[1..].to_vec()).prop_shuffle(),
        mut columns in Just(vec![0, 1]).prop_shuffle(),
    ) {
        rows.insert(0, cells(LONG)[0].clone());
        columns.push(2);
        prop_assert_eq!(cost(&text(&rows, &columns)), Ok(NUMBERS.to_vec()));
    }

    #[test]
    fn rows_and_columns_of_a_wide_table_come_in_any_order(
        mut rows in Just(cells(WIDE)[1..].to_vec()).prop_shuffle(),
        mut columns in Just(vec![1, 2, 3]).prop_shuffle(),
    ) {
        rows.insert(0, cells(WIDE)[0].clone());
        columns.insert(0, 0);
        prop_assert_eq!(cost(&text(&rows, &columns)), Ok(NUMBERS.to_vec()));
    }

    #[test]
    fn any_text_gives_a_table_or_an_error(
        words in prop::collection::vec(prop::sample::select(vec![
            "plants", "seattle", "san-diego", "topeka", "1.5", "nan", ",", ",", "\n", "#", "\"", " ",
        ]), 0..30),
    ) {
        let text = words.concat();
        prop_assert!(cost(&text).map_or(true, |numbers| numbers.len() == 6));
        prop_assert!(capacity(&text).map_or(true, |numbers| numbers.len() == 2));
        prop_assert!(resolve(&text, "eta", &[]).map_or(true, |numbers| numbers.len() == 1));
    }
}

#[test]
fn a_column_of_several_is_found_by_its_header() {
    let text = "plants,fuel,capacity,rate\nsan-diego,gas,600,2\nseattle,coal,350,x\n";
    let plants = &sets()[0];
    let column = |header: &str| {
        let source = CsvSource::text("plants.csv", text);
        let table = Table(Form::Csv(source, Some(header.to_owned())));
        table.resolve("k", &[plants]).map_err(|error| error.to_string())
    };
    assert_eq!(column("capacity"), Ok(vec![350.0, 600.0]));
    assert_eq!(
        column("rate"),
        Err("plants.csv, line 3, column `rate`: `x` is not a number".to_owned())
    );
    assert_eq!(
        column("capacty"),
        Err("plants.csv, line 1: there is no column `capacty`; did you mean `capacity`?".to_owned())
    );
    assert!(column("plants").is_err(), "keys are no numbers");
}
