//! What the theme promises: contrast that people can read, and a glyph for every character.

use super::*;
use crate::text::Language;
use eframe::egui::{Color32, FontId};

fn configs() -> [Config; 4] {
    [(false, false), (false, true), (true, false), (true, true)].map(|(high_contrast, large_text)| Config {
        high_contrast,
        large_text,
        ..Config::default()
    })
}

/// WCAG 2.1: (L₁ + 0.05) / (L₂ + 0.05), L the relative luminance.
fn contrast(a: Color32, b: Color32) -> f32 {
    let luminance = |c: Color32| {
        let [r, g, b] = [c.r(), c.g(), c.b()].map(|v| {
            let v = f32::from(v) / 255.0;
            if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    };
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[test]
fn contrast_is_computed_as_wcag_says() {
    assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-3);
    assert!((contrast(Color32::from_gray(118), Color32::WHITE) - 4.54).abs() < 0.01);
}

#[test]
fn every_text_can_be_read_on_every_surface() {
    for config in configs() {
        let t = Theme::of_config(&config);
        let wanted = if config.high_contrast { 7.0 } else { 4.5 };
        let surfaces = [t.surround, t.panel, t.bar, t.raised, t.field, t.button, t.button_press];
        let texts = [t.text, t.text_strong, t.text_muted, t.error_text, t.warning_text, t.success_text];
        let axes = [t.axis_x, t.axis_y, t.axis_z, t.accent];
        for (i, surface) in surfaces.into_iter().enumerate() {
            for (j, text) in texts.into_iter().chain(axes).enumerate() {
                let ratio = contrast(text, surface);
                assert!(ratio >= wanted, "text {j} on surface {i}, {config:?}: {ratio}");
            }
        }
        for (text, surface) in [
            (t.on_accent, t.accent),
            (t.on_selection, t.selection),
            (t.text_strong, t.selection),
            (t.text_strong, t.button_hover),
        ] {
            assert!(contrast(text, surface) >= wanted, "{text:?} on {surface:?}, {config:?}");
        }
    }
}

#[test]
fn large_text_is_a_quarter_larger() {
    let [normal, large, ..] = configs().map(|c| Theme::of_config(&c).sizes);
    assert_eq!(large.text, normal.text * 1.25);
    assert_eq!(large.control, normal.control * 1.25);
}

#[test]
fn the_theme_in_force_is_the_one_that_was_applied() {
    for config in configs() {
        let ctx = Context::default();
        apply(&ctx, &config);
        assert_eq!(of(&ctx), Theme::of_config(&config));
    }
}

/// Every character of the locales and the icons of kinds, in the fonts that the window uses.
#[test]
fn every_character_has_a_glyph() {
    let ctx = Context::default();
    apply(&ctx, &Config::default());
    let mut texts: String = "←→▲▼●✓°×·•…—–«»№".into();
    texts.push_str(
        include_str!("icons.rs")
            .split('"')
            .skip(1)
            .step_by(2)
            .map(icons::of_kind)
            .collect::<String>()
            .as_str(),
    );
    [icons::UNDO, icons::SAVE, icons::SHOWN, icons::DISC_LAMP, icons::LOCK]
        .iter()
        .for_each(|i| texts.push_str(i));
    for language in Language::ALL {
        crate::text::files_of(language).iter().for_each(|(_, text)| texts.push_str(text));
    }
    let mut output = ctx.run_ui(eframe::egui::RawInput::default(), |ui| {
        let missing: Vec<char> = ui.fonts_mut(|fonts| {
            let font = FontId::proportional(13.0);
            texts.chars().filter(|c| !c.is_control() && !fonts.has_glyph(&font, *c)).collect()
        });
        assert!(missing.is_empty(), "{missing:?}");
    });
    output.textures_delta.clear();
}
