//! Where the scenes are, and small pictures of them.

use std::path::{Path, PathBuf};
use vitrine::math::{Rgb, Vec3};
use vitrine::{Image, Project};

/// The folder of the example scenes.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

/// Every scene file, by its path in the folder, with `/`.
pub fn all_scenes() -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![String::new()];
    while let Some(inner) = folders.pop() {
        for entry in std::fs::read_dir(folder().join(&inner)).unwrap() {
            let entry = entry.unwrap();
            let path = format!("{inner}{}", entry.file_name().to_string_lossy());
            if entry.file_type().unwrap().is_dir() {
                folders.push(path + "/");
            } else if path.ends_with(".vitrine.toml") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// A scene by its path in the folder.
pub fn load(file: &str) -> Project {
    vitrine::load(folder().join(file)).unwrap_or_else(|e| panic!("{file}: {e}"))
}

/// A scene of the course work by its name.
pub fn coursework(name: &str) -> Project {
    load(&format!("coursework/{name}.vitrine.toml"))
}

/// The picture of a scene with some values changed.
pub fn picture(project: &Project, changes: &[&str]) -> Image {
    let mut changed = vitrine::load(project.path()).unwrap();
    changed.scene = project.scene.clone();
    changed.set(changes).unwrap();
    let rendered = vitrine::render(&changed, 0).unwrap();
    assert!(rendered.is_complete());
    rendered.film.image()
}

/// What the picture of a scene shows at a point of space.
pub fn at(project: &Project, image: &Image, point: Vec3) -> Rgb {
    let camera = &project.scene.camera;
    let [width, height] = image.size.map(|n| n as f32);
    // In front of the camera, 1 m away, the picture is as high as twice the tangent of half the view angle.
    let seen = camera.rotation().transpose() * (point - camera.position);
    let half = (camera.view_angle_deg.to_radians() / 2.0).tan();
    let (x, y) = (seen.x / -seen.z / half, seen.y / -seen.z / half);
    let (x, y) = (width / 2.0 + x * height / 2.0, height / 2.0 - y * height / 2.0);
    assert!((0.0..width).contains(&x) && (0.0..height).contains(&y), "{point} is not in the picture");
    image.pixel(x as u32, y as u32)
}
