//! The difference between two states of a scene: the runs of entries that changed, and nothing of what stayed. So a step
//! takes as much memory as what it touched, however large the scene is and wherever in its lists the changes are.

use std::collections::HashMap;
use vitrine::scene::{Camera, Group, Item, Light, Material, Object, Scene, Settings, Texture};

/// A run of entries that was replaced by another, either of them perhaps empty.
#[derive(Clone, Debug, PartialEq)]
struct Run<T> {
    /// The index of the first entry, before and after.
    start: [usize; 2],
    entries: [Vec<T>; 2],
}

/// The runs in which two states of a list differ, in order.
#[derive(Clone, Debug, PartialEq)]
struct ListPatch<T>(Vec<Run<T>>);

/// Which way to go through a patch.
#[derive(Clone, Copy)]
enum Way {
    Undo,
    Redo,
}

impl<T: Item + Clone + PartialEq> ListPatch<T> {
    /// Walks both lists from one entry that both have to the next. Entries that changed their order count as replaced.
    fn between(before: &[T], after: &[T]) -> Self {
        let mut runs = Vec::new();
        let start = before.iter().zip(after).take_while(|(b, a)| b == a).count();
        if start == before.len() && start == after.len() {
            return Self(runs);
        }
        let place: HashMap<&str, usize> =
            after.iter().enumerate().skip(start).map(|(i, item)| (item.name(), i)).collect();
        // Where what has been looked at ends, and where the open run begins.
        let (mut done, mut open) = (start, [start, start]);
        let mut close = |open: [usize; 2], end: [usize; 2]| {
            if open != end {
                let entries = [before[open[0]..end[0]].to_vec(), after[open[1]..end[1]].to_vec()];
                runs.push(Run { start: open, entries });
            }
        };
        for (b, item) in before.iter().enumerate().skip(start) {
            let Some(&a) = place.get(item.name()).filter(|a| **a >= done) else { continue };
            if *item == after[a] {
                close(open, [b, a]);
                open = [b + 1, a + 1];
                done = a + 1;
            }
        }
        close(open, [before.len(), after.len()]);
        Self(runs)
    }

    fn apply(&self, list: &mut Vec<T>, way: Way) {
        if self.0.is_empty() {
            return;
        }
        let (from, to) = match way {
            Way::Undo => (1, 0),
            Way::Redo => (0, 1),
        };
        let mut old = std::mem::take(list).into_iter();
        let mut taken = 0;
        for run in &self.0 {
            list.extend(old.by_ref().take(run.start[from] - taken));
            list.extend(run.entries[to].iter().cloned());
            taken = run.start[from] + run.entries[from].len();
            old.by_ref().take(run.entries[from].len()).for_each(drop);
        }
        list.extend(old);
    }

    fn len(&self) -> usize {
        self.0.iter().flat_map(|run| &run.entries).map(Vec::len).sum()
    }
}

/// The difference between two states of a scene.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Patch {
    about: Option<[String; 2]>,
    settings: Option<Box<[Settings; 2]>>,
    camera: Option<Box<[Camera; 2]>>,
    lights: ListPatch<Light>,
    textures: ListPatch<Texture>,
    materials: ListPatch<Material>,
    groups: ListPatch<Group>,
    objects: ListPatch<Object>,
}

impl Patch {
    /// What leads from one state to the other.
    pub(super) fn between(before: &Scene, after: &Scene) -> Self {
        fn pair<T: Clone + PartialEq>(before: &T, after: &T) -> Option<[T; 2]> {
            (before != after).then(|| [before.clone(), after.clone()])
        }
        Self {
            about: pair(&before.about, &after.about),
            settings: pair(&before.settings, &after.settings).map(Box::new),
            camera: pair(&before.camera, &after.camera).map(Box::new),
            lights: ListPatch::between(&before.lights, &after.lights),
            textures: ListPatch::between(&before.textures, &after.textures),
            materials: ListPatch::between(&before.materials, &after.materials),
            groups: ListPatch::between(&before.groups, &after.groups),
            objects: ListPatch::between(&before.objects, &after.objects),
        }
    }

    /// From the later state back to the earlier one.
    pub(super) fn undo(&self, scene: &mut Scene) {
        self.apply(scene, Way::Undo);
    }

    /// From the earlier state to the later one.
    pub(super) fn redo(&self, scene: &mut Scene) {
        self.apply(scene, Way::Redo);
    }

    fn apply(&self, scene: &mut Scene, way: Way) {
        fn pick<T: Clone>(pair: Option<&[T; 2]>, to: &mut T, way: Way) {
            if let Some([before, after]) = pair {
                to.clone_from(match way {
                    Way::Undo => before,
                    Way::Redo => after,
                });
            }
        }
        pick(self.about.as_ref(), &mut scene.about, way);
        pick(self.settings.as_deref(), &mut scene.settings, way);
        pick(self.camera.as_deref(), &mut scene.camera, way);
        self.lights.apply(&mut scene.lights, way);
        self.textures.apply(&mut scene.textures, way);
        self.materials.apply(&mut scene.materials, way);
        self.groups.apply(&mut scene.groups, way);
        self.objects.apply(&mut scene.objects, way);
    }

    /// How many entries it holds: what it costs.
    pub(super) fn len(&self) -> usize {
        let single = usize::from(self.about.is_some()) + 2 * usize::from(self.settings.is_some());
        single
            + 2 * usize::from(self.camera.is_some())
            + self.lights.len()
            + self.textures.len()
            + self.materials.len()
            + self.groups.len()
            + self.objects.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(names: &[(&str, bool)]) -> Scene {
        let object = |(name, visible): &(&str, bool)| Object {
            name: (*name).into(),
            visible: *visible,
            ..Object::default()
        };
        Scene { objects: names.iter().map(object).collect(), ..Scene::default() }
    }

    fn goes_both_ways(before: &Scene, after: &Scene) -> usize {
        let patch = Patch::between(before, after);
        let mut scene = before.clone();
        patch.redo(&mut scene);
        assert_eq!(scene, *after);
        patch.undo(&mut scene);
        assert_eq!(scene, *before);
        patch.len()
    }

    #[test]
    fn any_two_states_lead_to_one_another() {
        let first = scene(&[("a", true), ("b", true), ("c", true), ("d", true), ("e", true)]);
        let others: [&[(&str, bool)]; 8] = [
            &[],
            &[("e", true), ("d", true), ("c", true), ("b", true), ("a", true)],
            &[("a", false), ("b", true), ("c", true), ("d", true), ("e", false)],
            &[("x", true), ("b", true), ("y", true), ("d", true)],
            &[("n", true), ("a", true), ("b", true), ("c", true), ("d", true), ("e", true), ("m", true)],
            &[("b", true), ("d", true)],
            &[("c", true), ("a", true), ("b", false), ("e", true)],
            &[("a", true), ("a", true), ("b", true), ("b", false)],
        ];
        for other in others {
            goes_both_ways(&first, &scene(other));
            goes_both_ways(&scene(other), &first);
        }
        assert_eq!(goes_both_ways(&first, &first), 0);
    }

    #[test]
    fn what_lies_between_two_changes_is_not_kept() {
        let before: Vec<String> = (0..10_000).map(|i| format!("n{i}")).collect();
        let mut states: Vec<(&str, bool)> = before.iter().map(|n| (n.as_str(), true)).collect();
        let before = scene(&states);
        (states[0].1, states[9_999].1) = (false, false);
        states.remove(5_000);
        assert_eq!(goes_both_ways(&before, &scene(&states)), 5);
    }
}
