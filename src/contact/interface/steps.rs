//! What is kept from one evaluation to the next: the steps of friction, and patches.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;
use crate::contact::friction::FacetSlip;

impl<const D: usize> Contact<D> {
    /// Begins a step with friction at `coords`, with obstacles where they are: slip is counted from here. The elastic slip
    /// that was carried so far stays, none at first; [`Self::commit_step`] begins the next step by itself. To try a step
    /// again nothing has to be undone.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`]; with friction, of which what bears is measured here, as
    /// [`Self::evaluate`]. Nothing has then changed.
    #[inline(never)]
    pub fn begin_step(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        changes::friction_steps::begin(self, coords)
    }

    /// Accepts the step that ends at `coords`: the elastic slip there is carried into the next step, which begins here.
    /// Frozen friction is released. On an error nothing has changed.
    ///
    /// # Errors
    /// [`Error::NoStep`]; else as [`Self::evaluate`].
    #[inline(never)]
    pub fn commit_step(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        changes::friction_steps::commit(self, coords)
    }

    /// The elastic slip that was carried into the step: of every facet against each of the bodies and obstacles that it faced, where there
    /// was any. With the coordinates and poses at which the step began it is all that a restart needs.
    ///
    /// # Errors
    /// [`Error::NoStep`].
    #[inline(never)]
    pub fn slip(&self) -> Result<Vec<FacetSlip<D>>, Error> {
        changes::friction_steps::slip(self)
    }

    /// Sets the elastic slip that was carried into the step that has begun, after [`Self::begin_step`] at the coordinates
    /// of that time.
    ///
    /// # Errors
    /// [`Error::NoStep`], [`Error::NoSuchRow`], [`Error::NonFiniteSlip`]; the old one then stays.
    #[inline(never)]
    pub fn set_slip(&mut self, slip: &[FacetSlip<D>]) -> Result<(), Error> {
        changes::friction_steps::set_slip(self, slip)
    }

    /// Freezes the facets on which friction acts and their pressure as they are at `coords`, until the step ends or
    /// [`Self::release_friction`]: the forces of friction are then minus the gradient of a convex potential, and their
    /// tangent is symmetric and positive semidefinite. Repeated at what was found until nothing changes, this leads to the
    /// solution with the current pressure.
    ///
    /// # Errors
    /// [`Error::NoStep`]; else as [`Self::evaluate`]. What was frozen before then stays.
    #[inline(never)]
    pub fn freeze_friction(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        changes::friction_steps::freeze(self, coords)
    }

    /// Takes the pressure of the coordinates at hand again.
    pub fn release_friction(&mut self) {
        self.history.release_friction();
    }

    /// Finds the patches of the fiber law at `coords` and keeps them, that is the directions and the spacing of their
    /// lines, for all later evaluations, until this is called again or [`Self::release_patches`]. With kept patches the
    /// forces are the gradient of one energy, as a Newton solver needs. Patches of pairs that do not overlap at
    /// `coords` are not kept, but found at every evaluation. Returns the number of directions kept; 0 for other laws.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; patches kept before are then still kept.
    #[inline(never)]
    pub fn keep_patches(&mut self, coords: &[[f64; D]]) -> Result<usize, Error> {
        changes::patches::keep(self, coords)
    }

    /// Releases kept patches.
    pub fn release_patches(&mut self) {
        self.history.release_patches();
    }
}
