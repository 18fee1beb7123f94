/*
 * Contact forces and overlap volume for any finite element code.
 *
 *   fmc_cell_block cells = {FMC_QUAD4, sizeof conn[0], conn, cell_count};
 *   fmc_options options;
 *   fmc_options_init(&options);
 *   options.stiffness = 1e6;
 *   if (fmc_contact_force(2, coords, node_count, &cells, 1, NULL, &options, NULL, forces, &volume) != FMC_OK)
 *     fputs(fmc_last_error(), stderr);
 *
 * The life of a context in ten calls; each section of this header is headed by a line of dashes, in the order of use:
 *
 *    1. fmc_options_init             options; set at least `stiffness`
 *    2. fmc_context_new_from_cells   makes a context from a mesh
 *    3. fmc_context_add_obstacle     rigid shapes, as many as there are
 *    4. fmc_context_evaluate         forces at coordinates, in every iteration
 *    5. fmc_context_tangent_csr      their derivative, in the host's rows, after fmc_context_tangent
 *    6. fmc_context_begin_step       friction: a load step begins
 *    7. fmc_context_commit_step      and the host accepts it
 *    8. fmc_context_nodal_contact    outputs: pressure, gap, area, normal, friction at every node
 *    9. fmc_context_slip             state for a restart, with the coordinates; fmc_context_set_slip restores it
 *   10. fmc_context_free             the end
 *
 * Conventions. Every function that can fail returns a status, 0 for success. Outputs are written only on success, and an
 * error leaves the context unchanged. Arrays belong to the host and are not kept. Where a length is zero, its pointer is not
 * read. Lists of nodes, cells, bodies' ids and degrees of freedom, `void *`, have numbers of 4 or 8 bytes, as given by
 * `index_size` of the mesh's blocks. Nodes, cells, facets, degrees of freedom, rows and columns count from the option
 * `index_base`, 0 or 1, in input, output and messages. Bodies, obstacles, pairs and warnings count from 0. Forces push bodies
 * apart. The library never prints, exits or unwinds. Another thread must not change memory passed to a call while it runs.
 *
 * Generated from the Rust sources; do not edit.
 */

#ifndef FMC_CONTACT_H
#define FMC_CONTACT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---- Version ---------------------------------------------------------------------------------------------

// Version of the binary interface that this header describes. It grows when a struct or a function changes in a way
// that a compiled host would notice. A host that loads the library at run time compares it with `fmc_abi_version()`.
#define FMC_ABI_VERSION 3

// Version of the library, such as "0.1.0". The text is constant and never freed. Threads: any.
const char *fmc_version(void);

// Version of the binary interface of the library: `FMC_ABI_VERSION` of the header it was built with. Threads: any.
int32_t fmc_abi_version(void);

// 1 if this build of the library has a feature that a build can lack, else 0: "shapes" (convex hulls and compounds),
// "solver" (`fmc_condensation`). 0 for any other name and for NULL. Threads: any.
int32_t fmc_has_feature(const char *name);

// ---- Statuses, and the text of an error ------------------------------------------------------------------

// Result of a call. 0 is success. Every cause of failure has a separate code. `fmc_last_error` returns a text with the
// offending indices and values.
//
// An error leaves the outputs and the context unchanged. Codes are never reused.
typedef enum {
  // Success.
  FMC_OK = 0,
  // A pointer is NULL where the function needs one, or where a length is not zero.
  FMC_ERROR_NULL_POINTER = 1,
  // A pointer is not a multiple of its element's size.
  FMC_ERROR_MISALIGNED_POINTER = 2,
  // The length of an array does not match the mesh, or cannot be addressed.
  FMC_ERROR_LENGTH = 3,
  // The host's array is too short for the output.
  FMC_ERROR_BUFFER_TOO_SMALL = 4,
  // Strides for which entries of an output share memory, or that cannot be addressed.
  FMC_ERROR_STRIDE = 5,
  // A dimension other than 2 and 3, or a cell type of another dimension than the coordinates.
  FMC_ERROR_DIMENSION = 6,
  // Not a value of `fmc_cell_type`, or of `fmc_facet_type`.
  FMC_ERROR_UNKNOWN_CELL_TYPE = 7,
  // A cell or facet names a node that does not exist.
  FMC_ERROR_NODE_OUT_OF_RANGE = 8,
  // A coordinate is NaN or infinite.
  FMC_ERROR_NON_FINITE_COORDINATE = 9,
  // A cell or facet names one node twice.
  FMC_ERROR_REPEATED_NODE = 10,
  // A cell is inverted, or a facet of second order is folded.
  FMC_ERROR_INVERTED_CELL = 11,
  // A cell or facet has no length, area or volume.
  FMC_ERROR_ZERO_MEASURE = 12,
  // A surface given by facets is not closed.
  FMC_ERROR_OPEN_SURFACE = 13,
  // More than two facets meet at an edge (2D: at a node), or more than two cells at a face.
  FMC_ERROR_NON_MANIFOLD = 14,
  // Two neighbouring facets have opposite orientations.
  FMC_ERROR_INCONSISTENT_ORIENTATION = 15,
  // The facets of a body point inwards.
  FMC_ERROR_INVERTED_SURFACE = 16,
  // There are no cells and no facets.
  FMC_ERROR_EMPTY = 17,
  // A parameter is not positive and finite, or an exponent not at least 1.
  FMC_ERROR_NOT_POSITIVE = 18,
  // No option of this name.
  FMC_ERROR_UNKNOWN_OPTION = 19,
  // A struct was not initialised by its `_init` function, or comes from an unknown version of the header.
  FMC_ERROR_STRUCT_SIZE = 20,
  // A position or scale is not finite, a scale not positive, or a rotation not orthonormal with determinant +1.
  FMC_ERROR_BAD_POSE = 21,
  // No obstacle of this index.
  FMC_ERROR_OBSTACLE_OUT_OF_RANGE = 22,
  // No body, pair or warning of this index in the last evaluation, or no evaluation yet.
  FMC_ERROR_INDEX_OUT_OF_RANGE = 23,
  // The estimator, or this build of the library, does not support this.
  FMC_ERROR_UNSUPPORTED = 24,
  // A signed-distance callback failed, or left a value that is not finite.
  FMC_ERROR_SIGNED_DISTANCE = 25,
  // The spacing is too small for the bodies.
  FMC_ERROR_TOO_MANY_FIBERS = 26,
  // The threads could not be started, or more than 1024 were requested.
  FMC_ERROR_THREADS = 27,
  // The context is in use by another call: from another thread, or from a callback of this one.
  FMC_ERROR_BUSY = 28,
  // A volume, energy, force or entry of the tangent exceeds the range of a double.
  FMC_ERROR_OVERFLOW = 29,
  // A panic was caught: a defect of this library. The text gives the reason and the place.
  FMC_ERROR_PANIC = 30,
  // The points of a convex hull lie in one plane (2D: on one line), or their hull cannot be found to rounding.
  FMC_ERROR_DEGENERATE_HULL = 31,
  // A height field has fewer than two points along an axis.
  FMC_ERROR_TOO_FEW_HEIGHTS = 32,
  // A height is NaN or infinite.
  FMC_ERROR_NON_FINITE_HEIGHT = 33,
  // A compound has no parts.
  FMC_ERROR_EMPTY_COMPOUND = 34,
  // The mass of a node that feels contact is not positive.
  FMC_ERROR_NOT_POSITIVE_MASS = 35,
  // No body of this index.
  FMC_ERROR_BODY_OUT_OF_RANGE = 36,
  // The obstacle of this index was removed.
  FMC_ERROR_OBSTACLE_REMOVED = 37,
  // The facets of a pair lie in so many layers that `exact` would cut them into too many pieces.
  FMC_ERROR_TOO_MANY_PIECES = 38,
  // Lines along the boundary of a signed-distance obstacle would need more steps than are taken.
  FMC_ERROR_UNFINISHED_LINES = 39,
  // Friction is on, but no step has begun: call `fmc_context_begin_step`.
  FMC_ERROR_NO_STEP = 40,
  // An elastic slip is NaN or infinite.
  FMC_ERROR_NON_FINITE_SLIP = 41,
  // A node lies beyond the axis, with axisymmetry: its first coordinate is negative.
  FMC_ERROR_NEGATIVE_RADIUS = 42,
  // Two cells, or two facets of a surface, do not conform: an edge or a face is divided, or has a node in its middle, in
  // only one of them.
  FMC_ERROR_NON_CONFORMING = 43,
  // The stiffness of bodies and contact together is singular to rounding: a body is not held.
  FMC_ERROR_SINGULAR_STIFFNESS = 44,
  // The stiffness of bodies and contact together is not positive definite.
  FMC_ERROR_INDEFINITE_STIFFNESS = 45,
  // A list of degrees of freedom names one that does not exist.
  FMC_ERROR_DOF_OUT_OF_RANGE = 46,
  // A list of degrees of freedom does not ascend, or names one that another list has.
  FMC_ERROR_REPEATED_DOF = 47,
  // A stiffness or a residual that was given is NaN or infinite.
  FMC_ERROR_NON_FINITE_STIFFNESS = 48,
  // A host's function that places its nodes failed.
  FMC_ERROR_PLACE = 49,
  // The rank of a communicator is not from 0 to one less than its size.
  FMC_ERROR_BAD_RANK = 50,
  // A communicator's function failed.
  FMC_ERROR_COMMUNICATION = 51,
  // The evaluation failed on another rank, which has the cause.
  FMC_ERROR_ON_OTHER_RANK = 52,
  // Ranks that share the work of a context were given different coordinates, options or obstacles, or made different calls.
  FMC_ERROR_RANKS_DIFFER = 53,
  // Coordinates at which a part of a mesh that was not gathered may be in contact.
  FMC_ERROR_NOT_GATHERED = 54,
  // The stiffness of bodies is not positive definite: they are unsupported, or buckle.
  FMC_ERROR_NOT_POSITIVE_DEFINITE = 55,
  // A matrix that has to be symmetric is not.
  FMC_ERROR_UNSYMMETRIC = 56,
  // There are no factors of a matrix: none was given, or the last one could not be factorised.
  FMC_ERROR_NOT_FACTORISED = 57,
  // An `index_size` other than 4 and 8, or two of one call that differ.
  FMC_ERROR_INDEX_SIZE = 58,
  // An option, a kind or a switch has no such value.
  FMC_ERROR_BAD_VALUE = 59,
  // A bit of `flags` that the function does not have.
  FMC_ERROR_UNKNOWN_FLAG = 60,
  // Two options exclude one another, or one would have no effect in combination with the rest.
  FMC_ERROR_OPTIONS_CONFLICT = 61,
  // A reserved field is not zero: an option of a later version of the library.
  FMC_ERROR_RESERVED_FIELD = 62,
  // The contact has no stiffness: option `stiffness` is 0, and none was found from the bodies' matrix.
  FMC_ERROR_NO_STIFFNESS = 63,
  // The call was ended by the host (`fmc_context_set_interrupt`).
  FMC_ERROR_INTERRUPTED = 64,
  // Memory for large arrays could not be allocated. If memory runs out for small ones, or the system has overcommitted it, the
  // process ends.
  FMC_ERROR_MEMORY = 65,
  // Two tied bodies face one another nowhere within reach.
  FMC_ERROR_UNTIED = 66,
  // The law of the host on an interface or of friction failed, or wrote a number that is not finite; or its derivative is
  // wrong (`fmc_own_law_check`, `fmc_friction_law_check`).
  FMC_ERROR_INTERFACE_LAW = 67,
} fmc_status;

// Class of a status: how a host reacts to it.
typedef enum {
  // Success.
  FMC_CLASS_OK = 0,
  // An argument, an option or an array is wrong: correct the call. A retry does not help.
  FMC_CLASS_INPUT = 1,
  // The mesh or a shape is invalid, or became invalid as it deformed: correct it, or take a shorter step.
  FMC_CLASS_GEOMETRY = 2,
  // The solution diverged, or a matrix cannot be factorised: take a shorter step, or support the bodies.
  FMC_CLASS_NUMERICAL = 3,
  // More threads, lines, pieces or steps than possible: reduce the request.
  FMC_CLASS_RESOURCE = 4,
  // Calls in the wrong order, or ranks that do not match.
  FMC_CLASS_PROTOCOL = 5,
  // A defect of this library.
  FMC_CLASS_INTERNAL = 6,
} fmc_status_class_value;

// Name of a status, such as "FMC_ERROR_NULL_POINTER"; "FMC_UNKNOWN_STATUS" for any other number.
//
// The text is constant and never freed. Threads: any.
const char *fmc_status_name(int32_t status);

// Class of a status, a value of `fmc_status_class_value`; `FMC_CLASS_INTERNAL` for a number that is not a status. A host
// that branches on classes tolerates statuses of later versions of the library. Threads: any.
int32_t fmc_status_class(int32_t status);

// Text of the last call that failed on this thread, "" if none did; never NULL. It names the offending indices.
//
// The text is valid until the next call fails on this thread; successful calls do not change it. Threads: each has its
// own.
const char *fmc_last_error(void);

// ---- Options ---------------------------------------------------------------------------------------------

// Contact energy.
typedef enum {
  // w = k V^m for every overlapping pair; k is `stiffness`, m is `exponent`. Key value "volume".
  FMC_LAW_VOLUME = 0,
  // w = sum of psi(L) over lines along the mean normal of the contact, L being the penetration on each. Without
  // `smoothing_length`, psi = k L^2 / 2, the pressure is k L, and k, the `stiffness`, is a pressure per length. With
  // a smoothing length s, psi = k (sqrt(L^2 + s^2) - s), and k is a pressure as for "volume" with exponent 1. Key
  // value "fiber".
  FMC_LAW_FIBER = 1,
  // w = k/2 times the integral of g_A + g_B over the overlap, where g_A and g_B are the depths of both bodies'
  // material below their surfaces. Against an obstacle w is k times the integral of the depth below its surface.
  // Flat faces press with k times their penetration, as with "fiber", and k is a pressure per length. There are no
  // directions and no patches, and the energy is continuous for any motion of corners, edges and whole bodies.
  // Bodies need cells. It is measured without lines under every estimator. Key value "depth".
  FMC_LAW_DEPTH = 2,
} fmc_law;

// How the overlap is measured.
typedef enum {
  // Sampled by fibers: any shape and any obstacle, with a standard error. Key value "fibers".
  FMC_ESTIMATOR_FIBERS = 0,
  // Exact for straight-sided meshes and flat-sided obstacles. Key value "exact".
  FMC_ESTIMATOR_EXACT = 1,
  // Pair by pair: exact between bodies and with obstacles bounded by planes, sampled by lines with curved ones. Key
  // value "auto".
  FMC_ESTIMATOR_AUTO = 2,
} fmc_estimator;

// How fibers are laid.
typedef enum {
  // Families of parallel lines. Key value "lines".
  FMC_PATTERN_LINES = 0,
  // Short segments of random place and direction, as published (doi:10.1016/j.cma.2025.118645); the variance of the
  // force is infinite. Key value "isotropic".
  FMC_PATTERN_ISOTROPIC = 1,
} fmc_pattern;

// How line families are combined.
typedef enum {
  // Least noise, but the force is not the gradient of an energy. Key value "balance".
  FMC_WEIGHTS_BALANCE = 0,
  // The force is the exact gradient of the estimated energy. Key value "consistent".
  FMC_WEIGHTS_CONSISTENT = 1,
} fmc_weights;

// Options of an evaluation. `fmc_options_init` sets all of them.
//
// New options take the place of reserved fields; the size of the struct does not change, and compiled hosts keep
// working. Every option can also be set by the name of its field, through `fmc_options_set`.
typedef struct {
  // Set by `fmc_options_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // k > 0. 0, the default, with the laws "depth" and "fiber": `fmc_equilibrium_next` finds it from the bodies' matrix; until then no
  // evaluation is possible (`FMC_ERROR_NO_STIFFNESS`). For the laws "depth" and "fiber" a pressure per length (Pa/m): the pressure is k
  // times the penetration; see `fmc_suggest_stiffness`. For the law "volume" with `exponent` 1 it is a pressure (Pa) in 2D and 3D, and
  // must exceed the peak contact pressure; in general energy / (length^dim)^m.
  double stiffness;
  // m >= 1, for the law "volume" only. Default 1.
  double exponent;
  // Distance between neighbouring lines; 0, the default: chosen from the size of the facets in contact.
  double spacing;
  // Length of an isotropic fiber; 0, the default: the mean size of the facets in contact.
  double fiber_length;
  // Approximate number of fibers per pair; 0, the default: chosen from the facets in contact. Excludes `spacing`.
  uint64_t fiber_count;
  // Seed of the random shift of the pattern. Default 0. This, `spacing`, `fiber_length`, `fiber_count`, `pattern`
  // and `weights` are refused where they would have no effect, as with the estimator "exact", or with "auto" and the law
  // "depth".
  uint64_t seed;
  // A value of `fmc_law`. Default `FMC_LAW_DEPTH`.
  int32_t law;
  // A value of `fmc_estimator`. Default `FMC_ESTIMATOR_AUTO`.
  int32_t estimator;
  // A value of `fmc_pattern`. Default `FMC_PATTERN_LINES`.
  int32_t pattern;
  // A value of `fmc_weights`. Default `FMC_WEIGHTS_BALANCE`.
  int32_t weights;
  // 1, the default: momentum correction, the smallest change of the nodal forces that makes their sum and moment
  // vanish. 0: none.
  int32_t momentum_correction;
  // 1: self-contact, the overlap of each body with itself, is evaluated too. Default 0.
  int32_t self_contact;
  // 1, the default: the orientation of every cell is checked at every evaluation. 0: it is not.
  int32_t check_cells;
  // Number of threads, at least 1, the default. The result does not depend on it.
  int32_t threads;
  // First number of nodes, cells, facets, degrees of freedom, rows and columns, 0 or 1, in input, output and messages. Default 0.
  // Bodies, obstacles, pairs and warnings count from 0.
  int32_t index_base;
  // 1: axisymmetry, in 2D. Coordinates are (r, z) with r >= 0, and volumes, areas, energies and forces refer to
  // whole rings: integrals have the factor 2 pi r. Default 0. Not with isotropic fibers.
  int32_t axisymmetric;
  // Smoothing length of the law "fiber", over which the pressure grows to k; 0, the default: the quadratic law. Refused
  // with any other law.
  double smoothing_length;
  // Coefficient of Coulomb friction of all pairs without a separate one, at least 0. Infinite: facets under pressure never slide, unless
  // `shear_limit` lets them; not with `memoryless_slip`. Default 0: no friction. With it, steps are begun and committed, see
  // `fmc_context_begin_step`, and the tangent is unsymmetric. With the law "volume" not without `friction_stiffness` or
  // `memoryless_slip`.
  double friction_coefficient;
  // Tangential stiffness of the stick, a pressure per length; 0, the default: the stiffness of the law at a first touch.
  double friction_stiffness;
  // Shear traction that is transmitted without pressure wherever there is contact, at least 0, a pressure. Default 0.
  double cohesion;
  // Largest shear traction, a pressure; 0, the default: no limit.
  double shear_limit;
  // Slip of a step from which on friction without memory acts in full: a speed times the time step, say. This law is smooth
  // and has no history, so that sticking facets creep. 0, the default: friction with memory. Not together with
  // `friction_stiffness`.
  double memoryless_slip;
  // Static coefficient of friction, at least `friction_coefficient`, to which it falls over `weakening_slip`; 0, the default: one
  // coefficient. A facet that sticks throughout a step rests. Not together with `memoryless_slip`.
  double static_coefficient;
  // Slip over which the coefficient falls linearly from the static to the kinetic one, a length; positive with
  // `static_coefficient`, else 0, the default.
  double weakening_slip;
  // Distance within which contact treats nodes of one body as one node, at least 0, a length, for meshes whose nodes were not merged. It
  // is read by `fmc_context_new_from_cells` and `fmc_contact_force` and cannot be changed later. A welded node lies in the mean of its
  // nodes, and each of them has an equal part of its force. Smaller than every edge. Without `body_ids` parts that are welded become one
  // body. 0, the default: no nodes are welded. Refused for bodies given by facets, and for meshes in parts.
  double weld;
  // Zero. Room for options of later versions.
  uint64_t reserved[7];
} fmc_options;

// Sets all options to their defaults. Afterwards set `stiffness`, unless a search finds it.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_options_init(fmc_options *options);

// Sets one option by the name of its field, both as text: ("stiffness", "2.5e6"), ("estimator", "exact"),
// ("momentum_correction", "0"). Blanks around them are ignored, and numbers may be written as in Fortran, "2.5d6".
//
// Errors: `FMC_ERROR_UNKNOWN_OPTION` for an unknown key, `FMC_ERROR_BAD_VALUE` for an unknown value; ranges are checked
// where the options are used.
// Threads: any, on different structs.
fmc_status fmc_options_set(fmc_options *options, const char *key, const char *value);

// Suggests an initial stiffness k, from Young's modulus E of the softer body (Pa) and the size h of its cells in
// contact (length). `law` is a value of `fmc_law`.
//
// For the laws "depth" and "fiber" k = 10 E / h, a pressure per length: a penetration of a tenth of a cell presses with E.
// `dim` and `exponent` have no effect. For the law "volume" with the exponent m an overlap a tenth of a cell deep over a
// patch one cell wide presses with E: k = E / (m V^(m - 1)), V = h^dim / 10. Its unit is Pa / (length^dim)^(m - 1); for m = 1
// it is E.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for an unknown law, `FMC_ERROR_DIMENSION`,
// `FMC_ERROR_NOT_POSITIVE`. Threads: any.
fmc_status fmc_suggest_stiffness(int32_t law,
                                 int32_t dim,
                                 double exponent,
                                 double modulus,
                                 double cell_size,
                                 double *stiffness);

// ---- Arrays of the host, and its mesh --------------------------------------------------------------------

