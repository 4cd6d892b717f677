//! A scene as a new file: what differs from the defaults, section by section.

use super::section::{ABOUT_KEY, FORMAT, FORMAT_KEY, Section};
use super::text::string_text;
use super::view::View;
use vitrine_scene::{ListName, Scene};

/// The text of a new file for the scene: only what differs from the defaults, and what every file must say.
#[must_use]
pub fn print_new(scene: &Scene) -> String {
    let mut text = format!("{FORMAT_KEY} = {FORMAT}\n");
    if !scene.about.is_empty() {
        text += &format!("{ABOUT_KEY} = {}\n", string_text(&scene.about));
    }
    let settings = View::single(Section::SETTINGS, &scene.settings);
    let camera = View::single(Section::CAMERA, &scene.camera);
    let sections = [settings, camera].into_iter().filter(|v| !v.is_default());
    for view in sections.chain(ListName::ALL.into_iter().flat_map(|list| View::list(scene, list))) {
        text.push('\n');
        text += &view.block("\n");
    }
    text
}
