//! A scene with everything that belongs to it: its file, its models and pictures, its warnings.

use crate::formats::{self, Finding, SceneFile, folder_of};
use crate::scene::{Assets, Scene, Settings};
use crate::{Error, RenderOptions, SceneHash, VERSION};
use std::path::{Path, PathBuf};

/// A scene that has been loaded and can be rendered.
#[derive(Debug)]
pub struct Project {
    /// The scene. Change it at will; after a change of files or of whole parts call [`Project::refresh`].
    pub scene: Scene,
    /// The models and pictures that it names.
    pub assets: Assets,
    file: SceneFile,
    path: PathBuf,
    asset_warnings: Vec<String>,
}

/// Loads a scene file with its models and pictures.
///
/// # Errors
/// When the file cannot be read, has errors, or names a model or picture that cannot be read.
pub fn load(path: impl AsRef<Path>) -> Result<Project, Error> {
    Project::new(SceneFile::read(path.as_ref())?, path.as_ref())
}

impl Project {
    fn new(file: SceneFile, path: &Path) -> Result<Self, Error> {
        let (assets, asset_warnings) = load_assets(file.scene(), folder_of(path))?;
        Ok(Self { scene: file.scene().clone(), assets, file, path: path.to_owned(), asset_warnings })
    }

    /// The scene file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The folder from which the scene names its models and pictures.
    #[must_use]
    pub fn folder(&self) -> &Path {
        folder_of(&self.path)
    }

    /// The scene's name: the file's, without `.vitrine.toml`.
    #[must_use]
    pub fn name(&self) -> String {
        let file = self.path.file_name().unwrap_or_default().to_string_lossy();
        let bare = file.strip_suffix(".vitrine.toml").or_else(|| file.strip_suffix(".toml"));
        bare.unwrap_or(&file).to_owned()
    }

    /// What may not be as it was meant, though a picture can be made.
    #[must_use]
    pub fn warnings(&self) -> &[Finding] {
        self.file.warnings()
    }

    /// The same of the models and pictures.
    #[must_use]
    pub fn asset_warnings(&self) -> &[String] {
        &self.asset_warnings
    }

    /// The text to which the places of [`Project::warnings`] refer.
    #[must_use]
    pub fn checked_text(&self) -> &str {
        self.file.text()
    }

    /// The scene as the text of a file, with the comments and the order that its file has.
    #[must_use]
    pub fn text(&self) -> String {
        self.file.print(&self.scene)
    }

    /// The mark of the scene as it is now.
    #[must_use]
    pub fn hash(&self) -> SceneHash {
        SceneHash::of(&self.text())
    }

    /// Changes values by assignments such as `object.ball.material.transparency=0.4`, with the same checks as in a file.
    ///
    /// # Errors
    /// The first assignment that does not fit, or what is wrong with the scene after all of them; then the scene is as
    /// it was.
    pub fn set<A: AsRef<str>>(&mut self, assignments: &[A]) -> Result<(), Error> {
        let mut changed = self.scene.clone();
        for assignment in assignments {
            let argument = assignment.as_ref();
            formats::scene_file::set(&mut changed, argument)
                .map_err(|error| Error::Set { argument: argument.to_owned(), error })?;
        }
        let before = std::mem::replace(&mut self.scene, changed);
        self.refresh().inspect_err(|_| self.scene = before)
    }

    /// Checks the changed scene as a whole and loads the files that it names now.
    ///
    /// # Errors
    /// As [`load`].
    pub fn refresh(&mut self) -> Result<(), Error> {
        let text = self.text();
        if text == self.file.text() {
            return Ok(());
        }
        let file = SceneFile::parse(&self.path, &text).map_err(Box::new)?;
        if files_of(file.scene()) != files_of(self.file.scene()) {
            (self.assets, self.asset_warnings) = load_assets(file.scene(), self.folder())?;
        }
        self.scene = file.scene().clone();
        self.file = file;
        Ok(())
    }

    /// What the scene itself says of rendering.
    #[must_use]
    pub fn options(&self) -> RenderOptions {
        RenderOptions { settings: self.scene.settings.clone(), region: None }
    }

    /// What a picture's file says of how it was made.
    #[must_use]
    pub fn metadata(&self, settings: &Settings) -> Vec<(String, String)> {
        metadata_of(&self.name(), &self.scene.about, self.hash(), settings)
    }
}

