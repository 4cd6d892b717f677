//! Which entry of a changed list was which entry of the file.

use super::view::View;
use std::collections::{HashMap, VecDeque};

/// For each new entry the index of the old one that it was; None when it is new. No old one is given twice.
///
/// An entry is found again by its name; a renamed one by all else being the same, or by its place in the list.
pub(super) fn pair(old: &[View], new: &[View]) -> Vec<Option<usize>> {
    let mut pairs = vec![None; new.len()];
    let mut is_free = vec![true; old.len()];
    pair_by(old, new, |view| view.name().to_owned(), &mut pairs, &mut is_free);
    pair_by(old, new, View::nameless_block, &mut pairs, &mut is_free);
    for (index, pair) in pairs.iter_mut().enumerate() {
        if pair.is_none() && is_free.get(index) == Some(&true) {
            *pair = Some(index);
            is_free[index] = false;
        }
    }
    pairs
}

/// Pairs what has the same key among those that are still free, in order.
fn pair_by(
    old: &[View],
    new: &[View],
    key: impl Fn(&View) -> String,
    pairs: &mut [Option<usize>],
    is_free: &mut [bool],
) {
    let mut free: HashMap<String, VecDeque<usize>> = HashMap::new();
    for (index, view) in old.iter().enumerate().filter(|(i, _)| is_free[*i]) {
        free.entry(key(view)).or_default().push_back(index);
    }
    if free.is_empty() {
        return;
    }
    for (view, pair) in new.iter().zip(pairs).filter(|(_, pair)| pair.is_none()) {
        *pair = free.get_mut(&key(view)).and_then(VecDeque::pop_front);
        if let Some(index) = *pair {
            is_free[index] = false;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::pair;
    use crate::scene_file::view::View;
    use vitrine_scene::shapes::Sphere;
    use vitrine_scene::{ListName, Object, Scene, Shape};

    fn views(objects: &[(&str, f32)]) -> Vec<View> {
        let object = |(name, radius): &(&str, f32)| {
            let shape = Shape::Sphere(Sphere { radius: *radius });
            Object { name: (*name).into(), shape, ..Object::default() }
        };
        let scene = Scene { objects: objects.iter().map(object).collect(), ..Scene::default() };
        View::list(&scene, ListName::Object)
    }

    #[test]
    fn by_name_then_by_content_then_by_place() {
        let old = views(&[("a", 1.0), ("b", 2.0), ("c", 3.0), ("d", 4.0)]);
        let new = views(&[("x", 4.0), ("a", 9.0), ("y", 8.0), ("z", 7.0), ("w", 6.0)]);
        // "d" was renamed to "x", "a" changed, "c" was renamed and changed; the others are new.
        assert_eq!(pair(&old, &new), [Some(3), Some(0), Some(2), None, None]);
    }

    #[test]
    fn one_name_twice_is_paired_in_order() {
        let old = views(&[("a", 1.0), ("a", 2.0)]);
        assert_eq!(pair(&old, &views(&[("a", 1.0), ("a", 2.0), ("a", 3.0)])), [Some(0), Some(1), None]);
    }
}