// Type of a cell. Numbers and node order are as in VTK, except for `FMC_WEDGE6`. Cells of the mirrored order are accepted
// too: the outward side follows from the volume of the body.
typedef enum {
  // Triangle, 2D, 3 nodes.
  FMC_TRI3 = 5,
  // Quadrilateral, 2D, 4 nodes in order around it.
  FMC_QUAD4 = 9,
  // Tetrahedron, 3D, 4 nodes.
  FMC_TET4 = 10,
  // Hexahedron, 3D, 8 nodes: four around the bottom, then the four above them.
  FMC_HEX8 = 12,
  // Wedge, 3D, 6 nodes: three around the bottom, then the three above them, (x1 - x0) x (x2 - x0) . (x3 - x0) > 0: the
  // order of Gmsh, meshio and Abaqus. In VTK's definition the triangles run the other way round; the mirrored order.
  FMC_WEDGE6 = 13,
  // Pyramid, 3D, 5 nodes: four around the base, then the apex.
  FMC_PYRAMID5 = 14,
  // Triangle of second order, 2D, 6 nodes: the corners, then the middles of the edges 01, 12, 20.
  FMC_TRI6 = 22,
  // Quadrilateral of second order, 2D, 8 nodes: the corners, then the middles of the edges 01, 12, 23, 30.
  FMC_QUAD8 = 23,
  // Tetrahedron of second order, 3D, 10 nodes: the corners, then the middles of 01, 12, 20, 03, 13, 23. (Gmsh has the last two
  // the other way round.)
  FMC_TET10 = 24,
  // Hexahedron of second order, 3D, 20 nodes: the corners, then the middles of 01, 12, 23, 30, 45, 56, 67, 74, 04, 15, 26, 37.
  FMC_HEX20 = 25,
  // Wedge of second order, 3D, 15 nodes: the corners as in `FMC_WEDGE6`, then the middles of 01, 12, 20, 34, 45, 53, 03, 14,
  // 25.
  FMC_WEDGE15 = 26,
  // Pyramid of second order, 3D, 13 nodes: the corners, then the middles of 01, 12, 23, 30, 04, 14, 24, 34.
  FMC_PYRAMID13 = 27,
  // `FMC_QUAD8` with a ninth node in the middle of the cell.
  FMC_QUAD9 = 28,
  // `FMC_HEX20` with nodes in the middles of the faces 0473, 1265, 0154, 3762, 0321, 4567 and of the cell: 27.
  FMC_HEX27 = 29,
} fmc_cell_type;

// Coordinates of nodes, read during the call and not kept: component `axis` of node `node` is
// `data[node * node_stride + axis * axis_stride]`, for `node < node_count` and `axis < dim`.
//
// | the host's array | node_stride | axis_stride |
// | --- | --- | --- |
// | (n, dim), rows | dim, or both strides 0 | 1 |
// | (n, 3), rows, in 2D | 3 | 1 |
// | (dim, n), rows; (n, dim) by columns | 1 | n |
//
// Strides count doubles and may be negative. `{coords, n, 0, 0}`, or `{coords, n}` in C, are dense rows.
typedef struct {
  // First component of the first node.
  const double *data;
  // Number of nodes; if 0, `data` may be NULL.
  size_t node_count;
  // From one node to the next.
  ptrdiff_t node_stride;
  // From one axis to the next.
  ptrdiff_t axis_stride;
} fmc_coords;

// Array that receives nodal forces; laid out as `fmc_coords`. Padding between the entries is not written.
typedef struct {
  // First component of the first node.
  double *data;
  // Number of nodes that fit into it, at least as many as the mesh has; if 0, `data` may be NULL.
  size_t node_count;
  // From one node to the next.
  ptrdiff_t node_stride;
  // From one axis to the next.
  ptrdiff_t axis_stride;
} fmc_forces;

// Cells of one type; a mixed mesh has a block for each.
//
// A cell may name nodes repeatedly, for example a hexahedron with an edge or a face collapsed to a point. It then is the
// wedge, pyramid, tetrahedron or triangle that its faces form, also of second order. Cells and faces count as given.
typedef struct {
  // A value of `fmc_cell_type`.
  int32_t cell_type;
  // Bytes of a node number, 4 or 8, the same in all blocks. All lists of nodes, cells, bodies' ids and degrees of freedom that go
  // into the context or come out of it have this width.
  int32_t index_size;
  // Node numbers, (cell_count, nodes per cell), counted from the option `index_base`.
  const void *conn;
  // Number of cells; if 0, `conn` may be NULL.
  size_t cell_count;
} fmc_cell_block;

// ---- Create a context ------------------------------------------------------------------------------------

// Level of a warning: the result is valid, but the user should read the message.
#define FMC_LOG_WARNING 1

// Type of a facet of a surface. Numbers and node order are as in VTK. An edge has the body on its left; the corners of a
// triangle or quadrilateral run counter-clockwise seen from outside.
typedef enum {
  // Edge, 2D, 2 nodes.
  FMC_FACET_LINE2 = 3,
  // Triangle, 3D, 3 nodes.
  FMC_FACET_TRI3 = 5,
  // Quadrilateral, 3D, 4 nodes: four triangles about its middle, as a face of `FMC_HEX8`.
  FMC_FACET_QUAD4 = 9,
  // Edge of second order, 2D, 3 nodes: its ends, then its middle.
  FMC_FACET_LINE3 = 21,
  // Triangle of second order, 3D, 6 nodes: the corners, then the middles of the edges 01, 12, 20.
  FMC_FACET_TRI6 = 22,
  // Quadrilateral of second order, 3D, 8 nodes: the corners, then the middles of 01, 12, 23, 30. A face of `FMC_HEX20`.
  FMC_FACET_QUAD8 = 23,
  // `FMC_FACET_QUAD8` with a ninth node in its middle. A face of `FMC_HEX27`.
  FMC_FACET_QUAD9 = 28,
} fmc_facet_type;

// Facets, search trees and obstacles of a mesh in contact, and the results of the last evaluation. Opaque.
//
// Contexts share nothing, so different threads may use different contexts at once. Threads may use one context one
// after another. Concurrent calls on it, from two threads or from inside a callback, return `FMC_ERROR_BUSY`.
typedef struct fmc_context fmc_context;

// Receives messages: a level, and a sentence that is valid during the call. `user` is the pointer given with it.
//
// It is called at the end of an evaluation, on its thread, and may call the getters. It must not free the context,
// throw, or jump out.
typedef void (*fmc_log_callback)(void *user, int32_t level, const char *text);

// Facets of one type; a mixed surface has a block for each.
typedef struct {
  // A value of `fmc_facet_type`.
  int32_t facet_type;
  // Bytes of a node number, 4 or 8, as in `fmc_cell_block`.
  int32_t index_size;
  // Node numbers, (facet_count, nodes per facet), counted from the option `index_base`.
  const void *conn;
  // Number of facets; if 0, `conn` may be NULL.
  size_t facet_count;
} fmc_facet_block;

// Returns whether to end the running call: 0 to go on. `user` is the pointer given with it.
//
// It is called on the thread that called the library. It must not call a function of the same context, throw, or jump out.
typedef int32_t (*fmc_interrupt_callback)(void *user);

// Sets the callback that receives messages; NULL, the default: none. The library never prints.
//
// The callback and `user` must outlive the context, or be replaced before they end. They are called on the thread that
// evaluates the context. Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_set_log(fmc_context *context, fmc_log_callback callback, void *user);

// Makes a context from the cells of a mesh, in one block for each type; the boundary facets are found from them.
//
// `dim` is 2 or 3. `coords` are the coordinates of all nodes of the host, used or not: forces are returned for all of them. Cells may
// be numbered in either orientation. `body_ids`, one for every cell counted over the blocks, of the same width as node numbers, say
// which body a cell belongs to; NULL: bodies are the connected components by faces. Everything is read during the call and not kept
// (topology is copied). `options`, with `stiffness` set, must have been initialised.
//
// `context` receives the new context, to be freed by `fmc_context_free`.
//
// Errors, all with the offending indices in `fmc_last_error`: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`,
// `FMC_ERROR_STRIDE`, `FMC_ERROR_DIMENSION`, `FMC_ERROR_UNKNOWN_CELL_TYPE`, `FMC_ERROR_INDEX_SIZE`, `FMC_ERROR_NODE_OUT_OF_RANGE`,
// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_REPEATED_NODE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`,
// `FMC_ERROR_NON_MANIFOLD`, `FMC_ERROR_EMPTY`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_OPTIONS_CONFLICT`,
// `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_THREADS`. Threads: any, also at once.
fmc_status fmc_context_new_from_cells(int32_t dim,
                                      const fmc_coords *coords,
                                      const fmc_cell_block *blocks,
                                      size_t block_count,
                                      const void *body_ids,
                                      const fmc_options *options,
                                      fmc_context **context);

// Makes a context from a surface: the boundary facets of closed bodies, of any types of `fmc_facet_type`, in one block for each type.
//
// An edge has its body on the left, other facets run counter-clockwise seen from outside. Facets of second order are measured like
// faces of cells of second order, and give the same forces. In 3D an edge with a mid-side node does not conform to a straight edge.
// `body_ids`, one for every facet counted over the blocks, of the same width as node numbers, may be NULL: bodies are the connected
// components by nodes. Otherwise as `fmc_context_new_from_cells`; also `FMC_ERROR_OPEN_SURFACE`,
// `FMC_ERROR_INCONSISTENT_ORIENTATION`, `FMC_ERROR_INVERTED_SURFACE`, `FMC_ERROR_NON_CONFORMING`, and `FMC_ERROR_INVERTED_CELL` for a
// facet of which a part faces the other way. A mid-side node too near to a corner causes this: nearer than an eighth of the edge,
// along the edge.
fmc_status fmc_context_new_from_facets(int32_t dim,
                                       const fmc_coords *coords,
                                       const fmc_facet_block *blocks,
                                       size_t block_count,
                                       const void *body_ids,
                                       const fmc_options *options,
                                       fmc_context **context);

// Replaces the options. They apply from the next evaluation on; results of the last one are kept.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_OPTIONS_CONFLICT`,
// `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_THREADS`, `FMC_ERROR_BUSY`. Threads: one call at a time on a
// context.
fmc_status fmc_context_set_options(fmc_context *context,
                                   const fmc_options *options);

// The options in force, as given at creation or to the last `fmc_context_set_options`. Their stiffness includes the
// factors of `fmc_context_stiffen`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
// changes it.
fmc_status fmc_context_options(const fmc_context *context, fmc_options *options);

// Number of nodes of the mesh, of its boundary facets, and of its bodies. A quadrilateral face in 3D counts as four facets;
// of second order an edge counts as two, a triangle as four, a quadrilateral as sixteen. Any of the outputs may be NULL.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
// changes it.
fmc_status fmc_context_counts(const fmc_context *context,
                              size_t *node_count,
                              size_t *facet_count,
                              size_t *body_count);

// Number of nodes that the option `weld` has removed: as many as merging would remove; 0 without it.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call
// changes it.
fmc_status fmc_context_welded_node_count(const fmc_context *context, size_t *count);

// Sets a callback that the library asks some twenty times a second, during a call, whether to end the call; NULL, the default:
// none.
//
// An interrupted call returns `FMC_ERROR_INTERRUPTED`; the context is unchanged, and remains usable. A search for an equilibrium then
// ends with a refusal. The library calls it while it measures pairs. It does not call it within a factorisation or the linear algebra of
// a contact step, nor while ranks share the work, since they would wait for one another.
//
// The callback and `user` must outlive the context, or be replaced before they end. Errors: `FMC_ERROR_NULL_POINTER`,
// `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_set_interrupt(fmc_context *context,
                                     fmc_interrupt_callback callback,
                                     void *user);

// ---- The mesh without deformation, and unknowns of the host ----------------------------------------------

// A sparse matrix of the host in compressed rows (CSR): row r has the entries from `row_offsets[r]` to `row_offsets[r + 1]`, in any
// order; entries at one place add up. Initialise it with `fmc_csr_init`, then set all fields.
typedef struct {
  // Set by `fmc_csr_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Number of rows.
  size_t row_count;
  // Bytes of an offset and of a column, 4 or 8.
  int32_t index_size;
  // First number of offsets, rows and columns, 0 or 1.
  int32_t index_base;
  // Where rows begin, and the last one ends: `row_count` + 1 numbers.
  const void *row_offsets;
  // Column of every entry.
  const void *cols;
  // Value of every entry.
  const double *values;
  // Zero. Room for later versions.
  uint64_t reserved[4];
} fmc_csr;

// Sets the coordinates of all nodes without deformation, from which the law "depth" measures its depths. By default
// they are the coordinates at which the context was created.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a surface without cells, `FMC_ERROR_LENGTH`,
// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`; the old coordinates are then kept.
// Threads: one call at a time on a context.
fmc_status fmc_context_set_reference(fmc_context *context,
                                     const fmc_coords *coords);

// Sets `count` planes of symmetry: `points` and `normals` are dense rows of `dim` numbers, a point in each plane and its normal, of any
// length. For the law "depth" a face without deformation in one of them is no surface, since the body continues behind it. The host
// holds the nodes of such faces in their plane. Replaces earlier planes and nodes of symmetry; `count` 0: there is no symmetry, and
// flush faces cause no warning. With a mesh in parts all ranks pass the same planes.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` for a normal without length, `FMC_ERROR_UNSUPPORTED` for a body
// that would have no surface left; earlier planes and nodes are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_symmetry_planes(fmc_context *context,
                                           const double *points,
                                           const double *normals,
                                           size_t count);

// Names `count` nodes, counted from the option `index_base`, that lie in planes of symmetry, instead of the planes of
// `fmc_context_set_symmetry_planes`. The planes are found from the faces whose nodes are all named: they are the fewest planes that hold
// all these nodes. A face of the contact surface in a corner between two planes does not count. In a slice one cell thick all nodes lie in
// the planes of the slice: name further planes by `fmc_context_set_symmetry_planes`. With cells of second order name the nodes in the
// middle of edges and faces, too.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NODE_OUT_OF_RANGE` naming the entry, `FMC_ERROR_UNSUPPORTED` for a body that would have no
// surface left, or for nodes of a curved surface; earlier planes and nodes are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_symmetry_nodes(fmc_context *context,
                                          const void *nodes,
                                          size_t count);

// Measures straight faces as the round surfaces that they represent: where they meet at less than `feature_angle` degrees, the surface
// between them is smooth. Its normal at a node follows from the faces around the node. For the law "depth" between two bodies; 0, the
// default: faces are flat. Curved faces of second order are measured as curved in any case, and straight ones of second order in the same
// body as flat. At a larger angle faces meet at an edge of the body: 30 is usual. A round body needs some 40 facets around it.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` for an angle that is negative, NaN, or at least 90,
// `FMC_ERROR_UNSUPPORTED` for a surface without cells and for a mesh in parts; the earlier angle is then kept. Threads: one call at a
// time on a context.
fmc_status fmc_context_set_surface_smoothing(fmc_context *context,
                                             double feature_angle);

// Names a part of the surface, so that options of a pair can refer to it (`surface_a`, `surface_b`).
//
// `facets` are `count` facets, each by its place in `fmc_context_boundary_facets` always from 0, in any order; of a quadrilateral face
// all four, of one of second order all its parts. They may belong to several bodies. `surface` becomes the number of the part: 1, 2,
// ... It does not depend on the reference coordinates.
//
// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BAD_VALUE` for a facet that does not exist, naming its entry; `FMC_ERROR_UNSUPPORTED`
// without facets and for a mesh in parts, `FMC_ERROR_BUSY`. The context is then unchanged. Threads: one call at a time on a context.
fmc_status fmc_context_add_surface(fmc_context *context,
                                   const size_t *facets,
                                   size_t count,
                                   int32_t *surface);

// Sets all fields to zero and NULL.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_csr_init(fmc_csr *matrix);

// Lets unknowns of the host move the nodes of the mesh: control points of splines, coefficients of hierarchical shape functions,
// nodes of another mesh. `weights` has a row for every node of the mesh, and a column for every unknown: node n lies at the sum of
// value times coordinates of the unknown, over the entries of its row. Rows and columns count from the `index_base` of `weights`,
// whatever the context's.
//
// From then on every `fmc_coords` and `fmc_forces` has `unknown_count` rows. Tangents, masses, and the columns of gap
// gradients and of `fmc_context_point_weights` refer to unknowns. The mesh and its coordinates without deformation stay,
// and so do the nodes of `fmc_context_nodal_contact` and `fmc_context_set_symmetry_nodes`. A kept pattern
// (`fmc_context_keep_pattern`) is released. `weights` NULL: the unknowns are again the positions of the nodes.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_INDEX_SIZE`,
// `FMC_ERROR_LENGTH` for another number of rows and for offsets that descend, `FMC_ERROR_INDEX_OUT_OF_RANGE` for an unknown that
// does not exist, `FMC_ERROR_OVERFLOW` for a weight that is not finite. The basis is then unchanged. Threads: one call at a time
// on a context.
fmc_status fmc_context_set_basis(fmc_context *context,
                                 const fmc_csr *weights,
                                 size_t unknown_count);

// ---- Obstacles -------------------------------------------------------------------------------------------

// Kinds of shapes, each with the measures that it has. The axis of revolution is the last one: y in 2D, z in 3D.
typedef enum {
  // All points whose last coordinate is at most 0; the outward normal is the last axis. No measures.
  FMC_SHAPE_HALF_SPACE = 0,
  // A ball (2D: a disc) about the origin: `radius`.
  FMC_SHAPE_BALL = 1,
  // A box about the origin: `half_extents`, halves of its sides.
  FMC_SHAPE_CUBOID = 2,
  // A cylinder (2D: a rectangle) about the last axis, centred: `radius`, `half_height`.
  FMC_SHAPE_CYLINDER = 3,
  // A cone (2D: an isosceles triangle) about the last axis, its apex at +half_height and its base at -half_height:
  // `radius` of the base, `half_height`.
  FMC_SHAPE_CONE = 4,
  // A capsule (2D: a stadium), all points within `radius` of the segment from -half_height to +half_height on the last
  // axis: `radius`, `half_height`.
  FMC_SHAPE_CAPSULE = 5,
  // A closed polygon (2D) or triangle mesh (3D): `points`, its corners, and `facets`, as numbers of corners. In 2D the
  // body lies left of an edge, in 3D a triangle runs counter-clockwise seen from outside.
  FMC_SHAPE_POLYTOPE = 6,
  // The convex hull of `points`; those inside have no effect. It becomes a polytope.
  FMC_SHAPE_CONVEX_HULL = 7,
  // The solid below a height field: `heights` over a grid with `counts` points along its axes and `lengths`, and
  // `thickness`. It becomes a polytope.
  FMC_SHAPE_HEIGHT_FIELD = 8,
  // The union of other shapes: `parts`, which may overlap.
  FMC_SHAPE_COMPOUND = 9,
  // A body given by a function: `signed_distance`.
  FMC_SHAPE_SIGNED_DISTANCE = 10,
} fmc_shape_kind;

// Position, rotation and scale of an obstacle: a point X of the shape is at position + scale rotation X.
//
// In 2D the first two entries of the position and the upper left two by two of the rotation are read.
typedef struct {
  // Position of the shape's origin.
  double position[3];
  // Rotation matrix, 3 by 3, row after row; orthonormal with determinant +1 to 1e-8.
  double rotation[9];
  // Uniform scale, positive.
  double scale;
} fmc_pose;

// Signed distance of a body in the obstacle's own frame, for `n` points at once.
//
// Read `x`, (n, dim) rows. Write `phi`, (n): negative inside, positive outside, with slope of at most 1. Write `grad`,
// (n, dim) rows: its gradient, of any length; where phi = 0 it gives the outward normal. An unwritten entry counts as
// not finite. `user` is the pointer of the same name in the shape.
//
// Return 0; any other value makes the evaluation fail with `FMC_ERROR_SIGNED_DISTANCE`, naming point i of the batch
// for the value i + 1. It is called on the thread that evaluates, never from two threads at once. It must not call a
// function of the same context (it would get `FMC_ERROR_BUSY`), throw, or jump out.
typedef int32_t (*fmc_signed_distance)(void *user, size_t n, const double *x, double *phi, double *grad);

// A rigid shape in its own frame, as data. `fmc_shape_init` sets all fields; then set the fields that `fmc_shape_kind`
// lists for its kind. Other fields are not read.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_shape_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // A value of `fmc_shape_kind`.
  int32_t kind;
  // Bytes of a number in `facets`: 4, the default, or 8.
  int32_t index_size;
  // Radius.
  double radius;
  // Half of the height.
  double half_height;
  // Halves of the sides, of which the first `dim` are read.
  double half_extents[3];
  // Points, or corners.
  fmc_coords points;
  // Numbers of corners, (facet_count, dim), of `index_size` bytes each, counted from the option `index_base`.
  const void *facets;
  // Number of facets.
  size_t facet_count;
  // Heights along the last axis, over a grid across it that is centred on the origin. The index along the grid's last
  // axis runs fastest. In 3D every cell is split along the diagonal from its corner of least x and y.
  const double *heights;
  // Numbers of points of the grid along its `dim` - 1 axes, at least 2 each; their product is the number of heights.
  size_t counts[2];
  // Lengths of the grid along its `dim` - 1 axes.
  double lengths[2];
  // How far below the lowest height the flat bottom of the solid lies; its walls are vertical.
  double thickness;
  // `fmc_part`s of a compound, of any kind, which may overlap. Its signed distance is the least signed distance of its
  // parts: exact outside, and inside a single part; where parts overlap, the depth of a point is its largest depth in any
  // part.
  const void *parts;
  // Number of parts.
  size_t part_count;
  // Signed distance of a body. It and `user` must outlive the context, or the obstacle if it is removed before.
  fmc_signed_distance signed_distance;
  // Passed to `signed_distance`.
  void *user;
  // Zero. Room for measures of later versions.
  uint64_t reserved[8];
} fmc_shape;

// A part of a compound.
typedef struct {
  // Its shape.
  const fmc_shape *shape;
  // Its pose in the frame of the compound.
  fmc_pose pose;
} fmc_part;

// Sets a pose to the origin, without rotation and with scale 1.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_pose_init(fmc_pose *pose);

// Sets a pose to `position`, with scale 1 and the shape's last axis (y in 2D, z in 3D) along `axis`.
//
// That is the outward normal of a half-space and the axis of cylinder, cone and capsule. `position` and `axis` have
// `dim` entries; `axis` need not have unit length.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_DIMENSION`, `FMC_ERROR_BAD_POSE` for an axis of length 0. Threads:
// any, on different structs.
fmc_status fmc_pose_along(int32_t dim, const double *position, const double *axis, fmc_pose *pose);

// Sets a shape to a kind, a value of `fmc_shape_kind`, with sizes and counts 0 and pointers NULL.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for another number. Threads: any, on different structs.
fmc_status fmc_shape_init(fmc_shape *shape, int32_t kind);

// Adds a rigid obstacle of any shape; everything but a signed distance is copied.
//
// Obstacles are in contact with the bodies of the mesh, not with one another. `pose` may be NULL for the origin;
// `fmc_pose_along` makes the pose of a half-space from a point and its outward normal. `obstacle`, which may be NULL
// too, receives the index: 0 for the first obstacle of the context, then 1, 2, ..., also after others were removed.
//
// Both estimators support shapes that have facets or become polytopes; half-spaces and boxes too. `fibers`, `auto`, and the
// law "depth" support all of them.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE` for a `kind` or an
// `index_size` that does not exist, `FMC_ERROR_BAD_POSE`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`. For a polytope as
// `fmc_context_new_from_facets`; for a convex hull `FMC_ERROR_DEGENERATE_HULL`, `FMC_ERROR_NON_FINITE_COORDINATE`; for a height
// field `FMC_ERROR_TOO_FEW_HEIGHTS`, `FMC_ERROR_NON_FINITE_HEIGHT`; for a compound `FMC_ERROR_EMPTY_COMPOUND` and the errors of
// its parts. `FMC_ERROR_UNSUPPORTED` for hulls and compounds if the library lacks the feature "shapes". Threads: one call at a
// time on a context.
fmc_status fmc_context_add_obstacle(fmc_context *context,
                                    const fmc_shape *shape,
                                    const fmc_pose *pose,
                                    size_t *obstacle);

