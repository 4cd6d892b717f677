//! The tokens as egui's style.

use super::{Theme, tokens::Sizes};
use eframe::egui::style::{HandleShape, WidgetVisuals, Widgets};
use eframe::egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, Shadow, Stroke, Style, TextStyle,
    ThemePreference, Vec2, Visuals, vec2,
};

pub(super) fn install(ctx: &Context, theme: &Theme) {
    ctx.set_theme(ThemePreference::Dark);
    ctx.all_styles_mut(|style| *style = of(theme));
}

fn of(theme: &Theme) -> Style {
    let mut style = Style { visuals: visuals(theme), ..Style::default() };
    let sizes = &theme.sizes;
    let font = |size| FontId::new(size, FontFamily::Proportional);
    style.text_styles = [
        (TextStyle::Small, font(sizes.text_small)),
        (TextStyle::Body, font(sizes.text)),
        (TextStyle::Button, font(sizes.text)),
        (TextStyle::Heading, font(sizes.text_title)),
        (TextStyle::Monospace, FontId::new(sizes.text_small, FontFamily::Monospace)),
    ]
    .into();
    style.drag_value_text_style = TextStyle::Body;
    space(&mut style, sizes);
    style.animation_time = 0.12;
    style.interaction.tooltip_delay = 0.4;
    style.explanation_tooltips = false;
    style
}

fn space(style: &mut Style, sizes: &Sizes) {
    let spacing = &mut style.spacing;
    let margin = |size: f32| Margin::same(size as i8);
    spacing.item_spacing = Vec2::splat(sizes.gap_m);
    spacing.button_padding = vec2(sizes.gap_m, sizes.gap_s);
    spacing.interact_size = vec2(sizes.control, sizes.control);
    spacing.window_margin = margin(sizes.gap_xl);
    spacing.menu_margin = margin(sizes.gap_s);
    spacing.indent = sizes.gap_l;
    spacing.icon_width = sizes.icon;
    spacing.icon_width_inner = sizes.icon * 0.55;
    spacing.icon_spacing = sizes.gap_s;
    spacing.slider_rail_height = sizes.gap_s;
    spacing.tooltip_width = sizes.tooltip_width;
    spacing.menu_width = 220.0;
    spacing.combo_height = 320.0;
    spacing.scroll.bar_width = sizes.gap_m;
    spacing.scroll.floating = true;
}

fn visuals(theme: &Theme) -> Visuals {
    let sizes = &theme.sizes;
    let mut visuals = Visuals::dark();
    visuals.override_text_color = None;
    visuals.weak_text_color = Some(theme.text_muted);
    visuals.widgets = widgets(theme);
    visuals.selection.bg_fill = theme.selection;
    visuals.selection.stroke = Stroke::new(sizes.line, theme.on_selection);
    visuals.hyperlink_color = theme.accent;
    visuals.faint_bg_color = theme.raised;
    visuals.extreme_bg_color = theme.field;
    visuals.text_edit_bg_color = Some(theme.field);
    visuals.code_bg_color = theme.field;
    visuals.warn_fg_color = theme.warning_text;
    visuals.error_fg_color = theme.error_text;
    visuals.window_corner_radius = CornerRadius::same(sizes.radius_l);
    visuals.menu_corner_radius = CornerRadius::same(sizes.radius + 2);
    visuals.window_fill = theme.raised;
    visuals.window_stroke = Stroke::new(sizes.line, theme.border);
    visuals.window_highlight_topmost = false;
    visuals.panel_fill = theme.panel;
    let shadow = |y, blur| Shadow { offset: [0, y], blur, spread: 0, color: theme.shadow };
    visuals.window_shadow = shadow(12, 36);
    visuals.popup_shadow = shadow(6, 18);
    visuals.text_cursor.stroke = Stroke::new(sizes.line_bold, theme.accent);
    visuals.slider_trailing_fill = true;
    visuals.handle_shape = HandleShape::Circle;
    visuals.indent_has_left_vline = false;
    visuals.striped = false;
    visuals
}

fn widgets(theme: &Theme) -> Widgets {
    let line = theme.sizes.line;
    let state = |fill: Color32, border: Color32, text: Color32| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(line, border),
        corner_radius: CornerRadius::same(theme.sizes.radius),
        fg_stroke: Stroke::new(line, text),
        expansion: 0.0,
    };
    Widgets {
        noninteractive: state(theme.panel, theme.separator, theme.text),
        inactive: state(theme.button, theme.border, theme.text),
        hovered: state(theme.button_hover, theme.border, theme.text_strong),
        active: state(theme.button_press, theme.accent, theme.text_strong),
        open: state(theme.button_press, theme.border, theme.text_strong),
    }
}
