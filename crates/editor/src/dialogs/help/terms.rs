//! The terms of the glossary, in the order in which one may learn them. Their texts stand in `locales/*/glossary.ftl`.

use crate::text::{self, Language};

/// The words of the terms: the term has the key `glossary-<word>`, what it means the attribute `meaning`.
pub const TERMS: [&str; 50] = [
    "ray-tracing",
    "ray-casting",
    "path-tracing",
    "ray",
    "rendering",
    "live-picture",
    "scene",
    "object",
    "group",
    "camera",
    "view-angle",
    "axis",
    "ground",
    "sphere",
    "box",
    "triangle",
    "model",
    "normal",
    "smooth",
    "material",
    "texture",
    "uv",
    "diffuse",
    "specular",
    "shininess",
    "phong",
    "lambert",
    "reflectivity",
    "transparency",
    "refraction",
    "index",
    "fresnel",
    "light",
    "ambient",
    "point-light",
    "directional-light",
    "disc-light",
    "intensity",
    "shadow",
    "soft-shadow",
    "depth",
    "sample",
    "pass",
    "antialiasing",
    "noise",
    "pixel",
    "threads",
    "view-transform",
    "png",
    "exr",
];

/// A term in one language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Words {
    /// The term.
    pub term: String,
    /// What it means.
    pub meaning: String,
}

/// A term in all languages, in the order of [`Language::ALL`].
#[must_use]
pub fn in_all_languages(word: &str) -> [Words; 2] {
    let current = text::language();
    let key = format!("glossary-{word}");
    let words = Language::ALL.map(|language| {
        text::set_language(language);
        Words { term: text::text_of(&key, &[]), meaning: text::text_of(&format!("{key}.meaning"), &[]) }
    });
    text::set_language(current);
    words
}

/// The terms in which every word of the search occurs, in any language; those that begin with it first.
#[must_use]
pub fn search(text: &str) -> Vec<[Words; 2]> {
    let text = text.trim().to_lowercase();
    let parts: Vec<&str> = text.split_whitespace().collect();
    let all = |words: &[Words; 2]| {
        words.iter().map(|w| format!("{} {}", w.term, w.meaning)).collect::<Vec<_>>().join(" ").to_lowercase()
    };
    let mut found: Vec<_> = TERMS.iter().map(|word| in_all_languages(word)).collect();
    found.retain(|words| parts.iter().all(|part| all(words).contains(part)));
    found.sort_by_key(|words| !words.iter().any(|w| w.term.to_lowercase().starts_with(&text)));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_term_is_explained_in_both_languages() {
        for word in TERMS {
            let [english, russian] = in_all_languages(word);
            for words in [&english, &russian] {
                assert!(!words.term.starts_with("glossary-"), "{word} has no text");
                assert!(words.meaning.ends_with('.'), "{word}: {}", words.meaning);
            }
            assert_ne!(english.meaning, russian.meaning, "{word}");
        }
    }

    #[test]
    fn terms_are_found_by_either_language() {
        let first = |text: &str| search(text).first().map(|words| words[0].term.clone());
        assert_eq!(first("soft"), Some("Soft shadow".into()));
        assert_eq!(first("мягкая"), Some("Soft shadow".into()));
        assert_eq!(search("").len(), TERMS.len());
        assert_eq!(search("no such word"), Vec::<[Words; 2]>::new());
    }
}
