! The C interface of fmc-contact, name by name, as include/fmc_contact.h documents it. Module fmc_contact is built on it.
!
! Pointers are optional arguments: an omitted one is NULL. Lists of nodes, cells and degrees of freedom, type(*), have 32 or 64 bits
! like the mesh, and count from the option index_base. Bodies, obstacles, pairs and warnings count from 0 here. Initialise structs by
! their init functions, as in the header.
!
! Generated from the header; do not edit.
module fmc_contact_c
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer(c_int32_t), parameter :: FMC_ABI_VERSION_OF_HEADER = 3
  integer(c_int32_t), parameter :: FMC_LOG_WARNING = 1
  integer(c_int32_t), parameter :: FMC_PAIR_LAW_OF_CONTEXT = -1
  integer(c_int32_t), parameter :: FMC_PAIR_FRICTION_OF_CONTEXT = -1
  integer(c_int32_t), parameter :: FMC_EVALUATE_ADD = 1
  integer(c_int32_t), parameter :: FMC_TANGENT_SEMIDEFINITE = 2
  integer(c_int32_t), parameter :: FMC_TANGENT_SYMMETRIC = 32
  integer(c_int32_t), parameter :: FMC_CSR_BLOCKS = 4
  integer(c_int32_t), parameter :: FMC_CSR_OBSTACLES = 8
  integer(c_int32_t), parameter :: FMC_GRADIENT_STIFFNESS = 1
  integer(c_int32_t), parameter :: FMC_GRADIENT_GAP_OFFSET = 2
  integer(c_int32_t), parameter :: FMC_GRADIENT_FRICTION = 4
  integer(c_int32_t), parameter :: FMC_OK = 0
  integer(c_int32_t), parameter :: FMC_ERROR_NULL_POINTER = 1
  integer(c_int32_t), parameter :: FMC_ERROR_MISALIGNED_POINTER = 2
  integer(c_int32_t), parameter :: FMC_ERROR_LENGTH = 3
  integer(c_int32_t), parameter :: FMC_ERROR_BUFFER_TOO_SMALL = 4
  integer(c_int32_t), parameter :: FMC_ERROR_STRIDE = 5
  integer(c_int32_t), parameter :: FMC_ERROR_DIMENSION = 6
  integer(c_int32_t), parameter :: FMC_ERROR_UNKNOWN_CELL_TYPE = 7
  integer(c_int32_t), parameter :: FMC_ERROR_NODE_OUT_OF_RANGE = 8
  integer(c_int32_t), parameter :: FMC_ERROR_NON_FINITE_COORDINATE = 9
  integer(c_int32_t), parameter :: FMC_ERROR_REPEATED_NODE = 10
  integer(c_int32_t), parameter :: FMC_ERROR_INVERTED_CELL = 11
  integer(c_int32_t), parameter :: FMC_ERROR_ZERO_MEASURE = 12
  integer(c_int32_t), parameter :: FMC_ERROR_OPEN_SURFACE = 13
  integer(c_int32_t), parameter :: FMC_ERROR_NON_MANIFOLD = 14
  integer(c_int32_t), parameter :: FMC_ERROR_INCONSISTENT_ORIENTATION = 15
  integer(c_int32_t), parameter :: FMC_ERROR_INVERTED_SURFACE = 16
  integer(c_int32_t), parameter :: FMC_ERROR_EMPTY = 17
  integer(c_int32_t), parameter :: FMC_ERROR_NOT_POSITIVE = 18
  integer(c_int32_t), parameter :: FMC_ERROR_UNKNOWN_OPTION = 19
  integer(c_int32_t), parameter :: FMC_ERROR_STRUCT_SIZE = 20
  integer(c_int32_t), parameter :: FMC_ERROR_BAD_POSE = 21
  integer(c_int32_t), parameter :: FMC_ERROR_OBSTACLE_OUT_OF_RANGE = 22
  integer(c_int32_t), parameter :: FMC_ERROR_INDEX_OUT_OF_RANGE = 23
  integer(c_int32_t), parameter :: FMC_ERROR_UNSUPPORTED = 24
  integer(c_int32_t), parameter :: FMC_ERROR_SIGNED_DISTANCE = 25
  integer(c_int32_t), parameter :: FMC_ERROR_TOO_MANY_FIBERS = 26
  integer(c_int32_t), parameter :: FMC_ERROR_THREADS = 27
  integer(c_int32_t), parameter :: FMC_ERROR_BUSY = 28
  integer(c_int32_t), parameter :: FMC_ERROR_OVERFLOW = 29
  integer(c_int32_t), parameter :: FMC_ERROR_PANIC = 30
  integer(c_int32_t), parameter :: FMC_ERROR_DEGENERATE_HULL = 31
  integer(c_int32_t), parameter :: FMC_ERROR_TOO_FEW_HEIGHTS = 32
  integer(c_int32_t), parameter :: FMC_ERROR_NON_FINITE_HEIGHT = 33
  integer(c_int32_t), parameter :: FMC_ERROR_EMPTY_COMPOUND = 34
  integer(c_int32_t), parameter :: FMC_ERROR_NOT_POSITIVE_MASS = 35
  integer(c_int32_t), parameter :: FMC_ERROR_BODY_OUT_OF_RANGE = 36
  integer(c_int32_t), parameter :: FMC_ERROR_OBSTACLE_REMOVED = 37
  integer(c_int32_t), parameter :: FMC_ERROR_TOO_MANY_PIECES = 38
  integer(c_int32_t), parameter :: FMC_ERROR_UNFINISHED_LINES = 39
  integer(c_int32_t), parameter :: FMC_ERROR_NO_STEP = 40
  integer(c_int32_t), parameter :: FMC_ERROR_NON_FINITE_SLIP = 41
  integer(c_int32_t), parameter :: FMC_ERROR_NEGATIVE_RADIUS = 42
  integer(c_int32_t), parameter :: FMC_ERROR_NON_CONFORMING = 43
  integer(c_int32_t), parameter :: FMC_ERROR_SINGULAR_STIFFNESS = 44
  integer(c_int32_t), parameter :: FMC_ERROR_INDEFINITE_STIFFNESS = 45
  integer(c_int32_t), parameter :: FMC_ERROR_DOF_OUT_OF_RANGE = 46
  integer(c_int32_t), parameter :: FMC_ERROR_REPEATED_DOF = 47
  integer(c_int32_t), parameter :: FMC_ERROR_NON_FINITE_STIFFNESS = 48
  integer(c_int32_t), parameter :: FMC_ERROR_PLACE = 49
  integer(c_int32_t), parameter :: FMC_ERROR_BAD_RANK = 50
  integer(c_int32_t), parameter :: FMC_ERROR_COMMUNICATION = 51
  integer(c_int32_t), parameter :: FMC_ERROR_ON_OTHER_RANK = 52
  integer(c_int32_t), parameter :: FMC_ERROR_RANKS_DIFFER = 53
  integer(c_int32_t), parameter :: FMC_ERROR_NOT_GATHERED = 54
  integer(c_int32_t), parameter :: FMC_ERROR_NOT_POSITIVE_DEFINITE = 55
  integer(c_int32_t), parameter :: FMC_ERROR_UNSYMMETRIC = 56
  integer(c_int32_t), parameter :: FMC_ERROR_NOT_FACTORISED = 57
  integer(c_int32_t), parameter :: FMC_ERROR_INDEX_SIZE = 58
  integer(c_int32_t), parameter :: FMC_ERROR_BAD_VALUE = 59
  integer(c_int32_t), parameter :: FMC_ERROR_UNKNOWN_FLAG = 60
  integer(c_int32_t), parameter :: FMC_ERROR_OPTIONS_CONFLICT = 61
  integer(c_int32_t), parameter :: FMC_ERROR_RESERVED_FIELD = 62
  integer(c_int32_t), parameter :: FMC_ERROR_NO_STIFFNESS = 63
  integer(c_int32_t), parameter :: FMC_ERROR_INTERRUPTED = 64
  integer(c_int32_t), parameter :: FMC_ERROR_MEMORY = 65
  integer(c_int32_t), parameter :: FMC_ERROR_UNTIED = 66
  integer(c_int32_t), parameter :: FMC_ERROR_INTERFACE_LAW = 67
  integer(c_int32_t), parameter :: FMC_CLASS_OK = 0
  integer(c_int32_t), parameter :: FMC_CLASS_INPUT = 1
  integer(c_int32_t), parameter :: FMC_CLASS_GEOMETRY = 2
  integer(c_int32_t), parameter :: FMC_CLASS_NUMERICAL = 3
  integer(c_int32_t), parameter :: FMC_CLASS_RESOURCE = 4
  integer(c_int32_t), parameter :: FMC_CLASS_PROTOCOL = 5
  integer(c_int32_t), parameter :: FMC_CLASS_INTERNAL = 6
  integer(c_int32_t), parameter :: FMC_LAW_VOLUME = 0
  integer(c_int32_t), parameter :: FMC_LAW_FIBER = 1
  integer(c_int32_t), parameter :: FMC_LAW_DEPTH = 2
  integer(c_int32_t), parameter :: FMC_ESTIMATOR_FIBERS = 0
  integer(c_int32_t), parameter :: FMC_ESTIMATOR_EXACT = 1
  integer(c_int32_t), parameter :: FMC_ESTIMATOR_AUTO = 2
  integer(c_int32_t), parameter :: FMC_PATTERN_LINES = 0
  integer(c_int32_t), parameter :: FMC_PATTERN_ISOTROPIC = 1
  integer(c_int32_t), parameter :: FMC_WEIGHTS_BALANCE = 0
  integer(c_int32_t), parameter :: FMC_WEIGHTS_CONSISTENT = 1
  integer(c_int32_t), parameter :: FMC_TRI3 = 5
  integer(c_int32_t), parameter :: FMC_QUAD4 = 9
  integer(c_int32_t), parameter :: FMC_TET4 = 10
  integer(c_int32_t), parameter :: FMC_HEX8 = 12
  integer(c_int32_t), parameter :: FMC_WEDGE6 = 13
  integer(c_int32_t), parameter :: FMC_PYRAMID5 = 14
  integer(c_int32_t), parameter :: FMC_TRI6 = 22
  integer(c_int32_t), parameter :: FMC_QUAD8 = 23
  integer(c_int32_t), parameter :: FMC_TET10 = 24
  integer(c_int32_t), parameter :: FMC_HEX20 = 25
  integer(c_int32_t), parameter :: FMC_WEDGE15 = 26
  integer(c_int32_t), parameter :: FMC_PYRAMID13 = 27
  integer(c_int32_t), parameter :: FMC_QUAD9 = 28
  integer(c_int32_t), parameter :: FMC_HEX27 = 29
  integer(c_int32_t), parameter :: FMC_FACET_LINE2 = 3
  integer(c_int32_t), parameter :: FMC_FACET_TRI3 = 5
  integer(c_int32_t), parameter :: FMC_FACET_QUAD4 = 9
  integer(c_int32_t), parameter :: FMC_FACET_LINE3 = 21
  integer(c_int32_t), parameter :: FMC_FACET_TRI6 = 22
  integer(c_int32_t), parameter :: FMC_FACET_QUAD8 = 23
  integer(c_int32_t), parameter :: FMC_FACET_QUAD9 = 28
  integer(c_int32_t), parameter :: FMC_SHAPE_HALF_SPACE = 0
  integer(c_int32_t), parameter :: FMC_SHAPE_BALL = 1
  integer(c_int32_t), parameter :: FMC_SHAPE_CUBOID = 2
  integer(c_int32_t), parameter :: FMC_SHAPE_CYLINDER = 3
  integer(c_int32_t), parameter :: FMC_SHAPE_CONE = 4
  integer(c_int32_t), parameter :: FMC_SHAPE_CAPSULE = 5
  integer(c_int32_t), parameter :: FMC_SHAPE_POLYTOPE = 6
  integer(c_int32_t), parameter :: FMC_SHAPE_CONVEX_HULL = 7
  integer(c_int32_t), parameter :: FMC_SHAPE_HEIGHT_FIELD = 8
  integer(c_int32_t), parameter :: FMC_SHAPE_COMPOUND = 9
  integer(c_int32_t), parameter :: FMC_SHAPE_SIGNED_DISTANCE = 10
  integer(c_int32_t), parameter :: FMC_INTERFACE_CONTACT = 0
  integer(c_int32_t), parameter :: FMC_INTERFACE_TIED = 1
  integer(c_int32_t), parameter :: FMC_INTERFACE_COHESIVE = 2
  integer(c_int32_t), parameter :: FMC_INTERFACE_NO_SEPARATION = 3
  integer(c_int32_t), parameter :: FMC_INTERFACE_ROUGH = 4
  integer(c_int32_t), parameter :: FMC_INTERFACE_LAW = 5
  integer(c_int32_t), parameter :: FMC_SOFTENING_LINEAR = 0
  integer(c_int32_t), parameter :: FMC_SOFTENING_EXPONENTIAL = 1
  integer(c_int32_t), parameter :: FMC_SOFTENING_PPR = 2
  integer(c_int32_t), parameter :: FMC_PARTNER_BODY = 0
  integer(c_int32_t), parameter :: FMC_PARTNER_OBSTACLE = 1
  integer(c_int32_t), parameter :: FMC_WARNING_COARSE_FIBERS = 1
  integer(c_int32_t), parameter :: FMC_WARNING_UNRESOLVED_OVERLAP = 2
  integer(c_int32_t), parameter :: FMC_WARNING_SWALLOWED_BODY = 3
  integer(c_int32_t), parameter :: FMC_WARNING_PATCH_LEFT_OUT = 4
  integer(c_int32_t), parameter :: FMC_WARNING_UNBALANCED = 5
  integer(c_int32_t), parameter :: FMC_WARNING_FLUSH_FACES = 6
  integer(c_int32_t), parameter :: FMC_WARNING_COINCIDING_FACES = 7
  integer(c_int32_t), parameter :: FMC_WARNING_GENTLE_DISTANCE = 8
  integer(c_int32_t), parameter :: FMC_WARNING_CURVED_FACES = 9
  integer(c_int32_t), parameter :: FMC_WARNING_COARSE_FACES = 10
  integer(c_int32_t), parameter :: FMC_WARNING_UNUSED_SMOOTHING = 11
  integer(c_int32_t), parameter :: FMC_WARNING_TIED_IN_PART = 12
  integer(c_int32_t), parameter :: FMC_WARNING_NO_FRICTION_DIRECTION = 13
  integer(c_int32_t), parameter :: FMC_WARNING_LARGE_WEAR = 14
  integer(c_int32_t), parameter :: FMC_REQUEST_FORCES = 0
  integer(c_int32_t), parameter :: FMC_REQUEST_PRODUCT = 1
  integer(c_int32_t), parameter :: FMC_REQUEST_DIAGONAL = 2
  integer(c_int32_t), parameter :: FMC_REQUEST_SOLVE = 3
  integer(c_int32_t), parameter :: FMC_REQUEST_CONDENSED = 4
  integer(c_int32_t), parameter :: FMC_REQUEST_FOUND = 5
  integer(c_int32_t), parameter :: FMC_REQUEST_REFUSED = 6
  integer(c_int32_t), parameter :: FMC_WAY_NONE = 0
  integer(c_int32_t), parameter :: FMC_WAY_CONDENSED = 1
  integer(c_int32_t), parameter :: FMC_WAY_NEAREST = 2
  integer(c_int32_t), parameter :: FMC_WAY_DOWNHILL = 3
  integer(c_int32_t), parameter :: FMC_STEP_CONVERGED = 0
  integer(c_int32_t), parameter :: FMC_STEP_OUTSIDE = 1
  integer(c_int32_t), parameter :: FMC_STEP_NOT_CONVERGED = 2
  integer(c_int32_t), parameter :: FMC_NODE_APART = 0
  integer(c_int32_t), parameter :: FMC_NODE_TOUCHING = 1
  integer(c_int32_t), parameter :: FMC_NODE_STICKING = 2
  integer(c_int32_t), parameter :: FMC_NODE_SLIDING = 3

  type, bind(c) :: fmc_options
    integer(c_size_t) :: struct_size
    real(c_double) :: stiffness
    real(c_double) :: exponent
    real(c_double) :: spacing
    real(c_double) :: fiber_length
    integer(c_int64_t) :: fiber_count
    integer(c_int64_t) :: seed
    integer(c_int32_t) :: law
    integer(c_int32_t) :: estimator
    integer(c_int32_t) :: pattern
    integer(c_int32_t) :: weights
    integer(c_int32_t) :: momentum_correction
    integer(c_int32_t) :: self_contact
    integer(c_int32_t) :: check_cells
    integer(c_int32_t) :: threads
    integer(c_int32_t) :: index_base
    integer(c_int32_t) :: axisymmetric
    real(c_double) :: smoothing_length
    real(c_double) :: friction_coefficient
    real(c_double) :: friction_stiffness
    real(c_double) :: cohesion
    real(c_double) :: shear_limit
    real(c_double) :: memoryless_slip
    real(c_double) :: static_coefficient
    real(c_double) :: weakening_slip
    real(c_double) :: weld
    integer(c_int64_t) :: reserved(7)
  end type

  type, bind(c) :: fmc_coords
    type(c_ptr) :: data
    integer(c_size_t) :: node_count
    integer(c_ptrdiff_t) :: node_stride
    integer(c_ptrdiff_t) :: axis_stride
  end type

  type, bind(c) :: fmc_forces
    type(c_ptr) :: data
    integer(c_size_t) :: node_count
    integer(c_ptrdiff_t) :: node_stride
    integer(c_ptrdiff_t) :: axis_stride
  end type

  type, bind(c) :: fmc_cell_block
    integer(c_int32_t) :: cell_type
    integer(c_int32_t) :: index_size
    type(c_ptr) :: conn
    integer(c_size_t) :: cell_count
  end type

  type, bind(c) :: fmc_facet_block
    integer(c_int32_t) :: facet_type
    integer(c_int32_t) :: index_size
    type(c_ptr) :: conn
    integer(c_size_t) :: facet_count
  end type

  type, bind(c) :: fmc_csr
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: row_count
    integer(c_int32_t) :: index_size
    integer(c_int32_t) :: index_base
    type(c_ptr) :: row_offsets
    type(c_ptr) :: cols
    type(c_ptr) :: values
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_pose
    real(c_double) :: position(3)
    real(c_double) :: rotation(9)
    real(c_double) :: scale
  end type

  type, bind(c) :: fmc_shape
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: kind
    integer(c_int32_t) :: index_size
    real(c_double) :: radius
    real(c_double) :: half_height
    real(c_double) :: half_extents(3)
    type(fmc_coords) :: points
    type(c_ptr) :: facets
    integer(c_size_t) :: facet_count
    type(c_ptr) :: heights
    integer(c_size_t) :: counts(2)
    real(c_double) :: lengths(2)
    real(c_double) :: thickness
    type(c_ptr) :: parts
    integer(c_size_t) :: part_count
    type(c_funptr) :: signed_distance
    type(c_ptr) :: user
    integer(c_int64_t) :: reserved(8)
  end type

  type, bind(c) :: fmc_part
    type(c_ptr) :: shape
    type(fmc_pose) :: pose
  end type

  type, bind(c) :: fmc_pair_options
    integer(c_size_t) :: struct_size
    real(c_double) :: stiffness
    real(c_double) :: exponent
    real(c_double) :: smoothing_length
    real(c_double) :: gap_offset
    real(c_double) :: friction_coefficient
    integer(c_int32_t) :: law
    integer(c_int32_t) :: excluded
    real(c_double) :: static_coefficient
    real(c_double) :: weakening_slip
    integer(c_int32_t) :: interface_kind
    integer(c_int32_t) :: softening
    real(c_double) :: reach
    real(c_double) :: normal_strength
    real(c_double) :: shear_strength
    real(c_double) :: normal_energy
    real(c_double) :: shear_energy
    real(c_double) :: mixed_mode_exponent
    integer(c_int32_t) :: surface_a
    integer(c_int32_t) :: surface_b
    real(c_double) :: viscosity
    integer(c_int64_t) :: reserved(3)
  end type

  type, bind(c) :: fmc_orthotropic_friction
    integer(c_size_t) :: struct_size
    real(c_double) :: transverse_coefficient
    real(c_double) :: direction(3)
    integer(c_int32_t) :: direction_of
    integer(c_int32_t) :: unused
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_ppr
    integer(c_size_t) :: struct_size
    real(c_double) :: normal_shape
    real(c_double) :: shear_shape
    real(c_double) :: normal_slope
    real(c_double) :: shear_slope
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_law_points
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: count
    integer(c_size_t) :: dim
    integer(c_size_t) :: history_count
    integer(c_size_t) :: body
    integer(c_size_t) :: partner
    real(c_double) :: time_step
    type(c_ptr) :: jump
    type(c_ptr) :: axes
    type(c_ptr) :: position
    type(c_ptr) :: reference
    type(c_ptr) :: area
    type(c_ptr) :: history
    integer(c_size_t) :: field_count
    type(c_ptr) :: fields
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_law_response
    integer(c_size_t) :: struct_size
    type(c_ptr) :: traction
    type(c_ptr) :: tangent
    type(c_ptr) :: history
    type(c_ptr) :: stored
    type(c_ptr) :: dissipated
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_own_law
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: history_count
    type(c_funptr) :: respond
    type(c_ptr) :: user
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_friction_facets
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: count
    integer(c_size_t) :: dim
    integer(c_size_t) :: history_count
    integer(c_size_t) :: body
    integer(c_size_t) :: partner
    integer(c_int32_t) :: partner_kind
    integer(c_int32_t) :: unused
    real(c_double) :: time_step
    real(c_double) :: stiffness
    type(c_ptr) :: facet
    type(c_ptr) :: pressure
    type(c_ptr) :: slip
    type(c_ptr) :: trial
    type(c_ptr) :: axes
    type(c_ptr) :: position
    type(c_ptr) :: area
    type(c_ptr) :: history
    integer(c_size_t) :: field_count
    type(c_ptr) :: fields
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_friction_response
    integer(c_size_t) :: struct_size
    type(c_ptr) :: limit
    type(c_ptr) :: by_pressure
    type(c_ptr) :: by_slip
    type(c_ptr) :: history
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_friction_law
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: history_count
    type(c_funptr) :: limit
    type(c_ptr) :: user
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_result
    integer(c_size_t) :: struct_size
    real(c_double) :: volume
    real(c_double) :: volume_standard_error
    real(c_double) :: energy
    real(c_double) :: contact_area
    real(c_double) :: penetration
    integer(c_size_t) :: fiber_count
    integer(c_size_t) :: crossing_count
    integer(c_size_t) :: facet_count
    integer(c_size_t) :: pair_count
    integer(c_size_t) :: body_count
    integer(c_size_t) :: obstacle_count
    integer(c_size_t) :: warning_count
    real(c_double) :: friction_energy
    real(c_double) :: friction_dissipation
    real(c_double) :: stick_area
    real(c_double) :: slip_area
    real(c_double) :: largest_slip
    integer(c_int64_t) :: reserved(3)
  end type

  type, bind(c) :: fmc_resultant
    integer(c_size_t) :: struct_size
    integer(c_int64_t) :: id
    real(c_double) :: force(3)
    real(c_double) :: moment(3)
    integer(c_size_t) :: node_count
    real(c_double) :: friction(3)
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_pair_result
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: a_kind
    integer(c_int32_t) :: b_kind
    integer(c_size_t) :: a
    integer(c_size_t) :: b
    real(c_double) :: volume
    real(c_double) :: volume_standard_error
    real(c_double) :: energy
    real(c_double) :: pressure
    real(c_double) :: contact_area
    real(c_double) :: penetration
    real(c_double) :: spacing
    real(c_double) :: friction_energy
    real(c_double) :: friction_dissipation
    real(c_double) :: stick_area
    real(c_double) :: slip_area
    real(c_double) :: force(3)
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_step_limit
    integer(c_size_t) :: struct_size
    real(c_double) :: part
    real(c_double) :: first_touch
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_adjustment
    integer(c_size_t) :: struct_size
    real(c_double) :: closed
    real(c_double) :: removed
    real(c_double) :: left
    integer(c_size_t) :: count
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_augmentation
    integer(c_size_t) :: struct_size
    real(c_double) :: penetration
    real(c_double) :: change
    integer(c_size_t) :: multiplier_count
    integer(c_int32_t) :: is_converged
    integer(c_int32_t) :: reserved_flags
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_multiplier
    integer(c_size_t) :: struct_size
    integer(c_int64_t) :: node
    integer(c_size_t) :: body
    integer(c_int32_t) :: partner_kind
    integer(c_int32_t) :: reserved_flags
    integer(c_size_t) :: partner
    real(c_double) :: shift
    real(c_double) :: towards(3)
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_equilibrium_options
    integer(c_size_t) :: struct_size
    real(c_double) :: tolerance
    integer(c_size_t) :: max_solves
    real(c_double) :: penetration
    real(c_double) :: reach
    integer(c_size_t) :: max_updates
    integer(c_int32_t) :: condensed
    integer(c_int32_t) :: lagged
    integer(c_int32_t) :: find_patches
    integer(c_int32_t) :: check
    integer(c_int32_t) :: straight_slip
    integer(c_int32_t) :: reserved_flags
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_equilibrium_problem
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: unknown_count
    integer(c_size_t) :: row_count
    type(c_ptr) :: unknown_of_coordinate
    type(c_ptr) :: base
    type(c_ptr) :: free
    type(c_ptr) :: x
    type(c_ptr) :: prescribed
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_equilibrium_answer
    integer(c_size_t) :: struct_size
    type(c_ptr) :: vector
    type(c_ptr) :: refusal
    type(c_ptr) :: energy
    integer(c_int32_t) :: definite
    integer(c_int32_t) :: reserved_flags
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_equilibrium_request
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: kind
    integer(c_int32_t) :: matrix
    integer(c_int32_t) :: magnitudes
    integer(c_int32_t) :: tangent_flags
    type(c_ptr) :: x
    type(c_ptr) :: vector
    type(c_ptr) :: forces
    real(c_double) :: shift
    real(c_double) :: tolerance
    real(c_double) :: absolute_tolerance
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_equilibrium_result
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: way
    integer(c_int32_t) :: unheld
    type(c_ptr) :: x
    type(c_ptr) :: reactions
    type(c_ptr) :: residuals
    integer(c_size_t) :: residual_count
    integer(c_size_t) :: solve_count
    integer(c_size_t) :: rigid_step_count
    integer(c_size_t) :: part_count
    integer(c_size_t) :: loose_count
    integer(c_size_t) :: update_count
    integer(c_size_t) :: text_count
    real(c_double) :: penetration
    integer(c_int64_t) :: unheld_body
    real(c_double) :: unheld_direction(3)
    integer(c_size_t) :: first_touch_count
    integer(c_int64_t) :: reserved(5)
  end type

  type, bind(c) :: fmc_contact_step_options
    integer(c_size_t) :: struct_size
    real(c_double) :: tolerance
    real(c_double) :: absolute_tolerance
    real(c_double) :: full_below
    integer(c_int32_t) :: max_iterations
    integer(c_int32_t) :: max_trials
    integer(c_int32_t) :: soft_start
    integer(c_int32_t) :: reserved_flags
    integer(c_int64_t) :: reserved(7)
  end type

  type, bind(c) :: fmc_contact_step_result
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: state
    integer(c_int32_t) :: iterations
    integer(c_size_t) :: evaluation_count
    integer(c_size_t) :: outside_count
    real(c_double) :: residual_at_start
    real(c_double) :: residual
    real(c_double) :: scale
    integer(c_int64_t) :: reserved(8)
  end type

  type, bind(c) :: fmc_nodal_contact
    integer(c_size_t) :: struct_size
    type(c_ptr) :: pressure
    type(c_ptr) :: gap
    type(c_ptr) :: area
    type(c_ptr) :: normal
    type(c_ptr) :: friction
    type(c_ptr) :: sliding
    type(c_ptr) :: status
    type(c_ptr) :: local_pressure
    integer(c_int64_t) :: reserved(8)
  end type

  type, bind(c) :: fmc_contact_side
    integer(c_int32_t) :: kind
    integer(c_int32_t) :: node_count
    integer(c_size_t) :: index
    integer(c_int64_t) :: cell
    integer(c_int64_t) :: nodes(8)
    real(c_double) :: weights(8)
    real(c_double) :: position(3)
  end type

  type, bind(c) :: fmc_contact_point
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: patch
    real(c_double) :: position(3)
    real(c_double) :: normal(3)
    real(c_double) :: gap
    real(c_double) :: pressure
    real(c_double) :: area
    real(c_double) :: friction(3)
    real(c_double) :: slip(3)
    real(c_double) :: sliding
    type(fmc_contact_side) :: sides(2)
    integer(c_int64_t) :: reserved(8)
  end type

  type, bind(c) :: fmc_gap_constraint
    integer(c_size_t) :: struct_size
    integer(c_int64_t) :: node
    integer(c_size_t) :: body
    integer(c_int32_t) :: partner_kind
    integer(c_int32_t) :: reserved_flags
    integer(c_size_t) :: partner
    real(c_double) :: gap
    real(c_double) :: area
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_tie
    integer(c_size_t) :: struct_size
    real(c_double) :: area
    real(c_double) :: largest_gap
    integer(c_size_t) :: node_count
    real(c_double) :: reach
    integer(c_int64_t) :: reserved(3)
  end type

  type, bind(c) :: fmc_tie_node
    integer(c_size_t) :: struct_size
    integer(c_int64_t) :: node
    integer(c_size_t) :: body
    integer(c_size_t) :: partner
    real(c_double) :: area
    real(c_double) :: traction(3)
    real(c_double) :: jump(3)
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_conductance
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: pressure_count
    type(c_ptr) :: pressures
    type(c_ptr) :: by_pressure
    integer(c_size_t) :: gap_count
    type(c_ptr) :: gaps
    type(c_ptr) :: by_gap
    integer(c_int64_t) :: reserved(8)
  end type

  type, bind(c) :: fmc_cohesive
    integer(c_size_t) :: struct_size
    real(c_double) :: area
    real(c_double) :: largest_gap
    integer(c_size_t) :: point_count
    real(c_double) :: stored
    real(c_double) :: dissipated
    real(c_double) :: damaged_area
    real(c_double) :: broken_area
    real(c_double) :: rubbed
    real(c_double) :: viscous
    integer(c_int64_t) :: reserved(3)
  end type

  type, bind(c) :: fmc_cohesive_point
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: body
    integer(c_size_t) :: partner
    real(c_double) :: position(3)
    real(c_double) :: area
    real(c_double) :: opening
    real(c_double) :: sliding(3)
    real(c_double) :: traction(3)
    real(c_double) :: damage
    real(c_double) :: dissipated
    real(c_double) :: rubbed
    real(c_double) :: viscous
    integer(c_int64_t) :: reserved(3)
  end type

  type, bind(c) :: fmc_law_point
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: body
    integer(c_size_t) :: partner
    real(c_double) :: position(3)
    real(c_double) :: area
    real(c_double) :: axes(9)
    real(c_double) :: jump(3)
    real(c_double) :: traction(3)
    real(c_double) :: stored
    real(c_double) :: dissipated
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_boundary_facet
    integer(c_size_t) :: struct_size
    integer(c_size_t) :: body
    integer(c_int64_t) :: cell
    integer(c_int64_t) :: input_facet
    integer(c_int32_t) :: local_face
    integer(c_int32_t) :: node_count
    integer(c_int64_t) :: nodes(4)
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_gradients
    integer(c_size_t) :: struct_size
    type(c_ptr) :: coords
    type(c_ptr) :: reference
    type(c_ptr) :: positions
    type(c_ptr) :: rotations
    integer(c_int64_t) :: of_pairs
    type(c_ptr) :: slip_adjoint
    integer(c_size_t) :: slip_adjoint_count
    type(c_ptr) :: slip
    integer(c_size_t) :: slip_capacity
    type(c_ptr) :: slip_count
    integer(c_int64_t) :: reserved(3)
  end type

  type, bind(c) :: fmc_pair_gradient
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: a_kind
    integer(c_int32_t) :: b_kind
    integer(c_size_t) :: a
    integer(c_size_t) :: b
    real(c_double) :: stiffness
    real(c_double) :: gap_offset
    real(c_double) :: friction
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_directions
    integer(c_size_t) :: struct_size
    type(c_ptr) :: coords
    type(c_ptr) :: positions
    type(c_ptr) :: rotations
    real(c_double) :: stiffness
    real(c_double) :: gap_offset
    real(c_double) :: friction
    type(c_ptr) :: pairs
    integer(c_size_t) :: pair_count
    type(c_ptr) :: slip
    integer(c_size_t) :: slip_count
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_communicator
    integer(c_size_t) :: struct_size
    integer(c_int32_t) :: rank
    integer(c_int32_t) :: size
    type(c_funptr) :: all_gather
    type(c_ptr) :: user
    type(c_funptr) :: all_to_all
    integer(c_int64_t) :: reserved(5)
  end type

  type, bind(c) :: fmc_rank_counts
    integer(c_size_t) :: struct_size
    integer(c_int64_t) :: item_count
    integer(c_int64_t) :: own_item_count
    integer(c_int64_t) :: call_count
    integer(c_int64_t) :: sent_bytes
    integer(c_int64_t) :: received_bytes
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_mesh_part
    integer(c_size_t) :: struct_size
    type(fmc_coords) :: coords
    integer(c_int32_t) :: index_size
    integer(c_int32_t) :: reserved_flags
    type(c_ptr) :: node_numbers
    type(c_ptr) :: blocks
    integer(c_size_t) :: block_count
    type(c_ptr) :: cell_numbers
    type(c_ptr) :: body_ids
    real(c_double) :: reach
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_carried_slip
    integer(c_int64_t) :: cell
    integer(c_int32_t) :: face
    integer(c_int32_t) :: part
    integer(c_int32_t) :: partner_kind
    integer(c_int32_t) :: is_second
    integer(c_size_t) :: partner
    real(c_double) :: slip(3)
    real(c_double) :: slid
  end type

  type, bind(c) :: fmc_gathered_counts
    integer(c_size_t) :: struct_size
    integer(c_int64_t) :: node_count
    integer(c_int64_t) :: cell_count
    integer(c_int64_t) :: facet_count
    integer(c_int64_t) :: whole_facet_count
    integer(c_int64_t) :: own_cell_count
    integer(c_int64_t) :: gather_count
    integer(c_int64_t) :: reserved(4)
  end type

  type, bind(c) :: fmc_friction_step
    integer(c_size_t) :: struct_size
    type(c_ptr) :: start
    type(c_ptr) :: reference
    type(c_ptr) :: slip
    integer(c_size_t) :: slip_count
    type(c_ptr) :: next_slip
    integer(c_size_t) :: next_slip_capacity
    type(c_ptr) :: next_slip_count
    integer(c_int64_t) :: reserved(8)
  end type

  abstract interface
    subroutine fmc_log_callback(user, level, text) bind(c)
      import
      type(c_ptr), value :: user
      integer(c_int32_t), value :: level
      character(kind=c_char), intent(in) :: text(*)
    end subroutine
    function fmc_interrupt_callback(user) bind(c)
      import
      type(c_ptr), value :: user
      integer(c_int32_t) :: fmc_interrupt_callback
    end function
    function fmc_signed_distance(user, n, x, phi, grad) bind(c)
      import
      type(c_ptr), value :: user
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: x(*)
      real(c_double), intent(inout) :: phi(*)
      real(c_double), intent(inout) :: grad(*)
      integer(c_int32_t) :: fmc_signed_distance
    end function
    function fmc_respond(user, at, response) bind(c)
      import
      type(c_ptr), value :: user
      type(fmc_law_points), intent(in) :: at
      type(fmc_law_response), intent(in) :: response
      integer(c_int32_t) :: fmc_respond
    end function
    function fmc_limit_friction(user, at, response) bind(c)
      import
      type(c_ptr), value :: user
      type(fmc_friction_facets), intent(in) :: at
      type(fmc_friction_response), intent(in) :: response
      integer(c_int32_t) :: fmc_limit_friction
    end function
    function fmc_place(user, n, displacement, coords) bind(c)
      import
      type(c_ptr), value :: user
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: displacement(*)
      real(c_double), intent(inout) :: coords(*)
      integer(c_int32_t) :: fmc_place
    end function
    function fmc_all_gather(user, send, counts, received) bind(c)
      import
      type(c_ptr), value :: user
      type(c_ptr), value :: send
      integer(c_int64_t), intent(in) :: counts(*)
      type(c_ptr), value :: received
      integer(c_int32_t) :: fmc_all_gather
    end function
    function fmc_all_to_all(user, send, send_counts, received, received_counts) bind(c)
      import
      type(c_ptr), value :: user
      type(c_ptr), value :: send
      integer(c_int64_t), intent(in) :: send_counts(*)
      type(c_ptr), value :: received
      integer(c_int64_t), intent(in) :: received_counts(*)
      integer(c_int32_t) :: fmc_all_to_all
    end function
  end interface

  interface
    function fmc_version() bind(c)
      import
      type(c_ptr) :: fmc_version
    end function
    function fmc_abi_version() bind(c)
      import
      integer(c_int32_t) :: fmc_abi_version
    end function
    function fmc_has_feature(name) bind(c)
      import
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int32_t) :: fmc_has_feature
    end function
    function fmc_status_name(status) bind(c)
      import
      integer(c_int32_t), value :: status
      type(c_ptr) :: fmc_status_name
    end function
    function fmc_status_class(status) bind(c)
      import
      integer(c_int32_t), value :: status
      integer(c_int32_t) :: fmc_status_class
    end function
    function fmc_last_error() bind(c)
      import
      type(c_ptr) :: fmc_last_error
    end function
    function fmc_options_init(options) bind(c)
      import
      type(fmc_options), intent(inout), optional :: options
      integer(c_int32_t) :: fmc_options_init
    end function
    function fmc_options_set(options, key, value) bind(c)
      import
      type(fmc_options), intent(inout), optional :: options
      character(kind=c_char), intent(in) :: key(*)
      character(kind=c_char), intent(in) :: value(*)
      integer(c_int32_t) :: fmc_options_set
    end function
    function fmc_suggest_stiffness(law, dim, exponent, modulus, cell_size, stiffness) bind(c)
      import
      integer(c_int32_t), value :: law
      integer(c_int32_t), value :: dim
      real(c_double), value :: exponent
      real(c_double), value :: modulus
      real(c_double), value :: cell_size
      real(c_double), intent(inout), optional :: stiffness
      integer(c_int32_t) :: fmc_suggest_stiffness
    end function
    function fmc_context_set_log(context, callback, user) bind(c)
      import
      type(c_ptr), value :: context
      type(c_funptr), value :: callback
      type(c_ptr), value :: user
      integer(c_int32_t) :: fmc_context_set_log
    end function
    function fmc_context_new_from_cells(dim, coords, blocks, block_count, body_ids, options, &
        context) bind(c)
      import
      integer(c_int32_t), value :: dim
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_cell_block), intent(in), optional :: blocks(*)
      integer(c_size_t), value :: block_count
      type(*), intent(in), optional :: body_ids(*)
      type(fmc_options), intent(in), optional :: options
      type(c_ptr), intent(inout), optional :: context
      integer(c_int32_t) :: fmc_context_new_from_cells
    end function
    function fmc_context_new_from_facets(dim, coords, blocks, block_count, body_ids, options, &
        context) bind(c)
      import
      integer(c_int32_t), value :: dim
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_facet_block), intent(in), optional :: blocks(*)
      integer(c_size_t), value :: block_count
      type(*), intent(in), optional :: body_ids(*)
      type(fmc_options), intent(in), optional :: options
      type(c_ptr), intent(inout), optional :: context
      integer(c_int32_t) :: fmc_context_new_from_facets
    end function
    function fmc_context_set_options(context, options) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_options), intent(in), optional :: options
      integer(c_int32_t) :: fmc_context_set_options
    end function
    function fmc_context_options(context, options) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_options), intent(inout), optional :: options
      integer(c_int32_t) :: fmc_context_options
    end function
    function fmc_context_counts(context, node_count, facet_count, body_count) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), intent(inout), optional :: node_count
      integer(c_size_t), intent(inout), optional :: facet_count
      integer(c_size_t), intent(inout), optional :: body_count
      integer(c_int32_t) :: fmc_context_counts
    end function
    function fmc_context_welded_node_count(context, count) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_welded_node_count
    end function
    function fmc_context_set_interrupt(context, callback, user) bind(c)
      import
      type(c_ptr), value :: context
      type(c_funptr), value :: callback
      type(c_ptr), value :: user
      integer(c_int32_t) :: fmc_context_set_interrupt
    end function
    function fmc_context_set_reference(context, coords) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t) :: fmc_context_set_reference
    end function
    function fmc_context_set_symmetry_planes(context, points, normals, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: points(*)
      real(c_double), intent(in), optional :: normals(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_symmetry_planes
    end function
    function fmc_context_set_symmetry_nodes(context, nodes, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(in), optional :: nodes(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_symmetry_nodes
    end function
    function fmc_context_set_surface_smoothing(context, feature_angle) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), value :: feature_angle
      integer(c_int32_t) :: fmc_context_set_surface_smoothing
    end function
    function fmc_context_add_surface(context, facets, count, surface) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), intent(in), optional :: facets(*)
      integer(c_size_t), value :: count
      integer(c_int32_t), intent(inout), optional :: surface(*)
      integer(c_int32_t) :: fmc_context_add_surface
    end function
    function fmc_csr_init(matrix) bind(c)
      import
      type(fmc_csr), intent(inout), optional :: matrix
      integer(c_int32_t) :: fmc_csr_init
    end function
    function fmc_context_set_basis(context, weights, unknown_count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_csr), intent(in), optional :: weights
      integer(c_size_t), value :: unknown_count
      integer(c_int32_t) :: fmc_context_set_basis
    end function
    function fmc_pose_init(pose) bind(c)
      import
      type(fmc_pose), intent(inout), optional :: pose
      integer(c_int32_t) :: fmc_pose_init
    end function
    function fmc_pose_along(dim, position, axis, pose) bind(c)
      import
      integer(c_int32_t), value :: dim
      real(c_double), intent(in), optional :: position(*)
      real(c_double), intent(in), optional :: axis(*)
      type(fmc_pose), intent(inout), optional :: pose
      integer(c_int32_t) :: fmc_pose_along
    end function
    function fmc_shape_init(shape, kind) bind(c)
      import
      type(fmc_shape), intent(inout), optional :: shape
      integer(c_int32_t), value :: kind
      integer(c_int32_t) :: fmc_shape_init
    end function
    function fmc_context_add_obstacle(context, shape, pose, obstacle) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_shape), intent(in), optional :: shape
      type(fmc_pose), intent(in), optional :: pose
      integer(c_size_t), intent(inout), optional :: obstacle
      integer(c_int32_t) :: fmc_context_add_obstacle
    end function
    function fmc_context_obstacle_shape(context, obstacle, kind, pose) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: obstacle
      integer(c_int32_t), intent(inout), optional :: kind(*)
      type(fmc_pose), intent(inout), optional :: pose
      integer(c_int32_t) :: fmc_context_obstacle_shape
    end function
    function fmc_context_set_pose(context, obstacle, pose) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: obstacle
      type(fmc_pose), intent(in), optional :: pose
      integer(c_int32_t) :: fmc_context_set_pose
    end function
    function fmc_context_remove_obstacle(context, obstacle) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: obstacle
      integer(c_int32_t) :: fmc_context_remove_obstacle
    end function
    function fmc_pair_options_init(options) bind(c)
      import
      type(fmc_pair_options), intent(inout), optional :: options
      integer(c_int32_t) :: fmc_pair_options_init
    end function
    function fmc_context_set_pair_options(context, a_kind, a, b_kind, b, options) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_pair_options), intent(in), optional :: options
      integer(c_int32_t) :: fmc_context_set_pair_options
    end function
    function fmc_context_pair_options(context, a_kind, a, b_kind, b, options) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_pair_options), intent(inout), optional :: options
      integer(c_int32_t) :: fmc_context_pair_options
    end function
    function fmc_orthotropic_friction_init(friction) bind(c)
      import
      type(fmc_orthotropic_friction), intent(inout), optional :: friction
      integer(c_int32_t) :: fmc_orthotropic_friction_init
    end function
    function fmc_context_set_orthotropic_pair(context, a_kind, a, b_kind, b, options, &
        friction) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_pair_options), intent(in), optional :: options
      type(fmc_orthotropic_friction), intent(in), optional :: friction
      integer(c_int32_t) :: fmc_context_set_orthotropic_pair
    end function
    function fmc_context_orthotropic_pair(context, a_kind, a, b_kind, b, friction) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_orthotropic_friction), intent(inout), optional :: friction
      integer(c_int32_t) :: fmc_context_orthotropic_pair
    end function
    function fmc_ppr_init(ppr) bind(c)
      import
      type(fmc_ppr), intent(inout), optional :: ppr
      integer(c_int32_t) :: fmc_ppr_init
    end function
    function fmc_context_set_ppr_pair(context, a_kind, a, b_kind, b, options, ppr) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_pair_options), intent(in), optional :: options
      type(fmc_ppr), intent(in), optional :: ppr
      integer(c_int32_t) :: fmc_context_set_ppr_pair
    end function
    function fmc_context_ppr_pair(context, a_kind, a, b_kind, b, ppr) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_ppr), intent(inout), optional :: ppr
      integer(c_int32_t) :: fmc_context_ppr_pair
    end function
    function fmc_own_law_init(law) bind(c)
      import
      type(fmc_own_law), intent(inout), optional :: law
      integer(c_int32_t) :: fmc_own_law_init
    end function
    function fmc_own_law_check(law, dim, scale, jump, jump_count, time_step, tell, user) bind(c)
      import
      type(fmc_own_law), intent(in), optional :: law
      integer(c_size_t), value :: dim
      real(c_double), value :: scale
      real(c_double), intent(in), optional :: jump(*)
      integer(c_size_t), value :: jump_count
      real(c_double), value :: time_step
      type(c_funptr), value :: tell
      type(c_ptr), value :: user
      integer(c_int32_t) :: fmc_own_law_check
    end function
    function fmc_context_set_law_fields(context, values, row_count, field_count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: values(*)
      integer(c_size_t), value :: row_count
      integer(c_size_t), value :: field_count
      integer(c_int32_t) :: fmc_context_set_law_fields
    end function
    function fmc_context_set_law_pair(context, a_kind, a, b_kind, b, options, law) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_pair_options), intent(in), optional :: options
      type(fmc_own_law), intent(in), optional :: law
      integer(c_int32_t) :: fmc_context_set_law_pair
    end function
    function fmc_friction_law_init(law) bind(c)
      import
      type(fmc_friction_law), intent(inout), optional :: law
      integer(c_int32_t) :: fmc_friction_law_init
    end function
    function fmc_friction_law_check(law, dim, pressure, slip, time_step, tell, user) bind(c)
      import
      type(fmc_friction_law), intent(in), optional :: law
      integer(c_size_t), value :: dim
      real(c_double), value :: pressure
      real(c_double), value :: slip
      real(c_double), value :: time_step
      type(c_funptr), value :: tell
      type(c_ptr), value :: user
      integer(c_int32_t) :: fmc_friction_law_check
    end function
    function fmc_context_set_friction_law_pair(context, a_kind, a, b_kind, b, options, law) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      type(fmc_pair_options), intent(in), optional :: options
      type(fmc_friction_law), intent(in), optional :: law
      integer(c_int32_t) :: fmc_context_set_friction_law_pair
    end function
    function fmc_context_evaluate(context, coords, forces, flags, result) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_forces), intent(in), optional :: forces
      integer(c_int32_t), value :: flags
      type(fmc_result), intent(inout), optional :: result
      integer(c_int32_t) :: fmc_context_evaluate
    end function
    function fmc_context_body_resultant(context, index, body) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: index
      type(fmc_resultant), intent(inout), optional :: body
      integer(c_int32_t) :: fmc_context_body_resultant
    end function
    function fmc_context_obstacle_resultant(context, index, obstacle) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: index
      type(fmc_resultant), intent(inout), optional :: obstacle
      integer(c_int32_t) :: fmc_context_obstacle_resultant
    end function
    function fmc_context_pair_result(context, index, pair) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: index
      type(fmc_pair_result), intent(inout), optional :: pair
      integer(c_int32_t) :: fmc_context_pair_result
    end function
    function fmc_context_warning(context, index, code, text) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: index
      integer(c_int32_t), intent(inout), optional :: code
      type(c_ptr), intent(inout), optional :: text
      integer(c_int32_t) :: fmc_context_warning
    end function
    function fmc_context_tangent(context, coords, flags, rank_one_count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t), value :: flags
      integer(c_size_t), intent(inout), optional :: rank_one_count
      integer(c_int32_t) :: fmc_context_tangent
    end function
    function fmc_context_tangent_entries(context, rows, cols, values, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: rows(*)
      type(*), intent(inout), optional :: cols(*)
      real(c_double), intent(inout), optional :: values(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_tangent_entries
    end function
    function fmc_context_tangent_product(context, x, y, length) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: x(*)
      real(c_double), intent(inout), optional :: y(*)
      integer(c_size_t), value :: length
      integer(c_int32_t) :: fmc_context_tangent_product
    end function
    function fmc_context_tangent_rank_one(context, index, factor, vector, length) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: index
      real(c_double), intent(inout), optional :: factor
      real(c_double), intent(inout), optional :: vector(*)
      integer(c_size_t), value :: length
      integer(c_int32_t) :: fmc_context_tangent_rank_one
    end function
    function fmc_context_tangent_csr(context, flags, row_offsets, offset_capacity, offset_count, &
        cols, values, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: flags
      type(*), intent(inout), optional :: row_offsets(*)
      integer(c_size_t), value :: offset_capacity
      integer(c_size_t), intent(inout), optional :: offset_count
      type(*), intent(inout), optional :: cols(*)
      real(c_double), intent(inout), optional :: values(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_tangent_csr
    end function
    function fmc_context_keep_pattern(context, keep) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: keep
      integer(c_int32_t) :: fmc_context_keep_pattern
    end function
    function fmc_context_evaluate_tangent(context, coords, flags, forces, result, &
        rank_one_count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t), value :: flags
      type(fmc_forces), intent(in), optional :: forces
      type(fmc_result), intent(inout), optional :: result
      integer(c_size_t), intent(inout), optional :: rank_one_count
      integer(c_int32_t) :: fmc_context_evaluate_tangent
    end function
    function fmc_context_set_obstacle_rotations(context, on) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: on
      integer(c_int32_t) :: fmc_context_set_obstacle_rotations
    end function
    function fmc_context_begin_step(context, coords) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t) :: fmc_context_begin_step
    end function
    function fmc_context_commit_step(context, coords) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t) :: fmc_context_commit_step
    end function
    function fmc_context_freeze_friction(context, coords) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t) :: fmc_context_freeze_friction
    end function
    function fmc_context_keep_patches(context, coords, direction_count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_size_t), intent(inout), optional :: direction_count
      integer(c_int32_t) :: fmc_context_keep_patches
    end function
    function fmc_context_stable_step(context, coords, masses, step) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), intent(in), optional :: masses(*)
      real(c_double), intent(inout), optional :: step
      integer(c_int32_t) :: fmc_context_stable_step
    end function
    function fmc_context_stiffness_from_masses(context, coords, masses, limit) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), intent(in), optional :: masses(*)
      real(c_double), value :: limit
      integer(c_int32_t) :: fmc_context_stiffness_from_masses
    end function
    function fmc_context_step_limit(context, coords, step, limit) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_coords), intent(in), optional :: step
      type(fmc_step_limit), intent(inout), optional :: limit
      integer(c_int32_t) :: fmc_context_step_limit
    end function
    function fmc_context_adjust(context, coords, close, remove, adjustment) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), value :: close
      real(c_double), value :: remove
      type(fmc_adjustment), intent(inout), optional :: adjustment
      integer(c_int32_t) :: fmc_context_adjust
    end function
    function fmc_context_offsets(context, offsets, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: offsets(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_offsets
    end function
    function fmc_context_set_offsets(context, offsets, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: offsets(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_offsets
    end function
    function fmc_context_augment(context, coords, reach, tolerance, result) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), value :: reach
      real(c_double), value :: tolerance
      type(fmc_augmentation), intent(inout), optional :: result
      integer(c_int32_t) :: fmc_context_augment
    end function
    function fmc_context_stiffen(context, factor) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), value :: factor
      integer(c_int32_t) :: fmc_context_stiffen
    end function
    function fmc_equilibrium_options_init(options) bind(c)
      import
      type(fmc_equilibrium_options), intent(inout), optional :: options
      integer(c_int32_t) :: fmc_equilibrium_options_init
    end function
    function fmc_equilibrium_problem_init(problem) bind(c)
      import
      type(fmc_equilibrium_problem), intent(inout), optional :: problem
      integer(c_int32_t) :: fmc_equilibrium_problem_init
    end function
    function fmc_equilibrium_answer_init(answer) bind(c)
      import
      type(fmc_equilibrium_answer), intent(inout), optional :: answer
      integer(c_int32_t) :: fmc_equilibrium_answer_init
    end function
    function fmc_equilibrium_new(context, problem, options, equilibrium) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_equilibrium_problem), intent(in), optional :: problem
      type(fmc_equilibrium_options), intent(in), optional :: options
      type(c_ptr), intent(inout), optional :: equilibrium
      integer(c_int32_t) :: fmc_equilibrium_new
    end function
    function fmc_equilibrium_next(context, equilibrium, answer, request) bind(c)
      import
      type(c_ptr), value :: context
      type(c_ptr), value :: equilibrium
      type(fmc_equilibrium_answer), intent(in), optional :: answer
      type(fmc_equilibrium_request), intent(inout), optional :: request
      integer(c_int32_t) :: fmc_equilibrium_next
    end function
    function fmc_equilibrium_abandon(context, equilibrium) bind(c)
      import
      type(c_ptr), value :: context
      type(c_ptr), value :: equilibrium
      integer(c_int32_t) :: fmc_equilibrium_abandon
    end function
    function fmc_equilibrium_found(equilibrium, result) bind(c)
      import
      type(c_ptr), value :: equilibrium
      type(fmc_equilibrium_result), intent(inout), optional :: result
      integer(c_int32_t) :: fmc_equilibrium_found
    end function
    function fmc_equilibrium_text(equilibrium, number) bind(c)
      import
      type(c_ptr), value :: equilibrium
      integer(c_size_t), value :: number
      type(c_ptr) :: fmc_equilibrium_text
    end function
    function fmc_equilibrium_free(equilibrium) bind(c)
      import
      type(c_ptr), intent(inout), optional :: equilibrium
      integer(c_int32_t) :: fmc_equilibrium_free
    end function
    function fmc_contact_step_options_init(options) bind(c)
      import
      type(fmc_contact_step_options), intent(inout), optional :: options
      integer(c_int32_t) :: fmc_contact_step_options_init
    end function
    function fmc_context_contact_step(context, coords, options, dofs, dof_count, fixed_dofs, &
        fixed_count, stiffness, residual, place, user, displacement, result) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_contact_step_options), intent(in), optional :: options
      type(*), intent(in), optional :: dofs(*)
      integer(c_size_t), value :: dof_count
      type(*), intent(in), optional :: fixed_dofs(*)
      integer(c_size_t), value :: fixed_count
      real(c_double), intent(in), optional :: stiffness(*)
      real(c_double), intent(in), optional :: residual(*)
      type(c_funptr), value :: place
      type(c_ptr), value :: user
      real(c_double), intent(inout), optional :: displacement(*)
      type(fmc_contact_step_result), intent(inout), optional :: result
      integer(c_int32_t) :: fmc_context_contact_step
    end function
    function fmc_condensation_new(condensation) bind(c)
      import
      type(c_ptr), intent(inout), optional :: condensation
      integer(c_int32_t) :: fmc_condensation_new
    end function
    function fmc_condensation_free(condensation) bind(c)
      import
      type(c_ptr), intent(inout), optional :: condensation
      integer(c_int32_t) :: fmc_condensation_free
    end function
    function fmc_condensation_factorise(condensation, matrix, retained, retained_count) bind(c)
      import
      type(c_ptr), value :: condensation
      type(fmc_csr), intent(in), optional :: matrix
      type(*), intent(in), optional :: retained(*)
      integer(c_size_t), value :: retained_count
      integer(c_int32_t) :: fmc_condensation_factorise
    end function
    function fmc_condensation_complement(condensation, complement, capacity, count) bind(c)
      import
      type(c_ptr), value :: condensation
      real(c_double), intent(inout), optional :: complement(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_condensation_complement
    end function
    function fmc_condensation_condense(condensation, right, right_count, condensed, capacity, &
        count) bind(c)
      import
      type(c_ptr), value :: condensation
      real(c_double), intent(in), optional :: right(*)
      integer(c_size_t), value :: right_count
      real(c_double), intent(inout), optional :: condensed(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_condensation_condense
    end function
    function fmc_condensation_expand(condensation, right, right_count, retained, retained_count, &
        solution, capacity, count) bind(c)
      import
      type(c_ptr), value :: condensation
      real(c_double), intent(in), optional :: right(*)
      integer(c_size_t), value :: right_count
      real(c_double), intent(in), optional :: retained(*)
      integer(c_size_t), value :: retained_count
      real(c_double), intent(inout), optional :: solution(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_condensation_expand
    end function
    function fmc_nodal_contact_init(nodal) bind(c)
      import
      type(fmc_nodal_contact), intent(inout), optional :: nodal
      integer(c_int32_t) :: fmc_nodal_contact_init
    end function
    function fmc_context_nodal_contact(context, coords, nodal) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_nodal_contact), intent(in), optional :: nodal
      integer(c_int32_t) :: fmc_context_nodal_contact
    end function
    function fmc_context_contact_points(context, coords, points, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_contact_point), intent(inout), optional :: points(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_contact_points
    end function
    function fmc_context_gap_constraints(context, coords, reach, rows, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), value :: reach
      type(fmc_gap_constraint), intent(inout), optional :: rows(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_gap_constraints
    end function
    function fmc_context_gap_gradient(context, row_offsets, offset_capacity, offset_count, cols, &
        values, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: row_offsets(*)
      integer(c_size_t), value :: offset_capacity
      integer(c_size_t), intent(inout), optional :: offset_count
      type(*), intent(inout), optional :: cols(*)
      real(c_double), intent(inout), optional :: values(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_gap_gradient
    end function
    function fmc_context_tie(context, a, b, tie) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: a
      integer(c_size_t), value :: b
      type(fmc_tie), intent(inout), optional :: tie
      integer(c_int32_t) :: fmc_context_tie
    end function
    function fmc_context_tie_nodes(context, coords, rows, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_tie_node), intent(inout), optional :: rows(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_tie_nodes
    end function
    function fmc_context_tie_constraints(context, row_offsets, offset_capacity, offset_count, &
        cols, values, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: row_offsets(*)
      integer(c_size_t), value :: offset_capacity
      integer(c_size_t), intent(inout), optional :: offset_count
      type(*), intent(inout), optional :: cols(*)
      real(c_double), intent(inout), optional :: values(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_tie_constraints
    end function
    function fmc_context_add_tie(context, surface_a, surface_b, period, reach, tie) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: surface_a
      integer(c_int32_t), value :: surface_b
      real(c_double), intent(in), optional :: period(*)
      real(c_double), value :: reach
      integer(c_int32_t), intent(inout), optional :: tie(*)
      integer(c_int32_t) :: fmc_context_add_tie
    end function
    function fmc_context_remove_tie(context, tie) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tie
      integer(c_int32_t) :: fmc_context_remove_tie
    end function
    function fmc_context_set_tie_jump(context, tie, jump) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tie
      real(c_double), intent(in), optional :: jump(*)
      integer(c_int32_t) :: fmc_context_set_tie_jump
    end function
    function fmc_context_added_tie(context, tie, found) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tie
      type(fmc_tie), intent(inout), optional :: found
      integer(c_int32_t) :: fmc_context_added_tie
    end function
    function fmc_context_tie_force(context, coords, tie, force, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t), value :: tie
      real(c_double), intent(inout), optional :: force(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_tie_force
    end function
    function fmc_conductance_init(conductance) bind(c)
      import
      type(fmc_conductance), intent(inout), optional :: conductance
      integer(c_int32_t) :: fmc_conductance_init
    end function
    function fmc_context_flux(context, coords, conductance, field_count, fields, of_obstacles, &
        flux, obstacle_flux) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_conductance), intent(in), optional :: conductance
      integer(c_size_t), value :: field_count
      real(c_double), intent(in), optional :: fields(*)
      real(c_double), intent(in), optional :: of_obstacles(*)
      real(c_double), intent(inout), optional :: flux(*)
      real(c_double), intent(inout), optional :: obstacle_flux(*)
      integer(c_int32_t) :: fmc_context_flux
    end function
    function fmc_context_flux_matrix(context, row_offsets, offset_capacity, offset_count, cols, &
        values, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: row_offsets(*)
      integer(c_size_t), value :: offset_capacity
      integer(c_size_t), intent(inout), optional :: offset_count
      type(*), intent(inout), optional :: cols(*)
      real(c_double), intent(inout), optional :: values(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_flux_matrix
    end function
    function fmc_context_friction_heat(context, coords, effusivities, heat, obstacle_heat) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), intent(in), optional :: effusivities(*)
      real(c_double), intent(inout), optional :: heat(*)
      real(c_double), intent(inout), optional :: obstacle_heat(*)
      integer(c_int32_t) :: fmc_context_friction_heat
    end function
    function fmc_context_cohesive(context, a, b, coords, cohesive) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_size_t), value :: a
      integer(c_size_t), value :: b
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_cohesive), intent(inout), optional :: cohesive
      integer(c_int32_t) :: fmc_context_cohesive
    end function
    function fmc_context_cohesive_points(context, coords, rows, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_cohesive_point), intent(inout), optional :: rows(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_cohesive_points
    end function
    function fmc_context_law_points(context, coords, rows, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_law_point), intent(inout), optional :: rows(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_law_points
    end function
    function fmc_context_boundary_facets(context, facets, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_boundary_facet), intent(inout), optional :: facets(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_boundary_facets
    end function
    function fmc_context_point_weights(context, row_offsets, offset_capacity, offset_count, &
        nodes, weights, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: row_offsets(*)
      integer(c_size_t), value :: offset_capacity
      integer(c_size_t), intent(inout), optional :: offset_count
      type(*), intent(inout), optional :: nodes(*)
      real(c_double), intent(inout), optional :: weights(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_point_weights
    end function
    function fmc_gradients_init(gradients) bind(c)
      import
      type(fmc_gradients), intent(inout), optional :: gradients
      integer(c_int32_t) :: fmc_gradients_init
    end function
    function fmc_context_vjp(context, coords, energy, adjoint, gradients, pairs, capacity, &
        count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      real(c_double), value :: energy
      type(fmc_coords), intent(in), optional :: adjoint
      type(fmc_gradients), intent(in), optional :: gradients
      type(fmc_pair_gradient), intent(inout), optional :: pairs
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_vjp
    end function
    function fmc_directions_init(directions) bind(c)
      import
      type(fmc_directions), intent(inout), optional :: directions
      integer(c_int32_t) :: fmc_directions_init
    end function
    function fmc_context_jvp(context, coords, directions, energy, forces) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      type(fmc_directions), intent(in), optional :: directions
      real(c_double), intent(inout), optional :: energy(*)
      real(c_double), intent(inout), optional :: forces(*)
      integer(c_int32_t) :: fmc_context_jvp
    end function
    function fmc_equilibrium_adjoint(context, problem, by_x, by_forces, balance, right, &
        gradients, pairs, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_equilibrium_problem), intent(in), optional :: problem
      real(c_double), intent(in), optional :: by_x(*)
      real(c_double), intent(in), optional :: by_forces(*)
      real(c_double), intent(in), optional :: balance(*)
      real(c_double), intent(inout), optional :: right(*)
      type(fmc_gradients), intent(in), optional :: gradients
      type(fmc_pair_gradient), intent(inout), optional :: pairs
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_equilibrium_adjoint
    end function
    function fmc_context_set_pair_wear(context, a_kind, a, b_kind, b, wear_a, wear_b) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      real(c_double), value :: wear_a
      real(c_double), value :: wear_b
      integer(c_int32_t) :: fmc_context_set_pair_wear
    end function
    function fmc_context_pair_wear(context, a_kind, a, b_kind, b, wear_a, wear_b) bind(c)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: a_kind
      integer(c_size_t), value :: a
      integer(c_int32_t), value :: b_kind
      integer(c_size_t), value :: b
      real(c_double), intent(inout), optional :: wear_a(*)
      real(c_double), intent(inout), optional :: wear_b(*)
      integer(c_int32_t) :: fmc_context_pair_wear
    end function
    function fmc_context_worn_depth(context, depth, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: depth(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_worn_depth
    end function
    function fmc_context_worn_volumes(context, volumes, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: volumes(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_worn_volumes
    end function
    function fmc_context_worn_facets(context, worn, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: worn(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_worn_facets
    end function
    function fmc_context_set_worn_facets(context, worn, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: worn(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_worn_facets
    end function
    function fmc_context_set_wear_cycles(context, cycles) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), value :: cycles
      integer(c_int32_t) :: fmc_context_set_wear_cycles
    end function
    function fmc_context_slip(context, slip, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: slip(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_slip
    end function
    function fmc_context_set_slip(context, slip, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: slip(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_slip
    end function
    function fmc_context_friction_history(context, history, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: history(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_friction_history
    end function
    function fmc_context_set_friction_history(context, history, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: history(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_friction_history
    end function
    function fmc_context_damage(context, damage, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: damage(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_damage
    end function
    function fmc_context_set_damage(context, damage, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: damage(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_damage
    end function
    function fmc_context_cohesive_history(context, history, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: history(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_cohesive_history
    end function
    function fmc_context_set_cohesive_history(context, history, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: history(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_cohesive_history
    end function
    function fmc_context_set_time_step(context, time_step) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), value :: time_step
      integer(c_int32_t) :: fmc_context_set_time_step
    end function
    function fmc_context_law_history(context, history, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(inout), optional :: history(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_law_history
    end function
    function fmc_context_set_law_history(context, history, count) bind(c)
      import
      type(c_ptr), value :: context
      real(c_double), intent(in), optional :: history(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_law_history
    end function
    function fmc_context_multipliers(context, rows, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_multiplier), intent(inout), optional :: rows(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_multipliers
    end function
    function fmc_context_set_multipliers(context, rows, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_multiplier), intent(in), optional :: rows(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_multipliers
    end function
    function fmc_communicator_init(communicator) bind(c)
      import
      type(fmc_communicator), intent(inout), optional :: communicator
      integer(c_int32_t) :: fmc_communicator_init
    end function
    function fmc_context_set_communicator(context, communicator) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_communicator), intent(in), optional :: communicator
      integer(c_int32_t) :: fmc_context_set_communicator
    end function
    function fmc_context_rank_counts(context, counts) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_rank_counts), intent(inout), optional :: counts
      integer(c_int32_t) :: fmc_context_rank_counts
    end function
    function fmc_mesh_part_init(part) bind(c)
      import
      type(fmc_mesh_part), intent(inout), optional :: part
      integer(c_int32_t) :: fmc_mesh_part_init
    end function
    function fmc_context_new_from_part(dim, communicator, part, options, context) bind(c)
      import
      integer(c_int32_t), value :: dim
      type(fmc_communicator), intent(in), optional :: communicator
      type(fmc_mesh_part), intent(in), optional :: part
      type(fmc_options), intent(in), optional :: options
      type(c_ptr), intent(inout), optional :: context
      integer(c_int32_t) :: fmc_context_new_from_part
    end function
    function fmc_context_set_coords(context, coords, renumbered) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_coords), intent(in), optional :: coords
      integer(c_int32_t), intent(inout), optional :: renumbered
      integer(c_int32_t) :: fmc_context_set_coords
    end function
    function fmc_context_set_carried_slip(context, carried, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_carried_slip), intent(in), optional :: carried(*)
      integer(c_size_t), value :: count
      integer(c_int32_t) :: fmc_context_set_carried_slip
    end function
    function fmc_context_gathered_counts(context, counts) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_gathered_counts), intent(inout), optional :: counts
      integer(c_int32_t) :: fmc_context_gathered_counts
    end function
    function fmc_context_gathered_nodes(context, numbers, own_nodes, coords, capacity, &
        count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: numbers(*)
      type(*), intent(inout), optional :: own_nodes(*)
      real(c_double), intent(inout), optional :: coords(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_gathered_nodes
    end function
    function fmc_context_gathered_cells(context, numbers, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(*), intent(inout), optional :: numbers(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_gathered_cells
    end function
    function fmc_context_carried_slip(context, carried, capacity, count) bind(c)
      import
      type(c_ptr), value :: context
      type(fmc_carried_slip), intent(inout), optional :: carried(*)
      integer(c_size_t), value :: capacity
      integer(c_size_t), intent(inout), optional :: count
      integer(c_int32_t) :: fmc_context_carried_slip
    end function
    function fmc_context_free(context) bind(c)
      import
      type(c_ptr), intent(inout), optional :: context
      integer(c_int32_t) :: fmc_context_free
    end function
    function fmc_friction_step_init(step) bind(c)
      import
      type(fmc_friction_step), intent(inout), optional :: step
      integer(c_int32_t) :: fmc_friction_step_init
    end function
    function fmc_contact_force(dim, coords, node_count, blocks, block_count, body_ids, options, &
        step, forces, volume) bind(c)
      import
      integer(c_int32_t), value :: dim
      real(c_double), intent(in), optional :: coords(*)
      integer(c_size_t), value :: node_count
      type(fmc_cell_block), intent(in), optional :: blocks(*)
      integer(c_size_t), value :: block_count
      type(*), intent(in), optional :: body_ids(*)
      type(fmc_options), intent(in), optional :: options
      type(fmc_friction_step), intent(in), optional :: step
      real(c_double), intent(inout), optional :: forces(*)
      real(c_double), intent(inout), optional :: volume
      integer(c_int32_t) :: fmc_contact_force
    end function
  end interface
end module
