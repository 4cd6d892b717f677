//! A scene in POV-Ray's language, so that both programs trace the same rays.
//!
//! POV-Ray is left-handed: every z changes its sign. Its surface adds a mirror image to what it scatters and keeps
//! highlights on transparent surfaces at full strength; the classic renderer mixes. So each factor is given here
//! as the share that it has in the classic blend C = α·((1 − r)·(ambient + k_d… + k_s…) + r·mirror) + (1 − α)·behind.

use std::fmt::Write;
use vitrine_math::{Rgb, Transform, Vec3};
use vitrine_scene::lights::Emission;
use vitrine_scene::{
    Assets, ClassicMaterial, Geometry, LightSource, Material, MeshPart, Object, Pattern, Renderer, Scene,
    TriangleMesh,
};

/// Translates a scene.
///
/// # Errors
/// What the translation does not know: balls, panoramas and skies that shine, textures other than squares on a plane, refraction, a model that is not among the assets.
pub fn translate(scene: &Scene, assets: &Assets) -> Result<String, String> {
    if scene.settings.renderer != Renderer::Classic {
        return Err("only the classic renderer has a counterpart".into());
    }
    let mut out = String::new();
    header(&mut out, scene);
    for light in scene.lights.iter().filter(|l| l.visible) {
        let emission = light.source.as_kind().emission(assets).ok_or("a light's file has not been loaded")?;
        let color = rgb(light.radiance());
        lamp(&mut out, &emission, &color, scene.settings.shadow_points)
            .map_err(|e| format!("light `{}`: {e}", light.name))?;
    }
    for object in scene.objects.iter().filter(|o| scene.is_seen(o)) {
        body(&mut out, scene, assets, object).map_err(|e| format!("object `{}`: {e}", object.name))?;
    }
    Ok(out)
}

/// What a number or a text is written into. Writing into a text cannot fail.
macro_rules! put {
    ($out:expr, $($format:tt)*) => { writeln!($out, $($format)*).expect("a text grows") };
}

fn header(out: &mut String, scene: &Scene) {
    let ambient = scene
        .lights
        .iter()
        .filter(|l| l.visible && matches!(l.source, LightSource::Ambient(_)))
        .fold(Rgb::BLACK, |sum, l| sum + l.radiance());
    put!(out, "#version 3.7;");
    put!(out, "global_settings {{");
    put!(out, "  assumed_gamma 1.0");
    put!(out, "  max_trace_level {}", trace_level(scene));
    put!(out, "  ambient_light {}", rgb(ambient));
    put!(out, "}}");
    put!(out, "background {{ color {} }}", rgb(scene.settings.background));

    let [width, height] = scene.settings.size.map(|n| n as f32);
    let up = 2.0 * (scene.camera.view_angle_deg.to_radians() / 2.0).tan();
    let rotation = scene.camera.rotation();
    put!(out, "camera {{");
    put!(out, "  perspective");
    put!(out, "  location {}", vector(scene.camera.position));
    put!(out, "  direction {}", vector(rotation * Vec3::NEG_Z));
    put!(out, "  up {}", vector(rotation * Vec3::Y * up));
    put!(out, "  right {}", vector(rotation * Vec3::X * (up * width / height)));
    put!(out, "}}");
}

/// How many rays in a row POV-Ray may trace: the camera ray and the mirror images. It does not count rays that go
/// straight on, but lets none through at level 1.
fn trace_level(scene: &Scene) -> u32 {
    (scene.settings.depth + 1).max(2)
}

fn lamp(out: &mut String, emission: &Emission, color: &str, shadow_points: u32) -> Result<(), String> {
    match emission {
        // In the header: POV-Ray has one such light.
        Emission::Everywhere => {}
        Emission::Point { position } => put!(out, "light_source {{ {}, {color} }}", vector(*position)),
        Emission::Direction { travels } => {
            put!(out, "light_source {{ {}, {color} parallel point_at 0 }}", vector(*travels * -1e4));
        }
        Emission::Disc { position, radius } => {
            let side = (shadow_points as f32).sqrt().round().max(1.0);
            let size = 2.0 * radius;
            put!(out, "light_source {{ {}, {color}", vector(*position));
            put!(
                out,
                "  area_light <{size}, 0, 0>, <0, 0, {size}>, {side}, {side} circular jitter area_illumination on }}"
            );
        }
        Emission::Sphere { .. } | Emission::Environment { .. } | Emission::Sky { .. } => {
            return Err("such a light is not translated".into());
        }
    }
    Ok(())
}

