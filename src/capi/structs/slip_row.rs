//! Elastic slip that is carried, as rows of numbers.

use super::evaluation::side_of;
use super::partner::partner;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_INDEX_OUT_OF_RANGE, FMC_ERROR_LENGTH};
use crate::contact::FacetSlip;

/// Numbers of a row: facet, kind and index of what it faces, side, slip, how far it has slid.
pub(crate) const WIDTH: usize = 8;

/// Rows of a list.
pub(crate) fn rows<const D: usize>(slip: &[FacetSlip<D>]) -> Vec<f64> {
    let row = |one: &FacetSlip<D>| -> [f64; WIDTH] {
        let (kind, partner) = side_of(one.partner);
        let mut row = [0.0; WIDTH];
        row[..4].copy_from_slice(&[
            one.facet as f64,
            f64::from(kind),
            partner as f64,
            f64::from(u8::from(one.is_second)),
        ]);
        row[4..4 + D].copy_from_slice(&one.slip);
        row[7] = one.slid;
        row
    };
    slip.iter().flat_map(row).collect()
}

/// The list of rows.
pub(crate) fn list<const D: usize>(numbers: &[f64]) -> Result<Vec<FacetSlip<D>>, Failure> {
    let (rows, rest) = numbers.as_chunks::<WIDTH>();
    if !rest.is_empty() {
        let text = format!("'slip' has {} numbers, and rows of {WIDTH} are expected", numbers.len());
        return Err(Failure::new(FMC_ERROR_LENGTH, text));
    }
    rows.iter().enumerate().map(|(place, row)| one(place, row)).collect()
}

fn one<const D: usize>(place: usize, row: &[f64; WIDTH]) -> Result<FacetSlip<D>, Failure> {
    // What is written elsewhere, as slips of one for every facet, is no such row.
    let is_index = |x: &f64| *x >= 0.0 && *x < f64::from(u32::MAX) && x.fract() == 0.0;
    let is_rest = |x: &f64| *x == 0.0;
    if !row[..4].iter().all(is_index) || row[3] > 1.0 || !row[4 + D..7].iter().all(is_rest) {
        let text = format!("row {place} of 'slip', counted from 0, is none that fmc_context_slip writes");
        return Err(Failure::new(FMC_ERROR_INDEX_OUT_OF_RANGE, text));
    }
    Ok(FacetSlip {
        facet: row[0] as usize,
        partner: partner(row[1] as i32, row[2] as usize)?,
        is_second: row[3] == 1.0,
        slip: std::array::from_fn(|axis| row[4 + axis]),
        slid: row[7],
    })
}
