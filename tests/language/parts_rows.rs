//! What parts add to rows and definitions: to which rows, in which order, and that names, derivatives
//! and pattern follow.

use mcp_core::{AdProblem, Model, ModelError, Options, Problem, check_derivatives, mcp, solve};

mcp! {
    /// Firms in regions, whose costs the parts make.
    model Firms {
        data { firms: Set, regions: Set, big: Subset(firms), open[firms]: f64, size[firms]: f64 }
        var q[f in firms] >= 0.0 start 1.0 if open[f] > 0.0;
        def cost[f in firms]: 0.1 * q[f];
        def total: sum(firms, |f| q[f]);
        eq profit[f in firms]: cost[f] + 0.3 * total - 2.0 * size[f]    complements q[f];
        /// Costs that grow with what the region makes.
        part crowd {
            data { weight[regions, firms]: f64 }
            def crowding[r in regions]: sum(firms, |f| weight[r, f] * q[f]);
            adds cost[f]: 0.7 * sum(regions, |r| sum(firms, |g| weight[r, f] * weight[r, g] * q[g]));
            adds profit[f in big]: 0.01 * q[f].powi(2);
            report crowded: sum(regions, |r| crowding[r].powi(2));
        }
        part levy {
            var due free;
            eq owed: due - 0.2 * total                                 complements due;
            adds cost[f in big]: 0.003 * due;
            adds total: 0.11 * q_of_big;
            def q_of_big: sum(big, |f| q[f]);
        }
        /// A surcharge on what the crowd makes.
        part surcharge requires crowd {
            adds crowding[r]: 0.37 * sum(big, |f| weight[r, f] * q[f]);
            adds profit[f]: 1e-3 * sum(regions, |r| crowding[r]);
        }
    }
}

const WEIGHT: [[f64; 3]; 2] = [[0.3, 0.1, 0.7], [0.2, 0.9, 0.4]];

fn firms(open: [f64; 3], big: &[&str]) -> Firms {
    Firms::builder()
        .firms(["a", "b", "c"])
        .regions(["north", "south"])
        .big(big.to_vec())
        .open(open)
        .size([1.0, 1.5, 2.0])
        .build()
        .unwrap()
}

fn all() -> Firms {
    let parts = (Surcharge, Crowd { weight: WEIGHT }, Levy);
    firms([1.0; 3], &["a", "c"]).with(parts).unwrap()
}

/// `F` at `z` with all parts, from the formulas: each sum in the order of the text.
fn by_hand(z: [f64; 4]) -> [f64; 4] {
    let ([q @ .., due], weight) = (z, WEIGHT);
    let q: [f64; 3] = q;
    let total = q[0] + q[1] + q[2] + 0.11 * (q[0] + q[2]);
    let is_big = |f: usize| f != 1;
    let crowding = |r: usize| {
        let own: f64 = (0..3).map(|f| weight[r][f] * q[f]).sum();
        own + 0.37 * (weight[r][0] * q[0] + weight[r][2] * q[2])
    };
    let cost = |f: usize| {
        let mutual = |r: usize| (0..3).map(|g| weight[r][f] * weight[r][g] * q[g]).sum::<f64>();
        let levy = if is_big(f) { 0.003 * due } else { 0.0 };
        0.1 * q[f] + 0.7 * (mutual(0) + mutual(1)) + levy
    };
    let size = [1.0, 1.5, 2.0];
    let profit = |f: usize| {
        let own = if is_big(f) { 0.01 * q[f].powi(2) } else { 0.0 };
        let surcharge = 1e-3 * (crowding(0) + crowding(1));
        cost(f) + 0.3 * total - 2.0 * size[f] + own + surcharge
    };
    [profit(0), profit(1), profit(2), due - 0.2 * total]
}

fn f_at(model: &Firms, z: &[f64]) -> Vec<f64> {
    let mut problem = AdProblem::new(model).unwrap();
    let mut f = vec![0.0; z.len()];
    problem.evaluate(z, Some(&mut f), None);
    f
}

