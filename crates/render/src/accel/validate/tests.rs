//! Trees over awkward things are sound, and a tree that is broken on purpose is found out.

use super::*;
use crate::accel::primitives::plane::Plane;
use crate::accel::primitives::sphere::Sphere;
use crate::accel::tests::{Numbers, around, few, mesh, scene};
use crate::accel::tree::{Child, Node, STACK, WIDTH};
use crate::accel::{Instance, MaterialSlots, Primitives};
use proptest::prelude::*;
use vitrine_math::{Affine3A, Mat3, Transform};

fn corners_at(at: Vec3, size: f32) -> [Vec3; 3] {
    [at, at + Vec3::new(size, 0.0, 0.0), at + Vec3::new(0.0, size, 0.0)]
}

#[track_caller]
fn assert_sound(corners: &[[Vec3; 3]], what: &str) {
    assert_eq!(mesh(corners, Vec::new()).validate(), Ok(()), "{what}");
}

#[test]
fn trees_over_degenerate_models_are_sound() {
    let mut numbers = Numbers(5);
    let mut many = |of: &mut dyn FnMut(usize, Vec3) -> [Vec3; 3]| -> Vec<[Vec3; 3]> {
        (0..few(20_000)).map(|i| of(i, numbers.vector())).collect()
    };
    assert_sound(&[], "nothing");
    assert_sound(&[corners_at(Vec3::ONE, 1.0)], "one triangle");
    assert_sound(&vec![corners_at(Vec3::ONE, 1.0); few(100_000)], "identical triangles");
    assert_sound(&vec![[Vec3::ONE; 3]; few(100_000)], "all in one point");
    assert_sound(&many(&mut |_, p| corners_at(p.with_z(0.25), 0.01)), "a sheet");
    assert_sound(&many(&mut |_, p| [p.with_y(0.0).with_z(-0.0); 3]), "a line of points");
    for size in [1e30_f32, 1e19, 1e-19, 1e-30, 1e-38, 1e-45] {
        assert_sound(
            &many(&mut |_, p| corners_at(p * size, size * 0.1)),
            &format!("coordinates of {size:e}"),
        );
    }
    let spaced = |i: usize| Vec3::new(libm::exp2f((i % 250) as f32 - 125.0), 0.0, 0.0);
    assert_sound(&many(&mut |i, _| [spaced(i); 3]), "exponentially spaced points");
    assert_sound(&many(&mut |i, _| corners_at(spaced(i), spaced(i).x)), "exponentially spaced triangles");
    let on_both_sides = |i: usize, p: Vec3| corners_at(spaced(i) * p.x.signum(), spaced(i / 3).x);
    assert_sound(&many(&mut |i, p| on_both_sides(i, p)), "all sizes on both sides");
}

/// Balls, cubes, triangles and models, all of them where `place` says, of that size.
fn mixed(count: usize, mut place: impl FnMut(usize) -> (Vec3, f32)) -> Accel {
    let mut p = Primitives::default();
    let model = Arc::new(mesh(&[corners_at(Vec3::ZERO, 1.0)], Vec::new()));
    for i in 0..count {
        let ((at, size), primitive) = (place(i), i as u32);
        p.materials.push(MaterialSlots { first: 0, by_triangle: false });
        let shrunk = size.max(1e-12).recip();
        let inwards = Affine3A::from_mat3_translation(Mat3::from_diagonal(Vec3::splat(shrunk)), at * -shrunk);
        let bounds = around(at, size);
        match i % 7 {
            0 => {
                p.spheres.push((Sphere { center: at.into(), radius: size, primitive }, bounds));
            }
            1 => p.boxes.push((Unit { unit_from_world: inwards, primitive }, bounds)),
            2 => p.ellipsoids.push((Unit { unit_from_world: inwards, primitive }, bounds)),
            3 => p.triangles.push((corners_at(at, size), primitive)),
            4 => {
                let instance = Instance { mesh_from_world: inwards, mesh: model.clone(), primitive };
                p.instances.push((instance, bounds));
            }
            5 => {
                let unit = Transform { world_from_object: inwards.inverse(), object_from_world: inwards };
                let disc = Disc { center: at.into(), ..Disc::new(&unit, primitive) };
                p.discs.push((disc, bounds));
            }
            _ => p.planes.push(Plane { n: [0.0, 1.0, 0.0], offset: at.y, primitive }),
        }
    }
    Accel::new(p, vec![0.0])
}

