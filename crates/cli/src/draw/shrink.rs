//! Making a picture smaller, in linear light.

use vitrine::Image;
use vitrine::film::Display;
use vitrine::math::Rgb;

/// The picture as a display shows it (each value within its range) in that many pixels, which are not more than it has:
/// each new pixel is the mean of the area that it covers. The result is linear light again.
pub fn shrink(image: &Image, display: &Display, size: [u32; 2]) -> Image {
    let shown = display.shown(image);
    // An area's mean is the mean over rows of the means over columns.
    let narrow = shrink_rows(&shown, size[0]);
    transpose(&shrink_rows(&transpose(&narrow), size[1]))
}

fn shrink_rows(image: &Image, width: u32) -> Image {
    let [old_width, height] = image.size;
    if width == old_width {
        return image.clone();
    }
    let step = f64::from(old_width) / f64::from(width);
    let mut pixels = Vec::with_capacity(width as usize * height as usize);
    for row in image.pixels.chunks_exact(old_width as usize) {
        for x in 0..width {
            let (from, to) = (f64::from(x) * step, f64::from(x + 1) * step);
            pixels.push(mean(row, from, to));
        }
    }
    Image { size: [width, height], pixels }
}

/// The mean over `from..to`, parts of pixels at both ends included.
fn mean(row: &[Rgb], from: f64, to: f64) -> Rgb {
    let last = (to.ceil() as usize).min(row.len());
    let (mut sum, mut weights) = (Rgb::BLACK, 0.0);
    for (i, pixel) in row.iter().enumerate().take(last).skip(from as usize) {
        let weight = (to.min((i + 1) as f64) - from.max(i as f64)) as f32;
        sum += *pixel * weight;
        weights += weight;
    }
    sum / weights
}

fn transpose(image: &Image) -> Image {
    let [width, height] = image.size;
    let pixels = (0..width).flat_map(|x| (0..height).map(move |y| image.pixel(x, y))).collect();
    Image { size: [height, width], pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_of_light_and_not_of_its_code() {
        let image = Image { size: [2, 2], pixels: vec![Rgb::BLACK, Rgb::WHITE, Rgb::WHITE, Rgb::BLACK] };
        let one = shrink(&image, &Display::default(), [1, 1]);
        assert!((one.pixel(0, 0).g - 0.5).abs() < 1e-6, "{one:?}");
    }

    #[test]
    fn parts_of_pixels_count_as_parts() {
        let image = Image { size: [3, 1], pixels: vec![Rgb::BLACK, Rgb::WHITE, Rgb::BLACK] };
        let two = shrink(&image, &Display::default(), [2, 1]);
        assert!(two.pixels.iter().all(|p| (p.r - 1.0 / 3.0).abs() < 1e-6), "{two:?}");
    }

    #[test]
    fn overbright_light_does_not_spill() {
        let image = Image { size: [2, 1], pixels: vec![Rgb::splat(100.0), Rgb::BLACK] };
        assert!((shrink(&image, &Display::default(), [1, 1]).pixel(0, 0).r - 0.5).abs() < 1e-6);
    }
}
