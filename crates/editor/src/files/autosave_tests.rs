//! Windows that end well and windows that do not.

use super::*;
use crate::files::{read_template, recoverable};

const NOW: Duration = Duration::ZERO;

fn snapshot(revision: u64, about: &str) -> Snapshot {
    let opened = read_template("textured-sphere").unwrap();
    let mut scene = opened.file.scene().clone();
    scene.about = about.into();
    Snapshot {
        revision,
        title: "globe".into(),
        scene: Arc::new(scene),
        base: Some(opened.file),
        path: None,
        folder: None,
        seen: None,
        thumbnail: Some(ThumbnailImage { size: [2, 1], rgba: vec![255, 0, 0, 255, 0, 0, 255, 255] }),
    }
}

fn wait_for(autosave: &Autosave, revision: u64) {
    let start = Instant::now();
    while autosave.revision() != Some(revision) {
        assert!(start.elapsed() < Duration::from_secs(60), "{:?}", autosave.take_error());
        thread::sleep(Duration::from_millis(2));
    }
}

fn home() -> (tempfile::TempDir, Places) {
    let home = tempfile::tempdir().unwrap();
    let places = Places::inside(home.path());
    (home, places)
}

fn names(places: &Places) -> Vec<String> {
    let entries = fs::read_dir(places.autosave_folder()).unwrap();
    entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn what_a_window_leaves_behind_is_offered_and_opens_as_it_was() {
    let (_home, places) = home();
    let mut autosave = Autosave::start(&places, NOW).unwrap();
    autosave.offer(snapshot(1, "first"));
    autosave.offer(snapshot(2, "second"));
    wait_for(&autosave, 2);
    assert!(recoverable(&places).is_empty(), "the window lives");
    drop(autosave);

    let mut found = recoverable(&places);
    assert!(recoverable(&places).is_empty(), "it is offered to one window at a time");
    let recovery = found.pop().unwrap();
    assert_eq!((recovery.title.as_str(), &recovery.path), ("globe", &None));
    assert!(recovery.when.elapsed().unwrap() < Duration::from_secs(600));
    assert_eq!(recovery.thumbnail, snapshot(0, "").thumbnail);
    let opened = recovery.open().unwrap();
    assert_eq!(opened.file.scene().about, "second");
    assert_eq!(opened.assets.pictures.len(), 1);
    drop(recovery);
    recoverable(&places).pop().unwrap().discard();
    assert_eq!(names(&places), [""; 0]);
}

#[test]
fn a_window_that_ends_well_leaves_nothing() {
    let (_home, places) = home();
    let mut autosave = Autosave::start(&places, NOW).unwrap();
    autosave.offer(snapshot(1, "first"));
    wait_for(&autosave, 1);
    autosave.finish();
    assert_eq!(names(&places), [""; 0]);
}

#[test]
fn what_has_been_saved_is_forgotten_and_later_edits_are_kept() {
    let (_home, places) = home();
    let mut autosave = Autosave::start(&places, NOW).unwrap();
    autosave.offer(snapshot(1, "first"));
    wait_for(&autosave, 1);
    autosave.forget();
    autosave.offer(snapshot(2, "second"));
    wait_for(&autosave, 2);
    drop(autosave);
    assert_eq!(recoverable(&places)[0].open().unwrap().file.scene().about, "second");
}

#[test]
fn the_newest_is_written_once_the_time_has_come_and_at_the_end() {
    let (_home, places) = home();
    let mut autosave = Autosave::start(&places, Duration::from_secs(3600)).unwrap();
    autosave.offer(snapshot(1, "first"));
    wait_for(&autosave, 1);
    autosave.offer(snapshot(2, "second"));
    assert!(!autosave.wants(2) && autosave.wants(3));
    thread::sleep(Duration::from_millis(50));
    assert_eq!(autosave.revision(), Some(1), "not so soon");
    drop(autosave);
    assert_eq!(recoverable(&places)[0].open().unwrap().file.scene().about, "second");
}

#[test]
fn a_recovered_scene_is_kept_until_the_new_window_has_written_it() {
    let (_home, places) = home();
    let mut crashed = Autosave::start(&places, NOW).unwrap();
    crashed.offer(snapshot(1, "first"));
    drop(crashed);
    let mut autosave = Autosave::start(&places, NOW).unwrap();
    autosave.replace(recoverable(&places).pop().unwrap());
    assert_eq!(names(&places).iter().filter(|n| n.ends_with("toml")).count(), 1);
    autosave.offer(snapshot(7, "recovered"));
    wait_for(&autosave, 7);
    drop(autosave);
    let found = recoverable(&places);
    assert_eq!(found.len(), 1, "the old one is gone");
    assert_eq!(found[0].open().unwrap().file.scene().about, "recovered");
}

#[test]
fn broken_files_are_set_aside_and_stray_locks_removed() {
    let (_home, places) = home();
    let folder = places.autosave_folder();
    fs::create_dir_all(&folder).unwrap();
    for (name, bytes) in [("1-1.toml", &b"\x00\xff"[..]), ("2-2.toml", b"text = 5"), ("3-3.toml", b"")] {
        fs::write(folder.join(name), bytes).unwrap();
    }
    fs::write(folder.join("4-4.lock"), "").unwrap();
    assert!(recoverable(&places).is_empty());
    assert!(folder.join("1-1.toml.broken").exists() && folder.join("2-2.toml.broken").exists());
    assert!(!folder.join("4-4.lock").exists());
}

#[test]
fn a_recovered_scene_whose_picture_is_gone_is_an_error_and_not_lost() {
    let (_home, places) = home();
    let mut autosave = Autosave::start(&places, NOW).unwrap();
    let mut with_own_picture = snapshot(1, "own");
    let scene = Arc::make_mut(&mut with_own_picture.scene);
    let texture = vitrine::scene::Owner::Item(vitrine::scene::ListName::Texture, 0);
    scene.set(texture, "file", vitrine::scene::Value::Text("own.png".into())).unwrap();
    autosave.offer(with_own_picture);
    drop(autosave);
    let recovery = recoverable(&places).pop().unwrap();
    assert!(recovery.open().unwrap_err().problems()[0].message.contains("own.png"));
    drop(recovery);
    assert_eq!(recoverable(&places).len(), 1);
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("file");
    fs::write(&file, "").unwrap();
    assert!(Autosave::start(&Places::inside(&file), NOW).is_err());
}

#[test]
fn a_failure_to_write_is_told_once() {
    let (_home, places) = home();
    let mut autosave = Autosave::start(&places, NOW).unwrap();
    // The folder would be made anew, but not where a file is.
    fs::remove_dir_all(places.autosave_folder()).unwrap();
    fs::write(places.autosave_folder(), "").unwrap();
    autosave.offer(snapshot(1, "lost"));
    let start = Instant::now();
    let error = loop {
        if let Some(error) = autosave.take_error() {
            break error;
        }
        assert!(start.elapsed() < Duration::from_secs(60));
        thread::sleep(Duration::from_millis(2));
    };
    assert!(!error.is_empty());
    assert_eq!(autosave.take_error(), None);
}
