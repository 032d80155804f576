//! Bad files for the transport example: every fault is told with file, line and column.

#[path = "../examples/transport/data.rs"]
#[allow(dead_code, reason = "the tests look at messages and little else")]
mod data;

use data::{DataError, TransportData};
use std::fs;
use std::io::ErrorKind::NotFound;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

const PLANTS: &str = "plant,capacity_cases\nseattle,350\nsan-diego,600\n";
const MARKETS: &str = "market,demand_cases\nnew-york,325\ntopeka,275\n";
const DISTANCES: &str = "plant,market,thousand_miles\n\
    seattle,new-york,2.5\nseattle,topeka,1.8\nsan-diego,new-york,2.5\nsan-diego,topeka,1.4\n";

/// A directory of its own for each test, removed when dropped.
struct Directory(PathBuf);

impl Directory {
    fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("mcp-transport-{}-{count}", std::process::id());
        let directory = Directory(std::env::temp_dir().join(name));
        fs::create_dir(&directory.0).expect("a writable directory");
        directory
    }

    fn with(self, file: &str, text: impl AsRef<[u8]>) -> Self {
        fs::write(self.0.join(file), text).expect("a writable directory");
        self
    }

    fn read(&self) -> Result<TransportData, DataError> {
        TransportData::read(&self.0)
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Good files, with one of them replaced.
fn with(file: &str, text: impl AsRef<[u8]>) -> Directory {
    Directory::new()
        .with("plants.csv", PLANTS)
        .with("markets.csv", MARKETS)
        .with("distances.csv", DISTANCES)
        .with(file, text)
}

fn message(file: &str, text: impl AsRef<[u8]>) -> String {
    with(file, text).read().expect_err("a bad file").to_string()
}

#[test]
fn the_published_files_are_read() {
    let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/transport");
    let data = TransportData::read(Path::new(directory)).unwrap();
    assert_eq!(data.plants.labels().collect::<Vec<_>>(), ["seattle", "san-diego"]);
    assert_eq!(data.markets.labels().collect::<Vec<_>>(), ["new-york", "chicago", "topeka"]);
    assert_eq!((data.capacity, data.demand), (vec![350.0, 600.0], vec![325.0, 300.0, 275.0]));
    assert_eq!(data.distance, [2.5, 1.7, 1.8, 2.5, 1.8, 1.4]);
}

#[test]
fn order_of_rows_and_columns_blanks_and_further_columns_do_not_matter() {
    let text = "\u{feff}thousand_miles, market ,note,plant\r\n1.4,topeka,,san-diego\r\n\r\n\
        2.5,new-york,,seattle\r\n2.5,\"new-york\",x,san-diego\r\n1.8,topeka,,seattle";
    assert_eq!(with("distances.csv", text).read().unwrap().distance, [2.5, 1.8, 2.5, 1.4]);
}

#[test]
fn a_missing_file() {
    let directory = Directory::new();
    let error = directory.read().unwrap_err();
    let path = directory.0.join("plants.csv").display().to_string();
    assert!(error.to_string().starts_with(&format!("{path}: ")), "{error}");
    assert!(matches!(error, DataError::Unreadable { source, .. } if source.kind() == NotFound));
}

#[test]
fn a_file_that_is_not_a_text() {
    let message = message("markets.csv", b"market,demand_cases\nnew-york\xff,325\n");
    assert!(message.ends_with("markets.csv: stream did not contain valid UTF-8"), "{message}");
}

#[test]
fn an_empty_file() {
    let expected = "plants.csv, line 1, column `plant`: the file is empty";
    assert_eq!(message("plants.csv", ""), expected);
}

#[test]
fn a_header_without_rows() {
    assert_eq!(
        message("markets.csv", "market,demand_cases\n"),
        "markets.csv, line 2, column `market`: there are no rows"
    );
}

#[test]
fn a_missing_column() {
    assert_eq!(
        message("plants.csv", "plant,capacity\nseattle,350\n"),
        "plants.csv, line 1, column `capacity_cases`: there is no such column, only `plant`, \
         `capacity`"
    );
}

#[test]
fn a_column_given_twice() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases,plant\nseattle,350,x\n"),
        "plants.csv, line 1, column `plant`: there are two columns of this name"
    );
}

#[test]
fn a_row_that_is_too_short() {
    assert_eq!(
        message("distances.csv", "plant,market,thousand_miles\nseattle,topeka\n"),
        "distances.csv, line 2, column `thousand_miles`: the row has 2 cells, the header 3"
    );
}

#[test]
fn a_decimal_comma() {
    assert_eq!(
        message("distances.csv", "plant,market,thousand_miles\nseattle,topeka,1,8\n"),
        "distances.csv, line 2, column `thousand_miles`: the row has 4 cells, the header 3"
    );
}

#[test]
fn an_empty_number() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\nseattle,350\nsan-diego,\n"),
        "plants.csv, line 3, column `capacity_cases`: the cell is empty"
    );
}

#[test]
fn an_empty_label() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\n ,350\n"),
        "plants.csv, line 2, column `plant`: the cell is empty"
    );
}

#[test]
fn text_for_a_number() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\nseattle,many\n"),
        "plants.csv, line 2, column `capacity_cases`: `many` is not a number"
    );
}

#[test]
fn blank_lines_are_counted() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\n\nseattle,350\n\n\nsan-diego,many\n"),
        "plants.csv, line 6, column `capacity_cases`: `many` is not a number"
    );
}

#[test]
fn a_negative_capacity() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\nseattle,350\nsan-diego,-600\n"),
        "plants.csv, line 3, column `capacity_cases`: -600 is negative"
    );
}

#[test]
fn a_negative_distance() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("1.4", "-1.4")),
        "distances.csv, line 5, column `thousand_miles`: -1.4 is negative"
    );
}

#[test]
fn not_a_number() {
    assert_eq!(
        message("markets.csv", "market,demand_cases\nnew-york,NaN\n"),
        "markets.csv, line 2, column `demand_cases`: NaN is not finite"
    );
}

#[test]
fn a_number_beyond_the_largest() {
    assert_eq!(
        message("markets.csv", "market,demand_cases\nnew-york,1e999\n"),
        "markets.csv, line 2, column `demand_cases`: inf is not finite"
    );
}

#[test]
fn a_plant_given_twice() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\nseattle,350\nseattle,600\n"),
        "plants.csv, line 3, column `plant`: `seattle` was given before, in line 2"
    );
}

#[test]
fn a_pair_given_twice() {
    assert_eq!(
        message("distances.csv", format!("{DISTANCES}seattle,topeka,1.9\n")),
        "distances.csv, line 6, column `market`: the pair `seattle`, `topeka` was given before, \
         in line 3"
    );
}

#[test]
fn a_pair_left_out() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("seattle,topeka,1.8\n", "")),
        "distances.csv, line 5, column `thousand_miles`: there is no row for `seattle`, `topeka`"
    );
}

#[test]
fn an_unknown_plant() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("seattle,topeka", "seatle,topeka")),
        "distances.csv, line 3, column `plant`: there is no label `seatle`; did you mean \
         `seattle`?"
    );
}

#[test]
fn an_unknown_market() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("san-diego,topeka", "san-diego,boston")),
        "distances.csv, line 5, column `market`: there is no label `boston`"
    );
}
