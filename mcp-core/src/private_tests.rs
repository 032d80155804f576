#![allow(clippy::float_cmp, reason = "these numbers are exact")]

use super::*;
use crate::{Model, Reader, Real, Scalar, mcp_fn};

#[mcp_fn]
fn named<D: Scalar>([x, y]: [Real<D>; 2]) -> [Real<D>; 2] {
    [x + 10 * y, x - y]
}

#[mcp_fn]
fn indexed<D: Scalar>(z: [Real<D>; 2]) -> [Real<D>; 2] {
    named(z)
}

/// All rows at once and one by one.
fn rows(model: &impl Model, z: [f64; 2]) -> [[f64; 2]; 2] {
    let z = z.map(Real::<f64>::from);
    let read = Reader::lanes(&z, &[], &[]);
    let mut f = [Real::from(f64::NAN); 2];
    model.whole(&read, &mut f);
    let one_by_one = [0, 1].map(|row| {
        let row = model.shape().row(row);
        model.row(row.family, row.index, &read)
    });
    [f, one_by_one].map(|f| f.map(Real::into_scalar))
}

#[test]
fn rows_are_the_entries_of_the_returned_array() {
    assert_eq!(rows(&Named::new().unwrap(), [1.0, 2.0]), [[21.0, -1.0]; 2]);
    assert_eq!(rows(&Indexed::new().unwrap(), [1.0, 2.0]), [[21.0, -1.0]; 2]);
}

#[test]
fn every_kind_of_number_is_a_bound() {
    fn all<const N: usize>(numbers: impl PerVariable<N>) -> [f64; N] {
        numbers.numbers()
    }
    assert_eq!(all::<2>(1.5), [1.5; 2]);
    assert_eq!(all::<2>(1.5_f32), [1.5; 2]);
    assert_eq!(all::<2>(-3), [-3.0; 2]);
    assert_eq!(all::<2>([3_usize, 4]), [3.0, 4.0]);
    assert_eq!(all::<1>([3_u64]), [3.0]);
    assert_eq!(number(7_i64), 7.0);
}
