//! The layer check: which crate of the workspace may use which. ARCHITECTURE.md draws the same picture.
//!
//! Development and build dependencies count too: a test that needs two crates which do not know each other belongs to a
//! crate above both.

use serde_json::Value;

/// A crate of the workspace and the crates of the workspace that it may use.
struct Layer {
    name: &'static str,
    may_use: &'static [&'static str],
    rule: &'static str,
}

/// The allowed arrows, the ground first: a crate uses only crates that stand above it in this table.
const LAYERS: &[Layer] = &[
    Layer { name: "vitrine-math", may_use: &[], rule: "math knows nobody" },
    Layer {
        name: "vitrine-optics",
        may_use: &["vitrine-math"],
        rule: "optics is about directions and numbers at a surface: it uses math alone",
    },
    Layer {
        name: "vitrine-film",
        may_use: &["vitrine-math"],
        rule: "film only accumulates and displays: it never learns of the scene",
    },
    Layer {
        name: "vitrine-denoise",
        may_use: &["vitrine-math", "vitrine-film"],
        rule: "denoise turns a picture into a picture: no scene, no rendering, no picture files",
    },
    Layer {
        name: "vitrine-scene",
        may_use: &["vitrine-math", "vitrine-optics"],
        rule: "scene is plain data: no files, no rendering, no picture",
    },
    Layer {
        name: "vitrine-formats",
        may_use: &["vitrine-math", "vitrine-scene", "vitrine-film"],
        rule: "formats reads scenes and writes pictures: it never renders",
    },
    Layer {
        name: "vitrine-render",
        may_use: &["vitrine-math", "vitrine-optics", "vitrine-scene", "vitrine-film"],
        rule: "render turns a scene into a picture: it never touches the disc",
    },
    Layer {
        name: "vitrine-measure",
        may_use: &["vitrine-math", "vitrine-render"],
        rule: "measure shoots rays at the kernel: it knows no scene files and prints nothing",
    },
    Layer {
        name: "vitrine",
        may_use: &[
            "vitrine-math",
            "vitrine-scene",
            "vitrine-formats",
            "vitrine-film",
            "vitrine-denoise",
            "vitrine-render",
            "vitrine-measure",
        ],
        rule: "the facade stands on the libraries, below everything that people start",
    },
    Layer { name: "vitrine-editor", may_use: &["vitrine"], rule: TOP_RULE },
    Layer {
        name: "vitrine-cli",
        may_use: &["vitrine", "vitrine-editor"],
        rule: "the program opens the window and uses the facade, nothing below it",
    },
    Layer { name: "vitrine-py", may_use: &["vitrine"], rule: TOP_RULE },
    Layer {
        name: "xtask",
        may_use: &["vitrine"],
        rule: "the chores see the project as its users do, through the facade",
    },
    Layer {
        name: "vitrine-benches",
        may_use: &[
            "vitrine",
            "vitrine-math",
            "vitrine-optics",
            "vitrine-scene",
            "vitrine-formats",
            "vitrine-film",
            "vitrine-denoise",
            "vitrine-render",
            "vitrine-measure",
            "vitrine-editor",
        ],
        rule: "benches may measure any library and the window, never the program",
    },
];

const TOP_RULE: &str = "what people start uses the facade alone";

/// The row of crates that people meet, and the outside libraries that belong to it alone.
const TOP_ROW: &[&str] = &["vitrine-cli", "vitrine-editor", "vitrine-py"];
const TOP_ROW_LIBRARIES: &[&str] = &["clap", "egui", "eframe", "pyo3"];

/// Every arrow in the output of `cargo metadata --no-deps` that the picture does not allow, each as a line that names the
/// arrow and the rule.
///
/// # Errors
/// When the metadata is not what cargo writes.
pub fn violations(metadata: &Value) -> Result<Vec<String>, String> {
    let packages = list(metadata, "packages")?;
    let names = packages.iter().map(|p| text(p, "name")).collect::<Result<Vec<_>, _>>()?;
    let mut found = Vec::new();
    for (package, name) in packages.iter().zip(&names) {
        let Some(layer) = LAYERS.iter().find(|l| l.name == *name) else {
            found.push(format!(
                "{name}: a crate without a layer; give it one in xtask/src/layers.rs and ARCHITECTURE.md"
            ));
            continue;
        };
        for dependency in list(package, "dependencies")? {
            let to = text(dependency, "name")?;
            if let Some(rule) = broken_rule(layer, to, names.contains(&to)) {
                found.push(format!("{name} → {to}: {rule}"));
            }
        }
    }
    Ok(found)
}

