//! A scene in Mitsuba 3's language, so that both programs solve the same picture.
//!
//! Mitsuba knows no overlap of solids: each surface states the index on both its sides. So a solid may lie inside another here, but
//! not overlap it. Lamps stand in the way of light there and not here, which shows where they are seen or stand close to something.

use std::fmt::Write;
use std::path::Path;
use vitrine_math::{Bounds3, Mat3, Rgb, Vec3};
use vitrine_scene::lights::Emission;
use vitrine_scene::{Assets, Geometry, Material, Object, PhysicalMaterial, Renderer, Scene};

/// What a number or a text is written into. Writing into a text cannot fail.
macro_rules! put {
    ($out:expr, $($format:tt)*) => { writeln!($out, $($format)*).expect("a text grows") };
}

/// Translates a scene whose files lie below a folder.
///
/// # Errors
/// What the translation does not know: lights other than balls, shapes without end, models with normals, textures, and materials
/// other than matt ones, smooth clear glass, perfect mirrors and such that shine.
pub fn translate(scene: &Scene, assets: &Assets, folder: &Path) -> Result<String, String> {
    if scene.settings.renderer != Renderer::Photoreal || scene.settings.background != Rgb::BLACK {
        return Err("only photoreal scenes before a black background are translated".into());
    }
    let mut out = String::new();
    put!(out, "<scene version=\"3.0.0\">");
    header(&mut out, scene);
    for light in scene.lights.iter().filter(|l| l.visible) {
        let emission = light.source.as_kind().emission(assets).ok_or("a light's file has not been loaded")?;
        lamp(&mut out, &emission, light.radiance(), light.full_at)
            .map_err(|e| format!("light `{}`: {e}", light.name))?;
    }
    let solids = solids(scene);
    for object in scene.objects.iter().filter(|o| scene.is_seen(o)) {
        body(&mut out, scene, (assets, folder), object, &solids)
            .map_err(|e| format!("object `{}`: {e}", object.name))?;
    }
    put!(out, "</scene>");
    Ok(out)
}

fn header(out: &mut String, scene: &Scene) {
    let [width, height] = scene.settings.size;
    put!(
        out,
        "<integrator type=\"path\"><integer name=\"max_depth\" value=\"{}\"/></integrator>",
        scene.settings.bounces
    );
    // Mitsuba's camera looks along +Z with +X to the left.
    let turned = scene.camera.rotation() * Mat3::from_diagonal(Vec3::new(-1.0, 1.0, -1.0));
    put!(out, "<sensor type=\"perspective\">");
    put!(out, "  <string name=\"fov_axis\" value=\"y\"/>");
    put!(out, "  <float name=\"fov\" value=\"{}\"/>", scene.camera.view_angle_deg);
    put!(out, "  <float name=\"near_clip\" value=\"0.001\"/>");
    put!(out, "  {}", matrix(&turned, scene.camera.position));
    put!(out, "  <sampler type=\"independent\"/>");
    put!(out, "  <film type=\"hdrfilm\">");
    put!(out, "    <integer name=\"width\" value=\"{width}\"/><integer name=\"height\" value=\"{height}\"/>");
    // Mitsuba's and Vitrine's own filter, of the same width.
    put!(out, "    <rfilter type=\"gaussian\"/>");
    put!(out, "  </film>");
    put!(out, "</sensor>");
}

/// A ball that shines. Its radiance is what makes a white surface at the distance `full_at` show its intensity: I·d²/r².
fn lamp(out: &mut String, emission: &Emission, intensity: Rgb, full_at: Option<f32>) -> Result<(), String> {
    let (Emission::Sphere { position, radius }, Some(full_at)) = (emission, full_at) else {
        return Err("only balls that state full_at are translated".into());
    };
    let radiance = intensity * (full_at * full_at / (radius * radius));
    put!(out, "<shape type=\"sphere\">");
    put!(
        out,
        "  <point name=\"center\" value=\"{}\"/><float name=\"radius\" value=\"{radius}\"/>",
        list(*position)
    );
    put!(out, "  {}", shining(radiance));
    put!(out, "</shape>");
    Ok(())
}

/// What shines and reflects nothing.
fn shining(radiance: Rgb) -> String {
    format!(
        "<emitter type=\"area\"><rgb name=\"radiance\" value=\"{}\"/></emitter>{}",
        rgb(radiance),
        matt(Rgb::BLACK)
    )
}

fn matt(color: Rgb) -> String {
    format!("<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"{}\"/></bsdf>", rgb(color))
}

