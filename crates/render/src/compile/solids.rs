//! What light passes through: the solids that bend it, what they are filled with, and the simple forms of them through which
//! connections can be solved.
//!
//! Where two solids overlap, the smaller one is there: ice in water, water in a glass, a ball in a tank. No one has to cut
//! one out of the other (nested dielectrics: Schmidt and Budge, "Simple Nested Dielectrics in Ray Traced Images", 2002, with the
//! priorities inferred).

use super::geometry::{Form, Primitive};
use super::nests::Nest;
use super::physical::Substance;
use vitrine_math::{Ray, Rgb, Vec3};

/// No solid.
pub const AIR: u16 = u16::MAX;
/// Mirrors have numbers from here on.
const MIRRORS: u16 = 0xff00;
/// The most mirrors off which connections are solved: the first ones of the scene.
const MOST_MIRRORS: usize = 8;
/// Balls and blocks that reach into each other by less than this share of the ball only touch.
const TOUCH: f32 = 1e-5;
/// The most solids that are told apart; what comes after them is taken for thin walls.
const MOST: usize = MIRRORS as usize;

/// A transparent thing with an inside.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Its place among the scene's primitives.
    pub primitive: u32,
    /// What it is filled with.
    pub substance: Substance,
    /// Where several overlap, the one of the lowest rank is there.
    pub rank: u32,
    /// Its form, if connections can be solved through it.
    pub piece: Option<Piece>,
    /// The size of the space that it takes, cubic metres.
    volume: f64,
}

/// A form through which connections can be solved.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    /// A ball.
    Ball {
        /// Metres.
        center: Vec3,
        /// Metres.
        radius: f32,
    },
    /// A box: three pairs of parallel faces.
    Block {
        /// The middle.
        center: Vec3,
        /// The unit normals of the faces.
        axes: [Vec3; 3],
        /// Half of each edge, metres.
        half: [f32; 3],
    },
    /// All that lies below a plane.
    Below {
        /// The unit normal, out of the solid.
        n: Vec3,
        /// ⟨n, p⟩ on the plane, metres.
        offset: f32,
    },
}

impl Piece {
    fn new(form: &Form) -> Option<Self> {
        match form {
            Form::Sphere { center, radius } => Some(Self::Ball { center: *center, radius: *radius }),
            Form::Plane { point, n } => Some(Self::Below { n: *n, offset: n.dot(*point) }),
            Form::Box { unit } => {
                let m = unit.world_from_object.matrix3;
                let edges: [Vec3; 3] = [m.x_axis.into(), m.y_axis.into(), m.z_axis.into()];
                let half = edges.map(Vec3::length);
                let axes: [Vec3; 3] = std::array::from_fn(|k| edges[k] / half[k]);
                // A box that a group has sheared has no right angles.
                let slant = [axes[0].dot(axes[1]), axes[1].dot(axes[2]), axes[2].dot(axes[0])];
                let is_right = slant.iter().all(|s| s.abs() < 1e-5);
                is_right.then_some(Self::Block {
                    center: unit.world_from_object.translation.into(),
                    axes,
                    half,
                })
            }
            _ => None,
        }
    }

    /// Whether its surface cuts that of a ball; not if they touch.
    pub fn cuts(&self, center: Vec3, radius: f32) -> bool {
        let radius = radius * (1.0 - TOUCH);
        match self {
            Self::Ball { center: other, radius: of_other } => {
                let apart = (center - *other).length();
                apart < radius + of_other && apart > (radius - of_other).abs()
            }
            Self::Below { n, offset } => (n.dot(center) - offset).abs() < radius,
            Self::Block { center: other, axes, half } => {
                let local = center - *other;
                let beyond: [f32; 3] = std::array::from_fn(|k| axes[k].dot(local).abs() - half[k]);
                let outside = Vec3::from_array(beyond.map(|d| d.max(0.0))).length();
                let nearest = beyond.iter().fold(f32::NEG_INFINITY, |a, b| a.max(*b));
                if nearest > 0.0 { outside < radius } else { -nearest < radius }
            }
        }
    }

    /// Whether a point is in it.
    pub fn holds(&self, p: Vec3) -> bool {
        match self {
            Self::Ball { center, radius } => (p - *center).length_squared() < radius * radius,
            Self::Below { n, offset } => n.dot(p) < *offset,
            Self::Block { center, axes, half } => {
                let local = p - *center;
                (0..3).all(|k| axes[k].dot(local).abs() < half[k])
            }
        }
    }
}

/// The solids of a scene.
#[derive(Debug, Default)]
pub struct Solids {
    list: Vec<Solid>,
    /// Each primitive's solid, or [`AIR`].
    by_primitive: Vec<u16>,
    /// Those with a clear surface and a form through which connections can be solved.
    clear: Vec<u16>,
    /// The balls among those.
    nests: Vec<Nest>,
    /// Balls of polished metal.
    mirrors: Vec<Mirror>,
}

/// A ball of polished metal: nothing passes it, and connections are solved off it.
#[derive(Clone, Copy, Debug)]
pub struct Mirror {
    /// Its place among the scene's primitives.
    pub primitive: u32,
    /// Metres.
    pub center: Vec3,
    /// Metres.
    pub radius: f32,
}

