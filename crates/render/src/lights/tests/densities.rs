//! Densities by counts: what `sample` finds where is what `pdf_surface` and `pdf_distant` say.

use super::*;

/// Points where a light is looked at from, with a normal or without.
const VIEWS: [(Vec3, Option<Vec3>); 4] = [
    (Vec3::new(0.3, -1.1, 0.2), None),
    (Vec3::new(0.3, -1.1, 0.2), Some(Vec3::Y)),
    (Vec3::new(-2.0, 0.9, 1.5), None),
    (Vec3::new(0.9, -8.0, 3.0), Some(Vec3::Y)),
];

/// Lights of every kind with a surface; all lie around the origin.
fn surfaces() -> Vec<(&'static str, Lights)> {
    let unit = Transform::from_place(
        Vec3::new(0.1, 0.2, 0.0),
        Vec3::new(20.0, 50.0, -30.0),
        Vec3::new(0.5, 0.2, 0.8),
    );
    let center = Vec3::new(0.1, 0.0, -0.1);
    vec![
        ("ball", of_form(EmitterForm::Sphere { center, radius: 0.4 })),
        ("ellipsoid", of_form(EmitterForm::Ellipsoid { unit })),
        ("box", of_form(EmitterForm::Box { unit })),
        ("disc", Lights::new(&[], &[emitter(EmitterForm::Disc { unit, n: Vec3::Y }, true)])),
        ("triangle", Lights::new(&[], &[emitter(EmitterForm::Triangle { points: POINTS }, true)])),
        ("disc lamp", of_lamp(Emission::Disc { position: center, radius: 0.5 })),
        ("ball lamp", of_lamp(Emission::Sphere { position: center, radius: 0.5 })),
        ("several", Lights::new(&[lamp(Emission::Everywhere, Rgb::splat(0.02))], &several())),
    ]
}

const POINTS: [Vec3; 3] = [Vec3::new(-0.5, 0.0, -0.4), Vec3::new(0.6, 0.2, 0.0), Vec3::new(0.0, -0.3, 0.7)];

fn several() -> Vec<Emitter> {
    let at = |x, y| EmitterForm::Sphere { center: Vec3::new(x, y, 0.3), radius: 0.2 };
    [at(-0.6, 0.0), at(0.6, 0.4), EmitterForm::Triangle { points: POINTS }]
        .into_iter()
        .zip(0..)
        .map(|(form, triangle)| Emitter { triangle, ..emitter(form, true) })
        .collect()
}

#[test]
fn the_density_of_a_sample_is_that_of_its_point() {
    for (name, lights) in surfaces() {
        for (p, n) in VIEWS {
            for i in 0..500 {
                let (choice, u) = numbers(i, 7);
                let Some(sample) = lights.sample(p, n, choice, u) else { continue };
                let pdf = match sample.at {
                    LightPoint::Surface { position, .. } => lights.pdf_surface(sample.light, p, n, position),
                    LightPoint::Distant { toward } => lights.pdf_distant(p, n, toward),
                    LightPoint::Point { .. } => sample.pdf,
                };
                // A ball's limb turns away from who looks: there the last digits of its point show.
                let tolerance = 2e-3 * sample.pdf + 2e-5 / sample.pdf.max(0.01);
                assert!((pdf - sample.pdf).abs() <= tolerance, "{name}: {pdf} against {}", sample.pdf);
            }
        }
    }
}

/// The cell of a direction: 8 bands of equal height times 12 sectors around an axis.
fn cell(toward: Vec3, axis: Vec3) -> usize {
    let local = vitrine_math::Frame::around(axis).local(toward);
    let band = ((local.z + 1.0) * 4.0).clamp(0.0, 7.0) as usize;
    let sector = ((local.y.atan2(local.x) / std::f32::consts::TAU + 0.5) * 12.0).clamp(0.0, 11.0) as usize;
    band * 12 + sector
}

