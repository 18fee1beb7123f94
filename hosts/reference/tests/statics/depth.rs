//! The depth law, which stands on a soft contact first.

use crate::scene::{exact, solved};
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::rectangle_quad4;
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use fmc_solid::statics::Problem;

/// A block of half the width on another, neo-Hookean, its top pushed down by `pressed` from a start `overlap` deep.
fn blocks(overlap: f64, pressed: f64, law: EnergyLaw) -> Problem<2> {
    let material = Material { law: Law::NeoHookean, young: 200.0, poisson: 0.3, density: 1.0 };
    let part = |name: &str, mesh| Part { name: name.into(), cell_type: CellType::Quad4, mesh, material };
    let lower = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [10, 10]);
    let upper = rectangle_quad4([0.23, -overlap], [0.77, 0.5 - overlap], [7, 6]);
    let model = Model::new(vec![part("lower", lower), part("upper", upper)]).unwrap();
    let mut supports = Constraints::default();
    supports.fix(model.nodes_where(0, |x| x[1] < -1.0 + 1e-9));
    let top = model.nodes_where(1, |x| x[1] > 0.5 - overlap - 1e-9);
    supports.prescribe(top.clone(), 0, 0.0);
    supports.prescribe(top, 1, -pressed);
    Problem { supports, ..Problem::new(model, exact(law)) }
}

fn force(problem: Problem<2>) -> f64 {
    let (at, _) = solved(problem);
    at.balance().contact.bodies[1].force[1]
}

/// Half a cell deep at the start with k = 500 E per metre, where walls would be pushed aside by 6 times E h.
#[test]
fn a_deep_start_is_softened() {
    let [depth, fiber] = [EnergyLaw::depth(1e5), EnergyLaw::fiber(1e5)].map(|law| force(blocks(0.05, 0.0, law)));
    println!("{depth} {fiber}");
    assert!((depth / fiber - 1.0).abs() < 1e-2, "{depth} and {fiber}");
}

#[test]
fn the_law_is_as_it_was_asked_for_in_the_end() {
    let law = EnergyLaw::depth(1e5);
    let (at, log) = solved(blocks(0.0, 0.05, law));
    assert_eq!(at.problem().contact.law, law);
    assert!(log.last().unwrap().residual <= 1e-10);
    // The mean pressure is 500 times the penetration by E, within the rise towards the corners.
    let penetration = at.balance().contact.penetration;
    assert!(penetration > 0.0 && penetration < 5e-3, "{penetration}");
}
