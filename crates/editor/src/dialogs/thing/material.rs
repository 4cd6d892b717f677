//! What a thing in a dialog is made of: a new material, one of the scene's, or none.

use crate::document::{Addition, EditCommand, Paint, Thing, free_name};
use vitrine::math::Rgb;
use vitrine::scene::{
    Item, ListName, Material, Object, ParamSpec, Params, Scene, Texture, TextureSource, Value, params,
};

/// Where the material comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MaterialChoice {
    /// Nothing is stated: a model keeps its own, other things are light grey.
    Unstated,
    /// One that the scene has.
    Named(String),
    /// One made here.
    New,
}

/// A material while it is being chosen and changed.
#[derive(Clone, Debug)]
pub struct MaterialDraft {
    choice: MaterialChoice,
    /// The one made here, or a copy of the scene's with what was changed.
    material: Material,
    /// A texture that comes with it and is not in the scene yet.
    texture: Option<Texture>,
}

/// What a person sees of a material at first.
pub const FIRST_KEYS: [&str; 8] =
    ["color", "texture", "diffuse", "specular", "shininess", "reflectivity", "transparency", "refraction"];

impl MaterialDraft {
    /// What an object is made of; `with` brings materials and textures that the scene does not have yet.
    #[must_use]
    pub fn of(object: &Object, with: &Addition, scene: &Scene) -> Self {
        let mut draft = Self { choice: MaterialChoice::Unstated, material: fresh(), texture: None };
        let Some(name) = &object.material else { return draft };
        if let Some(material) = with.materials.iter().find(|m| m.name == *name) {
            draft.choice = MaterialChoice::New;
            draft.material = material.clone();
            let texture = material.texture.as_ref();
            draft.texture = with.textures.iter().find(|t| Some(&t.name) == texture).cloned();
        } else {
            draft.choose(MaterialChoice::Named(name.clone()), scene);
        }
        draft
    }

    /// A new material in the colour of `fresh` things.
    #[must_use]
    pub fn new() -> Self {
        Self { choice: MaterialChoice::New, material: fresh(), texture: None }
    }

    /// Where it comes from.
    #[must_use]
    pub const fn choice(&self) -> &MaterialChoice {
        &self.choice
    }

    /// Chooses another one. A new one begins like the one that was shown before.
    pub fn choose(&mut self, choice: MaterialChoice, scene: &Scene) {
        if choice == self.choice {
            return;
        }
        match &choice {
            MaterialChoice::Named(name) => {
                self.material = scene.material(name).cloned().unwrap_or_default();
                self.texture = None;
            }
            MaterialChoice::New if self.choice == MaterialChoice::Unstated => {
                self.material = fresh();
                self.texture = None;
            }
            MaterialChoice::New | MaterialChoice::Unstated => {}
        }
        self.choice = choice;
    }

