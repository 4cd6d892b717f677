//! The plot of the time of a ray against the number of triangles.

use super::{Area, BLUE, Chart, Drawn, GREEN, GREY, GRID, ORANGE, Style};
use crate::commands::Curve;
use plotters::prelude::*;

/// The times of a ray against the number of triangles, and the line that fits each best, over the logarithm.
#[derive(Clone, Copy, Debug)]
pub struct Growth<'a> {
    /// What was measured, one for each kind of ray.
    pub curves: &'a [Curve],
}

impl Chart for Growth<'_> {
    fn draw<B: DrawingBackend>(&self, area: &Area<B>, style: Style) -> Drawn<B> {
        let points = || self.curves.iter().flat_map(|c| &c.points);
        let slowest = points().map(|p| p.1).fold(f64::MIN_POSITIVE, f64::max);
        let fewest = points().map(|p| p.0).fold(f64::INFINITY, f64::min);
        let most = points().map(|p| p.0).fold(0.0, f64::max);
        let mut chart = ChartBuilder::on(area)
            .caption("Time of one ray against the number of triangles", style.font(24))
            .margin(20 * style.scale)
            .x_label_area_size(52 * style.scale)
            .y_label_area_size(76 * style.scale)
            .build_cartesian_2d((fewest * 0.8..most * 1.25).log_scale(), 0.0..slowest * 1.3)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(style.line(GRID, 1))
            .axis_style(style.line(BLACK, 1))
            .set_all_tick_mark_size(5 * style.scale)
            .x_label_formatter(&|x| rounded(*x))
            .y_label_formatter(&|y| format!("{y:.0}"))
            .x_desc("Number of triangles")
            .y_desc("Time of a ray, ns")
            .label_style(style.font(17))
            .axis_desc_style(style.font(19))
            .draw()?;
        let colors = [BLUE, GREEN, ORANGE].into_iter().cycle();
        for (i, (curve, color)) in self.curves.iter().zip(colors).enumerate() {
            if let Some(line) = curve.line {
                let ends = [fewest, most].map(|x| (x, line.at(x)));
                let (dash, gap) = (8 * style.scale, 6 * style.scale);
                let series = DashedLineSeries::new(ends, dash, gap, style.line(GREY, 2));
                let drawn = chart.draw_series(series)?;
                if i == 0 {
                    drawn.label("Best straight lines").legend(style.legend(style.line(GREY, 2)));
                }
            }
            chart
                .draw_series(LineSeries::new(curve.points.iter().copied(), style.line(color, 3)))?
                .label(curve.label)
                .legend(style.legend(style.line(color, 3)));
            let dot = |p: &(f64, f64)| Circle::new(*p, 5 * style.scale as i32, color.filled());
            chart.draw_series(curve.points.iter().map(dot))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .margin(14 * style.scale)
            .legend_area_size(34 * style.scale)
            .label_font(style.font(17))
            .background_style(WHITE.mix(0.9))
            .border_style(style.line(GRID, 1))
            .draw()
    }
}

/// "1 k", "300 k", "10 M".
fn rounded(number: f64) -> String {
    match number {
        0.0..1e3 => format!("{number:.0}"),
        1e3..1e6 => format!("{} k", number / 1e3),
        _ => format!("{} M", number / 1e6),
    }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn marks_are_short() {
        assert_eq!([500.0, 1e3, 3e5, 1e7].map(rounded), ["500", "1 k", "300 k", "10 M"]);
    }
}
