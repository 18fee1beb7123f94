//! Worn facets, as rows of numbers.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_INDEX_OUT_OF_RANGE, FMC_ERROR_LENGTH};
use crate::contact::WornFacet;

/// Numbers of a row: facet, point, depth, volume.
const WIDTH: usize = 4;

/// Rows of a list.
pub(crate) fn rows(worn: &[WornFacet]) -> Vec<f64> {
    worn.iter().flat_map(|one| [one.facet as f64, f64::from(one.point), one.depth, one.volume]).collect()
}

/// The list of rows.
pub(crate) fn list(numbers: &[f64]) -> Result<Vec<WornFacet>, Failure> {
    let (rows, rest) = numbers.as_chunks::<WIDTH>();
    if !rest.is_empty() {
        let text = format!("'worn' has {} numbers, and rows of {WIDTH} are expected", numbers.len());
        return Err(Failure::new(FMC_ERROR_LENGTH, text));
    }
    let one = |(place, &[facet, point, depth, volume]): (usize, &[f64; WIDTH])| {
        let is_index = |x: f64| x >= 0.0 && x < f64::from(u32::MAX) && x.fract() == 0.0;
        if !(is_index(facet) && is_index(point)) {
            let text = format!("row {place} of 'worn', counted from 0, is none that fmc_context_worn_facets writes");
            return Err(Failure::new(FMC_ERROR_INDEX_OUT_OF_RANGE, text));
        }
        Ok(WornFacet { facet: facet as usize, point: point as u32, depth, volume })
    };
    rows.iter().enumerate().map(one).collect()
}
