//! Carrying out what was asked for.

use super::Editor;
use super::chooser::Purpose;
use crate::action::{Action, NewThing, Screen};
use crate::dialogs::tour::Tour;
use crate::dialogs::{Around, Browse, CurrentPicture, Dialog, Reply, ThingDialog};
use crate::document::{
    Addition, CameraMove, EditCommand, Thing, bounds_of, bounds_of_all, copy, free_name, new_thing,
};
use crate::files::{Config, file_name};
use crate::live::{FinalState, Request};
use crate::text::{self, tr};
use crate::theme;
use eframe::egui::{Context, Event, ViewportCommand};
use std::path::Path;
use vitrine::scene::ListName;

impl Editor {
    /// Carries out everything that was asked for, in order; what follows from that, too.
    pub(super) fn carry_out(&mut self, ctx: &Context) {
        for _ in 0..4 {
            for action in std::mem::take(&mut self.actions) {
                self.carry(ctx, action);
            }
        }
    }

    fn carry(&mut self, ctx: &Context, action: Action) {
        match action {
            Action::Edit(command) => self.edit(command),
            Action::Drag(command, gesture) => {
                if let Err(error) = self.document.drag(command, gesture) {
                    self.notices.refused(&error);
                }
            }
            Action::Undo => drop(self.document.undo()),
            Action::Redo => drop(self.document.redo()),
            Action::Select(_) | Action::ToggleSelect(_) | Action::SelectAll => self.select(action),
            Action::Cut | Action::Copy | Action::Paste => self.use_clipboard(ctx, &action),
            Action::Frame(things) => self.bring_to_middle(&things),
            Action::AddQuick(new) => {
                let addition = self.new_thing(new);
                self.edit(EditCommand::Add(addition));
            }
            Action::AddDialog(_)
            | Action::EditDialog(_)
            | Action::ModelSettings(_)
            | Action::LoadModel
            | Action::LoadPanorama
            | Action::ChooseFile { .. }
            | Action::Show(_) => self.open_dialog(action),
            Action::StartRender | Action::StopRender | Action::ContinueRender => self.render(&action),
            Action::Configure(config) => self.configure(ctx, *config),
            file => self.carry_file(ctx, file),
        }
    }

    fn carry_file(&mut self, ctx: &Context, action: Action) {
        match action {
            Action::New => self.is_choosing = true,
            Action::NewFrom(name) => {
                self.unless_unsaved(Action::NewFrom(name.clone()), |editor| editor.begin_with(&name));
            }
            Action::Open => {
                let folder = self.document.path().and_then(Path::parent).map(Path::to_owned);
                self.chooser.open(Purpose::OpenScene, folder.as_deref(), "");
            }
            Action::OpenFile(path) if is_scene(&path) => {
                self.unless_unsaved(Action::OpenFile(path.clone()), |editor| editor.open_file(path));
            }
            Action::OpenFile(path) => self.open_file(path),
            Action::Save => self.save(),
            Action::SaveAs => self.ask_where_to_save(),
            Action::SavePicture => self.ask_how_to_save_picture(),
            Action::Quit => self.unless_unsaved(Action::Quit, |editor| {
                editor.may_close = true;
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }),
            _ => {}
        }
    }

    fn select(&mut self, action: Action) {
        let scene = self.document.scene();
        let things = match action {
            Action::Select(things) => things,
            Action::ToggleSelect(thing) => {
                let mut selection = self.document.selection().clone();
                selection.toggle(thing);
                selection.things().to_vec()
            }
            _ => {
                let all = |list: ListName| {
                    scene.names(list).map(move |name| Thing::Item(list, name.to_owned())).collect::<Vec<_>>()
                };
                [all(ListName::Light), all(ListName::Object)].concat()
            }
        };
        self.document.select(things);
    }

    fn use_clipboard(&mut self, ctx: &Context, action: &Action) {
        if *action == Action::Paste {
            let pasted = ctx.input(|i| {
                i.events
                    .iter()
                    .find_map(|e| if let Event::Paste(text) = e { Some(text.clone()) } else { None })
            });
            match pasted {
                Some(text) => self.edit(EditCommand::Paste(text)),
                // It comes as an event of one of the next frames.
                None => ctx.send_viewport_cmd(ViewportCommand::RequestPaste),
            }
            return;
        }
        let things = self.document.selection().things().to_vec();
        let text = copy(self.document.scene(), &things);
        if text.is_empty() {
            return;
        }
        ctx.copy_text(text);
        if *action == Action::Cut {
            self.edit(EditCommand::Delete(things));
        }
    }

    /// Brings things to the middle of the picture; all of them when none are named.
    fn bring_to_middle(&mut self, things: &[Thing]) {
        let (scene, assets) = (self.document.scene(), self.document.assets());
        let bounds = match things {
            [] => bounds_of_all(scene, assets),
            things => bounds_of(scene, assets, things),
        };
        if bounds.is_empty() {
            self.notices.info(tr!("app-nothing-to-frame"));
            return;
        }
        let radius = (0.5 * bounds.size().length()).max(1e-3);
        self.edit(EditCommand::Camera(CameraMove::Frame { center: bounds.center(), radius }));
    }

