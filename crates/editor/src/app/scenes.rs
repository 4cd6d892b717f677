//! Opening, saving and adding from files, each on another thread while the window goes on.

use super::Editor;
use super::chooser::Purpose;
use crate::action::{Action, NewThing};
use crate::dialogs::{Changed, Dialog, ErrorReport, Failure, LoadedModel, ModelDialog, Unsaved};
use crate::document::{Addition, Document, EditCommand, Paint, Thing, cover, free_name};
use crate::files::{
    NewAsset, OpenError, Opened, SaveError, SaveRequest, Saved, Seen, Task, TaskState, file_name, read_model,
    read_panorama, read_picture, read_scene, read_template, save,
};
use crate::panels::list::ListState;
use crate::panels::properties::PropertiesState;
use crate::text::tr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::scene::{ListName, Scene, Value};

/// What is being read and written.
#[derive(Default)]
pub struct Scenes {
    opening: Option<Task<Result<Opened, OpenError>>>,
    saving: Option<Saving>,
    /// Where to save once more when that is done: two writers of one file would take each other for another program.
    save_again: Option<PathBuf>,
    adding: Option<(Task<Result<NewAsset, OpenError>>, Addend)>,
    /// What the scene's file said last.
    seen: Option<Seen>,
    /// What a file is chosen for: a parameter of something.
    chosen_for: Option<(Thing, String)>,
    /// What waits until the scene has been saved.
    after_save: Option<Action>,
    /// Whether the person has let changes go for the scene that is being opened.
    lets_changes_go: bool,
}

/// A scene that is being written.
struct Saving {
    task: Task<Result<Saved, SaveError>>,
    path: PathBuf,
    /// The scene that is written.
    scene: Arc<Scene>,
}

/// What a file is read for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Addend {
    /// A model, for the dialog «Model settings».
    Model,
    /// A picture, for the dialog that is open.
    PictureForDialog,
    /// A picture, for what is selected.
    PictureForSelection,
    /// Another model, for a parameter.
    ModelForParam,
    /// A picture, for a parameter.
    PictureForParam,
    /// A panorama, for a new light.
    Panorama,
    /// Another panorama, for a parameter.
    PanoramaForParam,
}

/// Reads a file for a scene whose paths count from a folder.
type Reader = fn(&Path, Option<&Path>) -> Result<NewAsset, OpenError>;

impl Addend {
    const fn is_model(self) -> bool {
        matches!(self, Self::Model | Self::ModelForParam)
    }

    const fn reader(self) -> Reader {
        match self {
            Self::Model | Self::ModelForParam => read_model,
            Self::PictureForDialog | Self::PictureForSelection | Self::PictureForParam => read_picture,
            Self::Panorama | Self::PanoramaForParam => read_panorama,
        }
    }
}

impl Scenes {
    /// What the scene's file said last.
    pub fn seen(&self) -> Option<Seen> {
        self.seen.clone()
    }

    /// Notes for which parameter a file is being chosen.
    pub fn choose_for(&mut self, thing: Thing, key: String) {
        self.chosen_for = Some((thing, key));
    }

    /// Notes what the scene's file said.
    pub fn set_seen(&mut self, seen: Option<Seen>) {
        self.seen = seen;
    }
}

impl Editor {
    /// Does something that puts another scene in place of this one, or asks first what to do with unsaved changes.
    pub(super) fn unless_unsaved(&mut self, action: Action, go: impl FnOnce(&mut Self)) {
        if self.document.is_changed() {
            let name = self.document.title();
            self.dialog = Some(Dialog::Unsaved(Box::new(Unsaved { name, then: action })));
        } else {
            go(self);
        }
    }

    /// Begins with a template, at once.
    pub(super) fn begin_with(&mut self, template: &str) {
        match read_template(template) {
            Ok(opened) => self.take_opened(opened),
            Err(error) => self.report(Failure::Scene, &error),
        }
    }