// Kind of an obstacle's shape, a value of `fmc_shape_kind`, and its current pose. Either output may be NULL.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BUSY`.
// Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_obstacle_shape(const fmc_context *context, size_t obstacle, int32_t *kind, fmc_pose *pose);

// Moves an obstacle, and turns and scales it: the whole pose is set, so that a pose with only a position turns a ceiling
// into a floor. To move it only, fill the pose by `fmc_context_obstacle_shape` and change its position. Results of the
// last evaluation are kept.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`,
// `FMC_ERROR_BAD_POSE`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_set_pose(fmc_context *context,
                                size_t obstacle,
                                const fmc_pose *pose);

// Removes an obstacle, and the options of its pairs. All other obstacles keep their indices, and the index of the
// removed one is never reused. It stays in the counts, with a resultant of zero, and its row in the tangent is empty.
// Results of the last evaluation are kept. Afterwards the library does not use the callback and the `user` of a signed
// distance any more.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED` if it was removed
// before, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_remove_obstacle(fmc_context *context, size_t obstacle);

// ---- Options of single pairs -----------------------------------------------------------------------------

// Value of `law` in `fmc_pair_options`: the pair follows the law of the context's options, with its stiffness, also
// after they change.
#define FMC_PAIR_LAW_OF_CONTEXT -1

// Value of `friction_coefficient` in `fmc_pair_options`: the pair takes the coefficient of the context's options, also
// after it changes.
#define FMC_PAIR_FRICTION_OF_CONTEXT -1

// Interface between two bodies.
typedef enum {
  // They press and rub where they touch.
  FMC_INTERFACE_CONTACT = 0,
  // They are tied where their faces face one another without deformation, within `reach` and up to an angle of 60 degrees. They are in
  // no contact, neither there nor elsewhere. A gap or an overlap within reach is kept. Not with an obstacle, the law "volume", or a mesh
  // in parts. See `fmc_context_tie`. Key value "tied".
  FMC_INTERFACE_TIED = 1,
  // They are held together where tied bodies would be, by an interface that opens, slides and breaks. They are in no contact: the
  // interface carries compression without damage, also where it is broken, at the points that initially faced one another. See
  // `fmc_context_cohesive`. Key value "cohesive".
  FMC_INTERFACE_COHESIVE = 2,
  // They slide on one another without friction, and do not separate, where tied bodies would be held: the normal part of a tie, also in
  // compression. They are in no other contact. `fmc_context_begin_step`, `fmc_context_commit_step` and `fmc_context_augment` search
  // again for the points that face one another. The rules for ties apply. Key value "no_separation".
  FMC_INTERFACE_NO_SEPARATION = 3,
  // They press and open as in contact, and never slide where they touch: an infinite coefficient of friction. Key value "rough".
  FMC_INTERFACE_ROUGH = 4,
  // They are held together where a cohesive interface would hold them, by a law of the host, and are in no contact: the law has to
  // resist compression. Set by `fmc_context_set_law_pair`. Key value "law".
  FMC_INTERFACE_LAW = 5,
} fmc_interface;

// How the traction of a cohesive interface falls as it opens.
typedef enum {
  // Along a straight line. Key value "linear".
  FMC_SOFTENING_LINEAR = 0,
  // Exponentially: it never quite ends. Key value "exponential".
  FMC_SOFTENING_EXPONENTIAL = 1,
  // By the potential of Park, Paulino and Roesler, which also gives its rise, and mixes opening and sliding: without `stiffness`,
  // `mixed_mode_exponent` and `viscosity`. `fmc_context_set_ppr_pair` sets other shapes than the default ones. Key value "ppr".
  FMC_SOFTENING_PPR = 2,
} fmc_softening;

// Options of one pair of partners, in place of the context's. `fmc_pair_options_init` sets all of them to their
// defaults.
//
// New options take the place of reserved fields; the size of the struct does not change.
typedef struct {
  // Set by `fmc_pair_options_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // k > 0 of the law of this pair, in the units of `stiffness` in `fmc_options`; only with `law`, and then without a default. With
  // `FMC_INTERFACE_COHESIVE`, and without `law`: traction / opening without damage, and in compression. 0: damage begins at a hundredth
  // of the opening at which a linear softening ends.
  double stiffness;
  // m >= 1, for the law "volume" only. Default 1.
  double exponent;
  // Smoothing length of the law "fiber"; 0, the default: the quadratic law.
  double smoothing_length;
  // Distance at which contact begins, in length; 0, the default: at the surfaces. Penetration, gap and pressure are
  // counted from there, also in weighted gaps. With an obstacle: its surface lies so much further out (a shell's
  // thickness, a coating), or, if negative, further in (a clearance). Half-spaces, balls and capsules keep their kind,
  // and so do cylinders with a negative offset. Any other shape becomes its signed distance minus the offset, with its
  // outward edges rounded, and is treated as `FMC_SHAPE_SIGNED_DISTANCE`. Between bodies, and of one with itself, only
  // with the law "depth" and not positive: -c allows either body to penetrate by c before it presses.
  double gap_offset;
  // Coefficient of friction, at least 0 or infinite, or `FMC_PAIR_FRICTION_OF_CONTEXT`, the default; with
  // `FMC_INTERFACE_COHESIVE` the coefficient of the broken part. All other options of friction are taken from the
  // context.
  double friction_coefficient;
  // A value of `fmc_law`, or `FMC_PAIR_LAW_OF_CONTEXT`, the default.
  int32_t law;
  // 1: the pair is excluded; it is not measured, and adds nothing to any result. With `surface_a` and `surface_b` these parts are held,
  // and no other face of the pair is in contact. Default 0.
  int32_t excluded;
  // Static coefficient of friction, at least the kinetic one; 0, the default: as in the context's options, or none where
  // `friction_coefficient` is set.
  double static_coefficient;
  // Slip over which it falls to the kinetic coefficient, a length; positive with `static_coefficient`, else 0, the
  // default.
  double weakening_slip;
  // Interface between two bodies, a value of `fmc_interface`. Default `FMC_INTERFACE_CONTACT`.
  int32_t interface_kind;
  // A value of `fmc_softening`, with `FMC_INTERFACE_COHESIVE`. Default `FMC_SOFTENING_LINEAR`.
  int32_t softening;
  // Largest distance or overlap of faces that are held together, a length, with `FMC_INTERFACE_TIED`,
  // `FMC_INTERFACE_COHESIVE` and `FMC_INTERFACE_NO_SEPARATION`. 0, the default: a tenth of the mean facet of the body with
  // the larger facets, including all its faces.
  double reach;
  // With `FMC_INTERFACE_COHESIVE`: traction at which damage begins in pure opening, positive.
  double normal_strength;
  // The same in pure sliding; 0, the default: as in opening.
  double shear_strength;
  // Energy per area that pure opening takes until the interface is broken, positive.
  double normal_energy;
  // The same in pure sliding; 0, the default: as in opening.
  double shear_energy;
  // Exponent, at least 1, by which the two are mixed (Benzeggagh and Kenane); 0, the default: 2.
  double mixed_mode_exponent;
  // With `FMC_INTERFACE_TIED`, `FMC_INTERFACE_COHESIVE` and `FMC_INTERFACE_NO_SEPARATION`: the part of the surface of `a`, a number of
  // `fmc_context_add_surface`, whose faces may be held; 0, the default: all of it. Held facets of both parts are in no contact; all
  // other facets of the pair press and rub, by the law "depth". Without parts no other facet of the pair is in contact.
  int32_t surface_a;
  // The same of `b`. Both are 0, or neither.
  int32_t surface_b;
  // With `FMC_INTERFACE_COHESIVE`: a time by which damage lags behind the law, so that searches pass where a structure snaps; 0, the
  // default: none. `fmc_context_set_time_step` sets the duration of a step.
  double viscosity;
  // Zero. Room for options of later versions.
  uint64_t reserved[3];
} fmc_pair_options;

// Friction of a pair that has its coefficient along a direction only, as a surface with machining marks, a grain or fibres.
// `fmc_orthotropic_friction_init` sets all of it.
//
// With the coefficient of friction m1 of the pair, tractions (t1, t2) along the direction and across it lie in the ellipse
// sqrt((t1/m1)^2 + (t2/m2)^2) <= p. The slip maximises the dissipation: it is normal to the ellipse, mostly not along the traction.
// With a `static_coefficient` both limits are larger by the same factor.
typedef struct {
  // Set by `fmc_orthotropic_friction_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Coefficient m2 across the direction, at least 0 and finite. Default 0.
  double transverse_coefficient;
  // The direction, of any length but 0 and of either sign: on a body without deformation, on an obstacle in its frame. It is projected
  // into the plane of each facet there, and moves along as the facet deforms and turns. A facet to which it is perpendicular, up to 0.06
  // degrees, has the transverse coefficient for all slip, and `FMC_WARNING_NO_FRICTION_DIRECTION` reports it. Default 0: none.
  double direction[3];
  // The partner to which the direction belongs, in the order of the call: 0, the default, to `a`; 1 to `b`.
  int32_t direction_of;
  // Zero.
  int32_t unused;
  // Zero. Room for options of later versions.
  uint64_t reserved[4];
} fmc_orthotropic_friction;

// Shapes and initial slopes of the law of Park, Paulino and Roesler (J. Mech. Phys. Solids 57, 2009), of a cohesive interface with
// `FMC_SOFTENING_PPR`. `fmc_ppr_init` sets all of it.
typedef struct {
  // Set by `fmc_ppr_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Shape alpha of softening in opening, above 1: below 2 the traction falls late, about 2 along a line, above it early with a long
  // tail. Default 2.
  double normal_shape;
  // Shape beta of sliding. Default 2.
  double shear_shape;
  // Opening at the strength / opening at which the traction ends, above 0 and at most 1/sqrt(2 alpha - 1). Default 0.05.
  double normal_slope;
  // The same in sliding, with beta. Default 0.05.
  double shear_slope;
  // Zero. Room for options of later versions.
  uint64_t reserved[4];
} fmc_ppr;

// The points of a pair at which the library calls a law of the host. All numbers of a point follow one another. The host must not write to
// it, or read it after the call.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // How many points there are, at least 1.
  size_t count;
  // Dimension, 2 or 3.
  size_t dim;
  // Numbers of the history of a point.
  size_t history_count;
  // The bodies, indices for `fmc_context_body_resultant`, the lower one first; 0 and 1 in `fmc_own_law_check`.
  size_t body;
  // See `body`.
  size_t partner;
  // Duration of the step (`fmc_context_set_time_step`); 0: not set.
  double time_step;
  // Lengths, (count, dim). First the opening beyond the initial gap, along the normal of `partner`, negative in compression; then the
  // slip of `body` along the axes in the plane of the facet of `partner`.
  const double *jump;
  // Normal of `partner` and tangential axes, by rows, (count, dim, dim), orthonormal. In 2D the axis is the normal turned by +90
  // degrees. In 3D the first is the x axis projected into the undeformed facet (the z axis, where the normal is within 0.1 degrees of
  // x), which moves along with the facet. The second is normal x first.
  const double *axes;
  // Where the points are on `body`, (count, dim).
  const double *position;
  // The same without deformation.
  const double *reference;
  // Tributary areas of the points, without deformation, (count).
  const double *area;
  // (count, history_count), as last accepted (`fmc_context_commit_step`); 0 at first.
  const double *history;
  // Number of fields (`fmc_context_set_law_fields`).
  size_t field_count;
  // Fields at the point of `body`, then at the point of `partner`, (count, 2, field_count).
  const double *fields;
  // Zero.
  uint64_t reserved[4];
} fmc_law_points;

// Output of a law of the host.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Force per area without deformation along the axes, (count, dim): positive where it resists a positive jump. An unwritten
  // entry counts as not finite.
  double *traction;
  // Its derivative by the jump, with history and time step held, (count, dim, dim), row by row: entry (i, j) is the derivative of
  // traction i by jump j. It need not be symmetric. An unwritten entry counts as not finite.
  double *tangent;
  // The history as it would be after a step that ends here, (count, history_count). It is preset to the history at
  // the start of the step.
  double *history;
  // Energy per area that unloading would give back, (count); 0 at first. Only reported energies depend on it.
  double *stored;
  // The same that has been dissipated since the beginning.
  double *dissipated;
  // Zero.
  uint64_t reserved[4];
} fmc_law_response;

// A law of the host: writes tractions, tangents and history at all points of a pair in `response`. `user` is the pointer given with it.
//
// Return 0; any other value makes the call of the library fail with `FMC_ERROR_INTERFACE_LAW`, naming point i of the pair for the value
// i + 1. It is called on the thread that evaluates, never from two threads at once. Pairs follow one another in ascending order, with the
// points in the order of `fmc_context_law_points`. Where ranks share the work, it is called on every rank with all points. The same input
// must have a bit-for-bit identical answer. It must not call a function of the same context (it would get `FMC_ERROR_BUSY`), throw, or
// jump out.
typedef int32_t (*fmc_respond)(void *user, const fmc_law_points *at, const fmc_law_response *response);

// A law of the host on an interface, for `FMC_INTERFACE_LAW`. `fmc_own_law_init` sets all of it.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_own_law_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Numbers that a point carries from step to step. Default 0.
  size_t history_count;
  // The law. It and `user` must outlive the context, or be replaced before by other options of the pair.
  fmc_respond respond;
  // Passed to `respond`.
  void *user;
  // Zero. Room for options of later versions.
  uint64_t reserved[4];
} fmc_own_law;

// The facets of a pair for which the library calls a law of friction of the host: all facets under pressure, of both sides. All numbers of
// a facet follow one another. The host must not write to it, or read it after the call.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // How many facets there are, at least 1.
  size_t count;
  // Dimension, 2 or 3.
  size_t dim;
  // Numbers of the history of a facet.
  size_t history_count;
  // The pair: index of a body, and index of its partner; 0 and 1 in `fmc_friction_law_check`.
  size_t body;
  // See `body`.
  size_t partner;
  // `fmc_partner`: the partner is a body, whose index is at least `body`, or an obstacle.
  int32_t partner_kind;
  // Zero.
  int32_t unused;
  // Duration of the step (`fmc_context_set_time_step`); 0: not set.
  double time_step;
  // Stiffness k_T of the stick, a pressure per length; 0: friction without memory.
  double stiffness;
  // Places of the facets in `fmc_context_boundary_facets`, from 0, (count).
  const size_t *facet;
  // Mean pressures over the area in contact, positive, (count).
  const double *pressure;
  // Lengths, (count, dim - 1): slip of `body` against `partner` since the step began, along the axes, including its elastic part.
  const double *slip;
  // Lengths, (count, dim - 1): trial elastic slip, as if no facet slid in the step. Where its length times `stiffness` exceeds the
  // limit, the facet slides by the rest.
  const double *trial;
  // Tangential unit axes, by rows, (count, dim - 1, dim). In 2D the normal, out of `body`, turned by +90 degrees. In 3D the first is the
  // x axis projected into the facet (the z axis, where the normal is within 6 degrees of x); the second is normal x first. They do not
  // turn along with the material.
  const double *axes;
  // Where the tractions act, (count, dim).
  const double *position;
  // Tributary areas of the facets, (count): where two bodies meet, each side has half of the area in contact.
  const double *area;
  // (count, history_count), as last accepted (`fmc_context_commit_step`); 0 at the first touch.
  const double *history;
  // Number of fields (`fmc_context_set_law_fields`).
  size_t field_count;
  // Means of the fields over the facet on `body`, then on `partner`, (count, 2, field_count); NaN on an obstacle.
  const double *fields;
  // Zero.
  uint64_t reserved[4];
} fmc_friction_facets;

// Output of a law of friction of the host.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Tractions at which the facets slide, force per area, at least 0, (count). An unwritten entry counts as not
  // finite.
  double *limit;
  // Their derivatives by the pressure, with slip, history and time step held, (count). An unwritten entry counts as not finite.
  double *by_pressure;
  // Their derivatives by the slip, with the trial slip changing by the same amount, (count, dim - 1). 0 at first.
  double *by_slip;
  // The history as it would be after a step that ends here, (count, history_count). It is preset to the history at
  // the start of the step.
  double *history;
  // Zero.
  uint64_t reserved[4];
} fmc_friction_response;

// A law of friction of the host: writes the limits of all facets of a pair in `response`. `user` is the pointer given with it.
//
// Return 0; any other value makes the call of the library fail with `FMC_ERROR_INTERFACE_LAW`, naming facet i of the call for the value
// i + 1. It is called on the thread that evaluates, never from two threads at once. Pairs follow one another in ascending order. Where ranks
// share the work, it is called on every rank with all facets. The same input must have a bit-for-bit identical answer. It must not call a
// function of the same context (it would get `FMC_ERROR_BUSY`), throw, or jump out.
typedef int32_t (*fmc_limit_friction)(void *user, const fmc_friction_facets *at, const fmc_friction_response *response);

// A law of friction of the host. `fmc_friction_law_init` sets all of it.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_friction_law_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Numbers that a facet carries from step to step for each partner that it faces. Default 0.
  size_t history_count;
  // The law. It and `user` must outlive the context, or be replaced before by other options of the pair.
  fmc_limit_friction limit;
  // Passed to `limit`.
  void *user;
  // Zero. Room for options of later versions.
  uint64_t reserved[4];
} fmc_friction_law;

// Sets the options of a pair to their defaults: the law of the context, not excluded.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_pair_options_init(fmc_pair_options *options);

// Sets the options of a pair: a body with another, with itself, or with an obstacle, in either order. They apply from the next evaluation
// on; `options` NULL: the pair follows the options of the context again, as every pair does at first. Friction of the pair is then the
// same in all directions; for another, call `fmc_context_set_orthotropic_pair` instead. The wear coefficients of the pair are kept; with
// NULL they are removed.
//
// `a_kind` and `b_kind` are values of `fmc_partner`; `a` and `b` count bodies as `fmc_context_body_resultant` and obstacles as
// `fmc_context_obstacle_resultant`. For a body with itself these options override the context's `self_contact`: `excluded`
// switches self-contact of this body off, and any other options switch it on.
//
// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE` and
// `FMC_ERROR_OBSTACLE_REMOVED`, naming the index; `FMC_ERROR_BAD_VALUE` for an unknown kind or value, `FMC_ERROR_OPTIONS_CONFLICT` for an
// option that would have no effect; `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_STRUCT_SIZE`; `FMC_ERROR_NOT_POSITIVE`. `FMC_ERROR_UNSUPPORTED`
// for two obstacles, for a law that the estimator of the context does not support, and for a gap offset between bodies that is positive or
// has another law than "depth". The same for a pair with wear coefficients (`fmc_context_set_pair_wear`) that cannot wear with these
// options. `FMC_ERROR_UNTIED` for tied bodies that face one another nowhere within reach, `FMC_ERROR_BUSY`. The earlier options are then
// kept. `fmc_context_set_options` refuses an estimator that does not support the law of a pair. Threads: one call at a time on a context.
fmc_status fmc_context_set_pair_options(fmc_context *context,
                                        int32_t a_kind,
                                        size_t a,
                                        int32_t b_kind,
                                        size_t b,
                                        const fmc_pair_options *options);

// The options of a pair, named as in `fmc_context_set_pair_options`. For a pair without separate options, these are the options in force:
// for a body with itself `excluded` is 1 unless the context's `self_contact` is on. `fmc_context_orthotropic_pair` returns another
// coefficient of friction across a direction.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`,
// `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two
// obstacles, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_pair_options(const fmc_context *context,
                                    int32_t a_kind,
                                    size_t a,
                                    int32_t b_kind,
                                    size_t b,
                                    fmc_pair_options *options);

// Sets isotropic friction, as `fmc_context_orthotropic_pair` returns it for a pair whose friction is the same in all
// directions.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_orthotropic_friction_init(fmc_orthotropic_friction *friction);

// Sets the options of a pair as `fmc_context_set_pair_options` does, with another coefficient of friction across a direction. In 3D, of
// two bodies or of a body and an obstacle. `fmc_context_set_pair_options` takes it back.
//
// Errors: as `fmc_context_set_pair_options`; `FMC_ERROR_NOT_POSITIVE` for a coefficient that is negative or not finite, for an entry of
// the direction that is not finite, which the text names, and for a direction of length 0. `FMC_ERROR_BAD_VALUE` for a `direction_of`
// other than 0 and 1. `FMC_ERROR_UNSUPPORTED` in 2D, for a body with itself, for a direction of a body without cells, and in a mesh in
// parts. The same with an infinite coefficient, a cohesion, a shear limit, or a `static_coefficient` without a `friction_coefficient`.
// The earlier options are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_orthotropic_pair(fmc_context *context,
                                            int32_t a_kind,
                                            size_t a,
                                            int32_t b_kind,
                                            size_t b,
                                            const fmc_pair_options *options,
                                            const fmc_orthotropic_friction *friction);

// The coefficient of friction of a pair across a direction, as `fmc_context_set_orthotropic_pair` has set it, with `direction_of` in the
// order of this call. Of a pair whose friction is the same in all directions the direction is 0.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`,
// `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two
// obstacles, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_orthotropic_pair(const fmc_context *context,
                                        int32_t a_kind,
                                        size_t a,
                                        int32_t b_kind,
                                        size_t b,
                                        fmc_orthotropic_friction *friction);

// Sets shapes and slopes to the defaults.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_ppr_init(fmc_ppr *ppr);

// Sets the options of a pair as `fmc_context_set_pair_options` does, whose interface is `FMC_INTERFACE_COHESIVE` and whose softening is
// `FMC_SOFTENING_PPR`, with other shapes and initial slopes than the default ones.
//
// Errors: as `fmc_context_set_pair_options`; `FMC_ERROR_NOT_POSITIVE` and `FMC_ERROR_UNSUPPORTED` for impossible shapes and slopes, which
// the text names; `FMC_ERROR_OPTIONS_CONFLICT` for another interface or softening. The earlier options are then kept. Threads: one call at
// a time on a context.
fmc_status fmc_context_set_ppr_pair(fmc_context *context,
                                    int32_t a_kind,
                                    size_t a,
                                    int32_t b_kind,
                                    size_t b,
                                    const fmc_pair_options *options,
                                    const fmc_ppr *ppr);

// Shapes and slopes of a pair with `FMC_SOFTENING_PPR`; of any other pair the default ones.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`,
// `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two
// obstacles, `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_ppr_pair(const fmc_context *context,
                                int32_t a_kind,
                                size_t a,
                                int32_t b_kind,
                                size_t b,
                                fmc_ppr *ppr);

