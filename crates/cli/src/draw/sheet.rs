//! The contact sheet: small pictures in rows and columns, a caption under each.

use super::text;
use vitrine::Image;
use vitrine::math::Rgb;

/// The width that a sheet aims at, in pixels.
const WIDTH: f32 = 1500.0;
/// Width to height that a sheet aims at.
const ASPECT: f32 = 1.5;
/// Around and between the pictures.
const MARGIN: u32 = 24;
/// The letters' height.
const LETTERS: f32 = 26.0;
/// Between a picture and its caption.
const GAP: u32 = 8;

/// How a sheet is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    columns: u32,
    rows: u32,
    /// The room for one picture, in pixels.
    cell: [u32; 2],
}

impl Layout {
    /// Divides a sheet for so many pictures, none larger than `largest`. They are never made larger than they are.
    pub fn new(count: usize, largest: [u32; 2]) -> Self {
        let count = count.clamp(1, 10_000) as u32;
        let candidates = (1..=count).map(|columns| Self::with_columns(columns, count, largest));
        // Near the wanted form, and with few empty places.
        let badness = |layout: &Self| {
            let [width, height] = layout.size().map(|v| v as f32);
            let empty = (layout.columns * layout.rows - count) as f32 / count as f32;
            (width / height / ASPECT).ln().abs() + 0.5 * empty
        };
        candidates.min_by(|a, b| badness(a).total_cmp(&badness(b))).expect("there is one column at least")
    }

    fn with_columns(columns: u32, count: u32, largest: [u32; 2]) -> Self {
        let room = (WIDTH - (MARGIN * (columns + 1)) as f32) / columns as f32;
        let width = room.clamp(48.0, (largest[0] as f32).max(48.0));
        let height = width.min(largest[0] as f32) * largest[1] as f32 / largest[0] as f32;
        let cell = [width as u32, (height.round() as u32).max(1)];
        Self { columns, rows: count.div_ceil(columns), cell }
    }

    /// The size in which a picture goes into its place.
    pub fn fit(&self, size: [u32; 2]) -> [u32; 2] {
        let shrink =
            (self.cell[0] as f32 / size[0] as f32).min(self.cell[1] as f32 / size[1] as f32).min(1.0);
        size.map(|v| ((v as f32 * shrink).round() as u32).max(1))
    }

    fn size(&self) -> [u32; 2] {
        let step = self.step();
        [MARGIN + self.columns * step[0], MARGIN + self.rows * step[1]]
    }

    /// From one place to the next.
    fn step(&self) -> [u32; 2] {
        let caption = GAP + text::line_height(LETTERS).ceil() as u32;
        [self.cell[0] + MARGIN, self.cell[1] + caption + MARGIN]
    }
}

/// Puts small pictures, which fit their places, and their captions onto a sheet.
pub fn sheet(layout: Layout, pictures: &[(Image, String)]) -> Image {
    let mut sheet = Image::filled(layout.size(), Rgb::from_srgb8([246, 246, 244]));
    let ink = Rgb::from_srgb8([32, 32, 36]);
    let step = layout.step();
    for (i, (picture, caption)) in pictures.iter().enumerate() {
        let place = [i as u32 % layout.columns, i as u32 / layout.columns];
        let left = MARGIN + place[0] * step[0];
        let top = MARGIN + place[1] * step[1];
        paste(
            &mut sheet,
            picture,
            left + (layout.cell[0] - picture.size[0]) / 2,
            top + layout.cell[1] - picture.size[1],
        );
        let line = text::fit(caption, LETTERS, layout.cell[0] as f32);
        let middle = left as f32 + (layout.cell[0] as f32 - line.width) / 2.0;
        text::draw(&mut sheet, &line, middle, (top + layout.cell[1] + GAP) as f32, ink);
    }
    sheet
}

fn paste(sheet: &mut Image, picture: &Image, left: u32, top: u32) {
    let [width, _] = sheet.size.map(|v| v as usize);
    for (y, row) in picture.pixels.chunks_exact(picture.size[0] as usize).enumerate() {
        let start = (top as usize + y) * width + left as usize;
        sheet.pixels[start..start + row.len()].copy_from_slice(row);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_square_pictures_stand_three_by_two_on_a_sheet_of_the_wanted_width() {
        let layout = Layout::new(6, [809, 817]);
        assert_eq!((layout.columns, layout.rows), (3, 2));
        assert!((1490..=1500).contains(&layout.size()[0]), "{:?}", layout.size());
    }

    #[test]
    fn small_pictures_stay_small_and_all_have_a_place() {
        for count in 1..40 {
            let layout = Layout::new(count, [60, 30]);
            assert!(layout.columns * layout.rows >= count as u32);
            assert_eq!(layout.fit([60, 30]), [60, 30]);
        }
    }

    #[test]
    fn pictures_of_every_form_fit() {
        let layout = Layout::new(5, [4000, 1000]);
        for size in [[4000, 1000], [1, 1000], [4000, 1], [10, 10]] {
            let [width, height] = layout.fit(size);
            assert!(width <= layout.cell[0] && height <= layout.cell[1], "{size:?} became {width}×{height}");
        }
    }

    #[test]
    fn pictures_and_captions_land_on_the_sheet() {
        let layout = Layout::new(2, [100, 80]);
        let red = Rgb::new(1.0, 0.0, 0.0);
        let pictures: Vec<_> =
            ["a = 1", "a = 2"].map(|c| (Image::filled([100, 80], red), c.to_owned())).into();
        let sheet = sheet(layout, &pictures);
        assert_eq!(sheet.pixels.iter().filter(|p| **p == red).count(), 2 * 100 * 80);
        assert!(sheet.pixels.iter().any(|p| p.luminance() < 0.05), "captions are dark");
    }
}
