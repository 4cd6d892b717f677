//! What the locales promise: the same messages in every language, none missing, none that nobody says.

use super::*;
use fluent_bundle::FluentResource;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use vitrine::scene::{
    Camera, Group, Item as _, KindSpec, Light, LightSource, ListName, Material, Object, ParamKind, ParamSpec,
    Settings, Shape, Texture, TextureSource,
};

/// The parts of a message: the variables in its value and in each attribute.
type Parts = BTreeMap<String, BTreeSet<String>>;

/// The messages of a language, by key.
fn messages(language: Language) -> BTreeMap<String, Parts> {
    let mut found = BTreeMap::new();
    for (name, text) in files_of(language) {
        let parsed = FluentResource::try_new((*text).to_owned());
        assert!(
            parsed.is_ok(),
            "{}/{name}.ftl: {:?}",
            language.tag(),
            parsed.err().map(|(_, errors)| errors)
        );
        let mut key = String::new();
        for line in text.lines().filter(|l| !l.starts_with('#') && !l.trim().is_empty()) {
            let part = line.split_once('=').map(|(head, _)| head.trim().to_owned());
            let attribute = line.trim_start().starts_with('.');
            if !line.starts_with([' ', '}']) {
                key = part.clone().unwrap_or_default();
                let before = found.insert(key.clone(), Parts::new());
                assert!(before.is_none(), "{key} stands twice in {}", language.tag());
            }
            let part = if attribute { part.unwrap_or_default() } else { String::new() };
            let parts: &mut Parts = found.get_mut(&key).unwrap();
            let variables = line.split('$').skip(1).map(|v| {
                v.chars().take_while(|c| c.is_alphanumeric() || matches!(c, '-' | '_')).collect::<String>()
            });
            parts.entry(part).or_default().extend(variables);
        }
    }
    found
}

#[test]
fn both_languages_have_the_same_messages_with_the_same_values() {
    let [english, mut russian] = Language::ALL.map(messages);
    for (key, parts) in &mut russian {
        // English tooltips of parameters come from their descriptions, and one general label can serve several kinds.
        if key.starts_with("param-") && english.get(key).is_none_or(|p| !p.contains_key(".tooltip")) {
            parts.remove(".tooltip");
        }
    }
    russian.retain(|key, _| english.contains_key(key) || !RUSSIAN_ALONE.contains(&key.as_str()));
    let keys = |m: &BTreeMap<String, Parts>| m.keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&english), keys(&russian));
    assert_eq!(english, russian);
}

/// Parameters whose English descriptions differ while one Russian tooltip would be wrong for both.
const RUSSIAN_ALONE: &[&str] = &["param-light-visible", "param-light-position"];

/// The sources of the editor: their paths and texts.
fn sources() -> Vec<(String, String)> {
    fn walk(folder: &Path, found: &mut Vec<(String, String)>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push((path.display().to_string(), std::fs::read_to_string(&path).unwrap()));
            }
        }
    }
    let mut found = Vec::new();
    walk(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut found);
    found
}

/// The keys in `tr!("…")`, with whatever white space a formatter puts between.
fn keys_in(text: &str) -> Vec<&str> {
    let calls = text
        .match_indices("tr!(")
        .filter(|(at, _)| !text[..*at].ends_with(|c: char| c.is_alphanumeric() || c == '_'));
    calls
        .filter_map(|(at, call)| text[at + call.len()..].trim_start().strip_prefix('"')?.split('"').next())
        .collect()
}

