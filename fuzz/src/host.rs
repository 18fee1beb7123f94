//! A host that makes the calls of a program, and does not believe what it is told.
//!
//! After every call: a status that exists and is no panic; outputs untouched where it is an error; finite numbers where it
//! is none, the same bits when asked again, and nothing written beside the entries asked for.

use crate::condensation;
use crate::guarded::Guarded;
use crate::in_parts;
use crate::interface::*;
use crate::mesh::Mesh;
use crate::number::Number;
use crate::program::{Call, Fault, Hole, Layout, MOST_CALLS, Options, PairOptions, Pose, Program, Shape};
use std::ffi::{CStr, CString, c_char, c_void};
use std::ptr::{null, null_mut};

/// What outputs hold before a call: no number that a library writes.
const CANARY: u64 = 0x7ff8_dead_beef_cafe;

/// The statuses that exist, but for a panic.
pub(crate) fn checked(status: fmc_status) -> fmc_status {
    if status == PANIC {
        // SAFETY: a text that is valid until the next failure.
        panic!("{}", unsafe { CStr::from_ptr(fmc_last_error()) }.to_string_lossy());
    }
    assert!((OK..=LAST).contains(&status), "status {status}");
    status
}

/// NULL in the place of pointer number `which` if the hole is there; holes are rare.
pub(crate) fn unless<T>(hole: Hole, which: u8, pointer: *mut T) -> *mut T {
    if hole == which + 1 { null_mut() } else { pointer }
}

/// Numbers of a host, laid out as it likes, with canaries in the gaps.
pub(crate) struct Array {
    memory: Guarded<f64>,
    pub(crate) view: fmc_view,
    places: Vec<usize>,
}

impl Array {
    pub(crate) fn new(rows: &[f64], dim: usize, layout: Layout) -> Self {
        let n = rows.len() / dim;
        let (node_stride, axis_stride, first, len) = match layout {
            Layout::Rows => (dim as isize, 1, 0, n * dim),
            Layout::Padded => (dim as isize + 1, 1, 0, (n * (dim + 1)).saturating_sub(1)),
            Layout::Columns => (1, n as isize, 0, n * dim),
            Layout::Reversed => (-(dim as isize), 1, n.saturating_sub(1) * dim, n * dim),
            Layout::Repeated => (0, 1, 0, dim),
        };
        let place = |node: usize, axis: usize| {
            (first as isize + node as isize * node_stride + axis as isize * axis_stride) as usize
        };
        let places: Vec<usize> = (0..n).flat_map(|node| (0..dim).map(move |axis| place(node, axis))).collect();
        let mut values = vec![f64::from_bits(CANARY); len];
        places.iter().zip(rows).for_each(|(&place, &x)| values[place] = x);
        let memory = Guarded::new(&values);
        let data = if n == 0 { memory.ptr() } else { memory.ptr().wrapping_add(first) };
        Self { view: fmc_view { data, node_count: n, node_stride, axis_stride }, memory, places }
    }

    /// The bits of everything.
    fn bits(&self) -> Vec<u64> {
        self.memory.values().into_iter().map(f64::to_bits).collect()
    }

    /// The numbers, in rows; whatever lies between them must be as it was.
    pub(crate) fn rows(&self) -> Vec<f64> {
        let values = self.memory.values();
        let asked: std::collections::BTreeSet<usize> = self.places.iter().copied().collect();
        assert!((0..values.len()).all(|n| asked.contains(&n) || values[n].to_bits() == CANARY), "padding is written");
        self.places.iter().map(|&place| values[place]).collect()
    }
}

/// What a callback needs; it outlives the context.
struct Distance {
    dim: usize,
    radius: f64,
    fault: Fault,
    context: *mut fmc_context,
}

/// # Safety
/// As the header says of the callback; `user` is a [`Distance`].
unsafe extern "C" fn distance(user: *mut c_void, n: usize, x: *const f64, phi: *mut f64, grad: *mut f64) -> i32 {
    // SAFETY: the library hands on the pointer, and rooms for n points.
    unsafe {
        let this = &*user.cast::<Distance>();
        match this.fault {
            Fault::Returns(status) if status != 0 => return status,
            Fault::WritesNothing => return 0,
            Fault::CallsBack => {
                let status = fmc_context_evaluate(this.context, null(), null(), 0, null_mut());
                assert!(this.context.is_null() || status == BUSY, "status {status} from inside a callback");
            }
            _ => {}
        }
        for point in 0..n {
            let x = std::slice::from_raw_parts(x.add(point * this.dim), this.dim);
            let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            let steep = if this.fault == Fault::Steep { 1e3 } else { 1.0 };
            *phi.add(point) = if this.fault == Fault::WritesNan { f64::NAN } else { steep * (length - this.radius) };
            for (axis, x) in x.iter().enumerate() {
                *grad.add(point * this.dim + axis) = if this.fault == Fault::NoGradient { 0.0 } else { *x };
            }
        }
        0
    }
}

/// # Safety
/// As the header says of the callback; `user` is the context, or NULL.
/// What places the nodes of a contact step.
struct Placed {
    context: *mut fmc_context,
    fault: Fault,
    width: usize,
}

unsafe extern "C" fn place(user: *mut c_void, n: usize, displacement: *const f64, coords: *mut f64) -> i32 {
    // SAFETY: the library hands on the pointer, n numbers, and coordinates of at least one node.
    unsafe {
        let this = &*user.cast::<Placed>();
        match this.fault {
            Fault::Returns(status) => return status,
            Fault::WritesNan => coords.write(f64::NAN),
            Fault::CallsBack => {
                let status = fmc_context_evaluate(this.context, null(), null(), 0, null_mut());
                assert!(status == BUSY, "status {status} from inside a callback");
            }
            Fault::Steep if n > 0 => *coords.add(this.width - 1) += 1e3 * *displacement,
            _ => {}
        }
    }
    0
}

unsafe extern "C" fn log(user: *mut c_void, level: i32, text: *const c_char) {
    // SAFETY: the text is valid during the call, and the context lives.
    unsafe {
        assert!(level == 1 && !CStr::from_ptr(text).to_bytes().is_empty());
        let mut count = 0usize;
        checked(fmc_context_counts(user.cast(), &raw mut count, null_mut(), null_mut()));
    }
}

/// Options as the library takes them, for bodies that are ordinary or not: fibers that can be counted in a moment.
fn options(from: &Options, is_ordinary: bool) -> fmc_options {
    let mut options = std::mem::MaybeUninit::<fmc_options>::zeroed();
    // SAFETY: zeros are a value of every field.
    let mut options = unsafe {
        if from.is_raw != 7 {
            assert_eq!(fmc_options_init(options.as_mut_ptr()), OK);
        }
        options.assume_init()
    };
    options.stiffness = from.stiffness.0;
    options.exponent = from.exponent.map_or(options.exponent, |x| x.0);
    options.smoothing_length = from.smoothing_length.map_or(0.0, |x| x.0);
    options.friction_coefficient = from.friction.map_or(0.0, |x| x.0);
    options.friction_stiffness = from.friction_stiffness.map_or(0.0, |x| x.0);
    options.cohesion = from.cohesion.map_or(0.0, |x| x.0);
    options.memoryless_slip = if from.friction_stiffness.is_none() { options.cohesion } else { 0.0 };
    options.fiber_length = from.fiber_length.map_or(0.0, |x| x.0);
    options.seed = from.seed;
    let choice = |which: u32| i32::from((from.choices >> (2 * which)) & 3) - 1;
    // No value at all is one of the four; the default, being the first, is two of them.
    let choices = [0, 1, 2, 3, 4, 5, 6].map(|which| if choice(which) < 0 { None } else { Some(choice(which)) });
    let fields = [
        &mut options.law,
        &mut options.estimator,
        &mut options.pattern,
        &mut options.weights,
        &mut options.momentum_correction,
        &mut options.self_contact,
        &mut options.check_cells,
    ];
    for (field, choice) in fields.into_iter().zip(choices) {
        *field = choice.unwrap_or(*field);
    }
    options.index_base = i32::from(from.index_base);
    options.threads = if from.is_threaded { 2 } else { 1 };
    options.fiber_count = u64::from(from.fiber_count.unwrap_or(100)) * 4;
    match from.spacing {
        Some(spacing) if is_ordinary => {
            options.fiber_count = 0;
            // In space as many lines again lie behind those of the plane.
            options.spacing = if spacing.0.abs() < 0.2 { 0.2 } else { spacing.0 };
        }
        Some(spacing) if !spacing.0.is_finite() || spacing.0 < 0.0 => options.spacing = spacing.0,
        _ => {}
    }
    // What would have no effect is refused; often enough it is left out.
    if !from.seed.is_multiple_of(8) {
        let (is_sampled, is_volume, is_isotropic) = (options.estimator != 1, options.law == 0, options.pattern == 1);
        if options.estimator != 0 {
            options.pattern = 0;
        }
        if !is_sampled {
            (options.spacing, options.fiber_count, options.seed, options.pattern) = (0.0, 0, 0, 0);
        }
        if !is_sampled || !is_volume || is_isotropic {
            options.weights = 0;
        }
        if !is_sampled || !is_isotropic {
            options.fiber_length = 0.0;
        }
    }
    options
}

