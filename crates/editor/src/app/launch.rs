//! Opening the window, and saying what is missing when there is none to be had.

use super::{Editor, Pace};
use crate::files::Places;
use eframe::egui;
use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

/// Why the program ended without a window, or with it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LaunchError {
    /// No window could be opened, or it was lost.
    #[error("cannot open a window: {cause}")]
    NoWindow {
        /// What the system says.
        cause: String,
    },
}

/// The size of the window in points. It cannot be changed (C17).
pub const WINDOW_SIZE: [f32; 2] = [1280.0, 800.0];

/// How the system is asked for the window: of one size that stays (C17).
#[must_use]
pub fn window_builder() -> egui::ViewportBuilder {
    egui::ViewportBuilder::default()
        .with_title("Vitrine")
        .with_app_id("vitrine")
        .with_inner_size(WINDOW_SIZE)
        .with_min_inner_size(WINDOW_SIZE)
        .with_max_inner_size(WINDOW_SIZE)
        .with_resizable(false)
        .with_maximize_button(false)
        .with_drag_and_drop(true)
}

/// Opens the window, with this scene if one is given, and returns when it has been closed.
///
/// # Errors
/// [`LaunchError::NoWindow`] when there is no display or it cannot draw.
pub fn run(scene: Option<PathBuf>) -> Result<(), LaunchError> {
    let options = eframe::NativeOptions { viewport: window_builder(), ..eframe::NativeOptions::default() };
    // What a system lacks (a library that is opened at run time) can come as a panic out of the libraries below; once the
    // window is there, a panic is what it always is.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let is_open = AtomicBool::new(false);
    let places = Places::of_this_person();
    let ended = panic::catch_unwind(AssertUnwindSafe(|| {
        let open = |creation: &eframe::CreationContext<'_>| {
            panic::set_hook(hook);
            is_open.store(true, Ordering::Relaxed);
            Ok(Box::new(Editor::new(&creation.egui_ctx, places, scene, Pace::Threads))
                as Box<dyn eframe::App>)
        };
        eframe::run_native("vitrine", options, Box::new(open))
    }));
    let cause = match ended {
        Ok(Ok(())) => return Ok(()),
        Ok(Err(error)) => error.to_string(),
        Err(panic) if is_open.into_inner() => panic::resume_unwind(panic),
        Err(panic) => words_of(&*panic),
    };
    Err(LaunchError::NoWindow { cause })
}

fn words_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no reason is known".to_owned())
}
