//! Results of an evaluation, as plain structs.

use crate::Warning;
use crate::capi::boundary::failure::c_text;
use crate::contact::{ContactForces, PairForces, Resultant};
use crate::overlap::Partner;
use std::ffi::CString;

/// Results of an evaluation other than the forces. Units follow from the coordinates and the stiffness: with m and Pa,
/// volumes are m^3 (2D: m^2), areas m^2 (m), energies J (J/m) and forces N (N/m).
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct fmc_result {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Volume (2D: area) of the overlap of both sides, summed over the pairs.
    pub volume: f64,
    /// Standard error of the volume; 0 for `exact`.
    pub volume_standard_error: f64,
    /// Contact energy, summed over the pairs.
    pub energy: f64,
    /// Area of contact (2D: length), summed over the pairs; see `fmc_pair_result`.
    pub contact_area: f64,
    /// Largest penetration of any pair; see `fmc_pair_result`.
    pub penetration: f64,
    /// Fibers laid.
    pub fiber_count: usize,
    /// Crossings that bound an overlap.
    pub crossing_count: usize,
    /// Facets that bound an overlap.
    pub facet_count: usize,
    /// Overlapping pairs, for `fmc_context_pair_result`.
    pub pair_count: usize,
    /// Bodies, for `fmc_context_body_resultant`.
    pub body_count: usize,
    /// Obstacles, for `fmc_context_obstacle_resultant`.
    pub obstacle_count: usize,
    /// Warnings, for `fmc_context_warning`.
    pub warning_count: usize,
    /// Energy stored in the stick of friction; 0 without friction, as the next four.
    pub friction_energy: f64,
    /// Energy dissipated by friction since the step began, never negative.
    pub friction_dissipation: f64,
    /// Area (2D: length) that sticks.
    pub stick_area: f64,
    /// Area (2D: length) that slides.
    pub slip_area: f64,
    /// Largest slip since the step began, without its elastic part.
    pub largest_slip: f64,
    /// Zero.
    pub reserved: [u64; 3],
}

/// Contact force and moment on one body or obstacle.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_resultant {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Id of the body as given, or its number among the connected components; index of the obstacle.
    pub id: i64,
    /// Sum of the forces; in 2D the last entry is 0.
    pub force: [f64; 3],
    /// Moment of the forces about the origin of space; in 2D only the last entry differs from 0.
    pub moment: [f64; 3],
    /// Nodes on the body's surface, with cells of second order points of its division; 0 for an obstacle.
    pub node_count: usize,
    /// The part of `force` that is friction.
    pub friction: [f64; 3],
    /// Zero.
    pub reserved: [u64; 4],
}

/// Kind of a partner.
#[repr(C)]
pub enum fmc_partner {
    /// A body of the mesh.
    FMC_PARTNER_BODY = 0,
    /// An obstacle.
    FMC_PARTNER_OBSTACLE = 1,
}

/// One overlapping pair; no side is master or slave.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pair_result {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// First side: a value of `fmc_partner`.
    pub a_kind: i32,
    /// Second side: a value of `fmc_partner`.
    pub b_kind: i32,
    /// First side: index for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
    pub a: usize,
    /// Second side; the same as the first for a body that overlaps itself.
    pub b: usize,
    /// Volume (2D: area) of the overlap of both sides, each place once, with every law and estimator.
    pub volume: f64,
    /// Standard error of the volume; 0 for `exact`.
    pub volume_standard_error: f64,
    /// Energy.
    pub energy: f64,
    /// Mean of the contact pressure over the contact. With the law "volume" it is dw/dV, one value for the whole pair;
    /// with "fiber" the mean of psi'(L) over its lines. With "depth" it is k times the mean depth of either surface
    /// below the other, over both.
    pub pressure: f64,
    /// Area of contact (2D: length): half of the boundary of the overlap, including the strips of penetrating side
    /// walls. The law "fiber" does not see strips along its lines; with "depth" and an obstacle it is the surface of
    /// the body that is inside. Non-matching facets separate between their nodes in hard contact; the separated part is
    /// not counted.
    pub contact_area: f64,
    /// Penetration. With the law "fiber" it is the longest of its lines, with "depth" the largest depth of either
    /// surface below the other. With "volume", which has no local depth, it is the extent of the overlap along its mean
    /// normal. For flat faces all three agree. With "fiber" and "depth" k times it is the largest pressure.
    pub penetration: f64,
    /// Spacing of the fibers; 0 for `exact`. Passed as the option `spacing`, it gives the same pattern again.
    pub spacing: f64,
    /// Energy stored in the stick of friction.
    pub friction_energy: f64,
    /// Energy dissipated by friction since the step began.
    pub friction_dissipation: f64,
    /// Area (2D: length) that sticks.
    pub stick_area: f64,
    /// Area (2D: length) that slides.
    pub slip_area: f64,
    /// Force of the first side on the second, friction included; in 2D the last entry is 0. The force of the second on the first is
    /// its negative. 0 for a body that overlaps itself.
    pub force: [f64; 3],
    /// Zero.
    pub reserved: [u64; 4],
}

