//! All that holds bodies of a contact together.

use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::held::{At, Wanted};
use crate::contact::laws::Answer;
use crate::interfaces::HeldFacets;

impl<const D: usize> Contact<D> {
    /// Whether bodies are tied, or do not separate.
    pub(crate) fn has_ties(&self) -> bool {
        !(self.ties.is_empty() && self.glides.is_empty())
    }

    /// Whether interfaces hold bodies together that carry something from step to step.
    pub(crate) fn has_history(&self) -> bool {
        !(self.cohesions.is_empty() && self.governed.is_empty())
    }

    /// Whether anything holds bodies together.
    pub(crate) fn has_held(&self) -> bool {
        self.has_ties() || self.has_history()
    }

    /// Refuses a law whose stiffness nobody has given or found yet, where anything follows it.
    pub(crate) fn check_stiffness(&self) -> Result<(), Error> {
        let options = self.method.options();
        let is_needed = || self.ties.has_added() || self.partners.need_stiffness(options, self.surface().body_count());
        if self.partners.has_stiffness(options) || !is_needed() { Ok(()) } else { Err(Error::NoStiffness) }
    }

    /// Has something asked at points of the mesh.
    pub(crate) fn at_points<T>(&self, points: &[[f64; D]], ask: impl FnOnce(At<D>) -> T) -> T {
        ask(At { points, stiffness: &|pair| self.stiffness_of_tie(pair), past: self.past() })
    }

    /// Energies and tangents of all at points of the mesh.
    pub(crate) fn answers_of_held(&self, points: &[[f64; D]], wanted: Wanted) -> Result<Vec<Answer<D>>, Error> {
        self.at_points(points, |at| {
            let mut answers = self.ties.answers(at, wanted)?;
            answers.extend(self.glides.answers(at, wanted)?);
            answers.extend(self.cohesions.answers(at, wanted)?);
            answers.extend(self.governed.answers(at, wanted)?);
            Ok(answers)
        })
    }

    /// Facets that are held of pairs of which parts alone are to be.
    pub(crate) fn held_facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        let in_motion = self.cohesions.facets().chain(self.governed.facets());
        self.ties.facets().chain(self.glides.facets()).chain(in_motion)
    }
}
