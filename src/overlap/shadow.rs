//! Facets as lines see them: their shadows across the lines, and what hides what.

use super::piece::cut;
use super::quadrature::measure;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::tree::Tree;

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
    pub(super) fn shadow(&self) -> f64 {
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
    pub(super) fn new(facets: Vec<Seen<D>>) -> Self {
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
    pub(super) fn visible(
        &self,
        piece: Vec<[f64; D]>,
        but: [u32; 2],
        from: &Seen<D>,
        lengths: &[f64; D],
    ) -> Vec<Vec<[f64; D]>> {
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

/// Part of a piece below which what hides it is rounding.
const SLIVER: f64 = 1e-12;

/// A place across the lines.
pub(super) fn flat<const D: usize>(place: &[f64; 3]) -> Vector<D> {
    Vector::from_fn(|i, _| if i + 1 < D { place[i] } else { 0.0 })
}
