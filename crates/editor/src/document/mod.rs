//! What is being edited: the scene with its models and pictures, what is selected, what can be undone. Nothing here knows
//! of a window; whatever a person can do is an [`EditCommand`], which a test or a script can give as well.

mod asset_files;
mod bounds;
mod clipboard;
mod command;
mod cover;
mod defaults;
mod edits;
mod error;
mod history;
mod message;
mod patch;
mod saving;
mod selection;
mod thing;

pub(crate) use asset_files::missing;
pub use bounds::{bounds_of, bounds_of_all};
pub(crate) use bounds::{object_bounds, plane_level};
pub use clipboard::copy;
pub use command::{Addition, CameraMove, EditCommand, Paint};
pub use cover::cover;
pub use defaults::{free_name, free_name_among, new_thing, orbit_center};
pub use error::{EditError, allowed, problem};
pub use history::{Gesture, History};
pub use message::Message;
pub use selection::Selection;
pub use thing::Thing;

use edits::Draft;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::formats::{SceneFile, folder_of};
use vitrine::scene::{Assets, ListName, Scene, Severity, Shape};

/// A scene that is being edited. There is never one with errors in it: an edit that would make one is refused.
#[derive(Debug)]
pub struct Document {
    scene: Arc<Scene>,
    assets: Arc<Assets>,
    asset_warnings: Vec<String>,
    selection: Selection,
    history: History,
    /// What was read or written last: its text, with a person's remarks, is changed and not made anew.
    file: SceneFile,
    path: Option<PathBuf>,
    folder: PathBuf,
    /// The scene as it was when there was nothing to save; None: there is no such one.
    saved: Option<Arc<Scene>>,
    is_changed: bool,
    revision: u64,
}

impl Document {
    /// A new scene that begins as a file says and has never been saved. `folder` is where the file's models and pictures
    /// are.
    #[must_use]
    pub fn untitled(file: SceneFile, assets: Assets, folder: PathBuf) -> Self {
        let scene = Arc::new(file.scene().clone());
        Self {
            saved: Some(scene.clone()),
            scene,
            assets: Arc::new(assets),
            asset_warnings: Vec::new(),
            selection: Selection::default(),
            history: History::default(),
            file,
            path: None,
            folder,
            is_changed: false,
            revision: 0,
        }
    }

    /// A scene that was read from a file.
    #[must_use]
    pub fn opened(file: SceneFile, assets: Assets, asset_warnings: Vec<String>, path: PathBuf) -> Self {
        let folder = folder_of(&path).to_owned();
        Self { asset_warnings, path: Some(path), ..Self::untitled(file, assets, folder) }
    }

    /// The scene as it is now. Cheap to clone: renderers and savers take it with them.
    #[must_use]
    pub const fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The models and pictures that it names. They only grow, for undoing brings back what was deleted.
    #[must_use]
    pub const fn assets(&self) -> &Arc<Assets> {
        &self.assets
    }

    /// What may not be as it was meant in the models and pictures: one sentence each.
    #[must_use]
    pub fn asset_warnings(&self) -> &[String] {
        &self.asset_warnings
    }

    /// The file that it was read from or saved to; None for a new one.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The folder from which the scene names its models and pictures.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The name of its file; None for a new scene.
    #[must_use]
    pub fn title(&self) -> Option<String> {
        Some(self.path.as_ref()?.file_name()?.to_string_lossy().into_owned())
    }

    /// The scene as the text of a file, with the remarks and the order that its file has.
    #[must_use]
    pub fn text(&self) -> String {
        self.file.print(&self.scene)
    }

    /// Grows with every change of the scene, so that others know when to look again.
    #[must_use]
    pub const fn revision(&self) -> u64 {
        self.revision
    }

    /// Whether there is something to save.
    #[must_use]
    pub const fn is_changed(&self) -> bool {
        self.is_changed
    }

    /// Notes that this scene stands in no file: it was recovered after a crash.
    pub fn mark_unsaved(&mut self) {
        self.saved = None;
        self.compare_with_saved();
    }

    fn compare_with_saved(&mut self) {
        let is_same = |saved: &Arc<Scene>| Arc::ptr_eq(saved, &self.scene) || *saved == self.scene;
        self.is_changed = !self.saved.as_ref().is_some_and(is_same);
    }

    /// Takes models, pictures and panoramas in that were read elsewhere, before the edit that names them, so that the edit need not
    /// read them while a person waits.
    pub fn provide(&mut self, assets: Assets, warnings: Vec<String>) {
        let all = Arc::make_mut(&mut self.assets);
        all.meshes.extend(assets.meshes);
        all.pictures.extend(assets.pictures);
        all.maps.extend(assets.maps);
        for warning in warnings {
            if !self.asset_warnings.contains(&warning) {
                self.asset_warnings.push(warning);
            }
        }
    }

    /// Whether a thing is an object that is a model.
    #[must_use]
    pub fn is_model(&self, thing: &Thing) -> bool {
        let object = thing.name().and_then(|name| self.scene.object(name));
        thing.list() == Some(ListName::Object) && object.is_some_and(|o| matches!(o.shape, Shape::Mesh(_)))
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
        let mut draft = Draft {
            scene: Scene::clone(&self.scene),
            selection: self.selection.clone(),
            assets: &self.assets,
        };
        draft.carry_out(command)?;
        let Draft { scene, mut selection, .. } = draft;
        selection.keep_what_is_in(&scene);
        if scene == *self.scene {
            self.selection = selection;
            return Ok(());
        }
        let first_error = scene.problems().into_iter().find(|p| p.severity == Severity::Error);
        if let Some(problem) = first_error {
            return Err(EditError::Scene(problem.cause));
        }
        self.load_what_is_new(&scene)?;
        self.history.note([&self.scene, &scene], [self.selection.clone(), selection.clone()], gesture);
        self.scene = Arc::new(scene);
        self.selection = selection;
        self.after_change();
        Ok(())
    }

    fn after_change(&mut self) {
        self.revision += 1;
        self.compare_with_saved();
    }

    /// Takes the last step back. False when there is none.
    pub fn undo(&mut self) -> bool {
        let Some(selection) = self.history.undo(Arc::make_mut(&mut self.scene)) else { return false };
        self.selection = selection;
        self.after_change();
        true
    }

    /// Does the last undone step again. False when there is none.
    pub fn redo(&mut self) -> bool {
        let Some(selection) = self.history.redo(Arc::make_mut(&mut self.scene)) else { return false };
        self.selection = selection;
        self.after_change();
        true
    }

    /// What has been done.
    #[must_use]
    pub const fn history(&self) -> &History {
        &self.history
    }
}

impl Default for Document {
    /// An empty scene, without even a light.
    fn default() -> Self {
        let file = SceneFile::parse(Path::new(""), "format = 1\n").expect("an empty scene has no errors");
        Self::untitled(file, Assets::default(), PathBuf::from("."))
    }
}

#[cfg(test)]
mod tests;
