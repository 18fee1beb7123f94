//! `include/fmc_contact.h`, written down for Rust.
//!
//! Generated from the header by `make header`; do not edit.

use std::ffi::{c_char, c_void};

pub type fmc_status = i32;
pub const FMC_ABI_VERSION: i32 = 3;
pub const FMC_LOG_WARNING: i32 = 1;
pub const FMC_PAIR_LAW_OF_CONTEXT: i32 = -1;
pub const FMC_PAIR_FRICTION_OF_CONTEXT: i32 = -1;
pub const FMC_EVALUATE_ADD: u32 = 1;
pub const FMC_TANGENT_SEMIDEFINITE: u32 = 2;
pub const FMC_TANGENT_SYMMETRIC: u32 = 32;
pub const FMC_CSR_BLOCKS: u32 = 4;
pub const FMC_CSR_OBSTACLES: u32 = 8;
pub const FMC_GRADIENT_STIFFNESS: i32 = 1;
pub const FMC_GRADIENT_GAP_OFFSET: i32 = 2;
pub const FMC_GRADIENT_FRICTION: i32 = 4;
pub const FMC_OK: i32 = 0;
pub const FMC_ERROR_NULL_POINTER: i32 = 1;
pub const FMC_ERROR_MISALIGNED_POINTER: i32 = 2;
pub const FMC_ERROR_LENGTH: i32 = 3;
pub const FMC_ERROR_BUFFER_TOO_SMALL: i32 = 4;
pub const FMC_ERROR_STRIDE: i32 = 5;
pub const FMC_ERROR_DIMENSION: i32 = 6;
pub const FMC_ERROR_UNKNOWN_CELL_TYPE: i32 = 7;
pub const FMC_ERROR_NODE_OUT_OF_RANGE: i32 = 8;
pub const FMC_ERROR_NON_FINITE_COORDINATE: i32 = 9;
pub const FMC_ERROR_REPEATED_NODE: i32 = 10;
pub const FMC_ERROR_INVERTED_CELL: i32 = 11;
pub const FMC_ERROR_ZERO_MEASURE: i32 = 12;
pub const FMC_ERROR_OPEN_SURFACE: i32 = 13;
pub const FMC_ERROR_NON_MANIFOLD: i32 = 14;
pub const FMC_ERROR_INCONSISTENT_ORIENTATION: i32 = 15;
pub const FMC_ERROR_INVERTED_SURFACE: i32 = 16;
pub const FMC_ERROR_EMPTY: i32 = 17;
pub const FMC_ERROR_NOT_POSITIVE: i32 = 18;
pub const FMC_ERROR_UNKNOWN_OPTION: i32 = 19;
pub const FMC_ERROR_STRUCT_SIZE: i32 = 20;
pub const FMC_ERROR_BAD_POSE: i32 = 21;
pub const FMC_ERROR_OBSTACLE_OUT_OF_RANGE: i32 = 22;
pub const FMC_ERROR_INDEX_OUT_OF_RANGE: i32 = 23;
pub const FMC_ERROR_UNSUPPORTED: i32 = 24;
pub const FMC_ERROR_SIGNED_DISTANCE: i32 = 25;
pub const FMC_ERROR_TOO_MANY_FIBERS: i32 = 26;
pub const FMC_ERROR_THREADS: i32 = 27;
pub const FMC_ERROR_BUSY: i32 = 28;
pub const FMC_ERROR_OVERFLOW: i32 = 29;
pub const FMC_ERROR_PANIC: i32 = 30;
pub const FMC_ERROR_DEGENERATE_HULL: i32 = 31;
pub const FMC_ERROR_TOO_FEW_HEIGHTS: i32 = 32;
pub const FMC_ERROR_NON_FINITE_HEIGHT: i32 = 33;
pub const FMC_ERROR_EMPTY_COMPOUND: i32 = 34;
pub const FMC_ERROR_NOT_POSITIVE_MASS: i32 = 35;
pub const FMC_ERROR_BODY_OUT_OF_RANGE: i32 = 36;
pub const FMC_ERROR_OBSTACLE_REMOVED: i32 = 37;
pub const FMC_ERROR_TOO_MANY_PIECES: i32 = 38;
pub const FMC_ERROR_UNFINISHED_LINES: i32 = 39;
pub const FMC_ERROR_NO_STEP: i32 = 40;
pub const FMC_ERROR_NON_FINITE_SLIP: i32 = 41;
pub const FMC_ERROR_NEGATIVE_RADIUS: i32 = 42;
pub const FMC_ERROR_NON_CONFORMING: i32 = 43;
pub const FMC_ERROR_SINGULAR_STIFFNESS: i32 = 44;
pub const FMC_ERROR_INDEFINITE_STIFFNESS: i32 = 45;
pub const FMC_ERROR_DOF_OUT_OF_RANGE: i32 = 46;
pub const FMC_ERROR_REPEATED_DOF: i32 = 47;
pub const FMC_ERROR_NON_FINITE_STIFFNESS: i32 = 48;
pub const FMC_ERROR_PLACE: i32 = 49;
pub const FMC_ERROR_BAD_RANK: i32 = 50;
pub const FMC_ERROR_COMMUNICATION: i32 = 51;
pub const FMC_ERROR_ON_OTHER_RANK: i32 = 52;
pub const FMC_ERROR_RANKS_DIFFER: i32 = 53;
pub const FMC_ERROR_NOT_GATHERED: i32 = 54;
pub const FMC_ERROR_NOT_POSITIVE_DEFINITE: i32 = 55;
pub const FMC_ERROR_UNSYMMETRIC: i32 = 56;
pub const FMC_ERROR_NOT_FACTORISED: i32 = 57;
pub const FMC_ERROR_INDEX_SIZE: i32 = 58;
pub const FMC_ERROR_BAD_VALUE: i32 = 59;
pub const FMC_ERROR_UNKNOWN_FLAG: i32 = 60;
pub const FMC_ERROR_OPTIONS_CONFLICT: i32 = 61;
pub const FMC_ERROR_RESERVED_FIELD: i32 = 62;
pub const FMC_ERROR_NO_STIFFNESS: i32 = 63;
pub const FMC_ERROR_INTERRUPTED: i32 = 64;
pub const FMC_ERROR_MEMORY: i32 = 65;
pub const FMC_ERROR_UNTIED: i32 = 66;
pub const FMC_ERROR_INTERFACE_LAW: i32 = 67;
pub const FMC_CLASS_OK: i32 = 0;
pub const FMC_CLASS_INPUT: i32 = 1;
pub const FMC_CLASS_GEOMETRY: i32 = 2;
pub const FMC_CLASS_NUMERICAL: i32 = 3;
pub const FMC_CLASS_RESOURCE: i32 = 4;
pub const FMC_CLASS_PROTOCOL: i32 = 5;
pub const FMC_CLASS_INTERNAL: i32 = 6;
pub const FMC_LAW_VOLUME: i32 = 0;
pub const FMC_LAW_FIBER: i32 = 1;
pub const FMC_LAW_DEPTH: i32 = 2;
pub const FMC_ESTIMATOR_FIBERS: i32 = 0;
pub const FMC_ESTIMATOR_EXACT: i32 = 1;
pub const FMC_ESTIMATOR_AUTO: i32 = 2;
pub const FMC_PATTERN_LINES: i32 = 0;
pub const FMC_PATTERN_ISOTROPIC: i32 = 1;
pub const FMC_WEIGHTS_BALANCE: i32 = 0;
pub const FMC_WEIGHTS_CONSISTENT: i32 = 1;
pub const FMC_TRI3: i32 = 5;
pub const FMC_QUAD4: i32 = 9;
pub const FMC_TET4: i32 = 10;
pub const FMC_HEX8: i32 = 12;
pub const FMC_WEDGE6: i32 = 13;
pub const FMC_PYRAMID5: i32 = 14;
pub const FMC_TRI6: i32 = 22;
pub const FMC_QUAD8: i32 = 23;
pub const FMC_TET10: i32 = 24;
pub const FMC_HEX20: i32 = 25;
pub const FMC_WEDGE15: i32 = 26;
pub const FMC_PYRAMID13: i32 = 27;
pub const FMC_QUAD9: i32 = 28;
pub const FMC_HEX27: i32 = 29;
pub const FMC_FACET_LINE2: i32 = 3;
pub const FMC_FACET_TRI3: i32 = 5;
pub const FMC_FACET_QUAD4: i32 = 9;
pub const FMC_FACET_LINE3: i32 = 21;
pub const FMC_FACET_TRI6: i32 = 22;
pub const FMC_FACET_QUAD8: i32 = 23;
pub const FMC_FACET_QUAD9: i32 = 28;
pub const FMC_SHAPE_HALF_SPACE: i32 = 0;
pub const FMC_SHAPE_BALL: i32 = 1;
pub const FMC_SHAPE_CUBOID: i32 = 2;
pub const FMC_SHAPE_CYLINDER: i32 = 3;
pub const FMC_SHAPE_CONE: i32 = 4;
pub const FMC_SHAPE_CAPSULE: i32 = 5;
pub const FMC_SHAPE_POLYTOPE: i32 = 6;
pub const FMC_SHAPE_CONVEX_HULL: i32 = 7;
pub const FMC_SHAPE_HEIGHT_FIELD: i32 = 8;
pub const FMC_SHAPE_COMPOUND: i32 = 9;
pub const FMC_SHAPE_SIGNED_DISTANCE: i32 = 10;
pub const FMC_INTERFACE_CONTACT: i32 = 0;
pub const FMC_INTERFACE_TIED: i32 = 1;
pub const FMC_INTERFACE_COHESIVE: i32 = 2;
pub const FMC_INTERFACE_NO_SEPARATION: i32 = 3;
pub const FMC_INTERFACE_ROUGH: i32 = 4;
pub const FMC_INTERFACE_LAW: i32 = 5;
pub const FMC_SOFTENING_LINEAR: i32 = 0;
pub const FMC_SOFTENING_EXPONENTIAL: i32 = 1;
pub const FMC_SOFTENING_PPR: i32 = 2;
pub const FMC_PARTNER_BODY: i32 = 0;
pub const FMC_PARTNER_OBSTACLE: i32 = 1;
pub const FMC_WARNING_COARSE_FIBERS: i32 = 1;
pub const FMC_WARNING_UNRESOLVED_OVERLAP: i32 = 2;
pub const FMC_WARNING_SWALLOWED_BODY: i32 = 3;
pub const FMC_WARNING_PATCH_LEFT_OUT: i32 = 4;
pub const FMC_WARNING_UNBALANCED: i32 = 5;
pub const FMC_WARNING_FLUSH_FACES: i32 = 6;
pub const FMC_WARNING_COINCIDING_FACES: i32 = 7;
pub const FMC_WARNING_GENTLE_DISTANCE: i32 = 8;
pub const FMC_WARNING_CURVED_FACES: i32 = 9;
pub const FMC_WARNING_COARSE_FACES: i32 = 10;
pub const FMC_WARNING_UNUSED_SMOOTHING: i32 = 11;
pub const FMC_WARNING_TIED_IN_PART: i32 = 12;
pub const FMC_WARNING_NO_FRICTION_DIRECTION: i32 = 13;
pub const FMC_WARNING_LARGE_WEAR: i32 = 14;
pub const FMC_REQUEST_FORCES: i32 = 0;
pub const FMC_REQUEST_PRODUCT: i32 = 1;
pub const FMC_REQUEST_DIAGONAL: i32 = 2;
pub const FMC_REQUEST_SOLVE: i32 = 3;
pub const FMC_REQUEST_CONDENSED: i32 = 4;
pub const FMC_REQUEST_FOUND: i32 = 5;
pub const FMC_REQUEST_REFUSED: i32 = 6;
pub const FMC_WAY_NONE: i32 = 0;
pub const FMC_WAY_CONDENSED: i32 = 1;
pub const FMC_WAY_NEAREST: i32 = 2;
pub const FMC_WAY_DOWNHILL: i32 = 3;
pub const FMC_STEP_CONVERGED: i32 = 0;
pub const FMC_STEP_OUTSIDE: i32 = 1;
pub const FMC_STEP_NOT_CONVERGED: i32 = 2;
pub const FMC_NODE_APART: i32 = 0;
pub const FMC_NODE_TOUCHING: i32 = 1;
pub const FMC_NODE_STICKING: i32 = 2;
pub const FMC_NODE_SLIDING: i32 = 3;

