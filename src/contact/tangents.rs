//! Second derivatives of the energy: `tangent`, row by row in `compressed_rows` and `pattern`

mod compressed_rows;
mod pattern;
mod tangent;

pub use compressed_rows::CompressedRows;
pub(crate) use compressed_rows::compressed;
pub use pattern::Pattern;
pub use tangent::{RankOne, Tangent, TangentPart};
