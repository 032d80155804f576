//! A general equilibrium with nested CES production, in calibrated share form.

use mcp_core::economics::{ces, ces2, cobb};
use mcp_core::{Options, check_point, mcp, solve};

#[allow(dead_code, unreachable_pub, reason = "the example is included whole")]
#[path = "../../examples/cge_tax.rs"]
mod cge_tax;

mcp! {
    /// Y = CES(VA(factors), intermediates) with an output tax.
    pub model Cge {
        data {
            sectors: Set, factors: Set[labor, capital],
            y0[sectors]: f64, va0[sectors]: f64, id0[sectors, sectors]: f64, fd0[factors, sectors]: f64,
            c0[sectors]: f64, g0[sectors]: f64, fbar[factors]: f64, tf0[factors, sectors]: f64,
            sva[sectors]: f64, sy[sectors]: f64, sc: f64,
        }
        param ty[s in sectors] = 0.0;
        /// activity level [base = 1]
        var y[s in sectors] >= 0.0 start 1.0;    var p[s in sectors] >= 1e-9 start 1.0;
        var pf[f in factors] >= 1e-9 start 1.0;  var hh free start sum(factors, |f| fbar[f]);
        var gov free start sum(sectors, |s| g0[s]);
        fix pf[labor] = 1.0;
        def pfu[f in factors, s in sectors]: pf[f] / (1.0 + tf0[f, s]);
        def cva[s in sectors]: ces(sva[s], factors, |f| (fd0[f, s] / va0[s], pfu[f, s]));
        def cin[s in sectors]: cobb(sectors, |k| (id0[k, s], p[k]));
        def cy[s in sectors]:  ces2(sy[s], va0[s] / (y0[s] * (1.0 - ty.base(s))), cva[s], cin[s]);
        def df[f in factors, s in sectors]: fd0[f,s] * y[s] * (cy[s]/cva[s]).pow(sy[s]) * (cva[s]/pfu[f,s]).pow(sva[s]);
        def cpi: ces(sc, sectors, |s| (c0[s] / c0.sum(), p[s]));
        eq zero_profit[s in sectors]: cy[s] * (1.0 - ty.base(s)) - p[s] * (1.0 - ty[s])   complements y[s];
        eq goods[s in sectors]: y0[s] * y[s] - sum(sectors, |k| id0[s, k] * y[k] * (cy[k]/cin[k]).pow(sy[k]) * cin[k]/p[s])
             - c0[s] / c0.sum() * hh / cpi * (cpi/p[s]).pow(sc) - g0[s] * gov / (g0.sum() * p[s])   complements p[s];
        eq endow[f in factors]: fbar[f] - sum(sectors, |s| df[f, s])                  complements pf[f];
        eq income: hh - sum(factors, |f| pf[f] * fbar[f])                             complements hh;
        eq budget: gov - sum(sectors, |s| ty[s] * p[s] * y0[s] * y[s])                complements gov;
        report welfare: hh / cpi / c0.sum();
        part ftax { param tf[f in factors, s in sectors] = tf0[f, s];
          adds pfu[f, s]: pf[f] * tf[f, s] / (1.0 + tf0[f, s]);
          adds budget: -sum(factors, |f| sum(sectors, |s| tf[f, s] * pf[f] * df[f, s])); }
    }
}

const Y0: [f64; 2] = [100.0, 200.0];
const VA0: [f64; 2] = [60.0, 110.0];
const ID0: [[f64; 2]; 2] = [[10.0, 30.0], [20.0, 40.0]];
const FD0: [[f64; 2]; 2] = [[40.0, 60.0], [20.0, 50.0]];
const C0: [f64; 2] = [50.0, 120.0];
const G0: [f64; 2] = [10.0, 20.0];
const FBAR: [f64; 2] = [100.0, 70.0];
const TAX: f64 = 0.1;
const SVA: [f64; 2] = [0.8, 1.0];
const SY: [f64; 2] = [0.0, 0.5];
const SC: f64 = 1.5;

