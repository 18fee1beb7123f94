//! Derivatives: what is asked for, where it goes, and those by what a pair has.

use super::evaluation::side_of;
use super::slip_row;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_UNKNOWN_FLAG;
use crate::contact::{GradientRequest, Gradients, PairGradient};

/// Flag of `fmc_gradients`: by the stiffness of every pair that touches.
pub const FMC_GRADIENT_STIFFNESS: u32 = 1;

/// Flag of `fmc_gradients`: by the gap offset of every pair that touches.
pub const FMC_GRADIENT_GAP_OFFSET: u32 = 2;

/// Flag of `fmc_gradients`: by the coefficient of friction of every pair that touches.
pub const FMC_GRADIENT_FRICTION: u32 = 4;

/// Variables of `fmc_context_vjp`, and output arrays of the host. A derivative whose array is NULL is not computed. With n rows of
/// `coords` and m obstacles, removed ones included, all in dense rows.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_gradients {
    /// Set by `fmc_gradients_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// By the coordinates: room for n * dim numbers.
    pub coords: *mut f64,
    /// By the coordinates without deformation, as `fmc_context_set_reference` takes them, the current ones held: room for n * dim
    /// numbers. The law "depth" measures its depths from them; other laws do not depend on them.
    pub reference: *mut f64,
    /// By the position of every obstacle: room for m * dim numbers.
    pub positions: *mut f64,
    /// By a rotation vector of every obstacle about its position: room for m * 3 numbers; in 2D only the last of three differs from zero.
    pub rotations: *mut f64,
    /// Requested derivatives of every pair: a sum of `FMC_GRADIENT_STIFFNESS`, `FMC_GRADIENT_GAP_OFFSET` and `FMC_GRADIENT_FRICTION`,
    /// or 0.
    pub of_pairs: u64,
    /// Factors of the elastic slip at the end of the step, a third term next to energy and forces: rows as `fmc_context_slip` writes them.
    /// NULL: zeros. `fmc_context_commit_step` at `coords` would carry this slip on.
    pub slip_adjoint: *const f64,
    /// Number of entries.
    pub slip_adjoint_count: usize,
    /// By the elastic slip carried into the step: such rows, for every facet with friction. Room for `slip_capacity` numbers.
    pub slip: *mut f64,
    /// Room in `slip`.
    pub slip_capacity: usize,
    /// Becomes the number of entries. With `slip` NULL and no room only the number is returned; both NULL: no output.
    pub slip_count: *mut usize,
    /// Zero. Room for fields of later versions.
    pub reserved: [u64; 3],
}

impl Default for fmc_gradients {
    fn default() -> Self {
        let none = std::ptr::null_mut();
        let struct_size = size_of::<Self>();
        Self {
            struct_size,
            coords: none,
            reference: none,
            positions: none,
            rotations: none,
            of_pairs: 0,
            slip_adjoint: std::ptr::null(),
            slip_adjoint_count: 0,
            slip: none,
            slip_capacity: 0,
            slip_count: std::ptr::null_mut(),
            reserved: [0; 3],
        }
    }
}

impl fmc_gradients {
    /// What it asks for, if it was initialised and its pointers are those of arrays.
    pub(crate) fn request(&self) -> Result<GradientRequest, Failure> {
        check_struct::<Self>("fmc_gradients", self.struct_size, self.reserved)?;
        let outputs = [("coords", self.coords), ("reference", self.reference), ("positions", self.positions)];
        for (name, output) in outputs.into_iter().chain([("rotations", self.rotations), ("slip", self.slip)]) {
            Output::optional(name, output)?;
        }
        let has = |flag: u32| self.of_pairs & u64::from(flag) != 0;
        let known = FMC_GRADIENT_STIFFNESS | FMC_GRADIENT_GAP_OFFSET | FMC_GRADIENT_FRICTION;
        if self.of_pairs & !u64::from(known) != 0 {
            let text = format!("unknown flag in {:#x}, the field of_pairs of fmc_gradients", self.of_pairs);
            return Err(Failure::new(FMC_ERROR_UNKNOWN_FLAG, text));
        }
        Ok(GradientRequest {
            coords: !self.coords.is_null(),
            reference: !self.reference.is_null(),
            positions: !self.positions.is_null(),
            rotations: !self.rotations.is_null(),
            stiffness: has(FMC_GRADIENT_STIFFNESS),
            gap_offsets: has(FMC_GRADIENT_GAP_OFFSET),
            friction: has(FMC_GRADIENT_FRICTION),
            slip: !(self.slip.is_null() && self.slip_count.is_null()),
        })
    }

    /// Writes what is asked for.
    ///
    /// # Safety
    /// The host guarantees that its arrays, where given, have room for the lists.
    pub(crate) unsafe fn write(&self, lists: &GradientLists) {
        let outputs = [self.coords, self.reference, self.positions, self.rotations];
        for (list, output) in lists.by_place.iter().zip(outputs) {
            if !output.is_null() {
                // SAFETY: passed on to the caller; the list is our own and cannot overlap it.
                unsafe { std::ptr::copy_nonoverlapping(list.as_ptr(), output, list.len()) };
            }
        }
    }
}

/// Derivatives by the parameters of one pair; 0 if not requested. For `fmc_context_jvp` rates of these parameters.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pair_gradient {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// First side: a value of `fmc_partner`.
    pub a_kind: i32,
    /// Second side: a value of `fmc_partner`.
    pub b_kind: i32,
    /// First side: index for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
    pub a: usize,
    /// Second side; the same as the first for a body that overlaps itself.
    pub b: usize,
    /// By the stiffness k of the pair's law.
    pub stiffness: f64,
    /// By its gap offset.
    pub gap_offset: f64,
    /// By its coefficient of friction.
    pub friction: f64,
    /// Zero.
    pub reserved: [u64; 4],
}

impl From<&PairGradient> for fmc_pair_gradient {
    fn from(pair: &PairGradient) -> Self {
        let [(a_kind, a), (b_kind, b)] = pair.partners.map(side_of);
        let PairGradient { stiffness, gap_offset, friction, .. } = *pair;
        let struct_size = size_of::<Self>();
        Self { struct_size, a_kind, b_kind, a, b, stiffness, gap_offset, friction, reserved: [0; 4] }
    }
}

/// Derivatives with their dimension hidden.
pub(crate) struct GradientLists {
    /// By coordinates, reference, positions and rotations.
    pub(crate) by_place: [Vec<f64>; 4],
    pub(crate) pairs: Vec<fmc_pair_gradient>,
    /// By the slip at the start of the step, in rows.
    pub(crate) slip: Vec<f64>,
}

impl<const D: usize> From<Gradients<D>> for GradientLists {
    fn from(found: Gradients<D>) -> Self {
        let pairs = found.pairs.iter().map(fmc_pair_gradient::from).collect();
        let by_nodes = [found.coords, found.reference, found.positions].map(Vec::into_flattened);
        let [coords, reference, positions] = by_nodes;
        let by_place = [coords, reference, positions, found.rotations.into_flattened()];
        Self { by_place, pairs, slip: slip_row::rows(&found.slip) }
    }
}
