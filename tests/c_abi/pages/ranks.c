/* Both pieces of docs/host-guide.md about MPI, on one rank: a tetrahedron's tip in a plane. */
#include <fmc_mpi.h>
#include <stdio.h>

int main(void) {
  const double own_x[12] = {0, 0, -0.1, 1, 0, 0.5, 0, 1, 0.5, 0, 0, 1}, point[3] = {0, 0, 0}, up[3] = {0, 0, 1};
  const int32_t conn[4] = {0, 1, 2, 3}, body_ids[1] = {0};
  const int32_t node_numbers[4] = {0, 1, 2, 3}, cell_numbers[1] = {0};
  const fmc_cell_block block = {FMC_TET4, 4, conn, 1};
  const size_t own_count = 4;
  const fmc_coords whole_x = {own_x, own_count, 0, 0};
  double whole_f[12] = {0}, f[12] = {0}, x[12];
  int32_t numbers[4], own_nodes[4];
  size_t n;
  fmc_options options;
  fmc_context *context = NULL, *whole = NULL;
  fmc_pose floor;
  fmc_shape half_space;
  fmc_shape_init(&half_space, FMC_SHAPE_HALF_SPACE);
  fmc_options_init(&options);
  fmc_pose_along(3, point, up, &floor);
  options.stiffness = 1e6;
  if (fmc_context_new_from_cells(3, &whole_x, &block, 1, NULL, &options, &whole) != FMC_OK) return puts(fmc_last_error()), 1;
  context = whole;
  fmc_context_add_obstacle(whole, &half_space, &floor, NULL);
  {
#include "shared.inc"
    if (fmc_context_evaluate(whole, &whole_x, &(fmc_forces){whole_f, 4, 0, 0}, 0, NULL) != FMC_OK) return puts(fmc_last_error()), 1;
    context = NULL;
#include "parts.inc"
    for (size_t node = 0; node < n; node++)
      for (int axis = 0; axis < 3; axis++)
        if (f[3 * node + (size_t)axis] != whole_f[3 * numbers[node] + axis]) return puts("another force in parts"), 1;
  }
  printf("%zu nodes gathered, force on the tip %g\n", n, whole_f[2]);
  fmc_context_free(&context);
  fmc_context_free(&whole);
  return 0;
}
