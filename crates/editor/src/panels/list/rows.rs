//! The rows of the list: groups with their members under them, then objects that are in no group, lights, the camera.

use crate::document::Thing;
use crate::theme::icons;
use std::collections::HashSet;
use vitrine::scene::{ListName, Scene};

/// A row of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// What it stands for.
    pub thing: Thing,
    /// How many groups it is inside of.
    pub depth: usize,
    /// The word of its kind: "sphere", "disc", "group", "camera".
    pub kind: &'static str,
    /// Whether it is switched on itself; None when it has no such switch.
    pub visible: Option<bool>,
    /// Whether it has rows under it that are not shown now.
    pub is_closed: bool,
}

impl Row {
    /// The icon of its kind.
    #[must_use]
    pub fn icon(&self) -> &'static str {
        self.thing.list().map_or_else(|| icons::of_kind(self.kind), |list| icons::of_item(list, self.kind))
    }
}

/// The rows for a scene. With a search only the things whose names hold it, without groups around them.
#[must_use]
pub fn rows(scene: &Scene, closed: &HashSet<String>, search: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    if search.trim().is_empty() {
        let mut tree = Tree { scene, closed, rows: &mut rows, entered: HashSet::new() };
        tree.members_of(None, 0);
        // A ring of groups has no outermost one; whatever was not reached stands at the end.
        for group in &scene.groups {
            tree.group(&group.name, 0);
        }
    } else {
        rows.extend(scene.groups.iter().map(|g| row(Thing::group(&*g.name), 0, "group", Some(g.visible))));
        rows.extend(
            scene.objects.iter().map(|o| row(Thing::object(&*o.name), 0, o.shape.kind(), Some(o.visible))),
        );
    }
    rows.extend(
        scene.lights.iter().map(|l| row(Thing::light(&*l.name), 0, l.source.kind(), Some(l.visible))),
    );
    if search.trim().is_empty() {
        rows.push(row(Thing::Camera, 0, "camera", None));
    } else {
        let wanted = search.trim().to_lowercase();
        rows.retain(|r| r.thing.name().is_some_and(|n| n.to_lowercase().contains(&wanted)));
    }
    rows
}

fn row(thing: Thing, depth: usize, kind: &'static str, visible: Option<bool>) -> Row {
    Row { thing, depth, kind, visible, is_closed: false }
}

/// Walks the groups from the outside inwards, each once.
struct Tree<'a> {
    scene: &'a Scene,
    closed: &'a HashSet<String>,
    rows: &'a mut Vec<Row>,
    entered: HashSet<&'a str>,
}

impl<'a> Tree<'a> {
    fn members_of(&mut self, group: Option<&str>, depth: usize) {
        let scene = self.scene;
        let is_in = |of: &Option<String>| match (of.as_deref(), group) {
            (Some(of), Some(group)) => of == group,
            // A group that is not there counts as none.
            (of, None) => of.is_none_or(|of| scene.group(of).is_none()),
            (None, Some(_)) => false,
        };
        for inner in scene.groups.iter().filter(|g| is_in(&g.group)) {
            self.group(&inner.name, depth);
        }
        for object in scene.objects.iter().filter(|o| is_in(&o.group)) {
            self.rows.push(row(
                Thing::object(&*object.name),
                depth,
                object.shape.kind(),
                Some(object.visible),
            ));
        }
    }

    fn group(&mut self, name: &'a str, depth: usize) {
        let Some(group) = self.scene.group(name) else { return };
        if !self.entered.insert(name) {
            return;
        }
        let is_closed = self.closed.contains(name);
        let thing = Thing::Item(ListName::Group, name.to_owned());
        self.rows.push(Row { is_closed, ..row(thing, depth, "group", Some(group.visible)) });
        let before = self.rows.len();
        self.members_of(Some(name), depth + 1);
        if is_closed {
            self.rows.truncate(before);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::{Group, Light, Object};

    fn scene() -> Scene {
        let group = |name: &str, group: Option<&str>| Group {
            name: name.into(),
            group: group.map(str::to_owned),
            ..Group::default()
        };
        let object = |name: &str, group: Option<&str>| Object {
            name: name.into(),
            group: group.map(str::to_owned),
            ..Object::default()
        };
        Scene {
            groups: vec![group("shelf", Some("case")), group("case", None)],
            objects: vec![object("vase", Some("shelf")), object("Floor", None), object("lost", Some("gone"))],
            lights: vec![Light::default()],
            ..Scene::default()
        }
    }

    fn shown(closed: &[&str], search: &str) -> Vec<(String, usize)> {
        let closed = closed.iter().map(|c| (*c).to_owned()).collect();
        let name = |r: &Row| r.thing.name().unwrap_or("camera").to_owned();
        rows(&scene(), &closed, search).iter().map(|r| (name(r), r.depth)).collect()
    }

    fn of(rows: &[(&str, usize)]) -> Vec<(String, usize)> {
        rows.iter().map(|(name, depth)| ((*name).to_owned(), *depth)).collect()
    }

    #[test]
    fn members_stand_under_their_groups() {
        let wanted =
            [("case", 0), ("shelf", 1), ("vase", 2), ("Floor", 0), ("lost", 0), ("light", 0), ("camera", 0)];
        assert_eq!(shown(&[], ""), of(&wanted));
    }

    #[test]
    fn a_closed_group_hides_its_rows_alone() {
        let wanted = [("case", 0), ("Floor", 0), ("lost", 0), ("light", 0), ("camera", 0)];
        assert_eq!(shown(&["case"], ""), of(&wanted));
    }

    #[test]
    fn a_search_finds_names_without_regard_to_case() {
        assert_eq!(shown(&["case"], "FLO"), of(&[("Floor", 0)]));
        assert_eq!(shown(&["case"], " vas "), of(&[("vase", 0)]));
    }

    #[test]
    fn a_ring_of_groups_shows_everything_once() {
        let mut scene = scene();
        scene.groups[1].group = Some("shelf".into());
        let rows = rows(&scene, &HashSet::new(), "");
        assert_eq!(rows.len(), 7, "{rows:?}");
    }
}