fn economy() -> Cge {
    Cge::builder()
        .sectors(["agriculture", "manufacturing"])
        .y0(Y0)
        .va0(VA0)
        .id0(ID0)
        .fd0(FD0)
        .c0(C0)
        .g0(G0)
        .fbar(FBAR)
        .tf0(0.0)
        .sva(SVA)
        .sy(SY)
        .sc(SC)
        .ty(TAX)
        .build()
        .unwrap()
}

#[test]
fn the_benchmark_is_a_solution() {
    let model = economy();
    let start = model_start(&model);
    let check = check_point(&model, &start).unwrap();
    assert!(check.residual() < 1e-12, "{check}");
}

fn model_start(model: &Cge) -> Vec<f64> {
    use mcp_core::Model;
    model.shape().start().to_vec()
}

/// The same economy on plain numbers: for a price of capital, goods prices by iterating zero
/// profits, quantities by iterating the market clearing of goods, and the capital market by
/// bisection. The wage is 1.
struct Reference {
    p: [f64; 2],
    y: [f64; 2],
    rent: f64,
    gov: f64,
}

fn unit_ces(sigma: f64, terms: [(f64, f64); 2]) -> f64 {
    if sigma == 1.0 {
        return terms.iter().map(|(share, price)| price.powf(*share)).product();
    }
    let rho = 1.0 - sigma;
    terms.iter().map(|(share, price)| share * price.powf(rho)).sum::<f64>().powf(1.0 / rho)
}

/// `factor_tax[f][s]` comes on top of the price of factor `f`.
fn at_rent(rent: f64, tax: [f64; 2], factor_tax: [[f64; 2]; 2]) -> (Reference, f64) {
    let factor = [1.0, rent];
    let paid = |f: usize, s: usize| factor[f] * (1.0 + factor_tax[f][s]);
    let cva: [f64; 2] =
        std::array::from_fn(|s| unit_ces(SVA[s], [0, 1].map(|f| (FD0[f][s] / VA0[s], paid(f, s)))));
    let mut p = [1.0_f64; 2];
    let (mut cin, mut cy) = ([1.0; 2], [1.0; 2]);
    for _ in 0..2000 {
        for s in 0..2 {
            let total = ID0[0][s] + ID0[1][s];
            cin[s] = p[0].powf(ID0[0][s] / total) * p[1].powf(ID0[1][s] / total);
            let share = VA0[s] / (Y0[s] * (1.0 - TAX));
            cy[s] = unit_ces(SY[s], [(share, cva[s]), (1.0 - share, cin[s])]);
            p[s] = cy[s] * (1.0 - TAX) / (1.0 - tax[s]);
        }
    }
    let hh = FBAR[0] + rent * FBAR[1];
    let cpi = unit_ces(SC, [0, 1].map(|s| (C0[s] / 170.0, p[s])));
    let mut y = [1.0; 2];
    let mut gov = 0.0;
    for _ in 0..4000 {
        let used = |f: usize, s: usize| used(f, s, y, cy, cva, paid(f, s));
        let on_factors =
            |s: usize| (0..2).map(|f| factor_tax[f][s] * factor[f] * used(f, s)).sum::<f64>();
        gov = (0..2).map(|s| tax[s] * p[s] * Y0[s] * y[s] + on_factors(s)).sum();
        y = std::array::from_fn(|s| {
            let intermediate: f64 = (0..2)
                .map(|k| ID0[s][k] * y[k] * (cy[k] / cin[k]).powf(SY[k]) * cin[k] / p[s])
                .sum();
            let household = C0[s] / 170.0 * hh / cpi * (cpi / p[s]).powf(SC);
            (intermediate + household + G0[s] * gov / (30.0 * p[s])) / Y0[s]
        });
    }
    let capital: f64 = (0..2).map(|s| used(1, s, y, cy, cva, paid(1, s))).sum();
    (Reference { p, y, rent, gov }, FBAR[1] - capital)
}

