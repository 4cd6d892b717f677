//! Small pictures of materials and templates: asked for by whoever draws them, made one after another on a thread of their
//! own, kept in memory.

use super::sample::{self, Care};
use crate::document::Paint;
use crate::files::Wake;
use std::collections::HashMap;
use std::path::Path;
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread;
use vitrine::Image;
use vitrine::film::Display;
use vitrine::formats::{FormatError, WriteOptions, encode, image_format, read_picture};
use vitrine::math::Rgb;
use vitrine::scene::{Assets, Picture};

/// A small picture, 8 bits sRGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ThumbnailImage {
    /// Width and height, pixels.
    pub size: [usize; 2],
    /// Red, green, blue, alpha, row by row from the top.
    pub rgba: Vec<u8>,
}

impl ThumbnailImage {
    /// A rendered picture made so small that it fits into a width and height; each pixel is the mean of those that it stands
    /// for. `display` says how its light is shown.
    #[must_use]
    pub fn of_image(image: &Image, display: &Display, within: [u32; 2]) -> Self {
        let [width, height] = image.size;
        let shrink = (within[0] as f32 / width as f32).min(within[1] as f32 / height as f32).min(1.0);
        let size = image.size.map(|n| ((n as f32 * shrink) as u32).max(1));
        let span = |i: u32, from: u32, to: u32| i * from / to..((i + 1) * from / to).max(i * from / to + 1);
        let mut small = Image::filled(size, Rgb::BLACK);
        for (i, pixel) in small.pixels.iter_mut().enumerate() {
            let (x, y) =
                (span(i as u32 % size[0], width, size[0]), span(i as u32 / size[0], height, size[1]));
            let count = (x.len() * y.len()) as f32;
            let sum = y.flat_map(|y| x.clone().map(move |x| image.pixel(x, y)));
            *pixel = sum.fold(Rgb::BLACK, |a, b| a + b) / count;
        }
        let rgb = display.to_u8(&small);
        let rgba = rgb.as_chunks::<3>().0.iter().flat_map(|[r, g, b]| [*r, *g, *b, u8::MAX]).collect();
        Self { size: size.map(|n| n as usize), rgba }
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// When it has no pixels.
    pub fn to_png(&self) -> Result<Vec<u8>, FormatError> {
        let pixels = self.rgba.as_chunks::<4>().0.iter().map(|[r, g, b, _]| Rgb::from_srgb8([*r, *g, *b]));
        let image = Image { size: self.size.map(|n| n as u32), pixels: pixels.collect() };
        let path = Path::new("thumbnail.png");
        encode(image_format(path)?, &image, &WriteOptions::default())
    }

    /// Reads a PNG file. None when there is none, or it is broken.
    #[must_use]
    pub fn read_png(path: &Path) -> Option<Self> {
        let picture = read_picture(path).ok()?;
        let rgba = picture.texels.iter().flat_map(|[r, g, b]| [*r, *g, *b, u8::MAX]).collect();
        Some(Self { size: picture.size.map(|n| n as usize), rgba })
    }
}

/// What a picture is to show.
enum Order {
    Material(Box<Paint>, Option<Arc<Picture>>),
    Template(String),
}

impl Order {
    fn make(&self, care: Care) -> Option<ThumbnailImage> {
        match self {
            Self::Material(paint, picture) => sample::of_material(paint, picture.clone()),
            Self::Template(name) => sample::of_template(name, care),
        }
    }
}

/// A picture that was asked for: None while it is not there, and for ever when it cannot be made.
type Shelf = Arc<Mutex<HashMap<String, Option<Arc<ThumbnailImage>>>>>;

/// The pictures.
pub struct Thumbnails {
    shelf: Shelf,
    /// To the thread; None: made while one waits.
    orders: Option<Sender<(String, Order)>>,
}

impl Thumbnails {
    /// Pictures are made on a thread; `wake` is called when there is a new one.
    #[must_use]
    pub fn start(wake: Wake) -> Self {
        let (orders, inbox) = mpsc::channel();
        let shelf = Shelf::default();
        let made = Arc::clone(&shelf);
        let thread = thread::Builder::new().name("thumbnails".into());
        let started = thread.spawn(move || make_all(&inbox, &made, &wake));
        Self { shelf, orders: started.is_ok().then_some(orders) }
    }

    /// Pictures are made while the caller waits, so a test sees them at once; those of templates are rough.
    /// All that are made so share one shelf, for they are the same for all tests of a program.
    #[must_use]
    pub fn immediate() -> Self {
        static SHELF: OnceLock<Shelf> = OnceLock::new();
        Self { shelf: SHELF.get_or_init(Shelf::default).clone(), orders: None }
    }

