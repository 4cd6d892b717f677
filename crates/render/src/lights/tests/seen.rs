//! What rays see of lights: lamps, the sky, panoramas.

use super::*;

#[test]
fn a_panorama_is_seen_as_its_description_says() {
    // The top row is towards +Y, the middle column towards −Z, three quarters of the width towards +X.
    let seen = |x: u32, y: u32, turn: f32, toward: Vec3| {
        let map = map([16, 9], |column, row| if (column, row) == (x, y) { 1.0 } else { 0.0 });
        of_lamp(Emission::Environment { map, turn }).le_distant(toward.normalize()).r
    };
    let half = PI / 16.0;
    let beside = |x: f32| Vec3::new(x.sin(), 0.0, -x.cos());
    assert!((seen(8, 4, 0.0, beside(half)) - 1.0).abs() < 1e-4);
    assert!((seen(8, 4, 0.0, Vec3::NEG_Z) - 0.5).abs() < 1e-4, "between two texels");
    assert!((seen(12, 4, 0.0, beside(PI / 2.0 + half)) - 1.0).abs() < 1e-4);
    assert!((seen(0, 4, 0.0, beside(-PI + half)) - 1.0).abs() < 1e-4);
    assert!((seen(0, 4, 0.0, Vec3::Z) - 0.5).abs() < 1e-4, "where the picture's sides meet");
    assert!(
        seen(3, 0, 0.0, Vec3::Y) >= 0.0
            && (seen(8, 0, 0.0, beside(half) * 1e-3 + Vec3::Y) - 1.0).abs() < 1e-3
    );
    // More than 0 takes −Z towards −X.
    assert!((seen(8, 4, PI / 2.0, Vec3::NEG_X + Vec3::NEG_Z * half.tan()) - 1.0).abs() < 1e-3);
    // What is chosen is what is bright.
    let map = map([16, 9], |column, row| if (column, row) == (8, 4) { 1.0 } else { 0.0 });
    let lights = of_lamp(Emission::Environment { map, turn: 1.0 });
    for i in 0..100 {
        let (choice, u) = numbers(i, 1);
        let LightSample { at: LightPoint::Distant { toward }, .. } =
            lights.sample(Vec3::ZERO, None, choice, u).unwrap()
        else {
            panic!("a panorama is distant")
        };
        assert!(toward.distance(beside(half - 1.0)) < 0.7);
    }
}

fn sky(elevation_deg: f32, turbidity: f32, sun: bool) -> Lights {
    let (up, ahead) = elevation_deg.to_radians().sin_cos();
    of_lamp(Emission::Sky { to_sun: Vec3::new(0.0, up, -ahead), turbidity, sun })
}

#[test]
fn the_default_sky_lights_a_level_white_surface_fully() {
    let found = irradiance(&sky(45.0, 3.0, true), Vec3::ZERO, Vec3::Y, true) / PI64;
    assert!((found - 1.0).abs() < 0.02, "{found}");
    // About a third of it comes from the sky itself: 29 of 86 kilolux, as the model says for this height and haze.
    let of_sky = irradiance(&sky(45.0, 3.0, false), Vec3::ZERO, Vec3::Y, true) / PI64;
    assert!((0.3..0.37).contains(&of_sky), "{of_sky}");
}

#[test]
fn the_sky_is_blue_and_a_low_sun_red() {
    let high = sky(45.0, 3.0, true);
    let zenith = high.le_distant(Vec3::Y);
    assert!(zenith.b > 1.3 * zenith.r, "{zenith:?}");
    let sun = |elevation: f32| {
        let (up, ahead) = elevation.to_radians().sin_cos();
        sky(elevation, 3.0, true).le_distant(Vec3::new(0.0, up, -ahead))
    };
    let (noon, evening) = (sun(60.0), sun(3.0));
    assert!(noon.luminance() > 1000.0 * zenith.luminance());
    assert!(evening.r / evening.b > 3.0 * noon.r / noon.b, "{noon:?}, {evening:?}");
    assert!(evening.luminance() < 0.3 * noon.luminance());
    // Brighter near the sun and at the horizon than at right angles to the sun.
    let no_sun = sky(45.0, 3.0, false);
    let at = |x: f32, y: f32, z: f32| no_sun.le_distant(Vec3::new(x, y, z).normalize()).luminance();
    assert!(at(0.0, 1.0, -0.9) > 2.0 * at(0.0, 1.0, 1.0));
    assert!(at(0.0, 0.02, 1.0) > at(0.0, 1.0, 1.0));
}

