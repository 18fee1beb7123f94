//! The maps of cells of second order: whether they fold, seen at nodes and quadrature points.
//!
//! x(ξ) = Σ Nₐ(ξ) xₐ has the Jacobian J = ∂x/∂ξ. What is at hand are the points X of the division, and the nodes of a cell are
//! fixed combinations of those of its points that stand for nodes; so J is a combination of these points.

use super::entities::Entities;
use super::point_rows::row;
use super::shape_functions::{ShapeFunctions, places, point_places};
use crate::Error;
use crate::error::MapPoint;
use crate::geometry::primitives::facet::determinant;
use crate::geometry::{CellType, Vector};
use nalgebra::DMatrix;
use std::ops::Range;

/// Cells of one type, as given.
#[derive(Clone, Debug)]
pub(crate) struct CurvedCells {
    /// Number of the first of them.
    first: usize,
    size: usize,
    conn: Vec<u32>,
    /// Whether a cell is mirrored, as its straight parts are.
    pub(super) is_flipped: Vec<bool>,
    at: Vec<Place>,
    shape: ShapeFunctions,
    /// Nodes as combinations of points, and where the points of the division stand.
    of_nodes: DMatrix<f64>,
    places: Vec<[f64; 3]>,
}

/// Where maps are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MapCheck {
    /// At nodes and quadrature points: of a mesh as it is given.
    Given,
    /// At quadrature points alone: on the way to an equilibrium a map may fold at a node, where no host integrates.
    OnTheWay,
}

/// A place at which maps are looked at.
#[derive(Clone, Debug)]
struct Place {
    point: MapPoint,
    /// ∂x/∂ξ by axis and point of the cell.
    gradients: Vec<f64>,
    /// How much a line of it can change where points move by one, at most, and all lines together.
    largest: f64,
    norm: f64,
}

impl CurvedCells {
    /// Those of a block of cells of second order; `None` where they are straight.
    pub(super) fn new(cell_type: CellType, first: usize, conn: &[u32]) -> Option<Self> {
        let entities = Entities::of(cell_type)?;
        let (size, dim) = (cell_type.node_count(), cell_type.dimension());
        let shape = ShapeFunctions::of(cell_type, &entities)?;
        let local: Vec<u32> = (0..size as u32).collect();
        let mut points = DMatrix::<f64>::identity(size, size);
        for point in entities.corners..size {
            points.row_mut(point).fill(0.0);
            for (node, weight) in row(&entities, point, &local, Some(point as u32)) {
                points[(point, node as usize)] += weight;
            }
        }
        let nodes = points.try_inverse()?;
        let place = |(point, place): (MapPoint, [f64; 3])| {
            let of_points = shape.gradients(place) * &nodes;
            let line = |axis: usize| of_points.row(axis).iter().copied().collect::<Vec<f64>>();
            let sums = (0..dim).map(|axis| line(axis).iter().map(|x| x.abs()).sum::<f64>());
            let (largest, squared) =
                sums.fold((0.0f64, 0.0), |(most, squared), sum| (most.max(sum), squared + sum * sum));
            Place { point, gradients: (0..dim).flat_map(line).collect(), largest, norm: squared.sqrt() }
        };
        let of_nodes = places(cell_type, &entities).into_iter().enumerate();
        // Derivatives at the apex of a pyramid depend on where one comes from.
        let of_nodes = of_nodes.filter(|(node, _)| cell_type != CellType::Pyramid13 || *node != 4);
        let of_nodes = of_nodes.map(|(node, place)| (MapPoint::Node(node), place));
        let of_quadrature = quadrature_points(cell_type).into_iter().enumerate();
        let of_quadrature = of_quadrature.map(|(number, place)| (MapPoint::Quadrature(number), place));
        let is_flipped = vec![false; conn.len() / size];
        Some(Self {
            first,
            size,
            conn: conn.to_vec(),
            is_flipped,
            at: of_nodes.chain(of_quadrature).map(place).collect(),
            places: (0..entities.count()).map(point_places(cell_type, &entities)).collect(),
            of_nodes: nodes,
            shape,
        })
    }

