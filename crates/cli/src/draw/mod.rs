//! Drawing by the program itself: contact sheets and plots.

mod plot;
mod sheet;
mod shrink;
mod text;

pub use plot::{Growth, Threads, check_plot, plot};
pub use sheet::{Layout, sheet};
pub use shrink::shrink;

/// Inter, for captions and plots; assets/fonts/README.md says where it comes from.
const FONT: &[u8] = include_bytes!("../../../../assets/fonts/Inter-Regular.otf");
