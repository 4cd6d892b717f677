//! How the settings of a scene show a picture.

use crate::film::{Display, ViewTransform};
use crate::scene::{Settings, View};

/// The way from linear light to the display that the settings ask for.
#[must_use]
pub fn display_of(settings: &Settings) -> Display {
    let view = match settings.view() {
        View::Neutral => ViewTransform::Neutral,
        View::Agx => ViewTransform::Agx,
        View::Srgb => ViewTransform::Srgb,
    };
    Display { view, exposure: settings.exposure, white_balance: settings.white_balance }
}

/// The settings without what only shows the picture: where two agree in all else, they make the same light.
#[must_use]
pub fn without_display(settings: &Settings) -> Settings {
    let Settings { view, exposure, white_balance, .. } = Settings::default();
    Settings { view, exposure, white_balance, ..settings.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Renderer;

    #[test]
    fn classic_pictures_are_shown_as_ever_and_photoreal_ones_neutral() {
        let of = |renderer| display_of(&Settings { renderer, ..Settings::default() });
        assert_eq!(of(Renderer::Classic), Display::default());
        assert_eq!(of(Renderer::Photoreal), Display::of_view(ViewTransform::Neutral));
        let settings = Settings { view: Some(View::Agx), exposure: 1.5, ..Settings::default() };
        assert_eq!(display_of(&settings), Display { exposure: 1.5, ..Display::of_view(ViewTransform::Agx) });
    }
}
