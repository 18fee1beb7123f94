//! What a search for an equilibrium has led to.

use crate::contact::equilibrium::{Found, Refusal, Way};

/// How an equilibrium was found.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmc_equilibrium_way {
    /// No equilibrium was found.
    FMC_WAY_NONE = 0,
    /// By steps to the equilibrium of the contact with linear bodies.
    FMC_WAY_CONDENSED = 1,
    /// By full steps of Newton's method: it is the equilibrium next to the start.
    FMC_WAY_NEAREST = 2,
    /// By descent of the energy.
    FMC_WAY_DOWNHILL = 3,
}

/// Result of a search. Its arrays belong to the search, and are valid until it is freed.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_equilibrium_result {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// A value of `fmc_equilibrium_way`; `FMC_WAY_NONE` for a refusal.
    pub way: i32,
    /// For a refusal: 1 if `unheld_body` is the reason.
    pub unheld: i32,
    /// The equilibrium, `unknown_count` numbers; NULL for a refusal.
    pub x: *const f64,
    /// Internal minus external minus contact forces there: at unknowns that are not free, the reactions. NULL for a refusal.
    pub reactions: *const f64,
    /// Residual relative to the forces, state by state.
    pub residuals: *const f64,
    /// Their number.
    pub residual_count: usize,
    /// Linear systems solved, without the checks whether loose bodies are supported.
    pub solve_count: usize,
    /// Rigid steps in which loose bodies came to rest.
    pub rigid_step_count: usize,
    /// Parts in which the step was made.
    pub part_count: usize,
    /// Rigid motions that K does not resist, or hardly.
    pub loose_count: usize,
    /// Updates of the multipliers.
    pub update_count: usize,
    /// Number of texts of `fmc_equilibrium_text`: warnings, or one sentence for a refusal.
    pub text_count: usize,
    /// Largest mean penetration of a node, a length; negative where it was not measured.
    pub penetration: f64,
    /// Id of an unsupported body.
    pub unheld_body: i64,
    /// Unit vector along which it moves; zeros for a rotation.
    pub unheld_direction: [f64; 3],
    /// Pairs whose slip counts from where they first touched in this step: they were apart at its start. Derivatives of the equilibrium hold
    /// these places.
    pub first_touch_count: usize,
    /// Zero.
    pub reserved: [u64; 5],
}

impl Default for fmc_equilibrium_result {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            way: fmc_equilibrium_way::FMC_WAY_NONE as i32,
            unheld: 0,
            x: std::ptr::null(),
            reactions: std::ptr::null(),
            residuals: std::ptr::null(),
            residual_count: 0,
            solve_count: 0,
            rigid_step_count: 0,
            part_count: 0,
            loose_count: 0,
            update_count: 0,
            text_count: 0,
            penetration: -1.0,
            unheld_body: 0,
            unheld_direction: [0.0; 3],
            first_touch_count: 0,
            reserved: [0; 5],
        }
    }
}

impl<const D: usize> From<&Found<D>> for fmc_equilibrium_result {
    fn from(found: &Found<D>) -> Self {
        let way = match found.way {
            Way::Condensed => fmc_equilibrium_way::FMC_WAY_CONDENSED,
            Way::Nearest => fmc_equilibrium_way::FMC_WAY_NEAREST,
            Way::Downhill => fmc_equilibrium_way::FMC_WAY_DOWNHILL,
        };
        Self {
            way: way as i32,
            x: found.x.as_ptr(),
            reactions: found.reactions.as_ptr(),
            residuals: found.residuals.as_ptr(),
            residual_count: found.residuals.len(),
            solve_count: found.solves,
            rigid_step_count: found.rigid_steps,
            part_count: found.parts,
            loose_count: found.loose_count,
            update_count: found.updates,
            first_touch_count: found.first_touches,
            text_count: found.warnings.len(),
            penetration: found.penetration.unwrap_or(-1.0),
            ..Self::default()
        }
    }
}

impl From<&Refusal> for fmc_equilibrium_result {
    fn from(refusal: &Refusal) -> Self {
        let mut result = Self {
            residuals: refusal.residuals.as_ptr(),
            residual_count: refusal.residuals.len(),
            solve_count: refusal.solves,
            text_count: 1,
            ..Self::default()
        };
        if let Some(unheld) = &refusal.unheld {
            (result.unheld, result.unheld_body) = (1, unheld.body);
            result.unheld_direction.iter_mut().zip(&unheld.direction).for_each(|(to, from)| *to = *from);
        }
        result
    }
}
