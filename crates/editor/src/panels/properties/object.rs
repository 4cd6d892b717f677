//! Objects, lights and groups.

use super::ask::Ask;
use super::{PropertiesState, kind_word, material, remark_ui, title_ui};
use crate::action::Action;
use crate::document::{EditCommand, Thing};
use crate::text::{kind_name_in, param_label, param_tooltip, tr};
use crate::theme::{self, icons};
use crate::widgets::{
    Field, FileAnswer, Number, ParamEdit, Shown, choice_field, file_field, icon_toggle, section, subsection,
    text_button, toggle, vector_field,
};
use eframe::egui::{Align, Layout, Rect, Ui, UiBuilder, pos2, vec2};
use std::slice::from_ref;
use vitrine::math::Vec3;
use vitrine::scene::{KindSpec, LightSource, ListName, Object, ParamKind, Shape, Value};

/// The temperature of light that is about white, kelvin.
const DAYLIGHT: f32 = 6500.0;

/// An object: shape, place, material.
pub(super) fn object_ui(ui: &mut Ui, ask: &mut Ask<'_>, name: &str, state: &mut PropertiesState) {
    let thing = Thing::object(name);
    section(ui, &tr!("properties-shape"), true, |ui| kind_ui(ui, ask, &thing, Shape::KINDS));
    section(ui, &tr!("properties-place"), true, |ui| {
        place_ui(ui, ask, &thing, state);
        ui.horizontal(|ui| {
            if text_button(ui, &tr!("properties-drop"), &tr!("properties-drop.tooltip")).clicked() {
                ask.edit(EditCommand::DropToFloor(vec![thing.clone()]));
            }
            if text_button(ui, &tr!("properties-focus"), &tr!("properties-focus.tooltip")).clicked() {
                ask.actions.push(Action::Frame(vec![thing.clone()]));
            }
        });
    });
    section(ui, &tr!("properties-material"), true, |ui| material::material_ui(ui, ask, from_ref(&thing)));
}

/// A light: kind, brightness, colour, place.
pub(super) fn light_ui(ui: &mut Ui, ask: &mut Ask<'_>, name: &str) {
    let thing = Thing::light(name);
    section(ui, &tr!("properties-light"), true, |ui| {
        ask.param_ui(ui, from_ref(&thing), "intensity");
        ask.param_ui(ui, from_ref(&thing), "color");
        kind_ui(ui, ask, &thing, LightSource::KINDS);
        subsection(ui, &tr!("properties-more"), false, |ui| {
            ask.derived_ui(ui, from_ref(&thing), "temperature", Some(&Value::Number(DAYLIGHT)));
            full_at_ui(ui, ask, &thing);
        });
    });
}

/// From where a lamp is as bright as the classic renderer shows it: by itself, or as far as is stated.
fn full_at_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing) {
    // Only what has a place grows dimmer with the distance.
    let Some(Value::Vector(position)) = ask.value(thing, "position") else { return };
    let is_stated = ask.value(thing, "full_at").is_some_and(|v| v != Value::Nothing);
    let mut now = is_stated;
    toggle(ui, &mut now, &tr!("properties-full-at"), &tr!("properties-full-at.tooltip"));
    if now != is_stated {
        // Where it shines on the scene's middle, to begin with.
        let distance = (position.length() * 10.0).round().max(1.0) / 10.0;
        let value = if now { Value::Number(distance) } else { Value::Nothing };
        ask.edit(EditCommand::Set { things: vec![thing.clone()], key: "full_at".into(), value });
    }
    if is_stated {
        ask.param_ui(ui, from_ref(thing), "full_at");
    }
}

/// A group: place.
pub(super) fn group_ui(ui: &mut Ui, ask: &mut Ask<'_>, name: &str, state: &mut PropertiesState) {
    let thing = Thing::group(name);
    section(ui, &tr!("properties-place"), true, |ui| place_ui(ui, ask, &thing, state));
}

/// Which kind it is, and that kind's parameters.
pub(super) fn kind_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing, kinds: &'static [KindSpec]) {
    let (Some(owner), Some(list)) = (thing.owner(ask.scene), thing.list()) else { return };
    let word = kind_word(ask.scene, owner);
    let (label, tooltip) = (tr!("properties-kind"), tr!("properties-kind.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    // A model, a picture need a file: they are not made by choosing a word.
    let can_become = |kind: &KindSpec| kind.name == word || !kind.specs.iter().any(|s| s.required);
    let choices: Vec<_> =
        kinds.iter().filter(|k| can_become(k)).map(|k| (k.name, kind_name_in(list, k.name))).collect();
    if let Some(kind) = choice_field(ui, &field, Some(&word), &choices).filter(|k| *k != word) {
        ask.edit(EditCommand::SetKind { thing: thing.clone(), kind: kind.to_owned() });
    }
    for spec in kinds.iter().filter(|k| k.name == word).flat_map(|k| k.specs) {
        match spec.kind {
            ParamKind::File => file_ui(ui, ask, thing, spec.name),
            ParamKind::Pairs(_) => {
                subsection(ui, &param_label(word, spec), false, |ui| {
                    ask.param_ui(ui, from_ref(thing), spec.name);
                });
            }
            _ => ask.param_ui(ui, from_ref(thing), spec.name),
        }
    }
    if word == "mesh" && text_button(ui, &tr!("properties-model"), &tr!("properties-model.tooltip")).clicked()
    {
        ask.actions.push(Action::ModelSettings(thing.clone()));
    }
}

fn file_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing, key: &str) {
    let (Some(spec), Some(Value::Text(path))) = (ask.spec(thing, key), ask.value(thing, key)) else { return };
    let word = thing.owner(ask.scene).map_or("object", |owner| kind_word(ask.scene, owner));
    let (label, tooltip) = (param_label(word, spec), param_tooltip(word, spec));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    match file_field(ui, &field, &path) {
        Some(FileAnswer::Path(edit)) => ask.set(from_ref(thing), key, edit.map(Value::Text).into()),
        Some(FileAnswer::Choose) => {
            ask.actions.push(Action::ChooseFile { thing: thing.clone(), key: key.to_owned() });
        }
        None => {}
    }
}

