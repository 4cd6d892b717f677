//! What a person asks for. Panels, menus and keys only say it; the window carries it out after the frame is drawn.

use crate::document::{EditCommand, Gesture, Thing};
use crate::files::Config;
use crate::text::kind_name_in;
use crate::theme::icons;
use std::path::PathBuf;
use vitrine::scene::ListName;

/// Something that a person asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Change the scene: one step of the history.
    Edit(EditCommand),
    /// Change the scene as a part of a gesture: one step together with the rest of it.
    Drag(EditCommand, Gesture),
    /// Select these things and no others.
    Select(Vec<Thing>),
    /// Add to the selection, or take away.
    ToggleSelect(Thing),
    /// Select every object and light.
    SelectAll,
    /// Take the last step back.
    Undo,
    /// Do the last undone step again.
    Redo,
    /// Copy what is selected and delete it.
    Cut,
    /// Copy what is selected, as the text of a scene file.
    Copy,
    /// Add what the clipboard holds.
    Paste,
    /// Bring these things to the middle of the picture; everything when there are none.
    Frame(Vec<Thing>),
    /// Show the gallery of templates.
    New,
    /// Begin with a template.
    NewFrom(String),
    /// Choose a scene to open.
    Open,
    /// Open this scene, or add this model or picture.
    OpenFile(PathBuf),
    /// Save the scene.
    Save,
    /// Save the scene under another name.
    SaveAs,
    /// Choose how to save the picture.
    SavePicture,
    /// End the program.
    Quit,
    /// Add a thing with good defaults, where the camera looks.
    AddQuick(NewThing),
    /// Open the dialog that adds a thing.
    AddDialog(NewThing),
    /// Open the dialog with all properties of a thing.
    EditDialog(Thing),
    /// Choose a model to add.
    LoadModel,
    /// Choose a panorama whose light is to be added.
    LoadPanorama,
    /// Open the dialog «Model settings» for an object that is a model.
    ModelSettings(Thing),
    /// Choose a file for a parameter: a picture for a texture or for a material's surface, another model for an object,
    /// another panorama for a light.
    ChooseFile {
        /// Whose parameter.
        thing: Thing,
        /// Which.
        key: String,
    },
    /// Render at full size and quality.
    StartRender,
    /// Stop that; the picture so far stays.
    StopRender,
    /// Go on where it stopped.
    ContinueRender,
    /// Open a window.
    Show(Screen),
    /// Change the settings of the program.
    Configure(Box<Config>),
}

/// A kind of thing to add.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NewThing {
    /// Objects or lights.
    pub list: ListName,
    /// The word of the kind: "sphere", "disc".
    pub kind: &'static str,
}

impl NewThing {
    /// Its name in the current language.
    #[must_use]
    pub fn name(self) -> String {
        kind_name_in(self.list, self.kind)
    }

    /// Its icon.
    #[must_use]
    pub fn icon(self) -> &'static str {
        icons::of_item(self.list, self.kind)
    }

    /// What adds it: choosing a file if it comes from one, else what `make` says.
    #[must_use]
    pub fn action(self, make: fn(Self) -> Action) -> Action {
        match (self.list, self.kind) {
            (ListName::Object, "mesh") => Action::LoadModel,
            (ListName::Light, "environment") => Action::LoadPanorama,
            _ => make(self),
        }
    }
}

/// A window inside the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Screen {
    /// The settings of the program.
    Settings,
    /// Warnings, with mends.
    Problems,
    /// "First picture in 60 seconds".
    Tour,
    /// Keys.
    Shortcuts,
    /// Terms in both languages.
    Glossary,
    /// The version and the licences.
    About,
}

/// What has been asked for while a frame was drawn, in order.
pub type Actions = Vec<Action>;
