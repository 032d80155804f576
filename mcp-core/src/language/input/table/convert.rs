//! The lists in the program that make a [`Table`].

use super::{Form, Table};

/// A number of a [`Table`]: `f64` or `i32`.
pub trait Number: Copy + sealed::Sealed {
    /// The number.
    fn number(self) -> f64;
}

impl Number for f64 {
    fn number(self) -> f64 {
        self
    }
}

impl Number for i32 {
    fn number(self) -> f64 {
        f64::from(self)
    }
}

/// The key of a number in a [`Table`]: a label, or a tuple of up to six.
pub trait Key: sealed::Sealed {
    /// Its labels, one for each index set.
    fn labels(self) -> Vec<String>;
}

impl Key for &str {
    fn labels(self) -> Vec<String> {
        vec![self.to_owned()]
    }
}

impl Key for String {
    fn labels(self) -> Vec<String> {
        vec![self]
    }
}

macro_rules! tuple_key {
    ($($L:ident $label:ident),*) => {
        impl<$($L: Into<String>),*> Key for ($($L,)*) {
            fn labels(self) -> Vec<String> {
                let ($($label,)*) = self;
                vec![$($label.into()),*]
            }
        }
        impl<$($L),*> sealed::Sealed for ($($L,)*) {}
    };
}

tuple_key!(A a, B b);
tuple_key!(A a, B b, C c);
tuple_key!(A a, B b, C c, D d);
tuple_key!(A a, B b, C c, D d, E e);
tuple_key!(A a, B b, C c, D d, E e, F f);

mod sealed {
    pub trait Sealed {}

    impl Sealed for f64 {}
    impl Sealed for i32 {}
    impl Sealed for &str {}
    impl Sealed for String {}
}

impl From<f64> for Table {
    fn from(number: f64) -> Self {
        Table(Form::Same(number))
    }
}

impl From<i32> for Table {
    fn from(number: i32) -> Self {
        Table(Form::Same(number.into()))
    }
}

impl<V: Number> From<&[V]> for Table {
    fn from(numbers: &[V]) -> Self {
        Table(Form::Each(numbers.iter().map(|number| number.number()).collect()))
    }
}

impl<V: Number> From<Vec<V>> for Table {
    fn from(numbers: Vec<V>) -> Self {
        Table::from(numbers.as_slice())
    }
}

impl<V: Number, const N: usize> From<[V; N]> for Table {
    fn from(numbers: [V; N]) -> Self {
        Table::from(numbers.as_slice())
    }
}

impl<V: Number> From<Vec<Vec<V>>> for Table {
    fn from(rows: Vec<Vec<V>>) -> Self {
        let row = |row: Vec<V>| row.into_iter().map(Number::number).collect();
        Table(Form::Rows(rows.into_iter().map(row).collect()))
    }
}

impl<V: Number, const N: usize, const M: usize> From<[[V; N]; M]> for Table {
    fn from(rows: [[V; N]; M]) -> Self {
        Table::from(rows.map(Vec::from).to_vec())
    }
}

impl<K: Key, V: Number> From<Vec<(K, V)>> for Table {
    fn from(entries: Vec<(K, V)>) -> Self {
        let entry = |(key, number): (K, V)| (key.labels(), number.number());
        Table(Form::Keyed(entries.into_iter().map(entry).collect()))
    }
}

impl<K: Key, V: Number, const N: usize> From<[(K, V); N]> for Table {
    fn from(entries: [(K, V); N]) -> Self {
        Table::from(Vec::from(entries))
    }
}
