//! Patches of the law `fiber` that follow the contact while it is far from its equilibrium, and are those of its end.

use super::state::State;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::results::ContactForces;
use crate::overlap::Partner;

/// Residual by the forces above which patches follow the contact.
const FAR: f64 = 0.1;

/// Which patches are kept, from state to state.
#[derive(Default)]
pub(crate) struct Patches {
    /// Pairs and area of the contact for which they were found.
    kept: Option<(Vec<[Partner; 2]>, f64)>,
    has_turned: bool,
}

impl Patches {
    /// What is prescribed moves: patches begin anew.
    pub(crate) fn begin(&mut self) {
        *self = Self::default();
    }

    /// Whether patches were found anew here. Lines run along the contact normal of the start. Once the solution is near, they turn into
    /// that of now. Far from it they follow the contact where it has begun or spread.
    pub(crate) async fn found<const D: usize>(
        &mut self,
        host: &Host<D>,
        state: &State<D>,
        relative: f64,
    ) -> Result<bool, Trouble> {
        let is_near = relative <= FAR;
        let stays = match &self.kept {
            None => false,
            Some(_) if is_near => self.has_turned,
            Some(kept) => !outgrows(&state.contact, kept),
        };
        if stays {
            return Ok(false);
        }
        self.has_turned |= is_near;
        let coords = host.unknowns.coords(&state.x);
        host.contact(move |contact| contact.keep_patches(&coords)).await?;
        self.kept = Some((pairs(&state.contact), state.contact.contact_area));
        Ok(true)
    }
}

fn pairs<const D: usize>(contact: &ContactForces<D>) -> Vec<[Partner; 2]> {
    contact.pairs.iter().map(|pair| [pair.a, pair.b]).collect()
}

/// Whether there is a new pair, or the area of contact has changed by more than half.
fn outgrows<const D: usize>(contact: &ContactForces<D>, (known, area): &(Vec<[Partner; 2]>, f64)) -> bool {
    let is_new = pairs(contact).iter().any(|pair| !known.contains(pair));
    is_new || contact.contact_area < 0.5 * area || contact.contact_area > 2.0 * area
}
