//! Scenes: published trajectories, laws of physics, and effects that cost nothing while they are off.

#[path = "../examples/scenes/mod.rs"]
#[allow(dead_code, reason = "the example uses more of it")]
mod files;

#[path = "../examples/scenes/output.rs"]
#[allow(dead_code, reason = "the example uses more of it")]
mod output;

#[path = "scenes/energy.rs"]
mod energy;
#[path = "scenes/faults.rs"]
mod faults;
#[path = "scenes/laws.rs"]
mod laws;
#[path = "scenes/published.rs"]
mod published;
#[path = "scenes/runs.rs"]
mod runs;
#[path = "scenes/twins/mod.rs"]
mod twins;
#[path = "scenes/without.rs"]
mod without;

use files::effects::{Source, files_in, named};
use files::file::SceneFile;
use files::mechanics;
use files::scene::Scene;
use mcp_core::dynamics::MoreauJean;
use std::fs;
use std::path::{Path, PathBuf};

fn directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes")
}

/// The file of a scene.
fn path_of(name: &str) -> PathBuf {
    directory().join(name).with_extension("toml")
}

/// The text of a scene.
fn text_of(name: &str) -> String {
    fs::read_to_string(path_of(name)).expect("the scene exists")
}

/// A scene as it stands in its file.
fn scene(name: &str) -> Scene {
    Scene::read(&path_of(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// Names of all scenes.
fn all() -> Vec<String> {
    let scenes = files_in(&directory()).expect("there are scenes").into_iter();
    let name = |path: PathBuf| path.file_stem().expect("it has a name").to_string_lossy().into();
    let names: Vec<String> = scenes.map(name).collect();
    assert!(names.len() >= 13, "{names:?}");
    names
}

/// A scene with bodies, its text changed by `edit`.
fn bodies(name: &str, edit: impl FnOnce(&mut toml::Table)) -> MoreauJean {
    let mut table: toml::Table = text_of(name).parse().expect("the scene is well formed");
    edit(&mut table);
    let text = toml::to_string(&table).expect("it was read from text");
    let source = Source { file: name, text: &text };
    let file: SceneFile = toml::from_str(&text).expect("the scene is well formed");
    let effects = named(&file.effects, &file, &source).unwrap_or_else(|error| panic!("{error}"));
    mechanics::stepper(&file, &effects, &source).unwrap_or_else(|error| panic!("{error}"))
}

/// Sets a number of the table `[key]`.
fn set(table: &mut toml::Table, key: &str, name: &str, value: f64) {
    let inner = table.get_mut(key).and_then(toml::Value::as_table_mut).expect("it has the table");
    inner.insert(name.to_owned(), value.into());
}

/// Sets the effects.
fn name_effects(table: &mut toml::Table, effects: &[&str]) {
    table.insert("effects".to_owned(), effects.to_vec().into());
}

/// The bits of a state.
fn bits(state: &[f64]) -> Vec<u64> {
    state.iter().map(|x| x.to_bits()).collect()
}

/// The entries `[[key]]` of a scene.
fn entries<'a>(table: &'a mut toml::Table, key: &str) -> &'a mut Vec<toml::Value> {
    table.get_mut(key).and_then(toml::Value::as_array_mut).expect("it has the entries")
}