/// The same for a scene that is in no project: its name, its line of what it shows, its mark, and the settings with which
/// the picture was made.
#[must_use]
pub fn metadata_of(name: &str, about: &str, hash: SceneHash, settings: &Settings) -> Vec<(String, String)> {
    let pairs = [
        ("Software", format!("Vitrine {VERSION}")),
        ("Title", name.to_owned()),
        ("Description", about.to_owned()),
        ("vitrine:scene-hash", hash.to_string()),
        ("vitrine:renderer", settings.renderer.word().to_owned()),
        ("vitrine:samples", settings.samples.to_string()),
        ("vitrine:depth", settings.depth.to_string()),
        ("vitrine:seed", settings.seed.to_string()),
    ];
    pairs.into_iter().filter(|(_, v)| !v.is_empty()).map(|(k, v)| (k.to_owned(), v)).collect()
}

/// Everything that the scene names, and what may not be as it was meant, one sentence each.
fn load_assets(scene: &Scene, folder: &Path) -> Result<(Assets, Vec<String>), Error> {
    let (assets, mut warnings) = formats::load_assets(scene, folder)?;
    let open = scene.open_solids(&assets);
    warnings.extend(open.iter().map(|p| format!("{} ({})", p.cause, p.cause.help())));
    Ok((assets, warnings))
}

/// The models, pictures and panoramas that a scene names, in order.
fn files_of(scene: &Scene) -> Vec<&Path> {
    let models = scene.objects.iter().filter_map(|o| o.shape.as_kind().file());
    let pictures = scene.textures.iter().filter_map(|t| t.source.as_kind().file());
    let panoramas = scene.lights.iter().filter_map(|l| l.source.as_kind().file());
    models.chain(pictures).chain(panoramas).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use tempfile::TempDir;

    const SCENE: &str = "format = 1 # the only one\n\n[settings]\nsize = [8, 8]\n\n[[light]]\nname = \"lamp\"\nkind = \"point\"\n\n\
                         [[object]]\nname = \"ball\"\nshape = \"sphere\"\n";

    fn project(name: &str, text: &str) -> (TempDir, Project) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        (folder, load(path).unwrap())
    }

    #[test]
    fn names_have_no_endings() {
        for (file, name) in
            [("a.vitrine.toml", "a"), ("b.toml", "b"), ("c.d.vitrine.toml", "c.d"), ("e", "e")]
        {
            assert_eq!(project(file, SCENE).1.name(), name);
        }
    }

    #[test]
    fn the_hash_is_that_of_the_text_and_follows_the_changes() {
        let (_folder, mut project) = project("a.vitrine.toml", SCENE);
        let before = project.hash();
        assert_eq!(before, SceneHash::of(SCENE));
        project.set(&["object.ball.radius=2"]).unwrap();
        assert_ne!(project.hash(), before);
        assert!(project.text().contains("# the only one"), "remarks stay: {}", project.text());
    }

    #[test]
    fn a_refused_assignment_changes_nothing() {
        let (_folder, mut project) = project("a.vitrine.toml", SCENE);
        let before = project.scene.clone();
        let error = project.set(&["object.ball.radius=2", "object.ball.radius=-2"]).unwrap_err();
        assert!(
            matches!(&error, Error::Set { argument, .. } if argument == "object.ball.radius=-2"),
            "{error}"
        );
        assert_eq!(project.scene, before);
    }

    #[test]
    fn warnings_follow_the_changes() {
        let (_folder, mut project) = project("a.vitrine.toml", SCENE);
        assert!(project.warnings().is_empty(), "{:?}", project.warnings());
        project.set(&["light.lamp.visible=false"]).unwrap();
        assert_eq!(project.warnings().len(), 1);
        project.set(&["light.lamp.visible=true"]).unwrap();
        assert!(project.warnings().is_empty());
    }

    #[test]
    fn another_model_is_loaded_when_it_is_set() {
        let folder = tempfile::tempdir().unwrap();
        let triangles = |n: usize| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", "f 1 2 3\n".repeat(n));
        fs::write(folder.path().join("one.obj"), triangles(1)).unwrap();
        fs::write(folder.path().join("two.obj"), triangles(2)).unwrap();
        let path = folder.path().join("a.vitrine.toml");
        fs::write(
            &path,
            format!("{SCENE}\n[[object]]\nname = \"m\"\nshape = \"mesh\"\nfile = \"one.obj\"\n"),
        )
        .unwrap();
        let mut project = load(&path).unwrap();
        project.set(&["object.m.file=two.obj"]).unwrap();
        assert_eq!(project.assets.meshes[Path::new("two.obj")].triangles.len(), 2);
        let missing = project.set(&["object.m.file=three.obj"]).unwrap_err();
        assert!(missing.to_string().contains("three.obj"), "{missing}");
        assert_eq!(project.assets.meshes[Path::new("two.obj")].triangles.len(), 2, "as it was");
    }
}
