//! Scenes by chance, made from the descriptions alone: a new kind or parameter is in them from its first day.

use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{
    Item, ListName, Object, Owner, ParamKind, ParamSpec, Params, Range, Scene, Value, params,
};

/// Does something with a list of a scene, whatever it holds.
macro_rules! in_list {
    ($scene:ident, $list:ident, $items:ident => $do:expr) => {
        match $list {
            ListName::Light => {
                let $items = &mut $scene.lights;
                $do;
            }
            ListName::Texture => {
                let $items = &mut $scene.textures;
                $do;
            }
            ListName::Material => {
                let $items = &mut $scene.materials;
                $do;
            }
            ListName::Group => {
                let $items = &mut $scene.groups;
                $do;
            }
            ListName::Object => {
                let $items = &mut $scene.objects;
                $do;
            }
        }
    };
}

/// Throws that are the same for the same seed.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// SplitMix64.
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    pub fn chance(&mut self, one_in: usize) -> bool {
        self.below(one_in) == 0
    }

    pub fn one_of<T: Clone>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())].clone()
    }

    /// A number of the range: a plain one, or any of the many that there are.
    fn number(&mut self, range: Range) -> f32 {
        let plain = [0.0, 1.0, -1.0, 0.1, 0.3, 2.5, 100.0, 1e-3, 0.7, 33.33, -0.0, 1e10];
        loop {
            let number = match self.below(3) {
                0 => self.one_of(&plain),
                1 => (self.next() >> 40) as f32 / 16_777_216.0,
                _ => f32::from_bits(self.next() as u32),
            };
            if range.contains(number) {
                return number;
            }
        }
    }

    fn vector(&mut self, range: Range) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|_| self.number(range)))
    }

    fn integer(&mut self, min: i64, max: i64) -> i64 {
        let span = (max - min) as u64 + 1;
        min + if self.chance(2) { (self.next() % span.min(10)) as i64 } else { (self.next() % span) as i64 }
    }

    /// A text with all that makes trouble in files.
    pub fn text(&mut self) -> String {
        const PARTS: [&str; 18] = [
            "ball", "мяч", " ", ".", "\"", "'", "\\", "\n", "\t", "#", "=", "]", "🔮", "\u{7f}", "\r\n", "0",
            "é", "\u{0}",
        ];
        (0..1 + self.below(4)).map(|_| self.one_of(&PARTS)).collect::<String>() + "x"
    }

    fn value(&mut self, spec: &ParamSpec, scene: &Scene) -> Value {
        if spec.is_optional() && self.chance(2) {
            return Value::Nothing;
        }
        match spec.kind {
            ParamKind::Flag => Value::Flag(self.chance(2)),
            ParamKind::Integer { min, max } => Value::Integer(self.integer(min, max)),
            ParamKind::Number(range) => Value::Number(self.number(range)),
            // Small enough for one picture.
            ParamKind::Size { min, max } => Value::Size([(); 2].map(|()| self.integer(min, max.min(4000)))),
            ParamKind::Pair(range) => Value::Pair([(); 2].map(|()| self.number(range))),
            ParamKind::Vector(range) => Value::Vector(self.vector(range)),
            ParamKind::Direction | ParamKind::Scale if self.chance(3) => Value::Vector(Vec3::splat(2.0)),
            ParamKind::Direction | ParamKind::Scale => Value::Vector(self.vector(Range::from_to(0.01, 1e6))),
            ParamKind::Color if self.chance(2) => {
                Value::Color(Rgb::from_srgb8([(); 3].map(|()| self.below(256) as u8)))
            }
            ParamKind::Color => Value::Color(self.vector(Range::NOT_NEGATIVE).to_array().into()),
            ParamKind::Points(count) => {
                // A proper triangle and whatever else there may be.
                let corner =
                    |i: usize| [Vec3::ZERO, Vec3::X, Vec3::Y][i % 3] * self.number(Range::from_to(0.1, 9.0));
                Value::Points((0..count).map(corner).collect())
            }
            ParamKind::Pairs(count) => {
                Value::Pairs((0..count).map(|_| [(); 2].map(|()| self.number(Range::ANY))).collect())
            }
            ParamKind::Choice(words) => Value::Text(self.one_of(words).into()),
            ParamKind::Text | ParamKind::File => Value::Text(self.text()),
            ParamKind::Reference(list) => {
                let names: Vec<_> = scene.names(list).collect();
                if names.is_empty() { Value::Nothing } else { Value::Text(self.one_of(&names).into()) }
            }
        }
    }

    fn params(&mut self, target: &mut dyn Params, scene: &Scene) {
        for spec in target.specs() {
            if spec.required || self.chance(2) {
                let value = self.value(spec, scene);
                params::set(target, spec.name, value.clone()).unwrap_or_else(|e| panic!("{e}: {value:?}"));
            }
        }
    }

    fn item<T: Item + Default>(&mut self, scene: &Scene) -> T {
        let mut item = T::default();
        if let Some((_, kinds)) = T::KINDS {
            assert!(item.set_kind(self.one_of(kinds).name));
        }
        let name = loop {
            let name = self.text();
            if scene.names(T::LIST).all(|n| n != name) {
                break name;
            }
        };
        item.rename(name);
        self.params(&mut item, scene);
        if let Some(kind) = item.kind_params_mut() {
            self.params(kind, scene);
        }
        item
    }

    /// Adds an entry to a list.
    fn add(&mut self, scene: &mut Scene, list: ListName) {
        let at = self.below(scene.names(list).count() + 1);
        macro_rules! insert {
            ($($list:ident $field:ident),*) => {
                match list {
                    $(ListName::$list => {
                        let item = self.item(scene);
                        scene.$field.insert(at, item);
                    })*
                }
            };
        }
        insert!(Light lights, Texture textures, Material materials, Group groups, Object objects);
    }

    /// A scene that has no errors.
    pub fn scene(&mut self) -> Scene {
        let mut scene = Scene::default();
        if self.chance(2) {
            scene.about = self.text();
        }
        let empty = Scene::default();
        self.params(&mut scene.settings, &empty);
        self.params(&mut scene.camera, &empty);
        for list in ListName::ALL {
            for _ in 0..self.below(4) {
                self.add(&mut scene, list);
            }
        }
        mend(scene)
    }

    /// A scene with entries of every kind.
    pub fn scene_with_all(&mut self) -> Scene {
        let mut scene = Scene::default();
        for list in ListName::ALL {
            // Enough that no kind is left out by chance.
            (0..60).for_each(|_| self.add(&mut scene, list));
        }
        mend(scene)
    }

    /// The scene after a few changes of every sort.
    pub fn changed(&mut self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        for _ in 0..1 + self.below(6) {
            self.change(&mut scene);
        }
        mend(scene)
    }

    fn change(&mut self, scene: &mut Scene) {
        let list = self.one_of(&ListName::ALL);
        let count = scene.names(list).count();
        match self.below(8) {
            0 => scene.about = if self.chance(2) { String::new() } else { self.text() },
            1 => self.add(scene, list),
            2 if count > 0 => remove(scene, list, self.below(count)),
            3 if count > 1 => swap(scene, list, self.below(count), self.below(count)),
            4 if count > 0 => {
                let name = self.text();
                if scene.names(list).all(|n| n != name) {
                    rename(scene, list, self.below(count), name);
                }
            }
            5 if !scene.objects.is_empty() => {
                // Another shape, and whatever of the old one's keys it has too.
                let at = self.below(scene.objects.len());
                let other: Object = self.item(scene);
                scene.objects[at].shape = other.shape;
            }
            _ => {
                let item = Owner::Item(list, self.below(count.max(1)));
                let owner = self.one_of(&[Owner::Settings, Owner::Camera, item, item, item]);
                let specs = scene.specs(owner);
                if !specs.is_empty() {
                    let spec = self.one_of(&specs);
                    let value = self.value(spec, scene);
                    let _ = scene.set(owner, spec.name, value);
                }
            }
        }
    }
}

