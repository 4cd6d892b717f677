//! Saving the picture: as it is, or after a render of its own; the file is written on another thread.

use super::Editor;
use crate::dialogs::{Dialog, ErrorReport, Failure, PictureSource, SaveDialog, SavePictureRequest};
use crate::document::Document;
use crate::files::{Task, TaskState, Wake};
use crate::live::{FinalImage, FinalState, Request};
use crate::text::tr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use vitrine::denoise::{DenoiseError, Denoiser, Quality};
use vitrine::formats::{self, FormatError};
use vitrine::scene::{Renderer, Scene};
use vitrine::{Image, SceneHash, metadata_of};

/// Fewer samples a pixel tell little of how long many will take.
const SAMPLES_THAT_TELL: u32 = 4;

/// What is being saved.
#[derive(Default)]
pub struct PictureSaver {
    /// Wanted as soon as its render is complete, with the metadata of the scene as it was.
    waiting: Option<(SavePictureRequest, Vec<(String, String)>)>,
    /// Being written.
    writing: Option<Task<Result<Written, FormatError>>>,
    /// Samples of pixels in a second, as the last final render went, and of which renderer.
    rate: Option<(Renderer, f64)>,
    /// How many pictures have been saved.
    saved: usize,
}

/// A picture that has been written.
struct Written {
    path: PathBuf,
    /// Why the noise is still in it although the scene wants it out.
    noisy: Option<DenoiseError>,
}

impl PictureSaver {
    /// How many pictures have been saved.
    #[must_use]
    pub const fn saved(&self) -> usize {
        self.saved
    }

    fn write(
        &mut self,
        image: Arc<FinalImage>,
        (request, mut metadata): (SavePictureRequest, Vec<(String, String)>),
        wake: Wake,
    ) {
        if !image.is_complete {
            metadata.push(("vitrine:complete".into(), "false".into()));
        }
        self.writing = Some(Task::spawn(wake, move || {
            let (light, noisy) = match clean(&image) {
                Some(Ok((light, by))) => {
                    metadata.push(("vitrine:denoised".into(), by));
                    (light, None)
                }
                Some(Err(error)) => (image.image(), Some(error)),
                None => (image.image(), None),
            };
            let options = request.write_options(metadata);
            formats::write_image(&request.path, &light, &options)?;
            Ok(Written { path: request.path, noisy })
        }));
    }
}

impl Editor {
    /// Opens the dialog «Save picture».
    pub(super) fn ask_how_to_save_picture(&mut self) {
        let settings = self.final_settings();
        let path = self.picture_path();
        let dialog = SaveDialog::new(&path, &settings, self.current_picture());
        self.dialog = Some(Dialog::SavePicture(Box::new(dialog)));
    }

    /// The settings of the final render whose picture is there, else those of the scene.
    fn final_settings(&self) -> vitrine::scene::Settings {
        let there = self.live.final_image().filter(|_| self.current_picture().is_some());
        there.map_or_else(|| self.document.scene().settings.clone(), |image| image.scene.settings.clone())
    }

    /// Where a picture goes unless a person says otherwise: beside the scene, or among the person's pictures. A new name
    /// for each, so that none is lost.
    fn picture_path(&self) -> PathBuf {
        let folder = match self.document.path().and_then(std::path::Path::parent) {
            Some(folder) => folder.to_owned(),
            None => self.places.pictures_folder(),
        };
        let name = self.document.title().unwrap_or_else(|| tr!("app-untitled"));
        let name = name.strip_suffix(".vitrine.toml").or_else(|| name.strip_suffix(".toml")).unwrap_or(&name);
        let numbered = |n: u32| if n == 1 { format!("{name}.png") } else { format!("{name} {n}.png") };
        let free = (1..1000).map(|n| folder.join(numbered(n))).find(|path| !path.exists());
        free.unwrap_or_else(|| folder.join(numbered(1)))
    }

    /// Saves a picture, now or when its render is complete.
    pub(super) fn save_picture(&mut self, request: SavePictureRequest) {
        let current = self.live.final_image().filter(|_| request.source == PictureSource::Current);
        let metadata = metadata(&self.document, &request);
        if let Some(image) = current {
            self.picture.write(image, (request, metadata), self.wake.clone());
            return;
        }
        let scene = Scene { settings: request.settings.clone(), ..Scene::clone(self.document.scene()) };
        let wanted = Request { scene: Arc::new(scene), ..self.final_request() };
        self.picture.waiting = Some((request, metadata));
        self.live.start_final(wanted);
    }

