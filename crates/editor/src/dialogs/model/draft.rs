//! A model from a file until it is accepted: what its numbers mean, which way is up, where it stands.
//!
//! A scene knows none of this: units become a scale, the axis that points up becomes a turn about X, which comes first of
//! the three turns. So both can be read off an object again, and the dialog serves before and after loading.

use crate::dialogs::thing::{Flaw, MaterialDraft, Subject, replace};
use crate::document::{Addition, EditCommand, Thing};
use std::path::PathBuf;
use std::sync::Arc;
use vitrine::math::{Bounds3, Rgb, Transform, Vec3};
use vitrine::scene::{
    Camera, Light, LightSource, Object, Params, Scene, Shape, TriangleMesh, Value, lights, shapes,
};

/// What the numbers in a model's file mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Metres.
    Metre,
    /// Centimetres.
    Centimetre,
    /// Millimetres.
    Millimetre,
    /// Inches.
    Inch,
}

impl Units {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Metre, Self::Centimetre, Self::Millimetre, Self::Inch];

    /// How many metres one is.
    #[must_use]
    pub const fn metres(self) -> f32 {
        match self {
            Self::Metre => 1.0,
            Self::Centimetre => 0.01,
            Self::Millimetre => 0.001,
            Self::Inch => 0.0254,
        }
    }

    /// The key of its text.
    #[must_use]
    pub const fn text_key(self) -> &'static str {
        match self {
            Self::Metre => "dialog-model-unit-metre",
            Self::Centimetre => "dialog-model-unit-centimetre",
            Self::Millimetre => "dialog-model-unit-millimetre",
            Self::Inch => "dialog-model-unit-inch",
        }
    }
}

/// Which axis of a model's file points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// Y, as in the scene.
    Y,
    /// Z, as in many programs for construction.
    Z,
}

impl Up {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Y, Self::Z];

    /// The key of its text.
    #[must_use]
    pub const fn text_key(self) -> &'static str {
        match self {
            Self::Y => "dialog-model-up-y",
            Self::Z => "dialog-model-up-z",
        }
    }

    /// The turn about X, degrees, that stands it up.
    const fn turn_deg(self) -> f32 {
        match self {
            Self::Y => 0.0,
            Self::Z => -90.0,
        }
    }
}

/// A model that has been read.
#[derive(Clone, Debug)]
pub struct LoadedModel {
    /// Its file, as the scene writes it.
    pub path: PathBuf,
    /// Its triangles.
    pub mesh: Arc<TriangleMesh>,
    /// What its reader has to say.
    pub remarks: Vec<String>,
}

/// A model that is being added or changed.
#[derive(Clone, Debug)]
pub struct ModelDraft {
    /// The model.
    pub model: LoadedModel,
    /// Its name in the list.
    pub name: String,
    /// What the numbers in its file mean.
    pub units: Units,
    /// Which axis of its file points up.
    pub up: Up,
    /// Where it is, metres.
    pub position: Vec3,
    /// How it is turned after it has been stood up, degrees.
    pub turn_deg: Vec3,
    /// How many times larger it is than the file says.
    pub scale: Vec3,
    /// Whether its lowest point is put onto the floor.
    pub stands: bool,
    /// Whether facets look round.
    pub smooth: bool,
    /// What it is made of.
    pub material: MaterialDraft,
    /// What it was before; None for a new one.
    before: Option<Box<Object>>,
    bounds: Measured,
}

/// The box around a model, for the turn and scale for which it was measured.
#[derive(Clone, Copy, Debug)]
struct Measured {
    turn_deg: Vec3,
    scale: Vec3,
    bounds: Bounds3,
}

