//! Renders that are stopped or killed, and go on.
#![cfg(unix)]

use crate::support::{Folder, contains};
use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use vitrine::math::hash;

/// A render that takes a few seconds on one thread.
fn arguments<'a>(renderer: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let all = ["render", "scene.vitrine.toml", "--size", "96x64", "--threads", "1", "--json"];
    [&all[..], &["--renderer", renderer], more].concat()
}

fn spawn(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = folder.command();
    command.args(arguments).stdout(Stdio::piped()).stderr(Stdio::null());
    command.spawn().expect("the program starts")
}

fn events(child: &mut Child) -> impl Iterator<Item = Value> + use<> {
    let lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    lines.map(|l| serde_json::from_str(&l.expect("it is text")).expect("it is JSON"))
}

/// Kills a render at random moments until 20 times it did not get to its end, then lets it. What comes out must be the same
/// bytes as without.
fn killed_20_times(renderer: &str) {
    let folder = Folder::with_scene();
    folder.run_well(&arguments(renderer, &["-o", "whole.png", "--samples", "2048"]));
    let flags = ["-o", "killed.png", "--samples", "2048", "--resume", "--state-every", "0.01"];
    let goes_on = arguments(renderer, &flags);
    let mut kills = 0;
    for trial in 0..20 {
        let mut child = spawn(&folder, &goes_on);
        let mut events = events(&mut child);
        // From the moment when it renders, at most so long as a few blocks of samples take.
        let _ = events.find(|e| e["event"] == "progress");
        std::thread::sleep(Duration::from_millis((hash::unit(hash::mix(trial)) * 150.0) as u64));
        child.kill().expect("it can be killed");
        let code = child.wait().expect("it ends").code();
        assert!(code.is_none() || code == Some(0), "killed or done: {code:?}");
        kills += u32::from(code.is_none());
    }
    assert!(kills >= 15, "it was over before it was killed: {kills}");
    let last = folder.run_well(&goes_on).events().pop().expect("there is an end");
    assert_eq!(last["complete"].as_bool(), Some(true));
    assert!(last["resumed_samples"].as_u64() > Some(0), "it went on: {last}");
    assert!(folder.read("killed.png") == folder.read("whole.png"), "other bytes");
    assert_eq!(folder.names(), ["killed.png", "scene.vitrine.toml", "whole.png"], "nothing is left");
}

#[test]
fn c15_killed_20_times_a_classic_render_comes_to_the_same_bytes() {
    killed_20_times("classic");
}

#[test]
fn c15_killed_20_times_a_photoreal_render_comes_to_the_same_bytes() {
    killed_20_times("photoreal");
}

fn interrupt(folder: &Folder, arguments: &[&str]) {
    let mut child = spawn(folder, arguments);
    let mut events = events(&mut child);
    assert!(events.any(|e| e["samples_done"].as_u64() > Some(96 * 64)), "it began");
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(sent.success());
    events.for_each(drop);
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
}

#[test]
fn an_interrupted_render_goes_on() {
    let folder = Folder::with_scene();
    let endless = ["--samples", "65536"];
    interrupt(&folder, &arguments("classic", &endless));
    assert_eq!(folder.names(), ["scene.png", "scene.vitrine-state", "scene.vitrine.toml"]);
    assert!(contains(&folder.read("scene.png"), "vitrine:complete"));
    let state = folder.read("scene.vitrine-state");

    let refused = |flags: &[&str], words: &[&str]| {
        folder.run(&[&arguments("classic", &["--resume"])[..], flags].concat()).fails(1, words);
        assert!(folder.read("scene.vitrine-state") == state, "it stays: {flags:?}");
    };
    refused(&["--samples", "65536", "--seed", "7"], &["its `seed` was 0 and now is 7", "--resume"]);
    refused(&["--set", "object.ball.radius=0.5"], &["have changed", "scene.vitrine-state"]);
    refused(&["--region", "0,0,9,9"], &["another part of the picture"]);
    refused(&["--samples", "1"], &["a picture of 1 cannot go", "begin anew"]);
    folder.write("bad.vitrine-state", &state[..state.len() / 2]);
    let bad = folder.run(&arguments("classic", &["--resume=bad.vitrine-state"]));
    bad.fails(1, &["damaged or cut off", "bad.vitrine-state"]);

    // A short render beside it leaves it alone.
    let short = folder.run_well(&["render", "scene.vitrine.toml", "-o", "scene.jpg"]);
    assert!(short.err.contains("A stopped render is kept here"), "{}", short.err);
    assert!(folder.read("scene.vitrine-state") == state);

    // From another place, with another display and other limits.
    folder.write("kept/moved.vitrine-state", &state);
    let flags =
        ["--samples", "65536", "--time", "0.01", "--exposure", "1", "--resume=kept/moved.vitrine-state"];
    let last = folder.run_well(&arguments("classic", &flags)).events().pop().expect("there is an end");
    assert_eq!((last["ended"].as_str(), last["complete"].as_bool()), (Some("time"), Some(true)));
    assert!(folder.path("kept/moved.vitrine-state").exists(), "a longer time can go on");
}

#[test]
fn where_nothing_was_kept_a_render_begins_anew_and_leaves_nothing() {
    let folder = Folder::with_scene();
    let outcome = folder.run_well(&["render", "scene.vitrine.toml", "--resume"]);
    assert!(outcome.err.contains("begins anew"), "{}", outcome.err);
    assert_eq!(folder.names(), ["scene.png", "scene.vitrine.toml"]);
}

#[test]
fn no_state_is_kept_where_none_is_wanted() {
    let folder = Folder::with_scene();
    interrupt(&folder, &arguments("classic", &["--samples", "65536", "--state-every", "0"]));
    assert_eq!(folder.names(), ["scene.png", "scene.vitrine.toml"]);
}
