//! When a new picture is asked for: when the scene, the size of the view or the number of threads is another.

use super::Viewport;
use crate::document::Document;
use crate::live::{Live, Request};
use eframe::egui::{Rect, Ui};
use std::sync::Arc;
use std::time::Duration;

/// While only the picture refines, the window is drawn no more often than that.
const REFINE_EVERY: Duration = Duration::from_millis(80);
/// So long after it was turned last the wheel counts as turning, seconds.
pub const WHEEL_RESTS: f64 = 0.2;

/// What was asked for last.
#[derive(Default)]
pub struct Asking {
    last: Option<Request>,
    generation: u64,
    /// When another scene was asked for, in seconds of the window's clock.
    since: f64,
}

impl Asking {
    /// What would be asked now.
    pub fn request(&self, document: &Document, threads: usize) -> Request {
        Request {
            scene: document.scene().clone(),
            assets: document.assets().clone(),
            size: document.scene().settings.size,
            threads,
            is_dragging: false,
            generation: self.generation,
        }
    }

    /// Whether the picture of the newest scene is late.
    pub fn is_slow(&self, ui: &Ui, live: &Live, seconds: f64) -> bool {
        let is_there = live.picture().is_some_and(|p| p.generation == self.generation);
        !is_there && ui.input(|i| i.time) - self.since > seconds
    }
}

impl Viewport {
    /// Asks for a picture if it has to be another.
    pub(super) fn ask(&mut self, ui: &Ui, document: &Document, live: &mut Live, rect: Rect) {
        let (time, is_down) = ui.input(|i| (i.time, i.pointer.any_down()));
        let is_turning = self.wheel.is_some_and(|(_, last)| time - last < WHEEL_RESTS);
        let asking = &mut self.asking;
        let pixels = |length: f32| (length * ui.ctx().pixels_per_point()).round().max(1.0) as u32;
        let wish = Request {
            size: [pixels(rect.width()), pixels(rect.height())],
            is_dragging: is_down || is_turning,
            ..asking.request(document, self.threads)
        };
        let last = asking.last.as_ref();
        let is_same_scene = last.is_some_and(|last| {
            Arc::ptr_eq(&last.scene, &wish.scene) && Arc::ptr_eq(&last.assets, &wish.assets)
        });
        if !is_same_scene {
            asking.generation += 1;
            asking.since = time;
        }
        let is_same_view = last.is_some_and(|last| last.size == wish.size && last.threads == wish.threads);
        let has_come_to_rest = last.is_some_and(|last| last.is_dragging) && !wish.is_dragging;
        if !is_same_scene || !is_same_view || has_come_to_rest {
            let wish = Request { generation: asking.generation, ..wish };
            asking.last = Some(wish.clone());
            live.show(wish);
        }
        if is_turning {
            ui.ctx().request_repaint_after(Duration::from_secs_f64(WHEEL_RESTS));
        }
        if live.status().is_busy {
            ui.ctx().request_repaint_after(REFINE_EVERY);
        }
    }
}
