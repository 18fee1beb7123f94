"""Structs and enumerations of ``include/fmc_contact.h``, under the names that they have there."""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Structure, c_double, c_int32, c_int64, c_size_t, c_ssize_t, c_uint64, c_void_p

ABI_VERSION = 2
"""``FMC_ABI_VERSION`` of the header that these tables were written from."""

FMC_ADD = 1
FMC_SEMIDEFINITE = 2
FMC_BLOCKS = 4
FMC_OBSTACLES = 8
FMC_FROM_ONE = 16
FMC_SYMMETRIC = 32
FMC_LAW_OF_CONTEXT = -1
FMC_FRICTION_OF_CONTEXT = -1

CELL_TYPES = {
    "triangle": 5,
    "quad": 9,
    "tetra": 10,
    "hexahedron": 12,
    "wedge": 13,
    "pyramid": 14,
    "triangle6": 22,
    "quad8": 23,
    "tetra10": 24,
    "hexahedron20": 25,
    "wedge15": 26,
    "pyramid13": 27,
    "quad9": 28,
    "hexahedron27": 29,
}
"""Values of ``fmc_cell_type`` by the names of meshio."""

CELL_NODES = {
    "triangle": 3,
    "quad": 4,
    "tetra": 4,
    "hexahedron": 8,
    "wedge": 6,
    "pyramid": 5,
    "triangle6": 6,
    "quad8": 8,
    "quad9": 9,
    "tetra10": 10,
    "hexahedron20": 20,
    "hexahedron27": 27,
    "wedge15": 15,
    "pyramid13": 13,
}
CELL_DIMENSION = {name: 2 if name.startswith(("triangle", "quad")) else 3 for name in CELL_TYPES}

FACET_TYPES = {"line": 3, "triangle": 5, "quad": 9, "line3": 21, "triangle6": 22, "quad8": 23, "quad9": 28}
"""Values of ``fmc_facet_type`` by the names of meshio."""

FACET_NODES = {"line": 2, "triangle": 3, "quad": 4, "line3": 3, "triangle6": 6, "quad8": 8, "quad9": 9}
FACET_DIMENSION = {name: 2 if name.startswith("line") else 3 for name in FACET_TYPES}

CHOICES = {
    "law": {0: "volume", 1: "fiber", 2: "depth"},
    "estimator": {0: "fibers", 1: "exact", 2: "auto"},
    "pattern": {0: "lines", 1: "isotropic"},
    "weights": {0: "balance", 1: "consistent"},
}
"""Options that take one of a few values: names by number."""

SHAPES = (
    "half_space",
    "ball",
    "cuboid",
    "cylinder",
    "cone",
    "capsule",
    "polytope",
    "convex_hull",
    "height_field",
    "compound",
    "signed_distance",
)
"""Names of ``fmc_shape``, in the order of its values."""

PARTNERS = {0: "body", 1: "obstacle"}
STEP_STATES = {0: "converged", 1: "outside", 2: "not_converged"}
"""Values of ``fmc_contact_step_state``."""
WARNINGS = {
    1: "coarse_fibers",
    2: "unresolved_overlap",
    3: "swallowed_body",
    4: "patch_left_out",
    5: "unbalanced",
    6: "flush_faces",
}


class fmc_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("stiffness", c_double),
        ("exponent", c_double),
        ("spacing", c_double),
        ("fiber_length", c_double),
        ("fiber_count", c_uint64),
        ("seed", c_uint64),
        ("law", c_int32),
        ("estimator", c_int32),
        ("pattern", c_int32),
        ("weights", c_int32),
        ("momentum_correction", c_int32),
        ("self_contact", c_int32),
        ("check_cells", c_int32),
        ("threads", c_int32),
        ("index_base", c_int32),
        ("axisymmetric", c_int32),
        ("smoothing_length", c_double),
        ("friction_coefficient", c_double),
        ("friction_stiffness", c_double),
        ("cohesion", c_double),
        ("shear_limit", c_double),
        ("memoryless_slip", c_double),
        ("reserved", c_uint64 * 10),
    ]


