//! What bounds the lines through an edge, before it and behind it: the envelopes of the facets that cover it.
//!
//! Over an edge that is seen from the side every facet that covers a part of it is a segment. On either side of the edge
//! the nearest segments are an envelope, which has about as many corners as there are segments; all others are hidden.

use super::edges::along;
use super::projected_facets::ProjectedFacet;

/// A shorter part of an edge is rounding.
const LEAST: f64 = 1e-14;

/// What bounds a line at a place: a facet, or the plane.
#[derive(Clone, Copy)]
pub(super) enum Bound<'a, const D: usize> {
    Facet(&'a ProjectedFacet<D>),
    Plane { leaves: bool },
}

impl<const D: usize> Bound<'_, D> {
    pub(super) fn leaves(&self) -> bool {
        match self {
            Bound::Facet(facet) => facet.leaves,
            Bound::Plane { leaves } => *leaves,
        }
    }
}

/// A part of an edge, from 0 to 1 along it, where something covers it, and how far ahead that is at both ends of the edge.
pub(super) struct Segment<'a, const D: usize> {
    pub(super) part: [f64; 2],
    pub(super) ahead: [f64; 2],
    pub(super) bound: Bound<'a, D>,
}

impl<'a, const D: usize> Segment<'a, D> {
    /// The part of an edge that a facet covers, if it does.
    pub(super) fn of_facet(ends: &[[f64; 3]; 2], facet: &'a ProjectedFacet<D>) -> Option<Self> {
        let [first, last] = ends.map(|place| facet.barycentric(&place));
        let [mut from, mut to] = [0.0f64, 1.0f64];
        for (p, q) in first.into_iter().zip(last) {
            match (p >= 0.0, q >= 0.0) {
                (true, true) => {}
                (false, false) => return None,
                (true, false) => to = to.min(p / (p - q)),
                (false, true) => from = from.max(p / (p - q)),
            }
        }
        let ahead = [facet.t(&first) - ends[0][2], facet.t(&last) - ends[1][2]];
        (to - from > LEAST).then_some(Self { part: [from, to], ahead, bound: Bound::Facet(facet) })
    }

    fn ahead_at(&self, s: f64) -> f64 {
        along(&self.ahead.map(|t| [t, 0.0, 0.0]), s)[0]
    }
}

/// A part of an edge whose lines are bounded by the same two, with the indices of these.
pub(super) struct Bounded {
    pub(super) part: [f64; 2],
    pub(super) before: usize,
    pub(super) behind: usize,
}

/// The parts of an edge that are bounded on both sides.
pub(super) fn bounded<const D: usize>(segments: &[Segment<D>]) -> Vec<Bounded> {
    let mut ends = vec![0.0, 1.0];
    for segment in segments {
        ends.extend(segment.part);
        let [p, q] = segment.ahead;
        if (p > 0.0) != (q > 0.0) {
            ends.push(p / (p - q));
        }
    }
    ends.sort_unstable_by(f64::total_cmp);
    let mut all: Vec<Bounded> = Vec::new();
    for pair in ends.windows(2).filter(|pair| pair[1] - pair[0] > LEAST) {
        let part = [pair[0], pair[1]];
        let covers = |segment: &Segment<D>| segment.part[0] <= part[0] && segment.part[1] >= part[1];
        let middle = 0.5 * (part[0] + part[1]);
        let side = |sign: f64| {
            let of_side = |(index, segment): (usize, &Segment<D>)| {
                let is_there = covers(segment) && (segment.ahead_at(middle) >= 0.0) == (sign > 0.0);
                is_there.then(|| (index, part.map(|s| sign * segment.ahead_at(s))))
            };
            envelope(part, &segments.iter().enumerate().filter_map(of_side).collect::<Vec<_>>())
        };
        let (before, behind) = (side(-1.0), side(1.0));
        let (mut i, mut j, mut from) = (0, 0, part[0]);
        while let (Some(&(first, to_first)), Some(&(last, to_last))) = (before.get(i), behind.get(j)) {
            let to = to_first.min(to_last);
            match all.last_mut().filter(|b| b.part[1] == from && (b.before, b.behind) == (first, last)) {
                Some(same) => same.part[1] = to,
                None if to > from => all.push(Bounded { part: [from, to], before: first, behind: last }),
                None => {}
            }
            from = to;
            i += usize::from(to_first == to);
            j += usize::from(to_last == to);
        }
    }
    all.retain(|b| b.part[1] - b.part[0] > LEAST);
    all
}

