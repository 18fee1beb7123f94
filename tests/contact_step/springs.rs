//! A unit square on springs, pressed on a rigid plane: the law is a spring, too.

use fmc_contact::contact::{CondensedBodies, ContactStep, ContactStepOptions, ContactStepState};
use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, EnergyLaw, EnergyProfile, Obstacle, Options, PenetrationLaw, Pose, Shape,
    Surface,
};

pub(crate) const SPRING: f64 = 100.0;
pub(crate) const K: f64 = 3000.0;

/// Nodes 0 and 1 below, and a plane whose outside is above height 0.
pub(crate) fn square(height: f64) -> (Vec<[f64; 2]>, Contact<2>) {
    let coords = vec![[0.0, height], [1.0, height], [1.0, 1.0 + height], [0.0, 1.0 + height]];
    let block = CellBlock { cell_type: CellType::Quad4, conn: &[0, 1, 2, 3] };
    let surface = Surface::from_cells(&coords, &[block], Bodies::Connected).unwrap();
    let law = EnergyLaw::Fiber(PenetrationLaw { stiffness: K, profile: EnergyProfile::Quadratic });
    let mut contact = Contact::new(surface, Options::new(law)).unwrap();
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::default() }).unwrap();
    (coords, contact)
}

/// The whole square on four springs, of which the lower two nodes are the list; the others follow or stay.
pub(crate) fn step(height: f64, push: f64, options: &ContactStepOptions) -> ContactStep {
    let (coords, contact) = square(height);
    step_of(&contact, &coords, push, options)
}

/// The same with a contact that has a past.
pub(crate) fn step_of(
    contact: &Contact<2>,
    coords: &[[f64; 2]],
    push: f64,
    options: &ContactStepOptions,
) -> ContactStep {
    // Sideways, and up and down, of both nodes.
    let mut stiffness = [0.0; 16];
    (0..4).for_each(|k| stiffness[5 * k] = SPRING);
    let residual = [0.0, push, 0.0, push];
    let bodies = CondensedBodies { dofs: &[0, 1, 2, 3], held: &[], stiffness: &stiffness, residual: &residual };
    let mut follow = |d: &[f64], coords: &mut [[f64; 2]]| {
        (coords[3][1], coords[2][1]) = (coords[3][1] + d[1], coords[2][1] + d[3]);
        Ok(())
    };
    contact.contact_step(coords, &bodies, options, Some(&mut follow)).unwrap()
}

/// 2 SPRING d + 2 push = K · penetration, where it touches: the force is K times what is below the plane.
#[test]
fn two_springs_against_a_plane_are_springs_in_series() {
    for (height, push) in [(0.0, 3.0), (0.1, 20.0), (-0.05, 0.0), (-0.4, 10.0)] {
        let found = step(height, push, &ContactStepOptions::default());
        // 2 (SPRING d + push) = −K (height + d)
        let down = -(2.0 * push + K * height) / (2.0 * SPRING + K);
        assert_eq!(found.state, ContactStepState::Converged);
        assert!(found.residual <= 1e-10 * found.scale && found.iterations <= 10, "{found:?}");
        for (place, expected) in [0.0, down, 0.0, down].into_iter().enumerate() {
            assert!((found.displacement[place] - expected).abs() < 1e-10, "{height}, {push}: {found:?}, {down}");
        }
    }
}

#[test]
fn a_body_that_comes_off_the_plane_is_held_by_its_springs() {
    let found = step(-0.01, -20.0, &ContactStepOptions::default());
    assert_eq!(found.state, ContactStepState::Converged);
    assert!((found.displacement[1] - 20.0 / SPRING).abs() < 1e-12, "{found:?}");
}

#[test]
fn what_is_given_up_on_says_so() {
    let few = ContactStepOptions { max_iterations: 1, ..Default::default() };
    let found = step(0.1, 20.0, &few);
    assert_eq!((found.state, found.iterations), (ContactStepState::NotConverged, 1));
    assert!(
        found.residual > 1e-3 * found.scale && found.residual < found.residual_at_start.max(20.0 * 2.0),
        "{found:?}"
    );
    let loose = ContactStepOptions { absolute_tolerance: 1e3, ..few };
    let found = step(0.1, 20.0, &loose);
    assert_eq!((found.state, found.iterations), (ContactStepState::Converged, 0));
}

/// A degree of freedom that is missing from the list, and one that is held.
#[test]
fn contact_outside_the_list_is_told() {
    let (coords, contact) = square(-0.05);
    let stiffness = [SPRING];
    let bodies = CondensedBodies { dofs: &[1], held: &[], stiffness: &stiffness, residual: &[0.0] };
    let options = ContactStepOptions::default();
    let found = contact.contact_step(&coords, &bodies, &options, None).unwrap();
    assert_eq!(
        (found.state, found.outside, found.displacement[0]),
        (ContactStepState::Outside, 1, 0.0),
        "the plane presses on both lower nodes"
    );
    let bodies = CondensedBodies { held: &[0, 2, 3, 4, 5, 6, 7], ..bodies };
    let found = contact.contact_step(&coords, &bodies, &options, None).unwrap();
    assert_eq!((found.state, found.outside), (ContactStepState::Converged, 0));
}

#[test]
fn an_empty_list_is_in_equilibrium_where_nothing_touches() {
    let bodies = CondensedBodies { dofs: &[], held: &[], stiffness: &[], residual: &[] };
    for (height, state) in [(0.1, ContactStepState::Converged), (-0.1, ContactStepState::Outside)] {
        let (coords, contact) = square(height);
        let found = contact.contact_step(&coords, &bodies, &ContactStepOptions::default(), None).unwrap();
        assert_eq!((found.state, found.iterations), (state, 0));
    }
}
