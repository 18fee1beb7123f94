//! Fibers as cells of a VTU file, to look at.

use super::vtu;
use super::vtu_write::{VtkCell, VtuWriter, in_space};
use anyhow::{Context, Result, ensure};
use fmc_contact::overlap::FiberTrace;
use std::path::Path;

/// Numbers of the types in VTK.
const VERTEX: i64 = 1;
const LINE: i64 = 3;

/// An even selection of at most `most` fibers as lines, their stretches inside both bodies as lines over these, and their
/// crossings as points.
///
/// Of the cells: `piece` is 0 for a fiber, 1 for a stretch, 2 for a crossing; `fiber` is the number among all fibers in the
/// overlap.
pub fn fiber_grid<const D: usize>(traces: &[FiberTrace<D>], most: usize) -> VtuWriter {
    let mut picture = VtuWriter::default();
    let shown = traces.len().min(most);
    let (mut pieces, mut fiber) = (Vec::new(), Vec::new());
    for number in (0..shown).map(|position| position * traces.len() / shown) {
        let trace = &traces[number];
        let ends = [&trace.start, &trace.end].map(|x| picture.point(in_space(x)));
        picture.cell(VtkCell::Line, ends);
        pieces.push(0);
        let points: Vec<u64> = trace.crossings.iter().map(|x| picture.point(in_space(x))).collect();
        for &ends in points.as_chunks::<2>().0 {
            picture.cell(VtkCell::Line, ends);
            pieces.push(1);
        }
        for &point in &points {
            picture.cell(VtkCell::Vertex, [point]);
            pieces.push(2);
        }
        fiber.resize(picture.cell_count(), number as i64);
    }
    picture.cell_integers("piece", &pieces);
    picture.cell_integers("fiber", &fiber);
    picture
}

/// The fibers of a file that [`fiber_grid`] has made.
///
/// # Errors
/// If the file cannot be read or is another one.
pub fn read_fibers(path: &Path) -> Result<Vec<FiberTrace<3>>> {
    let bytes = std::fs::read(path).with_context(|| format!("{} cannot be read", path.display()))?;
    let pieces = |kind: i64| vtu::cells_of_type(&bytes, kind, "fiber").with_context(|| path.display().to_string());
    let mut traces: Vec<(i64, FiberTrace<3>)> = Vec::new();
    for (number, ends) in pieces(LINE)? {
        ensure!(ends.len() == 2, "{}: a line has {} ends", path.display(), ends.len());
        // The line of the whole fiber comes before those of its stretches.
        if traces.last().is_none_or(|(last, _)| *last != number) {
            traces.push((number, FiberTrace { start: ends[0], end: ends[1], crossings: Vec::new() }));
        }
    }
    let mut at = 0;
    for (number, point) in pieces(VERTEX)? {
        while traces.get(at).is_some_and(|(of, _)| *of != number) {
            at += 1;
        }
        let (_, trace) = traces.get_mut(at).with_context(|| format!("{}: a crossing of no fiber", path.display()))?;
        trace.crossings.extend(point);
    }
    Ok(traces.into_iter().map(|(_, trace)| trace).collect())
}