fn body(out: &mut String, scene: &Scene, assets: &Assets, object: &Object) -> Result<(), String> {
    let place = scene.world_from_object(object);
    let geometry = object.shape.as_kind().geometry(assets).ok_or("its model has not been loaded")?;
    let material = object.material.as_deref().and_then(|m| scene.material(m));
    let tiles = match material.and_then(|m| m.texture.as_deref()) {
        None => None,
        Some(texture) if matches!(geometry, Geometry::Plane) => Some(tiles(scene, assets, texture, &place)?),
        Some(_) => return Err("a texture on anything but a plane is not translated".into()),
    };
    let depth = scene.settings.depth;
    let is_flat = matches!(geometry, Geometry::Facets(_));
    match geometry {
        Geometry::Sphere { radius } => sphere(out, radius, &place),
        Geometry::Box { half } => cuboid(out, half, &place),
        Geometry::Plane => {
            let normal = place.normal(Vec3::Y);
            put!(out, "plane {{ {}, {}", vector(normal), normal.dot(place.point(Vec3::ZERO)));
        }
        Geometry::Disc { radius } => disc(out, radius, &place),
        Geometry::Triangle { points, .. } => {
            let [a, b, c] = points.map(|p| vector(place.point(p)));
            put!(out, "triangle {{ {a}, {b}, {c}");
        }
        Geometry::Mesh(mesh) | Geometry::Facets(mesh) => {
            let mesh = if is_flat {
                TriangleMesh { normals: Vec::new(), ..TriangleMesh::clone(&mesh) }.into()
            } else {
                mesh
            };
            for part in &mesh.parts {
                let own = part.material.and_then(|m| mesh.materials.get(m));
                if material.is_none() && own.is_some_and(|m| m.picture.is_some()) {
                    return Err("its model has a picture on it, which is not translated".into());
                }
                triangles(out, &mesh, part, &place);
                finish(out, material.or(own.map(|m| &m.material)), None, depth)?;
            }
            return Ok(());
        }
    }
    finish(out, material, tiles, depth)
}

/// Squares on a plane: their colours, and what takes the pattern to the plane.
struct Tiles {
    colors: [Rgb; 2],
    place: String,
}

fn tiles(scene: &Scene, assets: &Assets, texture: &str, place: &Transform) -> Result<Tiles, String> {
    let texture = scene.texture(texture).ok_or("its texture is missing")?;
    let Some(Pattern::Checker { colors }) = texture.source.as_kind().pattern(assets) else {
        return Err("a texture that is a picture is not translated".into());
    };
    // POV-Ray's checker is made of cubes of side 1. Two of them make a repeat, u goes along x and v along −z; half a cube
    // up, so that the plane cuts them in the middle.
    let ([u, v], [shift_u, shift_v]) = (texture.repeat, texture.shift);
    let place = format!(
        "translate <{}, -0.5, {}> scale <{}, 1, {}> {}",
        -2.0 * shift_u,
        -2.0 * shift_v,
        0.5 / u,
        -0.5 / v,
        matrix(place)
    );
    Ok(Tiles { colors, place })
}

/// A sphere, with its place in its own numbers where that can be: POV-Ray is slower with a matrix.
fn sphere(out: &mut String, radius: f32, place: &Transform) {
    if let Some(scale) = place.uniform_scale() {
        put!(out, "sphere {{ {}, {}", vector(place.point(Vec3::ZERO)), radius * scale);
    } else {
        put!(out, "sphere {{ 0, {radius} {}", matrix(place));
    }
}

/// A disc, like the sphere without a matrix where it stays round.
fn disc(out: &mut String, radius: f32, place: &Transform) {
    if let Some(scale) = place.uniform_scale() {
        let (center, normal) = (place.point(Vec3::ZERO), place.normal(Vec3::Y));
        put!(out, "disc {{ {}, {}, {}", vector(center), vector(normal), radius * scale);
    } else {
        put!(out, "disc {{ 0, y, {radius} {}", matrix(place));
    }
}

