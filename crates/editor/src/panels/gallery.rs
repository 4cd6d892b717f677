//! The screen at the start: scenes to begin with, scenes that were open lately, what can be recovered.

use super::thumbnail::ThumbnailTextures;
use crate::action::{Action, Actions};
use crate::files::{Config, Recent, Recovery, file_name};
use crate::library::{ThumbnailImage, Thumbnails, template_key};
use crate::text::{Language, tr};
use crate::theme::{self, icon_font, icons};
use crate::widgets::{describe, link_button, primary_button, text_button};
use eframe::egui::{
    Align, Button, CornerRadius, FontId, Frame, Label, Layout, Margin, Rect, Response, RichText, ScrollArea,
    Sense, Stroke, StrokeKind, Ui, UiBuilder, WidgetInfo, WidgetType, vec2,
};
use std::path::Path;
use std::sync::Arc;
use std::time::SystemTime;
use vitrine::templates::TEMPLATES;

/// The templates of the course work, which stand below the others.
const COURSE_WORK: [&str; 6] = [
    "benchmark",
    "transparent-sphere",
    "two-mirror-spheres",
    "textured-sphere",
    "textured-triangle",
    "soft-shadows",
];

/// A card's picture is so many times as wide as high.
const PROPORTION: f32 = 4.0 / 3.0;

/// What the screen shows.
#[derive(Clone, Copy)]
pub struct GalleryModel<'a> {
    /// Scenes that were open lately.
    pub recent: &'a Recent,
    /// Scenes of windows that did not end as they should.
    pub recoveries: &'a [Recovery],
    /// Small pictures.
    pub thumbnails: &'a Thumbnails,
    /// The settings of the program, for the language.
    pub config: &'a Config,
    /// Whether there is a scene to go back to.
    pub can_return: bool,
}

/// What the screen remembers.
#[derive(Debug, Default)]
pub struct GalleryState {
    textures: ThumbnailTextures,
    /// Pictures of what can be recovered, in its order.
    recovered: Vec<Option<Arc<ThumbnailImage>>>,
}

/// What a person asks of the screen itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GalleryAnswer {
    /// Open what can be recovered: its place in the list.
    Recover(usize),
    /// Throw it away.
    Discard(usize),
    /// Back to the scene.
    Return,
}

/// Draws the screen over all the room there is.
pub fn gallery_ui(
    ui: &mut Ui,
    state: &mut GalleryState,
    model: &GalleryModel<'_>,
    actions: &mut Actions,
) -> Option<GalleryAnswer> {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let whole = ui.max_rect();
    let margin = sizes.gap_xl;
    let side_width = sizes.properties_width + 2.0 * sizes.gap_xl;
    let (side, rest) = whole.split_left_right_at_x(whole.left() + side_width);
    ui.painter().rect_filled(side, CornerRadius::ZERO, theme.bar);
    let mut answer = None;
    let inside = UiBuilder::new().max_rect(side.shrink(sizes.gap_xl));
    ui.scope_builder(inside.layout(Layout::top_down(Align::Min)), |ui| {
        answer = answer.or(side_ui(ui, model, actions));
    });
    let inside = UiBuilder::new().max_rect(rest.shrink2(vec2(margin, 0.0)));
    ui.scope_builder(inside.layout(Layout::top_down(Align::Min)), |ui| {
        ScrollArea::vertical().auto_shrink(false).id_salt("gallery").show(ui, |ui| {
            ui.add_space(margin);
            // The bar at the right has room of its own.
            ui.set_max_width(ui.available_width() - sizes.gap_m);
            answer = answer.or(recoveries_ui(ui, state, model));
            cards_ui(ui, state, model, actions);
            ui.add_space(margin);
        });
    });
    answer
}

/// The column on the left: the program's name, opening, recent scenes, the language.
fn side_ui(ui: &mut Ui, model: &GalleryModel<'_>, actions: &mut Actions) -> Option<GalleryAnswer> {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let mut answer = None;
    ui.label(RichText::new(tr!("gallery-title")).size(sizes.text_display).color(theme.text_strong));
    ui.add(Label::new(RichText::new(tr!("gallery-about")).color(theme.text_muted)).wrap());
    ui.add_space(sizes.gap_xl);
    ui.horizontal(|ui| {
        if primary_button(ui, &tr!("gallery-open"), &tr!("gallery-open.tooltip")).clicked() {
            actions.push(Action::Open);
        }
        let back = (tr!("gallery-return"), tr!("gallery-return.tooltip"));
        if model.can_return && text_button(ui, &back.0, &back.1).clicked() {
            answer = Some(GalleryAnswer::Return);
        }
    });
    ui.add_space(sizes.gap_xl);
    if !model.recent.files().is_empty() {
        title_ui(ui, &tr!("gallery-recent"));
        let room = (ui.available_height() - sizes.control - sizes.gap_xl).max(sizes.row);
        ScrollArea::vertical().max_height(room).auto_shrink([false, true]).id_salt("recent").show(ui, |ui| {
            for file in model.recent.files() {
                if recent_ui(ui, &file.path, file.when()).clicked() {
                    actions.push(Action::OpenFile(file.path.clone()));
                }
            }
        });
    }
    ui.with_layout(Layout::bottom_up(Align::Min), |ui| languages_ui(ui, model.config, actions));
    answer
}

