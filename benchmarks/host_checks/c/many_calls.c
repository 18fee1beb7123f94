/* The same calls over and over: 10 000 rounds, or as many as the first argument says, of two squares and a ball, from the
 * making of the context to its end, in which every kind of call is made, refused ones too. A host of months calls no less. What
 * the process has taken from the system after a few rounds is all that it ever takes.
 *
 *   cc many_calls.c $(pkg-config --cflags --libs fmc_contact)
 *   GLIBC_TUNABLES=glibc.malloc.tcache_count=0:glibc.malloc.mxfast=0 ./a.out
 *
 * Without the environment of the second line glibc counts freed blocks that it keeps at hand, some ten thousand bytes, for held ones. */
#include <fmc_contact.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

static int failures = 0;
#define OK(call)                                                                                   \
  do {                                                                                             \
    const fmc_status status_ = (call);                                                             \
    if (status_ != FMC_OK) printf("FAIL %s: %s\n", #call, fmc_last_error()), failures++;           \
  } while (0)
#define REFUSED(call) ((call) == FMC_OK ? (void)(printf("FAIL %s is not refused\n", #call), failures++) : (void)0)

enum { ROOM = 1000, MOST_HELD = 1024 /* bytes */, MOST_TAKEN = 512 /* KiB */ };
static const double start[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.99, 0.1}, {1.99, 0.1}, {1.99, 0.9}, {0.99, 0.9}};
static const int32_t conn[8] = {0, 1, 2, 3, 4, 5, 6, 7}, beyond[8] = {0, 1, 2, 3, 4, 5, 6, 9};

static void step(fmc_context *context) {
  double forces[8][2], pressure[8], values[ROOM];
  int32_t offsets[17], cols[ROOM];
  const fmc_coords x = {start[0], 8, 0, 0};
  const fmc_forces f = {forces[0], 8, 0, 0};
  fmc_result result;
  size_t rows, entries, points;
  fmc_contact_point *found;
  OK(fmc_context_begin_step(context, &x));
  OK(fmc_context_keep_patches(context, &x, NULL));
  OK(fmc_context_evaluate_tangent(context, &x, 0, &f, &result, NULL));
  OK(fmc_context_tangent_csr(context, 0, NULL, 0, &rows, NULL, NULL, 0, &entries));
  if (rows == 17 && entries <= ROOM) OK(fmc_context_tangent_csr(context, 0, offsets, 17, NULL, cols, values, ROOM, NULL));
  fmc_nodal_contact nodal;
  OK(fmc_nodal_contact_init(&nodal));
  nodal.pressure = pressure;
  OK(fmc_context_nodal_contact(context, &x, &nodal));
  OK(fmc_context_contact_points(context, &x, NULL, 0, &points));
  found = malloc((points + 1) * sizeof *found);
  OK(fmc_context_contact_points(context, &x, found, points, NULL));
  free(found);
  OK(fmc_context_commit_step(context, &x));
  if (!(result.volume > 0.007 && result.volume < 0.009)) failures++, printf("FAIL volume %g\n", result.volume);
}

static void make_calls(int round) {
  static const fmc_law laws[3] = {FMC_LAW_DEPTH, FMC_LAW_FIBER, FMC_LAW_VOLUME};
  const fmc_coords x = {start[0], 8, 0, 0};
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 2}, wrong = {FMC_QUAD4, 4, beyond, 2};
  const double tip[3] = {-0.5, 0.5, 0}, up[3] = {0, 1, 0};
  fmc_options options, without_friction;
  fmc_context *context = NULL, *none = NULL;
  fmc_pose pose;
  fmc_shape shape;
  size_t ball;
  double forces[8][2], volume;
  OK(fmc_options_init(&options));
  options.stiffness = 1e5;
  options.law = laws[round % 3];
  options.estimator = round % 2 ? FMC_ESTIMATOR_EXACT : FMC_ESTIMATOR_AUTO;
  without_friction = options;
  if (options.law != FMC_LAW_VOLUME) options.friction_coefficient = 0.3;
  OK(fmc_context_new_from_cells(2, &x, &block, 1, NULL, &options, &context));
  OK(fmc_pose_along(2, tip, up, &pose));
  OK(fmc_shape_init(&shape, FMC_SHAPE_BALL));
  shape.radius = 0.45;
  OK(fmc_context_add_obstacle(context, &shape, &pose, &ball));
  OK(fmc_contact_force(2, start[0], 8, &block, 1, NULL, &without_friction, NULL, forces[0], &volume));
  for (int repeat = 0; repeat < 2; repeat++) step(context);
  REFUSED(fmc_context_new_from_cells(2, &x, &wrong, 1, NULL, &options, &none));
  REFUSED(fmc_contact_force(2, start[0], 8, &wrong, 1, NULL, &options, NULL, forces[0], &volume));
  REFUSED(fmc_context_set_pose(context, 7, &pose));
  OK(fmc_context_remove_obstacle(context, ball));
  OK(fmc_context_free(&context));
}

int main(int count, char **arguments) {
  const int rounds = count > 1 ? atoi(arguments[1]) : 10000, settled = rounds / 10;
  struct mallinfo2 before = mallinfo2(), after;
  struct rusage usage;
  long most = 0;
  for (int round = 0; round < rounds && failures == 0; round++) {
    if (round == settled) {
      before = mallinfo2();
      getrusage(RUSAGE_SELF, &usage);
      most = usage.ru_maxrss;
    }
    make_calls(round);
  }
  after = mallinfo2();
  getrusage(RUSAGE_SELF, &usage);
  /* Nothing more is held; a single block that is lost in each round would be 32 bytes a round or more. Few rounds, as under valgrind,
   * say nothing. */
  const long long held = (long long)(after.uordblks + after.hblkhd) - (long long)(before.uordblks + before.hblkhd);
  const long taken = usage.ru_maxrss - most;
  const int grows = held > MOST_HELD, swells = taken > MOST_TAKEN;
  if (rounds >= 5000 && (grows || swells)) failures++;
  printf("%d rounds: %s held, %s taken\n", rounds, grows ? "MORE" : "no more", swells ? "MORE" : "no more");
  if (failures) printf("%lld bytes more are held, %ld KiB more were taken\n", held, taken);
  printf("%d failures\n", failures);
  return failures != 0;
}
