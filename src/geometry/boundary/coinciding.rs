//! Faces of one body that lie on one another and look at each other: where nodes were not merged, or a flat cell was left out, the mesh is
//! torn there, and inner faces count as surface.

use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::{Surface, Vector};

/// How far apart such faces may be, by the longest edge of the smaller: coordinates that were written with seven digits.
const APART: f64 = 1e-6;

/// How far one may lie behind the other, by the same, where their cells share nodes: a cell as thin as that may be meant.
const BEHIND: f64 = 1e-9;

/// What of a body's surface coincides.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CoincidingFaces {
    pub(crate) body: usize,
    /// Area (2D: length), counted once for both sides.
    pub(crate) area: f64,
    /// Nodes of these faces, ascending.
    pub(crate) nodes: Vec<u32>,
}

/// A facet with what decides whether it meets another.
struct Piece<const D: usize> {
    corners: [Vector<D>; D],
    /// As long as its area.
    normal: Vector<D>,
    /// Its longest edge.
    size: f64,
}

impl<const D: usize> Piece<D> {
    fn new(corners: [Vector<D>; D]) -> Self {
        let edges = (0..D).map(|k| (corners[(k + 1) % D] - corners[k]).norm());
        Self { normal: area_vector(&corners), size: edges.fold(0.0, f64::max), corners }
    }

    /// Where the corners of another lie in front of this one, least and most.
    fn in_front(&self, other: &Self) -> [f64; 2] {
        let normal = self.normal / self.normal.norm();
        let heights = other.corners.map(|x| normal.dot(&(x - self.corners[0])));
        [heights.into_iter().fold(f64::INFINITY, f64::min), heights.into_iter().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// Area of what lies over this one of another in the same plane.
    fn common(&self, other: &Self) -> f64 {
        if D == 2 {
            let along = (self.corners[1] - self.corners[0]) / self.size;
            let mut ends = other.corners.map(|x| along.dot(&(x - self.corners[0])));
            ends.sort_by(f64::total_cmp);
            return (ends[1].min(self.size) - ends[0].max(0.0)).max(0.0);
        }
        let mut polygon: Vec<Vector<D>> = other.corners.to_vec();
        for k in 0..D {
            let (from, to) = (self.corners[k], self.corners[(k + 1) % D]);
            // Inwards across the edge.
            let mut spanned = self.corners;
            (spanned[0], spanned[1], spanned[2]) = (from, to, from + self.normal);
            let inwards = -area_vector(&spanned);
            polygon = clipped(&polygon, |x| inwards.dot(&(x - from)));
        }
        let parts = (1..polygon.len().saturating_sub(1)).map(|k| {
            let mut corners = other.corners;
            (corners[0], corners[1], corners[2]) = (polygon[0], polygon[k], polygon[k + 1]);
            area_vector(&corners)
        });
        parts.sum::<Vector<D>>().norm()
    }
}

/// The part of a convex polygon on which a linear function is not negative.
fn clipped<const D: usize>(polygon: &[Vector<D>], height: impl Fn(&Vector<D>) -> f64) -> Vec<Vector<D>> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (k, x) in polygon.iter().enumerate() {
        let y = &polygon[(k + 1) % polygon.len()];
        let (at, then) = (height(x), height(y));
        if at >= 0.0 {
            left.push(*x);
        }
        if (at >= 0.0) != (then >= 0.0) {
            left.push(x + (y - x) * (at / (at - then)));
        }
    }
    left
}

impl<const D: usize> Surface<D> {
    /// Faces of one body that coincide without deformation, body by body. None of a surface that was given by facets, or of a part of a
    /// mesh, whose ends are no faces.
    pub(crate) fn coinciding_faces(&self) -> Vec<CoincidingFaces> {
        if self.cells.is_none() || self.submesh.is_some() {
            return Vec::new();
        }
        let points = self.points(self.reference());
        (0..self.ranges.len()).filter_map(|body| self.coinciding_of(body, &points)).collect()
    }

