//! What hosts tell and are told of a search for an equilibrium.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::{check, slice, text};
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE};
use crate::contact::TangentPart;
use crate::contact::equilibrium::{Answer, DriverOptions, Request, Unknowns};
use std::ffi::{c_char, c_void};

/// `FMC_TANGENT_SEMIDEFINITE` and `FMC_TANGENT_SYMMETRIC`.
const SEMIDEFINITE: u32 = 2;
const SYMMETRIC: u32 = 32;

/// The unknowns of a host, and the start of a load step. Initialise it with `fmc_equilibrium_problem_init`.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_equilibrium_problem {
    /// Set by `fmc_equilibrium_problem_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Number of unknowns, free or not.
    pub unknown_count: usize,
    /// Number of rows of coordinates, as the context has them.
    pub row_count: usize,
    /// Unknown of every coordinate, `row_count * dim` numbers by row, of the mesh's `index_size` and counted from
    /// `index_base`. A coordinate that never moves has any number below `index_base`.
    pub unknown_of_coordinate: *const c_void,
    /// Coordinates where all unknowns are zero, `row_count * dim` numbers by row.
    pub base: *const f64,
    /// `unknown_count` marks: 0 for an unknown that is not solved for.
    pub free: *const u8,
    /// Where the load step begins, `unknown_count` numbers: best the last equilibrium.
    pub x: *const f64,
    /// Values at its end of unknowns that are not free, `unknown_count` numbers; other entries are not read. NULL:
    /// unchanged.
    pub prescribed: *const f64,
    /// Zero.
    pub reserved: [u64; 4],
}

impl Default for fmc_equilibrium_problem {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            unknown_count: 0,
            row_count: 0,
            unknown_of_coordinate: std::ptr::null(),
            base: std::ptr::null(),
            free: std::ptr::null(),
            x: std::ptr::null(),
            prescribed: std::ptr::null(),
            reserved: [0; 4],
        }
    }
}

impl Default for fmc_equilibrium_answer {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            vector: std::ptr::null(),
            refusal: std::ptr::null(),
            energy: std::ptr::null(),
            definite: 0,
            reserved_flags: 0,
            reserved: [0; 4],
        }
    }
}

/// Unknowns, where the step begins, and where those that are not free end.
type Given<const D: usize> = (Unknowns<D>, Vec<f64>, Option<Vec<f64>>);

impl fmc_equilibrium_problem {
    /// # Safety
    /// The host guarantees the arrays.
    pub(crate) unsafe fn read<const D: usize>(&self, size: IndexSize, index_base: i32) -> Result<Given<D>, Failure> {
        if self.struct_size != size_of::<Self>() {
            return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, "a problem was not set by fmc_equilibrium_problem_init"));
        }
        if self.reserved != [0; 4] {
            return Err(Failure::new(FMC_ERROR_RESERVED_FIELD, "a reserved field of a problem is not zero"));
        }
        let (count, rows) = (self.unknown_count, self.row_count);
        // SAFETY: passed on to the caller.
        unsafe {
            let numbers = size.list("unknown_of_coordinate", self.unknown_of_coordinate, rows, D)?;
            let (base, _) = slice("base", self.base, rows, D)?.as_chunks::<D>();
            let unknowns = Unknowns {
                count,
                weighted: std::collections::BTreeMap::new(),
                of_coordinate: numbers.iter().map(|&n| usize::try_from(n - i64::from(index_base)).ok()).collect(),
                base: base.to_vec(),
                free: slice("free", self.free, count, 1)?.iter().map(|&mark| mark != 0).collect(),
            };
            let x = slice("x", self.x, count, 1)?.to_vec();
            let prescribed = match self.prescribed.is_null() {
                true => None,
                false => Some(slice("prescribed", self.prescribed, count, 1)?.to_vec()),
            };
            Ok((unknowns, x, prescribed))
        }
    }
}

