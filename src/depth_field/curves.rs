//! Curved faces for which straight ones stand: how far the depth is more, or less, than that below the straight faces.

use super::divisions::Divisions;
use super::heights_in_cells::{HeightsInCells, SagTerm};
use super::rims::at_rims;
use crate::geometry::boundary::facet_sags::{FacetSag, FacetSags};
use crate::geometry::boundary::facets_around::FacetsAround;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashMap;

/// The curved faces of all bodies.
pub(crate) struct Curves<const D: usize> {
    /// By facet, the height of the surface above it.
    facets: Vec<FacetSag<D>>,
    /// The largest of these, by body.
    heights: Vec<f64>,
    /// Whether a facet is surface.
    is_surface: Vec<bool>,
    /// Whether it lies along a rim.
    at_rims: Vec<bool>,
    /// Vertices without deformation.
    points: Vec<Vector<D>>,
    pub(crate) around: FacetsAround,
    /// Of the simplices of cells that have a curved face, or a part of its border: what the height adds to the depth.
    cells: FxHashMap<u32, Vec<Vec<SagTerm>>>,
}

/// A quadratic function of the barycentric coordinates of a simplex: values at the corners, and in the middles between two what is above
/// their mean.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Quadratic {
    at: [f64; 4],
    between: [f64; 6],
}

/// Corners of a simplex, two by two.
const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

impl Quadratic {
    /// Its value and its derivatives by the coordinates.
    pub(crate) fn at(&self, x: &[f64; 4]) -> (f64, [f64; 4]) {
        let (mut value, mut slopes) = (0.0, self.at);
        for (sum, x) in self.at.iter().zip(x) {
            value += sum * x;
        }
        for ([p, q], b) in PAIRS.into_iter().zip(self.between).filter(|(_, b)| *b != 0.0) {
            value += 4.0 * b * x[p] * x[q];
            slopes[p] += 4.0 * b * x[q];
            slopes[q] += 4.0 * b * x[p];
        }
        (value, slopes)
    }

    pub(crate) fn is_zero(&self) -> bool {
        *self == Self::default()
    }

    /// Calls `visit(p, q, second derivative by the coordinates p and q)` for those that are not zero, p < q.
    pub(crate) fn for_each_second(&self, mut visit: impl FnMut(usize, usize, f64)) {
        let pairs = PAIRS.into_iter().zip(self.between).filter(|(_, b)| *b != 0.0);
        pairs.for_each(|([p, q], b)| visit(p, q, 4.0 * b));
    }
}

impl<const D: usize> Curves<D> {
    /// Those of a surface; `None` where all faces are flat.
    pub(super) fn new(
        surface: &Surface<D>,
        cells: &Cells,
        (divisions, division_of): (&Divisions, &[u32]),
        (is_surface, feature_angle): (impl Fn(usize) -> bool, Option<f64>),
    ) -> Option<Self> {
        let FacetSags { sags: facets, heights } = surface.facet_sags(&is_surface, feature_angle)?;
        let of_cells = HeightsInCells { surface, cells, facets: &facets, divisions, division_of }.terms(&is_surface);
        let is_surface: Vec<bool> = (0..surface.facets.len()).map(is_surface).collect();
        let (points, around) = (surface.points(surface.reference()), FacetsAround::new(surface));
        let at_rims = at_rims(surface, &facets, &is_surface, &around);
        Some(Self { facets, heights, is_surface, at_rims, points, around, cells: of_cells })
    }

    /// The height of the surface above a facet.
    pub(crate) fn facet(&self, facet: usize) -> &FacetSag<D> {
        &self.facets[facet]
    }

    /// Whether a facet lies along a rim, where the depth has less than its height.
    pub(crate) fn is_at_rim(&self, facet: usize) -> bool {
        self.at_rims[facet]
    }

    /// Whether a facet is surface.
    pub(crate) fn is_surface(&self, facet: usize) -> bool {
        self.is_surface[facet]
    }

    /// The largest height of a body.
    pub(crate) fn height(&self, body: usize) -> f64 {
        self.heights[body]
    }

    /// The largest height of all bodies.
    pub(crate) fn largest_height(&self) -> f64 {
        self.heights.iter().fold(0.0, |most, height| height.max(most))
    }

    /// Corners of a facet without deformation.
    pub(crate) fn corners(&self, facet: &[u32; D]) -> [Vector<D>; D] {
        facet.map(|vertex| self.points[vertex as usize])
    }

    /// What the height adds to the depth in a simplex of a cell, given the numbers of its corners.
    pub(crate) fn in_simplex(&self, cell: u32, simplex: usize, corners: &[u8; 4]) -> Quadratic {
        let mut sum = Quadratic::default();
        let Some(terms) = self.cells.get(&cell).and_then(|simplices| simplices.get(simplex)) else { return sum };
        let place = |number: u8| corners[..=D].iter().position(|corner| *corner == number);
        for term in terms {
            let [Some(p), Some(q)] = term.corners.map(place) else { continue };
            match PAIRS.iter().position(|pair| *pair == [p.min(q), p.max(q)]) {
                Some(pair) => sum.between[pair] = term.height,
                None => sum.at[p] = term.height,
            }
        }
        sum
    }
}
