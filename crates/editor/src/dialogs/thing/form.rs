//! The dialog «Add» and «Edit».

use super::draft::{Flaw, ThingDraft};
use super::material_form::{MaterialAnswer, material_form};
use crate::action::Actions;
use crate::dialogs::frame::{self, Buttons, Shell, Verdict};
use crate::dialogs::preview::Preview;
use crate::dialogs::{Around, Browse, Outcome, Reply, one_step};
use crate::document::{Addition, Document, Thing};
use crate::text::{kind_name, tr};
use crate::theme;
use crate::widgets::{Field, ParamField, Shown, param_ui, text_field};
use eframe::egui::{Context, Ui, vec2};

/// The dialog «Add» or «Edit».
#[derive(Debug)]
pub struct ThingDialog {
    draft: ThingDraft,
    preview: Preview,
}

impl ThingDialog {
    /// «Add», filled in with what the addition says. None when it adds neither an object nor a light.
    #[must_use]
    pub fn add(addition: &Addition, document: &Document) -> Option<Self> {
        let draft = ThingDraft::add(addition, document.scene())?;
        Some(Self { draft, preview: Preview::default() })
    }

    /// «Edit». None when the thing is neither an object nor a light of the scene.
    #[must_use]
    pub fn edit(thing: &Thing, document: &Document) -> Option<Self> {
        let draft = ThingDraft::edit(thing, document.scene())?;
        Some(Self { draft, preview: Preview::default() })
    }

    /// Lays a picture over the thing. `file` is its path as the scene writes it.
    pub fn take_picture(&mut self, file: &str, document: &Document) {
        if let Some(material) = &mut self.draft.material {
            material.set_picture(file, document.scene());
        }
    }

    pub(in crate::dialogs) fn show(
        &mut self,
        ctx: &Context,
        around: &Around<'_>,
        actions: &mut Actions,
    ) -> Outcome {
        let title = match self.draft.name_before() {
            Some(name) => tr!("dialog-edit-title", name = name),
            None => tr!("dialog-add-title", kind = kind_name(self.draft.subject.kind())),
        };
        let width = theme::of(ctx).sizes.dialog_wide;
        let mut reply = None;
        let verdict = frame::show(ctx, Shell { id: "thing", title: &title, width }, |ui| {
            reply = self.body(ui, around);
            let is_ready = self.draft.flaw(around.document.scene()).is_none();
            let key = if self.draft.is_new() { "dialog-add-ok" } else { "dialog-edit-ok" };
            Buttons::accept(key, is_ready)
        });
        match verdict {
            Verdict::Accept => {
                let thing = self.draft.thing_after();
                one_step(self.draft.commands(around.document.scene()), thing, actions);
                Outcome::Close(None)
            }
            Verdict::Cancel => Outcome::Close(None),
            Verdict::Open | Verdict::Other => Outcome::Stay(reply),
        }
    }

    fn body(&mut self, ui: &mut Ui, around: &Around<'_>) -> Option<Reply> {
        let mut reply = None;
        let Self { draft, preview } = self;
        let document = around.document;
        let shown = draft.shown_in(document.scene());
        let mut picture = |ui: &mut Ui| {
            let width = ui.available_width();
            preview.ui(ui, shown.clone(), document.assets(), vec2(width, (width * 0.62).floor()));
        };
        let scene = document.scene();
        let name = draft.name_before().map(str::to_owned);
        let unstated = match draft.subject.kind() {
            "mesh" => "dialog-add-material-own",
            _ => "dialog-add-material-none",
        };
        frame::columns(ui, |left, right| {
            fields(left, draft, around);
            let Some(material) = &mut draft.material else {
                frame::heading(right, &tr!("dialog-add-preview"));
                return picture(right);
            };
            left.add_space(theme::of(left).sizes.gap_s);
            picture(left);
            frame::heading(right, &tr!("dialog-add-material"));
            let answer = material_form(right, material, scene, (name.as_deref(), unstated));
            if answer == Some(MaterialAnswer::ChoosePicture) {
                reply = Some(Reply::Browse(Browse::Texture));
            }
        });
        reply
    }
}

/// The name and the thing's own parameters.
fn fields(ui: &mut Ui, draft: &mut ThingDraft, around: &Around<'_>) {
    let scene = around.document.scene();
    let (label, tooltip) = (tr!("dialog-add-name"), tr!("dialog-add-name.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(edit) = text_field(ui, &field, draft.subject.name()) {
        *draft.subject.name_mut() = edit.value;
    }
    let flaw = draft.flaw(scene);
    if let Some(flaw @ (Flaw::NoName | Flaw::NameTaken)) = flaw {
        frame::fault(ui, &tr!(flaw.text_key()));
    }
    ui.add_space(theme::of(ui).sizes.gap_xs);
    let kind = draft.subject.kind();
    for spec in draft.fields() {
        let Some(value) = draft.subject.value(spec.name) else { continue };
        let param = ParamField { spec, kind_word: kind, value: &value, shown: Shown::Stated };
        if let Some(edit) = param_ui(ui, param, scene) {
            draft.subject.set(spec.name, edit.value);
        }
    }
    if let Some(flaw @ Flaw::Line) = flaw {
        frame::fault(ui, &tr!(flaw.text_key()));
    }
}
