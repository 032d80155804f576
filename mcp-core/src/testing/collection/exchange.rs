//! General equilibria of Scarf and Hansen: consumers with CES demands and linear activities.

use super::Instance;
use crate::error::ModelError;
use crate::mcp;
use crate::model::Model;

mcp! {
    /// Markets clear, activities make no profit, incomes are spent.
    model Economy {
        data {
            goods: Set, sectors: Set, agents: Set,
            endowment[goods, agents]: f64, share[goods, agents]: f64, output[goods, sectors]: f64,
            sigma[agents]: f64, floor[goods]: f64,
        }
        var p[c in goods] >= floor[c];
        var y[k in sectors] >= 0.0;
        var income[h in agents] >= 0.0;
        /// `P^(1−σ)` of the CES price index `P`
        def index[h in agents]:
            sum(goods, |c| when(share[c, h] > 0.0, || share[c, h] * p[c].pow(1.0 - sigma[h])));
        eq market[c in goods]: sum(sectors, |k| output[c, k] * y[k]) + sum(agents, |h| endowment[c, h])
            - sum(agents, |h| when(share[c, h] > 0.0,
                || income[h] / index[h] * share[c, h] * p[c].pow(-sigma[h])))   complements p[c];
        eq profit[k in sectors]: -sum(goods, |c| output[c, k] * p[c])           complements y[k];
        eq budget[h in agents]: income[h] - sum(goods, |c| endowment[c, h] * p[c])  complements income[h];
    }
}

/// Demands `d` become shares; a good that is consumed has a price of at least `1e-5`.
fn economy<const G: usize, const S: usize, const H: usize>(
    goods: [&str; G],
    endowment: [[f64; H]; G],
    demand: [[f64; H]; G],
    output: [[f64; S]; G],
    sigma: [f64; H],
) -> Result<Economy, ModelError> {
    let total: [f64; H] = std::array::from_fn(|h| demand.iter().map(|d| d[h]).sum());
    let share = demand.map(|d| std::array::from_fn::<f64, H, _>(|h| d[h] / total[h]));
    let floor = demand.map(|d| if d.iter().any(|&d| d > 0.0) { 1e-5 } else { 0.0 });
    let numbers = |n: usize| (1..=n).map(|k| k.to_string()).collect::<Vec<_>>();
    Economy::builder()
        .goods(goods)
        .sectors(numbers(S))
        .agents(numbers(H))
        .endowment(endowment)
        .share(share)
        .output(output)
        .sigma(sigma)
        .floor(floor)
        .build()
}

const SCARF_GOODS: [&str; 6] = ["capeop", "nondurbl", "durable", "capbop", "skillab", "unsklab"];
const SCARF_ENDOWMENT: [[f64; 5]; 6] = [
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [1.0, 2.0, 1.5, 1.0, 2.0],
    [3.0, 0.1, 2.0, 1.0, 6.0],
    [5.0, 0.1, 6.0, 0.1, 0.1],
    [0.1, 7.0, 0.1, 8.0, 0.5],
];
const SCARF_DEMAND: [[f64; 5]; 6] = [
    [4.0, 0.4, 2.0, 5.0, 3.0],
    [2.0, 4.0, 2.0, 5.0, 4.0],
    [3.2, 1.0, 1.5, 4.5, 2.0],
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [0.2, 0.0, 0.5, 0.0, 0.0],
    [0.0, 0.6, 0.0, 0.2, 0.2],
];
const SCARF_OUTPUT: [[f64; 8]; 6] = [
    [4.0, 4.0, 1.6, 1.6, 1.6, 0.9, 7.0, 8.0],
    [0.0, 0.0, 6.0, 8.0, 7.0, 0.0, 0.0, 0.0],
    [4.0, 3.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-5.3, -5.0, -2.0, -2.0, -2.0, -1.0, -4.0, -5.0],
    [-2.0, -1.0, -2.0, -4.0, -1.0, 0.0, -3.0, -2.0],
    [-1.0, -6.0, -3.0, -1.0, -8.0, 0.0, -1.0, -8.0],
];

fn scarf_economy() -> Result<Economy, ModelError> {
    let sigma = [1.2, 1.6, 0.8, 0.5, 0.6];
    economy(SCARF_GOODS, SCARF_ENDOWMENT, SCARF_DEMAND, SCARF_OUTPUT, sigma)
}

/// Endowments at unit prices.
fn scarf_incomes() -> [f64; 5] {
    std::array::from_fn(|h| SCARF_ENDOWMENT.iter().map(|e| e[h]).sum())
}

/// The model of `scarfmcp`.
pub(super) fn scarf_with_numeraire() -> Result<impl Model + 'static, ModelError> {
    let mut model = scarf_economy()?;
    model.fix("income[1]", scarf_incomes()[0])?;
    Ok(model)
}

