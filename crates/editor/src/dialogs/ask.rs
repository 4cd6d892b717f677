//! Questions: what to do with unsaved changes, and with a file that another program has changed.

use super::frame::{self, Buttons, Caption, Shell, Verdict};
use super::{Outcome, Reply};
use crate::action::Action;
use crate::files::file_name;
use crate::text::tr;
use crate::theme;
use eframe::egui::{Context, Ui};
use std::path::PathBuf;

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
