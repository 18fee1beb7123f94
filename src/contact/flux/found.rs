//! What hosts get.

use super::request::FluxRequest;
use crate::Error;
use crate::contact::tangents::{CompressedRows, compressed};
use crate::overlap::Block;

/// The flux of fields through contact.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactFlux {
    /// What flows out of every node into what it touches, field after field, as the fields were given: ∫ N h (T − T_other) dA.
    pub flux: Vec<f64>,
    /// The same out of every obstacle, field after field; zero where they have no values.
    pub of_obstacles: Vec<f64>,
    /// The derivative of the flux by the field, the same for every field: symmetric, positive semidefinite, and zero for a field that is the
    /// same everywhere. Rows and columns are nodes, then obstacles.
    pub matrix: CompressedRows<f64>,
}

impl ContactFlux {
    /// From sorted entries. `is_partition`: nodes whose fields are all 1 have a field of 1 everywhere.
    pub(crate) fn new(
        entries: &[Block<1>],
        request: &FluxRequest,
        [nodes, obstacles, fields]: [usize; 3],
        is_partition: bool,
    ) -> Result<Self, Error> {
        let entry = |block: &Block<1>| ((block.row, block.col), block.value[0][0]);
        let matrix = compressed(nodes + obstacles, None, entries.iter().map(entry), 0.0);
        let (mut flux, mut of_obstacles) = (Vec::with_capacity(fields * nodes), Vec::with_capacity(fields * obstacles));
        let mut values = vec![0.0; nodes + obstacles];
        for field in 0..fields {
            values[..nodes].copy_from_slice(&request.fields[field * nodes..(field + 1) * nodes]);
            if let Some(given) = request.of_obstacles {
                values[nodes..].copy_from_slice(&given[field * obstacles..(field + 1) * obstacles]);
            }
            // Differences alone matter: of what is equal everywhere nothing flows, to the bit.
            let level = if is_partition { values.first().copied().unwrap_or(0.0) } else { 0.0 };
            let of_row = |row: usize| -> f64 {
                let range = matrix.offsets[row]..matrix.offsets[row + 1];
                let columns = matrix.cols[range.clone()].iter().zip(&matrix.values[range]);
                columns.map(|(&col, h)| h * (values[col as usize] - level)).sum()
            };
            flux.extend((0..nodes).map(of_row));
            of_obstacles.extend((nodes..nodes + obstacles).map(of_row));
        }
        match flux.iter().chain(&of_obstacles).chain(&matrix.values).copied().find(|x| !x.is_finite()) {
            Some(value) => Err(Error::Overflow { quantity: "flux", value }),
            None => Ok(Self { flux, of_obstacles, matrix }),
        }
    }
}