fn place_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing, state: &mut PropertiesState) {
    let things = [thing.clone()];
    ask.param_ui(ui, &things, "position");
    ask.param_ui(ui, &things, "turn_deg");
    size_ui(ui, ask, thing, state);
    if ask.scene.groups.iter().any(|g| Some(g.name.as_str()) != thing.name()) {
        ask.param_ui(ui, &things, "group");
    }
}

/// Factors along x, y and z, with a lock that changes them alike.
fn size_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing, state: &mut PropertiesState) {
    let (Some(spec), Some(Value::Vector(scale))) = (ask.spec(thing, "scale"), ask.value(thing, "scale"))
    else {
        return;
    };
    let sizes = &theme::of(ui).sizes;
    let at = ui.cursor().min + vec2(ui.available_width() - sizes.control, -sizes.gap_s);
    let (label, tooltip) = (param_label("object", spec), param_tooltip("object", spec));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let edit = vector_field(ui, &field, &Number::of(spec), scale);
    if let Some(edit) = edit {
        let value = if state.keep_shape { alike(scale, edit.value) } else { edit.value };
        let edit = ParamEdit { value: Value::Vector(value), gesture: edit.gesture, finished: edit.finished };
        if spec.check(&edit.value).is_ok() {
            ask.set(from_ref(thing), "scale", edit);
        }
    }
    let place = Rect::from_min_size(pos2(at.x, at.y), vec2(sizes.control, sizes.control));
    let layout = Layout::right_to_left(Align::Center);
    let mut child = ui.new_child(UiBuilder::new().id_salt("lock").max_rect(place).layout(layout));
    let icon = if state.keep_shape { icons::LOCK } else { icons::UNLOCK };
    let (name, tooltip) = (tr!("properties-lock"), tr!("properties-lock.tooltip"));
    if icon_toggle(&mut child, icon, state.keep_shape, &name, &tooltip).clicked() {
        state.keep_shape = !state.keep_shape;
    }
}

/// All three factors changed as the one that differs.
fn alike(before: Vec3, after: Vec3) -> Vec3 {
    let changed = (0..3).find(|i| before[*i] != after[*i]);
    changed.map_or(after, |i| {
        let mut all = before * (after[i] / before[i]);
        all[i] = after[i];
        all
    })
}

/// Several things: what they have in common.
pub(super) fn several_ui(ui: &mut Ui, ask: &mut Ask<'_>, things: &[Thing]) {
    ui.horizontal(|ui| title_ui(ui, icons::DUPLICATE, &tr!("properties-several", count = things.len())));
    let in_list =
        |list: ListName| things.iter().filter(|t| t.list() == Some(list)).cloned().collect::<Vec<_>>();
    let (objects, lights) = (in_list(ListName::Object), in_list(ListName::Light));
    let placed: Vec<Thing> = things.iter().filter(|t| ask.value(t, "position").is_some()).cloned().collect();
    if !placed.is_empty() {
        section(ui, &tr!("properties-place"), true, |ui| move_ui(ui, ask, &placed));
    }
    if !lights.is_empty() {
        section(ui, &tr!("properties-light"), true, |ui| {
            ask.param_ui(ui, &lights, "intensity");
            ask.param_ui(ui, &lights, "color");
        });
    }
    if !objects.is_empty() {
        section(ui, &tr!("properties-shape"), true, |ui| common_kind_ui(ui, ask, &objects));
        section(ui, &tr!("properties-material"), true, |ui| material::material_ui(ui, ask, &objects));
    }
}

/// The place of the last one; the others move along.
fn move_ui(ui: &mut Ui, ask: &mut Ask<'_>, things: &[Thing]) {
    let Some(last) = things.last() else { return };
    let (Some(spec), Some(Value::Vector(position))) =
        (ask.spec(last, "position"), ask.value(last, "position"))
    else {
        return;
    };
    let label = param_label("object", spec);
    let tooltip = tr!("properties-move-together");
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(edit) = vector_field(ui, &field, &Number::of(spec), position) {
        let by = edit.value - position;
        ask.edit_in(EditCommand::Move { things: things.to_vec(), by }, edit.gesture);
    }
    remark_ui(ui, &tooltip);
}

/// The parameters of the kind, when all are of one kind.
fn common_kind_ui(ui: &mut Ui, ask: &mut Ask<'_>, objects: &[Thing]) {
    let shapes: Vec<&Object> = objects.iter().filter_map(|t| ask.scene.object(t.name()?)).collect();
    let Some(first) = shapes.first() else { return };
    let word = first.shape.kind();
    if shapes.iter().any(|o| o.shape.kind() != word) {
        remark_ui(ui, &tr!("properties-different"));
        return;
    }
    let specs = Shape::KINDS.iter().filter(|k| k.name == word).flat_map(|k| k.specs);
    for spec in
        specs.filter(|s| !matches!(s.kind, ParamKind::File | ParamKind::Points(_) | ParamKind::Pairs(_)))
    {
        ask.param_ui(ui, objects, spec.name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_locked_size_grows_alike() {
        let before = Vec3::new(1.0, 2.0, 4.0);
        assert_eq!(alike(before, Vec3::new(1.0, 3.0, 4.0)), Vec3::new(1.5, 3.0, 6.0));
        assert_eq!(alike(before, before), before);
    }
}
