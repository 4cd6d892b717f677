//! What can be chosen on the command line.

use vitrine_measure::SceneKind;
use vitrine_measure::rays::{RayKind, SIZE};

const HELP: &str = "\
cargo bench --bench kernel -- [SCENE…] [RAYS…] [--rounds N] [--small]

SCENE     seed, room, cave; all when none is named
RAYS      primary, shadow, mirror, diffuse, ambient; all when none is named
--rounds  how many times all rays are traced; 5 when nobody says
--small   a tenth of the triangles and of the rays, to see that everything works

VITRINE_EMBREE=/path/to/libembree4.so.4 lets Embree take part.";

/// What is measured.
pub struct Options {
    pub scenes: Vec<SceneKind>,
    pub rays: Vec<RayKind>,
    pub rounds: usize,
    /// The picture that the camera's rays are for, pixels.
    pub size: [u32; 2],
    is_small: bool,
}

impl Options {
    /// Reads the arguments; the help is an error, too.
    pub fn read(arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options =
            Self { scenes: Vec::new(), rays: Vec::new(), rounds: 5, size: SIZE, is_small: false };
        let mut arguments = arguments;
        while let Some(word) = arguments.next() {
            let scene = SceneKind::ALL.into_iter().find(|s| s.name() == word);
            let rays = RayKind::ALL.into_iter().find(|r| r.name() == word);
            match (word.as_str(), scene, rays) {
                // What cargo adds.
                ("--bench", ..) => {}
                ("--small", ..) => (options.is_small, options.size) = (true, [256, 264]),
                ("--rounds", ..) => {
                    let number = arguments.next().and_then(|n| n.parse().ok()).filter(|n| *n > 0);
                    options.rounds = number.ok_or("--rounds takes a whole number from 1 on")?;
                }
                (_, Some(scene), _) => options.scenes.push(scene),
                (_, _, Some(rays)) => options.rays.push(rays),
                _ => return Err(HELP.to_owned()),
            }
        }
        if options.scenes.is_empty() {
            options.scenes.extend(SceneKind::ALL);
        }
        if options.rays.is_empty() {
            options.rays.extend(RayKind::ALL);
        }
        Ok(options)
    }

    /// How many triangles a scene gets.
    pub fn triangles(&self, scene: SceneKind) -> u32 {
        scene.triangles() / if self.is_small { 10 } else { 1 }
    }
}
