! The contact forces of two unit squares that overlap by a strip 0.01 wide and 0.8 high: k * 0.01 * 0.8 = 800, less at corners.
!
!   gfortran fmc_contact_c.f90 fmc_contact.f90 two_squares.f90 $(pkg-config --libs fmc_contact)
program two_squares
  use fmc_contact
  implicit none
  real(c_double) :: x(2, 8), forces(2, 8)
  integer :: conn(4, 2) = reshape([1, 2, 3, 4, 5, 6, 7, 8], [4, 2]), node
  type(contact) :: squares
  type(fmc_result) :: found
  x(:, 1:4) = reshape([0d0, 0d0, 1d0, 0d0, 1d0, 1d0, 0d0, 1d0], [2, 4])
  x(:, 5:8) = x(:, 1:4) + spread([0.99d0, -0.2d0], 2, 4)
  call squares%from_cells(x, FMC_QUAD4, conn, contact_options(stiffness=1d5))
  call squares%evaluate(x, forces, found)
  print '("overlap ", f5.3)', found%volume
  print '("node ", i0, f10.2, f9.2)', (node, forces(:, node), node = 1, 8)
end program
