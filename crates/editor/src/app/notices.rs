//! Short notices in the corner of the window.

use crate::document::{EditError, Message};
use crate::text::{FluentValue, text_of};
use eframe::egui::{Context, Vec2};
use egui_notify::{Anchor, Toasts};
use std::time::Duration;

/// From the window's corner, so that the line at the bottom stays free. Points.
const MARGIN: Vec2 = Vec2::new(8.0, 40.0);

/// The notices that are shown now.
pub struct Notices {
    toasts: Toasts,
    /// Texts in the order in which they were given, for whoever looks later.
    #[cfg(test)]
    pub told: Vec<String>,
}

impl Default for Notices {
    fn default() -> Self {
        Self {
            toasts: Toasts::default().with_anchor(Anchor::BottomRight).with_margin(MARGIN),
            #[cfg(test)]
            told: Vec::new(),
        }
    }
}

impl Notices {
    /// Something went well.
    pub fn success(&mut self, text: impl Into<String>) {
        let text = self.note(text.into());
        // Of several things that went well the last one tells enough.
        self.toasts.dismiss_all_toasts();
        self.toasts.success(text).duration(Duration::from_secs(4));
    }

    /// Something that a person should know.
    pub fn info(&mut self, text: impl Into<String>) {
        let text = self.note(text.into());
        self.toasts.info(text).duration(Duration::from_secs(6));
    }

    /// Something was not done, and why.
    pub fn error(&mut self, text: impl Into<String>) {
        let text = self.note(text.into());
        self.toasts.error(text).duration(Duration::from_secs(10));
    }

    /// An edit was refused.
    pub fn refused(&mut self, error: &EditError) {
        self.error(words(&error.message()));
    }

    /// Draws them.
    pub fn show(&mut self, ctx: &Context) {
        self.toasts.show(ctx);
    }

    fn note(&mut self, text: String) -> String {
        #[cfg(test)]
        self.told.push(text.clone());
        text
    }
}

/// A message in the current language.
#[must_use]
pub fn words(message: &Message) -> String {
    let values: Vec<_> =
        message.arguments.iter().map(|(name, value)| (*name, FluentValue::from(value.as_str()))).collect();
    text_of(message.key, &values)
}
