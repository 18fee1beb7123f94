//! A free elastic body inside another comes out of it.

use crate::scene::{exact, part, solved};
use fmc_contact::{CellType, EnergyLaw};
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, rectangle_quad4, rectangle_tri3};
use fmc_solid::fem::{Constraints, Model};
use fmc_solid::statics::Problem;

/// The small body, on which nothing acts but the large one around it, lies just outside at the end, as it was. Returns
/// how far its first node has moved.
fn comes_out<const D: usize>((cell_type, large): (CellType, Mesh<D>), small: Mesh<D>) -> [f64; D] {
    let model = Model::new(vec![part("large", cell_type, large), part("small", cell_type, small)]).unwrap();
    let mut supports = Constraints::default();
    supports.fix(model.nodes_where(0, |x| x[D - 1] < -1.0 + 1e-9));
    let (at, log) = solved(Problem { supports, ..Problem::new(model, exact(EnergyLaw::depth(1e4))) });
    println!("{} iterations, {} evaluations of the contact", at.iterations, at.evaluations);
    assert!(at.iterations <= 20 && log.last().unwrap().residual == 0.0);
    // What is left is rounding: the energy began with some 1e3.
    let balance = at.balance();
    assert!(balance.contact_energy < 1e-18 && balance.contact.penetration < 1e-7 && balance.strain < 1e-18);
    let of_large = at.model().nodes_of(0);
    assert!(at.displacement()[of_large.clone()].iter().flatten().all(|u| u.abs() < 1e-10));
    at.displacement()[of_large.end]
}

/// Below one side alone: straight out, over its distance from there.
#[test]
fn through_the_nearest_side() {
    let large = rectangle_tri3([-1.0, -1.0], [1.0, 1.0], [10, 10], Diagonals::Alternating);
    let moved = comes_out((CellType::Tri3, large), rectangle_tri3([-0.2, 0.5], [0.2, 0.9], [2, 2], Diagonals::Same));
    assert!(moved[0].abs() < 1e-6 && (moved[1] - 0.5).abs() < 1e-5, "{moved:?}");
    let large = rectangle_quad4([-1.0, -1.0], [1.0, 1.0], [10, 10]);
    let moved = comes_out((CellType::Quad4, large), rectangle_quad4([0.4, -0.1], [0.8, 0.2], [3, 2]));
    assert!(moved[1].abs() < 1e-6 && (moved[0] - 0.6).abs() < 1e-5, "{moved:?}");
    let large = cuboid_tet4([-1.0; 3], [1.0; 3], [6, 6, 6]);
    let moved = comes_out((CellType::Tet4, large), cuboid_tet4([-0.2, -0.2, 0.5], [0.2, 0.2, 0.9], [1, 1, 1]));
    println!("{moved:?}");
    assert!(moved[2] > 0.4, "{moved:?}");
}

/// Near the middle, where the sides pull against one another and turn the square.
#[test]
fn from_near_the_middle() {
    let large = rectangle_tri3([-1.0, -1.0], [1.0, 1.0], [9, 9], Diagonals::Alternating);
    for place in [[0.13, 0.21], [0.05, 0.02], [-0.3, 0.28]] {
        let small = rectangle_tri3([-0.2, -0.2], [0.2, 0.2], [2, 2], Diagonals::Same).translated(place);
        let moved = comes_out((CellType::Tri3, large.clone()), small);
        println!("{place:?} {moved:?}");
    }
}