fn remove(scene: &mut Scene, list: ListName, at: usize) {
    in_list!(scene, list, items => items.remove(at));
}

fn swap(scene: &mut Scene, list: ListName, a: usize, b: usize) {
    in_list!(scene, list, items => items.swap(a, b));
}

fn rename(scene: &mut Scene, list: ListName, at: usize, name: String) {
    in_list!(scene, list, items => items[at].rename(name));
}

/// Takes back what no file may say: two aims of the camera, an aperture of two blades, groups in a ring, references to what is gone.
fn mend(mut scene: Scene) -> Scene {
    if matches!(scene.camera.blades, 1 | 2) {
        scene.camera.blades = 0;
    }
    if scene.camera.turn_deg.is_some() || scene.camera.fault().is_some() {
        scene.camera.look_at = None;
    }
    let names: Vec<String> = scene.names(ListName::Group).map(str::to_owned).collect();
    for (i, group) in scene.groups.iter_mut().enumerate() {
        let outer = group.group.as_ref().and_then(|g| names.iter().position(|n| n == g));
        group.group = outer.filter(|o| *o < i).map(|o| names[o].clone());
    }
    for list in ListName::ALL {
        for index in 0..scene.names(list).count() {
            let owner = Owner::Item(list, index);
            for spec in scene.specs(owner) {
                let ParamKind::Reference(to) = spec.kind else { continue };
                let Some(Value::Text(name)) = scene.value(owner, spec.name) else { continue };
                if scene.names(to).all(|n| n != name) {
                    scene.set(owner, spec.name, Value::Nothing).unwrap();
                }
            }
        }
    }
    scene
}
