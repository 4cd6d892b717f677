//! The plot of time against threads (course work, figure 4.2).

use super::{FONT, shrink};
use crate::commands::Measured;
use crate::failure::{Exit, Failure};
use crate::flags::cores;
use crate::output;
use crate::report::Report;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::path::Path;
use vitrine::film::ViewTransform;
use vitrine::math::Rgb;
use vitrine::summary::plural;
use vitrine::{Image, WriteOptions, formats};

const WIDTH: u32 = 960;
const HEIGHT: u32 = 600;
/// In an SVG the viewer chooses the font: Inter if it has it.
const FAMILY: &str = "Inter, sans-serif";
const TIME: RGBColor = RGBColor(31, 97, 173);
const IDEAL: RGBColor = RGBColor(140, 140, 140);
const GRID: RGBColor = RGBColor(220, 220, 220);

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

/// Draws the median times against the number of threads, and the ideal: the time of one thread divided by their number,
/// as far as there are cores.
///
/// # Errors
/// When the file cannot be written.
pub fn plot_threads(path: &Path, scene: &str, measured: &[Measured]) -> Result<(), Failure> {
    // Registering again replaces the same font by itself.
    let registered = register_font(FAMILY, FontStyle::Normal, FONT);
    assert!(registered.is_ok(), "the font in the program is a font");
    if is_svg(path) {
        let mut text = String::new();
        let backend = SVGBackend::with_string(&mut text, (WIDTH, HEIGHT));
        Plot { scene, measured, scale: 1 }.draw(&backend.into_drawing_area())?;
        formats::write_atomically(path, text.as_bytes())?;
        return Ok(());
    }
    // The bitmap backend knows whole pixels only: drawn larger and made smaller, its lines and letters are smooth.
    const SMOOTH: u32 = 3;
    let large = [WIDTH * SMOOTH, HEIGHT * SMOOTH];
    let mut bytes = vec![0; large[0] as usize * large[1] as usize * 3];
    let backend = BitMapBackend::with_buffer(&mut bytes, large.into());
    Plot { scene, measured, scale: SMOOTH }.draw(&backend.into_drawing_area())?;
    let pixels = bytes.chunks_exact(3).map(|p| Rgb::from_srgb8([p[0], p[1], p[2]])).collect();
    let view = ViewTransform::Srgb;
    let image = shrink(&Image { size: large, pixels }, view, [WIDTH, HEIGHT]);
    formats::write_image(path, &image, &WriteOptions { view, ..WriteOptions::default() })?;
    Ok(())
}

/// What is drawn, and how many times larger than on an SVG.
struct Plot<'a> {
    scene: &'a str,
    measured: &'a [Measured],
    scale: u32,
}

type Area<B> = DrawingArea<B, plotters::coord::Shift>;

impl Plot<'_> {
    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), Failure> {
        self.draw_chart(area).and_then(|()| area.present()).map_err(|error| {
            Failure::new(Exit::Failed, Report::error(format!("cannot draw the plot: {error}")))
        })
    }

    fn font(&self, size: u32) -> (&'static str, u32) {
        (FAMILY, size * self.scale)
    }

    fn line(&self, color: RGBColor, width: u32) -> ShapeStyle {
        color.stroke_width(width * self.scale)
    }

    fn draw_chart<B: DrawingBackend>(
        &self,
        area: &Area<B>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        area.fill(&WHITE)?;
        let points: Vec<_> =
            self.measured.iter().map(|m| (m.threads as f64, m.median.wall.as_secs_f64())).collect();
        let slowest = points.iter().map(|p| p.1).fold(f64::MIN_POSITIVE, f64::max);
        let most = points.iter().map(|p| p.0).fold(1.0, f64::max);
        let mut chart = ChartBuilder::on(area)
            .caption(
                format!("Time of one picture against the number of threads: {}", self.scene),
                self.font(24),
            )
            .margin(20 * self.scale)
            .x_label_area_size(52 * self.scale)
            .y_label_area_size(76 * self.scale)
            .build_cartesian_2d(0.5..most + 0.5, 0.0..slowest * 1.3)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(self.line(GRID, 1))
            .axis_style(self.line(BLACK, 1))
            .set_all_tick_mark_size(5 * self.scale)
            .x_labels(most.min(16.0) as usize + 1)
            .x_label_formatter(&|x| if x.fract() == 0.0 { format!("{x:.0}") } else { String::new() })
            .y_label_formatter(&|y| decimals(*y, slowest))
            .x_desc("Number of threads")
            .y_desc("Time, s")
            .label_style(self.font(17))
            .axis_desc_style(self.font(19))
            .draw()?;

        let (first, scale) = (points.first().map_or(0.0, |p| p.1), self.scale as i32);
        let legend =
            move |style| move |(x, y): (i32, i32)| PathElement::new([(x, y), (x + 24 * scale, y)], style);
        let ideal = (0..=200)
            .map(|i| 1.0 + (most - 1.0) * f64::from(i) / 200.0)
            .map(move |threads| (threads, first / threads.min(cores() as f64)));
        let (dash, gap) = (8 * self.scale, 6 * self.scale);
        chart
            .draw_series(DashedLineSeries::new(ideal, dash, gap, self.line(IDEAL, 2)))?
            .label(format!("Ideal on {}", plural(cores() as u64, "core")))
            .legend(legend(self.line(IDEAL, 2)));
        chart
            .draw_series(LineSeries::new(points.iter().copied(), self.line(TIME, 3)))?
            .label("Measured, median")
            .legend(legend(self.line(TIME, 3)));
        chart.draw_series(points.iter().map(|p| Circle::new(*p, 5 * scale, TIME.filled())))?;
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .margin(14 * self.scale)
            .legend_area_size(34 * self.scale)
            .label_font(self.font(17))
            .background_style(WHITE.mix(0.9))
            .border_style(self.line(GRID, 1))
            .draw()
    }
}

/// As many decimals as tell the marks of an axis apart.
fn decimals(value: f64, largest: f64) -> String {
    let places = if largest >= 20.0 {
        0
    } else if largest >= 2.0 {
        1
    } else if largest >= 0.2 {
        2
    } else {
        3
    };
    format!("{value:.places$}")
}

fn is_svg(path: &Path) -> bool {
    has_extension(path, "svg")
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case(extension))
}