#[test]
fn trees_over_degenerate_scenes_are_sound() {
    let mut numbers = Numbers(6);
    assert_eq!(Accel::new(Primitives::default(), Vec::new()).validate(), Ok(()));
    for count in [1, 2, 7, 14, few(3000)] {
        assert_eq!(mixed(count, |_| (Vec3::ONE, 1.0)).validate(), Ok(()), "all in one place");
        assert_eq!(mixed(count, |_| (Vec3::ONE, 0.0)).validate(), Ok(()), "all in one point");
        assert_eq!(mixed(count, |i| (Vec3::X * i as f32, 0.0)).validate(), Ok(()), "a line");
        for size in [1e30_f32, 1e12, 1e-12, 1e-30] {
            let made = mixed(count, |_| (numbers.vector() * size, size * 0.1));
            assert_eq!(made.validate(), Ok(()), "{count} of {size:e}");
        }
        let spaced = |i: usize| libm::exp2f((i % 120) as f32 - 60.0);
        assert_eq!(mixed(count, |i| (Vec3::Y * spaced(i), spaced(i))).validate(), Ok(()), "exponential");
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: if cfg!(miri) { 4 } else { 400 },
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// Places and sizes of any magnitude, many of them equal.
    #[test]
    fn trees_over_anything_are_sound(
        places in proptest::collection::vec((-60_i32..60, -60_i32..60, any::<[i8; 3]>(), any::<bool>()), 0..300),
    ) {
        let at = |i: usize| {
            let (near, size, direction, is_round) = places[i];
            let power = |p: i32| libm::exp2f(if is_round { (p / 30 * 30) as f32 } else { p as f32 });
            (Vec3::from_array(direction.map(f32::from)) * power(near), power(size))
        };
        prop_assert_eq!(mixed(places.len(), at).validate(), Ok(()));
        let corners: Vec<_> = (0..places.len()).map(|i| corners_at(at(i).0, at(i).1)).collect();
        prop_assert_eq!(mesh(&corners, Vec::new()).validate(), Ok(()));
    }
}

/// A model with some levels.
fn sound_mesh() -> MeshAccel {
    let mut numbers = Numbers(9);
    let corners: Vec<_> = (0..600).map(|_| corners_at(numbers.vector(), 0.02)).collect();
    let accel = mesh(&corners, Vec::new());
    assert_eq!(accel.validate(), Ok(()));
    assert!(accel.tree.nodes.len() > 10);
    accel
}

/// What is found after a change.
fn broken(change: impl FnOnce(&mut MeshAccel)) -> TreeFlaw {
    let mut accel = sound_mesh();
    change(&mut accel);
    accel.validate().expect_err("broken on purpose")
}

/// The first place whose child is a leaf, or is none.
fn find(nodes: &[Node], is_leaf: bool) -> (usize, usize) {
    let all = (0..nodes.len()).flat_map(|node| (0..WIDTH).map(move |place| (node, place)));
    let is_it = |(node, place): &(usize, usize)| {
        !nodes[*node].bounds(*place).is_empty() && nodes[*node].child(*place).is_leaf() == is_leaf
    };
    all.into_iter().find(is_it).expect("there is one")
}

/// Writes what a child is.
fn set(nodes: &mut [Node], (node, place): (usize, usize), child: Child) {
    nodes[node].rows[6][place] = f32::from_bits(child.first);
    nodes[node].rows[7][place] = f32::from_bits(child.tag);
}

#[test]
fn children_outside_the_tree_or_met_twice_are_found() {
    for wrong in [0, u32::MAX] {
        let flaw = broken(|m| {
            let at = find(&m.tree.nodes, false);
            set(&mut m.tree.nodes, at, Child { first: wrong, tag: 0 });
        });
        assert_eq!(flaw, TreeFlaw::BadChild { node: 0, child: wrong as usize });
    }
    // Two ways to one node.
    let flaw = broken(|m| {
        let nodes = &mut m.tree.nodes;
        let (node, place) = find(nodes, false);
        let child = nodes[node].child(place);
        set(nodes, (node, place + 1), child);
    });
    assert_eq!(flaw, TreeFlaw::BadChild { node: 0, child: 1 });
}

#[test]
fn boxes_that_do_not_hold_what_is_in_them_are_found() {
    for is_leaf in [true, false] {
        for row in 0..6 {
            let mut at = (0, 0);
            let flaw = broken(|m| {
                at = find(&m.tree.nodes, is_leaf);
                let value = &mut m.tree.nodes[at.0].rows[row][at.1];
                *value = if row % 2 == 0 { value.next_up() } else { value.next_down() };
            });
            assert_eq!(flaw, TreeFlaw::OutsideBox { node: at.0, place: at.1 });
        }
    }
    // One triangle moved.
    let flaw = broken(|m| {
        let block = &mut m.blocks[0];
        (0..3).for_each(|corner| block.corners[corner][0][0] += 5.0);
    });
    assert!(matches!(flaw, TreeFlaw::OutsideBox { .. }), "{flaw}");
}

#[test]
fn boxes_that_are_none_are_found() {
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for row in 0..6 {
            let flaw = broken(|m| m.tree.nodes[0].rows[row][3] = value);
            assert_eq!(flaw, TreeFlaw::BadBox { node: 0, place: 3 }, "{value} in row {row}");
        }
    }
    // An empty place that still says what its child was.
    let flaw = broken(|m| {
        let (node, place) = find(&m.tree.nodes, true);
        for row in 0..6 {
            m.tree.nodes[node].rows[row][place] =
                if row % 2 == 0 { f32::INFINITY } else { f32::NEG_INFINITY };
        }
    });
    assert!(matches!(flaw, TreeFlaw::BadBox { .. }), "{flaw}");
}

