//! The dialog «Save picture».

use super::draft::{CurrentPicture, PictureFormat, PictureSource, RENDERERS, SaveDraft, SaveFlaw};
use crate::dialogs::frame::{self, Buttons, Shell, Verdict};
use crate::dialogs::{Around, Browse, Outcome, Reply};
use crate::text::tr;
use crate::theme;
use crate::widgets::{Field, FileAnswer, Number, Shown, file_field, number_field, toggle};
use eframe::egui::{Context, Ui};
use std::path::Path;
use std::time::Duration;
use vitrine::scene::{Range, Settings};

/// The dialog «Save picture».
#[derive(Debug)]
pub struct SaveDialog {
    /// What has been chosen so far.
    pub draft: SaveDraft,
    /// The size that the scene states.
    scene_size: [u32; 2],
}

/// Sizes that are often needed, with the keys of their texts.
const PRESETS: [([u32; 2], &str); 5] = [
    ([809, 817], "dialog-save-preset-course"),
    ([1280, 720], "dialog-save-preset-hd"),
    ([1920, 1080], "dialog-save-preset-full-hd"),
    ([3840, 2160], "dialog-save-preset-4k"),
    ([1080, 1080], "dialog-save-preset-square"),
];

impl SaveDialog {
    /// `path` is where the picture would be saved.
    #[must_use]
    pub fn new(path: &Path, settings: &Settings, current: Option<CurrentPicture>) -> Self {
        Self { draft: SaveDraft::new(path, settings, current), scene_size: settings.size }
    }

    pub(in crate::dialogs) fn show(&mut self, ctx: &Context, around: &Around<'_>) -> Outcome {
        let title = tr!("dialog-save-title");
        let width = theme::of(ctx).sizes.dialog_width;
        let mut reply = None;
        if around.current.is_none() {
            self.draft.source = PictureSource::RenderNow;
        }
        let verdict = frame::show(ctx, Shell { id: "save-picture", title: &title, width }, |ui| {
            ui.spacing_mut().item_spacing.y = theme::of(ui).sizes.gap_m;
            reply = file(ui, &mut self.draft);
            source(ui, &mut self.draft, around);
            match self.draft.source {
                PictureSource::RenderNow => self.new_picture(ui),
                PictureSource::Current => current(ui, around),
            }
            let time = time_text(self.draft.time(around.samples_per_second));
            frame::fact(ui, &tr!("dialog-save-time"), &time);
            let is_new = self.draft.source == PictureSource::RenderNow;
            let key = if is_new { "dialog-save-render-ok" } else { "dialog-save-ok" };
            Buttons::accept(key, self.draft.flaw().is_none())
        });
        match verdict {
            Verdict::Accept => Outcome::Close(Some(Reply::SavePicture(Box::new(self.draft.request())))),
            Verdict::Cancel => Outcome::Close(None),
            Verdict::Open | Verdict::Other => Outcome::Stay(reply),
        }
    }

    fn new_picture(&mut self, ui: &mut Ui) {
        let draft = &mut self.draft;
        preset(ui, draft, self.scene_size);
        size(ui, draft);
        if draft.flaw() == Some(SaveFlaw::TooLarge) {
            let limit = Settings::MAX_PIXELS / 1_000_000;
            frame::fault(ui, &tr!("dialog-save-too-large", limit = limit));
        }
        quality(ui, draft);
        let renderers = RENDERERS.map(|(renderer, key)| (renderer, tr!(key)));
        if let Some(chosen) = frame::choice(ui, "dialog-save-renderer", &draft.settings.renderer, &renderers)
        {
            draft.settings.renderer = chosen;
        }
    }
}

