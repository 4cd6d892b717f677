//! The picture as a texture, and over it the outline of what is selected.

use crate::live::{ObjectMap, Picture};
use crate::theme::{Theme, UNTINTED};
use eframe::egui::{Color32, ColorImage, Painter, Rect, TextureHandle, TextureId, TextureOptions, pos2};
use std::sync::Arc;
use vitrine::render::NO_OBJECT;
use vitrine::scene::{Object, Scene};

/// The textures.
#[derive(Default)]
pub struct Surface {
    picture: Option<(Arc<Picture>, TextureHandle)>,
    outline: Option<(OutlineKey, TextureHandle)>,
}

/// What an outline was drawn from.
#[derive(Clone)]
struct OutlineKey {
    map: Arc<ObjectMap>,
    chosen: Vec<bool>,
    color: Color32,
}

impl Surface {
    /// Draws the newest picture.
    pub fn paint_picture(&mut self, painter: &Painter, rect: Rect, newest: Option<Arc<Picture>>) {
        let is_new = |newest: &Arc<Picture>| {
            self.picture.as_ref().is_none_or(|(shown, _)| !Arc::ptr_eq(shown, newest))
        };
        if let Some(newest) = newest.filter(is_new) {
            let image = ColorImage::from_rgba_premultiplied(newest.size.map(|v| v as usize), &newest.rgba);
            match &mut self.picture {
                Some((shown, texture)) => {
                    texture.set(image, TextureOptions::LINEAR);
                    *shown = newest;
                }
                None => {
                    let texture = painter.ctx().load_texture("picture", image, TextureOptions::LINEAR);
                    self.picture = Some((newest, texture));
                }
            }
        }
        if let Some((_, texture)) = &self.picture {
            paint(painter, texture.id(), rect);
        }
    }

    /// Draws a contour around the chosen objects, a flag for each object of the map's scene.
    pub fn paint_outline(&mut self, painter: &Painter, rect: Rect, outline: Option<Outline>) {
        let Some(Outline { map, chosen, theme }) = outline.filter(|o| o.chosen.contains(&true)) else {
            return;
        };
        let color = theme.outline;
        let is_same =
            |key: &OutlineKey| Arc::ptr_eq(&key.map, &map) && key.chosen == chosen && key.color == color;
        if !self.outline.as_ref().is_some_and(|(key, _)| is_same(key)) {
            let image = contour(&map, &chosen, theme);
            let key = OutlineKey { map, chosen, color };
            match &mut self.outline {
                Some((old, texture)) => {
                    texture.set(image, TextureOptions::LINEAR);
                    *old = key;
                }
                None => {
                    let texture = painter.ctx().load_texture("outline", image, TextureOptions::LINEAR);
                    self.outline = Some((key, texture));
                }
            }
        }
        if let Some((_, texture)) = &self.outline {
            paint(painter, texture.id(), rect);
        }
    }
}

/// What an outline is drawn around.
pub struct Outline<'a> {
    /// Which object is seen where.
    pub map: Arc<ObjectMap>,
    /// A flag for each object of the map's scene.
    pub chosen: Vec<bool>,
    /// Colours.
    pub theme: &'a Theme,
}

fn paint(painter: &Painter, texture: TextureId, rect: Rect) {
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    painter.image(texture, rect, whole, UNTINTED);
}

/// Flags for the objects of a scene that are among the things, themselves or by their groups.
#[must_use]
pub fn flags(
    scene: &Scene,
    is_chosen: &dyn Fn(&str) -> bool,
    is_group_chosen: &dyn Fn(&str) -> bool,
) -> Vec<bool> {
    let in_group = |object: &Object| {
        let mut group = object.group.as_deref();
        // A ring of groups has no end: as many steps as there are groups are enough.
        for _ in 0..=scene.groups.len() {
            let Some(name) = group else { return false };
            if is_group_chosen(name) {
                return true;
            }
            group = scene.group(name).and_then(|g| g.group.as_deref());
        }
        false
    };
    scene.objects.iter().map(|o| is_chosen(&o.name) || in_group(o)).collect()
}