#[test]
fn leaves_that_hold_the_wrong_triangles_are_found() {
    let leaf_changed = |change: &dyn Fn(Child) -> Child| {
        broken(|m| {
            let at = find(&m.tree.nodes, true);
            let child = m.tree.nodes[at.0].child(at.1);
            set(&mut m.tree.nodes, at, change(child));
        })
    };
    let changes: [&dyn Fn(Child) -> Child; 4] = [
        &|c| Child { first: u32::MAX, ..c },
        &|c| Child { tag: c.tag + 1, ..c },
        &|c| Child { tag: c.tag | 0xff, ..c },
        &|c| Child { tag: c.count() | u32::from(leaf::SPHERE + 2) << 24, ..c },
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let flaw = leaf_changed(change);
        assert!(matches!(flaw, TreeFlaw::BadLeaf { .. }), "change {i}: {flaw}");
    }
    let blocks: [fn(&mut MeshAccel); 6] = [
        // Two leaves with one block.
        |m| {
            let nodes = &mut m.tree.nodes;
            let (node, place) = find(nodes, true);
            let child = nodes[node].child(place);
            (0..6).for_each(|row| nodes[node].rows[row][place + 1] = nodes[node].rows[row][place]);
            set(nodes, (node, place + 1), child);
        },
        |m| m.blocks[0].ids[0] = u32::MAX,
        |m| m.blocks[0].ids[0] = m.blocks[1].ids[0],
        |m| m.blocks[0].ids[0] = 600,
        |m| m.blocks[0].corners[1][2][0] = f32::NAN,
        |m| m.blocks[0].corners[2][0][0] = f32::INFINITY,
    ];
    for (i, change) in blocks.into_iter().enumerate() {
        let flaw = broken(change);
        assert!(matches!(flaw, TreeFlaw::BadLeaf { .. }), "block {i}: {flaw}");
    }
}

#[test]
fn what_no_way_leads_to_is_counted() {
    assert_eq!(broken(|m| m.tree.nodes.push(m.tree.nodes[0])), TreeFlaw::Unreachable { count: 1 });
    assert_eq!(broken(|m| m.blocks.push(m.blocks[0])), TreeFlaw::Unreachable { count: 1 });
    assert_eq!(broken(|m| m.triangles += 2), TreeFlaw::Unreachable { count: 2 });
    assert_eq!(
        broken(|m| m.tree.nodes.clear()),
        TreeFlaw::Unreachable { count: sound_mesh().blocks.len() + 600 }
    );
}

