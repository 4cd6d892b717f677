//! Everything that a person can do to a scene. Panels, keys, tests and scripts issue these; nothing else changes one.

use super::Thing;
use vitrine::math::{Axis, Vec3};
use vitrine::scene::{Light, Material, Object, Texture, Value};

/// A change of the scene: one step of the history.
#[derive(Clone, Debug, PartialEq)]
pub enum EditCommand {
    /// Sets a parameter of one or several things.
    Set {
        /// Whose.
        things: Vec<Thing>,
        /// Which.
        key: String,
        /// To what.
        value: Value,
    },
    /// Makes a light, texture or object another kind, with that kind's defaults.
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
    /// Copies things beside themselves and selects the copies.
    Duplicate(Vec<Thing>),
    /// Adds what a copied text says and selects it.
    Paste(String),
    /// Puts things into a new group.
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
    /// Turns about an axis of the world, each thing through its own centre.
    Turn {
        /// What.
        things: Vec<Thing>,
        /// About which axis.
        axis: Axis,
        /// How far, degrees.
        angle_deg: f32,
    },
    /// Makes so many times larger along the thing's own axes.
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
}

/// New things, with the material and texture that come with them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Addition {
    /// Objects; they name materials by the names in `materials` or in the scene.
    pub objects: Vec<Object>,
    /// Lights.
    pub lights: Vec<Light>,
    /// Materials; one that the scene has already, all alike, is not added again.
    pub materials: Vec<Material>,
    /// Textures, likewise.
    pub textures: Vec<Texture>,
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
