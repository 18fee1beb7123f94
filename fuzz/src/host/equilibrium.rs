//! Searches for an equilibrium that are begun, and left after a few answers; and limits of steps.

use super::Host;
use super::array::{Array, CANARY, checked, is_null, unless};
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

/// Answers before a search is left.
const ANSWERS: usize = 4;

impl Host {
    /// How far all nodes may go by a number.
    pub(super) fn step_limit(&mut self, number: f64, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let way: Vec<f64> = self.mesh.coords.iter().map(|_| number).collect();
        let step = Array::new(&way, self.mesh.dim, Layout::Rows);
        let (at, along) = (coords.view, step.view);
        // SAFETY: views of all nodes, and a struct of the header.
        unsafe {
            let mut limit = MaybeUninit::<fmc_step_limit>::zeroed().assume_init();
            let status = fmc_context_step_limit(
                self.context,
                unless(hole, 0, (&raw const at).cast_mut()),
                unless(hole, 1, (&raw const along).cast_mut()),
                unless(hole, 2, &raw mut limit),
            );
            if checked(status) == OK {
                assert!((0.0..=1.0).contains(&limit.part) && limit.first_touch >= 0.0);
            } else {
                assert_eq!(limit.struct_size, 0);
            }
        }
    }

    /// Gaps and overlaps up to a number; surfaces then go back.
    pub(super) fn adjust(&mut self, number: f64, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let at = coords.view;
        // SAFETY: views of all nodes, a struct of the header, and room for as many numbers as were told.
        unsafe {
            let mut found = MaybeUninit::<fmc_adjustment>::zeroed().assume_init();
            let status = fmc_context_adjust(
                self.context,
                unless(hole, 0, (&raw const at).cast_mut()),
                number,
                number,
                &raw mut found,
            );
            if checked(status) == OK {
                let most = 1.001 * number;
                assert!(found.closed <= most && found.removed <= most && found.left >= 0.0);
            } else {
                assert_eq!(found.struct_size, 0);
            }
            let mut count = 0;
            if checked(fmc_context_offsets(self.context, null_mut(), 0, &raw mut count)) == OK && count > 0 {
                let kept = Guarded::new(&vec![0.0; count]);
                assert_eq!(checked(fmc_context_offsets(self.context, kept.ptr(), count, &raw mut count)), OK);
                assert_eq!(checked(fmc_context_set_offsets(self.context, kept.ptr(), count)), OK);
                assert!(count == 1 || checked(fmc_context_set_offsets(self.context, kept.ptr(), count - 1)) != OK);
            }
            checked(fmc_context_set_offsets(self.context, null_mut(), 0));
        }
    }

    /// A host of springs, one for every coordinate, whose stiffness is a number.
    pub(super) fn equilibrium(&mut self, number: f64, hole: Hole) {
        let count = self.mesh.node_count() * self.mesh.dim;
        let given = (
            Numbers::new(&(0..count as i64).collect::<Vec<_>>(), self.is_wide),
            Guarded::new(&self.mesh.coords),
            Guarded::new(&vec![1u8; count]),
            Guarded::new(&vec![0.0; count]),
        );
        let numbers = Guarded::new(&vec![number; count]);
        // SAFETY: arrays of the lengths that are said, and structs of the header.
        unsafe {
            let mut problem = MaybeUninit::<fmc_equilibrium_problem>::zeroed().assume_init();
            let mut options = MaybeUninit::<fmc_equilibrium_options>::zeroed().assume_init();
            let mut answer = MaybeUninit::<fmc_equilibrium_answer>::zeroed().assume_init();
            let mut request = MaybeUninit::<fmc_equilibrium_request>::zeroed().assume_init();
            let mut result = MaybeUninit::<fmc_equilibrium_result>::zeroed().assume_init();
            assert_eq!(checked(fmc_equilibrium_problem_init(&raw mut problem)), OK);
            assert_eq!(checked(fmc_equilibrium_options_init(&raw mut options)), OK);
            assert_eq!(checked(fmc_equilibrium_answer_init(&raw mut answer)), OK);
            (problem.unknown_count, problem.row_count) = (count, self.mesh.node_count());
            problem.unknown_of_coordinate = unless(hole, 0, given.0.ptr()).cast_const();
            problem.base = unless(hole, 1, given.1.ptr()).cast_const();
            problem.free = unless(hole, 2, given.2.ptr()).cast_const();
            problem.x = unless(hole, 3, given.3.ptr()).cast_const();
            self.adjoint(&raw const problem, given.3.ptr(), count, hole);
            let mut search = null_mut();
            let status = fmc_equilibrium_new(
                self.context,
                &raw const problem,
                unless(hole, 4, &raw mut options),
                &raw mut search,
            );
            if checked(status) != OK {
                assert!(search.is_null());
                return;
            }
            let mut status = fmc_equilibrium_next(self.context, search, null(), unless(hole, 5, &raw mut request));
            for _ in 0..ANSWERS {
                if checked(status) != OK {
                    break;
                }
                answer.vector = unless(hole, 6, numbers.ptr()).cast_const();
                status = fmc_equilibrium_next(self.context, search, &raw const answer, &raw mut request);
            }
            let is_abandoned = checked(fmc_equilibrium_abandon(unless(hole, 9, self.context), search)) == OK;
            let is_ended = checked(fmc_equilibrium_found(search, unless(hole, 7, &raw mut result))) == OK;
            assert!(is_ended || !is_abandoned || is_null(hole, 7));
            if is_ended {
                assert!((0..result.text_count).all(|k| !fmc_equilibrium_text(search, k).is_null()));
            }
            assert!(fmc_equilibrium_text(search, usize::MAX).is_null());
            assert_eq!(checked(fmc_equilibrium_free(&raw mut search)), OK);
            assert!(search.is_null() && checked(fmc_equilibrium_free(&raw mut search)) == OK);
        }
    }

    /// The adjoint there, with the state for factors and for what solves its system; what is refused writes nothing.
    unsafe fn adjoint(&mut self, problem: *const fmc_equilibrium_problem, state: *mut f64, count: usize, hole: Hole) {
        let right = Guarded::new(&vec![f64::from_bits(CANARY); count]);
        // SAFETY: as in `equilibrium`; the state has a number for every unknown.
        unsafe {
            let mut to = MaybeUninit::<fmc_gradients>::zeroed().assume_init();
            let mut pair_count = 77usize;
            assert_eq!(checked(fmc_gradients_init(&raw mut to)), OK);
            to.of_pairs = FMC_GRADIENT_STIFFNESS as u64;
            let by_x = unless(hole, 8, state).cast_const();
            let status = fmc_equilibrium_adjoint(
                self.context,
                problem,
                by_x,
                null(),
                state.cast_const(),
                right.ptr(),
                null(),
                null_mut(),
                0,
                &raw mut pair_count,
            );
            let is_ok = checked(status) == OK;
            assert!(right.values().iter().all(|x| (x.to_bits() != CANARY) == is_ok));
            assert_eq!(pair_count, if is_ok { 0 } else { 77 });
            let status = fmc_equilibrium_adjoint(
                self.context,
                problem,
                by_x,
                null(),
                state.cast_const(),
                null_mut(),
                &raw const to,
                null_mut(),
                0,
                &raw mut pair_count,
            );
            checked(status);
        }
    }
}
