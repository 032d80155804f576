//! [`Packed`]: a long list of numbers with few different values.

/// Lists below this length stay as they are: they take little memory, and are never allocated anew.
const LONG: usize = 4096;

/// Numbers to be copied: a byte each where there are at most 256 different ones in a long list. On a grid of
/// `n` nodes the constant derivatives take 5 instead of 40 bytes a node.
#[derive(Debug)]
pub(super) enum Packed {
    /// As they are.
    Listed(Vec<f64>),
    /// By their numbers among the different values.
    Coded {
        /// One for each number.
        codes: Vec<u8>,
        /// What a code stands for.
        values: Box<[f64; 256]>,
    },
}

impl Default for Packed {
    fn default() -> Self {
        Packed::Listed(Vec::new())
    }
}

impl Packed {
    /// Zeros, to be added to.
    pub(super) fn clear(&mut self, len: usize) {
        match self {
            Packed::Listed(list) => {
                list.clear();
                list.resize(len, 0.0);
            }
            Packed::Coded { .. } => *self = Packed::Listed(vec![0.0; len]),
        }
    }

    /// Adds to number `k`, between [`clear`](Self::clear) and [`pack`](Self::pack).
    #[inline]
    pub(super) fn add(&mut self, k: usize, value: f64) {
        if let Packed::Listed(list) = self {
            list[k] += value;
        }
    }

    /// Takes as little memory as possible.
    pub(super) fn pack(&mut self) {
        let Packed::Listed(list) = self else { return };
        if list.len() < LONG {
            return;
        }
        let mut values = Box::new([0.0; 256]);
        let (mut known, mut last) = (0, 0);
        let mut codes = Vec::with_capacity(list.len());
        for value in &*list {
            // Bits, since −0 is not 0.
            let is_value = |k: &usize| f64::to_bits(values[*k]) == value.to_bits();
            if known == 0 || !is_value(&last) {
                last = match (0..known).find(is_value) {
                    Some(k) => k,
                    None if known == values.len() => return,
                    None => {
                        values[known] = *value;
                        known += 1;
                        known - 1
                    }
                };
            }
            codes.push(u8::try_from(last).expect("at most 256 values"));
        }
        *self = Packed::Coded { codes, values };
    }

    /// Writes all numbers.
    pub(super) fn copy_to(&self, to: &mut [f64]) {
        match self {
            Packed::Listed(list) => to.copy_from_slice(list),
            Packed::Coded { codes, values } => {
                assert_eq!(to.len(), codes.len(), "one place for every number");
                for (to, &code) in to.iter_mut().zip(codes) {
                    *to = values[usize::from(code)];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packed(list: &[f64]) -> Packed {
        let mut packed = Packed::default();
        packed.clear(list.len());
        list.iter().enumerate().for_each(|(k, value)| packed.add(k, *value));
        packed.pack();
        packed
    }

    fn copied(packed: &Packed, len: usize) -> Vec<f64> {
        let mut to = vec![f64::NAN; len];
        packed.copy_to(&mut to);
        to
    }

    #[test]
    fn up_to_256_values_take_a_byte_each_and_come_back() {
        let list: Vec<f64> = (0..2 * LONG).map(|k| (k * k % 256) as f64 - 3.5).collect();
        let packed = packed(&list);
        assert!(matches!(packed, Packed::Coded { .. }));
        assert_eq!(copied(&packed, list.len()), list);
    }

    #[test]
    fn more_values_and_short_lists_stay_as_they_are() {
        for list in [(0..LONG).map(|k| (k % 257) as f64).collect(), vec![1.0; LONG - 1]] {
            let packed = packed(&list);
            assert!(matches!(packed, Packed::Listed(_)));
            assert_eq!(copied(&packed, list.len()), list);
        }
    }

    #[test]
    fn packed_numbers_can_be_cleared_and_found_again() {
        let mut packed = packed(&vec![2.0; LONG]);
        packed.clear(LONG);
        packed.add(1, 3.0);
        packed.pack();
        let found = copied(&packed, LONG);
        assert_eq!(found[..3], [0.0, 3.0, 0.0]);
    }
}