/// A solid that light goes through.
struct Solid {
    bounds: Bounds3,
    index: f32,
}

/// All of them, the smallest first.
fn solids(scene: &Scene) -> Vec<Solid> {
    let of = |object: &Object| {
        let material = scene.material(object.material.as_deref()?).filter(|m| m.is_solid_glass())?;
        Some(Solid { bounds: bounds(scene, object)?, index: material.physical().specular_ior })
    };
    let mut solids: Vec<Solid> = scene.objects.iter().filter(|o| scene.is_seen(o)).filter_map(of).collect();
    solids.sort_by(|a, b| a.bounds.size().element_product().total_cmp(&b.bounds.size().element_product()));
    solids
}

/// What a ball or a box fills.
fn bounds(scene: &Scene, object: &Object) -> Option<Bounds3> {
    let half = match object.shape.as_kind().geometry(&Assets::default())? {
        Geometry::Sphere { radius } => Vec3::splat(radius),
        Geometry::Box { half } => half,
        _ => return None,
    };
    Some(scene.world_from_object(object).bounds(&Bounds3 { min: -half, max: half }))
}

/// The index around a solid: that of the smallest one that holds all of it, or of air.
fn index_around(own: &Bounds3, solids: &[Solid]) -> Result<f32, String> {
    for other in solids.iter().filter(|s| s.bounds != *own) {
        let holds = own.corners().iter().all(|c| other.bounds.contains(*c));
        if holds {
            return Ok(other.index);
        }
        let is_inside = other.bounds.corners().iter().all(|c| own.contains(*c));
        let shared = Bounds3 { min: own.min.max(other.bounds.min), max: own.max.min(other.bounds.max) };
        if !is_inside && shared.size().cmpgt(Vec3::ZERO).all() {
            return Err("its bounds cut those of another solid".into());
        }
    }
    Ok(1.0)
}

fn body(
    out: &mut String,
    scene: &Scene,
    (assets, folder): (&Assets, &Path),
    object: &Object,
    solids: &[Solid],
) -> Result<(), String> {
    let place = scene.world_from_object(object);
    let matrix = |scale: Vec3| {
        let m = place.world_from_object;
        matrix(&(Mat3::from(m.matrix3) * Mat3::from_diagonal(scale)), m.translation.into())
    };
    match object.shape.as_kind().geometry(assets).ok_or("its model has not been loaded")? {
        Geometry::Sphere { radius } => {
            put!(out, "<shape type=\"sphere\">{}", matrix(Vec3::splat(radius)));
        }
        Geometry::Box { half } => put!(out, "<shape type=\"cube\">{}", matrix(half)),
        Geometry::Disc { radius } => {
            // Mitsuba's disc faces +Z.
            let m = place.world_from_object;
            let upright = Mat3::from_cols(Vec3::X * radius, Vec3::NEG_Z * radius, Vec3::Y);
            let turned = Mat3::from(m.matrix3) * upright;
            put!(out, "<shape type=\"disk\">{}", self::matrix(&turned, m.translation.into()));
        }
        Geometry::Facets(_) => {
            let file = object.shape.as_kind().file().map(|file| folder.join(file)).unwrap_or_default();
            put!(out, "<shape type=\"obj\">{}", matrix(Vec3::ONE));
            put!(out, "  <string name=\"filename\" value=\"{}\"/>", file.display());
            put!(out, "  <boolean name=\"face_normals\" value=\"true\"/>");
        }
        _ => return Err("such a shape is not translated".into()),
    }
    let material = object.material.as_deref().and_then(|m| scene.material(m)).ok_or("it has no material")?;
    let around = match bounds(scene, object).filter(|_| material.is_solid_glass()) {
        Some(own) => index_around(&own, solids)?,
        None => 1.0,
    };
    put!(out, "  {}", surface(material, around)?);
    put!(out, "</shape>");
    Ok(())
}

