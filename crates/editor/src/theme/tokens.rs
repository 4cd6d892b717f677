//! The tokens: what each colour and size is for.

use crate::files::Config;
use eframe::egui::Color32;

/// The colours of a theme, by purpose, and its sizes.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// Around the picture: the darkest surface.
    pub surround: Color32,
    /// Panels.
    pub panel: Color32,
    /// Bars at the top and bottom.
    pub bar: Color32,
    /// Windows, menus, tooltips: what lies above the panels.
    pub raised: Color32,
    /// Fields in which one types, and rails of sliders.
    pub field: Color32,
    /// Buttons at rest.
    pub button: Color32,
    /// Buttons under the pointer.
    pub button_hover: Color32,
    /// Buttons that are pressed.
    pub button_press: Color32,
    /// Thin lines between parts.
    pub separator: Color32,
    /// Borders of fields and buttons.
    pub border: Color32,
    /// Text.
    pub text: Color32,
    /// Titles and what is selected.
    pub text_strong: Color32,
    /// Labels, hints, units: less important text.
    pub text_muted: Color32,
    /// The one colour that calls: the main button, focus, filled rails.
    pub accent: Color32,
    /// Text on the accent.
    pub on_accent: Color32,
    /// Behind what is selected or switched on.
    pub selection: Color32,
    /// Text on that.
    pub on_selection: Color32,
    /// Something is wrong: text.
    pub error_text: Color32,
    /// Something may be wrong: text.
    pub warning_text: Color32,
    /// Something went well: text.
    pub success_text: Color32,
    /// The X axis and its letter.
    pub axis_x: Color32,
    /// The Y axis and its letter.
    pub axis_y: Color32,
    /// The Z axis and its letter.
    pub axis_z: Color32,
    /// The outline of what is selected, in the picture.
    pub outline: Color32,
    /// A dark seam beside outlines and handles, so that they are seen on any picture.
    pub outline_seam: Color32,
    /// Knobs of sliders.
    pub knob: Color32,
    /// Handles that have no axis.
    pub handle: Color32,
    /// Handles under the pointer.
    pub handle_hover: Color32,
    /// Over the window while a dialog is open.
    pub veil: Color32,
    /// Shadows of windows and menus.
    pub shadow: Color32,
    /// Lengths, in points.
    pub sizes: Sizes,
}

/// Lengths, in points. What holds text grows with large text, the rest does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Text.
    pub text: f32,
    /// Hints and units.
    pub text_small: f32,
    /// Titles of sections.
    pub text_section: f32,
    /// Titles of dialogs.
    pub text_title: f32,
    /// Titles of whole screens.
    pub text_display: f32,
    /// Icons in buttons.
    pub icon: f32,
    /// Icons of the toolbar.
    pub icon_tool: f32,
    /// Controls: buttons, fields.
    pub control: f32,
    /// Buttons of the toolbar.
    pub tool: f32,
    /// Knobs of sliders: their radius.
    pub knob: f32,
    /// Rows of lists.
    pub row: f32,
    /// The toolbar's height.
    pub toolbar: f32,
    /// The menu bar's height.
    pub menu_bar: f32,
    /// The bottom line's height.
    pub status: f32,
    /// A hair: between things that belong together.
    pub gap_xs: f32,
    /// Between a label and its control.
    pub gap_s: f32,
    /// Between controls; the margin of panels is twice this.
    pub gap_m: f32,
    /// Between groups of controls.
    pub gap_l: f32,
    /// Between parts of a dialog.
    pub gap_xl: f32,
    /// Corners of controls.
    pub radius: u8,
    /// Corners of windows and cards.
    pub radius_l: u8,
    /// Thin lines.
    pub line: f32,
    /// Lines that must be seen: focus, outlines.
    pub line_bold: f32,
    /// The list's width.
    pub list_width: f32,
    /// The width of the panel of properties.
    pub properties_width: f32,
    /// A usual dialog's width.
    pub dialog_width: f32,
    /// A wide dialog's width.
    pub dialog_wide: f32,
    /// A picture of a material in the strip, both ways.
    pub thumbnail: f32,
    /// A picture of a template in the gallery: its width.
    pub card_width: f32,
    /// The length of a handle's arm in the picture.
    pub handle_arm: f32,
    /// How near to a handle the pointer must be.
    pub handle_grab: f32,
    /// The widest that a tooltip becomes.
    pub tooltip_width: f32,
}

impl Sizes {
    const NORMAL: Self = Self::scaled(1.0);
    const LARGE: Self = Self::scaled(1.25);

    const fn scaled(k: f32) -> Self {
        Self {
            text: 13.0 * k,
            text_small: 12.0 * k,
            text_section: 13.0 * k,
            text_title: 17.0 * k,
            text_display: 24.0 * k,
            icon: 16.0 * k,
            icon_tool: 18.0 * k,
            control: 26.0 * k,
            tool: 32.0 * k,
            knob: 7.0 * k,
            row: 26.0 * k,
            toolbar: 44.0 * k,
            menu_bar: 30.0 * k,
            status: 28.0 * k,
            gap_xs: 2.0,
            gap_s: 4.0,
            gap_m: 8.0,
            gap_l: 12.0,
            gap_xl: 20.0,
            radius: 6,
            radius_l: 10,
            line: 1.0,
            line_bold: 2.0,
            // Large letters need some more room, which the picture has at the sides.
            list_width: 210.0 + 80.0 * (k - 1.0),
            properties_width: 260.0 + 80.0 * (k - 1.0),
            dialog_width: 440.0,
            dialog_wide: 720.0,
            thumbnail: 72.0,
            card_width: 220.0,
            handle_arm: 84.0,
            handle_grab: 8.0,
            tooltip_width: 300.0 * k,
        }
    }
}

