//! «Save picture».

mod draft;
mod form;

pub use draft::{
    CurrentPicture, PictureFormat, PictureSource, RENDERERS, SaveDraft, SaveFlaw, SavePictureRequest,
};
pub use form::SaveDialog;