/// What a surface is made of, between its inside and an index around it.
fn surface(material: &Material, around: f32) -> Result<String, String> {
    let unknown = || format!("the material `{}` is not translated", material.name);
    if material.textures().iter().any(|t| t.is_some()) {
        return Err(unknown());
    }
    let PhysicalMaterial {
        base_color, base_weight, specular_ior, emission_luminance, emission_color, ..
    } = material.physical();
    let color = base_color * base_weight;
    // Alike in all but what is translated as it is.
    let is = |other: &Material| {
        material.physical()
            == PhysicalMaterial {
                base_color,
                base_weight,
                specular_ior,
                emission_luminance,
                emission_color,
                ..other.physical()
            }
    };
    let matt_base = Material { specular_weight: Some(0.0), ..Material::default() };
    let glass =
        Material { transmission_weight: Some(1.0), specular_roughness: Some(0.0), ..Material::default() };
    let mirror = Material {
        base_metalness: Some(1.0),
        base_color: Some(Rgb::WHITE),
        specular_roughness: Some(0.0),
        ..Material::default()
    };
    if is(&matt_base) && emission_luminance > 0.0 && color == Rgb::BLACK {
        Ok(shining(emission_color * emission_luminance))
    } else if is(&matt_base) && emission_luminance == 0.0 {
        Ok(matt(color))
    } else if is(&glass) && emission_luminance == 0.0 {
        Ok(format!(
            "<bsdf type=\"dielectric\"><float name=\"int_ior\" value=\"{specular_ior}\"/>\
             <float name=\"ext_ior\" value=\"{around}\"/></bsdf>"
        ))
    } else if is(&mirror) && emission_luminance == 0.0 && color == Rgb::WHITE {
        Ok("<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/></bsdf>".into())
    } else {
        Err(unknown())
    }
}

fn list(v: Vec3) -> String {
    format!("{}, {}, {}", v.x, v.y, v.z)
}

fn rgb(color: Rgb) -> String {
    format!("{}, {}, {}", color.r, color.g, color.b)
}

/// A place, row by row.
fn matrix(turned: &Mat3, position: Vec3) -> String {
    let m = turned.transpose();
    let rows = [(m.x_axis, position.x), (m.y_axis, position.y), (m.z_axis, position.z)];
    let rows = rows.map(|(r, p)| format!("{} {} {} {p}", r.x, r.y, r.z));
    format!("<transform name=\"to_world\"><matrix value=\"{} 0 0 0 1\"/></transform>", rows.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine_formats::{SceneFile, load_assets};
    use vitrine_scene::lights::Sphere;
    use vitrine_scene::{Light, LightSource};

    fn scene(name: &str) -> (Scene, Assets, std::path::PathBuf) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(format!("{name}.vitrine.toml"));
        let scene = SceneFile::read(&path).unwrap().into_scene();
        let folder = path.parent().unwrap().to_path_buf();
        let (assets, _) = load_assets(&scene, &folder).unwrap();
        (scene, assets, folder)
    }

    fn translated(name: &str) -> String {
        let (scene, assets, folder) = scene(name);
        translate(&scene, &assets, &folder).unwrap()
    }

    #[test]
    fn water_in_a_tank_lies_in_glass_and_the_tank_in_air() {
        let text = translated("tank");
        assert!(
            text.contains("\"int_ior\" value=\"1.33\"/><float name=\"ext_ior\" value=\"1.52\""),
            "{text}"
        );
        assert!(text.contains("\"int_ior\" value=\"1.52\"/><float name=\"ext_ior\" value=\"1\""), "{text}");
    }

    #[test]
    fn lamps_are_as_bright_as_they_are_here() {
        let (mut scene, assets, folder) = scene("pane");
        let place = Sphere { radius: 0.25, ..Sphere::default() };
        scene.lights[0] = Light { source: LightSource::Sphere(place), ..scene.lights[0].clone() };
        scene.lights[0].full_at = Some(2.0);
        // 1·(2 m)²/(0.25 m)²
        let text = translate(&scene, &assets, &folder).unwrap();
        assert!(text.contains("<rgb name=\"radiance\" value=\"64, 64, 64\""), "{text}");
        // 17 times the colour of the lamp in the Cornell box.
        assert!(translated("cornell").contains("<rgb name=\"radiance\" value=\"17, 12.75, 6.8"));
    }

    #[test]
    fn what_has_no_counterpart_is_refused() {
        let (mut scene, assets, folder) = scene("ball");
        scene.materials[0].specular_roughness = Some(0.2);
        assert!(translate(&scene, &assets, &folder).unwrap_err().contains("`glass`"));
        scene.materials[0].specular_roughness = Some(0.0);
        scene.materials[0].transmission_color = Some(Rgb::new(0.5, 0.9, 0.5));
        assert!(translate(&scene, &assets, &folder).is_err());
    }

    #[test]
    fn solids_that_cut_each_other_are_refused() {
        let (mut scene, assets, folder) = scene("tank");
        scene.objects.iter_mut().find(|o| o.name == "water").unwrap().position.x = 0.5;
        assert!(translate(&scene, &assets, &folder).unwrap_err().contains("cut"));
    }
}