class _View(Structure):
    _fields_ = [
        ("data", c_void_p),
        ("node_count", c_size_t),
        ("node_stride", c_ssize_t),
        ("axis_stride", c_ssize_t),
    ]


class fmc_coords(_View):
    pass


class fmc_forces(_View):
    pass


class _CellBlock(Structure):
    _fields_ = [("cell_type", c_int32), ("conn", c_void_p), ("cell_count", c_size_t)]


class fmc_cell_block(_CellBlock):
    pass


class fmc_cell_block_i64(_CellBlock):
    pass


class _FacetBlock(Structure):
    _fields_ = [("facet_type", c_int32), ("conn", c_void_p), ("facet_count", c_size_t)]


class fmc_facet_block(_FacetBlock):
    pass


class fmc_facet_block_i64(_FacetBlock):
    pass


class fmc_result(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("volume", c_double),
        ("volume_standard_error", c_double),
        ("energy", c_double),
        ("contact_area", c_double),
        ("penetration", c_double),
        ("fiber_count", c_size_t),
        ("crossing_count", c_size_t),
        ("facet_count", c_size_t),
        ("pair_count", c_size_t),
        ("body_count", c_size_t),
        ("obstacle_count", c_size_t),
        ("warning_count", c_size_t),
        ("friction_energy", c_double),
        ("friction_dissipation", c_double),
        ("stick_area", c_double),
        ("slip_area", c_double),
        ("largest_slip", c_double),
        ("reserved", c_uint64 * 3),
    ]


class fmc_resultant(Structure):
    _fields_ = [
        ("id", c_int64),
        ("force", c_double * 3),
        ("moment", c_double * 3),
        ("node_count", c_size_t),
        ("friction", c_double * 3),
        ("reserved", c_uint64 * 4),
    ]


