//! What can go wrong before a picture is rendered.

use crate::compile::FARTHEST;
use vitrine_film::RegionError;

/// Why a scene cannot be made ready.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CompileError {
    /// A model that an object needs is not among the assets.
    #[error("the model of the object `{object}` has not been loaded")]
    MissingModel {
        /// The object.
        object: String,
    },
    /// A picture that a texture needs is not among the assets.
    #[error("the picture of the texture `{texture}` has not been loaded")]
    MissingPicture {
        /// The texture, or the model's material.
        texture: String,
    },
    /// A panorama that a light needs is not among the assets.
    #[error("the panorama of the light `{light}` has not been loaded")]
    MissingPanorama {
        /// The light.
        light: String,
    },
    /// A name that the scene does not have.
    #[error("`{owner}` refers to `{name}`, which the scene does not have")]
    MissingName {
        /// What refers to it.
        owner: String,
        /// The name.
        name: String,
    },
    /// Coordinates so large that products of them leave the range of 32-bit floats.
    #[error(
        "the object `{object}` is too large or too far away: no part of it may be beyond {FARTHEST:e} metres"
    )]
    OutOfRange {
        /// The object.
        object: String,
    },
    /// Edges or scales so small that their inverses leave the range of 32-bit floats.
    #[error("the object `{object}` is too small or too thin to compute with")]
    TooThin {
        /// The object.
        object: String,
    },
    /// A model that makes no sense.
    #[error("the model of the object `{object}` cannot be used: {flaw}")]
    BadModel {
        /// The object.
        object: String,
        /// What is wrong with the model.
        flaw: ModelFlaw,
    },
    /// A model whose tree would not fit into memory.
    #[error(
        "the model of the object `{object}` is too large: with {triangles} triangles it would bring the scene to {} of memory, and {} may be taken",
        bytes(*needed), bytes(*allowed)
    )]
    TooMuchMemory {
        /// The object.
        object: String,
        /// How many triangles the model has.
        triangles: usize,
        /// Bytes that the trees would take, those before it and this one while it is built.
        needed: u64,
        /// The most bytes that they may take.
        allowed: u64,
    },
    /// More triangles than an index can count.
    #[error("the model of the object `{object}` has too many triangles ({triangles})")]
    TooManyTriangles {
        /// The object.
        object: String,
        /// How many.
        triangles: usize,
    },
}

impl CompileError {
    /// What can be done about it; empty where the message says all.
    #[must_use]
    pub const fn help(&self) -> &'static str {
        match self {
            Self::MissingModel { .. }
            | Self::MissingPicture { .. }
            | Self::MissingPanorama { .. }
            | Self::MissingName { .. } => "",
            Self::OutOfRange { .. } => "lengths are in metres: make it smaller or bring it nearer",
            Self::TooThin { .. } => "give it some thickness, or a scale that is not so close to 0",
            Self::BadModel { .. } => "make the model anew; those read from files have no such faults",
            Self::TooMuchMemory { .. } => {
                "show fewer models or some with fewer triangles, or take a machine with more memory; objects that show the same file share its memory"
            }
            Self::TooManyTriangles { .. } => "divide it into several models",
        }
    }
}

/// So many bytes in words.
fn bytes(count: u64) -> String {
    let (unit, name) = if count < 1 << 30 { (1_u64 << 20, "MiB") } else { (1 << 30, "GiB") };
    format!("{:.1} {name}", count as f64 / unit as f64)
}

/// What can be wrong with a model. Models that have been read from files have none of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ModelFlaw {
    /// A coordinate is infinite or no number.
    #[error("a vertex is at no finite place")]
    Position,
    /// Normals that are no numbers, or not one for each vertex.
    #[error("its normals are not finite or not one for each vertex")]
    Normals,
    /// Coordinates for pictures that are no numbers, or not one pair for each vertex.
    #[error("its texture coordinates are not finite or not one pair for each vertex")]
    Uvs,
    /// A corner that is none of the vertices.
    #[error("triangle {triangle} has a corner that is no vertex")]
    Corner {
        /// The triangle, counted from 0.
        triangle: usize,
    },
    /// A part with triangles or a material that the model does not have.
    #[error("part {part} has triangles or a material that the model does not have")]
    Part {
        /// The part, counted from 0.
        part: usize,
    },
}

/// Why a job cannot be started.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// The region is not a part of the picture.
    #[error(transparent)]
    Region(#[from] RegionError),
    /// A film that another job has left.
    #[error("the picture so far belongs to other settings")]
    OtherFilm,
    /// A film whose samples are cut into other blocks, or that has more of them than wanted.
    #[error(
        "a part of the picture so far has {samples} samples for each pixel, and a picture of {wanted} cannot go on from there"
    )]
    OtherBlocks {
        /// Samples of each pixel of the part.
        samples: u32,
        /// Samples that each pixel is to have.
        wanted: u32,
    },
    /// The picture is too large.
    #[error("a picture of {width} × {height} pixels is too large: {limit} pixels at most")]
    TooLarge {
        /// Pixels.
        width: u32,
        /// Pixels.
        height: u32,
        /// The most pixels that a picture may have.
        limit: u64,
    },
}
