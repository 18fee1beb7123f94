//! The tangent, entry by entry or row by row.

pub(super) mod compressed_rows;
pub(super) mod entries;
