//! Scattering held against what must be true of any surface: energy, reciprocity, densities, finite numbers.

use super::*;
use vitrine_math::hash;

/// Pairs of numbers in [0, 1), evenly spread and scrambled.
fn numbers(n: u32, seed: u32) -> impl Iterator<Item = (f32, [f32; 2])> {
    (0..n).map(move |i| {
        let h = hash::join(hash::mix(seed), i);
        let a = hash::unit(h);
        let u = [(i as f32 + hash::unit(hash::mix(h ^ 1))) / n as f32, hash::unit(hash::mix(h ^ 2))];
        (a, u)
    })
}

fn direction(cos: f32, turn: f32) -> Vec3 {
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    Vec3::new(sin * turn.cos(), sin * turn.sin(), cos)
}

/// All light that comes back to `wo` of light of radiance 1 all around (η² in the medium below), by sampling.
fn furnace(surface: &Surface, cos: f32) -> [f64; 3] {
    const N: u32 = 20_000;
    let wo = direction(cos, 0.7);
    let bsdf = Bsdf::new(surface, cos);
    let mut sum = [0.0_f64; 3];
    for (u_lobe, u) in numbers(N, 5) {
        if let Some(s) = bsdf.sample(wo, u_lobe, u) {
            let below = if s.event.is_transmission && !surface.thin_walled { surface.eta * surface.eta } else { 1.0 };
            for (total, w) in sum.iter_mut().zip(s.weight.to_array()) {
                *total += f64::from(w * below) / f64::from(N);
            }
        }
    }
    sum
}

#[test]
fn print_furnace() {
    let white = Surface { base_color: Rgb::WHITE, ..Surface::default() };
    let list: Vec<(&str, Surface)> = vec![
        ("lambert", Surface { specular_weight: 0.0, ..white }),
        ("eon", Surface { specular_weight: 0.0, diffuse_roughness: 1.0, ..white }),
        ("plastic", white),
        ("smooth plastic", Surface { roughness: 0.0, ..white }),
        ("eon plastic", Surface { diffuse_roughness: 1.0, ..white }),
        ("metal .3", Surface { metalness: 1.0, ..white }),
        ("metal 1", Surface { metalness: 1.0, roughness: 1.0, ..white }),
        ("glass", Surface { transmission: 1.0, roughness: 0.0, ..white }),
        ("glass out", Surface { transmission: 1.0, roughness: 0.0, eta: 1.0 / 1.5, ..white }),
        ("glass .1", Surface { transmission: 1.0, roughness: 0.1, ..white }),
        ("glass .3", Surface { transmission: 1.0, ..white }),
        ("glass .6", Surface { transmission: 1.0, roughness: 0.6, ..white }),
        ("glass 1", Surface { transmission: 1.0, roughness: 1.0, ..white }),
        ("glass .3 out", Surface { transmission: 1.0, eta: 1.0 / 1.5, ..white }),
        ("glass .6 out", Surface { transmission: 1.0, roughness: 0.6, eta: 1.0 / 1.5, ..white }),
        ("glass 1 out", Surface { transmission: 1.0, roughness: 1.0, eta: 1.0 / 1.5, ..white }),
        ("pane", Surface { transmission: 1.0, roughness: 0.0, thin_walled: true, ..white }),
        ("pane .5", Surface { transmission: 1.0, roughness: 0.5, thin_walled: true, ..white }),
        ("soap", Surface { transmission: 1.0, roughness: 0.0, thin_walled: true, thin_film_weight: 1.0, thin_film_ior: 1.5, ..white }),
        ("film glass", Surface { transmission: 1.0, roughness: 0.0, thin_film_weight: 1.0, ..white }),
        ("film plastic", Surface { thin_film_weight: 1.0, ..white }),
        ("coated plastic", Surface { coat_weight: 1.0, ..white }),
        ("rough coated plastic", Surface { coat_weight: 1.0, coat_roughness: 0.5, ..white }),
        ("coated metal", Surface { metalness: 1.0, coat_weight: 1.0, ..white }),
        ("coated metal .7", Surface { metalness: 1.0, roughness: 0.7, coat_weight: 1.0, ..white }),
        ("coated mirror", Surface { metalness: 1.0, roughness: 0.0, coat_weight: 1.0, ..white }),
        ("coated glass", Surface { transmission: 1.0, roughness: 0.0, coat_weight: 1.0, ..white }),
        ("coated rough glass", Surface { transmission: 1.0, roughness: 0.4, coat_weight: 1.0, ..white }),
        ("rough coat mirror", Surface { metalness: 1.0, roughness: 0.0, coat_weight: 1.0, coat_roughness: 0.3, ..white }),
        ("mix", Surface { metalness: 0.3, transmission: 0.5, roughness: 0.4, coat_weight: 0.5, ..white }),
    ];
    for (name, s) in list {
        print!("{name:22}");
        for cos in [1.0, 0.8, 0.5, 0.2, 0.05] {
            let f = furnace(&s, cos);
            print!(" {:.4}", f[1]);
        }
        println!();
    }
}
