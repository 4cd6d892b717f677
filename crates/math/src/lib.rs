//! Geometry, colour and chance: the ground that every other crate stands on. It knows nobody.
//!
//! Everything here gives the same bits on every machine: transcendental functions come from `libm`
//! and nothing uses fused multiply-add. That is what lets a picture be the same on any computer.

mod black_body;
mod bounds;
mod color;
mod frame;
pub mod hash;
mod offset;
mod power;
mod ray;
mod transform;
pub mod warp;

pub use black_body::black_body_color;
pub use bounds::Bounds3;
pub use color::{ParseColorError, Rgb, linear_from_srgb, srgb_from_linear};
pub use frame::Frame;
pub use glam::{Affine3A, DVec3, Mat3, Quat, Vec2, Vec3, Vec4};
pub use offset::{OFFSET_SHARE, OFFSET_STEPS, offset_origin};
pub use power::pow_unit;
pub use ray::Ray;
pub use transform::{Axis, Transform, rotation_from_turn, turn_from_rotation};
