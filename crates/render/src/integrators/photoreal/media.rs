//! What a path is inside of.

use crate::accel::{Accel, HitStream, RayStream};
use crate::compile::{AIR, Solids, probe};
use vitrine_math::Vec3;

/// So many solids may lie over each other in one place; what lies over more is not noticed.
const MOST: usize = 8;
/// So many surfaces are met to find out what the camera is inside of.
const MOST_SURFACES: usize = 256;

/// The solids that hold a place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Media {
    inside: [u16; MOST],
    len: u8,
}

/// What is on both sides of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides {
    /// The solid that is there before it, or [`AIR`].
    pub before: u16,
    /// The solid that is there behind it, or [`AIR`].
    pub beyond: u16,
    /// All that hold the place behind it.
    pub media: Media,
}

impl Media {
    fn all(&self) -> &[u16] {
        &self.inside[..usize::from(self.len)]
    }

    /// The one that is there, or [`AIR`]: of several, that of the lowest rank.
    #[inline]
    pub fn top(&self, solids: &Solids) -> u16 {
        match self.all() {
            [] => AIR,
            [one] => *one,
            all => all.iter().copied().min_by_key(|s| solids.get(*s).rank).unwrap_or(AIR),
        }
    }

    /// With one more.
    #[inline]
    #[must_use]
    pub fn with(mut self, solid: u16) -> Self {
        if !self.all().contains(&solid) && usize::from(self.len) < MOST {
            self.inside[usize::from(self.len)] = solid;
            self.len += 1;
        }
        self
    }

    /// Without one of them.
    #[inline]
    #[must_use]
    pub fn without(mut self, solid: u16) -> Self {
        if let Some(at) = self.all().iter().position(|s| *s == solid) {
            self.len -= 1;
            self.inside[at] = self.inside[usize::from(self.len)];
        }
        self
    }

    /// Those through which no connection is solved.
    pub fn unclear<'a>(&'a self, solids: &'a Solids) -> impl Iterator<Item = u16> + 'a {
        self.all().iter().copied().filter(|s| !solids.is_clear(*s))
    }

    /// Whether that one is among them.
    #[inline]
    pub fn holds(&self, solid: u16) -> bool {
        self.all().contains(&solid)
    }

    /// What is on both sides of a solid's surface for who comes from here: from outside it or from inside.
    #[inline]
    pub fn across(self, solids: &Solids, solid: u16, is_outside: bool) -> Sides {
        // Who is seen to come out of it was in it, whatever led there: the surface of a model may have holes.
        let (here, there) = if is_outside {
            (self.without(solid), self.with(solid))
        } else {
            (self.with(solid), self.without(solid))
        };
        Sides { before: here.top(solids), beyond: there.top(solids), media: there }
    }

    /// The solids that hold a point.
    pub fn at(accel: &Accel, solids: &Solids, p: Vec3) -> Self {
        let mut media = Self::default();
        let mut has_models = false;
        for (index, solid) in solids.iter() {
            match &solid.piece {
                Some(piece) if piece.holds(p) => media = media.with(index),
                Some(_) => {}
                None => has_models = true,
            }
        }
        if has_models {
            media.find_models(accel, solids, p);
        }
        media
    }

    /// Finds the models that hold a point: those whose surface a ray from there crosses an odd number of times.
    fn find_models(&mut self, accel: &Accel, solids: &Solids, p: Vec3) {
        let ray = probe(p);
        let (mut rays, mut hits) = (RayStream::default(), HitStream::default());
        let mut last = None;
        for _ in 0..MOST_SURFACES {
            rays.clear();
            match &last {
                None => rays.push(&ray),
                Some(hit) => rays.push_on(&ray, hit),
            }
            accel.closest(&rays, &mut hits);
            let Some(hit) = hits.get(0) else { return };
            let solid = solids.of_primitive(hit.primitive);
            if solid != AIR && solids.get(solid).piece.is_none() {
                *self = if self.holds(solid) { self.without(solid) } else { self.with(solid) };
            }
            last = Some(hit);
        }
    }
}
