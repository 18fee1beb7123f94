//! How much of every piece of a body lies inside the other, and where.

use super::boundary_moments::whole;
use super::cell_pieces::CellPieces;
use super::deep_bodies::{CHUNK, DeepBodies};
use super::piece_moments::{Moments, common_moments};
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::overlap::pair::bounds::Bounds;
use rustc_hash::FxHashMap;

/// Coordinates below this part of the height of a piece are told from rounding; of thinner pieces nothing can be.
const TOO_THIN: f64 = 1e-3;

/// The pieces of one body, and the other body.
pub(super) struct Enclosed<'a, const D: usize> {
    pub(super) bodies: &'a DeepBodies<'a, D>,
    pub(super) pieces: &'a CellPieces<D>,
    /// The surface of the other body, and its pieces.
    pub(super) side: &'a FacetSide<'a, D>,
    pub(super) other: &'a CellPieces<D>,
    /// What holds all of the overlap.
    pub(super) bounds: &'a Bounds<D>,
    /// Whether the other body is the same, of which a cell does not count for its own pieces.
    pub(super) is_own: bool,
}

impl<const D: usize> Enclosed<'_, D> {
    /// Moments of the overlap in the barycentric coordinates of every piece, given what the facets of the other body add and the pieces
    /// of which that is not certain.
    ///
    /// Of these every part of a piece of the other body is found by itself.
    pub(super) fn moments<M: Moments>(&self, shares: impl Iterator<Item = (u32, M)>, doubtful: &[Vec<u32>]) -> Vec<M> {
        let (pieces, is_doubtful) = (&self.pieces.pieces, self.doubtful(doubtful));
        let mut moments = vec![M::default(); pieces.len()];
        shares.for_each(|(number, share)| moments[number as usize].add(&share));
        let windings = self.windings(&is_doubtful);
        let whole = whole::<M, D>();
        for ((number, piece), winding) in pieces.iter().enumerate().zip(windings) {
            let sum = &mut moments[number];
            *sum = sum.times(piece.turn);
            if winding != 0 {
                sum.add(&whole.times(f64::from(winding)));
            }
            *sum = sum.times(piece.sign * piece.measure);
        }
        let doubtful: Vec<usize> = (0..pieces.len()).filter(|&number| is_doubtful[number]).collect();
        let in_pieces = |numbers: &[usize]| numbers.iter().map(|&number| self.part_by_part(number)).collect::<Vec<M>>();
        let found = self.bodies.pair.in_chunks(&doubtful, CHUNK, in_pieces);
        doubtful.iter().zip(found.into_iter().flatten()).for_each(|(&number, sum)| moments[number] = sum);
        moments
    }

    /// Whether rounding might decide what is found of a piece from facets, or where it is not that which is asked for.
    pub(super) fn doubtful(&self, doubtful: &[Vec<u32>]) -> Vec<bool> {
        let pieces = &self.pieces.pieces;
        let mut is_doubtful: Vec<bool> = (pieces.iter().zip(&self.pieces.near))
            .map(|(piece, near)| piece.is_cut() || *near > TOO_THIN || self.is_own && piece.sign < 0.0)
            .collect();
        doubtful.iter().flatten().for_each(|&number| is_doubtful[number as usize] = true);
        if self.is_own {
            self.spread_over_inverted_cells(&mut is_doubtful);
        }
        is_doubtful
    }

    /// A cell with an inverted piece covers some places more than once.
    fn spread_over_inverted_cells(&self, is_doubtful: &mut [bool]) {
        let pieces = &self.pieces.pieces;
        let mut first = 0;
        while first < pieces.len() {
            let count = pieces[first..].iter().take_while(|piece| piece.cell == pieces[first].cell).count();
            let of_cell = first..first + count;
            if pieces[of_cell.clone()].iter().any(|piece| piece.sign < 0.0) {
                is_doubtful[of_cell].fill(true);
            }
            first += count;
        }
    }

    /// How often the other body winds around the last corner of every piece.
    ///
    /// That corner belongs to this body; where the bounds do not hold it, it does not belong to the other.
    fn windings(&self, is_doubtful: &[bool]) -> Vec<i32> {
        let (mut points, mut point_of) = (Vec::new(), FxHashMap::default());
        let of_pieces = self.pieces.pieces.iter().zip(is_doubtful).map(|(piece, &is_doubtful)| {
            let last = piece.corners[D];
            if is_doubtful || !self.bounds.may_hold(std::iter::once(last)) {
                return None;
            }
            let bits: [u64; D] = std::array::from_fn(|i| last[i].to_bits());
            Some(*point_of.entry(bits).or_insert_with(|| {
                points.push(last);
                points.len() - 1
            }))
        });
        let of_pieces: Vec<Option<usize>> = of_pieces.collect();
        let around = |points: &[Vector<D>]| points.iter().map(|x| self.side.winding_number(x)).collect::<Vec<i32>>();
        let found: Vec<i32> = self.bodies.pair.in_chunks(&points, CHUNK, around).into_iter().flatten().collect();
        let own = i32::from(self.is_own);
        of_pieces.into_iter().map(|point| point.map_or(0, |point| found[point] - own)).collect()
    }

    /// The sum of what each piece of the other body has inside a piece.
    pub(super) fn part_by_part<M: Moments>(&self, number: usize) -> M {
        let (piece, aabb) = (&self.pieces.pieces[number], &self.pieces.boxes[number]);
        let mut sum = M::default();
        self.other.tree.visit(
            |node| node.meets(aabb),
            |j| {
                let other = &self.other.pieces[j as usize];
                let is_own = self.is_own && other.cell == piece.cell;
                if !is_own
                    && self.other.boxes[j as usize].meets(aabb)
                    && let Some([in_piece, _]) = common_moments::<M, D>(piece, other)
                {
                    sum.add(&in_piece);
                }
            },
        );
        sum
    }
}
