//! Small pictures of materials, templates and scenes on the graphics card, and how they are drawn.

use crate::library::ThumbnailImage;
use crate::theme::{self, UNTINTED};
use eframe::egui::load::SizedTexture;
use eframe::egui::{ColorImage, Context, CornerRadius, Image, Rect, TextureHandle, TextureOptions, Ui, vec2};
use std::collections::HashMap;
use std::sync::Arc;

/// Pictures that have been given to the graphics card, by the picture itself.
#[derive(Default)]
pub struct ThumbnailTextures(HashMap<usize, (Arc<ThumbnailImage>, TextureHandle)>);

impl std::fmt::Debug for ThumbnailTextures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ThumbnailTextures").field("count", &self.0.len()).finish()
    }
}

impl ThumbnailTextures {
    /// More than these, and all are given anew: materials that are being edited leave one behind at every step.
    const MOST: usize = 300;

    fn get(&mut self, ctx: &Context, image: &Arc<ThumbnailImage>) -> SizedTexture {
        if self.0.len() > Self::MOST {
            self.0.clear();
        }
        // The picture is kept with its texture, so its address belongs to no other.
        let entry = self.0.entry(Arc::as_ptr(image) as usize).or_insert_with(|| {
            let pixels = ColorImage::from_rgba_unmultiplied(image.size, &image.rgba);
            (image.clone(), ctx.load_texture("thumbnail", pixels, TextureOptions::LINEAR))
        });
        SizedTexture::from_handle(&entry.1)
    }

    /// Draws a picture so that it fills a rectangle, its edges cut off where the proportions differ; while it has not been made
    /// yet, a quiet place for it.
    pub fn paint(&mut self, ui: &Ui, rect: Rect, image: Option<&Arc<ThumbnailImage>>, radius: CornerRadius) {
        let theme = theme::of(ui);
        let Some(image) = image else {
            ui.painter().rect_filled(rect, radius, theme.field);
            return;
        };
        let texture = self.get(ui.ctx(), image);
        let scale = (rect.width() / texture.size.x).max(rect.height() / texture.size.y);
        let share = rect.size() / (texture.size * scale);
        let cut = Rect::from_center_size(eframe::egui::pos2(0.5, 0.5), vec2(share.x, share.y));
        Image::from_texture(texture).uv(cut).corner_radius(radius).tint(UNTINTED).paint_at(ui, rect);
    }
}
