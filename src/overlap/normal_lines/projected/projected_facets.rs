//! Facets as lines see them: their projections across the lines, and what hides what.

use super::work::Work;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Corners, cut, value};
use crate::geometry::primitives::quadrature::measure;
use crate::geometry::primitives::tree::Tree;
use crate::overlap::pair::surface_point::SurfacePoint;
use smallvec::SmallVec;

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

    /// Measure of its projection across the lines.
    pub(crate) fn projected_area(&self) -> f64 {
        let c = &self.corners;
        match D {
            2 => (c[1][0] - c[0][0]).abs(),
            _ => 0.5 * ((c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0])).abs(),
        }
    }

    /// Whether it is a facet of the other side in the same place, up to the tolerance, and entered or left as this one.
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

    /// Least and largest place along the lines.
    fn range(&self) -> [f64; 2] {
        self.corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| [low.min(c[2]), high.max(c[2])])
    }

    /// Its box in the frame of the lines, with no extent along them.
    fn across(&self) -> Aabb<D> {
        Aabb::of(&self.corners.map(|c| flat(&c)))
    }
}

/// A facet as the lines through the corners of another meet it, extended to its plane.
#[derive(Clone, Copy)]
pub(crate) struct Near<const D: usize> {
    pub(crate) facet: u32,
    /// Each of its barycentric coordinates at the corners of the other.
    pub(crate) bounds: [[f64; D]; D],
    /// Place along these lines.
    pub(crate) t: [f64; D],
}

/// The facets of both sides, to be found by their place across the lines.
pub(crate) struct Projection<const D: usize> {
    pub(crate) facets: Vec<ProjectedFacet<D>>,
    pub(crate) boxes: Vec<Aabb<D>>,
    /// Least and largest place of every facet along the lines.
    pub(crate) ranges: Vec<[f64; 2]>,
    /// Whether the winding numbers of both sides are known to be nowhere negative.
    pub(crate) is_upright: bool,
    /// Pieces that were made of them.
    pub(crate) work: Work,
    tree: Tree<D>,
    /// Distance up to which facets are in the same place.
    tolerance: f64,
}

impl<const D: usize> Projection<D> {
    pub(crate) fn new(facets: Vec<ProjectedFacet<D>>, is_upright: bool) -> Self {
        let boxes: Vec<Aabb<D>> = facets.iter().map(ProjectedFacet::across).collect();
        let tree = Tree::new(&boxes);
        let corners = facets.iter().flat_map(|seen| seen.corners.map(Vector::<3>::from));
        let tolerance = corners
            .fold(Aabb::<3>::empty(), |aabb, x| Aabb { min: aabb.min.inf(&x), max: aabb.max.sup(&x) })
            .rounding();
        let ranges = facets.iter().map(ProjectedFacet::range).collect();
        Self { work: Work::new(facets.len()), facets, boxes, ranges, is_upright, tree, tolerance }
    }

    /// Facets whose projection's box meets a box across the lines, ascending.
    pub(crate) fn near(&self, query: &Aabb<D>) -> Vec<u32> {
        let mut found = Vec::new();
        self.visit_near(query, |facet| found.push(facet));
        found.sort_unstable();
        found
    }

    fn visit_near(&self, query: &Aabb<D>, mut visit: impl FnMut(u32)) {
        self.tree.visit(
            |b| b.meets(query),
            |i| {
                if self.boxes[i as usize].meets(query) {
                    visit(i);
                }
            },
        );
    }

    /// Whether the box of one of some facets meets that of a facet.
    pub(crate) fn is_near_any(&self, facet: usize, is_one: impl Fn(usize) -> bool) -> bool {
        let mut is_near = false;
        self.visit_near(&self.boxes[facet], |other| is_near = is_near || is_one(other as usize));
        is_near
    }

