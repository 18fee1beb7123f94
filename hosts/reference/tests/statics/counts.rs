//! What an equilibrium takes, counted.

use crate::scene::{HALF_WIDTH, exact, hertz, solved};
use fmc_contact::EnergyLaw;
use fmc_solid::fem::Constraints;
use fmc_solid::statics::Problem;

/// Linear bodies that nothing but their supports holds are factorised once, however deep they start and however often the contact
/// is iterated; and of its iterations only those that move what is kept far go through the factors: beside these, one pass to condense, and one
/// to follow at the start and at the end.
#[test]
fn one_factorisation_and_few_passes() {
    let problem = hertz(8.0, exact(EnergyLaw::fiber(2e5)));
    let mut supports = Constraints::default();
    supports.prescribe(problem.model.nodes_where(0, |x| x[0].abs() < 1e-9), 0, 0.0);
    supports.prescribe(problem.model.nodes_where(0, |x| x[1] > 8.0 - 1e-9), 1, -0.1);
    let (at, log) = solved(Problem { supports, load: Vec::new(), ..problem });
    assert!(at.contact_iterations > at.iterations, "{} in {}", at.contact_iterations, at.iterations);
    assert_eq!(at.factorisations(), 1);
    let (passes, solves, inner) = (at.passes(), at.iterations, at.contact_iterations);
    assert!(passes <= 8 && solves <= 3, "{passes} passes in {solves} iterations with {inner} of the contact");
    // The overlap at the start is √(2 R δ) to either side, in facets of the size that eight make half of Hertz' contact, and more
    // than one node deep nowhere; what is kept is no more than that.
    let nodes = 2.0 * (2.0f64 * 8.0 * 0.1).sqrt() / (HALF_WIDTH / 8.0) + 4.0;
    assert!((at.kept_count() as f64) < 2.0 * nodes, "{} for {nodes} nodes", at.kept_count());
    assert!(log.iter().all(|iteration| iteration.length == 1.0 || iteration.tangent.is_none()));
}
