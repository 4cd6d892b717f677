//! What the window says, in every language.

mod language;

pub use language::Language;
