//! What hosts are told of ties.

/// A tie, as it was found where nothing is deformed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TieSummary {
    /// What is tied, in area (2D: length; with axisymmetry the area of whole rings).
    pub area: f64,
    /// The largest gap, or overlap, that is kept between the surfaces.
    pub largest_gap: f64,
    /// How far apart faces might be, or how far they might overlap: as it was given, or what it is by default.
    pub reach: f64,
    /// Number of means of the jump that are held: of nodes of the side that holds, mostly that with the larger facets.
    pub count: usize,
}

/// A node of a tie, of the side that holds, mostly that with the larger facets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TieNode<const D: usize> {
    /// The node; with cells of second order the point ([`PointWeights`](crate::PointWeights)).
    pub node: u32,
    /// Its body, and the body that it is tied to.
    pub bodies: [usize; 2],
    /// The area that it stands for.
    pub area: f64,
    /// Traction on its body, force by area.
    pub traction: [f64; D],
    /// Mean of how far its body has moved away from the other one.
    pub jump: [f64; D],
}

/// Ties as equations: Σ weights · x = 0 for every axis alone, where no gap is kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TieConstraints {
    /// Where each row begins in `columns` and `weights`, and the end of the last.
    pub row_starts: Vec<usize>,
    /// Nodes, or a host's unknowns.
    pub columns: Vec<u32>,
    /// Their weights; those of a row sum up to 0, those of one side to 1 and −1.
    pub weights: Vec<f64>,
}