#[test]
fn every_key_in_the_sources_is_in_the_locales() {
    let messages = messages(Language::English);
    let is_there = |key: &str| {
        let (id, attribute) =
            key.split_once('.').map_or((key, String::new()), |(id, a)| (id, format!(".{a}")));
        messages.get(id).is_some_and(|parts| parts.contains_key(&attribute))
    };
    let mut missing = Vec::new();
    for (path, text) in sources().iter().filter(|(path, _)| !path.contains("/text/")) {
        let keys = keys_in(text).into_iter().filter(|key| !is_there(key));
        missing.extend(keys.map(|key| format!("{key} in {path}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// The name of a language in itself, and the program's own, are the same in every language.
const NAMES: [&str; 2] = ["\"Vitrine\"", "\"EN\""];

#[test]
fn no_words_stand_in_the_sources() {
    let makers =
        [".label(", ".button(", ".heading(", "RichText::new(", "Button::new(", "Label::new(", "hover_text("];
    let mut found = Vec::new();
    for (path, text) in sources().iter().filter(|(path, _)| !path.contains("tests")) {
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        for (maker, quoted) in makers.iter().flat_map(|m| code.split(m).skip(1).map(move |rest| (m, rest))) {
            let Some(words) = quoted.strip_prefix('"').and_then(|q| q.split('"').next()) else { continue };
            let is_word = words.chars().filter(|c| c.is_alphabetic()).count() > 1;
            if is_word && !NAMES.contains(&format!("\"{words}\"").as_str()) {
                found.push(format!("{maker}{words:?} in {path}"));
            }
        }
        let colors = [
            "Color32::RED",
            "Color32::WHITE",
            "Color32::BLACK",
            "Color32::GRAY",
            "Color32::GREEN",
            "Color32::YELLOW",
        ];
        let is_theme = path.contains("/theme/");
        found.extend(
            colors.iter().filter(|c| !is_theme && code.contains(**c)).map(|c| format!("{c} in {path}")),
        );
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn every_message_is_said_somewhere() {
    let all = sources().into_iter().map(|(_, text)| text).collect::<String>();
    // Keys that are put together from words: their files say of what.
    let composed = ["param-", "kind-", "choice-"];
    let unused: Vec<_> = messages(Language::English)
        .into_keys()
        .filter(|key| !composed.iter().any(|c| key.starts_with(c)))
        .filter(|key| !all.contains(&format!("\"{key}\"")) && !all.contains(&format!("\"{key}.")))
        .filter(|key| !is_composed(key, &all))
        .collect();
    assert!(unused.is_empty(), "{unused:#?}");
}

/// Whether the sources put the key together: `format!("library-{word}")` says "library-glass".
fn is_composed(key: &str, sources: &str) -> bool {
    let ends = key.match_indices('-').map(|(at, _)| &key[..=at]);
    ends.into_iter().any(|start| sources.contains(&format!("\"{start}{{")))
}

#[test]
fn an_unused_parameter_message_is_found() {
    let names: BTreeSet<&str> = owners().iter().flat_map(|(_, specs)| specs.iter().map(|s| s.name)).collect();
    let keys = messages(Language::English).into_keys();
    for key in keys.filter(|k| k.starts_with("param-") && k != "param-key") {
        assert!(key.split('-').next_back().is_some_and(|name| names.contains(name)), "{key}");
    }
}

/// Everything that has parameters: the word for its messages, and them.
fn owners() -> Vec<(&'static str, &'static [ParamSpec])> {
    let mut owners = vec![
        ("settings", Settings::SPECS),
        ("camera", Camera::SPECS),
        ("object", Object::OWN_SPECS),
        ("light", Light::OWN_SPECS),
        ("group", Group::OWN_SPECS),
        ("material", Material::OWN_SPECS),
        ("texture", Texture::OWN_SPECS),
    ];
    owners.extend(kinds().into_iter().map(|(_, kind)| (kind.name, kind.specs)));
    owners
}

fn kinds() -> Vec<(ListName, KindSpec)> {
    let of = |list, kinds: &'static [KindSpec]| kinds.iter().map(move |k| (list, *k));
    of(ListName::Object, Shape::KINDS)
        .chain(of(ListName::Light, LightSource::KINDS))
        .chain(of(ListName::Texture, TextureSource::KINDS))
        .collect()
}

#[test]
fn every_parameter_has_a_label_and_a_tooltip_in_every_language() {
    for language in Language::ALL {
        set_language(language);
        for (kind, specs) in owners() {
            for spec in specs {
                let place = format!("{} of {kind} in {}", spec.name, language.tag());
                assert_ne!(param_label(kind, spec), spec.name, "{place}");
                let tooltip = param_tooltip(kind, spec);
                assert!(tooltip.len() > 10, "{place}: {tooltip}");
                let is_russian = tooltip.lines().next().unwrap().chars().any(|c| ('а'..='я').contains(&c));
                assert_eq!(is_russian, language == Language::Russian, "{place}: {tooltip}");
            }
        }
    }
    set_language(Language::English);
}

#[test]
fn every_kind_and_every_choice_has_a_name_in_every_language() {
    for language in Language::ALL {
        set_language(language);
        for (list, kind) in kinds() {
            assert_ne!(kind_name_in(list, kind.name), kind.name, "{}", language.tag());
        }
        for (_, specs) in owners() {
            for spec in specs {
                let ParamKind::Choice(words) = spec.kind else { continue };
                words.iter().for_each(|w| assert_ne!(choice_name(spec, w), *w, "{}", language.tag()));
            }
        }
    }
    set_language(Language::English);
}

/// PRODUCT's names, to the letter.
#[test]
fn names_on_the_panels_are_the_agreed_ones() {
    let labels = [
        ("camera", "view_angle_deg", "Zoom angle", "Угол обзора"),
        ("camera", "look_at", "Look at", "Смотреть на"),
        ("camera", "position", "Camera place", "Позиция камеры"),
        ("object", "turn_deg", "Turn", "Поворот"),
        ("light", "intensity", "Brightness", "Интенсивность"),
        ("disc", "radius", "Disc radius", "Радиус диска"),
        ("material", "diffuse", "Matte amount (diffuse)", "Матовость (рассеянное отражение)"),
        ("material", "specular", "Highlight (specular)", "Блик (зеркальное отражение)"),
        ("material", "shininess", "Highlight size (shininess)", "Размер блика (блеск)"),
        ("material", "reflectivity", "Mirror (reflectivity)", "Отражающая способность"),
        ("material", "refraction", "Light bending (index)", "Преломление"),
        ("material", "texture", "Picture on surface", "Картинка на поверхности"),
        ("settings", "depth", "Reflection depth", "Глубина рекурсии отражений"),
    ];
    for (kind, name, english, russian) in labels {
        let owners = owners();
        let spec =
            owners.iter().filter(|(k, _)| *k == kind).flat_map(|(_, s)| *s).find(|s| s.name == name).unwrap();
        set_language(Language::Russian);
        assert_eq!(param_label(kind, spec), russian);
        set_language(Language::English);
        assert_eq!(param_label(kind, spec), english);
    }
}

#[test]
fn a_missing_key_shows_itself_and_values_are_put_in() {
    assert_eq!(tr!("no-such-key"), "no-such-key");
    assert_eq!(try_tr("no-such-key"), None);
    assert_eq!(tr!("widgets-from-to", min = "1", max = "2"), "From 1 to 2");
    set_language(Language::Russian);
    assert_eq!(tr!("widgets-from-to", min = "1", max = "2"), "От 1 до 2");
    set_language(Language::English);
}
