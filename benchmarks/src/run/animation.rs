//! The deformed bodies in motion, coloured by von Mises stress, as a GIF.

use super::canvas::Canvas;
use crate::chart;
use anyhow::{Context, Result, anyhow};
use fmc_mesh_io as mesh;
use fmc_mesh_io::write_whole;
use fmc_solid::fem::Model;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use std::path::{Path, PathBuf};

/// Time that a frame and the last frame stay, in hundredths of a second.
const DELAY: u16 = 7;
const LAST_DELAY: u16 = 150;

/// Part of all values that are dimmer than the brightest colour: corners, where stress has no bound, do not dim the
/// rest.
const BRIGHTEST: f64 = 0.99;

/// One frame as the fields hold it.
struct Shape {
    time: f64,
    coords: Vec<[f64; 2]>,
    von_mises: Vec<f64>,
}

/// Writes an animation of frames, given by time and file.
pub(super) fn write<const D: usize>(
    path: &Path,
    title: &str,
    model: &Model<D>,
    frames: impl Iterator<Item = (f64, PathBuf)>,
) -> Result<()> {
    chart::use_font()?;
    let shapes: Vec<Shape> = frames.map(|(time, file)| shape(model, time, &file)).collect::<Result<_>>()?;
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for x in shapes.iter().flat_map(|shape| &shape.coords) {
        for axis in 0..2 {
            low[axis] = low[axis].min(x[axis]);
            high[axis] = high[axis].max(x[axis]);
        }
    }
    let canvas = Canvas::new(title, low, high, brightest(&shapes));
    let size = (canvas.size.0 as u16, canvas.size.1 as u16);
    let cannot = || format!("{} cannot be written", path.display());
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, size.0, size.1, &[]).with_context(cannot)?;
    encoder.set_repeat(Repeat::Infinite).with_context(cannot)?;
    let mut before: Vec<u8> = Vec::new();
    for (number, shape) in shapes.iter().enumerate() {
        let pixels = canvas.draw(&format!("t = {:.2} ms", 1e3 * shape.time), cells(model, shape))?;
        let is_last = number + 1 == shapes.len();
        let frame = changed_part(&pixels, &before, size, if is_last { LAST_DELAY } else { DELAY });
        encoder.write_frame(&frame).with_context(cannot)?;
        before = pixels;
    }
    drop(encoder);
    write_whole(path, bytes)
}

/// Reads a frame back.
fn shape<const D: usize>(model: &Model<D>, time: f64, file: &Path) -> Result<Shape> {
    let displacement = mesh::read_floats(file, "displacement")?;
    let von_mises = mesh::read_floats(file, "von_mises")?;
    let fits = displacement.len() == 3 * model.node_count() && von_mises.len() == model.cell_count();
    let placed = model.coords().iter().zip(displacement.chunks_exact(3)).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]);
    let shape = Shape { time, coords: placed.collect(), von_mises };
    fits.then_some(shape).ok_or_else(|| anyhow!("{} holds other bodies", file.display()))
}

/// Corners and value of all cells.
fn cells<const D: usize>(model: &Model<D>, shape: &Shape) -> impl Iterator<Item = (Vec<[f64; 2]>, f64)> {
    let cells = (0..model.parts().len()).flat_map(|part| model.cells(part));
    let corners = cells.map(|(_, nodes)| nodes.iter().map(|&node| shape.coords[node as usize]).collect());
    corners.zip(shape.von_mises.iter().copied())
}

/// A round number above almost all values.
fn brightest(shapes: &[Shape]) -> f64 {
    let mut values: Vec<f64> = shapes.iter().flat_map(|shape| &shape.von_mises).copied().collect();
    values.sort_unstable_by(f64::total_cmp);
    let value = values.get((values.len() as f64 * BRIGHTEST) as usize).copied().unwrap_or(0.0);
    if value <= 0.0 {
        return 1.0;
    }
    let decade = 10f64.powf(value.log10().floor());
    let round = [1.0, 2.0, 4.0, 5.0, 8.0, 10.0].into_iter().find(|step| step * decade >= value);
    round.unwrap_or(10.0) * decade
}

/// The quantiser takes every pixel (its fastest looks at each thirtieth); it is asked only where there are more than 256 colours.
const EVERY_PIXEL: i32 = 1;

/// The rectangle in which a frame differs from the one before; what is in it and does not differ is transparent.
fn changed_part(pixels: &[u8], before: &[u8], size: (u16, u16), delay: u16) -> Frame<'static> {
    let width = size.0 as usize;
    let color = |pixels: &[u8], index: usize| pixels.get(3 * index..3 * index + 3).map(|c| [c[0], c[1], c[2]]);
    let differs = |index: &usize| color(pixels, *index) != color(before, *index);
    let changed: Vec<(usize, usize)> =
        (0..pixels.len() / 3).filter(differs).map(|index| (index % width, index / width)).collect();
    let range = |values: &dyn Fn(&(usize, usize)) -> usize| {
        let low = changed.iter().map(values).min().unwrap_or(0);
        (low, changed.iter().map(values).max().unwrap_or(low))
    };
    let ((left, right), (top, bottom)) = (range(&|x| x.0), range(&|x| x.1));
    let inside = (top..=bottom).flat_map(|row| (left..=right).map(move |column| row * width + column));
    let mut part: Vec<u8> = inside
        .flat_map(|index| match color(pixels, index).filter(|_| differs(&index)) {
            Some([r, g, b]) => [r, g, b, u8::MAX],
            None => [0; 4],
        })
        .collect();
    let (columns, rows) = ((right - left + 1) as u16, (bottom - top + 1) as u16);
    let frame = Frame::from_rgba_speed(columns, rows, &mut part, EVERY_PIXEL);
    Frame { delay, dispose: DisposalMethod::Keep, top: top as u16, left: left as u16, ..frame }
}
