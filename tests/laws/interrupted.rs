//! A call that is ended leaves a contact as it was.

use crate::scene::table::laws;
use crate::scene::{Scene, by_lines};
use fmc_contact::{Error, Options};
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

/// Asked at once, a call ends before its first pair is measured; asked no more, it gives the same bits as if nothing had been.
fn check<const D: usize>(scene: &Scene<D>) {
    for options in laws(1e3).into_iter().flat_map(|law| [Options::new(law), by_lines(law)]) {
        let fresh = scene.contact(options).evaluate(&scene.coords);
        for threads in [1, 3] {
            let mut contact = scene.contact(Options { threads, ..options });
            contact.set_interrupt(Some(Box::new(|| true)));
            assert_eq!(contact.evaluate(&scene.coords), Err(Error::Interrupted), "{options:?}, {threads} threads");
            contact.set_interrupt(Some(Box::new(|| false)));
            assert_eq!(contact.evaluate(&scene.coords), fresh, "{options:?}, {threads} threads");
            contact.set_interrupt(None);
            assert_eq!(contact.evaluate(&scene.coords), fresh, "{options:?}, {threads} threads");
        }
    }
}

#[test]
fn a_call_that_is_ended_leaves_no_trace() {
    check(&Scene::of(&[
        &rectangle_quad4([0.0; 2], [1.0; 2], [3, 3]),
        &rectangle_quad4([0.3, 0.9], [1.2, 1.5], [2, 2]),
    ]));
    check(&Scene::of(&[
        &cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]),
        &cuboid_hex8([0.3, 0.3, 0.9], [0.8, 0.8, 1.5], [2; 3]),
    ]));
}
