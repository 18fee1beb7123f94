! Contact forces from overlap volume, for finite element codes in Fortran.
!
!   use fmc_contact
!   type(contact) :: bodies
!   type(fmc_options) :: options
!   type(fmc_result) :: found
!   options = contact_options(stiffness=1d8)
!   call bodies%from_cells(x, FMC_TET4, conn, options)      ! x(3, nodes), conn(4, cells) counted from 1
!   call bodies%evaluate(x, forces, found)                  ! forces(3, nodes), pushing bodies apart
!
! Arrays are by columns, a column for every node, cell or contact point. Nodes, bodies, obstacles, pairs and facets count from 1.
! Rows and columns of tangents count from 1, too: degree of freedom (node - 1) * dim + axis. Units are the host's.
! include/fmc_contact.h documents each function, its errors and its options, under the name next to it. Whatever is not here is
! called through module fmc_contact_c with the component `handle`.
!
! Errors: every procedure has an optional last argument `stat`, 0 or a value FMC_ERROR_...; contact_error() is the text.
! Without `stat` an error stops the program with that text, as for `allocate`. After an error nothing has changed.
!
! Requires Fortran 2018 (optional arguments of bind(c)): gfortran 9, ifx 2022 and later. To be compiled with the host:
! fmc_contact_c.f90, then this file.
module fmc_contact
  use fmc_contact_c
  implicit none
  public
  ! Procedures of the type: their names remain the host's.
  private :: from_cells, from_blocks, from_facets, take, free, set_options, set_pair_options, set_orthotropic_pair, &
             set_ppr_pair, set_law_pair, law_history, set_law_history, set_law_fields, &
             set_friction_law_pair, friction_history, set_friction_history, &
             set_reference, set_interrupt, &
             set_symmetry_planes, set_symmetry_nodes, set_surface_smoothing, set_basis, &
             evaluate, tangent, evaluate_tangent, stable_step, body, &
             obstacle, pair, warning, add_obstacle, add_half_space, add_polytope, &
             add_convex_hull, add_signed_distance, set_pose, remove_obstacle, &
             keep_patches, begin_step, commit_step, freeze_friction, slip, set_slip, nodal_contact, &
             set_pair_wear, worn_depth, worn_volumes, worn_facets, set_worn_facets, set_wear_cycles, &
             contact_points, gap_constraints, tie, tie_nodes, augment, multipliers, set_multipliers, boundary_facets, placed, &
             unplaced, view, onto, law_of, friction_law_of, checked, copy_text, copied, finished

  ! Bodies in contact with one another and with obstacles. Given back when it goes out of scope; it cannot be copied.
  type :: contact
    type(c_ptr) :: handle = c_null_ptr
    integer :: dim = 0
  contains
    procedure :: from_cells, from_blocks, from_facets, free
    procedure :: set_options, set_pair_options, set_orthotropic_pair, set_ppr_pair
    procedure :: set_law_pair, law_history, set_law_history, set_law_fields
    procedure :: set_friction_law_pair, friction_history, set_friction_history
    procedure :: set_reference, set_symmetry_planes, set_symmetry_nodes, set_basis
    procedure :: set_surface_smoothing
    procedure :: set_interrupt
    procedure :: evaluate, tangent, evaluate_tangent, stable_step
    procedure :: body, obstacle, pair, warning
    procedure :: add_obstacle, add_half_space, add_polytope, add_convex_hull, add_signed_distance
    procedure :: set_pose, remove_obstacle
    procedure :: keep_patches, begin_step, commit_step, freeze_friction, slip, set_slip
    procedure :: set_pair_wear, worn_depth, worn_volumes, worn_facets, set_worn_facets, set_wear_cycles
    procedure :: nodal_contact, contact_points, gap_constraints, boundary_facets
    procedure :: tie, tie_nodes
    procedure :: augment, multipliers, set_multipliers
    procedure, private :: copied, take
    generic :: assignment(=) => copied
    final :: finished
  end type