    /// A new thing with good defaults, where the camera looks, named in the person's language.
    pub(super) fn new_thing(&self, new: NewThing) -> Addition {
        let (scene, assets) = (self.document.scene(), self.document.assets());
        let name = free_name(scene, new.list, &new.name());
        new_thing(scene, assets, new.list, new.kind).named(&name)
    }

    fn open_dialog(&mut self, action: Action) {
        match action {
            Action::AddDialog(new) => {
                let addition = self.new_thing(new);
                self.dialog = ThingDialog::add(&addition, &self.document).map(|d| Dialog::Thing(Box::new(d)));
            }
            Action::EditDialog(thing) if self.document.is_model(&thing) => self.show_model_settings(&thing),
            Action::EditDialog(thing) => {
                self.dialog = ThingDialog::edit(&thing, &self.document).map(|d| Dialog::Thing(Box::new(d)));
            }
            Action::ModelSettings(thing) => self.show_model_settings(&thing),
            Action::LoadModel => {
                let folder = self.scene_folder();
                self.chooser.open(Purpose::LoadModel, folder.as_deref(), "");
            }
            Action::LoadPanorama => {
                let folder = self.scene_folder();
                self.chooser.open(Purpose::LoadPanorama, folder.as_deref(), "");
            }
            Action::ChooseFile { thing, key } => {
                let folder = self.scene_folder();
                let purpose = match thing.list() {
                    Some(ListName::Light) => Purpose::ReplacePanorama,
                    _ if self.document.is_model(&thing) => Purpose::ReplaceModel,
                    _ => Purpose::ReplaceTexture,
                };
                self.chooser.open(purpose, folder.as_deref(), "");
                self.scenes.choose_for(thing, key);
            }
            Action::Show(Screen::Tour) => {
                if self.is_choosing {
                    self.begin_with("empty");
                }
                self.tour = Some(Tour::begin(&self.document));
            }
            Action::Show(screen) => {
                let around = Around {
                    document: &self.document,
                    config: &self.config,
                    problems: &self.doctor.lines,
                    samples_per_second: None,
                    current: None,
                };
                self.dialog = Dialog::of_screen(screen, &around);
            }
            _ => {}
        }
    }

    fn render(&mut self, action: &Action) {
        match action {
            Action::StartRender => {
                self.forget_waiting_picture();
                let request = self.final_request();
                self.has_rendered = true;
                self.live.start_final(request);
            }
            Action::StopRender => {
                self.live.stop_final();
                self.forget_waiting_picture();
            }
            Action::ContinueRender => self.live.continue_final(),
            _ => {}
        }
    }

    /// What is asked of the final render of the scene as it is.
    pub(super) fn final_request(&self) -> Request {
        self.viewport.final_request(&self.document)
    }

    /// Takes other settings of the program: at once, and for the next start.
    pub(super) fn configure(&mut self, ctx: &Context, config: Config) {
        text::set_language(config.language);
        self.config = config;
        theme::apply(ctx, &self.config);
        if let Err(error) = self.config.save(&self.places) {
            self.notices.error(error.to_string());
        }
    }

    /// The final render as far as it has come, if it is the scene's own.
    pub(super) fn current_picture(&self) -> Option<CurrentPicture> {
        if self.live.final_state() == FinalState::Idle {
            return None;
        }
        let image = self.live.final_image()?;
        let size = [image.film.region().width, image.film.region().height];
        let samples = image.film.samples() / (u64::from(size[0]) * u64::from(size[1])).max(1);
        (samples > 0).then_some(CurrentPicture { size, samples: samples as u32 })
    }

    /// Does what a dialog asks for.
    pub(super) fn answer(&mut self, reply: Reply) {
        match reply {
            Reply::SavePicture(request) => self.save_picture(*request),
            Reply::Browse(Browse::Texture) => {
                let folder = self.scene_folder();
                self.chooser.open(Purpose::LoadTexture, folder.as_deref(), "");
            }
            Reply::Browse(Browse::SavePicture(path)) => {
                let name = file_name(&path);
                self.chooser.open(Purpose::SavePicture, path.parent(), &name);
            }
            Reply::SaveThen(action) => self.save_then(*action),
            Reply::DropThen(action) => {
                self.let_changes_go();
                self.actions.push(*action);
            }
            Reply::Reload(path) => {
                self.let_changes_go();
                self.open_file(path);
            }
            Reply::KeepMine(path) => self.save_over(path),
            Reply::BeginTour => self.actions.push(Action::Show(Screen::Tour)),
        }
    }
}

fn is_scene(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    !matches!(extension.as_str(), "obj" | "png" | "jpg" | "jpeg")
}
