//! The window: it draws the panels, and after each frame carries out what was asked for.

mod carry;
mod chooser;
mod doctor;
mod frame;
mod launch;
mod notices;
mod picture;
mod recovery;
mod scenes;

pub use launch::{LaunchError, WINDOW_SIZE, run, window_builder};

use crate::action::{Action, Actions};
use crate::dialogs::tour::{Tour, TourFacts};
use crate::dialogs::{self, Around, Dialog, tour_ui};
use crate::document::Document;
use crate::files::{
    AUTOSAVE_EVERY, Autosave, Config, Places, Recent, Recovery, Wake, read_template, recoverable,
};
use crate::library::Thumbnails;
use crate::live::Live;
use crate::panels::gallery::GalleryState;
use crate::panels::list::ListState;
use crate::panels::materials::MaterialsState;
use crate::panels::properties::PropertiesState;
use crate::viewport::Viewport;
use crate::{shortcuts, text, theme};
use chooser::Chooser;
use doctor::Doctor;
use eframe::egui::{self, Context, Key, Modifiers, Ui, ViewportCommand};
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
    /// Whether a scene has been begun or opened.
    has_begun: bool,
    live: Live,
    viewport: Viewport,
    list: ListState,
    properties: PropertiesState,
    materials: MaterialsState,
    gallery: GalleryState,
    thumbnails: Thumbnails,
    dialog: Option<Dialog>,
    tour: Option<Tour>,
    /// Whether a final render has been begun.
    has_rendered: bool,
    chooser: Chooser,
    notices: Notices,
    scenes: Scenes,
    picture: PictureSaver,
    doctor: Doctor,
    config: Config,
    recent: Recent,
    /// None where nothing can be written.
    autosave: Option<Autosave>,
    /// Scenes of windows that did not end as they should.
    recoveries: Vec<Recovery>,
    places: Places,
    actions: Actions,
    wake: Wake,
    /// Whether some control had the focus when the last frame ended.
    had_focus: bool,
    /// Whether the person has agreed that the window closes.
    may_close: bool,
}

/// How the window does its work: on threads of its own, or, for tests, at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Pictures and thumbnails come as they are ready.
    Threads,
    /// Each frame waits for its picture, so that a window without edits stands still.
    Immediate,
}

impl Editor {
    /// A window that keeps its files in these places, with a scene if one is given.
    #[must_use]
    pub fn new(ctx: &Context, places: Places, scene: Option<PathBuf>, pace: Pace) -> Self {
        let (config, warning) = Config::load(&places);
        text::set_language(config.language);
        theme::apply(ctx, &config);
        let wake: Wake = {
            let ctx = ctx.clone();
            Arc::new(move || ctx.request_repaint())
        };
        let (live, thumbnails) = match pace {
            Pace::Threads => (Live::new(wake.clone()), Thumbnails::start(wake.clone())),
            Pace::Immediate => (Live::synchronous(), Thumbnails::immediate()),
        };
        let autosave = Autosave::start(&places, AUTOSAVE_EVERY);
        let mut notices = Notices::default();
        if let Some(warning) = warning {
            notices.error(warning.to_string());
        }
        if let Err(error) = &autosave {
            notices.error(crate::tr!("app-no-autosave", reason = error.to_string()));
        }
        Self {
            document: first_document(),
            is_choosing: true,
            has_begun: false,
            live,
            viewport: Viewport::default(),
            list: ListState::default(),
            properties: PropertiesState::default(),
            materials: MaterialsState::default(),
            gallery: GalleryState::default(),
            thumbnails,
            dialog: None,
            tour: None,
            has_rendered: false,
            chooser: Chooser::new(places.documents_folder()),
            notices,
            scenes: Scenes::default(),
            picture: PictureSaver::default(),
            doctor: Doctor::default(),
            recent: Recent::load(&places),
            autosave: autosave.ok(),
            recoveries: recoverable(&places),
            config,
            places,
            actions: scene.map(Action::OpenFile).into_iter().collect(),
            wake,
            had_focus: false,
            may_close: false,
        }
    }

