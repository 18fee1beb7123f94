//! Arrays of a host: laid out as it likes, watched where nothing may be written; and what is asked of every call.

use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use crate::timed;
use std::ffi::CStr;
use std::ptr::null_mut;

/// What outputs hold before a call: no number that a library writes.
pub(super) const CANARY: u64 = 0x7ff8_dead_beef_cafe;

/// The statuses that exist, but for a panic.
pub(crate) fn checked(status: fmc_status) -> fmc_status {
    timed::call();
    if status == FMC_ERROR_PANIC {
        // SAFETY: a text that is valid until the next failure.
        panic!("{}", unsafe { CStr::from_ptr(fmc_last_error()) }.to_string_lossy());
    }
    // SAFETY: a text that ends in zero.
    let name = unsafe { CStr::from_ptr(fmc_status_name(status)) };
    assert!(status == OK || name.to_bytes().starts_with(b"FMC_ERROR_"), "status {status}");
    status
}

/// NULL in the place of pointer number `which` if the hole is there; holes are rare.
pub(crate) fn unless<T>(hole: Hole, which: u8, pointer: *mut T) -> *mut T {
    if is_null(hole, which) { null_mut() } else { pointer }
}

/// Whether pointer number `which` is NULL.
pub(crate) fn is_null(hole: Hole, which: u8) -> bool {
    hole == which + 1
}

/// Numbers of a host, laid out as it likes, with canaries in the gaps.
pub(crate) struct Array {
    pub(super) memory: Guarded<f64>,
    pub(crate) view: fmc_coords,
    places: Vec<usize>,
}

impl Array {
    pub(crate) fn new(rows: &[f64], dim: usize, layout: Layout) -> Self {
        let n = rows.len() / dim;
        let (node_stride, axis_stride, first, len) = match layout {
            Layout::Rows => (dim as isize, 1, 0, n * dim),
            Layout::Padded => (dim as isize + 1, 1, 0, (n * (dim + 1)).saturating_sub(1)),
            Layout::Columns => (1, n as isize, 0, n * dim),
            Layout::Reversed => (-(dim as isize), 1, n.saturating_sub(1) * dim, n * dim),
            Layout::Repeated => (0, 1, 0, dim),
        };
        let place = |node: usize, axis: usize| {
            (first as isize + node as isize * node_stride + axis as isize * axis_stride) as usize
        };
        let places: Vec<usize> = (0..n).flat_map(|node| (0..dim).map(move |axis| place(node, axis))).collect();
        let mut values = vec![f64::from_bits(CANARY); len];
        places.iter().zip(rows).for_each(|(&place, &x)| values[place] = x);
        let memory = Guarded::new(&values);
        let data = if n == 0 { memory.ptr() } else { memory.ptr().wrapping_add(first) };
        Self { view: fmc_coords { data, node_count: n, node_stride, axis_stride }, memory, places }
    }

    /// The same as a place for forces.
    pub(crate) fn out(&self) -> fmc_forces {
        let fmc_coords { data, node_count, node_stride, axis_stride } = self.view;
        fmc_forces { data: data.cast_mut(), node_count, node_stride, axis_stride }
    }

    /// The bits of everything.
    pub(super) fn bits(&self) -> Vec<u64> {
        self.memory.values().into_iter().map(f64::to_bits).collect()
    }

    /// The numbers, in rows; whatever lies between them must be as it was.
    pub(crate) fn rows(&self) -> Vec<f64> {
        let values = self.memory.values();
        let asked: std::collections::BTreeSet<usize> = self.places.iter().copied().collect();
        assert!((0..values.len()).all(|n| asked.contains(&n) || values[n].to_bits() == CANARY), "padding is written");
        self.places.iter().map(|&place| values[place]).collect()
    }
}
