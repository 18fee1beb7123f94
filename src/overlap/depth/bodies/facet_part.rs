//! What a facet has inside a piece: a polygon (2D: an interval) that knows which face of the piece each of its edges lies on.

/// Corners that a part has at most: those of a triangle, and one more for each of four faces and for the depth's zero. Rounding may
/// bring another.
const MOST_CORNERS: usize = 12;

/// An edge that lies on no face of the piece.
pub(super) const FREE: u8 = u8::MAX;

/// The part of a facet inside a piece; its memory serves one after the other.
#[derive(Clone, Debug)]
pub(crate) struct FacetPart<const D: usize> {
    /// The corners as they are, and as they were before the last cut: which is which changes from cut to cut.
    corners: [Corners<D>; 2],
    now: usize,
}

#[derive(Clone, Debug)]
struct Corners<const D: usize> {
    count: usize,
    /// Corners in the barycentric coordinates of the piece, and in those of the facet, in the order of the facet's.
    at: [[f64; 4]; MOST_CORNERS],
    on: [[f64; D]; MOST_CORNERS],
    /// In 3D the face of the piece on which the edge from a corner to the next lies; in 2D that on which the corner lies.
    faces: [u8; MOST_CORNERS],
}

impl<const D: usize> Corners<D> {
    fn new() -> Self {
        let (at, on) = ([[0.0; 4]; MOST_CORNERS], [[0.0; D]; MOST_CORNERS]);
        Self { count: 0, at, on, faces: [FREE; MOST_CORNERS] }
    }

    fn add(&mut self, at: [f64; 4], on: [f64; D], face: u8) {
        if self.count < MOST_CORNERS {
            (self.at[self.count], self.on[self.count], self.faces[self.count]) = (at, on, face);
            self.count += 1;
        }
    }
}

impl<const D: usize> Default for FacetPart<D> {
    fn default() -> Self {
        Self { corners: [Corners::new(), Corners::new()], now: 0 }
    }
}

impl<const D: usize> FacetPart<D> {
    /// Makes it the whole facet, whose corners have these coordinates in the piece.
    pub(super) fn reset(&mut self, barycentric: &[[f64; 4]; D]) {
        let corners = &mut self.corners[self.now];
        corners.count = 0;
        for (c, at) in barycentric.iter().enumerate() {
            corners.add(*at, std::array::from_fn(|b| f64::from(u8::from(b == c))), FREE);
        }
    }

    /// Makes it a part that is given by its corners on the facet; on which faces its edges lie is not known.
    pub(super) fn set(&mut self, on: &[[f64; D]], barycentric: &[[f64; 4]; D]) {
        let corners = &mut self.corners[self.now];
        corners.count = 0;
        for w in on {
            corners.add(std::array::from_fn(|k| (0..D).map(|b| w[b] * barycentric[b][k]).sum()), *w, FREE);
        }
    }

    /// Keeps the part where the coordinate of this number is positive; false if no part is left.
    ///
    /// A cut is found from the corner inside towards the one outside, so that both facets at an edge find it at the same place, to the
    /// last bit.
    pub(super) fn cut_to_face(&mut self, face: usize) -> bool {
        self.cut(face as u8, |at| at[face], |at| at[face] = 0.0)
    }

    /// The same for where a linear function is positive, given at the corners of the piece.
    pub(super) fn cut_where(&mut self, at_corners: &[f64; 4]) -> bool {
        self.cut(FREE, |at| at.iter().zip(at_corners).map(|(w, value)| w * value).sum(), |_| {})
    }

    fn cut(&mut self, face: u8, value: impl Fn(&[f64; 4]) -> f64, set_zero: impl Fn(&mut [f64; 4])) -> bool {
        let [first, second] = &mut self.corners;
        let (before, kept) = if self.now == 0 { (&*first, second) } else { (&*second, first) };
        self.now = 1 - self.now;
        kept.count = 0;
        let count = before.count;
        let mut values = [0.0; MOST_CORNERS];
        before.at[..count].iter().zip(&mut values).for_each(|(at, v)| *v = value(at));
        // An interval has one side, a polygon as many as corners.
        let sides = if D == 2 { count.saturating_sub(1) } else { count };
        for p in 0..count {
            let q = if p + 1 < count { p + 1 } else { 0 };
            if values[p] > 0.0 {
                kept.add(before.at[p], before.on[p], before.faces[p]);
            }
            if p < sides && (values[p] > 0.0) != (values[q] > 0.0) {
                let (from, to) = if values[p] > 0.0 { (p, q) } else { (q, p) };
                let part = values[from] / (values[from] - values[to]);
                let mut at = between(&before.at[from], &before.at[to], part);
                set_zero(&mut at);
                let on = between(&before.on[from], &before.on[to], part);
                // On the way out the next edge lies on the face; on the way in it is what is left of this one.
                kept.add(at, on, if D == 2 || from == p { face } else { before.faces[p] });
            }
        }
        kept.count >= D
    }

    /// Corners, in the facet's barycentric coordinates.
    pub(crate) fn on_facet(&self) -> &[[f64; D]] {
        &self.corners[self.now].on[..self.count()]
    }

    /// The same in those of the piece.
    pub(crate) fn in_piece(&self) -> &[[f64; 4]] {
        &self.corners[self.now].at[..self.count()]
    }

    /// Number of the corner before this one, of a polygon.
    pub(super) fn before(&self, corner: usize) -> usize {
        if corner == 0 { self.count() - 1 } else { corner - 1 }
    }

    /// Number of the corner after this one, of a polygon.
    pub(crate) fn after(&self, corner: usize) -> usize {
        if corner + 1 == self.count() { 0 } else { corner + 1 }
    }

    /// The face of the piece on which the edge after a corner lies (2D: the corner), or [`FREE`].
    pub(crate) fn face(&self, corner: usize) -> u8 {
        self.corners[self.now].faces[corner]
    }

    fn count(&self) -> usize {
        self.corners[self.now].count
    }
}

/// A point between two, all of whose coordinates lie between theirs: what is inside a face at both ends stays inside, so that a facet on
/// which that face has no corner outside needs no cut there, and agrees with a neighbour that has.
fn between<const N: usize>(from: &[f64; N], to: &[f64; N], part: f64) -> [f64; N] {
    std::array::from_fn(|i| {
        let (p, q) = (from[i], to[i]);
        (p + part * (q - p)).max(p.min(q)).min(p.max(q))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cut at a corner that lies inside another face by less than the last bit of the other end's coordinate.
    #[test]
    fn a_cut_stays_inside_other_faces() {
        let inside = f64::EPSILON / 16.0;
        let barycentric = [[0.5, 0.5, -0.8, 0.8], [-0.9, 0.3, 0.8, 0.8], [0.0, inside, 0.2, 0.8 - inside]];
        let mut part = FacetPart::<3>::default();
        part.reset(&barycentric);
        assert!(part.cut_to_face(0));
        let nearest = part.in_piece().iter().map(|at| at[1]).fold(f64::INFINITY, f64::min);
        assert_eq!(nearest, inside);
    }
}
