//! Materials and textures.

use super::ask::Ask;
use super::object::kind_ui;
use super::remark_ui;
use crate::action::Action;
use crate::document::{Addition, EditCommand, Paint, Thing, free_name};
use crate::text::{param_label, param_tooltip, tr};
use crate::widgets::{
    Field, Shown, TextureAnswer, choice_field, link_button, new_gesture, primary_button, subsection,
    texture_chooser,
};
use eframe::egui::Ui;
use vitrine::scene::{ClassicMaterial, ListName, Material, ParamValue as _, Texture, TextureSource, Value};

/// What is shown at first of a material: with the picture on the surface, eight controls.
const FIRST: [&str; 7] =
    ["color", "diffuse", "specular", "shininess", "reflectivity", "transparency", "refraction"];

/// What stands in parts of their own under "More": the key of each part's title, and its parameters.
const PARTS: [(&str, &[&str]); 5] = [
    (
        "properties-inside",
        &[
            "transmission_scatter",
            "transmission_scatter_anisotropy",
            "transmission_dispersion_scale",
            "transmission_dispersion_abbe_number",
        ],
    ),
    ("properties-coat", &["coat_weight", "coat_color", "coat_roughness", "coat_ior"]),
    ("properties-film", &["thin_film_weight", "thin_film_thickness", "thin_film_ior"]),
    ("properties-glow", &["emission_luminance", "emission_color"]),
    (
        "properties-patterns",
        &[
            "base_weight_texture",
            "roughness_texture",
            "metalness_texture",
            "specular_texture",
            "transmission_texture",
            "coat_texture",
            "emission_texture",
            "normal_map",
            "bump_map",
            "bump_height",
        ],
    ),
];

/// A choice of the chooser of materials.
#[derive(Clone, PartialEq)]
enum Choice {
    None,
    Named(String),
    New,
}

/// Which material objects are of, and its parameters.
pub(super) fn material_ui(ui: &mut Ui, ask: &mut Ask<'_>, objects: &[Thing]) {
    let names: Vec<Option<&str>> =
        objects.iter().filter_map(|t| ask.scene.object(t.name()?)).map(|o| o.material.as_deref()).collect();
    let Some(&name) = names.last() else { return };
    let shown = if names.iter().all(|n| *n == name) { Shown::Stated } else { Shown::Mixed };
    chooser_ui(ui, ask, objects, (name, shown));
    let material = name.filter(|_| shown == Shown::Stated).and_then(|n| ask.scene.material(n));
    let Some(material) = material else {
        if shown == Shown::Stated {
            remark_ui(ui, &tr!("properties-no-material"));
        }
        return;
    };
    let users = ask.scene.objects.iter().filter(|o| o.material.as_deref() == name).count();
    if users > objects.len() {
        remark_ui(ui, &tr!("properties-shared", count = users));
        if link_button(ui, &tr!("properties-own-copy"), &tr!("properties-own-copy.tooltip")).clicked() {
            let name = free_name(ask.scene, ListName::Material, &material.name);
            paint(ask, objects, Material { name, ..material.clone() });
        }
    }
    parameters_ui(ui, ask, &material.name);
}

