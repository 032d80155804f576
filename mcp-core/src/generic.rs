//! Numbers without a pattern, the same every time.

/// Multiples of the golden ratio modulo 1: distinct numbers in `[0, 1)` that fill it evenly.
pub(crate) fn generic(i: usize) -> f64 {
    ((i + 1) as f64 * 0.618_033_988_749_894_9).fract()
}
