//! The parts of the window. Each draws what there is and says what a person asked for; none changes anything.

pub mod gallery;
pub mod list;
pub mod materials;
pub mod menu;
pub mod properties;
pub mod status;
mod thumbnail;
pub mod toolbar;

use crate::document::{Document, Thing};
use crate::files::Config;
use std::path::PathBuf;
use vitrine::scene::Value;

/// How the final render stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RenderState {
    /// There is none, or it is done: the live picture is shown.
    #[default]
    Idle,
    /// It goes on.
    Running,
    /// It was stopped and can go on.
    Stopped,
}

/// What the bars around the picture show.
#[derive(Debug)]
pub struct Around<'a> {
    /// What is edited.
    pub document: &'a Document,
    /// The settings of the program.
    pub config: &'a Config,
    /// Scenes that were open lately, the last first.
    pub recent: Vec<PathBuf>,
    /// The scene's name.
    pub title: String,
    /// How the final render stands.
    pub render: RenderState,
}

impl Around<'_> {
    /// What is selected and stands in a list of the scene.
    #[must_use]
    pub fn selected_items(&self) -> Vec<Thing> {
        self.document.selection().things().iter().filter(|t| t.list().is_some()).cloned().collect()
    }

    /// Whether the thing selected last is a model.
    #[must_use]
    pub fn has_model_selected(&self) -> bool {
        self.document.selection().last().is_some_and(|thing| self.document.is_model(thing))
    }

    /// A parameter of the scene's settings.
    #[must_use]
    pub fn setting(&self, key: &str) -> Option<Value> {
        self.document.scene().value(vitrine::scene::Owner::Settings, key)
    }
}
