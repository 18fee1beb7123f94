//! What the lines of a bundle have inside both bodies.

use super::chords::{Chord, Lines};
use crate::geometry::Vector;
use crate::geometry::crossing::{for_each_crossing, weights_at};
use crate::overlap::depth::cell_pieces::CellPieces;
use crate::overlap::fibers::bundle::Bundle;
use crate::overlap::pair::sides::Pair;
use crate::ranks::packed;

/// A part of a line inside a piece of either body at once, as one of the two pieces sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) of_b: bool,
    pub(super) piece: u32,
    /// Its length; negative in one cell of the two that is inverted.
    pub(super) length: f64,
    /// Barycentric coordinates of its ends in the piece.
    pub(super) ends: [[f64; 4]; 2],
    /// Sums of both depths there.
    pub(super) depths: [f64; 2],
}

/// A crossing of a line with a facet, in a piece of the other side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch<const D: usize> {
    pub(super) of_b: bool,
    pub(super) facet: u32,
    pub(super) piece: u32,
    /// Barycentric coordinates in the facet, and in the piece.
    pub(super) weights: [f64; D],
    pub(super) in_piece: [f64; 4],
    /// Whether it lies in the piece, or only in its face but for rounding.
    pub(super) is_inside: bool,
}

/// What the lines of one bundle found.
pub(super) struct LineSums<const D: usize> {
    pub(super) spans: Vec<Span>,
    pub(super) touches: Vec<Touch<D>>,
    /// Sum of the lengths inside both, and how many lines have one.
    pub(super) length: f64,
    pub(super) lines_met: usize,
}

packed!(Span { of_b, piece, length, ends, depths });
packed!(Touch<D> { of_b, facet, piece, weights, in_piece, is_inside });
packed!(LineSums<D> { spans, touches, length, lines_met });

/// The pieces of both sides, those of a body with itself once.
pub(super) struct Pieces<'a, const D: usize> {
    pub(super) pair: &'a Pair<'a, D>,
    pub(super) of: &'a [CellPieces<D>],
    /// Cell of every facet of the first side, which does not count, where the other body is the same.
    pub(super) own_cell: Option<&'a [u32]>,
    /// Places nearer than this are one.
    pub(super) tolerance: f64,
}

/// A crossing on a line.
struct Crossing {
    line: u32,
    t: f64,
    of_b: bool,
    facet: u32,
}

