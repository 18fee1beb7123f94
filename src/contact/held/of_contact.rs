//! All that holds bodies of a contact together.

use super::found::Wanted;
use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::laws::Answer;
use crate::interfaces::HeldFacets;

impl<const D: usize> Contact<D> {
    /// Whether bodies are tied, or do not separate.
    pub(crate) fn has_ties(&self) -> bool {
        !(self.ties.is_empty() && self.glides.is_empty())
    }

    /// Whether anything holds bodies together.
    pub(crate) fn has_held(&self) -> bool {
        self.has_ties() || !self.cohesions.is_empty()
    }

    /// Energies and tangents of all at points of the mesh.
    pub(crate) fn answers_of_held(&self, points: &[[f64; D]], wanted: Wanted) -> Result<Vec<Answer<D>>, Error> {
        let (mut answers, at) = (self.ties.answers((self, points), wanted)?, (self, points));
        answers.extend(self.glides.answers(at, wanted)?);
        answers.extend(self.cohesions.answers(at, wanted)?);
        Ok(answers)
    }

    /// Facets that are held of pairs of which parts alone are to be.
    pub(crate) fn held_facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        self.ties.facets().chain(self.glides.facets()).chain(self.cohesions.facets())
    }
}
