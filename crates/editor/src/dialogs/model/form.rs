//! The dialog «Model settings».

use super::draft::{LoadedModel, ModelDraft, Units, Up};
use crate::action::Actions;
use crate::dialogs::frame::{self, Buttons, Shell, Verdict};
use crate::dialogs::preview::Preview;
use crate::dialogs::thing::{MaterialAnswer, material_form};
use crate::dialogs::{Around, Browse, Outcome, Reply, one_step};
use crate::document::{Document, Thing, orbit_center};
use crate::files::file_name;
use crate::text::tr;
use crate::theme;
use crate::widgets::{Field, ParamField, Shown, param_ui, text_field, toggle};
use eframe::egui::{Context, Ui, vec2};
use std::sync::Arc;
use vitrine::math::Vec3;
use vitrine::scene::{Assets, Object, ParamSpec, Value, shapes};

/// The dialog «Model settings».
#[derive(Debug)]
pub struct ModelDialog {
    /// The model as it is now.
    pub draft: ModelDraft,
    preview: Preview,
    /// The model and the pictures that the scene has, for the preview.
    assets: Arc<Assets>,
}

impl ModelDialog {
    /// For a model that has just been read.
    #[must_use]
    pub fn add(model: LoadedModel, document: &Document) -> Self {
        let mut draft = ModelDraft::add(model, document.scene());
        // Where the camera looks; how high it stands follows from the floor.
        let aim = orbit_center(document.scene(), document.assets());
        let tenths = |v: f32| (10.0 * v).round() / 10.0;
        draft.position = Vec3::new(tenths(aim.x), draft.position.y, tenths(aim.z));
        Self::of(draft, document)
    }

    /// For a model of the scene. None when the thing is none, or its file was not read.
    #[must_use]
    pub fn edit(thing: &Thing, document: &Document) -> Option<Self> {
        let object = document.scene().object(thing.name()?)?;
        let file = object.shape.as_kind().file()?;
        let mesh = document.assets().meshes.get(file)?.clone();
        Some(Self::of(ModelDraft::edit(thing, mesh, document.scene())?, document))
    }

    fn of(draft: ModelDraft, document: &Document) -> Self {
        let mut assets = Assets::clone(document.assets());
        assets.meshes.insert(draft.model.path.clone(), draft.model.mesh.clone());
        Self { draft, preview: Preview::default(), assets: Arc::new(assets) }
    }

    /// Lays a picture over the model. `file` is its path as the scene writes it.
    pub fn take_picture(&mut self, file: &str, document: &Document) {
        self.draft.material.set_picture(file, document.scene());
    }

    pub(in crate::dialogs) fn show(
        &mut self,
        ctx: &Context,
        around: &Around<'_>,
        actions: &mut Actions,
    ) -> Outcome {
        let scene = around.document.scene();
        let title = tr!("dialog-model-title");
        let width = theme::of(ctx).sizes.dialog_wide;
        let mut reply = None;
        let verdict = frame::show(ctx, Shell { id: "model", title: &title, width }, |ui| {
            reply = self.body(ui, around);
            let key = if self.draft.is_new() { "dialog-model-ok" } else { "dialog-edit-ok" };
            Buttons::accept(key, self.draft.flaw(scene).is_none())
        });
        match verdict {
            Verdict::Accept => {
                let name = self.draft.name.trim();
                let thing = self.draft.name_before().map(|_| Thing::object(name));
                one_step(self.draft.commands(scene), thing, actions);
                Outcome::Close(None)
            }
            Verdict::Cancel => Outcome::Close(None),
            Verdict::Open | Verdict::Other => Outcome::Stay(reply),
        }
    }

    fn body(&mut self, ui: &mut Ui, around: &Around<'_>) -> Option<Reply> {
        let scene = around.document.scene();
        let mut reply = None;
        let Self { draft, preview, assets } = self;
        let shown = draft.shown(scene);
        let name = draft.name_before().map(str::to_owned);
        frame::columns(ui, |left, right| {
            let width = left.available_width();
            preview.ui(left, shown, assets, vec2(width, (width * 0.6).floor()));
            facts(left, draft);
            remarks(left, &draft.model.remarks);
            meaning(left, draft);
            name_field(right, draft, around);
            place(right, draft, around);
            right.add_space(theme::of(right).sizes.gap_s);
            frame::heading(right, &tr!("dialog-add-material"));
            smooth(right, draft, around);
            let about = (name.as_deref(), "dialog-add-material-own");
            let answer = material_form(right, &mut draft.material, scene, about);
            if answer == Some(MaterialAnswer::ChoosePicture) {
                reply = Some(Reply::Browse(Browse::Texture));
            }
        });
        draft.put_down(scene);
        reply
    }
}

