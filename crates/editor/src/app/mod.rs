//! The window: it draws the panels, and after each frame carries out what was asked for.

mod carry;
mod chooser;
mod frame;
mod launch;
mod notices;
mod picture;
mod scenes;

pub use launch::{LaunchError, WINDOW_SIZE, run};

use crate::action::Actions;
use crate::dialogs::Dialog;
use crate::dialogs::tour::Tour;
use crate::doctor::{self, Brightness};
use crate::document::Document;
use crate::files::{Autosave, Config, Places, Recent, Wake};
use crate::library::Thumbnails;
use crate::live::Live;
use crate::panels::gallery::GalleryState;
use crate::panels::list::ListState;
use crate::panels::materials::MaterialsState;
use crate::panels::properties::PropertiesState;
use crate::viewport::Viewport;
use crate::{text, theme};
use chooser::Chooser;
use eframe::egui::Context;
use notices::Notices;
use picture::PictureSaver;
use scenes::Scenes;
use std::path::PathBuf;
use std::sync::Arc;

/// The window and everything in it.
pub struct Editor {
    document: Document,
    /// Whether the gallery of templates is shown in place of the scene.
    is_choosing: bool,
    live: Live,
    viewport: Viewport,
    list: ListState,
    properties: PropertiesState,
    materials: MaterialsState,
    gallery: GalleryState,
    thumbnails: Thumbnails,
    dialog: Option<Dialog>,
    tour: Option<Tour>,
    chooser: Chooser,
    notices: Notices,
    scenes: Scenes,
    picture: PictureSaver,
    doctor: Doctor,
    config: Config,
    recent: Recent,
    autosave: Autosave,
    places: Places,
    actions: Actions,
    wake: Wake,
    /// Whether the person has agreed that the window closes.
    may_close: bool,
}
