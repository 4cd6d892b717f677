//! The editor: the window in which a person builds a scene and watches it being ray-traced.
//!
//! [`document`] holds what is edited and knows of no window; everything else draws a document and says what a person asks
//! for ([`action`]).

pub mod action;
pub mod app;
pub mod dialogs;
pub mod doctor;
pub mod document;
pub mod files;
pub mod library;
pub mod live;
pub mod panels;
pub mod shortcuts;
pub mod text;
pub mod theme;
pub mod viewport;
pub mod widgets;

/// What the window is made with, for whoever drives it.
pub use eframe::egui;

pub use app::{Editor, LaunchError, Pace, WINDOW_SIZE, run, window_builder};
