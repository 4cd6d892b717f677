//! «Add» and «Edit»: an object or a light with its parameters and its material.

mod draft;
mod form;
mod material;
mod material_form;
#[cfg(test)]
mod tests;

pub use draft::{Flaw, Subject, ThingDraft};
pub use form::ThingDialog;
pub use material::{FIRST_KEYS, MaterialChoice, MaterialDraft};

pub(super) use draft::replace;
pub(super) use material_form::{MaterialAnswer, material_form};