impl Theme {
    const NORMAL: Self = Self {
        surround: rgb(0x1b_1a19),
        panel: rgb(0x27_2625),
        bar: rgb(0x21_201f),
        raised: rgb(0x31_302e),
        field: rgb(0x1d_1c1b),
        button: rgb(0x38_3634),
        button_hover: rgb(0x45_4340),
        button_press: rgb(0x2d_2b2a),
        separator: rgb(0x39_3735),
        border: rgb(0x4b_4846),
        text: rgb(0xe4_e2de),
        text_strong: rgb(0xfb_faf8),
        text_muted: rgb(0xb0_aca6),
        accent: rgb(0x57_c7c0),
        on_accent: rgb(0x0b_2422),
        selection: rgb(0x1f_4c4b),
        on_selection: rgb(0xe6_faf8),
        error_text: rgb(0xff_958a),
        warning_text: rgb(0xec_bf6c),
        success_text: rgb(0x8c_d39a),
        axis_x: rgb(0xf2_7d78),
        axis_y: rgb(0x8f_cb74),
        axis_z: rgb(0x7b_aef5),
        outline: rgb(0x6f_e5dd),
        outline_seam: rgba(0x00_0000, 150),
        knob: rgb(0xd6_d3ce),
        handle: rgb(0xf4_f2ee),
        handle_hover: rgb(0xff_d873),
        veil: rgba(0x0c_0b0b, 150),
        shadow: rgba(0x00_0000, 110),
        sizes: Sizes::NORMAL,
    };

    const HIGH_CONTRAST: Self = Self {
        surround: rgb(0x0d_0d0c),
        panel: rgb(0x12_1211),
        bar: rgb(0x08_0808),
        raised: rgb(0x1a_1a19),
        field: rgb(0x00_0000),
        button: rgb(0x26_2625),
        button_hover: rgb(0x3a_3a38),
        button_press: rgb(0x00_0000),
        separator: rgb(0x7a_7a77),
        border: rgb(0xa8_a8a4),
        text: rgb(0xff_ffff),
        text_strong: rgb(0xff_ffff),
        text_muted: rgb(0xdc_dcd8),
        accent: rgb(0x6f_f0e6),
        on_accent: rgb(0x00_0000),
        selection: rgb(0x00_4744),
        on_selection: rgb(0xff_ffff),
        error_text: rgb(0xff_b3aa),
        warning_text: rgb(0xff_d67a),
        success_text: rgb(0xa6_f0b4),
        axis_x: rgb(0xff_9f9a),
        axis_y: rgb(0xa9_ef8a),
        axis_z: rgb(0xa3_c9ff),
        outline: rgb(0x7f_fff5),
        outline_seam: rgb(0x00_0000),
        knob: rgb(0xff_ffff),
        handle: rgb(0xff_ffff),
        handle_hover: rgb(0xff_e14d),
        veil: rgba(0x00_0000, 190),
        shadow: rgba(0x00_0000, 0),
        sizes: Sizes::NORMAL,
    };

    const NORMAL_LARGE: Self = Self { sizes: Sizes::LARGE, ..Self::NORMAL };
    const HIGH_CONTRAST_LARGE: Self = Self { sizes: Sizes::LARGE, ..Self::HIGH_CONTRAST };

    /// The theme that the settings of the program ask for.
    #[must_use]
    pub const fn of_config(config: &Config) -> &'static Self {
        match (config.high_contrast, config.large_text) {
            (false, false) => &Self::NORMAL,
            (false, true) => &Self::NORMAL_LARGE,
            (true, false) => &Self::HIGH_CONTRAST,
            (true, true) => &Self::HIGH_CONTRAST_LARGE,
        }
    }

    /// The colour of an axis, 0 to 2 for X, Y, Z.
    #[must_use]
    pub const fn axis(&self, index: usize) -> Color32 {
        match index {
            0 => self.axis_x,
            1 => self.axis_y,
            _ => self.axis_z,
        }
    }
}

/// What a picture is multiplied by to be shown as it is.
pub const UNTINTED: Color32 = Color32::WHITE;

/// A colour of the scene's, as it is shown: each component 0 to 1, with the display's curve.
#[must_use]
pub fn shown(srgb: [f32; 3]) -> Color32 {
    let [r, g, b] = srgb.map(|v| (v.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

const fn rgb(hex: u32) -> Color32 {
    let [_, r, g, b] = hex.to_be_bytes();
    Color32::from_rgb(r, g, b)
}

const fn rgba(hex: u32, alpha: u8) -> Color32 {
    let [_, r, g, b] = hex.to_be_bytes();
    Color32::from_rgba_premultiplied(times(r, alpha), times(g, alpha), times(b, alpha), alpha)
}

const fn times(value: u8, alpha: u8) -> u8 {
    (value as u16 * alpha as u16 / 255) as u8
}
