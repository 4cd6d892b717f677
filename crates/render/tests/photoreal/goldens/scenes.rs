//! The scenes of the stored pictures: between them they meet everything that the photoreal renderer does.

use crate::common::{
    Material, Object, Rgb, Shape, Shot, Vec3, ball, bulb, clear, cuboid, disc, glowing, plane, solid, tinted,
    v, white,
};
use crate::panes::prism;
use vitrine_scene::lights::Sky;
use vitrine_scene::textures::Checker;
use vitrine_scene::{LightSource, Metal, Renderer, TextureSource};

/// The pictures' size.
pub const SIZE: [u32; 2] = [32, 24];

/// Makes a scene.
type Make = fn() -> Shot;

/// Their names, and how they are made.
pub const SCENES: [(&str, Make); 8] = [
    ("pane", pane),
    ("ball", glass_ball),
    ("case", case),
    ("cornell", cornell),
    ("tank", tank),
    ("prism", rainbow),
    ("milk", milk),
    ("still-life", still_life),
];

/// The scene of that name.
pub fn find(name: &str) -> Shot {
    let make = SCENES.iter().find(|(n, _)| *n == name).expect("there is such a scene").1;
    make()
}

fn shot(position: Vec3, look_at: Vec3) -> Shot {
    let mut shot = Shot::new(SIZE, position, look_at);
    shot.scene.settings.renderer = Renderer::Photoreal;
    shot.scene.camera.view_angle_deg = 40.0;
    shot
}

fn put_at(shot: &mut Shot, shape: Shape, material: Material, position: Vec3) -> &mut Object {
    let object = shot.put(shape, material);
    object.position = position;
    object
}

fn colored(color: Rgb) -> Material {
    Material { base_color: Some(color), ..white(0.5) }
}

/// A white ball behind a tinted pane and two clear ones, seen at a slant.
fn pane() -> Shot {
    let mut shot = shot(v(1.9, 0.7, 1.6), v(0.0, 0.35, 0.0));
    shot.put(plane(), white(0.6));
    put_at(&mut shot, ball(0.3), colored(Rgb::new(0.8, 0.5, 0.3)), v(-0.2, 0.35, -0.1));
    let tint = tinted(1.5, Rgb::new(0.6, 0.9, 0.8), 0.04);
    put_at(&mut shot, cuboid(v(1.6, 1.0, 0.04)), tint, v(0.0, 0.52, 0.3));
    for z in [0.4, 0.5] {
        put_at(&mut shot, cuboid(v(1.8, 1.0, 0.03)), clear(1.6), v(0.0, 0.52, z));
    }
    bulb(&mut shot, v(0.3, 1.6, 1.4), 0.2, 12.0);
    shot.ambient(0.1);
    shot
}

/// A ball of glass and what it gathers on the floor.
fn glass_ball() -> Shot {
    let mut shot = shot(v(0.4, 1.3, 2.4), v(0.0, 0.3, 0.0));
    shot.put(plane(), white(0.6));
    put_at(&mut shot, ball(0.4), clear(1.5), v(0.0, 0.5, 0.0));
    put_at(&mut shot, ball(0.15), colored(Rgb::new(0.7, 0.2, 0.1)), v(-0.6, 0.15, -0.3));
    bulb(&mut shot, v(0.9, 1.7, -0.6), 0.15, 15.0);
    shot.ambient(0.15);
    shot
}

/// Things under a hood of glass.
fn case() -> Shot {
    let mut shot = shot(v(1.2, 1.1, 2.2), v(0.0, 0.4, 0.0));
    shot.put(plane(), colored(Rgb::new(0.4, 0.35, 0.3)));
    put_at(&mut shot, cuboid(v(1.0, 0.9, 1.0)), clear(1.5), v(0.0, 0.46, 0.0));
    put_at(&mut shot, cuboid(v(0.96, 0.86, 0.96)), clear(1.0), v(0.0, 0.45, 0.0));
    let gold = Material {
        metal: Some(Metal::Gold),
        base_metalness: Some(1.0),
        specular_roughness: Some(0.3),
        ..Material::default()
    };
    put_at(&mut shot, ball(0.2), gold, v(0.1, 0.3, 0.1));
    put_at(&mut shot, cuboid(v(0.5, 0.06, 0.5)), white(0.7), v(0.0, 0.06, 0.0));
    shot.sun(v(-0.5, -0.8, -0.3), 0.8);
    shot.ambient(0.2);
    shot
}

/// A room with red and green walls, where all light is reflected many times.
fn cornell() -> Shot {
    let mut shot = shot(v(0.0, 0.5, 1.9), v(0.0, 0.5, 0.0));
    let walls = [
        (v(0.0, 0.0, 0.0), v(0.0, 0.0, 0.0), Rgb::splat(0.7)),
        (v(0.0, 1.0, 0.0), v(180.0, 0.0, 0.0), Rgb::splat(0.7)),
        (v(0.0, 0.0, -0.5), v(90.0, 0.0, 0.0), Rgb::splat(0.7)),
        (v(0.0, 0.0, 2.0), v(-90.0, 0.0, 0.0), Rgb::splat(0.4)),
        (v(-0.6, 0.0, 0.0), v(0.0, 0.0, -90.0), Rgb::new(0.6, 0.06, 0.05)),
        (v(0.6, 0.0, 0.0), v(0.0, 0.0, 90.0), Rgb::new(0.12, 0.45, 0.1)),
    ];
    for (position, turn_deg, color) in walls {
        put_at(&mut shot, plane(), colored(color), position).turn_deg = turn_deg;
    }
    put_at(&mut shot, cuboid(v(0.3, 0.6, 0.3)), white(0.7), v(-0.2, 0.3, -0.1)).turn_deg = v(0.0, 20.0, 0.0);
    put_at(&mut shot, cuboid(v(0.3, 0.3, 0.3)), white(0.7), v(0.25, 0.15, 0.2)).turn_deg = v(0.0, -15.0, 0.0);
    put_at(&mut shot, disc(0.2), glowing(9.0), v(0.0, 0.995, 0.1)).turn_deg = v(180.0, 0.0, 0.0);
    shot
}