    pub(crate) fn len(&self) -> usize {
        self.is_flipped.len()
    }

    /// Numbers of these cells among those given.
    pub(super) fn numbers(&self) -> Range<usize> {
        self.first..self.first + self.len()
    }

    /// Points of a cell that stand for its nodes.
    pub(crate) fn points(&self, cell: usize) -> &[u32] {
        &self.conn[cell * self.size..(cell + 1) * self.size]
    }

    /// Where a point of the division stands in the coordinates of the shape functions, by its number in the cell.
    pub(super) fn place_of_point(&self, point: usize) -> [f64; 3] {
        self.places[point]
    }

    /// Where the map of a cell has a place.
    pub(super) fn position<const D: usize>(&self, cell: usize, place: [f64; 3], coords: &[[f64; D]]) -> Vector<D> {
        self.combined(cell, self.shape.values(place), coords)
    }

    /// The points that move a place of a cell, with their weights.
    pub(super) fn weights(&self, cell: usize, place: [f64; 3]) -> impl Iterator<Item = (u32, f64)> {
        let of_points: Vec<f64> = (self.shape.values(place) * &self.of_nodes).iter().copied().collect();
        self.points(cell).iter().copied().zip(of_points)
    }

    /// How fast the position changes along a direction of the coordinates.
    pub(super) fn slope<const D: usize>(
        &self,
        (cell, place): (usize, [f64; 3]),
        direction: [f64; 3],
        coords: &[[f64; D]],
    ) -> Vector<D> {
        self.combined(cell, DMatrix::from_row_slice(1, 3, &direction) * self.shape.gradients(place), coords)
    }

    /// A combination of the nodes of a cell, (1, nodes).
    fn combined<const D: usize>(&self, cell: usize, of_nodes: DMatrix<f64>, coords: &[[f64; D]]) -> Vector<D> {
        let of_points = of_nodes * &self.of_nodes;
        let points = self.points(cell).iter().zip(of_points.iter());
        points.fold(Vector::zeros(), |x, (&point, &weight)| x + Vector::from(coords[point as usize]) * weight)
    }

    /// Checks that no map of some cells folds, at the places that `check` says: a determinant below zero by more than rounding. It may be zero, as at the tip of a
    /// crack, where nodes are drawn to the quarter of an edge or fall together. Returns twice how far every point of these cells
    /// may move, apart from a translation, before a determinant can vanish.
    ///
    /// J + dJ is regular as long as the norm of dJ is below the least singular value of J, which is at least |det J| over
    /// (‖J‖/√(D − 1))^(D − 1), since the others' product is at most that.
    ///
    /// # Errors
    /// [`Error::FoldedCell`], of the lowest cell.
    pub(crate) fn check<const D: usize>(
        &self,
        cells: Range<usize>,
        coords: &[[f64; D]],
        check: MapCheck,
    ) -> Result<f64, Error> {
        let is_looked_at = |place: &&Place| check == MapCheck::Given || matches!(place.point, MapPoint::Quadrature(_));
        let mut x = Vec::with_capacity(self.size);
        let mut width = f64::INFINITY;
        for cell in cells {
            let extent = self.place(cell, coords, &mut x);
            let sign = if self.is_flipped[cell] { -1.0 } else { 1.0 };
            for place in self.at.iter().filter(is_looked_at) {
                let edges = place.edges(&x);
                let determinant = sign * determinant::<D>(&edges);
                if determinant < 0.0 && determinant < -place.rounding(&edges, extent) {
                    return Err(Error::FoldedCell { cell: self.first + cell, at: place.point, determinant });
                }
                let squared = edges.iter().map(|edge| edge.norm_squared()).sum::<f64>() / (D - 1) as f64;
                let others = if D == 2 { squared.sqrt() } else { squared };
                let trusted = 2.0 * determinant.abs() / (others * place.norm);
                // Not a number where all points fall together.
                width = if trusted < width || trusted.is_nan() { trusted } else { width };
            }
        }
        Ok(if width.is_nan() { 0.0 } else { width })
    }

