use super::*;

/// The five-point Laplacian plus `c` on a grid; nodes where `known` have the row of the identity.
fn laplacian(grid: Grid, c: f64, known: impl Fn(usize) -> bool) -> (Pattern, Vec<f64>) {
    let Grid { rows, columns } = grid;
    let near = |p: usize| {
        let (i, j) = (p / columns, p % columns);
        let mut near = vec![p];
        near.extend((i > 0).then(|| p - columns));
        near.extend((i + 1 < rows).then(|| p + columns));
        near.extend((j > 0).then(|| p - 1));
        near.extend((j + 1 < columns).then(|| p + 1));
        near
    };
    let pattern = Pattern::from_columns((0..grid.n()).map(near));
    let value = |i: usize, j: usize| match (i == j, known(i) || known(j)) {
        (true, true) => 1.0,
        (true, false) => 4.0 + c,
        (false, true) => 0.0,
        (false, false) => -1.0,
    };
    let values = pattern.entries().map(|(_, i, j)| value(i, j)).collect();
    (pattern, values)
}

/// Steps of conjugate gradients until the residual has fallen to `10⁻⁸`, which is checked.
fn steps(grid: Grid, (pattern, values): &(Pattern, Vec<f64>)) -> usize {
    let mut solver = MultigridCg::new(grid);
    solver.analyse(pattern).unwrap();
    solver.factor(values).unwrap();
    let b: Vec<f64> = (0..grid.n()).map(|k| 1.0 + (k as f64 * 0.9).sin()).collect();
    let mut x = b.clone();
    solver.solve(&mut x);
    let mut residual = b.clone();
    for (k, i, j) in pattern.entries() {
        residual[i] -= values[k] * x[j];
    }
    assert!(norm(&residual) <= 1.01e-8 * norm(&b), "{:e}", norm(&residual) / norm(&b));
    solver.steps()
}

#[test]
fn steps_do_not_grow_with_the_grid() {
    for k in [1, 2, 3, 7, 15, 31, 63, 127, 64, 100] {
        let grid = Grid::square(k);
        let steps = steps(grid, &laplacian(grid, 0.0, |_| false));
        assert!(steps <= 12, "{k}: {steps}");
    }
}

#[test]
fn long_rectangles_are_solved_as_well() {
    for (rows, columns) in [(1, 200), (200, 1), (3, 101), (64, 9), (2, 2)] {
        let grid = Grid::new(rows, columns);
        let steps = steps(grid, &laplacian(grid, 0.1, |_| false));
        assert!(steps <= 14, "{rows} × {columns}: {steps}");
    }
}

#[test]
fn known_variables_do_not_slow_the_cycle_down() {
    let k = 63;
    let grid = Grid::square(k);
    let disk = |p: usize| (p / k).abs_diff(30).pow(2) + (p % k).abs_diff(25).pow(2) < 200;
    let spots = |p: usize| p.is_multiple_of(7);
    assert!(steps(grid, &laplacian(grid, 0.0, disk)) <= 14);
    assert!(steps(grid, &laplacian(grid, 0.0, spots)) <= 20);
    assert!(steps(grid, &laplacian(grid, 0.0, |_| true)) <= 1);
}

#[test]
fn the_cycle_is_a_symmetric_operator() {
    let grid = Grid::new(17, 12);
    let (pattern, values) = laplacian(grid, 0.2, |p| p.is_multiple_of(5));
    let mut solver = MultigridCg::new(grid);
    solver.analyse(&pattern).unwrap();
    solver.factor(&values).unwrap();
    let m = solver.levels[0].m;
    let place = |p: usize| (p / 12 + 1) * m + p % 12 + 1;
    let size = solver.levels[0].size();
    let image = |p: usize| {
        let (mut fields, mut r) = (vec![0.0; solver.memory()], vec![0.0; size]);
        fields[place(p)] = 1.0;
        cycle(&solver.levels, &mut fields, &mut r);
        fields[size..2 * size].to_vec()
    };
    for (p, q) in [(0, 1), (13, 100), (6, 203), (50, 62)] {
        let (of_p, of_q) = (image(p), image(q));
        let (one, other) = (of_p[place(q)], of_q[place(p)]);
        assert!((one - other).abs() <= 1e-14, "{one} {other}");
    }
}

#[test]
fn memory_that_is_lent_or_released_changes_no_bit() {
    let grid = Grid::new(40, 31);
    let (pattern, values) = laplacian(grid, 0.3, |p| p.is_multiple_of(9));
    let mut solver = MultigridCg::new(grid);
    solver.analyse(&pattern).unwrap();
    solver.factor(&values).unwrap();
    let mut own = vec![1.0; grid.n()];
    solver.solve(&mut own);
    solver.release();
    solver.factor(&values).unwrap();
    for lent in [solver.memory(), solver.memory() - 1] {
        let mut x = vec![1.0; grid.n()];
        solver.solve_with(&mut x, &mut vec![f64::NAN; lent]);
        assert_eq!(x, own, "{lent} numbers lent");
    }
}

#[test]
fn an_indefinite_matrix_gives_no_numbers() {
    let grid = Grid::square(15);
    let (pattern, values) = laplacian(grid, -2.0, |_| false);
    let mut solver = MultigridCg::new(grid);
    solver.analyse(&pattern).unwrap();
    if solver.factor(&values).is_ok() {
        let mut x = vec![1.0; grid.n()];
        solver.solve(&mut x);
        assert!(x.iter().all(|x| x.is_nan()));
    }
    let (_, values) = laplacian(grid, -4.5, |_| false);
    assert!(matches!(solver.factor(&values), Err(LinearError::NotDefinite { .. })));
}

#[test]
fn a_pattern_of_another_shape_is_refused() {
    let (pattern, _) = laplacian(Grid::new(4, 6), 0.0, |_| false);
    for grid in [Grid::new(6, 4), Grid::new(5, 5)] {
        let refused = MultigridCg::new(grid).analyse(&pattern);
        assert!(matches!(refused, Err(LinearError::NotOnGrid { .. })));
    }
}

#[test]
fn interpolation_reproduces_linear_functions_between_nodes() {
    // 2 x + 3 y + 1, which is 1 on two sides of the rim only.
    let linear = |grid: Grid| -> Vec<f64> {
        let share = |i: usize, m: usize| (i + 1) as f64 / (m + 1) as f64;
        let value = |k: usize| {
            2.0 * share(k / grid.columns, grid.rows) + 3.0 * share(k % grid.columns, grid.columns)
        };
        (0..grid.n()).map(value).collect()
    };
    for (from, to) in [((3, 4), (7, 9)), ((4, 5), (9, 8)), ((7, 9), (3, 4))] {
        let (from, to) = (Grid::new(from.0, from.1), Grid::new(to.0, to.1));
        let interpolated = to.interpolate(&linear(from), from, 0.0).unwrap();
        let is_between = |i: usize, fine: usize, coarse: usize| {
            let place = (i + 1) * (coarse + 1);
            place > fine && place <= coarse * (fine + 1)
        };
        for (k, expected) in linear(to).into_iter().enumerate() {
            if is_between(k / to.columns, to.rows, from.rows)
                && is_between(k % to.columns, to.columns, from.columns)
            {
                assert!((interpolated[k] - expected).abs() < 1e-14, "{from:?} {to:?} {k}");
            }
        }
    }
    assert!(Grid::square(3).interpolate(&[1.0; 3], Grid::square(2), 0.0).is_err());
}
