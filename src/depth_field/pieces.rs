//! The simplices on which the depth field is linear, where they are now.

use super::divisions::MOST_NODES;
use super::field::DepthField;
use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::facet_slopes::cross;

/// A simplex of a cell on which its depth is linear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPiece<const D: usize> {
    pub(crate) cell: u32,
    /// Its number among the simplices of the cell.
    pub(crate) simplex: u32,
    /// Numbers of its corners in the cell.
    pub(crate) numbers: [u8; 4],
    /// D + 1 corners, the least deep first.
    pub(crate) corners: [Vector<D>; 4],
    /// Depth at the corners; less the clearance, where the contact begins below the surface, so that it may be negative.
    pub(crate) depths: [f64; 4],
    /// Weights of the cell's nodes in the corners.
    pub(crate) weights: [[f64; MOST_NODES]; 4],
    /// Gradients of the barycentric coordinates.
    pub(crate) slopes: [Vector<D>; 4],
    /// Gradient of the depth.
    pub(crate) gradient: Vector<D>,
    /// Its measure, positive.
    pub(crate) measure: f64,
    /// +1, or −1 where the cell is inverted.
    pub(crate) sign: f64,
    /// +1 where the corners in their order enclose a positive measure, or −1.
    pub(crate) turn: f64,
    /// Whether the depth is the height above a facet of the body, which the piece has for a face.
    pub(crate) is_at_surface: bool,
    /// Whether its depth falls below facets that are tied: of it only a film counts.
    pub(crate) is_below_tie: bool,
}

impl<const D: usize> DepthPiece<D> {
    /// `None` where it is flat.
    pub(crate) fn new(
        cell: u32,
        corners: [Vector<D>; 4],
        depths: [f64; 4],
        weights: [[f64; MOST_NODES]; 4],
        flipped: bool,
    ) -> Option<Self> {
        let (slopes, signed) = slopes(&corners)?;
        let gradient = (0..=D).fold(Vector::zeros(), |sum, k| sum + slopes[k] * depths[k]);
        let turn = signed.signum();
        let sign = if flipped { -turn } else { turn };
        Some(Self {
            cell,
            simplex: 0,
            numbers: [0; 4],
            corners,
            depths,
            weights,
            slopes,
            gradient,
            measure: signed.abs(),
            sign,
            turn,
            is_at_surface: false,
            is_below_tie: false,
        })
    }

    /// The same with another zero of the depth.
    pub(crate) fn lowered(mut self, by: f64) -> Self {
        self.depths.iter_mut().take(D + 1).for_each(|depth| *depth -= by);
        self
    }

    /// Whether only a part of it counts, that where the depth is positive.
    pub(crate) fn is_cut(&self) -> bool {
        self.depths[..=D].iter().any(|depth| *depth < 0.0)
    }

    /// Barycentric coordinates of a point.
    pub(crate) fn barycentric(&self, x: &Vector<D>) -> [f64; 4] {
        let from = x - self.corners[0];
        let mut all = [0.0; 4];
        let mut rest = 1.0;
        for k in 1..=D {
            all[k] = self.slopes[k].dot(&from);
            rest -= all[k];
        }
        all[0] = rest;
        all
    }

    /// Values that are given at the corners, as values at the cell's nodes: the transpose of the interpolation.
    pub(crate) fn at_nodes(&self, at_corners: &[f64; 4]) -> [f64; MOST_NODES] {
        let mut at_nodes = [0.0; MOST_NODES];
        for k in 0..=D {
            for (sum, weight) in at_nodes.iter_mut().zip(&self.weights[k]) {
                *sum += weight * at_corners[k];
            }
        }
        at_nodes
    }
}

