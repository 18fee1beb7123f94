//! Rough faces: many patches of facets that lie inside the other body and hang together with no others.

use crate::scene::{Scene, exact};
use fmc_shapes::{Mesh, cuboid_tet4, rectangle_quad4};

/// Height of teeth of width 1 and height 1 over their tips.
fn tooth(x: f64) -> f64 {
    2.0 * (x - x.floor() - 0.5).abs()
}

/// The lower face pulled into teeth along x, with less and less of it above.
fn with_teeth<const D: usize>(mut mesh: Mesh<D>) -> Mesh<D> {
    for x in &mut mesh.coords {
        let height = tooth(x[0]);
        x[D - 1] += height * (1.0 - x[D - 1] / 4.0);
    }
    mesh
}

/// Teeth with eight edges each, down to 0.6 in a block: V = 6 × 0.6²/2, and the flanks inside are 0.6 √5/2 long.
#[test]
fn teeth_in_a_block() {
    let teeth = with_teeth(rectangle_quad4([0.0, 0.0], [6.0, 4.0], [48, 4]));
    let block = rectangle_quad4([-1.1, -2.0], [7.2, 0.6], [31, 7]);
    for angle in [0.0, 0.3, 1.9] {
        let scene = Scene::of(&[&teeth, &block].map(|m| m.clone().rotated(angle)).each_ref());
        let contact = scene.evaluate(exact());
        assert!((contact.volume - 6.0 * 0.18).abs() < 1e-12, "{}", contact.volume);
        let boundary = 6.0 * (2.0 * 0.3 * 5f64.sqrt() + 0.6);
        assert!((contact.contact_area - 0.5 * boundary).abs() < 1e-12, "{}", contact.contact_area);
        assert!((contact.penetration - 0.6).abs() < 1e-12, "{}", contact.penetration);
    }
}

/// The same in 3D, from y = 0 to 3, beside a block without cells, which covers y from 1 to 5.
#[test]
fn ridges_in_a_block() {
    let ridges = with_teeth(cuboid_tet4([0.0; 3], [6.0, 3.0, 4.0], [48, 5, 4]));
    let block = cuboid_tet4([-1.1, 1.0, -2.0], [7.2, 5.0, 0.6], [7, 4, 3]);
    for angle in [0.0, 0.7] {
        let put = |m: &Mesh<3>| m.clone().rotated([1.0, 2.0, 3.0], angle);
        let of_cells = Scene::of(&[&put(&ridges), &put(&block)]);
        let of_facets = Scene::of(&[&put(&ridges.boundary()), &put(&block.boundary())]);
        for scene in [of_cells, of_facets] {
            let contact = scene.evaluate(exact());
            assert!((contact.volume - 12.0 * 0.18).abs() < 1e-11, "{}", contact.volume);
            let boundary = 12.0 * (2.0 * 0.3 * 5f64.sqrt() + 0.6) + 2.0 * 6.0 * 0.18;
            assert!((contact.contact_area - 0.5 * boundary).abs() < 1e-11, "{}", contact.contact_area);
        }
    }
}
