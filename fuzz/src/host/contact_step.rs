//! Steps of contact alone, whose bodies are two numbers.

use super::Host;
use super::array::{Array, checked, unless};
use super::callbacks::{Placed, place};
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Fault, Hole, Layout};

impl Host {
    pub(super) fn contact_step(&mut self, which: u16, shift: i64, numbers: [f64; 4], fault: Fault, hole: Hole) {
        let [stiffness, coupling, residual, tolerance] = numbers;
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let dofs = 0..(self.mesh.node_count() * self.mesh.dim) as i64;
        let (mut list, mut held): (Vec<i64>, Vec<i64>) = dofs.partition(|dof| which >> (dof % 15) & 1 == 1);
        if which >> 15 == 1 {
            held.clear();
        }
        if let Some(first) = list.first_mut() {
            *first += shift;
        }
        let count = list.len();
        let at = |entry: usize| if entry / count == entry % count { stiffness } else { coupling };
        let matrix: Vec<f64> = (0..count * count).map(at).collect();
        let given = (
            Numbers::new(&list, self.is_wide),
            Numbers::new(&held, self.is_wide),
            Guarded::new(&matrix),
            Guarded::new(&vec![residual; count]),
        );
        let found = Guarded::new(&vec![-77.0; count]);
        let user = Placed { context: self.context, fault, width: self.mesh.dim };
        let view = coords.view;
        // SAFETY: arrays of the lengths that are said, structs of the header, and a function that keeps to its contract or not.
        unsafe {
            let mut options = std::mem::MaybeUninit::<fmc_contact_step_options>::zeroed().assume_init();
            let mut result = std::mem::MaybeUninit::<fmc_contact_step_result>::zeroed().assume_init();
            assert_eq!(checked(fmc_contact_step_options_init(&raw mut options)), OK);
            (options.tolerance, options.max_iterations, options.soft_start) =
                (tolerance, 12, i32::from(which & 1 == 1));
            let status = fmc_context_contact_step(
                self.context,
                unless(hole, 0, (&raw const view).cast_mut()),
                unless(hole, 1, &raw mut options),
                unless(hole, 2, given.0.ptr()),
                count,
                unless(hole, 3, given.1.ptr()),
                held.len(),
                unless(hole, 4, given.2.ptr()),
                unless(hole, 5, given.3.ptr()),
                if fault == Fault::None { None } else { Some(place) },
                (&raw const user).cast_mut().cast(),
                unless(hole, 6, found.ptr()),
                unless(hole, 7, &raw mut result),
            );
            if checked(status) == OK {
                assert!(found.values().iter().all(|d| d.is_finite()));
                assert!(hole == 7 || (0..=2).contains(&result.state) && result.residual.is_finite());
            } else {
                assert!(found.values().iter().all(|d| *d == -77.0) && result.struct_size == 0);
            }
        }
    }
}