impl ModelDraft {
    /// A new model, standing in the middle of the floor. Its units and the axis that points up are guessed.
    #[must_use]
    pub fn add(model: LoadedModel, scene: &Scene) -> Self {
        let stem = model.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let longest = model.mesh.bounds().size().max_element();
        // Nothing on a table is a hundred metres long: such numbers are millimetres.
        let units = if longest > 100.0 { Units::Millimetre } else { Units::Metre };
        let object = Object::default();
        let mut draft = Self {
            name: if stem.is_empty() { "model".into() } else { stem },
            units,
            up: Up::Y,
            position: Vec3::ZERO,
            turn_deg: Vec3::ZERO,
            scale: Vec3::ONE,
            stands: true,
            smooth: true,
            material: MaterialDraft::of(&object, &Addition::default(), scene),
            before: None,
            bounds: Measured { turn_deg: Vec3::ZERO, scale: Vec3::ONE, bounds: model.mesh.bounds() },
            model,
        };
        draft.put_down(scene);
        draft
    }

    /// A model of the scene. None when the thing is none.
    #[must_use]
    pub fn edit(thing: &Thing, mesh: Arc<TriangleMesh>, scene: &Scene) -> Option<Self> {
        let object = scene.object(thing.name()?)?;
        let Shape::Mesh(shape) = &object.shape else { return None };
        let Vec3 { x, y, z } = object.scale;
        let is_even = x == y && y == z;
        let units = Units::ALL.into_iter().find(|u| is_even && u.metres() == x).unwrap_or(Units::Metre);
        let up = if object.turn_deg.x == Up::Z.turn_deg() { Up::Z } else { Up::Y };
        let bounds = mesh.bounds();
        Some(Self {
            name: object.name.clone(),
            units,
            up,
            position: object.position,
            turn_deg: object.turn_deg - Vec3::X * up.turn_deg(),
            scale: object.scale / units.metres(),
            stands: false,
            smooth: shape.smooth,
            material: MaterialDraft::of(object, &Addition::default(), scene),
            before: Some(Box::new(object.clone())),
            bounds: Measured { turn_deg: Vec3::ZERO, scale: Vec3::ONE, bounds },
            model: LoadedModel { path: PathBuf::from(&shape.file), mesh, remarks: Vec::new() },
        })
    }

    /// What it was called before; None for a new one.
    #[must_use]
    pub fn name_before(&self) -> Option<&str> {
        self.before.as_ref().map(|o| o.name.as_str())
    }

    /// Whether it is being added.
    #[must_use]
    pub const fn is_new(&self) -> bool {
        self.before.is_none()
    }

    /// What stands in the way of accepting it.
    #[must_use]
    pub fn flaw(&self, scene: &Scene) -> Option<Flaw> {
        Subject::Object(Box::new(self.object())).flaw(scene, self.name_before())
    }

    /// Whether it can be put onto the floor here: what belongs to a group goes where the group is.
    #[must_use]
    pub fn can_stand(&self) -> bool {
        self.before.as_ref().is_none_or(|o| o.group.is_none())
    }

    /// Puts its lowest point onto the floor, if that is wanted. Call it after changes.
    pub fn put_down(&mut self, scene: &Scene) {
        let bounds = self.bounds();
        if self.stands && self.can_stand() && !bounds.is_empty() {
            self.position.y = floor_height(scene) - bounds.min.y;
        }
    }

    /// Width, height and depth as it stands, metres.
    pub fn size(&mut self) -> Vec3 {
        let bounds = self.bounds();
        if bounds.is_empty() { Vec3::ZERO } else { bounds.size() }
    }

    /// The box around it, turned and scaled, relative to its own origin. Measured anew only when it must be.
    fn bounds(&mut self) -> Bounds3 {
        let (turn_deg, scale) = (self.whole_turn(), self.whole_scale());
        if (turn_deg, scale) != (self.bounds.turn_deg, self.bounds.scale) {
            let place = Transform::from_place(Vec3::ZERO, turn_deg, scale);
            let points = self.model.mesh.positions.iter().map(|p| place.point(*p));
            self.bounds = Measured { turn_deg, scale, bounds: Bounds3::around(points) };
        }
        self.bounds.bounds
    }

