//! Polygons and lines to pixels.

use anyhow::{Context, Result};
use fmc_mesh_io::write_whole;
use std::path::Path;
use tiny_skia::{Color, FillRule, LineJoin, Paint, PathBuilder, Pixmap, Stroke as Pen, Transform};

/// Red, green, blue and opacity.
pub(super) type Rgba = [u8; 4];

/// A filled polygon.
pub(crate) struct Patch {
    /// Corners in order.
    pub corners: Vec<[f64; 2]>,
    /// Colour inside.
    pub fill: Rgba,
    /// Colour of its edges.
    pub edge: Rgba,
}

/// A straight line.
pub(crate) struct Stroke {
    /// Its ends.
    pub ends: [[f64; 2]; 2],
    /// Its colour.
    pub color: Rgba,
    /// Its width, pixels.
    pub width: f32,
}

/// A round point.
pub(crate) struct Dot {
    /// Where.
    pub at: [f64; 2],
    /// Its colour.
    pub color: Rgba,
    /// Its radius, pixels.
    pub radius: f32,
}

/// A part of the plane with what lies in it; what comes later covers what came before.
#[derive(Default)]
pub(crate) struct Drawing {
    /// Polygons.
    pub patches: Vec<Patch>,
    /// Lines over all polygons.
    pub strokes: Vec<Stroke>,
    /// Points over all lines.
    pub dots: Vec<Dot>,
}

/// Edges of cells smaller than this many pixels would cover the cells.
const LEAST_EDGED: f64 = 7.0;
/// Width of the edges of cells, and of small cells, where an edge in the colour of the cell closes the seams that
/// smoothing leaves between neighbours, pixels.
const EDGE: f32 = 0.9;
const SEAM: f32 = 0.6;

impl Drawing {
    /// Rectangle around all polygons, with a margin of a twentieth of its longer side.
    pub(crate) fn frame(&self) -> [[f64; 2]; 2] {
        let corners = self.patches.iter().flat_map(|patch| &patch.corners);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for corner in corners {
            low = [0, 1].map(|axis| low[axis].min(corner[axis]));
            high = [0, 1].map(|axis| high[axis].max(corner[axis]));
        }
        let margin = 0.05 * (high[0] - low[0]).max(high[1] - low[1]);
        [low.map(|x| x - margin), high.map(|x| x + margin)]
    }

    /// Writes the rectangle `frame` as PNG with `longest` pixels along its longer side.
    ///
    /// # Errors
    /// If the frame is empty or not finite, or the file cannot be written.
    pub(crate) fn write(&self, path: &Path, [low, high]: [[f64; 2]; 2], longest: f64) -> Result<()> {
        let sides = [high[0] - low[0], high[1] - low[1]];
        let scale = longest / sides[0].max(sides[1]);
        let pixels = sides.map(|side| (side * scale).ceil() as u32);
        let mut pixmap = Pixmap::new(pixels[0], pixels[1]).context("there is nothing to draw")?;
        pixmap.fill(Color::WHITE);
        let place = |x: &[f64; 2]| [((x[0] - low[0]) * scale) as f32, ((high[1] - x[1]) * scale) as f32];
        for patch in &self.patches {
            let corners: Vec<[f32; 2]> = patch.corners.iter().map(place).collect();
            let Some(path) = polygon(&corners) else { continue };
            pixmap.fill_path(&path, &paint(patch.fill), FillRule::Winding, Transform::identity(), None);
            let size = f64::from(path.bounds().width().max(path.bounds().height()));
            let (color, width) = if size < LEAST_EDGED { (patch.fill, SEAM) } else { (patch.edge, EDGE) };
            pixmap.stroke_path(&path, &paint(color), &pen(width), Transform::identity(), None);
        }
        for stroke in &self.strokes {
            let [from, to] = stroke.ends.map(|end| place(&end));
            let mut builder = PathBuilder::new();
            builder.move_to(from[0], from[1]);
            builder.line_to(to[0], to[1]);
            let Some(path) = builder.finish() else { continue };
            pixmap.stroke_path(&path, &paint(stroke.color), &pen(stroke.width), Transform::identity(), None);
        }
        for dot in &self.dots {
            let [x, y] = place(&dot.at);
            let Some(path) = PathBuilder::from_circle(x, y, dot.radius) else { continue };
            pixmap.fill_path(&path, &paint(dot.color), FillRule::Winding, Transform::identity(), None);
        }
        let bytes = pixmap.encode_png().context("a picture cannot be encoded")?;
        write_whole(path, bytes)
    }
}

fn polygon(corners: &[[f32; 2]]) -> Option<tiny_skia::Path> {
    let (first, rest) = corners.split_first()?;
    let mut builder = PathBuilder::new();
    builder.move_to(first[0], first[1]);
    rest.iter().for_each(|corner| builder.line_to(corner[0], corner[1]));
    builder.close();
    builder.finish()
}

fn paint(color: Rgba) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(color[0], color[1], color[2], color[3]);
    paint
}

fn pen(width: f32) -> Pen {
    Pen { width, line_join: LineJoin::Round, ..Pen::default() }
}
