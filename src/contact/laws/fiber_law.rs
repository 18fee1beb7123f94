//! w = Σ measure · ψ(L) over contact points, L being the penetration: a traction ψ'(L) that varies over the patch.

use super::momentum_correction::balance;
use super::pair_energy::PairEnergy;
use super::pair_law::{Answer, Asked, Measured, PairLaw};
use super::penetration_law::PenetrationLaw;
use super::pressure_point::of_contact_points;
use crate::Error;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::overlap::normal_lines::estimate as normal_lines;
use crate::overlap::volume::estimate as volume;
use crate::overlap::{ContactPoints, Overlap};

/// The fiber law, and any local law of the penetration.
pub(super) struct FiberLaw(pub(super) PenetrationLaw);

impl FiberLaw {
    fn energy_of<const D: usize>(
        &self,
        points: &ContactPoints<D>,
        measured: &Measured<D>,
    ) -> Result<PairEnergy<D>, Error> {
        let expected = normal_lines::imbalance(measured.estimator, measured.pair);
        let mut energy = PairEnergy::of_points(points, measured.pair, &self.0, expected);
        // Lines of several directions pass through the same places: together they measure more than there is.
        if points.patches.directions.len() > 1
            && let Some(once) = volume::overlap(measured.estimator, measured.pair)?
        {
            let overlap = &mut energy.overlap;
            (overlap.volume, overlap.standard_error) = (once.volume, once.standard_error);
            overlap.contact_area = once.contact_area;
        }
        Ok(energy)
    }
}

impl<const D: usize> PairLaw<D> for FiberLaw {
    fn measure(&self, measured: &Measured<D>, asked: &Asked) -> Result<Option<Answer<D>>, Error> {
        let (pair, law) = (measured.pair, &self.0);
        // What the derivative asks for beside the points does not change them.
        let derivative = !matches!(asked.tangent, None | Some(TangentPart::Semidefinite));
        let Some(points) = measured.contact_points(derivative)? else { return Ok(None) };
        let pressure = |penetration: f64| law.energy_gradient(penetration);
        Ok(Some(Answer {
            energy: asked.energy.then(|| self.energy_of(&points, measured)).transpose()?,
            tangent: (asked.tangent).map(|part| Tangent::of_points(&points, pair, law, part, measured.obstacle_node())),
            nodal_sums: asked
                .nodal_sums
                .then(|| points.nodal_sums(pair, &pressure, measured.estimator.lines_for(pair).is_none())),
            points: if asked.points || asked.slides {
                of_contact_points(&points, pair, pressure, |penetration| law.energy_hessian(penetration))
            } else {
                Vec::new()
            },
        }))
    }

    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        let points = measured.contact_points(false)?;
        let mut overlap = points.map(|points| points.overlap(measured.pair)).filter(Overlap::has_content);
        // Overlaps are corrected as those of the volume law are.
        if let (Some(o), Some(expected)) = (&mut overlap, volume::imbalance(measured.estimator, measured.pair)) {
            balance(o, measured.pair, expected);
        }
        Ok(overlap)
    }

    fn is_local(&self) -> bool {
        true
    }

    fn pressure(&self, penetration: f64) -> Option<f64> {
        Some(self.0.energy_gradient(penetration))
    }

    fn initial_stiffness(&self) -> Option<f64> {
        Some(self.0.energy_hessian(0.0))
    }
}
