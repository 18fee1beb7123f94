//! Panels drawn by plotters.
//!
//! The font is part of the program, so that the PNG has text on a machine without fonts.

use super::{Mark, Panel, Series, Sign};
use anyhow::{Context, anyhow};
use fmc_mesh_io::write_whole;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use std::path::Path;

/// Width and height of a picture in SVG; a PNG has `PNG_SCALE` times as many pixels.
const SIZE: (u32, u32) = (1100, 500);
const PNG_SCALE: u32 = 2;

/// Makes the built-in font the one called "sans-serif".
///
/// # Errors
/// If it cannot be read.
pub(crate) fn use_font() -> anyhow::Result<()> {
    register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular())
        .map_err(|_| anyhow!("the built-in font is damaged"))
}

/// Writes `DIR/NAME.svg` and `DIR/NAME.png`.
pub(super) fn draw(directory: &Path, name: &str, title: &str, panels: &[Panel]) -> anyhow::Result<()> {
    use_font()?;
    let svg = directory.join(format!("{name}.svg"));
    let area = SVGBackend::new(&svg, SIZE).into_drawing_area();
    draw_on(&area, 1.0, title, panels).map_err(|error| anyhow!("cannot draw {}: {error}", svg.display()))?;
    // The area writes its file when it is gone.
    drop(area);
    let png = directory.join(format!("{name}.png"));
    let size = (SIZE.0 * PNG_SCALE, SIZE.1 * PNG_SCALE);
    let mut pixels = vec![255; (3 * size.0 * size.1) as usize];
    let area = BitMapBackend::with_buffer(&mut pixels, size).into_drawing_area();
    draw_on(&area, PNG_SCALE.into(), title, panels)
        .map_err(|error| anyhow!("cannot draw {}: {error}", png.display()))?;
    drop(area);
    write_png(&png, size, &pixels).with_context(|| format!("{} cannot be written", png.display()))
}

/// Pixels of red, green and blue as a file.
fn write_png(path: &Path, size: (u32, u32), pixels: &[u8]) -> anyhow::Result<()> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.0, size.1);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    write_whole(path, bytes)
}

type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

/// Title on top, panels side by side, one legend for all of them below.
fn draw_on<DB: DrawingBackend>(area: &DrawingArea<DB, Shift>, scale: f64, title: &str, panels: &[Panel]) -> Drawn<DB> {
    let px = |size: f64| (size * scale) as i32;
    area.fill(&WHITE)?;
    let area = area.margin(px(12.0), 0, 0, px(12.0)).titled(title, ("sans-serif", px(23.0)))?;
    let (_, height) = area.dim_in_pixel();
    let (top, bottom) = area.split_vertically(height as i32 - px(34.0));
    for (panel, area) in panels.iter().zip(top.split_evenly((1, panels.len()))) {
        panel.draw(&area, scale)?;
    }
    if let Some(panel) = panels.first() {
        legend(&bottom, scale, &panel.series)?;
    }
    area.present()
}

impl Panel {
    fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>, scale: f64) -> Drawn<DB> {
        let px = |size: f64| (size * scale) as i32;
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x_range = self.x.range(points().map(|p| self.x.place(p.0)));
        let y_range = self.y.range(points().map(|p| self.y.place(p.1)));
        let (x_ticks, y_ticks) = (self.x.tick_count(&x_range), self.y.tick_count(&y_range));
        let mut chart = ChartBuilder::on(area)
            .margin(px(10.0))
            .set_label_area_size(LabelAreaPosition::Left, px(80.0))
            .set_label_area_size(LabelAreaPosition::Bottom, px(50.0))
            .build_cartesian_2d(x_range, y_range)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225).stroke_width(px(1.0) as u32))
            .axis_style(RGBColor(90, 90, 90).stroke_width(px(1.0) as u32))
            .label_style(("sans-serif", px(17.0)))
            .axis_desc_style(("sans-serif", px(18.0)))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_labels(x_ticks)
            .y_labels(y_ticks)
            .x_label_formatter(&|x| self.x.tick(*x))
            .y_label_formatter(&|y| self.y.tick(*y))
            .draw()?;
        for series in &self.series {
            let places: Vec<_> = series.points.iter().map(|p| (self.x.place(p.0), self.y.place(p.1))).collect();
            match series.mark {
                Mark::Line | Mark::LineAndPoints => {
                    chart.draw_series(LineSeries::new(places.iter().copied(), series.style(scale)))?;
                }
                Mark::Dashes => {
                    let dashes = DashedLineSeries::new(places.iter().copied(), px(7.0), px(5.0), series.style(scale));
                    chart.draw_series(dashes)?;
                }
                Mark::Points => {}
            }
            if series.mark.has_points() {
                for place in places {
                    let at = chart.backend_coord(&place);
                    let (left, top) = area.get_base_pixel();
                    area.draw(&series.sign((at.0 - left, at.1 - top), scale))?;
                }
            }
        }
        Ok(())
    }
}

/// All names in one line.
fn legend<DB: DrawingBackend>(area: &DrawingArea<DB, Shift>, scale: f64, series: &[Series]) -> Drawn<DB> {
    let px = |size: f64| (size * scale) as i32;
    let font = ("sans-serif", px(18.0)).into_font();
    let mut widths = Vec::new();
    for series in series {
        let (width, _) = area.estimate_text_size(&series.name, &font.clone().into())?;
        widths.push(width as i32 + px(70.0));
    }
    let (width, height) = area.dim_in_pixel();
    let mut x = (width as i32 - widths.iter().sum::<i32>()) / 2;
    for (series, width) in series.iter().zip(widths) {
        let (y, end) = (height as i32 / 2, x + px(32.0));
        match series.mark {
            Mark::Points => {}
            Mark::Line | Mark::LineAndPoints => {
                area.draw(&PathElement::new([(x, y), (end, y)], series.style(scale)))?;
            }
            Mark::Dashes => {
                for start in [x, x + px(12.0), x + px(24.0)] {
                    area.draw(&PathElement::new([(start, y), (start + px(8.0), y)], series.style(scale)))?;
                }
            }
        }
        if series.mark.has_points() {
            area.draw(&series.sign(((x + end) / 2, y), scale))?;
        }
        area.draw(&Text::new(series.name.as_str(), (end + px(8.0), y - px(5.0)), font.clone()))?;
        x += width;
    }
    Ok(())
}

impl Series {
    /// Stroke of the line or of the sign.
    fn style(&self, scale: f64) -> ShapeStyle {
        let (r, g, b) = self.color;
        RGBColor(r, g, b).stroke_width((2.0 * scale) as u32)
    }

    /// The sign of a point.
    fn sign<'a, DB: DrawingBackend + 'a>(&self, at: (i32, i32), scale: f64) -> DynElement<'a, DB, (i32, i32)> {
        let (style, size) = (self.style(scale), (4.5 * scale) as i32);
        match self.sign {
            Sign::Circle => Circle::new(at, size, style).into_dyn(),
            Sign::Cross => Cross::new(at, size, style).into_dyn(),
            Sign::Square => {
                let corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)];
                PathElement::new(corners.map(|(x, y)| (at.0 + x * size * 3 / 2, at.1 + y * size * 3 / 2)), style)
                    .into_dyn()
            }
        }
    }
}
