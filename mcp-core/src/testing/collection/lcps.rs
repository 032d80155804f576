//! Linear complementarity problems: worst cases of the literature and random ones; and random box
//! problems with arctan terms.

use super::super::affine::{Affine, ahn_matrix, cyclic_matrix, hilbert_matrix, murty_matrix};
use super::Instance;
use super::archive::RANDOM;
use crate::error::ModelError;
use crate::model::{Model, Reader, Shape};
use crate::scalar::{Real, Scalar, sum};

/// `e_k` of length `n`.
fn unit(n: usize, k: usize) -> Vec<f64> {
    (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect()
}

/// `M z − 1 ⟂ z >= 0` from 0.
fn minus_one(
    name: String,
    source: &'static str,
    n: usize,
    m: impl Fn(usize, usize) -> f64,
) -> Result<Instance, ModelError> {
    Ok(Instance::new(name, source, Affine::new(0, vec![-1.0; n], m)?))
}

fn worst_cases() -> Result<Vec<Instance>, ModelError> {
    let (murty, fathi) =
        ("Murty (1978), Math. Programming Study 7", "Fathi (1979), Math. Programming 17");
    let mut all = Vec::new();
    for n in [16, 32, 64] {
        // U Uᵀ: Fathi's matrix with the order of the variables reversed.
        let product =
            |i: usize, j: usize| 4.0 * (n - 1 - i.max(j)) as f64 + if i == j { 1.0 } else { 2.0 };
        let transposed = |i, j| murty_matrix(j, i);
        let name = format!("murtyT-{n}(explcp)");
        all.push(
            minus_one(format!("murty-{n}"), murty, n, murty_matrix)?.solved_by(unit(n, n - 1)),
        );
        all.push(minus_one(name, murty, n, transposed)?.solved_by(unit(n, 0)));
        all.push(minus_one(format!("fathi-{n}"), fathi, n, product)?.solved_by(unit(n, n - 1)));
    }
    for n in [8, 12, 24] {
        let x: Vec<f64> = (0..n).map(|i| if i % 2 == 0 { 1.0 } else { 0.0 }).collect();
        let q = |i: usize| 0.1 * (1.0 - x[i]) - sum(0..n, |j| hilbert_matrix(i, j) * x[j]);
        let manufactured = Affine::new(0, (0..n).map(q).collect(), hilbert_matrix)?;
        let source = "Hilbert matrix";
        all.push(Instance::new(format!("hilbert-{n}"), source, manufactured).solved_by(x));
        all.push(minus_one(format!("hilbert-neg-{n}"), source, n, hilbert_matrix)?);
    }
    for n in [32, 128] {
        all.push(minus_one(format!("ahn-{n}"), "Ahn (1983), Math. Programming 26", n, ahn_matrix)?);
    }
    let unit_lower = |i: usize, j: usize| match i.cmp(&j) {
        std::cmp::Ordering::Greater => -1.0,
        std::cmp::Ordering::Equal => 1.0,
        std::cmp::Ordering::Less => 0.0,
    };
    let csizmadia = Affine::new(0, vec![1.0; 40], unit_lower)?;
    let source = "after Csizmadia: unit lower triangle, solved by 0";
    all.push(Instance::new("csizmadia-like-40", source, csizmadia).solved_by([0.0; 40]));
    let source = "Ben Gharbia & Gilbert (2012), Math. Programming 134";
    all.push(minus_one("cyc3".into(), source, 3, cyclic_matrix)?.solved_by([1.0 / 3.0; 3]));
    let circulant = |i: usize, j: usize| [1.0, 1.5, 1.5, 0.0, 0.0, 0.0, 0.0][(j + 7 - i) % 7];
    all.push(minus_one("cyc7".into(), source, 7, circulant)?.solved_by([0.25; 7]));
    Ok(all)
}

/// What the random matrices are.
const KINDS: [&str; 8] =
    ["spd", "psd-skew", "P-tri", "psd-lowrank", "skew", "copos", "indef", "hcond"];

/// An LCP with stored `M`, `q` and manufactured solution; `F(z) = M z + q`.
pub(super) fn stored(name: String, start: f64) -> Result<Instance, ModelError> {
    let get = |what| RANDOM.get(&format!("{name}/{what}"));
    let (m, q) = (get("m"), get("q"));
    let n = q.len();
    let model = Affine::new(0, q, |i, j| m[i * n + j])?;
    let solution = get("x");
    let source = "random, with a manufactured solution";
    Ok(Instance::new(name, source, model).starting_at(vec![start; n]).solved_by(solution))
}

/// Every second one is degenerate in about 30 % of its pairs and starts at 0, the others at 1.
fn random() -> Result<Vec<Instance>, ModelError> {
    let instance = |k: usize| {
        let (kind, n) = (KINDS[k / 3], [10, 30, 80][k % 3]);
        let (suffix, start) = if k % 2 == 1 { ("-deg", 0.0) } else { ("", 1.0) };
        stored(format!("rnd-{kind}-{n}{suffix}"), start)
    };
    (0..24).map(instance).collect()
}

/// `F = M z + d arctan z + q + z³/100` in a box.
struct Arctan {
    shape: Shape,
    m: Vec<f64>,
    d: Vec<f64>,
    q: Vec<f64>,
}

impl Arctan {
    fn stored(name: &str) -> Result<Self, ModelError> {
        let get = |what| RANDOM.get(&format!("{name}/{what}"));
        let d = get("d");
        let shape = Shape::anonymous(&get("l"), &get("u"), &vec![0.0; d.len()])?;
        Ok(Arctan { shape, m: get("m"), d, q: get("q") })
    }
}

impl Model for Arctan {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn row<D: Scalar>(&self, _family: usize, i: usize, read: &Reader<'_, D>) -> Real<D> {
        let (n, z) = (self.d.len(), read.var(i));
        let m = &self.m[i * n..(i + 1) * n];
        sum(0..n, |j| m[j] * read.var(j)) + self.d[i] * z.atan() + self.q[i] + 0.01 * z.powi(3)
    }
}

fn arctans() -> Result<Vec<Instance>, ModelError> {
    let mut all = Vec::new();
    for kind in ["mono", "nonmono"] {
        for n in [20, 60, 120] {
            let name = format!("rnl-{kind}-{n}");
            let model = Arctan::stored(&name)?;
            all.push(Instance::new(
                name,
                "random, in the style of Sun, Fukushima & Qi (1997)",
                model,
            ));
        }
    }
    Ok(all)
}

pub(super) fn instances() -> Result<Vec<Instance>, ModelError> {
    Ok([worst_cases()?, random()?, arctans()?].concat())
}
