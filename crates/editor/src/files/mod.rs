//! Files of the editor: settings of the program, recent files, opening, saving, recovery.

mod autosave;
mod config;
mod open;
mod own_file;
mod places;
mod problem;
mod recent;
mod recovery;
mod relative;
mod save;
mod task;
mod wording;

pub use autosave::{AUTOSAVE_EVERY, Autosave, Snapshot};
pub use config::Config;
pub use open::{
    NewAsset, Opened, Seen, complete_assets, read_model, read_panorama, read_picture, read_scene,
    read_template,
};
pub use own_file::OwnFileWarning;
pub use places::{HOME_VARIABLE, Places};
pub use problem::{FileProblem, OpenError, TextPlace};
pub use recent::{Recent, RecentFile};
pub use recovery::{Recovery, recoverable};
pub use relative::{file_name, path_in_scene};
pub use save::{SaveError, SaveRequest, Saved, save};
pub use task::{Task, TaskState, Wake};
pub(crate) use wording::describe;
