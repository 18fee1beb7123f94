//! Spans of the fiber law integrated exactly: quadrature on the common pieces of facets projected along a patch's
//! direction.
//!
//! Across the lines of one direction, an entered facet e and a facet x through which lines leave share a convex piece (an
//! interval in 2D, a polygon in 3D). On it L = t_x − t_e is linear, and so are the barycentric coordinates of both. The
//! piece is cut where L = 0; Gauss points of degree 3 (2D) and 2 (3D) then integrate ψ'(L) N_a of the quadratic ψ
//! exactly, and any smooth ψ to their order. What a third facet hides of a piece is cut out of it.

use super::exact::ExactPair;
use super::patch::Patches;
use super::piece::{cut, whole};
use super::side::{FacetSide, ImplicitSide, Opponent};
use super::span::{End, Span, Spans};
use crate::Error;
use crate::geometry::aabb::Aabb;
use crate::geometry::facet::area_vector;
use crate::geometry::tree::Tree;
use crate::geometry::{Pose, Shape, Vector, cover_count};
use crate::sampling::Family;

/// A facet as seen along the direction of a patch.
pub(super) struct Seen<const D: usize> {
    pub(super) of_b: bool,
    pub(super) facet: u32,
    /// Across the lines (D − 1 entries used) and along them.
    pub(super) corners: [[f64; 3]; D],
    /// Whether lines leave their body through it.
    pub(super) leaves: bool,
}

impl<const D: usize> Seen<D> {
    /// Barycentric coordinates as linear functions of the place across the lines.
    pub(super) fn barycentric(&self, p: &[f64; 3]) -> [f64; D] {
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
    pub(super) fn t(&self, w: &[f64; D]) -> f64 {
        (0..D).map(|a| w[a] * self.corners[a][2]).sum()
    }

    pub(super) fn place(&self, w: &[f64; D]) -> [f64; 3] {
        std::array::from_fn(|i| (0..D).map(|a| w[a] * self.corners[a][i]).sum())
    }

    /// Measure of its shadow across the lines.
    fn shadow(&self) -> f64 {
        let c = &self.corners;
        match D {
            2 => (c[1][0] - c[0][0]).abs(),
            _ => 0.5 * ((c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0])).abs(),
        }
    }

    /// Its box in the frame of the lines, with no extent along them.
    fn across(&self) -> Aabb<D> {
        Aabb::of(&self.corners.map(|c| flat(&c)))
    }
}

/// The facets of both sides, to be found by their place across the lines.
pub(super) struct Shadows<const D: usize> {
    pub(super) facets: Vec<Seen<D>>,
    pub(super) boxes: Vec<Aabb<D>>,
    tree: Tree<D>,
}

impl<const D: usize> Shadows<D> {
    fn new(facets: Vec<Seen<D>>) -> Self {
        let boxes: Vec<Aabb<D>> = facets.iter().map(Seen::across).collect();
        let tree = Tree::new(&boxes);
        Self { facets, boxes, tree }
    }

    /// Facets whose shadow's box meets a box across the lines, ascending.
    pub(super) fn near(&self, query: &Aabb<D>) -> Vec<u32> {
        let mut found = Vec::new();
        self.tree.visit(|b| b.meets(query), |i| found.push(i));
        found.retain(|&i| self.boxes[i as usize].meets(query));
        found.sort_unstable();
        found
    }

    /// The parts of a piece of facet `from` whose lines meet no other facet on their way into its body, over these lengths
    /// (given at the corners of `from`).
    fn visible(&self, piece: Vec<[f64; D]>, but: [u32; 2], from: &Seen<D>, lengths: &[f64; D]) -> Vec<Vec<[f64; D]>> {
        let mut visible = vec![piece];
        let shadow = Aabb::of(&visible[0].iter().map(|w| flat::<D>(&from.place(w))).collect::<Vec<_>>());
        for other in self.near(&shadow).into_iter().filter(|other| !but.contains(other)) {
            let h = &self.facets[other as usize];
            let at_corners: [[f64; D]; D] = from.corners.map(|c| h.barycentric(&c));
            let ahead: [f64; D] = std::array::from_fn(|c| {
                let ahead = h.t(&at_corners[c]) - from.corners[c][2];
                if from.leaves { -ahead } else { ahead }
            });
            // Where the line meets it, between the ends: all of these are positive.
            let mut bounds: Vec<[f64; D]> = (0..D).map(|a| at_corners.map(|w| w[a])).collect();
            bounds.push(ahead);
            bounds.push(std::array::from_fn(|c| lengths[c] - ahead[c]));
            visible = visible.into_iter().flat_map(|piece| subtract(piece, &bounds)).collect();
        }
        visible
    }
}