// Sets a law without a function and without history.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_own_law_init(fmc_own_law *law);

// Checks a law without a context: whether the same input has the same answer, for each point alone and among other points. It also
// compares the tangents with differences of the tractions, to 1e-6 of the largest entry. Corners of a law, where damage begins, are
// recognised.
//
// `scale` is a jump over which the tractions change, such as the opening at which damage begins, a length; differences have steps of 1e-6
// of it. `jump` has `jump_count` jumps of `dim` numbers at which to check; NULL with 0: 60 that the library spreads over -scale/4 ...
// scale along the normal and -scale ... scale across it. The history is 0, and then the result of other jumps. `time_step` 0: not set.
//
// `tell` may be NULL; else it receives a sentence for each check, with level `FMC_LOG_WARNING` for a fault, else 0.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE` for a `history_count` above
// 1048576, `FMC_ERROR_DIMENSION`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NOT_POSITIVE`. `FMC_ERROR_INTERFACE_LAW` for a law that fails, returns a
// number that is not finite, or is wrong; the text lists all faults. Threads: any.
fmc_status fmc_own_law_check(const fmc_own_law *law,
                             size_t dim,
                             double scale,
                             const double *jump,
                             size_t jump_count,
                             double time_step,
                             fmc_log_callback tell,
                             void *user);

// Sets fields that laws of the host receive at their points, such as a temperature: `field_count` numbers for each of `row_count` rows
// of the coordinates, all of a row together, (row_count, field_count). They stay until others are set; `field_count` 0: none.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for another number of rows than coordinates have, `FMC_ERROR_NOT_POSITIVE` for a
// number that is not finite, `FMC_ERROR_BUSY`; the old fields are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_law_fields(fmc_context *context,
                                      const double *values,
                                      size_t row_count,
                                      size_t field_count);

// Sets the options of a pair as `fmc_context_set_pair_options` does, whose interface is `FMC_INTERFACE_LAW`, with the law. The history of
// its points begins with zeros. `fmc_context_set_pair_options` with the same interface keeps law and history.
//
// The tangent is symmetric only if the tangent of the law is. Unless the law has a potential, take the full tangent and an
// unsymmetric solver.
//
// Errors: as `fmc_context_set_pair_options`; the errors of `fmc_own_law_check` for an invalid struct; `FMC_ERROR_OPTIONS_CONFLICT` for
// another interface. The earlier options are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_law_pair(fmc_context *context,
                                    int32_t a_kind,
                                    size_t a,
                                    int32_t b_kind,
                                    size_t b,
                                    const fmc_pair_options *options,
                                    const fmc_own_law *law);

// Sets a law of friction without a function and without history.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_friction_law_init(fmc_friction_law *law);

// Checks a law of friction without a context: whether the same input has the same answer, for each facet alone and among other facets. It
// also compares the derivatives with differences of the limit, to 1e-6. Corners of a law are recognised.
//
// It calls the law at 60 pressures up to `pressure`, and slips of a step up to `slip`, a length, along every axis; differences have steps
// of 1e-6 of these. The history is 0, and then the result of other facets. `time_step` 0: not set. There are no fields.
//
// `tell` may be NULL; else it receives a sentence for each check, with level `FMC_LOG_WARNING` for a fault, else 0.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE` for a `history_count` above
// 1048576, `FMC_ERROR_DIMENSION`, `FMC_ERROR_NOT_POSITIVE`. `FMC_ERROR_INTERFACE_LAW` for a law that fails, returns an invalid limit, or
// is wrong; the text lists all faults. Threads: any.
fmc_status fmc_friction_law_check(const fmc_friction_law *law,
                                  size_t dim,
                                  double pressure,
                                  double slip,
                                  double time_step,
                                  fmc_log_callback tell,
                                  void *user);

// Sets the options of a pair (two bodies, a body and an obstacle, or a body with itself) as `fmc_context_set_pair_options` does, and its
// law of sliding, which replaces coefficient, cohesion and shear limit. The history of the law begins with zeros.
// `fmc_context_set_pair_options` removes the law. As with any friction the tangent is unsymmetric, and a step must have begun.
//
// Errors: as `fmc_context_set_pair_options`; the errors of `fmc_friction_law_check` for an invalid struct; `FMC_ERROR_UNSUPPORTED` with a
// coefficient of friction or a wear coefficient of the pair, with another interface than contact, and for a mesh in parts. The earlier
// options are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_friction_law_pair(fmc_context *context,
                                             int32_t a_kind,
                                             size_t a,
                                             int32_t b_kind,
                                             size_t b,
                                             const fmc_pair_options *options,
                                             const fmc_friction_law *law);

// ---- Evaluate: forces, totals and warnings ---------------------------------------------------------------

// Flag of `fmc_context_evaluate` and `fmc_context_evaluate_tangent`: add the forces to the host's array instead of
// overwriting it.
#define FMC_EVALUATE_ADD 1

// Kind of a partner.
typedef enum {
  // A body of the mesh.
  FMC_PARTNER_BODY = 0,
  // An obstacle.
  FMC_PARTNER_OBSTACLE = 1,
} fmc_partner;

// Kind of a warning.
typedef enum {
  // The fibers are further apart than the facets in contact are wide: nodal forces are noisy.
  FMC_WARNING_COARSE_FIBERS = 1,
  // Only a few fibers cross the overlap: it is thinner or smaller than their spacing.
  FMC_WARNING_UNRESOLVED_OVERLAP = 2,
  // One body lies inside the other and is not pushed out.
  FMC_WARNING_SWALLOWED_BODY = 3,
  // The law "fiber" neglects a patch of the contact next to a much shallower or larger one; the text gives its area,
  // penetration and normal. Two bodies in place of one that has both walls, or the law "volume", count it.
  FMC_WARNING_PATCH_LEFT_OUT = 4,
  // With the estimator "exact", forces or moments of a pair add up to zero with an error above rounding. Or, with the law "depth",
  // the error exceeds a tenth, since faces in contact were named as faces in planes of symmetry. The text gives the imbalance. Forces
  // may be wrong by as much.
  FMC_WARNING_UNBALANCED = 5,
  // With the law "depth", faces of two bodies lie in one plane, face the same way and reach into the overlap, as planes of
  // symmetry do. The host has not called `fmc_context_set_symmetry_nodes` (without nodes if there is no symmetry). The text
  // gives the area. Next to a plane of symmetry that is treated as surface the nodal forces are too low, by about the ratio
  // of penetration and cell size.
  FMC_WARNING_FLUSH_FACES = 6,
  // Faces of one body coincide and face each other, without deformation: nodes were not merged there, a flat cell was left out,
  // or there is a crack. The text gives the area and nodes, counted from `index_base`. The law "depth" treats such faces as
  // surface, and the pressure near them is too low.
  FMC_WARNING_COINCIDING_FACES = 7,
  // With the law "depth", a signed distance grows more slowly at its surface than a distance; the text gives the slopes.
  // Penetrations, and with them pressures, are too small by that factor.
  FMC_WARNING_GENTLE_DISTANCE = 8,
  // With the law "depth", the distance from facets in contact to the round surfaces that they represent exceeds the penetration; the
  // text gives both sizes. Where such surfaces conform, as a pin in its hole, pressures may be several times too large or too small.
  // Take a finer mesh, or `fmc_context_set_surface_smoothing`, which measures round faces of bodies whose facets meet at less than its
  // angle.
  FMC_WARNING_CURVED_FACES = 9,
  // With the law "depth", cells are so coarse that curved faces in contact, of second order or smoothed, may be wrong by more than
  // two fifths of the penetration. Pressures at single points may be wrong by as much. The text gives both sizes. Take a finer
  // mesh. The error falls with the fourth power of the cell size.
  FMC_WARNING_COARSE_FACES = 10,
  // `fmc_context_set_surface_smoothing` has no effect on a pair of bodies, since its law is not "depth": it is measured by straight
  // facets.
  FMC_WARNING_UNUSED_SMOOTHING = 11,
  // Some faces of tied bodies are farther apart than the reach, for example on coarse round bodies, and only part of them is tied; the
  // text gives areas and distances. A larger `reach` of the pair ties them.
  FMC_WARNING_TIED_IN_PART = 12,
  // Facets in contact are perpendicular to the direction of friction of the pair; the text gives one of them, counted from
  // `index_base`, and their part of the friction. The transverse coefficient holds there for all slip.
  FMC_WARNING_NO_FRICTION_DIRECTION = 13,
  // A step, with all of its cycles, would wear off more than the sides of a pair penetrate; the text gives the ratio. Pressures may
  // oscillate from step to step: take smaller steps, or fewer cycles (`fmc_context_set_wear_cycles`).
  FMC_WARNING_LARGE_WEAR = 14,
} fmc_warning;

// Results of an evaluation other than the forces. Units follow from the coordinates and the stiffness: with m and Pa,
// volumes are m^3 (2D: m^2), areas m^2 (m), energies J (J/m) and forces N (N/m).
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Volume (2D: area) of the overlap of both sides, summed over the pairs.
  double volume;
  // Standard error of the volume; 0 for `exact`.
  double volume_standard_error;
  // Contact energy, summed over the pairs.
  double energy;
  // Area of contact (2D: length), summed over the pairs; see `fmc_pair_result`.
  double contact_area;
  // Largest penetration of any pair; see `fmc_pair_result`.
  double penetration;
  // Fibers laid.
  size_t fiber_count;
  // Crossings that bound an overlap.
  size_t crossing_count;
  // Facets that bound an overlap.
  size_t facet_count;
  // Overlapping pairs, for `fmc_context_pair_result`.
  size_t pair_count;
  // Bodies, for `fmc_context_body_resultant`.
  size_t body_count;
  // Obstacles, for `fmc_context_obstacle_resultant`.
  size_t obstacle_count;
  // Warnings, for `fmc_context_warning`.
  size_t warning_count;
  // Energy stored in the stick of friction; 0 without friction, as the next four.
  double friction_energy;
  // Energy dissipated by friction since the step began, never negative.
  double friction_dissipation;
  // Area (2D: length) that sticks.
  double stick_area;
  // Area (2D: length) that slides.
  double slip_area;
  // Largest slip since the step began, without its elastic part.
  double largest_slip;
  // Zero.
  uint64_t reserved[3];
} fmc_result;

// Contact force and moment on one body or obstacle.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Id of the body as given, or its number among the connected components; index of the obstacle.
  int64_t id;
  // Sum of the forces; in 2D the last entry is 0.
  double force[3];
  // Moment of the forces about the origin of space; in 2D only the last entry differs from 0.
  double moment[3];
  // Nodes on the body's surface, with cells of second order points of its division; 0 for an obstacle.
  size_t node_count;
  // The part of `force` that is friction.
  double friction[3];
  // Zero.
  uint64_t reserved[4];
} fmc_resultant;

// One overlapping pair; no side is master or slave.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // First side: a value of `fmc_partner`.
  int32_t a_kind;
  // Second side: a value of `fmc_partner`.
  int32_t b_kind;
  // First side: index for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
  size_t a;
  // Second side; the same as the first for a body that overlaps itself.
  size_t b;
  // Volume (2D: area) of the overlap of both sides, each place once, with every law and estimator.
  double volume;
  // Standard error of the volume; 0 for `exact`.
  double volume_standard_error;
  // Energy.
  double energy;
  // Mean of the contact pressure over the contact. With the law "volume" it is dw/dV, one value for the whole pair;
  // with "fiber" the mean of psi'(L) over its lines. With "depth" it is k times the mean depth of either surface
  // below the other, over both.
  double pressure;
  // Area of contact (2D: length): half of the boundary of the overlap, including the strips of penetrating side
  // walls. The law "fiber" does not see strips along its lines; with "depth" and an obstacle it is the surface of
  // the body that is inside. Non-matching facets separate between their nodes in hard contact; the separated part is
  // not counted.
  double contact_area;
  // Penetration. With the law "fiber" it is the longest of its lines, with "depth" the largest depth of either
  // surface below the other. With "volume", which has no local depth, it is the extent of the overlap along its mean
  // normal. For flat faces all three agree. With "fiber" and "depth" k times it is the largest pressure.
  double penetration;
  // Spacing of the fibers; 0 for `exact`. Passed as the option `spacing`, it gives the same pattern again.
  double spacing;
  // Energy stored in the stick of friction.
  double friction_energy;
  // Energy dissipated by friction since the step began.
  double friction_dissipation;
  // Area (2D: length) that sticks.
  double stick_area;
  // Area (2D: length) that slides.
  double slip_area;
  // Force of the first side on the second, friction included; in 2D the last entry is 0. The force of the second on the first is
  // its negative. 0 for a body that overlaps itself.
  double force[3];
  // Zero.
  uint64_t reserved[4];
} fmc_pair_result;

// Contact forces at `coords`, the current coordinates of all nodes of the mesh.
//
// `forces`, which may be NULL, receives the nodal forces in the order of the nodes: the negative derivative of the
// contact energy, which pushes bodies apart. They overwrite the array, or are added to it with the flag `FMC_EVALUATE_ADD`.
// Nodes that are not in contact get 0. `result`, which may be NULL too, receives the overlap volume and the other
// totals; forces per body, pairs and warnings are kept in the context until the next evaluation that succeeds.
//
// Both are written only on success. The arrays may overlap one another. Units as in `fmc_result`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_STRIDE`,
// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`, `FMC_ERROR_UNSUPPORTED`,
// `FMC_ERROR_SIGNED_DISTANCE`, `FMC_ERROR_UNFINISHED_LINES`, `FMC_ERROR_TOO_MANY_FIBERS`, `FMC_ERROR_TOO_MANY_PIECES`,
// `FMC_ERROR_UNKNOWN_FLAG`, `FMC_ERROR_OVERFLOW`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_evaluate(fmc_context *context,
                                const fmc_coords *coords,
                                const fmc_forces *forces,
                                uint32_t flags,
                                fmc_result *result);

// Contact force and moment on a body of the mesh, from the last successful evaluation. Bodies are ordered by id.
//
// `index` counts from 0 to `body_count` of `fmc_result`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_INDEX_OUT_OF_RANGE`, `FMC_ERROR_BUSY`. Threads: several at once on one
// context, as long as no call changes it.
fmc_status fmc_context_body_resultant(const fmc_context *context, size_t index, fmc_resultant *body);

// Contact force and moment on an obstacle, from the last successful evaluation. Otherwise as `fmc_context_body_resultant`.
fmc_status fmc_context_obstacle_resultant(const fmc_context *context,
                                          size_t index,
                                          fmc_resultant *obstacle);

// One overlapping pair of the last successful evaluation. Otherwise as `fmc_context_body_resultant`.
fmc_status fmc_context_pair_result(const fmc_context *context, size_t index, fmc_pair_result *pair);

// One warning of the last successful evaluation: a value of `fmc_warning`, and a sentence that is valid until the next
// evaluation of the context or its end. Either output may be NULL. Otherwise as `fmc_context_body_resultant`.
fmc_status fmc_context_warning(const fmc_context *context, size_t index, int32_t *code, const char **text);

// ---- Tangent ---------------------------------------------------------------------------------------------

// Flag of `fmc_context_tangent` and `fmc_context_evaluate_tangent`: without the terms that can be indefinite, for use
// far from a solution.
#define FMC_TANGENT_SEMIDEFINITE 2

// Flag of both: without the unsymmetric part, the growth of frictional forces with the pressure.
#define FMC_TANGENT_SYMMETRIC 32

// Flag of `fmc_context_tangent_csr`: entries are blocks of dim x dim (BSR), rows and columns nodes.
#define FMC_CSR_BLOCKS 4

// Flag of `fmc_context_tangent_csr`: with rows and columns of the obstacles' translations, after the rows of the
// nodes.
#define FMC_CSR_OBSTACLES 8

// Second derivative of the contact energy at `coords`, which is minus the derivative of the nodal forces, to be added
// to the host's stiffness matrix. It is kept in the context until the next call, for `fmc_context_tangent_csr` and
// `fmc_context_tangent_entries`.
//
// The tangent is symmetric without friction. With friction it is UNSYMMETRIC, unless the friction is frozen: take LU or GMRES in
// place of Cholesky or conjugate gradients. Or ask for `FMC_TANGENT_SYMMETRIC`, with which Newton's method takes more iterations, and
// fails sooner at large coefficients of friction. Rows and columns are degrees of freedom: axis a of the n-th node is the one number
// n * dim + a, n and a from 0, counted from the option `index_base`. The translation of obstacle o follows the nodes, as node
// `node_count + o`. A host that loads an obstacle finds its stiffness there; other hosts ignore these rows and columns.
// `rank_one_count`, which may be NULL, receives the number of terms of rank one, which couple all nodes of a pair: 0 for the laws
// "depth" and "fiber".
//
// With the law "depth" it is the derivative of the forces of `fmc_context_evaluate`; with "fiber" it is with kept patches
// and `momentum_correction` 0; the momentum correction, which is small, is not differentiated. `flags`: 0,
// `FMC_TANGENT_SYMMETRIC` or `FMC_TANGENT_SEMIDEFINITE`, which is symmetric too.
//
// Newton's method, without a line search, with the law "depth" and k = 10 E / h (modulus E, facets of size h): apply prescribed
// displacements in the first solve, with the tangent of the last equilibrium. If the pressure k * penetration of an iterate exceeds
// both E / 10 and twice the pressure of the last equilibrium, lower the option `stiffness` until it does not. Then raise it at least
// fourfold in every iteration, and take `FMC_TANGENT_SEMIDEFINITE` until it is k again. Else take the full tangent. docs/newton.md
// has the loop, and its iterations on five problems.
//
// Errors: as `fmc_context_evaluate`; `FMC_ERROR_UNSUPPORTED` for a law or an estimator without tangent. Threads: one
// call at a time on a context.
fmc_status fmc_context_tangent(fmc_context *context,
                               const fmc_coords *coords,
                               uint32_t flags,
                               size_t *rank_one_count);

// The entries of the tangent, one for each pair of row and column: entry i is `values[i]` at row `rows[i]` and column `cols[i]`,
// ordered by row and column of their nodes.
//
// `count` becomes their number; the arrays have room for `capacity`. All three NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where there are more degrees of freedom
// than the context's numbers have room for, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one
// context, as long as no call changes it.
fmc_status fmc_context_tangent_entries(const fmc_context *context,
                                       void *rows,
                                       void *cols,
                                       double *values,
                                       size_t capacity,
                                       size_t *count);

// Product of the tangent, terms of rank one included, with `x`: `length` numbers, `dim` for every node, then, if
// `length` includes them, for every obstacle. `y` may be `x`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for fewer than `dim` times the number of nodes,
// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_tangent_product(const fmc_context *context, const double *x, double *y, size_t length);

// A term of rank one of the tangent, factor · g gᵀ: writes the factor, and g to `vector`, with room for `length`
// numbers laid out as in `fmc_context_tangent_product`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_INDEX_OUT_OF_RANGE`, `FMC_ERROR_LENGTH`, `FMC_ERROR_BUSY`. Threads:
// several at once on one context, as long as no call changes it.
fmc_status fmc_context_tangent_rank_one(const fmc_context *context,
                                        size_t index,
                                        double *factor,
                                        double *vector,
                                        size_t length);

// The last tangent in compressed rows (CSR), without its terms of rank one (`fmc_context_tangent_rank_one`). Row r has the entries
// from `row_offsets[r]` to `row_offsets[r + 1]`, in ascending order of their columns `cols`, each column once. Rows and columns are
// degrees of freedom as in `fmc_context_tangent`; rows without entries are there too. Offsets and columns count from the option
// `index_base`. Before the first tangent there are no rows.
//
// `flags`: `FMC_CSR_BLOCKS`, for entries that are blocks, `values[(entry * dim + i) * dim + j]`, and rows and columns that
// are nodes; `FMC_CSR_OBSTACLES`.
//
// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries, which are numbers, or
// blocks. `row_offsets` has room for `offset_capacity`, `cols` for `capacity`, and `values` for as many, or, with `FMC_CSR_BLOCKS`, for
// `capacity * dim * dim` numbers. An array that is NULL with capacity 0 is not written: only its number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNKNOWN_FLAG`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number
// does not fit into the context's numbers, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one context,
// as long as no call changes it.
fmc_status fmc_context_tangent_csr(const fmc_context *context,
                                   uint32_t flags,
                                   void *row_offsets,
                                   size_t offset_capacity,
                                   size_t *offset_count,
                                   void *cols,
                                   double *values,
                                   size_t capacity,
                                   size_t *count);

// Keeps the pattern of `fmc_context_tangent_csr`, with `keep` 1: from the last tangent on it only grows, and places
// that no longer have an entry hold zeros. While the numbers of rows and entries stay the same, the pattern is the
// same too. So a host's matrix and its symbolic factorisation can stay during a load step. 0 releases it: every
// tangent has its own pattern, which is the default. Values, and the other functions of the tangent, do not change.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for another number, `FMC_ERROR_BUSY`. Threads: one call
// at a time on a context.
fmc_status fmc_context_keep_pattern(fmc_context *context, int32_t keep);

// `fmc_context_evaluate` and `fmc_context_tangent` at the same coordinates, in little more than the time of the second:
// bodies are measured once. All results are bit-for-bit identical to the two calls, and are kept in the same way.
//
// `flags`: `FMC_EVALUATE_ADD`, `FMC_TANGENT_SEMIDEFINITE` and `FMC_TANGENT_SYMMETRIC`. All outputs may be NULL, and are written only on
// success.
//
// Errors: as both calls. Threads: one call at a time on a context.
fmc_status fmc_context_evaluate_tangent(fmc_context *context,
                                        const fmc_coords *coords,
                                        uint32_t flags,
                                        const fmc_forces *forces,
                                        fmc_result *result,
                                        size_t *rank_one_count);

// Gives tangents rows and columns for the rotations of the obstacles, with `on` 1, from the next one on; 0, the default:
// none. With n nodes and m obstacles, removed ones included, the rotation of obstacle o is node n + m + o. It is a
// rotation vector about the position of its pose, which moves along. In 2D its first entry is the angle, and the second
// has only zeros. Rotations follow wherever there are translations of obstacles, as with `FMC_CSR_OBSTACLES`.
//
// It is the second derivative of the energy, and symmetric. The moment M about the position (moment of
// `fmc_context_obstacle_resultant` minus position x force) changes by -K dtheta + 1/2 dtheta x M as the obstacle turns by dtheta.
// With axisymmetry obstacles do not rotate, and there are only zeros. Friction adds the terms of its tangent, unsymmetric without
// `FMC_TANGENT_SYMMETRIC`. Where a body meets an obstacle by the law "fiber", whose lines do not rotate with it, the tangent returns
// `FMC_ERROR_UNSUPPORTED`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for another number, `FMC_ERROR_BUSY`. Threads: one call
// at a time on a context.
fmc_status fmc_context_set_obstacle_rotations(fmc_context *context,
                                              int32_t on);

// ---- Steps: friction, patches, the longest step of explicit dynamics -------------------------------------