/// Factor `f` that sector `s` uses at the price `paid`.
fn used(f: usize, s: usize, y: [f64; 2], cy: [f64; 2], cva: [f64; 2], paid: f64) -> f64 {
    FD0[f][s] * y[s] * (cy[s] / cva[s]).powf(SY[s]) * (cva[s] / paid).powf(SVA[s])
}

/// The equilibrium at these taxes: the rent by bisection.
fn reference(tax: [f64; 2], factor_tax: [[f64; 2]; 2]) -> Reference {
    let (mut low, mut high) = (0.2, 5.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        // A higher rent leaves capital over.
        if at_rent(middle, tax, factor_tax).1 < 0.0 { low = middle } else { high = middle }
    }
    at_rent(0.5 * (low + high), tax, factor_tax).0
}

#[test]
fn a_tax_on_one_sector_moves_prices_as_in_an_independent_computation() {
    let tax = [0.1, 0.3];
    let mut model = economy();
    model.set_parameter("ty", &tax).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();

    let reference = reference(tax, [[0.0; 2]; 2]);
    for (s, sector) in ["agriculture", "manufacturing"].into_iter().enumerate() {
        assert!((view.p[sector] - reference.p[s]).abs() < 1e-8);
        assert!((view.y[sector] - reference.y[s]).abs() < 1e-8);
        assert_eq!(view.ty[sector], tax[s]);
    }
    assert!((view.pf["capital"] - reference.rent).abs() < 1e-8);
    assert!((view.gov - reference.gov).abs() < 1e-6);
    assert_eq!(view.pf["labor"], 1.0);
    // Walras: the labour market, whose equation is dropped because its price is fixed, clears too.
    assert!(solution.marginal("pf[labor]").unwrap().abs() < 1e-8);
    assert!(view.welfare < 1.0);
}

#[test]
fn a_tax_on_factors_of_rate_zero_changes_nothing() {
    let (base, taxed) = (economy(), economy().with(Ftax).unwrap());
    let levels = |model: &Cge| solve(model, &Options::default()).unwrap().solved().unwrap().z;
    for (without, with) in levels(&base).iter().zip(levels(&taxed)) {
        assert!((without - with).abs() <= 1e-12 * without.abs().max(1.0));
    }
}

#[test]
fn a_tax_on_capital_moves_prices_as_in_an_independent_computation() {
    let factor_tax = [[0.0, 0.0], [0.1, 0.4]];
    let mut model = economy().with(Ftax).unwrap();
    model.set_parameter("tf", &factor_tax.concat()).unwrap();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();

    let reference = reference([TAX; 2], factor_tax);
    for (s, sector) in ["agriculture", "manufacturing"].into_iter().enumerate() {
        assert!((view.p[sector] - reference.p[s]).abs() < 1e-8);
        assert!((view.y[sector] - reference.y[s]).abs() < 1e-8);
        assert_eq!(view.tf[("capital", sector)], factor_tax[1][s]);
    }
    assert!((view.pf["capital"] - reference.rent).abs() < 1e-8);
    assert!((view.gov - reference.gov).abs() < 1e-6);
    assert!(reference.rent < 0.9, "who uses capital pays less for it before tax");
}

#[test]
fn the_example_reports_the_changes_of_the_independent_computation() {
    let none = [[0.0; 2]; 2];
    let (before, after) = (reference([TAX, TAX], none), reference([TAX, cge_tax::TAX], none));
    let percent = |before: f64, after: f64| 100.0 * (after / before - 1.0);
    let expected = [
        percent(before.p[0], after.p[0]),
        percent(before.p[1], after.p[1]),
        percent(before.rent, after.rent),
        percent(before.y[0], after.y[0]),
        percent(before.y[1], after.y[1]),
        percent(before.gov, after.gov),
    ];
    for ((name, stated), expected) in cge_tax::CHANGES.into_iter().zip(expected) {
        assert!((stated - expected).abs() < 5e-5, "{name}: {stated} {expected}");
    }
}
