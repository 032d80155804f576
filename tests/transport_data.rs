//! Bad files for the transport example: every fault is told with the file and line, or the name, of
//! what is wrong.

#[path = "../examples/transport.rs"]
#[allow(dead_code, reason = "the tests look at messages and little else")]
mod transport;

use mcp_core::language::DataError;
use mcp_core::{Model, ModelError};
use std::fs;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use transport::{Transport, TransportError};

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

    fn read(&self) -> Result<Transport, TransportError> {
        Transport::read(&self.0)
    }

    /// The message, without the path of this directory.
    fn message(&self) -> String {
        let message = self.read().expect_err("a bad file").to_string();
        message.replace(&format!("{}{MAIN_SEPARATOR}", self.0.display()), "")
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
    with(file, text).message()
}

/// Values of a parameter as read from the files.
fn amounts(model: &Transport, name: &str) -> Vec<f64> {
    let family = model.shape().parameter(name).expect("a parameter of the model");
    model.shape().parameter_values()[family.offset()..][..family.len()].to_vec()
}

#[test]
fn the_published_files_are_read() {
    let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/transport");
    let model = Transport::read(Path::new(directory)).unwrap();
    let labels = |k: usize| model.shape().variable("x").unwrap().sets()[k].labels().collect();
    let (plants, markets): (Vec<_>, Vec<_>) = (labels(0), labels(1));
    assert_eq!(plants, ["seattle", "san-diego"]);
    assert_eq!(markets, ["new-york", "chicago", "topeka"]);
    assert_eq!(amounts(&model, "capacity"), [350.0, 600.0]);
    assert_eq!(amounts(&model, "demand"), [325.0, 300.0, 275.0]);
    assert_eq!(amounts(&model, "distance"), [2.5, 1.7, 1.8, 2.5, 1.8, 1.4]);
}

#[test]
fn order_of_rows_blanks_comments_and_order_of_named_keys_do_not_matter() {
    let text = "\u{feff}markets, plants ,thousand_miles\r\n# west\r\ntopeka,san-diego,1.4\r\n\r\n\
        new-york,seattle,2.5\r\n\"new-york\",san-diego,2.5\r\n topeka,seattle,1.8";
    let model = with("distances.csv", text).read().unwrap();
    assert_eq!(amounts(&model, "distance"), [2.5, 1.8, 2.5, 1.4]);
}

#[test]
fn a_missing_file() {
    let directory = Directory::new();
    let told = directory.message();
    assert!(told.starts_with("`plants` cannot be read from plants.csv: "), "{told}");
    let error = directory.read().unwrap_err();
    let TransportError::Model(ModelError::Data(error)) = error else { panic!("{error}") };
    assert!(matches!(error, DataError::Unreadable { .. }));
}

#[test]
fn a_file_that_is_not_a_text() {
    assert_eq!(
        message("markets.csv", b"market,demand_cases\nnew-york\xff,325\n"),
        "`markets` cannot be read from markets.csv: stream did not contain valid UTF-8"
    );
}

#[test]
fn an_empty_file() {
    assert_eq!(message("plants.csv", ""), "plants.csv has no header line");
}

#[test]
fn a_header_without_rows() {
    assert_eq!(
        message("markets.csv", "market,demand_cases\n"),
        "markets.csv: set `markets` is empty: give at least one label"
    );
}

#[test]
fn a_missing_column() {
    assert_eq!(
        message("plants.csv", "plant\nseattle\n"),
        "plants.csv, line 1: `capacity` needs the columns plants, value; or one \
         column for each label of plants; found 1"
    );
}

#[test]
fn a_further_column() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases,plant\nseattle,350,x\n"),
        "plants.csv, line 1: `capacity` needs the columns plants, value; or one \
         column for each label of plants; found 3"
    );
}

#[test]
fn a_column_given_twice() {
    assert_eq!(
        message("distances.csv", "plant,topeka,new-york,topeka\nseattle,1.8,2.5,1.9\n"),
        "distances.csv, line 1: there are two columns `topeka`"
    );
}

#[test]
fn a_row_that_is_too_short() {
    assert_eq!(
        message("distances.csv", "plant,market,thousand_miles\nseattle,topeka\n"),
        "distances.csv, line 2: expected 3 columns as in the header, found 2"
    );
}

#[test]
fn a_decimal_comma() {
    assert_eq!(
        message("distances.csv", "plant,market,thousand_miles\nseattle,topeka,1,8\n"),
        "distances.csv, line 2: expected 3 columns as in the header, found 4"
    );
}

#[test]
fn an_empty_number() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\nseattle,350\nsan-diego,\n"),
        "plants.csv: `capacity[san-diego]` has no value (missing: 1 of 2)"
    );
}

#[test]
fn an_empty_label() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\n ,350\n"),
        "plants.csv, line 2: label 1 of `plants` is empty"
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
        "`capacity[san-diego]` is -600: give a number that is not negative"
    );
}

#[test]
fn a_negative_distance() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("1.4", "-1.4")),
        "`distance[san-diego, topeka]` is -1.4: give a number that is not negative"
    );
}

#[test]
fn not_a_number() {
    assert_eq!(
        message("markets.csv", "market,demand_cases\nnew-york,NaN\n"),
        "markets.csv, line 2: `demand[new-york]` is NaN: give a number"
    );
}

#[test]
fn a_number_beyond_the_largest() {
    assert_eq!(
        message("markets.csv", "market,demand_cases\nnew-york,325\ntopeka,1e999\n"),
        "parameter `demand[topeka]` is inf: give a finite number"
    );
}

#[test]
fn a_distance_beyond_the_largest() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("1.4", "1e999")),
        "parameter `distance[san-diego, topeka]` is inf: give a finite number"
    );
}

#[test]
fn a_plant_given_twice() {
    assert_eq!(
        message("plants.csv", "plant,capacity_cases\nseattle,350\nseattle,600\n"),
        "plants.csv, line 3: `plants` has the label `seattle` twice"
    );
}

#[test]
fn a_pair_given_twice() {
    assert_eq!(
        message("distances.csv", format!("{DISTANCES}seattle,topeka,1.9\n")),
        "distances.csv, line 6: `distance[seattle, topeka]` is given twice, first in line 3"
    );
}

#[test]
fn a_pair_left_out() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("seattle,topeka,1.8\n", "")),
        "distances.csv: `distance[seattle, topeka]` has no value (missing: 1 of 4)"
    );
}

#[test]
fn an_unknown_plant() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("seattle,topeka", "seatle,topeka")),
        "distances.csv, line 3: `distance` names `seatle`, which is no label of `plants`; \
         did you mean `seattle`?"
    );
}

#[test]
fn an_unknown_market() {
    assert_eq!(
        message("distances.csv", DISTANCES.replace("san-diego,topeka", "san-diego,boston")),
        "distances.csv, line 5: `distance` names `boston`, which is no label of `markets`"
    );
}
