//! The whole scene.

use crate::{
    Camera, Group, KindSpec, Light, LightSource, ListName, Material, Object, ParamSpec, Params, Settings,
    Shape, Texture, TextureSource,
};

/// Everything that a scene file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// What the scene shows, in one line.
    pub about: String,
    /// How the picture is made.
    pub settings: Settings,
    /// The camera.
    pub camera: Camera,
    /// Lights, in the file's order.
    pub lights: Vec<Light>,
    /// Textures, in the file's order.
    pub textures: Vec<Texture>,
    /// Materials, in the file's order.
    pub materials: Vec<Material>,
    /// Groups, in the file's order.
    pub groups: Vec<Group>,
    /// Objects, in the file's order.
    pub objects: Vec<Object>,
}

/// Something in one of the scene's lists: it has a name, perhaps a kind, and parameters of its own and of its kind.
pub trait Item: Params {
    /// Its list.
    const LIST: ListName;
    /// What the entries of its list are, in plain English.
    const ABOUT: &'static str;
    /// Its own parameters, without its kind's.
    const OWN_SPECS: &'static [ParamSpec];
    /// The key that states its kind (`shape`) and the register of kinds; None when there are no kinds.
    const KINDS: Option<(&'static str, &'static [KindSpec])> = None;

    /// Its name.
    fn name(&self) -> &str;

    /// Gives it a name.
    fn rename(&mut self, name: String);

    /// The key and the word of its kind, such as `shape` and `sphere`.
    fn kind(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    /// Makes it another kind, with that kind's defaults. False, and nothing changes, when there is no such kind.
    fn set_kind(&mut self, _word: &str) -> bool {
        false
    }

    /// The parameters of its kind.
    fn kind_params(&self) -> Option<&dyn Params> {
        None
    }

    /// The parameters of its kind, to change.
    fn kind_params_mut(&mut self) -> Option<&mut dyn Params> {
        None
    }
}

macro_rules! items {
    ($($type:ty: $list:ident $(, $key:literal $field:ident $family:ty)?;)*) => {$(
        impl Item for $type {
            const LIST: ListName = ListName::$list;
            const ABOUT: &'static str = <$type>::DOC;
            const OWN_SPECS: &'static [ParamSpec] = <$type>::SPECS;
            $(const KINDS: Option<(&'static str, &'static [KindSpec])> = Some(($key, <$family>::KINDS));)?

            fn name(&self) -> &str {
                &self.name
            }

            fn rename(&mut self, name: String) {
                self.name = name;
            }

            $(
                fn kind(&self) -> Option<(&'static str, &'static str)> {
                    Some(($key, self.$field.kind()))
                }

                fn set_kind(&mut self, word: &str) -> bool {
                    let kind = <$family>::from_kind(word);
                    kind.map(|k| self.$field = k).is_some()
                }

                fn kind_params(&self) -> Option<&dyn Params> {
                    Some(self.$field.as_kind())
                }

                fn kind_params_mut(&mut self) -> Option<&mut dyn Params> {
                    Some(self.$field.params_mut())
                }
            )?
        }
    )*};
}

items! {
    Light: Light, "kind" source LightSource;
    Texture: Texture, "kind" source TextureSource;
    Material: Material;
    Group: Group;
    Object: Object, "shape" shape Shape;
}

impl Scene {
    /// The object of that name.
    #[must_use]
    pub fn object(&self, name: &str) -> Option<&Object> {
        self.objects.iter().find(|o| o.name == name)
    }

    /// The material of that name.
    #[must_use]
    pub fn material(&self, name: &str) -> Option<&Material> {
        self.materials.iter().find(|m| m.name == name)
    }

    /// The texture of that name.
    #[must_use]
    pub fn texture(&self, name: &str) -> Option<&Texture> {
        self.textures.iter().find(|t| t.name == name)
    }

    /// The group of that name.
    #[must_use]
    pub fn group(&self, name: &str) -> Option<&Group> {
        self.groups.iter().find(|g| g.name == name)
    }

    /// The names in a list, in order.
    pub fn names(&self, list: ListName) -> Box<dyn Iterator<Item = &str> + '_> {
        fn names<T: Item>(items: &[T]) -> Box<dyn Iterator<Item = &str> + '_> {
            Box::new(items.iter().map(Item::name))
        }
        match list {
            ListName::Object => names(&self.objects),
            ListName::Light => names(&self.lights),
            ListName::Material => names(&self.materials),
            ListName::Texture => names(&self.textures),
            ListName::Group => names(&self.groups),
        }
    }
}