// How far a step may go.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Part of the step, at most 1, in which no body passes through another: a factor for a step of Newton's method.
  double part;
  // Part of it at which the first gap closes, from the current slopes of the gaps: a linearisation holds up to there. Infinite
  // if no gap closes within `part`.
  double first_touch;
  // Zero.
  uint64_t reserved[4];
} fmc_step_limit;

// Begins a step with friction at `coords`, with the obstacles where they are: slip is counted from here. With friction
// this comes before the first evaluation, and `fmc_context_commit_step` after every step that is accepted, which begins
// the next. A step may be repeated any number of times: nothing has to be undone.
//
// Accumulated elastic slip is kept; there is none at first. With friction, the contact at `coords` is measured. A facet
// that touches later counts its slip from its first touch.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_STRIDE`, `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_BUSY`;
// with friction as `fmc_context_evaluate`. The context is then unchanged. Threads: one call at a time on a context.
fmc_status fmc_context_begin_step(fmc_context *context,
                                  const fmc_coords *coords);

// Accepts the step that ends at `coords`: the elastic slip there is carried into the next step, which begins here.
// Frozen friction is released. Call it with the coordinates that the host has accepted, and never within an iteration.
//
// Errors: `FMC_ERROR_NO_STEP` before `fmc_context_begin_step`; else as `fmc_context_evaluate`. The context is then
// unchanged. Threads: one call at a time on a context.
fmc_status fmc_context_commit_step(fmc_context *context, const fmc_coords *coords);

// Freezes the facets on which friction acts, and their pressure, as they are at `coords`. This holds until the step is
// committed, or until a call with `coords` NULL. Forces of friction are then minus the gradient of a convex potential, and
// their tangent is symmetric and positive semidefinite. Repeat this at the new solution until nothing changes: it converges to
// the solution with the current pressure. It also converges at large coefficients of friction, at which Newton's method with
// the current pressure fails.
//
// Errors: `FMC_ERROR_NO_STEP`; else as `fmc_context_evaluate`. Earlier frozen friction is then kept. Threads: one call
// at a time on a context.
fmc_status fmc_context_freeze_friction(fmc_context *context,
                                       const fmc_coords *coords);

// Finds the patches of the law "fiber" at `coords` and keeps the direction and the spacing of their lines for all
// later evaluations: a solver's forces are then the gradient of one energy. `coords` NULL releases them: every
// evaluation then finds its patches, which is the default.
//
// Call it at the start of a load step. Patches of pairs that do not overlap at `coords` are not kept, but found at
// every evaluation. `direction_count`, which may be NULL, receives the number of directions kept: 0 with other laws.
//
// Errors: as `fmc_context_evaluate`; earlier patches are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_keep_patches(fmc_context *context, const fmc_coords *coords, size_t *direction_count);

// Largest time step of central differences (leapfrog) for the contact alone, from the tangent at `coords`: 2/sqrt(q).
// Here q is an upper bound of the largest eigenvalue of M^-1 K, including terms of rank one, a few per cent above it.
// Infinite without contact. `masses` are lumped masses, one for every node of the mesh, positive where a node feels
// contact, and infinite for nodes that the host holds. Obstacles are held.
//
// A host whose limit without contact is h is stable with the step s, 1/s^2 = 1/h^2 + 1/step^2. The limit holds for the
// motion linearised at `coords`. It includes neither contact that begins within a step, nor the force of the law
// "volume" with an exponent below 2, which jumps. The stored tangent and results are kept. Unit: sqrt(mass * length /
// force).
//
// Errors: as `fmc_context_tangent`, and `FMC_ERROR_NOT_POSITIVE_MASS`. Threads: one call at a time on a context.
fmc_status fmc_context_stable_step(fmc_context *context, const fmc_coords *coords, const double *masses, double *step);

// Finds the stiffness of every pair without a separate law from the nodes' masses and `limit`, the largest time step of the bodies
// without contact in central differences. Contact of whole faces then makes the step a tenth shorter. For hosts without a matrix, with
// the option `stiffness` 0. `masses` as for `fmc_context_stable_step`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NOT_POSITIVE` for the limit, `FMC_ERROR_NOT_POSITIVE_MASS`,
// `FMC_ERROR_UNSUPPORTED` where the host holds every surface or the option `stiffness` is given, `FMC_ERROR_BUSY`; the earlier stiffness
// is then kept. Threads: one call at a time on a context.
fmc_status fmc_context_stiffness_from_masses(fmc_context *context,
                                             const fmc_coords *coords,
                                             const double *masses,
                                             double limit);

// How far the nodes at `coords` may move along `step`, a motion of every node in the same layout, so that no body passes through
// another. The overlap of surfaces grows by at most half a facet, and no body moves by more than half its thickness relative to
// another. For hosts that iterate themselves.
//
// Errors: as `fmc_context_gap_constraints`. Threads: one call at a time on a context.
fmc_status fmc_context_step_limit(fmc_context *context,
                                  const fmc_coords *coords,
                                  const fmc_coords *step,
                                  fmc_step_limit *limit);

// ---- Gaps and overlaps at the start ----------------------------------------------------------------------

// Gaps closed and overlaps removed by `fmc_context_adjust`.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Largest mean gap of a surface point that was closed, a length.
  double closed;
  // Largest mean overlap of a surface point that was removed, a length.
  double removed;
  // Largest remaining mean gap or overlap of these points, which non-matching meshes cause.
  double left;
  // Number of points that were moved.
  size_t count;
  // Zero.
  uint64_t reserved[4];
} fmc_adjustment;

// Closes gaps and removes overlaps at `coords` without strain. It applies where the mean gap of a surface point to a partner
// (`fmc_context_gap_constraints`) is at most `close`, or its overlap at most `remove`, both lengths. There the surface is offset from its
// nodes from then on, with two bodies each by half of the distance. Nodes and their strains stay. It works with any law, friction and
// self-contact. All later results of the context, including gaps, refer to the offset surfaces. A later call adds to the offsets of an
// earlier one.
//
// Apply an interference fit in steps: adjust, then before each load step set a smaller part of `fmc_context_offsets` by
// `fmc_context_set_offsets`, and none in the last. Offsets do not turn with bodies.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` for a length that is negative or NaN, `FMC_ERROR_UNSUPPORTED` for a mesh
// in parts or for bodies that are tied or glued across a gap, `FMC_ERROR_BUSY`; else as `fmc_context_gap_constraints`. The context
// is then unchanged. Adjust bodies before you tie them: a tie keeps its gap. Threads: one call at a time on a context.
fmc_status fmc_context_adjust(fmc_context *context,
                              const fmc_coords *coords,
                              double close,
                              double remove,
                              fmc_adjustment *adjustment);

// Offset of the surface from its nodes: `dim` numbers in dense rows for every node, with cells of second order for every point
// (`fmc_context_point_weights`), a length.
//
// `count` becomes their number; `offsets` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once
// on one context, as long as no call changes it.
fmc_status fmc_context_offsets(const fmc_context *context,
                               double *offsets,
                               size_t capacity,
                               size_t *count);

// Sets the offset of the surface from its nodes: `count` numbers, as `fmc_context_offsets` writes them; none: no offset. This causes no
// slip.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_STIFFNESS` for a number that is not finite,
// `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`; the old offsets are then kept. Threads: one call at a time on a
// context.
fmc_status fmc_context_set_offsets(fmc_context *context,
                                   const double *offsets,
                                   size_t count);

// ---- Penetration tolerance (method of multipliers) -------------------------------------------------------

// Results of `fmc_context_augment`, at the coordinates of its call.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Largest mean penetration of a node over its part of the surface, of the side of each pair that has the multipliers.
  double penetration;
  // Largest change of a multiplier / stiffness of the law: distance of a pressed node from the partner, inside or outside.
  double change;
  // Number of multipliers, for `fmc_context_multipliers`.
  size_t multiplier_count;
  // Whether both are within the tolerance: the multipliers are then unchanged.
  int32_t is_converged;
  // Zero.
  int32_t reserved_flags;
  // Zero.
  uint64_t reserved[4];
} fmc_augmentation;

// Multiplier of a node: by how far its surface is shifted towards one partner.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // The node, counted from the option `index_base`; with cells of second order the point, see
  // `fmc_context_point_weights`.
  int64_t node;
  // Its body, an index for `fmc_context_body_resultant`.
  size_t body;
  // Kind of the partner: a value of `fmc_partner`.
  int32_t partner_kind;
  // Zero.
  int32_t reserved_flags;
  // Index of the partner for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
  size_t partner;
  // Shift, a positive length; times the law's stiffness it is the pressure without penetration.
  double shift;
  // Unit vector towards the partner; in 2D the last is 0.
  double towards[3];
  // Zero.
  uint64_t reserved[4];
} fmc_multiplier;

// Updates the multipliers, which shift surfaces outwards so that they press with less penetration at the next equilibrium. A
// node shifts by its mean gap (`fmc_context_gap_constraints`) at `coords`. It shifts up to four times as far where the last
// update of a series has closed less than its shift, and back where the contact has opened. This is the method of multipliers:
// shift times the law's stiffness is a pressure without penetration.
//
// Call it where the bodies are in equilibrium, or nearly, solve again, and repeat until `is_converged`. Any stiffness of the law
// works, but a low one takes more updates. All later results of the context (forces, tangents, steps) refer to the shifted surfaces,
// whose penetration is pressure / stiffness; weighted gaps refer to the true surfaces. Multipliers stay for the next load step;
// `fmc_context_set_multipliers` without multipliers removes them. Of two bodies the one with more nodes near the other has the
// multipliers; with equal numbers the first.
//
// `reach`: largest distance from a partner at which gaps are measured, a length; 0: a twentieth of the bodies' extent. `tolerance`:
// penetration and change below which nothing is updated, a length. `result` receives both as they were before the update.
//
// Errors: `FMC_ERROR_NOT_POSITIVE` for `reach` and `tolerance` that are negative or NaN; `FMC_ERROR_UNSUPPORTED` with self-contact, a law
// whose pressure is not a stiffness times the penetration, and a mesh in parts; else as `fmc_context_evaluate`. The multipliers are then
// unchanged. Threads: one call at a time on a context.
fmc_status fmc_context_augment(fmc_context *context,
                               const fmc_coords *coords,
                               double reach,
                               double tolerance,
                               fmc_augmentation *result);

// Multiplies the stiffness of the law, and of the separate laws of pairs, by `factor`. The pressure of the multipliers does not
// change. Call it instead of another update if the last update reduced the penetration too little, say to more than a quarter. The
// options of the context have the new stiffness.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`; the context is then unchanged. Threads: one call at a
// time on a context.
fmc_status fmc_context_stiffen(fmc_context *context,
                               double factor);

// ---- Equilibrium at the end of a load step ---------------------------------------------------------------

// Requests of `fmc_equilibrium_next`, and ends of the search. K is the derivative of the forces at the last request with `matrix`, T
// the tangent of the contact at `x`.
typedef enum {
  // Internal minus external forces at `x`, without contact.
  FMC_REQUEST_FORCES = 0,
  // K `vector`, including rows and columns of unknowns that are not free.
  FMC_REQUEST_PRODUCT = 1,
  // The diagonal of K.
  FMC_REQUEST_DIAGONAL = 2,
  // d with (K + `shift` diag K + T) d = `vector` in the rows of free unknowns, and d = 0 at all other unknowns.
  FMC_REQUEST_SOLVE = 3,
  // A step from `x` to the equilibrium of the contact with linear bodies, from K and the forces `forces`, as
  // `fmc_context_contact_step` finds it. Unknowns that are not free move by `vector`.
  FMC_REQUEST_CONDENSED = 4,
  // The equilibrium was found: see `fmc_equilibrium_result`.
  FMC_REQUEST_FOUND = 5,
  // There is no equilibrium, or none was found: see `fmc_equilibrium_result`.
  FMC_REQUEST_REFUSED = 6,
} fmc_equilibrium_request_kind;

// How an equilibrium was found.
typedef enum {
  // No equilibrium was found.
  FMC_WAY_NONE = 0,
  // By steps to the equilibrium of the contact with linear bodies.
  FMC_WAY_CONDENSED = 1,
  // By full steps of Newton's method: it is the equilibrium next to the start.
  FMC_WAY_NEAREST = 2,
  // By descent of the energy.
  FMC_WAY_DOWNHILL = 3,
} fmc_equilibrium_way;

// A search for the equilibrium of a host's bodies in contact at the end of one load step. Opaque.
//
// Where the option `stiffness` is 0, it finds the stiffness of the contact from the host's matrix. It moves unsupported bodies until
// contact balances their loads, or names a body that no contact stops. It keeps steps so short that no body passes through another, and
// tries several ways to the equilibrium from the same start. The host keeps its vectors, matrices and solvers, and answers requests.
// Concurrent calls on one return `FMC_ERROR_BUSY`.
typedef struct fmc_equilibrium fmc_equilibrium;

// Tolerances and limits of a search. Initialise it with `fmc_equilibrium_options_init`; the defaults suffice.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_equilibrium_options_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Relative residual: its norm at free unknowns / norm of the forces of the bodies or of the contact, whichever is larger. Default
  // 1e-9.
  double tolerance;
  // Linear solves, at most. Default 100.
  size_t max_solves;
  // Penetration tolerance: largest mean penetration of a node, a length. 0, the default: a thousandth of the largest elastic
  // displacement if the search has found the stiffness; no tolerance if the stiffness was given.
  double penetration;
  // Largest distance from a partner at which gaps are measured for it, a length; 0, the default: a twentieth of the
  // bodies' extent.
  double reach;
  // Updates of multipliers, at most; it is an error if the tolerance needs more. Default 20.
  size_t max_updates;
  // 1: the host answers `FMC_REQUEST_CONDENSED`. 2: such steps come first also for bodies on very soft springs; they lead to a stable
  // equilibrium, which may be far from the start. Default 0.
  int32_t condensed;
  // 1: friction is frozen, solved for, and frozen again, until nothing changes. Default 0.
  int32_t lagged;
  // 1: patches of the law "fiber" are kept at the start, follow the contact far from its equilibrium, and are recomputed near it.
  // 0, the default: the host keeps them.
  int32_t find_patches;
  // 1: the host is checked at the start, and nothing is solved. The checks compare the residual with the matrix, and test signs,
  // symmetry and rigid motions. The search ends with `FMC_REQUEST_FOUND`, and `fmc_equilibrium_text` has a sentence for each. Default 0.
  int32_t check;
  // 1: slip counts straight from the start of the step, also of pairs that touch later in it. Derivatives of the equilibrium then hold no
  // place of first touch. Default 0: from where a gap closes.
  int32_t straight_slip;
  // Zero.
  uint32_t reserved_flags;
  // Zero. Room for options of later versions.
  uint64_t reserved[4];
} fmc_equilibrium_options;

// The unknowns of a host, and the start of a load step. Initialise it with `fmc_equilibrium_problem_init`.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_equilibrium_problem_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Number of unknowns, free or not.
  size_t unknown_count;
  // Number of rows of coordinates, as the context has them.
  size_t row_count;
  // Unknown of every coordinate, `row_count * dim` numbers by row, of the mesh's `index_size` and counted from
  // `index_base`. A coordinate that never moves has any number below `index_base`.
  const void *unknown_of_coordinate;
  // Coordinates where all unknowns are zero, `row_count * dim` numbers by row.
  const double *base;
  // `unknown_count` marks: 0 for an unknown that is not solved for.
  const uint8_t *free;
  // Where the load step begins, `unknown_count` numbers: best the last equilibrium.
  const double *x;
  // Values at its end of unknowns that are not free, `unknown_count` numbers; other entries are not read. NULL:
  // unchanged.
  const double *prescribed;
  // Zero.
  uint64_t reserved[4];
} fmc_equilibrium_problem;

// An answer. Initialise it with `fmc_equilibrium_answer_init`.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_equilibrium_answer_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // The requested vector, `unknown_count` numbers. NULL: it does not exist, for example with an inverted cell or a
  // singular matrix.
  const double *vector;
  // Reason why it does not exist, or NULL.
  const char *refusal;
  // With forces: strain energy minus the work of loads, or NULL where the host does not know it.
  const double *energy;
  // With a condensed step: 1 if K was found to be symmetric and positive definite without contact.
  int32_t definite;
  // Zero. Room for switches of later versions.
  uint32_t reserved_flags;
  // Zero.
  uint64_t reserved[4];
} fmc_equilibrium_answer;

// A request. Its arrays have `unknown_count` numbers, and are valid until the next call with the search.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // A value of `fmc_equilibrium_request_kind`.
  int32_t kind;
  // 1: from now on K is the derivative at this `x`.
  int32_t matrix;
  // 1: entries of K count by their magnitudes.
  int32_t magnitudes;
  // Flag of `fmc_context_tangent` for T: 0, `FMC_TANGENT_SYMMETRIC` or `FMC_TANGENT_SEMIDEFINITE`.
  uint32_t tangent_flags;
  // A state, or NULL.
  const double *x;
  // A vector, or NULL.
  const double *vector;
  // Forces, or NULL.
  const double *forces;
  // Part of the diagonal of K that is added.
  double shift;
  // Residual at which a condensed step may end, relative to the forces.
  double tolerance;
  // Residual at which it may end, a force.
  double absolute_tolerance;
  // Zero.
  uint64_t reserved[4];
} fmc_equilibrium_request;

// Result of a search. Its arrays belong to the search, and are valid until it is freed.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // A value of `fmc_equilibrium_way`; `FMC_WAY_NONE` for a refusal.
  int32_t way;
  // For a refusal: 1 if `unheld_body` is the reason.
  int32_t unheld;
  // The equilibrium, `unknown_count` numbers; NULL for a refusal.
  const double *x;
  // Internal minus external minus contact forces there: at unknowns that are not free, the reactions. NULL for a refusal.
  const double *reactions;
  // Residual relative to the forces, state by state.
  const double *residuals;
  // Their number.
  size_t residual_count;
  // Linear systems solved, without the checks whether loose bodies are supported.
  size_t solve_count;
  // Rigid steps in which loose bodies came to rest.
  size_t rigid_step_count;
  // Parts in which the step was made.
  size_t part_count;
  // Rigid motions that K does not resist, or hardly.
  size_t loose_count;
  // Updates of the multipliers.
  size_t update_count;
  // Number of texts of `fmc_equilibrium_text`: warnings, or one sentence for a refusal.
  size_t text_count;
  // Largest mean penetration of a node, a length; negative where it was not measured.
  double penetration;
  // Id of an unsupported body.
  int64_t unheld_body;
  // Unit vector along which it moves; zeros for a rotation.
  double unheld_direction[3];
  // Pairs whose slip counts from where they first touched in this step: they were apart at its start. Derivatives of the equilibrium hold
  // these places.
  size_t first_touch_count;
  // Zero.
  uint64_t reserved[5];
} fmc_equilibrium_result;

// Sets all options of a search to their defaults.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_equilibrium_options_init(fmc_equilibrium_options *options);

// Sets a problem to zero, and its size.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_equilibrium_problem_init(fmc_equilibrium_problem *problem);

// Sets an answer to zero, and its size.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_equilibrium_answer_init(fmc_equilibrium_answer *answer);

// Makes a search, to be freed by `fmc_equilibrium_free`. `options` may be NULL: the defaults.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_LENGTH`,
// `FMC_ERROR_INDEX_OUT_OF_RANGE`, `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_NON_FINITE_STIFFNESS`, `FMC_ERROR_NOT_POSITIVE`,
// `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_equilibrium_new(fmc_context *context,
                               const fmc_equilibrium_problem *problem,
                               const fmc_equilibrium_options *options,
                               fmc_equilibrium **equilibrium);

// Takes the answer to the last request, and writes the next request, or the end of the search.
//
// `answer`: NULL for the first call; later a call without an answer repeats the request. Between the calls the host may call the
// context, for example to get the tangent. It must not change obstacles, options or friction before the search has ended. A refusal
// restores friction and multipliers of the context.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_UNSUPPORTED` for a context of
// another dimension, `FMC_ERROR_BUSY`; the request then remains. Threads: one call at a time on a search and its context.
fmc_status fmc_equilibrium_next(fmc_context *context,
                                fmc_equilibrium *equilibrium,
                                const fmc_equilibrium_answer *answer,
                                fmc_equilibrium_request *request);

// Gives up a search that has not ended, for example because the host cannot answer. It restores friction and multipliers of the context,
// and the search ends with a refusal. Does nothing if the search has ended.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a context of another dimension, `FMC_ERROR_BUSY`. Threads: one call at a
// time on a search and its context.
fmc_status fmc_equilibrium_abandon(fmc_context *context,
                                   fmc_equilibrium *equilibrium);

// Result of an ended search.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP` before its end, `FMC_ERROR_BUSY`. Threads: one call at a time on a search.
fmc_status fmc_equilibrium_found(fmc_equilibrium *equilibrium,
                                 fmc_equilibrium_result *result);

// A sentence of a search that has ended: its warnings, or why there is no equilibrium; after `fmc_equilibrium_found`. NULL for a number
// that is too large. Valid until the search is freed.
//
// Errors: none. Threads: one call at a time on a search.
const char *fmc_equilibrium_text(const fmc_equilibrium *equilibrium,
                                 size_t number);

// Frees a search and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL. Freeing a search before
// its end does not restore the context, which keeps frozen or softened friction, and multipliers: call `fmc_equilibrium_abandon`
// first.
//
// Errors: none. Threads: no other call on it may be running or follow.
fmc_status fmc_equilibrium_free(fmc_equilibrium **equilibrium);

// ---- Equilibrium with condensed bodies -------------------------------------------------------------------

// How a step of `fmc_context_contact_step` ended.
typedef enum {
  // In equilibrium.
  FMC_STEP_CONVERGED = 0,
  // Contact acts on degrees of freedom that are neither on the list nor fixed, and a longer list is needed. The
  // displacement is the last one.
  FMC_STEP_OUTSIDE = 1,
  // The iterations have run out, or the residual could not be lowered further; the displacement is the last one.
  FMC_STEP_NOT_CONVERGED = 2,
} fmc_contact_step_state;

// Factors of the stiffness K of bodies, with the equations that feel contact retained for the end. Opaque.
//
// For hosts whose solver has no Schur complements. The host assembles K without contact and without fixed degrees of freedom. The
// condensation gives the dense matrix and the right side for `fmc_context_contact_step`, and all displacements from the retained
// ones. With c the retained equations and r the rest, `S = K_cc - K_cr inv(K_rr) K_rc`.
//
// It works with one thread, so the same matrix gives bit-for-bit identical results everywhere. Concurrent calls on one
// return `FMC_ERROR_BUSY`.
typedef struct fmc_condensation fmc_condensation;

