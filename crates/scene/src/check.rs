//! What is wrong with a scene as a whole: names, references, cycles, and what would give a black picture.

use crate::params::{ParamKind, Value};
use crate::{Fault, Geometry, GroupPlaces, Item, ListName, Owner, Renderer, Scene, Settings, closest};
use std::collections::HashMap;
use vitrine_math::Vec3;

/// Whether a picture can be made all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The picture can be made and may not be what was meant.
    Warning,
    /// The scene means nothing until it is mended.
    Error,
}

/// Where in the scene a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Whose problem; None when the whole scene's.
    pub owner: Option<Owner>,
    /// Which key; None when the whole entry is meant.
    pub key: Option<&'static str>,
}

/// Something wrong with the scene as a whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// How bad.
    pub severity: Severity,
    /// Where.
    pub place: Place,
    /// What.
    pub cause: Cause,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Cause {
    /// Two entries of a list have one name.
    #[error("there are two [[{}]] with the name `{name}`", list.key())]
    DuplicateName {
        /// The list.
        list: ListName,
        /// The name.
        name: String,
    },
    /// A name is empty.
    #[error("the name is empty")]
    EmptyName,
    /// A reference to nothing.
    #[error("there is no {} `{name}`", list.key())]
    MissingReference {
        /// The list.
        list: ListName,
        /// The name.
        name: String,
        /// A near one.
        suggestion: Option<String>,
    },
    /// A group is inside itself.
    #[error("the group `{name}` is inside itself")]
    GroupCycle {
        /// The group.
        name: String,
    },
    /// Parameters that do not go together.
    #[error("{}", .0.message)]
    Fault(Fault),
    /// The picture is too large.
    #[error("a picture of {width} × {height} pixels is too large")]
    PictureTooLarge {
        /// Pixels.
        width: u32,
        /// Pixels.
        height: u32,
    },
    /// Nothing shines.
    #[error("no light is switched on, so the picture will be black")]
    NoLight,
    /// Nothing to see.
    #[error("no object is visible, so the picture will be empty")]
    NoObject,
    /// The camera stands in a thing.
    #[error("the camera is inside `{name}`")]
    CameraInside {
        /// The object.
        name: String,
    },
    /// Light goes into a model that has no inside.
    #[error("`{name}` is of solid glass and its model is not closed, so light gets lost in it")]
    OpenSolid {
        /// The object.
        name: String,
    },
    /// Nothing says which glass fills what two solids share.
    #[error(
        "the glass of `{name}` and that of `{other}` overlap and are equally large, so the later one counts"
    )]
    EqualSolids {
        /// The object that counts.
        name: String,
        /// The other one.
        other: String,
    },
}

impl Cause {
    /// How to mend it.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::DuplicateName { .. } => "give each its own name: other entries refer to it by name".into(),
            Self::EmptyName => "give it a name such as \"ball\"".into(),
            Self::MissingReference { suggestion: Some(s), .. } => format!("did you mean `{s}`?"),
            Self::MissingReference { list, name, .. } => {
                format!("add a [[{}]] with name = \"{name}\", or remove this line", list.key())
            }
            Self::GroupCycle { .. } => "let the outermost group have no `group`".into(),
            Self::Fault(fault) => fault.help.into(),
            Self::PictureTooLarge { .. } => {
                format!("width times height can be {} at most", Settings::MAX_PIXELS)
            }
            Self::NoLight => "add a [[light]], such as one with kind = \"disc\" or \"sky\"".into(),
            Self::NoObject => "add an [[object]], or set visible = true on one".into(),
            Self::OpenSolid { .. } => {
                "close the model, or say geometry_thin_walled = true in the material if it is a sheet".into()
            }
            Self::EqualSolids { .. } => {
                "make the one that should count a little smaller, or move them apart".into()
            }
            Self::CameraInside { .. } => "move the camera out, unless the view from inside is meant".into(),
        }
    }
}

/// To look for a near name is slow among very many; nobody reads more suggestions than this.
const MOST_SUGGESTIONS: usize = 50;

impl Scene {
    /// Everything that is wrong with the scene as a whole, errors before warnings. Each parameter on its own has
    /// been checked when it was set.
    #[must_use]
    pub fn problems(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        check_names(&self.lights, &mut problems);
        check_names(&self.textures, &mut problems);
        check_names(&self.materials, &mut problems);
        check_names(&self.groups, &mut problems);
        check_names(&self.objects, &mut problems);
        self.check_references(&mut problems);
        self.check_cycles(&mut problems);
        self.check_faults(&mut problems);
        if problems.is_empty() {
            self.check_picture(&mut problems);
        }
        problems.sort_by_key(|p| std::cmp::Reverse(p.severity));
        problems
    }