fn chooser_ui(ui: &mut Ui, ask: &mut Ask<'_>, objects: &[Thing], (name, shown): (Option<&str>, Shown)) {
    let mut choices = vec![(Choice::None, tr!("widgets-none"))];
    choices.extend(ask.scene.materials.iter().map(|m| (Choice::Named(m.name.clone()), m.name.clone())));
    choices.push((Choice::New, tr!("properties-new-material")));
    let current = name.map_or(Choice::None, |n| Choice::Named(n.to_owned()));
    let (label, tooltip) = (tr!("properties-made-of"), tr!("properties-made-of.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown };
    let mut chosen = choice_field(ui, &field, Some(&current), &choices);
    if name.is_none() && shown == Shown::Stated {
        let tooltip = tr!("properties-give-material.tooltip");
        if primary_button(ui, &tr!("properties-give-material"), &tooltip).clicked() {
            chosen = Some(Choice::New);
        }
    }
    match chosen {
        Some(Choice::None) => set(ask, objects, Value::Nothing),
        Some(Choice::Named(name)) => set(ask, objects, Value::Text(name)),
        Some(Choice::New) => {
            let name = free_name(ask.scene, ListName::Material, &tr!("properties-new-material-name"));
            paint(ask, objects, Material { name, ..Material::default() });
        }
        None => {}
    }
}

fn set(ask: &mut Ask<'_>, things: &[Thing], value: Value) {
    ask.edit(EditCommand::Set { things: things.to_vec(), key: "material".into(), value });
}

fn paint(ask: &mut Ask<'_>, objects: &[Thing], material: Material) {
    let paint = Paint { material, texture: None };
    ask.edit(EditCommand::Paint { things: objects.to_vec(), material: Box::new(paint) });
}

/// The parameters of a material: the eight that matter most, then the others.
pub(super) fn parameters_ui(ui: &mut Ui, ask: &mut Ask<'_>, name: &str) {
    let Some(material) = ask.scene.material(name) else { return };
    let thing = Thing::material(name);
    let things = [thing.clone()];
    ui.push_id(("material", name), |ui| {
        let [color, rest @ ..] = FIRST;
        ask.derived_ui(ui, &things, color, derived(material, color).as_ref());
        surface_ui(ui, ask, &thing, material);
        rest.into_iter().for_each(|key| ask.derived_ui(ui, &things, key, derived(material, key).as_ref()));
        let is_elsewhere = |key: &str| {
            key == "texture" || FIRST.contains(&key) || PARTS.iter().any(|(_, keys)| keys.contains(&key))
        };
        subsection(ui, &tr!("properties-more"), false, |ui| {
            remark_ui(ui, &tr!("properties-more-remark"));
            for spec in Material::SPECS.iter().filter(|s| !is_elsewhere(s.name)) {
                ask.derived_ui(ui, &things, spec.name, derived(material, spec.name).as_ref());
            }
            for (title, keys) in PARTS {
                subsection(ui, &tr!(title), false, |ui| {
                    for key in keys {
                        ask.derived_ui(ui, &things, key, derived(material, key).as_ref());
                    }
                });
            }
        });
    });
}

/// What a parameter is where the material does not state it.
fn derived(material: &Material, key: &str) -> Option<Value> {
    let classic: ClassicMaterial = material.classic();
    let physical = material.physical();
    Some(match key {
        "color" => classic.color.to_value(),
        "diffuse" => classic.diffuse.to_value(),
        "specular" => classic.specular.to_value(),
        "shininess" => classic.shininess.to_value(),
        "reflectivity" => classic.reflectivity.to_value(),
        "transparency" => classic.transparency.to_value(),
        "refraction" => classic.refraction.to_value(),
        "base_weight" => physical.base_weight.to_value(),
        "base_color" => physical.base_color.to_value(),
        "base_metalness" => physical.base_metalness.to_value(),
        "specular_weight" => physical.specular_weight.to_value(),
        "specular_roughness" => physical.specular_roughness.to_value(),
        "specular_ior" => physical.specular_ior.to_value(),
        "transmission_weight" => physical.transmission_weight.to_value(),
        "transmission_color" => physical.transmission_color.to_value(),
        "transmission_depth" => physical.transmission_depth.to_value(),
        "base_diffuse_roughness" => physical.base_diffuse_roughness.to_value(),
        "specular_color" => physical.specular_color.to_value(),
        "transmission_scatter" => physical.transmission_scatter.to_value(),
        "transmission_scatter_anisotropy" => physical.transmission_scatter_anisotropy.to_value(),
        "transmission_dispersion_scale" => physical.transmission_dispersion_scale.to_value(),
        "transmission_dispersion_abbe_number" => physical.transmission_dispersion_abbe_number.to_value(),
        "coat_weight" => physical.coat_weight.to_value(),
        "coat_color" => physical.coat_color.to_value(),
        "coat_roughness" => physical.coat_roughness.to_value(),
        "coat_ior" => physical.coat_ior.to_value(),
        "thin_film_weight" => physical.thin_film_weight.to_value(),
        "thin_film_thickness" => physical.thin_film_thickness.to_value(),
        "thin_film_ior" => physical.thin_film_ior.to_value(),
        "emission_luminance" => physical.emission_luminance.to_value(),
        "emission_color" => physical.emission_color.to_value(),
        "bump_height" => physical.bump_height.to_value(),
        "geometry_thin_walled" => physical.geometry_thin_walled.unwrap_or(false).to_value(),
        _ => return None,
    })
}

/// The picture or pattern on the surface, and below it that texture's parameters.
fn surface_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing, material: &Material) {
    let Some(spec) = ask.spec(thing, "texture") else { return };
    let (label, tooltip) = (param_label("material", spec), param_tooltip("material", spec));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let current = material.texture.as_deref();
    let key = || "texture".to_owned();
    let to = |value| EditCommand::Set { things: vec![thing.clone()], key: key(), value };
    match texture_chooser(ui, &field, current, ask.scene) {
        Some(TextureAnswer::None) => ask.edit(to(Value::Nothing)),
        Some(TextureAnswer::Texture(name)) => ask.edit(to(Value::Text(name))),
        Some(TextureAnswer::ChooseFile) => {
            ask.actions.push(Action::ChooseFile { thing: thing.clone(), key: key() });
        }
        Some(TextureAnswer::NewPattern) => {
            let name = free_name(ask.scene, ListName::Texture, &tr!("properties-new-pattern-name"));
            let texture = Texture { name: name.clone(), ..Texture::default() };
            let gesture = Some(new_gesture());
            ask.edit_in(
                EditCommand::Add(Addition { textures: vec![texture], ..Addition::default() }),
                gesture,
            );
            ask.edit_in(to(Value::Text(name)), gesture);
        }
        None => {}
    }
    if let Some(name) = current.filter(|n| ask.scene.texture(n).is_some()) {
        subsection(ui, &tr!("properties-pattern"), false, |ui| texture_ui(ui, ask, name));
    }
}

/// The parameters of a texture.
pub(super) fn texture_ui(ui: &mut Ui, ask: &mut Ask<'_>, name: &str) {
    let thing = Thing::texture(name);
    kind_ui(ui, ask, &thing, TextureSource::KINDS);
    let things = [thing];
    ask.param_ui(ui, &things, "repeat");
    ask.param_ui(ui, &things, "shift");
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::ParamKind;

    #[test]
    fn every_part_has_parameters_that_there_are() {
        for key in PARTS.iter().flat_map(|(_, keys)| *keys) {
            assert!(Material::SPECS.iter().any(|s| s.name == *key), "{key}");
        }
    }

    #[test]
    fn every_parameter_of_a_material_but_textures_and_metals_has_a_value_that_follows() {
        let material = Material::default();
        let is_named = |kind| matches!(kind, ParamKind::Reference(_) | ParamKind::Choice(_));
        for spec in Material::SPECS.iter().filter(|s| !is_named(s.kind)) {
            let value = derived(&material, spec.name);
            assert!(value.is_some_and(|v| spec.check(&v).is_ok()), "{}", spec.name);
        }
    }

    #[test]
    fn a_material_shows_at_most_eight_controls_at_first() {
        assert!(FIRST.len() < 8, "with the picture on the surface, eight");
    }
}
