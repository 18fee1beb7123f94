//! A face of a rigid surface.

/// Corners and, of second order, the middles of the edges from each corner to the next. In space corners stand counter-clockwise seen from outside; in
/// the plane the outside is to the left of the way from the first to the second.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Front {
    pub(crate) corners: Vec<usize>,
    pub(crate) middles: Vec<usize>,
}

impl Front {
    /// The same face, seen from its other side.
    pub(super) fn turn(&mut self) {
        match self.corners.len() {
            2 => self.corners.reverse(),
            _ => self.corners[1..].reverse(),
        }
        self.middles.reverse();
    }

    /// At each corner: its node, and the edges from it to the next and to the last one; in the plane the second is across the plane, so that the cross
    /// product of both looks outwards.
    pub(super) fn angles(&self, place: impl Fn(usize) -> [f64; 3]) -> Vec<(usize, [f64; 3], [f64; 3])> {
        let along = |p: usize, q: usize| {
            let [p, q] = [place(p), place(q)];
            std::array::from_fn(|k| q[k] - p[k])
        };
        let corners = &self.corners;
        if let [a, b] = corners[..] {
            const BELOW: [f64; 3] = [0.0, 0.0, -1.0];
            return vec![(a, along(a, b), BELOW), (b, along(a, b), BELOW)];
        }
        let count = corners.len();
        let at = |k: usize| {
            let corner = corners[k];
            (corner, along(corner, corners[(k + 1) % count]), along(corner, corners[(k + count - 1) % count]))
        };
        (0..count).map(at).collect()
    }
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}
