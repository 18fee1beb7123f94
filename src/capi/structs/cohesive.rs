//! Cohesive interfaces as plain structs.

use crate::contact::{CohesivePoint, CohesiveSummary};

/// The cohesive interface of two bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_cohesive {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Its total area, without deformation (2D: length; with axisymmetry the area of whole rings); 0: there is no
    /// interface.
    pub area: f64,
    /// The largest gap, or overlap, that is kept between the surfaces, a length.
    pub largest_gap: f64,
    /// Number of points at which it opens and breaks.
    pub point_count: usize,
    /// Energy that unloading would give back.
    pub stored: f64,
    /// Energy that damage has dissipated so far.
    pub dissipated: f64,
    /// Area of points that are damaged, broken ones among them.
    pub damaged_area: f64,
    /// Area of points that are broken.
    pub broken_area: f64,
    /// Energy that friction of the broken part has dissipated, minus the stick energy of newly broken area.
    pub rubbed: f64,
    /// Energy that the viscosity has dissipated.
    pub viscous: f64,
    /// Zero.
    pub reserved: [u64; 3],
}

/// A point of a cohesive interface.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_cohesive_point {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// The bodies, indices for `fmc_context_body_resultant`, the lower one first.
    pub body: usize,
    /// See `body`.
    pub partner: usize,
    /// Where it is, on `body`; in 2D the last is 0.
    pub position: [f64; 3],
    /// Its tributary area, without deformation.
    pub area: f64,
    /// Opening beyond the initial gap, along the normal of `partner`, a length; negative in compression.
    pub opening: f64,
    /// Slip of `body` along the surface of `partner`, a length; in 2D the last is 0.
    pub sliding: [f64; 3],
    /// Traction on `partner`, force per area, along its outward normal in tension; in 2D the last is 0.
    pub traction: [f64; 3],
    /// Damage, 0 to 1, as it would be after a step that ends here.
    pub damage: f64,
    /// Energy per area that has been dissipated then.
    pub dissipated: f64,
    /// Energy per area that friction of the broken part has dissipated.
    pub rubbed: f64,
    /// Energy per area that the viscosity has dissipated.
    pub viscous: f64,
    /// Zero.
    pub reserved: [u64; 3],
}

impl From<Option<CohesiveSummary>> for fmc_cohesive {
    fn from(found: Option<CohesiveSummary>) -> Self {
        let found = found.unwrap_or_default();
        Self {
            struct_size: size_of::<Self>(),
            area: found.area,
            largest_gap: found.largest_gap,
            point_count: found.count,
            stored: found.stored,
            dissipated: found.dissipated,
            damaged_area: found.damaged_area,
            broken_area: found.broken_area,
            rubbed: found.rubbed,
            viscous: found.viscous,
            reserved: [0; 3],
        }
    }
}

impl<const D: usize> From<&CohesivePoint<D>> for fmc_cohesive_point {
    fn from(one: &CohesivePoint<D>) -> Self {
        let in_space = |x: &[f64; D]| std::array::from_fn(|axis| if axis < D { x[axis] } else { 0.0 });
        Self {
            struct_size: size_of::<Self>(),
            body: one.bodies[0],
            partner: one.bodies[1],
            position: in_space(&one.position),
            area: one.area,
            opening: one.opening,
            sliding: in_space(&one.sliding),
            traction: in_space(&one.traction),
            damage: one.damage,
            dissipated: one.dissipated,
            rubbed: one.rubbed,
            viscous: one.viscous,
            reserved: [0; 3],
        }
    }
}
