//! What a stopped render was of: a mark of the scene, and the settings by name.

use crate::SceneHash;
use crate::formats::scene_file::print_new;
use crate::math::{Vec2, Vec3};
use crate::scene::params::{Params, Value};
use crate::scene::{Assets, Scene, Settings};

/// The settings that may differ when a render goes on: how long to render, and how to show the picture.
const FREE: [&str; 7] = ["samples", "noise", "time_limit", "denoise", "view", "exposure", "white_balance"];

/// A mark of everything that makes the picture, the settings apart. Remarks in the scene's file do not count.
pub fn scene_mark(scene: &Scene, assets: &Assets) -> String {
    let bare = Scene { settings: Settings::default(), ..scene.clone() };
    let mut hash = SceneHash::of(&print_new(&bare));
    for (path, mesh) in &assets.meshes {
        hash = hash.and_text(&path.to_string_lossy());
        hash = hash.and_text(&format!("{:?} {:?}", mesh.parts, mesh.materials));
        hash = hash.and_numbers(mesh.positions.iter().chain(&mesh.normals).flat_map(Vec3::to_array));
        hash = hash.and_numbers(mesh.uvs.iter().flat_map(Vec2::to_array));
        hash = hash.and_words(mesh.triangles.as_flattened().iter().copied());
    }
    for (path, picture) in &assets.pictures {
        hash = hash.and_text(&path.to_string_lossy()).and_words(picture.size);
        hash = hash.and_words(picture.texels.iter().map(|[r, g, b]| u32::from_le_bytes([*r, *g, *b, 0])));
    }
    for (path, map) in &assets.maps {
        hash = hash.and_text(&path.to_string_lossy()).and_words(map.size);
        hash = hash.and_numbers(map.pixels.iter().flat_map(|p| p.to_array()));
    }
    hash.to_string()
}

/// The settings that must be the same, a line for each.
pub fn settings_text(settings: &Settings) -> String {
    let fixed = Settings::SPECS.iter().filter(|spec| !FREE.contains(&spec.name));
    let line = |name: &str| {
        let value = settings.get(name).unwrap_or(Value::Nothing);
        format!("{name} = {}\n", words(&value))
    };
    fixed.map(|spec| line(spec.name)).collect()
}

/// What differs first between the settings of a stopped render and those of now.
pub fn difference(before: &str, now: &str) -> Option<String> {
    if before == now {
        return None;
    }
    let (before, now) = (before.lines(), now.lines());
    let pair = before.zip(now).find(|(before, now)| before != now);
    let (before, now) = pair.unwrap_or_default();
    let value = |line: &str| line.split_once(" = ").map_or(String::new(), |(_, value)| value.to_owned());
    let name = now.split_once(" = ").map_or("", |(name, _)| name);
    Some(format!("its `{name}` was {} and now is {}", value(before), value(now)))
}

fn words(value: &Value) -> String {
    match value {
        Value::Nothing => "not stated".into(),
        Value::Flag(v) => v.to_string(),
        Value::Integer(v) => v.to_string(),
        Value::Number(v) => v.to_string(),
        Value::Size([width, height]) => format!("{width}x{height}"),
        Value::Color(color) => color.to_hex().unwrap_or_else(|| format!("{:?}", color.to_array())),
        Value::Text(text) => text.replace(char::is_control, " "),
        Value::Pair(_) | Value::Vector(_) | Value::Points(_) | Value::Pairs(_) => {
            format!("{value:?}").replace(char::is_control, " ")
        }
    }
}