    /// Facets over any part of one facet, ascending, with their place there; those that end before `least` along the lines
    /// are left out.
    pub(crate) fn find_near(&self, facet: u32, least: f64, near: &mut Vec<Near<D>>) {
        let first = &self.facets[facet as usize];
        let mut found: SmallVec<[u32; FEW]> = SmallVec::new();
        self.visit_near(&self.boxes[facet as usize], |other| {
            if self.ranges[other as usize][1] >= least - self.tolerance {
                found.push(other);
            }
        });
        found.sort_unstable();
        near.clear();
        near.extend(found.into_iter().filter_map(|other| {
            let h = &self.facets[other as usize];
            let at_corners: [[f64; D]; D] = first.corners.map(|c| h.barycentric(&c));
            let bounds: [[f64; D]; D] = std::array::from_fn(|a| at_corners.map(|w| w[a]));
            let is_beside = bounds.iter().any(|w| w.iter().all(|w| *w <= 0.0));
            (!is_beside).then(|| Near { facet: other, bounds, t: at_corners.map(|w| h.t(&w)) })
        }));
    }

    /// Those of the facets near one facet that may meet the lines of a part of it.
    fn over<'a>(&self, outline: &Aabb<D>, near: &'a [Near<D>]) -> SmallVec<[&'a Near<D>; FEW]> {
        if near.len() <= FEW {
            return near.iter().filter(|near| self.boxes[near.facet as usize].meets(outline)).collect();
        }
        // A large facet has all small ones of the other side near it, and few of them over each.
        let found = self.near(outline);
        let place = |facet: &u32| near.binary_search_by_key(facet, |near| near.facet).ok();
        found.iter().filter_map(|facet| Some(&near[place(facet)?])).collect()
    }

    /// Visits the parts of a piece of the first of two facets whose lines meet no other facet on their way to the second,
    /// over these lengths (given at the corners of the first), with the share of each; `near` are those of the first.
    ///
    /// A facet of the other side that coincides with either of the two, as the walls of two bodies in a plane of symmetry,
    /// shares the lines evenly: which of them comes first is rounding, and each would hide the other, or neither.
    pub(crate) fn visible(
        &self,
        piece: &[[f64; D]],
        between: [u32; 2],
        lengths: &[f64; D],
        near: &[Near<D>],
        mut visit: impl FnMut(&[[f64; D]], f64),
    ) {
        let [first, second] = between.map(|index| &self.facets[index as usize]);
        let sign = if first.leaves { -1.0 } else { 1.0 };
        let (mut outline, mut low, mut high) = (Aabb::empty(), f64::INFINITY, f64::NEG_INFINITY);
        for w in piece {
            let place = first.place(w);
            outline.include(&flat(&place));
            let far = place[2] + sign * (0..D).map(|a| w[a] * lengths[a]).sum::<f64>();
            (low, high) = (low.min(place[2]).min(far), high.max(place[2]).max(far));
        }
        let over = self.over(&outline, near);
        if !self.work.allows(over.len()) {
            return;
        }
        let mut hiding: SmallVec<[Hiding<D>; 16]> = SmallVec::new();
        for &Near { facet: other, bounds: sides, t } in over {
            // Before or behind all that lies between the two, or beside it. Neighbours share an edge, but for rounding.
            let [least, largest] = self.ranges[other as usize];
            if largest < low - self.tolerance || least > high + self.tolerance || between.contains(&other) {
                continue;
            }
            if is_clear(piece, &sides, SLIVER) {
                continue;
            }
            let h = &self.facets[other as usize];
            let mut bounds = [[0.0; D]; MOST_BOUNDS];
            bounds[..D].copy_from_slice(&sides);
            let shares = first.coincides(h, self.tolerance) || second.coincides(h, self.tolerance);
            let mut count = D;
            if !shares {
                bounds[D] = std::array::from_fn(|c| sign * (t[c] - first.corners[c][2]));
                bounds[D + 1] = std::array::from_fn(|c| lengths[c] - bounds[D][c]);
                count += 2;
            }
            let found = Hiding { bounds, count, shares };
            if is_clear(piece, found.bounds(), 0.0) {
                continue;
            }
            if !shares && is_covered(piece, found.bounds()) {
                return;
            }
            hiding.push(found);
        }
        if hiding.is_empty() {
            visit(piece, 1.0);
            return;
        }
        let mut visible = vec![(Corners::from_slice(piece), 1.0)];
        let mut left = Vec::new();
        for found in hiding {
            let is_clear = |bounds: &[[f64; D]], least| visible.iter().all(|(piece, _)| is_clear(piece, bounds, least));
            if is_clear(&found.bounds[..D], SLIVER) || is_clear(found.bounds(), 0.0) {
                continue;
            }
            if !self.work.allows(visible.len()) {
                return;
            }
            for (piece, share) in visible.drain(..) {
                let hidden = divide(piece, share, found.bounds(), &mut left);
                left.extend(hidden.filter(|_| found.shares).map(|piece| (piece, 0.5 * share)));
            }
            std::mem::swap(&mut visible, &mut left);
            if visible.is_empty() {
                return;
            }
        }
        visible.iter().for_each(|(piece, share)| visit(piece, *share));
    }
}