    /// Whether there is light without any lamp: the photoreal renderer shows materials that shine by themselves.
    #[must_use]
    pub fn shines_without_lights(&self) -> bool {
        self.settings.renderer == Renderer::Photoreal
            && self.materials.iter().any(|m| m.emission_luminance.is_some_and(|l| l > 0.0))
    }

    fn check_references(&self, problems: &mut Vec<Problem>) {
        let known = ListName::ALL.map(|l| (l, self.names(l).collect::<std::collections::HashSet<_>>()));
        for list in ListName::ALL {
            for index in 0..self.names(list).count() {
                let owner = Owner::Item(list, index);
                for spec in self.specs(owner) {
                    let ParamKind::Reference(to) = spec.kind else { continue };
                    let Some(Value::Text(name)) = self.value(owner, spec.name) else { continue };
                    if known.iter().any(|(l, names)| *l == to && names.contains(name.as_str())) {
                        continue;
                    }
                    let near = || closest(&name, self.names(to)).map(str::to_owned);
                    let suggestion = (problems.len() < MOST_SUGGESTIONS).then(near).flatten();
                    problems.push(Problem::error(
                        owner,
                        Some(spec.name),
                        Cause::MissingReference { list: to, name, suggestion },
                    ));
                }
            }
        }
    }

    fn check_cycles(&self, problems: &mut Vec<Problem>) {
        let index_of: HashMap<&str, usize> =
            self.groups.iter().enumerate().map(|(i, g)| (g.name.as_str(), i)).collect();
        let outer = |i: usize| self.groups[i].group.as_deref().and_then(|g| index_of.get(g).copied());
        // 0 unknown, 1 on the way that is being walked, 2 known to lead out.
        let mut state = vec![0_u8; self.groups.len()];
        for start in 0..self.groups.len() {
            let mut way = Vec::new();
            let mut at = Some(start);
            while let Some(i) = at {
                if state[i] == 2 {
                    break;
                }
                if state[i] == 1 {
                    let name = self.groups[i].name.clone();
                    let owner = Owner::Item(ListName::Group, i);
                    problems.push(Problem::error(owner, Some("group"), Cause::GroupCycle { name }));
                    break;
                }
                state[i] = 1;
                way.push(i);
                at = outer(i);
            }
            way.into_iter().for_each(|i| state[i] = 2);
        }
    }

    fn check_faults(&self, problems: &mut Vec<Problem>) {
        let [width, height] = self.settings.size;
        if u64::from(width) * u64::from(height) > Settings::MAX_PIXELS {
            let cause = Cause::PictureTooLarge { width, height };
            problems.push(Problem::error(Owner::Settings, Some("size"), cause));
        }
        if let Some(fault) = self.camera.fault() {
            problems.push(Problem::error(Owner::Camera, Some(fault.key), Cause::Fault(fault)));
        }
        for (i, object) in self.objects.iter().enumerate() {
            if let Some(fault) = object.shape.as_kind().fault() {
                let owner = Owner::Item(ListName::Object, i);
                problems.push(Problem::error(owner, Some(fault.key), Cause::Fault(fault)));
            }
        }
    }

    fn check_picture(&self, problems: &mut Vec<Problem>) {
        let mut warn = |owner, cause| {
            problems.push(Problem { severity: Severity::Warning, place: Place { owner, key: None }, cause });
        };
        if !self.shines_without_lights() && !self.lights.iter().any(|l| l.visible && l.intensity > 0.0) {
            warn(None, Cause::NoLight);
        }
        let places = self.group_places();
        if !self.objects.iter().any(|o| places.is_seen(o)) {
            warn(None, Cause::NoObject);
        }
        for (i, object) in self.objects.iter().enumerate() {
            if places.is_seen(object) && self.camera_is_inside(object, &places) {
                let name = object.name.clone();
                warn(Some(Owner::Item(ListName::Object, i)), Cause::CameraInside { name });
            }
        }
        problems.extend(self.equal_solids(&places));
    }

    fn camera_is_inside(&self, object: &crate::Object, places: &GroupPlaces) -> bool {
        let place = places.world_from_object(object);
        let p = place.object_from_world.transform_point3(self.camera.position);
        match object.shape.as_kind().geometry(&crate::Assets::default()) {
            Some(Geometry::Sphere { radius }) => p.length() < radius,
            Some(Geometry::Box { half }) => (half - p.abs()).cmpgt(Vec3::ZERO).all(),
            _ => false,
        }
    }
}

