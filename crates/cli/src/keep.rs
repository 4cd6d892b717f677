//! Keeping a render that may be stopped: flags, the file, and going on with it.

use crate::failure::Failure;
use crate::report::{self, Report};
use crate::{console, values};
use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Duration;
use vitrine::render::Glance;
use vitrine::{Ending, Project, Region, RenderJob, Rendered, STATE_EXTENSION, StateFile, StateKeeper};

/// Whether a render goes on, and how it is kept.
#[derive(Args, Clone, Debug)]
pub struct KeepFlags {
    /// Go on with a render that was stopped or killed, to the same picture
    ///
    /// A render keeps how far it is in a file beside the picture, NAME.vitrine-state, and removes it when the picture is
    /// finished. Where there is no such file the render begins anew. More samples, another noise or time limit and another
    /// display than before are fine; another scene or other settings are refused. A render that its time limit ended
    /// keeps its file if it was started with this flag.
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    resume: Option<Option<PathBuf>>,

    /// Seconds between two times that a render is kept for --resume (30 where nothing is given); 0: never, nor on Ctrl-C
    #[arg(long, value_name = "SECONDS", value_parser = values::pause, allow_hyphen_values = true)]
    state_every: Option<Duration>,
}

/// Between two times that a render is kept.
const PAUSE: Duration = Duration::from_secs(30);

/// The file of a render, and what writes it.
pub struct Kept {
    file: StateFile,
    /// None: never.
    every: Option<Duration>,
    goes_on: bool,
    keeper: Option<StateKeeper>,
}

impl KeepFlags {
    /// What is kept of a render whose picture goes there.
    pub fn of(&self, picture: &Path, project: &Project, region: Option<Region>) -> Kept {
        let beside = || picture.with_extension(STATE_EXTENSION);
        let path = self.resume.clone().flatten().unwrap_or_else(beside);
        let file = StateFile::new(path, project, region);
        let every = Some(self.state_every.unwrap_or(PAUSE)).filter(|every| !every.is_zero());
        Kept { file, every, goes_on: self.resume.is_some(), keeper: None }
    }
}

impl Kept {
    /// Where the render begins: with what was kept if it is to go on, else at the beginning.
    ///
    /// # Errors
    /// When what was kept is of another render.
    pub fn begin(&mut self, job: &RenderJob, is_quiet: bool) -> Result<Rendered, Failure> {
        self.keeper = self.every.map(|every| StateKeeper::new(self.file.clone(), every));
        if !self.goes_on {
            if self.file.path().exists() && self.every.is_some() && !is_quiet {
                console::tell(&format!(
                    "A stopped render is kept here; this one begins anew and takes its place, unless you go on with --resume: {}",
                    self.file.path().display()
                ));
            }
            return Ok(job.nothing_yet());
        }
        let kept = self.file.load()?;
        if kept.is_none() && !is_quiet {
            console::tell(&format!(
                "Nothing to go on with, so this begins anew: {}",
                self.file.path().display()
            ));
        }
        Ok(kept.unwrap_or_else(|| job.nothing_yet()))
    }

    /// Keeps the render if it is time to.
    pub fn look(&mut self, glance: &Glance) {
        if let Some(keeper) = &mut self.keeper {
            keeper.look(glance);
        }
    }

    /// Keeps what was stopped and removes what is finished, once the picture is on the disc. Whether there is something to go on
    /// with. What cannot be kept is told, but does not make the render fail.
    pub fn end(self, rendered: Rendered) -> bool {
        let Self { file, every, goes_on, keeper } = self;
        let written = keeper.map_or(Ok(false), StateKeeper::finish);
        let is_over = match rendered.ending {
            Ending::Samples | Ending::Noise => true,
            Ending::Time => !goes_on,
            Ending::Unfinished => false,
        };
        if is_over {
            // One that another render left stays, if this one was too short to take its place.
            if goes_on || written.is_ok_and(|written| written) {
                file.remove();
            }
            return false;
        }
        if every.is_none() || rendered.film.samples() == 0 {
            return false;
        }
        let saved = written.and_then(|_| file.save(rendered));
        if let Err(error) = &saved {
            report::show(
                &[Report::warning(error.to_string()).with_help("the render cannot be gone on with")],
            );
        }
        saved.is_ok()
    }
}
