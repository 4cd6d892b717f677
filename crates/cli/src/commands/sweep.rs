//! `vitrine sweep`: one value changed step by step, the pictures on a contact sheet (course work, section 4.2.1).

use crate::failure::{Exit, Failure};
use crate::flags::{PictureFlags, SettingFlags, ThreadFlag};
use crate::picture;
use crate::progress::Bar;
use crate::report::Report;
use crate::{console, draw, interrupt, output, report};
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use vitrine::film::Display;
use vitrine::summary::plural;
use vitrine::{Cancel, Error, Image, Project, WriteOptions, display_of, formats};

/// Render a scene with several values of one thing, onto a contact sheet
///
/// One `--set` gives several values; each makes a picture, and all stand on the sheet with their values under them.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine sweep ball.vitrine.toml --set object.ball.material.transparency=1,0.8,0.6,0.4,0.2,0\n  \
    vitrine sweep ball.vitrine.toml --set settings.depth=0,1,2,3 -o depths.png --each pictures\n  \
    vitrine sweep ball.vitrine.toml --set 'camera.position=[0, 1, 5],[3, 1, 4]' --samples 4")]
pub struct Sweep {
    /// The scene file, NAME.vitrine.toml
    scene: PathBuf,

    /// Where the contact sheet goes; without it, beside the scene as NAME-sweep.png
    #[arg(short, long, value_name = "SHEET")]
    output: Option<PathBuf>,

    /// Write each picture by itself into this folder, too
    #[arg(long, value_name = "DIR")]
    each: Option<PathBuf>,

    #[command(flatten)]
    threads: ThreadFlag,

    #[command(flatten)]
    picture: PictureFlags,

    /// No progress bar, no warnings, no last line; errors are still shown
    #[arg(short, long)]
    quiet: bool,

    #[command(flatten)]
    settings: SettingFlags,
}

/// The series: what is changed, and the values.
struct Series {
    path: String,
    values: Vec<String>,
}

impl Sweep {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let cancel = interrupt::cancel_on_interrupt()?;
        if let Some(path) = &self.output {
            output::check_picture(path)?;
        }
        let (series, fixed) = self.series()?;
        let mut project = vitrine::load(&self.scene)?;
        SettingFlags { set: fixed, ..self.settings.clone() }.apply(&mut project)?;
        let path = self.output.clone().unwrap_or_else(|| output::beside(&project, "-sweep.png"));
        output::check_picture(&path)?;
        let mut options = self.picture.options(&path)?;
        options.metadata = project.metadata(&project.scene.settings);
        options
            .metadata
            .push(("vitrine:sweep".into(), format!("{}={}", series.path, series.values.join(","))));
        if !self.quiet {
            report::show(&Report::warnings_of(&project));
        }
        let layout = draw::Layout::new(series.values.len(), series.largest_picture(&mut project)?);
        self.prepare_folder()?;

