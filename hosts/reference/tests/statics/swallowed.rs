//! A body that starts wholly inside another one.

use crate::scene::{exact, solved};
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::rectangle_quad4;
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use fmc_solid::statics::Problem;

/// A square of a fifth of a block's width, its top 0.05 below the block's: it is pushed out of the nearest side and comes to rest
/// there under a dead load. Guided along x by its middle nodes, as nothing else would hold it on a plane without friction.
#[test]
fn a_swallowed_body_comes_out() {
    for law in [Law::LinearElastic, Law::NeoHookean] {
        let material = Material { law, young: 200.0, poisson: 0.3, density: 1.0 };
        let part = |name: &str, mesh| Part { name: name.into(), cell_type: CellType::Quad4, mesh, material };
        let block = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [10, 10]);
        let square = rectangle_quad4([0.4, -0.25], [0.6, -0.05], [4, 4]);
        let model = Model::new(vec![part("block", block), part("square", square)]).unwrap();
        let mut supports = Constraints::default();
        supports.fix(model.nodes_where(0, |x| x[1] < -1.0 + 1e-9));
        supports.prescribe(model.nodes_where(1, |x| (x[0] - 0.5).abs() < 1e-9), 0, 0.0);
        let load = model.body_load(1, [0.0, -1.0]);
        let problem = Problem { supports, load, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) };
        let (at, _) = solved(problem);
        println!("{law:?}: {} ({}) iterations, {} halvings", at.iterations, at.contact_iterations, at.halvings);
        // Its weight of 0.04 rests on the block, on a side that was 0.25 deep.
        let contact = &at.balance().contact;
        assert!((contact.bodies[1].force[1] / 0.04 - 1.0).abs() < 1e-8, "{}", contact.bodies[1].force[1]);
        let lowest = at.coords()[121..].iter().map(|x| x[1]).fold(f64::INFINITY, f64::min);
        assert!(lowest > -1e-3, "{lowest}");
        assert!(at.iterations <= 20 && at.halvings == 0, "{} iterations, {} halvings", at.iterations, at.halvings);
    }
}
