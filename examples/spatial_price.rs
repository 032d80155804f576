//! # Grain between regions: prices, trade and the rent of a full river
//!
//! Region `i` supplies `y_i` [Mt] at the marginal cost `a_i + b_i y_i` [$/t] and demands
//! `d_i (p_i/p̄_i)^(−ε_i)` [Mt] at its price `p_i` [$/t]. Arc `r` ships `x_r` [Mt] from `i` to `j`
//! at the cost `c_r` [$/t], up to its capacity `k_r`:
//!
//! ```text
//! p_i + c_r − p_j                                       ⟂   0 <= x_r <= k_r   no gain by trade
//! a_i + b_i y_i − p_i                             >= 0   ⟂   y_i >= 0          no gain by supply
//! y_i + Σ_(r into i) x_r − Σ_(r out of i) x_r − demand   ⟂   p_i > 0           the market clears
//! ```
//!
//! An arc below its capacity ties two prices together, a full one parts them: what the price
//! difference leaves after the cost is its rent, `−F` at the upper bound.
//!
//! Source of the model: Takayama & Judge, *Spatial and Temporal Price and Allocation Models*,
//! North-Holland 1971. The data, in `examples/data/spatial_price`, are invented. Supply rises and
//! demand falls with the price, so that there is one equilibrium. Expected: all regions are one
//! market. Plains and delta both sell at the coast, by rail and canal for 20 + 25 $/t and by train
//! for 12 $/t, so that grain is worth 33 $/t more in the delta, and the full barges between them,
//! at 15 $/t, earn a rent of 18 $/t. With barges enough, all grain goes by river, and the lakes
//! trade with nobody. `tests/gallery/spatial_price.rs` finds the prices by bisection.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::language::{LabelPairs, Labels, Table};
use mcp_core::{ModelError, Options, mcp, solve};
use std::error::Error;
use std::path::Path;

mcp! {
    /// Regions trade a good along arcs of limited capacity.
    pub(crate) model SpatialPrice {
        data {
            regions: Set,
            arcs: Pairs(regions, regions),
            curves: Set[intercept, slope, demand, price, elasticity],
            freights: Set[cost, capacity],
            /// supply and demand of a region
            curve[regions, curves]: f64,
            /// cost [$/t] and capacity [Mt] of an arc
            freight[arcs, freights]: f64,
        }

        /// shipment [Mt]
        var x[r in arcs] in 0.0..=freight[r, capacity];
        /// supply [Mt]
        var y[i in regions] >= 0.0;
        /// price [$/t]
        var p[i in regions] >= 1e-9 start curve[i, price];

        /// demand [Mt]
        def d[i in regions]: curve[i, demand] * (p[i] / curve[i, price]).pow(-curve[i, elasticity]);

        eq arbitrage[r @ (i, j) in arcs]: p[i] + freight[r, cost] - p[j]         complements x[r];
        eq profit[i in regions]:
            curve[i, intercept] + curve[i, slope] * y[i] >= p[i]                 complements y[i];
        eq market[i in regions]:
            y[i] + sum(arcs.into(i), |r| x[r]) >= d[i] + sum(arcs.out_of(i), |r| x[r])
            complements p[i];

        /// shipment from the first region to the second [Mt]
        report trade[i in regions, j in regions]:
            sum(arcs.out_of(i), |r| when(arcs.ends(r).1 == j, || x[r]));
    }
}

/// The invented data.
pub(crate) const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/spatial_price");

/// Prices [$/t] with the barges of the data, and with barges enough.
pub(crate) const PRICES: [(&str, [f64; 2]); 5] = [
    ("plains", [196.877, 207.878]),
    ("lakes", [216.877, 210.622]),
    ("delta", [229.877, 222.878]),
    ("coast", [241.877, 234.878]),
    ("islands", [271.877, 264.878]),
];

impl SpatialPrice {
    /// Reads `regions.csv`, `arcs.csv` and `freight.csv` of a directory.
    pub(crate) fn read(directory: &Path) -> Result<Self, ModelError> {
        let regions = directory.join("regions.csv");
        SpatialPrice::builder()
            .regions(Labels::csv(&regions))
            .curve(Table::csv(&regions))
            .arcs(LabelPairs::csv(directory.join("arcs.csv")))
            .freight(Table::csv(directory.join("freight.csv")))
            .build()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut model = SpatialPrice::read(DATA.as_ref())?;
    let few = solve(&model, &Options::default())?.solved()?;
    let view = model.view(&few)?;
    println!("a river with barges for 8 Mt");
    print_market(&view)?;
    let rent = -view.x.marginal("barge")?;
    println!("rent of the barges: {rent:.2} $/t\n");
    check_prices(&view, 0);
    assert!((rent - 18.0).abs() < 1e-9);

    model.set_upper("x[barge]", f64::INFINITY)?;
    model.start_from(&few)?;
    let enough = solve(&model, &Options::default())?.solved()?;
    let view = model.view(&enough)?;
    println!("barges enough, {} iterations from there", enough.stats.iterations);
    print_market(&view)?;
    check_prices(&view, 1);
    assert!(view.x["rail"] < 1e-9 && view.x["canal"] < 1e-9);
    Ok(())
}

fn check_prices(view: &SpatialPriceView, case: usize) {
    for (region, prices) in PRICES {
        assert!((view.p[region] - prices[case]).abs() < 1e-3, "{region}: {}", view.p[region]);
    }
}

/// Who supplies, buys and ships what, from the region on the left to the one above.
fn print_market(view: &SpatialPriceView) -> Result<(), ModelError> {
    print!("{:<10}", "Mt");
    view.p.iter().for_each(|([region], _)| print!("{region:>9}"));
    println!("{:>9}{:>9}{:>9}", "supply", "demand", "$/t");
    for ([from], price) in view.p.iter() {
        print!("{from:<10}");
        for ([to], _) in view.p.iter() {
            let shipped = view.trade.get((&from, &to))?;
            if shipped > 1e-9 { print!("{shipped:>9.2}") } else { print!("{:>9}", "·") }
        }
        println!("{:>9.2}{:>9.2}{price:>9.2}", view.y[&from], view.d[&from]);
    }
    Ok(())
}
