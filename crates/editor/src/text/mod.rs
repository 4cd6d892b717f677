//! What the window says, in every language: Fluent messages from `locales/`, looked up by key with [`tr!`](crate::tr).
//!
//! The current language belongs to the thread, so that tests in different languages run side by side.

mod language;
mod locale;
mod params;

pub use crate::tr;
pub use fluent_bundle::FluentValue;
pub use language::Language;
pub use params::{
    choice_name, kind_name, kind_name_in, no_choice_name, own_specs, param_label, param_tooltip,
};

use locale::Locales;
use std::cell::{Cell, RefCell};

thread_local! {
    static LANGUAGE: Cell<Language> = const { Cell::new(Language::English) };
    static LOCALES: RefCell<Locales> = RefCell::default();
}

/// The text of a key in the current language: `tr!("menu-save")`, `tr!("status-passes", done = 3, all = 64)`.
/// Numbers that are not whole should come as finished text.
#[macro_export]
macro_rules! tr {
    ($key:expr) => { $crate::text::text_of($key, &[]) };
    ($key:expr, $($name:ident = $value:expr),+ $(,)?) => {
        $crate::text::text_of($key, &[$((stringify!($name), $crate::text::FluentValue::from($value))),+])
    };
}

/// Sets the language of this thread.
pub fn set_language(language: Language) {
    LANGUAGE.set(language);
}

/// The language of this thread.
#[must_use]
pub fn language() -> Language {
    LANGUAGE.get()
}

/// What [`tr!`](crate::tr) stands for: the text in the current language, else in English, else the key itself.
#[must_use]
pub fn text_of(key: &str, values: &[(&str, FluentValue<'_>)]) -> String {
    find(key, values).unwrap_or_else(|| key.to_owned())
}

/// The text of a key in the current language or in English; None when there is none. A key with a dot names an
/// attribute: "param-radius.tooltip".
#[must_use]
pub fn try_tr(key: &str) -> Option<String> {
    find(key, &[])
}

fn find(key: &str, values: &[(&str, FluentValue<'_>)]) -> Option<String> {
    let current = language();
    LOCALES.with_borrow_mut(|locales| {
        locales.text(current, key, values).or_else(|| locales.text(Language::English, key, values))
    })
}

/// The locale files of a language, name and text, for tests that check them.
#[cfg(test)]
pub fn files_of(language: Language) -> &'static [(&'static str, &'static str)] {
    locale::files(language)
}

/// The text of a key in the current language alone.
fn try_tr_here(key: &str) -> Option<String> {
    LOCALES.with_borrow_mut(|locales| locales.text(language(), key, &[]))
}

#[cfg(test)]
mod tests;