// When a step of `fmc_context_contact_step` ends. Initialise it with `fmc_contact_step_options_init`.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_contact_step_options_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Relative residual at which a step has converged. The reference is the norm of the given residual or of the contact
  // forces on the list, whichever is larger. Default 1e-10.
  double tolerance;
  // Norm of the residual, a force, at which it has converged too; 0, the default: none. For nonlinear bodies a part of
  // their linearisation error suffices.
  double absolute_tolerance;
  // Relative residual below which the full tangent is taken, above it the semidefinite one. Default 0.1.
  double full_below;
  // Iterations, at most, at least 1. Default 80.
  int32_t max_iterations;
  // Trials along a direction, at most, at least 1. Default 12.
  int32_t max_trials;
  // 1: softer contacts come first if the first full step of Newton's method would not lower the energy (without an energy, the
  // residual) or would invert a cell. The first contact is no stiffer than the bodies at any degree of freedom of the list, the
  // next one is ten times as stiff, and so on. Each may take `max_iterations`. Results refer to the true contact. 0, the default:
  // off.
  int32_t soft_start;
  // Zero. Room for switches of later versions.
  int32_t reserved_flags;
  // Zero. Room for options of later versions.
  uint64_t reserved[7];
} fmc_contact_step_options;

// Places the nodes for a displacement of the degrees of freedom on the list of `fmc_context_contact_step`.
//
// Read `displacement`, (n). `coords` are dense rows, one for every node: the coordinates of the start, with the
// displacement added on the list. Move the nodes that follow, and none on the list. `user` is the pointer given with the
// function.
//
// Return 0; any other value makes the step fail with `FMC_ERROR_PLACE`. It is called on the thread that called for the step. It
// must not call a function of the same context (it would get `FMC_ERROR_BUSY`), throw, or jump out.
typedef int32_t (*fmc_place)(void *user, size_t n, const double *displacement, double *coords);

// Results of a step.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // A value of `fmc_contact_step_state`.
  int32_t state;
  // Linear systems solved.
  int32_t iterations;
  // Evaluations of the contact forces alone, without evaluations of the tangent.
  size_t evaluation_count;
  // Degrees of freedom outside the list on which contact acts.
  size_t outside_count;
  // Norm of the residual at the start.
  double residual_at_start;
  // Norm of the residual at the end.
  double residual;
  // Reference of the residual: the norm of the given residual or of the contact forces on the list, whichever is
  // larger.
  double scale;
  // Zero.
  uint64_t reserved[8];
} fmc_contact_step_result;

// Sets all options of a contact step to their defaults.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_contact_step_options_init(fmc_contact_step_options *options);

// Finds the displacement d of some degrees of freedom for which `S d + r - f(x + d) = 0`: contact forces f are in equilibrium with
// bodies. The host has condensed their stiffness S and residual r, both without contact, on these degrees of freedom. The host
// factorises its bodies once, and iterates the contact, which opens and closes, on a small dense system.
//
// It uses Newton's method with a line search on the energy `r.d + d.S d / 2 + w(x + d)`. Frozen friction has an energy, too
// (`fmc_context_freeze_friction`). Friction with the current pressure has none: the matrix is then unsymmetric, and the line
// search lowers the residual. With the law "fiber" call `fmc_context_keep_patches` before, for one energy.
//
// `dofs`, the list: `dof_count` degrees of freedom, counted as in `fmc_context_tangent`, ascending; take the movable ones of the tangent's
// pattern. `fixed_dofs`: `fixed_count` others that do not move and on which contact may act, ascending. `stiffness`: S,
// `dof_count * dof_count` numbers, row by row, symmetric; `residual`: r, internal minus external forces at `coords`. `options` may be
// NULL: the defaults. `place`, which may be NULL, moves the nodes that follow the nodes on the list. Bodies that move by more than a part
// of a cell need it, since cells whose other nodes stay would be inverted. `displacement` has room for `dof_count` numbers. It and
// `result` are written on success, which is any state of `fmc_contact_step_state`: look at it.
//
// For a smaller penetration call `fmc_context_augment` at the end of the step, and repeat the step.
//
// Results and tangent in the context remain those from earlier calls. Dense factors of `dof_count` equations are made in every
// iteration: some 500 take tenths of a second.
//
// Errors: as `fmc_context_tangent` at `coords`; `FMC_ERROR_DOF_OUT_OF_RANGE`, `FMC_ERROR_REPEATED_DOF`, `FMC_ERROR_NON_FINITE_STIFFNESS`,
// `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_STRUCT_SIZE` and `FMC_ERROR_RESERVED_FIELD` for the options,
// `FMC_ERROR_SINGULAR_STIFFNESS` and `FMC_ERROR_INDEFINITE_STIFFNESS` for bodies and contact together, `FMC_ERROR_PLACE`. Threads: one
// call at a time on a context.
fmc_status fmc_context_contact_step(fmc_context *context,
                                    const fmc_coords *coords,
                                    const fmc_contact_step_options *options,
                                    const void *dofs,
                                    size_t dof_count,
                                    const void *fixed_dofs,
                                    size_t fixed_count,
                                    const double *stiffness,
                                    const double *residual,
                                    fmc_place place,
                                    void *user,
                                    double *displacement,
                                    fmc_contact_step_result *result);

// Makes a condensation without factors, to be freed by `fmc_condensation_free`.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any.
fmc_status fmc_condensation_new(fmc_condensation **condensation);

// Frees a condensation and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL.
//
// Errors: none. Threads: no other call on it may be running or follow.
fmc_status fmc_condensation_free(fmc_condensation **condensation);

// Factorises a symmetric matrix, with `retained_count` of its equations, `retained`, for the end.
//
// `matrix`: all entries, or none above the diagonal. `retained` counts equations as the matrix does, with numbers of the same width,
// and ascends. The other equations have to be positive definite: bodies are supported, or would be if the retained equations were
// fixed. The symbolic factorisation is kept for the next matrix of the same pattern, which then takes less time.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`,
// `FMC_ERROR_INDEX_SIZE`, `FMC_ERROR_LENGTH`, `FMC_ERROR_DOF_OUT_OF_RANGE`, `FMC_ERROR_REPEATED_DOF`, `FMC_ERROR_NON_FINITE_STIFFNESS`,
// `FMC_ERROR_UNSYMMETRIC`, which all keep the earlier factors. `FMC_ERROR_NOT_POSITIVE_DEFINITE` and `FMC_ERROR_OVERFLOW`, which discard
// them. `FMC_ERROR_UNSUPPORTED` if the library lacks the feature "solver"; `FMC_ERROR_BUSY`. Threads: one call at a time on a
// condensation.
fmc_status fmc_condensation_factorise(fmc_condensation *condensation,
                                      const fmc_csr *matrix,
                                      const void *retained,
                                      size_t retained_count);

// S of the last matrix, row by row: the stiffness for `fmc_context_contact_step`.
//
// `count` becomes the number of entries, the square of the number of retained equations; `complement` has room for `capacity`. NULL
// with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_NOT_FACTORISED`, `FMC_ERROR_BUFFER_TOO_SMALL`,
// `FMC_ERROR_BUSY`. Threads: one call at a time on a condensation.
fmc_status fmc_condensation_complement(const fmc_condensation *condensation,
                                       double *complement,
                                       size_t capacity,
                                       size_t *count);

// Condenses a right side b on the retained equations: `b_c - K_cr inv(K_rr) b_r`.
//
// `right`: `right_count` numbers, as many as there are equations. `count` becomes the number of retained equations; `condensed` has
// room for `capacity`. With b the external minus the internal forces, its negative is the residual for `fmc_context_contact_step`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_NOT_FACTORISED`, `FMC_ERROR_LENGTH`,
// `FMC_ERROR_NON_FINITE_STIFFNESS`, `FMC_ERROR_OVERFLOW`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: one call at a
// time on a condensation.
fmc_status fmc_condensation_condense(const fmc_condensation *condensation,
                                     const double *right,
                                     size_t right_count,
                                     double *condensed,
                                     size_t capacity,
                                     size_t *count);

// Solution of `K x = b` in the equations that are not retained, with given values of the retained unknowns:
// `x_r = inv(K_rr) (b_r - K_rc x_c)`.
//
// `right` is b, as many numbers as there are equations, and `retained` is x_c, one for every retained equation. `count` becomes the
// number of equations; `solution` has room for `capacity`, and may not overlap them. With the displacement of
// `fmc_context_contact_step` as x_c it is the change of all displacements.
//
// Errors: as `fmc_condensation_condense`. Threads: one call at a time on a condensation.
fmc_status fmc_condensation_expand(const fmc_condensation *condensation,
                                   const double *right,
                                   size_t right_count,
                                   const double *retained,
                                   size_t retained_count,
                                   double *solution,
                                   size_t capacity,
                                   size_t *count);

// ---- Outputs: at nodes, at points, on facets -------------------------------------------------------------

// Flag of `fmc_gradients`: by the stiffness of every pair that touches.
#define FMC_GRADIENT_STIFFNESS 1

// Flag of `fmc_gradients`: by the gap offset of every pair that touches.
#define FMC_GRADIENT_GAP_OFFSET 2

// Flag of `fmc_gradients`: by the coefficient of friction of every pair that touches.
#define FMC_GRADIENT_FRICTION 4

// Whether a node is in contact.
typedef enum {
  // No facet at the node is in contact.
  FMC_NODE_APART = 0,
  // A facet at the node is in contact, without friction.
  FMC_NODE_TOUCHING = 1,
  // More of the contact at the node sticks than slides, by area.
  FMC_NODE_STICKING = 2,
  // At least half of it slides.
  FMC_NODE_SLIDING = 3,
} fmc_node_status;

// Where `fmc_context_nodal_contact` writes the contact at the nodes: arrays of the host, each NULL if not requested. With n nodes
// of the mesh `normal` and `friction` have room for n times `dim` numbers, in dense rows, all others for n.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_nodal_contact_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Contact pressure: the nodal force by the area on which it acts, |F| / int N dA.
  double *pressure;
  // Minus the penetration, the mean over the same part, and never positive: distances of separated surfaces are not
  // measured.
  double *gap;
  // Area (2D: length) on which it acts: int N dA over the part of the facets at the node that is in contact, N being the node's
  // shape function. Never more than the node's part of the surface. Larger where `pressure` would be more than twice
  // `local_pressure` and more than the mean pressure of the pair, as at nodes that only the other side presses.
  double *area;
  // Unit vector outwards of the node's body.
  double *normal;
  // Traction of friction on the node's body, the mean over the same part.
  double *friction;
  // The part of the contact at the node that slides, of its area, between 0 and 1.
  double *sliding;
  // Values of `fmc_node_status`.
  int32_t *status;
  // The mean of the law's pressure over the same part, weighted with the node's shape function, int N p dA / int N dA; with the law
  // "volume" the pressure of the pair. On curved surfaces it scatters more than `pressure`.
  double *local_pressure;
  // Zero. Room for outputs of later versions.
  uint64_t reserved[8];
} fmc_nodal_contact;

// One end of a contact point: where, and the shape functions of the boundary face, or of the cell, there. With cells of second
// order they belong to the straight face or cell of the division.
typedef struct {
  // A value of `fmc_partner`.
  int32_t kind;
  // How many of `nodes` and `weights` are used; 0 for an obstacle, and where no cell of the other body is.
  int32_t node_count;
  // Index for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
  size_t index;
  // Cell, counted from the option `index_base` over all blocks; -1 for an obstacle and for a surface without cells.
  int64_t cell;
  // Nodes of the boundary face, or of the cell for a place inside it, counted from the option `index_base`. Where the cell
  // is of second order they are points of its division: row p of `fmc_context_point_weights` takes the force at point p
  // to the nodes.
  int64_t nodes[8];
  // Values of their shape functions: a force at this end is distributed to the nodes, or points, with these factors.
  double weights[8];
  // The end; in 2D the last entry is 0.
  double position[3];
} fmc_contact_side;

// A point of the contact, and its tributary area.
//
// With the law "fiber" it is a piece of a line inside both sides of a pair, between their boundaries. With the law "depth"
// it is the centre of the pressure on the part of a facet inside the other side. Facets of both bodies are pressed, each
// with half of its area, facets against an obstacle with all of it.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Number of the patch within the pair; points of one patch have one normal, up to its sign. 0 with
  // the law "depth".
  size_t patch;
  // Middle of the piece, or the centre of pressure; in 2D the last entry is 0.
  double position[3];
  // Unit vector along the line, or normal of the facet, outwards of the first side; in 2D the last entry is 0.
  double normal[3];
  // Minus the penetration: the length of the piece; the mean depth of the facet's part below the other surface.
  double gap;
  // Contact pressure.
  double pressure;
  // Area (2D: length) across the line, or of the facet's part.
  double area;
  // Traction of friction on the first side, the sum of friction * area being its resultant there; in 2D the last entry
  // is 0.
  double friction[3];
  // Slip of the first side against the second since the step began, without its elastic part, at the facets on which
  // the point lies; in 2D the last entry is 0.
  double slip[3];
  // Part of the area that slides: 0 where the point sticks, 0.5 where one of its two facets does, else 1.
  double sliding;
  // The ends, in the order of the pair's sides; with the law "depth" the point on the facet, and the same place in a
  // cell of the other body.
  fmc_contact_side sides[2];
  // Zero.
  uint64_t reserved[8];
} fmc_contact_point;

// The weighted gap of a node of one body over the surface of one partner: gap = int N phi dA over a part of the facets of
// the node. This part is nearer than the reach, and faces the partner within 60 degrees of the direction to its nearest
// point. N is the shape function of the node, phi the distance from the partner's surface, negative inside. Contact is gap
// >= 0.
//
// With cells of second order a row belongs to a point of their division, and N is its straight shape function, which is
// positive everywhere. The shape function of a node is not, and its integral at the corner of a face may vanish.
// Multipliers are then pressures at points; the derivative is that by nodes.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // The node, counted from the option `index_base`; with cells of second order the point, see
  // `fmc_context_point_weights`: numbers from the node count on are not nodes.
  int64_t node;
  // Its body, an index for `fmc_context_body_resultant`.
  size_t body;
  // Kind of the partner: a value of `fmc_partner`.
  int32_t partner_kind;
  // Zero.
  int32_t reserved_flags;
  // Index of the partner for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
  size_t partner;
  // Weighted gap, in length^dim.
  double gap;
  // int N dA over the same part: `gap / area` is the mean gap at the node.
  double area;
  // Zero.
  uint64_t reserved[4];
} fmc_gap_constraint;

// The tie of two bodies.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Area that is tied (2D: length; with axisymmetry the area of whole rings); 0: the bodies are not tied.
  double area;
  // The largest gap, or overlap, that is kept between the surfaces, a length.
  double largest_gap;
  // Number of means of the jump that are held: one for each node of the holding side, mostly the side with the
  // larger facets.
  size_t node_count;
  // Largest distance or overlap of tied faces, a length: as given, or its default.
  double reach;
  // Zero.
  uint64_t reserved[3];
} fmc_tie;

// A node of a tie, on the holding side, mostly the side with the larger facets.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // The node, counted from the option `index_base`; with cells of second order the point, see
  // `fmc_context_point_weights`.
  int64_t node;
  // Its body, an index for `fmc_context_body_resultant`.
  size_t body;
  // The body to which it is tied.
  size_t partner;
  // Its tributary area.
  double area;
  // Traction on its body, force per area; in 2D the last is 0.
  double traction[3];
  // Mean separation of its body from the other one, a length; in 2D the last is 0.
  double jump[3];
  // Zero.
  uint64_t reserved[4];
} fmc_tie_node;

// Conductance h of a contact: flux per area and jump of the field, for heat W/(m^2 K). Tables are linear between their entries; each
// has its own length.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_conductance_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Number of entries by pressure, where surfaces touch; 1 for a constant, 0 for no flux.
  size_t pressure_count;
  // Pressures, ascending, not negative. h is constant before the first and beyond the last.
  const double *pressures;
  // h at these pressures, not negative.
  const double *by_pressure;
  // Number of entries by gap, where surfaces are apart; 0 for no flux.
  size_t gap_count;
  // Gaps, ascending, not negative. h is constant before the first; beyond the last there is no flux.
  const double *gaps;
  // h at these gaps, not negative.
  const double *by_gap;
  // Zero. Room for fields of later versions.
  uint64_t reserved[8];
} fmc_conductance;

// The cohesive interface of two bodies.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Its total area, without deformation (2D: length; with axisymmetry the area of whole rings); 0: there is no
  // interface.
  double area;
  // The largest gap, or overlap, that is kept between the surfaces, a length.
  double largest_gap;
  // Number of points at which it opens and breaks.
  size_t point_count;
  // Energy that unloading would give back.
  double stored;
  // Energy that damage has dissipated so far.
  double dissipated;
  // Area of points that are damaged, broken ones among them.
  double damaged_area;
  // Area of points that are broken.
  double broken_area;
  // Energy that friction of the broken part has dissipated, minus the stick energy of newly broken area.
  double rubbed;
  // Energy that the viscosity has dissipated.
  double viscous;
  // Zero.
  uint64_t reserved[3];
} fmc_cohesive;

// A point of a cohesive interface.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // The bodies, indices for `fmc_context_body_resultant`, the lower one first.
  size_t body;
  // See `body`.
  size_t partner;
  // Where it is, on `body`; in 2D the last is 0.
  double position[3];
  // Its tributary area, without deformation.
  double area;
  // Opening beyond the initial gap, along the normal of `partner`, a length; negative in compression.
  double opening;
  // Slip of `body` along the surface of `partner`, a length; in 2D the last is 0.
  double sliding[3];
  // Traction on `partner`, force per area, along its outward normal in tension; in 2D the last is 0.
  double traction[3];
  // Damage, 0 to 1, as it would be after a step that ends here.
  double damage;
  // Energy per area that has been dissipated then.
  double dissipated;
  // Energy per area that friction of the broken part has dissipated.
  double rubbed;
  // Energy per area that the viscosity has dissipated.
  double viscous;
  // Zero.
  uint64_t reserved[3];
} fmc_cohesive_point;

// A point of an interface that follows a law of the host.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // The bodies, indices for `fmc_context_body_resultant`, the lower one first.
  size_t body;
  // See `body`.
  size_t partner;
  // Where it is, on `body`; in 2D the last is 0.
  double position[3];
  // Its tributary area, without deformation.
  double area;
  // Normal of `partner` and axes in its plane, as in `fmc_law_points`, three numbers each; in 2D the third axis is z.
  double axes[9];
  // Opening beyond the initial gap, and sliding, along these axes; in 2D the last is 0.
  double jump[3];
  // Traction along these axes, force per area: positive along the normal in tension; in 2D the last is 0.
  double traction[3];
  // Energy per area that unloading would give back, as the law returns it.
  double stored;
  // The same that has been dissipated.
  double dissipated;
  // Zero.
  uint64_t reserved[4];
} fmc_law_point;

// A boundary facet: an edge in 2D, a triangle in 3D. A quadrilateral face is four of them, one on each of its edges. A face
// of a cell of second order is divided first: an edge in two, a triangle or quadrilateral in four parts.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Its body, an index for `fmc_context_body_resultant`.
  size_t body;
  // Its cell, counted from the option `index_base` over all blocks; -1 where the context was made from facets.
  int64_t cell;
  // Its number among the facets that the context was made from, counted from `index_base` over all blocks; -1 where it was made
  // from cells.
  int64_t input_facet;
  // Number of its face in the cell, as VTK counts them, always from 0; -1 without cells. The corners of face 0, 1, ... by their
  // place in the cell, in VTK's order: triangle 01, 12, 20. Quadrilateral 01, 12, 23, 30. Tetrahedron 013, 123, 203, 021. Hexahedron
  // 0473, 1265, 0154, 3762, 0321, 4567. Wedge 012, 354, 0341, 1452, 2530. Pyramid 0321, 014, 124, 234, 304.
  int32_t local_face;
  // Number of nodes of its face: 2 in 2D, 3 or 4 in 3D; on a face of second order, of the part in which the facet
  // lies.
  int32_t node_count;
  // Nodes of its face, counted from the option `index_base`; unused ones are -1. In 2D the body lies left of the way from
  // the first to the second. In 3D they run counter-clockwise seen from outside, also where the cell is numbered the other
  // way round. With four nodes the facet is the triangle of the first two and the mean of all. On a face of second order
  // they are points of its division, see `fmc_context_point_weights`; numbers from the node count on are not nodes.
  int64_t nodes[4];
  // Zero.
  uint64_t reserved[4];
} fmc_boundary_facet;

// Variables of `fmc_context_vjp`, and output arrays of the host. A derivative whose array is NULL is not computed. With n rows of
// `coords` and m obstacles, removed ones included, all in dense rows.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_gradients_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // By the coordinates: room for n * dim numbers.
  double *coords;
  // By the coordinates without deformation, as `fmc_context_set_reference` takes them, the current ones held: room for n * dim
  // numbers. The law "depth" measures its depths from them; other laws do not depend on them.
  double *reference;
  // By the position of every obstacle: room for m * dim numbers.
  double *positions;
  // By a rotation vector of every obstacle about its position: room for m * 3 numbers; in 2D only the last of three differs from zero.
  double *rotations;
  // Requested derivatives of every pair: a sum of `FMC_GRADIENT_STIFFNESS`, `FMC_GRADIENT_GAP_OFFSET` and `FMC_GRADIENT_FRICTION`,
  // or 0.
  uint64_t of_pairs;
  // Factors of the elastic slip at the end of the step, a third term next to energy and forces: rows as `fmc_context_slip` writes them.
  // NULL: zeros. `fmc_context_commit_step` at `coords` would carry this slip on.
  const double *slip_adjoint;
  // Number of entries.
  size_t slip_adjoint_count;
  // By the elastic slip carried into the step: such rows, for every facet with friction. Room for `slip_capacity` numbers.
  double *slip;
  // Room in `slip`.
  size_t slip_capacity;
  // Becomes the number of entries. With `slip` NULL and no room only the number is returned; both NULL: no output.
  size_t *slip_count;
  // Zero. Room for fields of later versions.
  uint64_t reserved[3];
} fmc_gradients;

// Derivatives by the parameters of one pair; 0 if not requested. For `fmc_context_jvp` rates of these parameters.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // First side: a value of `fmc_partner`.
  int32_t a_kind;
  // Second side: a value of `fmc_partner`.
  int32_t b_kind;
  // First side: index for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
  size_t a;
  // Second side; the same as the first for a body that overlaps itself.
  size_t b;
  // By the stiffness k of the pair's law.
  double stiffness;
  // By its gap offset.
  double gap_offset;
  // By its coefficient of friction.
  double friction;
  // Zero.
  uint64_t reserved[4];
} fmc_pair_gradient;

