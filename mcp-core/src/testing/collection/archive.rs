//! Named arrays of numbers in one file of bytes.

/// A sequence of records: length of the name (`u16`), name (UTF-8), count (`u32`), numbers (`f64`),
/// all little endian.
#[derive(Clone, Copy, Debug)]
pub(super) struct Archive {
    bytes: &'static [u8],
}

/// What `data/export.py` wrote of numpy's random numbers.
pub(super) const RANDOM: Archive = Archive { bytes: include_bytes!("../data/random.bin") };

impl Archive {
    #[cfg(test)]
    pub(super) const fn new(bytes: &'static [u8]) -> Self {
        Archive { bytes }
    }

    /// The numbers under `name`; none if there is no such record.
    pub(super) fn get(self, name: &str) -> Vec<f64> {
        let mut records = self.records();
        let found = records.find(|(record, _)| *record == name.as_bytes());
        let numbers = found.map_or(&[][..], |(_, numbers)| numbers);
        let (numbers, _) = numbers.as_chunks::<8>();
        numbers.iter().map(|&number| f64::from_le_bytes(number)).collect()
    }

    #[cfg(test)]
    pub(super) fn names(self) -> impl Iterator<Item = &'static str> {
        self.records().filter_map(|(name, _)| std::str::from_utf8(name).ok())
    }

    /// Names and the bytes of their numbers.
    fn records(self) -> impl Iterator<Item = (&'static [u8], &'static [u8])> {
        let mut rest = self.bytes;
        std::iter::from_fn(move || {
            let (length, tail) = rest.split_first_chunk::<2>()?;
            let (name, tail) = tail.split_at_checked(u16::from_le_bytes(*length).into())?;
            let (count, tail) = tail.split_first_chunk::<4>()?;
            let count = usize::try_from(u32::from_le_bytes(*count)).ok()?;
            let (numbers, tail) = tail.split_at_checked(count.checked_mul(8)?)?;
            rest = tail;
            Some((name, numbers))
        })
    }
}

/// FNV-1a of 64 bits (Fowler, Noll & Vo), to notice that a data file has changed.
#[cfg(test)]
pub(super) fn fnv1a(bytes: &[u8]) -> u64 {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}
