//! Random numbers, the same every run.

/// `splitmix64` ([SLF14], references in `mcp_core`).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `[−1, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / 2_f64.powi(52) - 1.0
    }

    /// One of `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next() % n as u64).expect("smaller than n")
    }

    /// One of the integers `−most..=most`.
    pub(crate) fn integer(&mut self, most: i128) -> i128 {
        i128::from(self.next() >> 1) % (2 * most + 1) - most
    }

    /// The same, for exponents.
    pub(crate) fn exponent(&mut self, most: i32) -> i32 {
        i32::try_from(self.integer(most.into())).expect("as small as `most`")
    }

    /// Whether an event of probability `1/n` happens.
    pub(crate) fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }
}
