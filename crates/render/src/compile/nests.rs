//! Balls within balls: a bulb is a ball of glass with a ball of air around the same centre, a snow globe one with water. Connections
//! are solved through all surfaces of such a nest at once.

use vitrine_math::Vec3;

/// So many balls of one nest are told apart; those within them stand in the light's way.
pub const MOST_SHELLS: usize = 8;
/// The most nests through which connections are solved: the first ones of the scene.
const MOST_NESTS: usize = 8;
/// Centres that differ by less than this share of their coordinates differ by rounding.
const SAME: f32 = 2.0 * f32::EPSILON;
/// Radii that differ by less than this share of them bound no space.
const DISTINCT: f32 = 1e-5;

/// Clear balls around one centre.
#[derive(Clone, Debug)]
pub struct Nest {
    /// The centre.
    pub center: Vec3,
    /// Each one's solid and its radius, metres, from the largest to the smallest.
    pub balls: Vec<(u16, f32)>,
    /// Whether another solid may cut the outermost one, so that different things are outside of it in different places.
    pub is_cut: bool,
}

impl Nest {
    /// Nests of balls that are given by their solid, centre and radius, in the order of the first of each.
    pub fn all(balls: impl Iterator<Item = (u16, Vec3, f32)>) -> Vec<Self> {
        let mut nests: Vec<Self> = Vec::new();
        for (solid, center, radius) in balls {
            let is_same = |nest: &Self| {
                let apart = (nest.center - center).abs().max_element();
                apart <= SAME * center.abs().max_element()
            };
            match nests.iter().position(is_same) {
                Some(same) => nests[same].balls.push((solid, radius)),
                None if nests.len() == MOST_NESTS => {}
                None => nests.push(Self { center, balls: vec![(solid, radius)], is_cut: false }),
            }
        }
        for nest in &mut nests {
            nest.balls.sort_by(|a, b| b.1.total_cmp(&a.1));
            nest.balls.truncate(MOST_SHELLS);
        }
        // Of two balls in one place no one can say which is met first.
        nests.retain(|nest| nest.balls.windows(2).all(|two| two[1].1 < two[0].1 * (1.0 - DISTINCT)));
        nests
    }

    /// Whether that solid is one of the balls.
    pub fn holds(&self, solid: u16) -> bool {
        self.balls.iter().any(|ball| ball.0 == solid)
    }
}
