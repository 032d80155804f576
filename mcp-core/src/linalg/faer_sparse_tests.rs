//! Both kinds of factors of faer's sparse LU, each forced.

use super::*;

/// Numbers in `0..below` from a 64-bit linear congruential generator.
struct Random(u64);

impl Random {
    fn below(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        usize::try_from(self.0 >> 33).unwrap() % below
    }
}

fn residual(pattern: &Pattern, values: &[f64], x: &[f64], b: &[f64], transposed: bool) -> f64 {
    let mut r = b.to_vec();
    for (k, i, j) in pattern.entries() {
        let (to, from) = if transposed { (j, i) } else { (i, j) };
        r[to] -= values[k] * x[from];
    }
    norm_1(&r)
}

#[test]
fn both_kinds_of_factors_give_the_same_verdict_on_random_patterns() {
    let mut random = Random(1);
    let (mut regular, mut singular) = (0, 0);
    for case in 0..4_000 {
        let n = 8 + random.below(30);
        let most = 2 + case % 5;
        let columns: Vec<Vec<usize>> = (0..n)
            .map(|j| {
                let diagonal = (random.below(50) > 0).then_some(j);
                let count = random.below(most);
                (0..count).map(|_| random.below(n)).chain(diagonal).collect()
            })
            .collect();
        let pattern = Pattern::from_columns(columns);
        let values: Vec<f64> =
            (0..pattern.nnz()).map(|_| [-2.0, -1.0, 1.0, 2.0][random.below(4)]).collect();
        let b: Vec<f64> = (0..n).map(|_| random.below(9) as f64).collect();
        let mut verdicts = Vec::new();
        for threshold in
            [SupernodalThreshold::FORCE_SIMPLICIAL, SupernodalThreshold::FORCE_SUPERNODAL]
        {
            let mut solver = FaerSparseLu::new();
            solver.analyse_anew(&pattern, threshold).unwrap();
            let forced = threshold == SupernodalThreshold::FORCE_SUPERNODAL;
            assert_eq!(solver.kind == Kind::Supernodal, forced);
            let verdict = solver.factor(&values);
            if let Ok(info) = verdict {
                for transposed in [false, true] {
                    let mut x = b.clone();
                    solver.solve_either(&mut x, transposed);
                    let error = residual(&pattern, &values, &x, &b, transposed);
                    let bound = 1e-13 * (norm_1(&x) + norm_1(&b));
                    assert!(error <= bound, "{error:e} {bound:e} {info:?}");
                }
            }
            verdicts.push(verdict);
        }
        match (verdicts[0], verdicts[1]) {
            (Ok(_), Ok(_)) => regular += 1,
            (Err(LinearError::Singular { .. }), Err(LinearError::Singular { .. })) => {
                singular += 1;
            }
            // Rounding may leave a pivot of the size of its errors in one of them.
            (Ok(info), Err(LinearError::Singular { .. }))
            | (Err(LinearError::Singular { .. }), Ok(info)) => {
                assert!(info.pivot_ratio < 1e-13, "{verdicts:?}");
            }
            _ => panic!("{verdicts:?}"),
        }
    }
    assert!(regular > 300 && singular > 300, "{regular} regular, {singular} singular");
}

#[test]
fn supernodal_factors_name_the_column_of_a_zero_pivot() {
    let n = 20;
    let pattern = Pattern::dense(n);
    let mut random = Random(2);
    let mut values: Vec<f64> = (0..n * n).map(|_| 1.0 + random.below(1_000) as f64).collect();
    values[7 * n..8 * n].fill(0.0);
    let mut solver = FaerSparseLu::new();
    solver.analyse_anew(&pattern, SupernodalThreshold::FORCE_SUPERNODAL).unwrap();
    assert_eq!(solver.factor(&values), Err(LinearError::Singular { column: 7 }));
    for (k, value) in values[7 * n..8 * n].iter_mut().enumerate() {
        *value = if k == 3 { 1e5 } else { 1.0 };
    }
    assert!(solver.factor(&values).is_ok());
    assert_eq!(solver.current, Kind::Supernodal);
}

#[test]
fn the_probe_has_no_zero_and_both_signs() {
    let mut probe = [0.0; 1_000];
    fill_probe(&mut probe);
    assert!(probe.iter().all(|value| (0.5..=1.0).contains(&value.abs())));
    let positive = probe.iter().filter(|value| **value > 0.0).count();
    assert!((400..600).contains(&positive), "{positive}");
}
