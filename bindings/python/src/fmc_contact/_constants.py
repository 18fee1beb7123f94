"""Constants of ``include/fmc_contact.h``, and of every enumeration the names of its entries by their values.

Generated from the header by ``make header``; do not edit.
"""

from __future__ import annotations

FMC_ABI_VERSION = 3
FMC_LOG_WARNING = 1
FMC_PAIR_LAW_OF_CONTEXT = -1
FMC_PAIR_FRICTION_OF_CONTEXT = -1
FMC_EVALUATE_ADD = 1
FMC_TANGENT_SEMIDEFINITE = 2
FMC_TANGENT_SYMMETRIC = 32
FMC_CSR_BLOCKS = 4
FMC_CSR_OBSTACLES = 8
FMC_GRADIENT_STIFFNESS = 1
FMC_GRADIENT_GAP_OFFSET = 2
FMC_GRADIENT_FRICTION = 4
FMC_OK = 0
FMC_ERROR_NULL_POINTER = 1
FMC_ERROR_MISALIGNED_POINTER = 2
FMC_ERROR_LENGTH = 3
FMC_ERROR_BUFFER_TOO_SMALL = 4
FMC_ERROR_STRIDE = 5
FMC_ERROR_DIMENSION = 6
FMC_ERROR_UNKNOWN_CELL_TYPE = 7
FMC_ERROR_NODE_OUT_OF_RANGE = 8
FMC_ERROR_NON_FINITE_COORDINATE = 9
FMC_ERROR_REPEATED_NODE = 10
FMC_ERROR_INVERTED_CELL = 11
FMC_ERROR_ZERO_MEASURE = 12
FMC_ERROR_OPEN_SURFACE = 13
FMC_ERROR_NON_MANIFOLD = 14
FMC_ERROR_INCONSISTENT_ORIENTATION = 15
FMC_ERROR_INVERTED_SURFACE = 16
FMC_ERROR_EMPTY = 17
FMC_ERROR_NOT_POSITIVE = 18
FMC_ERROR_UNKNOWN_OPTION = 19
FMC_ERROR_STRUCT_SIZE = 20
FMC_ERROR_BAD_POSE = 21
FMC_ERROR_OBSTACLE_OUT_OF_RANGE = 22
FMC_ERROR_INDEX_OUT_OF_RANGE = 23
FMC_ERROR_UNSUPPORTED = 24
FMC_ERROR_SIGNED_DISTANCE = 25
FMC_ERROR_TOO_MANY_FIBERS = 26
FMC_ERROR_THREADS = 27
FMC_ERROR_BUSY = 28
FMC_ERROR_OVERFLOW = 29
FMC_ERROR_PANIC = 30
FMC_ERROR_DEGENERATE_HULL = 31
FMC_ERROR_TOO_FEW_HEIGHTS = 32
FMC_ERROR_NON_FINITE_HEIGHT = 33
FMC_ERROR_EMPTY_COMPOUND = 34
FMC_ERROR_NOT_POSITIVE_MASS = 35
FMC_ERROR_BODY_OUT_OF_RANGE = 36
FMC_ERROR_OBSTACLE_REMOVED = 37
FMC_ERROR_TOO_MANY_PIECES = 38
FMC_ERROR_UNFINISHED_LINES = 39
FMC_ERROR_NO_STEP = 40
FMC_ERROR_NON_FINITE_SLIP = 41
FMC_ERROR_NEGATIVE_RADIUS = 42
FMC_ERROR_NON_CONFORMING = 43
FMC_ERROR_SINGULAR_STIFFNESS = 44
FMC_ERROR_INDEFINITE_STIFFNESS = 45
FMC_ERROR_DOF_OUT_OF_RANGE = 46
FMC_ERROR_REPEATED_DOF = 47
FMC_ERROR_NON_FINITE_STIFFNESS = 48
FMC_ERROR_PLACE = 49
FMC_ERROR_BAD_RANK = 50
FMC_ERROR_COMMUNICATION = 51
FMC_ERROR_ON_OTHER_RANK = 52
FMC_ERROR_RANKS_DIFFER = 53
FMC_ERROR_NOT_GATHERED = 54
FMC_ERROR_NOT_POSITIVE_DEFINITE = 55
FMC_ERROR_UNSYMMETRIC = 56
FMC_ERROR_NOT_FACTORISED = 57
FMC_ERROR_INDEX_SIZE = 58
FMC_ERROR_BAD_VALUE = 59
FMC_ERROR_UNKNOWN_FLAG = 60
FMC_ERROR_OPTIONS_CONFLICT = 61
FMC_ERROR_RESERVED_FIELD = 62
FMC_ERROR_NO_STIFFNESS = 63
FMC_ERROR_INTERRUPTED = 64
FMC_ERROR_MEMORY = 65
FMC_ERROR_UNTIED = 66
FMC_ERROR_INTERFACE_LAW = 67
FMC_CLASS_OK = 0
FMC_CLASS_INPUT = 1
FMC_CLASS_GEOMETRY = 2
FMC_CLASS_NUMERICAL = 3
FMC_CLASS_RESOURCE = 4
FMC_CLASS_PROTOCOL = 5
FMC_CLASS_INTERNAL = 6
FMC_LAW_VOLUME = 0
FMC_LAW_FIBER = 1
FMC_LAW_DEPTH = 2
FMC_ESTIMATOR_FIBERS = 0
FMC_ESTIMATOR_EXACT = 1
FMC_ESTIMATOR_AUTO = 2
FMC_PATTERN_LINES = 0
FMC_PATTERN_ISOTROPIC = 1
FMC_WEIGHTS_BALANCE = 0
FMC_WEIGHTS_CONSISTENT = 1
FMC_TRI3 = 5
FMC_QUAD4 = 9
FMC_TET4 = 10
FMC_HEX8 = 12
FMC_WEDGE6 = 13
FMC_PYRAMID5 = 14
FMC_TRI6 = 22
FMC_QUAD8 = 23
FMC_TET10 = 24
FMC_HEX20 = 25
FMC_WEDGE15 = 26
FMC_PYRAMID13 = 27
FMC_QUAD9 = 28
FMC_HEX27 = 29
FMC_FACET_LINE2 = 3
FMC_FACET_TRI3 = 5
FMC_FACET_QUAD4 = 9
FMC_FACET_LINE3 = 21
FMC_FACET_TRI6 = 22
FMC_FACET_QUAD8 = 23
FMC_FACET_QUAD9 = 28
FMC_SHAPE_HALF_SPACE = 0
FMC_SHAPE_BALL = 1
FMC_SHAPE_CUBOID = 2
FMC_SHAPE_CYLINDER = 3
FMC_SHAPE_CONE = 4
FMC_SHAPE_CAPSULE = 5
FMC_SHAPE_POLYTOPE = 6
FMC_SHAPE_CONVEX_HULL = 7
FMC_SHAPE_HEIGHT_FIELD = 8
FMC_SHAPE_COMPOUND = 9
FMC_SHAPE_SIGNED_DISTANCE = 10
FMC_INTERFACE_CONTACT = 0
FMC_INTERFACE_TIED = 1
FMC_INTERFACE_COHESIVE = 2
FMC_INTERFACE_NO_SEPARATION = 3
FMC_INTERFACE_ROUGH = 4
FMC_INTERFACE_LAW = 5
FMC_SOFTENING_LINEAR = 0
FMC_SOFTENING_EXPONENTIAL = 1
FMC_SOFTENING_PPR = 2
FMC_PARTNER_BODY = 0
FMC_PARTNER_OBSTACLE = 1
FMC_WARNING_COARSE_FIBERS = 1
FMC_WARNING_UNRESOLVED_OVERLAP = 2
FMC_WARNING_SWALLOWED_BODY = 3
FMC_WARNING_PATCH_LEFT_OUT = 4
FMC_WARNING_UNBALANCED = 5
FMC_WARNING_FLUSH_FACES = 6
FMC_WARNING_COINCIDING_FACES = 7
FMC_WARNING_GENTLE_DISTANCE = 8
FMC_WARNING_CURVED_FACES = 9
FMC_WARNING_COARSE_FACES = 10
FMC_WARNING_UNUSED_SMOOTHING = 11
FMC_WARNING_TIED_IN_PART = 12
FMC_WARNING_NO_FRICTION_DIRECTION = 13
FMC_WARNING_LARGE_WEAR = 14
FMC_REQUEST_FORCES = 0
FMC_REQUEST_PRODUCT = 1
FMC_REQUEST_DIAGONAL = 2
FMC_REQUEST_SOLVE = 3
FMC_REQUEST_CONDENSED = 4
FMC_REQUEST_FOUND = 5
FMC_REQUEST_REFUSED = 6
FMC_WAY_NONE = 0
FMC_WAY_CONDENSED = 1
FMC_WAY_NEAREST = 2
FMC_WAY_DOWNHILL = 3
FMC_STEP_CONVERGED = 0
FMC_STEP_OUTSIDE = 1
FMC_STEP_NOT_CONVERGED = 2
FMC_NODE_APART = 0
FMC_NODE_TOUCHING = 1
FMC_NODE_STICKING = 2
FMC_NODE_SLIDING = 3