impl<const D: usize> DepthField<D> {
    /// Calls `visit` for every piece of a cell that has a measure, in a fixed order.
    pub(crate) fn for_each_piece(
        &self,
        cells: &Cells,
        cell: usize,
        coords: &[[f64; D]],
        mut visit: impl FnMut(DepthPiece<D>),
    ) {
        let (nodes, flipped) = (cells.nodes(cell), cells.is_flipped(cell));
        let count = nodes.len();
        let mut at_nodes = [Vector::<D>::zeros(); MOST_NODES];
        for (x, &n) in at_nodes.iter_mut().zip(nodes) {
            *x = coords[n as usize].into();
        }
        let depth = |k: usize| self.nodes[nodes[k] as usize];
        let (points, simplices) = self.divisions.get(self.division_of[cell]);
        // Cells that share a point must find it at the same place, to the last bit: its nodes are summed in one order.
        let mut order: [usize; MOST_NODES] = std::array::from_fn(|k| k);
        order[..count].sort_unstable_by_key(|&k| nodes[k]);
        for (number, simplex) in simplices.iter().enumerate() {
            let depth_of = |corner: u8| match (corner as usize).checked_sub(count) {
                Some(point) => points[point].depth(depth, count),
                None => depth(corner as usize),
            };
            let (numbers, depths, is_odd) = by_depth::<D>(simplex.corners, depth_of);
            let (mut corners, mut weights) = ([Vector::zeros(); 4], [[0.0; MOST_NODES]; 4]);
            for k in 0..=D {
                let corner = numbers[k] as usize;
                if let Some(point) = corner.checked_sub(count).map(|point| &points[point]) {
                    corners[k] =
                        order[..count].iter().fold(Vector::zeros(), |sum, &n| sum + at_nodes[n] * point.weights[n]);
                    weights[k] = point.weights;
                } else {
                    (corners[k], weights[k][corner]) = (at_nodes[corner], 1.0);
                }
            }
            if let Some(piece) = DepthPiece::new(cell as u32, corners, depths, weights, flipped != is_odd) {
                let is_at_surface = simplex.is_at_surface;
                visit(DepthPiece { is_at_surface, simplex: number as u32, numbers, ..piece });
            }
        }
    }
}

/// Corners of a simplex, the least deep first, with their depths, and whether an odd number of swaps has brought them there.
fn by_depth<const D: usize>(corners: [u8; 4], depth: impl Fn(u8) -> f64) -> ([u8; 4], [f64; 4], bool) {
    let (mut corners, mut depths, mut is_odd) = (corners, [0.0; 4], false);
    for k in 0..=D {
        depths[k] = depth(corners[k]);
        for place in (1..=k).rev() {
            if depths[place - 1] <= depths[place] {
                break;
            }
            depths.swap(place - 1, place);
            corners.swap(place - 1, place);
            is_odd = !is_odd;
        }
    }
    (corners, depths, is_odd)
}

