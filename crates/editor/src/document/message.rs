//! Words for a person, not yet in any language: the key of a locale's text and what it tells of.

/// Words for a person.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// The key in the locales.
    pub key: &'static str,
    /// What the text tells of: the names of its places and what to write there.
    pub arguments: Vec<(&'static str, String)>,
}

impl Message {
    /// Words that tell of nothing in particular.
    #[must_use]
    pub const fn new(key: &'static str) -> Self {
        Self { key, arguments: Vec::new() }
    }

    /// The same words that tell of something besides.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: &(impl ToString + ?Sized)) -> Self {
        self.arguments.push((name, value.to_string()));
        self
    }
}
