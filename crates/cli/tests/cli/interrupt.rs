//! Ctrl-C.
#![cfg(unix)]

use crate::support::Folder;
use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

/// Starts a render that would take hours and waits until a part of it is done.
fn start_long_render(folder: &Folder) -> (Child, impl Iterator<Item = Value>) {
    let mut child = folder
        .command()
        .args(["render", "scene.vitrine.toml", "--size", "300x200", "--samples", "65536", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    let mut events =
        lines.map(|l| serde_json::from_str::<Value>(&l.expect("it is text")).expect("it is JSON"));
    let first_round = 300 * 200;
    let begun = |event: &Value| event["samples_done"].as_u64().is_some_and(|n| n >= first_round);
    assert!(events.by_ref().any(|event| begun(&event)), "it began");
    (child, events)
}

fn interrupt(child: &Child) {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(sent.success());
}

/// C15.
#[test]
fn c15_the_picture_so_far_is_kept() {
    let folder = Folder::with_scene();
    let (mut child, events) = start_long_render(&folder);
    interrupt(&child);
    let last = events.last().expect("there is an end");
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert_eq!((last["event"].as_str(), last["complete"].as_bool()), (Some("done"), Some(false)));
    let picture = folder.picture("scene.png");
    assert_eq!(picture.size, [300, 200]);
    assert!(picture.texels.iter().all(|t| *t != [0, 0, 0]), "the first round had reached every pixel");
    assert!(crate::support::contains(&folder.read("scene.png"), "vitrine:complete"));
}

#[test]
fn a_sweep_keeps_what_it_has() {
    let folder = Folder::with_scene();
    let mut child = folder
        .command()
        .args(["sweep", "scene.vitrine.toml", "--set", "settings.samples=1,65536,2", "--size", "300x200"])
        .args(["--each", "each"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    while !folder.path("each/scene-1-samples-1.png").exists() {
        assert!(child.try_wait().expect("it runs").is_none(), "it runs until it is stopped");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    interrupt(&child);
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert!(folder.picture("scene-sweep.png").size[0] > 300);
    assert!(!folder.path("each/scene-3-samples-2.png").exists());
}