FMC_STATUS: dict[int, str] = {
    0: "ok",
    1: "error_null_pointer",
    2: "error_misaligned_pointer",
    3: "error_length",
    4: "error_buffer_too_small",
    5: "error_stride",
    6: "error_dimension",
    7: "error_unknown_cell_type",
    8: "error_node_out_of_range",
    9: "error_non_finite_coordinate",
    10: "error_repeated_node",
    11: "error_inverted_cell",
    12: "error_zero_measure",
    13: "error_open_surface",
    14: "error_non_manifold",
    15: "error_inconsistent_orientation",
    16: "error_inverted_surface",
    17: "error_empty",
    18: "error_not_positive",
    19: "error_unknown_option",
    20: "error_struct_size",
    21: "error_bad_pose",
    22: "error_obstacle_out_of_range",
    23: "error_index_out_of_range",
    24: "error_unsupported",
    25: "error_signed_distance",
    26: "error_too_many_fibers",
    27: "error_threads",
    28: "error_busy",
    29: "error_overflow",
    30: "error_panic",
    31: "error_degenerate_hull",
    32: "error_too_few_heights",
    33: "error_non_finite_height",
    34: "error_empty_compound",
    35: "error_not_positive_mass",
    36: "error_body_out_of_range",
    37: "error_obstacle_removed",
    38: "error_too_many_pieces",
    39: "error_unfinished_lines",
    40: "error_no_step",
    41: "error_non_finite_slip",
    42: "error_negative_radius",
    43: "error_non_conforming",
    44: "error_singular_stiffness",
    45: "error_indefinite_stiffness",
    46: "error_dof_out_of_range",
    47: "error_repeated_dof",
    48: "error_non_finite_stiffness",
    49: "error_place",
    50: "error_bad_rank",
    51: "error_communication",
    52: "error_on_other_rank",
    53: "error_ranks_differ",
    54: "error_not_gathered",
    55: "error_not_positive_definite",
    56: "error_unsymmetric",
    57: "error_not_factorised",
    58: "error_index_size",
    59: "error_bad_value",
    60: "error_unknown_flag",
    61: "error_options_conflict",
    62: "error_reserved_field",
    63: "error_no_stiffness",
    64: "error_interrupted",
    65: "error_memory",
    66: "error_untied",
    67: "error_interface_law",
}

