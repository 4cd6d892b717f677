//! Choosing a file: what for, from which folder, with which endings.

use crate::files::file_name;
use crate::text::tr;
use eframe::egui;
use egui_file_dialog::{DialogState, FileDialog, FileDialogConfig, FileDialogLabels, Filter, OpeningMode};
use egui_phosphor::regular as icons;
use std::path::{Path, PathBuf};

/// What a file is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A scene to open.
    OpenScene,
    /// The name under which the scene is saved.
    SaveScene,
    /// A model to add.
    LoadModel,
    /// A picture for a texture.
    LoadTexture,
    /// A panorama for a new light.
    LoadPanorama,
    /// Another model in place of one of the scene's.
    ReplaceModel,
    /// A picture for something of the scene.
    ReplaceTexture,
    /// Another panorama for a light.
    ReplacePanorama,
    /// The name under which the picture is saved.
    SavePicture,
}

/// The dialog in which a file is chosen. At most one is open.
pub struct Chooser {
    dialog: FileDialog,
    purpose: Option<Purpose>,
    /// Where the last file was chosen.
    folder: PathBuf,
}

impl Chooser {
    /// Begins in this folder.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        Self { dialog: FileDialog::new(), purpose: None, folder }
    }

    /// Opens the dialog. `name` is the file name to begin with where one is to be saved.
    pub fn open(&mut self, purpose: Purpose, folder: Option<&Path>, name: &str) {
        let folder = folder.filter(|f| f.is_dir()).unwrap_or(&self.folder).to_owned();
        self.dialog = dialog_for(purpose).initial_directory(folder).default_file_name(name);
        match purpose {
            Purpose::SaveScene | Purpose::SavePicture => self.dialog.save_file(),
            _ => self.dialog.pick_file(),
        }
        self.purpose = Some(purpose);
    }

    /// Whether it is open.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.purpose.is_some()
    }

    /// Draws it; gives the file when one has been chosen.
    pub fn show(&mut self, ctx: &egui::Context) -> Option<(Purpose, PathBuf)> {
        let purpose = self.purpose?;
        *self.dialog.labels_mut() = labels();
        self.dialog.update(ctx);
        if let Some(path) = self.dialog.take_picked() {
            self.purpose = None;
            if let Some(folder) = path.parent() {
                self.folder = folder.to_owned();
            }
            return Some((purpose, path));
        }
        if *self.dialog.state() != DialogState::Open {
            self.purpose = None;
        }
        None
    }
}

fn dialog_for(purpose: Purpose) -> FileDialog {
    let dialog = FileDialog::with_config(with_icons())
        .opening_mode(OpeningMode::AlwaysInitialDir)
        .default_size([760.0, 480.0])
        .anchor(egui::Align2::CENTER_CENTER, [0.0, 0.0])
        .resizable(false)
        .movable(false)
        .show_devices(false)
        .show_removable_devices(false);
    let ending = |ends: &'static [&'static str]| {
        Filter::new(move |path: &Path| {
            let name = file_name(path).to_lowercase();
            ends.iter().any(|end| name.ends_with(end))
        })
    };
    let with_filter = |dialog: FileDialog, key: &str, ends| {
        let name = tr!(key);
        dialog.add_file_filter(&name, ending(ends)).default_file_filter(&name)
    };
    match purpose {
        Purpose::OpenScene => {
            with_filter(dialog, "chooser-scenes", &[".toml"]).title(&tr!("chooser-open-scene"))
        }
        Purpose::SaveScene => dialog.title(&tr!("chooser-save-scene")),
        Purpose::LoadModel | Purpose::ReplaceModel => {
            with_filter(dialog, "chooser-models", &[".obj"]).title(&tr!("chooser-load-model"))
        }
        Purpose::LoadTexture | Purpose::ReplaceTexture => {
            with_filter(dialog, "chooser-pictures", &[".png", ".jpg", ".jpeg"])
                .title(&tr!("chooser-load-texture"))
        }
        Purpose::LoadPanorama | Purpose::ReplacePanorama => {
            with_filter(dialog, "chooser-panoramas", &[".hdr", ".exr", ".png", ".jpg", ".jpeg"])
                .title(&tr!("chooser-load-panorama"))
        }
        Purpose::SavePicture => dialog.title(&tr!("chooser-save-picture")),
    }
}

/// The dialog's own icons, from the font that the whole window uses.
fn with_icons() -> FileDialogConfig {
    FileDialogConfig {
        err_icon: icons::WARNING.into(),
        warn_icon: icons::WARNING.into(),
        default_file_icon: icons::FILE.into(),
        default_folder_icon: icons::FOLDER.into(),
        pinned_icon: icons::PUSH_PIN.into(),
        device_icon: icons::HARD_DRIVE.into(),
        removable_device_icon: icons::USB.into(),
        parent_directory_icon: icons::ARROW_UP.into(),
        back_icon: icons::ARROW_LEFT.into(),
        forward_icon: icons::ARROW_RIGHT.into(),
        new_folder_icon: icons::FOLDER_PLUS.into(),
        menu_icon: icons::LIST.into(),
        search_icon: icons::MAGNIFYING_GLASS.into(),
        path_edit_icon: icons::PENCIL_SIMPLE.into(),
        ..FileDialogConfig::default()
    }
}

/// The dialog's own words.
fn labels() -> FileDialogLabels {
    FileDialogLabels {
        title_select_directory: tr!("chooser-select-folder"),
        title_select_file: tr!("chooser-select-file"),
        title_select_multiple: tr!("chooser-select-files"),
        title_save_file: tr!("chooser-save-file"),
        cancel: tr!("common-cancel"),
        overwrite: tr!("chooser-overwrite"),
        reload: tr!("chooser-reload"),
        working_directory: tr!("chooser-working-folder"),
        select_all: tr!("chooser-select-all"),
        show_hidden: tr!("chooser-show-hidden"),
        show_system_files: tr!("chooser-show-system"),
        heading_pinned: tr!("chooser-pinned"),
        heading_places: tr!("chooser-places"),
        heading_devices: tr!("chooser-devices"),
        heading_removable_devices: tr!("chooser-removable"),
        home_dir: tr!("chooser-home"),
        desktop_dir: tr!("chooser-desktop"),
        documents_dir: tr!("chooser-documents"),
        downloads_dir: tr!("chooser-downloads"),
        audio_dir: tr!("chooser-audio"),
        pictures_dir: tr!("chooser-pictures-folder"),
        videos_dir: tr!("chooser-videos"),
        pin_folder: tr!("chooser-pin"),
        unpin_folder: tr!("chooser-unpin"),
        rename_pinned_folder: tr!("chooser-rename-pin"),
        selected_directory: tr!("chooser-selected-folder"),
        selected_file: tr!("chooser-selected-file"),
        selected_items: tr!("chooser-selected-files"),
        file_name: tr!("chooser-file-name"),
        file_filter_all_files: tr!("chooser-all-files"),
        save_extension_any: tr!("chooser-any"),
        open_button: tr!("chooser-open"),
        save_button: tr!("chooser-save"),
        cancel_button: tr!("common-cancel"),
        overwrite_file_modal_text: tr!("chooser-already-there"),
        err_empty_folder_name: tr!("chooser-empty-folder-name"),
        err_empty_file_name: tr!("chooser-empty-file-name"),
        err_directory_exists: tr!("chooser-folder-exists"),
        err_file_exists: tr!("chooser-file-exists"),
    }
}
