! Results for a Fortran host, a section each, checked against expected values.
!
!   gfortran fmc_contact_c.f90 fmc_contact.f90 walk_through.f90 $(pkg-config --libs fmc_contact)
module slope
  use fmc_contact
  implicit none
contains
  ! Whether a call is to end: never.
  integer(c_int32_t) function goes_on(user) bind(c)
    type(c_ptr), value :: user
    goes_on = merge(1, 0, c_associated(user))
  end function

  ! Signed distance from a plane through the origin that rises by 3 in 4: negative below.
  integer(c_int32_t) function distance(user, n, x, phi, grad) bind(c)
    type(c_ptr), value :: user
    integer(c_size_t), value :: n
    real(c_double), intent(in) :: x(*)
    real(c_double), intent(inout) :: phi(*), grad(*)
    real(c_double), pointer :: height
    integer(c_size_t) :: k
    call c_f_pointer(user, height)
    do k = 1, n
      phi(k) = 0.8d0*(x(2*k) - height) - 0.6d0*x(2*k - 1)
      grad(2*k - 1) = -0.6d0
      grad(2*k) = 0.8d0
    end do
    distance = 0
  end function

  ! Your own law of friction: 0.3 p, and the number of steps.
  integer(c_int32_t) function rub(user, at, response) bind(c)
    type(c_ptr), value :: user
    type(fmc_friction_facets), intent(in) :: at
    type(fmc_friction_response), intent(in) :: response
    real(c_double), pointer :: coefficient, pressure(:), before(:), limit(:), by_pressure(:), steps(:)
    call c_f_pointer(user, coefficient)
    call c_f_pointer(at%pressure, pressure, [at%count])
    call c_f_pointer(at%history, before, [at%count])
    call c_f_pointer(response%limit, limit, [at%count])
    call c_f_pointer(response%by_pressure, by_pressure, [at%count])
    call c_f_pointer(response%history, steps, [at%count])
    limit = coefficient*pressure
    by_pressure = coefficient
    steps = before + 1
    rub = 0
  end function

  ! Your own law of an interface: springs, and how far they have opened at most.
  integer(c_int32_t) function springs(user, at, response) bind(c)
    type(c_ptr), value :: user
    type(fmc_law_points), intent(in) :: at
    type(fmc_law_response), intent(in) :: response
    real(c_double), pointer :: k, jump(:, :), before(:), traction(:, :), tangent(:, :, :), opened(:)
    integer :: axis
    call c_f_pointer(user, k)
    call c_f_pointer(at%jump, jump, [at%dim, at%count])
    call c_f_pointer(at%history, before, [at%count])
    call c_f_pointer(response%traction, traction, [at%dim, at%count])
    call c_f_pointer(response%tangent, tangent, [at%dim, at%dim, at%count])
    call c_f_pointer(response%history, opened, [at%count])
    traction = k*jump
    tangent = 0
    do axis = 1, int(at%dim)
      tangent(axis, axis, :) = k
    end do
    opened = max(before, jump(1, :))
    springs = 0
  end function
end module

program walk_through
  use fmc_contact
  use slope
  implicit none
  integer :: failures = 0
  call walk
  print '(i0, a)', failures, " failures"

