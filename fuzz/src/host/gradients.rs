//! Derivatives of energy and forces.

use super::Host;
use super::array::{Array, CANARY, checked, unless};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};

impl Host {
    /// All that there is, with the coordinates for an adjoint; a derivative that is not known leaves all outputs as they were.
    pub(super) fn gradients(&mut self, read: Layout, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let (view, n, mut count) = (array.view, self.mesh.node_count() * self.mesh.dim, 77usize);
        let numbers = || Guarded::new(&vec![f64::from_bits(CANARY); n]);
        let (by_coords, by_reference) = (numbers(), numbers());
        // SAFETY: as in `evaluate`; pairs go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let mut to = std::mem::zeroed();
            let (none, capacity) = (std::ptr::null_mut(), 0);
            let unset = &raw const to;
            let ask = fmc_context_vjp(self.context, coords, 1.0, coords, unset, none, capacity, &raw mut count);
            assert_ne!(checked(ask), OK);
            assert_eq!(checked(fmc_gradients_init(&raw mut to)), OK);
            (to.coords, to.reference) = (unless(hole, 1, by_coords.ptr()), unless(hole, 2, by_reference.ptr()));
            let count_at = unless(hole, 3, &raw mut count);
            let ask = fmc_context_vjp(self.context, coords, 1.0, coords, &raw const to, none, capacity, count_at);
            let is_ok = checked(ask) == OK;
            for (number, list) in [(1, &by_coords), (2, &by_reference)] {
                let is_written = is_ok && hole != number + 1;
                assert!(list.values().iter().all(|x| (x.to_bits() == CANARY) != is_written));
            }
            assert_eq!(count, if is_ok && hole != 4 { 0 } else { 77 });
            let blank = std::mem::MaybeUninit::<fmc_pair_gradient>::zeroed().assume_init();
            assert_eq!(checked(fmc_gradients_init(&raw mut to)), OK);
            to.of_pairs = FMC_GRADIENT_STIFFNESS as u64;
            let ask = fmc_context_vjp(self.context, coords, 1.0, none.cast(), &raw const to, none, 0, &raw mut count);
            if checked(ask) == OK {
                let pairs = Guarded::new(&vec![blank; count]);
                let (room, at) = (count, pairs.ptr());
                let ask =
                    fmc_context_vjp(self.context, coords, 1.0, none.cast(), &raw const to, at, room, &raw mut count);
                assert_eq!(checked(ask), OK);
                assert!(pairs.values().iter().all(|pair| pair.struct_size == size_of::<fmc_pair_gradient>()));
                self.along(&raw const view, &pairs.values(), n);
            }
        }
    }

    /// Rates along the coordinates, as motion, and along what was found of pairs; all outputs stay where a rate is not known.
    unsafe fn along(&mut self, coords: *const fmc_coords, pairs: &[fmc_pair_gradient], n: usize) {
        let forces = Guarded::new(&vec![f64::from_bits(CANARY); n]);
        // SAFETY: as in `gradients`; the motion has as many numbers as the coordinates.
        unsafe {
            let (mut to, mut energy): (fmc_directions, f64) = (std::mem::zeroed(), f64::from_bits(CANARY));
            let ask = fmc_context_jvp(self.context, coords, &raw const to, &raw mut energy, forces.ptr());
            assert_ne!(checked(ask), OK);
            assert_eq!(checked(fmc_directions_init(&raw mut to)), OK);
            to.coords = self.mesh.coords.as_ptr();
            (to.pairs, to.pair_count) = (pairs.as_ptr(), pairs.len());
            let ask = fmc_context_jvp(self.context, coords, &raw const to, &raw mut energy, forces.ptr());
            let is_ok = checked(ask) == OK;
            assert_eq!(energy.to_bits() != CANARY, is_ok);
            assert!(forces.values().iter().all(|x| (x.to_bits() != CANARY) == is_ok));
        }
    }
}