fn file(ui: &mut Ui, draft: &mut SaveDraft) -> Option<Reply> {
    let (label, tooltip) = (tr!("dialog-save-path"), tr!("dialog-save-path.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let mut reply = None;
    let answer = ui.scope(|ui| {
        // So the button beside the line keeps to its width.
        ui.spacing_mut().button_padding.x = theme::of(ui).sizes.gap_s;
        file_field(ui, &field, &draft.path)
    });
    match answer.inner {
        Some(FileAnswer::Path(edit)) => draft.set_path(Path::new(&edit.value)),
        Some(FileAnswer::Choose) => reply = Some(Reply::Browse(Browse::SavePicture(draft.request().path))),
        None => {}
    }
    match draft.flaw() {
        Some(SaveFlaw::NoPath) => frame::fault(ui, &tr!("dialog-save-path-empty")),
        Some(SaveFlaw::NoFolder) => frame::fault(ui, &tr!("dialog-save-no-folder")),
        Some(SaveFlaw::TooLarge) => {}
        None if draft.request().path.is_file() => frame::hint(ui, &tr!("dialog-save-replaces")),
        None => {}
    }
    let formats = PictureFormat::ALL.map(|f| (f, tr!(f.text_key())));
    if let Some(chosen) = frame::choice(ui, "dialog-save-format", &draft.format, &formats) {
        draft.set_format(chosen);
    }
    frame::hint(ui, &tr!(&format!("{}.tooltip", draft.format.text_key())));
    reply
}

fn source(ui: &mut Ui, draft: &mut SaveDraft, around: &Around<'_>) {
    let mut sources = vec![(PictureSource::RenderNow, tr!("dialog-save-source-render"))];
    if around.current.is_some() {
        sources.insert(0, (PictureSource::Current, tr!("dialog-save-source-current")));
    }
    if let Some(chosen) = frame::choice(ui, "dialog-save-source", &draft.source, &sources) {
        draft.source = chosen;
    }
}

fn current(ui: &mut Ui, around: &Around<'_>) {
    let Some(CurrentPicture { size: [width, height], samples }) = around.current else { return };
    frame::fact(ui, &tr!("dialog-save-size"), &format!("{width} × {height}"));
    frame::fact(ui, &tr!("dialog-save-samples"), &samples.to_string());
}

fn preset(ui: &mut Ui, draft: &mut SaveDraft, scene_size: [u32; 2]) {
    let name = |[width, height]: [u32; 2], key: &str| format!("{} ({width} × {height})", tr!(key));
    let mut presets = vec![(Some(scene_size), name(scene_size, "dialog-save-preset-scene"))];
    let others = PRESETS.iter().filter(|(size, _)| *size != scene_size);
    presets.extend(others.map(|(size, key)| (Some(*size), name(*size, key))));
    presets.push((None, tr!("dialog-save-preset-own")));
    let size = Some(draft.settings.size);
    let now = if presets.iter().any(|(preset, _)| *preset == size) { size } else { None };
    if let Some(Some(chosen)) = frame::choice(ui, "dialog-save-preset", &now, &presets) {
        draft.set_size(chosen);
    }
}

/// Width and height, and the switch that ties them.
fn size(ui: &mut Ui, draft: &mut SaveDraft) {
    let number = whole(1.0, 32_768.0, tr!("unit-pixels"));
    let [width, height] = draft.settings.size;
    if let Some(changed) = pixels(ui, "dialog-save-width", &number, width) {
        draft.set_width(changed);
    }
    if let Some(changed) = pixels(ui, "dialog-save-height", &number, height) {
        draft.set_height(changed);
    }
    let mut keeps = draft.keeps_ratio;
    let (name, tooltip) = (tr!("dialog-save-ratio"), tr!("dialog-save-ratio.tooltip"));
    if toggle(ui, &mut keeps, &name, &tooltip).changed() {
        draft.set_keeps_ratio(keeps);
    }
}

fn pixels(ui: &mut Ui, key: &str, number: &Number, value: u32) -> Option<u32> {
    let (label, tooltip) = (tr!(key), tr!(&format!("{key}.tooltip")));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    let edit = number_field(ui, &field, number, f64::from(value))?;
    Some(edit.value as u32).filter(|v| *v != value)
}

fn quality(ui: &mut Ui, draft: &mut SaveDraft) {
    let number = whole(1.0, 65_536.0, String::new());
    if let Some(samples) = pixels(ui, "dialog-save-samples", &number, draft.settings.samples) {
        draft.settings.samples = samples;
    }
}

fn whole(min: f32, max: f32, unit: String) -> Number {
    Number { range: Range::from_to(min, max), whole: true, decimals: 0, step: 0.5, unit }
}

/// A time as people say it.
fn time_text(time: Option<Duration>) -> String {
    let Some(time) = time else { return tr!("dialog-save-time-unknown") };
    if time.is_zero() {
        return tr!("dialog-save-time-none");
    }
    let seconds = time.as_secs_f64();
    let (key, count) = match seconds {
        s if s <= 90.0 => ("dialog-save-time-seconds", s),
        s if s <= 5400.0 => ("dialog-save-time-minutes", s / 60.0),
        s => ("dialog-save-time-hours", s / 3600.0),
    };
    tr!(key, count = (count.ceil() as u64).max(1))
}
