//! A folder to work in, a small scene, and the program.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;
use vitrine::formats::read_picture;
use vitrine::scene::Picture;

/// A small picture with a glass ball, a soft shadow, a mirror and a texture of squares.
pub const SCENE: &str = r##"format = 1
about = "a ball for tests"

[settings]
size = [40, 30]
shadow_points = 8
background = "#2b3a55"

[camera]
position = [0.0, 1.2, 5.0]

[[light]]
name = "everywhere"
kind = "ambient"
intensity = 0.3

[[light]]
name = "lamp"
kind = "disc"
position = [2.0, 5.0, 3.0]
radius = 0.5

[[texture]]
name = "squares"
kind = "checker"

[[material]]
name = "floor"
texture = "squares"

[[material]]
name = "red glass"
color = "#c8281e"
transparency = 0.8
specular = 0.5
reflectivity = 0.2

[[object]]
name = "ground"
shape = "plane"
material = "floor"

[[object]]
name = "ball"
shape = "sphere"
position = [0.0, 1.0, 0.0]
material = "red glass"
"##;

/// A folder of its own for each test.
pub struct Folder(TempDir);

/// How the program ended and what it said.
#[derive(Debug)]
pub struct Outcome {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Folder {
    /// An empty one.
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("the system has room for a folder"))
    }

    /// One with [`SCENE`] as scene.vitrine.toml.
    pub fn with_scene() -> Self {
        let folder = Self::new();
        folder.write("scene.vitrine.toml", SCENE);
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().expect("it is in the folder")).expect("a folder can be made");
        fs::write(path, content).expect("a file can be written");
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub fn picture(&self, name: &str) -> Picture {
        read_picture(&self.path(name)).expect("it is a picture")
    }

    /// The names of all files and folders, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("the folder is there");
        let name = |e: std::io::Result<fs::DirEntry>| e.expect("the folder can be read").file_name();
        let mut names: Vec<_> = entries.map(|e| name(e).to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// The program in this folder.
    pub fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_vitrine"));
        command.current_dir(self.0.path());
        command
    }

    /// Runs the program in this folder.
    pub fn run(&self, arguments: &[&str]) -> Outcome {
        outcome(self.command().args(arguments))
    }

    /// Runs the program, which must do what it is asked.
    pub fn run_well(&self, arguments: &[&str]) -> Outcome {
        let outcome = self.run(arguments);
        assert_eq!(outcome.code, Some(0), "{arguments:?}: {outcome:#?}");
        outcome
    }
}

/// Runs a command to its end.
pub fn outcome(command: &mut Command) -> Outcome {
    let output = command.output().expect("the program starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it speaks UTF-8");
    Outcome { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

impl Outcome {
    /// The lines of JSON.
    pub fn events(&self) -> Vec<Value> {
        self.out.lines().map(|line| serde_json::from_str(line).expect("each line is JSON")).collect()
    }

    /// Checks the exit code and that every one of the words was said on stderr.
    #[track_caller]
    pub fn fails(&self, code: i32, words: &[&str]) {
        assert_eq!(self.code, Some(code), "{self:#?}");
        for word in words {
            assert!(self.err.contains(word), "no `{word}` in {}", self.err);
        }
        assert!(!self.err.contains('\u{1b}'), "colours where there is no terminal: {}", self.err);
        assert!(!self.err.contains("panicked"), "{}", self.err);
    }
}

/// Whether the bytes occur in it.
pub fn contains(bytes: &[u8], part: &str) -> bool {
    bytes.windows(part.len()).any(|window| window == part.as_bytes())
}

/// A path as text.
pub fn text(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}
