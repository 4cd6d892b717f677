//! The forms that rays are tested against, each exact, each for a packet at a time.

pub mod cuboid;
pub mod disc;
pub mod plane;
pub mod sphere;
pub mod triangle;

use super::simd::Simd;

/// Where the rays of a packet enter and leave a closed form. Only for lanes of the mask.
#[derive(Clone, Copy)]
pub struct Span<S: Simd> {
    /// Lanes whose line meets the form.
    pub mask: S::M,
    /// Where it enters; may lie behind the origin.
    pub near: S::F,
    /// Where it leaves.
    pub far: S::F,
}
