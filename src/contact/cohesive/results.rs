//! What hosts are told of cohesive interfaces.

/// A cohesive interface at some coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CohesiveSummary {
    /// All of it, in area without deformation (2D: length; with axisymmetry the area of whole rings).
    pub area: f64,
    /// The largest gap, or overlap, that is kept between the surfaces.
    pub largest_gap: f64,
    /// Number of points at which it opens and breaks.
    pub count: usize,
    /// Energy that unloading would give back.
    pub stored: f64,
    /// Energy that has been dissipated since nothing was damaged, as it broke.
    pub dissipated: f64,
    /// Energy that friction of what is broken has dissipated, less what the stick of newly broken area stores.
    pub rubbed: f64,
    /// Energy that the viscosity has dissipated.
    pub viscous: f64,
    /// Area of points that are damaged, broken ones among them.
    pub damaged_area: f64,
    /// Area of points that are broken.
    pub broken_area: f64,
}

/// A point of a cohesive interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CohesivePoint<const D: usize> {
    /// The pair, the body of lower index first.
    pub bodies: [usize; 2],
    /// Where it is, on the first body.
    pub position: [f64; D],
    /// The area that it stands for, without deformation.
    pub area: f64,
    /// How far the bodies are apart beyond the gap at first, along the normal of the second; negative where they are pressed.
    pub opening: f64,
    /// How far the first body has slid along the surface of the second.
    pub sliding: [f64; D],
    /// Traction on the second body, force by area: along its outward normal where the bodies are pulled apart.
    pub traction: [f64; D],
    /// Damage, 0 to 1, and the energy by area that was dissipated, as they would be after a step that ends here.
    pub damage: f64,
    /// See `damage`.
    pub dissipated: f64,
    /// The same that friction and the viscosity have dissipated.
    pub rubbed: f64,
    /// See `rubbed`.
    pub viscous: f64,
}

/// A cohesive interface that breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Breaking {
    pub(crate) bodies: [usize; 2],
    /// Parts of its area: where damage grows, and where nothing is left.
    pub(crate) damaged: f64,
    pub(crate) broken: f64,
    /// The largest forces, before damage grew, along the normals and across them.
    pub(crate) strengths: [f64; 2],
    /// Whether it has a viscosity.
    pub(crate) is_viscous: bool,
}
