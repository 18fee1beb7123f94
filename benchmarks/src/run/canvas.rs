//! One frame of an animation as pixels.

use anyhow::{Result, anyhow};
use colorous::VIRIDIS;
use plotters::coord::Shift;
use plotters::prelude::*;

/// Sides of the part of the plane that is shown, pixels, at most; and room for title and colour bar.
const LONGEST: f64 = 470.0;
const TOP: i32 = 64;
const RIGHT: i32 = 116;
const MARGIN: i32 = 14;

/// Where things are on every frame.
pub(super) struct Canvas {
    /// Pixels.
    pub(super) size: (u32, u32),
    low: [f64; 2],
    high: [f64; 2],
    /// Pixels per m.
    scale: f64,
    title: String,
    /// Value of the brightest colour, Pa.
    brightest: f64,
}

impl Canvas {
    /// Shows the rectangle from `low` to `high`; values from 0 to `brightest` are coloured.
    pub(super) fn new(title: &str, low: [f64; 2], high: [f64; 2], brightest: f64) -> Self {
        let sides = [high[0] - low[0], high[1] - low[1]];
        let scale = LONGEST / sides[0].max(sides[1]);
        let pixels = sides.map(|side| (side * scale).ceil() as i32);
        let size = ((pixels[0] + RIGHT + 2 * MARGIN) as u32, (pixels[1] + TOP + MARGIN) as u32);
        Self { size, low, high, scale, title: title.to_owned(), brightest }
    }

    /// Draws cells, each with its corners and its value, and returns red, green and blue of all pixels.
    pub(super) fn draw<'a>(
        &self,
        time: &str,
        cells: impl Iterator<Item = (Vec<[f64; 2]>, f64)> + 'a,
    ) -> Result<Vec<u8>> {
        let mut pixels = vec![255; (self.size.0 * self.size.1 * 3) as usize];
        {
            let area = BitMapBackend::with_buffer(&mut pixels, self.size).into_drawing_area();
            self.draw_on(&area, time, cells).map_err(|error| anyhow!("a frame cannot be drawn: {error}"))?;
        }
        Ok(pixels)
    }

    fn draw_on<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        time: &str,
        cells: impl Iterator<Item = (Vec<[f64; 2]>, f64)>,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        area.fill(&WHITE)?;
        for (corners, value) in cells {
            let part = value / self.brightest;
            let mut places: Vec<(i32, i32)> = corners.iter().map(|x| self.place(x)).collect();
            area.draw(&Polygon::new(places.clone(), rgb(color(part)).filled()))?;
            places.extend(places.first().copied());
            area.draw(&PathElement::new(places, rgb(line_color(part)).stroke_width(1)))?;
        }
        area.draw(&Text::new(self.title.as_str(), (MARGIN, 10), ("sans-serif", 18).into_font()))?;
        area.draw(&Text::new(time, (MARGIN, 34), ("sans-serif", 18).into_font()))?;
        self.color_bar(area)?;
        area.present()
    }

    fn color_bar<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        let left = self.size.0 as i32 - RIGHT + 10;
        let (top, height) = (TOP + 44, 240.min(self.size.1 as i32 - TOP - 60));
        let label = |text: &str, y: i32| Text::new(text.to_owned(), (left, y), ("sans-serif", 15).into_font());
        area.draw(&label("von Mises", TOP - 4))?;
        let (unit, factor) = if self.brightest >= 1e6 { ("MPa", 1e-6) } else { ("Pa", 1.0) };
        area.draw(&label(&format!("stress, {unit}"), TOP + 14))?;
        for row in 0..height {
            let part = 1.0 - f64::from(row) / f64::from(height - 1);
            let line = PathElement::new([(left, top + row), (left + 20, top + row)], rgb(color(part)).stroke_width(1));
            area.draw(&line)?;
        }
        for quarter in 0..=4 {
            let part = f64::from(quarter) / 4.0;
            let y = top + height - 1 - (part * f64::from(height - 1)) as i32;
            area.draw(&PathElement::new([(left + 20, y), (left + 25, y)], BLACK.stroke_width(1)))?;
            let text = format!("{}", round(part * self.brightest * factor));
            area.draw(&Text::new(text, (left + 30, y - 7), ("sans-serif", 14).into_font()))?;
        }
        Ok(())
    }

    /// Pixel of a point.
    fn place(&self, x: &[f64; 2]) -> (i32, i32) {
        let right = ((x[0] - self.low[0]) * self.scale).round() as i32;
        let down = ((self.high[1] - x[1]) * self.scale).round() as i32;
        (MARGIN + right, TOP + down)
    }
}

/// Three decimals at most.
fn round(x: f64) -> f64 {
    (x * 1e3).round() / 1e3
}

fn rgb([r, g, b]: [u8; 3]) -> RGBColor {
    RGBColor(r, g, b)
}

/// Colours of the scale. Few enough that most cells keep theirs from frame to frame, which makes the file small.
const STEPS: usize = 40;

/// How much darker the lines between cells are.
const LINE_SHADE: f64 = 0.82;

/// Colour of a value between 0 and 1.
fn color(value: f64) -> [u8; 3] {
    VIRIDIS.eval_rational((value.clamp(0.0, 1.0) * (STEPS - 1) as f64).round() as usize, STEPS).into_array()
}

/// Colour of the lines around a cell of that value.
fn line_color(value: f64) -> [u8; 3] {
    color(value).map(|k| (f64::from(k) * LINE_SHADE).round() as u8)
}
