//! Too little light, and too much.

use super::{Brightness, Diagnosis};
use crate::document::{Document, EditCommand, Message, Thing, new_thing};
use vitrine::math::Rgb;
use vitrine::scene::{Light, ListName, Scene, Value};

/// All lights together give this much after a mend: a white surface that faces them is white.
const GOOD_SUM: f32 = 1.0;
/// Less than this in all is darkness to the eye.
const DARK_SUM: f32 = 0.05;
/// More than this in all is too much when nobody has looked at the picture.
const GLARING_SUM: f32 = 5.0;

/// What is wrong with the lights.
pub(super) fn diagnose(document: &Document, picture: Option<Brightness>) -> Option<Diagnosis> {
    let scene = document.scene();
    if scene.shines_without_lights() {
        return None;
    }
    if scene.lights.is_empty() {
        let lamp = new_thing(scene, document.assets(), ListName::Light, "disc");
        return Some(Diagnosis {
            message: Message::new("doctor-no-light"),
            things: Vec::new(),
            mend_label: Message::new("doctor-mend-add-lamp"),
            mend: EditCommand::Add(lamp),
        });
    }
    no_light(scene).or_else(|| wrong_sum(scene, picture))
}

fn no_light(scene: &Scene) -> Option<Diagnosis> {
    if scene.lights.iter().any(|l| l.visible && strength(l) > 0.0) {
        return None;
    }
    // Lights that would shine if they were switched on, else all of them.
    let bright: Vec<&Light> = scene.lights.iter().filter(|l| strength(l) > 0.0).collect();
    let lights: Vec<&Light> = if bright.is_empty() { scene.lights.iter().collect() } else { bright };
    let things = things(&lights);
    let mut edits = vec![EditCommand::Show { things: things.clone(), visible: true }];
    edits.extend(
        lights.iter().filter(|l| l.intensity <= 0.0).map(|l| intensity(l, Light::default().intensity)),
    );
    edits.extend(lights.iter().filter(|l| l.color.luminance() <= 0.0).map(|l| EditCommand::Set {
        things: vec![Thing::light(&l.name)],
        key: "color".into(),
        value: Value::Color(Rgb::WHITE),
    }));
    let is_off = lights.iter().all(|l| strength(l) > 0.0);
    let message = if is_off { "doctor-lights-off" } else { "doctor-lights-zero" };
    Some(Diagnosis {
        message: Message::new(message),
        things,
        mend_label: Message::new("doctor-mend-switch-on"),
        mend: EditCommand::Several(edits),
    })
}

fn wrong_sum(scene: &Scene, picture: Option<Brightness>) -> Option<Diagnosis> {
    let shining: Vec<&Light> = scene.lights.iter().filter(|l| l.visible && strength(l) > 0.0).collect();
    let sum: f32 = shining.iter().map(|l| strength(l)).sum();
    let is_white = picture.map_or(sum > GLARING_SUM, |p| p.white > Brightness::MUCH && sum > GOOD_SUM);
    let is_black = sum < DARK_SUM && picture.is_none_or(|p| p.black > Brightness::MUCH);
    let (message, label) = match (is_white, is_black) {
        (true, _) => ("doctor-too-bright", "doctor-mend-dim"),
        (_, true) => ("doctor-too-dark", "doctor-mend-brighten"),
        _ => return None,
    };
    let factor = GOOD_SUM / sum;
    let edits = shining.iter().map(|l| intensity(l, readable(l.intensity * factor))).collect();
    Some(Diagnosis {
        message: Message::new(message),
        things: things(&shining),
        mend_label: Message::new(label),
        mend: EditCommand::Several(edits),
    })
}

/// How much light of any colour comes from it.
fn strength(light: &Light) -> f32 {
    light.intensity * light.color.luminance()
}

fn things(lights: &[&Light]) -> Vec<Thing> {
    lights.iter().map(|l| Thing::light(&l.name)).collect()
}

fn intensity(light: &Light, value: f32) -> EditCommand {
    EditCommand::Set {
        things: vec![Thing::light(&light.name)],
        key: "intensity".into(),
        value: Value::Number(value),
    }
}

/// Rounded to hundredths, unless nothing would be left.
fn readable(v: f32) -> f32 {
    let rounded = (v * 100.0).round() / 100.0;
    if rounded > 0.0 { rounded } else { v }
}