fn title_ui(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    let title = RichText::new(text).size(theme.sizes.text_title).color(theme.text_strong);
    ui.label(title);
    ui.add_space(theme.sizes.gap_m);
}

/// A recent scene: its name; its folder and age below.
fn recent_ui(ui: &mut Ui, path: &Path, when: SystemTime) -> Response {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let file = file_name(path);
    let name = file.strip_suffix(".vitrine.toml").unwrap_or(&file).to_owned();
    let folder = path.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy();
    let below = tr!("gallery-recent-below", folder = folder.as_ref(), age = age_text(when));
    let size = vec2(ui.available_width(), 2.0 * sizes.text * 1.35 + sizes.gap_m);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let is_lit = response.hovered() || response.has_focus();
    if is_lit {
        ui.painter().rect_filled(rect, CornerRadius::same(sizes.radius), theme.button_hover);
    }
    let line = |text: &str, size: f32, color, top: f32| {
        let room = rect.width() - 2.0 * sizes.gap_m;
        let mut job = eframe::egui::text::LayoutJob::simple_singleline(
            text.to_owned(),
            FontId::proportional(size),
            color,
        );
        job.wrap = eframe::egui::text::TextWrapping::truncate_at_width(room);
        let galley = ui.painter().layout_job(job);
        ui.painter().galley(rect.left_top() + vec2(sizes.gap_m, top), galley, color);
    };
    let name_color = if is_lit { theme.text_strong } else { theme.text };
    line(&name, sizes.text, name_color, sizes.gap_s);
    line(&below, sizes.text_small, theme.text_muted, sizes.gap_s + sizes.text * 1.35);
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Button, enabled, &name));
    describe(response, &name, &path.display().to_string())
}

fn languages_ui(ui: &mut Ui, config: &Config, actions: &mut Actions) {
    let theme = theme::of(ui);
    ui.horizontal(|ui| {
        ui.label(RichText::new(icons::LANGUAGE).font(icon_font(theme.sizes.icon)).color(theme.text_muted));
        for language in Language::ALL {
            let is_chosen = config.language == language;
            let name = language.own_name();
            let color = if is_chosen { theme.on_selection } else { theme.text_muted };
            let button = Button::selectable(is_chosen, RichText::new(name).color(color));
            let response = ui.add(button.min_size(vec2(0.0, theme.sizes.control)));
            let enabled = ui.is_enabled();
            response.widget_info(|| WidgetInfo::selected(WidgetType::RadioButton, enabled, is_chosen, name));
            if describe(response, name, &tr!("gallery-language")).clicked() && !is_chosen {
                actions.push(Action::Configure(Box::new(Config { language, ..config.clone() })));
            }
        }
    });
}

/// What can be recovered, each as a banner.
fn recoveries_ui(ui: &mut Ui, state: &mut GalleryState, model: &GalleryModel<'_>) -> Option<GalleryAnswer> {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    if state.recovered.len() != model.recoveries.len() {
        let images = model.recoveries.iter().map(|r| r.thumbnail.clone().map(Arc::new));
        state.recovered = images.collect();
    }
    let mut answer = None;
    for (index, recovery) in model.recoveries.iter().enumerate() {
        let frame = Frame::NONE
            .fill(theme.raised)
            .stroke(Stroke::new(sizes.line, theme.accent))
            .corner_radius(CornerRadius::same(sizes.radius_l))
            .inner_margin(Margin::same(sizes.gap_l as i8));
        frame.show(ui, |ui| {
            ui.horizontal(|ui| {
                let size = vec2(sizes.thumbnail * PROPORTION, sizes.thumbnail);
                let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
                let image = state.recovered[index].as_ref();
                state.textures.paint(ui, rect, image, CornerRadius::same(sizes.radius));
                ui.add_space(sizes.gap_m);
                ui.vertical(|ui| {
                    let title = tr!("gallery-recover-title", name = recovery.title.as_str());
                    ui.label(RichText::new(title).size(sizes.text_title).color(theme.text_strong));
                    let below = tr!("gallery-recover-below", age = age_text(recovery.when));
                    ui.label(RichText::new(below).color(theme.text_muted));
                    ui.add_space(sizes.gap_s);
                    ui.horizontal(|ui| {
                        let [recover, discard] = ["gallery-recover", "gallery-discard"];
                        if primary_button(ui, &tr!(recover), &tr!("gallery-recover.tooltip")).clicked() {
                            answer = Some(GalleryAnswer::Recover(index));
                        }
                        if link_button(ui, &tr!(discard), &tr!("gallery-discard.tooltip")).clicked() {
                            answer = Some(GalleryAnswer::Discard(index));
                        }
                    });
                });
                ui.add_space(ui.available_width());
            });
        });
        ui.add_space(sizes.gap_xl);
    }
    answer
}

