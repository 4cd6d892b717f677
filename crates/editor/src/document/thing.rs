//! What a person points at: anything in the scene that has parameters.

use std::collections::HashMap;
use vitrine::scene::{ListName, Owner, Scene};

/// Something that has parameters and can be selected, by name: names stay true while lists change.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Thing {
    /// How the picture is made.
    Settings,
    /// The camera.
    Camera,
    /// An entry of a list.
    Item(ListName, String),
}

impl Thing {
    /// An object.
    pub fn object(name: impl Into<String>) -> Self {
        Self::Item(ListName::Object, name.into())
    }

    /// A light.
    pub fn light(name: impl Into<String>) -> Self {
        Self::Item(ListName::Light, name.into())
    }

    /// A group.
    pub fn group(name: impl Into<String>) -> Self {
        Self::Item(ListName::Group, name.into())
    }

    /// A material.
    pub fn material(name: impl Into<String>) -> Self {
        Self::Item(ListName::Material, name.into())
    }

    /// A texture.
    pub fn texture(name: impl Into<String>) -> Self {
        Self::Item(ListName::Texture, name.into())
    }

    /// Its list; None for the camera and the settings.
    #[must_use]
    pub fn list(&self) -> Option<ListName> {
        match self {
            Self::Item(list, _) => Some(*list),
            Self::Settings | Self::Camera => None,
        }
    }

    /// Its name; None for the camera and the settings.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Item(_, name) => Some(name),
            Self::Settings | Self::Camera => None,
        }
    }

    /// Where it is in the scene; None when it is not there.
    #[must_use]
    pub fn owner(&self, scene: &Scene) -> Option<Owner> {
        match self {
            Self::Settings => Some(Owner::Settings),
            Self::Camera => Some(Owner::Camera),
            Self::Item(list, name) => {
                scene.names(*list).position(|n| n == name).map(|index| Owner::Item(*list, index))
            }
        }
    }

    /// What stands at a place of the scene; None when nothing does.
    #[must_use]
    pub fn at(scene: &Scene, owner: Owner) -> Option<Self> {
        match owner {
            Owner::Settings => Some(Self::Settings),
            Owner::Camera => Some(Self::Camera),
            Owner::Item(list, index) => {
                scene.names(list).nth(index).map(|name| Self::Item(list, name.to_owned()))
            }
        }
    }
}

/// Where things are, to ask about many of them: each list is walked once.
#[derive(Debug)]
pub(super) struct Places<'a> {
    scene: &'a Scene,
    lists: [Option<HashMap<&'a str, usize>>; ListName::ALL.len()],
}

impl<'a> Places<'a> {
    pub(super) fn new(scene: &'a Scene) -> Self {
        Self { scene, lists: [const { None }; ListName::ALL.len()] }
    }

    /// Where a thing is; None when it is not there.
    pub(super) fn owner(&mut self, thing: &Thing) -> Option<Owner> {
        match thing {
            Thing::Settings => Some(Owner::Settings),
            Thing::Camera => Some(Owner::Camera),
            Thing::Item(list, name) => self.index(*list, name).map(|index| Owner::Item(*list, index)),
        }
    }

    /// The index of the entry of that name.
    pub(super) fn index(&mut self, list: ListName, name: &str) -> Option<usize> {
        let at = ListName::ALL.iter().position(|l| *l == list)?;
        let scene = self.scene;
        let index_of = self.lists[at].get_or_insert_with(|| {
            scene.names(list).enumerate().map(|(index, name)| (name, index)).collect()
        });
        index_of.get(name).copied()
    }
}
