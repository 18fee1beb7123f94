//! The texts of errors.

use super::{Error, FrictionFault, LawFault, MapPoint};
use std::fmt;

impl std::error::Error for Error {}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Length { array, expected, found } => {
                write!(f, "array '{array}' has length {found}, expected {expected}")
            }
            Error::Dimension { block, expected, found } => {
                write!(
                    f,
                    "block {block} has cells of dimension {found}, or facets of such, but the coordinates have \
                     dimension {expected}"
                )
            }
            Error::NodeOutOfRange { cell, node, node_count } => {
                write!(f, "cell or facet {cell} names node {node}, but there are {node_count} nodes")
            }
            Error::NonFiniteCoordinate { node, axis } => write!(f, "coordinate {axis} of node {node} is not finite"),
            Error::NegativeRadius { node, radius } => {
                write!(f, "node {node} lies beyond the axis of axisymmetry: its first coordinate is {radius:.3e}")
            }
            Error::RepeatedNode { cell, node } => write!(f, "cell or facet {cell} names node {node} twice"),
            Error::UnknownOutOfRange { row, unknown, count } => {
                write!(f, "row {row} of the basis names unknown {unknown}, but there are {count}")
            }
            Error::NonConforming { cells: [one, other] } => write!(
                f,
                "cells {one} and {other} do not conform (facets, where there are no cells): an edge or a face has a \
                 node in its middle in only one of them, or they have different nodes there, or a hanging node is not \
                 in the middle"
            ),
            Error::InvertedCell { cell } => write!(
                f,
                "cell {cell} is inverted (a facet, where there are no cells): its nodes are numbered in the opposite \
                 sense to other cells, a node in the middle of an edge is too near to a corner, or a step of the host \
                 was too large"
            ),
            Error::Collapsed { cell, length, tolerance } => write!(
                f,
                "'weld' is {tolerance:.3e}, which would merge two nodes of cell {cell} that are {length:.3e} apart: \
                 it must be smaller than every edge"
            ),
            Error::InvertedCells { cells, bow_ties } => {
                let first = cells.first().copied().unwrap_or_default();
                let (is, count) =
                    if cells.len() == 1 { ("is", "1 cell".into()) } else { ("are", format!("{} cells", cells.len())) };
                write!(f, "{count} {is} inverted, the first is {first}")?;
                match bow_ties {
                    0 => write!(f, ": nodes are numbered in the opposite sense to other cells, or cells are folded"),
                    _ => write!(
                        f,
                        "; edges cross in {bow_ties} of them (a bow tie): their nodes do not go around the quadrilateral"
                    ),
                }
            }
            Error::FoldedCell { cell, at, determinant } => {
                let (kind, number) = match at {
                    MapPoint::Node(node) => ("node", node),
                    MapPoint::Quadrature(point) => ("quadrature point", point),
                };
                write!(
                    f,
                    "cell {cell} is inverted at its {kind} {number}, where the Jacobian determinant is {determinant:e}: a node in \
                     the middle of an edge is too near to a corner, or a step of the host was too large"
                )
            }
            Error::ZeroMeasure { cell } => write!(f, "cell or facet {cell} has zero measure"),
            Error::OpenSurface { facet, nodes } => {
                write!(f, "the surface is open: facet {facet} has no neighbour at {}", at(*nodes))
            }
            Error::RepeatedCell { cells: [one, other] } => {
                write!(f, "cells {one} and {other} have the same nodes: one of them is a duplicate")
            }
            Error::NonManifold { facet, nodes } => {
                write!(f, "facet or cell {facet} is the third to meet at {}", at(*nodes))
            }
            Error::InconsistentOrientation { facet, nodes } => {
                write!(f, "facet or cell {facet} is oriented against its neighbour at {}", at(*nodes))
            }
            Error::InvertedSurface { body } => {
                write!(f, "the facets of body {body} point inwards: they enclose a negative volume")
            }
            Error::Empty => write!(f, "there are no cells and no facets"),
            Error::NotPositive { name, value } => write!(f, "'{name}' is {value}, which is not allowed"),
            Error::BadEntry { array, entry, value } => {
                write!(f, "entry {entry} of '{array}' is {value}, which is not allowed")
            }
            Error::NoSuchNumber { array, entry, number: [number, count] } => {
                write!(f, "entry {entry} of '{array}' is {number}, and there are {count}")
            }
            Error::NotPositiveMass { node, value } => {
                write!(f, "node {node} feels contact, and its mass is {value}: a positive one is needed")
            }
            Error::BadPose { obstacle } => {
                write!(f, "the pose of obstacle {obstacle} is not a finite position, a rotation and a positive scale")
            }
            Error::ObstacleOutOfRange { obstacle, count } => {
                write!(f, "there is no obstacle {obstacle}, only {count}")
            }
            Error::ObstacleRemoved { obstacle } => write!(f, "obstacle {obstacle} was removed"),
            Error::BodyOutOfRange { body, count } => write!(f, "there is no body {body}, only {count}"),
            Error::OfPair { sides: [(first, a), (second, b)], cause } => {
                write!(f, "pair of {first} {a} and {second} {b}: {cause}")
            }
            Error::DofOutOfRange { dof, count } => {
                write!(f, "a list names degree of freedom {dof}, but there are {count}")
            }
            Error::RepeatedDof { dof } => {
                write!(f, "degree of freedom {dof} is named twice, or after one of a higher number")
            }
            Error::NonFiniteStiffness { array, entry } => write!(f, "entry {entry} of '{array}' is not finite"),
            Error::SingularStiffness { dof } => write!(
                f,
                "the stiffness of bodies and contact together is singular at degree of freedom {dof}: is every body \
                 supported?"
            ),
            Error::IndefiniteStiffness { dof, pivot } => write!(
                f,
                "the stiffness of bodies and contact together is not positive definite: it is {pivot:.3e} at degree of \
                 freedom {dof}, when those before it move freely"
            ),
            Error::NotPositiveDefinite { equation } => write!(
                f,
                "the stiffness is not positive definite, with a non-positive pivot at equation {equation}: is every \
                 body supported, or are the equations retained through which contact supports it?"
            ),
            Error::NotFactorised => {
                write!(f, "there are no factors: no matrix was factorised, or the last one could not be")
            }
            Error::Unsymmetric { row, column } => {
                write!(f, "the matrix is not symmetric: entry ({row}, {column}) differs from entry ({column}, {row})")
            }
            Error::Place { code } => write!(f, "the function that places the nodes returned {code}"),
            Error::NonFiniteSlip { facet } => write!(f, "the slip of facet {facet} is not finite"),
            Error::NoSuchRow { list, row, what } => write!(f, "row {row} of the {list}, counted from 0, names {what}"),
            Error::NoStep => {
                write!(
                    f,
                    "no step has begun: call begin_step before contact with friction is evaluated, and before \
                     commit_step; or use contact_force_step, in one call"
                )
            }
            Error::NoStiffness => {
                write!(
                    f,
                    "the contact has no stiffness: give one, or let the search for an equilibrium find it from the \
                     bodies' matrix"
                )
            }
            Error::Untied { bodies: [a, b], distances: [reach, nearest], held } => {
                write!(f, "bodies {a} and {b} are {held}, and ")?;
                if !nearest.is_finite() {
                    return write!(f, "none of their faces lie opposite one another");
                }
                write!(
                    f,
                    "face one another nowhere within {reach:.4e}: the nearest faces are {nearest:.4e} apart, or \
                     overlap by as much; a larger reach holds them together"
                )
            }
            Error::DegenerateHull { point_count } => {
                write!(f, "the convex hull of these {point_count} points is flat, or cannot be found to rounding")
            }
            Error::TooFewHeights { axis, count } => {
                write!(f, "the height field has {count} points along axis {axis}, and at least 2 are needed")
            }
            Error::NonFiniteHeight { point } => write!(f, "height {point} is not finite"),
            Error::EmptyCompound => write!(f, "the compound has no parts"),
            Error::Unsupported { what } => write!(f, "not supported: {what}"),
            Error::SteepDistance { obstacle, places: [[a, b, c], [d, e, g]], phi: [p, q] } => {
                write!(
                    f,
                    "the signed distance of obstacle {obstacle} grows faster than a distance can: it is {p:.6e} at ({a:.6}, {b:.6}, {c:.6}) \
                     and {q:.6e} at ({d:.6}, {e:.6}, {g:.6}); divide it by its steepest slope"
                )
            }
            Error::InterfaceLaw(LawFault { bodies: [a, b], point, cause }) => {
                write!(f, "the law of the interface of bodies {a} and {b}")?;
                point.map_or(Ok(()), |point| write!(f, ", at point {point}"))?;
                write!(f, ": {cause}")
            }
            Error::FrictionLaw(FrictionFault { sides: [(kind, a), (other, b)], facet, cause }) => {
                write!(f, "the law of friction of {kind} {a} and {other} {b}")?;
                facet.map_or(Ok(()), |facet| write!(f, ", at facet {facet}"))?;
                write!(f, ": {cause}")
            }
            Error::SignedDistance { obstacle, point } => {
                write!(
                    f,
                    "the signed distance of obstacle {obstacle} failed or is not finite at point {point} of the batch"
                )
            }
            Error::TooManyFibers { needed, limit } => {
                write!(
                    f,
                    "the spacing is too small for these bodies: {needed:.3e} fibers or crossings would be needed, the \
                     limit is {limit:.3e}; a diverged step of the host has the same effect"
                )
            }
            Error::UnfinishedLines { obstacle, lines, steps } => {
                write!(
                    f,
                    "{lines} lines along the boundary of obstacle {obstacle} were not searched to their ends in {steps} \
                     steps: its resolution, or the spacing of the lines, is too fine"
                )
            }
            Error::TooManyPieces { sides: [(first, a), (second, b)], limit } => {
                write!(
                    f,
                    "the facets of {first} {a} and {second} {b} lie in so many layers that they fall apart into more \
                     than {limit} pieces: a mesh is folded through itself, or a step of the host has diverged"
                )
            }
            Error::Interrupted => write!(f, "the call was ended by its caller"),
            Error::Memory { what, bytes } => write!(f, "{bytes} bytes for {what} could not be allocated"),
            Error::Overflow { quantity, value } => {
                write!(f, "the {quantity} is {value}: beyond the range of a double")
            }
            Error::NotGathered { body } => {
                write!(
                    f,
                    "body {body} may be in contact where its cells were not gathered: bring the parts of the mesh to "
                )?;
                f.write_str("these coordinates first")
            }
            Error::BadRank { rank, size } => write!(f, "rank {rank} of {size}: ranks are counted from 0"),
            Error::Communication { code } => write!(f, "the communicator failed with {code}"),
            Error::OnOtherRank { rank } => {
                write!(f, "the evaluation failed on rank {rank}, which has the cause, so that it ends on all ranks")
            }
            Error::RanksDiffer { rank } => {
                write!(
                    f,
                    "rank {rank} was given other coordinates, options or obstacles, or made another call: ranks that \
                     share the work of a contact make the same calls with the same values"
                )
            }
            Error::Threads { threads } => {
                write!(f, "{threads} threads could not be started; 'threads' may be 1 to 1024")
            }
        }
    }
}

/// An edge of the surface, in the plane a node.
fn at(nodes: [usize; 2]) -> String {
    match nodes {
        [first, second] if first == second => format!("node {first}"),
        [first, second] => format!("nodes {first} and {second}"),
    }
}