    /// Opens a scene, or adds a model, picture or panorama, by the ending of its name.
    pub(super) fn open_file(&mut self, path: PathBuf) {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let wake = self.wake.clone();
        match extension.as_str() {
            "obj" => self.add_file(path, Addend::Model),
            "hdr" | "exr" => self.add_file(path, Addend::Panorama),
            "png" | "jpg" | "jpeg" => self.add_file(path, Addend::PictureForSelection),
            _ => self.scenes.opening = Some(Task::spawn(wake, move || read_scene(&path))),
        }
    }

    /// Takes a file that a person has chosen.
    pub(super) fn take_chosen(&mut self, purpose: Purpose, path: PathBuf) {
        match purpose {
            Purpose::OpenScene => self.actions.push(Action::OpenFile(path)),
            Purpose::SaveScene => self.save_to(with_ending(path)),
            Purpose::LoadModel => self.add_file(path, Addend::Model),
            Purpose::LoadTexture => self.add_file(path, Addend::PictureForDialog),
            Purpose::ReplaceModel => self.add_file(path, Addend::ModelForParam),
            Purpose::LoadPanorama => self.add_file(path, Addend::Panorama),
            Purpose::ReplacePanorama => self.add_file(path, Addend::PanoramaForParam),
            Purpose::ReplaceTexture => self.add_file(path, Addend::PictureForParam),
            Purpose::SavePicture => {
                if let Some(dialog) = &mut self.dialog {
                    dialog.take_path(&path, &self.document);
                }
            }
        }
    }

    fn add_file(&mut self, path: PathBuf, addend: Addend) {
        let folder = self.scene_folder();
        let read = addend.reader();
        let task = Task::spawn(self.wake.clone(), move || read(&path, folder.as_deref()));
        self.scenes.adding = Some((task, addend));
    }

    /// The folder that the scene's paths count from; None while it has no file.
    pub(super) fn scene_folder(&self) -> Option<PathBuf> {
        let folder = self.document.folder();
        (!folder.as_os_str().is_empty()).then(|| folder.to_owned())
    }

    /// Saves the scene to its file, or asks for a name.
    pub(super) fn save(&mut self) {
        match self.document.path() {
            Some(path) => self.save_to(path.to_owned()),
            None => self.ask_where_to_save(),
        }
    }

    /// Asks under which name the scene is to be saved.
    pub(super) fn ask_where_to_save(&mut self) {
        let name = self.document.title().unwrap_or_else(|| format!("{}.vitrine.toml", tr!("app-untitled")));
        let folder = self.document.path().and_then(Path::parent).map(Path::to_owned);
        self.chooser.open(Purpose::SaveScene, folder.as_deref(), &name);
    }

    pub(super) fn save_to(&mut self, path: PathBuf) {
        let is_own_file = self.document.path() == Some(path.as_path());
        let seen = self.scenes.seen.clone().filter(|_| is_own_file);
        self.write(path, seen);
    }

    /// Saves the scene over whatever another program has written.
    pub(super) fn save_over(&mut self, path: PathBuf) {
        self.write(path, None);
    }

    fn write(&mut self, path: PathBuf, seen: Option<Seen>) {
        if self.scenes.saving.is_some() {
            self.scenes.save_again = Some(path);
            return;
        }
        let scene = self.document.scene().clone();
        let request = SaveRequest {
            scene: scene.clone(),
            assets: self.document.assets().clone(),
            base: Some(self.document.file().clone()),
            folder: self.scene_folder(),
            to: path.clone(),
            seen,
        };
        let task = Task::spawn(self.wake.clone(), move || save(&request));
        self.scenes.saving = Some(Saving { task, path, scene });
    }

    /// Saves the scene, then does what waits for that.
    pub(super) fn save_then(&mut self, action: Action) {
        self.scenes.after_save = Some(action);
        self.save();
    }

    /// Looks which files have been read and written.
    pub(super) fn look_after_files(&mut self) {
        self.look_after_opening();
        self.look_after_saving();
        self.look_after_adding();
        if self.scenes.after_save.is_some() && self.scenes.saving.is_none() && !self.chooser.is_open() {
            // The person has thought better of saving.
            self.scenes.after_save = None;
        }
    }

