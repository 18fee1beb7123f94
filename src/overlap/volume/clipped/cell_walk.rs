//! The cells of a body around a facet of another, found from neighbour to neighbour.
//!
//! The part of the body in a convex set is bounded, inside that set, by boundary facets that meet it. So whoever starts
//! at the cells of those facets, and goes from cell to neighbour while cells meet the set, finds every cell in it,
//! unless no boundary facet meets it at all. Here the set is the facet's box as far as it lies on the facet's plane.
//! The cost is that of the cells found, whatever the size of the body.

use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::aabb::Aabb;

/// A facet's box, as far as it lies on the facet's plane, both widened by the same distance.
pub(crate) struct Slab<const D: usize> {
    pub(crate) aabb: Aabb<D>,
    point: Vector<D>,
    normal: Vector<D>,
    width: f64,
}

/// A walk from cell to cell; its memory serves one facet after the other.
#[derive(Default)]
pub(crate) struct CellWalk {
    met: CellSet,
    queue: Vec<u32>,
    found: Vec<u32>,
}

impl<const D: usize> Slab<D> {
    /// About a facet with these corners and this area vector.
    pub(crate) fn new(corners: &[Vector<D>; D], area: &Vector<D>, width: f64) -> Self {
        let normal = area.try_normalize(0.0).unwrap_or_else(Vector::zeros);
        Self { aabb: Aabb::of(corners).inflated(width), point: corners[0], normal, width }
    }

    /// Whether the convex hull of some points may meet it.
    pub(crate) fn meets(&self, points: impl Iterator<Item = Vector<D>>) -> bool {
        let (mut aabb, mut low, mut high) = (Aabb::<D>::empty(), f64::INFINITY, f64::NEG_INFINITY);
        for x in points {
            aabb = Aabb { min: aabb.min.inf(&x), max: aabb.max.sup(&x) };
            let height = self.normal.dot(&(x - self.point));
            (low, high) = (low.min(height), high.max(height));
        }
        (low <= self.width) & (high >= -self.width) & aabb.meets(&self.aabb)
    }
}

impl CellWalk {
    /// Cells that may meet `slab`, ascending: those of `starts`, and those that can be reached from them.
    pub(crate) fn around<const D: usize>(
        &mut self,
        cells: &Cells,
        coords: &[[f64; D]],
        starts: impl IntoIterator<Item = u32>,
        slab: &Slab<D>,
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
            if !slab.meets(cells.nodes(cell as usize).iter().map(|&n| coords[n as usize].into())) {
                continue;
            }
            self.found.push(cell);
            for &next in cells.neighbours(cell as usize) {
                if self.met.insert(next) {
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
    use crate::geometry::primitives::facet::area_vector;
    use crate::geometry::{Bodies, CellBlock, CellType, Surface};
    use fmc_shapes::{cuboid_hex8, cuboid_tet4};

    #[test]
    fn cells_on_a_plate_against_brute_force() {
        let meshes = [
            (cuboid_tet4([0.0; 3], [1.0; 3], [5, 6, 7]), CellType::Tet4),
            (cuboid_hex8([0.0; 3], [1.0; 3], [9, 8, 7]), CellType::Hex8),
        ];
        for (mesh, cell_type) in meshes {
            let mut walked = 0;
            let mesh = mesh.rotated([1.0, 2.0, 3.0], 0.5);
            let blocks = [CellBlock { cell_type, conn: &mesh.conn }];
            let surface = Surface::from_cells(&mesh.coords, &blocks, Bodies::Connected).expect("a valid mesh");
            let cells = surface.cells.as_ref().expect("cells");
            let points = surface.points(&mesh.coords);
            let mut walk = CellWalk::default();
            for (facet, vertices) in surface.facets.iter().enumerate() {
                // The facet, moved into the body and out of it.
                let corners = vertices.map(|v| points[v as usize] + Vector::<3>::new(0.03, -0.02, 0.05));
                let slab = Slab::new(&corners, &area_vector(&corners), 0.02 * (facet % 9) as f64);
                let starts = (0..surface.facets.len())
                    .filter(|&f| slab.meets(surface.facets[f].iter().map(|&v| points[v as usize])))
                    .map(|f| surface.facet_cell[f]);
                let place = |&n: &u32| Vector::from(mesh.coords[n as usize]);
                let expected: Vec<u32> = (0..cells.len())
                    .filter(|&c| slab.meets(cells.nodes(c).iter().map(place)))
                    .map(|c| c as u32)
                    .collect();
                let mut starts = starts.peekable();
                // Where no facet of the boundary meets the slab, it lies inside or outside.
                if starts.peek().is_some() {
                    walked += 1;
                    assert_eq!(walk.around(cells, &mesh.coords, starts, &slab), expected);
                }
            }
            assert!(walked > 100, "{walked} walks");
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
