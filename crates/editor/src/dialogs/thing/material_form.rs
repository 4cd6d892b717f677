//! The part of a dialog that says what a thing is made of.

use super::material::{MaterialChoice, MaterialDraft};
use crate::dialogs::frame;
use crate::text::tr;
use crate::widgets::{Field, ParamField, Shown, TextureAnswer, choice_field, param_ui, texture_chooser};
use eframe::egui::Ui;
use vitrine::scene::{Params, Scene, Value};

/// What a person asks of the form that it cannot do itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::dialogs) enum MaterialAnswer {
    /// Let me choose a picture file.
    ChoosePicture,
}

/// Draws the choice of a material and its first parameters. `unstated` is the key of what stands for no material.
pub(in crate::dialogs) fn material_form(
    ui: &mut Ui,
    draft: &mut MaterialDraft,
    scene: &Scene,
    (object, unstated): (Option<&str>, &str),
) -> Option<MaterialAnswer> {
    let named = scene.materials.iter().map(|m| (MaterialChoice::Named(m.name.clone()), m.name.clone()));
    let mut choices = vec![(MaterialChoice::New, tr!("dialog-add-material-new"))];
    choices.push((MaterialChoice::Unstated, tr!(unstated)));
    choices.extend(named);
    let (label, tooltip) = (tr!("dialog-add-material-choice"), tr!("dialog-add-material-choice.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(choice) = choice_field(ui, &field, Some(draft.choice()), &choices) {
        draft.choose(choice, scene);
    }
    if *draft.choice() == MaterialChoice::Unstated {
        return None;
    }
    let others = draft.others(scene, object);
    if others > 0 {
        frame::hint(ui, &tr!("dialog-add-material-shared", count = others));
    }
    let mut answer = None;
    for spec in MaterialDraft::fields() {
        let value = draft.value(spec.name);
        if spec.name == "texture" {
            answer = answer.or(texture(ui, draft, scene));
            continue;
        }
        let is_stated = draft.material().get(spec.name).is_some_and(|v| v != Value::Nothing);
        let shown = if is_stated { Shown::Stated } else { Shown::Derived };
        let param = ParamField { spec, kind_word: "material", value: &value, shown };
        if let Some(edit) = param_ui(ui, param, scene) {
            draft.set(spec.name, edit.value);
        }
    }
    answer
}

fn texture(ui: &mut Ui, draft: &mut MaterialDraft, scene: &Scene) -> Option<MaterialAnswer> {
    let spec = MaterialDraft::fields().find(|s| s.name == "texture")?;
    let label = crate::text::param_label("material", spec);
    let tooltip = crate::text::param_tooltip("material", spec);
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    // What the scene has, and the new one that is not in it yet.
    let textures = scene.textures.iter().chain(draft.new_texture()).cloned().collect();
    let known = Scene { textures, ..Scene::default() };
    let current = draft.material().texture.clone();
    match texture_chooser(ui, &field, current.as_deref(), &known)? {
        TextureAnswer::None => {
            draft.set("texture", Value::Nothing);
        }
        TextureAnswer::Texture(name) if current.as_ref() == Some(&name) => {}
        TextureAnswer::Texture(name) => {
            draft.set("texture", Value::Text(name));
        }
        TextureAnswer::NewPattern => draft.set_pattern(scene),
        TextureAnswer::ChooseFile => return Some(MaterialAnswer::ChoosePicture),
    }
    None
}