/// Gradients of the barycentric coordinates of a simplex, and its signed measure; `None` where it is flat.
fn slopes<const D: usize>(corners: &[Vector<D>; 4]) -> Option<([Vector<D>; 4], f64)> {
    let mut slopes = [Vector::zeros(); 4];
    let edge = |k: usize| corners[k] - corners[0];
    let signed = match D {
        2 => {
            let (e, f) = (edge(1), edge(2));
            let twice = e[0] * f[1] - e[1] * f[0];
            (slopes[1][0], slopes[1][1]) = (f[1] / twice, -f[0] / twice);
            (slopes[2][0], slopes[2][1]) = (-e[1] / twice, e[0] / twice);
            twice / 2.0
        }
        _ => {
            let (e, f, g) = (edge(1), edge(2), edge(3));
            let of_first = cross(&f, &g);
            let sixfold = e.dot(&of_first);
            slopes[1] = of_first / sixfold;
            slopes[2] = cross(&g, &e) / sixfold;
            slopes[3] = cross(&e, &f) / sixfold;
            sixfold / 6.0
        }
    };
    slopes[0] = -(slopes[1] + slopes[2] + slopes[3]);
    let is_finite = slopes.iter().all(|slope| slope.iter().all(|x| x.is_finite()));
    (signed != 0.0 && is_finite).then_some((slopes, signed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Bodies, CellBlock, CellType, Surface, Weighting};
    use fmc_shapes::{
        Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_mixed, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6,
        rectangle_quad4, rectangle_tri3,
    };

    /// Pieces fill every cell; those that meet at a point have the same depth there, which is not above the distance
    /// from the surface of the convex body, and 0 on it; below facets the slope is 1.
    fn check<const D: usize>(mesh: &Mesh<D>, cell_type: CellType, low: [f64; D], high: [f64; D]) {
        check_blocks(&[(cell_type, mesh)], low, high);
    }

    /// The same of meshes on the same nodes.
    fn check_blocks<const D: usize>(meshes: &[(CellType, &Mesh<D>)], low: [f64; D], high: [f64; D]) {
        let block = |&(cell_type, mesh)| {
            let mesh: &Mesh<D> = mesh;
            CellBlock { cell_type, conn: &mesh.conn }
        };
        let blocks: Vec<CellBlock> = meshes.iter().map(block).collect();
        let mesh = meshes[0].1;
        let surface = Surface::from_cells(&mesh.coords, &blocks, Bodies::Connected).unwrap();
        let (field, cells) =
            (DepthField::new(&surface, None, Weighting::Plain, None, &|| ()).unwrap(), surface.cells.as_ref().unwrap());
        let mut pieces: Vec<DepthPiece<D>> = Vec::new();
        (0..cells.len()).for_each(|cell| field.for_each_piece(cells, cell, &mesh.coords, |piece| pieces.push(piece)));
        let volume: f64 = pieces.iter().map(|piece| piece.sign * piece.measure).sum();
        let expected: f64 = meshes.iter().map(|(_, mesh)| mesh.measure()).sum();
        assert!((volume / expected - 1.0).abs() < 1e-12, "{volume}");
        let at_surface = pieces.iter().filter(|piece| piece.is_at_surface);
        assert_eq!(at_surface.clone().count(), surface.facets.len());
        at_surface.for_each(|piece| assert!((piece.gradient.norm() - 1.0).abs() < 1e-9, "{:?}", piece.gradient));
        let mut random = Splitmix::new(1);
        for piece in &pieces {
            // In a face, where all pieces around it must agree.
            let face = random.between(0.0, (D + 1) as f64) as usize;
            let mut at: [f64; 4] =
                std::array::from_fn(|k| if k > D || k == face { 0.0 } else { random.between(0.0, 1.0) });
            let sum: f64 = at.iter().sum();
            at.iter_mut().for_each(|w| *w /= sum);
            let x = (0..=D).fold(Vector::zeros(), |x, k| x + piece.corners[k] * at[k]);
            let depth = |piece: &DepthPiece<D>| -> f64 {
                piece.barycentric(&x).iter().zip(&piece.depths).map(|(w, g)| w * g).sum()
            };
            let here = depth(piece);
            let distance = (0..D).map(|i| (x[i] - low[i]).min(high[i] - x[i])).fold(f64::INFINITY, f64::min);
            assert!(here >= -1e-12 && here <= distance + 1e-12, "{here} at a distance of {distance}");
            let around = pieces.iter().filter(|other| other.barycentric(&x)[..=D].iter().all(|w| *w > -1e-12));
            around.for_each(|other| assert!((depth(other) - here).abs() < 1e-10, "{here} and {}", depth(other)));
        }
    }

    #[test]
    fn depth_is_continuous() {
        for cells in [[1, 1], [2, 1], [1, 3], [3, 4]] {
            let (low, high) = ([0.0, 0.0], [1.0, 0.7]);
            let inner = |x: &[f64; 2]| (0..2).all(|i| x[i] > low[i] + 1e-9 && x[i] < high[i] - 1e-9);
            for diagonals in [Diagonals::Same, Diagonals::Alternating] {
                let mesh = rectangle_tri3(low, high, cells, diagonals).jittered(0.2, 1, inner);
                check(&mesh, CellType::Tri3, low, high);
            }
            check(&rectangle_quad4(low, high, cells).jittered(0.2, 2, inner), CellType::Quad4, low, high);
        }
    }

    #[test]
    fn depth_is_continuous_in_space() {
        for cells in [[1, 1, 1], [2, 1, 1], [1, 2, 3], [2, 2, 2], [3, 3, 4]] {
            let (low, high) = ([0.0, 0.0, 0.0], [1.0, 0.7, 0.9]);
            let inner = |x: &[f64; 3]| (0..3).all(|i| x[i] > low[i] + 1e-9 && x[i] < high[i] - 1e-9);
            check(&cuboid_tet4(low, high, cells).jittered(0.2, 1, inner), CellType::Tet4, low, high);
            check(&cuboid_hex8(low, high, cells).jittered(0.1, 2, inner), CellType::Hex8, low, high);
            check(&cuboid_wedge6(low, high, cells).jittered(0.1, 3, inner), CellType::Wedge6, low, high);
            check(&cuboid_pyramid5(low, high, cells).jittered(0.1, 4, inner), CellType::Pyramid5, low, high);
            let [a, b, c, d] = cuboid_mixed(low, high, [cells[0], cells[1], cells[2] + 2]);
            let mixed = [(CellType::Hex8, &a), (CellType::Wedge6, &b), (CellType::Pyramid5, &c), (CellType::Tet4, &d)];
            check_blocks(&mixed, low, high);
        }
    }
}
