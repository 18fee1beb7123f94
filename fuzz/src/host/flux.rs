//! Scalar fields through contact.

use super::Host;
use super::array::{Array, CANARY, checked, unless};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};

impl Host {
    /// A field that is everywhere the same, which flows nowhere, and the derivative.
    pub(super) fn flux(&mut self, h: f64, reach: f64, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, n) = (array.view, self.mesh.node_count());
        let (fields, flux) = (Guarded::new(&vec![3.25; n]), Guarded::new(&vec![f64::from_bits(CANARY); n]));
        let tables = [Guarded::new(&[0.0, 1.0]), Guarded::new(&[h, h]), Guarded::new(&[reach]), Guarded::new(&[h])];
        let (none, null) = (std::ptr::null_mut::<f64>(), std::ptr::null_mut());
        let (mut rows, mut entries) = (77usize, 77usize);
        // SAFETY: as in `evaluate`; all arrays are as long as is said.
        unsafe {
            let mut given = std::mem::zeroed();
            let unset = &raw const given;
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let (from, to) = (unless(hole, 1, fields.ptr()).cast_const(), unless(hole, 2, flux.ptr()));
            assert_ne!(checked(fmc_context_flux(self.context, coords, unset, 1, from, none, to, none)), OK);
            assert_eq!(checked(fmc_conductance_init(&raw mut given)), OK);
            (given.pressure_count, given.gap_count) = (2, 1);
            (given.pressures, given.by_pressure) = (tables[0].ptr(), unless(hole, 3, tables[1].ptr()).cast_const());
            (given.gaps, given.by_gap) = (tables[2].ptr(), tables[3].ptr());
            let given_at = unless(hole, 4, &raw mut given).cast_const();
            let is_ok = checked(fmc_context_flux(self.context, coords, given_at, 1, from, none, to, none)) == OK;
            assert!(flux.values().iter().all(|q| if is_ok { *q == 0.0 } else { q.to_bits() == CANARY }));
            let (rows_at, entries_at) = (&raw mut rows, unless(hole, 5, &raw mut entries));
            let status = fmc_context_flux_matrix(self.context, null, 0, rows_at, null, none, 0, entries_at);
            assert_eq!(checked(status), OK);
            assert!(!is_ok || rows > n);
            let heat = Guarded::new(&vec![f64::from_bits(CANARY); n]);
            let is_ok = checked(fmc_context_friction_heat(self.context, coords, none, heat.ptr(), none)) == OK;
            assert!(heat.values().iter().all(|q| (q.to_bits() == CANARY) != is_ok));
        }
    }
}
