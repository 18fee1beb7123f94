//! Options that take one of a few values.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BAD_VALUE;

/// An option that takes one of a few values, each with its number and name.
pub(crate) struct Choice {
    pub(crate) key: &'static str,
    pub(crate) values: &'static [(i32, &'static str)],
}

impl Choice {
    /// Name of a value, or the failure that there is none.
    pub(crate) fn name(&self, value: i32) -> Result<&'static str, Failure> {
        self.values
            .iter()
            .find(|(number, _)| *number == value)
            .map(|(_, name)| *name)
            .ok_or_else(|| Failure::new(FMC_ERROR_BAD_VALUE, format!("option '{}' has no value {value}", self.key)))
    }

    pub(crate) fn is_on(&self, value: i32) -> Result<bool, Failure> {
        Ok(self.name(value)? == "1")
    }
}
