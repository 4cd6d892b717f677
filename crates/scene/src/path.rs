//! Paths to one parameter: `object.ball.radius`, `camera.position`, and through a reference `object.ball.material.color`.

use crate::params::{self, ParamError, ParamKind, ParamSpec, Value};
use crate::{Item, ListName, Params, Scene, closest};

/// What in the scene has parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// `[settings]`
    Settings,
    /// `[camera]`
    Camera,
    /// An entry of a list, by index.
    Item(ListName, usize),
}

/// A parameter of something in the scene.
#[derive(Clone, Copy, Debug)]
pub struct ScenePath {
    /// What has the parameter.
    pub owner: Owner,
    /// The parameter.
    pub spec: &'static ParamSpec,
}

/// Why a path leads nowhere.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PathError {
    /// Too short or too long.
    #[error("`{path}` is not a path to a value")]
    Malformed {
        /// As given.
        path: String,
    },
    /// The first word names no part of the scene.
    #[error("a scene has no part `{word}`")]
    NoPart {
        /// As given.
        word: String,
    },
    /// The list has no such name.
    #[error("there is no {} `{name}`", list.key())]
    NoName {
        /// The list.
        list: ListName,
        /// As given.
        name: String,
        /// A near one.
        suggestion: Option<String>,
    },
    /// It has no such parameter.
    #[error("`{owner}` has no key `{key}`")]
    NoKey {
        /// The path up to the key.
        owner: String,
        /// As given.
        key: String,
        /// A near one.
        suggestion: Option<String>,
    },
    /// The path goes on through a reference that is not stated.
    #[error("`{owner}` states no {key}, so the path cannot go on through it")]
    NoReference {
        /// The path up to the key.
        owner: String,
        /// The reference.
        key: String,
    },
}

impl PathError {
    /// How to mend it, where there is more to say.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::Malformed { .. } | Self::NoPart { .. } => {
                "paths read settings.KEY, camera.KEY, or LIST.NAME.KEY with LIST one of object, light, \
                 material, texture, group; a name with a dot goes in quotes"
                    .into()
            }
            Self::NoName { suggestion: Some(s), .. } | Self::NoKey { suggestion: Some(s), .. } => {
                format!("did you mean `{s}`?")
            }
            Self::NoName { list, .. } => {
                format!("the name must be that of a [[{}]] of the scene", list.key())
            }
            Self::NoKey { .. } => "see the keys in docs/scene-file.md".into(),
            Self::NoReference { key, .. } => format!("give it a {key} first"),
        }
    }
}

impl ScenePath {
    /// Finds what the words of a path name. References are followed: `object`, `ball`, `material`, `color` is the
    /// colour of the ball's material.
    ///
    /// # Errors
    /// [`PathError`] for the first word that leads nowhere.
    pub fn find(scene: &Scene, words: &[&str]) -> Result<Self, PathError> {
        let malformed = || PathError::Malformed { path: words.join(".") };
        let (&part, rest) = words.split_first().ok_or_else(malformed)?;
        let (mut owner, mut keys) = match (part, rest) {
            ("settings", keys) => (Owner::Settings, keys),
            ("camera", keys) => (Owner::Camera, keys),
            (list, rest) => {
                let list = ListName::ALL.into_iter().find(|l| l.key() == list);
                let list = list.ok_or_else(|| PathError::NoPart { word: part.to_owned() })?;
                let (&name, keys) = rest.split_first().ok_or_else(malformed)?;
                (scene.find_item(list, name)?, keys)
            }
        };
        loop {
            let (&key, rest) = keys.split_first().ok_or_else(malformed)?;
            let before = || words[..words.len() - keys.len()].join(".");
            let specs = scene.specs(owner);
            let spec = specs.iter().copied().find(|s| s.name == key).ok_or_else(|| PathError::NoKey {
                owner: before(),
                key: key.to_owned(),
                suggestion: closest(key, specs.iter().map(|s| s.name)).map(str::to_owned),
            })?;
            if rest.is_empty() {
                return Ok(Self { owner, spec });
            }
            let ParamKind::Reference(list) = spec.kind else { return Err(malformed()) };
            let Some(Value::Text(name)) = scene.value(owner, spec.name) else {
                return Err(PathError::NoReference { owner: before(), key: key.to_owned() });
            };
            owner = scene.find_item(list, &name)?;
            keys = rest;
        }
    }
}

impl Scene {
    fn find_item(&self, list: ListName, name: &str) -> Result<Owner, PathError> {
        match self.names(list).position(|n| n == name) {
            Some(index) => Ok(Owner::Item(list, index)),
            None => Err(PathError::NoName {
                list,
                name: name.to_owned(),
                suggestion: closest(name, self.names(list)).map(str::to_owned),
            }),
        }
    }