/// Kind of a warning.
#[repr(C)]
pub enum fmc_warning {
    /// The fibers are further apart than the facets in contact are wide: nodal forces are noisy.
    FMC_WARNING_COARSE_FIBERS = 1,
    /// Only a few fibers cross the overlap: it is thinner or smaller than their spacing.
    FMC_WARNING_UNRESOLVED_OVERLAP = 2,
    /// One body lies inside the other and is not pushed out.
    FMC_WARNING_SWALLOWED_BODY = 3,
    /// The law "fiber" neglects a patch of the contact next to a much shallower or larger one; the text gives its area,
    /// penetration and normal. Two bodies in place of one that has both walls, or the law "volume", count it.
    FMC_WARNING_PATCH_LEFT_OUT = 4,
    /// With the estimator "exact", forces or moments of a pair add up to zero with an error above rounding. Or, with the law "depth",
    /// the error exceeds a tenth, since faces in contact were named as faces in planes of symmetry. The text gives the imbalance. Forces
    /// may be wrong by as much.
    FMC_WARNING_UNBALANCED = 5,
    /// With the law "depth", faces of two bodies lie in one plane, face the same way and reach into the overlap, as planes of
    /// symmetry do. The host has not called `fmc_context_set_symmetry_nodes` (without nodes if there is no symmetry). The text
    /// gives the area. Next to a plane of symmetry that is treated as surface the nodal forces are too low, by about the ratio
    /// of penetration and cell size.
    FMC_WARNING_FLUSH_FACES = 6,
    /// Faces of one body coincide and face each other, without deformation: nodes were not merged there, a flat cell was left out,
    /// or there is a crack. The text gives the area and nodes, counted from `index_base`. The law "depth" treats such faces as
    /// surface, and the pressure near them is too low.
    FMC_WARNING_COINCIDING_FACES = 7,
    /// With the law "depth", a signed distance grows more slowly at its surface than a distance; the text gives the slopes.
    /// Penetrations, and with them pressures, are too small by that factor.
    FMC_WARNING_GENTLE_DISTANCE = 8,
    /// With the law "depth", the distance from facets in contact to the round surfaces that they represent exceeds the penetration; the
    /// text gives both sizes. Where such surfaces conform, as a pin in its hole, pressures may be several times too large or too small.
    /// Take a finer mesh, or `fmc_context_set_surface_smoothing`, which measures round faces of bodies whose facets meet at less than its
    /// angle.
    FMC_WARNING_CURVED_FACES = 9,
    /// With the law "depth", cells are so coarse that curved faces in contact, of second order or smoothed, may be wrong by more than
    /// two fifths of the penetration. Pressures at single points may be wrong by as much. The text gives both sizes. Take a finer
    /// mesh. The error falls with the fourth power of the cell size.
    FMC_WARNING_COARSE_FACES = 10,
    /// `fmc_context_set_surface_smoothing` has no effect on a pair of bodies, since its law is not "depth": it is measured by straight
    /// facets.
    FMC_WARNING_UNUSED_SMOOTHING = 11,
    /// Some faces of tied bodies are farther apart than the reach, for example on coarse round bodies, and only part of them is tied; the
    /// text gives areas and distances. A larger `reach` of the pair ties them.
    FMC_WARNING_TIED_IN_PART = 12,
    /// Facets in contact are perpendicular to the direction of friction of the pair; the text gives one of them, counted from
    /// `index_base`, and their part of the friction. The transverse coefficient holds there for all slip.
    FMC_WARNING_NO_FRICTION_DIRECTION = 13,
    /// A step, with all of its cycles, would wear off more than the sides of a pair penetrate; the text gives the ratio. Pressures may
    /// oscillate from step to step: take smaller steps, or fewer cycles (`fmc_context_set_wear_cycles`).
    FMC_WARNING_LARGE_WEAR = 14,
}

