//! A renderer for tests: textured triangles, as egui's own draw them, on the processor alone.
//!
//! egui blends in display values with premultiplied alpha; so does this.

use eframe::egui::{self, Color32, Pos2, Rect, TextureId, TextureOptions, TexturesDelta, epaint};
use egui_kittest::TestRenderer;
use epaint::{ImageData, Mesh, Primitive, Vertex};
use std::collections::HashMap;

/// A texture: its size, its texels and whether they are blended between.
struct Texture {
    size: [usize; 2],
    texels: Vec<Color32>,
    is_smooth: bool,
}

/// Renders the window without a graphics card.
#[derive(Default)]
pub struct CpuRenderer {
    textures: HashMap<TextureId, Texture>,
}

impl TestRenderer for CpuRenderer {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        for (id, deltas) in delta.set.drain() {
            for part in deltas {
                let ImageData::Color(image) = part.image;
                let is_smooth = part.options.magnification == TextureOptions::LINEAR.magnification;
                let Some([x, y]) = part.pos else {
                    let texture = Texture { size: image.size, texels: image.pixels.clone(), is_smooth };
                    self.textures.insert(id, texture);
                    continue;
                };
                let Some(texture) = self.textures.get_mut(&id) else { continue };
                for (row, texels) in image.pixels.chunks_exact(image.size[0]).enumerate() {
                    let start = (y + row) * texture.size[0] + x;
                    texture.texels[start..start + texels.len()].copy_from_slice(texels);
                }
            }
        }
        delta.free.drain().for_each(|id| {
            self.textures.remove(&id);
        });
    }

    fn render(&mut self, ctx: &egui::Context, output: &egui::FullOutput) -> Result<image::RgbaImage, String> {
        let scale = ctx.pixels_per_point();
        let size = ctx.content_rect().size() * scale;
        let (width, height) = (size.x.round() as usize, size.y.round() as usize);
        let mut canvas = Canvas { width, height, pixels: vec![[0.0, 0.0, 0.0, 1.0]; width * height] };
        for clipped in ctx.tessellate(output.shapes.clone(), scale) {
            let Primitive::Mesh(mesh) = clipped.primitive else { continue };
            let Some(texture) = self.textures.get(&mesh.texture_id) else { continue };
            canvas.draw(&mesh, texture, clipped.clip_rect * scale, scale);
        }
        let bytes =
            canvas.pixels.iter().flatten().map(|v| (v.clamp(0.0, 1.0) * 255.0).round() as u8).collect();
        image::RgbaImage::from_raw(width as u32, height as u32, bytes).ok_or_else(|| "no picture".into())
    }
}

struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<[f32; 4]>,
}

impl Canvas {
    fn draw(&mut self, mesh: &Mesh, texture: &Texture, clip: Rect, scale: f32) {
        let whole = Rect::from_min_size(Pos2::ZERO, egui::vec2(self.width as f32, self.height as f32));
        let clip = Rect::from_min_max(clip.min.round(), clip.max.round()).intersect(whole);
        for corners in mesh.indices.chunks_exact(3) {
            let triangle = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
            self.fill(&triangle, texture, clip, scale);
        }
    }

    fn fill(&mut self, triangle: &[Vertex; 3], texture: &Texture, clip: Rect, scale: f32) {
        let [a, b, c] = triangle.map(|v| v.pos * scale);
        let area = cross(a, b, c);
        if area == 0.0 {
            return;
        }
        let bounds = Rect::from_points(&[a, b, c]).intersect(clip);
        if !bounds.is_positive() {
            return;
        }
        // Most of a window is of one colour, which need not be looked up for each pixel.
        let [first, rest @ ..] = triangle;
        let is_plain = rest.iter().all(|v| v.uv == first.uv && v.color == first.color);
        let plain = is_plain.then(|| shade(triangle, [1.0, 0.0, 0.0], texture));
        for y in bounds.top().floor() as usize..(bounds.bottom().ceil() as usize).min(clip.bottom() as usize)
        {
            for x in
                bounds.left().floor() as usize..(bounds.right().ceil() as usize).min(clip.right() as usize)
            {
                let p = Pos2::new(x as f32 + 0.5, y as f32 + 0.5);
                if !clip.contains(p) {
                    continue;
                }
                let edges = [(b, c), (c, a), (a, b)];
                let weights = edges.map(|(from, to)| cross(from, to, p) / area);
                // A pixel on an edge that two triangles share is drawn once: only left and top edges count.
                let counts =
                    |i: usize| weights[i] > 0.0 || (weights[i] == 0.0 && is_top_left(edges[i], area));
                if (0..3).all(counts) {
                    self.blend(x, y, plain.unwrap_or_else(|| shade(triangle, weights, texture)));
                }
            }
        }
    }

    /// Premultiplied: what is drawn, plus what is there as far as it shows through.
    fn blend(&mut self, x: usize, y: usize, source: [f32; 4]) {
        let pixel = &mut self.pixels[y * self.width + x];
        *pixel = [0, 1, 2, 3].map(|i| source[i] + pixel[i] * (1.0 - source[3]));
    }
}

/// Twice the area of a triangle, with its turning sense.
fn cross(a: Pos2, b: Pos2, c: Pos2) -> f32 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

fn is_top_left((from, to): (Pos2, Pos2), area: f32) -> bool {
    let along = if area > 0.0 { to - from } else { from - to };
    along.y < 0.0 || (along.y == 0.0 && along.x > 0.0)
}

fn shade(triangle: &[Vertex; 3], weights: [f32; 3], texture: &Texture) -> [f32; 4] {
    let mix = |f: &dyn Fn(&Vertex) -> f32| (0..3).map(|i| weights[i] * f(&triangle[i])).sum::<f32>();
    let texel = look_up(texture, mix(&|v| v.uv.x), mix(&|v| v.uv.y));
    [0, 1, 2, 3].map(|i| texel[i] * mix(&|v| f32::from(v.color.to_array()[i]) / 255.0))
}

fn look_up(texture: &Texture, u: f32, v: f32) -> [f32; 4] {
    let [width, height] = texture.size;
    let at = |x: i64, y: i64| {
        let (x, y) = (x.clamp(0, width as i64 - 1), y.clamp(0, height as i64 - 1));
        texture.texels[y as usize * width + x as usize].to_array().map(|v| f32::from(v) / 255.0)
    };
    let (x, y) = (u * width as f32, v * height as f32);
    if !texture.is_smooth {
        return at(x.floor() as i64, y.floor() as i64);
    }
    let (x, y) = (x - 0.5, y - 0.5);
    let (x0, y0) = (x.floor(), y.floor());
    let (fx, fy) = (x - x0, y - y0);
    let (x0, y0) = (x0 as i64, y0 as i64);
    let [a, b, c, d] = [at(x0, y0), at(x0 + 1, y0), at(x0, y0 + 1), at(x0 + 1, y0 + 1)];
    [0, 1, 2, 3].map(|i| (a[i] * (1.0 - fx) + b[i] * fx) * (1.0 - fy) + (c[i] * (1.0 - fx) + d[i] * fx) * fy)
}
