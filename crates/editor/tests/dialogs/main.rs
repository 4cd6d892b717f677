//! Dialogs, driven by the names that a screen reader says, in both languages.

mod look;
mod stories;
#[path = "../support/mod.rs"]
mod support;
mod tour;
mod world;
