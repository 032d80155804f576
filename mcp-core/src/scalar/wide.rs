//! [`Wide`]: [`Jet`] with 16 lanes, its operations behind calls.

use super::{Jet, behind_calls};

/// The lanes of [`Wide`].
type Lanes = Jet<16>;

/// [`Jet<16>`](Jet) for the rows of models. A user's compiler meets every row in every arithmetic; of
/// this one it compiles calls, which are short against 16 lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide(Lanes);

behind_calls!([] Wide, Lanes, {
    /// Not behind a call: it is repeated for all terms of a sum.
    #[inline]
    fn accumulate(&mut self, term: Wide) {
        self.0 = self.0 + term.0;
    }
});

#[cfg(test)]
#[path = "wide_tests.rs"]
mod tests;
