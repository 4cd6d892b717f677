//! Writes a scene in POV-Ray's language and prints its width and height, for `benches/povray/compare.sh`:
//! `cargo run -p vitrine-benches --example to_povray -- SCENE OUT.pov`

// A program for a script talks to the script.
#![allow(clippy::print_stdout, clippy::print_stderr)]

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use vitrine_benches::povray;
use vitrine_formats::{SceneFile, load_assets};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, out] = &arguments[..] else {
        eprintln!("usage: to_povray SCENE OUT.pov");
        return ExitCode::from(2);
    };
    match translate(Path::new(scene), Path::new(out)) {
        Ok([width, height]) => {
            println!("{width} {height}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn translate(path: &Path, out: &Path) -> Result<[u32; 2], Box<dyn Error>> {
    let scene = SceneFile::read(path)?.into_scene();
    let (assets, _) = load_assets(&scene, path.parent().unwrap_or(Path::new(".")))?;
    fs::write(out, povray::translate(&scene, &assets)?)?;
    Ok(scene.settings.size)
}