/// Tolerances and limits of a search. Initialise it with `fmc_equilibrium_options_init`; the defaults suffice.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_equilibrium_options {
    /// Set by `fmc_equilibrium_options_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Relative residual: its norm at free unknowns / norm of the forces of the bodies or of the contact, whichever is larger. Default
    /// 1e-9.
    pub tolerance: f64,
    /// Linear solves, at most. Default 100.
    pub max_solves: usize,
    /// Penetration tolerance: largest mean penetration of a node, a length. 0, the default: a thousandth of the largest elastic
    /// displacement if the search has found the stiffness; no tolerance if the stiffness was given.
    pub penetration: f64,
    /// Largest distance from a partner at which gaps are measured for it, a length; 0, the default: a twentieth of the
    /// bodies' extent.
    pub reach: f64,
    /// Updates of multipliers, at most; it is an error if the tolerance needs more. Default 20.
    pub max_updates: usize,
    /// 1: the host answers `FMC_REQUEST_CONDENSED`. 2: such steps come first also for bodies on very soft springs; they lead to a stable
    /// equilibrium, which may be far from the start. Default 0.
    pub condensed: i32,
    /// 1: friction is frozen, solved for, and frozen again, until nothing changes. Default 0.
    pub lagged: i32,
    /// 1: patches of the law "fiber" are kept at the start, follow the contact far from its equilibrium, and are recomputed near it.
    /// 0, the default: the host keeps them.
    pub find_patches: i32,
    /// 1: the host is checked at the start, and nothing is solved. The checks compare the residual with the matrix, and test signs,
    /// symmetry and rigid motions. The search ends with `FMC_REQUEST_FOUND`, and `fmc_equilibrium_text` has a sentence for each. Default 0.
    pub check: i32,
    /// 1: slip counts straight from the start of the step, also of pairs that touch later in it. Derivatives of the equilibrium then hold no
    /// place of first touch. Default 0: from where a gap closes.
    pub straight_slip: i32,
    /// Zero.
    pub reserved_flags: u32,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 4],
}

impl Default for fmc_equilibrium_options {
    fn default() -> Self {
        let defaults = DriverOptions::default();
        Self {
            struct_size: size_of::<Self>(),
            tolerance: defaults.tolerance,
            max_solves: defaults.max_solves,
            penetration: defaults.penetration,
            reach: defaults.reach,
            max_updates: defaults.max_updates,
            condensed: defaults.is_condensed.into(),
            lagged: defaults.is_lagged.into(),
            find_patches: defaults.finds_patches.into(),
            check: defaults.is_check.into(),
            straight_slip: defaults.is_slip_straight.into(),
            reserved_flags: 0,
            reserved: [0; 4],
        }
    }
}

impl fmc_equilibrium_options {
    pub(crate) fn to_options(self) -> Result<DriverOptions, Failure> {
        if self.struct_size != size_of::<Self>() {
            let text = "the options of an equilibrium were not set by fmc_equilibrium_options_init";
            return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, text));
        }
        if self.reserved != [0; 4] || self.reserved_flags != 0 {
            return Err(Failure::new(
                FMC_ERROR_RESERVED_FIELD,
                "a reserved field of the options of an equilibrium is not zero",
            ));
        }
        let switch = |name, value: i32| match value {
            0 => Ok(false),
            1 => Ok(true),
            other => Err(Failure::new(FMC_ERROR_BAD_VALUE, format!("'{name}' is {other}, which does not exist"))),
        };
        Ok(DriverOptions {
            tolerance: self.tolerance,
            max_solves: self.max_solves,
            penetration: self.penetration,
            reach: self.reach,
            max_updates: self.max_updates,
            is_condensed: self.condensed == 2 || switch("condensed", self.condensed)?,
            is_condensed_first: self.condensed == 2,
            is_condensed_on_contact: false,
            is_lagged: switch("lagged", self.lagged)?,
            finds_patches: switch("find_patches", self.find_patches)?,
            is_check: switch("check", self.check)?,
            is_slip_straight: switch("straight_slip", self.straight_slip)?,
        })
    }
}

/// Requests of `fmc_equilibrium_next`, and ends of the search. K is the derivative of the forces at the last request with `matrix`, T
/// the tangent of the contact at `x`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmc_equilibrium_request_kind {
    /// Internal minus external forces at `x`, without contact.
    FMC_REQUEST_FORCES = 0,
    /// K `vector`, including rows and columns of unknowns that are not free.
    FMC_REQUEST_PRODUCT = 1,
    /// The diagonal of K.
    FMC_REQUEST_DIAGONAL = 2,
    /// d with (K + `shift` diag K + T) d = `vector` in the rows of free unknowns, and d = 0 at all other unknowns.
    FMC_REQUEST_SOLVE = 3,
    /// A step from `x` to the equilibrium of the contact with linear bodies, from K and the forces `forces`, as
    /// `fmc_context_contact_step` finds it. Unknowns that are not free move by `vector`.
    FMC_REQUEST_CONDENSED = 4,
    /// The equilibrium was found: see `fmc_equilibrium_result`.
    FMC_REQUEST_FOUND = 5,
    /// There is no equilibrium, or none was found: see `fmc_equilibrium_result`.
    FMC_REQUEST_REFUSED = 6,
}

