//! A host that makes the calls of a program, and does not believe what it is told.
//!
//! After every call: a status that exists and is no panic; outputs untouched where it is an error; finite numbers where it
//! is none, the same bits when asked again, and nothing written beside the entries asked for.

mod array;
mod augment;
mod callbacks;
mod contact_step;
mod creation;
mod equilibrium;
mod evaluation;
mod fields;
mod flux;
mod friction;
mod getters;
mod gradients;
mod numbers;
mod obstacles;
mod options;
mod pairs;
mod ranks;
mod reference;
mod stateless;
mod tangent;

pub(crate) use array::{Array, checked, unless};
pub(crate) use callbacks::{echo, to_itself};
pub(crate) use creation::{cell_size, create};
pub(crate) use numbers::Numbers;

use crate::condensation;
use crate::in_parts;
use crate::interface::*;
use crate::mesh::Mesh;
use crate::program::{Call, MOST_CALLS, Program};
use callbacks::{Distance, go_on, log};
use obstacles::pose;
use options::options;
use stateless::{suggest, texts};

/// The host's state.
struct Host {
    context: *mut fmc_context,
    mesh: Mesh,
    options: fmc_options,
    /// Width of the context's numbers.
    is_wide: bool,
    // Boxes, as the library keeps their addresses.
    #[allow(clippy::vec_box)]
    distances: Vec<Box<Distance>>,
    /// A callback may change its mind from call to call only if it is wrong.
    is_steady: bool,
}

/// Runs a program from the first call to the last.
pub fn run(program: &Program) {
    let options = options(&program.options, program.mesh.is_ordinary());
    let Some(context) = create(&program.mesh, program.is_wide, &options) else { return };
    let mut host = Host {
        context,
        mesh: program.mesh.clone(),
        options,
        is_wide: program.is_wide,
        distances: Vec::new(),
        is_steady: true,
    };
    for call in program.calls.iter().take(MOST_CALLS) {
        host.make(call);
    }
    // SAFETY: the context is the host's own; the second time it is NULL.
    unsafe {
        assert_eq!(fmc_context_free(&raw mut host.context), OK);
        assert!(host.context.is_null());
        assert_eq!(fmc_context_free(&raw mut host.context), OK);
    }
}

impl Host {
    fn make(&mut self, call: &Call) {
        match call {
            Call::Evaluate { read, write, add, hole } => self.evaluate(*read, *write, *add, *hole),
            Call::Tangent { read, flags, hole } => self.tangent(*read, *flags, *hole),
            Call::Rows { read, flags, hole } => self.rows(*read, *flags, *hole),
            Call::KeepPattern { keep } => {
                // SAFETY: the host's own context.
                let status = checked(unsafe { fmc_context_keep_pattern(self.context, i32::from(*keep % 3)) });
                assert_eq!(status == OK, keep % 3 < 2);
                // SAFETY: as above.
                let on = i32::from(*keep / 3 % 3);
                assert_eq!(checked(unsafe { fmc_context_set_obstacle_rotations(self.context, on) }) == OK, on < 2);
            }
            Call::Share { rank, size, fails, hole } => self.share(i32::from(*rank), i32::from(*size), *fails, *hole),
            Call::InParts { reach, hole } => in_parts::beside_the_whole(&self.mesh, &self.options, reach.0, *hole),
            Call::StableStep { mass, hole } => {
                self.stable_step(mass.0, *hole);
                self.step_limit(mass.0, *hole);
                self.adjust(mass.0, *hole);
                self.equilibrium(mass.0, *hole);
            }
            Call::ContactStep { which, shift, stiffness, coupling, residual, tolerance, fault, hole } => {
                let numbers = [stiffness.0, coupling.0, residual.0, tolerance.0];
                self.contact_step(*which, i64::from(*shift), numbers, *fault, *hole);
            }
            Call::Condensation { which, shift, value, hole } => condensation::chain(*which, *shift, value.0, *hole),
            Call::Fields { read, hole } => {
                self.fields(*read, *hole);
                self.gradients(*read, *hole);
            }
            Call::Augment { reach, enough, damage, hole } => self.augment(reach.0, enough.0, damage.0, *hole),
            Call::Gaps { reach, hole } => {
                self.gaps(reach.0, *hole);
                self.ties(*hole);
                self.flux(reach.0, reach.0, *hole);
                self.cohesive(*hole);
                self.law_points(*hole);
            }
            Call::KeepPatches { forget, hole } => self.keep_patches(*forget, *hole),
            Call::SetOptions(from) => self.set_options(&options(from, self.mesh.is_ordinary())),
            Call::SetByName { key, value } => self.set_by_name(*key, value),
            Call::AddObstacle { shape, pose: place, hole } => {
                let place = place.as_ref().map(|place| pose(place, self.mesh.dim));
                self.add(shape, place, *hole);
            }
            Call::SetPose { obstacle, pose: place } => {
                let place = pose(place, self.mesh.dim);
                // SAFETY: the host's own context and pose.
                checked(unsafe { fmc_context_set_pose(self.context, *obstacle as usize % 4, &place) });
            }
            Call::RemoveObstacle { obstacle, hole } => self.remove(usize::from(obstacle % 4), *hole),
            Call::SetPair { options, hole } => self.set_pair(options, *hole),
            Call::Move { node, axis, to } => {
                let place = *node as usize % self.mesh.node_count() * self.mesh.dim + *axis as usize % self.mesh.dim;
                // Lines are few while all is ordinary, or counted.
                if to.is_ordinary() || self.options.spacing == 0.0 {
                    self.mesh.coords[place] = to.0;
                }
            }
            Call::Getters { index, hole } => self.getters(*index as usize % 5, *hole),
            Call::SetLog { calls_back } => {
                let callback: fmc_log_callback = if *calls_back { Some(log) } else { None };
                // SAFETY: the callback asks the context that calls it.
                checked(unsafe { fmc_context_set_log(self.context, callback, self.context.cast()) });
                let asked: fmc_interrupt_callback = if *calls_back { Some(go_on) } else { None };
                // SAFETY: so does this one.
                checked(unsafe { fmc_context_set_interrupt(self.context, asked, self.context.cast()) });
            }
            Call::Stateless { hole } => self.stateless(*hole),
            Call::FromFacets { facets, types: [one, other], is_wide } if one % 2 == 1 => {
                self.from_facet_blocks(facets, [one / 2, *other], *is_wide);
            }
            Call::FromFacets { facets, is_wide, .. } => self.from_facets(facets, *is_wide),
            Call::Suggest { dim, values } => suggest(i32::from(*dim % 5), values.map(|x| x.0)),
            Call::Texts { status, feature } => texts(*status, feature),
            Call::SetReference { read, factor, hole } => self.set_reference(*read, factor.0, *hole),
            Call::Step { what, read, value, hole } => self.step(*what, *read, value.0, *hole),
            Call::SetSymmetryNodes { nodes, hole } => self.set_symmetry_nodes(nodes, *hole),
        }
    }
}
