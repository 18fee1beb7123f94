//! Laws of friction of the host: the facets that they are asked at, and what they answer.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_NULL_POINTER};
use crate::capi::structs::evaluation::fmc_partner;
use crate::contact::{FrictionFacets, FrictionLaw, FrictionResponse, LawFailure};
use crate::overlap::Partner;
use std::ffi::c_void;

/// The facets of a pair for which the library calls a law of friction of the host: all facets under pressure, of both sides. All numbers of
/// a facet follow one another. The host must not write to it, or read it after the call.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_friction_facets {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// How many facets there are, at least 1.
    pub count: usize,
    /// Dimension, 2 or 3.
    pub dim: usize,
    /// Numbers of the history of a facet.
    pub history_count: usize,
    /// The pair: index of a body, and index of its partner; 0 and 1 in `fmc_friction_law_check`.
    pub body: usize,
    /// See `body`.
    pub partner: usize,
    /// `fmc_partner`: the partner is a body, whose index is at least `body`, or an obstacle.
    pub partner_kind: i32,
    /// Zero.
    pub unused: i32,
    /// Duration of the step (`fmc_context_set_time_step`); 0: not set.
    pub time_step: f64,
    /// Stiffness k_T of the stick, a pressure per length; 0: friction without memory.
    pub stiffness: f64,
    /// Places of the facets in `fmc_context_boundary_facets`, from 0, (count).
    pub facet: *const usize,
    /// Mean pressures over the area in contact, positive, (count).
    pub pressure: *const f64,
    /// Lengths, (count, dim - 1): slip of `body` against `partner` since the step began, along the axes, including its elastic part.
    pub slip: *const f64,
    /// Lengths, (count, dim - 1): trial elastic slip, as if no facet slid in the step. Where its length times `stiffness` exceeds the
    /// limit, the facet slides by the rest.
    pub trial: *const f64,
    /// Tangential unit axes, by rows, (count, dim - 1, dim). In 2D the normal, out of `body`, turned by +90 degrees. In 3D the first is the
    /// x axis projected into the facet (the z axis, where the normal is within 6 degrees of x); the second is normal x first. They do not
    /// turn along with the material.
    pub axes: *const f64,
    /// Where the tractions act, (count, dim).
    pub position: *const f64,
    /// Tributary areas of the facets, (count): where two bodies meet, each side has half of the area in contact.
    pub area: *const f64,
    /// (count, history_count), as last accepted (`fmc_context_commit_step`); 0 at the first touch.
    pub history: *const f64,
    /// Number of fields (`fmc_context_set_law_fields`).
    pub field_count: usize,
    /// Means of the fields over the facet on `body`, then on `partner`, (count, 2, field_count); NaN on an obstacle.
    pub fields: *const f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// Output of a law of friction of the host.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_friction_response {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Tractions at which the facets slide, force per area, at least 0, (count). An unwritten entry counts as not
    /// finite.
    pub limit: *mut f64,
    /// Their derivatives by the pressure, with slip, history and time step held, (count). An unwritten entry counts as not finite.
    pub by_pressure: *mut f64,
    /// Their derivatives by the slip, with the trial slip changing by the same amount, (count, dim - 1). 0 at first.
    pub by_slip: *mut f64,
    /// The history as it would be after a step that ends here, (count, history_count). It is preset to the history at
    /// the start of the step.
    pub history: *mut f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// A law of friction of the host: writes the limits of all facets of a pair in `response`. `user` is the pointer given with it.
///
/// Return 0; any other value makes the call of the library fail with `FMC_ERROR_INTERFACE_LAW`, naming facet i of the call for the value
/// i + 1. It is called on the thread that evaluates, never from two threads at once. Pairs follow one another in ascending order. Where ranks
/// share the work, it is called on every rank with all facets. The same input must have a bit-for-bit identical answer. It must not call a
/// function of the same context (it would get `FMC_ERROR_BUSY`), throw, or jump out.
pub type fmc_limit_friction = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        at: *const fmc_friction_facets,
        response: *const fmc_friction_response,
    ) -> i32,
