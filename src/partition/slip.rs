//! Slip that is carried from one step to the next, whatever was gathered.

use super::PartitionedContact;
use super::zone::FacetName;
use crate::Error;

/// Elastic slip of a boundary facet, by the numbers of the whole mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarriedSlip<const D: usize> {
    /// Number of its cell in the whole mesh.
    pub cell: u64,
    /// Face of that cell, as VTK counts them.
    pub face: u32,
    /// Which of the facets of that face: a quadrilateral has four, one of second order all its parts.
    pub part: u32,
    /// Elastic slip against what the facet faces.
    pub slip: [f64; D],
}

impl<const D: usize> PartitionedContact<D> {
    /// The elastic slip that was carried into the step, of all facets where it is not zero, ascending by cell, face and part;
    /// the same on all ranks. With the coordinates at which the step began it is all that a restart needs, on any number of
    /// ranks.
    ///
    /// # Errors
    /// [`Error::NoStep`].
    pub fn slip(&self) -> Result<Vec<CarriedSlip<D>>, Error> {
        let slip = self.contact.slip()?;
        let carried = self.zone.facets.iter().zip(slip).filter(|(_, slip)| slip.iter().any(|x| *x != 0.0));
        let mut carried: Vec<CarriedSlip<D>> = carried
            .map(|(FacetName { cell, face, part }, slip)| CarriedSlip {
                cell: *cell,
                face: *face,
                part: *part,
                slip: *slip,
            })
            .collect();
        carried.sort_unstable_by_key(|of| (of.cell, of.face, of.part));
        Ok(carried)
    }

    /// Sets the elastic slip that was carried into the step that has begun; zero for facets that are not listed. All ranks give
    /// the same, after [`Contact::begin_step`](crate::Contact::begin_step) at the coordinates of that time.
    ///
    /// # Errors
    /// [`Error::NoStep`], [`Error::NonFiniteSlip`], naming the index in the list, [`Error::Unsupported`] for a facet that was not
    /// gathered, which cannot have been in contact when the step began. The old slip then stays.
    pub fn set_slip(&mut self, carried: &[CarriedSlip<D>]) -> Result<(), Error> {
        let numbers = self.zone.facet_numbers();
        let mut slip = vec![[0.0; D]; self.zone.facets.len()];
        for (index, CarriedSlip { cell, face, part, slip: of_facet }) in carried.iter().enumerate() {
            let name = FacetName { cell: *cell, face: *face, part: *part };
            let facet =
                *numbers.get(&name).ok_or(Error::Unsupported { what: "slip of a facet that was not gathered" })?;
            if !of_facet.iter().all(|x| x.is_finite()) {
                return Err(Error::NonFiniteSlip { facet: index });
            }
            slip[facet] = *of_facet;
        }
        self.contact.set_slip(&slip)
    }
}
