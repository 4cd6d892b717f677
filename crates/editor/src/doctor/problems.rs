//! The list of problems: whatever may not be as it was meant, with the things concerned and a mend where there is one.

use super::closed::is_closed;
use super::{Diagnosis, diagnose};
use crate::document::{Document, EditCommand, Message, Thing, missing, problem};
use vitrine::scene::{Assets, Cause, Geometry, Material, Object, Scene, Severity};

/// One line of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct ProblemLine {
    /// How bad.
    pub severity: Severity,
    /// What is the matter.
    pub message: Message,
    /// The things concerned, to select them.
    pub things: Vec<Thing>,
    /// The words on the button that mends it, and what mends it.
    pub mend: Option<(Message, EditCommand)>,
}

impl ProblemLine {
    fn warning(message: Message, things: Vec<Thing>) -> Self {
        Self { severity: Severity::Warning, message, things, mend: None }
    }
}

impl From<Diagnosis> for ProblemLine {
    fn from(diagnosis: Diagnosis) -> Self {
        let Diagnosis { message, things, mend_label, mend } = diagnosis;
        Self { mend: Some((mend_label, mend)), ..Self::warning(message, things) }
    }
}

/// Everything that may not be as it was meant, the gravest first.
#[must_use]
pub fn problems(document: &Document) -> Vec<ProblemLine> {
    let (scene, assets) = (document.scene(), document.assets());
    let mut lines: Vec<ProblemLine> = diagnose(document, None).into_iter().map(Into::into).collect();
    lines.extend(of_scene(scene, &lines));
    lines.extend(missing_files(scene, assets));
    lines.extend(scene.objects.iter().filter(|o| is_open_glass(o, scene, assets)).map(|object| {
        let message = Message::new("problem-open-model").with("name", &object.name);
        ProblemLine::warning(message, vec![Thing::object(&object.name)])
    }));
    let notes = document.asset_warnings().iter();
    lines.extend(
        notes.map(|note| ProblemLine::warning(Message::new("problem-asset").with("text", note), Vec::new())),
    );
    lines.sort_by_key(|line| std::cmp::Reverse(line.severity));
    lines
}

/// What the scene says of itself and the diagnosis does not.
fn of_scene(scene: &Scene, lines: &[ProblemLine]) -> Vec<ProblemLine> {
    let problems = scene.problems().into_iter().filter(|p| match &p.cause {
        Cause::NoLight | Cause::NoObject => false,
        Cause::CameraInside { name } => {
            let thing = Thing::object(name);
            !lines.iter().any(|line| line.things.contains(&thing))
        }
        _ => true,
    });
    let line = |p: vitrine::scene::Problem| ProblemLine {
        severity: p.severity,
        message: problem(&p.cause),
        things: p.place.owner.and_then(|owner| Thing::at(scene, owner)).into_iter().collect(),
        mend: None,
    };
    problems.map(line).collect()
}

fn missing_files(scene: &Scene, assets: &Assets) -> Vec<ProblemLine> {
    let missing = missing(scene, assets);
    let line = |key, file: Option<&std::path::Path>, thing| {
        let path = file.map(|f| f.display().to_string()).unwrap_or_default();
        ProblemLine::warning(Message::new(key).with("path", &path), vec![thing])
    };
    let pictures = missing
        .textures
        .iter()
        .map(|t| line("problem-missing-picture", t.source.as_kind().file(), Thing::texture(&t.name)));
    let models = missing
        .objects
        .iter()
        .map(|o| line("problem-missing-model", o.shape.as_kind().file(), Thing::object(&o.name)));
    let panoramas = missing
        .lights
        .iter()
        .map(|l| line("problem-missing-picture", l.source.as_kind().file(), Thing::light(&l.name)));
    pictures.chain(models).chain(panoramas).collect()
}

/// Whether an object is a model with holes, of a material that lets light through.
fn is_open_glass(object: &Object, scene: &Scene, assets: &Assets) -> bool {
    let mesh = match object.shape.as_kind().geometry(assets) {
        Some(Geometry::Mesh(mesh) | Geometry::Facets(mesh)) => mesh,
        _ => return false,
    };
    let passes = match object.material.as_deref() {
        Some(name) => scene.material(name).is_some_and(Material::is_solid_glass),
        None => mesh.materials.iter().any(|m| m.material.is_solid_glass()),
    };
    passes && !is_closed(&mesh)
}