contains

  ! Variables of a procedure are freed at its end, variables of a program are not.
  subroutine walk
    real(c_double), parameter :: k = 1d5, depth = 0.01d0
    real(c_double) :: x(2, 8), y(2, 8), forces(2, 8), there(2, 8), pressure(8), normal(2, 8), masses(8), change(2, 8)
    real(c_double), allocatable :: values(:), carried(:, :), carried_law(:), depths(:), volumes(:), worn(:, :)
    real(c_double), target :: height = 0, coefficient = 0.3d0
    real(c_double) :: all_of(16), by(16), kept(2, 8), ring(2, 8), apart(2, 8), pulled(2, 8)
    integer :: conn(4, 2) = reshape([1, 2, 3, 4, 5, 6, 7, 8], [4, 2]), quarters(3, 4), index, stat, row
    integer(c_int32_t) :: status(8)
    integer(c_int32_t), allocatable :: row_offsets(:), cols(:)
    type(contact) :: squares, block, disc, bonded, rubbing
    type(fmc_pair_options) :: own
    type(fmc_options) :: options
    type(fmc_result) :: found
    type(fmc_resultant) :: body
    type(fmc_pair_result) :: pair
    type(fmc_contact_point), allocatable :: points(:)
    type(fmc_gap_constraint), allocatable :: gaps(:)
    type(fmc_multiplier), allocatable :: shifts(:)
    type(fmc_augmentation) :: moved_out
    type(fmc_boundary_facet), allocatable :: skin(:)

    x(:, 1:4) = reshape([0d0, 0d0, 1d0, 0d0, 1d0, 1d0, 0d0, 1d0], [2, 4])
    x(:, 5:8) = x(:, 1:4) + spread([1 - depth, 0.2d0], 2, 4)
    options = contact_options(k, FMC_LAW_FIBER)
    call squares%from_cells(x, FMC_QUAD4, conn, options)

    ! Forces, added to an array, and resultants.
    forces = 1
    call squares%set_interrupt(goes_on)
    call squares%evaluate(x, forces, found, add=.true.)
    body = squares%body(2)
    pair = squares%pair(1)
    call expect("force", body%force(1), k*depth*0.8d0, 1d-9)
    call expect("sum of nodal forces", sum(forces(1, 5:8)) - 4, body%force(1), 1d-9)
    call expect("partners", real(10*pair%a + pair%b, c_double), 12d0, 1d-15)

    ! The tangent of the law `depth`, which has no directions, times a change of the coordinates, against differences.
    call squares%set_options(contact_options(k))
    call squares%evaluate_tangent(x, forces, found, row_offsets, cols, values)
    call random(change)
    y = x + 1d-6*change
    call squares%evaluate(y, there)
    y = x - 1d-6*change
    call squares%evaluate(y, forces)
    all_of = reshape((forces - there)/2d-6, [16])
    by = reshape(change, [16])
    do row = 1, 16
      associate (first => row_offsets(row), last => row_offsets(row + 1) - 1)
        call expect("tangent", sum(values(first:last)*by(cols(first:last))), all_of(row), 1d-5*k)
      end associate
    end do

    call squares%set_options(options)

    ! Fields at nodes and contact points: both add up to the resultant.
    call squares%nodal_contact(x, pressure=pressure, normal=normal, status=status)
    call expect("pressure", maxval(pressure), k*depth, 1d-9)
    call expect("status", real(count(status == FMC_NODE_TOUCHING), c_double), 4d0, 1d-15)
    call squares%contact_points(x, points)
    call expect("points", sum(points%pressure*points%area), k*depth*0.8d0, 1d-9)
    call expect("nodes of points", real(maxval(points(1)%sides(2)%nodes), c_double), 8d0, 1d-15)
    call squares%gap_constraints(x, 0.1d0, gaps, row_offsets, cols, values)
    ! The structs belong to the library, which writes their size.
    call expect("size of fmc_options", real(c_sizeof(options), c_double), real(options%struct_size, c_double), 0d0)
    call expect("size of fmc_result", real(c_sizeof(found), c_double), real(found%struct_size, c_double), 0d0)
    call expect("size of fmc_pair_result", real(c_sizeof(pair), c_double), real(pair%struct_size, c_double), 0d0)
    call expect("size of a point", real(c_sizeof(points(1)), c_double), real(points(1)%struct_size, c_double), 0d0)
    call expect("size of a gap", real(c_sizeof(gaps(1)), c_double), real(gaps(1)%struct_size, c_double), 0d0)
    call expect("gaps", minval(gaps%gap/gaps%area), -depth, 1d-9)
    ! Shifted by its penetration the square presses twice as much; without shift, as before.
    call squares%augment(x, 1d-9, moved_out)
    call squares%multipliers(shifts)
    call expect("shift", maxval(shifts%shift), depth, 1d-9)
    call expect("nodes moved out", real(size(shifts), c_double), real(moved_out%multiplier_count, c_double), 0d0)
    call expect("size of a multiplier", real(c_sizeof(shifts(1)), c_double), real(shifts(1)%struct_size, c_double), 0d0)
    call squares%contact_points(x, points)
    call expect("pressure moved out", maxval(points%pressure), 2*k*depth, 1d-9)
    call squares%set_multipliers(shifts(1:0))
    call squares%multipliers(shifts)
    call expect("nodes moved back", real(size(shifts), c_double), 0d0, 0d0)
    call squares%boundary_facets(skin)
    call expect("facets", real(10*size(skin) + maxval(skin%cell), c_double), 82d0, 1d-15)
    masses = 1
    if (squares%stable_step(x, masses) <= 0) call expect("stable step", 0d0, 1d0, 0d0)

    ! Friction: a step of 1 mm up, stick with the stiffness k, then slip at the friction limit.
    options = contact_options(k)
    options%friction_coefficient = 0.3d0
    call squares%set_options(options)
    call squares%begin_step(x)
    y = x
    y(2, 5:8) = y(2, 5:8) + 0.05d0
    call squares%evaluate(y, forces)
    body = squares%body(2)
    call expect("friction", body%friction(2), -0.3d0*(body%force(1) - body%friction(1)), 1d-9*k)
    call squares%commit_step(y)
    call squares%slip(carried)
    call squares%begin_step(y)
    call squares%set_slip(carried)
    call squares%evaluate(y, there)
    call expect("friction after a restart", maxval(abs(there - forces)), 0d0, 1d-9*k)

    ! Wear of both, by Archard's law: their slip wears both by the same depth.
    call squares%set_pair_wear(FMC_PARTNER_BODY, 1, FMC_PARTNER_BODY, 2, 1d-6, 1d-6)
    call squares%set_wear_cycles(100d0)
    y(2, 5:8) = y(2, 5:8) + 0.05d0
    call squares%commit_step(y)
    call squares%worn_depth(depths)
    call squares%worn_volumes(volumes)
    call squares%worn_facets(worn)
    ! But for the rims, by the penetration over the width.
    call expect("volumes that are worn off", volumes(1), volumes(2), 2d-2*volumes(2))
    call expect("volumes by facet", sum(worn(4, :)), sum(volumes), 1d-12*volumes(2))
    if (maxval(depths) <= 0) call expect("worn depth", 0d0, 1d0, 0d0)
    call squares%set_worn_facets(worn(:, 1:0))
    call squares%worn_volumes(volumes)
    call expect("nothing is worn off", maxval(volumes), 0d0, 0d0)
    call squares%set_pair_wear(FMC_PARTNER_BODY, 1, FMC_PARTNER_BODY, 2, 0d0, 0d0)
    call squares%evaluate(y, kept)

    ! Obstacles: a plane, and the same by a signed distance of the host's.
    call block%from_cells(x(:, 1:4), FMC_QUAD4, conn(:, 1:1), contact_options(k))
    call block%add_half_space([0d0, depth], [0d0, 1d0], index)
    call block%evaluate(x(:, 1:4), forces(:, 1:4))
    body = block%obstacle(index)
    call expect("force on the plane", body%force(2), -k*depth, 1d-9*k)
    call block%remove_obstacle(index)
    call block%add_half_space([0d0, 0.1d0], [-0.6d0, 0.8d0], index)
    call block%evaluate(x(:, 1:4), forces(:, 1:4))
    body = block%obstacle(index)
    call block%remove_obstacle(index)
    height = 0.1d0
    call block%add_signed_distance(distance, pose_at([0d0, 0d0]), index, c_loc(height))
    call block%evaluate(x(:, 1:4), there(:, 1:4))
    call expect("signed distance", maxval(abs(there(:, 1:4) - forces(:, 1:4))), 0d0, 1d-3*body%force(1))

    ! Surfaces without cells, straight and of second order: a disc's quarters, whose middles lie on the circle.
    ring(:, 1:4) = reshape([1d0, 0d0, 0d0, 1d0, -1d0, 0d0, 0d0, -1d0], [2, 4])
    ring(:, 5:8) = sqrt(0.5d0)*reshape([1d0, 1d0, -1d0, 1d0, -1d0, -1d0, 1d0, -1d0], [2, 4])
    quarters = reshape([1, 2, 5, 2, 3, 6, 3, 4, 7, 4, 1, 8], [3, 4])
    call disc%from_facets(ring, [facets(FMC_FACET_LINE3, quarters)], contact_options(k, FMC_LAW_VOLUME))
    call disc%add_half_space([0d0, 10d0], [0d0, 1d0])
    call disc%evaluate(ring, forces, found)
    ! Four triangles of a square, and segments of parabolas, 2/3 of chord times rise.
    call expect("area of a disc", found%volume, 2 + 4*2d0/3*sqrt(2d0)*(1 - sqrt(0.5d0)), 1d-12)

    ! A box below the disc, which reaches as far: a shape as data.
    call disc%remove_obstacle(1)
    call disc%add_obstacle(shape_of(FMC_SHAPE_CUBOID, half_extents=[20d0, 20d0]), pose_at([0d0, -10d0]), index)
    call disc%evaluate(ring, forces, found)
    call expect("area of a disc in a box", found%volume, 2 + 4*2d0/3*sqrt(2d0)*(1 - sqrt(0.5d0)), 1d-12)

    ! Your own law between two squares that are drawn apart; the same after a restart.
    apart(:, 1:4) = x(:, 1:4)
    apart(:, 5:8) = x(:, 1:4) + spread([1d0, 0d0], 2, 4)
    call bonded%from_cells(apart, FMC_QUAD4, conn, contact_options(k))
    call expect("init", real(fmc_pair_options_init(own), c_double), 0d0, 0d0)
    own%interface_kind = FMC_INTERFACE_LAW
    call check_law(springs, 2, 0.1d0, history_count=1, user=c_loc(height))
    call bonded%set_law_pair(1, 2, own, springs, history_count=1, user=c_loc(height))
    call bonded%set_law_fields(spread([20d0, 30d0], 2, 8))
    call bonded%begin_step(apart)
    apart(1, 5:8) = apart(1, 5:8) + 0.25d0
    call bonded%evaluate(apart, pulled)
    body = bonded%body(2)
    call expect("force of springs", body%force(1), -0.25d0*height, 1d-15)
    call bonded%commit_step(apart)
    call bonded%law_history(carried_law)
    call expect("history", maxval(abs(carried_law - 0.25d0)), 0d0, 1d-15)
    call bonded%set_law_history(carried_law/2)
    call bonded%law_history(carried_law)
    call expect("history that was set", maxval(abs(carried_law - 0.125d0)), 0d0, 1d-15)
    call bonded%set_law_history(carried_law(2:), stat)
    call expect("too short a history", real(stat, c_double), real(FMC_ERROR_LENGTH, c_double), 0d0)

    ! Your own law of friction between two squares, the second 0.01 deep in the first and shifted along it by 0.1.
    call rubbing%from_cells(x, FMC_QUAD4, conn, contact_options(k))
    call expect("init", real(fmc_pair_options_init(own), c_double), 0d0, 0d0)
    call check_friction_law(rub, 2, 1d3, 1d0, 0d0, history_count=1, user=c_loc(coefficient))
    call rubbing%set_friction_law_pair(FMC_PARTNER_BODY, 1, FMC_PARTNER_BODY, 2, own, rub, history_count=1, &
                                       user=c_loc(coefficient))
    call rubbing%begin_step(x)
    apart = x
    apart(2, 5:8) = apart(2, 5:8) + 0.1d0
    call rubbing%evaluate(apart, pulled)
    body = rubbing%body(2)
    call expect("friction by your own law", body%friction(2), -0.3d0*body%force(1), 1d-2*body%force(1))
    call rubbing%commit_step(apart)
    call rubbing%friction_history(carried_law)
    call expect("steps that facets counted", maxval(abs(carried_law - 1)), 0d0, 0d0)
    call rubbing%set_friction_history(2*carried_law)
    call rubbing%friction_history(carried_law)
    call expect("steps that were set", maxval(abs(carried_law - 2)), 0d0, 0d0)
    call rubbing%set_friction_history(carried_law(2:), stat)
    call expect("too short a history of friction", real(stat, c_double), real(FMC_ERROR_LENGTH, c_double), 0d0)

    ! Errors: the text names the fault, and nothing has changed.
    conn(3, 2) = 9
    call squares%from_cells(x, FMC_QUAD4, conn, options, stat=stat)
    call expect("status of a node that is not there", real(stat, c_double), real(FMC_ERROR_NODE_OUT_OF_RANGE, c_double), 0d0)
    print '(a)', contact_error()
    call squares%evaluate(y, there)
    call expect("forces after an error", maxval(abs(there - kept)), 0d0, 0d0)
    call squares%add_convex_hull(reshape([1d0, 1d0, 1d0], [3, 1]), pose_at([0d0, 0d0]), stat=stat)
    call expect("points of three numbers in two dimensions", real(stat, c_double), real(FMC_ERROR_DIMENSION, c_double), 0d0)
  end subroutine

  subroutine expect(what, value, expected, error)
    character(*), intent(in) :: what
    real(c_double), intent(in) :: value, expected, error
    if (abs(value - expected) <= error) return
    print '(2a, es12.4, a, es12.4)', what, ":", value, " is not", expected
    failures = failures + 1
  end subroutine

  ! Numbers that are the same with every compiler.
  subroutine random(numbers)
    real(c_double), intent(out) :: numbers(2, 8)
    integer :: i, j
    numbers = reshape([((sin(7d0*i + 3d0*j), i = 1, 2), j = 1, 8)], [2, 8])
  end subroutine
end program
