//! The dimension, as a host gives it.

use super::failure::Failure;
use super::status::fmc_status::FMC_ERROR_DIMENSION;

/// 2 or 3.
pub(crate) fn checked_dimension(dim: i32) -> Result<usize, Failure> {
    match dim {
        2 | 3 => Ok(dim as usize),
        _ => Err(Failure::new(FMC_ERROR_DIMENSION, format!("the dimension is {dim}, not 2 or 3"))),
    }
}
