//! What a facet has inside a body.

use super::cell_walk::{CellWalk, Slab};
use super::solid::Solid;
use crate::geometry::primitives::convex_piece::{Piece, clip_below, place};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::{Vector, Weighting};
use crate::overlap::pair::assembly::FacetShare;
use crate::ranks::packed;

/// What a facet has inside the other side.
pub(crate) struct Clipped<const D: usize> {
    pub(crate) share: FacetShare<D>,
    /// Corners of the part inside, where they are known; a few more where it was put together from pieces. `None` for
    /// the corners of the facet itself.
    pub(crate) ends: Option<Vec<Vector<D>>>,
    /// ∫ N_a N_c over the part inside times the size of the weight's gradient; zero where there is no weight.
    pub(crate) spread: [[f64; D]; D],
}

packed!(Clipped<D> { share, ends, spread });

/// Clips facets one after the other; it keeps memory only.
#[derive(Default)]
pub(crate) struct Clipper<const D: usize> {
    weighting: Weighting,
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
    pub(crate) fn whole(
        (facet, of_b): (u32, bool),
        corners: &[Vector<D>; D],
        cover: i32,
        weighting: Weighting,
    ) -> Self {
        let measure = area_vector(corners).norm();
        if weighting.is_plain() {
            let each = measure / D as f64 * f64::from(cover);
            let share = FacetShare { facet, of_b, shares: [each; D] };
            return Self { share, ends: None, spread: [[0.0; D]; D] };
        }
        let mut piece = Piece::default();
        piece.reset();
        let (moments, spread) = weighting.moments(corners, &piece);
        let measure = measure * f64::from(cover);
        let share = FacetShare { facet, of_b, shares: moments.map(|w| w * measure) };
        Self { share, ends: None, spread: spread.map(|row| row.map(|w| w * measure)) }
    }
}

impl<const D: usize> Clipper<D> {
    pub(crate) fn new(weighting: Weighting) -> Self {
        Self { weighting, ..Self::default() }
    }

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
        let (mut sums, mut spread, mut cancelled, mut touches) = ([0.0; D], [[0.0; D]; D], false, false);
        self.ends.clear();
        let weighting = self.weighting;
        let (piece, ends) = (&mut self.piece, &mut self.ends);
        // Facets are near if their boxes are, each wider by the tolerance: the walk must start from every such one.
        let slab = Slab::new(corners, &area, 3.0 * tolerance);
        solid.for_each_near(&slab, &mut self.walk, &mut self.found, |simplex, origin| {
            if Some(origin) == except {
                return;
            }
            touches |= simplex.clip(corners, &area, tolerance, piece, |piece, part| {
                let (moments, products) = weighting.moments(corners, piece);
                for (sum, moment) in sums.iter_mut().zip(moments) {
                    *sum += simplex.sign * part * moment;
                }
                if !weighting.is_plain() {
                    let products = products.as_flattened().iter();
                    spread.as_flattened_mut().iter_mut().zip(products).for_each(|(s, p)| *s += simplex.sign * part * p);
                }
                ends.extend_from_slice(piece.corners());
                // Where pieces are subtracted from one another, their corners are not those of the overlap.
                cancelled |= simplex.sign < 0.0;
            });
        });
        let ends = if cancelled { Vec::new() } else { ends.iter().map(|w| place(corners, w)).collect() };
        let measure = area.norm();
        let share = FacetShare { facet, of_b, shares: sums.map(|w| w * measure) };
        // A facet on an axis has a part inside that weighs nothing.
        let counted: f64 = if weighting.is_plain() { sums.iter().sum() } else { spread.as_flattened().iter().sum() };
        match counted > 0.0 {
            true => {
                let spread = spread.map(|row| row.map(|w| w * measure));
                Inside::Part(Clipped { share, ends: Some(ends), spread })
            }
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
        let (moments, spread) = self.weighting.moments(corners, &self.piece);
        let share = FacetShare { facet, of_b: false, shares: moments.map(|w| w * area) };
        let ends = Some(self.piece.corners().iter().map(|w| place(corners, w)).collect());
        Some(Clipped { share, ends, spread: spread.map(|row| row.map(|w| w * area)) })
    }
}
