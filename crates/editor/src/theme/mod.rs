//! How the window looks: one calm dark theme of our own, neutral and a little warm so that it does not tint the judgement
//! of the picture. All colours, sizes, fonts and icons of the window come from here.

#![allow(clippy::disallowed_methods, reason = "the one place where colours are made")]

mod fonts;
pub mod icons;
mod style;
mod tokens;

pub use fonts::icon_font;
pub use tokens::{Sizes, Theme, UNTINTED, shown};

use crate::files::Config;
use eframe::egui::{Context, Id};

/// Gives the whole window its look, as the settings of the program say. Call it at the start and when they change; fonts are
/// there from the next frame on.
pub fn apply(ctx: &Context, config: &Config) {
    let theme = Theme::of_config(config);
    ctx.data_mut(|data| data.insert_temp(key(), config.high_contrast));
    ctx.data_mut(|data| data.insert_temp(key().with("large"), config.large_text));
    fonts::install(ctx);
    style::install(ctx, theme);
}

/// The theme in force. A `Ui` serves as well as a context.
#[must_use]
pub fn of(ctx: &Context) -> &'static Theme {
    let high_contrast = ctx.data(|data| data.get_temp(key())).unwrap_or_default();
    let large_text = ctx.data(|data| data.get_temp(key().with("large"))).unwrap_or_default();
    Theme::of_config(&Config { high_contrast, large_text, ..Config::default() })
}

fn key() -> Id {
    Id::new("vitrine theme")
}

#[cfg(test)]
mod tests;
