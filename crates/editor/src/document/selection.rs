//! What is selected: things in the order in which they were chosen; the last is the one whose properties are shown.

use super::Thing;
use super::thing::Places;
use std::collections::HashSet;
use vitrine::scene::Scene;

/// What is selected.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection(Vec<Thing>);

impl Selection {
    /// These things and no others.
    #[must_use]
    pub fn of(things: impl IntoIterator<Item = Thing>) -> Self {
        let mut seen = HashSet::new();
        Self(things.into_iter().filter(|thing| seen.insert(thing.clone())).collect())
    }

    /// The things, in the order in which they were chosen.
    #[must_use]
    pub fn things(&self) -> &[Thing] {
        &self.0
    }

    /// The one chosen last.
    #[must_use]
    pub fn last(&self) -> Option<&Thing> {
        self.0.last()
    }

    /// Whether nothing is selected.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it is among them.
    #[must_use]
    pub fn contains(&self, thing: &Thing) -> bool {
        self.0.contains(thing)
    }

    /// Selects one more.
    pub fn add(&mut self, thing: Thing) {
        self.0.retain(|t| *t != thing);
        self.0.push(thing);
    }

    /// Selects it if it is not, and the other way round.
    pub fn toggle(&mut self, thing: Thing) {
        if self.contains(&thing) {
            self.0.retain(|t| *t != thing);
        } else {
            self.0.push(thing);
        }
    }

    /// Forgets what is no longer in the scene.
    pub fn keep_what_is_in(&mut self, scene: &Scene) {
        let mut places = Places::new(scene);
        self.0.retain(|t| places.owner(t).is_some());
    }

    /// Follows a thing to its new name.
    pub fn rename(&mut self, from: &Thing, to: &Thing) {
        self.0.iter_mut().filter(|t| *t == from).for_each(|t| *t = to.clone());
    }
}