    fn look_after_opening(&mut self) {
        let Some(task) = &mut self.scenes.opening else { return };
        match task.poll() {
            TaskState::Running => return,
            TaskState::Done(Ok(opened)) => {
                if let Some(path) = &opened.path {
                    self.recent.add(path);
                }
                self.keep_recent();
                self.take_opened(opened);
            }
            TaskState::Done(Err(error)) => {
                // The changes are still there, for nothing has come in their place.
                if self.scenes.lets_changes_go {
                    self.document.mark_unsaved();
                }
                self.report(Failure::Scene, &error);
            }
            TaskState::Over => {}
        }
        self.scenes.opening = None;
        self.scenes.lets_changes_go = false;
    }

    /// Lets changes go, for a scene that comes in their place.
    pub(super) fn let_changes_go(&mut self) {
        self.scenes.lets_changes_go = self.document.is_changed();
        self.document.forget_changes();
    }

    /// Shows a scene that has been read.
    pub(super) fn take_opened(&mut self, opened: Opened) {
        let Opened { file, assets, notes, path, seen } = opened;
        self.scenes.seen = seen;
        let document = match path {
            Some(path) => Document::opened(file, assets, notes, path),
            None => Document::untitled(file, assets, PathBuf::new()),
        };
        self.show_document(document);
    }

    /// Puts a document in place of the one that is shown.
    pub(super) fn show_document(&mut self, document: Document) {
        self.document = document;
        self.is_choosing = false;
        self.has_begun = true;
        self.dialog = None;
        self.list = ListState::default();
        self.properties = PropertiesState::default();
        self.forget_autosave();
    }

    fn look_after_saving(&mut self) {
        let Some(saving) = &mut self.scenes.saving else { return };
        let answer = match saving.task.poll() {
            TaskState::Running => return,
            TaskState::Done(answer) => answer,
            TaskState::Over => {
                self.scenes.saving = None;
                return;
            }
        };
        let Some(Saving { path, scene, .. }) = self.scenes.saving.take() else { return };
        let again = self.scenes.save_again.take();
        match answer {
            Ok(saved) => {
                self.scenes.seen = Some(saved.seen.clone());
                self.document.take_saved(path.clone(), saved, &scene);
                self.recent.add(&path);
                self.keep_recent();
                self.forget_autosave();
                if let Some(path) = again {
                    self.save_to(path);
                    return;
                }
                self.notices.success(tr!("app-saved", name = self.document.title().unwrap_or_default()));
                self.actions.extend(self.scenes.after_save.take());
            }
            Err(SaveError::ChangedOnDisc { path }) => {
                let is_unsaved = self.document.is_changed();
                self.dialog = Some(Dialog::Changed(Changed { path, is_unsaved }));
            }
            Err(error) => {
                self.scenes.after_save = None;
                let (message, help) = error.words();
                self.dialog = Some(Dialog::Error(Box::new(ErrorReport::new(Failure::Other, message, help))));
            }
        }
    }

    fn look_after_adding(&mut self) {
        let Some((task, addend)) = &mut self.scenes.adding else { return };
        let addend = *addend;
        let answer = match task.poll() {
            TaskState::Running => return,
            TaskState::Done(answer) => Some(answer),
            TaskState::Over => None,
        };
        self.scenes.adding = None;
        match answer {
            Some(Ok(asset)) => self.take_asset(asset, addend),
            Some(Err(error)) => {
                let failure = if addend.is_model() { Failure::Model } else { Failure::Other };
                self.report(failure, &error);
            }
            None => {}
        }
    }

    fn take_asset(&mut self, asset: NewAsset, addend: Addend) {
        let NewAsset { file, assets, notes } = asset;
        let mesh = assets.meshes.get(Path::new(&file)).cloned();
        self.document.provide(assets, notes.clone());
        match (addend, mesh) {
            (Addend::Model, Some(mesh)) => {
                let model = LoadedModel { path: file.into(), mesh, remarks: notes };
                self.is_choosing = false;
                self.dialog = Some(Dialog::Model(Box::new(ModelDialog::add(model, &self.document))));
            }
            (Addend::PictureForDialog, _) if self.dialog.is_some() => {
                if let Some(dialog) = &mut self.dialog {
                    dialog.take_path(Path::new(&file), &self.document);
                }
            }
            (Addend::ModelForParam | Addend::PictureForParam | Addend::PanoramaForParam, _) => {
                self.set_chosen(&file);
            }
            (Addend::Panorama, _) => self.add_panorama(&file),
            _ => self.lay_over_selection(&file),
        }
    }