fn pose(from: &Pose, dim: usize) -> fmc_pose {
    let mut pose = fmc_pose { position: [0.0; 3], rotation: [0.0; 9], scale: 1.0 };
    let (position, axis) = (from.position.map(|x| x.0), from.axis.map(|x| x.0));
    // SAFETY: `dim` entries of three are read.
    unsafe {
        assert_eq!(fmc_pose_init(&raw mut pose), OK);
        let before = pose;
        if checked(fmc_pose_along(dim as i32, position.as_ptr(), axis.as_ptr(), &raw mut pose)) != OK {
            assert_eq!(pose, before);
            pose.position = position;
        }
    }
    if let Some(rotation) = from.rotation {
        pose.rotation = rotation.map(|x| x.0);
    }
    pose.scale = from.scale.map_or(1.0, |x| x.0);
    pose
}

/// The host's state.
struct Host {
    context: *mut fmc_context,
    mesh: Mesh,
    options: fmc_options,
    // Boxes, as the library keeps their addresses.
    #[allow(clippy::vec_box)]
    distances: Vec<Box<Distance>>,
    /// A callback may change its mind from call to call only if it is wrong.
    is_steady: bool,
}

/// Runs a program from the first call to the last.
pub fn run(program: &Program) {
    let options = options(&program.options, program.mesh.is_ordinary());
    let Some(context) = create(&program.mesh, program.is_wide, &options) else { return };
    let mut host = Host { context, mesh: program.mesh.clone(), options, distances: Vec::new(), is_steady: true };
    for call in program.calls.iter().take(MOST_CALLS) {
        host.make(call);
    }
    // SAFETY: the context is the host's own; the second time it is NULL.
    unsafe {
        assert_eq!(fmc_context_free(&raw mut host.context), OK);
        assert!(host.context.is_null());
        assert_eq!(fmc_context_free(&raw mut host.context), OK);
    }
}

/// Nodes of a cell of a type.
pub(crate) fn cell_size(cell_type: i32) -> usize {
    const SIZES: [(i32, usize); 14] = [
        (5, 3),
        (9, 4),
        (10, 4),
        (12, 8),
        (13, 6),
        (14, 5),
        (22, 6),
        (23, 8),
        (24, 10),
        (25, 20),
        (26, 15),
        (27, 13),
        (28, 9),
        (29, 27),
    ];
    SIZES.iter().find(|(number, _)| *number == cell_type).map_or(4, |(_, size)| *size)
}

pub(crate) fn create(mesh: &Mesh, is_wide: bool, options: &fmc_options) -> Option<*mut fmc_context> {
    let coords = Array::new(&mesh.coords, mesh.dim, Layout::Rows);
    let mut context = null_mut();
    let base = i64::from(options.index_base);
    let conn: Vec<Vec<i64>> =
        mesh.blocks.iter().map(|(_, conn)| conn.iter().map(|node| node + base).collect()).collect();
    // SAFETY: arrays as long as they are said to be, alive during the call.
    let status = unsafe {
        if is_wide {
            let conn: Vec<Guarded<i64>> = conn.iter().map(|conn| Guarded::new(conn)).collect();
            let ids = mesh.ids.as_ref().map(|ids| Guarded::new(ids));
            let blocks: Vec<fmc_cell_block_i64> = (mesh.blocks.iter().zip(&conn))
                .map(|((cell_type, nodes), conn)| fmc_cell_block_i64 {
                    cell_type: *cell_type,
                    conn: conn.ptr(),
                    cell_count: nodes.len() / cell_size(*cell_type),
                })
                .collect();
            let ids = ids.as_ref().map_or(null(), |ids| ids.ptr().cast_const());
            let dim = mesh.dim as i32;
            fmc_context_new_from_cells_i64(dim, &coords.view, blocks.as_ptr(), blocks.len(), ids, options, &mut context)
        } else {
            let narrow = |values: &[i64]| Guarded::new(&values.iter().map(|&v| v as i32).collect::<Vec<_>>());
            let conn: Vec<Guarded<i32>> = conn.iter().map(|conn| narrow(conn)).collect();
            let ids = mesh.ids.as_ref().map(|ids| narrow(ids));
            let blocks: Vec<fmc_cell_block> = (mesh.blocks.iter().zip(&conn))
                .map(|((cell_type, nodes), conn)| fmc_cell_block {
                    cell_type: *cell_type,
                    conn: conn.ptr(),
                    cell_count: nodes.len() / cell_size(*cell_type),
                })
                .collect();
            let ids = ids.as_ref().map_or(null(), |ids| ids.ptr().cast_const());
            let dim = mesh.dim as i32;
            fmc_context_new_from_cells(dim, &coords.view, blocks.as_ptr(), blocks.len(), ids, options, &mut context)
        }
    };
    assert_eq!(checked(status) == OK, !context.is_null());
    (status == OK).then_some(context)
}

/// Gathers what this rank sends as if all had sent it.
///
/// # Safety
/// That of `fmc_all_gather`; `user` is the rank and 256 times their number.
pub(crate) unsafe extern "C" fn echo(
    user: *mut c_void,
    send: *const c_void,
    counts: *const u64,
    received: *mut c_void,
) -> i32 {
    // SAFETY: there is one count for every rank, and all are the same.
    unsafe {
        let own = *counts.add(user.addr() % 256) as usize;
        let mut at = received.cast::<u8>();
        for rank in 0..user.addr() / 256 {
            let count = *counts.add(rank) as usize;
            std::ptr::copy_nonoverlapping(send.cast::<u8>(), at, count.min(own));
            at = at.add(count);
        }
    }
    0
}

/// # Safety
/// That of `fmc_all_gather`.
unsafe extern "C" fn fails_to_gather(_: *mut c_void, _: *const c_void, _: *const u64, _: *mut c_void) -> i32 {
    3
}

