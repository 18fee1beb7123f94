/* A square lies on a disc that is given twice: as a shape, and as a signed distance of the host's own. Both must press
 * it up alike, and the disc must be pressed down by the same force.
 *
 *   cc obstacles.c $(pkg-config --cflags --libs fmc_contact) -lm */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(fmc_status status) {
  if (status == FMC_OK) return;
  fprintf(stderr, "%s: %s\n", fmc_status_name(status), fmc_last_error());
  exit(1);
}

/* Distance from the circle about the origin whose radius `user` points to, and its gradient, for n points at once. */
static int32_t disc(void *user, size_t n, const double *x, double *phi, double *grad) {
  const double radius = *(const double *)user;
  for (size_t i = 0; i < n; i++) {
    const double r = hypot(x[2 * i], x[2 * i + 1]);
    phi[i] = r - radius;
    grad[2 * i] = r > 0 ? x[2 * i] / r : 0;
    grad[2 * i + 1] = r > 0 ? x[2 * i + 1] / r : 1;
  }
  return 0;
}

int main(void) {
  /* 1. A unit square with its lower side at y = 0, and a disc of radius 2 whose top is 0.05 above that. */
  const double coords[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, depth = 0.05;
  double radius = 2;
  const int32_t conn[4] = {0, 1, 2, 3};
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 1};
  const fmc_coords x = {coords[0], 4, 2, 1};
  fmc_options options;
  check(fmc_options_init(&options));
  options.law = FMC_LAW_VOLUME;
  check(fmc_options_set(&options, "stiffness", "1000"));
  check(fmc_options_set(&options, "spacing", "0.001"));
  fmc_pose pose;
  check(fmc_pose_init(&pose));
  pose.position[0] = 0.5;
  pose.position[1] = depth - radius;

  /* 2. The overlap is the cap of the disc above y = 0, 2 sqrt(r^2 - (r - depth)^2) wide. */
  const double width = 2 * sqrt(radius * radius - (radius - depth) * (radius - depth));
  const double cap = radius * radius * acos(1 - depth / radius) - (radius - depth) * width / 2;

  /* 3. Once as a ball, once by the callback. The force on the square is k times the width of the cap. */
  for (int way = 0; way < 2; way++) {
    fmc_context *context;
    fmc_result result;
    fmc_resultant square, obstacle;
    double forces[4][2];
    const fmc_forces f = {forces[0], 4, 2, 1};
    check(fmc_context_new_from_cells(2, &x, &block, 1, NULL, &options, &context));
    fmc_shape shape;
    check(fmc_shape_init(&shape, way == 0 ? FMC_SHAPE_BALL : FMC_SHAPE_SIGNED_DISTANCE));
    shape.radius = radius; /* Read of a ball alone, as the next two are of a signed distance. */
    shape.signed_distance = disc;
    shape.user = &radius;
    check(fmc_context_add_obstacle(context, &shape, &pose, NULL));
    check(fmc_context_evaluate(context, &x, &f, 0, &result));
    check(fmc_context_body_resultant(context, 0, &square));
    check(fmc_context_obstacle_resultant(context, 0, &obstacle));
    printf("%s  volume %.4f of %.4f  force %.0f of %.0f\n", way == 0 ? "ball    " : "callback", result.volume, cap,
           square.force[1], 1000 * width);
    if (fabs(result.volume - cap) > 1e-3 * cap || fabs(square.force[1] - 1000 * width) > 1.0) return 1;
    if (fabs(square.force[1] + obstacle.force[1]) > 1e-9) return 1;
    if (fabs(square.moment[2] + obstacle.moment[2]) > 1e-9) return 1;
    check(fmc_context_free(&context));
  }
  return 0;
}
