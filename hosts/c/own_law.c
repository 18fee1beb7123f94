/* Your own law between two squares: a bond that stiffens as it opens, with the largest opening so far as its history. */
#include <fmc_contact.h>
#include <stdio.h>

#define CHECK(call)                          \
  if ((call) != FMC_OK) {                    \
    fprintf(stderr, "%s\n", fmc_last_error()); \
    return 1;                                \
  }

typedef struct {
  double k, c;
} bond;

/* t = k s + c s^3 along every axis, at all points of a pair. */
static int32_t respond(void *user, const fmc_law_points *points, const fmc_law_response *response) {
  const bond *own = user;
  const size_t dim = points->dim;
  for (size_t p = 0; p < points->count; p++) {
    const double *jump = points->jump + p * dim;
    for (size_t i = 0; i < dim; i++) {
      const double s = jump[i];
      response->traction[p * dim + i] = own->k * s + own->c * s * s * s;
      for (size_t j = 0; j < dim; j++)
        response->tangent[(p * dim + i) * dim + j] = i == j ? own->k + 3 * own->c * s * s : 0;
      response->stored[p] += own->k * s * s / 2 + own->c * s * s * s * s / 4;
    }
    if (jump[0] > response->history[p]) response->history[p] = jump[0];
  }
  return 0;
}

static void tell(void *user, int32_t level, const char *text) {
  (void)user, (void)level;
  puts(text);
}

int main(void) {
  double x[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}};
  const int32_t conn[2][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  const fmc_cell_block squares = {FMC_QUAD4, 4, conn[0], 2};
  const fmc_coords coords = {x[0], 8, 2, 1};
  bond own = {100, 4e4};
  fmc_options options;
  fmc_pair_options pair;
  fmc_own_law law;
  fmc_context *contact = NULL;
  CHECK(fmc_options_init(&options));
  options.stiffness = 1;
  CHECK(fmc_context_new_from_cells(2, &coords, &squares, 1, NULL, &options, &contact));
  CHECK(fmc_own_law_init(&law));
  law.respond = respond, law.user = &own, law.history_count = 1;
  CHECK(fmc_own_law_check(&law, 2, 0.05, NULL, 0, 0, tell, NULL));
  CHECK(fmc_pair_options_init(&pair));
  pair.interface_kind = FMC_INTERFACE_LAW;
  CHECK(fmc_context_set_law_pair(contact, FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 1, &pair, &law));

  CHECK(fmc_context_begin_step(contact, &coords));
  for (int step = 1; step <= 3; step++) {
    const double opening = step < 3 ? 0.03 * step : 0.02;
    fmc_result result;
    fmc_resultant second;
    double largest = 0, history[16];
    size_t count;
    for (int node = 4; node < 8; node++) x[node][0] = (node == 5 || node == 6 ? 2 : 1) + opening;
    CHECK(fmc_context_evaluate(contact, &coords, NULL, 0, &result));
    CHECK(fmc_context_body_resultant(contact, 1, &second));
    CHECK(fmc_context_commit_step(contact, &coords));
    CHECK(fmc_context_law_history(contact, history, 16, &count));
    for (size_t p = 0; p < count; p++) largest = history[p] > largest ? history[p] : largest;
    printf("opening %.2f  force %.6f  energy %.6f  largest opening %.2f\n", opening, -second.force[0], result.energy, largest);
  }
  return fmc_context_free(&contact);
}
