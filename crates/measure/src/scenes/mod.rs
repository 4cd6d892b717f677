//! The scenes that are measured, one file each, and the register of them.

mod cave;
mod noise;
mod room;
mod seed;
mod shapes;

use crate::Scene;

/// A kind of scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneKind {
    /// Balls, a floor and four small models: what the course work's benchmark consists of.
    Seed,
    /// One large model all around the camera.
    Cave,
    /// A room full of things.
    Room,
}

impl SceneKind {
    /// All of them, the smallest first.
    pub const ALL: [Self; 3] = [Self::Seed, Self::Room, Self::Cave];

    /// Its name, a word in lower case.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Seed => "seed",
            Self::Cave => "cave",
            Self::Room => "room",
        }
    }

    /// How many triangles it has when nobody says.
    #[must_use]
    pub const fn triangles(self) -> u32 {
        match self {
            Self::Seed => 642,
            Self::Cave => 1_310_720,
            Self::Room => 500_000,
        }
    }

    /// Makes it of about so many triangles. The seed always has its own number, the room some thousands at the least.
    #[must_use]
    pub fn scene(self, triangles: u32) -> Scene {
        match self {
            Self::Seed => seed::scene(),
            Self::Cave => cave::scene(triangles),
            Self::Room => room::scene(triangles),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_have_the_triangles_that_were_asked_for() {
        assert_eq!(SceneKind::Seed.scene(5).triangles(), 642);
        for (kind, least) in [(SceneKind::Cave, 1000), (SceneKind::Room, 5000)] {
            for triangles in [least, 10 * least, 100 * least] {
                let made = kind.scene(triangles).triangles() as f32 / triangles as f32;
                assert!((0.8..1.25).contains(&made), "{} of {triangles}: {made}", kind.name());
            }
        }
    }

    #[test]
    fn a_scene_is_the_same_each_time() {
        for kind in SceneKind::ALL {
            assert_eq!(kind.scene(2000), kind.scene(2000));
        }
    }

    #[test]
    fn the_camera_stands_inside() {
        for kind in [SceneKind::Cave, SceneKind::Room] {
            let scene = kind.scene(5000);
            let bounds = scene.models[0].bounds();
            assert!(bounds.contains(scene.view.eye) && bounds.contains(scene.lamp), "{}", kind.name());
        }
    }
}