// Direction of `fmc_context_jvp`: rates of all variables of energy and forces, applied together. Variables with NULL or 0 are held.
// With n rows of `coords` and m obstacles, removed ones included, all in dense rows; units are the unit of the variable / a unit that
// the host chooses, such as a time.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_directions_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Of the coordinates: n * dim numbers.
  const double *coords;
  // Of the position of every obstacle: m * dim numbers.
  const double *positions;
  // Of a rotation vector of every obstacle about its position: m * 3 numbers; in 2D only the last of three counts.
  const double *rotations;
  // Of the stiffness k of every pair that touches.
  double stiffness;
  // Of the gap offset of every pair that touches.
  double gap_offset;
  // Of the coefficient of friction of every pair that touches.
  double friction;
  // Of single pairs, in addition: structs as `fmc_context_vjp` writes them, with rates in the place of derivatives. A pair that does not
  // touch has no effect.
  const fmc_pair_gradient *pairs;
  // Number of structs.
  size_t pair_count;
  // Of the elastic slip carried into the step: rows as `fmc_context_slip` writes them, whose last number is not read.
  const double *slip;
  // Number of entries.
  size_t slip_count;
  // Zero. Room for fields of later versions.
  uint64_t reserved[4];
} fmc_directions;

// Requests no output: all pointers are NULL.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_nodal_contact_init(fmc_nodal_contact *nodal);

// The contact at every node of the mesh at `coords`, in the order of the coordinates; zero without contact. `nodal` holds the
// output arrays. The nodal force without its friction is -pressure * area * normal, to rounding.
//
// With cells of second order a node has the values of its point of the division, with the straight shape function of this
// point. Shape functions of second order are negative in places, and have no mean at a corner. Forces at points,
// -pressure * area * normal, then differ from the forces at nodes. They do not add up to the resultant where faces have no node in
// their middle, because points without a node are not written.
//
// It measures the contact again, with the current pressure even where friction is frozen, and changes no other result of the
// context. Errors: as `fmc_context_evaluate`, `FMC_ERROR_STRUCT_SIZE` and `FMC_ERROR_RESERVED_FIELD`; no output is then
// written. Threads: one call at a time on a context.
fmc_status fmc_context_nodal_contact(fmc_context *context,
                                     const fmc_coords *coords,
                                     const fmc_nodal_contact *nodal);

// The contact points at `coords`, where the laws "fiber" and "depth" press, in the order of the pairs; none with the law "volume",
// which has one pressure for a whole pair, unless friction acts. With friction the points have its traction and their slip, with
// the current pressure even where friction is frozen.
//
// `count` becomes their number; `points` has room for `capacity`. NULL with capacity 0: only the number is returned, and the next
// call at the same coordinates does not search again.
//
// Errors: as `fmc_context_evaluate`, and `FMC_ERROR_BUFFER_TOO_SMALL`; no output is then written. Threads: one call at a time on
// a context.
fmc_status fmc_context_contact_points(fmc_context *context,
                                      const fmc_coords *coords,
                                      fmc_contact_point *points,
                                      size_t capacity,
                                      size_t *count);

// The weighted gaps at `coords` of all nodes that have a facet within `reach` of a partner, apart or overlapping, for an
// augmented Lagrangian, an interior point method or a preconditioner. They do not depend on law and estimator.
//
// Both bodies of a pair have rows, ordered by pair, side and node; a host that wants one side only takes the rows of one
// body. A body has no gaps over itself. With cells of second order rows are points, columns nodes.
//
// `count` becomes the number of rows; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned, and the
// next call at the same coordinates does not search again. The gaps are kept for `fmc_context_gap_gradient`.
//
// Errors: as `fmc_context_evaluate`, `FMC_ERROR_NOT_POSITIVE` for `reach`, and `FMC_ERROR_BUFFER_TOO_SMALL`; no output is then
// written. Threads: one call at a time on a context.
fmc_status fmc_context_gap_constraints(fmc_context *context,
                                       const fmc_coords *coords,
                                       double reach,
                                       fmc_gap_constraint *rows,
                                       size_t capacity,
                                       size_t *count);

// The derivative of the gaps of the last call, d gap / d x, in compressed rows. Row r has the entries from `row_offsets[r]` to
// `row_offsets[r + 1]`, in ascending order of their columns, which are degrees of freedom as in `fmc_context_tangent`. Offsets
// and columns count from the option `index_base`. The columns are the degrees of freedom that feel the contact. Pressures p on
// the rows act with the nodal forces sum over r of p_r times row r.
//
// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries. `row_offsets` has
// room for `offset_capacity`, `cols` and `values` for `capacity`. An array that is NULL with capacity 0 is not written: only its
// number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number does not fit into the context's
// numbers, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_gap_gradient(const fmc_context *context,
                                    void *row_offsets,
                                    size_t offset_capacity,
                                    size_t *offset_count,
                                    void *cols,
                                    double *values,
                                    size_t capacity,
                                    size_t *count);

// The tie of two bodies, indices for `fmc_context_body_resultant`, as found without deformation; for bodies that slide and do not
// separate, as found last. `fmc_context_set_pair_options` makes them. For other bodies all numbers are zero.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`; `FMC_ERROR_UNTIED` if reference coordinates that were set later
// leave no tied face; `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_tie(const fmc_context *context,
                           size_t a,
                           size_t b,
                           fmc_tie *tie);

// Traction and jump of all ties at `coords`, by pair and node of the holding side, mostly the side with the larger facets; for bodies that
// do not separate, along the normal only.
//
// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`,
// `FMC_ERROR_NO_STIFFNESS`, `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_tie_nodes(fmc_context *context,
                                 const fmc_coords *coords,
                                 fmc_tie_node *rows,
                                 size_t capacity,
                                 size_t *count);

// All ties as equations, for hosts that eliminate unknowns or use their own multipliers: sum of `values` times coordinates = 0 for
// every row, in compressed rows, a row for each axis of each of `fmc_context_tie_nodes`. Row r has the entries from `row_offsets[r]`
// to `row_offsets[r + 1]`, in ascending order of their columns, which are degrees of freedom as in `fmc_context_tangent`. Offsets and
// columns count from the option `index_base`.
//
// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries. `row_offsets` has
// room for `offset_capacity`, `cols` and `values` for `capacity`. An array that is NULL with capacity 0 is not written: only its
// number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number does not fit into the context's
// numbers. `FMC_ERROR_UNSUPPORTED` where a tie keeps a gap, since its rows then depend on the rotation of facets, and with bodies that do
// not separate. `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one
// context, as long as no call changes it.
fmc_status fmc_context_tie_constraints(const fmc_context *context,
                                       void *row_offsets,
                                       size_t offset_capacity,
                                       size_t *offset_count,
                                       void *cols,
                                       double *values,
                                       size_t capacity,
                                       size_t *count);

// Ties two parts of the surface (`fmc_context_add_surface`), each on one body, on two bodies or on one. It holds x_A - x_B = `period` +
// jump for points that face one another without deformation, after a shift of part B by `period`, `dim` numbers. `tie` becomes the number
// of the tie, 1, 2, ...; the jump is 0 at first (`fmc_context_set_tie_jump`). A body may have several.
//
// The rules of `FMC_INTERFACE_TIED` give the tied faces and the default of `reach` (0), with the stiffness of the pair's law and with
// multipliers. It changes no contact. With a period only the named facets can hide one another. No heat flows through it.
//
// With the period of a periodic cell and the jump H period the cell has the macroscopic displacement gradient H. Its stress is the sum of
// F period^T / V over the ties, with their forces F (`fmc_context_tie_force`). In a bolt with a cut across it, the jump along the axis is
// the pretension length.
//
// Errors: `FMC_ERROR_NULL_POINTER`; `FMC_ERROR_BAD_VALUE` for a surface that does not exist; `FMC_ERROR_UNTIED`; `FMC_ERROR_NOT_POSITIVE`
// for a reach; `FMC_ERROR_NON_FINITE_STIFFNESS` for a period that is not finite; `FMC_ERROR_BUSY`. `FMC_ERROR_UNSUPPORTED` for a surface
// of several bodies, for two surfaces with a common facet, for two bodies in contact whose faces coincide, and for a period along the
// radius. The same by the law "volume", without cells, and in parts. The context is then unchanged. Threads: one call at a time on a
// context.
fmc_status fmc_context_add_tie(fmc_context *context,
                               int32_t surface_a,
                               int32_t surface_b,
                               const double *period,
                               double reach,
                               int32_t *tie);

// Removes a tie of `fmc_context_add_tie`. Other ties keep their numbers.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_BUSY`. Threads: one call at a time on a
// context.
fmc_status fmc_context_remove_tie(fmc_context *context,
                                  int32_t tie);

// Sets the jump of a tie of `fmc_context_add_tie`, the distance of the first part from the second in addition to the period: `dim`
// numbers. It does not search for faces, and multipliers stay.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_NON_FINITE_STIFFNESS` for a jump that is not
// finite, `FMC_ERROR_UNSUPPORTED` for one along the radius, `FMC_ERROR_BUSY`; the old jump is then kept. Threads: one call at a time on a
// context.
fmc_status fmc_context_set_tie_jump(fmc_context *context,
                                    int32_t tie,
                                    const double *jump);

// Area, gap and reach of a tie of `fmc_context_add_tie`, as `fmc_context_tie`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_UNTIED` as `fmc_context_tie`,
// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_added_tie(const fmc_context *context,
                                 int32_t tie,
                                 fmc_tie *found);

// Force of a tie of `fmc_context_add_tie` on its first part at `coords`: the derivative of the energy by the jump. The force on the second
// part is its negative. `count` becomes `dim`; `force` has room for `capacity` numbers.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` if there is no such tie, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`,
// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_NO_STIFFNESS`, `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`. Threads: one
// call at a time on a context.
fmc_status fmc_context_tie_force(fmc_context *context,
                                 const fmc_coords *coords,
                                 int32_t tie,
                                 double *force,
                                 size_t capacity,
                                 size_t *count);

// Nothing conducts: no tables.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_conductance_init(fmc_conductance *conductance);

// Flux of heat or charge through the contact at `coords`: the integral of N h (T - T_other) dA out of every node. T is a field, and
// T_other the field at the facing point of the other side. The flux is positive if heat leaves the node, and its sum over all nodes and
// obstacles is zero. The conductance h depends on the pressure of the law. Bodies that are tied, glued or do not separate conduct where
// they are held. With axisymmetry dA is the area of rings.
//
// `fields` has `field_count` fields, one after the other, with a value for every row of `coords`; `flux` has room for as many.
// `of_obstacles` has as many fields, with a value for every obstacle, removed ones included; `obstacle_flux` has room for them. NULL for
// `of_obstacles`: there is no flux into obstacles; `obstacle_flux` may be NULL, too. With `field_count` 0 only the matrix is computed, for
// `fmc_context_flux_matrix`.
//
// Errors: as `fmc_context_evaluate`, except for friction; `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_UNSUPPORTED` for
// a mesh in parts; `FMC_ERROR_UNTIED` as `fmc_context_tie`. `FMC_ERROR_NOT_POSITIVE` for an entry of a field or table that is not finite,
// a negative entry of a table, or places that do not ascend. No output is then written. Threads: one call at a time on a context.
fmc_status fmc_context_flux(fmc_context *context,
                            const fmc_coords *coords,
                            const fmc_conductance *conductance,
                            size_t field_count,
                            const double *fields,
                            const double *of_obstacles,
                            double *flux,
                            double *obstacle_flux);

// The derivative of the flux by the field at the last `fmc_context_flux`, the same for every field, in compressed rows: symmetric,
// positive semidefinite, and independent of the field. Rows and columns are nodes, then obstacles. Row r has the entries from
// `row_offsets[r]` to `row_offsets[r + 1]`, in ascending order of their columns. Offsets and columns count from the option `index_base`.
//
// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries. `row_offsets` has
// room for `offset_capacity`, `cols` and `values` for `capacity`. An array that is NULL with capacity 0 is not written: only its
// number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number does not fit into the context's
// numbers, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_flux_matrix(const fmc_context *context,
                                   void *row_offsets,
                                   size_t offset_capacity,
                                   size_t *offset_count,
                                   void *cols,
                                   double *values,
                                   size_t capacity,
                                   size_t *count);

// The energy that friction has dissipated since the step began, as heat at nodes and obstacles: its sum is the dissipation of all pairs.
// Heat / duration of the step is a power. With cells of second order some nodes may have a negative part.
//
// `effusivities`: one for every body, then one for every obstacle, removed ones included, not negative. Each side of a pair takes a part
// of the heat in proportion to its effusivity, sqrt(conductivity * density * heat capacity); with 0 it takes none. NULL: halves. `heat`
// has room for a number for every row of `coords`, `obstacle_heat` for every obstacle; it may be NULL.
//
// Errors: as `fmc_context_evaluate`; `FMC_ERROR_NOT_POSITIVE` for an effusivity that is negative or not finite; `FMC_ERROR_UNSUPPORTED`
// for a mesh in parts. No output is then written. Threads: one call at a time on a context.
fmc_status fmc_context_friction_heat(fmc_context *context,
                                     const fmc_coords *coords,
                                     const double *effusivities,
                                     double *heat,
                                     double *obstacle_heat);

// The cohesive interface of two bodies at `coords`, indices for `fmc_context_body_resultant`.
// `fmc_context_set_pair_options` makes it. For bodies without an interface all numbers are zero.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`;
// `FMC_ERROR_UNTIED` if other reference coordinates leave no face of the interface; `FMC_ERROR_BUSY`. Threads: one call at a time on a
// context.
fmc_status fmc_context_cohesive(fmc_context *context,
                                size_t a,
                                size_t b,
                                const fmc_coords *coords,
                                fmc_cohesive *cohesive);

// All points of cohesive interfaces at `coords`, by pair, in the order of `fmc_context_damage`.
//
// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`,
// `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_cohesive_points(fmc_context *context,
                                       const fmc_coords *coords,
                                       fmc_cohesive_point *rows,
                                       size_t capacity,
                                       size_t *count);

// All points of interfaces by laws of the host at `coords`, by pair, in the order of `fmc_context_law_history`. The sums of area times
// energy are the energies of the interfaces.
//
// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`,
// `FMC_ERROR_INTERFACE_LAW`; `FMC_ERROR_UNTIED` if other reference coordinates leave no face of an interface; `FMC_ERROR_BUSY`. Threads:
// one call at a time on a context.
fmc_status fmc_context_law_points(fmc_context *context,
                                  const fmc_coords *coords,
                                  fmc_law_point *rows,
                                  size_t capacity,
                                  size_t *count);

// The boundary facets in the order in which `fmc_context_slip` has them, body after body.
//
// `count` becomes their number; `facets` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written. Threads: several
// at once on one context, as long as no call changes it.
fmc_status fmc_context_boundary_facets(const fmc_context *context,
                                       fmc_boundary_facet *facets,
                                       size_t capacity,
                                       size_t *count);

// The matrix P that takes nodes to points, X = P x, in compressed rows: point p has the entries from `row_offsets[p]` to
// `row_offsets[p + 1]`, `nodes` with their `weights`. Offsets and nodes count from the option `index_base`.
//
// Cells of second order are divided into straight ones, whose points are fixed linear combinations of the nodes.
// `fmc_boundary_facet`, `fmc_contact_side` and `fmc_gap_constraint` refer to points: their numbers, minus the option
// `index_base`, are rows. P takes nodal values to points; its transpose takes forces and other derivatives from points to nodes.
// A point that is a node, or represents a node in the middle of an edge, face or cell, has the node's number. Middles of faces
// without a node come after the nodes. The weights of a row add up to 1, and some are negative. Without cells of second order
// and hanging nodes P is the identity. With a basis (`fmc_context_set_basis`) its columns are unknowns, and its rows have the
// row sums of the basis.
//
// There are at least as many points as nodes; numbers change with a basis only. `offset_count` becomes the number of offsets, one
// more than there are points, and `count` the number of entries. `row_offsets` has room for `offset_capacity`, `nodes` and
// `weights` for `capacity`. An array that is NULL with capacity 0 is not written: only its number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written.
// Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_point_weights(const fmc_context *context,
                                     void *row_offsets,
                                     size_t offset_capacity,
                                     size_t *offset_count,
                                     void *nodes,
                                     double *weights,
                                     size_t capacity,
                                     size_t *count);

// Requests no output: all pointers are NULL.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_gradients_init(fmc_gradients *gradients);

// The derivatives of `energy` * w + `adjoint` . F at `coords`, by the variables that `gradients` names: w is the contact energy, and
// F are the nodal forces. F includes friction, w does not. `adjoint` has the shape of `coords`; NULL: zeros. A host that minimises
// J(x) with contact in equilibrium passes the solution of the adjoint system, with `energy` 0.
//
// All are exact partial derivatives: all other variables are held, including the slip at the start of the step, which has a separate
// derivative. Where two faces are equally near to a node, the depth has a kink, and the derivative is one-sided.
//
// `count` becomes the number of pairs that touch, 0 without a request for pairs; `pairs` has room for `capacity`.
//
// Errors: as `fmc_context_tangent`; `FMC_ERROR_LENGTH`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_UNKNOWN_FLAG` and
// `FMC_ERROR_BUFFER_TOO_SMALL`; for `slip_adjoint` as `fmc_context_set_slip`. `FMC_ERROR_UNSUPPORTED` for a derivative that is not known,
// never a zero. By coordinates and poses: with the law "fiber" unless patches are kept; of sampled energies unless weights are
// "consistent" and `momentum_correction` is 0. Also of forces: sampled ones, between curved faces in 3D, and frictional ones unless
// friction is frozen. By the reference: with axisymmetry, friction, curved faces, hanging nodes, ranks, and of forces with a gap offset
// between bodies. By gap offset: of frictional forces; by stiffness: of these with cohesion or a shear limit, or frozen. By slip: with
// static friction, or frozen; of the slip at the end of the step: by coordinates, poses and gap offsets. By gap offsets: of pairs other
// than bodies with half-spaces. By the coefficient of friction: where it is 0, and with static friction, cohesion or a shear limit. By
// rotations: with the law "fiber", and with axisymmetry. No output is then written. Threads: one call at a time on a context.
fmc_status fmc_context_vjp(fmc_context *context,
                           const fmc_coords *coords,
                           double energy,
                           const fmc_coords *adjoint,
                           const fmc_gradients *gradients,
                           fmc_pair_gradient *pairs,
                           size_t capacity,
                           size_t *count);

// All rates 0.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_directions_init(fmc_directions *directions);

// Rates of energy and nodal forces at `coords` along rates of their variables: the transpose of `fmc_context_vjp`. With the same
// parameters moved by d, energy * `energy` + adjoint . `forces` here is d times the derivatives there. The energy does not include
// friction; the slip at the start of the step changes only with the rate in `directions`.
//
// `energy` becomes the rate of the contact energy; `forces` has room for n * dim numbers, the rates of the force on every node in dense
// rows. Either may be NULL.
//
// Errors: as `fmc_context_vjp` with an adjoint, for all variables with a rate; `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_STIFFNESS` with
// the place of a rate, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`; `FMC_ERROR_INDEX_OUT_OF_RANGE` for a pair that does not exist;
// for `slip` as `fmc_context_set_slip`. There are no rates along coordinates without deformation. No output is then written. Threads: one
// call at a time on a context.
fmc_status fmc_context_jvp(fmc_context *context,
                           const fmc_coords *coords,
                           const fmc_directions *directions,
                           double *energy,
                           double *forces);

// Derivatives of a number J(x, F) of an equilibrium by its parameters, F being the contact forces on nodes. It takes two calls, and one
// linear solve of the host between them. R are internal minus external forces, K = dR/dx, T is the contact's full tangent and a = dJ/dF.
// The adjoint b is zero at unknowns that are not free, and solves (K + T)^T b = dJ/dx - T^T a in the free rows.
//
// With `balance` NULL `right` becomes dJ/dx - T^T a. With `balance` = b, the arrays of `gradients` become total derivatives of J, as
// `fmc_context_vjp` writes them, and `right` becomes dJ/dx - T^T (a + b). Minus K^T b it is the derivative by the value of an unknown that
// is not free. The host's part of dJ/dp is -b . dR/dp; a load has the derivative b. `coords` of `gradients` is the derivative by
// additional motions of the nodes, x held.
//
// `problem`: the unknowns as for `fmc_equilibrium_new`, its `x` the equilibrium, found by any solver; `prescribed` is not read. `by_x`:
// dJ/dx, `unknown_count` numbers, also of unknowns that are not free. `by_forces`: dJ/dF, `row_count * dim` numbers by row; NULL for
// zeros. `right` has room for `unknown_count` numbers, or is NULL. `gradients` NULL: only `right` is written. `pairs`, `capacity` and
// `count` as for `fmc_context_vjp`.
//
// Errors: as `fmc_equilibrium_new` for the problem and as `fmc_context_vjp` with an adjoint; `FMC_ERROR_NON_FINITE_STIFFNESS` with the
// place in an array. `FMC_ERROR_UNSUPPORTED` with multipliers, which the search sets if it found the stiffness or a `penetration` was
// given; with friction; for `slip` and `slip_adjoint`. No output is then written. Threads: one call at a time on a context.
fmc_status fmc_equilibrium_adjoint(fmc_context *context,
                                   const fmc_equilibrium_problem *problem,
                                   const double *by_x,
                                   const double *by_forces,
                                   const double *balance,
                                   double *right,
                                   const fmc_gradients *gradients,
                                   fmc_pair_gradient *pairs,
                                   size_t capacity,
                                   size_t *count);

// ---- Wear ------------------------------------------------------------------------------------------------

// Sets wear of a pair by Archard's law: `a` that slides by |ds| under the pressure p loses `wear_a` p |ds| of its depth, and `b` loses
// `wear_b` p |ds|. Both are dimensionless wear coefficient / hardness, in 1/pressure, and at least 0; 0, the default: that side does not
// wear. Obstacles never wear. With the laws "depth" and "fiber". Partners are named as in `fmc_context_set_pair_options`, and all other
// options of the pair stay.
//
// Surfaces wear in `fmc_context_commit_step` alone. Contact then sees the surface recessed by the worn depth; the host's nodes and strains
// stay. The depth at a node is int N K p |s| dA / int N dA, N being its shape function, so that the body loses the integral of K p |s| dA.
// With friction the slip counts without its elastic part; without friction all slip since `fmc_context_begin_step` counts.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`,
// `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_NOT_POSITIVE` for a number that is negative or not finite, `FMC_ERROR_BUSY`.
// `FMC_ERROR_UNSUPPORTED` for wear of an obstacle, of a body with itself, by the law "volume", of bodies that are held together or never
// slide, and of a mesh in parts. The earlier coefficients are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_pair_wear(fmc_context *context,
                                     int32_t a_kind,
                                     size_t a,
                                     int32_t b_kind,
                                     size_t b,
                                     double wear_a,
                                     double wear_b);

// Wear coefficients of a pair, as set by `fmc_context_set_pair_wear`; zeros by default.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`,
// `FMC_ERROR_BAD_VALUE` for an unknown kind, `FMC_ERROR_UNSUPPORTED` for two obstacles, `FMC_ERROR_BUSY`; no output is then
// written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_pair_wear(const fmc_context *context,
                                 int32_t a_kind,
                                 size_t a,
                                 int32_t b_kind,
                                 size_t b,
                                 double *wear_a,
                                 double *wear_b);

