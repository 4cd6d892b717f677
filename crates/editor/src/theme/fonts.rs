//! Fonts: Inter for text, Phosphor for icons. Inter's private-use characters were left out of the bundled file, so the two
//! never claim the same code point; egui's own fonts stand behind them for whatever else a person types.

use eframe::egui::{Context, FontData, FontDefinitions, FontFamily, FontId};
use egui_phosphor::Variant;

const TEXT: &str = "inter";
const ICONS: &str = "icons";

/// The font of icons alone, at a size in points. In running text icons need no font of their own.
#[must_use]
pub fn icon_font(size: f32) -> FontId {
    FontId::new(size, FontFamily::Name(ICONS.into()))
}

pub(super) fn install(ctx: &Context) {
    ctx.set_fonts(definitions());
}

fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let inter = include_bytes!("../../../../assets/fonts/Inter-Regular.otf");
    fonts.font_data.insert(TEXT.into(), FontData::from_static(inter).into());
    fonts.font_data.insert(ICONS.into(), FontData::from_static(Variant::Regular.font_bytes()).into());
    let others = fonts.families.entry(FontFamily::Proportional).or_default();
    // Icons come second: their font has empty letters a to z.
    others.splice(0..0, [TEXT.into(), ICONS.into()]);
    let family = others.clone();
    fonts.families.insert(FontFamily::Name(ICONS.into()), family);
    fonts
}
