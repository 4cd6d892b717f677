//! State files: a render that was stopped, so that it can go on to the same picture.
//!
//! ```text
//! "VITRSTAT", version of the format                                      8 + 4 bytes
//! lengths of the two texts, flags, region, numbers                       see `Header`
//! program and scene, line by line; settings, line by line                UTF-8
//! light, counts, half, half counts, features                             32-bit numbers, little-endian
//! checksum of all before it                                              8 bytes
//! ```
//!
//! A state belongs to one machine and one night, not to an archive: any other version is refused. The sums are noise to the last
//! digits, which no compression makes much smaller, so they are stored as they are.

mod bytes;

use crate::atomic::write_through;
use crate::{FormatError, disc};
use bytes::{Reader, Writer};
use std::path::{Path, PathBuf};
use vitrine_film::{Features, Film, FilmParts, Region};
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::Settings;

const MAGIC: &[u8; 8] = b"VITRSTAT";
/// The version of the format.
const VERSION: u32 = 1;
/// The most bytes of a file: the largest picture with all layers.
const MAX_FILE: u64 = 8 << 30;
/// The most bytes of a text. Settings take some hundred.
const MAX_TEXT: u32 = 1 << 16;

/// What a state file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderState {
    /// The program's version.
    pub program: String,
    /// The mark of the scene, without what may change from one start to the next.
    pub scene: String,
    /// The settings, a line for each: "name = value".
    pub settings: String,
    /// The picture so far.
    pub film: Film,
    /// Rays that it took.
    pub rays: u64,
    /// Samples that were left out.
    pub bad_samples: u64,
    /// Milliseconds that it took.
    pub spent_ms: u64,
}

/// Writes a state file: all of it or nothing.
///
/// # Errors
/// [`FormatError::MissingFolder`], [`FormatError::DiscFull`], [`FormatError::Unwritable`]; then what was there is unchanged.
pub fn write_state(path: &Path, state: &RenderState) -> Result<(), FormatError> {
    write_through(&part_of(path), path, &encode_state(state))
}

/// Where a state file stands while it is being written.
#[must_use]
pub fn part_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

/// Reads a state file.
///
/// # Errors
/// When the file cannot be read, is no state file, one of another version, or damaged.
pub fn read_state(path: &Path) -> Result<RenderState, FormatError> {
    parse_state(&disc::read(path, MAX_FILE)?, path)
}

/// The bytes of a state file.
#[must_use]
pub fn encode_state(state: &RenderState) -> Vec<u8> {
    let FilmParts { region, light, counts, half, half_counts, features } = state.film.parts();
    let head = format!("{}\n{}", state.program, state.scene);
    let pixels = region.pixels() * 13 * 4;
    let mut to = Writer::with_capacity(pixels + state.settings.len() + 1024);
    to.bytes(MAGIC);
    to.u32s([VERSION, head.len() as u32, state.settings.len() as u32]);
    to.u32s([u32::from(!half.is_empty()), u32::from(!features.is_empty())]);
    to.u32s([region.x, region.y, region.width, region.height]);
    [state.rays, state.bad_samples, state.spent_ms].into_iter().for_each(|v| to.u64(v));
    to.bytes(head.as_bytes());
    to.bytes(state.settings.as_bytes());
    to.f32s(light.as_flattened().iter().copied());
    to.u32s(counts.iter().copied());
    to.f32s(half.as_flattened().iter().copied());
    to.u32s(half_counts.iter().copied());
    for f in features {
        let Features { albedo: Rgb { r, g, b }, normal, depth } = *f;
        to.f32s([r, g, b, normal.x, normal.y, normal.z, depth]);
    }
    to.finish()
}

/// As [`read_state`], from the bytes of a file. `path` names it in messages.
///
/// # Errors
/// As [`read_state`], the disc's apart.
pub fn parse_state(bytes: &[u8], path: &Path) -> Result<RenderState, FormatError> {
    let path = || path.to_path_buf();
    if !bytes.starts_with(MAGIC) {
        return Err(FormatError::NotAState { path: path() });
    }
    let version = bytes.get(8..12).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes);
    match version {
        None => return Err(FormatError::StateDamaged { path: path() }),
        Some(VERSION) => {}
        Some(_) => return Err(FormatError::StateOfOtherVersion { path: path() }),
    }
    let state = bytes::checked(bytes).and_then(|checked| {
        let mut from = Reader::new(checked.get(12..)?);
        let state = read(&mut from)?;
        from.is_empty().then_some(state)
    });
    state.ok_or_else(|| FormatError::StateDamaged { path: path() })
}

/// The header's numbers.
struct Header {
    /// Bytes of the two texts.
    texts: [usize; 2],
    has_half: bool,
    has_features: bool,
    region: Region,
}

impl Header {
    fn read(from: &mut Reader) -> Option<Self> {
        let [head, settings, half, features] = from.u32s()?;
        let [x, y, width, height] = from.u32s()?;
        let is_flag = |v: u32| v <= 1;
        // A region of sane size: its lists are read only if the file has as many bytes, but their lengths must not overflow.
        let pixels = u64::from(width) * u64::from(height);
        let is_sound = head.max(settings) <= MAX_TEXT
            && is_flag(half)
            && is_flag(features)
            && (1..=Settings::MAX_PIXELS).contains(&pixels)
            && x.checked_add(width).is_some()
            && y.checked_add(height).is_some();
        is_sound.then_some(Self {
            texts: [head as usize, settings as usize],
            has_half: half == 1,
            has_features: features == 1,
            region: Region { x, y, width, height },
        })
    }
}

/// What follows the version.
fn read(from: &mut Reader) -> Option<RenderState> {
    let header = Header::read(from)?;
    let [rays, bad_samples, spent_ms] = [from.u64()?, from.u64()?, from.u64()?];
    let head = from.text(header.texts[0])?;
    let (program, scene) = head.split_once('\n')?;
    let settings = from.text(header.texts[1])?.to_owned();
    let region = header.region;
    let (pixels, tiles) = (region.pixels(), Film::tile_count(region));
    let only_if = |wanted: bool, length: usize| if wanted { length } else { 0 };
    let light = from.columns(pixels)?;
    let counts = from.u32_list(tiles)?;
    let half = from.columns(only_if(header.has_half, pixels))?;
    let half_counts = from.u32_list(only_if(header.has_half, tiles))?;
    let feature = |[r, g, b, x, y, z, depth]: [f32; 7]| Features {
        albedo: Rgb::new(r, g, b),
        normal: Vec3::new(x, y, z),
        depth,
    };
    let features = from.columns(only_if(header.has_features, pixels))?.into_iter().map(feature).collect();
    let film = Film::from_parts(FilmParts { region, light, counts, half, half_counts, features })?;
    let (program, scene) = (program.to_owned(), scene.to_owned());
    Some(RenderState { program, scene, settings, film, rays, bad_samples, spent_ms })
}

/// Puts the right checksum at the end of bytes that may be anything, for those who look for bytes that break the reader.
pub fn mend_checksum(bytes: &mut [u8]) {
    bytes::mend(bytes);
}

#[cfg(test)]
mod tests;