impl<const D: usize> Pieces<'_, D> {
    /// Of the lines of a bundle; isotropic segments have none.
    pub(super) fn sums(&self, bundle: &Bundle<D>) -> LineSums<D> {
        let mut sums = LineSums { spans: Vec::new(), touches: Vec::new(), length: 0.0, lines_met: 0 };
        let Bundle::Lines { family, spacing, window, facets, .. } = bundle else { return sums };
        let lines = Lines { family, spacing: *spacing, window };
        let mut chords = Vec::new();
        for (of, of_b) in self.of.iter().zip([false, true]) {
            lines.chords(of, of_b, &mut chords);
        }
        Chord::sort(&mut chords);
        let mut crossings: Vec<Crossing> = Vec::new();
        for of_b in [false, true].into_iter().take(self.of.len()) {
            for &facet in &facets[usize::from(of_b)].within {
                let p = bundle.project(self.pair.side(of_b), facet as usize, 0);
                for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), window, |i, j, t, _| {
                    crossings.push(Crossing { line: window.line(i, j), t, of_b, facet });
                });
            }
        }
        crossings.sort_unstable_by_key(|crossing| (crossing.line, crossing.of_b, crossing.facet));
        let mut rest = &crossings[..];
        for on_line in chords.chunk_by(|p, q| p.line == q.line) {
            let line = on_line[0].line;
            rest = &rest[rest.partition_point(|crossing| crossing.line < line)..];
            let (here, further) = rest.split_at(rest.partition_point(|crossing| crossing.line == line));
            rest = further;
            let (of_a, of_b) = on_line.split_at(on_line.partition_point(|chord| !chord.of_b));
            let ray = bundle.ray(u64::from(line));
            let length = self.add_spans(&ray, of_a, of_b, &mut sums.spans);
            sums.length += length;
            sums.lines_met += usize::from(length != 0.0);
            for crossing in here {
                let others = if crossing.of_b || self.own_cell.is_some() { of_a } else { of_b };
                self.add_touches(bundle, &ray, crossing, others, &mut sums.touches);
            }
        }
        sums
    }

    fn of(&self, of_b: bool) -> &CellPieces<D> {
        &self.of[usize::from(of_b)]
    }

    /// Adds what a line has in every two chords at once; the length of that, negative parts included.
    fn add_spans(&self, ray: &(Vector<D>, Vector<D>), of_a: &[Chord], of_b: &[Chord], spans: &mut Vec<Span>) -> f64 {
        let mut sum = 0.0;
        for (number, p) in of_a.iter().enumerate() {
            let others = if self.own_cell.is_some() { &of_a[number + 1..] } else { of_b };
            for q in others.iter().take_while(|q| q.ends[0] < p.ends[1]) {
                let [from, to] = [p.ends[0].max(q.ends[0]), p.ends[1].min(q.ends[1])];
                let [in_p, in_q] = [p, q].map(|chord| &self.of(chord.of_b).pieces[chord.piece as usize]);
                if from >= to || (self.own_cell.is_some() && in_p.cell == in_q.cell) {
                    continue;
                }
                let length = in_p.sign * in_q.sign * (to - from);
                sum += length;
                let at_ends = [from, to].map(|t| ray.0 + ray.1 * t);
                let of_piece = [in_p, in_q].map(|piece| at_ends.each_ref().map(|x| piece.barycentric(x)));
                let depth = |side: usize, end: usize| -> f64 {
                    (0..=D).map(|k| of_piece[side][end][k] * [in_p, in_q][side].depths[k]).sum()
                };
                let depths = [0, 1].map(|end| depth(0, end) + depth(1, end));
                for (side, (chord, piece)) in [(p, in_p), (q, in_q)].into_iter().enumerate() {
                    let [mut start, mut end] = of_piece[side];
                    let mut part = length;
                    if piece.is_cut() {
                        let Some(between) = positive([depth(side, 0), depth(side, 1)]) else { continue };
                        let at = |s: f64| std::array::from_fn(|k| start[k] + s * (end[k] - start[k]));
                        part *= between[1] - between[0];
                        (start, end) = (at(between[0]), at(between[1]));
                    }
                    spans.push(Span { of_b: chord.of_b, piece: chord.piece, length: part, ends: [start, end], depths });
                }
            }
        }
        sum
    }

    /// Adds a crossing in every piece of the other side in which it lies.
    fn add_touches(
        &self,
        bundle: &Bundle<D>,
        (origin, direction): &(Vector<D>, Vector<D>),
        crossing: &Crossing,
        others: &[Chord],
        touches: &mut Vec<Touch<D>>,
    ) {
        let &Crossing { line, t, of_b, facet } = crossing;
        let tolerance = self.tolerance;
        let near = others.iter().take_while(|chord| chord.ends[0] <= t + tolerance);
        for chord in near.filter(|chord| t - tolerance <= chord.ends[1]) {
            let piece = &self.of(chord.of_b).pieces[chord.piece as usize];
            let is_inside = chord.ends[0] <= t && t < chord.ends[1];
            let is_own = self.own_cell.is_some_and(|cells| cells[facet as usize] == piece.cell);
            if is_own || !(is_inside || piece.is_at_surface) {
                continue;
            }
            let p = bundle.project(self.pair.side(of_b), facet as usize, 0);
            let (i, j) = bundle.grid_point(u64::from(line));
            let (weights, _) = weights_at::<D>(std::array::from_fn(|k| &p[k]), i as f64, j as f64);
            let in_piece = piece.barycentric(&(origin + direction * t));
            touches.push(Touch { of_b, facet, piece: chord.piece, weights, in_piece, is_inside });
        }
    }
}

/// Where between 0 and 1 a linear function is positive that has these values there.
fn positive([first, last]: [f64; 2]) -> Option<[f64; 2]> {
    match (first > 0.0, last > 0.0) {
        (true, true) => Some([0.0, 1.0]),
        (false, false) => None,
        (true, false) => Some([0.0, first / (first - last)]),
        (false, true) => Some([first / (first - last), 1.0]),
    }
}
