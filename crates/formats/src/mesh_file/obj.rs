//! Wavefront OBJ: positions, texture coordinates, normals, polygons of any form, groups, materials (see [`mtl`]).
//!
//! The reader is our own, as a person with a broken file needs the number of the line, and none of the crates tells it.
//! Curves and free-form surfaces are left out with a warning.

use super::builder::{Corner, Lists, MeshBuilder};
use super::lines::{Lines, number, quote};
use super::{MeshFormat, Reading, mtl};
use crate::{FormatError, disc};
use std::collections::HashMap;
use std::io::{BufRead, BufReader};
use std::path::Path;
use vitrine_math::{Vec2, Vec3};
use vitrine_scene::{MeshMaterial, TriangleMesh};

/// The entry of the register.
pub const FORMAT: MeshFormat = MeshFormat { name: "Wavefront OBJ", extensions: &["obj"], read };

/// The most bytes of a file.
const MAX_FILE: u64 = 2 << 30;
/// The most corners of a polygon. To cut one takes time that can grow with the square of it.
const MAX_CORNERS: usize = 1 << 14;
/// The most libraries, so that a file cannot keep us busy with names.
const MAX_LIBRARIES: usize = 100;
/// The most names that one warning lists, and the most libraries that are reported.
const MAX_NAMES: usize = 5;

/// Where material libraries come from: the bytes of the file with that name, relative to the model's folder.
pub type Library<'a> = dyn FnMut(&str) -> Result<Vec<u8>, FormatError> + 'a;

fn read(path: &Path) -> Result<Reading, FormatError> {
    let source = BufReader::with_capacity(1 << 18, disc::open(path, MAX_FILE)?);
    let folder = path.parent().unwrap_or(Path::new(""));
    parse(source, path, &mut |name| disc::read(&folder.join(name), mtl::MAX_FILE))
}

/// Reads a model from any source. `path` names it in messages. A library that is missing or broken is a warning.
///
/// # Errors
/// When the source cannot be read, is no text, or what it says is no model; most name the line.
pub fn parse(source: impl BufRead, path: &Path, library: &mut Library) -> Result<Reading, FormatError> {
    let mut lines = Lines::new(source, path);
    let mut model = Model::default();
    while let Some(line) = lines.next()? {
        if let Err(Fault { reason, help }) = model.add_line(&line) {
            return Err(lines.fault(reason, help));
        }
    }
    model.finish(path, library)
}

/// What is wrong with a line and how to mend it.
struct Fault {
    reason: String,
    help: &'static str,
}

/// What has been read so far.
#[derive(Default)]
struct Model {
    lists: Lists,
    builder: MeshBuilder,
    corners: Vec<Corner>,
    /// The group or object and the material of what follows.
    name: String,
    material: Option<usize>,
    material_names: Vec<String>,
    material_of: HashMap<String, usize>,
    libraries: Vec<String>,
    faces: usize,
    bad_normals: usize,
    bad_uvs: usize,
    lines_and_points: usize,
    free_forms: usize,
}

impl Model {
    fn add_line(&mut self, line: &str) -> Result<(), Fault> {
        let line = line.trim_ascii();
        let (word, rest) = line.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((line, ""));
        let words = || rest.split_ascii_whitespace();
        match word {
            "v" => self.add_position(words())?,
            "vt" => self.add_uv(words()),
            "vn" => self.add_normal(words()),
            "f" | "fo" => self.add_face(words())?,
            "o" | "g" => self.name = rest.trim_ascii().to_owned(),
            "usemtl" => self.use_material(rest.trim_ascii()),
            "mtllib" => {
                let name = rest.trim_ascii().trim_matches('"').to_owned();
                if self.libraries.len() < MAX_LIBRARIES && !self.libraries.contains(&name) {
                    self.libraries.push(name);
                }
                return Ok(());
            }
            "l" | "p" => self.lines_and_points += 1,
            "curv" | "curv2" | "surf" => self.free_forms += 1,
            _ => {}
        }
        Ok(())
    }

