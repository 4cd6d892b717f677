//! The register of locale files and the messages read from them.

use super::Language;
use fluent_bundle::{FluentArgs, FluentBundle, FluentResource, FluentValue};
use std::collections::HashMap;

macro_rules! locale_files {
    ($($name:literal)*) => {
        /// The files of a language: name and text.
        pub(super) const fn files(language: Language) -> &'static [(&'static str, &'static str)] {
            match language {
                Language::English => &[$(($name, include_str!(concat!("../../locales/en/", $name, ".ftl"))),)*],
                Language::Russian => &[$(($name, include_str!(concat!("../../locales/ru/", $name, ".ftl"))),)*],
            }
        }
    };
}

// The register: one line for each file, which stands in both languages.
locale_files! {
    "app"
    "chooser"
    "common"
    "dialogs"
    "doctor"
    "files"
    "gallery"
    "glossary"
    "help"
    "kinds"
    "library"
    "list"
    "materials"
    "menu"
    "params"
    "properties"
    "status"
    "toolbar"
    "viewport"
    "widgets"
}

/// The messages of all languages, each read when it is first needed.
#[derive(Default)]
pub(super) struct Locales(HashMap<&'static str, FluentBundle<FluentResource>>);

impl Locales {
    /// The text of a key in a language. None when it has no such key or a value is missing.
    pub(super) fn text(
        &mut self,
        language: Language,
        key: &str,
        values: &[(&str, FluentValue<'_>)],
    ) -> Option<String> {
        let bundle = self.0.entry(language.tag()).or_insert_with(|| bundle(language));
        let (id, attribute) = key.split_once('.').map_or((key, None), |(id, name)| (id, Some(name)));
        let message = bundle.get_message(id)?;
        let pattern = match attribute {
            Some(name) => message.get_attribute(name)?.value(),
            None => message.value()?,
        };
        let mut args = FluentArgs::with_capacity(values.len());
        values.iter().for_each(|(name, value)| args.set(*name, value.clone()));
        let mut errors = Vec::new();
        let text = bundle.format_pattern(pattern, Some(&args), &mut errors).into_owned();
        errors.is_empty().then_some(text)
    }
}

/// A broken entry is left out, and a test names it; the rest of its file is kept.
fn bundle(language: Language) -> FluentBundle<FluentResource> {
    let tag = language.tag().parse().unwrap_or_default();
    let mut bundle = FluentBundle::new(vec![tag]);
    // No invisible marks of direction around values: both languages read from left to right.
    bundle.set_use_isolating(false);
    for (_, text) in files(language) {
        let resource = FluentResource::try_new((*text).to_owned()).unwrap_or_else(|(whole, _)| whole);
        bundle.add_resource_overriding(resource);
    }
    bundle
}