impl Problem {
    fn error(owner: Owner, key: Option<&'static str>, cause: Cause) -> Self {
        Self { severity: Severity::Error, place: Place { owner: Some(owner), key }, cause }
    }
}

fn check_names<T: Item>(items: &[T], problems: &mut Vec<Problem>) {
    let mut seen = std::collections::HashSet::new();
    for (i, item) in items.iter().enumerate() {
        let name = item.name();
        let owner = Owner::Item(T::LIST, i);
        if name.trim().is_empty() {
            problems.push(Problem::error(owner, Some("name"), Cause::EmptyName));
        } else if !seen.insert(name) {
            let cause = Cause::DuplicateName { list: T::LIST, name: name.to_owned() };
            problems.push(Problem::error(owner, Some("name"), cause));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Sphere, Triangle};
    use crate::{Group, Light, Object, Shape};

    fn good() -> Scene {
        Scene { lights: vec![Light::default()], objects: vec![Object::default()], ..Scene::default() }
    }

    fn causes(scene: &Scene) -> Vec<Cause> {
        scene.problems().into_iter().map(|p| p.cause).collect()
    }

    #[test]
    fn a_good_scene_has_none() {
        assert_eq!(good().problems(), []);
    }

    #[test]
    fn duplicate_and_empty_names() {
        let mut scene = good();
        scene.objects.push(Object::default());
        scene.lights[0].name = " ".into();
        let causes = causes(&scene);
        assert!(causes.contains(&Cause::EmptyName));
        assert!(causes.iter().any(|c| matches!(c, Cause::DuplicateName { name, .. } if name == "object")));
    }

    #[test]
    fn missing_references_suggest_a_near_name() {
        let mut scene = good();
        scene.groups.push(Group { name: "shelf".into(), ..Group::default() });
        scene.objects[0].group = Some("shelff".into());
        scene.objects[0].material = Some("gold".into());
        let helps: Vec<_> = causes(&scene).iter().map(Cause::help).collect();
        assert!(helps.iter().any(|h| h == "did you mean `shelf`?"), "{helps:?}");
        assert!(helps.iter().any(|h| h.contains("[[material]]")), "{helps:?}");
    }

    #[test]
    fn cyclic_groups_are_found_once_and_chains_are_not() {
        let mut scene = good();
        let group = |name: &str, outer: Option<&str>| Group {
            name: name.into(),
            group: outer.map(str::to_owned),
            ..Group::default()
        };
        scene.groups = vec![group("a", Some("b")), group("b", None)];
        assert_eq!(causes(&scene), []);
        scene.groups[1].group = Some("a".into());
        assert_eq!(causes(&scene), [Cause::GroupCycle { name: "a".into() }]);
    }

    #[test]
    fn flat_triangles_at_any_size() {
        for size in [1e-12_f32, 1.0, 1e12] {
            let mut points = [Vec3::ZERO, Vec3::X * size, Vec3::X * (2.0 * size)];
            let mut scene = good();
            scene.objects[0].shape = Shape::Triangle(Triangle { points, ..Triangle::default() });
            assert!(matches!(causes(&scene)[..], [Cause::Fault(_)]), "size {size}");
            points[2] = Vec3::Y * size;
            scene.objects[0].shape = Shape::Triangle(Triangle { points, ..Triangle::default() });
            assert_eq!(causes(&scene), [], "size {size}");
        }
    }

    #[test]
    fn darkness_emptiness_and_a_camera_inside_are_warnings() {
        let mut scene = good();
        scene.lights[0].visible = false;
        scene.objects[0].shape = Shape::Sphere(Sphere { radius: 100.0 });
        let found = scene.problems();
        assert!(found.iter().all(|p| p.severity == Severity::Warning));
        assert!(found.iter().any(|p| p.cause == Cause::NoLight));
        assert!(found.iter().any(|p| matches!(p.cause, Cause::CameraInside { .. })));
        scene.objects[0].visible = false;
        assert!(causes(&scene).contains(&Cause::NoObject));
    }

    #[test]
    fn huge_pictures_are_refused() {
        let mut scene = good();
        scene.settings.size = [32_768, 32_768];
        assert!(matches!(causes(&scene)[..], [Cause::PictureTooLarge { .. }]));
    }
}
