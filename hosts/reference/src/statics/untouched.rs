//! Contact that has not begun.

use fmc_contact::contact::Resultant;
use fmc_contact::{ContactForces, Surface};

/// No force on any body: what is said of a contact before its stiffness is found.
pub(super) fn untouched<const D: usize>(surface: &Surface<D>, node_count: usize) -> ContactForces<D> {
    let body = |(body, &id): (usize, &i64)| Resultant {
        id,
        force: [0.0; D],
        moment: [0.0; 3],
        friction: [0.0; D],
        node_count: surface.surface_node_count(body),
    };
    ContactForces {
        forces: vec![[0.0; D]; node_count],
        volume: 0.0,
        standard_error: 0.0,
        energy: 0.0,
        contact_area: 0.0,
        penetration: 0.0,
        fiber_count: 0,
        crossing_count: 0,
        facet_count: 0,
        bodies: surface.body_ids().iter().enumerate().map(body).collect(),
        obstacles: Vec::new(),
        friction: Default::default(),
        pairs: Vec::new(),
        warnings: Vec::new(),
    }
}
