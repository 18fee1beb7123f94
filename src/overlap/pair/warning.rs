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
    /// on the wrong side, or patches of the contact could not be told apart; or, with the law `depth`, faces that are pressed were
    /// named as faces in planes of symmetry. Forces may be wrong by as much.
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
    /// nodes if there are none). Beside a plane of symmetry that is taken for surface the nodal forces are too low, by
    /// about the ratio of penetration and cell size.
    FlushFaces {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Area (2D: length) of what coincides.
        area: f64,
    },
    /// Faces of one body lie on one another and look at each other, without deformation: nodes were not merged there, a flat cell was
    /// left out, or a crack is meant. The law `depth` takes them for surface, and a contact near them bears too little.
    CoincidingFaces {
        /// The body.
        body: Partner,
        /// Area (2D: length), counted once for both sides; with axisymmetry that of the section.
        area: f64,
        /// Nodes of these faces, ascending.
        nodes: Vec<usize>,
    },
    /// With the law `depth`, a signed distance grows more slowly at its surface than a distance: penetrations, and with them pressures,
    /// are too small by that factor.
    GentleDistance {
        /// Obstacle.
        obstacle: Partner,
        /// The least and the largest slope that were found at its surface.
        slopes: [f64; 2],
    },
    /// With the law `depth`, the facets in contact lie farther beside the round surfaces that they stand for than the sides penetrate.
    /// Where such surfaces conform, as a pin in its hole, pressures may be wrong by factors: smooth the surface, or take a finer mesh.
    CurvedFaces {
        /// First body of the pair.
        a: Partner,
        /// Second side of the pair.
        b: Partner,
        /// Distance of facets from the surface of the same normals at its nodes, without deformation: of both sides together, as a
        /// mean over the area of contact.
        sag: f64,
        /// Mean penetration over that area.
        penetration: f64,
        /// What may help beside a finer mesh.
        remedy: Smoothing,
    },
    /// With the law `depth`, cells are so coarse that curved faces in contact may be wrong by more than two fifths of the penetration, and
    /// pressures at single points by as much. Take a finer mesh; the error falls with the fourth power of the cell size.
    CoarseFaces {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// How far the depth below the curved faces may be wrong at a point, an estimate.
        error: f64,
        /// Mean penetration of the curved faces.
        penetration: f64,
    },
    /// `Contact::set_surface_smoothing` has no effect on a pair of bodies, since its law is not `depth`: it is measured by straight facets.
    UnusedSmoothing {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
    },
    /// Faces of bodies that are tied lie in part farther apart than the reach, as those of coarse round bodies, or of a wedge: they are
    /// tied in part only. A larger reach ties them.
    TiedInPart {
        /// First body of the pair.
        a: Partner,
        /// Second body of the pair.
        b: Partner,
        /// Area (2D: length) that is tied.
        tied: f64,
        /// Area of facets that are tied in part, and lie beyond the reach there.
        left_out: f64,
        /// The reach, and how far apart what is left out is at most.
        distances: [f64; 2],
    },
    /// Facets in contact are perpendicular to the direction along which the friction of the pair has a coefficient of its own: they have
    /// that across it, whatever their slip. They bear more than a hundredth of the friction.
    NoFrictionDirection {
        /// First body of the pair.
        a: Partner,
        /// Second side of the pair.
        b: Partner,
        /// That of them with the largest limit, by its place in `Contact::boundary_facets`.
        facet: usize,
        /// Their part of the limit of the pair's friction.
        part: f64,
    },
    /// A step, with all of its cycles, would wear off more than the sides penetrate: pressures may go up and down from step to step. Take
    /// smaller steps, or fewer cycles.
    LargeWear {
        /// First body of the pair.
        a: Partner,
        /// Second side of the pair.
        b: Partner,
        /// Worn depth of both sides by the penetration, where they slide the most.
        ratio: f64,
    },
    /// One body lies inside the other: the overlap has no boundary on the other and does not push it out.
    SwallowedBody {
        /// The body inside.
        inner: Partner,
        /// The body around it.
        outer: Partner,
    },
}

/// Whether the smoothing of surfaces could measure facets as the round surfaces that they stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Smoothing {
    /// It is not set.
    NotSet,
    /// It is set, but facets meet at more than its angle.
    AngleTooSmall,
    /// Curved faces press along rims, where they end at flat ones.
    AtRims,
    /// It does not measure such pairs: a body with an obstacle, or with itself.
    NotForSuchPairs,
}