/// A convex piece without the part on which all of some linear functions, given at the facet's corners, are positive.
fn subtract<const D: usize>(piece: Vec<[f64; D]>, positive: &[[f64; D]]) -> Vec<Vec<[f64; D]>> {
    let (mut rest, mut inside) = (Vec::new(), piece.clone());
    for bound in positive {
        let outside = cut(&inside, bound);
        inside = cut(&inside, &bound.map(|b| -b));
        if inside.len() < D || measure(&inside) <= SLIVER * measure(&piece) {
            return vec![piece];
        }
        if outside.len() >= D {
            rest.push(outside);
        }
    }
    rest
}

/// A facet whose shadow is a smaller part of it is seen edge-on: its barycentric coordinates are lost in rounding, and no
/// line of any measure crosses it.
const EDGE_ON: f64 = 1e-9;

/// Part of a piece below which what hides it is rounding.
const SLIVER: f64 = 1e-12;

fn measure<const D: usize>(piece: &[[f64; D]]) -> f64 {
    let mut measure = 0.0;
    for_each_gauss_point(piece, |_, part| measure += part);
    measure
}

/// A place across the lines.
pub(super) fn flat<const D: usize>(place: &[f64; 3]) -> Vector<D> {
    Vector::from_fn(|i, _| if i + 1 < D { place[i] } else { 0.0 })
}

impl<const D: usize> ExactPair<'_, D> {
    /// All spans along the directions of `patches`, and, if asked for, the creases that their tangent needs.
    pub(crate) fn spans(&self, patches: &Patches<D>, creases: bool) -> Result<Option<Spans<D>>, Error> {
        let mut spans = Spans { directions: patches.directions.clone(), ..Spans::default() };
        for (direction, d) in patches.directions.iter().enumerate() {
            let family = Family::along(*d, 0, 0);
            let mut add = |mut span: Span<D>| {
                span.weight *= patches.part(direction, &span.ends);
                span.direction = direction as u32;
                if span.weight > 0.0 && span.length > 0.0 {
                    spans.spans.push(span);
                }
            };
            let mut seen = self.seen(&family, false);
            let plane = match &self.pair.opponent {
                Opponent::Itself => None,
                Opponent::Facets(_) => {
                    seen.extend(self.seen(&family, true));
                    None
                }
                Opponent::Implicit(ImplicitSide { shape: Shape::HalfSpace, pose, .. }) => Some(Plane::of(pose)),
                Opponent::Implicit(_) => {
                    let what = "the exact overlap with a curved or signed-distance obstacle; use fibers, or give it as \
                                a polygon or triangle mesh";
                    return Err(Error::Unsupported { what });
                }
            };
            let seen = Shadows::new(seen);
            if let Some(plane) = &plane {
                self.spans_on_plane(&seen, &family, plane, &mut add);
            }
            self.spans_between(&seen, &mut add);
            if creases {
                self.visit_creases(&seen, &family, plane.as_ref(), |mut crease, ends| {
                    crease.weight *= patches.part(direction, ends);
                    spans.creases.push(crease);
                });
            }
        }
        Ok(Some(spans))
    }

    /// Facets of one side that the other side's box reaches; those seen edge-on are left out: no line crosses them.
    fn seen(&self, family: &Family<D>, of_b: bool) -> Vec<Seen<D>> {
        let side = self.pair.side(of_b);
        let other = match &self.pair.opponent {
            Opponent::Facets(_) => self.pair.side(!of_b).aabb,
            _ => side.aabb,
        };
        let region = side.aabb.intersection(&other);
        let region = region.inflated(region.rounding());
        let see = |facet: u32| {
            let area = area_vector(&side.corners(facet as usize));
            let slope = area.dot(family.direction());
            let corners = side.corners(facet as usize).map(|x| family.view(&x));
            let seen = Seen { of_b, facet, corners, leaves: slope > 0.0 };
            (seen.shadow() > EDGE_ON * area.norm()).then_some(seen)
        };
        side.facets_in(&region).into_iter().filter_map(see).collect()
    }

    fn spans_between(&self, seen: &Shadows<D>, add: &mut impl FnMut(Span<D>)) {
        for (entered, e) in seen.facets.iter().enumerate().filter(|(_, s)| !s.leaves) {
            for left in seen.near(&seen.boxes[entered]) {
                let x = &seen.facets[left as usize];
                if !x.leaves {
                    continue;
                }
                let mut piece = whole::<D>();
                let at_corners: [[f64; D]; D] = e.corners.map(|c| x.barycentric(&c));
                for a in 0..D {
                    piece = cut(&piece, &at_corners.map(|w| -w[a]));
                }
                let lengths: [f64; D] = std::array::from_fn(|c| x.t(&at_corners[c]) - e.corners[c][2]);
                piece = cut(&piece, &lengths.map(|l| -l));
                if piece.len() < D {
                    continue;
                }
                for piece in seen.visible(piece, [entered as u32, left], e, &lengths) {
                    // Entered one body and leaving the other, with nothing between: inside both.
                    if e.of_b == x.of_b && !self.is_covered_between(e, x, &e.place(&mean(&piece))) {
                        continue;
                    }
                    for_each_gauss_point(&piece, |w, part| {
                        let weights = x.barycentric(&e.place(w));
                        add(Span {
                            weight: part * e.shadow(),
                            length: (0..D).map(|a| w[a] * lengths[a]).sum(),
                            direction: 0,
                            ends: [end(e, *w), end(x, weights)],
                        });
                    });
                }
            }
        }
    }

    /// Whether, between two facets of one side, the other covers the line as well (or the body itself once more).
    pub(super) fn is_covered_between(&self, e: &Seen<D>, x: &Seen<D>, place: &[f64; 3]) -> bool {
        let side = self.pair.side(e.of_b);
        let [p, q] = [e, x].map(|s| {
            let w = s.barycentric(place);
            let corners = side.corners(s.facet as usize);
            (0..D).fold(Vector::zeros(), |sum, a| sum + corners[a] * w[a])
        });
        let middle = (p + q) * 0.5;
        let covering = |side: &FacetSide<D>| cover_count(side.facets, &side.views.points, &middle);
        match &self.pair.opponent {
            Opponent::Itself => covering(side) > 1,
            Opponent::Facets(_) => covering(self.pair.side(!e.of_b)) > 0,
            Opponent::Implicit(side) => Plane::of(side.pose).height(&middle) < 0.0,
        }
    }

    fn spans_on_plane(&self, seen: &Shadows<D>, family: &Family<D>, plane: &Plane<D>, add: &mut impl FnMut(Span<D>)) {
        let slope = plane.normal.dot(family.direction());
        for (index, s) in seen.facets.iter().enumerate().filter(|(_, s)| s.leaves != (slope > 0.0)) {
            let corners = self.pair.a.corners(s.facet as usize);
            // From the facet along the line to the plane; on the body's side of it the length is positive.
            let lengths = corners.map(|x| -plane.height(&x) / slope.abs());
            let piece = cut(&whole::<D>(), &lengths.map(|l| -l));
            if piece.len() < D {
                continue;
            }
            for piece in seen.visible(piece, [index as u32; 2], s, &lengths) {
                for_each_gauss_point(&piece, |w, part| {
                    let length = (0..D).map(|a| w[a] * lengths[a]).sum::<f64>();
                    let along = if s.leaves { -length } else { length };
                    let on_facet = (0..D).fold(Vector::zeros(), |sum, a| sum + corners[a] * w[a]);
                    let on_plane = End::Point { point: on_facet + family.direction() * along, normal: plane.normal };
                    let ends = if s.leaves { [on_plane, end(s, *w)] } else { [end(s, *w), on_plane] };
                    add(Span { weight: part * s.shadow(), length, direction: 0, ends });
                });
            }
        }
    }
}

