//! Wavefront MTL: the materials of OBJ models, as the course work's scales.
//!
//! | MTL | material |
//! |---|---|
//! | Kd | `color`, with `diffuse` 1 |
//! | Ks | its mean: `specular`; with illum 0 or 1 there are no highlights |
//! | Ns | `shininess` |
//! | d, or 1 − Tr | 1 − `transparency` |
//! | Tf | `transmission_color`, where it is transparent |
//! | Ni, with illum 4, 6 or 7 | `refraction` |
//! | Ks, with illum 3 to 9 | its mean: `reflectivity` |
//! | Ke | its largest number: `emission_luminance`; its hue: `emission_color` |
//! | map_Kd | the picture in place of the colour |
//!
//! Numbers out of range are brought into it. Everything else (Ka, bump, …) is left out.

use super::lines::{Lines, number, quote};
use crate::FormatError;
use std::path::{Path, PathBuf};
use vitrine_math::Rgb;
use vitrine_scene::{Material, MeshMaterial, ParamKind};

/// The most bytes of a file.
pub const MAX_FILE: u64 = 64 << 20;
/// The most lines that are reported; where one is wrong, many are.
const MAX_WARNINGS: usize = 5;

/// Reads a library of materials. `path` names it in messages. A line that is not understood is left out with a warning.
/// Pictures are named relative to the library's folder.
///
/// # Errors
/// When it is no text.
pub fn parse(bytes: &[u8], path: &Path) -> Result<(Vec<MeshMaterial>, Vec<String>), FormatError> {
    let mut lines = Lines::new(bytes, path);
    let mut entries: Vec<Entry> = Vec::new();
    let mut warnings = Vec::new();
    while let Some(line) = lines.next()? {
        let line = line.trim_ascii();
        let (word, rest) = line.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((line, ""));
        let rest = rest.trim_ascii();
        if word == "newmtl" {
            entries.push(Entry { name: rest.to_owned(), ..Entry::default() });
        } else if let Some(entry) = entries.last_mut()
            && entry.set(word, rest).is_none()
            && warnings.len() < MAX_WARNINGS
        {
            let warning = format!("{} is not understood", quote(line));
            warnings.push(format!("line {}: {warning}: {}", lines.number(), path.display()));
        }
    }
    let materials: Vec<_> = entries.into_iter().map(Entry::into_material).collect();
    let unseen = materials.iter().map(|m| &m.material).filter(|m| m.transparency >= Some(1.0));
    warnings.extend(unseen.take(MAX_WARNINGS).map(|m| {
        let name = quote(&m.name);
        format!(
            "material {name} is wholly transparent (d 0 or Tr 1), so it will not show: {}",
            path.display()
        )
    }));
    Ok((materials, warnings))
}

/// One material as the file states it.
#[derive(Default)]
struct Entry {
    name: String,
    kd: Option<Rgb>,
    ks: Option<Rgb>,
    ke: Option<Rgb>,
    tf: Option<Rgb>,
    ns: Option<f32>,
    ni: Option<f32>,
    d: Option<f32>,
    tr: Option<f32>,
    illum: Option<u32>,
    map_kd: Option<PathBuf>,
}

impl Entry {
    /// Takes a line over; None when it makes no sense. Lines that mean nothing here are taken and forgotten.
    fn set(&mut self, word: &str, rest: &str) -> Option<()> {
        match word {
            "Kd" => self.kd = Some(color(rest)?),
            "Ks" => self.ks = Some(color(rest)?),
            "Ke" => self.ke = Some(light(rest)?),
            "Tf" => self.tf = Some(color(rest)?),
            "Ns" => self.ns = Some(last_number(rest)?),
            "Ni" => self.ni = Some(last_number(rest)?),
            // "d -halo 0.5" thins out towards the edges, which we do not.
            "d" => self.d = Some(last_number(rest.trim_start_matches("-halo"))?),
            "Tr" => self.tr = Some(last_number(rest)?),
            "illum" => self.illum = Some(rest.split_ascii_whitespace().next()?.parse().ok()?),
            "map_Kd" | "map_kd" => self.map_kd = Some(picture(rest)?),
            _ => {}
        }
        Some(())
    }

