//! Equilibria of games against the enumeration of supports.

#[path = "../../examples/bimatrix.rs"]
#[allow(dead_code, reason = "`main` is run as an example")]
mod example;

use crate::numbers::solve_linear;
use example::{A, B, Bimatrix, EQUILIBRIA, inspection, regrets, start_sure};
use mcp_core::{Method, Options, solve};
use std::array::from_fn;

/// Probabilities on `support` that make all of `replies` pay the same; `pay(reply, choice)`.
fn indifferent(
    support: &[usize],
    replies: &[usize],
    pay: impl Fn(usize, usize) -> f64,
) -> Option<(Vec<f64>, f64)> {
    let n = support.len();
    let mut a: Vec<Vec<f64>> = replies
        .iter()
        .map(|&reply| support.iter().map(|&choice| pay(reply, choice)).chain([-1.0]).collect())
        .collect();
    a.push([vec![1.0; n], vec![0.0]].concat());
    let mut b = vec![0.0; n];
    b.push(1.0);
    let mut p = solve_linear(a, b)?;
    let value = p.pop()?;
    Some((p, value))
}

/// All equilibria of a nondegenerate game: supports of equal size that make each other indifferent.
fn equilibria(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<(Vec<f64>, Vec<f64>)> {
    let (m, n) = (a.len(), a[0].len());
    let members = |set: usize, of: usize| (0..of).filter(|i| set >> i & 1 == 1).collect::<Vec<_>>();
    let spread = |support: &[usize], p: &[f64], of: usize| {
        let mut all = vec![0.0; of];
        support.iter().zip(p).for_each(|(&i, &p)| all[i] = p);
        all
    };
    let mut found = Vec::new();
    for (rows, columns) in (1..1 << m).flat_map(|r| (1..1 << n).map(move |c| (r, c))) {
        let (rows, columns) = (members(rows, m), members(columns, n));
        if rows.len() != columns.len() {
            continue;
        }
        let Some((y, v)) = indifferent(&columns, &rows, |i, j| a[i][j]) else { continue };
        let Some((x, w)) = indifferent(&rows, &columns, |j, i| b[i][j]) else { continue };
        let (x, y) = (spread(&rows, &x, m), spread(&columns, &y, n));
        let pays = |i: usize| (0..n).map(|j| a[i][j] * y[j]).sum::<f64>();
        let other = |j: usize| (0..m).map(|i| b[i][j] * x[i]).sum::<f64>();
        if x.iter().chain(&y).all(|&p| p > -1e-12)
            && (0..m).all(|i| pays(i) < v + 1e-12)
            && (0..n).all(|j| other(j) < w + 1e-12)
        {
            found.push((x, y));
        }
    }
    found
}

fn near(z: &[f64], x: &[f64], y: &[f64]) -> bool {
    x.iter().chain(y).zip(z).all(|(p, z)| (p - z).abs() < 1e-7)
}

#[test]
fn the_published_equilibria_are_all_there_are() {
    let all = equilibria(&A.map(Vec::from), &B.map(Vec::from));
    for z in EQUILIBRIA {
        assert!(all.iter().any(|(x, y)| near(&z, x, y)), "{z:?}");
    }
    assert_eq!(all.len(), EQUILIBRIA.len());
}

#[test]
fn the_tram_has_one_equilibrium() {
    let (a, b) = ([[-3.0, -3.0], [-60.0, 0.0]], [[1.0, 3.0], [58.0, 0.0]]);
    let all = equilibria(&a.map(Vec::from), &b.map(Vec::from));
    assert_eq!(all.len(), 1);
    let mut tram = inspection().unwrap();
    for (i, row) in ["buy", "dodge"].into_iter().enumerate() {
        for (j, column) in ["inspect", "wait"].into_iter().enumerate() {
            start_sure(&mut tram, [row, column], [a[i][j], b[i][j]]).unwrap();
            let solution = solve(&tram, &Options::default()).unwrap().solved().unwrap();
            assert!(near(&solution.z, &all[0].0, &all[0].1));
        }
    }
}

/// A number in (0, 1) from a linear congruential generator with the constants of Knuth's MMIX.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

#[test]
fn in_random_games_what_is_solved_is_one_of_the_enumerated_equilibria() {
    let mut seed = 20;
    for game in 0..100 {
        let mut pays = || -> [[f64; 3]; 3] { from_fn(|_| from_fn(|_| random(&mut seed))) };
        let (a, b) = (pays(), pays());
        let all = equilibria(&a.map(Vec::from), &b.map(Vec::from));
        assert!(all.len() % 2 == 1, "nondegenerate games have an odd number of equilibria");
        let labels = ["1", "2", "3"];
        let mut model = Bimatrix::game(labels, labels, a, b).unwrap();
        let mut solved = 0;
        for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
            start_sure(&mut model, [labels[i], labels[j]], [a[i][j], b[i][j]]).unwrap();
            for method in [Method::NewtonFb, Method::NewtonMinFb] {
                let solution = solve(&model, &Options::new(method)).unwrap();
                if solution.is_solved() {
                    solved += 1;
                    let regrets = regrets(&model.view(&solution).unwrap());
                    assert!(
                        regrets.into_iter().all(|gain| gain < 1e-8),
                        "game {game}: {regrets:?}"
                    );
                    assert!(all.iter().any(|(x, y)| near(&solution.z, x, y)), "game {game}");
                }
            }
        }
        assert!(solved > 0, "game {game} is solved from no sure choice");
    }
}
