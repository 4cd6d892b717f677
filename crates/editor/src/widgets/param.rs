//! The control of a parameter, from its description alone.

use super::field::{Edit, Field, Shown};
use super::number::{Number, number_field};
use super::vector::boxes;
use super::{choice_field, color_field, slider_with_value, text_field, toggle, vector_field};
use crate::document::Gesture;
use crate::text::{choice_name, no_choice_name, param_label, param_tooltip};
use crate::tr;
use eframe::egui::Ui;
use vitrine::math::Vec3;
use vitrine::scene::{ParamKind, ParamSpec, Range, Scene, Unit, Value};

/// A parameter to show.
#[derive(Clone, Copy, Debug)]
pub struct ParamField<'a> {
    /// Its description.
    pub spec: &'static ParamSpec,
    /// The word of its kind ("sphere"), of its list ("object"), "camera" or "settings".
    pub kind_word: &'a str,
    /// The value to show; where nothing is stated, the one that follows from the rest, if there is one.
    pub value: &'a Value,
    /// What that value stands for.
    pub shown: Shown,
}

/// What a person has made of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamEdit {
    /// The new value.
    pub value: Value,
    /// The drag or typing that it is a part of; None when it is done in one go.
    pub gesture: Option<Gesture>,
    /// Whether that ends here.
    pub finished: bool,
}

impl From<Edit<Value>> for ParamEdit {
    fn from(edit: Edit<Value>) -> Self {
        Self { value: edit.value, gesture: edit.gesture, finished: edit.finished }
    }
}

/// Draws the control of a parameter. References offer what the scene has.
pub fn param_ui(ui: &mut Ui, param: ParamField<'_>, scene: &Scene) -> Option<ParamEdit> {
    let label = param_label(param.kind_word, param.spec);
    let tooltip = param_tooltip(param.kind_word, param.spec);
    let field = Field { label: &label, tooltip: &tooltip, shown: param.shown };
    let edit = match param.value {
        Value::Flag(on) => flag(ui, &field, *on),
        Value::Integer(v) => integer(ui, &field, param.spec, *v),
        Value::Number(v) => number(ui, &field, param.spec, *v),
        Value::Size(size) => size_row(ui, &field, param.spec, *size),
        Value::Pair(pair) => pair_row(ui, &field, param.spec, *pair),
        Value::Vector(v) => {
            vector_field(ui, &field, &Number::of(param.spec), *v).map(|e| e.map(Value::Vector))
        }
        Value::Color(color) => color_field(ui, &field, *color).map(|e| e.map(Value::Color)),
        Value::Points(points) => points_rows(ui, &field, param.spec, points),
        Value::Pairs(pairs) => pairs_rows(ui, &field, param.spec, pairs),
        Value::Text(text) => words(ui, &field, param.spec, text, scene),
        Value::Nothing => match blank(param.spec.kind) {
            Some(value) => return param_ui(ui, ParamField { value: &value, ..param }, scene),
            None => words(ui, &field, param.spec, "", scene),
        },
    };
    // What the description refuses never leaves the control.
    edit.filter(|e| param.spec.check(&e.value).is_ok()).map(ParamEdit::from)
}

/// What to show of a number that nobody has stated.
fn blank(kind: ParamKind) -> Option<Value> {
    match kind {
        ParamKind::Flag => Some(Value::Flag(false)),
        ParamKind::Integer { min, .. } => Some(Value::Integer(min.max(0))),
        ParamKind::Number(range) => Some(Value::Number(range.min.max(0.0))),
        ParamKind::Vector(_) | ParamKind::Direction => Some(Value::Vector(Vec3::ZERO)),
        ParamKind::Scale => Some(Value::Vector(Vec3::ONE)),
        ParamKind::Color => Some(Value::Color(vitrine::math::Rgb::WHITE)),
        _ => None,
    }
}

fn flag(ui: &mut Ui, field: &Field<'_>, on: bool) -> Option<Edit<Value>> {
    let mut now = on;
    toggle(ui, &mut now, field.label, field.tooltip);
    (now != on).then(|| Edit::at_once(Value::Flag(now)))
}

fn integer(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, v: i64) -> Option<Edit<Value>> {
    let edit = number_field(ui, field, &Number::of(spec), v as f64)?;
    Some(edit.map(|v| Value::Integer(v as i64)))
}

fn number(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, v: f32) -> Option<Edit<Value>> {
    let number = Number::of(spec);
    let edit = match usual(spec) {
        Some(usual) => slider_with_value(ui, field, &number, usual, f64::from(v)),
        None => number_field(ui, field, &number, f64::from(v)),
    };
    Some(edit?.map(|v| Value::Number(v as f32)))
}

