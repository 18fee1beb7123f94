/* Contact pressure at nodes and at contact points, of the squares of two_squares.c. */
#include <fmc_contact.h>
#include <stdio.h>
#include <stdlib.h>

#define CHECK(call)                          \
  if ((call) != FMC_OK) {                    \
    fprintf(stderr, "%s\n", fmc_last_error()); \
    return 1;                                \
  }

int main(void) {
  const double x[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.9, 0.1}, {1.9, 0.1}, {1.9, 0.9}, {0.9, 0.9}};
  const int32_t conn[2][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  const fmc_cell_block squares = {FMC_QUAD4, 4, conn[0], 2};
  const fmc_coords coords = {x[0], 8, 2, 1};
  fmc_options options;
  fmc_context *contact = NULL;
  fmc_resultant second;
  CHECK(fmc_options_init(&options));
  options.stiffness = 10000.0;
  options.law = FMC_LAW_FIBER;
  options.estimator = FMC_ESTIMATOR_EXACT;
  CHECK(fmc_context_new_from_cells(2, &coords, &squares, 1, NULL, &options, &contact));
  CHECK(fmc_context_evaluate(contact, &coords, NULL, 0, NULL));
  CHECK(fmc_context_body_resultant(contact, 1, &second));

  double pressure[8], gap[8], area[8], normal[8][2], of_nodes = 0, of_points = 0;
  int32_t status[8];
  fmc_nodal_contact nodal;
  CHECK(fmc_nodal_contact_init(&nodal));
  nodal.pressure = pressure, nodal.gap = gap, nodal.area = area, nodal.normal = normal[0], nodal.status = status;
  CHECK(fmc_context_nodal_contact(contact, &coords, &nodal));
  for (int n = 4; n < 8; n++) {
    of_nodes -= pressure[n] * area[n] * normal[n][0];
    if (status[n] == FMC_NODE_TOUCHING)
      printf("node %d  pressure %.2f  gap %.4f  area %.4f  normal (%.2f, %.2f)\n", n, pressure[n], gap[n], area[n],
             normal[n][0], normal[n][1] + 0.0);
  }

  size_t count;
  CHECK(fmc_context_contact_points(contact, &coords, NULL, 0, &count));
  fmc_contact_point *points = malloc(count * sizeof *points);
  CHECK(fmc_context_contact_points(contact, &coords, points, count, NULL));
  for (size_t i = 0; i < count; i++) of_points += points[i].pressure * points[i].area * points[i].normal[0];
  printf("force on the second square: %.2f, from its nodes %.2f, from the points %.2f\n", second.force[0], of_nodes,
         of_points);
  free(points);
  return fmc_context_free(&contact);
}
