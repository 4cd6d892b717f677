//! Light on its way to a path: it counts if nothing stands in between.

use crate::accel::{Hit, HitStream, RayStream};
use crate::compile::{AIR, CompiledScene};
use crate::surface::Spots;
use vitrine_math::{Ray, Rgb, Vec3};

/// So many thin sheets light passes at most.
const MOST_SHEETS: u32 = 64;

/// Light that waits.
#[derive(Clone, Copy, Debug)]
struct Ticket {
    pixel: u32,
    light: Rgb,
}

/// A straight part of its way.
#[derive(Clone, Copy, Debug)]
struct Leg {
    ticket: u32,
    /// What it goes through, or [`AIR`].
    medium: u16,
}

/// All light that waits.
#[derive(Debug, Default)]
pub struct Shadows {
    tickets: Vec<Ticket>,
    legs: Vec<Leg>,
    rays: RayStream,
    blocked: Vec<bool>,
    onward: RayStream,
    onward_legs: Vec<Leg>,
    hits: HitStream,
    spots: Spots,
}

impl Shadows {
    /// Adds light for a pixel; its legs follow.
    #[inline]
    pub fn expect(&mut self, pixel: u32, light: Rgb) {
        self.tickets.push(Ticket { pixel, light });
    }

    /// Adds a leg of the light that was added last, between two points that lie beside the surfaces where it begins and ends.
    #[inline]
    pub fn leg(&mut self, from: Vec3, to: Vec3, medium: u16) {
        let way = to - from;
        let length = way.length();
        // Between surfaces that touch there is nothing.
        if length > 0.0 && is_traceable(from, way / length) {
            self.rays.push(&Ray { origin: from, direction: way / length, t_max: length });
            self.legs.push(Leg { ticket: self.tickets.len() as u32 - 1, medium });
        } else if length != 0.0
            && let Some(ticket) = self.tickets.last_mut()
        {
            ticket.light = Rgb::BLACK;
        }
    }

    /// Finds out what arrives, and adds it to the pixels. Gives the number of rays.
    pub fn settle(&mut self, scene: &CompiledScene, sums: &mut [Rgb]) -> u64 {
        let mut count = self.rays.len() as u64;
        if scene.photoreal.passes_sheets {
            count += self.walk(scene);
        } else {
            scene.accel.occluded(&self.rays, &mut self.blocked);
            for (leg, blocked) in self.legs.iter().zip(&self.blocked) {
                if *blocked {
                    self.tickets[leg.ticket as usize].light = Rgb::BLACK;
                }
            }
        }
        for ticket in &self.tickets {
            sums[ticket.pixel as usize] += ticket.light;
        }
        self.tickets.clear();
        self.legs.clear();
        self.rays.clear();
        count
    }

    /// The same where light passes thin sheets, and surfaces that something else hides.
    fn walk(&mut self, scene: &CompiledScene) -> u64 {
        let mut count = 0;
        for _ in 0..MOST_SHEETS {
            if self.rays.is_empty() {
                return count;
            }
            scene.accel.closest(&self.rays, &mut self.hits);
            self.spots.fill(scene, &self.rays, &self.hits);
            self.onward.clear();
            self.onward_legs.clear();
            for (i, leg) in self.legs.iter().enumerate() {
                let Some(hit) = self.hits.get(i) else { continue };
                let ray = self.rays.get(i);
                let light = &mut self.tickets[leg.ticket as usize].light;
                *light = *light * passed(scene, &self.spots, (i, &ray, hit), leg.medium);
                if *light != Rgb::BLACK {
                    self.onward.push_on(&ray, &hit);
                    self.onward_legs.push(*leg);
                }
            }
            std::mem::swap(&mut self.rays, &mut self.onward);
            std::mem::swap(&mut self.legs, &mut self.onward_legs);
            count += self.rays.len() as u64;
        }
        // What has still not arrived is lost in a heap of sheets.
        for leg in &self.legs {
            self.tickets[leg.ticket as usize].light = Rgb::BLACK;
        }
        count
    }
}

/// No ray starts farther out, metres: beyond it there is nothing but planes.
const FARTHEST_ORIGIN: f32 = 1e18;

/// Whether a ray can be traced: in scenes whose numbers are at the limit of floats some have no place or no direction.
#[inline]
pub fn is_traceable(origin: Vec3, direction: Vec3) -> bool {
    origin.abs().max_element() < FARTHEST_ORIGIN && (0.5..2.0).contains(&direction.length_squared())
}

/// The share of light that goes straight on through a surface.
fn passed(scene: &CompiledScene, spots: &Spots, (i, ray, hit): (usize, &Ray, Hit), medium: u16) -> Rgb {
    let photoreal = &scene.photoreal;
    let solid = photoreal.solids.of_primitive(hit.primitive);
    if solid != AIR {
        // Inside another solid that is there in its place.
        let is_hidden = medium != AIR && photoreal.solids.get(solid).rank > photoreal.solids.get(medium).rank;
        return if is_hidden { Rgb::WHITE } else { Rgb::BLACK };
    }
    let spot = spots.get(i, hit);
    let material = &scene.physical[spot.material as usize];
    if material.is_sheet() { material.passed_sheet(-ray.direction.dot(spot.ns)) } else { Rgb::BLACK }
}
