//! Contact that is soft first: equilibria on growing stiffness, each from the one before.

use super::bodies::Checked;
use super::iterate::Iterate;
use super::options::ContactStepOptions;
use super::solve::{Search, newton};
use super::touching::{Touch, Touching};
use crate::Error;
use crate::contact::tangent::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Factor from one stiffness to the next.
const STRIDE: f64 = 10.0;

/// A contact of which energy, forces and tangent are a part of another's.
struct Softened<'a> {
    contact: &'a mut dyn Touching,
    part: f64,
}

impl Touching for Softened<'_> {
    fn at(&mut self, displacement: &DVector<f64>) -> Result<Touch, Error> {
        let mut touch = self.contact.at(displacement)?;
        touch.energy *= self.part;
        touch.forces *= self.part;
        touch.outside.iter_mut().for_each(|force| *force *= self.part);
        Ok(touch)
    }

    fn tangent(&mut self, displacement: &DVector<f64>, part: TangentPart) -> Result<DMatrix<f64>, Error> {
        Ok(self.contact.tangent(displacement, part)? * self.part)
    }

    fn freedom(&self, place: usize) -> usize {
        self.contact.freedom(place)
    }

    fn start(&self, place: usize) -> f64 {
        self.contact.start(place)
    }
}

/// Equilibria on softer contacts, one after the other, where the start is far from equilibrium and touches with more stiffness
/// than the bodies have. None of them is an equilibrium of the contact as it is: where one is not found, the next begins where
/// it has led. The displacement of the last is returned.
pub(super) fn settle(
    bodies: &Checked,
    contact: &mut dyn Touching,
    options: &ContactStepOptions,
    has_energy: bool,
    search: &mut Search,
    start: &Iterate,
) -> Result<Option<DVector<f64>>, Error> {
    let (_, scale) = bodies.goal(options, &start.touch.forces);
    if start.norm() <= options.full_below * scale {
        return Ok(None);
    }
    let tangent = contact.tangent(&start.displacement, TangentPart::Semidefinite)?;
    let mut part = bearable(&bodies.symmetric, &tangent);
    if part >= 1.0 {
        return Ok(None);
    }
    // The next one begins there, and needs no more digits.
    let rough = ContactStepOptions { tolerance: options.tolerance.max(options.full_below), ..*options };
    let mut reached = start.displacement.clone();
    while part < 1.0 {
        let mut softened = Softened { contact, part };
        let at = Iterate::new(bodies, &mut softened, reached)?;
        search.evaluations += 1;
        let displacement = at.displacement.clone();
        reached = match newton(bodies, &mut softened, &rough, has_energy, search, at) {
            Ok((at, _)) => at.displacement,
            // Bodies that give way are held by a stiffer contact, if at all.
            Err(Error::SingularStiffness { .. } | Error::IndefiniteStiffness { .. }) => displacement,
            Err(error) => return Err(error),
        };
        part *= STRIDE;
    }
    Ok(Some(reached))
}

/// Part of the contact's stiffness that is nowhere more than the bodies' own.
fn bearable(bodies: &DMatrix<f64>, contact: &DMatrix<f64>) -> f64 {
    let parts = (0..bodies.nrows()).map(|place| (bodies[(place, place)], contact[(place, place)]));
    parts.filter(|(own, touch)| *own > 0.0 && *touch > 0.0).map(|(own, touch)| own / touch).fold(1.0, f64::min)
}