    /// Adds the light of a panorama.
    fn add_panorama(&mut self, file: &str) {
        let mut addition = self.new_thing(NewThing { list: ListName::Light, kind: "environment" });
        for light in &mut addition.lights {
            light.source.params_mut().store("file", Value::Text(file.to_owned()));
        }
        self.edit(EditCommand::Add(addition));
    }

    /// Gives a file to the parameter that it was chosen for.
    fn set_chosen(&mut self, file: &str) {
        let Some((thing, key)) = self.scenes.chosen_for.take() else { return };
        let set = |key: String, text: String| EditCommand::Set {
            things: vec![thing.clone()],
            key,
            value: Value::Text(text),
        };
        if thing.list() != Some(ListName::Material) {
            self.edit(set(key, file.to_owned()));
            return;
        }
        // A material names a texture, which names the file.
        let Paint { texture: Some(mut texture), .. } = cover(self.document.scene(), &[], file) else {
            return;
        };
        texture.name = free_name(self.document.scene(), ListName::Texture, &texture.name);
        let selected = self.document.selection().things().to_vec();
        let name = texture.name.clone();
        let add = EditCommand::Add(Addition { textures: vec![texture], ..Addition::default() });
        self.edit(EditCommand::Several(vec![add, set(key, name)]));
        self.document.select(selected);
    }

    /// Lays a picture over the selected objects.
    fn lay_over_selection(&mut self, file: &str) {
        let things: Vec<_> = self.selected_objects();
        if things.is_empty() {
            self.notices.info(tr!("app-picture-for-nothing"));
            return;
        }
        let material = Box::new(cover(self.document.scene(), &things, file));
        self.edit(EditCommand::Paint { things, material });
    }

    pub(super) fn selected_objects(&self) -> Vec<Thing> {
        let is_object = |t: &&Thing| t.list() == Some(ListName::Object);
        self.document.selection().things().iter().filter(is_object).cloned().collect()
    }

    /// Opens the dialog «Model settings» for a model of the scene.
    pub(super) fn show_model_settings(&mut self, thing: &Thing) {
        if let Some(dialog) = ModelDialog::edit(thing, &self.document) {
            self.dialog = Some(Dialog::Model(Box::new(dialog)));
        }
    }

    /// Tells why a file was not opened. What was open stays.
    pub(super) fn report(&mut self, failure: Failure, error: &OpenError) {
        self.dialog = Some(Dialog::Error(Box::new(ErrorReport::of_open(failure, error))));
    }

    fn keep_recent(&mut self) {
        if let Err(error) = self.recent.save(&self.places) {
            self.notices.error(error.to_string());
        }
    }

    /// Makes an edit, or says why not.
    pub(super) fn edit(&mut self, command: EditCommand) {
        if let Err(error) = self.document.apply(command) {
            self.notices.refused(&error);
        }
    }
}

/// Scenes end in `.vitrine.toml`.
fn with_ending(path: PathBuf) -> PathBuf {
    let name = file_name(&path);
    if name.to_lowercase().ends_with(".toml") {
        path
    } else {
        path.with_file_name(format!("{name}.vitrine.toml"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_get_their_ending_unless_they_have_one() {
        let ending = |name: &str| with_ending(PathBuf::from(name)).display().to_string();
        assert_eq!(ending("a/ball"), "a/ball.vitrine.toml");
        assert_eq!(ending("a/ball 1.5"), "a/ball 1.5.vitrine.toml");
        assert_eq!(ending("a/ball.vitrine.toml"), "a/ball.vitrine.toml");
        assert_eq!(ending("a/ball.TOML"), "a/ball.TOML");
    }
}
