//! One line of text onto a picture.

use super::FONT;
use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};
use vitrine::Image;
use vitrine::math::Rgb;

/// A line of text, laid out.
#[derive(Debug)]
pub struct Line {
    glyphs: Vec<Glyph>,
    /// Pixels from its first to its last.
    pub width: f32,
}

/// Text of this height in pixels that is not wider than `room`: it becomes smaller down to two thirds, then it is cut.
pub fn fit(text: &str, height: f32, room: f32) -> Line {
    let line = lay_out(text, height);
    if line.width <= room {
        return line;
    }
    let height = (height * room / line.width).max(height * 2.0 / 3.0);
    let mut kept: Vec<char> = text.chars().collect();
    let mut line = lay_out(text, height);
    while line.width > room && !kept.is_empty() {
        kept.pop();
        line = lay_out(&format!("{}…", kept.iter().collect::<String>().trim_end()), height);
    }
    line
}

/// From the top of the highest letters to the bottom of the lowest, in pixels.
pub fn line_height(height: f32) -> f32 {
    font().as_scaled(PxScale::from(height)).height()
}

fn lay_out(text: &str, height: f32) -> Line {
    let font = font();
    let font = font.as_scaled(PxScale::from(height));
    let mut x = 0.0;
    let mut glyphs: Vec<Glyph> = Vec::new();
    for letter in text.chars() {
        let id = font.glyph_id(letter);
        if let Some(last) = glyphs.last() {
            x += font.kern(last.id, id);
        }
        glyphs.push(id.with_scale_and_position(font.scale(), point(x, font.ascent())));
        x += font.h_advance(id);
    }
    Line { glyphs, width: x }
}

/// Draws a line; `left` and `top` are its corner in the picture. What lies outside the picture is left out.
pub fn draw(image: &mut Image, line: &Line, left: f32, top: f32, color: Rgb) {
    let font = font();
    for glyph in &line.glyphs {
        let mut glyph = glyph.clone();
        glyph.position.x += left;
        glyph.position.y += top;
        let Some(outline) = font.outline_glyph(glyph) else { continue };
        let corner = outline.px_bounds().min;
        outline.draw(|x, y, cover| {
            let (x, y) = (corner.x as i64 + i64::from(x), corner.y as i64 + i64::from(y));
            let inside =
                (0..i64::from(image.size[0])).contains(&x) && (0..i64::from(image.size[1])).contains(&y);
            if inside {
                let pixel = &mut image.pixels[y as usize * image.size[0] as usize + x as usize];
                *pixel = pixel.lerp(color, cover.clamp(0.0, 1.0));
            }
        });
    }
}

fn font() -> FontRef<'static> {
    FontRef::try_from_slice(FONT).expect("the font in the program is a font")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_both_languages_has_a_glyph() {
        let font = font();
        for letter in ('a'..='z')
            .chain('A'..='Z')
            .chain('а'..='я')
            .chain('А'..='Я')
            .chain("Ёё0123456789=.,°×–…№«»→αβ≤".chars())
        {
            assert_ne!(font.glyph_id(letter).0, 0, "{letter}");
        }
    }

    #[test]
    fn long_text_is_made_to_fit() {
        let text = "a caption that is much longer than the picture under which it stands";
        assert!(fit(text, 24.0, 200.0).width <= 200.0);
        assert!(fit("short", 24.0, 200.0).width > 40.0);
    }

    #[test]
    fn ink_lands_inside_the_line() {
        let mut image = Image::filled([100, 40], Rgb::WHITE);
        draw(&mut image, &fit("Ш", 30.0, 100.0), 10.0, 2.0, Rgb::BLACK);
        let inked: Vec<_> = (0..100).filter(|&x| (0..40).any(|y| image.pixel(x, y).r < 0.5)).collect();
        assert!(inked.len() > 10 && inked[0] >= 10 && inked[inked.len() - 1] < 50, "{inked:?}");
    }
}
