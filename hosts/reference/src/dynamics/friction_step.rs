//! Where a step of friction began.

use fmc_contact::contact::FacetSlip;

/// Where a step of friction began, and the elastic slip that was carried into it: with the displacement of now, all that
/// its forces follow from.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct FrictionStep<const D: usize> {
    pub(super) displacement: Vec<[f64; D]>,
    pub(super) slip: Vec<FacetSlip<D>>,
}
