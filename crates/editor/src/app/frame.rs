//! One frame of the window: what stands where.

use super::Editor;
use crate::dialogs::tour;
use crate::live::FinalState;
use crate::panels::gallery::{GalleryAnswer, GalleryModel, gallery_ui};
use crate::panels::list::list_ui;
use crate::panels::materials::materials_ui;
use crate::panels::menu::menu_ui;
use crate::panels::properties::properties_ui;
use crate::panels::status::{Progress, Standing, status_ui, time_text};
use crate::panels::toolbar::toolbar_ui;
use crate::panels::{Around, RenderState};
use crate::text::tr;
use crate::theme;
use crate::viewport::viewport_ui;
use eframe::egui::{CentralPanel, Color32, Frame, Id, Margin, Panel, Ui};
use vitrine::render::threads;

impl Editor {
    /// Draws everything; what is asked for is noted.
    pub(super) fn draw(&mut self, ui: &mut Ui) {
        if self.is_choosing {
            self.draw_gallery(ui);
        } else {
            self.draw_scene(ui);
        }
        self.draw_above(ui);
    }

    fn draw_gallery(&mut self, ui: &mut Ui) {
        let fill = theme::of(ui).surround;
        let panel = CentralPanel::no_frame().frame(Frame::NONE.fill(fill));
        let answer = panel.show(ui, |ui| {
            let model = GalleryModel {
                recent: &self.recent,
                recoveries: &self.recoveries,
                thumbnails: &self.thumbnails,
                config: &self.config,
                can_return: self.has_begun,
            };
            gallery_ui(ui, &mut self.gallery, &model, &mut self.actions)
        });
        match answer.inner {
            Some(GalleryAnswer::Recover(index)) => self.recover(index),
            Some(GalleryAnswer::Discard(index)) => self.forget_recovery(index),
            Some(GalleryAnswer::Return) => self.is_choosing = false,
            None => {}
        }
    }

    fn draw_scene(&mut self, ui: &mut Ui) {
        let (progress, standing) = (self.progress(), self.standing());
        let around = Around {
            document: &self.document,
            config: &self.config,
            recent: self.recent.files().iter().map(|f| f.path.clone()).collect(),
            title: self.document.title().unwrap_or_else(|| tr!("app-untitled")),
            render: render_state(self.live.final_state()),
        };
        let theme = theme::of(ui);
        let sizes = &theme.sizes;
        let frame = |fill: Color32, across: f32, down: f32| {
            Frame::NONE.fill(fill).inner_margin(Margin::symmetric(across as i8, down as i8))
        };
        let bar = |down| frame(theme.bar, sizes.gap_m, down);
        let panel = frame(theme.panel, sizes.gap_m, sizes.gap_m);
        let actions = &mut self.actions;
        let top = |name, height: f32| Panel::top(Id::new(name)).exact_size(height).resizable(false);
        top("menu", sizes.menu_bar).frame(bar(0.0)).show(ui, |ui| menu_ui(ui, &around, actions));
        top("toolbar", sizes.toolbar).frame(bar(0.0)).show(ui, |ui| toolbar_ui(ui, &around, actions));
        Panel::bottom(Id::new("status")).exact_size(sizes.status).resizable(false).frame(bar(0.0)).show(
            ui,
            |ui| {
                status_ui(ui, &around, &progress, &standing, actions);
            },
        );
        Panel::left(Id::new("list")).exact_size(sizes.list_width).resizable(false).frame(panel).show(
            ui,
            |ui| {
                list_ui(ui, &self.document, &mut self.list, actions);
            },
        );
        let width = sizes.properties_width;
        Panel::right(Id::new("properties")).exact_size(width).resizable(false).frame(panel).show(ui, |ui| {
            tour::mark(ui.ctx(), "properties", ui.max_rect());
            properties_ui(ui, &self.document, &mut self.properties, actions);
        });
        let height = sizes.thumbnail + sizes.control + sizes.gap_xl + 2.0 * sizes.gap_m;
        let strip = Panel::bottom(Id::new("materials")).exact_size(height).resizable(false).frame(panel);
        strip.show(ui, |ui| {
            tour::mark(ui.ctx(), "materials", ui.max_rect());
            materials_ui(ui, &self.document, (&mut self.materials, &self.thumbnails), actions);
        });
        CentralPanel::no_frame().frame(Frame::NONE.fill(theme.surround)).show(ui, |ui| {
            tour::mark(ui.ctx(), "picture", ui.max_rect());
            self.viewport.threads = self.config.threads;
            viewport_ui(ui, &self.document, &mut self.live, &mut self.viewport, actions);
        });
    }

    /// How far the picture is, for the line at the bottom.
    fn progress(&self) -> Progress {
        let status = self.live.status();
        let share = status.samples_done as f32 / status.samples_total.max(1) as f32;
        let percent = (100.0 * share).floor() as u64;
        let busy = |text: String| Progress { text, share: Some(share) };
        match self.live.final_state() {
            FinalState::Running => busy(match status.time_left {
                Some(left) => tr!("status-final", percent = percent, left = time_text(left)),
                None => tr!("status-final-starting", percent = percent),
            }),
            FinalState::Stopped => busy(tr!("status-stopped", percent = percent)),
            FinalState::Done => {
                Progress { text: tr!("status-done", elapsed = time_text(status.elapsed)), share: None }
            }
            FinalState::Idle
                if status.is_busy
                    && let Some([samples, all]) = status.samples =>
            {
                let share = Some(samples as f32 / all.max(1) as f32);
                Progress { text: tr!("status-samples", samples = samples, all = all), share }
            }
            FinalState::Idle if status.is_busy && status.pass > 0 => {
                busy(tr!("status-pass", pass = status.pass, passes = status.passes))
            }
            FinalState::Idle if status.is_busy => busy(tr!("status-drawing")),
            FinalState::Idle => {
                let finished = |[samples, _]: [u32; 2]| tr!("status-live-samples", samples = samples);
                Progress { text: status.samples.map_or_else(|| tr!("status-live"), finished), share: None }
            }
        }
    }

    fn standing(&self) -> Standing {
        let file = match (self.document.path(), self.document.is_changed()) {
            (None, _) => tr!("status-unsaved"),
            (Some(_), true) => tr!("status-changed"),
            (Some(_), false) => tr!("status-saved"),
        };
        let threads = threads::meant_by(self.config.threads);
        Standing { file, problems: self.doctor.lines.len(), threads }
    }
}

/// How the final render stands, for menus and tools.
pub(super) fn render_state(state: FinalState) -> RenderState {
    match state {
        FinalState::Running => RenderState::Running,
        FinalState::Stopped => RenderState::Stopped,
        FinalState::Idle | FinalState::Done => RenderState::Idle,
    }
}
