/* A host that has floating-point traps on, as gfortran -ffpe-trap=invalid,zero,overflow does: valid input must raise none.
 * Two blocks and every kind of obstacle, in many positions, in the plane and in space, by both laws and estimators.
 *
 *   cc traps.c $(pkg-config --cflags --libs fmc_contact) -lm */
#define _GNU_SOURCE
#include <fenv.h>
#include <fmc_contact.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static sigjmp_buf back;
static int failures = 0;
static char scene[200];

static void on_trap(int signal_number) {
  (void)signal_number;
  siglongjmp(back, 1);
}

static void failed(const char *what) {
  failures++;
  if (failures <= 40) printf("%s: %s\n", scene, what);
}

/* What only some estimators support is no failure. */
static int good(fmc_status status) {
  if (status == FMC_OK) return 1;
  if (status != FMC_ERROR_UNSUPPORTED) failed(fmc_last_error());
  return 0;
}

static int32_t ball(void *user, size_t n, const double *x, double *phi, double *grad) {
  const int dim = *(const int *)user;
  for (size_t i = 0; i < n; i++) {
    double r = 0;
    for (int d = 0; d < dim; d++) r += x[dim * i + d] * x[dim * i + d];
    r = sqrt(r);
    phi[i] = r - 0.5;
    for (int d = 0; d < dim; d++) grad[dim * i + d] = r > 0 ? x[dim * i + d] / r : d == 0;
  }
  return 0;
}

static const char *const SHAPES[] = {"none",    "half-space", "ball", "cuboid", "cylinder", "cone",
                                     "capsule", "polytope",   "hull", "field",  "callback"};
enum { SHAPE_COUNT = sizeof SHAPES / sizeof *SHAPES };

