//! Scenes by chance, made from the descriptions of the parameters alone, so that a new kind or parameter is in them from its
//! first day. Whatever is allowed gives an error or a picture of finite numbers, none below zero.

use crate::common::{Dice, run};
use crate::models;
use proptest::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;
use vitrine_film::Image;
use vitrine_math::{Rgb, Vec3, hash};
use vitrine_render::accel::simd::Instructions;
use vitrine_render::{CompileError, RenderOptions, compile};
use vitrine_scene::{
    Assets, Item, KindSpec, LightSource, ListName, Owner, ParamKind, ParamSpec, Picture, RadianceMap, Range,
    Scene, Severity, Shape, TextureSource, TriangleMesh, Value,
};

const MODELS: [&str; 4] = ["cube.obj", "ball.obj", "square.obj", "odd.obj"];
const PICTURES: [&str; 2] = ["dot.png", "four.png"];
const PANORAMAS: [&str; 1] = ["bright.hdr"];

fn assets() -> Assets {
    let mut smooth = models::faceted_ball(1.0, 3);
    smooth.normals = smooth.positions.clone();
    // Triangles without area, a needle, and normals that are missing or opposed.
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::X * 2.0, Vec3::new(0.5, 1e-6, 0.0), Vec3::Y];
    let mut odd = models::of(positions, vec![[0, 1, 2], [0, 0, 0], [0, 1, 3], [0, 1, 4], [4, 1, 0]]);
    odd.normals = vec![Vec3::ZERO, Vec3::Y, Vec3::NEG_Y, Vec3::X, Vec3::Z];
    let all: [TriangleMesh; 4] = [models::cube(), smooth, models::square(), odd];
    let pictures = [
        Picture { size: [1, 1], texels: vec![[9, 99, 199]] },
        Picture { size: [2, 2], texels: vec![[0; 3], [255; 3], [255, 0, 0], [0, 255, 0]] },
    ];
    let panoramas = [RadianceMap { size: [2, 1], pixels: vec![Rgb::splat(1e30), Rgb::BLACK] }];
    Assets {
        meshes: MODELS.iter().map(PathBuf::from).zip(all.map(Arc::new)).collect(),
        pictures: PICTURES.iter().map(PathBuf::from).zip(pictures.map(Arc::new)).collect(),
        maps: PANORAMAS.iter().map(PathBuf::from).zip(panoramas.map(Arc::new)).collect(),
    }
}

/// How far the numbers go.
#[derive(Clone, Copy, Debug)]
enum Wild {
    /// Everyday numbers.
    Tame,
    /// One in eight is large, small or at an end of its range.
    Bold,
    /// Half of them are any that there are.
    Mad,
}

/// Writes scenes.
struct Author {
    dice: Dice,
    wild: Wild,
}

impl Author {
    fn below(&mut self, n: usize) -> usize {
        ((self.dice.unit() * n as f32) as usize).min(n - 1)
    }

