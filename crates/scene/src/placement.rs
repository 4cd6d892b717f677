//! Where groups put their members: worked out once for all groups, then looked up for each object.

use crate::{Object, Scene};
use std::collections::HashMap;
use vitrine_math::Transform;

/// Where all groups of a scene are and whether they are seen. Made by [`Scene::group_places`].
#[derive(Clone, Debug)]
pub struct GroupPlaces<'a> {
    index_of: HashMap<&'a str, usize>,
    places: Vec<GroupPlace>,
}

/// A group with all that are around it.
#[derive(Clone, Copy, Debug)]
struct GroupPlace {
    world_from_group: Transform,
    is_seen: bool,
}

impl Scene {
    /// Where all groups are, to ask about many objects. A missing group counts as none, and a ring of groups is cut open;
    /// both are [`Problem`](crate::Problem)s.
    #[must_use]
    pub fn group_places(&self) -> GroupPlaces<'_> {
        // Of several groups with one name the first counts, as everywhere.
        let index_of: HashMap<&str, usize> =
            self.groups.iter().enumerate().rev().map(|(i, g)| (g.name.as_str(), i)).collect();
        let mut places: Vec<Option<GroupPlace>> = vec![None; self.groups.len()];
        let mut is_on_the_way = vec![false; self.groups.len()];
        for start in 0..self.groups.len() {
            // Outwards until a place is known, and back.
            let mut way = Vec::new();
            let mut at = Some(start);
            while let Some(i) = at.filter(|i| places[*i].is_none() && !is_on_the_way[*i]) {
                is_on_the_way[i] = true;
                way.push(i);
                at = self.groups[i].group.as_deref().and_then(|g| index_of.get(g).copied());
            }
            let mut outer = at.and_then(|i| places[i]);
            for i in way.into_iter().rev() {
                let group = &self.groups[i];
                let place = outer.map_or_else(|| group.place(), |o| o.world_from_group.after(&group.place()));
                let is_seen = group.visible && outer.is_none_or(|o| o.is_seen);
                outer = Some(GroupPlace { world_from_group: place, is_seen });
                places[i] = outer;
            }
        }
        GroupPlaces { index_of, places: places.into_iter().flatten().collect() }
    }

    /// From an object's own space to the world, through its groups. For many objects take [`Scene::group_places`].
    #[must_use]
    pub fn world_from_object(&self, object: &Object) -> Transform {
        self.group_places().world_from_object(object)
    }

    /// Whether an object and all groups around it are visible. For many objects take [`Scene::group_places`].
    #[must_use]
    pub fn is_seen(&self, object: &Object) -> bool {
        self.group_places().is_seen(object)
    }
}

impl GroupPlaces<'_> {
    /// From an object's own space to the world, through its groups.
    #[must_use]
    pub fn world_from_object(&self, object: &Object) -> Transform {
        let place = object.place();
        self.around(object.group.as_deref()).map_or(place, |group| group.world_from_group.after(&place))
    }

    /// From the space of a group's members to the world, through the groups around it. `None` and a missing group are the
    /// world itself.
    #[must_use]
    pub fn world_from_group(&self, group: Option<&str>) -> Transform {
        self.around(group).map_or_else(Transform::default, |group| group.world_from_group)
    }

    /// Whether an object and all groups around it are visible.
    #[must_use]
    pub fn is_seen(&self, object: &Object) -> bool {
        object.visible && self.around(object.group.as_deref()).is_none_or(|group| group.is_seen)
    }

    fn around(&self, group: Option<&str>) -> Option<&GroupPlace> {
        let index = self.index_of.get(group?)?;
        self.places.get(*index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Group;
    use vitrine_math::Vec3;

    fn nested() -> Scene {
        Scene {
            groups: vec![
                Group {
                    name: "shelf".into(),
                    group: Some("case".into()),
                    position: Vec3::new(0.0, 1.0, 0.0),
                    ..Group::default()
                },
                Group {
                    name: "case".into(),
                    position: Vec3::new(10.0, 0.0, 0.0),
                    turn_deg: Vec3::new(0.0, 90.0, 0.0),
                    ..Group::default()
                },
            ],
            objects: vec![Object {
                position: Vec3::new(0.0, 0.0, 2.0),
                group: Some("shelf".into()),
                ..Object::default()
            }],
            ..Scene::default()
        }
    }

    #[test]
    fn groups_move_their_members_inside_out() {
        let scene = nested();
        let origin = scene.world_from_object(&scene.objects[0]).point(Vec3::ZERO);
        assert_eq!(origin, Vec3::new(12.0, 1.0, 0.0));
    }

    #[test]
    fn a_hidden_outer_group_hides_the_object() {
        let mut scene = nested();
        assert!(scene.is_seen(&scene.objects[0]));
        scene.groups[1].visible = false;
        assert!(!scene.is_seen(&scene.objects[0]));
    }

    #[test]
    fn a_ring_of_groups_and_a_missing_group_end() {
        let mut scene = nested();
        scene.groups[1].group = Some("shelf".into());
        assert!(scene.world_from_object(&scene.objects[0]).world_from_object.is_finite());
        scene.objects[0].group = Some("gone".into());
        assert_eq!(scene.world_from_object(&scene.objects[0]), scene.objects[0].place());
    }

    #[test]
    fn a_hundred_groups_inside_one_another_all_count() {
        let group = |i: usize| Group {
            name: format!("g{i}"),
            group: i.checked_sub(1).map(|outer| format!("g{outer}")),
            position: Vec3::X,
            ..Group::default()
        };
        let object = Object { group: Some("g99".into()), ..Object::default() };
        let scene =
            Scene { groups: (0..100).map(group).collect(), objects: vec![object], ..Scene::default() };
        let origin = scene.world_from_object(&scene.objects[0]).point(Vec3::ZERO);
        assert_eq!(origin, Vec3::new(100.0, 0.0, 0.0));
    }
}