/// Water in glass, seen through both; a stone in it, a bubble and a sheet above.
fn tank() -> Shot {
    let mut shot = shot(v(0.7, 1.2, 2.3), v(0.0, 0.4, 0.0));
    shot.put(plane(), white(0.6));
    put_at(&mut shot, cuboid(v(1.4, 0.8, 0.8)), clear(1.5), v(0.0, 0.42, 0.0));
    put_at(&mut shot, cuboid(v(1.32, 0.76, 0.72)), clear(1.0), v(0.0, 0.46, 0.0));
    let water = tinted(1.333, Rgb::new(0.6, 0.85, 0.9), 0.8);
    put_at(&mut shot, cuboid(v(1.33, 0.6, 0.73)), water, v(0.0, 0.355, 0.0));
    put_at(&mut shot, ball(0.15), colored(Rgb::new(0.8, 0.3, 0.1)), v(-0.3, 0.25, 0.0));
    put_at(&mut shot, ball(0.08), clear(1.0), v(0.25, 0.4, 0.1));
    put_at(&mut shot, plane(), solid(white(0.2)), v(0.0, 0.0, -1.5)).turn_deg = v(90.0, 0.0, 0.0);
    bulb(&mut shot, v(0.4, 1.8, 0.6), 0.2, 10.0);
    shot.ambient(0.15);
    shot
}

/// Glass that splits light: a prism, which only chance gets through, and a ball.
fn rainbow() -> Shot {
    let mut shot = shot(v(0.2, 1.6, 2.4), v(0.0, 0.3, 0.0));
    shot.put(plane(), white(0.7));
    let flint = Material { transmission_dispersion_abbe_number: Some(15.0), ..clear(1.6) };
    let model = shot.model(prism(60.0));
    let object = put_at(&mut shot, model, flint.clone(), v(-0.4, 0.5, 0.0));
    (object.scale, object.turn_deg) = (v(0.4, 0.3, 0.4), v(0.0, 30.0, 80.0));
    put_at(&mut shot, ball(0.3), flint, v(0.5, 0.5, 0.0));
    bulb(&mut shot, v(0.3, 2.5, -0.5), 0.4, 8.0);
    shot.ambient(0.1);
    shot
}

/// A ball that scatters light inside, a rough pane, something coated, something with a thin film.
fn milk() -> Shot {
    let mut shot = shot(v(0.3, 1.0, 2.4), v(0.0, 0.35, 0.0));
    shot.put(plane(), white(0.6));
    let milk = Material {
        transmission_scatter: Some(Rgb::new(0.5, 0.7, 0.9)),
        transmission_scatter_anisotropy: Some(0.6),
        ..tinted(1.35, Rgb::new(0.5, 0.4, 0.3), 0.25)
    };
    put_at(&mut shot, ball(0.3), milk, v(-0.4, 0.32, 0.1));
    let frosted = Material { specular_roughness: Some(0.35), ..clear(1.5) };
    put_at(&mut shot, cuboid(v(0.9, 0.7, 0.05)), frosted, v(0.4, 0.37, -0.2));
    let coated = Material { coat_weight: Some(1.0), ..colored(Rgb::new(0.5, 0.1, 0.1)) };
    put_at(&mut shot, ball(0.15), coated, v(0.2, 0.15, 0.5));
    let film = Material {
        thin_film_weight: Some(1.0),
        specular_weight: Some(1.0),
        specular_roughness: Some(0.2),
        ..colored(Rgb::splat(0.1))
    };
    put_at(&mut shot, ball(0.15), film, v(0.6, 0.15, 0.4));
    bulb(&mut shot, v(0.6, 1.7, 0.8), 0.2, 10.0);
    shot.ambient(0.15);
    shot
}

/// Textured and metal things under the sky, seen by a lens.
fn still_life() -> Shot {
    let mut shot = shot(v(0.5, 0.9, 2.4), v(0.0, 0.3, 0.0));
    let checker = Checker { color: Rgb::new(0.7, 0.6, 0.4), other_color: Rgb::new(0.1, 0.15, 0.3) };
    let tiles = shot.texture(TextureSource::Checker(checker));
    shot.put(plane(), Material { texture: Some(tiles.clone()), ..white(0.6) });
    let metal = |metal: Metal, roughness: f32| Material {
        metal: Some(metal),
        base_metalness: Some(1.0),
        specular_roughness: Some(roughness),
        ..Material::default()
    };
    put_at(&mut shot, ball(0.3), metal(Metal::Copper, 0.25), v(-0.4, 0.3, 0.0));
    put_at(&mut shot, cuboid(v(0.4, 0.5, 0.4)), metal(Metal::Aluminium, 0.0), v(0.5, 0.25, -0.2)).turn_deg =
        v(0.0, 30.0, 0.0);
    let glossy = Material {
        specular_weight: Some(1.0),
        specular_roughness: Some(0.3),
        roughness_texture: Some(tiles),
        ..colored(Rgb::new(0.2, 0.5, 0.3))
    };
    put_at(&mut shot, ball(0.18), glossy, v(0.1, 0.18, 0.5));
    shot.light(LightSource::Sky(Sky { sun: false, ..Sky::default() }), 1.0);
    shot.scene.camera.f_stop = Some(1.4);
    shot
}
