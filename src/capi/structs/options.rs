//! Options of an evaluation.

use super::law::fmc_law;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status;

/// How the overlap is measured.
#[repr(C)]
pub enum fmc_estimator {
    /// Sampled by fibers: any shape and any obstacle, with a standard error. Key value "fibers".
    FMC_ESTIMATOR_FIBERS = 0,
    /// Exact for straight-sided meshes and flat-sided obstacles. Key value "exact".
    FMC_ESTIMATOR_EXACT = 1,
    /// Pair by pair: exact between bodies and with obstacles bounded by planes, sampled by lines with curved ones. Key
    /// value "auto".
    FMC_ESTIMATOR_AUTO = 2,
}

/// How fibers are laid.
#[repr(C)]
pub enum fmc_pattern {
    /// Families of parallel lines. Key value "lines".
    FMC_PATTERN_LINES = 0,
    /// Short segments of random place and direction, as published (doi:10.1016/j.cma.2025.118645); the variance of the
    /// force is infinite. Key value "isotropic".
    FMC_PATTERN_ISOTROPIC = 1,
}

/// How line families are combined.
#[repr(C)]
pub enum fmc_weights {
    /// Least noise, but the force is not the gradient of an energy. Key value "balance".
    FMC_WEIGHTS_BALANCE = 0,
    /// The force is the exact gradient of the estimated energy. Key value "consistent".
    FMC_WEIGHTS_CONSISTENT = 1,
}

