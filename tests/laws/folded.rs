//! Bodies folded over their own sides, as linear elasticity leaves them at a sharp tip.

use crate::scene::Scene;
use fmc_contact::{EnergyLaw, Estimator, FiberOptions, Options, Resolution};
use fmc_shapes::{Diagonals, rectangle_quad4, rectangle_tri3};

/// A node of the left side is pushed out through the top: beside it the body is turned inside out, and lies in the other
/// body as minus once. Lines that leave it there have not been inside before, however far they have come.
#[test]
fn what_lies_there_minus_once_is_not_inside() {
    for place in [[0.02, 1.1], [0.0, 1.1], [-0.02, 1.1], [0.0, 1.004]] {
        let lower = rectangle_tri3([0.0, 0.0], [1.0, 1.0], [4, 4], Diagonals::Alternating);
        let upper = rectangle_quad4([-0.5, 0.99], [1.5, 3.0], [5, 2]);
        let scene = Scene::of(&[&lower, &upper]);
        let mut coords = scene.coords.clone();
        let node = coords.iter().position(|x| (x[0], x[1]) == (0.0, 0.75)).unwrap();
        coords[node] = place;
        let fibers =
            FiberOptions { resolution: Resolution::Spacing(1e-5), momentum_correction: false, ..Default::default() };
        let [exact, lines] = [Estimator::Exact, Estimator::Fibers(fibers)].map(|estimator| {
            let options = Options { estimator, check_cells: false, ..Options::new(EnergyLaw::fiber(1.0)) };
            scene.contact(options).evaluate(&coords).unwrap()
        });
        // The step of the sampling beside the widths of some hundredths that lines see.
        assert!((exact.energy / lines.energy - 1.0).abs() < 2e-3, "{place:?}: {} {}", exact.energy, lines.energy);
    }
}
