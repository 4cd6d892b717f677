//! The settings of the program, which are the person's and not the scene's.

use crate::text::Language;
use serde::{Deserialize, Serialize};

/// The settings of the program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Config {
    /// The language of the window.
    pub language: Language,
    /// How many threads compute the picture; 0: all of the machine's.
    pub threads: usize,
    /// Larger letters.
    pub large_text: bool,
    /// Stronger contrast.
    pub high_contrast: bool,
    /// Whether the guided tour has been seen or dismissed.
    pub tour_seen: bool,
}
