//! `vitrine man`: the manual page, with all commands.

use super::Cli;
use crate::console;
use crate::failure::{Exit, Failure};
use clap::{Args, Command, CommandFactory};
use clap_mangen::Man as Page;
use std::io::{self, Write};

/// Print the manual page
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine man | man -l -\n  \
    vitrine man > ~/.local/share/man/man1/vitrine.1")]
pub struct Man {}

impl Man {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let mut text = Vec::new();
        write_manual(&mut text).expect("a list of bytes takes everything");
        console::print(text)?;
        Ok(Exit::Done)
    }
}

/// One page: the program, then a section for each command with its own options and examples.
fn write_manual(out: &mut dyn Write) -> io::Result<()> {
    let mut program = Cli::command().disable_help_subcommand(true);
    program.build();
    let page = Page::new(program.clone());
    page.render_title(out)?;
    page.render_name_section(out)?;
    page.render_synopsis_section(out)?;
    page.render_description_section(out)?;
    write_closing_words(&program, out)?;
    write_commands(&program, out)
}

fn write_commands(parent: &Command, out: &mut dyn Write) -> io::Result<()> {
    for command in parent.get_subcommands().filter(|c| !c.is_hide_set()) {
        if command.has_subcommands() {
            write_commands(command, out)?;
            continue;
        }
        let name = command.get_bin_name().unwrap_or(command.get_name());
        writeln!(out, ".SH \"{}\"", name.to_uppercase())?;
        let page = Page::new(command.clone());
        write_as_subsection(|text| page.render_synopsis_section(text), out)?;
        write_as_subsection(|text| page.render_description_section(text), out)?;
        write_as_subsection(|text| page.render_options_section(text), out)?;
        write_closing_words(command, out)?;
    }
    Ok(())
}

/// The section of a page of its own, one level down.
fn write_as_subsection(
    render: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut text = Vec::new();
    render(&mut text)?;
    for line in String::from_utf8_lossy(&text).lines() {
        match line.strip_prefix(".SH ") {
            Some(heading) => writeln!(out, ".SS {heading}")?,
            // Each section repeats the definition of an apostrophe; once, at the top, is enough.
            None if line.starts_with(".ie ") || line.starts_with(".el ") => {}
            None => writeln!(out, "{line}")?,
        }
    }
    Ok(())
}

/// What stands below the help, line by line as it is.
fn write_closing_words(command: &Command, out: &mut dyn Write) -> io::Result<()> {
    let Some(text) = command.get_after_help() else { return Ok(()) };
    writeln!(out, ".PP\n.nf")?;
    for line in text.to_string().lines() {
        // A leading dot or apostrophe would be a command of roff, a backslash an escape.
        writeln!(out, "\\&{}", line.replace('\\', "\\e").replace('-', "\\-"))?;
    }
    writeln!(out, ".fi")
}
