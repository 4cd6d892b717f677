//! Files of the editor: settings of the program, recent files, opening, saving, recovery.

mod config;

pub use config::Config;
