//! A misspelt name.

use mcp_core::mcp;

mcp! {
    /// Mills sell flour on one market.
    model Flour {
        data { mills: Set, cost[mills]: f64, slope[mills]: f64, limit[mills]: f64 }
        param tax = 0.0;
        var q[m in mills] in 0.0..=limit[m];
        var p >= 0.0 start 1.0;
        eq profit[m in mills]: cost[m] + slpoe[m] * q[m] + tax - p    complements q[m];
        eq market: sum(mills, |m| q[m]) >= 10.0 - p                   complements p;
    }
}

fn main() {}
