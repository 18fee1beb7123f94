//! What a context tells of itself.

use super::Host;
use super::array::{CANARY, checked, unless};
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::Hole;
use std::ffi::CStr;
use std::ptr::{null, null_mut};

impl Host {
    pub(super) fn getters(&self, index: usize, hole: Hole) {
        let mut resultant = fmc_resultant {
            struct_size: 77,
            id: 77,
            force: [0.5; 3],
            moment: [0.5; 3],
            node_count: 77,
            friction: [0.5; 3],
            reserved: [7; 4],
        };
        let untouched = resultant;
        let mut pair = std::mem::MaybeUninit::<fmc_pair_result>::zeroed();
        let (mut code, mut text) = (0, null());
        let mut counts = [0usize; 3];
        // SAFETY: outputs that may be written.
        unsafe {
            let status = checked(fmc_context_body_resultant(self.context, index, unless(hole, 0, &raw mut resultant)));
            assert!(status == OK || resultant == untouched);
            let mut resultant = untouched;
            let status =
                checked(fmc_context_obstacle_resultant(self.context, index, unless(hole, 1, &raw mut resultant)));
            assert!(status == OK || resultant == untouched);
            let status = checked(fmc_context_pair_result(self.context, index, unless(hole, 2, pair.as_mut_ptr())));
            let pair = pair.assume_init();
            assert!(if status == OK {
                pair.struct_size == size_of::<fmc_pair_result>()
            } else {
                pair.struct_size == 0
            });
            if checked(fmc_context_warning(self.context, index, &raw mut code, unless(hole, 3, &raw mut text))) == OK
                && hole != 4
            {
                assert!((1..=6).contains(&code) && !CStr::from_ptr(text).to_bytes().is_empty());
            }
            let [nodes, facets, bodies] = &mut counts;
            assert_eq!(checked(fmc_context_counts(self.context, nodes, facets, unless(hole, 4, bodies))), OK);
            assert_eq!(counts[0], self.mesh.node_count());
            let mut welded = 1usize;
            assert_eq!(checked(fmc_context_welded_node_count(self.context, &raw mut welded)), OK);
            assert_eq!(welded, 0);
            let mut options = std::mem::MaybeUninit::<fmc_options>::zeroed().assume_init();
            assert_eq!(checked(fmc_context_options(self.context, &raw mut options)), OK);
            assert_eq!(options.struct_size, size_of::<fmc_options>());
            let blank = std::mem::MaybeUninit::<fmc_boundary_facet>::zeroed().assume_init();
            let found = Guarded::new(&vec![blank; counts[1]]);
            assert_ne!(checked(fmc_context_boundary_facets(self.context, found.ptr(), counts[1] - 1, null_mut())), OK);
            let target = unless(hole, 2, found.ptr());
            let is_wanted = !target.is_null();
            let status = checked(fmc_context_boundary_facets(self.context, target, counts[1], null_mut()));
            assert_eq!(status == OK, is_wanted);
            let size = if is_wanted { size_of::<fmc_boundary_facet>() } else { 0 };
            assert!(found.values().iter().all(|facet| facet.struct_size == size));
            let weights = self.point_weights(hole);
            let named = found.values().into_iter().flat_map(|facet| facet.nodes);
            let points = weights + i64::from(self.options.index_base);
            assert!(!is_wanted || named.into_iter().all(|point| (-1..points).contains(&point)));
            CStr::from_ptr(fmc_last_error()).to_str().expect("UTF-8");
        }
    }

    /// Points as combinations of nodes; returns their number.
    fn point_weights(&self, hole: Hole) -> i64 {
        let (mut offset_count, mut entries) = (77usize, 77usize);
        // SAFETY: outputs that may be written, with room for as much as is said.
        unsafe {
            let context = unless(hole, 6, self.context).cast_const();
            let none = null_mut();
            let (offsets_at, entries_at) = (&raw mut offset_count, &raw mut entries);
            let no_weights = null_mut();
            let status = fmc_context_point_weights(context, none, 0, offsets_at, none, no_weights, 0, entries_at);
            if checked(status) != OK {
                assert!(context.is_null() && (offset_count, entries) == (77, 77));
                return i64::MAX / 2;
            }
            let points = offset_count - 1;
            let list = |length: usize| Numbers::new(&vec![-7; length], self.is_wide);
            let (offsets, nodes) = (list(offset_count), list(entries));
            let weights = Guarded::new(&vec![CANARY; entries]);
            let at = |offsets, nodes, rows: usize, entries: usize| {
                let (weights, none) = (weights.ptr().cast(), null_mut());
                checked(fmc_context_point_weights(context, offsets, rows, none, nodes, weights, entries, none))
            };
            assert_ne!(at(offsets.ptr(), nodes.ptr(), points, entries), OK);
            assert_ne!(at(offsets.ptr(), nodes.ptr(), points + 1, entries - 1), OK);
            assert_ne!(at(null_mut(), nodes.ptr(), points + 1, entries), OK);
            assert_ne!(at(offsets.ptr(), null_mut(), points + 1, entries), OK);
            assert!(offsets.values().iter().chain(&nodes.values()).all(|&at| at == -7), "an error writes outputs");
            assert_eq!(at(offsets.ptr(), nodes.ptr(), points + 1, entries), OK);
            let base = i64::from(self.options.index_base);
            let (nodes, weights) = (nodes.values(), weights.values());
            let offsets: Vec<i64> = offsets.values().iter().map(|offset| offset - base).collect();
            assert!(points >= self.mesh.node_count() && (offsets[0], offsets[points]) == (0, entries as i64));
            let range = base..self.mesh.node_count() as i64 + base;
            for row in offsets.windows(2) {
                let row = row[0] as usize..row[1] as usize;
                assert!(!row.is_empty() && nodes[row.clone()].iter().all(|node| range.contains(node)));
                let sum: f64 = weights[row].iter().map(|&bits| f64::from_bits(bits)).sum();
                assert!((sum - 1.0).abs() < 1e-12, "{sum}");
            }
            points as i64
        }
    }
}
