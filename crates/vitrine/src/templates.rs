//! Scenes to begin with, carried inside the program: an empty floor, scenes behind glass, the experiments of the
//! course work.
//!
//! A new template is a scene file under `scenes/` and one line in [`TEMPLATES`].

use crate::{Error, formats};
use std::fs;
use std::path::{Path, PathBuf};

/// A scene that the program carries, with the files it needs.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    /// Its name: "two-mirror-spheres".
    pub name: &'static str,
    /// The text of its scene file in the project's own folder.
    source: &'static str,
    /// Models and pictures: the path as the scene writes it, and the bytes.
    pub assets: &'static [(&'static str, &'static [u8])],
}

macro_rules! template {
    ($folder:literal, $name:literal $(, $asset:literal)*) => {
        Template {
            name: $name,
            source: include_str!(concat!("../../../scenes/", $folder, $name, ".vitrine.toml")),
            assets: &[$(($asset, include_bytes!(concat!("../../../scenes/", $folder, $asset))),)*],
        }
    };
}

/// The register of templates: the folder under `scenes/`, the name, the files that the scene needs.
pub const TEMPLATES: &[Template] = &[
    template!("", "empty"),
    template!("", "display-case", "models/vase.obj", "models/goblet.obj", "textures/vitrine-wood.png"),
    template!(
        "",
        "shop-window",
        "models/vase.obj",
        "textures/vitrine-brick.png",
        "textures/vitrine-wood.png"
    ),
    template!("", "aquarium", "textures/vitrine-wood.png"),
    template!("", "glass-ball"),
    template!("", "snow-globe", "models/cone.obj", "models/foot.obj", "textures/vitrine-wood.png"),
    template!(
        "",
        "bottle-still-life",
        "models/bottle.obj",
        "models/goblet.obj",
        "textures/vitrine-marble.png"
    ),
    template!("coursework/", "benchmark", "models/cone-160.obj", "models/cone-162.obj"),
    template!("coursework/", "transparent-sphere", "models/cone-160.obj"),
    template!("coursework/", "two-mirror-spheres"),
    template!("coursework/", "textured-sphere", "textures/globe.png"),
    template!("coursework/", "textured-triangle", "textures/leaded-window.png"),
    template!("coursework/", "soft-shadows", "models/cone-160.obj"),
];

/// What to do with a file that is there already and differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// Leave everything as it is and return an error.
    Keep,
    /// Replace it.
    Replace,
}

impl Template {
    /// The template of that name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        TEMPLATES.iter().find(|t| t.name == name)
    }

    /// The text of the scene file. The first line of the project's own files points to the schema in the project's own
    /// folder, which is nowhere else; it is left out.
    #[must_use]
    pub fn text(&self) -> &'static str {
        match self.source.split_once('\n') {
            Some((first, rest)) if first.starts_with("#:schema") => rest,
            _ => self.source,
        }
    }

    /// What it shows, in one line.
    #[must_use]
    pub fn about(&self) -> String {
        let path = PathBuf::from(format!("{}.vitrine.toml", self.name));
        formats::SceneFile::parse(&path, self.text())
            .map(|file| file.scene().about.clone())
            .unwrap_or_default()
    }

    /// Writes the scene as `file` and its models and pictures into the folders beside it. Files that are there and the
    /// same already are left alone. Returns what has been written, the scene last.
    ///
    /// # Errors
    /// When a file with other content is in the way and `existing` says to keep it (then nothing has been written), or
    /// when a file cannot be written.
    pub fn write(&self, file: &Path, existing: Existing) -> Result<Vec<PathBuf>, Error> {
        let folder = file.parent().unwrap_or(Path::new(""));
        let assets = self.assets.iter().map(|(path, bytes)| (folder.join(path), *bytes));
        let mut wanted: Vec<_> = assets.chain([(file.to_owned(), self.text().as_bytes())]).collect();
        wanted.retain(|(path, bytes)| fs::read(path).map_or(true, |there| there != *bytes));
        if existing == Existing::Keep
            && let Some((path, _)) = wanted.iter().find(|(path, _)| path.symlink_metadata().is_ok())
        {
            return Err(Error::InTheWay { path: path.clone() });
        }
        for (path, bytes) in &wanted {
            if let Some(parent) = path.parent().filter(|p| *p != folder) {
                fs::create_dir_all(parent)
                    .map_err(|source| Error::Folder { path: parent.to_owned(), source })?;
            }
            formats::write_atomically(path, bytes)?;
        }
        Ok(wanted.into_iter().map(|(path, _)| path).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WITH_MODEL: Template = Template {
        name: "t",
        source: "#:schema ../x.json\nformat = 1\nabout = \"a test\"\n",
        assets: &[("models/a.obj", b"v 0 0 0\n"), ("textures/b.png", b"png")],
    };

    #[test]
    fn names_are_unique_and_everyone_says_what_it_shows() {
        for (i, template) in TEMPLATES.iter().enumerate() {
            assert!(TEMPLATES[..i].iter().all(|t| t.name != template.name), "{} twice", template.name);
            assert!(!template.about().is_empty(), "{}", template.name);
            assert!(Template::find(template.name).is_some_and(|found| found.source == template.source));
        }
        assert_eq!(WITH_MODEL.about(), "a test");
        assert_eq!(WITH_MODEL.text(), "format = 1\nabout = \"a test\"\n");
    }

    #[test]
    fn what_a_scene_needs_is_written_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("mine.vitrine.toml");
        let written = WITH_MODEL.write(&file, Existing::Keep).unwrap();
        assert_eq!(written.len(), 3);
        assert_eq!(written.last(), Some(&file));
        assert_eq!(fs::read(folder.path().join("models/a.obj")).unwrap(), b"v 0 0 0\n");
        assert!(WITH_MODEL.write(&file, Existing::Keep).unwrap().is_empty(), "all is there");
    }

    #[test]
    fn nothing_is_written_when_one_file_is_in_the_way() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("mine.vitrine.toml");
        let model = folder.path().join("models/a.obj");
        fs::create_dir(folder.path().join("models")).unwrap();
        fs::write(&model, "another").unwrap();
        let error = WITH_MODEL.write(&file, Existing::Keep).unwrap_err();
        assert!(matches!(&error, Error::InTheWay { path } if *path == model), "{error}");
        assert!(!file.exists() && fs::read(&model).unwrap() == b"another");
        WITH_MODEL.write(&file, Existing::Replace).unwrap();
        assert_eq!(fs::read(&model).unwrap(), b"v 0 0 0\n");
    }
}
