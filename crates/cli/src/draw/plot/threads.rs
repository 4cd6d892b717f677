//! The plot of time against threads (course work, figure 4.2).

use super::{Area, BLUE, Chart, Drawn, GREY, GRID, Style};
use crate::commands::Measured;
use plotters::prelude::*;
use vitrine::render::threads::of_machine;
use vitrine::summary::plural;

/// The median times against the number of threads, and the ideal: the time of one thread divided by their number, as far
/// as there are cores.
#[derive(Clone, Copy, Debug)]
pub struct Threads<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// What was measured, the fewest threads first.
    pub measured: &'a [Measured],
}

impl Chart for Threads<'_> {
    fn draw<B: DrawingBackend>(&self, area: &Area<B>, style: Style) -> Drawn<B> {
        let points: Vec<_> =
            self.measured.iter().map(|m| (m.threads as f64, m.median.wall.as_secs_f64())).collect();
        let slowest = points.iter().map(|p| p.1).fold(f64::MIN_POSITIVE, f64::max);
        let most = points.iter().map(|p| p.0).fold(1.0, f64::max);
        let mut chart = ChartBuilder::on(area)
            .caption(
                format!("Time of one picture against the number of threads: {}", self.scene),
                style.font(24),
            )
            .margin(20 * style.scale)
            .x_label_area_size(52 * style.scale)
            .y_label_area_size(76 * style.scale)
            .build_cartesian_2d(0.5..most + 0.5, 0.0..slowest * 1.3)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(style.line(GRID, 1))
            .axis_style(style.line(BLACK, 1))
            .set_all_tick_mark_size(5 * style.scale)
            .x_labels(most.min(16.0) as usize + 1)
            .x_label_formatter(&|x| if x.fract() == 0.0 { format!("{x:.0}") } else { String::new() })
            .y_label_formatter(&|y| decimals(*y, slowest))
            .x_desc("Number of threads")
            .y_desc("Time, s")
            .label_style(style.font(17))
            .axis_desc_style(style.font(19))
            .draw()?;

        let first = points.first().map_or(0.0, |p| p.1);
        let ideal = (0..=200)
            .map(|i| 1.0 + (most - 1.0) * f64::from(i) / 200.0)
            .map(move |threads| (threads, first / threads.min(of_machine() as f64)));
        let (dash, gap) = (8 * style.scale, 6 * style.scale);
        chart
            .draw_series(DashedLineSeries::new(ideal, dash, gap, style.line(GREY, 2)))?
            .label(format!("Ideal on {}", plural(of_machine() as u64, "core")))
            .legend(style.legend(style.line(GREY, 2)));
        chart
            .draw_series(LineSeries::new(points.iter().copied(), style.line(BLUE, 3)))?
            .label("Measured, median")
            .legend(style.legend(style.line(BLUE, 3)));
        chart.draw_series(points.iter().map(|p| Circle::new(*p, 5 * style.scale as i32, BLUE.filled())))?;
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .margin(14 * style.scale)
            .legend_area_size(34 * style.scale)
            .label_font(style.font(17))
            .background_style(WHITE.mix(0.9))
            .border_style(style.line(GRID, 1))
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