    /// Samples of pixels that the scene's renderer makes in a second: as its last final render went, else as the live picture
    /// goes; None before there is either.
    pub(super) fn samples_per_second(&self) -> Option<(Renderer, f64)> {
        let renderer = self.document.scene().settings.renderer;
        self.picture.rate.filter(|(of, _)| *of == renderer).or_else(|| {
            let picture = self.live.picture().filter(|p| p.samples >= SAMPLES_THAT_TELL)?;
            let samples =
                f64::from(picture.samples) * f64::from(picture.size[0]) * f64::from(picture.size[1]);
            (picture.elapsed > Duration::ZERO).then(|| (renderer, samples / picture.elapsed.as_secs_f64()))
        })
    }

    /// Looks whether a picture that was waited for is complete, and whether one has been written.
    pub(super) fn look_after_pictures(&mut self) {
        let state = self.live.final_state();
        if state == FinalState::Done {
            let status = self.live.status();
            let image = self.live.final_image();
            if let Some(image) = image.as_ref().filter(|_| status.elapsed > Duration::ZERO) {
                // It may have ended before all samples were there.
                let samples = image.film.samples() as f64;
                self.picture.rate = Some((image.settings().renderer, samples / status.elapsed.as_secs_f64()));
            }
            if let (Some(waiting), Some(image)) = (self.picture.waiting.take(), image) {
                self.picture.write(image, waiting, self.wake.clone());
            }
        }
        if let Some(error) = self.live.status().error.filter(|_| self.picture.waiting.is_some()) {
            self.picture.waiting = None;
            let report = ErrorReport::new(Failure::Render, error.to_string(), "");
            self.dialog = Some(Dialog::Error(Box::new(report)));
        }
        let Some(task) = &mut self.picture.writing else { return };
        match task.poll() {
            TaskState::Running => return,
            TaskState::Done(Ok(Written { path, noisy })) => {
                self.picture.saved += 1;
                self.notices.success(tr!("app-picture-saved", path = path.display().to_string()));
                if let Some(error) = noisy {
                    self.notices.error(match error {
                        DenoiseError::NotFound { .. } => tr!("app-picture-no-denoiser"),
                        error => tr!("app-picture-noisy", error = error.to_string()),
                    });
                }
            }
            TaskState::Done(Err(error)) => {
                self.dialog =
                    Some(Dialog::Error(Box::new(ErrorReport::of_file(Failure::SavePicture, &error))));
            }
            TaskState::Over => {}
        }
        self.picture.writing = None;
    }

    /// Waits for no picture any more: its render was stopped or another one begun.
    pub(super) fn forget_waiting_picture(&mut self) {
        if self.picture.waiting.take().is_some() {
            self.notices.info(tr!("app-picture-not-saved"));
        }
    }
}

/// A complete picture without its noise and by what that was taken out, where its scene asks for it.
fn clean(image: &FinalImage) -> Option<Result<(Image, String), DenoiseError>> {
    let settings = image.settings();
    let is_wanted = settings.denoise && settings.renderer == Renderer::Photoreal && image.is_complete;
    let run = |denoiser: Denoiser| {
        let light = denoiser.run_film(&image.film, Quality::High)?;
        Ok((light, format!("Open Image Denoise {}", denoiser.version())))
    };
    is_wanted.then(|| Denoiser::find(None).and_then(run))
}

fn metadata(document: &Document, request: &SavePictureRequest) -> Vec<(String, String)> {
    let hash = SceneHash::of(&document.text());
    let name = document.title().unwrap_or_default();
    metadata_of(&name, &document.scene().about, hash, &request.settings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::Region;
    use vitrine::film::Film;
    use vitrine::scene::Settings;

    #[test]
    fn the_noise_is_taken_out_of_complete_photoreal_pictures_that_ask_for_it() {
        let asks = |renderer, denoise, is_complete| {
            let settings = Settings { renderer, denoise, ..Settings::default() };
            let scene = Arc::new(Scene { settings, ..Scene::default() });
            clean(&FinalImage { film: Film::new(Region::whole([8, 8])), is_complete, scene }).is_some()
        };
        assert!(asks(Renderer::Photoreal, true, true));
        assert!(!asks(Renderer::Photoreal, true, false));
        assert!(!asks(Renderer::Photoreal, false, true));
        assert!(!asks(Renderer::Classic, true, true));
    }
}
