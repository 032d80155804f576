use super::super::samples::{Broken, Linear, fault, linear, transport};
use super::*;
use crate::model::{Equation, Set, Shape, Variable};
use crate::solver::Status;
use serde_json::Value;

/// Labels with commas and quotes, one free and one boxed variable at its upper bound.
fn awkward() -> Report {
    let set = Set::new("s", ["a, b", "say \"c\""]).unwrap();
    let shape = Shape::builder()
        .variable(Variable::new("x").over(&[&set]).unit("m, s"))
        .variable(Variable::new("y").lower(-0.0).upper(1.0 / 3.0))
        .variable(Variable::new("n").fixed(2.0))
        .equation(Equation::new("f").over(&[&set]).complements("x"))
        .equation(Equation::new("g").complements("y"))
        .build()
        .unwrap();
    let mut problem = Linear::diagonal(shape, &[1.0, 1.0, 1.0, 0.0], &[-0.1, 0.0, -7.0, 0.0]);
    let solution = problem.ended(&[0.1, 1e-300, 1.0 / 3.0, 2.0], Status::Solved);
    Report::new(&mut problem, &solution).unwrap()
}

fn json(report: &Report) -> Value {
    let mut out = Vec::new();
    report.write_json(&mut out).unwrap();
    serde_json::from_slice(&out).unwrap()
}

fn read_back(text: &str) -> Option<f64> {
    (!text.is_empty()).then(|| text.parse().unwrap())
}

#[test]
fn csv_reads_back_to_the_same_rows() {
    let report = awkward();
    let mut out = Vec::new();
    report.write_csv(&mut out).unwrap();
    let mut reader = csv::Reader::from_reader(&out[..]);
    assert_eq!(reader.headers().unwrap(), &COLUMNS[..]);
    let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), report.row_count());
    for (record, row) in records.iter().zip(report.rows()) {
        assert_eq!(record[0], row.variable);
        assert_eq!(read_back(&record[1]), Some(row.lower));
        assert_eq!(read_back(&record[2]), Some(row.level));
        assert_eq!(read_back(&record[3]), Some(row.upper));
        assert_eq!(read_back(&record[4]), row.marginal);
        assert_eq!(read_back(&record[5]), row.rent);
        assert_eq!(&record[6], row.state.name());
        assert_eq!(record[7], row.unit);
        assert_eq!(record[8], row.equation.unwrap_or_default());
    }
    assert_eq!(&records[0][0], "x[a, b]");
    assert_eq!(&records[1][8], "f[say \"c\"]");
    assert_eq!((&records[0][1], &records[0][3]), ("-inf", "inf"));
    assert_eq!((&records[2][1], &records[2][6]), ("0", "at upper"));
    assert_eq!(read_back(&records[2][5]), Some(7.0 - 1.0 / 3.0));
    assert_eq!((&records[3][4], &records[3][8]), ("", ""));
}

#[test]
fn json_reads_back_and_infinities_are_words() {
    let report = awkward().named("awkward \"model\"");
    let json = json(&report);
    assert_eq!(json["name"], "awkward \"model\"");
    assert_eq!(json["status"], "solved");
    assert_eq!(json["sign_convention"], SIGN_CONVENTION);
    assert_eq!(json["stats"]["jacobian_evaluations"], 2);
    assert_eq!(json["statistics"]["minimum_map"]["value"], 1e-300);
    assert_eq!(json["worst_equation"], "f[say \"c\"]");
    let variables = json["variables"].as_array().unwrap();
    assert_eq!(variables[0]["variable"], "x[a, b]");
    assert_eq!((&variables[0]["lower"], &variables[0]["upper"]), (&"-inf".into(), &"inf".into()));
    assert_eq!(variables[2]["level"].as_f64().unwrap().to_bits(), (1.0_f64 / 3.0).to_bits());
    assert_eq!(variables[2]["state"], "at_upper");
    assert_eq!(variables[3]["marginal"], Value::Null);
    let keys: Vec<&String> = variables[0].as_object().unwrap().keys().collect();
    assert!(COLUMNS.iter().all(|column| keys.iter().any(|key| key == column)));
    assert_eq!(keys.len(), COLUMNS.len());
}

#[test]
fn json_of_a_domain_error_has_the_fault_and_words_for_nan() {
    let mut problem = transport();
    let mut solution = problem.ended(&[f64::NAN, 0.0, 0.0, 0.0, 0.0, 1.0], Status::DomainError);
    solution.fault = Some(fault(0, Some(3), f64::NEG_INFINITY, &[1.0, 2.0, 0.5, -0.3, 0.0, 1.0]));
    let json = json(&Report::new(&mut problem, &solution).unwrap());
    assert_eq!(json["natural_residual"], "NaN");
    assert_eq!(json["worst_relative_equation"], Value::Null);
    assert_eq!(json["fault"]["value"], "-inf");
    assert_eq!(json["fault"]["derivative_by"], "p[new-york]");
    assert_eq!(json["fault"]["reads"][0]["value"], -0.3);
    assert_eq!(json["variables"][0]["level"], "NaN");
    assert_eq!(json["variables"][0]["state"], "outside");
}

#[test]
fn negative_zeros_lose_their_sign() {
    let mut problem = linear(2);
    let solution = problem.ended(&[-0.0, -0.0], Status::Solved);
    let report = Report::new(&mut problem, &solution).unwrap();
    let (mut csv, mut json) = (Vec::new(), Vec::new());
    report.write_csv(&mut csv).unwrap();
    report.write_json(&mut json).unwrap();
    assert!(!String::from_utf8(csv).unwrap().contains("-0"));
    assert!(!String::from_utf8(json).unwrap().contains("-0"));
}

#[test]
fn errors_of_the_writer_are_returned_as_such() {
    let report = awkward();
    let csv = report.write_csv(Broken { lines: 0 }).unwrap_err();
    let json = report.write_json(Broken { lines: 3 }).unwrap_err();
    for error in [csv, json] {
        assert!(
            matches!(&error, ReportError::Io(error) if error.to_string().contains("disk full"))
        );
    }
}