fn cards_ui(ui: &mut Ui, state: &mut GalleryState, model: &GalleryModel<'_>, actions: &mut Actions) {
    let sizes = &theme::of(ui).sizes;
    let is_course_work = |name: &&str| COURSE_WORK.contains(name);
    let (course_work, others): (Vec<_>, Vec<_>) = TEMPLATES.iter().map(|t| t.name).partition(is_course_work);
    for (title, names) in [("gallery-begin", others), ("gallery-course-work", course_work)] {
        title_ui(ui, &tr!(title));
        let gap = sizes.gap_l;
        let across = ((ui.available_width() + gap) / (sizes.card_width + gap)).floor().max(1.0);
        for row in names.chunks(across as usize) {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = gap;
                for name in row {
                    let image = model.thumbnails.template(name);
                    let response = card_ui(ui, name, |ui, rect, radius| {
                        state.textures.paint(ui, rect, image.as_ref(), radius);
                    });
                    if response.clicked() {
                        actions.push(Action::NewFrom((*name).to_owned()));
                    }
                }
            });
            ui.add_space(gap);
        }
        ui.add_space(sizes.gap_l);
    }
}

/// A template: its picture, its title and one line.
fn card_ui(ui: &mut Ui, name: &str, paint: impl FnOnce(&mut Ui, Rect, CornerRadius)) -> Response {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let (title, about) = (tr!(&template_key(name)), tr!(&format!("{}.about", template_key(name))));
    let width = sizes.card_width;
    let room = width - 2.0 * sizes.gap_l;
    let layout = |text: &str, size, color| {
        ui.painter().layout(text.to_owned(), FontId::proportional(size), color, room)
    };
    let title_text = layout(&title, sizes.text, theme.text_strong);
    let about_text = layout(&about, sizes.text_small, theme.text_muted);
    let picture_height = (width / PROPORTION).round();
    // Two lines for every card, so that a row is level.
    let text_height = sizes.gap_m + title_text.size().y + sizes.gap_xs + 2.7 * sizes.text_small + sizes.gap_l;
    let (rect, response) = ui.allocate_exact_size(vec2(width, picture_height + text_height), Sense::click());
    if ui.is_rect_visible(rect) {
        let is_lit = response.hovered() || response.has_focus();
        let radius = CornerRadius::same(sizes.radius_l);
        ui.painter().rect_filled(rect, radius, if is_lit { theme.raised } else { theme.panel });
        let picture = Rect::from_min_size(rect.min, vec2(width, picture_height));
        let top = CornerRadius { sw: 0, se: 0, ..radius };
        paint(ui, picture, top);
        let at = picture.left_bottom() + vec2(sizes.gap_l, sizes.gap_m);
        let below = at + vec2(0.0, title_text.size().y + sizes.gap_xs);
        ui.painter().galley(at, title_text, theme.text_strong);
        ui.painter().galley(below, about_text, theme.text_muted);
        let (line, color) =
            if is_lit { (sizes.line_bold, theme.accent) } else { (sizes.line, theme.separator) };
        ui.painter().rect_stroke(rect, radius, Stroke::new(line, color), StrokeKind::Inside);
    }
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Button, enabled, &title));
    describe(response, &title, &tr!("gallery-card.tooltip", about = about.as_str()))
}

/// How long ago something was, in words.
fn age_text(when: SystemTime) -> String {
    let seconds = when.elapsed().map_or(0, |age| age.as_secs());
    match seconds {
        0..60 => tr!("gallery-age-now"),
        60..3600 => tr!("gallery-age-minutes", count = seconds / 60),
        3600..86_400 => tr!("gallery-age-hours", count = seconds / 3600),
        _ => tr!("gallery-age-days", count = seconds / 86_400),
    }
}