impl Host {
    fn make(&mut self, call: &Call) {
        match call {
            Call::Evaluate { read, write, add, hole } => self.evaluate(*read, *write, *add, *hole),
            Call::Tangent { read, flags, hole } => self.tangent(*read, *flags, *hole),
            Call::Rows { read, flags, hole } => self.rows(*read, *flags, *hole),
            Call::KeepPattern { keep } => {
                // SAFETY: the host's own context.
                let status = checked(unsafe { fmc_context_keep_pattern(self.context, i32::from(*keep % 3)) });
                assert_eq!(status == OK, keep % 3 < 2);
                // SAFETY: as above.
                let on = i32::from(*keep / 3 % 3);
                assert_eq!(checked(unsafe { fmc_context_set_obstacle_rotations(self.context, on) }) == OK, on < 2);
            }
            Call::Share { rank, size, fails, hole } => self.share(i32::from(*rank), i32::from(*size), *fails, *hole),
            Call::InParts { reach, hole } => in_parts::beside_the_whole(&self.mesh, &self.options, reach.0, *hole),
            Call::StableStep { mass, hole } => self.stable_step(mass.0, *hole),
            Call::ContactStep { which, shift, stiffness, coupling, residual, tolerance, fault, hole } => {
                let numbers = [stiffness.0, coupling.0, residual.0, tolerance.0];
                self.contact_step(*which, i64::from(*shift), numbers, *fault, *hole);
            }
            Call::Condensation { which, shift, value, hole } => condensation::chain(*which, *shift, value.0, *hole),
            Call::Fields { read, hole } => self.fields(*read, *hole),
            Call::Augment { reach, enough, damage, hole } => self.augment(reach.0, enough.0, damage.0, *hole),
            Call::Gaps { reach, hole } => self.gaps(reach.0, *hole),
            Call::KeepPatches { forget, hole } => self.keep_patches(*forget, *hole),
            Call::SetOptions(from) => self.set_options(&options(from, self.mesh.is_ordinary())),
            Call::SetByName { key, value } => self.set_by_name(*key, value),
            Call::AddObstacle { shape, pose: place, hole } => {
                let place = place.as_ref().map(|place| pose(place, self.mesh.dim));
                self.add(shape, place, *hole);
            }
            Call::SetPose { obstacle, pose: place } => {
                let place = pose(place, self.mesh.dim);
                // SAFETY: the host's own context and pose.
                checked(unsafe { fmc_context_set_pose(self.context, *obstacle as usize % 4, &place) });
            }
            Call::RemoveObstacle { obstacle, hole } => self.remove(usize::from(obstacle % 4), *hole),
            Call::SetPair { options, hole } => self.set_pair(options, *hole),
            Call::Move { node, axis, to } => {
                let place = *node as usize % self.mesh.node_count() * self.mesh.dim + *axis as usize % self.mesh.dim;
                // Lines are few while all is ordinary, or counted.
                if to.is_ordinary() || self.options.spacing == 0.0 {
                    self.mesh.coords[place] = to.0;
                }
            }
            Call::Getters { index, hole } => self.getters(*index as usize % 5, *hole),
            Call::SetLog { calls_back } => {
                let callback: fmc_log_callback = if *calls_back { Some(log) } else { None };
                // SAFETY: the callback asks the context that calls it.
                checked(unsafe { fmc_context_set_log(self.context, callback, self.context.cast()) });
            }
            Call::Stateless { hole } => self.stateless(*hole),
            Call::FromFacets { facets, types: [one, other], is_wide } if one % 2 == 1 => {
                self.from_facet_blocks(facets, [one / 2, *other], *is_wide);
            }
            Call::FromFacets { facets, is_wide, .. } => self.from_facets(facets, *is_wide),
            Call::Suggest { dim, values } => suggest(i32::from(*dim % 5), values.map(|x| x.0)),
            Call::Texts { status, feature } => texts(*status, feature),
            Call::SetReference { read, factor, hole } => self.set_reference(*read, factor.0, *hole),
            Call::Step { what, read, value, hole } => self.step(*what, *read, value.0, *hole),
            Call::SetSymmetryNodes { nodes, hole } => self.set_symmetry_nodes(nodes, *hole),
        }
    }

    fn evaluate(&mut self, read: Layout, write: Layout, add: bool, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let before = vec![if add { 0.0 } else { f64::from_bits(CANARY) }; self.mesh.coords.len()];
        let nothing = fmc_result { fiber_count: 77, ..no_result() };
        let once = || {
            let forces = Array::new(&before, self.mesh.dim, write);
            let (untouched, mut result) = (forces.bits(), nothing);
            let (coords_view, forces_view) = (coords.view, forces.view);
            // SAFETY: views of arrays that are as long as they say, alive during the call.
            let status = checked(unsafe {
                fmc_context_evaluate(
                    self.context,
                    unless(hole, 0, (&raw const coords_view).cast_mut()),
                    unless(hole, 1, (&raw const forces_view).cast_mut()),
                    u32::from(add),
                    unless(hole, 2, &raw mut result),
                )
            });
            if status != OK {
                assert!(forces.bits() == untouched && result == nothing, "an error writes outputs");
                return (status, Vec::new(), result);
            }
            if hole != 2 {
                assert!(!matches!(write, Layout::Repeated) || self.mesh.node_count() < 2, "forces fall on one another");
                assert!(forces.rows().iter().all(|f| f.is_finite()), "{:?}", forces.rows());
            }
            if hole != 3 {
                let numbers = [result.volume, result.energy, result.contact_area, result.penetration];
                assert!(numbers.iter().all(|x| x.is_finite() && *x >= 0.0), "{result:?}");
                assert!(result.volume_standard_error >= 0.0 && result.struct_size == size_of::<fmc_result>());
            }
            (status, forces.bits(), result)
        };
        let found = once();
        if self.is_steady {
            assert_eq!(format!("{found:?}"), format!("{:?}", once()), "asked twice");
        }
    }