    /// The parameters of an owner, its kind's own last. Empty when there is no such owner.
    #[must_use]
    pub fn specs(&self, owner: Owner) -> Vec<&'static ParamSpec> {
        self.parts(owner).into_iter().flat_map(Params::specs).collect()
    }

    /// The value of one parameter, or None when there is no such owner or parameter.
    #[must_use]
    pub fn value(&self, owner: Owner, key: &str) -> Option<Value> {
        self.parts(owner).into_iter().find_map(|p| p.get(key))
    }

    /// Sets one parameter, with the same checks for files, `--set`, panels and scripts. Aiming the camera one way
    /// takes back the other.
    ///
    /// # Errors
    /// [`ParamError`]; then nothing has changed.
    pub fn set(&mut self, owner: Owner, key: &str, value: Value) -> Result<(), ParamError> {
        let unknown = || ParamError::Unknown { name: key.to_owned() };
        let part = self.part_mut(owner, key).ok_or_else(unknown)?;
        let aims = value != Value::Nothing;
        params::set(part, key, value)?;
        match (owner, key) {
            (Owner::Camera, "turn_deg") if aims => self.camera.look_at = None,
            (Owner::Camera, "look_at") if aims => self.camera.turn_deg = None,
            _ => {}
        }
        Ok(())
    }

    fn parts(&self, owner: Owner) -> Vec<&dyn Params> {
        fn of<T: Item>(items: &[T], index: usize) -> Vec<&dyn Params> {
            items.get(index).map_or_else(Vec::new, |item| {
                std::iter::once(item as &dyn Params).chain(item.kind_params()).collect()
            })
        }
        match owner {
            Owner::Settings => vec![&self.settings],
            Owner::Camera => vec![&self.camera],
            Owner::Item(ListName::Object, i) => of(&self.objects, i),
            Owner::Item(ListName::Light, i) => of(&self.lights, i),
            Owner::Item(ListName::Material, i) => of(&self.materials, i),
            Owner::Item(ListName::Texture, i) => of(&self.textures, i),
            Owner::Item(ListName::Group, i) => of(&self.groups, i),
        }
    }

    fn part_mut(&mut self, owner: Owner, key: &str) -> Option<&mut dyn Params> {
        fn of<'a, T: Item>(items: &'a mut [T], index: usize, key: &str) -> Option<&'a mut dyn Params> {
            let item = items.get_mut(index)?;
            if item.get(key).is_some() {
                return Some(item);
            }
            item.kind_params_mut().filter(|p| p.get(key).is_some())
        }
        match owner {
            Owner::Settings => Some(&mut self.settings),
            Owner::Camera => Some(&mut self.camera),
            Owner::Item(ListName::Object, i) => of(&mut self.objects, i, key),
            Owner::Item(ListName::Light, i) => of(&mut self.lights, i, key),
            Owner::Item(ListName::Material, i) => of(&mut self.materials, i, key),
            Owner::Item(ListName::Texture, i) => of(&mut self.textures, i, key),
            Owner::Item(ListName::Group, i) => of(&mut self.groups, i, key),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Material, Object};
    use vitrine_math::Vec3;

    fn scene() -> Scene {
        Scene {
            materials: vec![Material { name: "red glass".into(), ..Material::default() }],
            objects: vec![
                Object { name: "ball".into(), material: Some("red glass".into()), ..Object::default() },
                Object { name: "bare".into(), ..Object::default() },
            ],
            ..Scene::default()
        }
    }

    #[test]
    fn reaches_shape_parameters_and_goes_through_references() {
        let mut scene = scene();
        let radius = ScenePath::find(&scene, &["object", "ball", "radius"]).unwrap();
        scene.set(radius.owner, "radius", Value::Number(2.5)).unwrap();
        assert_eq!(scene.value(radius.owner, "radius"), Some(Value::Number(2.5)));

        let path = ScenePath::find(&scene, &["object", "ball", "material", "transparency"]).unwrap();
        assert_eq!(path.owner, Owner::Item(ListName::Material, 0));
        scene.set(path.owner, path.spec.name, Value::Number(0.4)).unwrap();
        assert_eq!(scene.materials[0].transparency, Some(0.4));
    }

    #[test]
    fn says_where_a_path_ends_in_nothing() {
        let scene = scene();
        let error = |words: &[&str]| ScenePath::find(&scene, words).unwrap_err();
        assert!(
            matches!(error(&["object", "bal", "radius"]), PathError::NoName { suggestion: Some(s), .. } if s == "ball")
        );
        assert!(
            matches!(error(&["object", "ball", "raduis"]), PathError::NoKey { suggestion: Some(s), .. } if s == "radius")
        );
        assert!(matches!(error(&["object", "bare", "material", "color"]), PathError::NoReference { .. }));
        assert!(matches!(error(&["objects", "ball"]), PathError::NoPart { .. }));
        assert!(matches!(error(&["object", "ball"]), PathError::Malformed { .. }));
        assert!(matches!(error(&["object", "ball", "radius", "x"]), PathError::Malformed { .. }));
        assert!(matches!(error(&[]), PathError::Malformed { .. }));
    }

    #[test]
    fn refuses_what_the_file_would_refuse() {
        let mut scene = scene();
        let ball = Owner::Item(ListName::Object, 0);
        for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            let refused = scene.set(ball, "radius", Value::Number(bad));
            assert!(matches!(refused, Err(ParamError::NotAllowed { .. })), "{bad}");
        }
        assert!(matches!(scene.set(ball, "radius", Value::Flag(true)), Err(ParamError::WrongType { .. })));
        assert!(matches!(scene.set(ball, "size", Value::Flag(true)), Err(ParamError::Unknown { .. })));
    }

    #[test]
    fn the_last_way_of_aiming_the_camera_counts() {
        let mut scene = scene();
        scene.set(Owner::Camera, "look_at", Value::Vector(Vec3::Y)).unwrap();
        scene.set(Owner::Camera, "turn_deg", Value::Vector(Vec3::X)).unwrap();
        assert_eq!((scene.camera.look_at, scene.camera.turn_deg), (None, Some(Vec3::X)));
    }
}
