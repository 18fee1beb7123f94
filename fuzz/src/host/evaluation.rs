//! Forces, the stable step, and patches.

use super::Host;
use super::array::{Array, CANARY, checked, unless};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use std::ptr::null;

pub(super) fn no_result() -> fmc_result {
    fmc_result {
        struct_size: 77,
        volume: -1.0,
        volume_standard_error: -1.0,
        energy: -1.0,
        contact_area: -1.0,
        penetration: -1.0,
        fiber_count: 77,
        crossing_count: 77,
        facet_count: 77,
        pair_count: 77,
        body_count: 77,
        obstacle_count: 77,
        warning_count: 77,
        friction_energy: 77.0,
        friction_dissipation: 77.0,
        stick_area: 77.0,
        slip_area: 77.0,
        largest_slip: 77.0,
        reserved: [77; 3],
    }
}

impl Host {
    pub(super) fn evaluate(&mut self, read: Layout, write: Layout, add: bool, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let before = vec![if add { 0.0 } else { f64::from_bits(CANARY) }; self.mesh.coords.len()];
        let nothing = fmc_result { fiber_count: 77, ..no_result() };
        let once = || {
            let forces = Array::new(&before, self.mesh.dim, write);
            let (untouched, mut result) = (forces.bits(), nothing);
            let (coords_view, forces_view) = (coords.view, forces.out());
            // SAFETY: views of arrays that are as long as they say, alive during the call.
            let status = checked(unsafe {
                fmc_context_evaluate(
                    self.context,
                    unless(hole, 0, (&raw const coords_view).cast_mut()),
                    unless(hole, 1, (&raw const forces_view).cast_mut()),
                    u32::from(add),
                    unless(hole, 2, &raw mut result),
                )
            });
            if status != OK {
                assert!(forces.bits() == untouched && result == nothing, "an error writes outputs");
                return (status, Vec::new(), result);
            }
            if hole != 2 {
                assert!(!matches!(write, Layout::Repeated) || self.mesh.node_count() < 2, "forces fall on one another");
                assert!(forces.rows().iter().all(|f| f.is_finite()), "{:?}", forces.rows());
            }
            if hole != 3 {
                let numbers = [result.volume, result.energy, result.contact_area, result.penetration];
                assert!(numbers.iter().all(|x| x.is_finite() && *x >= 0.0), "{result:?}");
                assert!(result.volume_standard_error >= 0.0 && result.struct_size == size_of::<fmc_result>());
            }
            (status, forces.bits(), result)
        };
        let found = once();
        if self.is_steady {
            assert_eq!(format!("{found:?}"), format!("{:?}", once()), "asked twice");
        }
    }

    /// Evaluates where that has to fail.
    pub(super) fn evaluate_refused(&self) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let view = coords.view;
        // SAFETY: as in `evaluate`.
        let status = checked(unsafe {
            fmc_context_evaluate(self.context, &raw const view, std::ptr::null(), 0, std::ptr::null_mut())
        });
        assert!(status != OK, "nothing was gathered");
    }

    pub(super) fn stable_step(&mut self, mass: f64, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let masses = Guarded::new(&vec![mass; self.mesh.node_count()]);
        let (view, mut step) = (coords.view, -77.0);
        // SAFETY: as in `evaluate`, with a mass for every node.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let masses = unless(hole, 1, masses.ptr());
            // What has a stiffness found would be no more what it is compared with.
            assert_ne!(checked(fmc_context_stiffness_from_masses(self.context, coords, masses, -mass.abs())), OK);
            let status = fmc_context_stable_step(self.context, coords, masses, unless(hole, 2, &raw mut step));
            assert!(if checked(status) == OK { step > 0.0 } else { step == -77.0 }, "{step}");
        }
    }

    pub(super) fn keep_patches(&mut self, forget: bool, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut count) = (coords.view, 77usize);
        // SAFETY: as in `evaluate`.
        unsafe {
            let coords = if forget { null() } else { &raw const view };
            let status = fmc_context_keep_patches(self.context, coords, unless(hole, 0, &raw mut count));
            assert!(checked(status) == OK || count == 77);
        }
    }
}
