//! `vitrine info`: a scene in numbers.

use crate::console;
use crate::failure::{Exit, Failure};
use crate::flags::SettingFlags;
use clap::Args;
use std::path::PathBuf;
use vitrine::Project;
use vitrine::summary::{Counts, Summary, plural};

/// Show what is in a scene and what will be slow
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine info ball.vitrine.toml\n  \
    vitrine info ball.vitrine.toml --samples 64")]
pub struct Info {
    /// The scene file
    scene: PathBuf,

    #[command(flatten)]
    settings: SettingFlags,
}

impl Info {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let mut project = vitrine::load(&self.scene)?;
        self.settings.apply(&mut project)?;
        let mut text = format!("{}\n", project.path().display());
        if !project.scene.about.is_empty() {
            text.push_str(&format!("{}\n", project.scene.about));
        }
        text.push('\n');
        text.push_str(&console::table(&rows(&project, &Summary::of(&project)?), false));
        console::print(text)?;
        Ok(Exit::Done)
    }
}

fn rows(project: &Project, summary: &Summary) -> Vec<Vec<String>> {
    let scene = &project.scene;
    let settings = &scene.settings;
    let [width, height] = settings.size;
    let mut rows = vec![
        ("Objects", counts(&summary.objects, summary.hidden_objects, "hidden")),
        ("Lights", counts(&summary.lights, summary.hidden_lights, "off")),
        ("Materials", scene.materials.len().to_string()),
        ("Textures", scene.textures.len().to_string()),
        ("Groups", scene.groups.len().to_string()),
        ("Triangles", console::thousands(summary.triangles as u64)),
        ("Bounds", bounds(summary)),
        (
            "Picture",
            format!(
                "{width} × {height} pixels, {}, depth {}, {}",
                plural(u64::from(settings.samples), "sample"),
                settings.depth,
                settings.renderer.word()
            ),
        ),
        ("Memory", format!("about {}", bytes(summary.memory))),
        ("Rays", format!("about {}", console::thousands(round_to_two_digits(summary.rays)))),
    ];
    rows.extend(summary.slow.iter().map(|part| ("Slow", part.clone())));
    rows.into_iter().map(|(name, value)| vec![name.to_owned(), value]).collect()
}

fn counts(counts: &Counts, hidden: usize, word: &str) -> String {
    if counts.is_empty() {
        return "none".into();
    }
    let total: usize = counts.iter().map(|(_, n)| n).sum();
    let kinds: Vec<_> = counts.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
    let hidden = if hidden > 0 { format!("; {hidden} {word}") } else { String::new() };
    format!("{total} ({}{hidden})", kinds.join(", "))
}

fn bounds(summary: &Summary) -> String {
    if summary.bounds.is_empty() {
        return "nothing that has an end".into();
    }
    let size = summary.bounds.size();
    let point = |p: vitrine::math::Vec3| format!("[{:.3}, {:.3}, {:.3}]", p.x, p.y, p.z);
    format!(
        "{:.3} × {:.3} × {:.3} m, from {} to {}",
        size.x,
        size.y,
        size.z,
        point(summary.bounds.min),
        point(summary.bounds.max)
    )
}

fn bytes(bytes: u64) -> String {
    let megabytes = bytes as f64 / 1e6;
    if megabytes < 1000.0 { format!("{megabytes:.1} MB") } else { format!("{:.2} GB", megabytes / 1000.0) }
}

/// An estimate does not pretend to know more than its first two digits.
fn round_to_two_digits(number: u64) -> u64 {
    let unit = 10_u64.pow(number.checked_ilog10().unwrap_or(0).saturating_sub(1));
    (number + unit / 2) / unit * unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimates_are_rounded() {
        assert_eq!([0, 7, 42, 1_249, 8_963_211].map(round_to_two_digits), [0, 7, 42, 1_200, 9_000_000]);
    }
}
