//! How well contacts conduct.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::slice;
use crate::contact::Conductance;

/// Conductance h of a contact: flux per area and jump of the field, for heat W/(m^2 K). Tables are linear between their entries; each
/// has its own length.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_conductance {
    /// Set by `fmc_conductance_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Number of entries by pressure, where surfaces touch; 1 for a constant, 0 for no flux.
    pub pressure_count: usize,
    /// Pressures, ascending, not negative. h is constant before the first and beyond the last.
    pub pressures: *const f64,
    /// h at these pressures, not negative.
    pub by_pressure: *const f64,
    /// Number of entries by gap, where surfaces are apart; 0 for no flux.
    pub gap_count: usize,
    /// Gaps, ascending, not negative. h is constant before the first; beyond the last there is no flux.
    pub gaps: *const f64,
    /// h at these gaps, not negative.
    pub by_gap: *const f64,
    /// Zero. Room for fields of later versions.
    pub reserved: [u64; 8],
}

impl Default for fmc_conductance {
    fn default() -> Self {
        let none = std::ptr::null();
        Self {
            struct_size: size_of::<Self>(),
            pressure_count: 0,
            pressures: none,
            by_pressure: none,
            gap_count: 0,
            gaps: none,
            by_gap: none,
            reserved: [0; 8],
        }
    }
}

impl fmc_conductance {
    /// The tables, if it was initialised.
    ///
    /// # Safety
    /// The host guarantees arrays of the lengths that it says.
    pub(crate) unsafe fn tables(&self) -> Result<Conductance, Failure> {
        check_struct::<Self>("fmc_conductance", self.struct_size, self.reserved)?;
        // SAFETY: passed on to the caller.
        unsafe {
            Ok(Conductance {
                by_pressure: table(
                    ("pressures", self.pressures),
                    ("by_pressure", self.by_pressure),
                    self.pressure_count,
                )?,
                by_gap: table(("gaps", self.gaps), ("by_gap", self.by_gap), self.gap_count)?,
            })
        }
    }
}

/// # Safety
/// The host guarantees arrays of this length.
unsafe fn table(
    (places_name, places): (&str, *const f64),
    (values_name, values): (&str, *const f64),
    count: usize,
) -> Result<Vec<[f64; 2]>, Failure> {
    // SAFETY: passed on to the caller.
    let (places, values) = unsafe { (slice(places_name, places, count, 1)?, slice(values_name, values, count, 1)?) };
    Ok(places.iter().zip(values).map(|(place, value)| [*place, *value]).collect())
}