#[test]
fn a_tree_that_is_too_deep_to_walk_is_found() {
    let flaw = broken(|m| {
        // A ladder above the tree: each node has one child, the next one.
        let bounds = m.bounds();
        let below = std::mem::take(&mut m.tree.nodes);
        let rungs = STACK / (WIDTH - 1) + 1;
        m.tree.nodes = vec![Node::EMPTY; rungs];
        for (i, node) in m.tree.nodes.iter_mut().enumerate() {
            for axis in 0..3 {
                node.rows[2 * axis][0] = bounds.min[axis];
                node.rows[2 * axis + 1][0] = bounds.max[axis];
            }
            (node.rows[6][0], node.rows[7][0]) = (f32::from_bits(i as u32 + 1), 0.0);
        }
        m.tree.nodes.extend(below.into_iter().map(|mut node| {
            for place in 0..WIDTH {
                let child = node.child(place);
                if !child.is_leaf() {
                    node.rows[6][place] = f32::from_bits(child.first + rungs as u32);
                }
            }
            node
        }));
    });
    assert!(matches!(flaw, TreeFlaw::TooDeep { .. }), "{flaw}");
}

#[test]
fn flaws_of_the_scene_and_of_its_meshes_are_told_apart() {
    assert_eq!(scene(4).validate(), Ok(()));
    let bad_leaf = |change: fn(&mut Accel)| {
        let mut accel = scene(4);
        change(&mut accel);
        let flaw = accel.validate().expect_err("broken on purpose");
        assert!(matches!(flaw, AccelFlaw::Scene { flaw: TreeFlaw::BadLeaf { .. } }), "{flaw}");
    };
    bad_leaf(|a| a.spheres[0].radii[0] = -1.0);
    bad_leaf(|a| a.spheres[0].centers[1][0] = f32::NAN);
    bad_leaf(|a| a.spheres[0].primitives[0] = a.boxes[0].primitive);
    bad_leaf(|a| a.boxes[0].primitive = a.ellipsoids[0].primitive);
    bad_leaf(|a| a.ellipsoids[0].primitive = u32::MAX);
    bad_leaf(|a| a.ellipsoids[0].unit_from_world.translation.x = f32::NAN);
    bad_leaf(|a| a.discs[0].n[1] = f32::NAN);
    bad_leaf(|a| a.discs[0].center[2] = f32::INFINITY);
    bad_leaf(|a| a.discs[0].across[1][0] = f32::NAN);
    bad_leaf(|a| a.discs[0].primitive = a.discs[1].primitive);
    bad_leaf(|a| a.triangles[0].ids[0] = a.instances[0].primitive);
    bad_leaf(|a| a.instances.truncate(1));

    let mut accel = scene(4);
    accel.boxes.push(accel.boxes[0]);
    assert_eq!(accel.validate(), Err(TreeFlaw::Unreachable { count: 1 }.into()));

    let mut accel = scene(4);
    accel.planes[1].primitive = accel.planes[0].primitive;
    assert_eq!(accel.validate(), Err(AccelFlaw::BadPlane { primitive: accel.planes[0].primitive }));
    let mut accel = scene(4);
    accel.planes[0].offset = f32::NAN;
    assert_eq!(accel.validate(), Err(AccelFlaw::BadPlane { primitive: accel.planes[0].primitive }));

    let mut accel = scene(4);
    let mut model = MeshAccel::clone(&accel.instances[2].mesh);
    model.blocks[3].ids[0] = 100_000;
    accel.instances[2].mesh = Arc::new(model);
    let flaw = accel.validate().expect_err("broken on purpose");
    let primitive = accel.instances[2].primitive;
    assert!(
        matches!(flaw, AccelFlaw::Mesh { primitive: p, flaw: TreeFlaw::BadLeaf { .. } } if p == primitive),
        "{flaw}"
    );
    assert!(flaw.to_string().contains(&format!("primitive {primitive}")), "{flaw}");
}
