//! Displacements of any basis: nodes as combinations of a host's own unknowns.

use super::interpolation::Interpolation;
use crate::Error;

/// The matrix from a host's unknowns to the nodes of the mesh, in compressed rows: node r lies at the sum of
/// `weights[k]` times the coordinates of unknown `unknowns[k]`, for k from `row_starts[r]` to `row_starts[r + 1]`.
///
/// Unknowns are what the host's shape functions multiply: control points of splines, coefficients of hierarchical functions
/// (whose rows need not add up to one), nodes of another mesh. Each has a coordinate per axis.
#[derive(Clone, Copy, Debug)]
pub struct Basis<'a> {
    /// Number of unknowns.
    pub unknown_count: usize,
    /// Where rows begin in the other two, one number more than there are nodes.
    pub row_starts: &'a [usize],
    /// Unknowns of every row, in any order.
    pub unknowns: &'a [u32],
    /// Values of their shape functions.
    pub weights: &'a [f64],
}

impl Basis<'_> {
    /// The rows, checked, of `node_count` nodes.
    pub(super) fn checked(&self, node_count: usize) -> Result<Vec<Vec<(u32, f64)>>, Error> {
        let length = |array, expected, found| match expected == found {
            true => Ok(()),
            false => Err(Error::Length { array, expected, found }),
        };
        length("row_starts", node_count + 1, self.row_starts.len())?;
        let is_ascending = self.row_starts.first() == Some(&0) && self.row_starts.is_sorted();
        if !is_ascending {
            return Err(Error::Unsupported { what: "row starts of a basis that do not begin at 0, or descend" });
        }
        let entries = self.row_starts.last().copied().unwrap_or(0);
        length("unknowns", entries, self.unknowns.len())?;
        length("weights", entries, self.weights.len())?;
        let row = |(row, ends): (usize, &[usize])| {
            let entry = |k: usize| {
                let (unknown, weight) = (self.unknowns[k], self.weights[k]);
                if unknown as usize >= self.unknown_count {
                    return Err(Error::UnknownOutOfRange { row, unknown: unknown.into(), count: self.unknown_count });
                }
                if !weight.is_finite() {
                    return Err(Error::Overflow { quantity: "weight in a basis", value: weight });
                }
                Ok((unknown, weight))
            };
            (ends[0]..ends[1]).map(entry).collect()
        };
        self.row_starts.windows(2).enumerate().map(row).collect()
    }
}

impl Interpolation {
    /// Points as combinations of the unknowns whose combinations the nodes are.
    pub(super) fn of_unknowns(&self, basis: &Basis) -> Result<Self, Error> {
        let of_node = basis.checked(self.node_count())?;
        let row = |point: usize| {
            let mut sums = std::collections::BTreeMap::new();
            for (node, weight) in self.row(point) {
                for &(unknown, part) in &of_node[node as usize] {
                    *sums.entry(unknown).or_insert(0.0) += weight * part;
                }
            }
            sums.into_iter().collect::<Vec<_>>()
        };
        let rows: Vec<_> = (0..self.point_count()).map(row).collect();
        Ok(Self::new(basis.unknown_count, &rows, |point| self.is_used(point)))
    }
}