impl fmt::Display for Smoothing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Smoothing::NotSet => "set_surface_smoothing measures round faces, or ",
            Smoothing::AngleTooSmall => {
                "facets meet at more than the angle of set_surface_smoothing: raise the angle, or "
            }
            Smoothing::AtRims => "along rims curved faces are less accurate: name flat ends as planes of symmetry, or ",
            Smoothing::NotForSuchPairs => "",
        })
    }
}

/// How many nodes a sentence names.
const NAMED: usize = 8;

impl Warning {
    /// The same with its nodes and facets counted from `base`; bodies and obstacles stay.
    #[must_use]
    pub fn counted_from(mut self, base: usize) -> Self {
        match &mut self {
            Warning::CoincidingFaces { nodes, .. } => nodes.iter_mut().for_each(|node| *node += base),
            Warning::NoFrictionDirection { facet, .. } => *facet += base,
            _ => {}
        }
        self
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Warning::CoarseFibers { a, b, spacing, facet_size } => write!(
                f,
                "{a} and {b}: the fibers are {spacing:.3e} apart, the facets in contact only {facet_size:.3e} wide"
            ),
            Warning::UnresolvedOverlap { a, b, fibers } => {
                write!(f, "{a} and {b}: only {fibers} fibers cross the overlap")
            }
            Warning::PatchLeftOut { a, b, normal: [x, y, z], area, depth } => write!(
                f,
                "{a} and {b}: a patch of the contact next to a shallower or larger one is not counted; its area is \
                 {area:.3e}, its penetration {depth:.3e}, its normal ({x:.3}, {y:.3}, {z:.3})"
            ),
            Warning::Unbalanced { a, b, imbalance } => {
                write!(f, "{a} and {b}: the forces between them do not balance, by {imbalance:.1e} of their size")
            }
            Warning::FlushFaces { a, b, area } => write!(
                f,
                "{a} and {b}: faces of an area of {area:.3e} lie in one plane and face the same way; if it is a plane \
                 of symmetry, name its nodes (symmetry nodes), if not, name none"
            ),
            Warning::CoincidingFaces { body, area, nodes } => {
                let named: Vec<String> = nodes.iter().take(NAMED).map(usize::to_string).collect();
                let more = if nodes.len() > NAMED { ", …" } else { "" };
                write!(
                    f,
                    "{body}: faces of an area of {area:.3e} coincide and face each other, as where nodes were not \
                     merged or a cell was left out; their nodes, {} in all: {}{more}",
                    nodes.len(),
                    named.join(", ")
                )
            }
            Warning::GentleDistance { obstacle, slopes: [least, largest] } => write!(
                f,
                "the signed distance of {obstacle} changes by {least:.3} to {largest:.3} per length at its surface, not by 1: penetrations \
                 and pressures are too small by this factor; divide it by its slope"
            ),
            Warning::CurvedFaces { a, b, sag, penetration, remedy } => write!(
                f,
                "{a} and {b}: facets in contact are {sag:.3e} away from the round surfaces that they represent, and \
                 penetrate by only {penetration:.3e}; pressures may be wrong by factors where the surfaces conform: \
                 {remedy}take a finer mesh"
            ),
            Warning::CoarseFaces { a, b, error, penetration } => write!(
                f,
                "{a} and {b}: the cells are coarse for the curved faces in contact: their error is {error:.3e}, and \
                 they penetrate by {penetration:.3e}; pressures at single points may be wrong by as much: take a \
                 finer mesh, the error falls with the fourth power of the cell size"
            ),
            Warning::UnusedSmoothing { a, b } => write!(
                f,
                "{a} and {b}: set_surface_smoothing has no effect on them, since only the law depth measures round \
                 faces; they are measured by straight facets"
            ),
            Warning::TiedInPart { a, b, tied, left_out, distances: [reach, farthest] } => write!(
                f,
                "{a} and {b} are tied over an area of {tied:.3e}; {left_out:.3e} more of the same faces lies farther \
                 apart than the reach of {reach:.3e}, up to {farthest:.3e}, and is not tied: set a larger reach to \
                 tie it"
            ),
            Warning::NoFrictionDirection { a, b, facet, part } => write!(
                f,
                "{a} and {b}: the direction of their friction is perpendicular to facets that carry {part:.3} of it, \
                 facet {facet} the most: there the transverse coefficient holds for all slip"
            ),
            Warning::LargeWear { a, b, ratio } => write!(
                f,
                "{a} and {b}: this step, with all of its cycles, wears off up to {ratio:.3} times their penetration: \
                 pressures may oscillate from step to step; take smaller steps or fewer cycles"
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