/// A solid to be.
pub struct Candidate<'a> {
    /// The primitive.
    pub primitive: &'a Primitive,
    /// Its place.
    pub id: u32,
    /// What it is filled with.
    pub substance: Substance,
    /// Whether its surface is smooth and the same everywhere.
    pub is_clear: bool,
}

impl Solids {
    /// From those primitives of so many that are solids.
    pub fn new<'a>(candidates: impl Iterator<Item = Candidate<'a>>, primitives: usize) -> Self {
        let mut all = Self { by_primitive: vec![AIR; primitives], ..Self::default() };
        for candidate in candidates.take(MOST) {
            let Candidate { primitive, id, substance, is_clear } = candidate;
            let index = all.list.len() as u16;
            let piece = Piece::new(&primitive.form);
            all.list.push(Solid { primitive: id, substance, rank: 0, piece, volume: primitive.volume });
            all.by_primitive[id as usize] = index;
            if is_clear && piece.is_some() {
                all.clear.push(index);
            }
        }
        // Equal ones: the later in the scene's list is there.
        let mut order: Vec<usize> = (0..all.list.len()).collect();
        order.sort_by(|&a, &b| all.list[a].volume.total_cmp(&all.list[b].volume).then(b.cmp(&a)));
        for (rank, index) in order.into_iter().enumerate() {
            all.list[index].rank = rank as u32;
        }
        let ball = |&index: &u16| match all.list[usize::from(index)].piece {
            Some(Piece::Ball { center, radius }) => Some((index, center, radius)),
            _ => None,
        };
        all.nests = Nest::all(all.clear.iter().filter_map(ball));
        for nest in &mut all.nests {
            let others = || (0..).zip(&all.list).filter(|(index, _)| !nest.holds(*index));
            nest.is_cut = others().any(|(_, other)| match &other.piece {
                Some(piece) => piece.cuts(nest.center, nest.balls[0].1),
                // Of a model no one knows it so soon.
                None => true,
            });
        }
        all
    }

    /// Takes the first balls among primitives of polished metal, each with its place in the scene, for mirrors.
    #[must_use]
    pub fn with_mirrors<'a>(mut self, metal: impl Iterator<Item = (u32, &'a Primitive)>) -> Self {
        let ball = |(id, primitive): (u32, &'a Primitive)| match primitive.form {
            Form::Sphere { center, radius } => Some(Mirror { primitive: id, center, radius }),
            _ => None,
        };
        self.mirrors = metal.filter_map(ball).take(MOST_MIRRORS).collect();
        self
    }

    /// The mirrors, each with the number by which chains of surfaces know it.
    #[inline]
    pub fn mirrors(&self) -> impl Iterator<Item = (u16, &Mirror)> {
        (MIRRORS..).zip(&self.mirrors)
    }

    /// The mirror of that number.
    #[inline]
    pub fn mirror(&self, number: u16) -> Option<&Mirror> {
        self.mirrors.get(usize::from(number.checked_sub(MIRRORS)?))
    }

    /// The number of the mirror that a primitive is.
    #[inline]
    pub fn mirror_of_primitive(&self, primitive: u32) -> Option<u16> {
        self.mirrors().find(|(_, mirror)| mirror.primitive == primitive).map(|(number, _)| number)
    }

    /// Whether there is nothing through or off which connections are solved.
    #[inline]
    pub fn is_plain(&self) -> bool {
        self.clear.is_empty() && self.mirrors.is_empty()
    }

    /// The solid that a primitive is, or [`AIR`].
    #[inline]
    pub fn of_primitive(&self, primitive: u32) -> u16 {
        self.by_primitive[primitive as usize]
    }

    /// A solid.
    ///
    /// # Panics
    /// For [`AIR`].
    #[inline]
    pub fn get(&self, solid: u16) -> &Solid {
        &self.list[solid as usize]
    }

    /// What a place is filled with; None for air.
    #[inline]
    pub fn substance(&self, solid: u16) -> Option<&Substance> {
        self.list.get(solid as usize).map(|s| &s.substance)
    }

    /// What is left of light after so many metres through what fills a place.
    #[inline]
    pub fn transmittance(&self, solid: u16, length: f32) -> Rgb {
        self.substance(solid).map_or(Rgb::WHITE, |inside| inside.transmittance(length))
    }

    /// All of them, in the scene's order.
    pub fn iter(&self) -> impl Iterator<Item = (u16, &Solid)> {
        (0..).zip(&self.list)
    }

    /// The clear ones of a simple form.
    #[inline]
    pub fn clear(&self) -> &[u16] {
        &self.clear
    }

    /// Whether that one is among them.
    #[inline]
    pub fn is_clear(&self, solid: u16) -> bool {
        self.clear.binary_search(&solid).is_ok()
    }

    /// Forgets which ones are clear and which are mirrors, so that no connection is solved through or off any.
    pub fn forget_clear(&mut self) {
        self.clear.clear();
        self.nests.clear();
        self.mirrors.clear();
    }

    /// The clear balls, each with those around the same centre.
    #[inline]
    pub fn nests(&self) -> &[Nest] {
        &self.nests
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}

/// The ray by which it is found whether a point is inside a model: towards where rays seldom run along faces.
pub fn probe(p: Vec3) -> Ray {
    Ray::new(p, Vec3::new(0.312_3, 0.871_9, 0.377_1).normalize())
}
