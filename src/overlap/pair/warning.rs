//! Warnings of an estimate.

use crate::overlap::pair::partner::Partner;
use std::fmt;

/// A caution about a result, which is valid all the same.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The spacing of the fibers is larger than the facets in contact: nodal forces are noisy.
    CoarseFibers {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Spacing of the fibers.
        spacing: f64,
        /// Mean size of the smaller facets in contact.
        facet_size: f64,
    },
    /// Only a few fibers cross the overlap, or so few were laid that it may have been missed: it is thinner or smaller
    /// than their spacing.
    UnresolvedOverlap {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Fibers that lie in the overlap.
        fibers: usize,
    },
    /// The law `fiber` does not count a patch of the contact, since another of the same overlap is much shallower or
    /// larger: the two bodies push apart there by less than they should, or not at all. Two bodies in place of one that
    /// has both walls, or the law `volume`, count it.
    PatchLeftOut {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Unit normal of the patch, outwards of the first body; the third component is 0 in the plane.
        normal: [f64; 3],
        /// Its area (2D: length).
        area: f64,
        /// Its mean penetration.
        depth: f64,
    },
    /// Forces or moments of the pair do not add up to zero, as those of an exact overlap should: a facet was taken to lie
    /// on the wrong side, or patches of the contact could not be told apart. Forces may be wrong by as much.
    Unbalanced {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Size of the sum by the sum of sizes.
        imbalance: f64,
    },
    /// With the law `depth`, faces of both bodies lie in one plane, look the same way and reach into the overlap, as planes
    /// of symmetry do; and the host has not said which nodes lie in such planes (`Contact::set_symmetry_nodes`, with no
    /// nodes if there are none). Beside a plane of symmetry that is taken for surface the pressure is too low, by about
    /// twice the penetration by the size of the cells.
    FlushFaces {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Area (2D: length) of what coincides.
        area: f64,
    },
    /// One body lies inside the other: the overlap has no boundary on the other and does not push it out.
    SwallowedBody {
        /// The body inside.
        inner: Partner,
        /// The body around it.
        outer: Partner,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Warning::CoarseFibers { a, b, spacing, facet_size } => write!(
                f,
                "{a} and {b}: the fibers are {spacing:.3e} apart, the facets in contact only {facet_size:.3e} wide"
            ),
            Warning::UnresolvedOverlap { a, b, fibers } => {
                write!(f, "{a} and {b}: the overlap was met by {fibers} fibers only")
            }
            Warning::PatchLeftOut { a, b, normal: [x, y, z], area, depth } => write!(
                f,
                "{a} and {b}: a patch of the contact is not counted beside a shallower or larger one; its area is {area:.3e}, \
                 its penetration {depth:.3e}, its normal ({x:.3}, {y:.3}, {z:.3})"
            ),
            Warning::Unbalanced { a, b, imbalance } => {
                write!(f, "{a} and {b}: the forces between them do not balance, by {imbalance:.1e} of their size")
            }
            Warning::FlushFaces { a, b, area } => write!(
                f,
                "{a} and {b}: faces of an area of {area:.3e} lie in one plane and look the same way; if it is a plane of \
                 symmetry, name its nodes (symmetry nodes), if not, name none"
            ),
            Warning::SwallowedBody { inner, outer } => write!(f, "{inner} lies inside {outer} and is not pushed out"),
        }
    }
}

/// The body that lies inside the other, found from how much boundary each side of a pair contributes to their overlap.
pub(crate) fn swallowed(a: Partner, b: Partner, areas: [f64; 2]) -> Option<Warning> {
    match areas {
        _ if a == b => None,
        [of_a, 0.0] if of_a > 0.0 => Some(Warning::SwallowedBody { inner: a, outer: b }),
        [0.0, of_b] if of_b > 0.0 => Some(Warning::SwallowedBody { inner: b, outer: a }),
        _ => None,
    }
}