FMC_STATUS_CLASS_VALUE: dict[int, str] = {
    0: "ok",
    1: "input",
    2: "geometry",
    3: "numerical",
    4: "resource",
    5: "protocol",
    6: "internal",
}

FMC_LAW: dict[int, str] = {0: "volume", 1: "fiber", 2: "depth"}

FMC_ESTIMATOR: dict[int, str] = {0: "fibers", 1: "exact", 2: "auto"}

FMC_PATTERN: dict[int, str] = {0: "lines", 1: "isotropic"}

FMC_WEIGHTS: dict[int, str] = {0: "balance", 1: "consistent"}

FMC_CELL_TYPE: dict[int, str] = {
    5: "tri3",
    9: "quad4",
    10: "tet4",
    12: "hex8",
    13: "wedge6",
    14: "pyramid5",
    22: "tri6",
    23: "quad8",
    24: "tet10",
    25: "hex20",
    26: "wedge15",
    27: "pyramid13",
    28: "quad9",
    29: "hex27",
}

FMC_FACET_TYPE: dict[int, str] = {3: "line2", 5: "tri3", 9: "quad4", 21: "line3", 22: "tri6", 23: "quad8", 28: "quad9"}

FMC_SHAPE_KIND: dict[int, str] = {
    0: "half_space",
    1: "ball",
    2: "cuboid",
    3: "cylinder",
    4: "cone",
    5: "capsule",
    6: "polytope",
    7: "convex_hull",
    8: "height_field",
    9: "compound",
    10: "signed_distance",
}

FMC_INTERFACE: dict[int, str] = {0: "contact", 1: "tied", 2: "cohesive", 3: "no_separation", 4: "rough", 5: "law"}

FMC_SOFTENING: dict[int, str] = {0: "linear", 1: "exponential", 2: "ppr"}

FMC_PARTNER: dict[int, str] = {0: "body", 1: "obstacle"}

FMC_WARNING: dict[int, str] = {
    1: "coarse_fibers",
    2: "unresolved_overlap",
    3: "swallowed_body",
    4: "patch_left_out",
    5: "unbalanced",
    6: "flush_faces",
    7: "coinciding_faces",
    8: "gentle_distance",
    9: "curved_faces",
    10: "coarse_faces",
    11: "unused_smoothing",
    12: "tied_in_part",
    13: "no_friction_direction",
    14: "large_wear",
}

FMC_EQUILIBRIUM_REQUEST_KIND: dict[int, str] = {
    0: "forces",
    1: "product",
    2: "diagonal",
    3: "solve",
    4: "condensed",
    5: "found",
    6: "refused",
}

FMC_EQUILIBRIUM_WAY: dict[int, str] = {0: "none", 1: "condensed", 2: "nearest", 3: "downhill"}

FMC_CONTACT_STEP_STATE: dict[int, str] = {0: "converged", 1: "outside", 2: "not_converged"}

FMC_NODE_STATUS: dict[int, str] = {0: "apart", 1: "touching", 2: "sticking", 3: "sliding"}
