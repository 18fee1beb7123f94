//! Rates of what energy and forces depend on.

use super::gradients::fmc_pair_gradient;
use super::partner::partner;
use super::slip_row;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE};
use crate::contact::{FacetSlip, PairGradient};

/// Direction of `fmc_context_jvp`: rates of all variables of energy and forces, applied together. Variables with NULL or 0 are held.
/// With n rows of `coords` and m obstacles, removed ones included, all in dense rows; units are the unit of the variable / a unit that
/// the host chooses, such as a time.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_directions {
    /// Set by `fmc_directions_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Of the coordinates: n * dim numbers.
    pub coords: *const f64,
    /// Of the position of every obstacle: m * dim numbers.
    pub positions: *const f64,
    /// Of a rotation vector of every obstacle about its position: m * 3 numbers; in 2D only the last of three counts.
    pub rotations: *const f64,
    /// Of the stiffness k of every pair that touches.
    pub stiffness: f64,
    /// Of the gap offset of every pair that touches.
    pub gap_offset: f64,
    /// Of the coefficient of friction of every pair that touches.
    pub friction: f64,
    /// Of single pairs, in addition: structs as `fmc_context_vjp` writes them, with rates in the place of derivatives. A pair that does not
    /// touch has no effect.
    pub pairs: *const fmc_pair_gradient,
    /// Number of structs.
    pub pair_count: usize,
    /// Of the elastic slip carried into the step: rows as `fmc_context_slip` writes them, whose last number is not read.
    pub slip: *const f64,
    /// Number of entries.
    pub slip_count: usize,
    /// Zero. Room for fields of later versions.
    pub reserved: [u64; 4],
}

impl Default for fmc_directions {
    fn default() -> Self {
        let none = std::ptr::null();
        let struct_size = size_of::<Self>();
        Self {
            struct_size,
            coords: none,
            positions: none,
            rotations: none,
            stiffness: 0.0,
            gap_offset: 0.0,
            friction: 0.0,
            pairs: std::ptr::null(),
            pair_count: 0,
            slip: none,
            slip_count: 0,
            reserved: [0; 4],
        }
    }
}

/// The arrays of one, read.
pub(crate) struct DirectionLists<'a, const D: usize> {
    pub(crate) coords: Option<&'a [[f64; D]]>,
    pub(crate) positions: Option<&'a [[f64; D]]>,
    pub(crate) rotations: Option<&'a [[f64; 3]]>,
    pub(crate) pairs: Vec<PairGradient>,
    pub(crate) slip: Vec<FacetSlip<D>>,
}

impl fmc_directions {
    /// Its arrays, for so many nodes and obstacles.
    ///
    /// # Safety
    /// The host guarantees that its arrays, where given, have that many numbers, unchanged for `'a`.
    pub(crate) unsafe fn lists<'a, const D: usize>(
        &self,
        nodes: usize,
        obstacles: usize,
    ) -> Result<DirectionLists<'a, D>, Failure> {
        check_struct::<Self>("fmc_directions", self.struct_size, self.reserved)?;
        // SAFETY: passed on to the caller.
        let (coords, positions, rotations, pairs, slip) = unsafe {
            (
                rows("coords", self.coords, nodes)?,
                rows("positions", self.positions, obstacles)?,
                rows("rotations", self.rotations, obstacles)?,
                slice("pairs", self.pairs, self.pair_count, 1)?,
                slice("slip", self.slip, self.slip_count, 1)?,
            )
        };
        let pairs = pairs.iter().enumerate().map(rates_of).collect::<Result<_, _>>()?;
        Ok(DirectionLists { coords, positions, rotations, pairs, slip: slip_row::list(slip)? })
    }
}

/// Rows of an array that may be NULL.
///
/// # Safety
/// As for [`fmc_directions::lists`].
unsafe fn rows<'a, const N: usize>(
    name: &str,
    pointer: *const f64,
    count: usize,
) -> Result<Option<&'a [[f64; N]]>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: passed on to the caller.
    Ok(Some(unsafe { slice(name, pointer, count, N) }?.as_chunks().0))
}

fn rates_of((place, rates): (usize, &fmc_pair_gradient)) -> Result<PairGradient, Failure> {
    let expected = size_of::<fmc_pair_gradient>();
    if rates.struct_size != expected {
        let text = format!("pairs[{place}] has struct_size {}, expected {expected}", rates.struct_size);
        return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, text));
    }
    if rates.reserved != [0; 4] {
        let text = format!("a reserved field of pairs[{place}] is not zero");
        return Err(Failure::new(FMC_ERROR_RESERVED_FIELD, text));
    }
    let mut pair = PairGradient::new([partner(rates.a_kind, rates.a)?, partner(rates.b_kind, rates.b)?]);
    (pair.stiffness, pair.gap_offset, pair.friction) = (rates.stiffness, rates.gap_offset, rates.friction);
    Ok(pair)
}
