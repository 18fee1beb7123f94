/* The contact forces of two unit squares that overlap by a strip 0.01 wide and 0.8 high:
 *
 *       3 ------- 2                      volume   0.01 * 0.8 = 0.008
 *       |       7-|----- 6               pressure k * depth = 100000 * 0.01, and
 *       |       | |      |               force    pressure * 0.8 = 800 to the left on the first square, less at corners
 *       0 ------|-1      |
 *               4 ------ 5               cc two_squares.c $(pkg-config --cflags --libs fmc_contact)   */
#include <fmc_contact.h>
#include <stdio.h>

int main(void) {
  const double coords[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.99, -0.2}, {1.99, -0.2}, {1.99, 0.8}, {0.99, 0.8}};
  const int32_t conn[2][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  const fmc_cell_block squares = {FMC_QUAD4, sizeof conn[0][0], conn[0], 2};
  double forces[8][2], volume;

  fmc_options options;
  fmc_options_init(&options);
  options.stiffness = 100000.0;
  if (fmc_contact_force(2, coords[0], 8, &squares, 1, NULL, &options, NULL, forces[0], &volume) != FMC_OK) {
    fprintf(stderr, "%s\n", fmc_last_error());
    return 1;
  }
  printf("overlap %.3f\n", volume);
  for (int node = 0; node < 8; node++) printf("node %d  %8.2f %8.2f\n", node, forces[node][0], forces[node][1]);
  return 0;
}
