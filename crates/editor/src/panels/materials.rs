//! The strip of materials under the picture: those of the scene, then the library. A click paints what is selected; a
//! material can be dragged onto a thing in the picture.

use super::thumbnail::ThumbnailTextures;
use crate::action::{Action, Actions};
use crate::document::{Document, EditCommand, Paint, Thing};
use crate::library::{Category, Thumbnails, materials};
use crate::text::tr;
use crate::theme;
use crate::widgets::{describe, empty_hint, search_field};
use eframe::egui::{
    Align, Button, CornerRadius, DragAndDrop, FontId, Id, LayerId, Layout, Order, Rect, Response, RichText,
    ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo, WidgetType, vec2,
};
use vitrine::scene::ListName;

/// The width of the field to search in, in controls' heights.
const SEARCH_WIDTH: f32 = 7.0;

/// Which materials are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Shelf {
    #[default]
    All,
    Scene,
    Library(Category),
}

/// What the strip remembers.
#[derive(Debug, Default)]
pub struct MaterialsState {
    search: String,
    shelf: Shelf,
    /// Somebody clicked a material while nothing was selected.
    needs_selection: bool,
    textures: ThumbnailTextures,
}

/// A material as the strip shows it.
struct Entry {
    title: String,
    tooltip: String,
    paint: Paint,
}

/// Draws the strip. It fills what room there is: a row of controls and below it the pictures.
pub fn materials_ui(
    ui: &mut Ui,
    document: &Document,
    (state, thumbnails): (&mut MaterialsState, &Thumbnails),
    actions: &mut Actions,
) {
    header_ui(ui, document, state);
    let entries = entries(document, state);
    if entries.is_empty() {
        empty_hint(ui, &tr!("materials-none"));
        return;
    }
    let gap = theme::of(ui).sizes.gap_m;
    ScrollArea::horizontal().auto_shrink(false).id_salt("materials").show(ui, |ui| {
        ui.spacing_mut().item_spacing.x = gap;
        ui.horizontal_top(|ui| {
            for (index, entry) in entries.iter().enumerate() {
                let image = thumbnails.material(&entry.paint, document.assets());
                ui.push_id(index, |ui| {
                    let response = cell_ui(ui, entry, |ui, rect, radius| {
                        state.textures.paint(ui, rect, image.as_ref(), radius);
                    });
                    answer(ui, &response, entry, (document, &mut *state), actions);
                    if response.dragged() {
                        let at = ui.ctx().pointer_latest_pos().unwrap_or(response.rect.center());
                        let layer = LayerId::new(Order::Tooltip, Id::new("dragged material"));
                        let size = vec2(1.0, 1.0) * theme::of(ui).sizes.tool;
                        let above = ui.new_child(eframe::egui::UiBuilder::new().layer_id(layer));
                        let radius = CornerRadius::same(theme::of(ui).sizes.radius);
                        let rect = Rect::from_center_size(at, size);
                        state.textures.paint(&above, rect, image.as_ref(), radius);
                    }
                });
            }
        });
    });
}

/// What a click or a drag means.
fn answer(
    ui: &Ui,
    response: &Response,
    entry: &Entry,
    (document, state): (&Document, &mut MaterialsState),
    actions: &mut Actions,
) {
    if response.drag_started() {
        DragAndDrop::set_payload(ui.ctx(), entry.paint.clone());
    }
    if response.clicked() {
        let things = selected_objects(document);
        state.needs_selection = things.is_empty();
        if !things.is_empty() {
            let material = Box::new(entry.paint.clone());
            actions.push(Action::Edit(EditCommand::Paint { things, material }));
        }
    }
}

fn selected_objects(document: &Document) -> Vec<Thing> {
    let things = document.selection().things().iter();
    things.filter(|t| t.list() == Some(ListName::Object)).cloned().collect()
}