/// Options of an evaluation. `fmc_options_init` sets all of them.
///
/// New options take the place of reserved fields; the size of the struct does not change, and compiled hosts keep
/// working. Every option can also be set by the name of its field, through `fmc_options_set`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_options {
    /// Set by `fmc_options_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// k > 0. 0, the default, with the laws "depth" and "fiber": `fmc_equilibrium_next` finds it from the bodies' matrix; until then no
    /// evaluation is possible (`FMC_ERROR_NO_STIFFNESS`). For the laws "depth" and "fiber" a pressure per length (Pa/m): the pressure is k
    /// times the penetration; see `fmc_suggest_stiffness`. For the law "volume" with `exponent` 1 it is a pressure (Pa) in 2D and 3D, and
    /// must exceed the peak contact pressure; in general energy / (length^dim)^m.
    pub stiffness: f64,
    /// m >= 1, for the law "volume" only. Default 1.
    pub exponent: f64,
    /// Distance between neighbouring lines; 0, the default: chosen from the size of the facets in contact.
    pub spacing: f64,
    /// Length of an isotropic fiber; 0, the default: the mean size of the facets in contact.
    pub fiber_length: f64,
    /// Approximate number of fibers per pair; 0, the default: chosen from the facets in contact. Excludes `spacing`.
    pub fiber_count: u64,
    /// Seed of the random shift of the pattern. Default 0. This, `spacing`, `fiber_length`, `fiber_count`, `pattern`
    /// and `weights` are refused where they would have no effect, as with the estimator "exact", or with "auto" and the law
    /// "depth".
    pub seed: u64,
    /// A value of `fmc_law`. Default `FMC_LAW_DEPTH`.
    pub law: i32,
    /// A value of `fmc_estimator`. Default `FMC_ESTIMATOR_AUTO`.
    pub estimator: i32,
    /// A value of `fmc_pattern`. Default `FMC_PATTERN_LINES`.
    pub pattern: i32,
    /// A value of `fmc_weights`. Default `FMC_WEIGHTS_BALANCE`.
    pub weights: i32,
    /// 1, the default: momentum correction, the smallest change of the nodal forces that makes their sum and moment
    /// vanish. 0: none.
    pub momentum_correction: i32,
    /// 1: self-contact, the overlap of each body with itself, is evaluated too. Default 0.
    pub self_contact: i32,
    /// 1, the default: the orientation of every cell is checked at every evaluation. 0: it is not.
    pub check_cells: i32,
    /// Number of threads, at least 1, the default. The result does not depend on it.
    pub threads: i32,
    /// First number of nodes, cells, facets, degrees of freedom, rows and columns, 0 or 1, in input, output and messages. Default 0.
    /// Bodies, obstacles, pairs and warnings count from 0.
    pub index_base: i32,
    /// 1: axisymmetry, in 2D. Coordinates are (r, z) with r >= 0, and volumes, areas, energies and forces refer to
    /// whole rings: integrals have the factor 2 pi r. Default 0. Not with isotropic fibers.
    pub axisymmetric: i32,
    /// Smoothing length of the law "fiber", over which the pressure grows to k; 0, the default: the quadratic law. Refused
    /// with any other law.
    pub smoothing_length: f64,
    /// Coefficient of Coulomb friction of all pairs without a separate one, at least 0. Infinite: facets under pressure never slide, unless
    /// `shear_limit` lets them; not with `memoryless_slip`. Default 0: no friction. With it, steps are begun and committed, see
    /// `fmc_context_begin_step`, and the tangent is unsymmetric. With the law "volume" not without `friction_stiffness` or
    /// `memoryless_slip`.
    pub friction_coefficient: f64,
    /// Tangential stiffness of the stick, a pressure per length; 0, the default: the stiffness of the law at a first touch.
    pub friction_stiffness: f64,
    /// Shear traction that is transmitted without pressure wherever there is contact, at least 0, a pressure. Default 0.
    pub cohesion: f64,
    /// Largest shear traction, a pressure; 0, the default: no limit.
    pub shear_limit: f64,
    /// Slip of a step from which on friction without memory acts in full: a speed times the time step, say. This law is smooth
    /// and has no history, so that sticking facets creep. 0, the default: friction with memory. Not together with
    /// `friction_stiffness`.
    pub memoryless_slip: f64,
    /// Static coefficient of friction, at least `friction_coefficient`, to which it falls over `weakening_slip`; 0, the default: one
    /// coefficient. A facet that sticks throughout a step rests. Not together with `memoryless_slip`.
    pub static_coefficient: f64,
    /// Slip over which the coefficient falls linearly from the static to the kinetic one, a length; positive with
    /// `static_coefficient`, else 0, the default.
    pub weakening_slip: f64,
    /// Distance within which contact treats nodes of one body as one node, at least 0, a length, for meshes whose nodes were not merged. It
    /// is read by `fmc_context_new_from_cells` and `fmc_contact_force` and cannot be changed later. A welded node lies in the mean of its
    /// nodes, and each of them has an equal part of its force. Smaller than every edge. Without `body_ids` parts that are welded become one
    /// body. 0, the default: no nodes are welded. Refused for bodies given by facets, and for meshes in parts.
    pub weld: f64,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 7],
}

impl Default for fmc_options {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            stiffness: 0.0,
            exponent: 1.0,
            spacing: 0.0,
            fiber_length: 0.0,
            fiber_count: 0,
            seed: 0,
            law: fmc_law::FMC_LAW_DEPTH as i32,
            estimator: fmc_estimator::FMC_ESTIMATOR_AUTO as i32,
            pattern: 0,
            weights: 0,
            momentum_correction: 1,
            self_contact: 0,
            check_cells: 1,
            threads: 1,
            index_base: 0,
            axisymmetric: 0,
            smoothing_length: 0.0,
            friction_coefficient: 0.0,
            friction_stiffness: 0.0,
            cohesion: 0.0,
            shear_limit: 0.0,
            memoryless_slip: 0.0,
            static_coefficient: 0.0,
            weakening_slip: 0.0,
            weld: 0.0,
            reserved: [0; 7],
        }
    }
}

/// Sets all options to their defaults. Afterwards set `stiffness`, unless a search finds it.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_options_init(options: *mut fmc_options) -> fmc_status {
    entry(|| {
        let output = Output::required("options", options)?;
        // SAFETY: the host passes a struct of the header's size, which may be written.
        unsafe { output.write(fmc_options::default()) };
        Ok(())
    })
}