    /// What is being edited.
    #[must_use]
    pub const fn document(&self) -> &Document {
        &self.document
    }

    /// The picture that is shown and the final render.
    #[must_use]
    pub const fn live(&self) -> &Live {
        &self.live
    }

    /// Asks for something, as a panel does; it is carried out with the next frame.
    pub fn ask(&mut self, action: Action) {
        self.actions.push(action);
    }

    /// Draws one frame and carries out what was asked for.
    pub fn frame(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.carry_out(&ctx);
        self.take_dropped_files(&ctx);
        // Keys belong to the chooser while it is open.
        if !self.is_choosing && !self.chooser.is_open() {
            shortcuts::asked_for(&ctx, &self.document, &mut self.actions);
        }
        let is_free = self.is_escape_free(&ctx);
        self.draw(ui);
        if is_free && ctx.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape)) {
            self.actions.push(Action::Select(Vec::new()));
        }
        self.had_focus = ctx.memory(|m| m.focused().is_some());
        self.carry_out(&ctx);
        self.look_after_files();
        self.look_after_pictures();
        self.carry_out(&ctx);
        self.doctor.look(&self.document, self.live.picture().as_ref());
        self.offer_autosave();
        self.answer_closing(&ctx);
    }

    /// Whether Esc has nothing nearer to leave than the selection: no field, menu, dialog or drag.
    fn is_escape_free(&self, ctx: &Context) -> bool {
        let is_above = self.dialog.is_some() || self.chooser.is_open() || egui::Popup::is_any_open(ctx);
        !self.is_choosing && !is_above && !self.had_focus && !self.viewport.is_dragging()
    }

    /// Dialogs, the chooser, the tour and notices, over everything else.
    fn draw_above(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let around = Around {
            document: &self.document,
            config: &self.config,
            problems: &self.doctor.lines,
            samples_per_second: self.samples_per_second(),
            current: self.current_picture(),
        };
        let reply = dialogs::dialogs_ui(&ctx, &mut self.dialog, &around, &mut self.actions);
        if let Some((purpose, path)) = self.chooser.show(&ctx) {
            self.take_chosen(purpose, path);
        }
        let facts = TourFacts {
            document: &self.document,
            is_rendered: self.has_rendered,
            is_saved: self.picture.saved() > 0,
        };
        tour_ui(&ctx, &mut self.tour, &facts, &self.config, &mut self.actions);
        self.notices.show(&ctx);
        if let Some(reply) = reply {
            self.answer(reply);
        }
    }

    fn take_dropped_files(&mut self, ctx: &Context) {
        let dropped =
            ctx.input(|i| i.raw.dropped_files.iter().map(|f| f.path().to_owned()).collect::<Vec<_>>());
        self.actions.extend(dropped.into_iter().map(Action::OpenFile));
    }

    /// A window that is being closed asks first what to do with unsaved changes.
    fn answer_closing(&mut self, ctx: &Context) {
        let is_closing = ctx.input(|i| i.viewport().close_requested());
        if is_closing && !self.may_close && self.document.is_changed() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.actions.push(Action::Quit);
            ctx.request_repaint();
        }
        let title = self.document.title().unwrap_or_else(|| crate::tr!("app-untitled"));
        let title = if self.is_choosing { "Vitrine".to_owned() } else { format!("{title} — Vitrine") };
        let id = egui::Id::new("window title");
        if ctx.data(|d| d.get_temp::<String>(id)) != Some(title.clone()) {
            ctx.data_mut(|d| d.insert_temp(id, title.clone()));
            ctx.send_viewport_cmd(ViewportCommand::Title(title));
        }
    }
}

/// What stands behind the gallery before anything is chosen.
fn first_document() -> Document {
    let opened = read_template("empty").expect("the template is carried in the program and tested");
    Document::untitled(opened.file, opened.assets, PathBuf::new())
}

impl eframe::App for Editor {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.frame(ui);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        if let Some(autosave) = self.autosave.take() {
            autosave.finish();
        }
    }
}
