//! "First picture in 60 seconds": a small card beside the real controls, which goes on once the person has really done
//! what it says. Panels mark their controls with [`mark`]; the steps are data.

use crate::document::Document;
use crate::text::tr;
use eframe::egui::{Context, Id, Rect};
use vitrine::scene::{Object, Scene, Shape};

/// What the tour knows of the world.
#[derive(Clone, Copy, Debug)]
pub struct TourFacts<'a> {
    /// What is being edited.
    pub document: &'a Document,
    /// Whether the final render is running or has run since the tour began.
    pub is_rendered: bool,
    /// Whether a picture has been saved since the tour began.
    pub is_saved: bool,
}

/// One step.
#[derive(Clone, Copy)]
pub struct Step {
    /// Its word: its title has the key `tour-<word>`, what to do the attribute `text`.
    pub word: &'static str,
    /// The control beside which the card stands.
    pub anchor: &'static str,
    /// Whether it is done, told from the scene when the step began and the world now.
    is_done: fn(&Scene, &TourFacts<'_>) -> bool,
}

/// The steps, in order.
pub const STEPS: [Step; 5] = [
    Step { word: "add", anchor: "add-sphere", is_done: |before, now| balls(scene(now)) > balls(before) },
    Step {
        word: "paint",
        anchor: "materials",
        is_done: |_, now| scene(now).objects.iter().any(is_red_glass(now)),
    },
    Step { word: "move", anchor: "picture", is_done: has_moved },
    Step { word: "render", anchor: "start-render", is_done: |_, now| now.is_rendered },
    Step { word: "save", anchor: "save-picture", is_done: |_, now| now.is_saved },
];

/// Where a person is in the tour.
#[derive(Clone, Debug)]
pub struct Tour {
    step: usize,
    /// The scene when the step began.
    before: Scene,
}

impl Tour {
    /// At the first step.
    #[must_use]
    pub fn begin(document: &Document) -> Self {
        Self { step: 0, before: Scene::clone(document.scene()) }
    }

    /// The step to do; None when all are done.
    #[must_use]
    pub fn step(&self) -> Option<&'static Step> {
        STEPS.get(self.step)
    }

    /// The number of the step, from 1.
    #[must_use]
    pub const fn number(&self) -> usize {
        self.step + 1
    }

    /// Goes on if the step has been done.
    pub fn look(&mut self, facts: &TourFacts<'_>) {
        if self.step().is_some_and(|step| (step.is_done)(&self.before, facts)) {
            self.skip(facts.document);
        }
    }

    /// Goes on to the next step.
    pub fn skip(&mut self, document: &Document) {
        self.step = (self.step + 1).min(STEPS.len());
        self.before = Scene::clone(document.scene());
    }

    /// The title of the card and what it says.
    #[must_use]
    pub fn texts(&self) -> [String; 2] {
        let word = self.step().map_or("done", |s| s.word);
        [tr!(&format!("tour-{word}")), tr!(&format!("tour-{word}.text"))]
    }
}

/// Tells the tour where a control is. Names: "add-sphere", "materials", "picture", "start-render", "save-picture".
pub fn mark(ctx: &Context, name: &str, rect: Rect) {
    ctx.data_mut(|data| data.insert_temp(anchor_id(name), rect));
}

/// Where a control is; None when nobody has marked it.
#[must_use]
pub fn anchor(ctx: &Context, name: &str) -> Option<Rect> {
    ctx.data(|data| data.get_temp(anchor_id(name)))
}

fn anchor_id(name: &str) -> Id {
    Id::new("tour anchor").with(name)
}

fn scene<'a>(now: &TourFacts<'a>) -> &'a Scene {
    now.document.scene()
}

fn is_ball(object: &Object) -> bool {
    matches!(object.shape, Shape::Sphere(_))
}

fn balls(scene: &Scene) -> usize {
    scene.objects.iter().filter(|o| is_ball(o)).count()
}

/// Whether an object is a ball that lets light through and is more red than anything else.
fn is_red_glass(now: &TourFacts<'_>) -> impl Fn(&Object) -> bool {
    let scene = scene(now);
    move |object| {
        let material = object.material.as_deref().and_then(|m| scene.material(m));
        let classic = material.map(vitrine::scene::Material::classic);
        is_ball(object)
            && classic.is_some_and(|m| m.transparency > 0.2 && m.color.r > m.color.g.max(m.color.b) * 1.2)
    }
}

fn has_moved(before: &Scene, now: &TourFacts<'_>) -> bool {
    let mut objects = scene(now).objects.iter().filter(|o| is_ball(o));
    objects.any(|o| before.object(&o.name).is_some_and(|b| b.position != o.position))
}
