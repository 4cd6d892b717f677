//! An object: a shape of some material at some place.

use crate::{ListName, ParamKind, Range, Shape};
use vitrine_math::{Transform, Vec3};

crate::params! {
    /// A thing in the scene.
    pub struct Object {
        @plain {
            /// Its name, unique among the objects.
            name: String = "object".to_owned();
            /// Its shape with that shape's own parameters.
            shape: Shape = Shape::Sphere(crate::shapes::Sphere::default());
        }
        /// Whether it is seen and casts shadows.
        visible: bool = true => ParamKind::Flag, None;
        /// Where its centre (a model's own origin) is.
        position: Vec3 = Vec3::ZERO => ParamKind::Vector(Range::ANY), Metres;
        /// How it is turned about the world's X axis, then Y, then Z, through its centre.
        turn_deg: Vec3 = Vec3::ZERO => ParamKind::Vector(Range::ANY), Degrees;
        /// How many times larger it becomes, along its own x, y and z.
        scale: Vec3 = Vec3::ONE => ParamKind::Scale, None;
        /// What it is made of. Without it a model keeps its own materials, and other things are light grey.
        material: Option<String> = None => ParamKind::Reference(ListName::Material), None;
        /// The group that it belongs to.
        group: Option<String> = None => ParamKind::Reference(ListName::Group), None;
    }
}

impl Object {
    /// From the object's own space to its group's, or to the world's when it is in none.
    #[must_use]
    pub fn place(&self) -> Transform {
        Transform::from_place(self.position, self.turn_deg, self.scale)
    }
}
