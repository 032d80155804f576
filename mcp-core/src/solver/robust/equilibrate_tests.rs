use super::*;

const INF: f64 = f64::INFINITY;

struct Case {
    pattern: Pattern,
    jac: Vec<f64>,
    z: Vec<f64>,
    f: Vec<f64>,
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Case {
    /// A sparse matrix with entries over twelve decades.
    fn new(n: usize) -> Self {
        let noise = |k: usize| ((k * 7919 + 131) % 1009) as f64 / 504.5 - 1.0;
        let rows: Vec<Vec<usize>> = (0..n)
            .map(|i| (0..n).filter(|&j| i == j || (i * 7 + j * 3) % 5 == 0).collect())
            .collect();
        let pattern = Pattern::from_rows(&rows);
        let jac = (0..pattern.nnz()).map(|k| noise(k) * 10_f64.powf(6.0 * noise(k + 50))).collect();
        Case {
            pattern,
            jac,
            z: (0..n).map(|j| noise(j + 9)).collect(),
            f: (0..n).map(|j| 1e3 * noise(j + 99)).collect(),
            lower: vec![0.0; n],
            upper: (0..n).map(|j| if j == 2 { 0.0 } else { INF }).collect(),
        }
    }

    fn scales(&self) -> Equilibration {
        self.scales_by(Sizes::AsOneEntry)
    }

    fn scales_by(&self, sizes: Sizes) -> Equilibration {
        let mut equilibration = Equilibration::default();
        equilibration.resize(self.z.len());
        let bounds = Bounds::new(self.lower.clone(), self.upper.clone()).expect("well formed");
        let sample = Sample { z: &self.z, f: &self.f, jac: &self.jac, start: &self.z, sizes };
        equilibration.measure(&self.pattern, &bounds, sample);
        equilibration
    }

    /// `2^{k_i} F_i` as a function of `2^{k_j} z_j`.
    fn in_units(&self, rows: &[i32], columns: &[i32]) -> Self {
        let jac = self
            .pattern
            .entries()
            .map(|(k, i, j)| self.jac[k] * power_of_two(rows[i]) * power_of_two(-columns[j]));
        let scaled = |list: &[f64], k: &[i32]| -> Vec<f64> {
            list.iter().zip(k).map(|(x, &k)| x * power_of_two(k)).collect()
        };
        Case {
            pattern: self.pattern.clone(),
            jac: jac.collect(),
            z: scaled(&self.z, columns),
            f: scaled(&self.f, rows),
            lower: scaled(&self.lower, columns),
            upper: scaled(&self.upper, columns),
        }
    }
}

#[test]
fn scales_follow_every_power_of_two_of_rows_and_columns() {
    let case = Case::new(12);
    let own = case.scales();
    let own_by_sizes = case.scales_by(Sizes::AsAllEntries);
    assert_ne!(own.c, own_by_sizes.c);
    for k in [1, 2, -7, 15] {
        let units: Vec<i32> = (0..12).map(|i| k * ((i * 5 % 7) - 3)).collect();
        let none = [0; 12];
        for (rows, columns) in [(&units[..], &none[..]), (&none, &units), (&units, &units)] {
            let moved = case.in_units(rows, columns);
            for (other, own) in
                [(moved.scales(), &own), (moved.scales_by(Sizes::AsAllEntries), &own_by_sizes)]
            {
                for j in 0..12 {
                    assert_eq!(other.r[j], own.r[j] - rows[j], "row {j}");
                    assert_eq!(other.c[j], own.c[j] + columns[j], "column {j}");
                }
            }
        }
    }
}

#[test]
fn a_matrix_that_is_well_scaled_in_hidden_units_is_found_back() {
    let mut case = Case::new(10);
    for value in &mut case.jac {
        *value = value.signum() * 1.5;
    }
    let units: Vec<i32> = (0..10).map(|i| 9 * (i % 4) - 11).collect();
    let hidden = case.in_units(&units, &units);
    let scales = hidden.scales();
    for (k, i, j) in hidden.pattern.entries() {
        let scaled = exponent(hidden.jac[k]) + scales.r[i] + scales.c[j];
        assert!(scaled.abs() <= 1, "{scaled} at {i}, {j}");
    }
}

#[test]
fn a_symmetric_matrix_gets_one_vector_up_to_a_power_of_two() {
    let n = 8;
    let noise = |k: usize| ((k * 7919 + 131) % 1009) as f64 / 504.5 - 1.0;
    let mut case = Case::new(n);
    case.pattern = Pattern::dense(n);
    case.jac = (0..n * n)
        .map(|k| (k / n, k % n))
        .map(|(i, j)| 10_f64.powf(5.0 * noise(i.min(j) * n + i.max(j))))
        .collect();
    case.upper.fill(INF);
    for units in [[0; 8], [3, -1, 4, -1, 5, -9, 2, 6]] {
        let scales = case.in_units(&units, &[0; 8]).scales();
        let differences: Vec<i32> = (0..n).map(|j| scales.r[j] + units[j] - scales.c[j]).collect();
        assert!(differences.iter().all(|&d| d == differences[0]), "{differences:?}");
    }
}

#[test]
fn exponents_are_exact_down_to_subnormals() {
    for k in [-1000, -1, 0, 1, 52, 1000] {
        assert_eq!(exponent(power_of_two(k)), k);
        assert_eq!(exponent(-1.9 * power_of_two(k)), k);
    }
    assert_eq!(exponent(f64::from_bits(1)), -1074);
}

#[test]
fn dust_in_the_start_does_not_change_the_scales() {
    let mut case = Case::new(12);
    for j in [1, 5, 7] {
        case.z[j] = 0.0;
    }
    let clean = case.scales();
    for j in [1, 5, 7] {
        case.z[j] = 1e-60;
    }
    let dusty = case.scales();
    assert_eq!((clean.r, clean.c), (dusty.r, dusty.c));
}
