//! [`Apart`]: a value that the user's crate drops by a call.

use std::fmt;
use std::ops::{Deref, DerefMut};

/// A `T` behind a virtual call. What drops it contains that call and not the drops of everything in
/// `T`, which would be compiled again with every model.
///
/// To be made in functions that are compiled here: neither generic nor inlined.
pub(crate) struct Apart<T>(Box<dyn Hold<T>>);

trait Hold<T>: Send + Sync {
    fn held(&self) -> &T;
    fn held_mut(&mut self) -> &mut T;
}

impl<T: Send + Sync> Hold<T> for T {
    fn held(&self) -> &T {
        self
    }
    fn held_mut(&mut self) -> &mut T {
        self
    }
}

impl<T: Send + Sync + 'static> Apart<T> {
    pub(crate) fn new(value: T) -> Self {
        Apart(Box::new(value))
    }
}

impl<T> Deref for Apart<T> {
    type Target = T;
    fn deref(&self) -> &T {
        (*self.0).held()
    }
}

impl<T> DerefMut for Apart<T> {
    fn deref_mut(&mut self) -> &mut T {
        (*self.0).held_mut()
    }
}

impl<T: fmt::Debug> fmt::Debug for Apart<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}