    /// Points of a cell from its first one, and the largest coordinate.
    fn place<const D: usize>(&self, cell: usize, coords: &[[f64; D]], x: &mut Vec<Vector<D>>) -> f64 {
        let points = self.points(cell);
        let from = Vector::<D>::from(coords[points[0] as usize]);
        x.clear();
        let mut extent = 0.0f64;
        for &point in points {
            let at = Vector::<D>::from(coords[point as usize]);
            extent = extent.max(at.amax());
            x.push(at - from);
        }
        extent
    }

    /// A place at which the map of a cell folds whose straight parts are not all turned the same way: one against the sum.
    pub(super) fn fold<const D: usize>(&self, cell: usize, coords: &[[f64; D]]) -> Option<Error> {
        let mut x = Vec::with_capacity(self.size);
        self.place(cell, coords, &mut x);
        let sum: f64 = self.at.iter().map(|place| determinant::<D>(&place.edges(&x))).sum();
        let mut turned = self.clone();
        turned.is_flipped[cell] = sum < 0.0;
        turned.check(cell..cell + 1, coords, MapCheck::Given).err()
    }
}

impl Place {
    /// Lines of J.
    #[inline(always)]
    fn edges<const D: usize>(&self, x: &[Vector<D>]) -> [Vector<D>; D] {
        let mut edges = [Vector::<D>::zeros(); D];
        for (edge, line) in edges.iter_mut().zip(self.gradients.chunks_exact(x.len())) {
            for (x, gradient) in x.iter().zip(line) {
                for axis in 0..D {
                    edge[axis] += gradient * x[axis];
                }
            }
        }
        edges
    }

    /// What rounding of coordinates and of J may make of a determinant of zero.
    fn rounding<const D: usize>(&self, edges: &[Vector<D>; D], extent: f64) -> f64 {
        let axes = (D as f64).sqrt();
        let of_edge = 16.0 * f64::EPSILON * axes * extent * self.largest;
        let longest = edges.iter().map(|edge| edge.norm()).fold(0.0, f64::max);
        D as f64 * of_edge * (longest + of_edge).powi(D as i32 - 1)
    }
}

/// Points of the rules with which stiffness is mostly integrated: three or four in simplices, three a direction in
/// quadrilaterals and hexahedra, three times three in wedges, two a direction in pyramids; the first coordinate runs fastest.
fn quadrature_points(cell_type: CellType) -> Vec<[f64; 3]> {
    let gauss = |n: usize| match n {
        1 => vec![0.0],
        2 => [-1.0, 1.0].map(|side: f64| 0.5 + side * (1.0 / 12.0f64).sqrt()).to_vec(),
        _ => [-1.0, 0.0, 1.0].map(|side: f64| 0.5 + side * 0.15f64.sqrt()).to_vec(),
    };
    let product = |x: usize, y: usize, z: usize| {
        let (x, y, z) = (gauss(x), gauss(y), gauss(z));
        let mut all = Vec::new();
        for &z in &z {
            for &y in &y {
                all.extend(x.iter().map(|&x| [x, y, z]));
            }
        }
        all
    };
    let of_triangle = [[1.0 / 6.0, 1.0 / 6.0], [2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0]];
    match cell_type.straight() {
        CellType::Tri3 => of_triangle.map(|[x, y]| [x, y, 0.0]).to_vec(),
        CellType::Quad4 => product(3, 3, 1),
        CellType::Tet4 => {
            let aside = (5.0 - 5.0f64.sqrt()) / 20.0;
            let near = 1.0 - 3.0 * aside;
            vec![[aside; 3], [near, aside, aside], [aside, near, aside], [aside, aside, near]]
        }
        CellType::Wedge6 => gauss(3).into_iter().flat_map(|z| of_triangle.map(|[x, y]| [x, y, z])).collect(),
        CellType::Pyramid5 => {
            let at = |[x, y, z]: [f64; 3]| [(1.0 - z) * (2.0 * x - 1.0), (1.0 - z) * (2.0 * y - 1.0), z];
            product(2, 2, 2).into_iter().map(at).collect()
        }
        _ => product(3, 3, 3),
    }
}