/// A box, like the sphere without a matrix where it is not turned.
fn cuboid(out: &mut String, half: Vec3, place: &Transform) {
    let m = place.world_from_object.matrix3;
    let is_turned = [m.x_axis.y, m.x_axis.z, m.y_axis.x, m.y_axis.z, m.z_axis.x, m.z_axis.y] != [0.0; 6];
    if is_turned {
        let h = half;
        put!(out, "box {{ <{}, {}, {}>, <{}, {}, {}> {}", -h.x, -h.y, -h.z, h.x, h.y, h.z, matrix(place));
    } else {
        put!(out, "box {{ {}, {}", vector(place.point(-half)), vector(place.point(half)));
    }
}

fn triangles(out: &mut String, mesh: &TriangleMesh, part: &MeshPart, place: &Transform) {
    let list = |items: Vec<String>| format!("{},\n    {}", items.len(), items.join(", "));
    let faces = &mesh.triangles[part.triangles.clone()];
    put!(out, "mesh2 {{");
    put!(
        out,
        "  vertex_vectors {{ {} }}",
        list(mesh.positions.iter().map(|p| vector(place.point(*p))).collect())
    );
    // POV-Ray wants a normal for every corner or none at all.
    if !mesh.normals.is_empty() && !mesh.normals.contains(&Vec3::ZERO) {
        put!(
            out,
            "  normal_vectors {{ {} }}",
            list(mesh.normals.iter().map(|n| vector(place.normal(*n))).collect())
        );
    }
    put!(
        out,
        "  face_indices {{ {} }}",
        list(faces.iter().map(|[a, b, c]| format!("<{a}, {b}, {c}>")).collect())
    );
}

/// The material, and the end of the object. A surface without one is light grey.
fn finish(
    out: &mut String,
    material: Option<&Material>,
    tiles: Option<Tiles>,
    depth: u32,
) -> Result<(), String> {
    let default = Material::default();
    let material = material.unwrap_or(&default);
    let ClassicMaterial { color, diffuse, specular, shininess, reflectivity, transparency, refraction } =
        material.classic();
    if transparency > 0.0 && refraction != 1.0 {
        return Err(format!("the refraction of `{}` is not translated", material.name));
    }
    let through = |color| format!("{} transmit {transparency}", rgb(color));
    match tiles {
        None => put!(out, "  pigment {{ color {} }}", through(color)),
        Some(Tiles { colors: [a, b], place }) => {
            put!(out, "  pigment {{ checker color {}, color {} {place} }}", through(a), through(b));
        }
    }
    // At the end of the recursion a mirror shows its own colour; where that is the first surface, no mirror is needed.
    let reflectivity = if depth > 0 { reflectivity } else { 0.0 };
    // POV-Ray itself weakens pigment, so ambient and diffuse, by the transparency; the rest is weakened here.
    let opacity = 1.0 - transparency;
    let own = 1.0 - reflectivity;
    put!(
        out,
        "  finish {{ ambient {own} diffuse {} phong {} phong_size {shininess} reflection {} }}",
        own * diffuse,
        own * opacity * specular,
        opacity * reflectivity
    );
    put!(out, "}}");
    Ok(())
}

/// A point or direction, its z turned.
fn vector(v: Vec3) -> String {
    format!("<{}, {}, {}>", v.x, v.y, -v.z)
}

fn rgb(color: Rgb) -> String {
    format!("rgb <{}, {}, {}>", color.r, color.g, color.b)
}

