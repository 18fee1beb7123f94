/* Newton's method with the contact tangent: a rigid square on four springs sinks onto another that is held.
 *
 *        .-- load 0.8 --.        The upper square moves as a whole, by u. Its energy is k_s u.u / 2 - load, with springs
 *       7 ------------- 6        k_s = 1, plus the contact energy of the law "fiber". Where they touch over the length 1
 *       |               |        with pressure k * depth, equilibrium is 0.8 = u + k (u - gap): with k = 1000 and a gap
 *       4 ------------- 5        of 0.1 that is u = 100.8 / 1001.
 *     3 ------------- 2
 *     |               |          cc newton.c $(pkg-config --cflags --libs fmc_contact) -lm                            */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static fmc_context *context;

static void check(fmc_status status) {
  if (status != FMC_OK) {
    fprintf(stderr, "%s\n", fmc_last_error());
    exit(1);
  }
}

int main(void) {
  const double start[8][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0.5, 1.1}, {1.5, 1.1}, {1.5, 2}, {0.5, 2}};
  const int32_t conn[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 2};
  double u = 0.12; /* downwards; a guess at which they overlap, so that the contact has a direction */

  fmc_options options;
  check(fmc_options_init(&options));
  options.law = FMC_LAW_FIBER;
  options.estimator = FMC_ESTIMATOR_EXACT;
  options.stiffness = 1000.0;
  const fmc_coords initial = {start[0], 8, 0, 0};
  check(fmc_context_new_from_cells(2, &initial, &block, 1, NULL, &options, &context));

  for (int iteration = 0; iteration < 10; iteration++) {
    double x[8][2], f[8][2];
    for (int node = 0; node < 8; node++) {
      x[node][0] = start[node][0];
      x[node][1] = start[node][1] - (node > 3 ? u : 0);
    }
    const fmc_coords coords = {x[0], 8, 0, 0};
    const fmc_forces forces = {f[0], 8, 0, 0};
    if (iteration == 0) check(fmc_context_keep_patches(context, &coords, NULL));
    check(fmc_context_evaluate(context, &coords, &forces, 0, NULL));
    double residual = 0.8 - u;
    for (int node = 4; node < 8; node++) residual -= f[node][1];
    printf("iteration %d  u %.9f  residual %8.1e\n", iteration, u, residual);
    if (fabs(residual) < 1e-10) break;

    /* The stiffness of the contact against moving the upper square as a whole: the sum of its entries. */
    size_t count;
    check(fmc_context_tangent(context, &coords, 0, NULL));
    check(fmc_context_tangent_entries(context, NULL, NULL, NULL, 0, &count));
    int32_t *rows = malloc(count * sizeof *rows), *cols = malloc(count * sizeof *cols);
    double *values = malloc(count * sizeof *values), stiffness = 1;
    check(fmc_context_tangent_entries(context, rows, cols, values, count, NULL));
    for (size_t entry = 0; entry < count; entry++)
      if (rows[entry] >= 8 && cols[entry] >= 8 && rows[entry] % 2 == 1 && cols[entry] % 2 == 1) stiffness += values[entry];
    free(rows), free(cols), free(values);
    u += residual / stiffness;
  }

  /* The product with the same motion is the same stiffness. */
  double motion[16] = {0}, product[16], along = 1;
  for (int node = 4; node < 8; node++) motion[2 * node + 1] = 1;
  check(fmc_context_tangent_product(context, motion, product, 16));
  for (int node = 4; node < 8; node++) along += product[2 * node + 1];
  printf("u %.6f, expected %.6f; stiffness %.3f\n", u, 100.8 / 1001, along);
  fmc_context_free(&context);
  return fabs(u - 100.8 / 1001) < 1e-9 && fabs(along - 1001) < 1e-6 ? 0 : 1;
}
