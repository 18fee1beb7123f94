//! What a facet has inside a body.

use super::cell_walk::{CellWalk, Slab};
use super::solid::Solid;
use crate::geometry::Vector;
use crate::geometry::convex_piece::{Piece, clip_below, place};
use crate::geometry::facet::area_vector;
use crate::geometry::plane::Plane;
use crate::overlap::pair::assembly::FacetShare;

/// What a facet has inside the other side.
pub(crate) struct Clipped<const D: usize> {
    pub(crate) share: FacetShare<D>,
    /// Corners of the part inside, where they are known; a few more where it was put together from pieces. `None` for
    /// the corners of the facet itself.
    pub(crate) ends: Option<Vec<Vector<D>>>,
}

/// Clips facets one after the other; it keeps memory only.
#[derive(Default)]
pub(crate) struct Clipper<const D: usize> {
    piece: Piece<D>,
    walk: CellWalk,
    found: Vec<u32>,
    /// Corners of the pieces of the facet in hand, in its barycentric coordinates.
    ends: Vec<[f64; D]>,
}

/// How a facet stands to a body.
pub(crate) enum Inside<const D: usize> {
    Part(Clipped<D>),
    /// It lies on the boundary, from outside.
    Touching,
    /// No cell that was looked at has a part of it.
    Nothing,
}

impl<const D: usize> Clipped<D> {
    /// A facet that is covered all over, `cover` times.
    pub(crate) fn whole(facet: u32, of_b: bool, corners: &[Vector<D>; D], cover: i32) -> Self {
        let each = area_vector(corners).norm() / D as f64 * f64::from(cover);
        Self { share: FacetShare { facet, of_b, shares: [each; D] }, ends: None }
    }
}

impl<const D: usize> Clipper<D> {
    /// What a facet has inside `solid`. The cell `except` does not count.
    pub(crate) fn inside(
        &mut self,
        facet: u32,
        of_b: bool,
        corners: &[Vector<D>; D],
        solid: &Solid<D>,
        tolerance: f64,
        except: Option<u32>,
    ) -> Inside<D> {
        let area = area_vector(corners);
        let (mut sums, mut cancelled, mut touches) = ([0.0; D], false, false);
        self.ends.clear();
        let (piece, ends) = (&mut self.piece, &mut self.ends);
        // Facets are near if their boxes are, each wider by the tolerance: the walk must start from every such one.
        let slab = Slab::new(corners, &area, 3.0 * tolerance);
        solid.for_each_near(&slab, &mut self.walk, &mut self.found, |simplex, origin| {
            if Some(origin) == except {
                return;
            }
            touches |= simplex.clip(corners, &area, tolerance, piece, |piece, part| {
                for (sum, moment) in sums.iter_mut().zip(piece.moments()) {
                    *sum += simplex.sign * part * moment;
                }
                ends.extend_from_slice(piece.corners());
                // Where pieces are subtracted from one another, their corners are not those of the overlap.
                cancelled |= simplex.sign < 0.0;
            });
        });
        let ends = if cancelled { Vec::new() } else { ends.iter().map(|w| place(corners, w)).collect() };
        let measure = area.norm();
        let share = FacetShare { facet, of_b, shares: sums.map(|w| w * measure) };
        match sums.iter().sum::<f64>() > 0.0 {
            true => Inside::Part(Clipped { share, ends: Some(ends) }),
            false if touches => Inside::Touching,
            false => Inside::Nothing,
        }
    }

    /// What a facet of the first side has below a plane, `None` if nothing.
    pub(crate) fn below(
        &mut self,
        facet: u32,
        corners: &[Vector<D>; D],
        plane: &Plane<D>,
        tolerance: f64,
    ) -> Option<Clipped<D>> {
        if !clip_below(&corners.map(|x| plane.height(&x)), tolerance, &mut self.piece) {
            return None;
        }
        let area = area_vector(corners).norm();
        let share = FacetShare { facet, of_b: false, shares: self.piece.moments().map(|w| w * area) };
        Some(Clipped { share, ends: Some(self.piece.corners().iter().map(|w| place(corners, w)).collect()) })
    }
}
