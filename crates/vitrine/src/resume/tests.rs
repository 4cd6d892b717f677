use super::*;
use crate::{Cancel, RenderJob, load};
use std::fs;

const SCENE: &str = "format = 1\n[settings]\nsize = [70, 50]\nsamples = 64\n[[light]]\nname = \"lamp\"\nkind = \"disc\"\n\
                     position = [1.0, 4.0, 2.0]\n[[object]]\nname = \"ball\"\nshape = \"sphere\"\n[[object]]\n\
                     name = \"model\"\nshape = \"mesh\"\nfile = \"m.obj\"\n";
const MODEL: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

struct Desk {
    folder: tempfile::TempDir,
}

impl Desk {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("m.obj"), MODEL).unwrap();
        fs::write(folder.path().join("a.vitrine.toml"), SCENE).unwrap();
        Self { folder }
    }

    fn project(&self, set: &[&str]) -> Project {
        let mut project = load(self.folder.path().join("a.vitrine.toml")).unwrap();
        project.set(set).unwrap();
        project
    }

    fn file(&self, project: &Project) -> StateFile {
        StateFile::new(self.folder.path().join("a.vitrine-state"), project, None)
    }

    /// Stops a render after its first block and keeps it.
    fn stopped(&self, set: &[&str]) -> Rendered {
        let project = self.project(&[&["settings.samples=1"], set].concat());
        let rendered = crate::render(&project, 2).unwrap();
        self.file(&project).save(rendered.clone()).unwrap();
        rendered
    }

    #[track_caller]
    fn refuses(&self, set: &[&str], words: &str) {
        let project = self.project(set);
        let error = self.file(&project).load().unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn what_was_kept_goes_on_to_the_same_picture() {
    for renderer in ["classic", "photoreal"] {
        let desk = Desk::new();
        let set = [&*format!("settings.renderer={renderer}"), "settings.noise=0.001"];
        let stopped = desk.stopped(&set);
        let project = desk.project(&set);
        let kept = desk.file(&project).load().unwrap().expect("it was kept");
        assert!(kept.film == stopped.film);
        assert_eq!((kept.rays, kept.bad_samples), (stopped.rays, stopped.bad_samples));
        let compiled = crate::render::compile(&project.scene, &project.assets).unwrap();
        let job = RenderJob::new(&compiled, project.options()).unwrap();
        let ended = job.resume(kept, 2, &Cancel::default(), &mut |_| {}).unwrap();
        let whole = crate::render(&project, 1).unwrap();
        assert!(ended.film == whole.film && ended.rays == whole.rays, "{renderer}");
    }
}

#[test]
fn other_scenes_and_settings_are_refused_by_name() {
    let desk = Desk::new();
    desk.stopped(&[]);
    desk.refuses(&["object.ball.radius=2"], "the scene, its models or its pictures have changed");
    desk.refuses(&["settings.depth=5"], "its `depth` was 3 and now is 5");
    desk.refuses(&["settings.seed=1"], "its `seed` was 0 and now is 1");
    desk.refuses(&["settings.size=[70, 51]"], "another part of the picture");
    fs::write(desk.folder.path().join("m.obj"), MODEL.replace("v 1 0 0", "v 1 0 0.5")).unwrap();
    desk.refuses(&[], "have changed");
}

#[test]
fn how_long_and_how_shown_may_differ_and_remarks_do_not_count() {
    let desk = Desk::new();
    desk.stopped(&[]);
    let path = desk.folder.path().join("a.vitrine.toml");
    fs::write(&path, format!("# a remark\n{SCENE}")).unwrap();
    let project = desk.project(&["settings.exposure=1", "settings.view=agx", "settings.time_limit=5"]);
    assert!(desk.file(&project).load().unwrap().is_some());
}

#[test]
fn where_there_is_no_file_there_is_nothing_to_go_on_with() {
    let desk = Desk::new();
    let project = desk.project(&[]);
    let file = desk.file(&project);
    assert!(file.load().unwrap().is_none());
    desk.stopped(&[]);
    file.remove();
    assert!(file.load().unwrap().is_none());
    file.remove();
}

#[test]
fn a_keeper_keeps_what_a_job_has() {
    let desk = Desk::new();
    let project = desk.project(&["settings.samples=2000", "settings.shadow_points=1"]);
    let compiled = crate::render::compile(&project.scene, &project.assets).unwrap();
    let job = RenderJob::new(&compiled, project.options()).unwrap();
    let file = desk.file(&project);
    let mut keeper = StateKeeper::new(file.clone(), Duration::ZERO);
    let whole =
        job.resume(job.nothing_yet(), 2, &Cancel::default(), &mut |glance| keeper.look(glance)).unwrap();
    assert!(keeper.finish().unwrap());
    let kept = file.load().unwrap().expect("at least the last look is kept");
    assert!(kept.film.samples() > 0);
    let again = job.resume(kept, 2, &Cancel::default(), &mut |_| {}).unwrap();
    assert!(again.film == whole.film && again.rays == whole.rays);
}
