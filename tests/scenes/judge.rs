//! All oracles on one scene.

use crate::beside::{fields, points};
use crate::draw::Drawn;
use crate::forces::{balance, moved_as_one, other_order, overlap, slope};
use crate::scene::table::exactly;
use fmc_contact::{Contact, ContactForces, EnergyLaw};

/// k in the scene's unit, so that a pressure of 1 is that of one size.
pub(crate) fn stiffness<const D: usize>(drawn: &Drawn<D>) -> f64 {
    1.0 / drawn.size
}

/// The answer of the default law.
pub(crate) struct Answer<'a, const D: usize> {
    pub(crate) drawn: &'a Drawn<D>,
    pub(crate) contact: &'a Contact<D>,
    pub(crate) forces: &'a ContactForces<D>,
    /// Σ|F|.
    pub(crate) size: f64,
    /// What rounded coordinates do to a force: the pressure of so small a depth on all of a block.
    pub(crate) rounding: f64,
}

/// What must hold, or what does not.
type Oracle<const D: usize> = fn(&Answer<D>) -> Result<(), String>;

pub(crate) fn judge<const D: usize>(drawn: &Drawn<D>) -> Vec<String> {
    let contact = drawn.scene.contact(exactly(EnergyLaw::depth(stiffness(drawn))));
    let forces = match contact.evaluate(&drawn.coords) {
        Ok(forces) => forces,
        Err(error) => return vec![format!("refused: {error}")],
    };
    let answer = Answer {
        drawn,
        contact: &contact,
        forces: &forces,
        size: crate::scene::size_sum(&forces.forces),
        rounding: drawn.rounding * drawn.size.powi(D as i32 - 1),
    };
    let mut defects = Vec::new();
    let oracles: [(&str, Oracle<D>); 7] = [
        ("balance", balance),
        ("overlap", overlap),
        ("slope", slope),
        ("order of bodies", other_order),
        ("moved as one", moved_as_one),
        ("fields", fields),
        ("points", points),
    ];
    for (name, oracle) in oracles {
        if let Err(said) = oracle(&answer) {
            defects.push(format!("{name}: {said}"));
        }
    }
    defects
}