/// The income of agent 1 is the numeraire, fixed at the value of the endowment at unit prices;
/// `scarf-ray` has none.
pub(super) fn scarf() -> Result<Vec<Instance>, ModelError> {
    let value = scarf_incomes();
    let start = |price: f64, activity: f64, income: [f64; 5]| {
        [&[price; 6][..], &[activity; 8], &income].concat()
    };
    let mut starts = [
        start(1.0, 1.0, value),
        start(0.1, 0.0, value.map(|v| 0.1 * v)),
        start(5.0, 3.0, value.map(|v| 5.0 * v)),
        start(1.0, 0.0, [1.0; 5]),
    ];
    let source = "Scarf (1973), The Computation of Economic Equilibria; MCPLIB";
    let ray = Instance::new("scarf-ray", source, scarf_economy()?).starting_at(starts[0].clone());
    for start in &mut starts {
        start[14] = value[0];
    }
    let instances = Instance::new("scarfmcp", source, scarf_with_numeraire()?).at_starts(&starts);
    Ok([instances, vec![ray]].concat())
}

const HANSEN_GOODS: [&str; 14] = [
    "agric", "food", "textiles", "hserv", "entert", "houseop", "capeop", "steel", "coal", "lumber",
    "housbop", "capbop", "labor", "exchange",
];
const HANSEN_ENDOWMENT: [[f64; 4]; 14] = [
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [2.0, 0.4, 0.0, 0.8],
    [3.0, 2.0, 0.0, 7.5],
    [0.6, 0.8, 1.0, 0.6],
    [0.0, 0.0, 0.0, 0.0],
];
const HANSEN_DEMAND: [[f64; 4]; 14] = [
    [0.1, 0.2, 0.3, 0.1],
    [0.2, 0.2, 0.2, 0.2],
    [0.1, 0.1, 0.3, 0.1],
    [0.1, 0.1, 0.1, 0.1],
    [0.1, 0.1, 0.1, 0.1],
    [0.3, 0.1, 0.0, 0.1],
    [0.1, 0.2, 0.0, 0.3],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0],
];
#[rustfmt::skip]
const HANSEN_OUTPUT: [[f64; 26]; 14] = [
    [5.0, -3.5, -0.1, 0.0, -0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-0.9, 5.0, -0.1, 0.0, -0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-0.2, -0.5, 2.0, -0.1, -0.1, -0.8, -0.4, -0.1, -0.1, -0.1, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0],
    [-1.0, -2.0, -2.0, 2.0, -2.0, -0.4, -1.8, -1.6, -0.8, -0.2, 0.0, 0.0, -0.4, -0.2, -0.2, -0.4, -0.4, -0.4, -0.4, -0.2, -0.2, -0.2, -0.4, -0.4, -0.4, -0.4],
    [0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.32, 0.0, 0.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.36, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.4, 1.3, 1.2, 0.0, 0.0, 1.1, 6.0, 1.8, 1.2, 0.4, 0.9, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
    [-0.2, -0.4, -0.2, -0.1, 0.0, -1.0, -2.0, 2.0, -0.5, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0],
    [-1.0, -0.1, -0.1, -1.0, 0.0, 0.0, -0.2, -1.0, 2.0, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0],
    [-0.5, -0.4, -0.3, -0.3, 0.0, -3.0, -0.2, -0.2, -0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
    [0.0, 0.0, 0.0, -0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-0.5, -1.5, -1.5, -0.1, -0.1, -1.5, -2.5, -2.5, -1.5, -0.5, -1.0, 0.0, -0.2, -0.1, -0.1, -0.2, -0.2, -0.2, -0.2, -0.2, -0.1, -0.1, -0.2, -0.2, -0.2, -0.2],
    [-0.4, -0.2, -0.2, -0.02, -0.4, -0.3, -0.1, -0.1, -0.4, -0.4, 0.0, 0.0, -0.04, -0.02, -0.02, -0.04, -0.04, -0.04, -0.04, -0.04, -0.02, -0.02, -0.04, -0.04, -0.04, -0.04],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, -0.4, -0.8, -1.2, -0.6, -0.7, -0.4, 0.5, 0.4, 0.8, 1.2, 0.6, 0.7, 0.4],
];

/// Cobb–Douglas demands; the price of agricultural goods is the numeraire.
pub(super) fn hansen() -> Result<Vec<Instance>, ModelError> {
    let mut model =
        economy(HANSEN_GOODS, HANSEN_ENDOWMENT, HANSEN_DEMAND, HANSEN_OUTPUT, [1.0; 4])?;
    model.fix("p[agric]", 1.0)?;
    let levels = [(1.0, 1.0, 1.0), (0.2, 0.0, 0.5), (4.0, 2.0, 10.0), (1.0, 0.0, 5.0)];
    let starts = levels.map(|(price, activity, income)| {
        let mut start = [&[price; 14][..], &[activity; 26], &[income; 4]].concat();
        start[0] = 1.0;
        start
    });
    let source = "Scarf & Hansen (1973), The Computation of Economic Equilibria; MCPLIB";
    Ok(Instance::new("hansmcp", source, model).at_starts(&starts))
}