    fn add_position<'a>(&mut self, mut words: impl Iterator<Item = &'a str>) -> Result<(), Fault> {
        let mut position = Vec3::ZERO;
        for axis in 0..3 {
            let Some(word) = words.next() else {
                return Err(Fault { reason: "a position lacks a coordinate".into(), help: POSITION_HELP });
            };
            position[axis] = number(word).ok_or_else(|| Fault {
                reason: format!("{} is not a finite number", quote(word)),
                help: if word.contains(',') { "write decimals with a point" } else { POSITION_HELP },
            })?;
        }
        self.lists.positions.push(position);
        Ok(())
    }

    fn add_uv<'a>(&mut self, mut words: impl Iterator<Item = &'a str>) {
        // The second may be missing for pictures with one row.
        let u = words.next().and_then(number);
        let v = words.next().map_or(Some(0.0), number);
        let uv = u.zip(v).map(Vec2::from);
        self.bad_uvs += usize::from(uv.is_none());
        self.lists.uvs.push(uv.unwrap_or_default());
    }

    fn add_normal<'a>(&mut self, mut words: impl Iterator<Item = &'a str>) {
        let [x, y, z] = [(); 3].map(|()| words.next().and_then(number));
        // In double precision no square overflows or vanishes.
        let normal =
            x.zip(y).zip(z).map(|((x, y), z)| Vec3::new(x, y, z).as_dvec3().normalize_or_zero().as_vec3());
        self.bad_normals += usize::from(normal.is_none());
        self.lists.normals.push(normal.unwrap_or_default());
    }

    fn add_face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), Fault> {
        self.corners.clear();
        for word in words.take_while(|w| !w.starts_with('#')) {
            if self.corners.len() == MAX_CORNERS {
                let reason = format!("a face has more than {MAX_CORNERS} corners");
                return Err(Fault { reason, help: "divide the face into smaller ones" });
            }
            let corner = self.corner(word)?;
            self.corners.push(corner);
        }
        if self.corners.len() < 3 {
            let reason = format!("a face has {} corners and needs 3 at least", self.corners.len());
            return Err(Fault { reason, help: FACE_HELP });
        }
        self.faces += 1;
        self.builder.begin_part(if self.name.is_empty() { "default" } else { &self.name }, self.material);
        self.builder.add_face(&self.lists, &self.corners);
        Ok(())
    }

    /// "position", "position/uv", "position//normal" or "position/uv/normal".
    fn corner(&self, word: &str) -> Result<Corner, Fault> {
        let mut fields = word.split('/');
        let position = fields.next().unwrap_or_default();
        let [uv, normal] = [(); 2].map(|()| fields.next().filter(|f| !f.is_empty()));
        if fields.next().is_some() {
            return Err(Fault { reason: format!("{} is no corner of a face", quote(word)), help: FACE_HELP });
        }
        let lists = &self.lists;
        Ok(Corner {
            position: index(position, "position", lists.positions.len())?,
            uv: uv.map(|f| index(f, "texture coordinate", lists.uvs.len())).transpose()?,
            normal: normal.map(|f| index(f, "normal", lists.normals.len())).transpose()?,
        })
    }

    fn use_material(&mut self, name: &str) {
        self.material = (!name.is_empty()).then(|| match self.material_of.get(name) {
            Some(known) => *known,
            None => {
                self.material_names.push(name.to_owned());
                self.material_of.insert(name.to_owned(), self.material_names.len() - 1);
                self.material_names.len() - 1
            }
        });
    }

    fn finish(self, path: &Path, library: &mut Library) -> Result<Reading, FormatError> {
        let (mut mesh, flat_faces) = self.builder.finish();
        if mesh.triangles.is_empty() {
            let (reason, help) = match self.faces {
                0 => ("there is no face in this model", "export the model as OBJ with its faces"),
                _ => ("no face of this model has an area", "check the model in the program that made it"),
            };
            return Err(FormatError::Model { path: path.into(), reason: reason.into(), help: help.into() });
        }
        let mut warnings = Vec::new();
        let mut warn = |count: usize, what: &str| {
            if count > 0 {
                warnings.push(format!("{count} {what}: {}", path.display()));
            }
        };
        warn(flat_faces, "faces have no area and are left out");
        warn(self.bad_normals, "normals are not three finite numbers and are left out");
        warn(self.bad_uvs, "texture coordinates are not finite numbers and count as 0 0");
        warn(self.lines_and_points, "lines and points are left out, as only faces are shown");
        warn(self.free_forms, "curves and free-form surfaces are left out, as only faces are shown");
        let found = read_libraries(&self.libraries, path, library, &mut warnings);
        let any_library = !found.is_empty();
        let missing = take_materials(&mut mesh, &self.material_names, found);
        // Without any library nobody expects its materials, or has been told.
        if any_library && !missing.is_empty() {
            let more = if missing.len() > MAX_NAMES { ", …" } else { "" };
            let names: Vec<_> = missing.iter().take(MAX_NAMES).map(|n| quote(n)).collect();
            warnings.push(format!("there is no material {}{more}: {}", names.join(", "), path.display()));
        }
        Ok((mesh, warnings))
    }
}

