//! Slip that is carried from one step to the next, whatever was gathered.

use super::PartitionedContact;
use super::zone::FacetName;
use crate::Error;
use crate::contact::FacetSlip;
use crate::overlap::Partner;

/// Elastic slip of a boundary facet against one of the bodies and obstacles that it faces, by the numbers of the whole mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarriedSlip<const D: usize> {
    /// Number of its cell in the whole mesh.
    pub cell: u64,
    /// Face of that cell, as VTK counts them.
    pub face: u32,
    /// Which of the facets of that face: a quadrilateral has four, one of second order all its parts.
    pub part: u32,
    /// What it faces; its own body where that touches itself.
    pub partner: Partner,
    /// Whether its body is the second side of the pair.
    pub is_second: bool,
    /// Elastic slip of the facet against it.
    pub slip: [f64; D],
    /// How far it has slid since it rested.
    pub slid: f64,
}

impl<const D: usize> PartitionedContact<D> {
    /// The elastic slip that was carried into the step, where it is not zero, ascending by cell, face, part and partner;
    /// the same on all ranks. With the coordinates at which the step began it is all that a restart needs, on any number of
    /// ranks.
    ///
    /// # Errors
    /// [`Error::NoStep`].
    #[inline(never)]
    pub fn slip(&self) -> Result<Vec<CarriedSlip<D>>, Error> {
        let named = |FacetSlip { facet, partner, is_second, slip, slid }: FacetSlip<D>| {
            let FacetName { cell, face, part } = self.zone.facets[facet];
            CarriedSlip { cell, face, part, partner, is_second, slip, slid }
        };
        let mut carried: Vec<CarriedSlip<D>> = self.contact.slip()?.into_iter().map(named).collect();
        carried.sort_unstable_by_key(|of| (of.cell, of.face, of.part, of.partner, of.is_second));
        Ok(carried)
    }

    /// Sets the elastic slip that was carried into the step that has begun; none for what is not listed. All ranks give
    /// the same, after [`Contact::begin_step`](crate::Contact::begin_step) at the coordinates of that time.
    ///
    /// # Errors
    /// [`Error::NoStep`], [`Error::NoSuchRow`], [`Error::NonFiniteSlip`], naming the index in the list, [`Error::Unsupported`] for a facet
    /// that was not gathered, which cannot have been in contact when the step began. The old slip then stays.
    #[inline(never)]
    pub fn set_slip(&mut self, carried: &[CarriedSlip<D>]) -> Result<(), Error> {
        let numbers = self.zone.facet_numbers();
        let named = |(index, of): (usize, &CarriedSlip<D>)| {
            let CarriedSlip { cell, face, part, partner, is_second, slip, slid } = *of;
            let what = "slip of a facet that was not gathered";
            let facet = *numbers.get(&FacetName { cell, face, part }).ok_or(Error::Unsupported { what })?;
            if !(slip.iter().all(|x| x.is_finite()) && slid.is_finite() && slid >= 0.0) {
                return Err(Error::NonFiniteSlip { facet: index });
            }
            Ok(FacetSlip { facet, partner, is_second, slip, slid })
        };
        let slip = carried.iter().enumerate().map(named).collect::<Result<Vec<_>, _>>()?;
        self.contact.set_slip(&slip)
    }
}
