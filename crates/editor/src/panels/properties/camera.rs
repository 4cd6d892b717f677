//! The camera: where it stands, how it is aimed, and turning it by an angle about an axis (C13).

use super::ask::Ask;
use super::{PropertiesState, title_ui};
use crate::action::Action;
use crate::document::{CameraMove, EditCommand, Thing};
use crate::text::{kind_name, tr};
use crate::theme::{self, icons};
use crate::widgets::{
    Field, Number, Shown, choice_field, describe, number_field, section, text_button, toggle,
};
use eframe::egui::{Align, Button, Layout, RichText, Ui, vec2};
use vitrine::math::{Axis, Vec3};
use vitrine::scene::{Camera, Range, Scene, Value};

/// An aperture that blurs what is out of focus so that one sees it.
const USUAL_APERTURE: f32 = 2.8;

/// Ways of aiming.
#[derive(Clone, Copy, PartialEq)]
enum Aim {
    At,
    Turned,
}

/// The camera's part of the panel.
pub(super) fn camera_ui(ui: &mut Ui, ask: &mut Ask<'_>, state: &mut PropertiesState) {
    let things = [Thing::Camera];
    ui.horizontal(|ui| title_ui(ui, icons::CAMERA, &kind_name("camera")));
    section(ui, &tr!("properties-place"), true, |ui| {
        ask.param_ui(ui, &things, "position");
        aim_ui(ui, ask);
        ask.param_ui(ui, &things, "view_angle_deg");
    });
    section(ui, &tr!("properties-lens"), false, |ui| lens_ui(ui, ask));
    section(ui, &tr!("properties-turn-by"), true, |ui| turn_ui(ui, ask, state));
    section(ui, &tr!("properties-look"), true, |ui| look_ui(ui, ask));
}

/// Whether what is out of focus is blurred, and how.
fn lens_ui(ui: &mut Ui, ask: &mut Ask<'_>) {
    let things = [Thing::Camera];
    let camera = &ask.scene.camera;
    let (is_blurred, focus) = (camera.f_stop.is_some(), camera.focus());
    let mut now = is_blurred;
    toggle(ui, &mut now, &tr!("properties-blur"), &tr!("properties-blur.tooltip"));
    if now != is_blurred {
        let value = if now { Value::Number(USUAL_APERTURE) } else { Value::Nothing };
        ask.edit(EditCommand::Set { things: things.to_vec(), key: "f_stop".into(), value });
    }
    if is_blurred {
        ask.param_ui(ui, &things, "f_stop");
        ask.derived_ui(ui, &things, "focus_distance", Some(&Value::Number(focus)));
        ask.param_ui(ui, &things, "blades");
    }
}

/// Either a point to look at or a turn.
fn aim_ui(ui: &mut Ui, ask: &mut Ask<'_>) {
    let camera = &ask.scene.camera;
    let aim = if camera.look_at.is_some() { Aim::At } else { Aim::Turned };
    let (label, tooltip) = (tr!("properties-aim"), tr!("properties-aim.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let choices = [(Aim::At, tr!("properties-aim-point")), (Aim::Turned, tr!("properties-aim-turn"))];
    let chosen = choice_field(ui, &field, Some(&aim), &choices).filter(|chosen| *chosen != aim);
    if let Some(chosen) = chosen {
        let (key, value) = match chosen {
            Aim::At => ("look_at", Value::Vector(point_ahead(camera))),
            Aim::Turned => ("turn_deg", Value::Vector(turn_of(camera))),
        };
        ask.edit(EditCommand::Set { things: vec![Thing::Camera], key: key.into(), value });
    }
    ask.param_ui(ui, &[Thing::Camera], if aim == Aim::At { "look_at" } else { "turn_deg" });
}

/// A point in the middle of the picture, as far away as the origin is.
fn point_ahead(camera: &Camera) -> Vec3 {
    let distance = camera.position.length().max(1.0);
    camera.position + camera.rotation() * Vec3::NEG_Z * distance
}

/// The turn that shows what the camera shows now.
fn turn_of(camera: &Camera) -> Vec3 {
    let mut turned = camera.clone();
    turned.turn(Axis::X, 0.0);
    turned.turn_deg.unwrap_or_default()
}

/// C13: by a given angle about a given axis.
fn turn_ui(ui: &mut Ui, ask: &mut Ask<'_>, state: &mut PropertiesState) {
    let (label, tooltip) = (tr!("properties-angle"), tr!("properties-angle.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let unit = tr!("unit-degrees");
    let number = Number { range: Range::ANY, whole: false, decimals: 2, step: 0.5, unit };
    if let Some(edit) = number_field(ui, &field, &number, f64::from(state.turn_angle_deg)) {
        state.turn_angle_deg = edit.value as f32;
    }
    ui.horizontal(|ui| {
        let sizes = &theme::of(ui).sizes;
        ui.spacing_mut().item_spacing.x = sizes.gap_s;
        for (i, (axis, letter)) in [(Axis::X, "X"), (Axis::Y, "Y"), (Axis::Z, "Z")].into_iter().enumerate() {
            let text = RichText::new(letter).color(theme::of(ui).axis(i));
            let button = Button::selectable(state.turn_axis == axis, text)
                .min_size(vec2(sizes.control, sizes.control));
            let name = tr!("properties-axis", axis = letter);
            if describe(ui.add(button), &name, &tr!("properties-axis.tooltip", axis = letter)).clicked() {
                state.turn_axis = axis;
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if text_button(ui, &tr!("properties-turn"), &tr!("properties-turn.tooltip")).clicked() {
                let (axis, angle_deg) = (state.turn_axis, state.turn_angle_deg);
                ask.edit(EditCommand::Camera(CameraMove::Turn { axis, angle_deg }));
            }
        });
    });
}

/// Bringing things into the picture.
fn look_ui(ui: &mut Ui, ask: &mut Ask<'_>) {
    let (label, tooltip) = (tr!("properties-look-at"), tr!("properties-look-at.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let choices: Vec<_> = ask.scene.objects.iter().map(|o| (o.name.clone(), o.name.clone())).collect();
    if let Some(name) = choice_field(ui, &field, None, &choices)
        && let Some(point) = middle_of(ask.scene, &name)
    {
        ask.edit(EditCommand::Camera(CameraMove::LookAt(point)));
    }
    if text_button(ui, &tr!("properties-frame-all"), &tr!("properties-frame-all.tooltip")).clicked() {
        ask.actions.push(Action::Frame(Vec::new()));
    }
}

/// Where an object's centre lies in the world.
fn middle_of(scene: &Scene, name: &str) -> Option<Vec3> {
    let places = scene.group_places();
    Some(places.world_from_object(scene.object(name)?).world_from_object.transform_point3(Vec3::ZERO))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changing_the_way_of_aiming_shows_the_same() {
        let camera = Camera { look_at: Some(Vec3::new(1.0, 0.5, -2.0)), ..Camera::default() };
        let forward = |c: &Camera| c.rotation() * Vec3::NEG_Z;
        let turned = Camera { look_at: None, turn_deg: Some(turn_of(&camera)), ..camera.clone() };
        assert!((forward(&turned) - forward(&camera)).length() < 1e-5);
        let aimed = Camera { look_at: Some(point_ahead(&turned)), turn_deg: None, ..turned };
        assert!((forward(&aimed) - forward(&camera)).length() < 1e-5);
    }
}
