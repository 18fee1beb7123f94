//! Whether cells are inverted, decided by how far their nodes have moved since they were last checked.
//!
//! A simplex can only turn inside out by way of a position in which its corners lie in one plane, and then each of them
//! has moved by at least half of the simplex's width, the least distance between two parallel planes with the simplex
//! between them. In 3D the width is at least 6 V / ℓ², in 2D 2 A / ℓ, with ℓ the longest edge. So a group of cells
//! whose nodes have all moved less than that, apart from a translation of the whole group, has not changed its
//! orientation. Only the other groups are checked cell by cell, with the same result as a check of every cell. As long as
//! all nodes together have moved less than any group may, apart from a translation, one pass over them is enough.

use crate::Error;
use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::mesh::inverted::CHUNK;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::determinant;
use crate::geometry::second_order::{CurvedCells, MapCheck};
use rayon::prelude::*;

/// Part of the width up to which movements are trusted, for rounding in the determinants.
const TRUSTED: f64 = 0.9;

/// Cells whose maps are checked together: each costs as much as some dozens of straight ones.
const CHUNK_OF_MAPS: usize = CHUNK / 16;

/// Groups of cells, with the positions in which they were last checked.
#[derive(Default)]
pub(crate) struct CellCheck<const D: usize> {
    groups: Vec<Group<D>>,
    /// All nodes when the groups were looked at last, and how far they may part from there.
    reference: Vec<[f64; D]>,
    margin: f64,
}

struct Group<const D: usize> {
    /// Block of cells of second order, whose maps are looked at; `None`: straight cells.
    curved: Option<usize>,
    cells: std::ops::Range<usize>,
    /// Its nodes, each once, and where they were.
    nodes: Vec<u32>,
    reference: Vec<[f64; D]>,
    /// Least width of a corner's simplex of any of its cells; 0 before the first check.
    width: f64,
}

impl<const D: usize> CellCheck<D> {
    /// Nothing has been checked yet.
    pub(crate) fn new(cells: &Cells, curved: &[CurvedCells]) -> Self {
        let mut groups = Vec::new();
        let group = |curved, cells, mut nodes: Vec<u32>| {
            nodes.sort_unstable();
            nodes.dedup();
            nodes.shrink_to_fit();
            Group { curved, cells, nodes, reference: Vec::new(), width: 0.0 }
        };
        // First, so that a point is named rather than a part of a cell.
        for (block, of_block) in curved.iter().enumerate() {
            for start in (0..of_block.len()).step_by(CHUNK_OF_MAPS) {
                let range = start..(start + CHUNK_OF_MAPS).min(of_block.len());
                let nodes = range.clone().flat_map(|cell| of_block.points(cell)).copied().collect();
                groups.push(group(Some(block), range, nodes));
            }
        }
        for range in cells.block_ranges() {
            for start in range.clone().step_by(CHUNK) {
                let cells_of = start..(start + CHUNK).min(range.end);
                let nodes = cells_of.clone().flat_map(|cell| cells.nodes(cell)).copied().collect();
                groups.push(group(None, cells_of, nodes));
            }
        }
        Self { groups, reference: Vec::new(), margin: 0.0 }
    }

    /// Checks that no cell is inverted or without measure at `coords`; the lowest offending cell is named.
    ///
    /// # Errors
    /// [`Error::InvertedCell`], [`Error::FoldedCell`], [`Error::ZeroMeasure`].
    pub(crate) fn check(
        &mut self,
        cells: &Cells,
        curved: &[CurvedCells],
        coords: &[[f64; D]],
        parallel: bool,
    ) -> Result<(), Error> {
        if self.margin > 0.0 && self.parted(coords) < self.margin {
            return Ok(());
        }
        self.margin = 0.0;
        let check = |group: &mut Group<D>| group.check(cells, curved, coords);
        let margins: Vec<Result<f64, Error>> = if parallel {
            self.groups.par_iter_mut().map(check).collect()
        } else {
            self.groups.iter_mut().map(check).collect()
        };
        // The lowest of several offending cells, whichever thread finds one first.
        let margins: Vec<f64> = margins.into_iter().collect::<Result<_, _>>()?;
        self.margin = margins.into_iter().fold(f64::INFINITY, f64::min);
        self.reference.clear();
        self.reference.extend_from_slice(coords);
        Ok(())
    }

    /// A bound of how far any two nodes have moved apart; no number where a node has none.
    fn parted(&self, coords: &[[f64; D]]) -> f64 {
        let (mut moved, mut sum) = (Aabb::<D>::empty(), Vector::<D>::zeros());
        for (x, from) in coords.iter().zip(&self.reference) {
            let way = Vector::from(*x) - Vector::from(*from);
            moved.include(&way);
            sum += way;
        }
        if sum.iter().all(|sum| sum.is_finite()) { moved.extent().norm() } else { f64::NAN }
    }
}

