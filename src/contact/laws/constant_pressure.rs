//! A law that only the tests know: constant pressure over the contact area. That it stands in one file, and works with
//! either estimator, shows what a new law needs.

use super::energy_law::EnergyLaw;
use super::pair_energy::PairEnergy;
use super::pair_law::{Answer, Asked, Measured, PairLaw};
use crate::Error;
use crate::overlap::Overlap;

/// w = p Σ measure L.
struct ConstantPressure(f64);

impl<const D: usize> PairLaw<D> for ConstantPressure {
    fn measure(&self, measured: &Measured<D>, asked: &Asked) -> Result<Option<Answer<D>>, Error> {
        if asked.tangent.is_some() {
            return Err(Error::Unsupported { what: "the tangent of a constant pressure" });
        }
        let overlap = PairLaw::<D>::overlap(self, measured)?;
        let energy = overlap.map(|overlap| PairEnergy::of_volume(overlap, &EnergyLaw::volume(self.0)));
        Ok(Some(Answer { energy, tangent: None, nodal_sums: None, points: Vec::new() }))
    }

    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        Ok(measured.contact_points(false)?.map(|points| points.overlap(measured.pair)))
    }

    fn is_local(&self) -> bool {
        true
    }
}

#[test]
fn a_law_of_its_own_works_with_either_estimator() {
    use crate::{Bodies, CellBlock, CellType, Contact, Estimator, FiberOptions, Options, Surface};
    // A unit square 0.1 deep in another: 0.1 is the overlap, and the force the pressure times the width of 1.
    let coords = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.9], [1., 0.9], [1., 1.9], [0., 1.9]];
    let blocks = [CellBlock { cell_type: CellType::Quad4, conn: &[0, 1, 2, 3, 4, 5, 6, 7] }];
    let surface = Surface::from_cells(&coords, &blocks, Bodies::Connected).expect("a valid mesh");
    for (estimator, tolerance) in [(Estimator::Exact, 1e-12), (Estimator::Fibers(FiberOptions::default()), 0.02)] {
        let options = Options { estimator, ..Options::new(EnergyLaw::fiber(1.0)) };
        let mut contact = Contact::new(surface.clone(), options).expect("valid options");
        contact.method.law = Box::new(ConstantPressure(30.0));
        let found = contact.evaluate(&coords).expect("valid coordinates");
        assert!((found.energy - 3.0).abs() < 3.0 * tolerance, "{estimator:?}: {}", found.energy);
        assert!((found.bodies[1].force[1] - 30.0).abs() < 30.0 * tolerance, "{estimator:?}: {:?}", found.bodies);
    }
}
