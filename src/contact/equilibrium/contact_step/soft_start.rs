//! Contact that is soft first: equilibria on growing stiffness, each from the one before.

use super::bodies::Checked;
use super::iterate::Iterate;
use super::newton::{Search, direction, newton, wish};
use super::options::ContactStepOptions;
use super::touching::{Touch, Touching};
use crate::Error;
use crate::contact::equilibrium::descent::TangentChoice;
use crate::contact::tangents::TangentPart;
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

    fn dof(&self, place: usize) -> usize {
        self.contact.dof(place)
    }

    fn node(&self, place: usize) -> usize {
        self.contact.node(place)
    }

    fn start(&self, place: usize) -> f64 {
        self.contact.start(place)
    }
}

/// Where Newton's method begins with the contact as it is: where its first step leads if that can be taken whole, else where
/// equilibria on softer contacts have led, one after the other. None of these is an equilibrium of the contact as it is: where one
/// is not found, the next begins where it has led.
pub(super) fn settle(
    bodies: &Checked,
    contact: &mut dyn Touching,
    options: &ContactStepOptions,
    has_energy: bool,
    search: &mut Search,
    start: Iterate,
) -> Result<Iterate, Error> {
    let (goal, scale) = bodies.goal(options, &start.touch.forces);
    if start.norm() <= goal || start.touch.outside(goal) > 0 {
        return Ok(start);
    }
    let wish = wish(&TangentChoice::default(), options, &start, scale, has_energy);
    let (direction, tangent, _) = direction(bodies, contact, search, &start, wish, has_energy)?;
    let once = ContactStepOptions { max_trials: 1, ..*options };
    search.iterations += 1;
    search.evaluations += 1;
    if let Some(next) = start.after(bodies, contact, &direction, &once, has_energy)?.0 {
        return Ok(next);
    }
    let ahead = stiffness_ahead(contact, options, &start, &direction)?;
    let mut part =
        ahead.iter().chain([&tangent]).map(|tangent| bearable(&bodies.symmetric, tangent)).fold(1.0, f64::min);
    // The next one begins there, and needs no more digits.
    let rough = ContactStepOptions { tolerance: options.tolerance.max(options.full_below), ..*options };
    let mut reached = start.displacement;
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
    search.evaluations += 1;
    Iterate::new(bodies, contact, reached)
}

/// Stiffness of the contact where a step leads: what begins to touch does so on the way. If cells are inside out there, it is
/// that of half of the step, and so on.
fn stiffness_ahead(
    contact: &mut dyn Touching,
    options: &ContactStepOptions,
    start: &Iterate,
    direction: &DVector<f64>,
) -> Result<Option<DMatrix<f64>>, Error> {
    let mut length = 1.0;
    for _ in 0..options.max_trials {
        match contact.tangent(&(&start.displacement + direction * length), TangentPart::Semidefinite) {
            Ok(tangent) => return Ok(Some(tangent)),
            Err(Error::InvertedCell { .. } | Error::FoldedCell { .. }) => length *= 0.5,
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// Part of the contact's stiffness that is nowhere more than the bodies' own.
fn bearable(bodies: &DMatrix<f64>, contact: &DMatrix<f64>) -> f64 {
    let parts = (0..bodies.nrows()).map(|place| (bodies[(place, place)], contact[(place, place)]));
    parts.filter(|(own, touch)| *own > 0.0 && *touch > 0.0).map(|(own, touch)| own / touch).fold(1.0, f64::min)
}
