//! Why a picture is black, white or empty, and what mends it: each mend is an edit that the person may make with one click.

mod closed;
mod light;
mod problems;
mod view;

pub use problems::{ProblemLine, problems};

use crate::document::{Document, EditCommand, Message, Thing};
use vitrine::display_of;
use vitrine::scene::Settings;

/// How bright the picture is that a person sees: which shares of its pixels, 0 to 1 each, are as good as black, as good as
/// white, and background.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Brightness {
    /// Black.
    pub black: f32,
    /// White.
    pub white: f32,
    /// Nothing but the background's colour.
    pub background: f32,
}

impl Brightness {
    /// Of a picture as it is shown: red, green, blue and opacity, 8 bits each. `settings` are the scene's.
    #[must_use]
    pub fn of(rgba: &[u8], settings: &Settings) -> Self {
        let background = display_of(settings).display(settings.background).map(|v| (v * 255.0).round() as u8);
        let count = |is_so: &dyn Fn(&[u8]) -> bool| rgba.chunks_exact(4).filter(|p| is_so(p)).count() as f32;
        let all = (rgba.len() / 4).max(1) as f32;
        Self {
            black: count(&|p| p[..3].iter().all(|v| *v <= 4)) / all,
            white: count(&|p| p[..3].iter().all(|v| *v >= 252)) / all,
            background: count(&|p| p[..3].iter().zip(background).all(|(v, b)| v.abs_diff(b) <= 1)) / all,
        }
    }

    /// A share that makes a picture black, white or empty as a whole.
    const WHOLE: f32 = 0.97;
    /// A share of white that is no highlight any more.
    const MUCH: f32 = 0.4;
}

/// A cause of a black, white or empty picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// What is the matter.
    pub message: Message,
    /// The things concerned, to select them.
    pub things: Vec<Thing>,
    /// The words on the button that mends it.
    pub mend_label: Message,
    /// What mends it.
    pub mend: EditCommand,
}

/// Everything that makes the picture black, white or empty, the gravest first. Without a look at the picture only what is
/// certain from the scene alone.
#[must_use]
pub fn diagnose(document: &Document, picture: Option<Brightness>) -> Vec<Diagnosis> {
    let mut found = view::diagnose(document, picture);
    found.extend(light::diagnose(document, picture));
    found
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod texts;
