//! Names of kinds, parameters and choices, from their descriptions in the scene crate.
//!
//! A parameter's label is the message `param-<name>`, or `param-<kind>-<name>` where a kind needs another word. Its tooltip
//! is that message's attribute `tooltip`; in English the description itself is the tooltip unless a locale says otherwise.

use super::{tr, try_tr, try_tr_here};
use vitrine::scene::{Group, Item as _, Light, ListName, Material, Object, ParamSpec, Texture};

/// The label of a parameter. `kind` is the word of the kind ("sphere"), of the list ("object"), "camera" or "settings".
#[must_use]
pub fn param_label(kind: &str, spec: &ParamSpec) -> String {
    try_tr(&format!("param-{kind}-{}", spec.name))
        .or_else(|| try_tr(&spec.label_key()))
        .unwrap_or_else(|| spec.name.to_owned())
}

/// The tooltip of a parameter.
#[must_use]
pub fn param_tooltip(kind: &str, spec: &ParamSpec) -> String {
    let keys = [format!("param-{kind}-{}.tooltip", spec.name), format!("{}.tooltip", spec.label_key())];
    let stated = keys.iter().find_map(|key| try_tr_here(key));
    let text = stated.unwrap_or_else(|| spec.doc.split_whitespace().collect::<Vec<_>>().join(" "));
    format!("{text}\n{}", tr!("param-key", key = spec.name))
}

/// The name of a kind ("sphere") or of a part of the scene ("camera").
#[must_use]
pub fn kind_name(word: &str) -> String {
    try_tr(&format!("kind-{word}")).unwrap_or_else(|| word.to_owned())
}

/// The name of a kind of a list's entries: a "disc" among the lights is a lamp, among the objects it is not.
#[must_use]
pub fn kind_name_in(list: ListName, word: &str) -> String {
    try_tr(&format!("kind-{}-{word}", list.key())).unwrap_or_else(|| kind_name(word))
}

/// The name of a word of a choice: "repeat" of "wrap".
#[must_use]
pub fn choice_name(spec: &ParamSpec, word: &str) -> String {
    try_tr(&format!("choice-{}-{word}", spec.name)).unwrap_or_else(|| word.to_owned())
}

/// What is said where a choice has not been made: "none" unless the parameter has a word of its own.
#[must_use]
pub fn no_choice_name(spec: &ParamSpec) -> String {
    try_tr(&format!("choice-{}-none", spec.name)).unwrap_or_else(|| tr!("widgets-none"))
}

/// The parameters that all entries of a list have, whatever their kind. Their texts are looked up under the list's word.
#[must_use]
pub const fn own_specs(list: ListName) -> &'static [ParamSpec] {
    match list {
        ListName::Object => Object::OWN_SPECS,
        ListName::Light => Light::OWN_SPECS,
        ListName::Material => Material::OWN_SPECS,
        ListName::Texture => Texture::OWN_SPECS,
        ListName::Group => Group::OWN_SPECS,
    }
}