/// Chi-squared of counts against what was expected, cells with few together; and the degrees of freedom.
fn chi2(counts: &[f64], expected: &[f64]) -> (f64, f64) {
    let (mut sum, mut cells, mut few) = (0.0, 0.0, [0.0, 0.0]);
    for (count, expected) in counts.iter().zip(expected) {
        if *expected < 20.0 {
            few = [few[0] + count, few[1] + expected];
        } else {
            sum += (count - expected).powi(2) / expected;
            cells += 1.0;
        }
    }
    if few[1] > 5.0 {
        sum += (few[0] - few[1]).powi(2) / few[1];
        cells += 1.0;
    }
    (sum, cells - 1.0)
}

/// Points of each light's surface, evenly spread by area in patches: by their centres and areas. Only for the forms below.
fn assert_counts(
    name: &str,
    lights: &Lights,
    patches: &[(u32, Vec3, f32)],
    cell_of: impl Fn(u32, Vec3) -> usize,
) {
    const N: u32 = 100_000;
    for (p, n) in VIEWS {
        let (mut counts, mut expected) = (vec![0.0; 64], vec![0.0; 64]);
        for &(light, y, area) in patches {
            expected[cell_of(light, y)] +=
                f64::from(lights.pdf_surface(light, p, n, y) * area) * f64::from(N);
        }
        let mut random = 1_u32;
        let mut next = || {
            random = hash::mix(random.wrapping_add(0x9e37_79b9));
            hash::unit(random)
        };
        for _ in 0..N {
            let sample = lights.sample(p, n, next(), [next(), next()]);
            if let Some(LightSample { light, at: LightPoint::Surface { position, .. }, .. }) = sample {
                counts[cell_of(light, position)] += 1.0;
            }
        }
        let (chi2, freedom) = chi2(&counts, &expected);
        // Normal by Wilson and Hilferty: 4σ.
        let limit = freedom * (1.0 - 2.0 / (9.0 * freedom) + 4.0 * (2.0 / (9.0 * freedom)).sqrt()).powi(3);
        assert!(freedom < 1.0 || chi2 < limit, "{name} from {p}: χ² = {chi2}, {freedom} degrees");
    }
}

#[test]
fn flat_lights_are_chosen_as_their_densities_say() {
    // A triangle cut into 24 × 24 small ones, by their middles; cells are 8 × 8.
    const FINE: u32 = 24;
    let (a, b) = (POINTS[1] - POINTS[0], POINTS[2] - POINTS[0]);
    let area = 0.5 * a.cross(b).length() / (FINE * FINE) as f32;
    let mut patches = Vec::new();
    for i in 0..FINE {
        for j in 0..FINE - i {
            let at = |x: f32, y: f32| POINTS[0] + (a * (i as f32 + x) + b * (j as f32 + y)) / FINE as f32;
            patches.push((0, at(1.0 / 3.0, 1.0 / 3.0), area));
            if i + j + 1 < FINE {
                patches.push((0, at(2.0 / 3.0, 2.0 / 3.0), area));
            }
        }
    }
    let gram = [a.length_squared(), a.dot(b), b.length_squared()];
    let det = gram[0] * gram[2] - gram[1] * gram[1];
    let cell_of = |_, y: Vec3| {
        let v = y - POINTS[0];
        let (va, vb) = (v.dot(a), v.dot(b));
        let x = (va * gram[2] - vb * gram[1]) / det;
        let z = (vb * gram[0] - va * gram[1]) / det;
        let [i, j] = [x, z].map(|s| (s * 8.0).clamp(0.0, 7.0) as usize);
        i * 8 + j
    };
    let lights = Lights::new(&[], &[emitter(EmitterForm::Triangle { points: POINTS }, true)]);
    assert_counts("triangle", &lights, &patches, cell_of);
}

