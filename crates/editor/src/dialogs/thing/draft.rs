//! The thing that a dialog adds or changes, until the person accepts: a copy, so that «Cancel» has nothing to take back.

use super::material::MaterialDraft;
use crate::document::{Addition, EditCommand, Thing, free_name_among};
use vitrine::scene::{Item, Light, ListName, Object, ParamSpec, Params, Scene, Shape, Value, params};

/// An object or a light.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// An object.
    Object(Box<Object>),
    /// A light.
    Light(Box<Light>),
}

/// Why a draft cannot be accepted as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// The name is empty.
    NoName,
    /// Another thing of the list has the name.
    NameTaken,
    /// The points of a triangle lie on one line.
    Line,
}

impl Flaw {
    /// The key of its text.
    #[must_use]
    pub const fn text_key(self) -> &'static str {
        match self {
            Self::NoName => "dialog-add-name-empty",
            Self::NameTaken => "dialog-add-name-taken",
            Self::Line => "dialog-add-fault-line",
        }
    }
}

impl Subject {
    /// Its list.
    #[must_use]
    pub const fn list(&self) -> ListName {
        match self {
            Self::Object(_) => ListName::Object,
            Self::Light(_) => ListName::Light,
        }
    }

    /// The word of its kind: "sphere".
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Object(object) => object.shape.kind(),
            Self::Light(light) => light.source.kind(),
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Object(object) => &object.name,
            Self::Light(light) => &light.name,
        }
    }

    /// Its name, to change.
    pub fn name_mut(&mut self) -> &mut String {
        match self {
            Self::Object(object) => &mut object.name,
            Self::Light(light) => &mut light.name,
        }
    }

    fn parts(&self) -> [Option<&dyn Params>; 2] {
        match self {
            Self::Object(object) => [Some(&**object), object.kind_params()],
            Self::Light(light) => [Some(&**light), light.kind_params()],
        }
    }

    /// The descriptions of all its parameters.
    pub fn specs(&self) -> impl Iterator<Item = &'static ParamSpec> {
        self.parts().into_iter().flatten().flat_map(Params::specs)
    }

    /// The value of a parameter.
    #[must_use]
    pub fn value(&self, key: &str) -> Option<Value> {
        self.parts().into_iter().flatten().find_map(|p| p.get(key))
    }

    /// Changes a parameter. False when the value does not fit; then nothing has changed.
    pub fn set(&mut self, key: &str, value: Value) -> bool {
        fn set<T: Item>(item: &mut T, key: &str, value: Value) -> bool {
            if item.get(key).is_some() {
                return params::set(item, key, value).is_ok();
            }
            item.kind_params_mut().is_some_and(|p| params::set(p, key, value).is_ok())
        }
        match self {
            Self::Object(object) => set(&mut **object, key, value),
            Self::Light(light) => set(&mut **light, key, value),
        }
    }

    /// The parameters that its dialog shows, in the order of the course work: where it is, how large, how turned. An
    /// existing object can be moved, turned and scaled, whatever its kind.
    #[must_use]
    pub fn fields(&self, is_new: bool) -> Vec<&'static ParamSpec> {
        let own: &[&str] = match (self, self.kind()) {
            (Self::Object(_), "triangle") if is_new => &[],
            (Self::Object(_), "sphere") if is_new => &["position"],
            (Self::Object(_), _) if is_new => &["position", "turn_deg"],
            (Self::Object(_), _) => &["position", "turn_deg", "scale"],
            (Self::Light(_), _) => &["intensity", "color"],
        };
        let [owner, kind] = self.parts().map(|p| p.map_or(&[][..], Params::specs));
        let own = own.iter().filter_map(|key| owner.iter().find(|s| s.name == *key));
        // The picture's corners on a triangle are for the panel of properties.
        let kind = kind.iter().filter(|s| s.name != "uvs");
        match self {
            // The place first, then what the kind adds, then the turn.
            Self::Object(_) => {
                let (place, rest): (Vec<_>, Vec<_>) = own.partition(|s| s.name == "position");
                place.into_iter().chain(kind).chain(rest).collect()
            }
            Self::Light(_) => kind.chain(own).collect(),
        }
    }

    /// What stands in the way of accepting it. `before` is the name of the thing that is being changed.
    #[must_use]
    pub fn flaw(&self, scene: &Scene, before: Option<&str>) -> Option<Flaw> {
        let name = self.name().trim();
        if name.is_empty() {
            return Some(Flaw::NoName);
        }
        let is_taken = scene.names(self.list()).any(|n| n == name);
        if is_taken && before.is_some_and(|b| b != name) {
            return Some(Flaw::NameTaken);
        }
        let is_flat = matches!(self, Self::Object(o) if o.shape.as_kind().fault().is_some());
        is_flat.then_some(Flaw::Line)
    }
}

/// A thing that is being added or changed.
#[derive(Clone, Debug)]
pub struct ThingDraft {
    /// The thing.
    pub subject: Subject,
    /// What it is made of; lights have none.
    pub material: Option<MaterialDraft>,
    /// What it was before; None for a new one.
    before: Option<Subject>,
}

