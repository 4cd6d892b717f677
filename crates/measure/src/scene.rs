//! A scene as plain geometry, for any ray kernel: no materials, no names.

use vitrine_math::{Bounds3, Vec3};

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// The centre, metres.
    pub center: Vec3,
    /// The radius, metres.
    pub radius: f32,
}

/// Triangles over shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Vertices in world space, metres.
    pub positions: Vec<Vec3>,
    /// Three indices of vertices each.
    pub triangles: Vec<[u32; 3]>,
}

impl Model {
    /// The corners of a triangle.
    ///
    /// # Panics
    /// When there is no such triangle.
    #[must_use]
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|i| self.positions[i as usize])
    }

    /// The box around all vertices.
    #[must_use]
    pub fn bounds(&self) -> Bounds3 {
        Bounds3::around(self.positions.iter().copied())
    }

    /// Adds another model's triangles, its vertices moved by a function.
    pub fn append(&mut self, other: &Self, moved: impl Fn(Vec3) -> Vec3) {
        let first = self.positions.len() as u32;
        self.positions.extend(other.positions.iter().map(|&p| moved(p)));
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|i| first + i)));
    }

    /// The same triangles, the vertices moved by a function.
    #[must_use]
    pub fn moved(mut self, to: impl Fn(Vec3) -> Vec3) -> Self {
        for p in &mut self.positions {
            *p = to(*p);
        }
        self
    }
}

/// Where the camera stands and what it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The camera, metres.
    pub eye: Vec3,
    /// What lies in the middle of the picture, metres.
    pub look_at: Vec3,
    /// The angle from the left edge of the picture to the right one, degrees.
    pub angle_deg: f32,
}

/// Everything that rays are shot at, and where they are shot from.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Balls.
    pub balls: Vec<Ball>,
    /// The height of a floor without end, metres; None when there is none.
    pub floor: Option<f32>,
    /// Models.
    pub models: Vec<Model>,
    /// The camera.
    pub view: View,
    /// A point light, metres.
    pub lamp: Vec3,
    /// How long the short rays are that look for near things, metres.
    pub reach: f32,
}

/// What a ray has met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The ball of that index.
    Ball(usize),
    /// The floor.
    Floor,
    /// A triangle of a model.
    Triangle {
        /// The model's index.
        model: usize,
        /// The triangle's index in its model.
        triangle: usize,
    },
}

impl Scene {
    /// How many triangles there are.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.models.iter().map(|m| m.triangles.len()).sum()
    }

    /// The unit normal of a part at one of its points; either side.
    ///
    /// # Panics
    /// When the scene has no such part.
    #[must_use]
    pub fn normal(&self, part: Part, at: Vec3) -> Vec3 {
        let n = match part {
            Part::Ball(i) => at - self.balls[i].center,
            Part::Floor => Vec3::Y,
            Part::Triangle { model, triangle } => {
                let [a, b, c] = self.models[model].corners(triangle);
                (b - a).cross(c - a)
            }
        };
        n.try_normalize().unwrap_or(Vec3::Y)
    }
}
