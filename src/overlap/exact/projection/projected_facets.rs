//! Facets as lines see them: their shadows across the lines, and what hides what.

use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::convex_piece::cut;
use crate::geometry::quadrature::measure;
use crate::geometry::tree::Tree;
use crate::overlap::pair::surface_point::SurfacePoint;

/// A convex piece of a facet: its corners, in the facet's barycentric coordinates.
type Corners<const D: usize> = Vec<[f64; D]>;

/// A facet as seen along the direction of a patch.
pub(crate) struct ProjectedFacet<const D: usize> {
    pub(crate) of_b: bool,
    pub(crate) facet: u32,
    /// Across the lines (D − 1 entries used) and along them.
    pub(crate) corners: [[f64; 3]; D],
    /// Whether lines leave their body through it.
    pub(crate) leaves: bool,
}

impl<const D: usize> ProjectedFacet<D> {
    /// Barycentric coordinates as linear functions of the place across the lines.
    pub(crate) fn barycentric(&self, p: &[f64; 3]) -> [f64; D] {
        let c = &self.corners;
        let mut w = [0.0; D];
        if D == 2 {
            let total = c[1][0] - c[0][0];
            (w[0], w[1]) = ((c[1][0] - p[0]) / total, (p[0] - c[0][0]) / total);
            return w;
        }
        let minor = |a: usize, b: usize| (c[a][0] - p[0]) * (c[b][1] - p[1]) - (c[a][1] - p[1]) * (c[b][0] - p[0]);
        let parts = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let total: f64 = parts.iter().sum();
        std::array::from_fn(|a| parts[a] / total)
    }

    /// Place along the lines.
    pub(crate) fn t(&self, w: &[f64; D]) -> f64 {
        (0..D).map(|a| w[a] * self.corners[a][2]).sum()
    }

    pub(crate) fn place(&self, w: &[f64; D]) -> [f64; 3] {
        std::array::from_fn(|i| (0..D).map(|a| w[a] * self.corners[a][i]).sum())
    }

    /// Measure of its shadow across the lines.
    pub(crate) fn projected_area(&self) -> f64 {
        let c = &self.corners;
        match D {
            2 => (c[1][0] - c[0][0]).abs(),
            _ => 0.5 * ((c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0])).abs(),
        }
    }

    /// Whether it is a facet of the other side in the same place, up to `tie`, and entered or left as this one.
    fn coincides(&self, other: &Self, tolerance: f64) -> bool {
        self.of_b != other.of_b
            && self.leaves == other.leaves
            && (self.lies_in_plane(other, tolerance) || other.lies_in_plane(self, tolerance))
    }

    fn lies_in_plane(&self, plane: &Self, tolerance: f64) -> bool {
        let origin = Vector::<3>::from(plane.corners[0]);
        let away = |c: &[f64; 3]| Vector::<3>::from(*c) - origin;
        let along = away(&plane.corners[1]);
        let normal =
            if D == 2 { Vector::from([along[2], 0.0, -along[0]]) } else { along.cross(&away(&plane.corners[2])) };
        let tolerance = tolerance * normal.norm();
        self.corners.iter().all(|c| away(c).dot(&normal).abs() <= tolerance)
    }

    /// Its box in the frame of the lines, with no extent along them.
    fn across(&self) -> Aabb<D> {
        Aabb::of(&self.corners.map(|c| flat(&c)))
    }
}

/// The facets of both sides, to be found by their place across the lines.
pub(crate) struct Projection<const D: usize> {
    pub(crate) facets: Vec<ProjectedFacet<D>>,
    pub(crate) boxes: Vec<Aabb<D>>,
    tree: Tree<D>,
    /// Distance up to which facets are in the same place.
    tolerance: f64,
}

