//! Dialogs: at most one is open. Each works on a draft, so that «Cancel» has nothing to take back, and says what was
//! decided as [`Action`]s, or as a [`Reply`] where the window's actions have no word for it.

mod ask;
mod frame;
mod help;
mod model;
mod preview;
mod problems;
mod reply;
mod report;
mod save;
mod settings;
mod thing;
pub mod tour;
mod tour_card;

pub use ask::{Changed, Unsaved};
pub use help::{GlossaryDialog, TERMS, Words, in_all_languages, search_terms};
pub use model::{LoadedModel, ModelDialog, ModelDraft, Units, Up};
pub use preview::Preview;
pub use problems::{Mend, ProblemLine};
pub use reply::{Browse, Reply};
pub use report::{BadLine, ErrorReport, Failure};
pub use save::{
    CurrentPicture, PictureFormat, PictureSource, RENDERERS, SaveDialog, SaveDraft, SaveFlaw,
    SavePictureRequest,
};
pub use settings::SettingsDialog;
pub use thing::{FIRST_KEYS, Flaw, MaterialChoice, MaterialDraft, Subject, ThingDialog, ThingDraft};
pub use tour_card::tour_ui;

use crate::action::{Action, Actions, Screen};
use crate::document::{Document, EditCommand, Thing};
use crate::files::Config;
use crate::widgets::new_gesture;
use eframe::egui::Context;
use std::path::Path;
use vitrine::scene::Renderer;

/// The dialog that is open.
#[derive(Debug)]
pub enum Dialog {
    /// «Add» and «Edit».
    Thing(Box<ThingDialog>),
    /// «Model settings».
    Model(Box<ModelDialog>),
    /// «Save picture».
    SavePicture(Box<SaveDialog>),
    /// «Settings».
    Settings(Box<SettingsDialog>),
    /// What to do with changes that are not saved.
    Unsaved(Box<Unsaved>),
    /// What to do when another program has changed the file.
    Changed(Changed),
    /// Something did not work.
    Error(Box<ErrorReport>),
    /// The list of problems and the picture doctor.
    Problems,
    /// Keys.
    Shortcuts,
    /// Terms in both languages.
    Glossary(GlossaryDialog),
    /// The version and the licences.
    About,
}

/// What dialogs know of the world.
#[derive(Clone, Copy, Debug)]
pub struct Around<'a> {
    /// What is being edited.
    pub document: &'a Document,
    /// The settings of the program.
    pub config: &'a Config,
    /// What is wrong with the scene and with its picture, for the list of problems.
    pub problems: &'a [ProblemLine],
    /// Samples of pixels that a renderer makes in a second, for estimates; None when nobody knows.
    pub samples_per_second: Option<(Renderer, f64)>,
    /// The final render as far as it has come.
    pub current: Option<CurrentPicture>,
}

/// What a dialog does after a frame.
#[derive(Debug)]
enum Outcome {
    /// It stays open, and may ask for something.
    Stay(Option<Reply>),
    /// It closes, and may ask for something.
    Close(Option<Reply>),
}

impl Dialog {
    /// The dialog of a screen; None for the tour, which is none.
    #[must_use]
    pub fn of_screen(screen: Screen, around: &Around<'_>) -> Option<Self> {
        match screen {
            Screen::Settings => Some(Self::Settings(Box::new(SettingsDialog::new(around)))),
            Screen::Problems => Some(Self::Problems),
            Screen::Shortcuts => Some(Self::Shortcuts),
            Screen::Glossary => Some(Self::Glossary(GlossaryDialog::default())),
            Screen::About => Some(Self::About),
            Screen::Tour => None,
        }
    }

    /// Takes a file that was chosen, after a [`Reply::Browse`]. The path of a texture is as the scene writes it.
    pub fn take_path(&mut self, path: &Path, document: &Document) {
        match self {
            Self::Thing(dialog) => dialog.take_picture(&path.to_string_lossy(), document),
            Self::Model(dialog) => dialog.take_picture(&path.to_string_lossy(), document),
            Self::SavePicture(dialog) => dialog.draft.set_path(path),
            _ => {}
        }
    }
}

/// Draws the open dialog, if there is one, and closes it when the person is done. Edits go to `actions`; the answer is what
/// else it asks for.
pub fn dialogs_ui(
    ctx: &Context,
    open: &mut Option<Dialog>,
    around: &Around<'_>,
    actions: &mut Actions,
) -> Option<Reply> {
    let outcome = match open.as_mut()? {
        Dialog::Thing(dialog) => dialog.show(ctx, around, actions),
        Dialog::Model(dialog) => dialog.show(ctx, around, actions),
        Dialog::SavePicture(dialog) => dialog.show(ctx, around),
        Dialog::Settings(dialog) => dialog.show(ctx, around, actions),
        Dialog::Unsaved(dialog) => dialog.show(ctx),
        Dialog::Changed(dialog) => dialog.show(ctx),
        Dialog::Error(dialog) => dialog.show(ctx),
        Dialog::Problems => problems::show(ctx, around, actions),
        Dialog::Shortcuts => help::shortcuts(ctx),
        Dialog::Glossary(dialog) => dialog.show(ctx),
        Dialog::About => help::about(ctx),
    };
    match outcome {
        Outcome::Stay(reply) => reply,
        Outcome::Close(reply) => {
            *open = None;
            reply
        }
    }
}

/// Asks for all commands as one step of the history. `thing` stays selected, whatever came along with it.
fn one_step(commands: Vec<EditCommand>, thing: Option<Thing>, actions: &mut Actions) {
    let adds = commands.iter().any(|c| matches!(c, EditCommand::Add(_)));
    if commands.len() == 1 {
        actions.extend(commands.into_iter().map(Action::Edit));
    } else {
        let gesture = new_gesture();
        actions.extend(commands.into_iter().map(|command| Action::Drag(command, gesture)));
    }
    if let Some(thing) = thing.filter(|_| adds) {
        actions.push(Action::Select(vec![thing]));
    }
}
