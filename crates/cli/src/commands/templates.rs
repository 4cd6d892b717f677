//! `vitrine templates`: scenes to begin with.

use crate::failure::{Exit, Failure};
use crate::{console, output};
use clap::Args;
use std::path::PathBuf;
use vitrine::scene::closest;
use vitrine::templates::{Existing, TEMPLATES, Template};

/// List the scenes to begin with, or write one
///
/// Models and textures that the scene needs are written into folders beside it.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine templates\n  \
    vitrine templates empty -o my.vitrine.toml\n  \
    vitrine templates empty | less")]
pub struct Templates {
    /// The template's name; without it, all are listed
    name: Option<String>,

    /// The scene file to write; without it, the scene's text is printed
    #[arg(short, long, value_name = "FILE", requires = "name")]
    output: Option<PathBuf>,

    /// Replace files that are there already
    #[arg(long, requires = "output")]
    force: bool,
}

impl Templates {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let Some(name) = &self.name else {
            let rows: Vec<_> = TEMPLATES.iter().map(|t| vec![t.name.to_owned(), t.about()]).collect();
            console::print(console::table(&rows, false))?;
            return Ok(Exit::Done);
        };
        let template = Template::find(name).ok_or_else(|| unknown(name))?;
        let Some(path) = &self.output else {
            console::print(template.text())?;
            let needed: Vec<_> = template.assets.iter().map(|(path, _)| *path).collect();
            if !needed.is_empty() {
                console::tell(&format!("It needs {}; -o FILE writes them beside it.", needed.join(", ")));
            }
            return Ok(Exit::Done);
        };
        output::check_place(path)?;
        let existing = if self.force { Existing::Replace } else { Existing::Keep };
        for written in template.write(path, existing)? {
            console::print(format!("{}\n", written.display()))?;
        }
        Ok(Exit::Done)
    }
}

fn unknown(name: &str) -> Failure {
    let names = || TEMPLATES.iter().map(|t| t.name);
    let help = match closest(name, names()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the templates are {}", names().collect::<Vec<_>>().join(", ")),
    };
    Failure::usage(format!("there is no template `{name}`"), help)
}