/// The rule that an arrow breaks, or None when it is allowed.
fn broken_rule(from: &Layer, to: &str, is_ours: bool) -> Option<String> {
    if is_ours {
        return (!from.may_use.contains(&to)).then(|| from.rule.to_owned());
    }
    // "clap_complete" and "egui-notify" belong to their families.
    let family = to.split(['_', '-']).next().unwrap_or(to);
    (TOP_ROW_LIBRARIES.contains(&family) && !TOP_ROW.contains(&from.name))
        .then(|| format!("{} belong to the top row ({})", TOP_ROW_LIBRARIES.join(", "), TOP_ROW.join(", ")))
}

fn list<'a>(value: &'a Value, key: &str) -> Result<&'a Vec<Value>, String> {
    value[key].as_array().ok_or_else(|| format!("cargo metadata has no list `{key}`"))
}

fn text<'a>(value: &'a Value, key: &str) -> Result<&'a str, String> {
    value[key].as_str().ok_or_else(|| format!("cargo metadata has no text `{key}`"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn workspace(crates: &[(&str, &[&str])]) -> Value {
        let package = |(name, uses): &(&str, &[&str])| {
            let dependencies: Vec<_> = uses.iter().map(|to| json!({ "name": to, "kind": null })).collect();
            json!({ "name": name, "dependencies": dependencies })
        };
        json!({ "packages": crates.iter().map(package).collect::<Vec<_>>() })
    }

    #[test]
    fn this_workspace_keeps_to_the_picture() {
        let metadata = crate::cargo_metadata().unwrap();
        assert_eq!(violations(&metadata).unwrap(), Vec::<String>::new());
    }

    #[test]
    fn an_arrow_up_or_sideways_is_named_with_its_rule() {
        let bad = workspace(&[
            ("vitrine-math", &["glam"]),
            ("vitrine-scene", &["vitrine-math"]),
            ("vitrine-film", &["vitrine-math", "vitrine-scene"]),
            ("vitrine-formats", &["vitrine-scene", "vitrine-render"]),
            ("vitrine-render", &["vitrine-scene", "vitrine-film"]),
        ]);
        let found = violations(&bad).unwrap();
        assert_eq!(
            found,
            [
                "vitrine-film → vitrine-scene: film only accumulates and displays: it never learns of the scene",
                "vitrine-formats → vitrine-render: formats reads scenes and writes pictures: it never renders",
            ]
        );
    }

    #[test]
    fn a_dependency_for_tests_alone_counts_too() {
        let mut bad = workspace(&[("vitrine-render", &["vitrine-formats"]), ("vitrine-formats", &[])]);
        bad["packages"][0]["dependencies"][0]["kind"] = json!("dev");
        assert_eq!(violations(&bad).unwrap().len(), 1);
    }

    #[test]
    fn what_makes_windows_and_command_lines_stays_in_the_top_row() {
        let found = violations(&workspace(&[
            ("vitrine-cli", &["clap", "clap_complete"]),
            ("vitrine-render", &["clap_complete"]),
            ("vitrine", &["egui-notify"]),
            ("vitrine-scene", &["pyo3"]),
            ("vitrine-formats", &["clapper"]),
        ]))
        .unwrap();
        let arrows: Vec<_> = found.iter().filter_map(|f| f.split(':').next()).collect();
        assert_eq!(
            arrows,
            ["vitrine-render → clap_complete", "vitrine → egui-notify", "vitrine-scene → pyo3"]
        );
    }

    #[test]
    fn a_new_crate_must_be_given_a_layer() {
        let found = violations(&workspace(&[("vitrine-sound", &[])])).unwrap();
        assert!(found[0].starts_with("vitrine-sound: a crate without a layer"), "{found:?}");
    }

    #[test]
    fn the_table_itself_points_down_only() {
        for (i, layer) in LAYERS.iter().enumerate() {
            for to in layer.may_use {
                assert!(LAYERS[..i].iter().any(|l| l.name == *to), "{} → {to}", layer.name);
            }
        }
    }

    #[test]
    fn metadata_of_another_form_is_an_error() {
        assert!(violations(&json!({ "packages": [{ "name": "vitrine" }] })).is_err());
        assert!(violations(&json!([])).is_err());
    }
}
