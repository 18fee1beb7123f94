//! The C functions called as C calls them, where a C program could not look.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::last_error::fmc_last_error;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::*;
use crate::capi::calls::evaluation::evaluate::fmc_context_evaluate;
use crate::capi::calls::mesh::creation::fmc_context_new_from_cells;
use crate::capi::calls::mesh::release::fmc_context_free;
use crate::capi::calls::results::getters::fmc_context_body_resultant;
use crate::capi::context::session::{Counts, Session};
use crate::capi::context::state::{State, fmc_context};
use crate::capi::structs::boundary_facet::fmc_boundary_facet;
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::evaluation::{Evaluation, fmc_result, fmc_resultant};
use crate::capi::structs::gap_constraint::KeptGaps;
use crate::capi::structs::in_parts::InParts;
use crate::capi::structs::kept_tangent::Kept;
use crate::capi::structs::mesh::{fmc_cell_block, fmc_cell_type};
use crate::capi::structs::multiplier::fmc_multiplier;
use crate::capi::structs::nodal_lists::NodalLists;
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::placement::Placement;
use crate::capi::structs::pose::fmc_pose;
use crate::capi::structs::shape::fmc_shape;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use crate::contact::{
    Augmentation, CondensedBodies, ContactStep, ContactStepOptions, ContactStepState, NodalContact, PairOptions,
    TangentPart,
};
use crate::overlap::Partner;
use crate::{
    Basis, Bodies, CellBlock, CellType, Communicator, EnergyLaw, Options, PointWeights, RankCounts, ShapeKind,
    contact_force,
};
use std::ffi::CStr;
use std::ptr::{null, null_mut};

const COORDS: [[f64; 2]; 8] =
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.9, -0.2], [1.9, -0.1], [1.8, 0.9], [0.8, 0.8]];
const CONN: [i32; 8] = [0, 1, 2, 3, 4, 5, 6, 7];

fn view() -> fmc_coords {
    fmc_coords { data: COORDS.as_ptr().cast(), node_count: 8, node_stride: 2, axis_stride: 1 }
}

/// Evaluates at [`COORDS`] and gives the status, the forces and what else was found.
fn evaluate(context: *mut fmc_context) -> (fmc_status, [[f64; 2]; 8], fmc_result) {
    let (mut forces, mut result) = ([[7.0; 2]; 8], fmc_result::default());
    let output = fmc_forces { data: forces.as_mut_ptr().cast(), node_count: 8, node_stride: 2, axis_stride: 1 };
    // SAFETY: a living context, views of arrays of eight nodes, and a result.
    let status = unsafe { fmc_context_evaluate(context, &view(), &output, 0, &mut result) };
    (status, forces, result)
}

#[test]
fn forces_are_those_of_the_rust_api_to_the_bit() {
    let conn = CONN.as_ptr().cast();
    let block = fmc_cell_block { cell_type: fmc_cell_type::FMC_QUAD4 as i32, index_size: 4, conn, cell_count: 2 };
    let options =
        fmc_options { law: 0, estimator: 0, stiffness: 1e3, exponent: 2.0, seed: 5, ..fmc_options::default() };
    let mut context = null_mut();
    // SAFETY: all arguments live through the call.
    let status = unsafe { fmc_context_new_from_cells(2, &view(), &block, 1, null(), &options, &mut context) };
    assert_eq!(status, FMC_OK);
    let (status, forces, result) = evaluate(context);
    assert_eq!(status, FMC_OK);

    let conn = CONN.map(|node| node as u32);
    let block = CellBlock { cell_type: CellType::Quad4, conn: &conn };
    let mut expected = Options::new(EnergyLaw::Volume { stiffness: 1e3, exponent: 2.0 });
    expected.estimator = crate::Estimator::Fibers(crate::FiberOptions { seed: 5, ..crate::FiberOptions::default() });
    let expected = contact_force(&COORDS, &[block], Bodies::Connected, &expected).unwrap();
    assert!(expected.volume > 0.0);
    assert_eq!(forces.as_slice(), expected.forces);
    assert_eq!((result.volume, result.energy), (expected.volume, expected.energy));
    assert_eq!((result.fiber_count, result.crossing_count), (expected.fiber_count, expected.crossing_count));

    let zero = [0.0; 3];
    let mut body = fmc_resultant {
        struct_size: 0,
        id: -1,
        force: zero,
        moment: zero,
        node_count: 0,
        friction: zero,
        reserved: [0; 4],
    };
    // SAFETY: a living context and an output.
    assert_eq!(unsafe { fmc_context_body_resultant(context, 1, &mut body) }, FMC_OK);
    assert_eq!((body.id, body.force[0], body.force[2]), (1, expected.bodies[1].force[0], 0.0));
    // SAFETY: the context is freed once.
    assert_eq!(unsafe { fmc_context_free(&mut context) }, FMC_OK);
    assert!(context.is_null());
}

