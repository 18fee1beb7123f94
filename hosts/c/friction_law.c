/* Your own law of friction of a square on a plane: the coefficient falls with the speed, and the traction stays below what the metal bears. */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>

#define CHECK(call)                          \
  if ((call) != FMC_OK) {                    \
    fprintf(stderr, "%s\n", fmc_last_error()); \
    return 1;                                \
  }

typedef struct {
  double slow, fast, speed, most;
} stribeck;

/* limit = min((fast + (slow - fast) exp(-v / speed)) p, most), at all facets of a pair; the history is the way slid. */
static int32_t limit(void *user, const fmc_friction_facets *facets, const fmc_friction_response *response) {
  const stribeck *own = user;
  const size_t axes = facets->dim - 1;
  for (size_t f = 0; f < facets->count; f++) {
    const double *slip = facets->slip + f * axes, *trial = facets->trial + f * axes;
    const double p = facets->pressure[f], way = axes == 1 ? fabs(slip[0]) : hypot(slip[0], slip[1]);
    const double part = (own->slow - own->fast) * exp(-way / facets->time_step / own->speed), mu = own->fast + part;
    const double elastic = axes == 1 ? fabs(trial[0]) : hypot(trial[0], trial[1]);
    response->limit[f] = fmin(mu * p, own->most);
    response->by_pressure[f] = mu * p < own->most ? mu : 0;
    for (size_t i = 0; i < axes; i++)
      response->by_slip[f * axes + i] =
          mu * p < own->most && way > 0 ? -part * p / own->speed / facets->time_step * slip[i] / way : 0;
    if (elastic * facets->stiffness > response->limit[f])
      response->history[f] += elastic - response->limit[f] / facets->stiffness;
  }
  return 0;
}

static void tell(void *user, int32_t level, const char *text) {
  (void)user, (void)level;
  puts(text);
}

int main(void) {
  double x[4][2] = {{0, -0.25}, {1, -0.25}, {1, 1}, {0, 1}};
  const int32_t conn[4] = {0, 1, 2, 3};
  const fmc_cell_block square = {FMC_QUAD4, 4, conn, 1};
  const fmc_coords coords = {x[0], 4, 2, 1};
  stribeck own = {0.5, 0.25, 2, 8};
  fmc_options options;
  fmc_pair_options pair;
  fmc_friction_law law;
  fmc_context *contact = NULL;
  fmc_shape plane;
  fmc_pose pose;
  CHECK(fmc_options_init(&options));
  options.stiffness = 64;
  CHECK(fmc_context_new_from_cells(2, &coords, &square, 1, NULL, &options, &contact));
  CHECK(fmc_shape_init(&plane, FMC_SHAPE_HALF_SPACE));
  CHECK(fmc_pose_init(&pose));
  CHECK(fmc_context_add_obstacle(contact, &plane, &pose, NULL));
  CHECK(fmc_friction_law_init(&law));
  law.limit = limit, law.user = &own, law.history_count = 1;
  CHECK(fmc_friction_law_check(&law, 2, 50, 1, 0.5, tell, NULL));
  CHECK(fmc_pair_options_init(&pair));
  CHECK(fmc_context_set_friction_law_pair(contact, FMC_PARTNER_BODY, 0, FMC_PARTNER_OBSTACLE, 0, &pair, &law));
  CHECK(fmc_context_set_time_step(contact, 0.5));

  /* A pressure of 64 / 4 on the length 1. The last step presses twice as much. */
  CHECK(fmc_context_begin_step(contact, &coords));
  for (int step = 1; step <= 3; step++) {
    const double speed = step == 1 ? 1 : 4;
    fmc_result result;
    fmc_resultant body;
    double slid = 0, history[4];
    size_t count;
    for (int node = 0; node < 4; node++) x[node][0] += 0.5 * speed;
    if (step == 3) x[0][1] = x[1][1] = -0.5;
    CHECK(fmc_context_evaluate(contact, &coords, NULL, 0, &result));
    CHECK(fmc_context_body_resultant(contact, 0, &body));
    CHECK(fmc_context_commit_step(contact, &coords));
    CHECK(fmc_context_friction_history(contact, history, 4, &count));
    /* As the square sinks, its walls slide a little too. */
    for (size_t f = 0; f < count; f++) slid = fmax(slid, history[f]);
    printf("speed %.0f  normal %.6f  friction %.6f  slid %.6f\n", speed, body.force[1] - body.friction[1], -body.friction[0], slid);
  }
  return fmc_context_free(&contact);
}
