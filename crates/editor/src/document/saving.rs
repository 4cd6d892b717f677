//! The document and its file: what is told when the scene has been written, and what counts as nothing to save.

use super::{Document, asset_files};
use crate::files::Saved;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::formats::{SceneFile, folder_of};
use vitrine::scene::Scene;

impl Document {
    /// The file that was read or written last; its text is what saving changes.
    #[must_use]
    pub const fn file(&self) -> &SceneFile {
        &self.file
    }

    /// Notes that `written`, a state of the scene, stands in the file `path` now. Paths that read otherwise there, because
    /// they count from another folder, are taken over, in what can be undone as well.
    pub fn take_saved(&mut self, path: PathBuf, saved: Saved, written: &Arc<Scene>) {
        let Saved { file, assets, moved, .. } = saved;
        self.provide(assets, Vec::new());
        let is_as_written = Arc::ptr_eq(&self.scene, written);
        if !moved.is_empty() {
            let to = |old: &Path| {
                let moved = moved.iter().find(|(before, _)| Path::new(before) == old);
                moved.map_or_else(|| old.to_owned(), |(_, after)| PathBuf::from(after))
            };
            asset_files::rename(Arc::make_mut(&mut self.scene), to);
            self.history.rename_files(to);
            self.revision += 1;
        }
        self.folder = folder_of(&path).to_owned();
        self.path = Some(path);
        self.saved = Some(if is_as_written { self.scene.clone() } else { Arc::new(file.scene().clone()) });
        self.file = file;
        self.compare_with_saved();
    }

    /// Notes that a person gives up what is not saved.
    pub fn forget_changes(&mut self) {
        self.saved = Some(self.scene.clone());
        self.compare_with_saved();
    }
}
