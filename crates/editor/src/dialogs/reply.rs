//! What dialogs ask for that is no action of the rest of the window.

use super::SavePictureRequest;
use crate::action::Action;
use std::path::PathBuf;

/// What a dialog asks of the window.
#[derive(Clone, Debug, PartialEq)]
pub enum Reply {
    /// Save a picture.
    SavePicture(Box<SavePictureRequest>),
    /// Let the person choose a file, then give it to [`Dialog::take_path`](super::Dialog::take_path). The dialog stays open.
    Browse(Browse),
    /// Save the scene, then do what waits.
    SaveThen(Box<Action>),
    /// Do what waits; the changes are lost.
    DropThen(Box<Action>),
    /// Read the open scene again from the disc.
    Reload(PathBuf),
    /// Keep the scene as it is here.
    KeepMine(PathBuf),
    /// Begin the guided tour.
    BeginTour,
}

/// What a file is chosen for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Browse {
    /// A picture that exists, for a texture.
    Texture,
    /// Where to save a picture; the name as it stands.
    SavePicture(PathBuf),
}