/// How large the model is and what it is made of.
fn facts(ui: &mut Ui, draft: &mut ModelDraft) {
    let size = draft.size();
    let [width, height, depth] = size.to_array().map(length);
    let of = tr!("dialog-model-size-of", width = width, height = height, depth = depth);
    frame::fact(ui, &tr!("dialog-model-size"), &of);
    let count = grouped(draft.model.mesh.triangles.len());
    frame::fact(ui, &tr!("dialog-model-triangles"), &count);
    let file = file_name(&draft.model.path);
    frame::fact(ui, &tr!("dialog-model-file"), &file);
    let longest = size.max_element();
    if longest > 100.0 {
        frame::fault(ui, &tr!("dialog-model-hint-huge"));
    } else if longest < 0.001 {
        frame::fault(ui, &tr!("dialog-model-hint-tiny"));
    }
}

fn remarks(ui: &mut Ui, remarks: &[String]) {
    if remarks.is_empty() {
        return;
    }
    frame::hint(ui, &tr!("dialog-model-warnings", count = remarks.len()));
    let sizes = &theme::of(ui).sizes;
    frame::sunken(ui, |ui| {
        let area = eframe::egui::ScrollArea::vertical().id_salt("remarks").max_height(sizes.control * 3.0);
        area.show(ui, |ui| remarks.iter().for_each(|remark| frame::hint(ui, remark)));
    });
}

/// What the numbers of the file mean.
fn meaning(ui: &mut Ui, draft: &mut ModelDraft) {
    let units = Units::ALL.map(|u| (u, tr!(u.text_key())));
    if let Some(chosen) = frame::choice(ui, "dialog-model-units", &draft.units, &units) {
        draft.units = chosen;
    }
    let ups = Up::ALL.map(|u| (u, tr!(u.text_key())));
    if let Some(chosen) = frame::choice(ui, "dialog-model-up", &draft.up, &ups) {
        draft.up = chosen;
    }
    if draft.can_stand() {
        let (name, tooltip) = (tr!("dialog-model-stand"), tr!("dialog-model-stand.tooltip"));
        toggle(ui, &mut draft.stands, &name, &tooltip);
    }
}

fn name_field(ui: &mut Ui, draft: &mut ModelDraft, around: &Around<'_>) {
    let (label, tooltip) = (tr!("dialog-add-name"), tr!("dialog-add-name.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(edit) = text_field(ui, &field, &draft.name) {
        draft.name = edit.value;
    }
    if let Some(flaw) = draft.flaw(around.document.scene()) {
        frame::fault(ui, &tr!(flaw.text_key()));
    }
}

fn place(ui: &mut Ui, draft: &mut ModelDraft, around: &Around<'_>) {
    let before = draft.position.y;
    vector(ui, around, "position", &mut draft.position);
    if draft.position.y != before {
        // Whoever lifts it does not want it on the floor.
        draft.stands = false;
    }
    vector(ui, around, "turn_deg", &mut draft.turn_deg);
    vector(ui, around, "scale", &mut draft.scale);
}

fn vector(ui: &mut Ui, around: &Around<'_>, key: &str, vector: &mut Vec3) {
    let Some(spec) = spec(Object::SPECS, key) else { return };
    let param = ParamField { spec, kind_word: "mesh", value: &Value::Vector(*vector), shown: Shown::Stated };
    if let Some(Value::Vector(changed)) = param_ui(ui, param, around.document.scene()).map(|e| e.value) {
        *vector = changed;
    }
}

fn smooth(ui: &mut Ui, draft: &mut ModelDraft, around: &Around<'_>) {
    let Some(spec) = spec(shapes::Mesh::SPECS, "smooth") else { return };
    let value = Value::Flag(draft.smooth);
    let param = ParamField { spec, kind_word: "mesh", value: &value, shown: Shown::Stated };
    if let Some(Value::Flag(changed)) = param_ui(ui, param, around.document.scene()).map(|e| e.value) {
        draft.smooth = changed;
    }
}

fn spec(specs: &'static [ParamSpec], key: &str) -> Option<&'static ParamSpec> {
    specs.iter().find(|s| s.name == key)
}

/// A length with three digits that count.
fn length(metres: f32) -> String {
    let decimals = match metres {
        m if m >= 100.0 => 0,
        m if m >= 10.0 => 1,
        m if m >= 1.0 => 2,
        m if m >= 0.01 => 3,
        _ => 5,
    };
    let text = format!("{metres:.decimals$}");
    if crate::text::language() == crate::text::Language::Russian { text.replace('.', ",") } else { text }
}

/// A whole number with thin gaps between its thousands.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push('\u{a0}');
        }
        text.push(digit);
    }
    text
}
