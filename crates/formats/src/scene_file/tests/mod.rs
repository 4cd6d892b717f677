//! Tests of the whole of scene files.

mod bad_input;
mod dice;
mod printing;
mod reading;
mod setting;

use super::{SceneFile, SceneFileError};
use std::path::Path;

/// The example file that the format was agreed on; its keys are a contract.
const EXAMPLE: &str = r##"format = 1
[settings]                       # all optional
size = [809, 817]
depth = 3                        # reflection depth
background = "#2b3a55"           # "#rrggbb" is sRGB, [r, g, b] is linear
[camera]
position = [0.0, 1.2, 6.0]
turn_deg = [-5.0, 0.0, 0.0]      # or look_at = [0, 1, 0]
view_angle_deg = 50.0            # vertical
[[light]]
name = "Lamp"
kind = "disc"                    # ambient | point | directional | disc
position = [2.0, 5.0, 3.0]
radius = 0.5
intensity = 0.7
[[material]]
name = "red glass"
color = "#c8281e"
transparency = 0.8
[[object]]
name = "ball"
shape = "sphere"                 # sphere | box | plane | triangle | mesh
radius = 1.0
position = [0.0, 1.0, 0.0]
material = "red glass"
[[object]]
name = "cone"
shape = "mesh"
file = "models/cone.obj"         # relative to the scene file
"##;

fn parse(text: &str) -> Result<SceneFile, SceneFileError> {
    SceneFile::parse(Path::new("test.vitrine.toml"), text)
}

/// A file that is right, with these lines after what every file needs.
fn with(lines: &str) -> String {
    format!("format = 1\n{lines}\n")
}
