//! Questions: what to do with unsaved changes, with a recovered scene, with a file that another program has changed.

use super::frame::{self, Buttons, Caption, Shell, Verdict};
use super::{Outcome, Reply};
use crate::action::Action;
use crate::text::tr;
use crate::theme;
use eframe::egui::{
    Align, ColorImage, Context, Image, Layout, TextureHandle, TextureOptions, Ui, Vec2, vec2,
};
use std::fmt;
use std::path::{Path, PathBuf};

/// Changes would be lost.
#[derive(Clone, Debug, PartialEq)]
pub struct Unsaved {
    /// The scene's name; None for one that has no file yet.
    pub name: Option<String>,
    /// What waits for the answer: quitting, opening another scene, …
    pub then: Action,
}

impl Unsaved {
    pub(super) fn show(&self, ctx: &Context) -> Outcome {
        let name = self.name.clone().unwrap_or_else(|| tr!("dialog-unsaved-untitled"));
        let verdict = question(ctx, ["unsaved", "dialog-unsaved-title"], |ui| {
            frame::paragraph(ui, &tr!("dialog-unsaved-text", name = name));
            let other = Some(Caption::of("dialog-unsaved-drop"));
            Buttons { other, ..Buttons::accept("dialog-unsaved-save", true) }
        });
        let then = || Box::new(self.then.clone());
        match verdict {
            Verdict::Open => Outcome::Stay(None),
            Verdict::Accept => Outcome::Close(Some(Reply::SaveThen(then()))),
            Verdict::Other => Outcome::Close(Some(Reply::DropThen(then()))),
            Verdict::Cancel => Outcome::Close(None),
        }
    }
}

/// A scene that was saved by itself before the program ended.
#[derive(Clone)]
pub struct Recovery {
    /// The scene's name.
    pub name: String,
    /// When it was saved, in words that fit into a sentence: "3 minutes ago".
    pub when: String,
    /// Its picture, if there is one.
    pub picture: Option<ColorImage>,
    texture: Option<TextureHandle>,
}

impl fmt::Debug for Recovery {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Recovery").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Recovery {
    /// See the fields.
    #[must_use]
    pub const fn new(name: String, when: String, picture: Option<ColorImage>) -> Self {
        Self { name, when, picture, texture: None }
    }

    pub(super) fn show(&mut self, ctx: &Context) -> Outcome {
        let (name, when) = (self.name.clone(), self.when.clone());
        let verdict = question(ctx, ["recover", "dialog-recover-title"], |ui| {
            let text = tr!("dialog-recover-text", name = name, when = when);
            self.with_picture(ui, &text);
            let other = Some(Caption::of("dialog-recover-drop"));
            Buttons { other, ..Buttons::accept("dialog-recover-ok", true) }
        });
        match verdict {
            Verdict::Open => Outcome::Stay(None),
            Verdict::Accept => Outcome::Close(Some(Reply::Recover)),
            Verdict::Other => Outcome::Close(Some(Reply::ForgetRecovery)),
            Verdict::Cancel => Outcome::Close(None),
        }
    }

    fn with_picture(&mut self, ui: &mut Ui, text: &str) {
        if let Some(picture) = self.picture.take() {
            self.texture = Some(ui.ctx().load_texture("recovered", picture, TextureOptions::LINEAR));
        }
        let Some(texture) = &self.texture else { return frame::paragraph(ui, text) };
        let sizes = &theme::of(ui).sizes;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = sizes.gap_l;
            let image = Image::new(texture).corner_radius(sizes.radius);
            let image = image.max_size(Vec2::splat(sizes.thumbnail * 2.0)).shrink_to_fit();
            ui.add(image.alt_text(tr!("dialog-recover-picture")));
            let room = vec2(ui.available_width(), 0.0);
            ui.allocate_ui_with_layout(room, Layout::top_down(Align::Min), |ui| frame::paragraph(ui, text));
        });
    }
}

/// Another program has changed the open scene's file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Changed {
    /// The file.
    pub path: PathBuf,
    /// Whether there are changes here that are not saved.
    pub is_unsaved: bool,
}

impl Changed {
    pub(super) fn show(&self, ctx: &Context) -> Outcome {
        let name = file_name(&self.path);
        let key = if self.is_unsaved { "dialog-changed-text-unsaved" } else { "dialog-changed-text" };
        let verdict = question(ctx, ["changed", "dialog-changed-title"], |ui| {
            frame::paragraph(ui, &tr!(key, name = name));
            let cancel = Some(Caption::of("dialog-changed-keep"));
            Buttons { cancel, ..Buttons::accept("dialog-changed-reload", true) }
        });
        match verdict {
            Verdict::Open => Outcome::Stay(None),
            Verdict::Accept => Outcome::Close(Some(Reply::Reload(self.path.clone()))),
            Verdict::Other | Verdict::Cancel => Outcome::Close(Some(Reply::KeepMine(self.path.clone()))),
        }
    }
}

fn question(ctx: &Context, [id, title]: [&'static str; 2], body: impl FnOnce(&mut Ui) -> Buttons) -> Verdict {
    let width = theme::of(ctx).sizes.dialog_width;
    frame::show(ctx, Shell { id, title: &tr!(title), width }, body)
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
