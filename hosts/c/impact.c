/* An elastic block falls onto another: explicit dynamics with linear triangles of the host's own, in 2D, plane strain. The
 * same program, line by line, is hosts/cpp/impact.cpp, and hosts/rust has it too: they print the same history.
 *
 *   cc -ffp-contract=off impact.c $(pkg-config --cflags --libs fmc_contact)
 *
 * Without contraction of a * b + c into one operation, so that all languages round alike. */
#include <fmc_contact.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 25 + 16, TRIANGLES = 32 + 18, STEPS = 400 };

static const double YOUNG = 1e6, POISSON = 0.3, DENSITY = 1000, STIFFNESS = 1e8, DT = 1e-4;

static double start[NODES][2], x[NODES][2], v[NODES][2], mass[NODES], force[NODES][2], internal[NODES][2];
static int32_t triangles[TRIANGLES][3];
static int node_count = 0, triangle_count = 0;

static void check(fmc_status status) {
  if (status == FMC_OK) return;
  fprintf(stderr, "%s: %s\n", fmc_status_name(status), fmc_last_error());
  exit(1);
}

/* Appends the block [x0, x0 + side] x [y0, y0 + side], in n x n squares of two triangles each. */
static void add_block(double x0, double y0, double side, int n) {
  const int first = node_count;
  for (int j = 0; j <= n; j++) {
    for (int i = 0; i <= n; i++) {
      start[node_count][0] = x0 + i * side / n;
      start[node_count][1] = y0 + j * side / n;
      node_count++;
    }
  }
  for (int j = 0; j < n; j++) {
    for (int i = 0; i < n; i++) {
      const int32_t a = first + j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      const int32_t two[2][3] = {{a, b, c}, {a, c, d}};
      for (int t = 0; t < 2; t++, triangle_count++) {
        for (int k = 0; k < 3; k++) triangles[triangle_count][k] = two[t][k];
      }
    }
  }
}

/* Twice the area of a triangle without deformation. */
static double twice_area(const int32_t *node) {
  const double *p = start[node[0]], *q = start[node[1]], *r = start[node[2]];
  return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
}

static void lump_masses(void) {
  for (int t = 0; t < TRIANGLES; t++) {
    for (int k = 0; k < 3; k++) mass[triangles[t][k]] += DENSITY * (twice_area(triangles[t]) / 2) / 3;
  }
}

/* The elastic forces of all triangles: constant strain, small displacements. */
static void find_internal_forces(void) {
  const double lambda = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), mu = YOUNG / (2 * (1 + POISSON));
  memset(internal, 0, sizeof internal);
  for (int t = 0; t < TRIANGLES; t++) {
    const int32_t *node = triangles[t];
    const double area2 = twice_area(node);
    double bx[3], by[3], exx = 0, eyy = 0, gxy = 0;
    for (int k = 0; k < 3; k++) {
      const double *next = start[node[(k + 1) % 3]], *last = start[node[(k + 2) % 3]];
      bx[k] = (next[1] - last[1]) / area2;
      by[k] = (last[0] - next[0]) / area2;
      const double ux = x[node[k]][0] - start[node[k]][0], uy = x[node[k]][1] - start[node[k]][1];
      exx += bx[k] * ux;
      eyy += by[k] * uy;
      gxy += by[k] * ux + bx[k] * uy;
    }
    const double sxx = (lambda + 2 * mu) * exx + lambda * eyy;
    const double syy = lambda * exx + (lambda + 2 * mu) * eyy;
    const double sxy = mu * gxy;
    for (int k = 0; k < 3; k++) {
      internal[node[k]][0] -= area2 / 2 * (sxx * bx[k] + sxy * by[k]);
      internal[node[k]][1] -= area2 / 2 * (sxy * bx[k] + syy * by[k]);
    }
  }
}

int main(void) {
  /* 1. The lower block, whose bottom row is held, and the upper one, which falls. */
  add_block(0, 0, 1, 4);
  const int held = 5, upper = node_count;
  add_block(0.2, 1.001, 0.6, 3);
  lump_masses();
  for (int n = 0; n < NODES; n++) {
    x[n][0] = start[n][0];
    x[n][1] = start[n][1];
    if (n >= upper) v[n][1] = -1;
  }

  /* 2. The contact, which finds the facets once. */
  fmc_options options;
  check(fmc_options_init(&options));
  options.law = FMC_LAW_DEPTH;
  options.estimator = FMC_ESTIMATOR_EXACT;
  options.stiffness = STIFFNESS;
  const fmc_cell_block cells = {FMC_TRI3, 4, triangles[0], TRIANGLES};
  const fmc_coords coords = {x[0], NODES, 2, 1};
  const fmc_forces forces = {force[0], NODES, 2, 1};
  fmc_context *contact;
  check(fmc_context_new_from_cells(2, &coords, &cells, 1, NULL, &options, &contact));

  /* 3. Leapfrog; a line of the history every 20 steps. */
  for (int step = 0; step <= STEPS; step++) {
    fmc_result result;
    check(fmc_context_evaluate(contact, &coords, &forces, 0, &result));
    if (step % 20 == 0) {
      fmc_resultant block;
      double momentum = 0, total = 0;
      check(fmc_context_body_resultant(contact, 1, &block));
      for (int n = upper; n < NODES; n++) {
        momentum += mass[n] * v[n][1];
        total += mass[n];
      }
      printf("%6d %23.15e %23.15e %23.15e\n", step, block.force[1], momentum / total, result.energy);
    }
    find_internal_forces();
    for (int n = held; n < NODES; n++) {
      for (int axis = 0; axis < 2; axis++) {
        v[n][axis] += DT * (force[n][axis] + internal[n][axis]) / mass[n];
        x[n][axis] += DT * v[n][axis];
      }
    }
  }
  check(fmc_context_free(&contact));
  return 0;
}
