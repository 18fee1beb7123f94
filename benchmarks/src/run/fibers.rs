//! Fibers of an equilibrium, to look at.

use crate::case::{self, Case, EstimatorName, LawName};
use anyhow::Result;
use fmc_contact::Contact;
use fmc_contact::overlap::FiberTrace;
use fmc_solid::statics::Equilibrium;

/// The fibers that cross an overlap of an equilibrium, with the points at which they enter and leave it.
///
/// They are those of the sampled estimator, laid as the case says, also where the case is measured exactly. None where contact
/// is linearised, where nothing overlaps, and none by the law `depth`, whose forces come from no lines.
///
/// # Errors
/// Those of the contact.
pub fn traces<const D: usize>(case: &Case, at: &Equilibrium<D>) -> Result<Vec<FiberTrace<D>>> {
    let problem = at.problem();
    if problem.linearised.is_some() || case.contact.law == LawName::Depth {
        return Ok(Vec::new());
    }
    let sampled = case::Contact { estimator: EstimatorName::Fibers, ..case.contact.clone() };
    let mut contact = Contact::new(at.model().surface()?, sampled.options(1))?;
    for obstacle in &problem.obstacles {
        contact.add_obstacle(obstacle.clone())?;
    }
    Ok(contact.trace(&at.coords())?)
}
