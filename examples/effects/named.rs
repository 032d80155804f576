//! The effects that a file names.

use super::{At, FileError, Source};

/// An effect that a file of this kind can name.
pub(crate) trait Effect<File>: Copy + PartialEq + 'static {
    const ALL: &'static [Self];

    /// What it is called in a file.
    fn name(self) -> &'static str;

    /// The effect without which this one makes no sense.
    fn requires(self) -> Option<Self> {
        None
    }

    /// Whether the file has the data of the effect.
    fn has_data(self, file: &File) -> bool;
}

/// The effects of a file's list, each known, with its data, and with what it requires.
pub(crate) fn named<File, E: Effect<File>>(
    names: &[At<String>],
    file: &File,
    source: &Source<'_>,
) -> Result<Vec<E>, FileError> {
    let mut effects: Vec<E> = Vec::new();
    for name in names {
        let fault = |message: String| source.error(name.span(), "effects", message);
        let known = E::ALL.iter().copied().find(|effect| effect.name() == name.get_ref());
        let Some(effect) = known else {
            let all: Vec<&str> = E::ALL.iter().map(|effect| effect.name()).collect();
            let all = all.join(", ");
            return Err(fault(format!("there is no effect `{}`: choose {all}", name.get_ref())));
        };
        if effects.contains(&effect) {
            return Err(fault(format!("`{}` is named twice", effect.name())));
        }
        if !effect.has_data(file) {
            return Err(fault(format!("the file has no data for `{}`", effect.name())));
        }
        effects.push(effect);
    }
    for (effect, name) in effects.iter().zip(names) {
        if let Some(other) = effect.requires().filter(|other| !effects.contains(other)) {
            let message = format!("`{}` makes no sense without `{}`", effect.name(), other.name());
            return Err(source.error(name.span(), "effects", message));
        }
    }
    Ok(effects)
}