impl<const D: usize> Group<D> {
    /// How much farther its nodes may part.
    fn check(&mut self, cells: &Cells, curved: &[CurvedCells], coords: &[[f64; D]]) -> Result<f64, Error> {
        if self.width > 0.0 {
            let margin = 0.5 * TRUSTED * self.width - self.moved(coords);
            if margin > 0.0 {
                return Ok(margin);
            }
        }
        let (range, width) = (self.cells.clone(), |cell| width(cells, cell, coords));
        self.width = match self.curved {
            Some(block) => curved[block].check(range, coords, MapCheck::OnTheWay)?,
            None => {
                cells.check_range(range.clone(), coords)?;
                range.map(width).fold(f64::INFINITY, f64::min)
            }
        };
        self.reference.clear();
        self.reference.extend(self.nodes.iter().map(|&n| coords[n as usize]));
        Ok(0.5 * TRUSTED * self.width)
    }

    /// Largest displacement of a node since then, relative to that of the first.
    fn moved(&self, coords: &[[f64; D]]) -> f64 {
        let way = |(&node, x): (&u32, &[f64; D])| Vector::<D>::from(coords[node as usize]) - Vector::from(*x);
        let mut ways = self.nodes.iter().zip(&self.reference).map(way);
        let Some(of_all) = ways.next() else { return 0.0 };
        // A way that is no number makes the sum one that is not less than any width.
        let most = ways.fold(0.0f64, |most, way| {
            let squared = (way - of_all).norm_squared();
            if squared > most || squared.is_nan() { squared } else { most }
        });
        most.sqrt()
    }
}

/// Least width of the simplices at a cell's corners.
fn width<const D: usize>(cells: &Cells, cell: usize, coords: &[[f64; D]]) -> f64 {
    let nodes = cells.nodes(cell);
    let x = |n: usize| Vector::<D>::from(coords[nodes[n] as usize]);
    let mut least = f64::INFINITY;
    for corner in cells.cell_type(cell).corners() {
        let edges: [Vector<D>; D] = std::array::from_fn(|k| x(corner[k + 1]) - x(corner[0]));
        let mut longest = 0.0f64;
        for k in 0..D {
            longest = longest.max(edges[k].norm_squared());
            for other in &edges[..k] {
                longest = longest.max((edges[k] - other).norm_squared());
            }
        }
        let across = if D == 2 { longest.sqrt() } else { longest };
        least = least.min(determinant(&edges).abs() / across);
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Bodies, CellBlock, CellType, Surface};
    use fmc_shapes::{cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6};

    /// Nodes move at random until cells are inverted: at every step the result is that of a check of every cell.
    #[test]
    fn kept_checks_answer_as_checks_of_every_cell() {
        let meshes = [
            (cuboid_tet4([0.0; 3], [1.0; 3], [9, 8, 7]), CellType::Tet4),
            (cuboid_hex8([0.0; 3], [1.0; 3], [14, 13, 9]), CellType::Hex8),
            (cuboid_wedge6([0.0; 3], [1.0; 3], [12, 11, 9]), CellType::Wedge6),
            (cuboid_pyramid5([0.0; 3], [1.0; 3], [8, 8, 7]), CellType::Pyramid5),
        ];
        for (mesh, cell_type) in meshes {
            let blocks = [CellBlock { cell_type, conn: &mesh.conn }];
            let surface = Surface::from_cells(&mesh.coords, &blocks, Bodies::Connected).expect("a valid mesh");
            let cells = surface.cells.as_ref().expect("cells");
            let mut kept = CellCheck::new(cells, &[]);
            let (mut passed, mut trusted, mut failed) = (0, 0, 0);
            for step in 0..60 {
                let s = f64::from(step);
                let mut coords = mesh.clone().rotated([1.0, 2.0, 3.0], 0.002 * s).coords;
                for (node, x) in coords.iter_mut().enumerate() {
                    for (axis, x) in x.iter_mut().enumerate() {
                        let noise = ((node * 31 + axis * 17) % 101) as f64 / 101.0 - 0.5;
                        *x += 0.4 * s + 4e-3 * s * noise;
                    }
                }
                let before: Vec<f64> = kept.groups.iter().map(|group| group.moved(&coords)).collect();
                trusted += kept.groups.iter().zip(&before).filter(|(g, m)| 2.0 * **m < TRUSTED * g.width).count();
                let expected = cells.check_range(0..cells.len(), &coords);
                for parallel in [false, true] {
                    assert_eq!(kept.check(cells, &[], &coords, parallel), expected, "{cell_type:?}, step {step}");
                }
                if expected.is_ok() { passed += 1 } else { failed += 1 }
            }
            assert!(passed > 5 && failed > 5 && trusted > 10, "{passed} passed, {trusted} trusted, {failed} failed");
        }
    }
}