>;

/// A law of friction of the host. `fmc_friction_law_init` sets all of it.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_friction_law {
    /// Set by `fmc_friction_law_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Numbers that a facet carries from step to step for each partner that it faces. Default 0.
    pub history_count: usize,
    /// The law. It and `user` must outlive the context, or be replaced before by other options of the pair.
    pub limit: fmc_limit_friction,
    /// Passed to `limit`.
    pub user: *mut c_void,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 4],
}

/// A function of the host and its user pointer.
pub(crate) struct HostFriction {
    function: unsafe extern "C" fn(*mut c_void, *const fmc_friction_facets, *const fmc_friction_response) -> i32,
    user: *mut c_void,
    history_count: usize,
}

// SAFETY: the pointer is handed through, never followed, and the function is called by the thread that evaluates the context only; the host
// promises in `fmc_friction_law` that it may be called from whichever that is.
unsafe impl Send for HostFriction {}
// SAFETY: as above; evaluations of one context exclude one another.
unsafe impl Sync for HostFriction {}

impl fmc_friction_law {
    pub(crate) fn to_law(self) -> Result<HostFriction, Failure> {
        let Self { struct_size, history_count, limit, user, reserved } = self;
        check_struct::<Self>("fmc_friction_law", struct_size, reserved)?;
        // What no array could hold; the product with the facets is then no overflow.
        if history_count > 1 << 20 {
            let text =
                format!("history_count is {history_count}, and at most {} numbers are kept for a facet", 1 << 20);
            return Err(Failure::new(FMC_ERROR_BAD_VALUE, text));
        }
        let function = limit.ok_or_else(|| Failure::new(FMC_ERROR_NULL_POINTER, "'limit' is NULL"))?;
        Ok(HostFriction { function, user, history_count })
    }
}

impl FrictionLaw for HostFriction {
    fn history_count(&self) -> usize {
        self.history_count
    }

    fn respond(&self, facets: &FrictionFacets<'_>, response: &mut FrictionResponse<'_>) -> Result<(), LawFailure> {
        let [Partner::Body(body) | Partner::Obstacle(body), partner] = facets.partners;
        let (partner_kind, partner) = match partner {
            Partner::Body(partner) => (fmc_partner::FMC_PARTNER_BODY, partner),
            Partner::Obstacle(partner) => (fmc_partner::FMC_PARTNER_OBSTACLE, partner),
        };
        let asked = fmc_friction_facets {
            struct_size: size_of::<fmc_friction_facets>(),
            count: facets.count,
            dim: facets.dim,
            history_count: self.history_count,
            body,
            partner,
            partner_kind: partner_kind as i32,
            unused: 0,
            time_step: facets.time_step,
            stiffness: facets.stiffness,
            facet: facets.facets.as_ptr(),
            pressure: facets.pressures.as_ptr(),
            slip: facets.slips.as_ptr(),
            trial: facets.trials.as_ptr(),
            axes: facets.axes.as_ptr(),
            position: facets.positions.as_ptr(),
            area: facets.areas.as_ptr(),
            history: facets.history.as_ptr(),
            field_count: facets.field_count,
            fields: facets.fields.as_ptr(),
            reserved: [0; 4],
        };
        let answer = fmc_friction_response {
            struct_size: size_of::<fmc_friction_response>(),
            limit: response.limits.as_mut_ptr(),
            by_pressure: response.by_pressure.as_mut_ptr(),
            by_slip: response.by_slip.as_mut_ptr(),
            history: response.history.as_mut_ptr(),
            reserved: [0; 4],
        };
        // SAFETY: all arrays are as long as the structs say; the host guarantees a function that keeps to its contract.
        match unsafe { (self.function)(self.user, &raw const asked, &raw const answer) } {
            0 => Ok(()),
            code => {
                let point = usize::try_from(code).ok().map(|code| code - 1).filter(|point| *point < facets.count);
                Err(LawFailure { point, cause: format!("it returned {code}") })
            }
        }
    }
}