fn header_ui(ui: &mut Ui, document: &Document, state: &mut MaterialsState) {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    state.needs_selection &= selected_objects(document).is_empty();
    ui.allocate_ui_with_layout(
        vec2(ui.available_width(), sizes.control),
        Layout::right_to_left(Align::Center),
        |ui| {
            let room = vec2(sizes.control * SEARCH_WIDTH, sizes.control);
            ui.allocate_ui_with_layout(room, Layout::left_to_right(Align::Center), |ui| {
                search_field(
                    ui,
                    &mut state.search,
                    &tr!("materials-search"),
                    &tr!("materials-search.tooltip"),
                );
            });
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.spacing_mut().item_spacing.x = sizes.gap_s;
                if state.needs_selection {
                    ui.label(RichText::new(tr!("materials-needs-selection")).color(theme.warning_text));
                } else {
                    shelves_ui(ui, state);
                }
            });
        },
    );
}

fn shelves_ui(ui: &mut Ui, state: &mut MaterialsState) {
    let theme = theme::of(ui);
    let mut shelves = vec![(Shelf::All, tr!("materials-all")), (Shelf::Scene, tr!("materials-scene"))];
    shelves.extend(Category::ALL.map(|category| (Shelf::Library(category), category.title())));
    for (shelf, title) in shelves {
        let is_chosen = state.shelf == shelf;
        let color = if is_chosen { theme.on_selection } else { theme.text_muted };
        let button = Button::selectable(is_chosen, RichText::new(&title).color(color));
        let response = ui.add(button.min_size(vec2(0.0, theme.sizes.control)));
        let enabled = ui.is_enabled();
        response.widget_info(|| WidgetInfo::selected(WidgetType::RadioButton, enabled, is_chosen, &title));
        if describe(response, &title, &tr!("materials-shelf", name = title.as_str())).clicked() {
            state.shelf = shelf;
        }
    }
}

/// What is to be seen: the scene's own materials first.
fn entries(document: &Document, state: &MaterialsState) -> Vec<Entry> {
    let scene = document.scene();
    let own = scene.materials.iter().filter(|m| {
        let name = m.name.to_lowercase();
        let is_found = state.search.to_lowercase().split_whitespace().all(|word| name.contains(word));
        is_found && matches!(state.shelf, Shelf::All | Shelf::Scene)
    });
    let own = own.map(|material| Entry {
        title: material.name.clone(),
        tooltip: tr!("materials-own.tooltip", name = material.name.as_str()),
        paint: Paint {
            material: material.clone(),
            texture: material.texture.as_deref().and_then(|name| scene.texture(name)).cloned(),
        },
    });
    let library = materials().iter().filter(|m| {
        let is_on_shelf = state.shelf == Shelf::All || state.shelf == Shelf::Library(m.category);
        is_on_shelf && m.is_found_by(&state.search)
    });
    own.chain(library.map(|m| Entry {
        title: m.title(),
        tooltip: tr!("materials-library.tooltip", about = m.about()),
        paint: m.paint(),
    }))
    .collect()
}

/// A picture with the name below it.
fn cell_ui(ui: &mut Ui, entry: &Entry, paint: impl FnOnce(&mut Ui, Rect, CornerRadius)) -> Response {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let font = FontId::proportional(sizes.text_small);
    let name = ui.painter().layout_no_wrap(entry.title.clone(), font, theme.text);
    let edge = (ui.available_height() - name.size().y - sizes.gap_s).clamp(sizes.icon, sizes.thumbnail);
    let size = vec2(edge.max(name.size().x), edge + sizes.gap_xs + name.size().y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let picture = Rect::from_center_size(rect.center_top() + vec2(0.0, edge / 2.0), vec2(edge, edge));
    let radius = CornerRadius::same(sizes.radius);
    if ui.is_rect_visible(rect) {
        paint(ui, picture, radius);
        let is_lit = response.hovered() || response.has_focus();
        let (width, color) =
            if is_lit { (sizes.line_bold, theme.accent) } else { (sizes.line, theme.border) };
        ui.painter().rect_stroke(picture, radius, Stroke::new(width, color), StrokeKind::Inside);
        // A name that the edge would cut through is left out until it is scrolled in.
        let fits =
            ui.clip_rect().x_range().contains(rect.left()) && ui.clip_rect().x_range().contains(rect.right());
        let at = rect.center_bottom() - vec2(name.size().x / 2.0, name.size().y);
        let color = if is_lit { theme.text_strong } else { theme.text };
        if fits {
            ui.painter().galley_with_override_text_color(at, name, color);
        }
    }
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Button, enabled, &entry.title));
    describe(response, &entry.title, &entry.tooltip)
}
