//! Steps of friction, and what makes a symmetric half.

use super::Host;
use super::array::{Array, checked, is_null, unless};
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use std::ptr::null_mut;

impl Host {
    pub(super) fn step(&mut self, what: u8, read: Layout, value: f64, hole: Hole) {
        if what % 11 == 10 {
            self.wear(what, value);
        }
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let view = coords.view;
        let coords = unless(hole, 0, (&raw const view).cast_mut()).cast_const();
        // Rows of 8 numbers; some name what there is not, and one is not whole.
        let rows = usize::from(what / 5 % 8);
        let row = |facet: usize| {
            let (facet, second) = (facet as f64, f64::from(what / 40 % 2));
            [facet, second, 0.0, f64::from(what / 80 % 2), value, 0.0, 0.0, 0.0]
        };
        let mut numbers: Vec<f64> = (0..rows).flat_map(row).collect();
        if what > 250 {
            numbers.pop();
        }
        let length = numbers.len();
        let slip = Guarded::new(&numbers);
        // SAFETY: a living context or NULL, a view or NULL, as many numbers as it says.
        unsafe {
            match what % 5 {
                0 => checked(fmc_context_begin_step(self.context, coords)),
                1 => checked(fmc_context_commit_step(self.context, coords)),
                2 => checked(fmc_context_freeze_friction(self.context, coords)),
                3 => checked(fmc_context_set_slip(self.context, unless(hole, 1, slip.ptr()).cast_const(), length)),
                _ => checked(fmc_context_slip(self.context, unless(hole, 1, slip.ptr()), length, std::ptr::null_mut())),
            };
        }
        self.friction_history(hole);
    }

    /// What laws of friction keep, which is put back.
    fn friction_history(&mut self, hole: Hole) {
        let mut count = 77;
        // SAFETY: a living context or NULL, and as many numbers as each call says.
        unsafe {
            let at = unless(hole, 2, &raw mut count);
            if checked(fmc_context_friction_history(self.context, null_mut(), 0, at)) != OK || is_null(hole, 2) {
                assert_eq!(count, 77);
                return;
            }
            let history = Guarded::new(&vec![0.0; count]);
            assert_eq!(checked(fmc_context_friction_history(self.context, history.ptr(), count, null_mut())), OK);
            let given = unless(hole, 3, history.ptr()).cast_const();
            let status = checked(fmc_context_set_friction_history(self.context, given, count));
            assert!(status == OK || is_null(hole, 3));
        }
    }

    /// What was worn off, set as it is told, and as no call tells it.
    pub(super) fn wear(&mut self, what: u8, value: f64) {
        let mut count = 0;
        let context = self.context;
        // SAFETY: a living context or NULL, and as many numbers as each call says.
        unsafe {
            if checked(fmc_context_worn_facets(context, null_mut(), 0, &raw mut count)) == OK {
                let worn = Guarded::new(&vec![0.0; count]);
                assert_eq!(checked(fmc_context_worn_facets(context, worn.ptr(), count, &raw mut count)), OK);
                checked(fmc_context_set_worn_facets(context, worn.ptr().cast_const(), count));
            }
            if checked(fmc_context_worn_depth(context, null_mut(), 0, &raw mut count)) == OK {
                let depth = Guarded::new(&vec![0.0; count]);
                assert_eq!(checked(fmc_context_worn_depth(context, depth.ptr(), count, &raw mut count)), OK);
            }
            if checked(fmc_context_worn_volumes(context, null_mut(), 0, &raw mut count)) == OK {
                let volumes = Guarded::new(&vec![0.0; count]);
                assert_eq!(checked(fmc_context_worn_volumes(context, volumes.ptr(), count, &raw mut count)), OK);
            }
            let rows = Guarded::new(&[f64::from(what), f64::from(what / 3), value, 0.5, value]);
            checked(fmc_context_set_worn_facets(context, rows.ptr().cast_const(), if what > 250 { 5 } else { 4 }));
            checked(fmc_context_set_wear_cycles(context, value));
        }
    }

    pub(super) fn set_symmetry_nodes(&mut self, nodes: &[u8], hole: Hole) {
        let nodes: Vec<i64> = nodes.iter().map(|&node| i64::from(node) - 2).collect();
        let numbers = Numbers::new(&nodes, self.is_wide);
        // SAFETY: as many numbers as it says.
        checked(unsafe {
            fmc_context_set_symmetry_nodes(self.context, unless(hole, 0, numbers.ptr()).cast_const(), nodes.len())
        });
        // As many planes as there are numbers for, in space.
        let (rows, count) = (nodes.iter().map(|&n| n as f64).collect::<Vec<f64>>(), nodes.len() / 6);
        let (points, normals) = rows.split_at(3 * count);
        let points = unless(hole, 1, points.as_ptr().cast_mut()).cast_const();
        // SAFETY: three numbers for each plane and more.
        checked(unsafe { fmc_context_set_symmetry_planes(self.context, points, normals.as_ptr(), count) });
        let angle = nodes.first().map_or(f64::NAN, |&node| 10.0 * node as f64);
        // SAFETY: a context.
        checked(unsafe { fmc_context_set_surface_smoothing(self.context, angle) });
    }
}
