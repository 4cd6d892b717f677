//! Writes a scene in Mitsuba's language, for `benches/mitsuba/compare.py`:
//! `cargo run -p vitrine-benches --bin to_mitsuba -- SCENE OUT.xml`

// A program for a script talks to the script.
#![allow(clippy::print_stderr)]

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use vitrine_benches::mitsuba;
use vitrine_formats::{SceneFile, load_assets};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, out] = &arguments[..] else {
        eprintln!("usage: to_mitsuba SCENE OUT.xml");
        return ExitCode::from(2);
    };
    match translate(Path::new(scene), Path::new(out)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn translate(path: &Path, out: &Path) -> Result<(), Box<dyn Error>> {
    let scene = SceneFile::read(path)?.into_scene();
    let folder = path.parent().unwrap_or(Path::new(".")).canonicalize()?;
    let (assets, _) = load_assets(&scene, &folder)?;
    fs::write(out, mitsuba::translate(&scene, &assets, &folder)?)?;
    Ok(())
}