/// A line two pixels wide where chosen objects meet others, with a dark seam around it.
fn contour(map: &ObjectMap, chosen: &[bool], theme: &Theme) -> ColorImage {
    let [width, height] = map.size.map(|v| v as usize);
    let is_in = |object: &u32| *object != NO_OBJECT && chosen.get(*object as usize) == Some(&true);
    // What is behind glass has an outline as well.
    let both = map.objects.iter().zip(&map.behind_glass);
    let inside: Vec<bool> = both.map(|(nearest, behind)| is_in(nearest) || is_in(behind)).collect();
    let mut pixels = vec![Color32::TRANSPARENT; width * height];
    let mut mark = |x: usize, y: usize, color: Color32| {
        let pixel = &mut pixels[y * width + x];
        if *pixel == Color32::TRANSPARENT || color == theme.outline {
            *pixel = color;
        }
    };
    // The seam lies one pixel outside the line.
    let mut edge = |from: (usize, usize), to: (usize, usize), beyond: Option<(usize, usize)>| {
        mark(from.0, from.1, theme.outline);
        mark(to.0, to.1, theme.outline);
        if let Some((x, y)) = beyond {
            mark(x, y, theme.outline_seam);
        }
    };
    for y in 0..height {
        for x in 0..width {
            let here = inside[y * width + x];
            if x + 1 < width && inside[y * width + x + 1] != here {
                let beyond = if here {
                    (x + 2 < width).then_some((x + 2, y))
                } else {
                    x.checked_sub(1).map(|x| (x, y))
                };
                edge((x, y), (x + 1, y), beyond);
            }
            if y + 1 < height && inside[(y + 1) * width + x] != here {
                let beyond = if here {
                    (y + 2 < height).then_some((x, y + 2))
                } else {
                    y.checked_sub(1).map(|y| (x, y))
                };
                edge((x, y), (x, y + 1), beyond);
            }
        }
    }
    ColorImage::new([width, height], pixels)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Config;
    use vitrine::scene::Group;

    #[test]
    fn the_contour_is_two_pixels_wide_with_a_seam_outside() {
        let mut objects = vec![NO_OBJECT; 12];
        objects.extend([1; 12]);
        let behind_glass = vec![NO_OBJECT; 24];
        let map = ObjectMap { generation: 0, size: [4, 6], objects, behind_glass, scene: Arc::default() };
        let theme = Theme::of_config(&Config::default());
        let image = contour(&map, &[false, true], theme);
        let row = |y: usize| image.pixels[4 * y];
        assert_eq!([row(2), row(3)], [theme.outline; 2]);
        assert_eq!(
            [row(0), row(1), row(4)],
            [Color32::TRANSPARENT, theme.outline_seam, Color32::TRANSPARENT]
        );
        let swapped =
            ObjectMap { objects: map.behind_glass.clone(), behind_glass: map.objects.clone(), ..map.clone() };
        assert_eq!(contour(&swapped, &[false, true], theme), image, "behind glass");
        assert!(contour(&map, &[true, false], theme).pixels.iter().all(|p| *p == Color32::TRANSPARENT));
    }

    #[test]
    fn members_of_a_chosen_group_are_chosen_even_through_rings() {
        let group =
            |name: &str, of: &str| Group { name: name.into(), group: Some(of.into()), ..Group::default() };
        let object = |of: Option<&str>| Object { group: of.map(Into::into), ..Object::default() };
        let scene = Scene {
            groups: vec![group("inner", "outer"), group("outer", "outer")],
            objects: vec![object(Some("inner")), object(None), object(Some("lost"))],
            ..Scene::default()
        };
        let chosen = |wanted: &'static str| flags(&scene, &|_| false, &move |g| g == wanted);
        assert_eq!(chosen("outer"), [true, false, false]);
        assert_eq!(chosen("other"), [false; 3]);
    }
}