    /// The descriptions of what is shown at first, in order.
    pub fn fields() -> impl Iterator<Item = &'static ParamSpec> {
        FIRST_KEYS.iter().filter_map(|key| Material::SPECS.iter().find(|s| s.name == *key))
    }

    /// The value of a parameter, also where it is derived and not stated.
    #[must_use]
    pub fn value(&self, key: &str) -> Value {
        let classic = self.material.classic();
        let derived = || match key {
            "color" => Value::Color(classic.color),
            "diffuse" => Value::Number(classic.diffuse),
            "specular" => Value::Number(classic.specular),
            "shininess" => Value::Number(classic.shininess),
            "reflectivity" => Value::Number(classic.reflectivity),
            "transparency" => Value::Number(classic.transparency),
            "refraction" => Value::Number(classic.refraction),
            _ => Value::Nothing,
        };
        self.material.get(key).filter(|v| *v != Value::Nothing).unwrap_or_else(derived)
    }

    /// Changes a parameter. False when the value does not fit; then nothing has changed.
    pub fn set(&mut self, key: &str, value: Value) -> bool {
        let is_other_texture = key == "texture";
        let is_set = params::set(&mut self.material, key, value).is_ok();
        if is_set && is_other_texture {
            self.texture = None;
        }
        is_set
    }

    /// Lays a picture over the surface. `file` is its path as the scene writes it.
    pub fn set_picture(&mut self, file: &str, scene: &Scene) {
        let stem = std::path::Path::new(file).file_stem().unwrap_or_default();
        let name = free_name(scene, ListName::Texture, &stem.to_string_lossy());
        let mut texture = Texture { name: name.clone(), ..Texture::default() };
        texture.set_kind("picture");
        if let TextureSource::Picture(picture) = &mut texture.source {
            file.clone_into(&mut picture.file);
        }
        self.material.texture = Some(name);
        self.texture = Some(texture);
    }

    /// Lays a new pattern over the surface.
    pub fn set_pattern(&mut self, scene: &Scene) {
        let wanted = crate::text::kind_name("checker");
        let name = free_name(scene, ListName::Texture, &wanted);
        self.material.texture = Some(name.clone());
        self.texture = Some(Texture { name, ..Texture::default() });
    }

    /// The material.
    #[must_use]
    pub const fn material(&self) -> &Material {
        &self.material
    }

    /// The new texture, if there is one.
    #[must_use]
    pub const fn new_texture(&self) -> Option<&Texture> {
        self.texture.as_ref()
    }

    /// How many other objects of the scene are made of it and change with it.
    #[must_use]
    pub fn others(&self, scene: &Scene, object: Option<&str>) -> usize {
        let MaterialChoice::Named(name) = &self.choice else { return 0 };
        let is_other = |o: &&Object| o.material.as_ref() == Some(name) && Some(o.name.as_str()) != object;
        scene.objects.iter().filter(is_other).count()
    }

    /// Puts it on a new object, with all that has to come along.
    pub(in crate::dialogs) fn put_on(&self, mut object: Object, scene: &Scene) -> Addition {
        let mut addition = Addition::default();
        object.material = match &self.choice {
            MaterialChoice::Unstated => None,
            MaterialChoice::Named(name) => Some(name.clone()),
            MaterialChoice::New => {
                let mut material = self.material.clone();
                material.name = free_name(scene, ListName::Material, &object.name);
                let name = material.name.clone();
                addition.materials.push(material);
                addition.textures.extend(self.texture.clone());
                Some(name)
            }
        };
        addition.objects.push(object);
        addition
    }

    /// Shows it in a scene that is only looked at.
    pub(in crate::dialogs) fn show_in(&self, scene: &mut Scene, object: &mut Object) {
        scene.textures.extend(self.texture.clone());
        object.material = match &self.choice {
            MaterialChoice::Unstated => None,
            MaterialChoice::Named(name) => {
                let shown = scene.materials.iter_mut().find(|m| m.name == *name);
                shown.into_iter().for_each(|m| *m = self.material.clone());
                Some(name.clone())
            }
            MaterialChoice::New => {
                let name = free_name(scene, ListName::Material, &object.name);
                scene.materials.push(Material { name: name.clone(), ..self.material.clone() });
                Some(name)
            }
        };
    }

    /// What makes an object of the scene be made of it.
    #[must_use]
    pub fn commands(&self, object: &Object, scene: &Scene) -> Vec<EditCommand> {
        let thing = Thing::object(&object.name);
        let set = |thing: &Thing, key: &str, value: Value| EditCommand::Set {
            things: vec![thing.clone()],
            key: key.to_owned(),
            value,
        };
        match &self.choice {
            MaterialChoice::Unstated if object.material.is_some() => {
                vec![set(&thing, "material", Value::Nothing)]
            }
            MaterialChoice::Unstated => Vec::new(),
            MaterialChoice::New => {
                let name = free_name(scene, ListName::Material, &object.name);
                let material = Material { name, ..self.material.clone() };
                let paint = Paint { material, texture: self.texture.clone() };
                vec![EditCommand::Paint { things: vec![thing], material: Box::new(paint) }]
            }
            MaterialChoice::Named(name) => {
                let mut commands = Vec::new();
                if let Some(texture) = &self.texture {
                    let textures = vec![texture.clone()];
                    commands.push(EditCommand::Add(Addition { textures, ..Addition::default() }));
                }
                let target = Thing::material(name);
                let before = scene.material(name).cloned().unwrap_or_default();
                for spec in Material::SPECS {
                    let value = self.material.get(spec.name);
                    let changed = value.filter(|v| before.get(spec.name).as_ref() != Some(v));
                    commands.extend(changed.map(|v| set(&target, spec.name, v)));
                }
                if object.material.as_ref() != Some(name) {
                    commands.push(set(&thing, "material", Value::Text(name.clone())));
                }
                commands
            }
        }
    }
}

impl Default for MaterialDraft {
    fn default() -> Self {
        Self::new()
    }
}

/// A matte material with a faint highlight; every scale is stated, so that all of them show a number.
fn fresh() -> Material {
    Material {
        color: Some(Rgb::new(0.6, 0.6, 0.6)),
        diffuse: Some(0.8),
        specular: Some(0.2),
        shininess: Some(32.0),
        reflectivity: Some(0.0),
        transparency: Some(0.0),
        refraction: Some(1.0),
        ..Material::default()
    }
}
