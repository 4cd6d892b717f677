//! Help: keys, the glossary, what the program is made of.

mod about;
mod glossary;
mod keys;
mod terms;

pub use glossary::GlossaryDialog;
pub use terms::{TERMS, Words, in_all_languages, search as search_terms};

pub(super) use about::about;
pub(super) use keys::shortcuts;
