//! Draws `docs/fibers.svg` (or the file named on the command line): why fibers.
//!
//! A disc is pressed into a block. Two families of parallel lines run through both; the stretches inside both bodies at once
//! are the spans, their ends are crossings with a facet, and the force on a node is what its crossings add up to.

use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, EnergyLaw, Estimator, FiberOptions, Options, Resolution, Surface,
};
use fmc_shapes::{disc_quad4, rectangle_quad4};
use plotters::prelude::*;
use std::error::Error;

const SIZE: (u32, u32) = (1100, 520);
/// Half of the width of what is shown, and its lowest and highest point.
const VIEW: (f64, f64, f64) = (1.05, -0.56, 0.43);
/// How far fibers are drawn beyond what was traced, and the length of the largest force.
const BEYOND: f64 = 0.16;
const LARGEST: f64 = 0.2;

const DISC: RGBColor = RGBColor(66, 133, 190);
const BLOCK: RGBColor = RGBColor(176, 168, 150);
const FIBER: RGBColor = RGBColor(90, 90, 90);
const SPAN: RGBColor = RGBColor(224, 122, 20);
const FORCE: RGBColor = RGBColor(178, 24, 43);

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "docs/fibers.svg".into());
    let disc = disc_quad4(0.9, 40).rotated(0.03).translated([0.0, 0.72]);
    let mut mesh = disc.clone();
    mesh.append(&rectangle_quad4([-1.5, -1.2], [1.5, 0.0], [25, 10]));
    let ids: Vec<i64> = (0..mesh.cell_count()).map(|cell| i64::from(cell >= disc.cell_count())).collect();
    let block = CellBlock { cell_type: CellType::Quad4, conn: &mesh.conn };
    let surface = Surface::from_cells(&mesh.coords, &[block], Bodies::Ids(&ids))?;

    let with = |estimator| Options { estimator, ..Options::new(EnergyLaw::volume(1.0)) };
    let coarse = FiberOptions { resolution: Resolution::Spacing(0.045), ..FiberOptions::default() };
    let traces = Contact::new(surface.clone(), with(Estimator::Fibers(coarse)))?.trace(&mesh.coords)?;
    let forces =
        Contact::new(surface, with(Estimator::Fibers(FiberOptions::default())))?.evaluate(&mesh.coords)?.forces;

    let root = SVGBackend::new(&file, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let (half, low, high) = VIEW;
    let mut chart = ChartBuilder::on(&root).build_cartesian_2d(-half..half, low..high)?;
    let at = |node: &u32| (mesh.coords[*node as usize][0], mesh.coords[*node as usize][1]);
    for (cell, nodes) in mesh.cells().enumerate() {
        let color = if cell < disc.cell_count() { DISC } else { BLOCK };
        let mut corners: Vec<(f64, f64)> = nodes.iter().map(at).collect();
        chart.draw_series([Polygon::new(corners.clone(), color.mix(0.25).filled())])?;
        corners.push(corners[0]);
        chart.draw_series([PathElement::new(corners, color.stroke_width(1))])?;
    }
    for fiber in &traces {
        let (start, end) = (fiber.start, fiber.end);
        let length = (end[0] - start[0]).hypot(end[1] - start[1]);
        let ahead = [0, 1].map(|axis| (end[axis] - start[axis]) * BEYOND / length);
        let ends = vec![(start[0] - ahead[0], start[1] - ahead[1]), (end[0] + ahead[0], end[1] + ahead[1])];
        chart.draw_series([PathElement::new(ends, FIBER.mix(0.55).stroke_width(1))])?;
        for span in fiber.crossings.chunks_exact(2) {
            let ends: Vec<(f64, f64)> = span.iter().map(|x| (x[0], x[1])).collect();
            chart.draw_series([PathElement::new(ends.clone(), SPAN.stroke_width(3))])?;
            chart.draw_series(ends.into_iter().map(|x| Circle::new(x, 3, SPAN.filled())))?;
        }
    }
    let largest = forces.iter().map(|f| f[0].hypot(f[1])).fold(0.0, f64::max);
    for (node, force) in (0u32..).zip(&forces) {
        let size = force[0].hypot(force[1]);
        if size > 0.02 * largest {
            let (x, y) = at(&node);
            let tip = (x + LARGEST * force[0] / largest, y + LARGEST * force[1] / largest);
            chart.draw_series(arrow((x, y), tip))?;
        }
    }
    let label = |text: &'static str, row: i32, color: RGBColor| {
        let style = ("sans-serif", 19).into_font().color(&color);
        Text::new(text, (24, 430 + 26 * row), style)
    };
    root.draw(&label("fibers: lines in two directions", 0, FIBER))?;
    root.draw(&label("spans: where a fiber is inside both bodies", 1, SPAN))?;
    root.draw(&label("nodal contact forces", 2, FORCE))?;
    root.present()?;
    println!("{file}: {} fibers", traces.len());
    Ok(())
}

/// A shaft and a head.
fn arrow(from: (f64, f64), to: (f64, f64)) -> Vec<PathElement<(f64, f64)>> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    let back = 0.035_f64.min(0.5 * length) / length;
    let wing = |side: f64| (to.0 - back * (dx + side * 0.45 * dy), to.1 - back * (dy - side * 0.45 * dx));
    let style = FORCE.stroke_width(2);
    vec![PathElement::new(vec![from, to], style), PathElement::new(vec![wing(1.0), to, wing(-1.0)], style)]
}