/// A request. Its arrays have `unknown_count` numbers, and are valid until the next call with the search.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_equilibrium_request {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// A value of `fmc_equilibrium_request_kind`.
    pub kind: i32,
    /// 1: from now on K is the derivative at this `x`.
    pub matrix: i32,
    /// 1: entries of K count by their magnitudes.
    pub magnitudes: i32,
    /// Flag of `fmc_context_tangent` for T: 0, `FMC_TANGENT_SYMMETRIC` or `FMC_TANGENT_SEMIDEFINITE`.
    pub tangent_flags: u32,
    /// A state, or NULL.
    pub x: *const f64,
    /// A vector, or NULL.
    pub vector: *const f64,
    /// Forces, or NULL.
    pub forces: *const f64,
    /// Part of the diagonal of K that is added.
    pub shift: f64,
    /// Residual at which a condensed step may end, relative to the forces.
    pub tolerance: f64,
    /// Residual at which it may end, a force.
    pub absolute_tolerance: f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// An answer. Initialise it with `fmc_equilibrium_answer_init`.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_equilibrium_answer {
    /// Set by `fmc_equilibrium_answer_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// The requested vector, `unknown_count` numbers. NULL: it does not exist, for example with an inverted cell or a
    /// singular matrix.
    pub vector: *const f64,
    /// Reason why it does not exist, or NULL.
    pub refusal: *const c_char,
    /// With forces: strain energy minus the work of loads, or NULL where the host does not know it.
    pub energy: *const f64,
    /// With a condensed step: 1 if K was found to be symmetric and positive definite without contact.
    pub definite: i32,
    /// Zero. Room for switches of later versions.
    pub reserved_flags: u32,
    /// Zero.
    pub reserved: [u64; 4],
}

impl fmc_equilibrium_answer {
    /// # Safety
    /// The host guarantees the arrays.
    pub(crate) unsafe fn read(&self, request: &Request, count: usize) -> Result<Answer, Failure> {
        if self.struct_size != size_of::<Self>() {
            return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, "an answer was not set by fmc_equilibrium_answer_init"));
        }
        if self.reserved != [0; 4] || self.reserved_flags != 0 {
            return Err(Failure::new(FMC_ERROR_RESERVED_FIELD, "a reserved field of an answer is not zero"));
        }
        if self.vector.is_null() {
            let why = match self.refusal.is_null() {
                true => "the host has refused",
                // SAFETY: passed on to the caller.
                false => unsafe { text("refusal", self.refusal) }?,
            };
            return Ok(Answer::Refused(why.to_owned()));
        }
        // SAFETY: passed on to the caller.
        let vector = unsafe { slice("vector", self.vector, count, 1) }?.to_vec();
        Ok(match request {
            Request::Forces { .. } if self.energy.is_null() => Answer::Forces { forces: vector, energy: None },
            Request::Forces { .. } => {
                check("energy", self.energy)?;
                // SAFETY: neither NULL nor misaligned; passed on to the caller.
                Answer::Forces { forces: vector, energy: Some(unsafe { *self.energy }) }
            }
            Request::Condensed { .. } => Answer::Step { step: vector, is_definite: self.definite != 0 },
            Request::Product { .. } | Request::Diagonal | Request::Solve { .. } => Answer::Vector(vector),
        })
    }
}

impl Default for fmc_equilibrium_request {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            kind: 0,
            matrix: 0,
            magnitudes: 0,
            tangent_flags: 0,
            x: std::ptr::null(),
            vector: std::ptr::null(),
            forces: std::ptr::null(),
            shift: 0.0,
            tolerance: 0.0,
            absolute_tolerance: 0.0,
            reserved: [0; 4],
        }
    }
}

impl From<&Request> for fmc_equilibrium_request {
    fn from(request: &Request) -> Self {
        use fmc_equilibrium_request_kind::*;
        let of = |kind: fmc_equilibrium_request_kind| Self { kind: kind as i32, ..Self::default() };
        match request {
            Request::Forces { x, matrix } => Self { x: x.as_ptr(), matrix: (*matrix).into(), ..of(FMC_REQUEST_FORCES) },
            Request::Product { vector, magnitudes } => {
                Self { vector: vector.as_ptr(), magnitudes: (*magnitudes).into(), ..of(FMC_REQUEST_PRODUCT) }
            }
            Request::Diagonal => of(FMC_REQUEST_DIAGONAL),
            Request::Solve { x, part, shift, right } => {
                let tangent_flags = match part {
                    TangentPart::Full => 0,
                    TangentPart::Symmetric => SYMMETRIC,
                    TangentPart::Semidefinite => SEMIDEFINITE,
                };
                Self { x: x.as_ptr(), vector: right.as_ptr(), shift: *shift, tangent_flags, ..of(FMC_REQUEST_SOLVE) }
            }
            Request::Condensed { x, moved, forces, tolerance, absolute_tolerance } => Self {
                x: x.as_ptr(),
                vector: moved.as_ptr(),
                forces: forces.as_ptr(),
                tolerance: *tolerance,
                absolute_tolerance: *absolute_tolerance,
                ..of(FMC_REQUEST_CONDENSED)
            },
        }
    }
}
