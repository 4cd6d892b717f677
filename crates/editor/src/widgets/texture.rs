//! The picture or pattern on a surface.

use super::choice_field;
use super::field::{Field, Shown};
use crate::tr;
use eframe::egui::Ui;
use vitrine::scene::Scene;

/// What a person asks of the chooser of textures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TextureAnswer {
    /// None: the plain colour.
    None,
    /// The texture of that name.
    Texture(String),
    /// Let me choose a picture file.
    ChooseFile,
    /// A new pattern.
    NewPattern,
}

/// A label and a list: none, the scene's textures, a new pattern, a picture file.
pub fn texture_chooser(
    ui: &mut Ui,
    field: &Field<'_>,
    current: Option<&str>,
    scene: &Scene,
) -> Option<TextureAnswer> {
    let named = |name: &str| (TextureAnswer::Texture(name.to_owned()), name.to_owned());
    let mut choices = vec![(TextureAnswer::None, tr!("widgets-texture-none"))];
    choices.extend(scene.textures.iter().map(|t| named(&t.name)));
    choices.push((TextureAnswer::NewPattern, tr!("widgets-texture-pattern")));
    choices.push((TextureAnswer::ChooseFile, tr!("widgets-texture-file")));
    let current = current.map_or(TextureAnswer::None, |name| TextureAnswer::Texture(name.to_owned()));
    let current = (field.shown != Shown::Mixed).then_some(current);
    choice_field(ui, field, current.as_ref(), &choices)
}