/// The least of some linear functions, each with an index and its values at both ends of a part: which it is, and up to
/// where.
fn envelope(part: [f64; 2], lines: &[(usize, [f64; 2])]) -> Vec<(usize, f64)> {
    let by = |k: usize| {
        move |p: &&(usize, [f64; 2]), q: &&(usize, [f64; 2])| {
            p.1[k].total_cmp(&q.1[k]).then(p.1[1 - k].total_cmp(&q.1[1 - k]))
        }
    };
    let Some(mut least) = lines.iter().min_by(by(0)) else { return Vec::new() };
    let (mut found, mut from) = (Vec::new(), 0.0);
    loop {
        // The next to come below falls faster: where they cross, as part of the way.
        let crossing = |line: &&(usize, [f64; 2])| {
            let [p, q] = [0, 1].map(|k| line.1[k] - least.1[k]);
            (q < 0.0).then(|| (p / (p - q)).clamp(from, 1.0))
        };
        let next = lines.iter().filter_map(|line| Some((crossing(&line)?, line)));
        let next = next.min_by(|(s, p), (t, q)| s.total_cmp(t).then(by(1)(p, q)));
        let at = |s: f64| part[0] + s * (part[1] - part[0]);
        let Some((s, line)) = next else {
            found.push((least.0, part[1]));
            return found;
        };
        found.push((least.0, at(s)));
        (least, from) = (line, s);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(part: [f64; 2], ahead: [f64; 2]) -> Segment<'static, 3> {
        Segment { part, ahead, bound: Bound::Plane { leaves: false } }
    }

    /// One before all of the edge; behind it a flat one, a steep one that comes nearer at three quarters, and one that is
    /// hidden.
    #[test]
    fn the_nearest_bound_an_edge_and_what_is_hidden_does_not() {
        let segments = [
            segment([0.0, 1.0], [-1.0, -2.0]),
            segment([0.0, 1.0], [1.0, 1.0]),
            segment([0.25, 1.0], [4.0, 0.0]),
            segment([0.1, 0.9], [5.0, 5.0]),
        ];
        let found: Vec<_> = bounded(&segments).into_iter().map(|b| (b.part, b.before, b.behind)).collect();
        assert_eq!(found, [([0.0, 0.75], 0, 1), ([0.75, 1.0], 0, 2)]);
    }

    /// A segment that passes through the edge is behind it first, before it then.
    #[test]
    fn a_segment_through_the_edge_bounds_both_sides() {
        let segments = [[-2.0, -2.0], [2.0, 2.0], [1.0, -1.0]].map(|ahead| segment([0.0, 1.0], ahead));
        let found: Vec<_> = bounded(&segments).into_iter().map(|b| (b.part, b.before, b.behind)).collect();
        assert_eq!(found, [([0.0, 0.5], 0, 2), ([0.5, 1.0], 2, 1)]);
    }

    /// Segments of a fan, k (k − 1) / 2 crossings: the envelope has k parts.
    #[test]
    fn an_envelope_has_as_many_parts_as_lines() {
        let tangent = |x: f64| segment([0.0, 1.0], [3.0 + x * x, 3.0 + x * x - 2.0 * x]);
        let segments: Vec<_> = [segment([0.0, 1.0], [-1.0, -1.0])]
            .into_iter()
            .chain((0..40).map(|k| tangent(f64::from(k) / 40.0 + 0.0125)))
            .collect();
        // Each is the tangent of 3 − s² at its place: the least of all at s.
        let found = bounded(&segments);
        assert_eq!(found.len(), 40);
        for b in &found {
            let s = 0.5 * (b.part[0] + b.part[1]);
            let least = segments[1..].iter().map(|segment| segment.ahead_at(s)).fold(f64::INFINITY, f64::min);
            assert_eq!(segments[b.behind].ahead_at(s), least);
        }
    }
}