/// Directions all over a ball by patches, with the solid angle of one.
fn directions() -> impl Iterator<Item = (Vec3, f32)> {
    const FINE: [u32; 2] = [240, 360];
    let all = (0..FINE[0]).flat_map(|i| (0..FINE[1]).map(move |j| (i, j)));
    all.map(|(i, j)| {
        let z = 2.0 * (i as f32 + 0.5) / FINE[0] as f32 - 1.0;
        let ground = (1.0 - z * z).sqrt();
        let (sin, cos) = (std::f32::consts::TAU * (j as f32 + 0.5) / FINE[1] as f32).sin_cos();
        let solid_angle = 4.0 * PI / (FINE[0] * FINE[1]) as f32;
        (Vec3::new(ground * cos, ground * sin, z), solid_angle)
    })
}

#[test]
fn round_lights_and_boxes_are_chosen_as_their_densities_say() {
    let unit = Transform::from_place(
        Vec3::new(0.1, 0.2, 0.0),
        Vec3::new(20.0, 50.0, -30.0),
        Vec3::new(0.5, 0.2, 0.8),
    );
    let stretch = |s: Vec3| {
        let covector = unit.object_from_world.matrix3.transpose() * s;
        unit.world_from_object.matrix3.determinant() * covector.length()
    };
    let round = |s: Vec3| {
        let [i, j] = [s.x, s.y].map(|v| ((v * 0.5 + 0.5) * 5.0).clamp(0.0, 4.0) as usize);
        i * 5 + j + 25 * usize::from(s.z > 0.0)
    };
    // The back is never chosen: `pdf_surface` is asked for what is seen alone.
    let center = Vec3::new(0.1, 0.0, -0.1);
    let ball: Vec<_> = directions().step_by(1).map(|(s, w)| (0, center + s * 0.4, w * 0.16)).collect();
    assert_counts("ball", &of_form(EmitterForm::Sphere { center, radius: 0.4 }), &ball, |_, y| {
        round((y - center) / 0.4)
    });
    let stretched: Vec<_> =
        directions().step_by(1).map(|(s, w)| (0, unit.point(s), w * stretch(s))).collect();
    assert_counts("ellipsoid", &of_form(EmitterForm::Ellipsoid { unit }), &stretched, |_, y| {
        round(unit.object_from_world.transform_point3(y))
    });
}

#[test]
fn the_faces_of_a_box_are_chosen_by_their_area_and_evenly() {
    let unit = Transform::from_place(Vec3::new(0.1, 0.2, 0.0), Vec3::ZERO, Vec3::new(0.5, 0.2, 0.8));
    let lights = of_form(EmitterForm::Box { unit });
    // Below, beside and in front: three faces of areas 0.64, 1.6 and 0.4.
    let p = Vec3::new(3.0, -2.0, 4.0);
    let (mut counts, mut sums) = ([0.0; 3], [Vec3::ZERO; 3]);
    const N: u32 = 1 << 15;
    for i in 0..N {
        let (choice, u) = numbers(i, 1);
        let sample = lights.sample(p, None, choice, u).unwrap();
        assert!((sample.pdf - 1.0 / 2.64).abs() < 1e-5);
        let LightPoint::Surface { position, n, .. } = sample.at else { panic!("a box has a surface") };
        let face = n.abs().max_position();
        assert!(n.dot(p - position) > 0.0 && (n[face].abs() - 1.0).abs() < 1e-5);
        counts[face] += 1.0 / f64::from(N);
        sums[face] += unit.object_from_world.transform_point3(position);
    }
    for (face, share) in [0.64 / 2.64, 1.6 / 2.64, 0.4 / 2.64].into_iter().enumerate() {
        assert!((counts[face] - share).abs() < 1e-3, "{counts:?}");
        let mean = sums[face] / (counts[face] as f32 * N as f32);
        for k in (0..3).filter(|&k| k != face) {
            assert!(mean[k].abs() < 0.01, "{mean}");
        }
    }
}

/// A panorama with dark parts and a bright spot.
fn place() -> Arc<RadianceMap> {
    map([32, 16], |x, y| match (x, y) {
        (20, 5) => 300.0,
        (0, _) | (31, _) => 4.0,
        (_, 12..) => 0.0,
        _ => 0.5,
    })
}