    fn into_material(self) -> MeshMaterial {
        let illum = self.illum.unwrap_or(2);
        let ks = self.ks.map(|c| (c.r + c.g + c.b) / 3.0);
        // Many programs write "Ke 0 0 0" into every material.
        let emission = self.ke.map(|ke| (ke, ke.r.max(ke.g).max(ke.b))).filter(|(_, most)| *most > 0.0);
        let transparency = self.d.map(|d| 1.0 - d).or(self.tr).filter(|t| *t != 0.0);
        let material = Material {
            name: self.name,
            color: self.kd,
            diffuse: self.kd.map(|_| 1.0),
            specular: if illum < 2 { Some(0.0) } else { into_range("specular", ks) },
            shininess: into_range("shininess", self.ns),
            reflectivity: into_range("reflectivity", ks.filter(|_| (3..=9).contains(&illum))),
            transparency: into_range("transparency", transparency),
            transmission_color: self.tf.filter(|_| transparency.is_some()),
            refraction: into_range("refraction", self.ni.filter(|_| matches!(illum, 4 | 6 | 7))),
            emission_luminance: emission.map(|(_, most)| most),
            emission_color: emission.map(|(ke, most)| Rgb::new(ke.r / most, ke.g / most, ke.b / most)),
            ..Material::default()
        };
        MeshMaterial { material, picture: self.map_kd }
    }
}

/// Brings a number into the range that a parameter of materials allows.
fn into_range(name: &str, value: Option<f32>) -> Option<f32> {
    let spec = Material::SPECS.iter().find(|s| s.name == name);
    match spec.map(|s| s.kind) {
        Some(ParamKind::Number(range)) => value.map(|v| v.clamp(range.min, range.max)),
        _ => value,
    }
}

/// "r g b" or one number for all, brought into 0 to 1. None for spectra and colours as XYZ too.
fn color(rest: &str) -> Option<Rgb> {
    three(rest, 1.0)
}

/// The same of any brightness.
fn light(rest: &str) -> Option<Rgb> {
    three(rest, f32::MAX)
}

/// "r g b" or one number for all, brought into 0 to `most`.
fn three(rest: &str, most: f32) -> Option<Rgb> {
    let mut words = rest.split_ascii_whitespace().map(|w| number(w).map(|v| v.clamp(0.0, most)));
    let r = words.next()??;
    let g = words.next().unwrap_or(Some(r))?;
    let b = words.next().unwrap_or(Some(r))?;
    Some(Rgb::new(r, g, b))
}

fn last_number(rest: &str) -> Option<f32> {
    number(rest.split_ascii_whitespace().next()?)
}