const POSITION_HELP: &str = "a position is `v` and three finite numbers, such as v 0.5 1 -2";
const FACE_HELP: &str = "a face is `f` and three or more corners, such as f 1 2 3 or f 1/1/1 2/2/1 3/3/1";
const INDEX_HELP: &str = "corners name what stands above them, counted from 1, or from the end by -1, -2, …";

/// The place in a list that a number names: counted from 1, or from the list's end when negative.
fn index(word: &str, what: &str, count: usize) -> Result<u32, Fault> {
    let stated: i64 = word.parse().map_err(|_| Fault {
        reason: format!("{} is no number of a {what}", quote(word)),
        help: FACE_HELP,
    })?;
    let place = match stated {
        1.. => stated - 1,
        // 0 lands behind the end.
        _ => stated.saturating_add_unsigned(count as u64),
    };
    if (0..count as i64).contains(&place) {
        // A file of 2 GB cannot list 4 billion entries.
        return Ok(place as u32);
    }
    let reason = match stated {
        0 => format!("a face names {what} 0, and counting starts at 1"),
        _ => format!("a face names {what} {stated}, and {count} stand above it"),
    };
    Err(Fault { reason, help: INDEX_HELP })
}

/// The materials of all libraries by name, and a warning for each that cannot be read. The first of a name counts.
fn read_libraries(
    names: &[String],
    path: &Path,
    library: &mut Library,
    warnings: &mut Vec<String>,
) -> HashMap<String, MeshMaterial> {
    let mut found = HashMap::new();
    let mut read = |name: &str| {
        let name = name.replace('\\', "/");
        let result = library(&name).and_then(|bytes| mtl::parse(&bytes, &path.with_file_name(&name)));
        result.map(|(materials, mut notes)| {
            warnings.append(&mut notes);
            for mut material in materials {
                // Pictures are named relative to the library's folder.
                material.picture = material.picture.map(|p| Path::new(&name).with_file_name("").join(p));
                found.entry(material.material.name.clone()).or_insert(material);
            }
        })
    };
    let mut faults = Vec::new();
    for name in names {
        // One name, which may hold spaces, or several names.
        let Err(fault) = read(name) else { continue };
        match name.split_once(char::is_whitespace) {
            Some(_) => {
                let names = name.split_whitespace().take(MAX_LIBRARIES);
                faults.extend(names.filter_map(|n| read(n).err()));
            }
            None => faults.push(fault),
        }
    }
    warnings.extend(faults.iter().take(MAX_NAMES).map(|f| format!("the model's materials are missing, {f}")));
    found
}

/// Gives the model those of the materials that its parts use, and returns the names of those that are missing.
fn take_materials<'a>(
    mesh: &mut TriangleMesh,
    names: &'a [String],
    mut found: HashMap<String, MeshMaterial>,
) -> Vec<&'a str> {
    // For each name: not met yet, met and missing, or its place.
    let mut places: Vec<Option<Option<usize>>> = vec![None; names.len()];
    let mut missing = Vec::new();
    for part in &mut mesh.parts {
        let Some(name) = part.material else { continue };
        part.material = *places[name].get_or_insert_with(|| match found.remove(&names[name]) {
            Some(material) => {
                mesh.materials.push(material);
                Some(mesh.materials.len() - 1)
            }
            None => {
                missing.push(names[name].as_str());
                None
            }
        });
    }
    missing
}

#[cfg(test)]
mod tests;