class fmc_pair(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("a_kind", c_int32),
        ("b_kind", c_int32),
        ("a", c_size_t),
        ("b", c_size_t),
        ("volume", c_double),
        ("volume_standard_error", c_double),
        ("energy", c_double),
        ("pressure", c_double),
        ("contact_area", c_double),
        ("penetration", c_double),
        ("spacing", c_double),
        ("friction_energy", c_double),
        ("friction_dissipation", c_double),
        ("stick_area", c_double),
        ("slip_area", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_pair_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("stiffness", c_double),
        ("exponent", c_double),
        ("smoothing_length", c_double),
        ("gap_offset", c_double),
        ("friction_coefficient", c_double),
        ("law", c_int32),
        ("excluded", c_int32),
        ("reserved", c_uint64 * 10),
    ]


class fmc_contact_side(Structure):
    _fields_ = [
        ("kind", c_int32),
        ("node_count", c_int32),
        ("index", c_size_t),
        ("cell", c_int64),
        ("nodes", c_int64 * 8),
        ("weights", c_double * 8),
        ("position", c_double * 3),
    ]


class fmc_contact_point(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("patch", c_size_t),
        ("position", c_double * 3),
        ("normal", c_double * 3),
        ("gap", c_double),
        ("pressure", c_double),
        ("area", c_double),
        ("friction", c_double * 3),
        ("slip", c_double * 3),
        ("sliding", c_double),
        ("sides", fmc_contact_side * 2),
        ("reserved", c_uint64 * 8),
    ]


class fmc_boundary_facet(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("body", c_size_t),
        ("cell", c_int64),
        ("given", c_int64),
        ("local_face", c_int32),
        ("node_count", c_int32),
        ("nodes", c_int64 * 4),
        ("reserved", c_uint64 * 4),
    ]


class fmc_friction_step(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("start", POINTER(c_double)),
        ("reference", POINTER(c_double)),
        ("slip", POINTER(c_double)),
        ("next_slip", POINTER(c_double)),
        ("slip_length", c_size_t),
        ("facet_count", c_size_t),
        ("reserved", c_uint64 * 8),
    ]


ALL_GATHER = CFUNCTYPE(c_int32, c_void_p, c_void_p, POINTER(c_uint64), c_void_p)
"""``fmc_all_gather``."""


ALL_TO_ALL = CFUNCTYPE(c_int32, c_void_p, c_void_p, POINTER(c_uint64), c_void_p, POINTER(c_uint64))
"""``fmc_all_to_all``."""


class fmc_communicator(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("rank", c_int32),
        ("size", c_int32),
        ("all_gather", ALL_GATHER),
        ("user", c_void_p),
        ("all_to_all", ALL_TO_ALL),
        ("reserved", c_uint64 * 5),
    ]


class fmc_rank_counts(Structure):
    _fields_ = [
        ("item_count", c_uint64),
        ("own_item_count", c_uint64),
        ("call_count", c_uint64),
        ("sent_bytes", c_uint64),
        ("received_bytes", c_uint64),
    ]


class fmc_mesh_part(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("coords", fmc_coords),
        ("node_numbers", POINTER(c_int64)),
        ("blocks", POINTER(fmc_cell_block)),
        ("block_count", c_size_t),
        ("cell_numbers", POINTER(c_int64)),
        ("body_ids", POINTER(c_int32)),
        ("reach", c_double),
    ]


class fmc_carried_slip(Structure):
    _fields_ = [("cell", c_int64), ("face", c_int32), ("part", c_int32), ("slip", c_double * 3)]


class fmc_gathered_counts(Structure):
    _fields_ = [
        ("node_count", c_uint64),
        ("cell_count", c_uint64),
        ("facet_count", c_uint64),
        ("whole_facet_count", c_uint64),
        ("own_cell_count", c_uint64),
        ("gather_count", c_uint64),
    ]


class fmc_contact_step_options(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("tolerance", c_double),
        ("goal", c_double),
        ("full_below", c_double),
        ("most_iterations", c_int32),
        ("most_trials", c_int32),
        ("penetration", c_double),
        ("reach", c_double),
        ("most_updates", c_int32),
        ("soft_start", c_int32),
        ("reserved", c_uint64 * 5),
    ]


class fmc_contact_step_result(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("state", c_int32),
        ("iterations", c_int32),
        ("evaluation_count", c_size_t),
        ("outside_count", c_size_t),
        ("residual_at_start", c_double),
        ("residual", c_double),
        ("scale", c_double),
        ("update_count", c_size_t),
        ("penetration", c_double),
        ("reserved", c_uint64 * 6),
    ]


class fmc_gap_constraint(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("node", c_int64),
        ("body", c_size_t),
        ("partner_kind", c_int32),
        ("reserved_flags", c_int32),
        ("partner", c_size_t),
        ("gap", c_double),
        ("area", c_double),
        ("reserved", c_uint64 * 4),
    ]


class fmc_augmentation(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("penetration", c_double),
        ("change", c_double),
        ("multiplier_count", c_size_t),
        ("is_enough", c_int32),
        ("reserved_flags", c_int32),
        ("reserved", c_uint64 * 4),
    ]


class fmc_multiplier(Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("node", c_int64),
        ("body", c_size_t),
        ("partner_kind", c_int32),
        ("reserved_flags", c_int32),
        ("partner", c_size_t),
        ("shift", c_double),
        ("towards", c_double * 3),
        ("reserved", c_uint64 * 4),
    ]


class fmc_pose(Structure):
    _fields_ = [("position", c_double * 3), ("rotation", c_double * 9), ("scale", c_double)]


class fmc_part(Structure):
    _fields_ = [
        ("shape", c_int32),
        ("facet_count", c_size_t),
        ("radius", c_double),
        ("half_height", c_double),
        ("half_extents", c_double * 3),
        ("points", POINTER(fmc_coords)),
        ("facets", POINTER(c_int32)),
        ("pose", fmc_pose),
    ]
