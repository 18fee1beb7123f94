! A block falls on another one that is held: elastic blocks of triangles, by central differences.
!
!   gfortran -ffp-contract=off fmc_contact_c.f90 fmc_contact.f90 impact.f90 $(pkg-config --libs fmc_contact)
!
! Every 20 steps: step, vertical contact force on the falling block, its mean vertical velocity, energy of the contact. The
! hosts in C, C++ and Rust print the same.
program impact
  use fmc_contact
  implicit none
  real(c_double), parameter :: young = 1d6, poisson = 0.3d0, density = 1000, step_size = 1d-4
  real(c_double), parameter :: lambda = young*poisson/((1 + poisson)*(1 - 2*poisson)), mu = young/(2*(1 + poisson))
  integer, parameter :: nodes = 25 + 16, triangles = 32 + 18, held = 5, falling = 26
  real(c_double) :: start(2, nodes), x(2, nodes), velocity(2, nodes), mass(nodes), forces(2, nodes), internal(2, nodes)
  integer :: conn(3, triangles), step, node
  type(contact) :: blocks
  type(fmc_result) :: found
  type(fmc_resultant) :: above

  call mesh(4, 0, 0, 0d0, 0d0, 1d0)
  call mesh(3, 25, 32, 0.2d0, 1.001d0, 0.6d0)
  call lump
  call blocks%from_cells(start, FMC_TRI3, conn, contact_options(1d8, FMC_LAW_DEPTH, FMC_ESTIMATOR_EXACT))
  x = start
  velocity = 0
  velocity(2, falling:) = -1
  do step = 0, 400
    call blocks%evaluate(x, forces, found)
    if (mod(step, 20) == 0) then
      above = blocks%body(2)
      print '(i6, 3es24.15e2)', step, above%force(2), mean_velocity(), found%energy
    end if
    call strain(internal)
    do node = 1, nodes
      if (node <= held) cycle
      velocity(:, node) = velocity(:, node) + step_size*(forces(:, node) + internal(:, node))/mass(node)
      x(:, node) = x(:, node) + step_size*velocity(:, node)
    end do
  end do

contains

  ! A square of n by n squares, two triangles each, after so many nodes and triangles.
  subroutine mesh(n, first_node, first_triangle, left, bottom, side)
    integer, intent(in) :: n, first_node, first_triangle
    real(c_double), intent(in) :: left, bottom, side
    integer :: i, j, a, triangle
    do j = 0, n
      do i = 0, n
        start(:, first_node + j*(n + 1) + i + 1) = [left + (i*side)/n, bottom + (j*side)/n]
      end do
    end do
    triangle = first_triangle
    do j = 0, n - 1
      do i = 0, n - 1
        a = first_node + j*(n + 1) + i + 1
        conn(:, triangle + 1) = [a, a + 1, a + n + 2]
        conn(:, triangle + 2) = [a, a + n + 2, a + n + 1]
        triangle = triangle + 2
      end do
    end do
  end subroutine

  ! Twice the area of a triangle.
  real(c_double) function twice_area(p)
    real(c_double), intent(in) :: p(2, 3)
    twice_area = (p(1, 2) - p(1, 1))*(p(2, 3) - p(2, 1)) - (p(1, 3) - p(1, 1))*(p(2, 2) - p(2, 1))
  end function

  ! A third of a triangle's mass on each of its nodes.
  subroutine lump
    integer :: t, k
    mass = 0
    do t = 1, triangles
      do k = 1, 3
        mass(conn(k, t)) = mass(conn(k, t)) + density*(twice_area(start(:, conn(:, t)))/2)/3
      end do
    end do
  end subroutine

  real(c_double) function mean_velocity()
    real(c_double) :: momentum, total
    integer :: n
    momentum = 0
    total = 0
    do n = falling, nodes
      momentum = momentum + mass(n)*velocity(2, n)
      total = total + mass(n)
    end do
    mean_velocity = momentum/total
  end function

  ! Internal forces of linear elasticity.
  subroutine strain(f)
    real(c_double), intent(out) :: f(2, nodes)
    real(c_double) :: p(2, 3), u(2, 3), slope(2, 3), doubled, exx, eyy, gxy, sxx, syy, sxy
    integer :: t, k, next, last
    f = 0
    do t = 1, triangles
      p = start(:, conn(:, t))
      u = x(:, conn(:, t)) - p
      doubled = twice_area(p)
      exx = 0
      eyy = 0
      gxy = 0
      do k = 1, 3
        next = mod(k, 3) + 1
        last = mod(k + 1, 3) + 1
        slope(:, k) = [(p(2, next) - p(2, last))/doubled, (p(1, last) - p(1, next))/doubled]
        exx = exx + slope(1, k)*u(1, k)
        eyy = eyy + slope(2, k)*u(2, k)
        gxy = gxy + (slope(2, k)*u(1, k) + slope(1, k)*u(2, k))
      end do
      sxx = (lambda + 2*mu)*exx + lambda*eyy
      syy = lambda*exx + (lambda + 2*mu)*eyy
      sxy = mu*gxy
      do k = 1, 3
        f(1, conn(k, t)) = f(1, conn(k, t)) - (doubled/2)*(sxx*slope(1, k) + sxy*slope(2, k))
        f(2, conn(k, t)) = f(2, conn(k, t)) - (doubled/2)*(sxy*slope(1, k) + syy*slope(2, k))
      end do
    end do
  end subroutine
end program
