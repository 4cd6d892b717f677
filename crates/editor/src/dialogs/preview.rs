//! A small picture of a scene inside a dialog, rendered on a thread of its own whenever the scene changes.

use crate::text::tr;
use crate::theme::{self, UNTINTED};
use eframe::egui::{ColorImage, Image, Rect, Response, Sense, TextureHandle, TextureOptions, Ui, Vec2};
use std::fmt;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use vitrine::render::{CompileOptions, CompiledScene, compile_with};
use vitrine::scene::{Assets, Renderer, Scene};
use vitrine::{Cancel, RenderJob, RenderOptions, display_of};

/// A picture, and the compiled scene, whose trees the next one takes over.
type Made = Option<(Arc<CompiledScene>, ColorImage)>;

/// A small picture that follows a scene.
#[derive(Default)]
pub struct Preview {
    /// The scene that the newest picture, or the one being made, shows.
    asked: Option<Scene>,
    making: Option<Receiver<Made>>,
    cancel: Cancel,
    compiled: Option<Arc<CompiledScene>>,
    texture: Option<TextureHandle>,
}

impl fmt::Debug for Preview {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Preview").field("is_making", &self.making.is_some()).finish_non_exhaustive()
    }
}

impl Preview {
    /// Draws the picture, and asks for another when the scene is not the one that it shows.
    pub fn ui(&mut self, ui: &mut Ui, mut scene: Scene, assets: &Arc<Assets>, size: Vec2) -> Response {
        let pixels = size * ui.ctx().pixels_per_point();
        scene.settings.size = [pixels.x.max(1.0) as u32, pixels.y.max(1.0) as u32];
        // Light that is chosen by chance needs more to be seen as what it is.
        scene.settings.samples = if scene.settings.renderer == Renderer::Photoreal { 32 } else { 4 };
        (scene.settings.noise, scene.settings.time_limit) = (0.0, 0.0);
        scene.settings.shadow_points = scene.settings.shadow_points.min(16);
        self.receive(ui);
        if self.making.is_none() && self.asked.as_ref() != Some(&scene) {
            self.make(ui, scene, assets);
        }
        let theme = theme::of(ui);
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        ui.painter().rect_filled(rect, theme.sizes.radius, theme.surround);
        match &self.texture {
            Some(texture) => paint(ui, texture, rect),
            None => {
                let text = tr!("dialog-add-preview-none");
                let mut child = ui.new_child(eframe::egui::UiBuilder::new().max_rect(rect));
                child.centered_and_justified(|ui| ui.weak(text));
            }
        }
        let name = tr!("dialog-add-preview");
        response
            .widget_info(|| eframe::egui::WidgetInfo::labeled(eframe::egui::WidgetType::Image, true, &name));
        response.on_hover_text(tr!("dialog-add-preview.tooltip"))
    }

    fn receive(&mut self, ui: &Ui) {
        let Some(receiver) = &self.making else { return };
        match receiver.try_recv() {
            Err(TryRecvError::Empty) => return,
            Ok(Some((compiled, image))) => {
                self.compiled = Some(compiled);
                let options = TextureOptions::LINEAR;
                match &mut self.texture {
                    Some(texture) => texture.set(image, options),
                    None => self.texture = Some(ui.ctx().load_texture("dialog-preview", image, options)),
                }
            }
            // The scene cannot be shown as it is now: the last good picture stays.
            Ok(None) | Err(TryRecvError::Disconnected) => {}
        }
        self.making = None;
    }

    fn make(&mut self, ui: &Ui, scene: Scene, assets: &Arc<Assets>) {
        self.asked = Some(scene.clone());
        let (sender, receiver) = channel();
        let (assets, ctx) = (assets.clone(), ui.ctx().clone());
        let (earlier, cancel) = (self.compiled.clone(), self.cancel.clone());
        std::thread::spawn(move || {
            // Whoever asked may be gone; then nobody wants the picture.
            let _ = sender.send(render(&scene, &assets, earlier.as_deref(), &cancel));
            ctx.request_repaint();
        });
        self.making = Some(receiver);
    }
}

impl Drop for Preview {
    fn drop(&mut self) {
        self.cancel.cancel();
    }
}

fn render(scene: &Scene, assets: &Assets, earlier: Option<&CompiledScene>, cancel: &Cancel) -> Made {
    let options = CompileOptions { earlier, ..CompileOptions::default() };
    let compiled = compile_with(scene, assets, options).ok()?;
    let options = RenderOptions { settings: scene.settings.clone(), region: None };
    let rendered = RenderJob::new(&compiled, options).ok()?.run(1, cancel, &mut |_| {});
    let is_complete = rendered.is_complete();
    let image = rendered.film.into_image();
    let size = image.size.map(|s| s as usize);
    let picture = ColorImage::from_rgb(size, &display_of(&scene.settings).to_u8(&image));
    is_complete.then(|| (Arc::new(compiled), picture))
}

fn paint(ui: &Ui, texture: &TextureHandle, rect: Rect) {
    let radius = theme::of(ui).sizes.radius;
    Image::new(texture).corner_radius(radius).tint(UNTINTED).paint_at(ui, rect);
}