fn warning_code(warning: &Warning) -> i32 {
    let code = match warning {
        Warning::CoarseFibers { .. } => fmc_warning::FMC_WARNING_COARSE_FIBERS,
        Warning::UnresolvedOverlap { .. } => fmc_warning::FMC_WARNING_UNRESOLVED_OVERLAP,
        Warning::PatchLeftOut { .. } => fmc_warning::FMC_WARNING_PATCH_LEFT_OUT,
        Warning::Unbalanced { .. } => fmc_warning::FMC_WARNING_UNBALANCED,
        Warning::FlushFaces { .. } => fmc_warning::FMC_WARNING_FLUSH_FACES,
        Warning::CoincidingFaces { .. } => fmc_warning::FMC_WARNING_COINCIDING_FACES,
        Warning::GentleDistance { .. } => fmc_warning::FMC_WARNING_GENTLE_DISTANCE,
        Warning::CurvedFaces { .. } => fmc_warning::FMC_WARNING_CURVED_FACES,
        Warning::CoarseFaces { .. } => fmc_warning::FMC_WARNING_COARSE_FACES,
        Warning::UnusedSmoothing { .. } => fmc_warning::FMC_WARNING_UNUSED_SMOOTHING,
        Warning::TiedInPart { .. } => fmc_warning::FMC_WARNING_TIED_IN_PART,
        Warning::NoFrictionDirection { .. } => fmc_warning::FMC_WARNING_NO_FRICTION_DIRECTION,
        Warning::LargeWear { .. } => fmc_warning::FMC_WARNING_LARGE_WEAR,
        Warning::SwallowedBody { .. } => fmc_warning::FMC_WARNING_SWALLOWED_BODY,
    };
    code as i32
}

/// Results of an evaluation other than the forces.
#[derive(Debug, Default)]
pub(crate) struct Evaluation {
    pub(crate) result: fmc_result,
    pub(crate) bodies: Vec<fmc_resultant>,
    pub(crate) obstacles: Vec<fmc_resultant>,
    pub(crate) pairs: Vec<fmc_pair_result>,
    pub(crate) warnings: Vec<(i32, CString)>,
}

impl Evaluation {
    /// What a host gets, which counts nodes from `index_base`.
    pub(crate) fn of<const D: usize>(forces: &ContactForces<D>, index_base: i32) -> Self {
        let warning = |w: &Warning| (warning_code(w), c_text(&w.clone().counted_from(index_base as usize).to_string()));
        Self {
            result: fmc_result {
                struct_size: size_of::<fmc_result>(),
                volume: forces.volume,
                volume_standard_error: forces.standard_error,
                energy: forces.energy,
                contact_area: forces.contact_area,
                penetration: forces.penetration,
                fiber_count: forces.fiber_count,
                crossing_count: forces.crossing_count,
                facet_count: forces.facet_count,
                pair_count: forces.pairs.len(),
                body_count: forces.bodies.len(),
                obstacle_count: forces.obstacles.len(),
                warning_count: forces.warnings.len(),
                friction_energy: forces.friction.stored,
                friction_dissipation: forces.friction.dissipated,
                stick_area: forces.friction.stick_area,
                slip_area: forces.friction.slip_area,
                largest_slip: forces.friction.largest_slip,
                reserved: [0; 3],
            },
            bodies: forces.bodies.iter().map(resultant).collect(),
            obstacles: forces.obstacles.iter().map(resultant).collect(),
            pairs: forces.pairs.iter().map(pair).collect(),
            warnings: forces.warnings.iter().map(warning).collect(),
        }
    }
}

fn resultant<const D: usize>(found: &Resultant<D>) -> fmc_resultant {
    fmc_resultant {
        struct_size: size_of::<fmc_resultant>(),
        id: found.id,
        force: padded(&found.force),
        moment: found.moment,
        node_count: found.node_count,
        friction: padded(&found.friction),
        reserved: [0; 4],
    }
}

/// A vector as one in space; in 2D the last entry is 0.
pub(crate) fn padded<const D: usize>(x: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|i| if i < D { x[i] } else { 0.0 })
}

/// Kind and index of a partner.
pub(crate) fn side_of(partner: Partner) -> (i32, usize) {
    match partner {
        Partner::Body(index) => (fmc_partner::FMC_PARTNER_BODY as i32, index),
        Partner::Obstacle(index) => (fmc_partner::FMC_PARTNER_OBSTACLE as i32, index),
    }
}

fn pair(found: &PairForces) -> fmc_pair_result {
    let ((a_kind, a), (b_kind, b)) = (side_of(found.a), side_of(found.b));
    fmc_pair_result {
        struct_size: size_of::<fmc_pair_result>(),
        a_kind,
        b_kind,
        a,
        b,
        volume: found.volume,
        volume_standard_error: found.standard_error,
        energy: found.energy,
        pressure: found.pressure,
        contact_area: found.contact_area,
        penetration: found.penetration,
        spacing: found.spacing,
        friction_energy: found.friction.stored,
        friction_dissipation: found.friction.dissipated,
        stick_area: found.friction.stick_area,
        slip_area: found.friction.slip_area,
        force: found.force,
        reserved: [0; 4],
    }
}
