//! Evaluations in one call, without anything that is kept.

use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::friction::FacetSlip;
use crate::contact::method::Options;
use crate::contact::results::ContactForces;
use crate::geometry::{Bodies, CellBlock, Surface};

/// Contact forces between the bodies of a mesh, in one call.
///
/// # Errors
/// Those of [`Surface::from_cells`], [`Contact::new`] and [`Contact::evaluate`]; with friction [`Error::NoStep`], as that takes
/// [`contact_force_step`].
///
/// ```
/// use fmc_contact::{Bodies, CellBlock, CellType, EnergyLaw, Options, contact_force};
/// // Two unit squares, the second 0.1 deep in the first.
/// let coords = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.9], [1., 0.9], [1., 1.9], [0., 1.9]];
/// let blocks = [CellBlock { cell_type: CellType::Quad4, conn: &[0, 1, 2, 3, 4, 5, 6, 7] }];
/// let options = Options::new(EnergyLaw::volume(1000.0));
/// let contact = contact_force(&coords, &blocks, Bodies::Connected, &options)?;
/// assert!((contact.volume - 0.1).abs() < 0.01);
/// assert!(contact.bodies[1].force[1] > 0.0); // the upper square is pushed up
/// # Ok::<(), fmc_contact::Error>(())
/// ```
pub fn contact_force<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[CellBlock],
    bodies: Bodies,
    options: &Options,
) -> Result<ContactForces<D>, Error> {
    Contact::new(Surface::from_cells(coords, blocks, bodies)?, *options)?.evaluate(coords)
}

/// A step with friction, for [`contact_force_step`].
#[derive(Clone, Copy, Debug)]
pub struct FrictionStep<'a, const D: usize> {
    /// Coordinates without deformation, from which the law `depth` has its depths.
    pub reference: &'a [[f64; D]],
    /// Coordinates at which the step began.
    pub start: &'a [[f64; D]],
    /// Elastic slip that was carried into it.
    pub slip: &'a [FacetSlip<D>],
}

/// Contact forces with friction at the end of a step, in one call, and the elastic slip that is carried into the next: the
/// bits of a contact that goes through [`Contact::begin_step`], [`Contact::set_slip`], [`Contact::evaluate`] and
/// [`Contact::commit_step`].
///
/// # Errors
/// Those of [`contact_force`], [`Contact::set_slip`] and [`Contact::commit_step`].
pub fn contact_force_step<const D: usize>(
    step: FrictionStep<D>,
    coords: &[[f64; D]],
    blocks: &[CellBlock],
    bodies: Bodies,
    options: &Options,
) -> Result<(ContactForces<D>, Vec<FacetSlip<D>>), Error> {
    let mut contact = Contact::new(Surface::from_cells(step.reference, blocks, bodies)?, *options)?;
    contact.begin_step(step.start)?;
    contact.set_slip(step.slip)?;
    let forces = contact.evaluate(coords)?;
    contact.commit_step(coords)?;
    Ok((forces, contact.slip()?))
}
