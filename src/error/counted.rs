//! Errors in the numbering of a host that does not count from 0.

use super::Error;

impl Error {
    /// The same with its nodes, cells, facets, degrees of freedom and unknowns counted from `base`. Numbers that are reported as
    /// they were given stay, and so do bodies, obstacles, axes, ranks, and places in arrays.
    #[must_use]
    pub fn counted_from(mut self, base: usize) -> Self {
        // Every variant stands here, so that a new one cannot be forgotten.
        match &mut self {
            Error::NodeOutOfRange { cell, node: _, node_count: _ }
            | Error::InvertedCell { cell }
            | Error::FoldedCell { cell, at: _, determinant: _ }
            | Error::Collapsed { cell, length: _, tolerance: _ }
            | Error::ZeroMeasure { cell } => *cell += base,
            Error::NonFiniteCoordinate { node, axis: _ }
            | Error::NegativeRadius { node, radius: _ }
            | Error::NotPositiveMass { node, value: _ } => *node += base,
            Error::RepeatedNode { cell, node } => {
                *cell += base;
                *node += base;
            }
            Error::InvertedCells { cells, bow_ties: _ } => cells.iter_mut().for_each(|cell| *cell += base),
            Error::UnknownOutOfRange { row, unknown: _, count: _ } => *row += base,
            Error::NonConforming { cells } | Error::RepeatedCell { cells } => {
                cells.iter_mut().for_each(|cell| *cell += base);
            }
            Error::OpenSurface { facet, nodes }
            | Error::NonManifold { facet, nodes }
            | Error::InconsistentOrientation { facet, nodes } => {
                *facet += base;
                nodes.iter_mut().for_each(|node| *node += base);
            }
            Error::NonFiniteSlip { facet } => *facet += base,
            Error::DofOutOfRange { dof, count: _ } => *dof += base as i64,
            Error::NotPositiveDefinite { equation } => *equation += base,
            Error::Unsymmetric { row, column } => {
                *row += base;
                *column += base;
            }
            Error::RepeatedDof { dof }
            | Error::SingularStiffness { dof }
            | Error::IndefiniteStiffness { dof, pivot: _ } => *dof += base,
            Error::OfPair { sides: _, cause } => {
                let own = std::mem::replace(&mut **cause, Error::Empty);
                **cause = own.counted_from(base);
            }
            // Handles, axes, blocks and places in arrays.
            Error::Length { array: _, expected: _, found: _ }
            | Error::Dimension { block: _, expected: _, found: _ }
            | Error::InvertedSurface { body: _ }
            | Error::BadPose { obstacle: _ }
            | Error::ObstacleOutOfRange { obstacle: _, count: _ }
            | Error::ObstacleRemoved { obstacle: _ }
            | Error::BodyOutOfRange { body: _, count: _ }
            | Error::NonFiniteStiffness { array: _, entry: _ }
            | Error::NoSuchNumber { array: _, entry: _, number: _ }
            | Error::BadEntry { array: _, entry: _, value: _ }
            | Error::InterfaceLaw(_)
            | Error::FrictionLaw(_)
            | Error::NoSuchRow { list: _, row: _, what: _ }
            | Error::DegenerateHull { point_count: _ }
            | Error::TooFewHeights { axis: _, count: _ }
            | Error::NonFiniteHeight { point: _ }
            | Error::SteepDistance { obstacle: _, places: _, phi: _ }
            | Error::SignedDistance { obstacle: _, point: _ }
            | Error::UnfinishedLines { obstacle: _, lines: _, steps: _ }
            | Error::TooManyPieces { sides: _, limit: _ }
            | Error::BadRank { rank: _, size: _ }
            | Error::OnOtherRank { rank: _ }
            | Error::RanksDiffer { rank: _ }
            | Error::NotGathered { body: _ } => {}
            // No numbers of anything.
            Error::Empty
            | Error::NotPositive { name: _, value: _ }
            | Error::NotFactorised
            | Error::Place { code: _ }
            | Error::NoStep
            | Error::NoStiffness
            | Error::Untied { bodies: _, distances: _, held: _ }
            | Error::EmptyCompound
            | Error::Unsupported { what: _ }
            | Error::TooManyFibers { needed: _, limit: _ }
            | Error::Interrupted
            | Error::Memory { what: _, bytes: _ }
            | Error::Overflow { quantity: _, value: _ }
            | Error::Communication { code: _ }
            | Error::Threads { threads: _ } => {}
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_cells_nodes_and_facets_also_of_a_cause() {
        let error = Error::RepeatedNode { cell: 0, node: 4 };
        assert_eq!(error.clone().counted_from(1), Error::RepeatedNode { cell: 1, node: 5 });
        assert_eq!(Error::NonFiniteSlip { facet: 2 }.counted_from(1), Error::NonFiniteSlip { facet: 3 });
        let of_pair = |cause| Error::OfPair { sides: [("body", 0), ("obstacle", 1)], cause: Box::new(cause) };
        assert_eq!(of_pair(error).counted_from(1), of_pair(Error::RepeatedNode { cell: 1, node: 5 }));
        let dof = |dof| Error::DofOutOfRange { dof, count: 4 };
        assert_eq!(dof(9).counted_from(1), dof(10));
        let given = Error::NodeOutOfRange { cell: 0, node: 9, node_count: 4 };
        assert_eq!(given.counted_from(1), Error::NodeOutOfRange { cell: 1, node: 9, node_count: 4 });
    }
}
