//! Contact at nodes and at points, and weighted gaps.

use super::Host;
use super::array::{Array, CANARY, checked, is_null, unless};
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};

impl Host {
    pub(super) fn fields(&mut self, read: Layout, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let (view, n, mut count) = (array.view, self.mesh.node_count(), 77usize);
        let numbers = |each: usize| Guarded::new(&vec![f64::from_bits(CANARY); n * each]);
        let (pressure, gap, area, normal) = (numbers(1), numbers(1), numbers(1), numbers(self.mesh.dim));
        let (friction, sliding, touches) = (numbers(self.mesh.dim), numbers(1), Guarded::new(&vec![7; n]));
        // SAFETY: as in `evaluate`; points go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let mut nodal = std::mem::zeroed();
            assert_ne!(checked(fmc_context_nodal_contact(self.context, &raw const view, &raw const nodal)), OK);
            assert_eq!(checked(fmc_nodal_contact_init(&raw mut nodal)), OK);
            (nodal.pressure, nodal.status) = (unless(hole, 1, pressure.ptr()), unless(hole, 2, touches.ptr()));
            (nodal.gap, nodal.area, nodal.normal) = (gap.ptr(), area.ptr(), normal.ptr());
            (nodal.friction, nodal.sliding) = (friction.ptr(), sliding.ptr());
            let nodal_at = unless(hole, 5, &raw mut nodal).cast_const();
            let is_ok = checked(fmc_context_nodal_contact(self.context, coords, nodal_at)) == OK;
            let found = [gap.values(), normal.values(), friction.values(), sliding.values()].concat();
            assert_eq!(found.iter().any(|v| v.to_bits() == CANARY), !is_ok);
            assert!(!is_ok || sliding.values().iter().all(|part| (0.0..=1.0 + 1e-9).contains(part)));
            assert!(is_ok && !is_null(hole, 2) || touches.values().iter().all(|s| *s == 7));
            assert!(!is_ok || is_null(hole, 2) || touches.values().iter().all(|s| (0..=3).contains(s)));
            let count_at = unless(hole, 4, &raw mut count);
            let ask = fmc_context_contact_points(self.context, coords, std::ptr::null_mut(), 0, count_at);
            if checked(ask) != OK || is_null(hole, 4) {
                assert_eq!(count, 77);
                return;
            }
            let blank = std::mem::MaybeUninit::<fmc_contact_point>::zeroed().assume_init();
            let points = Guarded::new(&vec![blank; count]);
            let mut give = |room| fmc_context_contact_points(self.context, coords, points.ptr(), room, &raw mut count);
            let there = points.values().len();
            assert!(there == 0 || checked(give(there - 1)) != OK);
            assert_eq!(checked(give(there)), OK);
            assert!(points.values().iter().all(|point| point.struct_size == size_of::<fmc_contact_point>()));
        }
    }

    pub(super) fn gaps(&mut self, reach: f64, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut rows, mut entries) = (array.view, 77usize, 77usize);
        // SAFETY: as in `evaluate`; rows and entries go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let (rows_at, none) = (unless(hole, 1, &raw mut rows), std::ptr::null_mut());
            let status = fmc_context_gap_constraints(self.context, coords, reach, none, 0, rows_at);
            if checked(status) != OK || is_null(hole, 1) {
                assert_eq!(rows, 77);
                return;
            }
            let (none, entries_at) = (std::ptr::null_mut(), &raw mut entries);
            let no_values = std::ptr::null_mut();
            let status =
                fmc_context_gap_gradient(self.context, none, 0, std::ptr::null_mut(), none, no_values, 0, entries_at);
            assert_eq!(checked(status), OK);
            let blank = std::mem::MaybeUninit::<fmc_gap_constraint>::zeroed().assume_init();
            let found = Guarded::new(&vec![blank; rows]);
            let list = |length: usize| Numbers::new(&vec![-7; length], self.is_wide);
            let (offsets, cols, base) = (list(rows + 1), list(entries), i64::from(self.options.index_base));
            let values = Guarded::new(&vec![f64::from_bits(CANARY); entries]);
            let give = |room| {
                fmc_context_gap_constraints(self.context, coords, reach, found.ptr(), room, std::ptr::null_mut())
            };
            assert!(rows == 0 || checked(give(rows - 1)) != OK);
            assert_eq!(checked(give(rows)), OK);
            assert!(found.values().iter().all(|row| row.struct_size == size_of::<fmc_gap_constraint>()));
            let (offsets_at, cols_at, values_at) = (offsets.ptr(), cols.ptr(), values.ptr());
            let none = std::ptr::null_mut();
            let status =
                fmc_context_gap_gradient(self.context, offsets_at, rows + 1, none, cols_at, values_at, entries, none);
            assert_eq!(checked(status), OK);
            assert_eq!(offsets.values().last().copied(), Some(entries as i64 + base));
            let size = (self.mesh.node_count() * self.mesh.dim) as i64;
            assert!(cols.values().iter().all(|col| (base..size + base).contains(col)));
            assert!(values.values().iter().all(|value| value.is_finite()));
        }
    }

    /// Cohesive interfaces at the coordinates, and their damage, which is put back.
    pub(super) fn cohesive(&mut self, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut count, mut numbers) = (array.view, 77usize, 77usize);
        // SAFETY: as in `gaps`.
        unsafe {
            let mut found = std::mem::MaybeUninit::<fmc_cohesive>::zeroed().assume_init();
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let status = checked(fmc_context_cohesive(self.context, 0, 1, coords, unless(hole, 3, &raw mut found)));
            assert!(status != OK || found.struct_size == size_of::<fmc_cohesive>());
            let (none, nothing) = (std::ptr::null_mut(), std::ptr::null_mut());
            let status = fmc_context_cohesive_points(self.context, coords, none, 0, unless(hole, 1, &raw mut count));
            if checked(status) != OK || is_null(hole, 1) {
                assert_eq!(count, 77);
                return;
            }
            let blank = std::mem::MaybeUninit::<fmc_cohesive_point>::zeroed().assume_init();
            let rows = Guarded::new(&vec![blank; count]);
            let status = fmc_context_cohesive_points(self.context, coords, rows.ptr(), count, std::ptr::null_mut());
            assert_eq!(checked(status), OK);
            assert!(rows.values().iter().all(|row| row.struct_size == size_of::<fmc_cohesive_point>()));
            assert_eq!(checked(fmc_context_damage(self.context, nothing, 0, &raw mut numbers)), OK);
            assert_eq!(numbers, 2 * count);
            let damage = Guarded::new(&vec![0.0; numbers]);
            assert_eq!(checked(fmc_context_damage(self.context, damage.ptr(), numbers, std::ptr::null_mut())), OK);
            assert!(damage.values().iter().all(|x| *x >= 0.0));
            let given = unless(hole, 4, damage.ptr()).cast_const();
            let status = checked(fmc_context_set_damage(self.context, given, numbers));
            assert!(status == OK || is_null(hole, 4));
            assert_eq!(checked(fmc_context_cohesive_history(self.context, nothing, 0, &raw mut numbers)), OK);
            assert_eq!(numbers, 5 * count);
            let history = Guarded::new(&vec![0.0; numbers]);
            let filled = fmc_context_cohesive_history(self.context, history.ptr(), numbers, std::ptr::null_mut());
            assert_eq!(checked(filled), OK);
            assert!(history.values().iter().all(|x| x.is_finite()));
            let given = unless(hole, 4, history.ptr()).cast_const();
            let status = checked(fmc_context_set_cohesive_history(self.context, given, numbers));
            assert!(status == OK || is_null(hole, 4));
            assert_eq!(checked(fmc_context_set_time_step(self.context, 0.1)), OK);
        }
    }

    /// Interfaces by a law of the host at the coordinates, and their history, which is put back.
    pub(super) fn law_points(&mut self, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut count, mut numbers) = (array.view, 77usize, 77usize);
        // SAFETY: as in `gaps`.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let (none, nothing) = (std::ptr::null_mut(), std::ptr::null_mut());
            let status = fmc_context_law_points(self.context, coords, none, 0, unless(hole, 1, &raw mut count));
            if checked(status) != OK || is_null(hole, 1) {
                assert_eq!(count, 77);
                return;
            }
            let blank = std::mem::MaybeUninit::<fmc_law_point>::zeroed().assume_init();
            let rows = Guarded::new(&vec![blank; count]);
            let status = fmc_context_law_points(self.context, coords, rows.ptr(), count, std::ptr::null_mut());
            assert_eq!(checked(status), OK);
            assert!(rows.values().iter().all(|row| row.struct_size == size_of::<fmc_law_point>()));
            assert_eq!(checked(fmc_context_law_history(self.context, nothing, 0, &raw mut numbers)), OK);
            assert_eq!(numbers, count);
            let history = Guarded::new(&vec![0.0; numbers]);
            let filled = fmc_context_law_history(self.context, history.ptr(), numbers, std::ptr::null_mut());
            assert_eq!(checked(filled), OK);
            let given = unless(hole, 4, history.ptr()).cast_const();
            let status = checked(fmc_context_set_law_history(self.context, given, numbers));
            assert!(status == OK || is_null(hole, 4));
            let values = unless(hole, 2, self.mesh.coords.as_ptr().cast_mut()).cast_const();
            checked(fmc_context_set_law_fields(self.context, values, self.mesh.node_count(), self.mesh.dim));
        }
    }

    /// Ties at the coordinates, and as equations.
    pub(super) fn ties(&mut self, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut count, mut entries) = (array.view, 77usize, 77usize);
        // SAFETY: as in `gaps`.
        unsafe {
            let mut tie = std::mem::MaybeUninit::<fmc_tie>::zeroed().assume_init();
            let status = checked(fmc_context_tie(self.context, 0, 1, unless(hole, 3, &raw mut tie)));
            assert!(status != OK || is_null(hole, 3) || tie.struct_size == size_of::<fmc_tie>());
            let (null, nothing) = (std::ptr::null_mut(), std::ptr::null_mut());
            let entries_at = unless(hole, 4, &raw mut entries);
            let status =
                fmc_context_tie_constraints(self.context, null, 0, nothing, null, std::ptr::null_mut(), 0, entries_at);
            assert!(checked(status) != OK || is_null(hole, 4) || entries != 77);
            let (mut surface, facets) = (-77, Guarded::new(&[0, 1, 3]));
            let given = unless(hole, 6, facets.ptr()).cast_const();
            let status = checked(fmc_context_add_surface(self.context, given, 3, unless(hole, 7, &raw mut surface)));
            assert!((status == OK) == (surface > 0) || is_null(hole, 7), "an error writes outputs");
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let none = std::ptr::null_mut();
            let (mut added, period) = (-77, Guarded::new(&[1.0, 0.0, 0.0]));
            let vector = unless(hole, 5, period.ptr()).cast_const();
            let number = unless(hole, 6, &raw mut added);
            let status = checked(fmc_context_add_tie(self.context, surface, surface, vector, 0.5, number));
            assert!((status == OK) == (added > 0) || is_null(hole, 6), "an error writes outputs");
            checked(fmc_context_set_tie_jump(self.context, added, vector));
            checked(fmc_context_added_tie(self.context, added, unless(hole, 3, &raw mut tie)));
            let (force, no_count) = (Guarded::new(&[0.0; 3]), std::ptr::null_mut());
            let room = unless(hole, 4, force.ptr());
            checked(fmc_context_tie_force(self.context, coords, added, room, 3, no_count));
            checked(fmc_context_remove_tie(self.context, added));
            let status = fmc_context_tie_nodes(self.context, coords, none, 0, unless(hole, 1, &raw mut count));
            if checked(status) != OK || is_null(hole, 1) {
                assert_eq!(count, 77);
                return;
            }
            let blank = std::mem::MaybeUninit::<fmc_tie_node>::zeroed().assume_init();
            let found = Guarded::new(&vec![blank; count]);
            let status = fmc_context_tie_nodes(self.context, coords, found.ptr(), count, std::ptr::null_mut());
            assert_eq!(checked(status), OK);
            assert!(found.values().iter().all(|row| row.struct_size == size_of::<fmc_tie_node>()));
        }
    }
}