        let mut pictures = Vec::new();
        for step in 0..series.values.len() {
            project.set(&[series.assignment(step)])?;
            let Some((image, is_complete)) = self.render(&project, &series, step, &cancel)? else { break };
            self.save_alone(&project, &image, &series.file_name(&project, step, &path))?;
            let small = draw::shrink(&image, &display_of(&project.scene.settings), layout.fit(image.size));
            pictures.push((small, series.caption(step)));
            if !is_complete {
                break;
            }
        }
        if !pictures.is_empty() {
            // The small pictures are display light already; the plain curve writes them as they are.
            let options = WriteOptions { display: Display::default(), ..options };
            formats::write_image(&path, &draw::sheet(layout, &pictures), &options)?;
        }
        self.say_done(&path, pictures.len(), &cancel)
    }

    /// The one `--set` with several values, and the assignments with one.
    fn series(&self) -> Result<(Series, Vec<String>), Failure> {
        let mut series = None;
        let mut fixed = Vec::new();
        for argument in &self.settings.set {
            let split = formats::scene_file::split_values(argument)
                .map_err(|error| Failure::new(Exit::Usage, Report::of_set(argument, &error)))?;
            match split {
                (_, values) if values.len() < 2 => fixed.push(argument.clone()),
                (path, values) if series.is_none() => series = Some(Series { path, values }),
                _ => {
                    return Err(Failure::usage(
                        "two --set give several values",
                        "let one of them have several values and the others one each",
                    ));
                }
            }
        }
        let missing = || {
            Failure::usage(
                "no --set gives several values",
                "separate the values by commas: --set object.ball.material.transparency=1,0.5,0",
            )
        };
        Ok((series.ok_or_else(missing)?, fixed))
    }

    /// The picture of one step, and whether it is complete. None when it was interrupted before there was anything.
    fn render(
        &self,
        project: &Project,
        series: &Series,
        step: usize,
        cancel: &Cancel,
    ) -> Result<Option<(Image, bool)>, Failure> {
        let bar = Bar::new(self.quiet);
        let compiled = picture::compile(project)?;
        bar.begin(format!("{} of {}", step + 1, series.values.len()));
        let threads = self.threads.count();
        let made =
            picture::make(&compiled, project.options(), threads, cancel, &mut |progress| bar.show(progress))?;
        let is_complete = made.rendered.is_complete();
        let film = made.rendered.film;
        Ok((film.samples() > 0).then(|| (film.into_image(), is_complete)))
    }

    fn prepare_folder(&self) -> Result<(), Failure> {
        let Some(folder) = &self.each else { return Ok(()) };
        fs::create_dir_all(folder).map_err(|source| Error::Folder { path: folder.clone(), source })?;
        output::check_folder(folder)
    }

    fn save_alone(&self, project: &Project, image: &Image, file_name: &str) -> Result<(), Failure> {
        let Some(folder) = &self.each else { return Ok(()) };
        let path = folder.join(file_name);
        let settings = &project.scene.settings;
        let (metadata, display) = (project.metadata(settings), display_of(settings));
        let options = WriteOptions { metadata, display, ..self.picture.options(&path)? };
        formats::write_image(&path, image, &options)?;
        Ok(())
    }

    fn say_done(&self, path: &Path, pictures: usize, cancel: &Cancel) -> Result<Exit, Failure> {
        if pictures == 0 {
            console::tell(picture::NOTHING_YET);
            return Ok(Exit::Interrupted);
        }
        let pictures = plural(pictures as u64, "picture");
        if cancel.is_cancelled() {
            console::tell(&format!("Interrupted: {pictures} in {}", path.display()));
            return Ok(Exit::Interrupted);
        }
        if !self.quiet {
            console::print(format!("{}: {pictures}\n", path.display()))?;
        }
        Ok(Exit::Done)
    }
}

impl Series {
    fn assignment(&self, step: usize) -> String {
        format!("{}={}", self.path, self.values[step])
    }

    /// The last word of the path, which names the value.
    fn key(&self) -> &str {
        self.path.rsplit('.').next().unwrap_or(&self.path).trim()
    }

    fn caption(&self, step: usize) -> String {
        format!("{} = {}", self.key(), self.values[step].trim())
    }

    /// "ball-2-transparency-0.8.png", with the extension of the sheet.
    fn file_name(&self, project: &Project, step: usize, sheet: &Path) -> String {
        let digits = self.values.len().to_string().len();
        let tame = |c: char| if c.is_alphanumeric() || "._-".contains(c) { c } else { '_' };
        let value: String = self.values[step].trim().trim_matches('"').chars().take(60).map(tame).collect();
        let extension = sheet.extension().unwrap_or_default().to_string_lossy();
        format!("{}-{:0digits$}-{}-{value}.{extension}", project.name(), step + 1, self.key())
    }

    /// Tries every value before anything is rendered; the largest width and height of a picture among them.
    fn largest_picture(&self, project: &mut Project) -> Result<[u32; 2], Failure> {
        let mut largest = [1, 1];
        for step in 0..self.values.len() {
            project.set(&[self.assignment(step)]).map_err(|error| match error {
                Error::Scene(_) => Failure { exit: Exit::Usage, ..error.into() },
                _ => error.into(),
            })?;
            let size = project.scene.settings.size;
            largest = [0, 1].map(|i| largest[i].max(size[i]));
        }
        Ok(largest)
    }
}