// Worn depth of surfaces (`fmc_context_set_pair_wear`), a length for every node, in the order of `fmc_context_nodal_contact`; 0 at first.
//
// `count` becomes their number; `depth` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_NO_STEP` after `fmc_context_set_worn_facets` before
// `fmc_context_begin_step`, `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`; no output is then written. Threads: several
// at once on one context, as long as no call changes it.
fmc_status fmc_context_worn_depth(const fmc_context *context,
                                  double *depth,
                                  size_t capacity,
                                  size_t *count);

// Volume that every body has lost by wear, in 2D per unit thickness, with axisymmetry the volume of rings. It is the integral of K p |s|
// dA over all accepted steps.
//
// `count` becomes the number of bodies; `volumes` has room for `capacity`. NULL with capacity 0: only the number is
// returned.
//
// Errors: as `fmc_context_worn_depth`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_worn_volumes(const fmc_context *context,
                                    double *volumes,
                                    size_t capacity,
                                    size_t *count);

// State of wear, for a restart: a row for every worn facet and each of the points that move it. A row is 4 numbers: facet, node,
// depth against the normal of the facet, and volume. The facet is its place in `fmc_context_boundary_facets`. With cells of second
// order the node is a point (`fmc_context_point_weights`). Both count always from 0. Rows ascend by facet and point.
//
// `count` becomes their number; `worn` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once
// on one context, as long as no call changes it.
fmc_status fmc_context_worn_facets(const fmc_context *context,
                                   double *worn,
                                   size_t capacity,
                                   size_t *count);

// Sets the state of wear: `count` numbers, in rows as `fmc_context_worn_facets` writes them. Facets without a row are not worn. Pass no
// rows after the host has moved its nodes to the worn surface. For a restart call it before `fmc_context_begin_step` and
// `fmc_context_set_slip`: the results are bit-for-bit identical to the unbroken run.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` where the last row is not whole, `FMC_ERROR_INDEX_OUT_OF_RANGE` for a row that
// names a facet that does not exist, a point that does not move it, or both twice. `FMC_ERROR_NOT_POSITIVE` for a depth or volume that is
// negative or not finite, `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`. The old state is then kept. Threads: one call at
// a time on a context.
fmc_status fmc_context_set_worn_facets(fmc_context *context,
                                       const double *worn,
                                       size_t count);

// Sets how many cycles each step represents from now on, 1 at first: the wear of a step is multiplied by this number. Wear is explicit,
// and surfaces do not change within a step: `FMC_WARNING_LARGE_WEAR` reports too many cycles.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE` unless positive and finite, `FMC_ERROR_BUSY`. Threads: one call at a time on
// a context.
fmc_status fmc_context_set_wear_cycles(fmc_context *context,
                                       double cycles);

// ---- Restart ---------------------------------------------------------------------------------------------

// The elastic slip carried into the step: a row for every facet with slip and each body or obstacle that it faced. A restart needs it,
// and the coordinates and poses at which the step began. Call `fmc_context_begin_step` there, then `fmc_context_set_slip`: the results
// are bit-for-bit identical to the unbroken run.
//
// A row is 8 numbers. The first is the facet, by its place in `fmc_context_boundary_facets` always from 0. Then follow the kind of
// its partner, a value of `fmc_partner`, and the partner's index for `fmc_context_body_resultant` or
// `fmc_context_obstacle_resultant`; then 1 where the facet's body is the second side of that pair, else 0. The last four are the
// slip of the facet, three lengths, in 2D the last 0, and the slip since it rested, with `static_coefficient`, else 0. Rows ascend
// by facet, partner and side.
//
// `count` becomes their number; `slip` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then
// written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_slip(const fmc_context *context,
                            double *slip,
                            size_t capacity,
                            size_t *count);

// Sets the elastic slip carried into the current step: `count` numbers, in rows as `fmc_context_slip` writes them. Facets
// without a row have none.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_LENGTH` where the last row is not whole.
// `FMC_ERROR_INDEX_OUT_OF_RANGE` for a row that names a facet or a partner that does not exist, that occurs twice, or that is not valid.
// `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_NON_FINITE_SLIP`, `FMC_ERROR_BUSY`; the old slip is then kept. Threads: one call at a time on a
// context.
fmc_status fmc_context_set_slip(fmc_context *context,
                                const double *slip,
                                size_t count);

// The history of the host's laws of friction after the accepted steps (`fmc_context_commit_step`). For each row of `fmc_context_slip`, in
// its order, it has as many numbers as the law of its pair, none without a law. A restart needs it and the slip.
//
// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUSY`; no output is then written.
// Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_friction_history(const fmc_context *context,
                                        double *history,
                                        size_t capacity,
                                        size_t *count);

// Sets this history, for a restart: `count` numbers, as `fmc_context_friction_history` writes them. Call it after `fmc_context_set_slip`
// with the rows to which they belong.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a number that is not
// finite, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUSY`; the old history is then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_friction_history(fmc_context *context,
                                            const double *history,
                                            size_t count);

// State of all points of cohesive interfaces after the accepted steps (`fmc_context_commit_step`), in the order of
// `fmc_context_cohesive_points`. Each point has two numbers: its damage, 0 to 1, and its dissipated energy per area. A restart needs
// it and the coordinates, and with friction or viscosity also `fmc_context_cohesive_history`.
//
// `count` becomes their number; `damage` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`; no
// output is then written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_damage(const fmc_context *context,
                              double *damage,
                              size_t capacity,
                              size_t *count);

// Sets this state: `count` numbers, as `fmc_context_damage` writes them, for a restart, or for an initially damaged interface. A damage of
// 1 is a crack.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a damage outside 0 to 1 or a
// negative energy, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old damage is then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_damage(fmc_context *context,
                                  const double *damage,
                                  size_t count);

// Further state of these points, five numbers for each. Two are the slip of the broken part, as multiples of the two edges at the first
// corner of the facet of `partner`. Two are the energies per area that friction and the viscosity have dissipated. The last is the
// loading of the point when the step began, sqrt(Y / Y0), which corresponds to more than its damage while the viscosity delays damage.
// All are 0 without friction and viscosity. A restart sets them with the damage.
//
// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_cohesive`, `FMC_ERROR_BUSY`; no
// output is then written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_cohesive_history(const fmc_context *context,
                                        double *history,
                                        size_t capacity,
                                        size_t *count);

// Sets this state: `count` numbers, as `fmc_context_cohesive_history` writes them, for a restart.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a number that is not finite or a
// negative energy of the viscosity, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old history is then kept. Threads: one call at a time on a
// context.
fmc_status fmc_context_set_cohesive_history(fmc_context *context,
                                            const double *history,
                                            size_t count);

// Sets the duration of the current step and of all later ones, for the viscosity of cohesive interfaces. Without this call an evaluation
// with a viscosity fails.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_set_time_step(fmc_context *context,
                                     double time_step);

// The history of all points of interfaces by laws of the host after the accepted steps (`fmc_context_commit_step`), in the order of
// `fmc_context_law_points`: as many numbers for each as its law has. A restart needs it and the coordinates.
//
// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_law_points`, `FMC_ERROR_BUSY`;
// no output is then written. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_law_history(const fmc_context *context,
                                   double *history,
                                   size_t capacity,
                                   size_t *count);

// Sets this history: `count` numbers, as `fmc_context_law_history` writes them, for a restart.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a number that is not
// finite, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old history is then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_law_history(fmc_context *context,
                                       const double *history,
                                       size_t count);

// The multipliers, ascending by node and partner. A restart, or a repeated load step, needs them and the coordinates.
//
// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: several at once on one
// context, as long as no call changes it.
fmc_status fmc_context_multipliers(const fmc_context *context, fmc_multiplier *rows, size_t capacity, size_t *count);

// Sets the multipliers, `count` structs as `fmc_context_multipliers` writes them; none: surfaces are no longer shifted.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_NODE_OUT_OF_RANGE`, `FMC_ERROR_BAD_VALUE` for a kind of
// partner that does not exist, `FMC_ERROR_NOT_POSITIVE` for an invalid shift or direction, `FMC_ERROR_UNSUPPORTED` as
// `fmc_context_augment`, `FMC_ERROR_BUSY`; the old multipliers are then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_multipliers(fmc_context *context,
                                       const fmc_multiplier *rows,
                                       size_t count);

// ---- Ranks, and a mesh in parts --------------------------------------------------------------------------

// Sends bytes to all ranks, this one too, and receives theirs: rank r sends `counts[r]` bytes, and `received` gets the bytes
// of all ranks, one after the other. `user` is the pointer given with the function. `fmc_mpi.h` implements it by
// MPI_Allgatherv.
//
// Return 0; any other value makes the evaluation fail with `FMC_ERROR_COMMUNICATION`. It is called on the thread that evaluates,
// in the same order on all ranks. It must not call a function of the same context, throw, or jump out.
typedef int32_t (*fmc_all_gather)(void *user, const void *send, const uint64_t *counts, void *received);

// Sends bytes to every rank, this one too, and receives their bytes for this rank: `send` has `send_counts[r]` bytes for rank r, one
// rank after the other, and `received` gets `received_counts[r]` of rank r. `user` is the pointer given with the function.
// `fmc_mpi.h` implements it by MPI_Alltoallv.
//
// Return 0; any other value makes the call of the library fail with `FMC_ERROR_COMMUNICATION`. The rules of `fmc_all_gather` apply.
typedef int32_t (*fmc_all_to_all)(void *user,
                                  const void *send,
                                  const uint64_t *send_counts,
                                  void *received,
                                  const uint64_t *received_counts);

// Ranks of a parallel program, as the host's message passing library has them. Initialise it with `fmc_communicator_init`.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Set by `fmc_communicator_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Number of this rank, from 0, and of all ranks, at least 1.
  int32_t rank;
  int32_t size;
  // Moves bytes.
  fmc_all_gather all_gather;
  // Handed to the functions.
  void *user;
  // Moves bytes to single ranks. It may be NULL, on all ranks; `all_gather` then sends these bytes to all ranks. With a mesh in
  // parts it sends faces between ranks to the ranks that may have the other side.
  fmc_all_to_all all_to_all;
  // Zero. Room for functions of later versions.
  uint64_t reserved[5];
} fmc_communicator;

// Work of this rank since the communicator was set; `item_count` is the total of all ranks.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Facets, bundles of lines, pieces of cells and pairs of facets that were divided among the ranks.
  uint64_t item_count;
  // Items that this rank measured.
  uint64_t own_item_count;
  // Calls of the communicator.
  uint64_t call_count;
  // Bytes that this rank sent, and received, its own too.
  uint64_t sent_bytes;
  uint64_t received_bytes;
  // Zero.
  uint64_t reserved[4];
} fmc_rank_counts;

// The cells of one rank, with their nodes. Every cell of the mesh is given by one rank, and only by that one; nodes between
// ranks are given by all that have a cell there. A rank may have none. Initialise it with `fmc_mesh_part_init`, then set all fields.
typedef struct {
  // Set by `fmc_mesh_part_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Coordinates of the rank's own nodes without deformation.
  fmc_coords coords;
  // Bytes of a number in the lists here and in the blocks, 4 or 8, and in all lists of the context; the same on all ranks.
  int32_t index_size;
  // Zero. Room for switches of later versions.
  int32_t reserved_flags;
  // Number of each in the whole mesh, counted from the option `index_base`, the same on all ranks that have it. Results are
  // identical to one rank whose mesh has its nodes in the order of these numbers, which may have gaps.
  const void *node_numbers;
  // Cells, of own nodes counted from the option `index_base`.
  const fmc_cell_block *blocks;
  // Number of blocks.
  size_t block_count;
  // Number of each cell in the whole mesh, over all blocks, counted from the option `index_base`. Results are identical to a mesh with
  // its cells in the order of these numbers.
  const void *cell_numbers;
  // Body of each cell, as all ranks name it.
  const void *body_ids;
  // Largest `reach` of `fmc_context_gap_constraints`; 0 if it is not called.
  double reach;
  // Zero. Room for later versions.
  uint64_t reserved[4];
} fmc_mesh_part;

// Elastic slip of a boundary facet against one of the bodies and obstacles that it faced, by the numbers of the whole mesh.
typedef struct {
  // Number of its cell in the whole mesh, counted from the option `index_base`.
  int64_t cell;
  // Face of that cell, as VTK counts them, always from 0.
  int32_t face;
  // Which of the facets of that face, from 0.
  int32_t part;
  // Kind of its partner: a value of `fmc_partner`.
  int32_t partner_kind;
  // 1 where the facet's body is the second side of that pair, else 0.
  int32_t is_second;
  // Index of the partner for `fmc_context_body_resultant` or `fmc_context_obstacle_resultant`.
  size_t partner;
  // Elastic slip of the facet, a length; in 2D the last is 0.
  double slip[3];
  // Slip since it rested, with `static_coefficient`, else 0; a length.
  double slid;
} fmc_carried_slip;

// Gathered part of a mesh in parts: the same on all ranks, except for the own cells.
//
// New fields take the place of reserved ones; the size of the struct does not change.
typedef struct {
  // Size of this struct, as the library wrote it.
  size_t struct_size;
  // Nodes and cells that every rank has.
  uint64_t node_count;
  uint64_t cell_count;
  // Boundary facets that every rank has, and boundary facets of the whole mesh.
  uint64_t facet_count;
  uint64_t whole_facet_count;
  // Cells that this rank gave.
  uint64_t own_cell_count;
  // Number of times that cells were gathered.
  uint64_t gather_count;
  // Zero.
  uint64_t reserved[4];
} fmc_gathered_counts;

// Sets a communicator of one rank without a function.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_communicator_init(fmc_communicator *communicator);

// Shares the work of the context's evaluations with other ranks; NULL ends this. The struct is copied. From then on all
// ranks make the same calls on their contexts with the same coordinates, options, obstacles and history. Each gets the
// whole result, bit-for-bit identical to one rank, for any number of ranks. The number of threads may differ. Ranks divide
// the measuring of facets, lines and cells; every rank measures pairs with a signed distance function. If there is too
// little work to share, every rank does all.
//
// An evaluation that fails on one rank fails on all, with `FMC_ERROR_ON_OTHER_RANK` there. If ranks were given different data,
// all return `FMC_ERROR_RANKS_DIFFER`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_RANK`, `FMC_ERROR_BUSY`. Threads:
// one call at a time on a context.
fmc_status fmc_context_set_communicator(fmc_context *context,
                                        const fmc_communicator *communicator);

// Work of this rank since the communicator was set; zeros without a communicator.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: any number at once.
fmc_status fmc_context_rank_counts(const fmc_context *context, fmc_rank_counts *counts);

// Sets a part to one without nodes and cells.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_mesh_part_init(fmc_mesh_part *part);

// Makes a context of a mesh of which this rank has a part; all ranks call it together. Then every rank has its own cells and all
// cells that may be in contact. `fmc_context_set_coords` takes the coordinates of the own nodes. After it all ranks call the
// other functions of the context together, as with a whole mesh, with the nodes that `fmc_context_gathered_nodes` names, and
// share the work. Results are bit-for-bit identical to one rank with the whole mesh, for any number of ranks.
//
// Nodes in planes of symmetry are given as own nodes; call `fmc_context_set_coords` again after it. A body that may touch itself, and
// one that by the law `FMC_LAW_DEPTH` or with friction meets an obstacle with facets, is gathered whole. Hanging nodes, another
// reference, a basis, and another communicator are refused. It begins at the coordinates of the part.
//
// Errors: as `fmc_context_new_from_cells` and `fmc_context_set_communicator`, naming own nodes and cells; `FMC_ERROR_ON_OTHER_RANK`
// if it failed on another rank. Threads: any, also at once.
fmc_status fmc_context_new_from_part(int32_t dim,
                                     const fmc_communicator *communicator,
                                     const fmc_mesh_part *part,
                                     const fmc_options *options,
                                     fmc_context **context);

// Sets the coordinates of a mesh in parts: `coords` are the coordinates of this rank's own nodes, as many as were given to
// `fmc_context_new_from_part`. Every rank calls it before it evaluates at these coordinates, after its options and obstacles
// were set. The context then has the gathered nodes, facets and cells: all that may be in contact, the same on all ranks.
// `fmc_context_gathered_nodes` returns their numbers and coordinates.
//
// `renumbered`, which may be NULL, becomes 1 where other cells were gathered than before, so that their numbers have changed,
// else 0. Slip, kept patches and frozen friction are transferred; tangents, patterns and points of the last evaluation are not.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_STRIDE`, `FMC_ERROR_UNSUPPORTED`; naming own nodes and cells
// `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_INVERTED_CELL`, `FMC_ERROR_ZERO_MEASURE`; `FMC_ERROR_RANKS_DIFFER` for a node in two
// places, `FMC_ERROR_ON_OTHER_RANK`, `FMC_ERROR_COMMUNICATION`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
fmc_status fmc_context_set_coords(fmc_context *context,
                                  const fmc_coords *coords,
                                  int32_t *renumbered);

// Sets the elastic slip carried into the current step, for a mesh in parts: `count` facets, as
// `fmc_context_carried_slip` writes them; all other facets have zero slip. All ranks pass the same list, after
// `fmc_context_begin_step`.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_NON_FINITE_SLIP`, `FMC_ERROR_UNSUPPORTED` for a facet that was not
// gathered, `FMC_ERROR_BUSY`; the old slip is then kept. Threads: one call at a time on a context.
fmc_status fmc_context_set_carried_slip(fmc_context *context,
                                        const fmc_carried_slip *carried,
                                        size_t count);

// Sizes of the gathered part of a mesh in parts.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_UNSUPPORTED` for a context of a whole mesh, `FMC_ERROR_BUSY`. Threads: several at once
// on one context, as long as no call changes it.
fmc_status fmc_context_gathered_counts(const fmc_context *context,
                                       fmc_gathered_counts *counts);

// The gathered nodes, in the order in which the context counts them. `numbers` are their numbers in the whole mesh, ascending.
// `own_nodes` are their places among this rank's own nodes, -1 for a node that only other ranks have. Both count from the
// option `index_base`. `coords` are their coordinates, `dim` numbers each in dense rows. Each may be NULL, and has room for
// `capacity` nodes; `count` becomes their number. All three NULL with capacity 0: only the number is returned. Evaluations are
// at these coordinates; forces, rows and columns refer to these nodes.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_MISALIGNED_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNSUPPORTED`,
// `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
fmc_status fmc_context_gathered_nodes(const fmc_context *context,
                                      void *numbers,
                                      void *own_nodes,
                                      double *coords,
                                      size_t capacity,
                                      size_t *count);

// The numbers in the whole mesh of the cells gathered, ascending, counted from the option `index_base`. `count` becomes their number;
// `numbers` has room for `capacity`. NULL with capacity 0: only the number is returned.
//
// Errors: as `fmc_context_gathered_nodes`. Threads: as there.
fmc_status fmc_context_gathered_cells(const fmc_context *context,
                                      void *numbers,
                                      size_t capacity,
                                      size_t *count);

// The elastic slip carried into the step, of all facets of a mesh in parts with slip: the same list on all ranks, ascending by cell,
// face and part. `count` becomes its length; `carried` has room for `capacity`. NULL with capacity 0: only the length is returned. A
// restart, on any number of ranks, needs it and the coordinates and poses at which the step began.
//
// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNSUPPORTED`, `FMC_ERROR_BUSY`. Threads:
// several at once on one context, as long as no call changes it.
fmc_status fmc_context_carried_slip(const fmc_context *context,
                                    fmc_carried_slip *carried,
                                    size_t capacity,
                                    size_t *count);

// ---- Free a context --------------------------------------------------------------------------------------

// Frees a context and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL.
//
// Errors: none. Threads: no other call on the context may be running or follow.
fmc_status fmc_context_free(fmc_context **context);

// ---- All in one call, without a context ------------------------------------------------------------------

// A step with friction, for `fmc_contact_force`, which does not write into it. `fmc_friction_step_init` sets the optional fields.
//
// The host keeps the slip that is carried into the next step, and discards the slip of a rejected step.
typedef struct {
  // Set by `fmc_friction_step_init`, so that the library recognises an uninitialised struct.
  size_t struct_size;
  // Coordinates at which the step began, (node_count, dim).
  const double *start;
  // Coordinates without deformation, (node_count, dim), from which the law "depth" measures its depths; NULL, the
  // default: `start`.
  const double *reference;
  // Elastic slip that was carried into the step, in rows of 8 numbers, as `fmc_context_slip` writes them; NULL, the default: none.
  const double *slip;
  // Numbers in `slip`; 0, the default: none.
  size_t slip_count;
  // Receives the elastic slip for the next step, in such rows, if the host accepts the end of this one; may be `slip`
  // itself. NULL, the default: no output.
  double *next_slip;
  // Numbers for which `next_slip` has room.
  size_t next_slip_capacity;
  // Receives their number; NULL, the default: no output. With `next_slip` NULL and no capacity only the number is
  // returned.
  size_t *next_slip_count;
  // Zero. Room for later versions.
  uint64_t reserved[8];
} fmc_friction_step;

// Sets every field to its default.
//
// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
fmc_status fmc_friction_step_init(fmc_friction_step *step);

// Contact forces between the bodies of a mesh, in one call.
//
// `dim` is 2 or 3; `coords`, (node_count, dim), are the coordinates of all nodes; `blocks` are the cells, in one block for each
// type. `body_ids`, one for every cell counted over the blocks, may be NULL: bodies are the connected components by faces. `options`
// must have been initialised and have `stiffness` set. `step` may be NULL; with friction it gives the start of the step that ends at
// `coords`, and receives the elastic slip for the next step.
//
// `forces`, (node_count, dim), receives the force on every node, which pushes bodies apart; `volume`, which may be NULL, the
// overlap volume (2D: area), summed over the pairs. All are written only on success. The result is bit-for-bit identical to a
// context. With a step this is a context made at `step->reference`, followed by `fmc_context_begin_step`, `fmc_context_set_slip`,
// `fmc_context_evaluate` and `fmc_context_commit_step`. A context finds the boundary facets once for many evaluations, accepts
// strides and obstacles, and reports forces per body, pairs and warnings.
//
// Errors: as `fmc_context_new_from_cells`, `fmc_context_evaluate`, and with a step the calls above; with friction and without a step
// `FMC_ERROR_NO_STEP`. `fmc_last_error` returns the text, with the offending indices. Threads: any, also at once.
fmc_status fmc_contact_force(int32_t dim,
                             const double *coords,
                             size_t node_count,
                             const fmc_cell_block *blocks,
                             size_t block_count,
                             const void *body_ids,
                             const fmc_options *options,
                             const fmc_friction_step *step,
                             double *forces,
                             double *volume);

#ifdef __cplusplus
}  // extern "C"
#endif

#endif  // FMC_CONTACT_H