    fn coinciding_of(&self, body: usize, points: &[Vector<D>]) -> Option<CoincidingFaces> {
        let facets = &self.facets[self.ranges[body].clone()];
        let pieces: Vec<Piece<D>> =
            facets.iter().map(|facet| Piece::new(facet.map(|vertex| points[vertex as usize]))).collect();
        let boxes: Vec<Aabb<D>> =
            pieces.iter().map(|piece| Aabb::of(&piece.corners).inflated(APART * piece.size)).collect();
        let tree = Tree::new(&boxes);
        let mut found = CoincidingFaces { body, area: 0.0, nodes: Vec::new() };
        tree.visit_pairs(&tree, [&boxes, &boxes], |i, j| {
            if i < j {
                let area = self.common_area(body, [i as usize, j as usize], &pieces);
                found.area += area;
                if area > 0.0 {
                    let vertices = [i, j].into_iter().flat_map(|facet| facets[facet as usize]);
                    found.nodes.extend(vertices.flat_map(|vertex| self.nodes_of_vertex(vertex)).map(|(node, _)| node));
                }
            }
        });
        found.nodes.retain(|&node| (node as usize) < self.node_count());
        found.nodes.sort_unstable();
        found.nodes.dedup();
        (found.area > 0.0).then_some(found)
    }

    fn common_area(&self, body: usize, [i, j]: [usize; 2], pieces: &[Piece<D>]) -> f64 {
        let (large, small) = if pieces[i].size >= pieces[j].size { (i, j) } else { (j, i) };
        let (large, small) = (&pieces[large], &pieces[small]);
        let product = large.normal.norm() * small.normal.norm();
        // Most neighbours end here. An angle whose cosine is as near to one is some 1e-3.
        if large.normal.dot(&small.normal) > -(1.0 - APART) * product || product <= 0.0 {
            return 0.0;
        }
        let cells = [i, j].map(|facet| self.facet_cell[self.ranges[body].start + facet] as usize);
        let [one, other] = cells.map(|cell| self.cells.as_ref().map_or(&[][..], |cells| cells.nodes(cell)));
        let are_neighbours = one.iter().any(|node| other.contains(node));
        let behind = if are_neighbours { BEHIND } else { APART };
        let [least, most] = large.in_front(small);
        if cells[0] == cells[1] || least < -behind * small.size || most > APART * small.size {
            return 0.0;
        }
        let area = large.common(small);
        if area > APART * small.normal.norm() { area } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Bodies, CellBlock, CellType};

    fn of<const D: usize>(coords: &[[f64; D]], cell_type: CellType, conn: &[u32]) -> Vec<CoincidingFaces> {
        let blocks = [CellBlock { cell_type, conn }];
        let ids = vec![4; conn.len() / cell_type.node_count()];
        Surface::from_cells(coords, &blocks, Bodies::Ids(&ids)).expect("cells").coinciding_faces()
    }

    /// Two squares in a row that are one, that touch, that nearly touch, and with a gap.
    #[test]
    fn of_squares() {
        let at = |gap: f64| {
            let x = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
            let shifted = x.map(|[x, y]| [x + 1.0 + gap, y + 0.25]);
            [x, shifted].concat()
        };
        let conn = [0, 1, 2, 3, 4, 5, 6, 7];
        for gap in [0.0, 1e-9, 1e-7, -1e-8] {
            let found = of(&at(gap), CellType::Quad4, &conn);
            let [CoincidingFaces { body: 0, area, nodes }] = &found[..] else { panic!("{gap}: {found:?}") };
            assert!((area - 0.75).abs() < 1e-12, "{gap}: {area}");
            assert_eq!(nodes, &[1, 2, 4, 7]);
        }
        for gap in [1e-5, -1e-5] {
            assert_eq!(of(&at(gap), CellType::Quad4, &conn), []);
        }
    }

    /// A flat tetrahedron between four others was left out: two triangles over two others, of the same nodes.
    #[test]
    fn around_a_flat_tetrahedron() {
        let coords = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [0.5, 0.5, 1.], [0.5, 0.5, -1.]];
        let conn = [0, 1, 2, 4, 0, 2, 3, 4, 0, 3, 1, 5, 1, 3, 2, 5];
        let found = of(&coords, CellType::Tet4, &conn);
        let [CoincidingFaces { body: 0, area, nodes }] = &found[..] else { panic!("{found:?}") };
        assert!((area - 1.0).abs() < 1e-12, "{area}");
        assert_eq!(nodes, &[0, 1, 2, 3]);
    }

    /// Cells that are as thin as 1e-8 of their width are no slits, whatever they are.
    #[test]
    fn thin_cells_are_none() {
        let coords = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0.3, 0.3, 1e-8]];
        assert_eq!(of(&coords, CellType::Tet4, &[0, 1, 2, 3]), []);
        let strip = [[0., 0.], [1., 0.], [2., 0.], [0., 1e-8], [1., 1e-8], [2., 1e-8]];
        assert_eq!(of(&strip, CellType::Tri3, &[0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4]), []);
    }
}