/// The file of "-option value … file name with spaces.png".
fn picture(rest: &str) -> Option<PathBuf> {
    let mut rest = rest;
    while rest.starts_with('-') {
        let (option, mut after) = rest.split_once(|c: char| c.is_ascii_whitespace())?;
        // Offset, scale and turbulence have one to three numbers, the others a fixed count of words.
        let (least, most) = match option {
            "-o" | "-s" | "-t" => (1, 3),
            "-mm" => (2, 2),
            _ => (1, 1),
        };
        for i in 0..most {
            match after.trim_ascii_start().split_once(|c: char| c.is_ascii_whitespace()) {
                Some((value, next)) if i < least || number(value).is_some() => after = next,
                None if i < least => return None,
                _ => break,
            }
        }
        rest = after.trim_ascii_start();
    }
    let name = rest.trim_matches('"').replace('\\', "/");
    (!name.is_empty()).then(|| name.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(text: &str) -> MeshMaterial {
        let (mut materials, warnings) = parse(text.as_bytes(), Path::new("a.mtl")).unwrap();
        assert_eq!(warnings, [""; 0]);
        materials.pop().unwrap()
    }

    #[test]
    fn every_statement_lands_in_its_scale() {
        let glass =
            one("newmtl red glass\nKd 0.5 0.25 0.125\nKs 0.2 0.4 0.6\nNs 90\nd 0.25\nNi 1.5\nillum 7\n\
                         Tf 1 0 0\nmap_Kd -s 2 2 1 -clamp on tex\\a b.png\n");
        let expected = Material {
            name: "red glass".into(),
            color: Some(Rgb::new(0.5, 0.25, 0.125)),
            diffuse: Some(1.0),
            specular: Some(0.4),
            shininess: Some(90.0),
            reflectivity: Some(0.4),
            transparency: Some(0.75),
            transmission_color: Some(Rgb::new(1.0, 0.0, 0.0)),
            refraction: Some(1.5),
            ..Material::default()
        };
        assert_eq!(glass.material, expected);
        assert_eq!(glass.picture, Some("tex/a b.png".into()));
    }

    #[test]
    fn without_ray_traced_illumination_nothing_reflects_or_refracts() {
        let m = one("newmtl m\nKs 0.5 0.5 0.5\nNi 1.5\nillum 2").material;
        assert_eq!((m.specular, m.reflectivity, m.refraction), (Some(0.5), None, None));
        let m = one("newmtl m\nKs 0.5 0.5 0.5\nillum 1").material;
        assert_eq!(m.specular, Some(0.0));
        let mirror = one("newmtl m\nKs 0.5 0.5 0.5\nNi 1.5\nillum 3").material;
        assert_eq!((mirror.reflectivity, mirror.refraction), (Some(0.5), None));
    }

    #[test]
    fn what_shines_has_a_brightness_and_a_hue() {
        let lamp = one("newmtl lamp\nKd 1 1 1\nKe 10 5 0").material;
        assert_eq!(lamp.emission_luminance, Some(10.0));
        assert_eq!(lamp.emission_color, Some(Rgb::new(1.0, 0.5, 0.0)));
        let grey = one("newmtl m\nKe 0.25").material;
        assert_eq!((grey.emission_luminance, grey.emission_color), (Some(0.25), Some(Rgb::WHITE)));
        for dark in ["Ke 0 0 0", "Ke -1 -2 0"] {
            let m = one(&format!("newmtl m\n{dark}")).material;
            assert_eq!((m.emission_luminance, m.emission_color), (None, None), "{dark}");
        }
    }

    #[test]
    fn transparency_by_either_name_and_d_counts_more() {
        assert_eq!(one("newmtl m\nTr 0.25").material.transparency, Some(0.25));
        assert_eq!(one("newmtl m\nTr 0.25\nd 0.5").material.transparency, Some(0.5));
        assert_eq!(one("newmtl m\nd -halo 0.5").material.transparency, Some(0.5));
        assert_eq!(one("newmtl m\nd 1").material.transparency, None);
    }

    #[test]
    fn numbers_out_of_range_are_brought_into_it() {
        let m = one("newmtl m\nKd -1 2 0.5\nKs 9\nNs 0\nd 3\nNi 99\nillum 4").material;
        assert_eq!(m.color, Some(Rgb::new(0.0, 1.0, 0.5)));
        assert_eq!((m.specular, m.shininess, m.transparency), (Some(1.0), Some(1.0), Some(0.0)));
        assert_eq!(m.refraction, Some(4.0));
        assert_eq!(one("newmtl m\nNs 1e30").material.shininess, Some(10_000.0));
    }

    #[test]
    fn what_nobody_would_see_is_a_warning() {
        for line in ["d 0", "Tr 1", "Tr 7"] {
            let (materials, warnings) =
                parse(format!("newmtl m\n{line}").as_bytes(), Path::new("a.mtl")).unwrap();
            assert_eq!(materials[0].material.transparency, Some(1.0));
            assert!(warnings[0].starts_with("material `m` is wholly transparent"), "{warnings:?}");
        }
    }

    #[test]
    fn lines_that_make_no_sense_are_warnings_and_the_rest_counts() {
        let text =
            "Kd 1 1 1\nnewmtl a\nKd red\nNs\nd nan\nillum x\nmap_Kd\nKd spectral a.rfl\nKd 1 0 0\nwhat 7";
        let (materials, warnings) = parse(text.as_bytes(), Path::new("a.mtl")).unwrap();
        assert_eq!(materials[0].material.color, Some(Rgb::new(1.0, 0.0, 0.0)));
        assert_eq!(warnings.len(), MAX_WARNINGS);
        assert_eq!(warnings[0], "line 3: `Kd red` is not understood: a.mtl");
    }

    #[test]
    fn options_of_pictures_are_skipped() {
        for rest in ["a.png", "-o 1 a.png", "-s 1 1 1 a.png", "-mm 0 1 -blendu on a.png", "-bm 1.0 \"a.png\""]
        {
            assert_eq!(picture(rest), Some("a.png".into()), "{rest}");
        }
        assert_eq!(picture("-s 1 2 3.png"), Some("3.png".into()));
        assert_eq!(picture("-s 1"), None, "a file must be named");
        assert_eq!(picture("-clamp on"), None);
    }

    #[test]
    fn binary_junk_is_an_error() {
        assert!(parse(b"newmtl \0\x01", Path::new("a.mtl")).is_err());
    }
}
