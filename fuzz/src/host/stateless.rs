//! Functions without a context.

use super::Host;
use super::array::{Array, CANARY, checked, unless};
use super::creation::cell_size;
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use std::ffi::{CStr, CString};
use std::ptr::null;

pub(super) fn suggest(dim: i32, [a, b, c]: [f64; 3]) {
    let check = |call: &dyn Fn(*mut f64) -> fmc_status| {
        let mut found = -1.0;
        let status = checked(call(&raw mut found));
        // A product of numbers in range may leave it.
        assert!(if status == OK { found > 0.0 || found == 0.0 || found.is_infinite() } else { found == -1.0 });
    };
    // SAFETY: the output may be written.
    unsafe {
        for law in -1..4 {
            check(&|found| fmc_suggest_stiffness(law, dim, a, b, c, found));
        }
    }
}

pub(super) fn texts(status: i32, feature: &[u8; 5]) {
    let end = feature.iter().position(|b| *b == 0).unwrap_or(5);
    let feature = CString::new(&feature[..end]).expect("no zero within");
    // SAFETY: texts that end in zero, theirs and ours.
    unsafe {
        assert!((0..=1).contains(&fmc_has_feature(feature.as_ptr())) && fmc_has_feature(null()) == 0);
        assert!(CStr::from_ptr(fmc_status_name(status)).to_bytes().starts_with(b"FMC_"));
        assert!((0..=6).contains(&fmc_status_class(status)));
        assert!(!CStr::from_ptr(fmc_version()).to_bytes().is_empty());
        assert!(fmc_abi_version() > 0);
        assert!(CStr::from_ptr(fmc_last_error()).to_str().is_ok());
    }
}

impl Host {
    pub(super) fn stateless(&self, hole: Hole) {
        let Some((cell_type, conn)) = self.mesh.blocks.first() else { return };
        let size = cell_size(*cell_type);
        let numbers: Vec<i64> = conn.iter().map(|n| n + i64::from(self.options.index_base)).collect();
        let both = [false, true].map(|is_wide| Numbers::new(&numbers, is_wide));
        let block = |is_wide: bool| fmc_cell_block {
            cell_type: *cell_type,
            index_size: Numbers::size(is_wide),
            conn: both[usize::from(is_wide)].ptr(),
            cell_count: conn.len() / size,
        };
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let canaries = vec![f64::from_bits(CANARY); self.mesh.coords.len()];
        let (dim, n) = (self.mesh.dim as i32, self.mesh.node_count());
        let call = |is_wide: bool| {
            let (forces, mut volume) = (Guarded::new(&canaries), -1.0);
            // SAFETY: arrays as long as they are said to be.
            let status = unsafe {
                let (x, o) = (unless(hole, 0, coords.memory.ptr()), &raw const self.options);
                let (f, v) = (unless(hole, 1, forces.ptr()), unless(hole, 2, &raw mut volume));
                let block = block(is_wide);
                fmc_contact_force(dim, x, n, &block, 1, null(), o, null(), f, v)
            };
            let bits: Vec<u64> = forces.values().into_iter().map(f64::to_bits).collect();
            if checked(status) != OK {
                assert!(bits.iter().all(|b| *b == CANARY) && volume == -1.0, "an error writes outputs");
            }
            (status, bits, volume.to_bits())
        };
        assert_eq!(call(false), call(true));
        let stepped = |is_wide: bool| {
            let (forces, next) = (Guarded::new(&canaries), Guarded::new(&canaries));
            // SAFETY: arrays as long as they are said to be; a slip of more than `n` rows is refused.
            let (status, volume) = unsafe {
                let (mut step, mut volume) = (std::mem::zeroed(), -1.0);
                assert_eq!(fmc_friction_step_init(&raw mut step), OK);
                step.start = unless(hole, 3, coords.memory.ptr());
                (step.next_slip, step.next_slip_capacity) = (unless(hole, 4, next.ptr()), canaries.len());
                let (x, o, f) = (coords.memory.ptr(), &raw const self.options, forces.ptr());
                let (v, step) = (&raw mut volume, unless(hole, 5, &raw mut step));
                let block = block(is_wide);
                let status = fmc_contact_force(dim, x, n, &block, 1, null(), o, step, f, v);
                (checked(status), volume)
            };
            let bits: Vec<u64> = forces.values().iter().chain(&next.values()).map(|x| x.to_bits()).collect();
            if status != OK {
                assert!(bits.iter().all(|x| *x == CANARY) && volume == -1.0, "an error writes outputs");
            }
            (status, bits, volume.to_bits())
        };
        assert_eq!(stepped(false), stepped(true));
    }
}