/// A facet that hides a part of a piece.
struct Hiding<const D: usize> {
    /// Where the line meets it, between the ends: the first so many of these are positive.
    bounds: [[f64; D]; MOST_BOUNDS],
    count: usize,
    /// Whether it shares the lines.
    shares: bool,
}

impl<const D: usize> Hiding<D> {
    fn bounds(&self) -> &[[f64; D]] {
        &self.bounds[..self.count]
    }
}

/// So many facets are asked one by one.
const FEW: usize = 64;

/// Bounds of the part of a piece that a facet hides: its own edges, and the two ends of the lines.
const MOST_BOUNDS: usize = 5;

/// Whether some linear function, given at the facet's corners, is nowhere on a piece larger than `least`.
fn is_clear<const D: usize>(piece: &[[f64; D]], bounds: &[[f64; D]], least: f64) -> bool {
    bounds.iter().any(|bound| piece.iter().all(|w| value(w, bound) <= least))
}

/// Whether all of some linear functions are positive on all of a piece.
fn is_covered<const D: usize>(piece: &[[f64; D]], bounds: &[[f64; D]]) -> bool {
    bounds.iter().all(|bound| piece.iter().all(|w| value(w, bound) > 0.0))
}

/// The part of a convex piece on which all of some linear functions, given at the facet's corners, are positive; adds the
/// rest to `left`, with its share.
fn divide<const D: usize>(
    piece: Corners<D>,
    share: f64,
    positive: &[[f64; D]],
    left: &mut Vec<(Corners<D>, f64)>,
) -> Option<Corners<D>> {
    if is_clear(&piece, positive, 0.0) {
        left.push((piece, share));
        return None;
    }
    let (before, least) = (left.len(), SLIVER * measure(&piece));
    let mut inside = piece.clone();
    for bound in positive {
        if is_covered(&inside, std::slice::from_ref(bound)) {
            continue;
        }
        let outside = cut(&inside, bound);
        inside = cut(&inside, &bound.map(|b| -b));
        if inside.len() < D || measure(&inside) <= least {
            left.truncate(before);
            left.push((piece, share));
            return None;
        }
        if outside.len() >= D {
            left.push((outside, share));
        }
    }
    Some(inside)
}

/// Part of a piece, or of a facet, below which what is left of it is rounding: whether its lines are inside is chance.
pub(crate) const SLIVER: f64 = 1e-12;

/// A place across the lines.
pub(crate) fn flat<const D: usize>(place: &[f64; 3]) -> Vector<D> {
    Vector::from_fn(|i, _| if i + 1 < D { place[i] } else { 0.0 })
}

/// A point of a projected facet, as the end of a contact point.
pub(crate) fn end<const D: usize>(seen: &ProjectedFacet<D>, weights: [f64; D]) -> SurfacePoint<D> {
    SurfacePoint::Facet { of_b: seen.of_b, facet: seen.facet, weights }
}
