//! How the panel asks: a control for a parameter of one or several things, and the edit that follows.

use super::kind_word;
use crate::action::{Action, Actions};
use crate::document::{EditCommand, Gesture, Thing};
use crate::text::{own_specs, param_label, tr};
use crate::theme::{self, icons};
use crate::widgets::{ParamEdit, ParamField, Shown, icon_button, param_ui};
use eframe::egui::{Align, Layout, Rect, Ui, UiBuilder, pos2, vec2};
use vitrine::scene::{ParamSpec, Scene, Value};

/// The scene that is shown, and what is asked for.
pub(super) struct Ask<'a> {
    pub scene: &'a Scene,
    pub actions: &'a mut Actions,
}

impl Ask<'_> {
    /// Asks for an edit that is a step of its own.
    pub fn edit(&mut self, command: EditCommand) {
        self.actions.push(Action::Edit(command));
    }

    /// Asks for an edit that may be a part of a gesture.
    pub fn edit_in(&mut self, command: EditCommand, gesture: Option<Gesture>) {
        self.actions.push(match gesture {
            Some(gesture) => Action::Drag(command, gesture),
            None => Action::Edit(command),
        });
    }

    /// Asks for a new value.
    pub fn set(&mut self, things: &[Thing], key: &str, edit: ParamEdit) {
        let command = EditCommand::Set { things: things.to_vec(), key: key.to_owned(), value: edit.value };
        self.edit_in(command, edit.gesture);
    }

    /// The description of a thing's parameter.
    pub fn spec(&self, thing: &Thing, key: &str) -> Option<&'static ParamSpec> {
        let owner = thing.owner(self.scene)?;
        self.scene.specs(owner).into_iter().find(|s| s.name == key)
    }

    /// The value of a thing's parameter.
    pub fn value(&self, thing: &Thing, key: &str) -> Option<Value> {
        self.scene.value(thing.owner(self.scene)?, key)
    }

    /// The value that things have in common, else the last one's, and whether they differ.
    fn common(&self, things: &[Thing], key: &str) -> Option<(Value, Shown)> {
        let mut values: Vec<Value> = things.iter().filter_map(|t| self.value(t, key)).collect();
        let last = values.pop()?;
        let shown = if values.iter().all(|v| *v == last) { Shown::Stated } else { Shown::Mixed };
        Some((last, shown))
    }

    /// The word under which a parameter's texts are looked up: its kind's for its kind's own, else its list's.
    fn word(&self, thing: &Thing, key: &str) -> &'static str {
        let Some(owner) = thing.owner(self.scene) else { return "object" };
        match thing.list().filter(|list| own_specs(*list).iter().any(|s| s.name == key)) {
            Some(list) => list.key(),
            None => kind_word(self.scene, owner),
        }
    }

    /// The control of a parameter that several things have, or one.
    pub fn param_ui(&mut self, ui: &mut Ui, things: &[Thing], key: &str) {
        self.derived_ui(ui, things, key, None);
    }

    /// The same for one that may follow from others: `derived` is what follows. Where it is stated, a button takes that back.
    pub fn derived_ui(&mut self, ui: &mut Ui, things: &[Thing], key: &str, derived: Option<&Value>) {
        let Some(last) = things.last() else { return };
        let (Some(spec), Some((value, shown))) = (self.spec(last, key), self.common(things, key)) else {
            return;
        };
        let is_stated = value != Value::Nothing;
        let follows = derived.is_some() && !is_stated && shown == Shown::Stated;
        let shown = if follows { Shown::Derived } else { shown };
        let value = if is_stated { value } else { derived.cloned().unwrap_or(value) };
        let field = ParamField { spec, kind_word: self.word(last, key), value: &value, shown };
        let top = ui.cursor().min;
        let sizes = &theme::of(ui).sizes;
        let gutter = if derived.is_some() { sizes.control - sizes.gap_s } else { 0.0 };
        let all = ui.available_width();
        let edit = ui
            .push_id(key, |ui| {
                ui.set_max_width(all - gutter);
                param_ui(ui, field, self.scene)
            })
            .inner;
        if let Some(edit) = edit {
            self.set(things, key, edit);
        }
        if derived.is_some() && is_stated {
            let place = Rect::from_min_size(pos2(top.x + all - gutter, top.y), vec2(gutter, sizes.control));
            let label = param_label(field.kind_word, spec);
            self.reset_ui(ui, place, things, (key, &label));
        }
    }

    fn reset_ui(&mut self, ui: &mut Ui, place: Rect, things: &[Thing], (key, label): (&str, &str)) {
        let layout = Layout::right_to_left(Align::Center);
        let mut child = ui.new_child(UiBuilder::new().id_salt((key, "reset")).max_rect(place).layout(layout));
        child.spacing_mut().button_padding.x = 0.0;
        let name = tr!("properties-reset", name = label);
        if icon_button(&mut child, icons::UNDO, &name, &tr!("properties-reset.tooltip"), "").clicked() {
            let command =
                EditCommand::Set { things: things.to_vec(), key: key.to_owned(), value: Value::Nothing };
            self.edit(command);
        }
    }
}