/// A mesh whose evaluation panics the first time.
struct Brittle {
    broken: bool,
}

impl Session for Brittle {
    fn parts(&self) -> Option<&dyn InParts> {
        None
    }

    fn parts_mut(&mut self) -> Option<&mut dyn InParts> {
        None
    }

    fn counts(&self) -> Counts {
        Counts { nodes: 8, unknowns: 8, facets: 8, bodies: 2 }
    }

    fn boundary_facets(&self, _: i32) -> Vec<fmc_boundary_facet> {
        Vec::new()
    }

    fn point_weights(&self) -> PointWeights {
        PointWeights::default()
    }
    fn set_basis(&mut self, _: Option<&Basis>) -> Result<(), Failure> {
        panic!("a basis")
    }

    fn set_options(&mut self, _: Options) -> Result<(), Failure> {
        Ok(())
    }

    fn stiffness(&self) -> f64 {
        1.0
    }

    fn set_pose(&mut self, _: usize, _: fmc_pose) -> Result<(), Failure> {
        Ok(())
    }

    fn remove_obstacle(&mut self, _: usize) -> Result<(), Failure> {
        Ok(())
    }

    fn obstacle(&self, _: usize) -> Result<(ShapeKind, fmc_pose), Failure> {
        Ok((ShapeKind::HALF_SPACE, fmc_pose::default()))
    }

    fn set_pair_options(&mut self, _: [Partner; 2], _: Option<PairOptions>) -> Result<(), Failure> {
        Ok(())
    }

    fn pair_options(&self, _: [Partner; 2]) -> Result<PairOptions, Failure> {
        Ok(PairOptions::default())
    }

    unsafe fn add_obstacle(&mut self, _: &fmc_shape, _: fmc_pose, _: i32) -> Result<usize, Failure> {
        Ok(0)
    }

    unsafe fn set_reference(&mut self, _: &fmc_coords, _: i32) -> Result<(), Failure> {
        Ok(())
    }

    fn set_symmetry_nodes(&mut self, _: &[i64], _: i32) -> Result<(), Failure> {
        Ok(())
    }

    unsafe fn begin_step(&mut self, _: &fmc_coords, _: i32) -> Result<(), Failure> {
        Ok(())
    }

    unsafe fn commit_step(&mut self, _: &fmc_coords, _: i32) -> Result<(), Failure> {
        Ok(())
    }

    unsafe fn freeze_friction(&mut self, _: Option<&fmc_coords>, _: i32) -> Result<(), Failure> {
        Ok(())
    }

    fn slip(&self) -> Result<&[f64], Failure> {
        Ok(&[])
    }

    fn set_slip(&mut self, _: &[f64]) -> Result<(), Failure> {
        Ok(())
    }

    fn set_communicator(&mut self, _: Option<Box<dyn Communicator>>) -> Result<(), Failure> {
        Ok(())
    }

    fn rank_counts(&self) -> RankCounts {
        RankCounts::default()
    }

    fn set_obstacle_rotations(&mut self, _: bool) {}

    unsafe fn augment(&mut self, _: &fmc_coords, _: f64, _: f64, _: i32) -> Result<Augmentation, Failure> {
        panic!("an update")
    }

    fn stiffen(&mut self, _: f64) -> Result<(), Failure> {
        Ok(())
    }

    fn multipliers(&self, _: i32) -> Vec<fmc_multiplier> {
        Vec::new()
    }

    fn set_multipliers(&mut self, _: &[fmc_multiplier], _: i32) -> Result<(), Failure> {
        Ok(())
    }

    unsafe fn keep_patches(&mut self, _: Option<&fmc_coords>, _: i32) -> Result<usize, Failure> {
        Ok(0)
    }

    unsafe fn tangent(&mut self, _: &fmc_coords, _: TangentPart, _: i32) -> Result<Kept, Failure> {
        Ok(Kept::default())
    }

