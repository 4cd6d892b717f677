//! The material library: scene files with materials only, one file for each category. A new material is a few lines of such
//! a file and its name in the locales.

use crate::document::Paint;
use crate::tr;
use std::path::Path;
use std::sync::OnceLock;
use vitrine::formats::SceneFile;

/// What materials belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    /// Glass and liquids.
    Glass,
    /// Mirrors and metals.
    Metal,
    /// Plastic, ceramic, paint.
    Plastic,
    /// Wood, stone, paper.
    Natural,
}

impl Category {
    /// All of them, in the order of the strip.
    pub const ALL: [Self; 4] = [Self::Glass, Self::Metal, Self::Plastic, Self::Natural];

    /// Its word: "glass".
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Glass => "glass",
            Self::Metal => "metal",
            Self::Plastic => "plastic",
            Self::Natural => "natural",
        }
    }

    /// Its name in the current language.
    #[must_use]
    pub fn title(self) -> String {
        tr!(&format!("material-category-{}", self.word()))
    }

    /// The register: the text of its file.
    const fn source(self) -> &'static str {
        match self {
            Self::Glass => include_str!("../../../../assets/materials/glass.vitrine.toml"),
            Self::Metal => include_str!("../../../../assets/materials/metal.vitrine.toml"),
            Self::Plastic => include_str!("../../../../assets/materials/plastic.vitrine.toml"),
            Self::Natural => include_str!("../../../../assets/materials/natural.vitrine.toml"),
        }
    }
}

/// A material of the library.
#[derive(Clone, Debug, PartialEq)]
pub struct LibraryMaterial {
    /// Where it belongs.
    pub category: Category,
    /// The material with its texture, named in English.
    paint: Paint,
}

impl LibraryMaterial {
    /// The key of its name in the locales: "material-red-glass". The attribute `about` says what it is, `search` lists
    /// further words by which it is found.
    #[must_use]
    pub fn key(&self) -> String {
        format!("material-{}", self.paint.material.name.replace(' ', "-"))
    }

    /// Its name in the current language.
    #[must_use]
    pub fn title(&self) -> String {
        tr!(&self.key())
    }

    /// What it is, in a sentence.
    #[must_use]
    pub fn about(&self) -> String {
        tr!(&format!("{}.about", self.key()))
    }

    /// What one paints with: the material and its texture, named in the current language.
    #[must_use]
    pub fn paint(&self) -> Paint {
        let mut paint = self.paint.clone();
        paint.material.name = self.title();
        if let Some(texture) = &mut paint.texture {
            texture.name = self.title();
            paint.material.texture = Some(texture.name.clone());
        }
        paint
    }

    /// Whether all of the words occur in its name, its further words or its category.
    #[must_use]
    pub fn is_found_by(&self, query: &str) -> bool {
        let known = [
            self.title(),
            self.paint.material.name.clone(),
            tr!(&format!("{}.search", self.key())),
            self.category.title(),
        ];
        let known = known.join(" ").to_lowercase();
        query.to_lowercase().split_whitespace().all(|word| known.contains(word))
    }
}

/// The library, in the order of the strip.
#[must_use]
pub fn materials() -> &'static [LibraryMaterial] {
    static MATERIALS: OnceLock<Vec<LibraryMaterial>> = OnceLock::new();
    MATERIALS.get_or_init(|| Category::ALL.into_iter().flat_map(of_category).collect())
}

