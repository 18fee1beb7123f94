/* A square is pressed on another and pushed along it, in steps: stuck below mu times the normal force, sliding at it. Once
 * with a context that is kept, once with a call that keeps nothing, which must lead to the same bits.
 *
 *   cc friction.c $(pkg-config --cflags --libs fmc_contact) -lm */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;
#define EXPECT(condition)                                                      \
  do {                                                                         \
    const int good_ = (condition);                                             \
    if (!good_) failures++;                                                    \
    printf("%s %s\n", good_ ? "ok  " : "FAIL", #condition);                    \
  } while (0)
#define OK(call)                                                               \
  do {                                                                         \
    const fmc_status status_ = (call);                                         \
    if (status_ == FMC_OK) break;                                              \
    failures++;                                                                \
    printf("FAIL %s: %s: %s\n", #call, fmc_status_name(status_), fmc_last_error()); \
  } while (0)

enum { NODES = 8, STEPS = 4, ROOM = 64 };
static const int32_t conn[8] = {0, 1, 2, 3, 4, 5, 6, 7};
static const double depth = 1e-3, mu = 0.3, stiffness = 1e3;

/* The upper square, 1e-3 deep in the lower one, displaced along it. */
static void place(double by, double coords[NODES][2]) {
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; k++) {
    coords[k][0] = 2 * corners[k][0] - 0.5;
    coords[k][1] = 2 * corners[k][1] - 2;
    coords[4 + k][0] = corners[k][0] + by;
    coords[4 + k][1] = corners[k][1] - depth;
  }
}

int main(void) {
  const double way[STEPS] = {1e-4, 1e-3, 9e-4, -1e-3};
  double start[NODES][2], coords[NODES][2], forces[NODES][2], other[NODES][2], slip[ROOM], kept[ROOM], before[ROOM];
  double friction[NODES][2], sliding[NODES];
  int32_t status[NODES];
  fmc_options options;
  OK(fmc_options_init(&options));
  options.stiffness = stiffness;
  options.friction_coefficient = mu;

  place(0, start);
  fmc_context *context = NULL;
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 2};
  const fmc_coords at_start = {start[0], NODES, 0, 0}, at = {coords[0], NODES, 0, 0};
  const fmc_forces out = {forces[0], NODES, 0, 0};
  OK(fmc_context_new_from_cells(2, &at_start, &block, 1, NULL, &options, &context));
  EXPECT(fmc_context_evaluate(context, &at_start, &out, 0, NULL) == FMC_ERROR_NO_STEP);
  OK(fmc_context_begin_step(context, &at_start));

  EXPECT(fmc_contact_force(2, start[0], NODES, &block, 1, NULL, &options, NULL, other[0], NULL) == FMC_ERROR_NO_STEP);
  EXPECT(strstr(fmc_last_error(), "give fmc_contact_force a step") != NULL);

  /* The length of the slip is told by a call without room for it: nothing has slipped yet. */
  fmc_friction_step step;
  OK(fmc_friction_step_init(&step));
  size_t length = 7, next = 0;
  step.start = start[0];
  step.next_slip_count = &length;
  OK(fmc_contact_force(2, start[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL));
  EXPECT(length == 0);
  memset(slip, 0, sizeof slip);

  double reference[NODES][2];
  memcpy(reference, start, sizeof start);
  for (int k = 0; k < STEPS; k++) {
    place(way[k], coords);
    fmc_result result;
    OK(fmc_context_evaluate(context, &at, &out, 0, &result));
    double normal = 0, along = 0;
    for (int node = 4; node < NODES; node++) {
      along += forces[node][0];
      normal += forces[node][1];
    }
    printf("pushed by %7.4f: %8.5f of %.5f, dissipated %.2e\n", way[k], along, mu * normal, result.friction_dissipation);
    EXPECT(fabs(along) <= 1.001 * mu * normal && result.friction_dissipation >= 0);
    fmc_nodal_contact nodal;
    OK(fmc_nodal_contact_init(&nodal));
    nodal.friction = friction[0], nodal.sliding = sliding, nodal.status = status;
    OK(fmc_context_nodal_contact(context, &at, &nodal));
    EXPECT(k == 0 || k == 2 ? status[4] == FMC_NODE_STICKING : status[4] == FMC_NODE_SLIDING);
    EXPECT(friction[4][0] * along > 0 && friction[0][0] == 0);

    OK(fmc_friction_step_init(&step));
    step.start = start[0];
    step.reference = reference[0];
    step.slip = step.next_slip = slip;
    step.slip_count = length;
    step.next_slip_capacity = ROOM;
    step.next_slip_count = &next;
    memcpy(before, slip, sizeof slip);
    double volume = -1;
    OK(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], &volume));
    EXPECT(memcmp(forces, other, sizeof forces) == 0 && volume == result.volume);
    OK(fmc_context_commit_step(context, &at));
    /* Rows of 8 numbers: a facet of either block, and what it faces. */
    EXPECT(next >= 16 && next % 8 == 0 && slip[2] == 1 && slip[next - 8 + 2] == 0);
    length = next;
    OK(fmc_context_slip(context, kept, ROOM, &next));
    EXPECT(next == length);
    EXPECT(memcmp(kept, slip, length * sizeof *slip) == 0 && memcmp(before, slip, sizeof slip) != 0);
    memcpy(start, coords, sizeof start);
  }

  /* What is refused writes nothing. */
  memcpy(before, slip, sizeof slip);
  size_t told = 7;
  step.slip_count = length - 1;
  step.next_slip_count = &told;
  memset(other, 0, sizeof other);
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_LENGTH);
  EXPECT(told == 7 && memcmp(before, slip, sizeof slip) == 0 && other[4][1] == 0);
  step.slip_count = length;
  step.next_slip_capacity = length - 1;
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_BUFFER_TOO_SMALL);
  EXPECT(told == 7 && memcmp(before, slip, sizeof slip) == 0 && other[4][1] == 0);
  step.next_slip_capacity = length;
  slip[8] = slip[0];
  slip[10] = slip[2];
  slip[11] = slip[3];
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_INDEX_OUT_OF_RANGE);
  memcpy(slip, before, sizeof slip);
  slip[5] = NAN;
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_NON_FINITE_SLIP);
  slip[5] = before[5];
  step.reserved[0] = 1;
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_RESERVED_FIELD);
  step.struct_size = 8;
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_STRUCT_SIZE);
  EXPECT(fmc_friction_step_init(NULL) == FMC_ERROR_NULL_POINTER);
  OK(fmc_friction_step_init(&step));
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, &step, other[0], NULL) ==
         FMC_ERROR_NULL_POINTER);
  EXPECT(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, NULL, other[0], NULL) ==
         FMC_ERROR_NO_STEP);

  fmc_context_free(&context);
  printf("%d failures\n", failures);
  return failures != 0;
}
