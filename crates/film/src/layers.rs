//! What a film may keep of a pixel beside its light: for denoisers, compositors and the estimate of noise.

use crate::{Film, Image};
use vitrine_math::{Rgb, Vec3};

/// What a denoiser and a compositor want to know of a pixel beside its light; all zero where nothing is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Features {
    /// The colour of what is seen, as if evenly lit.
    pub albedo: Rgb,
    /// Its normal, world space, of unit length for one sample.
    pub normal: Vec3,
    /// How far away it is, metres.
    pub depth: f32,
}

impl Features {
    /// Adds the colour and the normal of more samples. The depth stays: one between two surfaces would be that of neither.
    #[inline]
    pub(crate) fn add_blended(&mut self, more: &Self) {
        self.albedo += more.albedo;
        self.normal += more.normal;
    }
}

/// How much a film keeps beside the sums of light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Keep {
    /// Nothing.
    #[default]
    Light,
    /// A second sum of light, of every other block of samples: enough for [`Film::noise`].
    Halves,
    /// That and [`Features`].
    Layers,
}

/// The sums of one block of samples over a tile, row by row.
#[derive(Clone, Copy, Debug)]
pub struct TileSums<'a> {
    /// The light, a sum for each pixel.
    pub light: &'a [Rgb],
    /// The features, sums too; empty where a renderer makes none.
    pub features: &'a [Features],
}

impl<'a> TileSums<'a> {
    /// Light alone.
    #[must_use]
    pub const fn of_light(light: &'a [Rgb]) -> Self {
        Self { light, features: &[] }
    }
}

/// The layers of a picture beside its light, each row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Layers {
    /// The mean colour of what each pixel shows, as if evenly lit.
    pub albedo: Image,
    /// The mean normal, world space; shorter than 1 at edges.
    pub normal: Vec<Vec3>,
    /// The distance of what the first sample of each pixel sees, metres; 0 where that is nothing.
    pub depth: Vec<f32>,
    /// How many samples each pixel has.
    pub samples: Vec<u32>,
}

impl Film {
    /// The layers that it keeps; None unless it keeps features.
    #[must_use]
    pub fn layers(&self) -> Option<Layers> {
        if self.keep() < Keep::Layers {
            return None;
        }
        let samples = self.pixel_samples();
        let features = &self.parts().features;
        let mean = |(f, &count): (&Features, &u32)| {
            let count = count.max(1) as f32;
            (f.albedo / count, f.normal / count)
        };
        let (pixels, normal) = features.iter().zip(&samples).map(mean).unzip();
        let region = self.region();
        let albedo = Image { size: [region.width, region.height], pixels };
        let depth = features.iter().map(|f| f.depth).collect();
        Some(Layers { albedo, normal, depth, samples })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Region;

    fn seen(depth: f32) -> Features {
        Features { albedo: Rgb::splat(0.5), normal: Vec3::Z, depth }
    }

    #[test]
    fn colours_and_normals_are_means_and_the_depth_is_the_first_samples() {
        let mut film = Film::with_layers(Region::whole([2, 1]));
        let mut add = |features: [Features; 2], count| {
            let light = [Rgb::WHITE; 2];
            let sums = TileSums { light: &light, features: &features };
            film.bands().next().unwrap().add_samples(0, sums, count);
        };
        add([seen(3.0), Features::default()], 1);
        add([seen(5.0), seen(4.0)], 1);
        let twice = Features { albedo: Rgb::WHITE, normal: Vec3::X * 2.0, depth: 18.0 };
        add([twice, Features::default()], 2);
        let layers = film.layers().unwrap();
        assert_eq!(layers.albedo.pixels, [Rgb::splat(0.5), Rgb::splat(0.125)]);
        assert_eq!(layers.normal, [Vec3::new(0.5, 0.0, 0.5), Vec3::Z * 0.25]);
        assert_eq!(layers.depth, [3.0, 0.0]);
        assert_eq!(layers.samples, [4, 4]);
        assert_eq!(film.image().pixels, [Rgb::splat(0.75); 2]);
    }

    #[test]
    fn films_without_features_have_no_layers() {
        let region = Region::whole([2, 1]);
        assert_eq!(Film::new(region).layers(), None);
        assert_eq!(Film::keeping(region, Keep::Halves).layers(), None);
        // A renderer without features may fill a film with layers: they stay empty.
        let mut film = Film::with_layers(region);
        film.bands().next().unwrap().add_samples(0, TileSums::of_light(&[Rgb::WHITE; 2]), 1);
        assert_eq!(film.layers().unwrap().depth, [0.0; 2]);
    }
}
