//! Prices of fourteen analgesics in a game of their producers (Choi et al., 1990).

use super::Instance;
use crate::error::ModelError;
use crate::mcp;

mcp! {
    /// Thirty subjects choose among brands by a logit model; each brand maximises its own profit:
    /// `−∂ profit_j / ∂ p_j ⟂ p_j >= cost_j`.
    model Logit {
        data {
            subjects: 30, brands: 14, cost[brands]: f64,
            w[subjects]: f64, appeal[subjects, brands]: f64,
        }
        var p[j in brands] >= cost[j];
        def e[i in subjects, j in brands]: (w[i] * p[j] + appeal[i, j]).exp();
        /// with 1 for buying nothing
        def total[i in subjects]: 1.0 + sum(brands, |j| e[i, j]);
        eq margin[j in brands]: -sum(subjects, |i| e[i, j] / total[i]
            * (1.0 + (p[j] - cost[j]) * w[i] * (total[i] - e[i, j]) / total[i])) / 30.0   complements p[j];
    }
}

/// Scale of the choice.
const CHI: f64 = 3.0;

impl Logit {
    /// Utility falls with price and with the squared distance of a brand from a subject's ideal.
    fn new() -> Result<Self, ModelError> {
        let appeal: Vec<f64> = (0..30)
            .flat_map(|i| {
                ATTRIBUTES.map(|x| {
                    let distance: f64 = x.iter().zip(IDEAL[i]).map(|(x, y)| (x - y).powi(2)).sum();
                    -CHI * (IMPORTANCE[i] * distance + CONSTANT[i])
                })
            })
            .collect();
        let w = PRICE_WEIGHT.map(|w| -CHI * w);
        Logit::builder().cost(COST).w(w).appeal(appeal).build()
    }
}

/// The price of brand 8 is given, but for the last instance.
pub(super) fn choi() -> Result<Vec<Instance>, ModelError> {
    let source = "Choi, DeSarbo & Harker (1990), Management Science 36; MCPLIB";
    let starts = [COST.map(|c| c + 0.01), COST.map(|c| c + 1.0), COST].map(|mut start| {
        start[7] = 0.199;
        start
    });
    let mut fixed = Logit::new()?;
    fixed.fix("p[8]", 0.199)?;
    let free = Instance::new("choi-free8", source, Logit::new()?);
    let free = free.starting_at(COST.map(|c| c + 0.01));
    Ok([Instance::new("choi", source, fixed).at_starts(&starts), vec![free]].concat())
}

const ATTRIBUTES: [[f64; 4]; 14] = [
    [0.0, 0.5, 0.0, 0.0],
    [0.4, 0.0, 0.032, 0.0],
    [0.0, 0.5, 0.0, 0.0],
    [0.325, 0.0, 0.0, 0.15],
    [0.325, 0.0, 0.0, 0.0],
    [0.324, 0.0, 0.0, 0.1],
    [0.421, 0.0, 0.032, 0.075],
    [0.5, 0.0, 0.0, 0.1],
    [0.0, 0.5, 0.0, 0.0],
    [0.25, 0.25, 0.065, 0.0],
    [0.0, 0.5, 0.0, 0.0],
    [0.0, 0.5, 0.0, 0.0],
    [0.0, 0.325, 0.0, 0.0],
    [0.227, 0.194, 0.0, 0.075],
];

const IDEAL: [[f64; 4]; 30] = [
    [0.0, 0.0835, 0.0, 0.0331],
    [0.0, 0.543, 0.0075, 0.0204],
    [0.0, 0.4889, 0.0055, 0.0],
    [0.479, 0.0568, 0.0, 0.0725],
    [0.3202, 0.0, 0.0013, 0.0],
    [0.0, 0.1395, 0.0, 0.0],
    [0.0, 0.4805, 0.0, 0.0],
    [0.0649, 0.3759, 0.0022, 0.0],
    [0.0, 0.3834, 0.0, 0.0],
    [0.3431, 0.0908, 0.0, 0.0695],
    [0.0484, 0.3229, 0.0351, 0.0],
    [0.2696, 0.0741, 0.0005, 0.111],
    [0.4348, 0.0276, 0.0013, 0.0605],
    [0.2634, 0.0, 0.0022, 0.0],
    [0.3163, 0.0581, 0.0, 0.0],
    [0.0859, 0.0488, 0.0, 0.1355],
    [0.3197, 0.032, 0.0424, 0.063],
    [0.1872, 0.7724, 0.0, 0.0186],
    [0.4398, 0.0235, 0.023, 0.0765],
    [0.0, 0.196, 0.0, 0.0604],
    [0.0242, 0.5938, 0.0016, 0.0002],
    [0.0016, 0.5157, 0.0399, 0.0079],
    [0.2584, 0.0761, 0.0024, 0.0065],
    [0.0, 0.5171, 0.0, 0.0],
    [0.1094, 0.1291, 0.0, 0.0934],
    [0.0153, 0.2855, 0.0, 0.0],
    [0.1851, 0.0874, 0.0322, 0.0903],
    [0.1289, 0.262, 0.1226, 0.0],
    [0.0472, 0.2513, 0.0059, 0.0],
    [0.2752, 0.0199, 0.0003, 0.0224],
];

const IMPORTANCE: [f64; 30] = [
    15.13539, 4.62777, 2.21225, 0.0, 0.0, 10.58941, 5.0178, 3.51912, 9.10098, 0.0, 10.53417, 0.0,
    0.0, 0.0, 0.0, 7.46487, 0.64571, 4.8654, 0.53507, 5.31825, 6.86056, 5.69439, 0.0, 5.98602,
    14.47467, 13.5548, 13.01291, 22.7317, 5.13727, 0.07553,
];

const CONSTANT: [f64; 30] = [
    -4.42859, -2.04758, -1.82057, -3.22572, -2.13139, -2.75795, -1.97219, -2.79767, -3.17282,
    -2.22797, -5.16751, -4.40669, -3.08085, -3.46886, -2.66754, -4.11384, -1.83466, -3.56241,
    -2.31347, -2.28169, -4.38702, -1.85474, -2.75502, -2.61935, -2.65956, -2.95081, -2.50123,
    -3.65221, -2.87451, -2.78712,
];

const COST: [f64; 14] =
    [0.4, 0.1328, 0.4, 0.1275, 0.0975, 0.1172, 0.1541, 0.17, 0.4, 0.301, 0.4, 0.4, 0.26, 0.2383];

const PRICE_WEIGHT: [f64; 30] = [
    3.86546, 1.0, 1.0, 4.07059, 2.95369, 1.52444, 1.0, 3.03524, 3.06484, 2.60511, 7.67621, 7.52461,
    5.39522, 5.77346, 3.28809, 4.94403, 2.07788, 1.0, 3.91686, 1.98819, 5.20269, 1.0, 4.7539,
    2.34962, 1.0, 1.0, 1.0, 1.96784, 3.41328, 5.10606,
];
