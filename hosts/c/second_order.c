/* Two squares in quadrilaterals of eight nodes, in contact along 0.8 of an edge: what the nodes bear, and how what is told at
 * points is brought to nodes. Numbers count from 1.
 *
 *   cc second_order.c $(pkg-config --cflags --libs fmc_contact) -lm */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int failures = 0;
#define EXPECT(condition)                                                      \
  do {                                                                         \
    if (!(condition)) failures++, printf("FAIL %s\n", #condition);             \
  } while (0)
#define CHECK(call) EXPECT((call) == FMC_OK)

#define NODES 16
static double x[NODES][2];

/* Corners, then the middles of the edges. */
static void square(int first, double left, double low, double width, double height) {
  const double at[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}};
  for (int n = 0; n < 8; n++) {
    x[first + n][0] = left + width * at[n][0];
    x[first + n][1] = low + height * at[n][1];
  }
}

int main(void) {
  square(0, 0, 0, 1, 1);
  square(8, 0.9, 0.1, 1, 0.8);
  int32_t conn[NODES];
  for (int n = 0; n < NODES; n++) conn[n] = n + 1;
  const fmc_cell_block cells = {FMC_QUAD8, 4, conn, 2};
  const fmc_coords coords = {x[0], NODES, 2, 1};
  fmc_options options;
  fmc_context *contact = NULL;
  CHECK(fmc_options_init(&options));
  options.stiffness = 10000;
  options.law = FMC_LAW_FIBER;
  options.estimator = FMC_ESTIMATOR_EXACT;
  options.index_base = 1;
  CHECK(fmc_context_new_from_cells(2, &coords, &cells, 1, NULL, &options, &contact));

  /* Pressure 10000 * 0.1 on the left edge of the second square: 1/6, 2/3, 1/6 of it by the shape functions. */
  double f[NODES][2];
  const fmc_forces forces = {f[0], NODES, 2, 1};
  CHECK(fmc_context_evaluate(contact, &coords, &forces, 0, NULL));
  printf("nodes 9, 16, 12 bear %.3f %.3f %.3f\n", f[8][0], f[15][0], f[11][0]);

  /* Points: the nodes, and the middles of both cells, which have no node. */
  size_t offsets_of_points = 0, entries = 0;
  CHECK(fmc_context_point_weights(contact, NULL, 0, &offsets_of_points, NULL, NULL, 0, &entries));
  CHECK(fmc_context_point_weights(contact, NULL, 0, NULL, NULL, NULL, 0, NULL));
  const size_t room = offsets_of_points, points = room - 1;
  EXPECT(points == NODES + 2);
  int32_t *starts = malloc(room * sizeof *starts), *nodes = malloc(entries * sizeof *nodes);
  double *weights = malloc(entries * sizeof *weights);
  starts[0] = nodes[0] = -7;
  const fmc_status small = FMC_ERROR_BUFFER_TOO_SMALL, null = FMC_ERROR_NULL_POINTER;
  EXPECT(fmc_context_point_weights(contact, starts, room - 1, NULL, nodes, weights, entries, NULL) == small);
  EXPECT(fmc_context_point_weights(contact, starts, room, NULL, nodes, weights, entries - 1, NULL) == small);
  EXPECT(fmc_context_point_weights(contact, NULL, room, NULL, nodes, weights, entries, NULL) == null);
  EXPECT(fmc_context_point_weights(contact, starts, room, NULL, NULL, weights, entries, NULL) == null);
  EXPECT(fmc_context_point_weights(contact, starts, room, NULL, nodes, NULL, entries, NULL) == null);
  EXPECT(fmc_context_point_weights(NULL, starts, room, NULL, nodes, weights, entries, NULL) == null);
  EXPECT(starts[0] == -7 && nodes[0] == -7);
  CHECK(fmc_context_point_weights(contact, starts, room, NULL, nodes, weights, entries, NULL));
  /* All counts from 1, as the option says. */
  EXPECT(starts[0] == 1 && starts[points] == (int32_t)entries + 1);
  for (size_t p = 0; p <= points; p++) starts[p]--;
  /* A corner is itself; the middle of an edge lies 4/3 as far from the chord as its node. */
  EXPECT(starts[1] == 1 && nodes[0] == 1 && weights[0] == 1);
  double of_node = 0;
  for (int32_t e = starts[4]; e < starts[5]; e++) of_node += nodes[e] == 5 ? weights[e] : 0;
  EXPECT(fabs(of_node - 4.0 / 3.0) < 1e-15);

  /* Forces at contact points, by the shape functions of the points and the weights of the nodes. */
  size_t count;
  double brought[NODES][2] = {{0}};
  CHECK(fmc_context_contact_points(contact, &coords, NULL, 0, &count));
  fmc_contact_point *found = malloc(count * sizeof *found);
  CHECK(fmc_context_contact_points(contact, &coords, found, count, NULL));
  for (size_t i = 0; i < count; i++)
    for (int s = 0; s < 2; s++)
      for (int k = 0; k < found[i].sides[s].node_count; k++) {
        const int64_t point = found[i].sides[s].nodes[k] - 1;
        const double size = (s ? 1 : -1) * found[i].pressure * found[i].area * found[i].sides[s].weights[k];
        for (int32_t e = starts[point]; e < starts[point + 1]; e++)
          for (int axis = 0; axis < 2; axis++)
            brought[nodes[e] - 1][axis] += size * weights[e] * found[i].normal[axis];
      }
  for (int n = 0; n < NODES; n++) EXPECT(fabs(brought[n][0] - f[n][0]) < 1e-9);

  /* Rows are points, columns degrees of freedom of nodes. */
  size_t rows, slopes;
  CHECK(fmc_context_gap_constraints(contact, &coords, 0.3, NULL, 0, &rows));
  CHECK(fmc_context_gap_gradient(contact, NULL, 0, NULL, NULL, NULL, 0, &slopes));
  fmc_gap_constraint *gaps = malloc(rows * sizeof *gaps);
  int32_t *offsets = malloc((rows + 1) * sizeof *offsets), *cols = malloc(slopes * sizeof *cols);
  double *values = malloc(slopes * sizeof *values);
  CHECK(fmc_context_gap_constraints(contact, &coords, 0.3, gaps, rows, NULL));
  CHECK(fmc_context_gap_gradient(contact, offsets, rows + 1, NULL, cols, values, slopes, NULL));
  EXPECT(offsets[0] == 1 && offsets[rows] == (int32_t)slopes + 1);
  for (size_t r = 0; r < rows; r++) {
    EXPECT(gaps[r].node >= 1 && gaps[r].node <= (int64_t)points);
    if (gaps[r].node == 16 && gaps[r].body == 1) EXPECT(fabs(gaps[r].gap / gaps[r].area + 0.1) < 1e-12);
  }
  for (size_t e = 0; e < slopes; e++) EXPECT(cols[e] >= 1 && cols[e] <= 2 * NODES);

  /* The same bodies by their edges, the middles last, without cells: the same forces. */
  int32_t edges[8][3];
  for (int s = 0; s < 2; s++)
    for (int e = 0; e < 4; e++) {
      edges[4 * s + e][0] = 8 * s + e + 1;
      edges[4 * s + e][1] = 8 * s + (e + 1) % 4 + 1;
      edges[4 * s + e][2] = 8 * s + e + 5;
    }
  const fmc_facet_block skin = {FMC_FACET_LINE3, 4, edges[0], 8};
  fmc_context *by_edges = NULL;
  double g[NODES][2];
  const fmc_forces same = {g[0], NODES, 2, 1};
  CHECK(fmc_context_new_from_facets(2, &coords, &skin, 1, NULL, &options, &by_edges));
  CHECK(fmc_context_evaluate(by_edges, &coords, &same, 0, NULL));
  for (int n = 0; n < NODES; n++)
    for (int axis = 0; axis < 2; axis++) EXPECT(fabs(g[n][axis] - f[n][axis]) < 1e-9);
  CHECK(fmc_context_free(&by_edges));

  /* A straight cell whose side is an edge with a node in its middle does not fit. */
  const int32_t beside[4] = {2, 10, 11, 3};
  const fmc_cell_block mixed[2] = {{FMC_QUAD8, 4, conn, 1}, {FMC_QUAD4, 4, beside, 1}};
  fmc_context *none = NULL;
  EXPECT(fmc_context_new_from_cells(2, &coords, mixed, 2, NULL, &options, &none) == FMC_ERROR_NON_CONFORMING);
  printf("%s\n", fmc_last_error());

  free(starts), free(nodes), free(weights), free(found), free(gaps), free(offsets), free(cols), free(values);
  CHECK(fmc_context_free(&contact));
  printf("%d failures\n", failures);
  return failures != 0;
}