    fn tangent(&mut self, read: Layout, flags: u8, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let (mut entry_count, mut rank_one_count) = (77usize, 77usize);
        let view = coords.view;
        // SAFETY: as in `evaluate`; entries go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let entries = unless(hole, 1, &raw mut entry_count);
            let flags = u32::from(flags % 4);
            let status = checked(fmc_context_tangent(self.context, coords, flags, entries, &raw mut rank_one_count));
            if status != OK {
                assert_eq!((entry_count, rank_one_count), (77, 77));
                return;
            }
            if hole == 2 {
                return;
            }
            let rows = Guarded::new(&vec![-1; entry_count]);
            let cols = Guarded::new(&vec![-1; entry_count]);
            let values = Guarded::new(&vec![f64::from_bits(CANARY); entry_count]);
            assert_eq!(
                checked(fmc_context_tangent_entries(self.context, rows.ptr(), cols.ptr(), values.ptr(), entry_count)),
                OK
            );
            // Whether they are finite is not asked: entries of bodies of any shape may leave the range.
            assert!(rows.values().iter().chain(&cols.values()).all(|&at| at >= 0));
            assert!(values.values().iter().all(|v| v.to_bits() != CANARY));
            if entry_count > 0 {
                let few = entry_count - 1;
                let status = fmc_context_tangent_entries(self.context, rows.ptr(), cols.ptr(), values.ptr(), few);
                assert_ne!(checked(status), OK, "room for too few");
            }
            let length = self.mesh.coords.len();
            let x = Guarded::new(&vec![1.0; length]);
            assert_eq!(checked(fmc_context_tangent_product(self.context, x.ptr(), x.ptr(), length)), OK);
            let mut factor = 0.0;
            for index in 0..=rank_one_count {
                let status = fmc_context_tangent_rank_one(self.context, index, &raw mut factor, x.ptr(), length);
                assert!(checked(status) != OK || index < rank_one_count);
            }
        }
    }

    /// Forces and tangent in one call, and the tangent in compressed rows of either width.
    fn rows(&mut self, read: Layout, flags: u8, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let forces = Array::new(&vec![0.0; self.mesh.coords.len()], self.mesh.dim, Layout::Rows);
        let (mut result, mut parts) = (no_result(), 77usize);
        let (view, forces_view, dim) = (coords.view, forces.view, self.mesh.dim);
        // SAFETY: as in `tangent`.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let forces = unless(hole, 1, (&raw const forces_view).cast_mut());
            let both = u32::from(flags % 8);
            let result = unless(hole, 2, &raw mut result);
            let status =
                fmc_context_evaluate_tangent(self.context, coords, both, forces, result, null_mut(), &raw mut parts);
            assert!(checked(status) == OK || parts == 77);
            let flags = u32::from(flags >> 3) << 2;
            let (mut row_count, mut count) = (0usize, 0usize);
            let sizes = (&raw mut row_count, &raw mut count);
            if checked(fmc_context_tangent_csr_size(self.context, flags, sizes.0, sizes.1)) != OK {
                assert!(flags & !28 != 0);
                return;
            }
            let numbers = count * if flags & 4 != 0 { dim * dim } else { 1 };
            let (offsets, cols) = (Guarded::new(&vec![-1i32; row_count + 1]), Guarded::new(&vec![-1i32; count]));
            let (wide, wide_cols) = (Guarded::new(&vec![-1i64; row_count + 1]), Guarded::new(&vec![-1i64; count]));
            let values = [0, 1].map(|_| Guarded::new(&vec![f64::from_bits(CANARY); numbers]));
            let [first, second] = [values[0].ptr(), values[1].ptr()];
            if count > 0 {
                let few = count - 1;
                let status = fmc_context_tangent_csr(self.context, flags, offsets.ptr(), cols.ptr(), first, few);
                assert_ne!(checked(status), OK, "room for too few");
                assert!(offsets.values().iter().chain(&cols.values()).all(|&at| at == -1));
            }
            let status = fmc_context_tangent_csr(self.context, flags, offsets.ptr(), cols.ptr(), first, count);
            assert_eq!(checked(status), OK);
            let status = fmc_context_tangent_csr_i64(self.context, flags, wide.ptr(), wide_cols.ptr(), second, count);
            assert_eq!(checked(status), OK);
            let widened = |narrow: &Guarded<i32>| narrow.values().into_iter().map(i64::from).collect::<Vec<_>>();
            assert!(widened(&offsets) == wide.values() && widened(&cols) == wide_cols.values());
            let bits = |values: &Guarded<f64>| values.values().into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert!(bits(&values[0]) == bits(&values[1]) && !bits(&values[0]).contains(&CANARY));
            let base = i64::from(flags & 16 != 0);
            let (wide, cols) = (wide.values(), wide_cols.values());
            assert!(wide[0] == base && wide[row_count] == count as i64 + base);
            for row in wide.windows(2) {
                let cols = &cols[(row[0] - base) as usize..(row[1] - base) as usize];
                assert!(
                    cols.is_sorted_by(|a, b| a < b)
                        && cols.iter().all(|col| (base..row_count as i64 + base).contains(col))
                );
            }
        }
    }

    fn fields(&mut self, read: Layout, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let (view, n, mut count) = (array.view, self.mesh.node_count(), 77usize);
        let numbers = |each: usize| Guarded::new(&vec![f64::from_bits(CANARY); n * each]);
        let (pressure, gap, area, normal) = (numbers(1), numbers(1), numbers(1), numbers(self.mesh.dim));
        let (friction, sliding, touches) = (numbers(self.mesh.dim), numbers(1), Guarded::new(&vec![7; n]));
        // SAFETY: as in `evaluate`; points go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let (p, s) = (unless(hole, 1, pressure.ptr()), unless(hole, 2, touches.ptr()));
            let room = if hole == 6 { n + 1 } else { n };
            let (gap_at, area_at, normal_at) = (gap.ptr(), area.ptr(), normal.ptr());
            let (friction_at, sliding_at) = (friction.ptr(), sliding.ptr());
            let status = fmc_context_nodal_contact(
                self.context,
                coords,
                p,
                gap_at,
                area_at,
                normal_at,
                friction_at,
                sliding_at,
                s,
                room,
            );
            let is_ok = checked(status) == OK;
            assert!(!is_ok || room == n);
            let found = [gap.values(), normal.values(), friction.values(), sliding.values()].concat();
            assert_eq!(found.iter().any(|v| v.to_bits() == CANARY), !is_ok);
            assert!(!is_ok || sliding.values().iter().all(|part| (0.0..=1.0 + 1e-9).contains(part)));
            assert!(is_ok && hole != 3 || touches.values().iter().all(|s| *s == 7));
            assert!(!is_ok || hole == 3 || touches.values().iter().all(|s| (0..=3).contains(s)));
            let count_at = unless(hole, 4, &raw mut count);
            if checked(fmc_context_find_contact_points(self.context, coords, count_at)) != OK || hole == 5 {
                assert_eq!(count, 77);
                return;
            }
            let blank = std::mem::MaybeUninit::<fmc_contact_point>::zeroed().assume_init();
            let points = Guarded::new(&vec![blank; count]);
            if count > 0 {
                assert_ne!(checked(fmc_context_contact_points(self.context, points.ptr(), count - 1)), OK);
            }
            assert_eq!(checked(fmc_context_contact_points(self.context, points.ptr(), count)), OK);
            assert!(points.values().iter().all(|point| point.struct_size == size_of::<fmc_contact_point>()));
        }
    }

    fn gaps(&mut self, reach: f64, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut rows, mut entries) = (array.view, 77usize, 77usize);
        // SAFETY: as in `evaluate`; rows and entries go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let (rows_at, entries_at) = (unless(hole, 1, &raw mut rows), unless(hole, 2, &raw mut entries));
            let status = fmc_context_find_gap_constraints(self.context, coords, reach, rows_at, entries_at);
            if checked(status) != OK || (2..4).contains(&hole) {
                assert!(rows == 77 || hole == 3);
                return;
            }
            let blank = std::mem::MaybeUninit::<fmc_gap_constraint>::zeroed().assume_init();
            let found = Guarded::new(&vec![blank; rows]);
            let (offsets, cols) = (Guarded::new(&vec![-7i64; rows + 1]), Guarded::new(&vec![-7i64; entries]));
            let values = Guarded::new(&vec![f64::from_bits(CANARY); entries]);
            if rows > 0 {
                assert_ne!(checked(fmc_context_gap_constraints(self.context, found.ptr(), rows - 1)), OK);
            }
            assert_eq!(checked(fmc_context_gap_constraints(self.context, found.ptr(), rows)), OK);
            assert!(found.values().iter().all(|row| row.struct_size == size_of::<fmc_gap_constraint>()));
            let (offsets_at, cols_at, values_at) = (offsets.ptr(), cols.ptr(), values.ptr());
            assert_eq!(checked(fmc_context_gap_gradient(self.context, offsets_at, cols_at, values_at, entries)), OK);
            assert_eq!(offsets.values().last().copied(), Some(entries as i64));
            let size = (self.mesh.node_count() * self.mesh.dim) as i64;
            assert!(cols.values().iter().all(|col| (0..size).contains(col)));
            assert!(values.values().iter().all(|value| value.is_finite()));
        }
    }

    /// Moves surfaces out, reads by how much, damages one and sets it.
    fn augment(&mut self, reach: f64, enough: f64, damage: f64, hole: Hole) {
        let array = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let view = array.view;
        // SAFETY: as in `evaluate`; structs of this interface, of which there is room for as many as are told of.
        unsafe {
            let mut found = std::mem::MaybeUninit::<fmc_augmentation>::zeroed().assume_init();
            let (coords, found_at) = (unless(hole, 0, (&raw const view).cast_mut()), unless(hole, 1, &raw mut found));
            let status = checked(fmc_context_augment(self.context, coords, reach, enough, found_at));
            let mut count = 77usize;
            assert_eq!(checked(fmc_context_multipliers(self.context, std::ptr::null_mut(), 0, &raw mut count)), OK);
            if status == OK {
                assert_eq!((found.struct_size, found.multiplier_count), (size_of::<fmc_augmentation>(), count));
                assert!(found.penetration >= 0.0 && found.change >= 0.0);
            }
            // A factor that is none; with others the options would be no more what they are known to be.
            if !(damage > 0.0 && damage.is_finite()) {
                assert_ne!(checked(fmc_context_stiffen(self.context, damage)), OK);
            }
            assert_eq!(checked(fmc_context_stiffen(self.context, 1.0)), OK);
            let blank = std::mem::MaybeUninit::<fmc_multiplier>::zeroed().assume_init();
            let kept = Guarded::new(&vec![blank; count]);
            if count > 1 {
                assert_ne!(checked(fmc_context_multipliers(self.context, kept.ptr(), count - 1, &raw mut count)), OK);
            }
            assert_eq!(checked(fmc_context_multipliers(self.context, kept.ptr(), count, &raw mut count)), OK);
            let mut given = kept.values().to_vec();
            assert!(given.iter().all(|one| one.struct_size == size_of::<fmc_multiplier>() && one.shift > 0.0));
            for one in given.iter_mut().take(1) {
                match hole % 5 {
                    0 => one.shift = damage,
                    1 => one.node = damage as i64,
                    2 => one.partner = damage as usize,
                    3 => one.partner_kind = damage as i32,
                    _ => one.towards[0] = damage,
                }
            }
            let given = Guarded::new(&given);
            if checked(fmc_context_set_multipliers(self.context, given.ptr(), count)) == OK {
                let mut energy = std::mem::MaybeUninit::<fmc_result>::zeroed().assume_init();
                checked(fmc_context_evaluate(self.context, &raw const view, std::ptr::null_mut(), 0, &raw mut energy));
            }
            assert_eq!(checked(fmc_context_set_multipliers(self.context, kept.ptr(), count)), OK);
            // What follows is compared with contacts that have none.
            assert_eq!(checked(fmc_context_set_multipliers(self.context, std::ptr::null(), 0)), OK);
        }
    }

    /// What is right on one rank is right on ranks that are all the same: what the others should have sent is done here.
    fn share(&mut self, rank: i32, size: i32, fails: bool, hole: Hole) {
        // SAFETY: structs of this interface, the host's own context, and functions that keep to their contract.
        unsafe {
            let mut given = std::mem::MaybeUninit::<fmc_communicator>::zeroed().assume_init();
            let set = |given: &fmc_communicator| checked(fmc_context_set_communicator(self.context, given));
            assert!(set(&given) != OK, "a communicator that was not initialised");
            let to = unless(hole, 0, &raw mut given);
            let is_set = !to.is_null();
            assert_eq!(checked(fmc_communicator_init(to)) == OK, is_set);
            assert!(set(&given) != OK, "a communicator without a function");
            (given.rank, given.size) = (rank, size);
            given.user = std::ptr::without_provenance_mut((rank.max(0) + 256 * size.max(0)) as usize);
            if fails && self.mesh.is_ordinary() {
                given.all_gather = Some(fails_to_gather);
                if set(&given) == OK {
                    self.evaluate_refused();
                }
            }
            given.all_gather = Some(echo);
            assert_eq!(set(&given) == OK, is_set && (0..size).contains(&rank), "rank {rank} of {size}");
            let mut counts = fmc_rank_counts::default();
            let to = unless(hole, 1, &raw mut counts);
            let status = checked(fmc_context_rank_counts(self.context, to));
            assert!((status == OK) != to.is_null() && counts.own_item_count <= counts.item_count);
            if hole % 2 == 0 {
                assert_eq!(checked(fmc_context_set_communicator(self.context, std::ptr::null())), OK);
            }
        }
    }

    /// Evaluates where that has to fail.
    fn evaluate_refused(&self) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let view = coords.view;
        // SAFETY: as in `evaluate`.
        let status = checked(unsafe {
            fmc_context_evaluate(self.context, &raw const view, std::ptr::null(), 0, std::ptr::null_mut())
        });
        assert!(status != OK, "nothing was gathered");
    }

    fn stable_step(&mut self, mass: f64, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let masses = Guarded::new(&vec![mass; self.mesh.node_count()]);
        let (view, mut step) = (coords.view, -77.0);
        // SAFETY: as in `evaluate`, with a mass for every node.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let masses = unless(hole, 1, masses.ptr());
            let status = fmc_context_stable_step(self.context, coords, masses, unless(hole, 2, &raw mut step));
            assert!(if checked(status) == OK { step > 0.0 } else { step == -77.0 }, "{step}");
        }
    }

    fn contact_step(&mut self, which: u16, shift: i64, numbers: [f64; 4], fault: Fault, hole: Hole) {
        let [stiffness, coupling, residual, tolerance] = numbers;
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let freedoms = 0..(self.mesh.node_count() * self.mesh.dim) as i64;
        let (mut list, mut held): (Vec<i64>, Vec<i64>) = freedoms.partition(|freedom| which >> (freedom % 15) & 1 == 1);
        if which >> 15 == 1 {
            held.clear();
        }
        if let Some(first) = list.first_mut() {
            *first += shift;
        }
        let count = list.len();
        let at = |entry: usize| if entry / count == entry % count { stiffness } else { coupling };
        let matrix: Vec<f64> = (0..count * count).map(at).collect();
        let given =
            (Guarded::new(&list), Guarded::new(&held), Guarded::new(&matrix), Guarded::new(&vec![residual; count]));
        let found = Guarded::new(&vec![-77.0; count]);
        let user = Placed { context: self.context, fault, width: self.mesh.dim };
        let view = coords.view;
        // SAFETY: arrays of the lengths that are said, structs of the header, and a function that keeps to its contract or not.
        unsafe {
            let mut options = std::mem::MaybeUninit::<fmc_contact_step_options>::zeroed().assume_init();
            let mut result = std::mem::MaybeUninit::<fmc_contact_step_result>::zeroed().assume_init();
            assert_eq!(checked(fmc_contact_step_options_init(&raw mut options)), OK);
            (options.tolerance, options.most_iterations, options.soft_start) =
                (tolerance, 12, i32::from(which & 1 == 1));
            if which & 1 << 14 != 0 {
                (options.penetration, options.most_updates) = (coupling, 3);
            }
            let status = fmc_context_contact_step(
                self.context,
                unless(hole, 0, (&raw const view).cast_mut()),
                unless(hole, 1, &raw mut options),
                unless(hole, 2, given.0.ptr()),
                count,
                unless(hole, 3, given.1.ptr()),
                held.len(),
                unless(hole, 4, given.2.ptr()),
                unless(hole, 5, given.3.ptr()),
                if fault == Fault::None { None } else { Some(place) },
                (&raw const user).cast_mut().cast(),
                unless(hole, 6, found.ptr()),
                unless(hole, 7, &raw mut result),
            );
            if checked(status) == OK {
                assert!(found.values().iter().all(|d| d.is_finite()));
                assert!(hole == 7 || (0..=2).contains(&result.state) && result.residual.is_finite());
            } else {
                assert!(found.values().iter().all(|d| *d == -77.0) && result.struct_size == 0);
            }
        }
    }

    fn set_reference(&mut self, read: Layout, factor: f64, hole: Hole) {
        let mut coords = self.mesh.coords.clone();
        coords.iter_mut().step_by(self.mesh.dim).for_each(|x| *x *= factor);
        let coords = Array::new(&coords, self.mesh.dim, read);
        let view = coords.view;
        // SAFETY: as in `evaluate`.
        checked(unsafe {
            fmc_context_set_reference(self.context, unless(hole, 0, (&raw const view).cast_mut()).cast_const())
        });
        self.set_basis(factor, hole);
    }

    /// Every node between two unknowns, of which there is one more than nodes; then nodes move by themselves again.
    fn set_basis(&mut self, part: f64, hole: Hole) {
        let (n, base) = (self.mesh.node_count(), i64::from(self.options.index_base));
        let offsets: Vec<i64> = (0..=n as i64).map(|row| 2 * row).collect();
        let unknowns: Vec<i64> = (0..n as i64).flat_map(|row| [row + base, row + 1 + base]).collect();
        let weights: Vec<f64> = (0..n).flat_map(|_| [part, 1.0 - part]).collect();
        let (offsets, unknowns, weights) = (Guarded::new(&offsets), Guarded::new(&unknowns), Guarded::new(&weights));
        let at = |count: usize, entries: usize| {
            // SAFETY: a living context or NULL, arrays of the sizes that are said, or smaller sizes.
            checked(unsafe {
                fmc_context_set_basis(
                    self.context,
                    count,
                    offsets.ptr().cast_const(),
                    unless(hole, 0, unknowns.ptr()).cast_const(),
                    unless(hole, 1, weights.ptr()).cast_const(),
                    entries,
                )
            })
        };
        assert_ne!(at(n, 2 * n), OK, "an unknown too many");
        assert_ne!(at(n + 1, 2 * n - 1), OK, "an entry too few");
        if at(n + 1, 2 * n) == OK {
            assert!(part.is_finite());
            let mut coords = self.mesh.coords.clone();
            coords.extend(vec![0.0; self.mesh.dim]);
            let coords = Array::new(&coords, self.mesh.dim, Layout::Rows);
            let forces = Array::new(&vec![0.0; (n + 1) * self.mesh.dim], self.mesh.dim, Layout::Rows);
            let (view, target) = (coords.view, forces.view);
            // SAFETY: views of as many rows as unknowns.
            checked(unsafe { fmc_context_evaluate(self.context, &raw const view, &raw const target, 0, null_mut()) });
        }
        // SAFETY: nothing is read.
        checked(unsafe {
            fmc_context_set_basis(self.context, 0, std::ptr::null(), std::ptr::null(), std::ptr::null(), 0)
        });
    }

    fn step(&mut self, what: u8, read: Layout, value: f64, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let view = coords.view;
        let coords = unless(hole, 0, (&raw const view).cast_mut()).cast_const();
        let count = self.mesh.dim * self.facet_count();
        let length = count.saturating_sub(usize::from(what > 250));
        let slip = Guarded::new(&vec![value; length]);
        // SAFETY: a living context or NULL, a view or NULL, as many numbers as it says.
        unsafe {
            match what % 5 {
                0 => checked(fmc_context_begin_step(self.context, coords)),
                1 => checked(fmc_context_commit_step(self.context, coords)),
                2 => checked(fmc_context_freeze_friction(self.context, coords)),
                3 => checked(fmc_context_set_slip(self.context, unless(hole, 1, slip.ptr()).cast_const(), length)),
                _ => checked(fmc_context_slip(self.context, unless(hole, 1, slip.ptr()), length)),
            };
        }
    }

    /// Facets of the context's surface.
    fn facet_count(&self) -> usize {
        let mut count = 0;
        // SAFETY: a living context or NULL, and room for one number.
        checked(unsafe {
            fmc_context_counts(self.context, std::ptr::null_mut(), &raw mut count, std::ptr::null_mut())
        });
        count
    }

    fn set_symmetry_nodes(&mut self, nodes: &[u8], hole: Hole) {
        let nodes: Vec<i64> = nodes.iter().map(|&node| i64::from(node) - 2).collect();
        let numbers = Guarded::new(&nodes);
        // SAFETY: as many numbers as it says.
        checked(unsafe {
            fmc_context_set_symmetry_nodes(self.context, unless(hole, 0, numbers.ptr()).cast_const(), nodes.len())
        });
    }

    fn keep_patches(&mut self, forget: bool, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (view, mut count) = (coords.view, 77usize);
        // SAFETY: as in `evaluate`.
        unsafe {
            let coords = if forget { null() } else { &raw const view };
            let status = fmc_context_keep_patches(self.context, coords, unless(hole, 0, &raw mut count));
            assert!(checked(status) == OK || count == 77);
        }
    }

    fn set_options(&mut self, options: &fmc_options) {
        // SAFETY: the host's own context and options.
        if checked(unsafe { fmc_context_set_options(self.context, options) }) == OK {
            self.options = *options;
        }
    }

    fn set_by_name(&mut self, key: u8, value: &[u8; 6]) {
        const KEYS: [&CStr; 18] = [
            c"stiffness",
            c"exponent",
            c"smoothing_length",
            c"spacing",
            c"fiber_length",
            c"fiber_count",
            c"seed",
            c"law",
            c"estimator",
            c"pattern",
            c"weights",
            c"momentum_correction",
            c"self_contact",
            c"check_cells",
            c"threads",
            c"index_base",
            c" law ",
            c"no option",
        ];
        const VALUES: [&CStr; 8] = [c"1", c"0", c"2.5d6", c"exact", c"fibers", c"fiber", c"volume", c"consistent"];
        let end = value.iter().position(|b| *b == 0).unwrap_or(6);
        let own = CString::new(&value[..end]).expect("no zero within");
        let value = if value[0] < 64 { VALUES[value[0] as usize % 8] } else { &own };
        let mut options = self.options;
        // SAFETY: a struct of the header's size, and texts that end in zero.
        let status =
            checked(unsafe { fmc_options_set(&raw mut options, KEYS[key as usize % 18].as_ptr(), value.as_ptr()) });
        // Fine lines and many threads are a matter of time, not of soundness.
        if status == OK && (1..=2).contains(&options.threads) && options.fiber_count <= 1_000 {
            let is_fine = options.spacing > 0.0 && (options.spacing < 0.2 || !self.mesh.is_ordinary());
            let is_automatic = options.spacing == 0.0 && options.fiber_count == 0;
            if !is_fine && !is_automatic {
                self.set_options(&options);
            }
        }
    }

    fn add(&mut self, shape: &Shape, place: Option<fmc_pose>, hole: Hole) {
        let (context, mut obstacle) = (self.context, 77usize);
        let place = place.as_ref().map_or(null(), |place| &raw const *place);
        let index = unless(hole, 0, &raw mut obstacle);
        let base = i64::from(self.options.index_base);
        // SAFETY: `dim` entries of three are read; arrays are as long as they say.
        let status = checked(unsafe {
            match shape {
                Shape::HalfSpace => fmc_context_add_half_space(context, place, index),
                Shape::Ball(radius) => fmc_context_add_ball(context, radius.0, place, index),
                Shape::Cuboid(half) => {
                    let half = Guarded::new(&half.map(|x| x.0)[..self.mesh.dim]);
                    fmc_context_add_cuboid(context, unless(hole, 1, half.ptr()), place, index)
                }
                Shape::Cylinder(radius, half) => fmc_context_add_cylinder(context, radius.0, half.0, place, index),
                Shape::Cone(radius, half) => fmc_context_add_cone(context, radius.0, half.0, place, index),
                Shape::Capsule(radius, half) => fmc_context_add_capsule(context, radius.0, half.0, place, index),
                Shape::Polytope { corners, facets, is_wide } => {
                    let dim = self.mesh.dim;
                    let points: Vec<f64> =
                        corners.iter().take(dim + 1).flat_map(|x| x[..dim].iter().map(|x| x.0)).collect();
                    let points = Array::new(&points, dim, Layout::Rows);
                    let simplex: &[i64] =
                        if dim == 2 { &[0, 1, 1, 2, 2, 0] } else { &[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3] };
                    let facets: Vec<i64> = match facets.len() {
                        0..3 => simplex.iter().map(|node| node + base).collect(),
                        _ => facets.iter().map(|f| i64::from(f % 8) - 1).collect(),
                    };
                    let count = facets.len() / dim;
                    if *is_wide {
                        let facets = Guarded::new(&facets[..count * dim]);
                        fmc_context_add_polytope_i64(context, &points.view, facets.ptr(), count, place, index)
                    } else {
                        let facets: Vec<i32> = facets[..count * dim].iter().map(|&f| f as i32).collect();
                        let facets = Guarded::new(&facets);
                        fmc_context_add_polytope(context, &points.view, facets.ptr(), count, place, index)
                    }
                }
                Shape::ConvexHull(points) => {
                    let dim = self.mesh.dim;
                    let points: Vec<f64> = points.iter().take(12).flat_map(|x| x[..dim].iter().map(|x| x.0)).collect();
                    let points = Array::new(&points, dim, Layout::Rows);
                    fmc_context_add_convex_hull(context, &points.view, place, index)
                }
                Shape::HeightField { count, heights, thickness } => {
                    let counts = Guarded::new(&[usize::from(count % 5), 2][..self.mesh.dim - 1]);
                    let lengths = Guarded::new(&[2.0, 1.0][..self.mesh.dim - 1]);
                    let heights = heights.map(|x| x.0);
                    let heights = Guarded::new(&heights[..counts.values().iter().product()]);
                    let (counts, lengths) = (unless(hole, 1, counts.ptr()), lengths.ptr());
                    fmc_context_add_height_field(context, counts, lengths, heights.ptr(), thickness.0, place, index)
                }
                Shape::Compound(parts) => {
                    let part = |(shape, size): &(u8, Number)| {
                        let mut part = std::mem::MaybeUninit::<fmc_part>::zeroed();
                        assert_eq!(fmc_part_init(part.as_mut_ptr()), OK);
                        let mut part = part.assume_init();
                        part.shape = i32::from(shape % 9);
                        (part.radius, part.half_height, part.half_extents) = (size.0, 0.5, [size.0; 3]);
                        part
                    };
                    let parts = Guarded::new(&parts.iter().take(4).map(part).collect::<Vec<_>>());
                    fmc_context_add_compound(context, parts.ptr(), parts.values().len(), place, index)
                }
                Shape::SignedDistance { radius, fault } => {
                    let radius = if radius.0.is_finite() { radius.0.abs().min(2.0) } else { 1.0 };
                    let own = Box::new(Distance { dim: self.mesh.dim, radius, fault: *fault, context });
                    let user = (&raw const *own).cast_mut().cast();
                    self.distances.push(own);
                    fmc_context_add_signed_distance(context, Some(distance), user, place, index)
                }
            }
        });
        assert!(status == OK || obstacle == 77, "an error writes outputs");
    }

    fn remove(&mut self, obstacle: usize, hole: Hole) {
        let (mut shape, mut place) = (77, fmc_pose { position: [0.5; 3], rotation: [0.5; 9], scale: 0.5 });
        let untouched = place;
        // SAFETY: the host's own context, and outputs that may be written.
        unsafe {
            let context = self.context;
            let mut find = || {
                let (shape, place) = (unless(hole, 0, &raw mut shape), unless(hole, 1, &raw mut place));
                checked(fmc_context_obstacle_shape(context, obstacle, shape, place))
            };
            let before = find();
            assert_eq!(checked(fmc_context_remove_obstacle(context, obstacle)), before);
            assert_eq!(find(), if before == OK { REMOVED } else { before });
            assert!(if before != OK || hole == 1 { shape == 77 } else { (0..=10).contains(&shape) });
            assert!(if before != OK || hole == 2 { place == untouched } else { place.scale > 0.0 });
        }
    }

    fn set_pair(&mut self, from: &PairOptions, hole: Hole) {
        let [(a_kind, a), (b_kind, b)] = from.sides.map(|side| (i32::from(side % 5 / 2), usize::from(side / 5 % 4)));
        let context = self.context;
        let none = fmc_pair_options {
            struct_size: 77,
            stiffness: 0.0,
            exponent: 0.0,
            smoothing_length: 0.0,
            gap_offset: 0.0,
            friction_coefficient: 0.0,
            law: 77,
            excluded: 77,
            reserved: [77; 10],
        };
        // SAFETY: the host's own context, and structs of the header's size.
        unsafe {
            let found = || {
                let mut found = none;
                let status = checked(fmc_context_pair_options(context, a_kind, a, b_kind, b, &raw mut found));
                assert!(status == OK || found == none, "an error writes outputs");
                (status, found)
            };
            let before = found();
            let mut options = none;
            assert_eq!(fmc_pair_options_init(&raw mut options), OK);
            options.law = i32::from(from.law % 6) - 1;
            // What belongs to a law is refused without one; often enough it is left out.
            if options.law >= 0 || from.law >= 250 {
                options.stiffness = from.stiffness.0;
                options.exponent = from.exponent.map_or(1.0, |x| x.0);
                options.smoothing_length = from.smoothing_length.map_or(0.0, |x| x.0);
            }
            options.excluded = i32::from(from.excluded % 3);
            options.gap_offset = from.gap_offset.map_or(0.0, |x| x.0);
            let given = unless(hole, 0, &raw mut options).cast_const();
            let status = checked(fmc_context_set_pair_options(context, a_kind, a, b_kind, b, given));
            let after = found();
            if status == OK {
                assert!(after.0 == OK && (given.is_null() || after.1 == options), "{after:?}");
            } else {
                assert_eq!(before, after);
            }
        }
    }

    fn getters(&self, index: usize, hole: Hole) {
        let mut resultant = fmc_resultant {
            id: 77,
            force: [0.5; 3],
            moment: [0.5; 3],
            node_count: 77,
            friction: [0.5; 3],
            reserved: [7; 4],
        };
        let untouched = resultant;
        let mut pair = std::mem::MaybeUninit::<fmc_pair>::zeroed();
        let (mut code, mut text) = (0, null());
        let mut counts = [0usize; 3];
        // SAFETY: outputs that may be written.
        unsafe {
            let status = checked(fmc_context_body(self.context, index, unless(hole, 0, &raw mut resultant)));
            assert!(status == OK || resultant == untouched);
            let mut resultant = untouched;
            let status = checked(fmc_context_obstacle(self.context, index, unless(hole, 1, &raw mut resultant)));
            assert!(status == OK || resultant == untouched);
            let status = checked(fmc_context_pair(self.context, index, unless(hole, 2, pair.as_mut_ptr())));
            let pair = pair.assume_init();
            assert!(if status == OK { pair.struct_size == size_of::<fmc_pair>() } else { pair.struct_size == 0 });
            if checked(fmc_context_warning(self.context, index, &raw mut code, unless(hole, 3, &raw mut text))) == OK
                && hole != 4
            {
                assert!((1..=6).contains(&code) && !CStr::from_ptr(text).to_bytes().is_empty());
            }
            let [nodes, facets, bodies] = &mut counts;
            assert_eq!(checked(fmc_context_counts(self.context, nodes, facets, unless(hole, 4, bodies))), OK);
            assert_eq!(counts[0], self.mesh.node_count());
            let blank = std::mem::MaybeUninit::<fmc_boundary_facet>::zeroed().assume_init();
            let found = Guarded::new(&vec![blank; counts[1]]);
            assert_ne!(checked(fmc_context_boundary_facets(self.context, found.ptr(), counts[1] - 1)), OK);
            let target = unless(hole, 2, found.ptr());
            let is_wanted = !target.is_null();
            let status = checked(fmc_context_boundary_facets(self.context, target, counts[1]));
            assert_eq!(status == OK, is_wanted);
            let size = if is_wanted { size_of::<fmc_boundary_facet>() } else { 0 };
            assert!(found.values().iter().all(|facet| facet.struct_size == size));
            let weights = self.point_weights(hole);
            let named = found.values().into_iter().flat_map(|facet| facet.nodes);
            let points = weights + i64::from(self.options.index_base);
            assert!(!is_wanted || named.into_iter().all(|point| (-1..points).contains(&point)));
            CStr::from_ptr(fmc_context_error(unless(hole, 5, self.context))).to_str().expect("UTF-8");
        }
    }

    /// Points as combinations of nodes; returns their number.
    fn point_weights(&self, hole: Hole) -> i64 {
        let (mut points, mut entries) = (77usize, 77usize);
        // SAFETY: outputs that may be written, with room for as much as is said.
        unsafe {
            let context = unless(hole, 6, self.context).cast_const();
            let status = checked(fmc_context_point_weights_size(context, &raw mut points, &raw mut entries));
            if status != OK {
                assert!(context.is_null() && (points, entries) == (77, 77));
                return i64::MAX / 2;
            }
            let offsets = Guarded::new(&vec![-7i64; points + 1]);
            let (nodes, weights) = (Guarded::new(&vec![-7i64; entries]), Guarded::new(&vec![CANARY; entries]));
            let at = |offsets: *mut i64, nodes: *mut i64, points: usize, entries: usize| {
                let weights = weights.ptr().cast();
                checked(fmc_context_point_weights(context, offsets, points, nodes, weights, entries))
            };
            assert_ne!(at(offsets.ptr(), nodes.ptr(), points - 1, entries), OK);
            assert_ne!(at(offsets.ptr(), nodes.ptr(), points, entries - 1), OK);
            assert_ne!(at(null_mut(), nodes.ptr(), points, entries), OK);
            assert_ne!(at(offsets.ptr(), null_mut(), points, entries), OK);
            assert!(offsets.values().iter().chain(&nodes.values()).all(|&at| at == -7), "an error writes outputs");
            assert_eq!(at(offsets.ptr(), nodes.ptr(), points, entries), OK);
            let (offsets, nodes, weights) = (offsets.values(), nodes.values(), weights.values());
            assert!(points >= self.mesh.node_count() && (offsets[0], offsets[points]) == (0, entries as i64));
            let base = i64::from(self.options.index_base);
            let range = base..self.mesh.node_count() as i64 + base;
            for row in offsets.windows(2) {
                let row = row[0] as usize..row[1] as usize;
                assert!(!row.is_empty() && nodes[row.clone()].iter().all(|node| range.contains(node)));
                let sum: f64 = weights[row].iter().map(|&bits| f64::from_bits(bits)).sum();
                assert!((sum - 1.0).abs() < 1e-12, "{sum}");
            }
            points as i64
        }
    }

    fn stateless(&self, hole: Hole) {
        let Some((cell_type, conn)) = self.mesh.blocks.first() else { return };
        let size = cell_size(*cell_type);
        let wide = Guarded::new(&conn.iter().map(|n| n + i64::from(self.options.index_base)).collect::<Vec<_>>());
        let narrow = Guarded::new(&wide.values().iter().map(|&n| n as i32).collect::<Vec<_>>());
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let canaries = vec![f64::from_bits(CANARY); self.mesh.coords.len()];
        let (dim, n, cells) = (self.mesh.dim as i32, self.mesh.node_count(), conn.len() / size);
        let call = |is_wide: bool| {
            let (forces, mut volume) = (Guarded::new(&canaries), -1.0);
            // SAFETY: arrays as long as they are said to be.
            let status = unsafe {
                let (x, o) = (unless(hole, 0, coords.memory.ptr()), &raw const self.options);
                let (f, v) = (unless(hole, 1, forces.ptr()), unless(hole, 2, &raw mut volume));
                if is_wide {
                    fmc_contact_force_i64(dim, x, n, *cell_type, wide.ptr(), cells, null(), o, f, v)
                } else {
                    fmc_contact_force(dim, x, n, *cell_type, narrow.ptr(), cells, null(), o, f, v)
                }
            };
            let bits: Vec<u64> = forces.values().into_iter().map(f64::to_bits).collect();
            if checked(status) != OK {
                assert!(bits.iter().all(|b| *b == CANARY) && volume == -1.0, "an error writes outputs");
            }
            (status, bits, volume.to_bits())
        };
        assert_eq!(call(false), call(true));
        let stepped = |is_wide: bool| {
            let (forces, next) = (Guarded::new(&canaries), Guarded::new(&canaries));
            // SAFETY: arrays as long as they are said to be; a slip of another length than `n` rows is refused.
            let (status, volume) = unsafe {
                let (mut step, mut volume) = (std::mem::zeroed(), -1.0);
                assert_eq!(fmc_friction_step_init(&raw mut step), OK);
                (step.start, step.slip_length) = (unless(hole, 3, coords.memory.ptr()), canaries.len());
                step.next_slip = unless(hole, 4, next.ptr());
                let (x, o, f) = (coords.memory.ptr(), &raw const self.options, forces.ptr());
                let (v, step) = (&raw mut volume, unless(hole, 5, &raw mut step));
                let status = if is_wide {
                    fmc_contact_force_step_i64(dim, x, n, *cell_type, wide.ptr(), cells, null(), o, step, f, v)
                } else {
                    fmc_contact_force_step(dim, x, n, *cell_type, narrow.ptr(), cells, null(), o, step, f, v)
                };
                (checked(status), volume)
            };
            let bits: Vec<u64> = forces.values().iter().chain(&next.values()).map(|x| x.to_bits()).collect();
            if status != OK {
                assert!(bits.iter().all(|x| *x == CANARY) && volume == -1.0, "an error writes outputs");
            }
            (status, bits, volume.to_bits())
        };
        assert_eq!(stepped(false), stepped(true));
    }

    /// The same from two blocks of facets of these types, known or not.
    fn from_facet_blocks(&self, facets: &[u8], types: [u8; 2], is_wide: bool) {
        const TYPES: [(i32, usize); 8] = [(3, 2), (5, 3), (9, 4), (21, 3), (22, 6), (23, 8), (28, 9), (7, 5)];
        let n = self.mesh.node_count() as i64 + 1;
        let all: Vec<i64> = facets.iter().take(72).map(|f| i64::from(*f) % n).collect();
        let halves = all.split_at(all.len() / 2);
        let blocks = [(halves.0, types[0]), (halves.1, types[1])].map(|(nodes, of)| {
            let (number, width) = TYPES[usize::from(of) % TYPES.len()];
            (number, &nodes[..nodes.len() / width * width], nodes.len() / width)
        });
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (dim, mut context) = (self.mesh.dim as i32, null_mut());
        let (o, to) = (&raw const self.options, &raw mut context);
        // SAFETY: arrays as long as they are said to be; the context is given back.
        unsafe {
            let status = checked(if is_wide {
                let conn = blocks.map(|(_, nodes, _)| Guarded::new(nodes));
                let block = |k: usize| fmc_facet_block_i64 {
                    facet_type: blocks[k].0,
                    conn: conn[k].ptr(),
                    facet_count: blocks[k].2,
                };
                fmc_context_new_from_facet_blocks_i64(
                    dim,
                    &coords.view,
                    [block(0), block(1)].as_ptr(),
                    2,
                    null(),
                    o,
                    to,
                )
            } else {
                let conn =
                    blocks.map(|(_, nodes, _)| Guarded::new(&nodes.iter().map(|&f| f as i32).collect::<Vec<_>>()));
                let block = |k: usize| fmc_facet_block {
                    facet_type: blocks[k].0,
                    conn: conn[k].ptr(),
                    facet_count: blocks[k].2,
                };
                fmc_context_new_from_facet_blocks(dim, &coords.view, [block(0), block(1)].as_ptr(), 2, null(), o, to)
            });
            assert_eq!(status == OK, !context.is_null());
            assert_eq!(fmc_context_free(to), OK);
        }
    }

    /// A context of its own, from facets of any kind on the nodes that are there.
    fn from_facets(&self, facets: &[u8], is_wide: bool) {
        let n = self.mesh.node_count() as i64 + 1;
        let facets: Vec<i64> = facets.iter().take(24).map(|f| i64::from(*f) % n).collect();
        let count = facets.len() / self.mesh.dim;
        let facets = &facets[..count * self.mesh.dim];
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (dim, mut context) = (self.mesh.dim as i32, null_mut());
        // SAFETY: arrays as long as they are said to be; the context is given back.
        unsafe {
            let status = checked(if is_wide {
                let facets = Guarded::new(facets);
                let ids = null();
                fmc_context_new_from_facets_i64(
                    dim,
                    &coords.view,
                    facets.ptr(),
                    count,
                    ids,
                    &raw const self.options,
                    &raw mut context,
                )
            } else {
                let facets = Guarded::new(&facets.iter().map(|&f| f as i32).collect::<Vec<_>>());
                let ids = null();
                fmc_context_new_from_facets(
                    dim,
                    &coords.view,
                    facets.ptr(),
                    count,
                    ids,
                    &raw const self.options,
                    &raw mut context,
                )
            });
            assert_eq!(status == OK, !context.is_null());
            assert_eq!(fmc_context_free(&raw mut context), OK);
        }
    }
}