impl<const D: usize> Projection<D> {
    pub(crate) fn new(facets: Vec<ProjectedFacet<D>>) -> Self {
        let boxes: Vec<Aabb<D>> = facets.iter().map(ProjectedFacet::across).collect();
        let tree = Tree::new(&boxes);
        let corners = facets.iter().flat_map(|seen| seen.corners.map(Vector::<3>::from));
        let tolerance = corners
            .fold(Aabb::<3>::empty(), |aabb, x| Aabb { min: aabb.min.inf(&x), max: aabb.max.sup(&x) })
            .rounding();
        Self { facets, boxes, tree, tolerance }
    }

    /// Facets whose shadow's box meets a box across the lines, ascending.
    pub(crate) fn near(&self, query: &Aabb<D>) -> Vec<u32> {
        let mut found = Vec::new();
        self.tree.visit(|b| b.meets(query), |i| found.push(i));
        found.retain(|&i| self.boxes[i as usize].meets(query));
        found.sort_unstable();
        found
    }

    /// The parts of a piece of the first of two facets whose lines meet no other facet on their way to the second, over
    /// these lengths (given at the corners of the first); and the share of each.
    ///
    /// A facet of the other side that coincides with either of the two, as the walls of two bodies in a plane of symmetry,
    /// shares the lines evenly: which of them comes first is rounding, and each would hide the other, or neither.
    pub(crate) fn visible(&self, piece: Corners<D>, between: [u32; 2], lengths: &[f64; D]) -> Vec<(Corners<D>, f64)> {
        let [first, second] = between.map(|index| &self.facets[index as usize]);
        let projected_area = Aabb::of(&piece.iter().map(|w| flat::<D>(&first.place(w))).collect::<Vec<_>>());
        let mut visible = vec![(piece, 1.0)];
        for other in self.near(&projected_area).into_iter().filter(|other| !between.contains(other)) {
            let h = &self.facets[other as usize];
            let at_corners: [[f64; D]; D] = first.corners.map(|c| h.barycentric(&c));
            // Where the line meets it, between the ends: all of these are positive.
            let mut bounds: Vec<[f64; D]> = (0..D).map(|a| at_corners.map(|w| w[a])).collect();
            let shares = first.coincides(h, self.tolerance) || second.coincides(h, self.tolerance);
            if !shares {
                let ahead: [f64; D] = std::array::from_fn(|c| {
                    let ahead = h.t(&at_corners[c]) - first.corners[c][2];
                    if first.leaves { -ahead } else { ahead }
                });
                bounds.push(ahead);
                bounds.push(std::array::from_fn(|c| lengths[c] - ahead[c]));
            }
            let divided = visible.into_iter().flat_map(|(piece, share)| {
                let (inside, rest) = divide(piece, &bounds);
                let shared = inside.filter(|_| shares).map(|inside| (inside, 0.5 * share));
                rest.into_iter().map(move |piece| (piece, share)).chain(shared)
            });
            visible = divided.collect();
        }
        visible
    }
}

/// The part of a convex piece on which all of some linear functions, given at the facet's corners, are positive, and the
/// rest.
fn divide<const D: usize>(piece: Corners<D>, positive: &[[f64; D]]) -> (Option<Corners<D>>, Vec<Corners<D>>) {
    let (mut rest, mut inside) = (Vec::new(), piece.clone());
    for bound in positive {
        let outside = cut(&inside, bound);
        inside = cut(&inside, &bound.map(|b| -b));
        if inside.len() < D || measure(&inside) <= SLIVER * measure(&piece) {
            return (None, vec![piece]);
        }
        if outside.len() >= D {
            rest.push(outside);
        }
    }
    (Some(inside), rest)
}

/// Part of a piece below which what hides it is rounding.
const SLIVER: f64 = 1e-12;

/// A place across the lines.
pub(crate) fn flat<const D: usize>(place: &[f64; 3]) -> Vector<D> {
    Vector::from_fn(|i, _| if i + 1 < D { place[i] } else { 0.0 })
}

/// A point of a projected facet, as the end of a contact point.
pub(crate) fn end<const D: usize>(seen: &ProjectedFacet<D>, weights: [f64; D]) -> SurfacePoint<D> {
    SurfacePoint::Facet { of_b: seen.of_b, facet: seen.facet, weights }
}
