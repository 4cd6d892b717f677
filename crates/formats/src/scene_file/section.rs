//! The frame of a scene file: its sections and lists. What stands in them comes from the scene's own descriptions.

use vitrine_scene::{
    Camera, Group, Item, KindSpec, Light, ListName, Material, Object, ParamSpec, Settings, Texture,
};

/// The version of the format that this program reads and writes.
pub(super) const FORMAT: i64 = 1;
/// The key of the version.
pub(super) const FORMAT_KEY: &str = "format";
/// The key of the line on what the scene shows.
pub(super) const ABOUT_KEY: &str = "about";
/// What that line is.
pub(super) const ABOUT_DOC: &str = "What the scene shows, in one line.";
/// What the version is.
pub(super) const FORMAT_DOC: &str = "The version of the file's format.";
/// The section on how the picture is made.
pub(super) const SETTINGS: &str = "settings";
/// The section on the camera.
pub(super) const CAMERA: &str = "camera";
/// What a name is.
pub(super) const NAME_DOC: &str =
    "Its name, which no other entry of the list has. Other entries refer to it.";
/// The key of an entry's name.
pub(super) const NAME_KEY: &str = "name";

/// The register of a list's kinds and the key that chooses among them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kinds {
    /// `shape` or `kind`.
    pub key: &'static str,
    /// The kinds.
    pub all: &'static [KindSpec],
}

impl Kinds {
    /// The kind of that word.
    pub fn find(&self, word: &str) -> Option<&'static KindSpec> {
        self.all.iter().find(|k| k.name == word)
    }

    /// The words in quotes: "sphere", "box".
    pub fn quoted(&self) -> String {
        let quoted: Vec<_> = self.all.iter().map(|k| format!("\"{}\"", k.name)).collect();
        quoted.join(", ")
    }
}

/// A section, or the entries of a list.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Its word in the file.
    pub word: &'static str,
    /// The list; None for a section that stands once.
    pub list: Option<ListName>,
    /// What it is, or its entries are, in plain English.
    pub doc: &'static str,
    /// The parameters, without a kind's own.
    pub specs: &'static [ParamSpec],
    /// The kinds, where there are any.
    pub kinds: Option<Kinds>,
}

impl Section {
    pub const SETTINGS: Self = Self::single(SETTINGS, Settings::DOC, Settings::SPECS);
    pub const CAMERA: Self = Self::single(CAMERA, Camera::DOC, Camera::SPECS);

    /// All of them in the order of a file.
    pub fn all() -> impl Iterator<Item = Self> {
        [Self::SETTINGS, Self::CAMERA].into_iter().chain(ListName::ALL.map(Self::of_list))
    }

    const fn single(word: &'static str, doc: &'static str, specs: &'static [ParamSpec]) -> Self {
        Self { word, list: None, doc, specs, kinds: None }
    }

    /// The list that holds such items.
    pub fn of<T: Item>() -> Self {
        let kinds = T::KINDS.map(|(key, all)| Kinds { key, all });
        Self { word: T::LIST.key(), list: Some(T::LIST), doc: T::ABOUT, specs: T::OWN_SPECS, kinds }
    }

    /// A list.
    pub fn of_list(list: ListName) -> Self {
        match list {
            ListName::Object => Self::of::<Object>(),
            ListName::Light => Self::of::<Light>(),
            ListName::Material => Self::of::<Material>(),
            ListName::Texture => Self::of::<Texture>(),
            ListName::Group => Self::of::<Group>(),
        }
    }

    /// How it stands in the file: `[camera]`, `[[object]]`.
    pub fn header(&self) -> String {
        if self.list.is_some() { format!("[[{}]]", self.word) } else { format!("[{}]", self.word) }
    }

    /// The keys that stand in every entry of it, with the parameters of one kind if there is one.
    pub fn keys(&self, kind: Option<&'static KindSpec>) -> Vec<&'static str> {
        let name = self.list.map(|_| NAME_KEY);
        let kind_key = self.kinds.map(|k| k.key);
        let own = kind.map_or(&[][..], |k| k.specs);
        let specs = own.iter().chain(self.specs).map(|s| s.name);
        name.into_iter().chain(kind_key).chain(specs).collect()
    }

    /// The words of the kinds that have this key of their own.
    pub fn kinds_with(&self, key: &str) -> Vec<&'static str> {
        let all = self.kinds.map_or(&[][..], |k| k.all);
        all.iter().filter(|k| k.specs.iter().any(|s| s.name == key)).map(|k| k.name).collect()
    }

    /// Whether this key may stand in it, at least for some kind.
    pub fn knows(&self, key: &str) -> bool {
        self.keys(None).contains(&key) || !self.kinds_with(key).is_empty()
    }
}

/// A description on one line.
pub(super) fn one_line(doc: &str) -> String {
    doc.split_whitespace().collect::<Vec<_>>().join(" ")
}
