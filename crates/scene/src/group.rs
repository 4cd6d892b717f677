//! Groups: objects that are moved, turned, scaled and hidden together.

use crate::{ListName, ParamKind, Range};
use vitrine_math::{Transform, Vec3};

crate::params! {
    /// Objects that are moved, turned, scaled and hidden together.
    pub struct Group {
        @plain {
            /// Its name, unique among the groups.
            name: String = "group".to_owned();
        }
        /// Whether its members are seen.
        visible: bool = true => ParamKind::Flag, None;
        /// Where its members' origin lies.
        position: Vec3 = Vec3::ZERO => ParamKind::Vector(Range::ANY), Metres;
        /// How its members are turned together about X, then Y, then Z.
        turn_deg: Vec3 = Vec3::ZERO => ParamKind::Vector(Range::ANY), Degrees;
        /// How many times larger its members become, along x, y and z.
        scale: Vec3 = Vec3::ONE => ParamKind::Scale, None;
        /// The group that it belongs to itself.
        group: Option<String> = None => ParamKind::Reference(ListName::Group), None;
    }
}

impl Group {
    /// From the group's space to that of its own group or the world.
    #[must_use]
    pub fn place(&self) -> Transform {
        Transform::from_place(self.position, self.turn_deg, self.scale)
    }
}
