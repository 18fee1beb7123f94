//! Where surfaces lie beside their nodes: what hosts call.

use crate::Error;
use crate::contact::changes::adjustment::{self, Adjustment};
use crate::contact::evaluation::Contact;

impl<const D: usize> Contact<D> {
    /// Closes gaps and removes overlaps at `coords` without strain: where the mean gap of a surface point to a partner is no more than
    /// `close`, or its overlap no more than `remove`, both lengths, the surface is taken to lie beside its nodes from then on, of two
    /// bodies each half of the way. Nodes and their strains stay. What lay elsewhere before is moved on. Any law, friction and
    /// self-contact go with it, and all that is asked of the contact afterwards, gaps too, is that of surfaces that lie there.
    ///
    /// An interference fit is brought on by parts: adjust, and before each load step give back a smaller part of [`Self::offsets`] by
    /// [`Self::set_offsets`], at last none. The vectors do not turn with bodies.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a length that is negative or no number; [`Error::Unsupported`] for a mesh in parts; [`Error::OfPair`] for bodies that
    /// are held together already across a gap, which they keep: adjust first; else as [`Self::gap_constraints`]. Surfaces then lie where they did.
    #[inline(never)]
    pub fn adjust(&mut self, coords: &[[f64; D]], close: f64, remove: f64) -> Result<Adjustment, Error> {
        adjustment::adjust(self, coords, close, remove)
    }

    /// How far the surface lies beside its nodes, a vector for every node; with cells of second order for every point
    /// ([`Self::point_weights`]).
    #[inline(never)]
    pub fn offsets(&self) -> Vec<[f64; D]> {
        self.mesh.offsets().list(self.mesh.surface.point_weights().point_count())
    }

    /// Has the surface lie so far beside its nodes; `&[]`: nowhere. No body slides by that, but friction feels the pressure that it makes.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteStiffness`] for a vector that is not finite, [`Error::Unsupported`] for a mesh in parts.
    #[inline(never)]
    pub fn set_offsets(&mut self, offsets: &[[f64; D]]) -> Result<(), Error> {
        adjustment::set(self, offsets)
    }

    /// Has straight faces that stand for round surfaces measured as these: where they meet at less than `feature_angle` degrees, the surface
    /// between them is the smooth one whose normals at the nodes are those of the faces around each. For the law `depth` between two
    /// bodies; 0 takes faces for flat, the default. Curved faces of second order are measured as curved in any case, and straight ones of
    /// second order in the same body as flat. At a larger angle faces meet at an edge of the body: 30 is usual. A round body needs some 40 facets around it.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for an angle that is negative, no number, or 90 and more; [`Error::Unsupported`] for a surface without cells and
    /// for a mesh in parts. What was set before then stays.
    #[inline(never)]
    pub fn set_surface_smoothing(&mut self, feature_angle: f64) -> Result<(), Error> {
        self.mesh.set_surface_smoothing(feature_angle)
    }
}
