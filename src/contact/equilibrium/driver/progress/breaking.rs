//! Cohesive interfaces that break in a load step.

use crate::contact::cohesive::Breaking;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;

/// Those whose damage at x is more than when the step began.
pub(crate) async fn breaking<const D: usize>(host: &Host<D>, x: &[f64]) -> Result<Vec<Breaking>, Trouble> {
    let coords = host.unknowns.coords(x);
    Ok(host.contact(move |contact| contact.breaking(&coords)).await?)
}
