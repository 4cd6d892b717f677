//! Plots, as SVG or PNG.

mod growth;
mod threads;

use super::{FONT, shrink};
use crate::failure::{Exit, Failure};
use crate::output;
use crate::report::Report;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::path::Path;
use vitrine::film::Display;
use vitrine::math::Rgb;
use vitrine::{Image, WriteOptions, formats};

pub use growth::Growth;
pub use threads::Threads;

const WIDTH: u32 = 960;
const HEIGHT: u32 = 600;
/// In an SVG the viewer chooses the font: Inter if it has it.
const FAMILY: &str = "Inter, sans-serif";
const BLUE: RGBColor = RGBColor(31, 97, 173);
const ORANGE: RGBColor = RGBColor(200, 96, 16);
const GREEN: RGBColor = RGBColor(46, 132, 78);
const GREY: RGBColor = RGBColor(140, 140, 140);
const GRID: RGBColor = RGBColor(220, 220, 220);

type Area<B> = DrawingArea<B, Shift>;
type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// Something to be drawn on any backend.
pub trait Chart {
    /// Draws it on a white area.
    fn draw<B: DrawingBackend>(&self, area: &Area<B>, style: Style) -> Drawn<B>;
}

/// How large everything is.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// How many times larger than on an SVG.
    scale: u32,
}

impl Style {
    const fn font(self, size: u32) -> (&'static str, u32) {
        (FAMILY, size * self.scale)
    }

    fn line(self, color: RGBColor, width: u32) -> ShapeStyle {
        color.stroke_width(width * self.scale)
    }

    /// A short line for the legend.
    fn legend(self, line: ShapeStyle) -> impl Fn((i32, i32)) -> PathElement<(i32, i32)> + 'static {
        let length = 24 * self.scale as i32;
        move |(x, y)| PathElement::new([(x, y), (x + length, y)], line)
    }
}

/// Checks that a plot can be written there: .svg or .png, and a folder that takes files.
///
/// # Errors
/// What is in the way.
pub fn check_plot(path: &Path) -> Result<(), Failure> {
    if is_svg(path) || has_extension(path, "png") {
        return output::check_place(path);
    }
    Err(Failure::usage(
        format!("a plot is .svg or .png: {}", path.display()),
        "give the file one of these extensions",
    ))
}

/// Draws a chart into a file.
///
/// # Errors
/// When the file cannot be written.
pub fn plot(path: &Path, chart: &impl Chart) -> Result<(), Failure> {
    // Registering again replaces the same font by itself.
    let registered = register_font(FAMILY, FontStyle::Normal, FONT);
    assert!(registered.is_ok(), "the font in the program is a font");
    if is_svg(path) {
        let mut text = String::new();
        let backend = SVGBackend::with_string(&mut text, (WIDTH, HEIGHT));
        draw(chart, backend, 1)?;
        formats::write_atomically(path, text.as_bytes())?;
        return Ok(());
    }
    // The bitmap backend knows whole pixels only: drawn larger and made smaller, its lines and letters are smooth.
    const SMOOTH: u32 = 3;
    let large = [WIDTH * SMOOTH, HEIGHT * SMOOTH];
    let mut bytes = vec![0; large[0] as usize * large[1] as usize * 3];
    draw(chart, BitMapBackend::with_buffer(&mut bytes, large.into()), SMOOTH)?;
    let pixels = bytes.chunks_exact(3).map(|p| Rgb::from_srgb8([p[0], p[1], p[2]])).collect();
    let image = shrink(&Image { size: large, pixels }, &Display::default(), [WIDTH, HEIGHT]);
    formats::write_image(path, &image, &WriteOptions::default())?;
    Ok(())
}

fn draw<B: DrawingBackend>(chart: &impl Chart, backend: B, scale: u32) -> Result<(), Failure> {
    let area = backend.into_drawing_area();
    let drawn = area.fill(&WHITE).and_then(|()| chart.draw(&area, Style { scale }));
    drawn
        .and_then(|()| area.present())
        .map_err(|error| Failure::new(Exit::Failed, Report::error(format!("cannot draw the plot: {error}"))))
}

fn is_svg(path: &Path) -> bool {
    has_extension(path, "svg")
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case(extension))
}