    fn one_of<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.below(words.len())]
    }

    fn number(&mut self, range: Range) -> f32 {
        const ODD: [f32; 10] = [0.0, 1.0, 1e-3, 1e4, -1e6, 1e9, 1e-9, 1e-20, 3e11, -2e15];
        loop {
            let is_odd = match self.wild {
                Wild::Tame => false,
                Wild::Bold => self.below(8) == 0,
                Wild::Mad => self.below(2) == 0,
            };
            let number = if !is_odd {
                let is_unit = range.min >= 0.0 && range.max <= 1.0;
                let (from, to) = if is_unit { (0.0, 1.0) } else { (-4.0, 4.0) };
                self.dice.between(from, to).clamp(range.min, range.max)
            } else if matches!(self.wild, Wild::Mad) && self.below(2) == 0 {
                f32::from_bits(hash::mix((self.dice.unit() * 16_777_216.0) as u32))
            } else {
                match self.below(ODD.len() + 2) {
                    0 => range.min,
                    1 => range.max,
                    k => ODD[k - 2],
                }
            };
            if range.contains(number) {
                return number;
            }
        }
    }

    fn vector(&mut self, range: Range) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|_| self.number(range)))
    }

    fn pair(&mut self, range: Range) -> [f32; 2] {
        [self.number(range), self.number(range)]
    }

    fn value(&mut self, scene: &Scene, owner: Owner, spec: &ParamSpec) -> Value {
        if spec.is_optional() && self.below(2) == 0 {
            return Value::Nothing;
        }
        let value = match spec.kind {
            ParamKind::Flag => Value::Flag(self.below(4) > 0),
            ParamKind::Integer { min, max } => {
                Value::Integer(min + self.below((max - min).min(30) as usize + 1) as i64)
            }
            ParamKind::Number(range) => Value::Number(self.number(range)),
            ParamKind::Size { .. } => Value::Size([9, 7]),
            ParamKind::Pair(range) => Value::Pair(self.pair(range)),
            ParamKind::Vector(range) => Value::Vector(self.vector(range)),
            ParamKind::Direction | ParamKind::Scale => Value::Vector(self.vector(Range::ANY)),
            ParamKind::Color => Value::Color(Rgb::from(self.vector(Range::NOT_NEGATIVE).to_array())),
            ParamKind::Points(n) => Value::Points((0..n).map(|_| self.vector(Range::ANY)).collect()),
            ParamKind::Pairs(n) => Value::Pairs((0..n).map(|_| self.pair(Range::ANY)).collect()),
            ParamKind::Choice(words) => Value::Text(self.one_of(words).to_owned()),
            ParamKind::Text => Value::Text("a scene by chance".to_owned()),
            ParamKind::File => {
                let files: &[&str] = match owner {
                    Owner::Item(ListName::Object, _) => &MODELS,
                    Owner::Item(ListName::Light, _) => &PANORAMAS,
                    _ => &PICTURES,
                };
                Value::Text(self.one_of(files).to_owned())
            }
            ParamKind::Reference(list) => match scene.names(list).collect::<Vec<_>>() {
                names if names.is_empty() => Value::Nothing,
                names => Value::Text(self.one_of(&names).to_owned()),
            },
        };
        // Where a range has holes, as scales and directions have, the dice are thrown again.
        if spec.check(&value).is_ok() { value } else { self.value(scene, owner, spec) }
    }

    fn fill(&mut self, scene: &mut Scene, owner: Owner) {
        for spec in scene.specs(owner) {
            let value = self.value(scene, owner, spec);
            scene.set(owner, spec.name, value).expect("the value is allowed");
        }
    }

    fn add<T: Item + Default>(
        &mut self,
        scene: &mut Scene,
        list: impl Fn(&mut Scene) -> &mut Vec<T>,
        kinds: &[KindSpec],
    ) {
        let index = list(scene).len();
        let mut item = T::default();
        item.rename(format!("{} {index}", T::LIST.key()));
        if !kinds.is_empty() {
            assert!(item.set_kind(kinds[self.below(kinds.len())].name));
        }
        list(scene).push(item);
        self.fill(scene, Owner::Item(T::LIST, index));
    }

    fn scene(&mut self, objects: usize) -> Scene {
        let mut scene = Scene::default();
        self.fill(&mut scene, Owner::Settings);
        self.fill(&mut scene, Owner::Camera);
        if scene.camera.look_at.is_some() {
            scene.camera.turn_deg = None;
        }
        if matches!(scene.camera.blades, 1 | 2) {
            scene.camera.blades = 0;
        }
        (0..3).for_each(|_| self.add(&mut scene, |s| &mut s.lights, LightSource::KINDS));
        (0..2).for_each(|_| self.add(&mut scene, |s| &mut s.textures, TextureSource::KINDS));
        (0..3).for_each(|_| self.add(&mut scene, |s| &mut s.materials, &[]));
        (0..2).for_each(|_| self.add(&mut scene, |s| &mut s.groups, &[]));
        // Groups in one another, and none in itself.
        scene.groups[0].group = None;
        scene.groups[1].group = scene.groups[1].group.take().map(|_| scene.groups[0].name.clone());
        (0..objects).for_each(|_| self.add(&mut scene, |s| &mut s.objects, Shape::KINDS));
        // Small enough for a test.
        let settings = &mut scene.settings;
        (settings.samples, settings.depth) = (settings.samples.min(3), settings.depth.min(5));
        // What a time limit leaves out nobody can foretell.
        settings.time_limit = 0.0;
        scene
    }
}

fn bits(image: &Image) -> Vec<u32> {
    image.pixels.iter().flat_map(|p| p.to_array().map(f32::to_bits)).collect()
}

/// Whether there was a picture to be looked at.
fn check(seed: u32, wild: Wild, objects: usize) -> bool {
    let scene = Author { dice: Dice(hash::mix(seed)), wild }.scene(objects);
    if scene.problems().iter().any(|p| p.severity == Severity::Error) {
        return false;
    }
    let compiled = match compile(&scene, &assets()) {
        Ok(compiled) => compiled,
        Err(CompileError::OutOfRange { .. } | CompileError::TooThin { .. }) => return false,
        Err(other) => panic!("{other}"),
    };
    compiled.validate().unwrap_or_else(|flaw| panic!("{flaw} in {scene:#?}"));
    let options = || RenderOptions { settings: scene.settings.clone(), region: None };
    let picture = run(&compiled, options(), 1).film.image();
    for p in &picture.pixels {
        // A single wavelength has colours beyond those of displays: less than nothing of some channel.
        let is_sane = scene.settings.renderer == vitrine_scene::Renderer::Photoreal
            || p.to_array().iter().all(|c| *c >= 0.0);
        assert!(p.is_finite() && is_sane, "{p:?} in {scene:#?}");
    }
    let again = run(&compiled.with_instructions(Instructions::Portable), options(), 1).film.image();
    assert!(bits(&picture) == bits(&again), "instructions matter in {scene:#?}");
    true
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn c1_to_c16_any_scene_gives_an_error_or_a_sane_picture(
        seed in any::<u32>(),
        wild in prop_oneof![Just(Wild::Tame), Just(Wild::Bold), Just(Wild::Mad)],
        objects in 0_usize..7,
    ) {
        check(seed, wild, objects);
    }
}

#[test]
fn scenes_by_chance_are_of_use() {
    let count = |wild: Wild| (0..300).filter(|seed| check(*seed, wild, 3)).count();
    let counts = [Wild::Tame, Wild::Bold, Wild::Mad].map(count);
    assert!(counts[0] > 250 && counts[1] > 60 && counts[2] > 10, "{counts:?}");
}
