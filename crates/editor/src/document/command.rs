//! Everything that a person can do to a scene. Panels, keys, tests and scripts issue these; nothing else changes one.

use super::Thing;
use vitrine::math::{Axis, Vec3};
use vitrine::scene::{Group, Light, Material, Object, Texture, Value};

/// A change of the scene: one step of the history.
#[derive(Clone, Debug, PartialEq)]
pub enum EditCommand {
    /// Sets a parameter of one or several things; of several, those that have it.
    Set {
        /// Whose.
        things: Vec<Thing>,
        /// Which.
        key: String,
        /// To what.
        value: Value,
    },
    /// Makes a light, texture or object another kind. What both kinds have stays, the rest is as that kind's defaults.
    SetKind {
        /// Which.
        thing: Thing,
        /// The word of the kind.
        kind: String,
    },
    /// Gives a thing another name; whatever refers to it follows.
    Rename {
        /// Which.
        thing: Thing,
        /// Its new name.
        name: String,
    },
    /// Changes the line that says what the scene shows.
    SetAbout(String),
    /// Adds new things; names that are taken get a number. What has been added is selected.
    Add(Addition),
    /// Deletes things; nothing refers to them afterwards. Groups take their members along.
    Delete(Vec<Thing>),
    /// Copies things beside themselves and selects the copies. Groups are copied with their members.
    Duplicate(Vec<Thing>),
    /// Adds what a copied text says and selects it: where it was, or beside that when it is there still.
    Paste(String),
    /// Puts objects and groups into a new group, whose origin is in their middle. They stay where they are.
    Group(Vec<Thing>),
    /// Takes groups apart; their members stay where they are.
    Ungroup(Vec<Thing>),
    /// Shows or hides.
    Show {
        /// What.
        things: Vec<Thing>,
        /// Whether it is seen.
        visible: bool,
    },
    /// Moves by metres along the world's axes: objects, groups, lights with a position, the camera.
    Move {
        /// What.
        things: Vec<Thing>,
        /// How far.
        by: Vec3,
    },
    /// Turns about an axis of the world, each thing through its own centre: objects, groups, sunlight, the camera.
    Turn {
        /// What.
        things: Vec<Thing>,
        /// About which axis.
        axis: Axis,
        /// How far, degrees.
        angle_deg: f32,
    },
    /// Makes so many times larger along the thing's own axes: objects, groups, disc lamps.
    Resize {
        /// What.
        things: Vec<Thing>,
        /// Factors, none zero.
        by: Vec3,
    },
    /// Sets things down on the floor or on whatever lies below them.
    DropToFloor(Vec<Thing>),
    /// Makes objects of a material, which is added unless the scene has one just like it.
    Paint {
        /// Which objects.
        things: Vec<Thing>,
        /// Of what.
        material: Box<Paint>,
    },
    /// Moves the camera.
    Camera(CameraMove),
    /// Several edits as one step; when one of them is refused, none is made.
    Several(Vec<EditCommand>),
}

/// New things, with the material and texture that come with them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Addition {
    /// Objects; they name materials by the names in `materials` or in the scene.
    pub objects: Vec<Object>,
    /// Groups that come with them.
    pub groups: Vec<Group>,
    /// Lights.
    pub lights: Vec<Light>,
    /// Materials; one that the scene has already, alike in all but a number after its name, is not added again.
    pub materials: Vec<Material>,
    /// Textures, likewise.
    pub textures: Vec<Texture>,
}

impl Addition {
    /// The same with another name for its only object or light, and for a material that is named after it.
    #[must_use]
    pub fn named(mut self, name: &str) -> Self {
        let old = self.objects.first().map(|o| o.name.clone());
        for material in self.materials.iter_mut().filter(|m| Some(&m.name) == old.as_ref()) {
            name.clone_into(&mut material.name);
        }
        for object in &mut self.objects {
            if object.material == old {
                object.material = Some(name.to_owned());
            }
            name.clone_into(&mut object.name);
        }
        self.lights.iter_mut().for_each(|light| name.clone_into(&mut light.name));
        self
    }
}

/// A material to paint with, and the texture that it needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Paint {
    /// The material; its `texture` names the one below or one in the scene.
    pub material: Material,
    /// The texture that comes with it.
    pub texture: Option<Texture>,
}

/// Ways to move the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CameraMove {
    /// Around the point that it looks at: to the right and up, degrees. Y stays up.
    Orbit {
        /// The point in the middle.
        around: Vec3,
        /// Degrees to the right.
        right_deg: f32,
        /// Degrees up.
        up_deg: f32,
    },
    /// Sideways and up in its own directions, metres; the point that it looks at goes along.
    Pan {
        /// Metres to the right.
        right: f32,
        /// Metres up.
        up: f32,
    },
    /// Towards a point: so many times nearer.
    Zoom {
        /// The point.
        toward: Vec3,
        /// 2 halves the distance.
        factor: f32,
    },
    /// By an angle about an axis of the world, through itself (C13).
    Turn {
        /// The axis.
        axis: Axis,
        /// Degrees.
        angle_deg: f32,
    },
    /// Aims at a point.
    LookAt(Vec3),
    /// Steps back or forth, without turning, until a ball fills the picture.
    Frame {
        /// The middle of the ball.
        center: Vec3,
        /// Its radius, metres.
        radius: f32,
    },
}
