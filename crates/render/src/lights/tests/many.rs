//! Many lights: the tree chooses what matters, and its probabilities are those of its choices.

use super::*;

/// Triangles and balls strewn over a hall, of very different brightness.
fn strewn(count: u32) -> Vec<Emitter> {
    let number = |i: u32| hash::unit(hash::mix(i));
    (0..count)
        .map(|i| {
            let at = |k| Vec3::new(number(k), number(k + 1), number(k + 2));
            let center = at(20 * i) * Vec3::new(20.0, 4.0, 20.0);
            let form = if i % 3 == 0 {
                EmitterForm::Sphere { center, radius: 0.02 + 0.1 * number(20 * i + 3) }
            } else {
                EmitterForm::Triangle { points: [5, 8, 11].map(|k| center + (at(20 * i + k) - 0.5) * 0.3) }
            };
            let radiance = Rgb::splat(libm::powf(100.0, number(20 * i + 14)));
            Emitter { form, radiance, is_two_sided: i % 2 == 0, primitive: i / 7, triangle: i % 7 }
        })
        .collect()
}

const POINTS: [Vec3; 4] = [
    Vec3::new(3.0, 0.0, 4.0),
    Vec3::new(10.0, 2.0, 10.0),
    Vec3::new(-30.0, 5.0, 3.0),
    Vec3::new(1e5, 0.0, -1e5),
];

#[test]
fn probabilities_of_all_lights_together_are_one() {
    for count in [2, 16, 17, 300] {
        // To both sides: where all lights of a branch turn their backs, its part of the choice is lost.
        let both = |emitter| Emitter { is_two_sided: true, ..emitter };
        let lights = Lights::new(&[], &strewn(count).into_iter().map(both).collect::<Vec<_>>());
        for p in POINTS {
            let weights = lights.weights(p, None);
            let probability = |light| match (&lights.tree, &weights.local) {
                (Some(tree), Local::Cut(cut)) => tree.probability(cut, light, p, None),
                (_, local) => local.probability(light),
            };
            let sum: f64 = (0..count).map(|light| f64::from(probability(light))).sum();
            assert!((sum - 1.0).abs() < 1e-4, "{count} lights, from {p}: {sum}");
        }
    }
}

#[test]
fn the_tree_chooses_with_the_probabilities_that_it_says() {
    const N: u32 = 200_000;
    let lights = Lights::new(&[], &strewn(100));
    let tree = lights.tree.as_ref().unwrap();
    for (p, n) in POINTS.into_iter().flat_map(|p| [(p, None), (p, Some(Vec3::Y))]) {
        let cut = tree.cut(p, n);
        let mut counts = [0.0; 100];
        let mut lost = 0.0;
        for i in 0..N {
            match tree.choose(&cut, p, n, (f64::from(i) + 0.5) / f64::from(N)) {
                Some((light, probability)) => {
                    counts[light as usize] += 1.0 / f64::from(N);
                    let said = tree.probability(&cut, light, p, n);
                    assert!((probability - said).abs() <= 1e-5 * said, "{probability} against {said}");
                }
                None => lost += 1.0 / f64::from(N),
            }
        }
        for (light, count) in (0..).zip(counts) {
            let said = f64::from(tree.probability(&cut, light, p, n));
            assert!(
                (count - said).abs() < 3.0 / f64::from(N) + 1e-6,
                "light {light}: {count} against {said}"
            );
        }
        assert!((counts.iter().sum::<f64>() + lost - 1.0_f64).abs() < 1e-9);
    }
}

#[test]
fn the_tree_lights_as_its_lights_do_one_by_one() {
    let emitters = strewn(60);
    let all = Lights::new(&[], &emitters);
    let n = Vec3::new(0.3, 0.9, -0.2).normalize();
    for p in POINTS {
        let alone =
            |emitter: &Emitter| irradiance(&Lights::new(&[], std::slice::from_ref(emitter)), p, n, true);
        let expected: f64 = emitters.iter().map(alone).sum();
        for with_normal in [true, false] {
            let found = irradiance(&all, p, n, with_normal);
            assert!((found - expected).abs() <= 0.02 * expected, "{found} against {expected} from {p}");
        }
    }
}

#[test]
fn the_tree_is_far_better_than_an_even_choice() {
    // By the spread of what single samples say, in a hall of 300 lights, near one of its walls.
    let emitters = strewn(300);
    let lights = Lights::new(&[], &emitters);
    let (p, n) = (Vec3::new(3.0, 0.0, 4.0), Vec3::Y);
    let (mut tree, mut even, count) = ([0.0; 2], [0.0; 2], 20_000);
    for i in 0..count {
        let (choice, u) = numbers(i, 4);
        let of = |sample: Option<LightSample>| sample.map_or(0.0, |sample| irradiance_of(&sample, p, n));
        let by_tree = of(lights.sample(p, Some(n), choice, u));
        tree = [tree[0] + by_tree, tree[1] + by_tree * by_tree];
        let one = &emitters[(choice * 300.0) as usize];
        let by_one = 300.0 * of(Lights::new(&[], std::slice::from_ref(one)).sample(p, Some(n), 0.0, u));
        even = [even[0] + by_one, even[1] + by_one * by_one];
    }
    let variance = |[sum, squares]: [f64; 2]| squares / f64::from(count) - (sum / f64::from(count)).powi(2);
    let [tree, even] = [tree, even].map(variance);
    assert!(tree * 20.0 < even, "{tree} against {even}");
}

#[test]
fn lights_in_one_place_make_a_tree_that_is_not_deep() {
    let one = emitter(EmitterForm::Sphere { center: Vec3::ONE, radius: 0.1 }, false);
    let lights = Lights::new(&[], &vec![one; 5000]);
    let tree = lights.tree.as_ref().unwrap();
    let cut = tree.cut(Vec3::ZERO, None);
    assert!((tree.probability(&cut, 777, Vec3::ZERO, None) * 5000.0 - 1.0).abs() < 0.3);
    // Each half as far as the one before: cut after cut takes a few off the end only.
    let halves =
        (0..2000).map(|i| EmitterForm::Sphere { center: Vec3::X * libm::powf(0.98, i as f32), radius: 1e-4 });
    let emitters: Vec<_> = halves.map(|form| emitter(form, false)).collect();
    assert!(Lights::new(&[], &emitters).sample(Vec3::Y, None, 0.3, [0.5; 2]).is_some());
}

#[test]
fn a_triangle_finds_its_light() {
    let mut emitters = strewn(100);
    // Some do not shine, and those of one primitive do not come in order.
    emitters.iter_mut().step_by(5).for_each(|emitter| emitter.radiance = Rgb::BLACK);
    emitters.reverse();
    let lights = Lights::new(&[], &emitters);
    let mut light = 0;
    for emitter in &emitters {
        let expected = (emitter.radiance != Rgb::BLACK).then_some(light);
        assert_eq!(lights.emitter(emitter.primitive, emitter.triangle), expected);
        light += u32::from(expected.is_some());
    }
    assert_eq!(lights.emitter(500, 0), None);
    assert_eq!(lights.emitter(0, 9), None);
}