/// The place as POV-Ray writes it: the images of x, y and z, then of the origin.
fn matrix(place: &Transform) -> String {
    let m = place.world_from_object;
    let rows = [m.matrix3.x_axis, m.matrix3.y_axis, m.matrix3.z_axis, m.translation];
    let rows = rows.map(|r| format!("{}, {}, {}", r.x, r.y, -r.z));
    format!("matrix <{}>", rows.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine_scene::shapes::{Cuboid, Disc, Plane};
    use vitrine_scene::{Light, Shape, Texture};

    fn scene(object: Object, material: Material) -> Scene {
        let object = Object { material: Some(material.name.clone()), ..object };
        Scene {
            lights: vec![Light::default()],
            materials: vec![material],
            objects: vec![object],
            ..Scene::default()
        }
    }

    fn translated(scene: &Scene) -> String {
        translate(scene, &Assets::default()).unwrap()
    }

    #[test]
    fn z_changes_its_sign_and_a_plain_place_needs_no_matrix() {
        let place = Vec3::new(1.0, 2.0, 3.0);
        let ball = Object { position: place, scale: Vec3::splat(2.0), ..Object::default() };
        let text = translated(&scene(ball, Material::default()));
        assert!(text.contains("sphere { <1, 2, -3>, 2\n"), "{text}");
        let shape = Shape::Box(Cuboid { size: Vec3::ONE });
        let chest = Object { shape, position: place, ..Object::default() };
        let text = translated(&scene(chest.clone(), Material::default()));
        assert!(text.contains("box { <0.5, 1.5, -2.5>, <1.5, 2.5, -3.5>\n"), "{text}");
        let turned = Object { turn_deg: Vec3::new(0.0, 90.0, 0.0), ..chest };
        let text = translated(&scene(turned, Material::default()));
        // Its x points to −z, so to POV-Ray's +z.
        assert!(text.contains("matrix <0, 0, 1, 0, 1, -0, 1, 0, -0, 1, 2, -3>\n"), "{text}");
    }

    #[test]
    fn a_plane_keeps_its_distance_from_the_origin() {
        let ground = Object {
            shape: Shape::Plane(Plane::default()),
            position: Vec3::new(5.0, -1.5, 0.0),
            ..Object::default()
        };
        assert!(translated(&scene(ground, Material::default())).contains("plane { <0, 1, -0>, -1.5\n"));
    }

    #[test]
    fn a_disc_that_is_no_longer_round_has_a_matrix() {
        let shape = Shape::Disc(Disc { radius: 0.5 });
        let coin = Object { shape, position: Vec3::new(1.0, 2.0, 3.0), ..Object::default() };
        let text = translated(&scene(coin.clone(), Material::default()));
        assert!(text.contains("disc { <1, 2, -3>, <0, 1, -0>, 0.5\n"), "{text}");
        let long = Object { scale: Vec3::new(2.0, 1.0, 1.0), ..coin };
        let text = translated(&scene(long, Material::default()));
        assert!(
            text.contains("disc { 0, y, 0.5 matrix <2, 0, -0, 0, 1, -0, 0, 0, -1, 1, 2, -3>\n"),
            "{text}"
        );
    }

    #[test]
    fn every_factor_has_its_share_of_the_blend() {
        let material = Material {
            diffuse: Some(0.5),
            specular: Some(0.5),
            shininess: Some(20.0),
            reflectivity: Some(0.5),
            transparency: Some(0.75),
            ..Material::default()
        };
        let text = translated(&scene(Object::default(), material));
        assert!(text.contains("transmit 0.75"), "{text}");
        assert!(
            text.contains("ambient 0.5 diffuse 0.25 phong 0.0625 phong_size 20 reflection 0.125"),
            "{text}"
        );
    }

    #[test]
    fn squares_lie_on_a_plane_as_in_its_own_space() {
        let ground = Object { shape: Shape::Plane(Plane::default()), ..Object::default() };
        let tiled = Material { texture: Some("tiles".into()), ..Material::default() };
        let mut tiled = scene(ground, tiled);
        let (repeat, shift) = ([0.25, 0.5], [1.0, 2.0]);
        tiled.textures.push(Texture { name: "tiles".into(), repeat, shift, ..Texture::default() });
        let text = translated(&tiled);
        // A repeat of 0.25 a metre is two squares of 2 m each; v grows towards −z.
        assert!(text.contains("translate <-2, -0.5, -4> scale <2, 1, -1> matrix <1, 0, -0, 0,"), "{text}");
    }

    #[test]
    fn what_has_no_counterpart_is_refused() {
        let glass = Material { transparency: Some(0.9), refraction: Some(1.5), ..Material::default() };
        assert!(translate(&scene(Object::default(), glass), &Assets::default()).is_err());
        let tiled = Material { texture: Some("tiles".into()), ..Material::default() };
        let mut tiled = scene(Object::default(), tiled);
        tiled.textures.push(Texture { name: "tiles".into(), ..Texture::default() });
        assert!(translate(&tiled, &Assets::default()).is_err());
    }
}