contains

  ! Options with their defaults, and nodes that count from 1 (fmc_options_init).
  function contact_options(stiffness, law, estimator) result(options)
    real(c_double), intent(in) :: stiffness
    integer(c_int32_t), intent(in), optional :: law, estimator
    type(fmc_options) :: options
    call checked(fmc_options_init(options))
    options%stiffness = stiffness
    options%index_base = 1
    if (present(law)) options%law = law
    if (present(estimator)) options%estimator = estimator
  end function

  ! Text of the last error of this thread (fmc_last_error).
  function contact_error() result(text)
    character(:), allocatable :: text
    type(c_ptr) :: found
    found = fmc_last_error()
    call copy_text(found, text)
  end function

  ! Cells of one type for from_blocks: conn(nodes of a cell, cells), which must live until that call.
  function cells(cell_type, conn) result(block)
    integer(c_int32_t), intent(in) :: cell_type
    integer(c_int32_t), intent(in), contiguous, target :: conn(:, :)
    type(fmc_cell_block) :: block
    block%cell_type = cell_type
    block%index_size = 4
    block%conn = c_loc(conn)
    block%cell_count = size(conn, 2, c_size_t)
  end function

  ! Facets of one type for from_facets: conn(nodes of a facet, facets), which must live until that call.
  function facets(facet_type, conn) result(block)
    integer(c_int32_t), intent(in) :: facet_type
    integer(c_int32_t), intent(in), contiguous, target :: conn(:, :)
    type(fmc_facet_block) :: block
    block%facet_type = facet_type
    block%index_size = 4
    block%conn = c_loc(conn)
    block%facet_count = size(conn, 2, c_size_t)
  end function

  ! Bodies of cells of one type: x(dim, nodes), conn(nodes of a cell, cells); body_ids(cells), else bodies are the connected
  ! components (fmc_context_new_from_cells).
  subroutine from_cells(self, x, cell_type, conn, options, body_ids, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    integer(c_int32_t), intent(in) :: cell_type
    integer(c_int32_t), intent(in), contiguous, target :: conn(:, :)
    type(fmc_options), intent(in) :: options
    integer(c_int32_t), intent(in), optional :: body_ids(:)
    integer, intent(out), optional :: stat
    call self%from_blocks(x, [cells(cell_type, conn)], options, body_ids, stat)
  end subroutine

  ! The same of a mixed mesh: blocks = [cells(FMC_HEX8, hexes), cells(FMC_TET4, tets)]; body_ids through all of them.
  subroutine from_blocks(self, x, blocks, options, body_ids, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    type(fmc_cell_block), intent(in) :: blocks(:)
    type(fmc_options), intent(in) :: options
    integer(c_int32_t), intent(in), optional :: body_ids(:)
    integer, intent(out), optional :: stat
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    made = c_null_ptr
    status = fmc_context_new_from_cells(size(x, 1), view(x), blocks, size(blocks, kind=c_size_t), body_ids, options, made)
    call self%take(made, size(x, 1), status, stat)
  end subroutine

  ! Bodies of closed surfaces, oriented outwards as for fmc_context_new_from_facets: blocks = [facets(FMC_FACET_TRI6, curved),
  ! facets(FMC_FACET_TRI3, flat)]; body_ids through all of them.
  subroutine from_facets(self, x, blocks, options, body_ids, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    type(fmc_facet_block), intent(in) :: blocks(:)
    type(fmc_options), intent(in) :: options
    integer(c_int32_t), intent(in), optional :: body_ids(:)
    integer, intent(out), optional :: stat
    type(c_ptr) :: made
    integer(c_int32_t) :: status
    made = c_null_ptr
    status = fmc_context_new_from_facets(size(x, 1), view(x), blocks, size(blocks, kind=c_size_t), body_ids, options, made)
    call self%take(made, size(x, 1), status, stat)
  end subroutine

  ! Another handle in place of the one there is, if it was made.
  subroutine take(self, made, dim, status, stat)
    class(contact), intent(inout) :: self
    type(c_ptr), intent(in) :: made
    integer, intent(in) :: dim
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    if (status == FMC_OK) then
      call self%free()
      self%handle = made
      self%dim = dim
    end if
    call checked(status, stat)
  end subroutine

  ! Gives the bodies back; also done at the end of the scope.
  subroutine free(self)
    class(contact), intent(inout) :: self
    if (c_associated(self%handle)) call checked(fmc_context_free(self%handle))
    self%handle = c_null_ptr
  end subroutine

  subroutine set_options(self, options, stat)
    class(contact), intent(inout) :: self
    type(fmc_options), intent(in) :: options
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_options(self%handle, options), stat)
  end subroutine

  ! A function bind(c) of interface fmc_interrupt_callback, which is asked some twenty times a second whether the call that is
  ! running is to end: 0 to go on. A call that is ended gives FMC_ERROR_INTERRUPTED.
  subroutine set_interrupt(self, asked, stat)
    class(contact), intent(inout) :: self
    procedure(fmc_interrupt_callback) :: asked
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_interrupt(self%handle, c_funloc(asked), c_null_ptr), stat)
  end subroutine

  ! Options of one pair, from fmc_pair_options_init; kinds FMC_PARTNER_BODY and FMC_PARTNER_OBSTACLE.
  subroutine set_pair_options(self, a_kind, a, b_kind, b, options, stat)
    class(contact), intent(inout) :: self
    integer(c_int32_t), intent(in) :: a_kind, b_kind
    integer, intent(in) :: a, b
    type(fmc_pair_options), intent(in) :: options
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_pair_options(self%handle, a_kind, int(a - 1, c_size_t), b_kind, &
                                              int(b - 1, c_size_t), options), stat)
  end subroutine

  ! The same with another coefficient of friction across a direction (fmc_orthotropic_friction_init).
  subroutine set_orthotropic_pair(self, a_kind, a, b_kind, b, options, friction, stat)
    class(contact), intent(inout) :: self
    integer(c_int32_t), intent(in) :: a_kind, b_kind
    integer, intent(in) :: a, b
    type(fmc_pair_options), intent(in) :: options
    type(fmc_orthotropic_friction), intent(in) :: friction
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_orthotropic_pair(self%handle, a_kind, int(a - 1, c_size_t), b_kind, &
                                                  int(b - 1, c_size_t), options, friction), stat)
  end subroutine

  ! The same with shapes of the cohesive law of FMC_SOFTENING_PPR (fmc_ppr_init).
  subroutine set_ppr_pair(self, a_kind, a, b_kind, b, options, ppr, stat)
    class(contact), intent(inout) :: self
    integer(c_int32_t), intent(in) :: a_kind, b_kind
    integer, intent(in) :: a, b
    type(fmc_pair_options), intent(in) :: options
    type(fmc_ppr), intent(in) :: ppr
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_ppr_pair(self%handle, a_kind, int(a - 1, c_size_t), b_kind, &
                                          int(b - 1, c_size_t), options, ppr), stat)
  end subroutine

  ! The same with your own law for FMC_INTERFACE_LAW, of bodies a and b: a function bind(c) of interface fmc_respond. Arrays of its
  ! structs come by c_f_pointer, with shapes [dim, count] and the like; tangents are (j, i, point): the derivative of traction i by jump j.
  ! Every point keeps history_count numbers.
  subroutine set_law_pair(self, a, b, options, respond, history_count, user, stat)
    class(contact), intent(inout) :: self
    integer, intent(in) :: a, b
    type(fmc_pair_options), intent(in) :: options
    procedure(fmc_respond) :: respond
    integer, intent(in), optional :: history_count
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_law_pair(self%handle, FMC_PARTNER_BODY, int(a - 1, c_size_t), FMC_PARTNER_BODY, &
                                          int(b - 1, c_size_t), options, law_of(respond, history_count, user)), stat)
  end subroutine

  ! The history of all points by your own laws, after the steps that were committed (fmc_context_law_history).
  subroutine law_history(self, history, stat)
    class(contact), intent(in) :: self
    real(c_double), intent(out), allocatable :: history(:)
    integer, intent(out), optional :: stat
    integer(c_int32_t) :: status
    integer(c_size_t) :: count
    count = 0
    status = fmc_context_law_history(self%handle, capacity=0_c_size_t, count=count)
    allocate (history(count))
    if (status == FMC_OK) status = fmc_context_law_history(self%handle, history, count)
    call checked(status, stat)
  end subroutine

  subroutine set_law_history(self, history, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous :: history(:)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_law_history(self%handle, history, size(history, kind=c_size_t)), stat)
  end subroutine

  ! The same with your own law of friction, a function bind(c) of interface fmc_limit_friction; every facet keeps history_count numbers for
  ! each of those that it faces. Arrays of its structs come by c_f_pointer, with shapes [dim - 1, count] and the like.
  subroutine set_friction_law_pair(self, a_kind, a, b_kind, b, options, limit, history_count, user, stat)
    class(contact), intent(inout) :: self
    integer(c_int32_t), intent(in) :: a_kind, b_kind
    integer, intent(in) :: a, b
    type(fmc_pair_options), intent(in) :: options
    procedure(fmc_limit_friction) :: limit
    integer, intent(in), optional :: history_count
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_friction_law_pair(self%handle, a_kind, int(a - 1, c_size_t), b_kind, int(b - 1, c_size_t), &
                                                   options, friction_law_of(limit, history_count, user)), stat)
  end subroutine

  ! History of laws of friction after the committed steps, in the order of the slip (fmc_context_friction_history).
  subroutine friction_history(self, history, stat)
    class(contact), intent(in) :: self
    real(c_double), intent(out), allocatable :: history(:)
    integer, intent(out), optional :: stat
    integer(c_int32_t) :: status
    integer(c_size_t) :: count
    count = 0
    status = fmc_context_friction_history(self%handle, capacity=0_c_size_t, count=count)
    allocate (history(count))
    if (status == FMC_OK) status = fmc_context_friction_history(self%handle, history, count)
    call checked(status, stat)
  end subroutine

  subroutine set_friction_history(self, history, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous :: history(:)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_friction_history(self%handle, history, size(history, kind=c_size_t)), stat)
  end subroutine

  ! Whether your own law of friction is one, by differences up to this pressure and slip (fmc_friction_law_check).
  subroutine check_friction_law(limit, dim, pressure, slip, time_step, history_count, user, stat)
    procedure(fmc_limit_friction) :: limit
    integer, intent(in) :: dim
    real(c_double), intent(in) :: pressure, slip, time_step
    integer, intent(in), optional :: history_count
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    call checked(fmc_friction_law_check(friction_law_of(limit, history_count, user), int(dim, c_size_t), pressure, slip, &
                                        time_step, tell=c_null_funptr, user=c_null_ptr), stat)
  end subroutine

  function friction_law_of(limit, history_count, user) result(law)
    procedure(fmc_limit_friction) :: limit
    integer, intent(in), optional :: history_count
    type(c_ptr), intent(in), optional :: user
    type(fmc_friction_law) :: law
    call checked(fmc_friction_law_init(law))
    law%limit = c_funloc(limit)
    if (present(history_count)) law%history_count = int(history_count, c_size_t)
    if (present(user)) law%user = user
  end function

  ! Fields that your own laws are asked with, a column for every node (fmc_context_set_law_fields).
  subroutine set_law_fields(self, values, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous :: values(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_law_fields(self%handle, values, size(values, 2, c_size_t), size(values, 1, c_size_t)), stat)
  end subroutine

  ! Checks your own law by differences at jumps of this scale; contact_error() names faults (fmc_own_law_check).
  subroutine check_law(respond, dim, scale, history_count, user, stat)
    procedure(fmc_respond) :: respond
    integer, intent(in) :: dim
    real(c_double), intent(in) :: scale
    integer, intent(in), optional :: history_count
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    call checked(fmc_own_law_check(law_of(respond, history_count, user), int(dim, c_size_t), scale, &
                                   jump_count=0_c_size_t, time_step=0d0, tell=c_null_funptr, user=c_null_ptr), stat)
  end subroutine

  function law_of(respond, history_count, user) result(law)
    procedure(fmc_respond) :: respond
    integer, intent(in), optional :: history_count
    type(c_ptr), intent(in), optional :: user
    type(fmc_own_law) :: law
    call checked(fmc_own_law_init(law))
    law%respond = c_funloc(respond)
    if (present(history_count)) law%history_count = int(history_count, c_size_t)
    if (present(user)) law%user = user
  end function

  ! Coordinates without deformation, from which the law `depth` has its depths (fmc_context_set_reference).
  subroutine set_reference(self, x, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_reference(self%handle, view(x)), stat)
  end subroutine

  ! Planes of symmetry, a point in each and a vector across it: (dim, planes) (fmc_context_set_symmetry_planes).
  subroutine set_symmetry_planes(self, points, normals, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous :: points(:, :), normals(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_symmetry_planes(self%handle, points, normals, size(points, 2, c_size_t)), stat)
  end subroutine

  ! Nodes in planes of symmetry, none if there are none (fmc_context_set_symmetry_nodes).
  subroutine set_symmetry_nodes(self, nodes, stat)
    class(contact), intent(inout) :: self
    integer, intent(in) :: nodes(:)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_symmetry_nodes(self%handle, int(nodes, c_int32_t), size(nodes, kind=c_size_t)), stat)
  end subroutine

  ! Straight faces that meet at less than this angle, in degrees, stand for a smooth surface; 0: none
  ! (fmc_context_set_surface_smoothing).
  subroutine set_surface_smoothing(self, feature_angle, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in) :: feature_angle
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_surface_smoothing(self%handle, feature_angle), stat)
  end subroutine

  ! Nodes as combinations of the host's own unknowns, in compressed rows that count from 1 (fmc_context_set_basis).
  subroutine set_basis(self, unknown_count, row_offsets, unknowns, weights, stat)
    class(contact), intent(inout) :: self
    integer, intent(in) :: unknown_count
    integer, intent(in), contiguous, target :: row_offsets(:), unknowns(:)
    real(c_double), intent(in), contiguous, target :: weights(:)
    integer, intent(out), optional :: stat
    type(fmc_csr) :: matrix
    call checked(fmc_csr_init(matrix))
    matrix%row_count = size(row_offsets, kind=c_size_t) - 1
    matrix%index_size = int(storage_size(row_offsets)/8, c_int32_t)
    matrix%index_base = 1
    matrix%row_offsets = c_loc(row_offsets)
    matrix%cols = c_loc(unknowns)
    matrix%values = c_loc(weights)
    call checked(fmc_context_set_basis(self%handle, matrix, int(unknown_count, c_size_t)), stat)
  end subroutine

  ! Forces at x, into forces(dim, nodes) or, with add, added to it (fmc_context_evaluate).
  subroutine evaluate(self, x, forces, found, add, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    real(c_double), intent(inout), contiguous, target :: forces(:, :)
    type(fmc_result), intent(out), optional :: found
    logical, intent(in), optional :: add
    integer, intent(out), optional :: stat
    type(fmc_result) :: all
    integer(c_int32_t) :: flags
    flags = 0
    if (present(add)) flags = merge(FMC_EVALUATE_ADD, 0, add)
    call checked(fmc_context_evaluate(self%handle, view(x), onto(forces), flags, all), stat)
    if (present(found)) found = all
  end subroutine

  ! Second derivative of the energy, - d force / d x, in compressed rows that count from 1: the host adds it to its stiffness.
  ! flags: FMC_TANGENT_SEMIDEFINITE, FMC_TANGENT_SYMMETRIC (fmc_context_tangent, fmc_context_tangent_csr).
  subroutine tangent(self, x, row_offsets, cols, values, flags, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    integer(c_int32_t), intent(out), allocatable :: row_offsets(:), cols(:)
    real(c_double), intent(out), allocatable :: values(:)
    integer(c_int32_t), intent(in), optional :: flags
    integer, intent(out), optional :: stat
    integer(c_int32_t) :: asked, status
    asked = 0
    if (present(flags)) asked = flags
    status = fmc_context_tangent(self%handle, view(x), asked)
    if (status == FMC_OK) status = rows_of(self, row_offsets, cols, values)
    call checked(status, stat)
  end subroutine

  ! Both at once, for less than both (fmc_context_evaluate_tangent).
  subroutine evaluate_tangent(self, x, forces, found, row_offsets, cols, values, flags, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    real(c_double), intent(inout), contiguous, target :: forces(:, :)
    type(fmc_result), intent(out) :: found
    integer(c_int32_t), intent(out), allocatable :: row_offsets(:), cols(:)
    real(c_double), intent(out), allocatable :: values(:)
    integer(c_int32_t), intent(in), optional :: flags
    integer, intent(out), optional :: stat
    integer(c_int32_t) :: asked, status
    asked = 0
    if (present(flags)) asked = flags
    status = fmc_context_evaluate_tangent(self%handle, view(x), asked, onto(forces), found)
    if (status == FMC_OK) status = rows_of(self, row_offsets, cols, values)
    call checked(status, stat)
  end subroutine

  integer(c_int32_t) function rows_of(self, row_offsets, cols, values) result(status)
    class(contact), intent(in) :: self
    integer(c_int32_t), intent(out), allocatable :: row_offsets(:), cols(:)
    real(c_double), intent(out), allocatable :: values(:)
    integer(c_size_t) :: offsets, entries
    status = fmc_context_tangent_csr(self%handle, 0, offset_capacity=0_c_size_t, offset_count=offsets, &
                                     capacity=0_c_size_t, count=entries)
    if (status /= FMC_OK) return
    allocate (row_offsets(offsets), cols(entries), values(entries))
    status = fmc_context_tangent_csr(self%handle, 0, row_offsets, offsets, cols=cols, values=values, capacity=entries)
  end function

  ! Largest time step that the contact allows an explicit host, with masses(nodes) (fmc_context_stable_step).
  real(c_double) function stable_step(self, x, masses, stat) result(step)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    real(c_double), intent(in), contiguous :: masses(:)
    integer, intent(out), optional :: stat
    step = 0
    call checked(fmc_context_stable_step(self%handle, view(x), masses, step), stat)
  end function

  ! Force and moment on a body, on an obstacle, and results of a pair, from the last evaluation.
  type(fmc_resultant) function body(self, index, stat)
    class(contact), intent(in) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    call checked(fmc_context_body_resultant(self%handle, int(index - 1, c_size_t), body), stat)
  end function

  type(fmc_resultant) function obstacle(self, index, stat)
    class(contact), intent(in) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    call checked(fmc_context_obstacle_resultant(self%handle, int(index - 1, c_size_t), obstacle), stat)
  end function

  type(fmc_pair_result) function pair(self, index, stat)
    class(contact), intent(in) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    call checked(fmc_context_pair_result(self%handle, int(index - 1, c_size_t), pair), stat)
    pair%a = pair%a + 1
    pair%b = pair%b + 1
  end function

  ! Text of a warning of the last evaluation, of which there are found%warning_count.
  function warning(self, index, code, stat) result(text)
    class(contact), intent(in) :: self
    integer, intent(in) :: index
    integer(c_int32_t), intent(out), optional :: code
    integer, intent(out), optional :: stat
    character(:), allocatable :: text
    type(c_ptr) :: found
    integer(c_int32_t) :: kind
    found = c_null_ptr
    call checked(fmc_context_warning(self%handle, int(index - 1, c_size_t), kind, found), stat)
    if (present(code)) code = kind
    call copy_text(found, text)
  end function

  ! Where an obstacle stands: position(dim), and its last axis along axis(dim) (fmc_pose_along).
  function pose_along(position, axis, stat) result(pose)
    real(c_double), intent(in) :: position(:), axis(:)
    integer, intent(out), optional :: stat
    type(fmc_pose) :: pose
    call checked(fmc_pose_init(pose))
    call checked(fmc_pose_along(size(position), position, axis, pose), stat)
  end function

  ! Where an obstacle stands that is not turned.
  function pose_at(position) result(pose)
    real(c_double), intent(in) :: position(:)
    type(fmc_pose) :: pose
    call checked(fmc_pose_init(pose))
    pose%position(:size(position)) = position
  end function

  ! Obstacles; index receives their number. All of the half-space behind point, whose outward normal is given.
  subroutine add_half_space(self, point, normal, index, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in) :: point(:), normal(:)
    integer, intent(out), optional :: index, stat
    integer(c_int32_t) :: status
    integer(c_size_t) :: number
    type(fmc_pose) :: pose
    call checked(fmc_pose_init(pose))
    status = fmc_pose_along(size(point), point, normal, pose)
    if (status == FMC_OK) status = fmc_context_add_obstacle(self%handle, shape_of(FMC_SHAPE_HALF_SPACE), pose, number)
    call placed(status, number, index, stat)
  end subroutine

  ! A shape of a kind FMC_SHAPE_... with its lengths (fmc_shape_init), for add_obstacle and for parts of a compound. Arrays go
  ! into its components, by c_loc.
  function shape_of(kind, radius, half_height, half_extents) result(shape)
    integer(c_int32_t), intent(in) :: kind
    real(c_double), intent(in), optional :: radius, half_height, half_extents(:)
    type(fmc_shape) :: shape
    call checked(fmc_shape_init(shape, kind))
    if (present(radius)) shape%radius = radius
    if (present(half_height)) shape%half_height = half_height
    if (present(half_extents)) shape%half_extents(:size(half_extents)) = half_extents
  end function

  ! Any shape, as shape_of makes it.
  subroutine add_obstacle(self, shape, pose, index, stat)
    class(contact), intent(inout) :: self
    type(fmc_shape), intent(in) :: shape
    type(fmc_pose), intent(in) :: pose
    integer, intent(out), optional :: index, stat
    integer(c_size_t) :: number
    call placed(fmc_context_add_obstacle(self%handle, shape, pose, number), number, index, stat)
  end subroutine

  ! points(dim, corners), facets(dim, facets).
  subroutine add_polytope(self, points, facets, pose, index, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: points(:, :)
    integer(c_int32_t), intent(in), contiguous, target :: facets(:, :)
    type(fmc_pose), intent(in) :: pose
    integer, intent(out), optional :: index, stat
    type(fmc_shape) :: shape
    if (size(facets, 1) /= self%dim .or. size(points, 1) /= self%dim) then
      call unplaced(index, stat)
      return
    end if
    shape = shape_of(FMC_SHAPE_POLYTOPE)
    shape%points = view(points)
    shape%facets = c_loc(facets)
    shape%facet_count = size(facets, 2, c_size_t)
    call self%add_obstacle(shape, pose, index, stat)
  end subroutine

  ! points(dim, points).
  subroutine add_convex_hull(self, points, pose, index, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: points(:, :)
    type(fmc_pose), intent(in) :: pose
    integer, intent(out), optional :: index, stat
    type(fmc_shape) :: shape
    if (size(points, 1) /= self%dim) then
      call unplaced(index, stat)
      return
    end if
    shape = shape_of(FMC_SHAPE_CONVEX_HULL)
    shape%points = view(points)
    call self%add_obstacle(shape, pose, index, stat)
  end subroutine

  ! A function bind(c) of interface fmc_signed_distance; x is (dim, n) there, and user is handed to it.
  subroutine add_signed_distance(self, distance, pose, index, user, stat)
    class(contact), intent(inout) :: self
    procedure(fmc_signed_distance) :: distance
    type(fmc_pose), intent(in) :: pose
    integer, intent(out), optional :: index
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    type(fmc_shape) :: shape
    shape = shape_of(FMC_SHAPE_SIGNED_DISTANCE)
    shape%signed_distance = c_funloc(distance)
    if (present(user)) shape%user = user
    call self%add_obstacle(shape, pose, index, stat)
  end subroutine

  ! The whole pose: its rotation too, which a pose of a position alone turns back.
  subroutine set_pose(self, index, pose, stat)
    class(contact), intent(inout) :: self
    integer, intent(in) :: index
    type(fmc_pose), intent(in) :: pose
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_pose(self%handle, int(index - 1, c_size_t), pose), stat)
  end subroutine

  subroutine remove_obstacle(self, index, stat)
    class(contact), intent(inout) :: self
    integer, intent(in) :: index
    integer, intent(out), optional :: stat
    call checked(fmc_context_remove_obstacle(self%handle, int(index - 1, c_size_t)), stat)
  end subroutine

  ! Keeps the patches of the law `fiber` as they are at x, for a load step (fmc_context_keep_patches).
  subroutine keep_patches(self, x, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_keep_patches(self%handle, view(x)), stat)
  end subroutine

  ! Steps of friction: begun at x, committed where they are accepted, with its pressure frozen if asked for.
  subroutine begin_step(self, x, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_begin_step(self%handle, view(x)), stat)
  end subroutine

  subroutine commit_step(self, x, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_commit_step(self%handle, view(x)), stat)
  end subroutine

  ! Without x friction is released.
  subroutine freeze_friction(self, x, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target, optional :: x(:, :)
    integer, intent(out), optional :: stat
    if (present(x)) then
      call checked(fmc_context_freeze_friction(self%handle, view(x)), stat)
    else
      call checked(fmc_context_freeze_friction(self%handle), stat)
    end if
  end subroutine

  ! Elastic slip of every facet against each of its partners, (8, rows), for a restart: facet from 0, kind and index of the
  ! partner, side, slip, 0.
  subroutine slip(self, values, stat)
    class(contact), intent(in) :: self
    real(c_double), intent(out), allocatable :: values(:, :)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: numbers
    integer(c_int32_t) :: status
    numbers = 0
    status = fmc_context_slip(self%handle, capacity=0_c_size_t, count=numbers)
    allocate (values(8, numbers / 8))
    if (status == FMC_OK) status = fmc_context_slip(self%handle, values, numbers)
    call checked(status, stat)
  end subroutine

  subroutine set_slip(self, values, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous :: values(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_slip(self%handle, values, size(values, kind=c_size_t)), stat)
  end subroutine

  ! Wear coefficients of both sides of a pair, in 1/pressure; all other options of the pair stay.
  subroutine set_pair_wear(self, a_kind, a, b_kind, b, wear_a, wear_b, stat)
    class(contact), intent(inout) :: self
    integer(c_int32_t), intent(in) :: a_kind, b_kind
    integer, intent(in) :: a, b
    real(c_double), intent(in) :: wear_a, wear_b
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_pair_wear(self%handle, a_kind, int(a - 1, c_size_t), b_kind, int(b - 1, c_size_t), &
                                           wear_a, wear_b), stat)
  end subroutine

  ! How far the surface is worn off at every node.
  subroutine worn_depth(self, values, stat)
    class(contact), intent(in) :: self
    real(c_double), intent(out), allocatable :: values(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: numbers
    integer(c_int32_t) :: status
    numbers = 0
    status = fmc_context_worn_depth(self%handle, capacity=0_c_size_t, count=numbers)
    allocate (values(numbers))
    if (status == FMC_OK) status = fmc_context_worn_depth(self%handle, values, numbers, numbers)
    call checked(status, stat)
  end subroutine

  ! Volume that every body has lost by wear.
  subroutine worn_volumes(self, values, stat)
    class(contact), intent(in) :: self
    real(c_double), intent(out), allocatable :: values(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: numbers
    integer(c_int32_t) :: status
    numbers = 0
    status = fmc_context_worn_volumes(self%handle, capacity=0_c_size_t, count=numbers)
    allocate (values(numbers))
    if (status == FMC_OK) status = fmc_context_worn_volumes(self%handle, values, numbers, numbers)
    call checked(status, stat)
  end subroutine

  ! State of wear, (4, rows), for a restart: facet and point from 0, depth, volume.
  subroutine worn_facets(self, values, stat)
    class(contact), intent(in) :: self
    real(c_double), intent(out), allocatable :: values(:, :)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: numbers
    integer(c_int32_t) :: status
    numbers = 0
    status = fmc_context_worn_facets(self%handle, capacity=0_c_size_t, count=numbers)
    allocate (values(4, numbers / 4))
    if (status == FMC_OK) status = fmc_context_worn_facets(self%handle, values, numbers, numbers)
    call checked(status, stat)
  end subroutine

  subroutine set_worn_facets(self, values, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous :: values(:, :)
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_worn_facets(self%handle, values, size(values, kind=c_size_t)), stat)
  end subroutine

  ! As many times the wear of a step counts.
  subroutine set_wear_cycles(self, cycles, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in) :: cycles
    integer, intent(out), optional :: stat
    call checked(fmc_context_set_wear_cycles(self%handle, cycles), stat)
  end subroutine

  ! Contact at every node of x: any of pressure(nodes), gap, area, sliding, status(nodes), normal(dim, nodes), friction,
  ! local_pressure(nodes).
  subroutine nodal_contact(self, x, pressure, gap, area, normal, friction, sliding, status, stat, local_pressure)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    real(c_double), intent(out), contiguous, target, optional :: pressure(:), gap(:), area(:), sliding(:), &
                                                                   local_pressure(:)
    real(c_double), intent(out), contiguous, target, optional :: normal(:, :), friction(:, :)
    integer(c_int32_t), intent(out), contiguous, target, optional :: status(:)
    integer, intent(out), optional :: stat
    type(fmc_nodal_contact) :: nodal
    call checked(fmc_nodal_contact_init(nodal))
    if (present(pressure)) nodal%pressure = c_loc(pressure)
    if (present(gap)) nodal%gap = c_loc(gap)
    if (present(area)) nodal%area = c_loc(area)
    if (present(normal)) nodal%normal = c_loc(normal)
    if (present(friction)) nodal%friction = c_loc(friction)
    if (present(sliding)) nodal%sliding = c_loc(sliding)
    if (present(status)) nodal%status = c_loc(status)
    if (present(local_pressure)) nodal%local_pressure = c_loc(local_pressure)
    call checked(fmc_context_nodal_contact(self%handle, view(x), nodal), stat)
  end subroutine

  ! Where the laws `fiber` and `depth` press at x.
  subroutine contact_points(self, x, points, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    type(fmc_contact_point), intent(out), allocatable :: points(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: count
    integer(c_int32_t) :: status
    integer :: k
    count = 0
    status = fmc_context_contact_points(self%handle, view(x), capacity=0_c_size_t, count=count)
    allocate (points(count))
    if (status == FMC_OK) status = fmc_context_contact_points(self%handle, view(x), points, count)
    do k = 1, size(points)
      points(k)%patch = points(k)%patch + 1
      points(k)%sides%index = points(k)%sides%index + 1
    end do
    call checked(status, stat)
  end subroutine

  ! Weighted gaps of the nodes within reach of a partner, and d gap / d x in compressed rows that count from 1
  ! (fmc_context_gap_constraints).
  subroutine gap_constraints(self, x, reach, rows, row_offsets, cols, values, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    real(c_double), intent(in) :: reach
    type(fmc_gap_constraint), intent(out), allocatable :: rows(:)
    integer(c_int32_t), intent(out), allocatable :: row_offsets(:), cols(:)
    real(c_double), intent(out), allocatable :: values(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: count, entries
    integer(c_int32_t) :: status
    count = 0
    entries = 0
    status = fmc_context_gap_constraints(self%handle, view(x), reach, capacity=0_c_size_t, count=count)
    if (status == FMC_OK) status = fmc_context_gap_gradient(self%handle, offset_capacity=0_c_size_t, &
                                                            capacity=0_c_size_t, count=entries)
    allocate (rows(count), row_offsets(count + 1), cols(entries), values(entries))
    if (status == FMC_OK) status = fmc_context_gap_constraints(self%handle, view(x), reach, rows, count)
    if (status == FMC_OK) status = fmc_context_gap_gradient(self%handle, row_offsets, count + 1, cols=cols, values=values, &
                                                            capacity=entries)
    if (status == FMC_OK) then
      rows%body = rows%body + 1
      rows%partner = rows%partner + 1
    end if
    call checked(status, stat)
  end subroutine

  ! The tie of two bodies that count from 1 (fmc_context_tie); its area is 0 where they are not tied.
  subroutine tie(self, a, b, found, stat)
    class(contact), intent(in) :: self
    integer, intent(in) :: a, b
    type(fmc_tie), intent(out) :: found
    integer, intent(out), optional :: stat
    call checked(fmc_context_tie(self%handle, int(a - 1, c_size_t), int(b - 1, c_size_t), found), stat)
  end subroutine

  ! Traction and jump of all ties at x, by nodes and bodies that count from 1 (fmc_context_tie_nodes).
  subroutine tie_nodes(self, x, rows, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    type(fmc_tie_node), intent(out), allocatable :: rows(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: count
    integer(c_int32_t) :: status
    count = 0
    status = fmc_context_tie_nodes(self%handle, view(x), capacity=0_c_size_t, count=count)
    allocate (rows(count))
    if (status == FMC_OK) status = fmc_context_tie_nodes(self%handle, view(x), rows, count)
    if (status == FMC_OK) then
      rows%body = rows%body + 1
      rows%partner = rows%partner + 1
    end if
    call checked(status, stat)
  end subroutine

  ! Updates the multipliers by the penetration at x (fmc_context_augment); reach: 0 for a twentieth of the bodies' extent.
  subroutine augment(self, x, tolerance, result, reach, stat)
    class(contact), intent(inout) :: self
    real(c_double), intent(in), contiguous, target :: x(:, :)
    real(c_double), intent(in) :: tolerance
    type(fmc_augmentation), intent(out) :: result
    real(c_double), intent(in), optional :: reach
    integer, intent(out), optional :: stat
    real(c_double) :: within
    within = 0
    if (present(reach)) within = reach
    call checked(fmc_context_augment(self%handle, view(x), within, tolerance, result), stat)
  end subroutine

  ! Shifts of surfaces, by nodes, bodies and partners that count from 1.
  subroutine multipliers(self, found, stat)
    class(contact), intent(in) :: self
    type(fmc_multiplier), intent(out), allocatable :: found(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: count
    integer(c_int32_t) :: status
    count = 0
    status = fmc_context_multipliers(self%handle, capacity=0_c_size_t, count=count)
    allocate (found(count))
    if (status == FMC_OK .and. count > 0) status = fmc_context_multipliers(self%handle, found, count, count)
    found%body = found%body + 1
    found%partner = found%partner + 1
    call checked(status, stat)
  end subroutine

  ! Shifts surfaces as returned by multipliers; none: no shift.
  subroutine set_multipliers(self, given, stat)
    class(contact), intent(inout) :: self
    type(fmc_multiplier), intent(in) :: given(:)
    integer, intent(out), optional :: stat
    type(fmc_multiplier) :: rows(size(given))
    rows = given
    rows%body = rows%body - 1
    rows%partner = rows%partner - 1
    call checked(fmc_context_set_multipliers(self%handle, rows, size(rows, kind=c_size_t)), stat)
  end subroutine

  ! The facets of all bodies; local_face is VTK's number and counts from 0.
  subroutine boundary_facets(self, facets, stat)
    class(contact), intent(in) :: self
    type(fmc_boundary_facet), intent(out), allocatable :: facets(:)
    integer, intent(out), optional :: stat
    integer(c_size_t) :: count
    integer(c_int32_t) :: status
    count = 0
    status = fmc_context_boundary_facets(self%handle, capacity=0_c_size_t, count=count)
    allocate (facets(count))
    if (status == FMC_OK) status = fmc_context_boundary_facets(self%handle, facets, count)
    facets%body = facets%body + 1
    call checked(status, stat)
  end subroutine

  subroutine placed(status, number, index, stat)
    integer(c_int32_t), intent(in) :: status
    integer(c_size_t), intent(in) :: number
    integer, intent(out), optional :: index, stat
    call checked(status, stat)
    if (present(index)) index = merge(int(number) + 1, 0, status == FMC_OK)
  end subroutine

  ! An obstacle whose arrays do not have the contact's dimension: the library does not get their lengths.
  subroutine unplaced(index, stat)
    integer, intent(out), optional :: index, stat
    if (present(index)) index = 0
    if (.not. present(stat)) error stop "fmc_contact: an array of an obstacle is not of the contact's dimension"
    stat = FMC_ERROR_DIMENSION
  end subroutine

  type(fmc_coords) function view(x)
    real(c_double), intent(in), contiguous, target :: x(:, :)
    view%data = c_loc(x)
    view%node_count = size(x, 2, c_size_t)
    view%node_stride = size(x, 1, c_ptrdiff_t)
    view%axis_stride = 1
  end function

  type(fmc_forces) function onto(forces)
    real(c_double), intent(inout), contiguous, target :: forces(:, :)
    onto%data = c_loc(forces)
    onto%node_count = size(forces, 2, c_size_t)
    onto%node_stride = size(forces, 1, c_ptrdiff_t)
    onto%axis_stride = 1
  end function

  subroutine checked(status, stat)
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(:), allocatable :: text
    if (present(stat)) then
      stat = status
    else if (status /= FMC_OK) then
      text = contact_error()
      error stop text
    end if
  end subroutine

  subroutine copy_text(c, text)
    type(c_ptr), intent(in) :: c
    character(:), allocatable, intent(out) :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: length, k
    if (.not. c_associated(c)) then
      text = ""
      return
    end if
    call c_f_pointer(c, letters, [huge(length)])
    length = 0
    do while (letters(length + 1) /= c_null_char)
      length = length + 1
    end do
    allocate (character(length) :: text)
    do k = 1, length
      text(k:k) = letters(k)
    end do
  end subroutine

  subroutine copied(self, other)
    class(contact), intent(inout) :: self
    class(contact), intent(in) :: other
    if (.not. (c_associated(self%handle) .eqv. c_associated(other%handle))) continue
    error stop "fmc_contact: a contact cannot be copied; pass it on, or make another one"
  end subroutine

  subroutine finished(self)
    type(contact), intent(inout) :: self
    call self%free()
  end subroutine
end module
