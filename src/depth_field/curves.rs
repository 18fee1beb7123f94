//! Curved faces for which straight ones stand: how far the depth is more, or less, than that below the straight faces.

use super::divisions::Divisions;
use super::heights_in_cells::{HeightsInCells, SagTerm};
use super::rims::{Facets, Rims};
use crate::geometry::boundary::facet_sags::{Bend, FacetSag, FacetSags, MostCurved};
use crate::geometry::boundary::facets_around::FacetsAround;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashMap;

/// The curved faces of all bodies.
pub(crate) struct Curves<const D: usize> {
    /// By facet, the height of the surface above it.
    facets: Vec<FacetSag<D>>,
    /// The curvature of every facet.
    curvatures: Vec<f64>,
    /// The largest of both, by body.
    of_bodies: Vec<MostCurved>,
    /// Whether a facet is surface.
    is_surface: Vec<bool>,
    rims: Rims,
    /// Vertices without deformation.
    points: Vec<Vector<D>>,
    pub(crate) around: FacetsAround,
    /// Of the simplices of cells that have a curved face, or a part of its border: what the height adds to the depth.
    cells: TermsOfCells,
    /// The same as facets see it that bend outwards, and inwards, where there are rims.
    by_bend: Option<[TermsOfCells; 2]>,
}

type TermsOfCells = FxHashMap<u32, Vec<Vec<SagTerm>>>;

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

    /// The function whose value at a place is that of this one at another, given those of the corners.
    pub(crate) fn mapped(&self, corners: &[[f64; 4]; 4]) -> Self {
        let middle = |[p, q]: [usize; 2]| std::array::from_fn(|k| 0.5 * (corners[p][k] + corners[q][k]));
        let at = corners.map(|corner| self.at(&corner).0);
        Self { at, between: PAIRS.map(|[p, q]| self.at(&middle([p, q])).0 - 0.5 * (at[p] + at[q])) }
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
        let FacetSags { sags: facets, of_bodies } = surface.facet_sags(&is_surface, feature_angle)?;
        let (points, around) = (surface.points(surface.reference()), FacetsAround::new(surface));
        let curvature = |(sag, facet): (&FacetSag<D>, &[u32; D])| sag.curvature(&facet.map(|v| points[v as usize]));
        let curvatures: Vec<f64> = facets.iter().zip(&surface.facets).map(curvature).collect();
        let bend = |(facet, &one): (usize, &f64)| Bend::new(one, of_bodies[around.body(facet) as usize].curvature);
        let bends: Vec<Bend> = curvatures.iter().enumerate().map(bend).collect();
        let in_cells = HeightsInCells { surface, cells, facets: &facets, bends: &bends, divisions, division_of };
        let seen_by = |bend| in_cells.terms(&is_surface, bend);
        let of_cells = seen_by(Bend::None);
        let flags: Vec<bool> = (0..surface.facets.len()).map(&is_surface).collect();
        let rims = Rims::new(&Facets { surface, points: &points, sags: &facets, is_surface: &flags, around: &around });
        let by_bend = rims.at.contains(&true).then(|| [Bend::Outwards, Bend::Inwards].map(seen_by));
        Some(Self { facets, curvatures, of_bodies, is_surface: flags, rims, points, around, cells: of_cells, by_bend })
    }

    /// The height of the surface above a facet.
    pub(crate) fn facet(&self, facet: usize) -> &FacetSag<D> {
        &self.facets[facet]
    }

    /// Whether a facet lies along a rim, where the depth has less than its height.
    pub(crate) fn is_at_rim(&self, facet: usize) -> bool {
        self.rims.at[facet]
    }

    /// The number of the smooth face of a facet at a vertex on a rim; `None` where all are one.
    pub(crate) fn face_at_rim(&self, facet: usize, vertex: u32) -> Option<u32> {
        self.rims.face(facet, vertex)
    }

    /// To which side a facet bends, as far as it may conform to a body.
    pub(crate) fn bend(&self, facet: usize, beside: usize) -> Bend {
        Bend::new(self.curvatures[facet], self.of_bodies[beside].curvature)
    }

    /// Whether what faces add to the depth depends on how what sees it bends.
    pub(crate) fn has_bends(&self) -> bool {
        self.by_bend.is_some()
    }

    /// Whether a facet is surface.
    pub(crate) fn is_surface(&self, facet: usize) -> bool {
        self.is_surface[facet]
    }

    /// The largest height of a body.
    pub(crate) fn height(&self, body: usize) -> f64 {
        self.of_bodies[body].height
    }

    /// The largest height of all bodies.
    pub(crate) fn largest_height(&self) -> f64 {
        self.of_bodies.iter().fold(0.0, |most, body| body.height.max(most))
    }

    /// Corners of a facet without deformation.
    pub(crate) fn corners(&self, facet: &[u32; D]) -> [Vector<D>; D] {
        facet.map(|vertex| self.points[vertex as usize])
    }

    /// What the height adds to the depth in a simplex of a cell, given the numbers of its corners, as facets see it that bend so.
    pub(crate) fn in_simplex(&self, cell: u32, simplex: usize, corners: &[u8; 4], seen_by: Bend) -> Quadratic {
        let mut sum = Quadratic::default();
        let cells = match (&self.by_bend, seen_by) {
            (Some([outwards, _]), Bend::Outwards) => outwards,
            (Some([_, inwards]), Bend::Inwards) => inwards,
            _ => &self.cells,
        };
        let Some(terms) = cells.get(&cell).and_then(|simplices| simplices.get(simplex)) else { return sum };
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
