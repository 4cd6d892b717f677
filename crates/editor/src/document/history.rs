//! What has been done, step by step: each step keeps only the entries that it changed, so hundreds of steps in a scene of
//! thousands of objects take little memory, and undoing needs no code of its own for any command.

use super::Selection;
use vitrine::scene::{Camera, Group, Light, Material, Object, Scene, Settings, Texture};

/// A part of a list that was replaced.
#[derive(Clone, Debug, PartialEq)]
struct Splice<T> {
    start: usize,
    before: Vec<T>,
    after: Vec<T>,
}

impl<T: Clone + PartialEq> Splice<T> {
    /// What lies between the common beginning and the common end of two states of a list; None when they are the same.
    fn between(before: &[T], after: &[T]) -> Option<Self> {
        let start = before.iter().zip(after).take_while(|(a, b)| a == b).count();
        let (before, after) = (&before[start..], &after[start..]);
        let end = before.iter().rev().zip(after.iter().rev()).take_while(|(a, b)| a == b).count();
        let (before, after) = (&before[..before.len() - end], &after[..after.len() - end]);
        let is_change = !(before.is_empty() && after.is_empty());
        is_change.then(|| Self { start, before: before.to_vec(), after: after.to_vec() })
    }

    fn undo(&self, list: &mut Vec<T>) {
        list.splice(self.start..self.start + self.after.len(), self.before.iter().cloned());
    }

    fn redo(&self, list: &mut Vec<T>) {
        list.splice(self.start..self.start + self.before.len(), self.after.iter().cloned());
    }
}

/// The difference between two states of a scene.
#[derive(Clone, Debug, PartialEq)]
struct Patch {
    about: Option<[String; 2]>,
    settings: Option<Box<[Settings; 2]>>,
    camera: Option<Box<[Camera; 2]>>,
    lights: Option<Splice<Light>>,
    textures: Option<Splice<Texture>>,
    materials: Option<Splice<Material>>,
    groups: Option<Splice<Group>>,
    objects: Option<Splice<Object>>,
}

impl Patch {
    fn between(before: &Scene, after: &Scene) -> Self {
        fn pair<T: Clone + PartialEq>(before: &T, after: &T) -> Option<[T; 2]> {
            (before != after).then(|| [before.clone(), after.clone()])
        }
        Self {
            about: pair(&before.about, &after.about),
            settings: pair(&before.settings, &after.settings).map(Box::new),
            camera: pair(&before.camera, &after.camera).map(Box::new),
            lights: Splice::between(&before.lights, &after.lights),
            textures: Splice::between(&before.textures, &after.textures),
            materials: Splice::between(&before.materials, &after.materials),
            groups: Splice::between(&before.groups, &after.groups),
            objects: Splice::between(&before.objects, &after.objects),
        }
    }

    fn undo(&self, scene: &mut Scene) {
        fn first<T: Clone>(pair: Option<&[T; 2]>, to: &mut T) {
            if let Some([before, _]) = pair {
                *to = before.clone();
            }
        }
        first(self.about.as_ref(), &mut scene.about);
        first(self.settings.as_deref(), &mut scene.settings);
        first(self.camera.as_deref(), &mut scene.camera);
        self.lights.iter().for_each(|s| s.undo(&mut scene.lights));
        self.textures.iter().for_each(|s| s.undo(&mut scene.textures));
        self.materials.iter().for_each(|s| s.undo(&mut scene.materials));
        self.groups.iter().for_each(|s| s.undo(&mut scene.groups));
        self.objects.iter().for_each(|s| s.undo(&mut scene.objects));
    }

    fn redo(&self, scene: &mut Scene) {
        fn second<T: Clone>(pair: Option<&[T; 2]>, to: &mut T) {
            if let Some([_, after]) = pair {
                *to = after.clone();
            }
        }
        second(self.about.as_ref(), &mut scene.about);
        second(self.settings.as_deref(), &mut scene.settings);
        second(self.camera.as_deref(), &mut scene.camera);
        self.lights.iter().for_each(|s| s.redo(&mut scene.lights));
        self.textures.iter().for_each(|s| s.redo(&mut scene.textures));
        self.materials.iter().for_each(|s| s.redo(&mut scene.materials));
        self.groups.iter().for_each(|s| s.redo(&mut scene.groups));
        self.objects.iter().for_each(|s| s.redo(&mut scene.objects));
    }
}

/// A gesture that goes on: all that is done during one drag, or while one field is being typed in, is one step.
pub type Gesture = u64;

/// One step.
#[derive(Clone, Debug)]
struct Step {
    patch: Patch,
    /// What was selected before and after.
    selection: [Selection; 2],
    gesture: Option<Gesture>,
    /// Tells this state of the scene from all others.
    state: u64,
}

/// The steps that can be undone and redone.
#[derive(Debug, Default)]
pub struct History {
    steps: Vec<Step>,
    /// How many of the steps are done.
    done: usize,
    /// The state before the first step that is kept.
    first_state: u64,
    last_state: u64,
}

impl History {
    /// The most steps that are kept.
    pub const MOST: usize = 1000;

    /// Notes a step from one state of the scene to another. What was undone before is forgotten.
    pub fn note(&mut self, scenes: [&Scene; 2], selection: [Selection; 2], gesture: Option<Gesture>) {
        self.steps.truncate(self.done);
        self.last_state += 1;
        let state = self.last_state;
        let [before, after] = scenes;
        let [selected_before, selected_after] = selection;
        if let Some(last) = self.steps.last_mut().filter(|s| gesture.is_some() && s.gesture == gesture) {
            // The step grows: from where the gesture began to here.
            let mut start = before.clone();
            last.patch.undo(&mut start);
            last.patch = Patch::between(&start, after);
            last.selection[1] = selected_after;
            last.state = state;
            return;
        }
        let patch = Patch::between(before, after);
        self.steps.push(Step { patch, selection: [selected_before, selected_after], gesture, state });
        if self.steps.len() > Self::MOST {
            self.first_state = self.steps.remove(0).state;
        }
        self.done = self.steps.len();
    }

    /// Takes the last step back; gives what was selected before it. None when there is nothing to undo.
    pub fn undo(&mut self, scene: &mut Scene) -> Option<Selection> {
        let step = self.steps.get(self.done.checked_sub(1)?)?;
        step.patch.undo(scene);
        self.done -= 1;
        Some(step.selection[0].clone())
    }

    /// Does the last undone step again; gives what was selected after it. None when there is nothing to redo.
    pub fn redo(&mut self, scene: &mut Scene) -> Option<Selection> {
        let step = self.steps.get(self.done)?;
        step.patch.redo(scene);
        self.done += 1;
        Some(step.selection[1].clone())
    }

    /// How many steps can be undone.
    #[must_use]
    pub const fn undoable(&self) -> usize {
        self.done
    }

    /// How many steps can be redone.
    #[must_use]
    pub const fn redoable(&self) -> usize {
        self.steps.len() - self.done
    }

    /// A number that tells the present state of the scene from all others in this history.
    #[must_use]
    pub fn state(&self) -> u64 {
        self.done.checked_sub(1).map_or(self.first_state, |last| self.steps[last].state)
    }
}
