use super::*;

const FLOWS: [[f64; 3]; 3] = [[0.0, 0.0, 100.0], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0]];

fn told(flows: [[f64; 3]; 3]) -> String {
    Sam::new(["bread", "labor", "household"], flows).unwrap_err().to_string()
}

#[test]
fn an_unbalanced_account_is_named_with_both_sums() {
    let mut flows = FLOWS;
    flows[2][1] = 99.0;
    assert_eq!(told(flows), "account `labor` receives 100 but pays 99");
    flows[2][1] = 100.0 + 1e-8;
    assert!(Sam::new(["bread", "labor", "household"], flows).is_ok());
}

#[test]
fn rounding_errors_of_flows_that_cancel_are_balanced_and_sums_that_overflow_are_not() {
    // 0.1 + 0.2 − 0.3 is 5.6e-17, and the account pays nothing.
    let flows = [[0.1, 0.2, -0.3], [-0.1, 0.0, 0.1], [0.0, -0.2, 0.2]];
    assert!(Sam::new(["bread", "tax", "subsidy"], flows).is_ok());
    let told = Sam::new(["a", "b"], [[1e308; 2]; 2]).unwrap_err().to_string();
    assert!(told.starts_with("account `a` receives inf but pays inf"), "{told}");
}

#[test]
fn a_flow_that_is_no_number_is_named_by_its_cell() {
    let mut flows = FLOWS;
    flows[1][0] = f64::INFINITY;
    assert_eq!(told(flows), "cell [labor, bread] is inf: give a number");
    flows[1][0] = f64::NAN;
    assert_eq!(told(flows), "`flow[labor, bread]` is NaN: give a number");
}

#[test]
fn a_negative_flow_is_refused_as_data_and_named_by_its_cell() {
    let flows = [[0.0, 20.0, 80.0], [100.0, 0.0, -20.0], [0.0, 60.0, 0.0]];
    let sam = Sam::new(["bread", "labor", "household"], flows).unwrap();
    assert_eq!(sam.get("labor", "household").unwrap(), -20.0);
    let told = sam.block(&["labor", "bread"], &["household"]).unwrap_err().to_string();
    assert_eq!(told, "cell [labor, household] is -20: this flow may not be negative");
    assert!(sam.row("labor", &["bread"]).is_ok());
}

#[test]
fn accounts_that_are_not_there_are_answered_with_the_nearest() {
    let sam = Sam::new(["bread", "labor", "household"], FLOWS).unwrap();
    let told = sam.get("labour", "bread").unwrap_err().to_string();
    assert_eq!(told, "there is no account `labour`; did you mean `labor`?");
    assert!(sam.total("rent").is_err() && sam.column(&["bread"], "rent").is_err());
    let told = Sam::new(["bread", "bread"], [[0.0; 2]; 2]).unwrap_err().to_string();
    assert_eq!(told, "set `accounts` has the label `bread` twice");
}

#[test]
fn blocks_are_data_of_a_model() {
    let sam = Sam::new(["bread", "labor", "household"], FLOWS).unwrap();
    let [one, two] = ["bread", "labor"].map(|label| Set::new(label, [label]).unwrap());
    let accounts = sam.accounts().clone();
    let block = sam.block(&["labor"], &["bread"]).unwrap();
    assert_eq!(block.resolve("use", &[&two, &one]).unwrap(), [100.0]);
    let all = ["bread", "labor", "household"];
    assert_eq!(sam.row("labor", &all).unwrap().resolve("v", &[&accounts]).unwrap(), FLOWS[1]);
    assert_eq!(
        sam.column(&all, "labor").unwrap().resolve("v", &[&accounts]).unwrap(),
        [0.0, 0.0, 100.0]
    );
    assert_eq!(sam.total("household").unwrap(), 100.0);
}

#[cfg(feature = "serde")]
mod csv {
    use super::*;

    const TEXT: &str = "
        ,        labor, household, bread
        bread,        ,       100,
        labor,        ,          , 100
        household, 100,          ,
    ";

    fn told(text: &str) -> String {
        Sam::csv_text("sam.csv", text).unwrap_err().to_string()
    }

    #[test]
    fn columns_come_in_any_order_and_empty_cells_are_zero() {
        let sam = Sam::csv_text("sam.csv", TEXT).unwrap();
        assert_eq!(sam.flows, FLOWS.concat());
        let labels: Vec<String> = sam.accounts().labels().collect();
        assert_eq!(labels, ["bread", "labor", "household"]);
    }

    #[test]
    fn faults_are_named_with_file_line_and_cell() {
        assert_eq!(
            told(&TEXT.replace("labor,        ,          , 100", "labor,        ,          , 90")),
            "sam.csv: account `bread` receives 100 but pays 90"
        );
        assert_eq!(
            told(&TEXT.replace(", 100\n", ", many\n")),
            "sam.csv, line 4, column `bread`: `many` is not a number"
        );
        assert_eq!(
            told(&TEXT.replace("household, 100,          ,", "")),
            "sam.csv: account `household` has a column but no row"
        );
        assert_eq!(
            told(&TEXT.replace("household, 100", "houshold, 100")),
            "sam.csv: account `household` has a column but no row; did you mean `houshold`?"
        );
        let narrow = ",bread,labor\nbread,,1\nlabor,1,\nhousehold,,";
        assert_eq!(told(narrow), "sam.csv: account `household` has a row but no column");
        assert_eq!(told(",a,a\na,1,1"), "sam.csv, line 1: there are two columns `a`");
        assert_eq!(told(",a\na,1\na,1"), "set `accounts` has the label `a` twice");
        let negative = Sam::csv_text("sam.csv", ",a,b\na,2,-1\nb,-1,3").unwrap();
        assert_eq!(
            negative.row("a", &["b"]).unwrap_err().to_string(),
            "sam.csv: cell [a, b] is -1: this flow may not be negative"
        );
    }
}
