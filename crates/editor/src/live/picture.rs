//! Pictures ready to be shown, and the map of what is seen in each of their pixels.

use std::sync::Arc;
use std::time::Duration;
use vitrine::film::{Display, Film};
use vitrine::math::Vec3;
use vitrine::render::NO_OBJECT;
use vitrine::scene::Scene;

/// Which picture it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The one that follows every edit.
    Live,
    /// The final render.
    Final,
}

/// A picture to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The generation of the request that it answers.
    pub generation: u64,
    /// Which picture it is.
    pub source: Source,
    /// Width and height in pixels; coarse pictures are smaller than the view.
    pub size: [u32; 2],
    /// Red, green, blue and full opacity, 8 bits each, row by row from the top.
    pub rgba: Vec<u8>,
    /// Which pass it comes from, counted from 1.
    pub pass: u32,
    /// How many passes there will be.
    pub passes: u32,
    /// Samples that every pixel has, at least.
    pub samples: u32,
    /// Whether nothing finer will follow.
    pub is_final: bool,
    /// From the request to this picture.
    pub elapsed: Duration,
    /// From the request to its first picture.
    pub first_picture_after: Duration,
}

/// The object that is seen in each pixel.
#[derive(Clone, Debug)]
pub struct ObjectMap {
    /// The generation of the request that it belongs to.
    pub generation: u64,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Indices of objects in the scene's list, row by row; [`NO_OBJECT`] where there is none.
    pub objects: Vec<u32>,
    /// The same with what is seen behind all that is transparent.
    pub behind_glass: Vec<u32>,
    /// The scene whose objects they are.
    pub scene: Arc<Scene>,
}

impl ObjectMap {
    /// The name of the object that is seen in a pixel.
    #[must_use]
    pub fn name(&self, x: u32, y: u32) -> Option<&str> {
        let inside = x < self.size[0] && y < self.size[1];
        let place = y as usize * self.size[0] as usize + x as usize;
        let index = *self.objects.get(place).filter(|_| inside)?;
        if index == NO_OBJECT {
            return None;
        }
        self.scene.objects.get(index as usize).map(|o| o.name.as_str())
    }
}

/// What lies under a point of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// The object's name.
    pub name: String,
    /// Where its surface is, world space, metres.
    pub point: Vec3,
    /// From the camera, metres.
    pub distance: f32,
    /// The unit normal on the camera's side.
    pub n: Vec3,
}

/// What stands in a picture where there is no sample yet.
#[derive(Clone, Copy)]
pub struct Backdrop<'a> {
    /// Width and height.
    pub size: [u32; 2],
    /// The earlier picture.
    pub rgba: &'a [u8],
}

/// A film as it is shown; where it has no sample yet stands what was there before.
#[must_use]
pub fn shown(film: &Film, display: &Display, backdrop: Option<Backdrop>) -> Vec<u8> {
    let rgb = display.to_u8(&film.image());
    let mut rgba = Vec::with_capacity(rgb.len() / 3 * 4);
    for pixel in rgb.chunks_exact(3) {
        rgba.extend_from_slice(&[pixel[0], pixel[1], pixel[2], u8::MAX]);
    }
    let region = film.region();
    let size = [region.width, region.height];
    if let Some(backdrop) = backdrop {
        let empty = Film::tiles(region).zip(film.tile_samples()).filter(|(_, samples)| **samples == 0);
        for (tile, _) in empty {
            for y in tile.y..tile.y + tile.height {
                for x in tile.x..tile.x + tile.width {
                    let to = 4 * (y as usize * size[0] as usize + x as usize);
                    rgba[to..to + 4].copy_from_slice(&backdrop.at([x, y], size));
                }
            }
        }
    }
    rgba
}

impl Backdrop<'_> {
    /// What lies at the place of a pixel of a picture of another size, blended between the nearest pixels.
    fn at(&self, at: [u32; 2], size: [u32; 2]) -> [u8; 4] {
        let [(left, right, across), (top, bottom, down)] = [0, 1].map(|axis| {
            let last = self.size[axis].saturating_sub(1);
            let place = (at[axis] as f32 + 0.5) * self.size[axis] as f32 / size[axis].max(1) as f32 - 0.5;
            let place = place.clamp(0.0, last as f32);
            let first = place as u32;
            (first, (first + 1).min(last), place - first as f32)
        });
        let rows = [top, bottom].map(|y| {
            let [a, b] = [left, right].map(|x| self.pixel(x, y));
            std::array::from_fn::<f32, 4, _>(|i| mix(a[i].into(), b[i].into(), across))
        });
        std::array::from_fn(|i| mix(rows[0][i], rows[1][i], down).round() as u8)
    }

    fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        let place = 4 * (y as usize * self.size[0] as usize + x as usize);
        self.rgba.get(place..place + 4).and_then(|p| p.try_into().ok()).unwrap_or([0, 0, 0, u8::MAX])
    }
}

fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::Region;
    use vitrine::film::TileSums;
    use vitrine::math::Rgb;

    #[test]
    fn what_has_no_sample_yet_shows_the_earlier_picture() {
        let mut film = Film::new(Region::whole([64, 32]));
        let white = vec![Rgb::WHITE; 32 * 32];
        film.bands().next().unwrap().add_samples(0, TileSums::of_light(&white), 1);
        let earlier = [1, 2, 3, 255, 5, 6, 7, 255];
        let rgba = shown(&film, &Display::default(), Some(Backdrop { size: [2, 1], rgba: &earlier }));
        assert_eq!(rgba.len(), 64 * 32 * 4);
        assert_eq!(rgba[..4], [255; 4], "a sample");
        assert_eq!(rgba[4 * 63..4 * 64], [5, 6, 7, 255], "the right end of the earlier picture");
        assert_eq!(rgba[4 * 32..4 * 33], [3, 4, 5, 255], "halfway between its two pixels");
        assert_eq!(shown(&film, &Display::default(), None)[4 * 32..4 * 33], [0, 0, 0, 255]);
    }
}
