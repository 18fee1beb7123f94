//! Ties that are added beside the options of pairs: what hosts call.

use crate::Error;
use crate::contact::changes::added_ties;
use crate::contact::evaluation::Contact;
use crate::contact::ties::TieSummary;
use crate::geometry::Vector;
use crate::overlap::Partner;

impl<const D: usize> Contact<D> {
    /// Ties two named parts of the surface ([`Self::add_surface`]), each of one body, of two bodies or of one: x_A − x_B = `period` + jump for
    /// points that face one another without deformation once `period`, a length, has brought part B to part A. Returns the number of the
    /// tie, 1, 2, …; the jump is 0 at first ([`Self::set_tie_jump`]). A body may have several.
    ///
    /// What is tied, how, and within which `reach` (0: the default) is as of [`Interface::Tied`](crate::contact::Interface::Tied), with the stiffness of
    /// the pair's law and with multipliers. It changes no contact. With a period only the named facets can hide one another. Heat does not pass.
    ///
    /// With the period of a periodic cell and a jump H·period the cell has the macroscopic displacement gradient H; its stress is
    /// Σ F ⊗ period / V over the ties with their forces F ([`Self::tie_force`]). In a bolt that is cut across, the jump along its axis is
    /// the length that pretension takes out of it.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`] for a surface that does not exist; [`Error::Untied`]; [`Error::NotPositive`] for a reach;
    /// [`Error::NonFiniteStiffness`] for a period that is not finite; [`Error::Unsupported`] for a surface with facets of several bodies,
    /// for two with a facet in common, for two bodies in contact whose faces lie on one another, by the law `volume`, without cells, in
    /// parts, and for a period along the radius. Nothing changes then.
    #[inline(never)]
    pub fn add_tie(&mut self, surfaces: [usize; 2], period: [f64; D], reach: f64) -> Result<usize, Error> {
        added_ties::add(self, surfaces, period, reach)
    }

    /// Removes a tie that was added; numbers of others stay.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`].
    pub fn remove_tie(&mut self, tie: usize) -> Result<(), Error> {
        self.ties.remove(tie)?;
        self.state.forget_found();
        Ok(())
    }

    /// Has the first part of a tie that was added lie so far from the second, beside its period; multipliers stay. No face is looked for anew.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`], [`Error::NonFiniteStiffness`]; [`Error::Unsupported`] for a jump along the radius.
    #[inline(never)]
    pub fn set_tie_jump(&mut self, tie: usize, jump: [f64; D]) -> Result<(), Error> {
        added_ties::check_vector(self, "jump", &jump)?;
        self.ties.set_jump(tie, Vector::from(jump))?;
        self.state.forget_found();
        Ok(())
    }

    /// What a tie that was added holds.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`]; [`Error::Untied`] where other reference coordinates have left nothing of it.
    pub fn added_tie(&self, tie: usize) -> Result<TieSummary, Error> {
        let (tie, ..) = self.ties.of_number(tie)?;
        let (area, largest_gap, reach, count) = (tie.area, tie.largest_gap, tie.given, tie.rows.len());
        Ok(TieSummary { area, largest_gap, reach, count })
    }

    /// Force of a tie that was added on its first part at `coords`: the derivative of the energy by the jump. That on the second part is its
    /// negative.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`], [`Error::Untied`], [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::NoStiffness`].
    #[inline(never)]
    pub fn tie_force(&self, tie: usize, coords: &[[f64; D]]) -> Result<[f64; D], Error> {
        let (tie, multipliers, sign) = self.ties.of_number(tie)?;
        self.check_stiffness()?;
        let points = self.mesh.points(coords)?;
        let stiffness = self.stiffness_of_tie(tie.bodies.map(Partner::Body));
        Ok((tie.at(&points, stiffness, multipliers).force() * sign).into())
    }
}