fn of_category(category: Category) -> Vec<LibraryMaterial> {
    // A test sees that every file can be read.
    let Ok(file) = SceneFile::parse(Path::new(category.word()), category.source()) else { return Vec::new() };
    let scene = file.into_scene();
    let paint = |material: &vitrine::scene::Material| {
        let texture = material.texture.as_deref().and_then(|name| scene.texture(name)).cloned();
        Paint { material: material.clone(), texture }
    };
    scene.materials.iter().map(|m| LibraryMaterial { category, paint: paint(m) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::carried;
    use crate::text::{Language, set_language, try_tr};
    use vitrine::scene::TextureSource;

    const PROMISED: &str = "clear glass, red glass, window pane, museum glass, frosted glass, tinted glass, \
        bottle green, crystal, diamond, water, ice, acrylic, soap film, mirror, old mirror, chrome, brushed steel, \
        gold, copper, matte plastic, glossy plastic, rubber, ceramic, car paint, wood, marble, checker, brick, paper";

    #[test]
    fn every_category_is_read_and_has_what_is_promised() {
        for category in Category::ALL {
            let read = SceneFile::parse(Path::new(category.word()), category.source());
            assert!(read.is_ok(), "{}: {:?}", category.word(), read.err());
        }
        for name in PROMISED.split(", ") {
            let name = name.trim();
            assert!(materials().iter().any(|m| m.paint.material.name == name), "{name}");
        }
        let place = |name: &str| materials().iter().position(|m| m.paint.material.name == name).unwrap();
        assert!(place("red glass") < 3, "red glass stands early");
    }

    #[test]
    fn both_sides_are_stated() {
        for m in materials() {
            let material = &m.paint.material;
            assert!(material.diffuse.is_some(), "{}", material.name);
            assert!(material.specular_roughness.is_some(), "{}", material.name);
            let is_glass = m.category == Category::Glass;
            assert_eq!(material.transmission_weight.is_some(), is_glass, "{}", material.name);
            assert_eq!(material.transparency.is_some(), is_glass, "{}", material.name);
            let is_metal = m.category == Category::Metal;
            assert_eq!(material.base_metalness == Some(1.0), is_metal, "{}", material.name);
        }
    }

    #[test]
    fn pictures_are_carried_by_the_program() {
        for m in materials() {
            if let Some(TextureSource::Picture(picture)) = m.paint.texture.as_ref().map(|t| &t.source) {
                assert!(carried(Path::new(&picture.file)).is_some(), "{}", picture.file);
            }
        }
    }

    #[test]
    fn names_and_words_stand_in_both_languages() {
        for language in Language::ALL {
            set_language(language);
            for category in Category::ALL {
                let key = format!("material-category-{}", category.word());
                assert!(try_tr(&key).is_some(), "{language:?}: {key}");
            }
            let mut titles = Vec::new();
            for m in materials() {
                for key in [m.key(), format!("{}.about", m.key()), format!("{}.search", m.key())] {
                    assert!(try_tr(&key).is_some(), "{language:?}: {key}");
                }
                assert!(!titles.contains(&m.title()), "{} twice", m.title());
                titles.push(m.title());
            }
        }
        set_language(Language::Russian);
        assert_ne!(materials()[0].title(), "clear glass", "not a fallback");
        set_language(Language::English);
    }

    #[test]
    fn a_material_is_found_by_its_other_words_in_both_languages() {
        let found = |query: &str| {
            let all = materials().iter().filter(|m| m.is_found_by(query));
            all.map(|m| m.paint.material.name.as_str()).collect::<Vec<_>>()
        };
        assert_eq!(found("museum"), ["museum glass"]);
        assert_eq!(found("zzz"), [""; 0]);
        assert_eq!(found("").len(), materials().len());
        set_language(Language::Russian);
        assert_eq!(found("красное стекло"), ["red glass"]);
        assert!(found("gold").contains(&"gold"), "the English name serves everywhere");
        set_language(Language::English);
    }

    #[test]
    fn what_one_paints_with_is_named_in_the_language_of_the_window() {
        set_language(Language::Russian);
        let wood = materials().iter().find(|m| m.paint.material.name == "wood").unwrap().paint();
        assert_eq!(wood.material.texture, wood.texture.map(|t| t.name));
        assert_ne!(wood.material.name, "wood");
        set_language(Language::English);
    }
}