fn distant_lights() -> Vec<(&'static str, Lights)> {
    let place = || Emission::Environment { map: place(), turn: 1.0 };
    let to_sun = Vec3::new(0.5, 0.4, -0.6).normalize();
    let sky = |sun| Emission::Sky { to_sun, turbidity: 3.0, sun };
    vec![
        ("panorama", of_lamp(place())),
        ("everywhere", of_lamp(Emission::Everywhere)),
        ("sky", of_lamp(sky(false))),
        ("sky with sun", of_lamp(sky(true))),
        (
            "mixture",
            Lights::new(&[place(), Emission::Everywhere, sky(true)].map(|e| lamp(e, Rgb::WHITE)), &[]),
        ),
        (
            "with a lamp",
            Lights::new(
                &[place(), Emission::Point { position: Vec3::Y }].map(|emission| lamp(emission, Rgb::WHITE)),
                &[],
            ),
        ),
    ]
}

#[test]
fn directions_are_chosen_as_their_densities_say() {
    const N: u32 = 200_000;
    for (name, lights) in distant_lights() {
        for (p, n) in VIEWS {
            let axis = Vec3::new(0.2, 0.3, 0.9).normalize();
            let (mut counts, mut expected) = (vec![0.0; 96], vec![0.0; 96]);
            for (toward, solid_angle) in directions() {
                // The sun is smaller than the patches: its part is counted apart.
                let pdf = lights.pdf_distant(p, n, toward);
                let pdf = if pdf > 1000.0 { 0.0 } else { pdf };
                expected[cell(toward, axis)] += f64::from(pdf * solid_angle) * f64::from(N);
            }
            let mut sun = 0.0;
            let mut random = 5_u32;
            let mut next = || {
                random = hash::mix(random.wrapping_add(0x9e37_79b9));
                hash::unit(random)
            };
            let mut missed = 0.0;
            for _ in 0..N {
                match lights.sample(p, n, next(), [next(), next()]) {
                    Some(LightSample { at: LightPoint::Distant { toward }, pdf, .. }) => {
                        assert!((toward.length() - 1.0).abs() < 1e-5);
                        let said = lights.pdf_distant(p, n, toward);
                        assert!((pdf - said).abs() <= 1e-5 * pdf, "{name}: {pdf} against {said}");
                        if pdf > 1000.0 { sun += 1.0 } else { counts[cell(toward, axis)] += 1.0 }
                    }
                    _ => missed += 1.0,
                }
            }
            let (chi2, freedom) = chi2(&counts, &expected);
            let limit =
                freedom * (1.0 - 2.0 / (9.0 * freedom) + 4.5 * (2.0 / (9.0 * freedom)).sqrt()).powi(3);
            assert!(chi2 < limit, "{name} from {p}: χ² = {chi2}, {freedom} degrees, {sun} of the sun");
            let whole = expected.iter().sum::<f64>() + sun + missed;
            assert!((whole / f64::from(N) - 1.0).abs() < 0.005, "{name}: {whole}");
        }
    }
}

#[test]
fn nothing_bright_of_a_panorama_is_missed() {
    // The mean of radiance over density is the same for samples of the panorama and for even ones: ∫ L dω.
    let lights = of_lamp(Emission::Environment { map: place(), turn: 1.0 });
    let even: f64 =
        directions().map(|(toward, w)| f64::from(lights.le_distant(toward).luminance() * w)).sum();
    let (mut sum, mut largest, n) = (0.0, 0.0_f64, 1 << 16);
    for i in 0..n {
        let (choice, u) = numbers(i, 2);
        let sample = lights.sample(Vec3::ZERO, None, choice, u).unwrap();
        let each = f64::from(sample.le.luminance() / sample.pdf);
        (sum, largest) = (sum + each, largest.max(each));
    }
    assert!((sum / f64::from(n) / even - 1.0).abs() < 2e-3, "{} against {even}", sum / f64::from(n));
    // No sample is much brighter than the mean: no fireflies where a bright texel's light spreads into a dark one.
    assert!(largest < 2.0 * even, "{largest} against {even}");
}
