//! Cohesive interfaces that break in a load step.

use super::host::Host;
use super::trouble::Trouble;
use crate::contact::cohesive::Breaking;

/// Those whose damage at x is more than when the step began.
pub(super) async fn breaking<const D: usize>(host: &Host<D>, x: &[f64]) -> Result<Vec<Breaking>, Trouble> {
    let coords = host.unknowns.coords(x);
    Ok(host.contact(move |contact| contact.breaking(&coords)).await?)
}