fn no_result() -> fmc_result {
    fmc_result {
        struct_size: 77,
        volume: -1.0,
        volume_standard_error: -1.0,
        energy: -1.0,
        contact_area: -1.0,
        penetration: -1.0,
        fiber_count: 77,
        crossing_count: 77,
        facet_count: 77,
        pair_count: 77,
        body_count: 77,
        obstacle_count: 77,
        warning_count: 77,
        friction_energy: 77.0,
        friction_dissipation: 77.0,
        stick_area: 77.0,
        slip_area: 77.0,
        largest_slip: 77.0,
        reserved: [77; 3],
    }
}

fn suggest(dim: i32, [a, b, c]: [f64; 3]) {
    let check = |call: &dyn Fn(*mut f64) -> fmc_status| {
        let mut found = -1.0;
        let status = checked(call(&raw mut found));
        // A product of numbers in range may leave it.
        assert!(if status == OK { found > 0.0 || found == 0.0 || found.is_infinite() } else { found == -1.0 });
    };
    // SAFETY: the output may be written.
    unsafe {
        check(&|found| fmc_suggest_fiber_stiffness(a, b, found));
        check(&|found| fmc_suggest_stiffness_from_modulus(dim, a, b, c, found));
        check(&|found| fmc_suggest_stiffness_from_pressure(dim, a, b, c, found));
    }
}

fn texts(status: i32, feature: &[u8; 5]) {
    let end = feature.iter().position(|b| *b == 0).unwrap_or(5);
    let feature = CString::new(&feature[..end]).expect("no zero within");
    // SAFETY: texts that end in zero, theirs and ours.
    unsafe {
        assert!((0..=1).contains(&fmc_has_feature(feature.as_ptr())) && fmc_has_feature(null()) == 0);
        assert!(CStr::from_ptr(fmc_status_name(status)).to_bytes().starts_with(b"FMC_"));
        assert!(!CStr::from_ptr(fmc_version()).to_bytes().is_empty());
        assert!(fmc_abi_version() > 0);
        assert!(CStr::from_ptr(fmc_last_error()).to_str().is_ok());
    }
}

/// Numbers that a test of this file may want.
impl From<f64> for Number {
    fn from(x: f64) -> Self {
        Number(x)
    }
}