    /// The picture of a material: a ball of it. None until it has been made. `assets` are the scene's.
    #[must_use]
    pub fn material(&self, paint: &Paint, assets: &Assets) -> Option<Arc<ThumbnailImage>> {
        let key = Self::material_key(paint);
        self.get(key, || {
            let file = paint.texture.as_ref().and_then(|t| t.source.as_kind().file());
            let picture = file.and_then(|f| assets.pictures.get(f)).cloned();
            Order::Material(Box::new(paint.clone()), picture)
        })
    }

    /// Tells the picture of a material from all others; its name does not count.
    #[must_use]
    pub fn material_key(paint: &Paint) -> String {
        let mut nameless = paint.clone();
        nameless.material.name.clear();
        nameless.material.texture = None;
        if let Some(texture) = &mut nameless.texture {
            texture.name.clear();
        }
        format!("{nameless:?}")
    }

    /// The picture of a template. None until it has been made.
    #[must_use]
    pub fn template(&self, name: &str) -> Option<Arc<ThumbnailImage>> {
        self.get(format!("template {name}"), || Order::Template(name.to_owned()))
    }

    fn get(&self, key: String, order: impl FnOnce() -> Order) -> Option<Arc<ThumbnailImage>> {
        let mut shelf = lock(&self.shelf);
        if let Some(there) = shelf.get(&key) {
            return there.clone();
        }
        let Some(orders) = &self.orders else {
            let made = order().make(Care::Quick).map(Arc::new);
            shelf.insert(key, made.clone());
            return made;
        };
        shelf.insert(key.clone(), None);
        // Without a thread at the other end the picture stays away, and nothing else.
        let _ = orders.send((key, order()));
        None
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The thread: until the pictures' owner is gone.
fn make_all(inbox: &Receiver<(String, Order)>, shelf: &Shelf, wake: &Wake) {
    while let Ok((key, order)) = inbox.recv() {
        if let Some(image) = order.make(Care::Fine) {
            lock(shelf).insert(key, Some(Arc::new(image)));
            wake();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::materials;
    use std::time::{Duration, Instant};

    #[test]
    fn a_picture_comes_from_the_thread_and_wakes() {
        let (sender, woken) = mpsc::channel();
        let sender = Mutex::new(sender);
        let thumbnails = Thumbnails::start(Arc::new(move || lock(&sender).send(()).unwrap()));
        let paint = materials()[0].paint();
        assert_eq!(thumbnails.material(&paint, &Assets::default()), None, "not at once");
        woken.recv_timeout(Duration::from_secs(60)).unwrap();
        assert!(thumbnails.material(&paint, &Assets::default()).is_some());
    }

    #[test]
    fn a_picture_is_made_small_in_its_own_proportions_and_survives_a_file() {
        let mut image = Image::filled([400, 200], Rgb::BLACK);
        image.pixels[..400 * 100].fill(Rgb::WHITE);
        let small = ThumbnailImage::of_image(&image, &Display::default(), [100, 100]);
        assert_eq!(small.size, [100, 50]);
        assert_eq!((small.rgba[0], small.rgba[small.rgba.len() - 4]), (255, 0));
        let tiny =
            ThumbnailImage::of_image(&Image::filled([3, 900], Rgb::WHITE), &Display::default(), [100, 100]);
        assert_eq!(tiny.size, [1, 100]);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        std::fs::write(&path, small.to_png().unwrap()).unwrap();
        assert_eq!(ThumbnailImage::read_png(&path), Some(small));
        std::fs::write(&path, "no picture").unwrap();
        assert_eq!(ThumbnailImage::read_png(&path), None);
    }

    #[test]
    fn what_cannot_be_made_is_tried_once() {
        let thumbnails = Thumbnails::immediate();
        assert_eq!(thumbnails.template("none"), None);
        let start = Instant::now();
        assert_eq!(thumbnails.template("none"), None);
        assert!(start.elapsed() < Duration::from_secs(1));
        assert_eq!(lock(&thumbnails.shelf).get("template none"), Some(&None));
    }

    #[test]
    fn materials_that_differ_by_name_alone_share_a_picture() {
        let thumbnails = Thumbnails::immediate();
        let mut paint = materials()[1].paint();
        let first = thumbnails.material(&paint, &Assets::default()).unwrap();
        paint.material.name = "other".into();
        assert!(Arc::ptr_eq(&first, &thumbnails.material(&paint, &Assets::default()).unwrap()));
        paint.material.transparency = Some(0.1);
        assert!(!Arc::ptr_eq(&first, &thumbnails.material(&paint, &Assets::default()).unwrap()));
    }
}