/// Where a slider goes from and to; None for numbers that have no usual range.
fn usual(spec: &ParamSpec) -> Option<[f64; 2]> {
    let ParamKind::Number(range) = spec.kind else { return None };
    match spec.name {
        "intensity" => Some([0.0, 2.0]),
        "shininess" => Some([1.0, 1000.0]),
        "refraction" | "specular_ior" => Some([1.0, 2.5]),
        "transmission_dispersion_abbe_number" => Some([15.0, 90.0]),
        "emission_luminance" => Some([0.0, 10.0]),
        "exposure" => Some([-5.0, 5.0]),
        "f_stop" => Some([1.0, 22.0]),
        "view_angle_deg" => Some([10.0, 110.0]),
        _ if range == Range::UNIT => Some([0.0, 1.0]),
        _ if spec.unit == Unit::None && range.max < f32::MAX => {
            Some([f64::from(range.min), f64::from(range.max)])
        }
        _ => None,
    }
}

/// Numbers in rows of two under one label, each with a word of its own.
fn numbers(
    ui: &mut Ui,
    field: &Field<'_>,
    spec: &ParamSpec,
    parts: &[(String, f64)],
) -> Option<Edit<Vec<f64>>> {
    let number = Number::of(spec);
    let words: Vec<&str> = parts.iter().map(|(word, _)| word.as_str()).collect();
    let values: Vec<f64> = parts.iter().map(|(_, value)| *value).collect();
    let (at, edit) = super::field::stacked(ui, field, |ui| boxes(ui, field, &number, (&words, &values)))?;
    let mut all = values;
    Some(edit.map(|v| {
        all[at] = v;
        all
    }))
}

fn size_row(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, [w, h]: [i64; 2]) -> Option<Edit<Value>> {
    let parts = [(tr!("widgets-width"), w as f64), (tr!("widgets-height"), h as f64)];
    let edit = numbers(ui, field, spec, &parts)?;
    Some(edit.map(|v| Value::Size([v[0] as i64, v[1] as i64])))
}

fn pair_row(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, [u, v]: [f32; 2]) -> Option<Edit<Value>> {
    let edit = numbers(ui, field, spec, &[("U".into(), f64::from(u)), ("V".into(), f64::from(v))])?;
    Some(edit.map(|v| Value::Pair([v[0] as f32, v[1] as f32])))
}

fn points_rows(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, points: &[Vec3]) -> Option<Edit<Value>> {
    let number = Number::of(spec);
    let mut edit = None;
    for (i, (point, letter)) in points.iter().zip('A'..).enumerate() {
        let name = format!("{} {letter}", field.label);
        let one = Field { label: &name, ..*field };
        if let Some(e) = vector_field(ui, &one, &number, *point) {
            let mut all = points.to_vec();
            edit = Some(e.map(|p| {
                all[i] = p;
                Value::Points(all)
            }));
        }
    }
    edit
}

fn pairs_rows(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, pairs: &[[f32; 2]]) -> Option<Edit<Value>> {
    let parts: Vec<_> = pairs
        .iter()
        .zip('A'..)
        .flat_map(|(p, letter)| [(format!("{letter} u"), p[0]), (format!("{letter} v"), p[1])])
        .map(|(word, v)| (word, f64::from(v)))
        .collect();
    let edit = numbers(ui, field, spec, &parts)?;
    Some(edit.map(|v| Value::Pairs(v.chunks_exact(2).map(|p| [p[0] as f32, p[1] as f32]).collect())))
}

/// Choices, references, texts and paths.
fn words(ui: &mut Ui, field: &Field<'_>, spec: &ParamSpec, text: &str, scene: &Scene) -> Option<Edit<Value>> {
    let named = |name: &str| (Value::Text(name.to_owned()), name.to_owned());
    let choices: Vec<(Value, String)> = match spec.kind {
        ParamKind::Choice(words) => {
            let none = spec.is_optional().then(|| (Value::Nothing, no_choice_name(spec)));
            let words = words.iter().map(|w| (Value::Text((*w).to_owned()), choice_name(spec, w)));
            none.into_iter().chain(words).collect()
        }
        ParamKind::Reference(list) => std::iter::once((Value::Nothing, tr!("widgets-none")))
            .chain(scene.names(list).map(named))
            .collect(),
        _ => return text_field(ui, field, text).map(|e| e.map(Value::Text)),
    };
    let current = if text.is_empty() { Value::Nothing } else { Value::Text(text.to_owned()) };
    choice_field(ui, field, Some(&current), &choices).map(Edit::at_once)
}