/// The surface of a half-space.
pub(super) struct Plane<const D: usize> {
    pub(super) point: Vector<D>,
    pub(super) normal: Vector<D>,
}

impl<const D: usize> Plane<D> {
    fn of(pose: &Pose<D>) -> Self {
        let mut up = Vector::zeros();
        up[D - 1] = 1.0;
        Self { point: pose.position.into(), normal: pose.rotate(&up) }
    }

    pub(super) fn height(&self, x: &Vector<D>) -> f64 {
        self.normal.dot(&(x - self.point))
    }
}

pub(super) fn end<const D: usize>(seen: &Seen<D>, weights: [f64; D]) -> End<D> {
    End::Facet { of_b: seen.of_b, facet: seen.facet, weights }
}

fn mean<const D: usize>(piece: &[[f64; D]]) -> [f64; D] {
    std::array::from_fn(|a| piece.iter().map(|w| w[a]).sum::<f64>() / piece.len() as f64)
}

/// Calls `visit(barycentric, part of the facet's measure)` for every quadrature point of a convex piece: two Gauss points
/// on an interval (degree 3), three in every triangle of a polygon (degree 2).
fn for_each_gauss_point<const D: usize>(piece: &[[f64; D]], mut visit: impl FnMut(&[f64; D], f64)) {
    if D == 2 {
        let (p, q) = (&piece[0], &piece[1]);
        for s in [0.5 - 0.5 / 3f64.sqrt(), 0.5 + 0.5 / 3f64.sqrt()] {
            visit(&std::array::from_fn(|a| p[a] + s * (q[a] - p[a])), 0.5 * (q[1] - p[1]).abs());
        }
        return;
    }
    let p = &piece[0];
    for k in 1..piece.len() - 1 {
        let corners = [p, &piece[k], &piece[k + 1]];
        let [_, q, r] = corners;
        let part = ((q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])).abs();
        for near in 0..3 {
            let weight = |corner: usize| if corner == near { 2.0 / 3.0 } else { 1.0 / 6.0 };
            visit(&std::array::from_fn(|a| (0..3).map(|c| weight(c) * corners[c][a]).sum()), part / 3.0);
        }
    }
}
