//! w = Σ measure · ψ(L) over contact points, L being the penetration: a traction ψ'(L) that varies over the patch.

use super::energy_law::EnergyLaw;
use super::pair_energy::PairEnergy;
use super::pair_law::{EnergyAndSums, EnergyAndTangent, Measured, PairLaw};
use crate::Error;
use crate::contact::momentum_correction::balance;
use crate::contact::tangent::{Tangent, TangentPart};
use crate::overlap::{ContactPoints, Overlap};

/// The fiber law, and any local law of the penetration.
pub(super) struct FiberLaw(pub(super) EnergyLaw);

impl FiberLaw {
    fn energy_of<const D: usize>(
        &self,
        points: &ContactPoints<D>,
        measured: &Measured<D>,
    ) -> Result<PairEnergy<D>, Error> {
        let expected = measured.estimator.imbalance_of_points(measured.pair);
        let mut energy = PairEnergy::of_points(points, measured.pair, &self.0, expected);
        // Lines of several directions pass through the same places: together they measure more than there is.
        if points.patches.directions.len() > 1
            && let Some(once) = measured.estimator.overlap(measured.pair)?
        {
            let overlap = &mut energy.overlap;
            (overlap.volume, overlap.standard_error) = (once.volume, once.standard_error);
            overlap.contact_area = once.contact_area;
        }
        Ok(energy)
    }
}

impl<const D: usize> PairLaw<D> for FiberLaw {
    fn energy(&self, measured: &Measured<D>) -> Result<Option<PairEnergy<D>>, Error> {
        measured.contact_points(false)?.map(|points| self.energy_of(&points, measured)).transpose()
    }

    fn tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<Option<Tangent<D>>, Error> {
        let points = measured.contact_points(part == TangentPart::Full)?;
        Ok(points.map(|points| Tangent::of_points(&points, measured.pair, &self.0, part, obstacle_node)))
    }

    fn energy_and_tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<EnergyAndTangent<D>, Error> {
        // What the derivative asks for beside the points does not change them.
        let Some(points) = measured.contact_points(part == TangentPart::Full)? else { return Ok((None, None)) };
        let tangent = Tangent::of_points(&points, measured.pair, &self.0, part, obstacle_node);
        Ok((Some(self.energy_of(&points, measured)?), Some(tangent)))
    }

    fn energy_and_nodal_sums(&self, measured: &Measured<D>) -> Result<Option<EnergyAndSums<D>>, Error> {
        let pressure = |penetration: f64| self.0.energy_gradient(penetration);
        let Some(points) = measured.contact_points(false)? else { return Ok(None) };
        let sums = points.nodal_sums(measured.pair, &pressure);
        Ok(Some((self.energy_of(&points, measured)?, Some(sums))))
    }

    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        let points = measured.contact_points(false)?;
        let mut overlap = points.map(|points| points.overlap(measured.pair)).filter(Overlap::has_content);
        // Overlaps are corrected as those of the volume law are.
        if let (Some(o), Some(expected)) = (&mut overlap, measured.estimator.imbalance_of_volume(measured.pair)) {
            balance(o, measured.pair, expected);
        }
        Ok(overlap)
    }

    fn is_local(&self) -> bool {
        true
    }

    fn pressure_at(&self, penetration: f64) -> f64 {
        self.0.energy_gradient(penetration)
    }
}
