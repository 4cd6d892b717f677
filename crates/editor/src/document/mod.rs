//! What is being edited: the scene with its models and pictures, what is selected, what can be undone. Nothing here knows
//! of a window; whatever a person can do is an [`EditCommand`], which a test or a script can give as well.

mod command;
mod history;
mod selection;
mod thing;

pub use command::{Addition, CameraMove, EditCommand, Paint};
pub use history::{Gesture, History};
pub use selection::Selection;
pub use thing::Thing;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::scene::{Assets, ParamError, Scene};

/// Why an edit was not made. Then nothing has changed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// A value does not fit its parameter.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// There is no such thing.
    #[error("there is no such thing in the scene")]
    NoThing,
    /// A name is empty or taken.
    #[error("the name `{name}` is empty or taken")]
    Name {
        /// As given.
        name: String,
    },
}

/// A scene that is being edited.
#[derive(Debug, Default)]
pub struct Document {
    scene: Arc<Scene>,
    assets: Arc<Assets>,
    selection: Selection,
    history: History,
    /// The history's state that is on the disc.
    saved_state: u64,
    path: Option<PathBuf>,
    revision: u64,
}

impl Document {
    /// The scene as it is now. Cheap to clone: renderers and savers take it with them.
    #[must_use]
    pub const fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The models and pictures that it names.
    #[must_use]
    pub const fn assets(&self) -> &Arc<Assets> {
        &self.assets
    }

    /// The file that it was read from or saved to; None for a new one.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Grows with every change of the scene, so that others know when to look again.
    #[must_use]
    pub const fn revision(&self) -> u64 {
        self.revision
    }

    /// Whether there is something to save.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.history.state() != self.saved_state
    }

    /// What is selected.
    #[must_use]
    pub const fn selection(&self) -> &Selection {
        &self.selection
    }

    /// Selects these things and no others. Not a step of the history.
    pub fn select(&mut self, things: impl IntoIterator<Item = Thing>) {
        self.selection = Selection::of(things);
        self.selection.keep_what_is_in(&self.scene);
    }

    /// Makes an edit, as one step of the history.
    ///
    /// # Errors
    /// [`EditError`]; then nothing has changed.
    pub fn apply(&mut self, command: EditCommand) -> Result<(), EditError> {
        self.edit(command, None)
    }

    /// Makes an edit that belongs to a gesture: all edits of one gesture are undone together.
    ///
    /// # Errors
    /// [`EditError`]; then nothing has changed.
    pub fn drag(&mut self, command: EditCommand, gesture: Gesture) -> Result<(), EditError> {
        self.edit(command, Some(gesture))
    }

    fn edit(&mut self, command: EditCommand, gesture: Option<Gesture>) -> Result<(), EditError> {
        let mut scene = Scene::clone(&self.scene);
        let mut selection = self.selection.clone();
        if let EditCommand::Set { things, key, value } = command {
            for thing in &things {
                let owner = thing.owner(&scene).ok_or(EditError::NoThing)?;
                scene.set(owner, &key, value.clone())?;
            }
        }
        selection.keep_what_is_in(&scene);
        if scene == *self.scene {
            return Ok(());
        }
        self.history.note([&self.scene, &scene], [self.selection.clone(), selection.clone()], gesture);
        self.scene = Arc::new(scene);
        self.selection = selection;
        self.revision += 1;
        Ok(())
    }

    /// Takes the last step back. False when there is none.
    pub fn undo(&mut self) -> bool {
        let scene = Arc::make_mut(&mut self.scene);
        let Some(selection) = self.history.undo(scene) else { return false };
        self.selection = selection;
        self.revision += 1;
        true
    }

    /// Does the last undone step again. False when there is none.
    pub fn redo(&mut self) -> bool {
        let scene = Arc::make_mut(&mut self.scene);
        let Some(selection) = self.history.redo(scene) else { return false };
        self.selection = selection;
        self.revision += 1;
        true
    }

    /// What has been done.
    #[must_use]
    pub const fn history(&self) -> &History {
        &self.history
    }
}
