//! `cargo xtask models`: makes the models that the example scenes need. They are checked in, so that scenes work without
//! a build; a test sees that they are what this program makes.

use crate::generated::Generated;
use crate::lathe;
use std::f64::consts::TAU;

/// Every such file.
pub fn files() -> Vec<Generated> {
    vec![
        Generated { path: "scenes/coursework/models/cone-160.obj", text: cone_obj(80) },
        Generated { path: "scenes/coursework/models/cone-162.obj", text: cone_obj(81) },
        Generated { path: "scenes/models/bottle.obj", text: lathe::obj(&lathe::BOTTLE) },
        Generated { path: "scenes/models/cone.obj", text: cone_obj(80) },
        Generated { path: "scenes/models/drink.obj", text: lathe::obj(&lathe::DRINK) },
        Generated { path: "scenes/models/foot.obj", text: lathe::obj(&lathe::FOOT) },
        Generated { path: "scenes/models/goblet.obj", text: lathe::obj(&lathe::GOBLET) },
        Generated { path: "scenes/models/prism.obj", text: prism_obj() },
        Generated { path: "scenes/models/tumbler.obj", text: lathe::obj(&lathe::TUMBLER) },
        Generated { path: "scenes/models/vase.obj", text: lathe::obj(&lathe::VASE) },
    ]
}

/// A cone of 2·`sides` triangles as an OBJ file: 1 m wide and high, its base around the origin, its tip up.
///
/// The mantle is smooth. A cone has no normal at its tip, so each triangle has its own there, the one in its middle.
fn cone_obj(sides: u32) -> String {
    const RADIUS: f64 = 0.5;
    let angle = |i: f64| TAU * i / f64::from(sides);
    let on_circle = |radius: f64, y: f64, angle: f64| {
        format!("{} {} {}", number(radius * libm::cos(angle)), number(y), number(radius * libm::sin(angle)))
    };
    // The mantle falls 1 over a run of RADIUS: its normals rise RADIUS over a run of 1.
    let run = 1.0 / libm::sqrt(1.0 + RADIUS * RADIUS);
    let mut lines = vec![
        format!(
            "# A cone, 1 m wide and high: {sides} triangles of the mantle, {sides} of the base. Made by `cargo xtask models`."
        ),
        "v 0 1 0".to_owned(),
        "v 0 0 0".to_owned(),
    ];
    lines.extend((0..sides).map(|i| format!("v {}", on_circle(RADIUS, 0.0, angle(f64::from(i))))));
    for half in [0.0, 0.5] {
        lines.extend(
            (0..sides).map(|i| format!("vn {}", on_circle(run, RADIUS * run, angle(f64::from(i) + half)))),
        );
    }
    lines.push("vn 0 -1 0".to_owned());
    // OBJ counts from 1: the tip, the middle of the base, the rim; normals of the rim, of the tip, down.
    let (tip, middle, rim, down) = (1, 2, 3, 2 * sides + 1);
    lines.push("g mantle".to_owned());
    for i in 0..sides {
        let next = (i + 1) % sides;
        let tip_normal = sides + i + 1;
        lines.push(format!("f {tip}//{tip_normal} {}//{} {}//{}", rim + next, next + 1, rim + i, i + 1));
    }
    lines.push("g base".to_owned());
    for i in 0..sides {
        let next = (i + 1) % sides;
        lines.push(format!("f {middle}//{down} {}//{down} {}//{down}", rim + i, rim + next));
    }
    lines.join("\n") + "\n"
}

/// A prism as an OBJ file: each side 1 m, lying along Z for 1 m, its base on the ground around the origin.
fn prism_obj() -> String {
    let top = libm::sqrt(0.75);
    let mut lines =
        vec!["# A prism of equal sides, 1 m wide and long. Made by `cargo xtask models`.".to_owned()];
    for z in [0.5, -0.5] {
        for [x, y] in [[-0.5, 0.0], [0.5, 0.0], [0.0, top]] {
            lines.push(format!("v {} {} {}", number(x), number(y), number(z)));
        }
    }
    lines.extend(["f 1 2 3", "f 4 6 5", "f 1 4 5 2", "f 2 5 6 3", "f 3 6 4 1"].map(str::to_owned));
    lines.join("\n") + "\n"
}

/// A number with six places at the most.
pub fn number(v: f64) -> String {
    // Adding 0 turns −0 into 0.
    let text = format!("{:.6}", (v * 1e6).round() / 1e6 + 0.0);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checked_in_models_are_what_the_program_makes() {
        assert_eq!(crate::generated::check("models", &files()), Ok(()));
    }

    #[test]
    fn numbers_are_short() {
        let numbers = [0.0, -0.0, 1.0, -0.25, 1.0 / 3.0, -1e-9, 10.0].map(number);
        assert_eq!(numbers, ["0", "0", "1", "-0.25", "0.333333", "0", "10"]);
    }
}
