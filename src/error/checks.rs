//! Numbers that are checked in many places.

use super::Error;

impl Error {
    /// Refuses a number that is negative, or none.
    pub(crate) fn check_not_negative(name: &'static str, value: f64) -> Result<(), Self> {
        if value.is_finite() && value >= 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
    }
}
