//! Patches of the fiber law, kept during a solve or found anew.

use super::Contact;
use super::candidate::Candidate;
use crate::Error;
use crate::overlap::ContactPoints;

impl<const D: usize> Contact<D> {
    /// Finds the patches of the fiber law at `coords` and keeps them for all evaluations to come, until this is called
    /// again or [`Self::release_patches`]: the directions of the lines and their spacing. With kept patches the forces
    /// are the gradient of one energy, as a Newton solver needs. Pairs that do not overlap at `coords` are not kept, and
    /// theirs are found at every evaluation. Returns the number of directions kept; 0 for other laws.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; what was kept then stays.
    pub fn keep_patches(&mut self, coords: &[[f64; D]]) -> Result<usize, Error> {
        if !self.options.law.is_fiber() {
            return Ok(0);
        }
        self.kept = self.for_each_pair(coords, |Candidate { fibers, exact }| {
            let Some(mut patches) = fibers.patches(false)? else { return Ok(None) };
            if exact.is_none() {
                patches.spacing = fibers.spans(&patches)?.map(|spans| spans.spacing);
            }
            Ok(Some((fibers.pair.partners, patches)))
        })?;
        Ok(self.kept.iter().map(|(_, patches)| patches.directions.len()).sum())
    }

    /// Forgets kept patches.
    pub fn release_patches(&mut self) {
        self.kept.clear();
    }

    /// ContactPoints of a pair: on its kept patches, or on those that are found now.
    pub(super) fn spans(
        &self,
        Candidate { fibers, exact }: &Candidate<D>,
        kinks: bool,
    ) -> Result<Option<ContactPoints<D>>, Error> {
        let found;
        let patches = match self.kept.iter().find(|(partners, _)| *partners == fibers.pair.partners) {
            Some((_, patches)) => patches,
            None => match fibers.patches(true)? {
                Some(patches) => {
                    found = patches;
                    &found
                }
                None => return Ok(None),
            },
        };
        let spans = match exact {
            Some(exact) => exact.spans(patches, kinks)?,
            None => fibers.spans(patches)?,
        };
        Ok(spans.filter(|spans| !spans.spans.is_empty() || !spans.warnings.is_empty()))
    }
}