#[test]
fn skies_of_all_heights_and_hazes_are_numbers_and_go_dark_smoothly() {
    for turbidity in [2.0, 3.0, 6.0, 10.0] {
        let mut before = f64::INFINITY;
        for elevation in [90.0, 45.0, 20.0, 10.0, 5.0, 1.0, 0.2, -0.5, -2.0, -5.0] {
            let lights = sky(elevation, turbidity, true);
            for i in -20..=20 {
                let le = lights.le_distant(Vec3::new(0.3, i as f32 / 20.0, -0.5).normalize());
                assert!(le.is_finite() && le.r >= 0.0 && le.g >= 0.0 && le.b >= 0.0, "{elevation}: {le:?}");
            }
            let level = irradiance(&lights, Vec3::ZERO, Vec3::Y, true);
            assert!(level > 0.0 && level < before * 1.01, "{turbidity}, {elevation}: {level}, {before}");
            before = level;
        }
    }
}

#[test]
fn lamps_are_met_where_they_are() {
    let ball = Emission::Sphere { position: Vec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    let disc = Emission::Disc { position: Vec3::new(0.0, 3.0, 0.0), radius: 0.5 };
    let lights = Lights::new(&[ball, disc].map(|emission| lamp(emission, Rgb::WHITE)), &[]);
    let meet = |origin, direction, t_max| lights.intersect(&Ray::new(origin, direction), t_max);
    let hit = meet(Vec3::ZERO, Vec3::NEG_Z * 2.0, f32::INFINITY).unwrap();
    assert!((hit.t - 2.0).abs() < 1e-6 && hit.light == 0 && (hit.n - Vec3::Z).length() < 1e-6);
    assert!((hit.y - Vec3::new(0.0, 0.0, -4.0)).length() < 1e-6);
    assert!(meet(Vec3::ZERO, Vec3::NEG_Z, 3.9).is_none());
    assert!(meet(Vec3::new(0.0, 0.0, -5.5), Vec3::NEG_Z, 9.0).is_none(), "from inside");
    assert!(meet(Vec3::ZERO, Vec3::Z, 9.0).is_none() && meet(Vec3::Y * 1.01, Vec3::NEG_Z, 9.0).is_none());
    let hit = meet(Vec3::X * 0.4, Vec3::Y, 9.0).unwrap();
    assert_eq!((hit.t, hit.light, hit.n), (3.0, 1, Vec3::NEG_Y));
    assert_eq!(meet(Vec3::Y * 4.0, Vec3::NEG_Y, 9.0).unwrap().n, Vec3::Y);
    assert!(meet(Vec3::X * 0.51, Vec3::Y, 9.0).is_none() && meet(Vec3::Y * 3.0, Vec3::X, 9.0).is_none());
    // A lamp shines with what it is seen with.
    assert_eq!(lights.le_surface(0, true), Rgb::splat(4.0));
    assert_eq!(lights.le_surface(1, false), Rgb::splat(16.0));
}

#[test]
fn many_lamps_are_met_as_one_by_one() {
    let number = |i: u32| 2.0 * hash::unit(hash::mix(i)) - 1.0;
    let at = |i: u32| Vec3::new(number(i), number(i + 1), number(i + 2));
    let specs: Vec<LampSpec> = (0..200)
        .map(|i| {
            let (position, radius) = (at(10 * i) * 5.0, 0.3 + 0.2 * number(10 * i + 4));
            let is_ball = i % 2 == 0;
            let ball = Emission::Sphere { position, radius };
            lamp(if is_ball { ball } else { Emission::Disc { position, radius } }, Rgb::WHITE)
        })
        .collect();
    let lights = Lights::new(&specs, &[]);
    let singles: Vec<Lights> =
        specs.iter().map(|spec| Lights::new(std::slice::from_ref(spec), &[])).collect();
    let mut hits = 0;
    for i in 0..2000 {
        let direction = if i % 10 == 0 { Vec3::NEG_Y } else { at(7000 + 6 * i + 3) };
        let ray = Ray::new(at(7000 + 6 * i) * 6.0, direction);
        let each = (0..)
            .zip(&singles)
            .filter_map(|(light, single)| single.intersect(&ray, 20.0).map(|hit| LampHit { light, ..hit }));
        let nearest = each.min_by(|a, b| a.t.total_cmp(&b.t));
        assert_eq!(lights.intersect(&ray, 20.0), nearest);
        hits += u32::from(nearest.is_some());
    }
    assert!((200..1900).contains(&hits), "{hits}");
}
