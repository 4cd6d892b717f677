//! Places and numbers at the edge: nothing is ever no number, and what does not shine is not chosen.

use super::*;

fn all_kinds() -> Vec<Lights> {
    let position = Vec3::new(0.0, 1.0, 0.0);
    let unit = Transform::from_place(position, Vec3::new(10.0, 20.0, 30.0), Vec3::new(0.5, 0.3, 0.7));
    let forms = [
        EmitterForm::Sphere { center: position, radius: 0.5 },
        EmitterForm::Ellipsoid { unit },
        EmitterForm::Box { unit },
        EmitterForm::Disc { unit, n: Vec3::Y },
        EmitterForm::Triangle { points: [position, position + Vec3::X, position + Vec3::Z] },
    ];
    let emissions = [
        Emission::Point { position },
        Emission::Sphere { position, radius: 0.1 },
        Emission::Disc { position, radius: 0.1 },
        Emission::Direction { travels: Vec3::NEG_Y },
        Emission::Everywhere,
        Emission::Environment { map: map([4, 2], |x, _| x as f32), turn: 0.0 },
        Emission::Sky { to_sun: Vec3::Y, turbidity: 2.0, sun: true },
    ];
    let mut kinds: Vec<Lights> = forms.iter().map(|&form| of_form(form)).collect();
    kinds.extend(emissions.iter().cloned().map(of_lamp));
    let lamps = emissions.map(|emission| lamp(emission, Rgb::WHITE));
    kinds.push(Lights::new(&lamps, &forms.map(|form| emitter(form, true))));
    kinds.push(Lights::new(&[], &forms.map(|form| emitter(form, true)).repeat(5)));
    kinds
}

#[test]
fn no_place_gives_anything_that_is_no_number() {
    let directions = [Vec3::ZERO, Vec3::Y, Vec3::new(1.0, -1.0, 1.0).normalize()];
    let places = directions.into_iter().flat_map(|direction| {
        [0.0, 1e-30, 1e-7, 0.1, 0.3, 0.5, 0.500_000_06, 0.7, 1.0, 1e6, 1e12]
            .map(|far| Vec3::new(0.0, 1.0, 0.0) + direction * far)
    });
    let edges = [0.0, 0.5, 0.999_999_94];
    for (kind, lights) in all_kinds().iter().enumerate() {
        for (p, n) in places.clone().flat_map(|p| [None, Some(Vec3::Y), Some(Vec3::NEG_X)].map(|n| (p, n))) {
            for [choice, u, v] in edges.into_iter().flat_map(|a| edges.map(|b| [a, b, 0.3])) {
                let Some(sample) = lights.sample(p, n, choice, [u, v]) else { continue };
                assert!(sample.pdf > 0.0 && sample.pdf.is_finite(), "kind {kind} from {p}: {sample:?}");
                assert!(sample.le.is_finite() && sample.le.luminance() > 0.0 || sample.light == DISTANT);
                let again = match sample.at {
                    LightPoint::Surface { position, n: side, .. } => {
                        assert!(position.is_finite() && (side.length() - 1.0).abs() < 1e-4);
                        assert!(side.dot(p - position) >= 0.0);
                        lights.pdf_surface(sample.light, p, n, position)
                    }
                    LightPoint::Distant { toward } => {
                        assert!(toward.is_finite());
                        lights.pdf_distant(p, n, toward)
                    }
                    LightPoint::Point { .. } => sample.pdf,
                };
                assert!(again >= 0.0 && again.is_finite(), "kind {kind} from {p}: {again}");
            }
        }
    }
}

#[test]
fn what_does_not_shine_is_not_there() {
    let position = Vec3::ONE;
    let black = map([8, 4], |_, _| 0.0);
    let lamps = [
        lamp(Emission::Point { position }, Rgb::BLACK),
        lamp(Emission::Everywhere, Rgb::BLACK),
        lamp(Emission::Environment { map: black, turn: 0.0 }, Rgb::WHITE),
        lamp(Emission::Direction { travels: Vec3::NEG_Y }, Rgb::BLACK),
    ];
    let nothing = EmitterForm::Triangle { points: [Vec3::ZERO, Vec3::X, Vec3::X * 2.0] };
    let dark = Emitter {
        radiance: Rgb::BLACK,
        ..emitter(EmitterForm::Sphere { center: position, radius: 1.0 }, false)
    };
    let lights = Lights::new(&lamps, &[emitter(nothing, true), dark]);
    assert!(lights.is_empty());
    assert!(lights.sample(Vec3::ZERO, None, 0.5, [0.5; 2]).is_none());
    assert_eq!(lights.pdf_distant(Vec3::ZERO, None, Vec3::Y), 0.0);
    assert_eq!(lights.pdf_surface(0, Vec3::ZERO, None, Vec3::Y), 0.0);
    assert_eq!(lights.le_distant(Vec3::Y), Rgb::BLACK);
    // Beside one that shines, it is never chosen.
    let [point, ..] = lamps;
    let bright = lamp(Emission::Point { position: Vec3::Y }, Rgb::WHITE);
    let lights = Lights::new(&[point, bright], &[]);
    let sample = lights.sample(Vec3::ZERO, None, 0.99, [0.5; 2]).unwrap();
    assert_eq!((sample.at, sample.pdf), (LightPoint::Point { position: Vec3::Y }, 1.0));
}

#[test]
fn lights_behind_a_surface_are_not_chosen() {
    let at = |y: f32| EmitterForm::Sphere { center: Vec3::Y * y, radius: 0.5 };
    let lights = Lights::new(&[], &[emitter(at(2.0), false), emitter(at(-2.0), false)]);
    for i in 0..200 {
        let (choice, u) = numbers(i, 6);
        assert_eq!(lights.sample(Vec3::ZERO, Some(Vec3::Y), choice, u).unwrap().light, 0);
    }
    // One that stands half above the horizon is.
    let lights = Lights::new(&[], &[emitter(at(2.0), false), emitter(at(0.4), false)]);
    let p = Vec3::new(0.0, 0.5, 1.0);
    assert!((0..200).any(|i| {
        let (choice, u) = numbers(i, 6);
        lights.sample(p, Some(Vec3::Y), choice, u).is_some_and(|sample| sample.light == 1)
    }));
}

#[test]
fn a_far_light_and_a_sky_each_get_a_share() {
    let lamps = [Emission::Point { position: Vec3::Y * 100.0 }, Emission::Everywhere];
    let lights = Lights::new(&lamps.map(|emission| lamp(emission, Rgb::WHITE)), &[]);
    let of_sky = lights.pdf_distant(Vec3::ZERO, None, Vec3::X) * 4.0 * PI;
    assert!((0.89..0.91).contains(&of_sky), "{of_sky}");
}