#[test]
fn every_term_reaches_its_rows_and_no_other() {
    for z in [[1.0, 2.0, 3.0, 4.0], [0.3, 5.0, 0.7, -2.0]] {
        for (found, expected) in f_at(&all(), &z).iter().zip(by_hand(z)) {
            assert!((found - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{z:?}");
        }
    }
}

#[test]
fn derivatives_and_pattern_follow_the_parts_that_are_on() {
    let reads = |model: &Firms| {
        let problem = AdProblem::new(model).unwrap();
        problem.pattern().entries().map(|(_, i, j)| (i, j)).collect::<Vec<_>>()
    };
    let base = firms([1.0; 3], &["a", "c"]);
    let levy = base.with(Levy).unwrap();
    assert!(reads(&base).iter().all(|&(i, j)| i < 3 && j < 3));
    // The levy is in the costs of the big firms only.
    let of_due: Vec<usize> = reads(&levy).into_iter().filter(|e| e.1 == 3).map(|e| e.0).collect();
    assert_eq!(of_due, [0, 2, 3]);
    for model in [base, levy, all()] {
        let z: Vec<f64> = (0..model.shape().n()).map(|j| 0.5 + j as f64).collect();
        check_derivatives(&model, &z).unwrap().verdict().unwrap();
    }
}

#[test]
fn the_order_of_naming_changes_no_bit() {
    let base = || firms([1.0; 3], &["a", "c"]);
    let crowd = || Crowd { weight: WEIGHT };
    let orders = [
        base().with((Surcharge, crowd(), Levy)).unwrap(),
        base().with((Levy, crowd(), Surcharge)).unwrap(),
        base().with((crowd(), (Surcharge, Levy))).unwrap(),
        base().with(Levy).unwrap().with((Surcharge, crowd())).unwrap(),
        base().with(crowd()).unwrap().with(Levy).unwrap().with(Surcharge).unwrap(),
    ];
    let z = [0.1, 0.7, 1.3, 0.9];
    let bits =
        |model: &Firms| -> Vec<u64> { f_at(model, &z).iter().map(|f| f.to_bits()).collect() };
    let jacobian = |model: &Firms| -> Vec<u64> {
        let mut problem = AdProblem::new(model).unwrap();
        let mut jac = vec![0.0; problem.pattern().nnz()];
        problem.evaluate(&z, None, Some(&mut jac));
        jac.iter().map(|x| x.to_bits()).collect()
    };
    for other in &orders[1..] {
        assert_eq!(bits(&orders[0]), bits(other));
        assert_eq!(jacobian(&orders[0]), jacobian(other));
    }
}

#[test]
fn definitions_and_reports_of_a_part_that_is_off_are_absent() {
    let names = |model: &Firms| -> Vec<String> {
        let shape = model.shape();
        let families = shape.definitions().iter().chain(shape.reports());
        families.map(|family| family.name().to_owned()).collect()
    };
    let base = firms([1.0; 3], &["a", "c"]);
    assert_eq!(names(&base), ["cost", "total"]);
    assert_eq!(names(&base.with(Levy).unwrap()), ["cost", "q_of_big", "total"]);
    let model = all();
    let solution = solve(&model, &Options::default()).unwrap().solved().unwrap();
    let view = model.view(&solution).unwrap();
    let [north, south] = ["north", "south"].map(|r| view.crowding[r]);
    assert_eq!(view.crowded, Some(north.powi(2) + south.powi(2)));
    let solution = solve(&base, &Options::default()).unwrap().solved().unwrap();
    let view = base.view(&solution).unwrap();
    assert_eq!((view.crowded, view.q_of_big, view.due), (None, None, None));
    assert_eq!(
        view.crowding.get("north").unwrap_err().to_string(),
        "`crowding` exists only with the part `crowd`, which is off"
    );
}

#[test]
fn terms_for_rows_that_there_are_not_are_no_terms_but_for_none_at_all_an_error() {
    let crowd = || Crowd { weight: WEIGHT };
    // Firm `a` is closed: the big firm `c` alone has the square.
    let some = firms([0.0, 1.0, 1.0], &["a", "c"]).with(crowd()).unwrap();
    assert_eq!(some.shape().n(), 2);
    let without_squares = firms([0.0, 1.0, 1.0], &[]).with(crowd()).unwrap();
    let (with, without) = (f_at(&some, &[1.0, 2.0]), f_at(&without_squares, &[1.0, 2.0]));
    assert_eq!(with[0].to_bits(), without[0].to_bits());
    assert!((with[1] - without[1] - 0.04).abs() < 1e-15);

    let none = firms([0.0, 1.0, 0.0], &["a", "c"]).with(crowd());
    let said = none.unwrap_err();
    assert!(matches!(said, ModelError::Data(_)));
    assert_eq!(
        said.to_string(),
        "the part `crowd` adds to `profit` over `big`, where it has no row: its condition holds for \
         none of them"
    );
}
