//! Partners as the host names them.

use super::evaluation::fmc_partner;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BAD_VALUE;
use crate::overlap::Partner;

/// The partner that the host names.
pub(crate) fn partner(kind: i32, index: usize) -> Result<Partner, Failure> {
    match kind {
        _ if kind == fmc_partner::FMC_PARTNER_BODY as i32 => Ok(Partner::Body(index)),
        _ if kind == fmc_partner::FMC_PARTNER_OBSTACLE as i32 => Ok(Partner::Obstacle(index)),
        _ => Err(Failure::new(FMC_ERROR_BAD_VALUE, format!("{kind} is no value of fmc_partner"))),
    }
}