    unsafe fn nodal_contact(&mut self, _: &fmc_coords, _: i32) -> Result<NodalLists, Failure> {
        let (numbers, vectors) = (Vec::new, Vec::new);
        Ok(NodalContact::<2> {
            pressure: numbers(),
            gap: numbers(),
            area: numbers(),
            normal: vectors(),
            friction: vectors(),
            sliding: numbers(),
            status: Vec::new(),
        }
        .into())
    }

    unsafe fn bits(&mut self, _: &fmc_coords) -> Result<Vec<u64>, Failure> {
        Ok(Vec::new())
    }

    unsafe fn contact_points(&mut self, _: &fmc_coords, _: i32) -> Result<Vec<fmc_contact_point>, Failure> {
        Ok(Vec::new())
    }

    unsafe fn gap_constraints(&mut self, _: &fmc_coords, _: f64, _: i32) -> Result<KeptGaps, Failure> {
        Ok(KeptGaps::default())
    }

    fn contact_mut(&mut self) -> Result<&mut dyn std::any::Any, Failure> {
        panic!("no contact")
    }

    unsafe fn step_limit(
        &mut self,
        _: &fmc_coords,
        _: &fmc_coords,
        _: i32,
    ) -> Result<crate::contact::equilibrium::StepLimit, Failure> {
        panic!("no limit")
    }

    unsafe fn stable_step(&mut self, _: &fmc_coords, _: &[f64], _: i32) -> Result<f64, Failure> {
        Ok(f64::INFINITY)
    }

    unsafe fn contact_step(
        &mut self,
        _: &fmc_coords,
        bodies: &CondensedBodies,
        _: &ContactStepOptions,
        _: Option<Placement>,
        _: i32,
    ) -> Result<ContactStep, Failure> {
        Ok(ContactStep {
            displacement: vec![0.0; bodies.dofs.len()],
            state: ContactStepState::Converged,
            iterations: 0,
            evaluations: 0,
            residual_at_start: 0.0,
            residual: 0.0,
            scale: 0.0,
            outside: 0,
        })
    }

    unsafe fn evaluate_tangent(
        &mut self,
        _: &fmc_coords,
        _: TangentPart,
        _: Option<&fmc_forces>,
        _: bool,
        _: i32,
    ) -> Result<(Evaluation, Kept), Failure> {
        Ok((Evaluation::default(), Kept::default()))
    }

    unsafe fn evaluate(
        &mut self,
        _: &fmc_coords,
        _: Option<&fmc_forces>,
        _: bool,
        _: i32,
    ) -> Result<Evaluation, Failure> {
        assert!(std::mem::replace(&mut self.broken, true), "facet 3 is lost");
        Ok(Evaluation::default())
    }
}

#[test]
fn a_context_survives_a_panic() {
    let state = State::new(Box::new(Brittle { broken: false }), IndexSize::Four, &fmc_options::default());
    let mut context = Box::into_raw(Box::new(fmc_context::new(state)));
    let (status, forces, result) = evaluate(context);
    assert_eq!((status, forces, result), (FMC_ERROR_PANIC, [[7.0; 2]; 8], fmc_result::default()));
    // SAFETY: a living context; the text lives as long as it and is not replaced meanwhile.
    let text = unsafe { CStr::from_ptr(fmc_last_error()) };
    assert!(text.to_str().is_ok_and(|text| text.ends_with(": facet 3 is lost")), "{text:?}");
    assert_eq!(evaluate(context).0, FMC_OK);
    // SAFETY: made above in the way of `fmc_context_new_from_cells`, and freed once.
    assert_eq!(unsafe { fmc_context_free(&mut context) }, FMC_OK);
}

#[test]
fn concurrent_calls_return_busy() {
    let session = Box::new(Brittle { broken: true });
    let context = fmc_context::new(State::new(session, IndexSize::Four, &fmc_options::default()));
    let pointer = (&raw const context).cast_mut();
    {
        // SAFETY: a living context.
        let _reading = unsafe { crate::capi::context::state::read(pointer) }.unwrap();
        assert_eq!(evaluate(pointer).0, FMC_ERROR_BUSY);
        // SAFETY: a living context; readers do not exclude one another.
        assert!(unsafe { crate::capi::context::state::read(pointer) }.is_ok());
    }
    assert_eq!(evaluate(pointer).0, FMC_OK);
}
