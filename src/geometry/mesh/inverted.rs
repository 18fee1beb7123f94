//! Whether cells are inverted, or without measure.
//!
//! Mostly all is well. So blocks of cells are run through with one test, whether all Jacobian determinants of a cell
//! are positive, and only the first cell that fails it is looked at closely.

use super::cells::Cells;
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::determinant;
use crate::geometry::{CellType, Vector};
use std::ops::Range;

/// Cells that are checked together; some microseconds of work.
pub(crate) const CHUNK: usize = 1024;

impl Cells {
    /// Jacobian determinant at every corner of a cell, as given.
    pub(in crate::geometry) fn jacobians<const D: usize>(
        &self,
        cell: usize,
        coords: &[[f64; D]],
    ) -> impl Iterator<Item = f64> {
        let nodes = self.nodes(cell);
        let x = move |n: usize| Vector::<D>::from(coords[nodes[n] as usize]);
        self.cell_type(cell)
            .corners()
            .iter()
            .map(move |corner| determinant::<D>(&std::array::from_fn(|k| x(corner[k + 1]) - x(corner[0]))))
    }

    /// Checks that none of some cells of one block is inverted or without measure at `coords`; the lowest offending
    /// cell is named.
    pub(crate) fn check_range<const D: usize>(&self, cells: Range<usize>, coords: &[[f64; D]]) -> Result<(), Error> {
        for (cell_type, of_block, conn) in self.blocks_of(cells.clone()) {
            let (start, end) = (cells.start.max(of_block.start), cells.end.min(of_block.end));
            if start < end {
                let size = cell_type.node_count();
                let conn = &conn[(start - of_block.start) * size..(end - of_block.start) * size];
                self.check_chunk(cell_type, start..end, conn, coords)?;
            }
        }
        Ok(())
    }

    /// Checks all cells of a mesh that is made: names how many are inverted, unless one without measure comes first.
    pub(in crate::geometry) fn check_all<const D: usize>(&self, coords: &[[f64; D]]) -> Result<(), Error> {
        let Err(first) = self.check_range(0..self.len(), coords) else { return Ok(()) };
        let (mut cells, mut bow_ties) = (Vec::new(), 0);
        for cell in 0..self.len() {
            let is_bow_tie = self.is_bow_tie(cell, coords);
            match self.check_cell(cell, coords) {
                Err(Error::ZeroMeasure { .. }) if !is_bow_tie && cells.is_empty() => return Err(first),
                Err(Error::InvertedCell { .. }) => cells.push(cell),
                Err(_) if is_bow_tie => cells.push(cell),
                _ => continue,
            }
            bow_ties += usize::from(is_bow_tie && cells.last() == Some(&cell));
        }
        if cells.len() > 1 || bow_ties > 0 { Err(Error::InvertedCells { cells, bow_ties }) } else { Err(first) }
    }

    /// Whether edges of a quadrilateral cross: two of its corners turn one way, and two the other. One that turns the other way
    /// makes a dart.
    fn is_bow_tie<const D: usize>(&self, cell: usize, coords: &[[f64; D]]) -> bool {
        if self.cell_type(cell) != CellType::Quad4 {
            return false;
        }
        let found: Vec<f64> = self.jacobians(cell, coords).collect();
        let least = 1e-13 * found.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let turning = |sign: f64| found.iter().filter(|&&x| sign * x > least).count();
        turning(1.0) == 2 && turning(-1.0) == 2
    }

    fn check_chunk<const D: usize>(
        &self,
        cell_type: CellType,
        cells: Range<usize>,
        conn: &[u32],
        coords: &[[f64; D]],
    ) -> Result<(), Error> {
        // One loop for every type, with its corners known to the compiler.
        match cell_type {
            CellType::Tri3 => self.check_cells::<D, 3>(CellType::Tri3, cells, conn, coords),
            CellType::Quad4 => self.check_cells::<D, 4>(CellType::Quad4, cells, conn, coords),
            CellType::Tet4 => self.check_cells::<D, 4>(CellType::Tet4, cells, conn, coords),
            CellType::Wedge6 => self.check_cells::<D, 6>(CellType::Wedge6, cells, conn, coords),
            CellType::Pyramid5 => self.check_cells::<D, 5>(CellType::Pyramid5, cells, conn, coords),
            _ => self.check_cells::<D, 8>(CellType::Hex8, cells, conn, coords),
        }
    }

    #[inline(always)]
    fn check_cells<const D: usize, const N: usize>(
        &self,
        cell_type: CellType,
        cells: Range<usize>,
        conn: &[u32],
        coords: &[[f64; D]],
    ) -> Result<(), Error> {
        let corners = cell_type.corners();
        for (cell, nodes) in cells.zip(conn.as_chunks::<N>().0) {
            let x = nodes.map(|n| Vector::<D>::from(coords[n as usize]));
            let sign = if self.is_flipped(cell) { -1.0 } else { 1.0 };
            let at =
                |corner: &[usize]| sign * determinant::<D>(&std::array::from_fn(|k| x[corner[k + 1]] - x[corner[0]]));
            if !corners.iter().all(|corner| at(corner) > 0.0) {
                self.check_cell(cell, coords)?;
            }
        }
        Ok(())
    }

    fn check_cell<const D: usize>(&self, cell: usize, coords: &[[f64; D]]) -> Result<(), Error> {
        let (mut least, mut sum) = (f64::INFINITY, 0.0);
        for determinant in self.jacobians(cell, coords) {
            let determinant = if self.is_flipped(cell) { -determinant } else { determinant };
            least = least.min(determinant);
            sum += determinant;
        }
        let x = |&n: &u32| Vector::<D>::from(coords[n as usize]);
        let size = Aabb::of(&self.nodes(cell).iter().map(x).collect::<Vec<_>>()).extent().amax().powi(D as i32);
        // Rounding of a determinant of differences is a few 1e-16 of size^D; slivers in use are far above 1e-13.
        if least <= 0.0 && sum.abs() <= 1e-13 * size {
            return Err(Error::ZeroMeasure { cell });
        }
        if least < -1e-13 * size {
            return Err(Error::InvertedCell { cell });
        }
        Ok(())
    }
}
