//! Surfaces moved out by what they penetrate.

use super::Host;
use super::array::{Array, checked, unless};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};

impl Host {
    /// Moves surfaces out, reads by how much, damages one and sets it.
    pub(super) fn augment(&mut self, reach: f64, enough: f64, damage: f64, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let view = array.view;
        // SAFETY: as in `evaluate`; structs of this interface, of which there is room for as many as are told of.
        unsafe {
            let mut found = std::mem::MaybeUninit::<fmc_augmentation>::zeroed().assume_init();
            let (coords, found_at) = (unless(hole, 0, (&raw const view).cast_mut()), unless(hole, 1, &raw mut found));
            let status = checked(fmc_context_augment(self.context, coords, reach, enough, found_at));
            let mut count = 77usize;
            assert_eq!(checked(fmc_context_multipliers(self.context, std::ptr::null_mut(), 0, &raw mut count)), OK);
            if status == OK {
                assert_eq!((found.struct_size, found.multiplier_count), (size_of::<fmc_augmentation>(), count));
                assert!(found.penetration >= 0.0 && found.change >= 0.0);
            }
            // A factor that is none; with others the options would be no more what they are known to be.
            if !(damage > 0.0 && damage.is_finite()) {
                assert_ne!(checked(fmc_context_stiffen(self.context, damage)), OK);
            }
            assert_eq!(checked(fmc_context_stiffen(self.context, 1.0)), OK);
            let blank = std::mem::MaybeUninit::<fmc_multiplier>::zeroed().assume_init();
            let kept = Guarded::new(&vec![blank; count]);
            if count > 1 {
                assert_ne!(checked(fmc_context_multipliers(self.context, kept.ptr(), count - 1, &raw mut count)), OK);
            }
            assert_eq!(checked(fmc_context_multipliers(self.context, kept.ptr(), count, &raw mut count)), OK);
            let mut given = kept.values().to_vec();
            assert!(given.iter().all(|one| one.struct_size == size_of::<fmc_multiplier>() && one.shift > 0.0));
            for one in given.iter_mut().take(1) {
                match hole % 5 {
                    0 => one.shift = damage,
                    1 => one.node = damage as i64,
                    2 => one.partner = damage as usize,
                    3 => one.partner_kind = damage as i32,
                    _ => one.towards[0] = damage,
                }
            }
            let given = Guarded::new(&given);
            if checked(fmc_context_set_multipliers(self.context, given.ptr(), count)) == OK {
                let mut energy = std::mem::MaybeUninit::<fmc_result>::zeroed().assume_init();
                checked(fmc_context_evaluate(self.context, &raw const view, std::ptr::null_mut(), 0, &raw mut energy));
            }
            assert_eq!(checked(fmc_context_set_multipliers(self.context, kept.ptr(), count)), OK);
            // What follows is compared with contacts that have none.
            assert_eq!(checked(fmc_context_set_multipliers(self.context, std::ptr::null(), 0)), OK);
        }
    }
}