#[repr(C)]
pub struct fmc_context {
    _private: [u8; 0],
}

#[repr(C)]
pub struct fmc_equilibrium {
    _private: [u8; 0],
}

#[repr(C)]
pub struct fmc_condensation {
    _private: [u8; 0],
}

pub type fmc_log_callback = Option<unsafe extern "C" fn(user: *mut c_void, level: i32, text: *const c_char)>;

pub type fmc_interrupt_callback = Option<unsafe extern "C" fn(user: *mut c_void) -> i32>;

pub type fmc_signed_distance = Option<unsafe extern "C" fn(user: *mut c_void, n: usize, x: *const f64, phi: *mut f64, grad: *mut f64) -> i32>;

pub type fmc_respond = Option<unsafe extern "C" fn(user: *mut c_void, at: *const fmc_law_points, response: *const fmc_law_response) -> i32>;

pub type fmc_limit_friction = Option<unsafe extern "C" fn(user: *mut c_void, at: *const fmc_friction_facets, response: *const fmc_friction_response) -> i32>;

pub type fmc_place = Option<unsafe extern "C" fn(user: *mut c_void, n: usize, displacement: *const f64, coords: *mut f64) -> i32>;

pub type fmc_all_gather = Option<unsafe extern "C" fn(user: *mut c_void, send: *const c_void, counts: *const u64, received: *mut c_void) -> i32>;