impl ThingDraft {
    /// A new thing, filled in with what the addition says. None when it adds neither an object nor a light.
    #[must_use]
    pub fn add(addition: &Addition, scene: &Scene) -> Option<Self> {
        if let Some(object) = addition.objects.first() {
            let material = Some(MaterialDraft::of(object, addition, scene));
            let subject = Subject::Object(Box::new(by_its_points(object.clone())));
            return Some(Self { subject, material, before: None });
        }
        let light = addition.lights.first()?;
        Some(Self { subject: Subject::Light(Box::new(light.clone())), material: None, before: None })
    }

    /// A thing of the scene. None when it is not there, or neither an object nor a light.
    #[must_use]
    pub fn edit(thing: &Thing, scene: &Scene) -> Option<Self> {
        let name = thing.name()?;
        let (subject, material) = match thing.list()? {
            ListName::Object => {
                let object = scene.object(name)?;
                let material = MaterialDraft::of(object, &Addition::default(), scene);
                (Subject::Object(Box::new(object.clone())), Some(material))
            }
            ListName::Light => {
                let light = scene.lights.iter().find(|l| l.name == name)?;
                (Subject::Light(Box::new(light.clone())), None)
            }
            ListName::Material | ListName::Texture | ListName::Group => return None,
        };
        Some(Self { before: Some(subject.clone()), subject, material })
    }

    /// What it was called before; None for a new one.
    #[must_use]
    pub fn name_before(&self) -> Option<&str> {
        self.before.as_ref().map(Subject::name)
    }

    /// The thing that is being changed, as it will be called; None for a new one.
    #[must_use]
    pub fn thing_after(&self) -> Option<Thing> {
        let name = self.subject.name().trim().to_owned();
        self.before.as_ref().map(|b| Thing::Item(b.list(), name))
    }

    /// Whether it is being added.
    #[must_use]
    pub const fn is_new(&self) -> bool {
        self.before.is_none()
    }

    /// The parameters to show.
    #[must_use]
    pub fn fields(&self) -> Vec<&'static ParamSpec> {
        self.subject.fields(self.is_new())
    }

    /// What stands in the way of accepting it.
    #[must_use]
    pub fn flaw(&self, scene: &Scene) -> Option<Flaw> {
        self.subject.flaw(scene, self.name_before())
    }

    /// What to do when it is accepted, in order; together one step. Empty when nothing was changed.
    #[must_use]
    pub fn commands(&self, scene: &Scene) -> Vec<EditCommand> {
        let name = self.subject.name().trim();
        let Some(before) = &self.before else {
            let mut subject = self.subject.clone();
            name.clone_into(subject.name_mut());
            return vec![EditCommand::Add(self.addition(subject, scene))];
        };
        let thing = Thing::Item(before.list(), before.name().to_owned());
        let changed = self.subject.specs().filter_map(|spec| {
            let value = self.subject.value(spec.name)?;
            // The material has commands of its own.
            let is_other = spec.name != "material" && before.value(spec.name).as_ref() != Some(&value);
            is_other.then(|| EditCommand::Set { things: vec![thing.clone()], key: spec.name.into(), value })
        });
        let mut commands: Vec<_> = changed.collect();
        if let (Subject::Object(object), Some(material)) = (before, &self.material) {
            commands.extend(material.commands(object, scene));
        }
        if name != before.name() {
            commands.push(EditCommand::Rename { thing, name: name.to_owned() });
        }
        commands
    }

    fn addition(&self, subject: Subject, scene: &Scene) -> Addition {
        match (subject, &self.material) {
            (Subject::Object(object), Some(material)) => material.put_on(*object, scene),
            (Subject::Object(object), None) => Addition { objects: vec![*object], ..Addition::default() },
            (Subject::Light(light), _) => Addition { lights: vec![*light], ..Addition::default() },
        }
    }

    /// The scene as it would be.
    #[must_use]
    pub fn shown_in(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        match &self.subject {
            Subject::Object(object) => {
                let mut object = Object::clone(object);
                if let Some(material) = &self.material {
                    material.show_in(&mut scene, &mut object);
                }
                replace(&mut scene.objects, object, self.name_before());
            }
            Subject::Light(light) => replace(&mut scene.lights, Light::clone(light), self.name_before()),
        }
        scene
    }
}

/// Puts an item into its list: in place of the one with the old name, or as a new one.
pub(in crate::dialogs) fn replace<T: Item>(items: &mut Vec<T>, mut item: T, before: Option<&str>) {
    match items.iter_mut().find(|i| Some(i.name()) == before) {
        Some(old) => {
            item.rename(old.name().to_owned());
            *old = item;
        }
        None => {
            let name = free_name_among(items.iter().map(Item::name), item.name());
            item.rename(name);
            items.push(item);
        }
    }
}

/// A new triangle is said by three points of the scene (C4), so its place goes into them.
fn by_its_points(mut object: Object) -> Object {
    if let Shape::Triangle(triangle) = &mut object.shape {
        let place = std::mem::take(&mut object.position);
        triangle.points.iter_mut().for_each(|point| *point += place);
    }
    object
}
