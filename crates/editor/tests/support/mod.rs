//! What tests of the window share: a renderer without a graphics card, and checks of what is seen and named.
//!
//! ```ignore
//! mod support;
//! let mut harness = Harness::builder().renderer(support::CpuRenderer::default()).build_ui(…);
//! ```
#![allow(dead_code, reason = "each test program uses a part of it")]

mod checks;
mod renderer;

pub use checks::{controls_without_name_or_tooltip, labels_clipped};
pub use renderer::CpuRenderer;

use egui_kittest::Harness;
use std::path::PathBuf;

/// Whether a picture is wanted, for a look by eye: `VITRINE_PICTURES` is a part of its name.
pub fn is_pictured(name: &str) -> bool {
    std::env::var("VITRINE_PICTURES").is_ok_and(|part| name.contains(&part))
}

/// Draws the window into `target/tmp/<name>.png`, for a look by eye.
pub fn picture<State>(harness: &mut Harness<'_, State>, name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    let image = harness.render().expect("the renderer has no way to fail");
    image.save(&path).expect("target/tmp can be written");
    path
}