pub type fmc_all_to_all = Option<unsafe extern "C" fn(user: *mut c_void, send: *const c_void, send_counts: *const u64, received: *mut c_void, received_counts: *const u64) -> i32>;

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_options {
    pub struct_size: usize,
    pub stiffness: f64,
    pub exponent: f64,
    pub spacing: f64,
    pub fiber_length: f64,
    pub fiber_count: u64,
    pub seed: u64,
    pub law: i32,
    pub estimator: i32,
    pub pattern: i32,
    pub weights: i32,
    pub momentum_correction: i32,
    pub self_contact: i32,
    pub check_cells: i32,
    pub threads: i32,
    pub index_base: i32,
    pub axisymmetric: i32,
    pub smoothing_length: f64,
    pub friction_coefficient: f64,
    pub friction_stiffness: f64,
    pub cohesion: f64,
    pub shear_limit: f64,
    pub memoryless_slip: f64,
    pub static_coefficient: f64,
    pub weakening_slip: f64,
    pub weld: f64,
    pub reserved: [u64; 7],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_coords {
    pub data: *const f64,
    pub node_count: usize,
    pub node_stride: isize,
    pub axis_stride: isize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_forces {
    pub data: *mut f64,
    pub node_count: usize,
    pub node_stride: isize,
    pub axis_stride: isize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_cell_block {
    pub cell_type: i32,
    pub index_size: i32,
    pub conn: *const c_void,
    pub cell_count: usize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_facet_block {
    pub facet_type: i32,
    pub index_size: i32,
    pub conn: *const c_void,
    pub facet_count: usize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_csr {
    pub struct_size: usize,
    pub row_count: usize,
    pub index_size: i32,
    pub index_base: i32,
    pub row_offsets: *const c_void,
    pub cols: *const c_void,
    pub values: *const f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_pose {
    pub position: [f64; 3],
    pub rotation: [f64; 9],
    pub scale: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct fmc_shape {
    pub struct_size: usize,
    pub kind: i32,
    pub index_size: i32,
    pub radius: f64,
    pub half_height: f64,
    pub half_extents: [f64; 3],
    pub points: fmc_coords,
    pub facets: *const c_void,
    pub facet_count: usize,
    pub heights: *const f64,
    pub counts: [usize; 2],
    pub lengths: [f64; 2],
    pub thickness: f64,
    pub parts: *const c_void,
    pub part_count: usize,
    pub signed_distance: fmc_signed_distance,
    pub user: *mut c_void,
    pub reserved: [u64; 8],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_part {
    pub shape: *const fmc_shape,
    pub pose: fmc_pose,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_pair_options {
    pub struct_size: usize,
    pub stiffness: f64,
    pub exponent: f64,
    pub smoothing_length: f64,
    pub gap_offset: f64,
    pub friction_coefficient: f64,
    pub law: i32,
    pub excluded: i32,
    pub static_coefficient: f64,
    pub weakening_slip: f64,
    pub interface_kind: i32,
    pub softening: i32,
    pub reach: f64,
    pub normal_strength: f64,
    pub shear_strength: f64,
    pub normal_energy: f64,
    pub shear_energy: f64,
    pub mixed_mode_exponent: f64,
    pub surface_a: i32,
    pub surface_b: i32,
    pub viscosity: f64,
    pub reserved: [u64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_orthotropic_friction {
    pub struct_size: usize,
    pub transverse_coefficient: f64,
    pub direction: [f64; 3],
    pub direction_of: i32,
    pub unused: i32,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_ppr {
    pub struct_size: usize,
    pub normal_shape: f64,
    pub shear_shape: f64,
    pub normal_slope: f64,
    pub shear_slope: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_law_points {
    pub struct_size: usize,
    pub count: usize,
    pub dim: usize,
    pub history_count: usize,
    pub body: usize,
    pub partner: usize,
    pub time_step: f64,
    pub jump: *const f64,
    pub axes: *const f64,
    pub position: *const f64,
    pub reference: *const f64,
    pub area: *const f64,
    pub history: *const f64,
    pub field_count: usize,
    pub fields: *const f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_law_response {
    pub struct_size: usize,
    pub traction: *mut f64,
    pub tangent: *mut f64,
    pub history: *mut f64,
    pub stored: *mut f64,
    pub dissipated: *mut f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct fmc_own_law {
    pub struct_size: usize,
    pub history_count: usize,
    pub respond: fmc_respond,
    pub user: *mut c_void,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_friction_facets {
    pub struct_size: usize,
    pub count: usize,
    pub dim: usize,
    pub history_count: usize,
    pub body: usize,
    pub partner: usize,
    pub partner_kind: i32,
    pub unused: i32,
    pub time_step: f64,
    pub stiffness: f64,
    pub facet: *const usize,
    pub pressure: *const f64,
    pub slip: *const f64,
    pub trial: *const f64,
    pub axes: *const f64,
    pub position: *const f64,
    pub area: *const f64,
    pub history: *const f64,
    pub field_count: usize,
    pub fields: *const f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_friction_response {
    pub struct_size: usize,
    pub limit: *mut f64,
    pub by_pressure: *mut f64,
    pub by_slip: *mut f64,
    pub history: *mut f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct fmc_friction_law {
    pub struct_size: usize,
    pub history_count: usize,
    pub limit: fmc_limit_friction,
    pub user: *mut c_void,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_result {
    pub struct_size: usize,
    pub volume: f64,
    pub volume_standard_error: f64,
    pub energy: f64,
    pub contact_area: f64,
    pub penetration: f64,
    pub fiber_count: usize,
    pub crossing_count: usize,
    pub facet_count: usize,
    pub pair_count: usize,
    pub body_count: usize,
    pub obstacle_count: usize,
    pub warning_count: usize,
    pub friction_energy: f64,
    pub friction_dissipation: f64,
    pub stick_area: f64,
    pub slip_area: f64,
    pub largest_slip: f64,
    pub reserved: [u64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_resultant {
    pub struct_size: usize,
    pub id: i64,
    pub force: [f64; 3],
    pub moment: [f64; 3],
    pub node_count: usize,
    pub friction: [f64; 3],
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_pair_result {
    pub struct_size: usize,
    pub a_kind: i32,
    pub b_kind: i32,
    pub a: usize,
    pub b: usize,
    pub volume: f64,
    pub volume_standard_error: f64,
    pub energy: f64,
    pub pressure: f64,
    pub contact_area: f64,
    pub penetration: f64,
    pub spacing: f64,
    pub friction_energy: f64,
    pub friction_dissipation: f64,
    pub stick_area: f64,
    pub slip_area: f64,
    pub force: [f64; 3],
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_step_limit {
    pub struct_size: usize,
    pub part: f64,
    pub first_touch: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_adjustment {
    pub struct_size: usize,
    pub closed: f64,
    pub removed: f64,
    pub left: f64,
    pub count: usize,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_augmentation {
    pub struct_size: usize,
    pub penetration: f64,
    pub change: f64,
    pub multiplier_count: usize,
    pub is_converged: i32,
    pub reserved_flags: i32,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_multiplier {
    pub struct_size: usize,
    pub node: i64,
    pub body: usize,
    pub partner_kind: i32,
    pub reserved_flags: i32,
    pub partner: usize,
    pub shift: f64,
    pub towards: [f64; 3],
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_equilibrium_options {
    pub struct_size: usize,
    pub tolerance: f64,
    pub max_solves: usize,
    pub penetration: f64,
    pub reach: f64,
    pub max_updates: usize,
    pub condensed: i32,
    pub lagged: i32,
    pub find_patches: i32,
    pub check: i32,
    pub straight_slip: i32,
    pub reserved_flags: u32,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_equilibrium_problem {
    pub struct_size: usize,
    pub unknown_count: usize,
    pub row_count: usize,
    pub unknown_of_coordinate: *const c_void,
    pub base: *const f64,
    pub free: *const u8,
    pub x: *const f64,
    pub prescribed: *const f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_equilibrium_answer {
    pub struct_size: usize,
    pub vector: *const f64,
    pub refusal: *const c_char,
    pub energy: *const f64,
    pub definite: i32,
    pub reserved_flags: u32,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_equilibrium_request {
    pub struct_size: usize,
    pub kind: i32,
    pub matrix: i32,
    pub magnitudes: i32,
    pub tangent_flags: u32,
    pub x: *const f64,
    pub vector: *const f64,
    pub forces: *const f64,
    pub shift: f64,
    pub tolerance: f64,
    pub absolute_tolerance: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_equilibrium_result {
    pub struct_size: usize,
    pub way: i32,
    pub unheld: i32,
    pub x: *const f64,
    pub reactions: *const f64,
    pub residuals: *const f64,
    pub residual_count: usize,
    pub solve_count: usize,
    pub rigid_step_count: usize,
    pub part_count: usize,
    pub loose_count: usize,
    pub update_count: usize,
    pub text_count: usize,
    pub penetration: f64,
    pub unheld_body: i64,
    pub unheld_direction: [f64; 3],
    pub first_touch_count: usize,
    pub reserved: [u64; 5],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_contact_step_options {
    pub struct_size: usize,
    pub tolerance: f64,
    pub absolute_tolerance: f64,
    pub full_below: f64,
    pub max_iterations: i32,
    pub max_trials: i32,
    pub soft_start: i32,
    pub reserved_flags: i32,
    pub reserved: [u64; 7],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_contact_step_result {
    pub struct_size: usize,
    pub state: i32,
    pub iterations: i32,
    pub evaluation_count: usize,
    pub outside_count: usize,
    pub residual_at_start: f64,
    pub residual: f64,
    pub scale: f64,
    pub reserved: [u64; 8],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_nodal_contact {
    pub struct_size: usize,
    pub pressure: *mut f64,
    pub gap: *mut f64,
    pub area: *mut f64,
    pub normal: *mut f64,
    pub friction: *mut f64,
    pub sliding: *mut f64,
    pub status: *mut i32,
    pub local_pressure: *mut f64,
    pub reserved: [u64; 8],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_contact_side {
    pub kind: i32,
    pub node_count: i32,
    pub index: usize,
    pub cell: i64,
    pub nodes: [i64; 8],
    pub weights: [f64; 8],
    pub position: [f64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_contact_point {
    pub struct_size: usize,
    pub patch: usize,
    pub position: [f64; 3],
    pub normal: [f64; 3],
    pub gap: f64,
    pub pressure: f64,
    pub area: f64,
    pub friction: [f64; 3],
    pub slip: [f64; 3],
    pub sliding: f64,
    pub sides: [fmc_contact_side; 2],
    pub reserved: [u64; 8],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_gap_constraint {
    pub struct_size: usize,
    pub node: i64,
    pub body: usize,
    pub partner_kind: i32,
    pub reserved_flags: i32,
    pub partner: usize,
    pub gap: f64,
    pub area: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_tie {
    pub struct_size: usize,
    pub area: f64,
    pub largest_gap: f64,
    pub node_count: usize,
    pub reach: f64,
    pub reserved: [u64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_tie_node {
    pub struct_size: usize,
    pub node: i64,
    pub body: usize,
    pub partner: usize,
    pub area: f64,
    pub traction: [f64; 3],
    pub jump: [f64; 3],
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_conductance {
    pub struct_size: usize,
    pub pressure_count: usize,
    pub pressures: *const f64,
    pub by_pressure: *const f64,
    pub gap_count: usize,
    pub gaps: *const f64,
    pub by_gap: *const f64,
    pub reserved: [u64; 8],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_cohesive {
    pub struct_size: usize,
    pub area: f64,
    pub largest_gap: f64,
    pub point_count: usize,
    pub stored: f64,
    pub dissipated: f64,
    pub damaged_area: f64,
    pub broken_area: f64,
    pub rubbed: f64,
    pub viscous: f64,
    pub reserved: [u64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_cohesive_point {
    pub struct_size: usize,
    pub body: usize,
    pub partner: usize,
    pub position: [f64; 3],
    pub area: f64,
    pub opening: f64,
    pub sliding: [f64; 3],
    pub traction: [f64; 3],
    pub damage: f64,
    pub dissipated: f64,
    pub rubbed: f64,
    pub viscous: f64,
    pub reserved: [u64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_law_point {
    pub struct_size: usize,
    pub body: usize,
    pub partner: usize,
    pub position: [f64; 3],
    pub area: f64,
    pub axes: [f64; 9],
    pub jump: [f64; 3],
    pub traction: [f64; 3],
    pub stored: f64,
    pub dissipated: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_boundary_facet {
    pub struct_size: usize,
    pub body: usize,
    pub cell: i64,
    pub input_facet: i64,
    pub local_face: i32,
    pub node_count: i32,
    pub nodes: [i64; 4],
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_gradients {
    pub struct_size: usize,
    pub coords: *mut f64,
    pub reference: *mut f64,
    pub positions: *mut f64,
    pub rotations: *mut f64,
    pub of_pairs: u64,
    pub slip_adjoint: *const f64,
    pub slip_adjoint_count: usize,
    pub slip: *mut f64,
    pub slip_capacity: usize,
    pub slip_count: *mut usize,
    pub reserved: [u64; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_pair_gradient {
    pub struct_size: usize,
    pub a_kind: i32,
    pub b_kind: i32,
    pub a: usize,
    pub b: usize,
    pub stiffness: f64,
    pub gap_offset: f64,
    pub friction: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_directions {
    pub struct_size: usize,
    pub coords: *const f64,
    pub positions: *const f64,
    pub rotations: *const f64,
    pub stiffness: f64,
    pub gap_offset: f64,
    pub friction: f64,
    pub pairs: *const fmc_pair_gradient,
    pub pair_count: usize,
    pub slip: *const f64,
    pub slip_count: usize,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct fmc_communicator {
    pub struct_size: usize,
    pub rank: i32,
    pub size: i32,
    pub all_gather: fmc_all_gather,
    pub user: *mut c_void,
    pub all_to_all: fmc_all_to_all,
    pub reserved: [u64; 5],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_rank_counts {
    pub struct_size: usize,
    pub item_count: u64,
    pub own_item_count: u64,
    pub call_count: u64,
    pub sent_bytes: u64,
    pub received_bytes: u64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_mesh_part {
    pub struct_size: usize,
    pub coords: fmc_coords,
    pub index_size: i32,
    pub reserved_flags: i32,
    pub node_numbers: *const c_void,
    pub blocks: *const fmc_cell_block,
    pub block_count: usize,
    pub cell_numbers: *const c_void,
    pub body_ids: *const c_void,
    pub reach: f64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_carried_slip {
    pub cell: i64,
    pub face: i32,
    pub part: i32,
    pub partner_kind: i32,
    pub is_second: i32,
    pub partner: usize,
    pub slip: [f64; 3],
    pub slid: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_gathered_counts {
    pub struct_size: usize,
    pub node_count: u64,
    pub cell_count: u64,
    pub facet_count: u64,
    pub whole_facet_count: u64,
    pub own_cell_count: u64,
    pub gather_count: u64,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_friction_step {
    pub struct_size: usize,
    pub start: *const f64,
    pub reference: *const f64,
    pub slip: *const f64,
    pub slip_count: usize,
    pub next_slip: *mut f64,
    pub next_slip_capacity: usize,
    pub next_slip_count: *mut usize,
    pub reserved: [u64; 8],
}

unsafe extern "C" {
    pub fn fmc_version() -> *const c_char;
    pub fn fmc_abi_version() -> i32;
    pub fn fmc_has_feature(name: *const c_char) -> i32;
    pub fn fmc_status_name(status: i32) -> *const c_char;
    pub fn fmc_status_class(status: i32) -> i32;
    pub fn fmc_last_error() -> *const c_char;
    pub fn fmc_options_init(options: *mut fmc_options) -> fmc_status;
    pub fn fmc_options_set(options: *mut fmc_options, key: *const c_char, value: *const c_char) -> fmc_status;
    pub fn fmc_suggest_stiffness(law: i32, dim: i32, exponent: f64, modulus: f64, cell_size: f64, stiffness: *mut f64) -> fmc_status;
    pub fn fmc_context_set_log(context: *mut fmc_context, callback: fmc_log_callback, user: *mut c_void) -> fmc_status;
    pub fn fmc_context_new_from_cells(dim: i32, coords: *const fmc_coords, blocks: *const fmc_cell_block, block_count: usize, body_ids: *const c_void, options: *const fmc_options, context: *mut *mut fmc_context) -> fmc_status;
    pub fn fmc_context_new_from_facets(dim: i32, coords: *const fmc_coords, blocks: *const fmc_facet_block, block_count: usize, body_ids: *const c_void, options: *const fmc_options, context: *mut *mut fmc_context) -> fmc_status;
    pub fn fmc_context_set_options(context: *mut fmc_context, options: *const fmc_options) -> fmc_status;
    pub fn fmc_context_options(context: *const fmc_context, options: *mut fmc_options) -> fmc_status;
    pub fn fmc_context_counts(context: *const fmc_context, node_count: *mut usize, facet_count: *mut usize, body_count: *mut usize) -> fmc_status;
    pub fn fmc_context_welded_node_count(context: *const fmc_context, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_interrupt(context: *mut fmc_context, callback: fmc_interrupt_callback, user: *mut c_void) -> fmc_status;
    pub fn fmc_context_set_reference(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status;
    pub fn fmc_context_set_symmetry_planes(context: *mut fmc_context, points: *const f64, normals: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_set_symmetry_nodes(context: *mut fmc_context, nodes: *const c_void, count: usize) -> fmc_status;
    pub fn fmc_context_set_surface_smoothing(context: *mut fmc_context, feature_angle: f64) -> fmc_status;
    pub fn fmc_context_add_surface(context: *mut fmc_context, facets: *const usize, count: usize, surface: *mut i32) -> fmc_status;
    pub fn fmc_csr_init(matrix: *mut fmc_csr) -> fmc_status;
    pub fn fmc_context_set_basis(context: *mut fmc_context, weights: *const fmc_csr, unknown_count: usize) -> fmc_status;
    pub fn fmc_pose_init(pose: *mut fmc_pose) -> fmc_status;
    pub fn fmc_pose_along(dim: i32, position: *const f64, axis: *const f64, pose: *mut fmc_pose) -> fmc_status;
    pub fn fmc_shape_init(shape: *mut fmc_shape, kind: i32) -> fmc_status;
    pub fn fmc_context_add_obstacle(context: *mut fmc_context, shape: *const fmc_shape, pose: *const fmc_pose, obstacle: *mut usize) -> fmc_status;
    pub fn fmc_context_obstacle_shape(context: *const fmc_context, obstacle: usize, kind: *mut i32, pose: *mut fmc_pose) -> fmc_status;
    pub fn fmc_context_set_pose(context: *mut fmc_context, obstacle: usize, pose: *const fmc_pose) -> fmc_status;
    pub fn fmc_context_remove_obstacle(context: *mut fmc_context, obstacle: usize) -> fmc_status;
    pub fn fmc_pair_options_init(options: *mut fmc_pair_options) -> fmc_status;
    pub fn fmc_context_set_pair_options(context: *mut fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, options: *const fmc_pair_options) -> fmc_status;
    pub fn fmc_context_pair_options(context: *const fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, options: *mut fmc_pair_options) -> fmc_status;
    pub fn fmc_orthotropic_friction_init(friction: *mut fmc_orthotropic_friction) -> fmc_status;
    pub fn fmc_context_set_orthotropic_pair(context: *mut fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, options: *const fmc_pair_options, friction: *const fmc_orthotropic_friction) -> fmc_status;
    pub fn fmc_context_orthotropic_pair(context: *const fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, friction: *mut fmc_orthotropic_friction) -> fmc_status;
    pub fn fmc_ppr_init(ppr: *mut fmc_ppr) -> fmc_status;
    pub fn fmc_context_set_ppr_pair(context: *mut fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, options: *const fmc_pair_options, ppr: *const fmc_ppr) -> fmc_status;
    pub fn fmc_context_ppr_pair(context: *const fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, ppr: *mut fmc_ppr) -> fmc_status;
    pub fn fmc_own_law_init(law: *mut fmc_own_law) -> fmc_status;
    pub fn fmc_own_law_check(law: *const fmc_own_law, dim: usize, scale: f64, jump: *const f64, jump_count: usize, time_step: f64, tell: fmc_log_callback, user: *mut c_void) -> fmc_status;
    pub fn fmc_context_set_law_fields(context: *mut fmc_context, values: *const f64, row_count: usize, field_count: usize) -> fmc_status;
    pub fn fmc_context_set_law_pair(context: *mut fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, options: *const fmc_pair_options, law: *const fmc_own_law) -> fmc_status;
    pub fn fmc_friction_law_init(law: *mut fmc_friction_law) -> fmc_status;
    pub fn fmc_friction_law_check(law: *const fmc_friction_law, dim: usize, pressure: f64, slip: f64, time_step: f64, tell: fmc_log_callback, user: *mut c_void) -> fmc_status;
    pub fn fmc_context_set_friction_law_pair(context: *mut fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, options: *const fmc_pair_options, law: *const fmc_friction_law) -> fmc_status;
    pub fn fmc_context_evaluate(context: *mut fmc_context, coords: *const fmc_coords, forces: *const fmc_forces, flags: u32, result: *mut fmc_result) -> fmc_status;
    pub fn fmc_context_body_resultant(context: *const fmc_context, index: usize, body: *mut fmc_resultant) -> fmc_status;
    pub fn fmc_context_obstacle_resultant(context: *const fmc_context, index: usize, obstacle: *mut fmc_resultant) -> fmc_status;
    pub fn fmc_context_pair_result(context: *const fmc_context, index: usize, pair: *mut fmc_pair_result) -> fmc_status;
    pub fn fmc_context_warning(context: *const fmc_context, index: usize, code: *mut i32, text: *mut *const c_char) -> fmc_status;
    pub fn fmc_context_tangent(context: *mut fmc_context, coords: *const fmc_coords, flags: u32, rank_one_count: *mut usize) -> fmc_status;
    pub fn fmc_context_tangent_entries(context: *const fmc_context, rows: *mut c_void, cols: *mut c_void, values: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_tangent_product(context: *const fmc_context, x: *const f64, y: *mut f64, length: usize) -> fmc_status;
    pub fn fmc_context_tangent_rank_one(context: *const fmc_context, index: usize, factor: *mut f64, vector: *mut f64, length: usize) -> fmc_status;
    pub fn fmc_context_tangent_csr(context: *const fmc_context, flags: u32, row_offsets: *mut c_void, offset_capacity: usize, offset_count: *mut usize, cols: *mut c_void, values: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_keep_pattern(context: *mut fmc_context, keep: i32) -> fmc_status;
    pub fn fmc_context_evaluate_tangent(context: *mut fmc_context, coords: *const fmc_coords, flags: u32, forces: *const fmc_forces, result: *mut fmc_result, rank_one_count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_obstacle_rotations(context: *mut fmc_context, on: i32) -> fmc_status;
    pub fn fmc_context_begin_step(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status;
    pub fn fmc_context_commit_step(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status;
    pub fn fmc_context_freeze_friction(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status;
    pub fn fmc_context_keep_patches(context: *mut fmc_context, coords: *const fmc_coords, direction_count: *mut usize) -> fmc_status;
    pub fn fmc_context_stable_step(context: *mut fmc_context, coords: *const fmc_coords, masses: *const f64, step: *mut f64) -> fmc_status;
    pub fn fmc_context_stiffness_from_masses(context: *mut fmc_context, coords: *const fmc_coords, masses: *const f64, limit: f64) -> fmc_status;
    pub fn fmc_context_step_limit(context: *mut fmc_context, coords: *const fmc_coords, step: *const fmc_coords, limit: *mut fmc_step_limit) -> fmc_status;
    pub fn fmc_context_adjust(context: *mut fmc_context, coords: *const fmc_coords, close: f64, remove: f64, adjustment: *mut fmc_adjustment) -> fmc_status;
    pub fn fmc_context_offsets(context: *const fmc_context, offsets: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_offsets(context: *mut fmc_context, offsets: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_augment(context: *mut fmc_context, coords: *const fmc_coords, reach: f64, tolerance: f64, result: *mut fmc_augmentation) -> fmc_status;
    pub fn fmc_context_stiffen(context: *mut fmc_context, factor: f64) -> fmc_status;
    pub fn fmc_equilibrium_options_init(options: *mut fmc_equilibrium_options) -> fmc_status;
    pub fn fmc_equilibrium_problem_init(problem: *mut fmc_equilibrium_problem) -> fmc_status;
    pub fn fmc_equilibrium_answer_init(answer: *mut fmc_equilibrium_answer) -> fmc_status;
    pub fn fmc_equilibrium_new(context: *mut fmc_context, problem: *const fmc_equilibrium_problem, options: *const fmc_equilibrium_options, equilibrium: *mut *mut fmc_equilibrium) -> fmc_status;
    pub fn fmc_equilibrium_next(context: *mut fmc_context, equilibrium: *mut fmc_equilibrium, answer: *const fmc_equilibrium_answer, request: *mut fmc_equilibrium_request) -> fmc_status;
    pub fn fmc_equilibrium_abandon(context: *mut fmc_context, equilibrium: *mut fmc_equilibrium) -> fmc_status;
    pub fn fmc_equilibrium_found(equilibrium: *mut fmc_equilibrium, result: *mut fmc_equilibrium_result) -> fmc_status;
    pub fn fmc_equilibrium_text(equilibrium: *const fmc_equilibrium, number: usize) -> *const c_char;
    pub fn fmc_equilibrium_free(equilibrium: *mut *mut fmc_equilibrium) -> fmc_status;
    pub fn fmc_contact_step_options_init(options: *mut fmc_contact_step_options) -> fmc_status;
    pub fn fmc_context_contact_step(context: *mut fmc_context, coords: *const fmc_coords, options: *const fmc_contact_step_options, dofs: *const c_void, dof_count: usize, fixed_dofs: *const c_void, fixed_count: usize, stiffness: *const f64, residual: *const f64, place: fmc_place, user: *mut c_void, displacement: *mut f64, result: *mut fmc_contact_step_result) -> fmc_status;
    pub fn fmc_condensation_new(condensation: *mut *mut fmc_condensation) -> fmc_status;
    pub fn fmc_condensation_free(condensation: *mut *mut fmc_condensation) -> fmc_status;
    pub fn fmc_condensation_factorise(condensation: *mut fmc_condensation, matrix: *const fmc_csr, retained: *const c_void, retained_count: usize) -> fmc_status;
    pub fn fmc_condensation_complement(condensation: *const fmc_condensation, complement: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_condensation_condense(condensation: *const fmc_condensation, right: *const f64, right_count: usize, condensed: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_condensation_expand(condensation: *const fmc_condensation, right: *const f64, right_count: usize, retained: *const f64, retained_count: usize, solution: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_nodal_contact_init(nodal: *mut fmc_nodal_contact) -> fmc_status;
    pub fn fmc_context_nodal_contact(context: *mut fmc_context, coords: *const fmc_coords, nodal: *const fmc_nodal_contact) -> fmc_status;
    pub fn fmc_context_contact_points(context: *mut fmc_context, coords: *const fmc_coords, points: *mut fmc_contact_point, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_gap_constraints(context: *mut fmc_context, coords: *const fmc_coords, reach: f64, rows: *mut fmc_gap_constraint, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_gap_gradient(context: *const fmc_context, row_offsets: *mut c_void, offset_capacity: usize, offset_count: *mut usize, cols: *mut c_void, values: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_tie(context: *const fmc_context, a: usize, b: usize, tie: *mut fmc_tie) -> fmc_status;
    pub fn fmc_context_tie_nodes(context: *mut fmc_context, coords: *const fmc_coords, rows: *mut fmc_tie_node, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_tie_constraints(context: *const fmc_context, row_offsets: *mut c_void, offset_capacity: usize, offset_count: *mut usize, cols: *mut c_void, values: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_add_tie(context: *mut fmc_context, surface_a: i32, surface_b: i32, period: *const f64, reach: f64, tie: *mut i32) -> fmc_status;
    pub fn fmc_context_remove_tie(context: *mut fmc_context, tie: i32) -> fmc_status;
    pub fn fmc_context_set_tie_jump(context: *mut fmc_context, tie: i32, jump: *const f64) -> fmc_status;
    pub fn fmc_context_added_tie(context: *const fmc_context, tie: i32, found: *mut fmc_tie) -> fmc_status;
    pub fn fmc_context_tie_force(context: *mut fmc_context, coords: *const fmc_coords, tie: i32, force: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_conductance_init(conductance: *mut fmc_conductance) -> fmc_status;
    pub fn fmc_context_flux(context: *mut fmc_context, coords: *const fmc_coords, conductance: *const fmc_conductance, field_count: usize, fields: *const f64, of_obstacles: *const f64, flux: *mut f64, obstacle_flux: *mut f64) -> fmc_status;
    pub fn fmc_context_flux_matrix(context: *const fmc_context, row_offsets: *mut c_void, offset_capacity: usize, offset_count: *mut usize, cols: *mut c_void, values: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_friction_heat(context: *mut fmc_context, coords: *const fmc_coords, effusivities: *const f64, heat: *mut f64, obstacle_heat: *mut f64) -> fmc_status;
    pub fn fmc_context_cohesive(context: *mut fmc_context, a: usize, b: usize, coords: *const fmc_coords, cohesive: *mut fmc_cohesive) -> fmc_status;
    pub fn fmc_context_cohesive_points(context: *mut fmc_context, coords: *const fmc_coords, rows: *mut fmc_cohesive_point, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_law_points(context: *mut fmc_context, coords: *const fmc_coords, rows: *mut fmc_law_point, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_boundary_facets(context: *const fmc_context, facets: *mut fmc_boundary_facet, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_point_weights(context: *const fmc_context, row_offsets: *mut c_void, offset_capacity: usize, offset_count: *mut usize, nodes: *mut c_void, weights: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_gradients_init(gradients: *mut fmc_gradients) -> fmc_status;
    pub fn fmc_context_vjp(context: *mut fmc_context, coords: *const fmc_coords, energy: f64, adjoint: *const fmc_coords, gradients: *const fmc_gradients, pairs: *mut fmc_pair_gradient, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_directions_init(directions: *mut fmc_directions) -> fmc_status;
    pub fn fmc_context_jvp(context: *mut fmc_context, coords: *const fmc_coords, directions: *const fmc_directions, energy: *mut f64, forces: *mut f64) -> fmc_status;
    pub fn fmc_equilibrium_adjoint(context: *mut fmc_context, problem: *const fmc_equilibrium_problem, by_x: *const f64, by_forces: *const f64, balance: *const f64, right: *mut f64, gradients: *const fmc_gradients, pairs: *mut fmc_pair_gradient, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_pair_wear(context: *mut fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, wear_a: f64, wear_b: f64) -> fmc_status;
    pub fn fmc_context_pair_wear(context: *const fmc_context, a_kind: i32, a: usize, b_kind: i32, b: usize, wear_a: *mut f64, wear_b: *mut f64) -> fmc_status;
    pub fn fmc_context_worn_depth(context: *const fmc_context, depth: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_worn_volumes(context: *const fmc_context, volumes: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_worn_facets(context: *const fmc_context, worn: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_worn_facets(context: *mut fmc_context, worn: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_set_wear_cycles(context: *mut fmc_context, cycles: f64) -> fmc_status;
    pub fn fmc_context_slip(context: *const fmc_context, slip: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_slip(context: *mut fmc_context, slip: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_friction_history(context: *const fmc_context, history: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_friction_history(context: *mut fmc_context, history: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_damage(context: *const fmc_context, damage: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_damage(context: *mut fmc_context, damage: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_cohesive_history(context: *const fmc_context, history: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_cohesive_history(context: *mut fmc_context, history: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_set_time_step(context: *mut fmc_context, time_step: f64) -> fmc_status;
    pub fn fmc_context_law_history(context: *const fmc_context, history: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_law_history(context: *mut fmc_context, history: *const f64, count: usize) -> fmc_status;
    pub fn fmc_context_multipliers(context: *const fmc_context, rows: *mut fmc_multiplier, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_set_multipliers(context: *mut fmc_context, rows: *const fmc_multiplier, count: usize) -> fmc_status;
    pub fn fmc_communicator_init(communicator: *mut fmc_communicator) -> fmc_status;
    pub fn fmc_context_set_communicator(context: *mut fmc_context, communicator: *const fmc_communicator) -> fmc_status;
    pub fn fmc_context_rank_counts(context: *const fmc_context, counts: *mut fmc_rank_counts) -> fmc_status;
    pub fn fmc_mesh_part_init(part: *mut fmc_mesh_part) -> fmc_status;
    pub fn fmc_context_new_from_part(dim: i32, communicator: *const fmc_communicator, part: *const fmc_mesh_part, options: *const fmc_options, context: *mut *mut fmc_context) -> fmc_status;
    pub fn fmc_context_set_coords(context: *mut fmc_context, coords: *const fmc_coords, renumbered: *mut i32) -> fmc_status;
    pub fn fmc_context_set_carried_slip(context: *mut fmc_context, carried: *const fmc_carried_slip, count: usize) -> fmc_status;
    pub fn fmc_context_gathered_counts(context: *const fmc_context, counts: *mut fmc_gathered_counts) -> fmc_status;
    pub fn fmc_context_gathered_nodes(context: *const fmc_context, numbers: *mut c_void, own_nodes: *mut c_void, coords: *mut f64, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_gathered_cells(context: *const fmc_context, numbers: *mut c_void, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_carried_slip(context: *const fmc_context, carried: *mut fmc_carried_slip, capacity: usize, count: *mut usize) -> fmc_status;
    pub fn fmc_context_free(context: *mut *mut fmc_context) -> fmc_status;
    pub fn fmc_friction_step_init(step: *mut fmc_friction_step) -> fmc_status;
    pub fn fmc_contact_force(dim: i32, coords: *const f64, node_count: usize, blocks: *const fmc_cell_block, block_count: usize, body_ids: *const c_void, options: *const fmc_options, step: *const fmc_friction_step, forces: *mut f64, volume: *mut f64) -> fmc_status;
}
