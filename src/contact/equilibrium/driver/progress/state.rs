//! Bodies and contact at a displacement, and how nearly they balance.

use crate::Error;
use crate::contact::equilibrium::descent::Descent;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, largest, norm};
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::results::ContactForces;

/// Units of rounding that a sum over the cells around a node may lose.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Bodies and contact.
pub(crate) struct State<const D: usize> {
    pub(crate) x: Vec<f64>,
    /// Internal less external forces.
    pub(crate) inside: Vec<f64>,
    /// Strain energy less the work of loads, where the host knows it.
    pub(crate) energy: Option<f64>,
    /// Contact forces on the unknowns.
    pub(crate) forces: Vec<f64>,
    pub(crate) contact: ContactForces<D>,
    /// `inside` less `forces`.
    pub(crate) residual: Vec<f64>,
}

/// What rounding may leave of a residual, row by row.
pub(crate) struct Rounding {
    /// Of displacements as they are.
    pub(crate) of_state: Vec<f64>,
    /// Of a host that finds strains from coordinates: larger, and never counted without need.
    pub(crate) of_coordinates: Vec<f64>,
}

impl<const D: usize> State<D> {
    /// With `matrix` the host has the bodies' matrix of this place from now on.
    pub(crate) async fn at(host: &Host<D>, x: Vec<f64>, matrix: bool) -> Result<Self, Trouble> {
        let (inside, energy) = host.forces(&x, matrix).await?;
        Self::balanced(host, x, (inside, energy), Contact::evaluate).await
    }

    /// The same while surfaces count as apart.
    pub(crate) async fn apart(host: &Host<D>, x: Vec<f64>) -> Result<Self, Trouble> {
        let inside = host.forces(&x, true).await?;
        Self::balanced(host, x, inside, kernels::evaluate_apart).await
    }

    /// The same place where the contact has become another.
    pub(crate) async fn again(self, host: &Host<D>) -> Result<Self, Trouble> {
        Self::balanced(host, self.x, (self.inside, self.energy), Contact::evaluate).await
    }

    async fn balanced(
        host: &Host<D>,
        x: Vec<f64>,
        (inside, energy): (Vec<f64>, Option<f64>),
        evaluate: fn(&Contact<D>, &[[f64; D]]) -> Result<ContactForces<D>, Error>,
    ) -> Result<Self, Trouble> {
        if let Some(unknown) = inside.iter().position(|force| !force.is_finite()) {
            return Err(Trouble::Host(format!("the residual is not finite: the force at unknown {unknown}")));
        }
        let coords = host.unknowns.coords(&x);
        let contact = host.contact(move |contact| evaluate(contact, &coords)).await?;
        let forces = host.unknowns.gather(&contact.forces);
        let residual = inside.iter().zip(&forces).map(|(inside, force)| inside - force).collect();
        Ok(Self { x, inside, energy, forces, contact, residual })
    }

    /// Norm of the residual at the free unknowns.
    pub(crate) fn norm(&self, host: &Host<D>) -> f64 {
        host.unknowns.free_norm(&self.residual)
    }

    /// Energy of the contact; what frozen friction stores and takes out is its potential.
    fn contact_energy(&self) -> f64 {
        self.contact.energy + self.contact.friction.stored + self.contact.friction.dissipated
    }

    /// This state and another, as the rules of descent see them. Without an energy of the host its forces' work along the way, by the
    /// trapezoidal rule: exact for linear bodies.
    pub(crate) fn descents(&self, host: &Host<D>, other: &Self, step: &[f64]) -> (Descent, Descent) {
        let (bodies, size) = match (self.energy, other.energy) {
            (Some(here), Some(there)) => (there - here, here.abs()),
            _ => (0.5 * (dot(&self.inside, step) + dot(&other.inside, step)), 0.0),
        };
        let (before, after) = (self.contact_energy(), other.contact_energy());
        let work = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a * b).abs()).sum::<f64>();
        let size = size + before.abs() + after.abs() + work(&other.inside, step);
        let known = work(&other.forces, &other.x);
        let (rounding, flat) = (ROUNDING * (8.0 * size + known), Descent::flatness(size) + ROUNDING * known);
        let at = |energy, norm| Descent { energy, norm, rounding, flat };
        (at(0.0, self.norm(host)), at(bodies + after - before, other.norm(host)))
    }

    /// What rounding may leave of the residual here. `pressed` is the stiffness by area of what presses and pulls, row by row.
    pub(crate) async fn rounding(
        &self,
        host: &Host<D>,
        assembly: &Assembly<D>,
        pressed: &[f64],
    ) -> Result<Rounding, Trouble> {
        let farthest = assembly.position.iter().map(|x| x.amax()).fold(0.0, f64::max) + largest(&self.x);
        let mut touched = vec![0.0; host.unknowns.count];
        for (place, unknown) in host.unknowns.of_coordinate.iter().enumerate() {
            if let Some(unknown) = unknown.filter(|&unknown| self.forces[unknown] != 0.0) {
                touched[unknown] = pressed[place / D] * assembly.area[place / D].abs() * farthest;
            }
        }
        for (&place, weights) in &host.unknowns.weighted {
            let here = pressed[place / D] * assembly.area[place / D].abs() * farthest;
            for &(unknown, weight) in weights.iter().filter(|(unknown, _)| self.forces[*unknown] != 0.0) {
                touched[unknown] = touched[unknown].max(weight.abs() * here);
            }
        }
        let own = host.product(self.x.iter().map(|x| x.abs()).collect(), true).await?;
        let all = host.product(vec![farthest; host.unknowns.count], true).await?;
        let sum = |bodies: &[f64]| -> Vec<f64> {
            bodies.iter().zip(&touched).map(|(bodies, touched)| ROUNDING * (bodies.abs() + touched)).collect()
        };
        Ok(Rounding { of_state: sum(&own), of_coordinates: sum(&all) })
    }

    /// The larger of the norms of both forces, without rows that are made of rounding.
    pub(crate) fn scale(&self, rounding: &[f64]) -> f64 {
        let of = |forces: &[f64]| {
            let counts = forces.iter().zip(rounding).map(|(f, n)| if f.abs() > 8.0 * n { *f } else { 0.0 });
            norm(&counts.collect::<Vec<_>>())
        };
        of(&self.inside).max(of(&self.forces))
    }

    /// Norm of what the residual at free unknowns has beyond rounding, row by row.
    pub(crate) fn beyond(&self, host: &Host<D>, rounding: &[f64]) -> f64 {
        let rest: Vec<f64> = self.residual.iter().zip(rounding).map(|(r, n)| (r.abs() - n).max(0.0)).collect();
        host.unknowns.free_norm(&rest)
    }
}
