//! Where the map of a cell of second order is looked at.

/// A place at which the map of a cell of second order is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapPoint {
    /// A node, by its number in the cell.
    Node(usize),
    /// A point of the rule by which stiffness is mostly integrated, from 0, the first coordinate fastest: 3 points in `Tri6`, 4 in
    /// `Tet10`, 9 in `Quad8`, `Quad9` and `Wedge15`, 27 in `Hex20` and `Hex27`, 8 in `Pyramid13`.
    Quadrature(usize),
}
