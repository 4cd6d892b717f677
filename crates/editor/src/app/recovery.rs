//! What survives the end of the window: autosave while one edits, and scenes of windows that were killed.

use super::Editor;
use crate::dialogs::Failure;
use crate::document::Document;
use crate::files::{Recovery, Snapshot};
use crate::library::ThumbnailImage;
use crate::live::Picture;
use crate::text::tr;
use std::path::PathBuf;

/// The longer side of the small picture that is kept with a scene, pixels.
const THUMBNAIL: usize = 240;

impl Editor {
    /// Gives the autosave what there is now, if it is new and not saved.
    pub(super) fn offer_autosave(&mut self) {
        let Some(autosave) = &mut self.autosave else { return };
        if let Some(reason) = autosave.take_error() {
            self.notices.error(tr!("app-no-autosave", reason = reason));
        }
        let revision = self.document.revision();
        if !self.document.is_changed() || !autosave.wants(revision) {
            return;
        }
        let folder = self.document.folder();
        autosave.offer(Snapshot {
            revision,
            title: self.document.title().unwrap_or_else(|| tr!("app-untitled")),
            scene: self.document.scene().clone(),
            base: Some(self.document.file().clone()),
            path: self.document.path().map(Into::into),
            folder: (!folder.as_os_str().is_empty()).then(|| folder.to_owned()),
            seen: self.scenes.seen(),
            thumbnail: self.live.picture().map(|picture| shrunk(&picture)),
        });
    }

    /// There is nothing to lose any more.
    pub(super) fn forget_autosave(&mut self) {
        if let Some(autosave) = &mut self.autosave {
            autosave.forget();
        }
    }

    /// Opens a scene that was kept when its window was killed.
    pub(super) fn recover(&mut self, index: usize) {
        if index >= self.recoveries.len() {
            return;
        }
        let recovery = self.recoveries.remove(index);
        match recovery.open() {
            Ok(opened) => {
                let folder = recovery.folder().map(Into::into).unwrap_or_default();
                self.take_recovered(opened, folder, recovery);
            }
            // It stays on the disc, for a later start.
            Err(error) => self.report(Failure::Scene, &error),
        }
    }

    fn take_recovered(&mut self, opened: crate::files::Opened, folder: PathBuf, recovery: Recovery) {
        self.scenes.set_seen(opened.seen.clone());
        let mut document = match opened.path {
            Some(path) => Document::opened(opened.file, opened.assets, opened.notes, path),
            None => Document::untitled(opened.file, opened.assets, folder),
        };
        document.mark_unsaved();
        self.show_document(document);
        if let Some(autosave) = &mut self.autosave {
            autosave.replace(recovery);
        }
    }

    /// Throws such a scene away.
    pub(super) fn forget_recovery(&mut self, index: usize) {
        if index < self.recoveries.len() {
            self.recoveries.remove(index).discard();
        }
    }
}

/// A small picture of what is shown: every so many pixels one.
fn shrunk(picture: &Picture) -> ThumbnailImage {
    let [width, height] = picture.size.map(|v| v as usize);
    let step = width.max(height).div_ceil(THUMBNAIL).max(1);
    let rows = (0..height).step_by(step);
    let pixels = rows.flat_map(|y| (0..width).step_by(step).map(move |x| 4 * (y * width + x)));
    let rgba = pixels.flat_map(|at| picture.rgba[at..at + 4].iter().copied()).collect();
    ThumbnailImage { size: [width.div_ceil(step), height.div_ceil(step)], rgba }
}
