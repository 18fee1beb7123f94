//! Laws of the host on interfaces: the points that they are asked at, and what they answer.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_NULL_POINTER};
use crate::contact::{InterfaceLaw, LawFailure, LawPoints, LawResponse};
use std::ffi::c_void;

/// The points of a pair at which the library calls a law of the host. All numbers of a point follow one another. The host must not write to
/// it, or read it after the call.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_law_points {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// How many points there are, at least 1.
    pub count: usize,
    /// Dimension, 2 or 3.
    pub dim: usize,
    /// Numbers of the history of a point.
    pub history_count: usize,
    /// The bodies, indices for `fmc_context_body_resultant`, the lower one first; 0 and 1 in `fmc_own_law_check`.
    pub body: usize,
    /// See `body`.
    pub partner: usize,
    /// Duration of the step (`fmc_context_set_time_step`); 0: not set.
    pub time_step: f64,
    /// Lengths, (count, dim). First the opening beyond the initial gap, along the normal of `partner`, negative in compression; then the
    /// slip of `body` along the axes in the plane of the facet of `partner`.
    pub jump: *const f64,
    /// Normal of `partner` and tangential axes, by rows, (count, dim, dim), orthonormal. In 2D the axis is the normal turned by +90
    /// degrees. In 3D the first is the x axis projected into the undeformed facet (the z axis, where the normal is within 0.1 degrees of
    /// x), which moves along with the facet. The second is normal x first.
    pub axes: *const f64,
    /// Where the points are on `body`, (count, dim).
    pub position: *const f64,
    /// The same without deformation.
    pub reference: *const f64,
    /// Tributary areas of the points, without deformation, (count).
    pub area: *const f64,
    /// (count, history_count), as last accepted (`fmc_context_commit_step`); 0 at first.
    pub history: *const f64,
    /// Number of fields (`fmc_context_set_law_fields`).
    pub field_count: usize,
    /// Fields at the point of `body`, then at the point of `partner`, (count, 2, field_count).
    pub fields: *const f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// Output of a law of the host.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_law_response {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Force per area without deformation along the axes, (count, dim): positive where it resists a positive jump. An unwritten
    /// entry counts as not finite.
    pub traction: *mut f64,
    /// Its derivative by the jump, with history and time step held, (count, dim, dim), row by row: entry (i, j) is the derivative of
    /// traction i by jump j. It need not be symmetric. An unwritten entry counts as not finite.
    pub tangent: *mut f64,
    /// The history as it would be after a step that ends here, (count, history_count). It is preset to the history at
    /// the start of the step.
    pub history: *mut f64,
    /// Energy per area that unloading would give back, (count); 0 at first. Only reported energies depend on it.
    pub stored: *mut f64,
    /// The same that has been dissipated since the beginning.
    pub dissipated: *mut f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// A law of the host: writes tractions, tangents and history at all points of a pair in `response`. `user` is the pointer given with it.
///
/// Return 0; any other value makes the call of the library fail with `FMC_ERROR_INTERFACE_LAW`, naming point i of the pair for the value
/// i + 1. It is called on the thread that evaluates, never from two threads at once. Pairs follow one another in ascending order, with the
/// points in the order of `fmc_context_law_points`. Where ranks share the work, it is called on every rank with all points. The same input
/// must have a bit-for-bit identical answer. It must not call a function of the same context (it would get `FMC_ERROR_BUSY`), throw, or
/// jump out.
pub type fmc_respond = Option<
    unsafe extern "C" fn(user: *mut c_void, at: *const fmc_law_points, response: *const fmc_law_response) -> i32,
>;

/// A law of the host on an interface, for `FMC_INTERFACE_LAW`. `fmc_own_law_init` sets all of it.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_own_law {
    /// Set by `fmc_own_law_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Numbers that a point carries from step to step. Default 0.
    pub history_count: usize,
    /// The law. It and `user` must outlive the context, or be replaced before by other options of the pair.
    pub respond: fmc_respond,
    /// Passed to `respond`.
    pub user: *mut c_void,
    /// Zero. Room for options of later versions.
    pub reserved: [u64; 4],
}

/// A function of the host and its user pointer.
pub(crate) struct OwnLaw {
    function: unsafe extern "C" fn(*mut c_void, *const fmc_law_points, *const fmc_law_response) -> i32,
    user: *mut c_void,
    history_count: usize,
}

// SAFETY: the pointer is handed through, never followed, and the function is called by the thread that evaluates the context only; the host
// promises in `fmc_own_law` that it may be called from whichever that is.
unsafe impl Send for OwnLaw {}
// SAFETY: as above; evaluations of one context exclude one another.
unsafe impl Sync for OwnLaw {}

impl fmc_own_law {
    pub(crate) fn to_law(self) -> Result<OwnLaw, Failure> {
        let Self { struct_size, history_count, respond, user, reserved } = self;
        check_struct::<Self>("fmc_own_law", struct_size, reserved)?;
        // What no array could hold; the product with the points is then no overflow.
        if history_count > 1 << 20 {
            let text =
                format!("history_count is {history_count}, and at most {} numbers are kept for a point", 1 << 20);
            return Err(Failure::new(FMC_ERROR_BAD_VALUE, text));
        }
        let function = respond.ok_or_else(|| Failure::new(FMC_ERROR_NULL_POINTER, "'respond' is NULL"))?;
        Ok(OwnLaw { function, user, history_count })
    }
}

impl InterfaceLaw for OwnLaw {
    fn history_count(&self) -> usize {
        self.history_count
    }

    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        let asked = fmc_law_points {
            struct_size: size_of::<fmc_law_points>(),
            count: points.count,
            dim: points.dim,
            history_count: self.history_count,
            body: points.bodies[0],
            partner: points.bodies[1],
            time_step: points.time_step,
            jump: points.jumps.as_ptr(),
            axes: points.axes.as_ptr(),
            position: points.positions.as_ptr(),
            reference: points.references.as_ptr(),
            area: points.areas.as_ptr(),
            history: points.history.as_ptr(),
            field_count: points.field_count,
            fields: points.fields.as_ptr(),
            reserved: [0; 4],
        };
        let answer = fmc_law_response {
            struct_size: size_of::<fmc_law_response>(),
            traction: response.tractions.as_mut_ptr(),
            tangent: response.tangents.as_mut_ptr(),
            history: response.history.as_mut_ptr(),
            stored: response.stored.as_mut_ptr(),
            dissipated: response.dissipated.as_mut_ptr(),
            reserved: [0; 4],
        };
        // SAFETY: all arrays are as long as the structs say; the host guarantees a function that keeps to its contract.
        match unsafe { (self.function)(self.user, &raw const asked, &raw const answer) } {
            0 => Ok(()),
            code => {
                let point = usize::try_from(code).ok().map(|code| code - 1).filter(|point| *point < points.count);
                Err(LawFailure { point, cause: format!("it returned {code}") })
            }
        }
    }
}
