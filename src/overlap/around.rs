//! The cells of a body around a facet of another, found from neighbour to neighbour.
//!
//! The part of the body in a box is bounded, inside the box, by boundary facets that meet the box. So whoever starts at
//! the cells of those facets, and goes from cell to neighbour while the cell's box meets the box, finds every cell in
//! the box, unless no boundary facet meets it at all. The cost is that of the cells found, whatever the size of the
//! body.

use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::cells::Cells;

/// A walk from cell to cell; its memory serves one box after the other.
#[derive(Default)]
pub(crate) struct Walk {
    met: CellSet,
    queue: Vec<u32>,
    found: Vec<u32>,
}

impl Walk {
    /// Cells whose box meets `query`, ascending: those of `starts`, and those that can be reached from them.
    pub(crate) fn around<const D: usize>(
        &mut self,
        cells: &Cells,
        coords: &[[f64; D]],
        starts: impl IntoIterator<Item = u32>,
        query: &Aabb<D>,
    ) -> &[u32] {
        self.met.clear();
        self.queue.clear();
        self.found.clear();
        for start in starts {
            if self.met.insert(start) {
                self.queue.push(start);
            }
        }
        while let Some(cell) = self.queue.pop() {
            let mut aabb = Aabb::<D>::empty();
            for &n in cells.nodes(cell as usize) {
                let x = Vector::<D>::from(coords[n as usize]);
                aabb = Aabb { min: aabb.min.inf(&x), max: aabb.max.sup(&x) };
            }
            if !aabb.meets(query) {
                continue;
            }
            self.found.push(cell);
            for face in 0..cells.cell_type(cell as usize).faces().len() {
                if let Some(next) = cells.neighbour(cell as usize, face)
                    && self.met.insert(next)
                {
                    self.queue.push(next);
                }
            }
        }
        self.found.sort_unstable();
        &self.found
    }
}

/// A set of cells: a table in which a cell stands at its hash or at the next place that was free.
#[derive(Default)]
struct CellSet {
    table: Vec<u32>,
    count: usize,
}

/// No cell; marks a free place.
const FREE: u32 = u32::MAX;

impl CellSet {
    fn clear(&mut self) {
        self.table.fill(FREE);
        self.count = 0;
    }

    /// Whether the cell is new.
    fn insert(&mut self, cell: u32) -> bool {
        if 2 * self.count >= self.table.len() {
            let larger = vec![FREE; (2 * self.table.len()).max(128)];
            let cells = std::mem::replace(&mut self.table, larger);
            self.count = 0;
            cells.into_iter().filter(|&c| c != FREE).for_each(|c| {
                self.insert(c);
            });
        }
        let mask = self.table.len() - 1;
        // Multiplication by 2³²/φ spreads neighbours; the upper bits are the spread ones.
        let mut place = (cell.wrapping_mul(0x9E37_79B9) >> 12) as usize & mask;
        while self.table[place] != FREE {
            if self.table[place] == cell {
                return false;
            }
            place = (place + 1) & mask;
        }
        self.table[place] = cell;
        self.count += 1;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Bodies, CellBlock, CellType, Surface};
    use fmc_shapes::{cuboid_hex8, cuboid_tet4};

    #[test]
    fn cells_in_a_box_against_brute_force() {
        let meshes = [
            (cuboid_tet4([0.0; 3], [1.0; 3], [5, 6, 7]), CellType::Tet4),
            (cuboid_hex8([0.0; 3], [1.0; 3], [9, 8, 7]), CellType::Hex8),
        ];
        for (mesh, cell_type) in meshes {
            let mesh = mesh.rotated([1.0, 2.0, 3.0], 0.5);
            let blocks = [CellBlock { cell_type, conn: &mesh.conn }];
            let surface = Surface::from_cells(&mesh.coords, &blocks, Bodies::Connected).expect("a valid mesh");
            let cells = surface.cells.as_ref().expect("cells");
            let boxes: Vec<Aabb<3>> = (0..cells.len())
                .map(|c| {
                    let x: Vec<Vector<3>> = cells.nodes(c).iter().map(|&n| mesh.coords[n as usize].into()).collect();
                    Aabb::of(&x)
                })
                .collect();
            let points = surface.points(&mesh.coords);
            let mut walk = Walk::default();
            for (facet, corners) in surface.facets.iter().enumerate() {
                let query = Aabb::of(corners.iter().map(|&v| &points[v as usize])).inflated(0.02 * (facet % 9) as f64);
                // From all facets in the box, as the walk promises; one of them is enough here, where the box is small.
                let starts = (0..surface.facets.len())
                    .filter(|&f| Aabb::of(surface.facets[f].iter().map(|&v| &points[v as usize])).meets(&query))
                    .map(|f| surface.facet_cell[f]);
                let expected: Vec<u32> = (0..cells.len() as u32).filter(|&c| boxes[c as usize].meets(&query)).collect();
                assert_eq!(walk.around(cells, &mesh.coords, starts, &query), expected);
            }
        }
    }

    #[test]
    fn cells_are_new_once() {
        let mut set = CellSet::default();
        for round in 0..3 {
            set.clear();
            assert!((0..1000).all(|c| set.insert(c * 37 + round)));
            assert!((0..1000).all(|c| !set.insert(c * 37 + round)));
        }
    }
}
