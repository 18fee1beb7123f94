//! The C functions called as C calls them, where a C program could not look.

use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::last_error::fmc_last_error;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::*;
use crate::capi::calls::evaluation::evaluate::fmc_context_evaluate;
use crate::capi::calls::mesh::creation::fmc_context_new_from_cells;
use crate::capi::calls::mesh::release::fmc_context_free;
use crate::capi::calls::results::getters::fmc_context_body_resultant;
use crate::capi::context::resident::Resident;
use crate::capi::context::state::{State, fmc_context};
use crate::capi::structs::evaluation::{fmc_result, fmc_resultant};
use crate::capi::structs::law::fmc_law;
use crate::capi::structs::mesh::{fmc_cell_block, fmc_cell_type};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use crate::{Bodies, CellBlock, CellType, EnergyLaw, Obstacle, Options, Pose, Shape, Surface, contact_force};
use std::ffi::CStr;
use std::ptr::{null, null_mut};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

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

/// A square beside an obstacle whose distance panics while `is_broken`.
fn brittle(is_broken: Arc<AtomicBool>) -> fmc_context {
    let block = CellBlock { cell_type: CellType::Quad4, conn: &[0, 1, 2, 3, 4, 5, 6, 7] };
    let surface = Surface::from_cells(&COORDS, &[block], Bodies::Connected).expect("two squares");
    let options = fmc_options { law: fmc_law::FMC_LAW_DEPTH as i32, stiffness: 1.0, ..fmc_options::default() };
    let mut contact = Resident::<2>::new(surface, options.to_options().expect("options")).expect("a contact");
    let distance = move |x: &[f64; 2]| {
        assert!(!is_broken.load(Relaxed), "facet 3 is lost");
        (x[0], [1.0, 0.0])
    };
    let obstacle = Obstacle { shape: Shape::SignedDistance(Arc::new(distance)), pose: Pose::default() };
    contact.contact_mut().expect("a whole mesh").add_obstacle(obstacle).expect("an obstacle");
    fmc_context::new(State::new(contact.into(), IndexSize::Four, &options))
}

#[test]
fn a_context_survives_a_panic() {
    let is_broken = Arc::new(AtomicBool::new(true));
    let mut context = Box::into_raw(Box::new(brittle(Arc::clone(&is_broken))));
    let (status, forces, result) = evaluate(context);
    assert_eq!((status, forces, result), (FMC_ERROR_PANIC, [[7.0; 2]; 8], fmc_result::default()));
    // SAFETY: a living context; the text lives as long as it and is not replaced meanwhile.
    let text = unsafe { CStr::from_ptr(fmc_last_error()) };
    assert!(text.to_str().is_ok_and(|text| text.ends_with(": facet 3 is lost")), "{text:?}");
    is_broken.store(false, Relaxed);
    assert_eq!(evaluate(context).0, FMC_OK);
    // SAFETY: made above in the way of `fmc_context_new_from_cells`, and freed once.
    assert_eq!(unsafe { fmc_context_free(&mut context) }, FMC_OK);
}

#[test]
fn concurrent_calls_return_busy() {
    let context = brittle(Arc::default());
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
