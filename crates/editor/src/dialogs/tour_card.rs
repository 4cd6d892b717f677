//! The card of the guided tour, beside the control that the step is about.

use super::frame;
use super::tour::{STEPS, Tour, TourFacts, anchor};
use crate::action::{Action, Actions};
use crate::files::Config;
use crate::text::tr;
use crate::theme;
use crate::widgets::{primary_button, text_button};
use eframe::egui::{
    Align, Area, Context, Frame, Id, Layout, Margin, Order, Pos2, Rect, Stroke, StrokeKind, Ui, Vec2, pos2,
    vec2,
};

/// Draws the card, if the tour goes on, and a frame around the control that it speaks of. Draw it last.
pub fn tour_ui(
    ctx: &Context,
    tour: &mut Option<Tour>,
    facts: &TourFacts<'_>,
    config: &Config,
    actions: &mut Actions,
) {
    let Some(state) = tour else { return };
    state.look(facts);
    // A dialog has the word; the card waits behind it.
    if ctx.memory(|m| m.top_modal_layer().is_some()) {
        return;
    }
    let theme = theme::of(ctx);
    let target = state.step().and_then(|step| anchor(ctx, step.anchor));
    if let Some(target) = target {
        let layer = eframe::egui::LayerId::new(Order::Foreground, Id::new("tour frame"));
        let stroke = Stroke::new(theme.sizes.line_bold, theme.accent);
        let around = target.expand(theme.sizes.gap_xs);
        ctx.layer_painter(layer).rect_stroke(around, theme.sizes.radius, stroke, StrokeKind::Outside);
    }
    let id = Id::new("tour card");
    let known: Option<Vec2> = ctx.data(|d| d.get_temp(id));
    let size = known.unwrap_or(vec2(theme.sizes.properties_width, theme.sizes.control * 6.0));
    let at = place(ctx.content_rect().shrink(theme.sizes.gap_l), target, size, theme.sizes.gap_l);
    let area = Area::new(id).order(Order::Foreground).fixed_pos(at);
    let shown = area.show(ctx, |ui| {
        let frame = Frame::window(ui.style())
            .stroke(Stroke::new(theme.sizes.line, theme.accent))
            .inner_margin(Margin::same(theme.sizes.gap_l as i8));
        frame.show(ui, |ui| card(ui, state)).inner
    });
    ctx.data_mut(|d| d.insert_temp(id, shown.response.rect.size()));
    match shown.inner {
        Some(Wish::Skip) => state.skip(facts.document),
        Some(Wish::Again) => *tour = Some(Tour::begin(facts.document)),
        Some(Wish::Close) => {
            *tour = None;
            let config = Config { tour_seen: true, ..config.clone() };
            actions.push(Action::Configure(Box::new(config)));
        }
        None => {}
    }
}

/// What a person wants of the card.
enum Wish {
    Skip,
    Again,
    Close,
}

fn card(ui: &mut Ui, tour: &Tour) -> Option<Wish> {
    let sizes = &theme::of(ui).sizes;
    ui.set_width(sizes.properties_width);
    ui.spacing_mut().item_spacing.y = sizes.gap_m;
    let is_done = tour.step().is_none();
    let title = tr!("tour-title");
    if is_done {
        frame::hint(ui, &title);
    } else {
        let step = tr!("tour-step", step = tour.number(), all = STEPS.len());
        frame::hint(ui, &format!("{title} · {step}"));
    }
    let [what, text] = tour.texts();
    frame::heading(ui, &what);
    frame::paragraph(ui, &text);
    progress(ui, tour);
    let mut wish = None;
    let button =
        |ui: &mut Ui, key: &str| text_button(ui, &tr!(key), &tr!(&format!("{key}.tooltip"))).clicked();
    let room = vec2(ui.available_width(), sizes.control);
    ui.allocate_ui_with_layout(room, Layout::right_to_left(Align::Center), |ui| {
        if is_done {
            if primary_button(ui, &tr!("tour-finish"), &tr!("tour-finish.tooltip")).clicked() {
                wish = Some(Wish::Close);
            }
            if button(ui, "tour-again") {
                wish = Some(Wish::Again);
            }
            return;
        }
        if button(ui, "tour-skip") {
            wish = Some(Wish::Skip);
        }
        if button(ui, "tour-close") {
            wish = Some(Wish::Close);
        }
    });
    wish
}

/// A dash for each step: done, being done, to come.
fn progress(ui: &mut Ui, tour: &Tour) {
    let theme = theme::of(ui);
    let height = theme.sizes.gap_s;
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), eframe::egui::Sense::hover());
    let gap = theme.sizes.gap_s;
    let width = (rect.width() + gap) / STEPS.len() as f32 - gap;
    for i in 0..STEPS.len() {
        let left = rect.left() + i as f32 * (width + gap);
        let dash = Rect::from_min_size(pos2(left, rect.top()), vec2(width, height));
        let color = if i < tour.number() { theme.accent } else { theme.field };
        ui.painter().rect_filled(dash, height / 2.0, color);
    }
}

/// Where a card of some size stands beside a control: below, above, to the right, to the left, or in the corner that hides
/// the least of it.
fn place(room: Rect, target: Option<Rect>, size: Vec2, gap: f32) -> Pos2 {
    let Some(target) = target else { return room.right_bottom() - size };
    let along_x =
        (target.center().x - size.x / 2.0).clamp(room.left(), (room.right() - size.x).max(room.left()));
    let along_y =
        (target.center().y - size.y / 2.0).clamp(room.top(), (room.bottom() - size.y).max(room.top()));
    let below = pos2(along_x, target.bottom() + gap);
    let above = pos2(along_x, target.top() - gap - size.y);
    let right = pos2(target.right() + gap, along_y);
    let left = pos2(target.left() - gap - size.x, along_y);
    let fits = |at: &Pos2| room.expand(0.5).contains_rect(Rect::from_min_size(*at, size));
    let inside = target.right_bottom() - size - Vec2::splat(gap);
    [below, above, right, left].into_iter().find(fits).unwrap_or(inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_card_stands_beside_its_control_and_inside_the_window() {
        let room = Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 800.0));
        let size = vec2(280.0, 160.0);
        let controls = [[0.0, 40.0, 90.0, 30.0], [1240.0, 40.0, 40.0, 30.0], [230.0, 700.0, 800.0, 90.0]];
        for [x, y, width, height] in controls {
            let target = Rect::from_min_size(pos2(x, y), vec2(width, height));
            let card = Rect::from_min_size(place(room, Some(target), size, 12.0), size);
            assert!(room.contains_rect(card), "{card} beside {target}");
            assert!(!card.intersects(target), "{card} beside {target}");
        }
    }

    #[test]
    fn beside_a_control_that_fills_the_window_the_card_stands_in_its_corner() {
        let room = Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 800.0));
        let at = place(room, Some(room), vec2(280.0, 160.0), 12.0);
        assert_eq!(at, pos2(1280.0 - 280.0 - 12.0, 800.0 - 160.0 - 12.0));
    }
}