static int add(fmc_context *context, int shape, int *dim, const fmc_pose *pose) {
  const double heights[9] = {0, 0, 0, 0, 0.1, 0, 0, 0, 0};
  const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const double simplex[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int32_t sides[8] = {0, 1, 1, 2, 2, 3, 3, 0}, faces[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  const int kind = shape < 10 ? shape - 1 : FMC_SHAPE_SIGNED_DISTANCE;
  fmc_shape data;
  if (shape == 0) return 1;
  if (!good(fmc_shape_init(&data, kind))) return 0;
  data.radius = data.half_height = data.thickness = 0.5;
  for (int d = 0; d < 3; d++) data.half_extents[d] = 0.5;
  for (int d = 0; d < 2; d++) data.counts[d] = 3, data.lengths[d] = 2;
  data.points = *dim == 2 ? (fmc_coords){square[0], 4, 2, 1} : (fmc_coords){simplex[0], 4, 3, 1};
  data.facets = *dim == 2 ? sides : faces, data.facet_count = 4;
  data.heights = heights;
  data.signed_distance = ball, data.user = dim;
  return good(fmc_context_add_obstacle(context, &data, pose, NULL));
}

/* Everything that a host calls in one step. */
static void step(int dim, const fmc_coords *x, const fmc_cell_block *block, const fmc_options *options, int shape,
                 const fmc_pose *pose, fmc_context **context) {
  double forces[48], masses[16], stable;
  const fmc_forces f = {forces, x->node_count, dim, 1};
  if (!good(fmc_context_new_from_cells(dim, x, block, 1, NULL, options, context))) return;
  if (!add(*context, shape, &dim, pose)) return;
  for (size_t node = 0; node < x->node_count; node++) masses[node] = 0.1 + (double)node;
  for (int round = 0; round < 2; round++) {
    size_t rank_one;
    if (!good(fmc_context_evaluate(*context, x, &f, 0, NULL))) return;
    good(fmc_context_tangent(*context, x, 0, &rank_one));
    good(fmc_context_tangent(*context, x, FMC_TANGENT_SEMIDEFINITE, &rank_one));
    good(fmc_context_stable_step(*context, x, masses, &stable));
    if (!good(fmc_context_keep_patches(*context, x, NULL))) return;
  }
}

/* Two unit blocks of one cell, the second `apart` above the first and moved `aside`, both turned by `angle`. */
static void blocks(int dim, double apart, double aside, double angle, double *coords) {
  static const double corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const int nodes = dim == 2 ? 4 : 8;
  for (int k = 0; k < 2 * nodes; k++) {
    double p[3] = {corners[k % nodes][0], corners[k % nodes][1], corners[k % nodes][2]};
    if (k >= nodes) {
      p[0] += aside;
      p[dim - 1] += apart;
    }
    const double c = cos(angle), s = sin(angle), u = c * p[0] - s * p[1], v = s * p[0] + c * p[1];
    p[0] = u;
    p[1] = v;
    for (int d = 0; d < dim; d++) coords[dim * k + d] = p[d];
  }
}

/* How far the second block is above the first, and aside, and by how much both are turned. */
static const double PLACES[][3] = {{1.1, 0.1, 0},  {0.99, 0.1, 0}, {1, 0, 0},       {0.99, 0, 0},     {0.99, 0, 0.3},
                                   {0.5, 0.6, 0},  {0, 0, 0},      {0.9, 0.3, 1.1}, {1.2, 0, 1e-300}, {0.7, 1e-17, 1e-17}};
enum { PLACE_COUNT = sizeof PLACES / sizeof *PLACES, WAY_COUNT = 6 };

static fmc_options options_of(int way) {
  fmc_options options;
  if (fmc_options_init(&options) != FMC_OK) failed("options");
  options.stiffness = 1e4;
  if (way != 2 && way != 3) options.fiber_count = 100;
  options.law = way & 1 ? FMC_LAW_FIBER : FMC_LAW_VOLUME;
  options.estimator = way == 2 || way == 3 ? FMC_ESTIMATOR_EXACT : FMC_ESTIMATOR_FIBERS;
  if (way == 4) options.pattern = FMC_PATTERN_ISOTROPIC;
  if (way == 5) options.self_contact = 1;
  if (way == 5) options.smoothing_length = 1e-3;
  return options;
}

static void run(int dim, int way, int place, int shape, int turned) {
  static const int32_t numbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const double axis[3] = {0.3, 0.2, 0.9}, origin[3] = {0.2, 0.1, 0};
  double coords[48];
  fmc_pose pose;
  static fmc_context *context;
  const fmc_options options = options_of(way);
  const fmc_cell_block block = {dim == 2 ? FMC_QUAD4 : FMC_HEX8, 4, numbers, 2};
  const fmc_coords x = {coords, dim == 2 ? 8 : 16, dim, 1};
  blocks(dim, PLACES[place][0], PLACES[place][1], PLACES[place][2], coords);
  if (fmc_pose_init(&pose) != FMC_OK || (turned && fmc_pose_along(dim, origin, axis, &pose) != FMC_OK)) failed("pose");
  snprintf(scene, sizeof scene, "dim %d, way %d, place %d, %s%s", dim, way, place, SHAPES[shape], turned ? ", turned" : "");
  context = NULL;
  feclearexcept(FE_ALL_EXCEPT);
  if (sigsetjmp(back, 1)) {
    fedisableexcept(FE_ALL_EXCEPT);
    failed("a floating-point trap"); /* What the call held is lost. */
    return;
  }
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  step(dim, &x, &block, &options, shape, &pose, &context);
  fedisableexcept(FE_ALL_EXCEPT);
  fmc_context_free(&context);
}

int main(void) {
  signal(SIGFPE, on_trap);
  for (int dim = 2; dim <= 3; dim++)
    for (int way = 0; way < WAY_COUNT; way++)
      for (int place = 0; place < PLACE_COUNT; place++)
        for (int shape = 0; shape < SHAPE_COUNT; shape++) {
          run(dim, way, place, shape, 0);
          if (shape > 0) run(dim, way, place, shape, 1);
        }
  printf("%d failures\n", failures);
  return failures != 0;
}
