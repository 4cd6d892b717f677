//! The glossary: each term in both languages, side by side.

use super::terms::{Words, search};
use crate::dialogs::Outcome;
use crate::dialogs::frame::{self, Buttons, Shell, Verdict};
use crate::text::{Language, language, tr};
use crate::theme;
use crate::widgets::{empty_hint, search_field};
use eframe::egui::{Context, Label, RichText, ScrollArea, Ui};

/// The glossary.
#[derive(Debug, Default)]
pub struct GlossaryDialog {
    search: String,
}

impl GlossaryDialog {
    pub(in crate::dialogs) fn show(&mut self, ctx: &Context) -> Outcome {
        let title = tr!("help-glossary-title");
        let width = theme::of(ctx).sizes.dialog_wide;
        let verdict = frame::show(ctx, Shell { id: "glossary", title: &title, width }, |ui| {
            self.body(ui);
            Buttons::close()
        });
        if verdict == Verdict::Open { Outcome::Stay(None) } else { Outcome::Close(None) }
    }

    fn body(&mut self, ui: &mut Ui) {
        let (name, tooltip) = (tr!("help-glossary-search"), tr!("help-glossary-search.tooltip"));
        search_field(ui, &mut self.search, &name, &tooltip);
        let found = search(&self.search);
        let sizes = &theme::of(ui).sizes;
        let height = sizes.control * 15.0;
        let area = ScrollArea::vertical().id_salt("terms").max_height(height).min_scrolled_height(height);
        area.auto_shrink([false, false]).show(ui, |ui| {
            if found.is_empty() {
                let text = tr!("help-glossary-nothing", text = self.search.trim());
                empty_hint(ui, &text);
            }
            for words in &found {
                pair(ui, words);
                ui.separator();
            }
        });
        frame::hint(ui, &tr!("help-glossary-count", count = found.len()));
    }
}

/// A term: the person's own language first.
fn pair(ui: &mut Ui, [english, russian]: &[Words; 2]) {
    let (own, other) = match language() {
        Language::English => (english, russian),
        Language::Russian => (russian, english),
    };
    frame::columns(ui, |left, right| {
        words(left, own, true);
        words(right, other, false);
    });
}

fn words(ui: &mut Ui, words: &Words, is_own: bool) {
    let theme = theme::of(ui);
    let color = if is_own { theme.text_strong } else { theme.text };
    ui.add(Label::new(RichText::new(&words.term).color(color).strong()).wrap());
    frame::hint(ui, &words.meaning);
}
