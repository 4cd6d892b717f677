//! «Model settings», before a model is added and after.

mod draft;
mod form;
#[cfg(test)]
mod tests;

pub use draft::{LoadedModel, ModelDraft, Units, Up};
pub use form::ModelDialog;