    fn whole_turn(&self) -> Vec3 {
        self.turn_deg + Vec3::X * self.up.turn_deg()
    }

    fn whole_scale(&self) -> Vec3 {
        self.scale * self.units.metres()
    }

    /// The object that it is.
    #[must_use]
    pub fn object(&self) -> Object {
        let base = self.before.as_deref().cloned().unwrap_or_default();
        let file = self.model.path.to_string_lossy().into_owned();
        Object {
            name: self.name.trim().to_owned(),
            shape: Shape::Mesh(shapes::Mesh { file, smooth: self.smooth }),
            position: self.position,
            turn_deg: self.whole_turn(),
            scale: self.whole_scale(),
            ..base
        }
    }

    /// What to do when it is accepted, in order; together one step. Empty when nothing was changed.
    #[must_use]
    pub fn commands(&self, scene: &Scene) -> Vec<EditCommand> {
        let object = self.object();
        let Some(before) = &self.before else {
            return vec![EditCommand::Add(self.material.put_on(object, scene))];
        };
        let thing = Thing::object(&before.name);
        let set = |key: &str, value| EditCommand::Set { things: vec![thing.clone()], key: key.into(), value };
        let mut commands = Vec::new();
        for key in ["position", "turn_deg", "scale"] {
            let value = object.get(key).filter(|v| before.get(key).as_ref() != Some(v));
            commands.extend(value.map(|v| set(key, v)));
        }
        if object.shape != before.shape {
            commands.push(set("smooth", Value::Flag(self.smooth)));
        }
        commands.extend(self.material.commands(before, scene));
        if object.name != before.name {
            commands.push(EditCommand::Rename { thing, name: object.name });
        }
        commands
    }

    /// A scene that shows the model alone, on a floor, filling the picture.
    #[must_use]
    pub fn shown(&mut self, scene: &Scene) -> Scene {
        let bounds = self.bounds();
        let mut shown = Scene { textures: scene.textures.clone(), ..Scene::default() };
        shown.materials.clone_from(&scene.materials);
        shown.settings.background = Rgb::new(0.16, 0.17, 0.18);
        let mut object = Object { position: -bounds.center(), group: None, visible: true, ..self.object() };
        self.material.show_in(&mut shown, &mut object);
        replace(&mut shown.objects, object, None);
        let radius = (bounds.size().length() * 0.5).max(f32::MIN_POSITIVE);
        let floor = Object {
            name: "floor".into(),
            shape: Shape::Plane(shapes::Plane::default()),
            position: Vec3::NEG_Y * (bounds.size().y * 0.5),
            ..Object::default()
        };
        replace(&mut shown.objects, floor, None);
        let eye = Vec3::new(0.55, 0.45, 1.0).normalize() * radius * 2.9;
        shown.camera =
            Camera { position: eye, look_at: Some(Vec3::ZERO), view_angle_deg: 42.0, ..Camera::default() };
        let lamp = lights::Disc { position: Vec3::new(1.0, 2.2, 1.6) * radius * 1.6, radius: radius * 0.4 };
        let air = Light {
            name: "air".into(),
            source: LightSource::Ambient(lights::Ambient::default()),
            intensity: 0.3,
            ..Light::default()
        };
        let lamp = Light { name: "lamp".into(), source: LightSource::Disc(lamp), ..Light::default() };
        shown.lights = vec![air, lamp];
        shown
    }
}

/// The height of the floor: that of the scene's highest level plane, else 0.
fn floor_height(scene: &Scene) -> f32 {
    let is_level = |o: &&Object| {
        matches!(o.shape, Shape::Plane(_)) && o.turn_deg == Vec3::ZERO && o.group.is_none() && o.visible
    };
    scene.objects.iter().filter(is_level).map(|o| o.position.y).max_by(f32::total_cmp).unwrap_or(0.0)
}
