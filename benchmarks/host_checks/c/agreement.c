/* Ways that must lead to the same bits: stateless and context, 32- and 64-bit ids, counting from 0 and from 1, every
 * array layout, adding and overwriting, one thread and three, cells and facets, two contexts at once; and the two
 * bodies exchanged.
 *
 *   cc agreement.c $(pkg-config --cflags --libs fmc_contact) -lm -pthread */
#include <fmc_contact.h>
#include <math.h>
#include <pthread.h>
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
#define SAME(a, b) (memcmp(a, b, sizeof(a)) == 0)

/* Two turned squares of two triangles each, apart from a third body that touches nothing. Node 4 belongs to nothing. */
#define NODES 12
static const double coords[NODES][2] = {{0, 0},    {1, 0.1},   {0.9, 1.1}, {-0.1, 1},  {NAN, 7}, {0.9, 0.2},
                                        {2, -0.1}, {2.1, 0.9}, {0.95, 1.05}, {5, 5},    {6, 5},   {5, 6}};
static const int32_t conn[15] = {0, 1, 2, 0, 2, 3, 5, 6, 7, 5, 7, 8, 9, 10, 11};
#define CELLS 5
static const fmc_cell_block cells = {FMC_TRI3, 4, conn, CELLS};

static void warned(void *user, int32_t level, const char *text) {
  if (level == FMC_LOG_WARNING && strlen(text) > 0) ++*(int *)user;
}

static void run(int32_t estimator) {
  fmc_options options;
  OK(fmc_options_init(&options));
  options.law = FMC_LAW_VOLUME;
  options.stiffness = 1000;
  options.exponent = 2;
  options.estimator = estimator;
  double reference[NODES][2], forces[NODES][2], volume = 0;
  OK(fmc_contact_force(2, coords[0], NODES, &cells, 1, NULL, &options, NULL, reference[0], &volume));
  EXPECT(volume > 0.01 && volume < 0.05);
  EXPECT(reference[4][0] == 0 && reference[4][1] == 0 && reference[9][0] == 0);

  /* A context, evaluated twice. */
  const fmc_coords x = {coords[0], NODES, 2, 1};
  const fmc_forces f = {forces[0], NODES, 2, 1};
  const fmc_cell_block blocks[2] = {{FMC_TRI3, 4, conn, 2}, {FMC_TRI3, 4, conn + 6, 3}};
  fmc_context *context;
  fmc_result result;
  size_t nodes, facets, bodies;
  OK(fmc_context_new_from_cells(2, &x, blocks, 2, NULL, &options, &context));
  OK(fmc_context_counts(context, &nodes, &facets, &bodies));
  EXPECT(nodes == NODES && facets == 11 && bodies == 3);
  for (int time = 0; time < 2; time++) {
    memset(forces, 1, sizeof forces);
    OK(fmc_context_evaluate(context, &x, &f, 0, &result));
    EXPECT(SAME(forces, reference));
    EXPECT(result.volume == volume);
  }

  /* Adding to what is there; and no forces at all. */
  OK(fmc_context_evaluate(context, &x, &f, FMC_EVALUATE_ADD, NULL));
  int doubled = 1;
  for (int node = 0; node < NODES; node++) {
    for (int axis = 0; axis < 2; axis++) doubled = doubled && forces[node][axis] == 2 * reference[node][axis];
  }
  EXPECT(doubled);
  OK(fmc_context_evaluate(context, &x, NULL, 0, &result));
  EXPECT(result.volume == volume && result.pair_count == 1 && result.body_count == 3);

  /* Layouts: padded rows, columns, backwards. */
  double padded[NODES][3], columns[2][NODES], backwards[NODES][2];
  double padded_forces[NODES][3], column_forces[2][NODES], backward_forces[NODES][2];
  for (int node = 0; node < NODES; node++) {
    for (int axis = 0; axis < 2; axis++) {
      padded[node][axis] = columns[axis][node] = backwards[NODES - 1 - node][axis] = coords[node][axis];
    }
    padded[node][2] = NAN;
    padded_forces[node][2] = 8;
  }
  const fmc_coords layouts[3] = {
      {padded[0], NODES, 3, 1}, {columns[0], NODES, 1, NODES}, {backwards[NODES - 1], NODES, -2, 1}};
  const fmc_forces outputs[3] = {
      {padded_forces[0], NODES, 3, 1}, {column_forces[0], NODES, 1, NODES}, {backward_forces[NODES - 1], NODES, -2, 1}};
  for (int layout = 0; layout < 3; layout++) {
    OK(fmc_context_evaluate(context, &layouts[layout], &outputs[layout], 0, &result));
    EXPECT(result.volume == volume);
  }
  int same = 1;
  for (int node = 0; node < NODES; node++) {
    for (int axis = 0; axis < 2; axis++) {
      same = same && padded_forces[node][axis] == reference[node][axis] &&
             column_forces[axis][node] == reference[node][axis] &&
             backward_forces[NODES - 1 - node][axis] == reference[node][axis];
    }
    same = same && padded_forces[node][2] == 8;
  }
  EXPECT(same);

  /* Threads. */
  options.threads = 3;
  OK(fmc_context_set_options(context, &options));
  OK(fmc_context_evaluate(context, &x, &f, 0, &result));
  EXPECT(SAME(forces, reference));
  options.threads = 1;

  /* A pair with the law and stiffness of its own in a context of others; left out; and as the context again. */
  fmc_pair_options own, shown;
  OK(fmc_pair_options_init(&own));
  own.law = FMC_LAW_VOLUME;
  own.stiffness = 1000;
  own.exponent = 2;
  options.stiffness = 7;
  OK(fmc_context_set_options(context, &options));
  OK(fmc_context_set_pair_options(context, FMC_PARTNER_BODY, 1, FMC_PARTNER_BODY, 0, &own));
  OK(fmc_context_pair_options(context, FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 1, &shown));
  EXPECT(memcmp(&own, &shown, sizeof own) == 0);
  OK(fmc_context_evaluate(context, &x, &f, 0, &result));
  EXPECT(SAME(forces, reference));
  own.excluded = 1;
  OK(fmc_context_set_pair_options(context, FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 1, &own));
  OK(fmc_context_evaluate(context, &x, NULL, 0, &result));
  EXPECT(result.pair_count == 0 && result.energy == 0);
  options.stiffness = 1000;
  OK(fmc_context_set_options(context, &options));
  OK(fmc_context_set_pair_options(context, FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 1, NULL));
  OK(fmc_context_pair_options(context, FMC_PARTNER_BODY, 1, FMC_PARTNER_BODY, 0, &shown));
  EXPECT(shown.law == FMC_PAIR_LAW_OF_CONTEXT && shown.excluded == 0 && shown.stiffness == 0);
  OK(fmc_context_pair_options(context, FMC_PARTNER_BODY, 1, FMC_PARTNER_BODY, 1, &shown));
  EXPECT(shown.law == FMC_PAIR_LAW_OF_CONTEXT && shown.excluded == 1);
  OK(fmc_context_evaluate(context, &x, &f, 0, &result));
  EXPECT(SAME(forces, reference));

  /* Resultants balance, and the pair names its sides. */
  fmc_resultant a, b;
  fmc_pair_result pair;
  OK(fmc_context_body_resultant(context, 0, &a));
  OK(fmc_context_body_resultant(context, 1, &b));
  OK(fmc_context_pair_result(context, 0, &pair));
  const double size = 1e-12 * (fabs(a.force[0]) + fabs(a.force[1]));
  EXPECT(fabs(a.force[0] + b.force[0]) <= size && fabs(a.force[1] + b.force[1]) <= size);
  EXPECT(fabs(a.moment[2] + b.moment[2]) <= 4 * size && a.force[0] < 0);
  EXPECT(pair.a_kind == FMC_PARTNER_BODY && pair.a == 0 && pair.b == 1 && pair.volume == volume);
  OK(fmc_context_free(&context));

  /* 64-bit ids counted from 1, with body ids that are far apart. */
  int64_t wide[15], ids[CELLS] = {-3, -3, INT64_C(1) << 40, INT64_C(1) << 40, 7};
  for (int i = 0; i < 15; i++) wide[i] = conn[i] + 1;
  options.index_base = 1;
  double other = 0;
  const fmc_cell_block block = {FMC_TRI3, 8, wide, CELLS};
  OK(fmc_contact_force(2, coords[0], NODES, &block, 1, NULL, &options, NULL, forces[0], &other));
  EXPECT(SAME(forces, reference) && other == volume);
  OK(fmc_context_new_from_cells(2, &x, &block, 1, ids, &options, &context));
  OK(fmc_context_evaluate(context, &x, &f, 0, &result));
  OK(fmc_context_body_resultant(context, 0, &a));
  OK(fmc_context_body_resultant(context, 2, &b));
  EXPECT(a.id == -3 && b.id == INT64_C(1) << 40 && a.node_count == 4 && b.force[0] > 0);
  OK(fmc_context_free(&context));
  options.index_base = 0;

  /* The boundary given directly. */
  const int32_t edges[22] = {0, 1, 1, 2, 2, 3, 3, 0, 5, 6, 6, 7, 7, 8, 8, 5, 9, 10, 10, 11, 11, 9};
  const fmc_facet_block boundary = {FMC_FACET_LINE2, 4, edges, 11};
  OK(fmc_context_new_from_facets(2, &x, &boundary, 1, NULL, &options, &context));
  if (estimator == FMC_ESTIMATOR_FIBERS) {
    OK(fmc_context_evaluate(context, &x, &f, 0, &result));
    EXPECT(fabs(result.volume - volume) <= 1e-3 * volume);
  }
  OK(fmc_context_free(&context));

  /* The bodies exchanged: the forces are exchanged. */
  const int32_t swapped[15] = {5, 6, 7, 5, 7, 8, 0, 1, 2, 0, 2, 3, 9, 10, 11};
  const fmc_cell_block exchanged = {FMC_TRI3, 4, swapped, CELLS};
  OK(fmc_contact_force(2, coords[0], NODES, &exchanged, 1, NULL, &options, NULL, forces[0], &other));
  EXPECT(SAME(forces, reference) && other == volume);
}

/* One of two threads, each with a context of its own; gives back whether every evaluation had the same bits. */
static void *evaluate_often(void *reference) {
  const fmc_coords x = {coords[0], NODES, 2, 1};
  const fmc_cell_block block = {FMC_TRI3, 4, conn, CELLS};
  double forces[NODES][2];
  const fmc_forces f = {forces[0], NODES, 2, 1};
  fmc_options options;
  fmc_context *context = NULL;
  int same = fmc_options_init(&options) == FMC_OK;
  options.law = FMC_LAW_VOLUME;
  options.stiffness = 1000;
  same = same && fmc_context_new_from_cells(2, &x, &block, 1, NULL, &options, &context) == FMC_OK;
  for (int time = 0; time < 50 && same; time++) {
    same = fmc_context_evaluate(context, &x, &f, 0, NULL) == FMC_OK && memcmp(forces, reference, sizeof forces) == 0;
  }
  fmc_context_free(&context);
  return same ? reference : NULL;
}

static void two_contexts_at_once(void) {
  double reference[NODES][2];
  fmc_options options;
  OK(fmc_options_init(&options));
  options.law = FMC_LAW_VOLUME;
  options.stiffness = 1000;
  OK(fmc_contact_force(2, coords[0], NODES, &cells, 1, NULL, &options, NULL, reference[0], NULL));
  pthread_t threads[2];
  for (int i = 0; i < 2; i++) EXPECT(pthread_create(&threads[i], NULL, evaluate_often, reference) == 0);
  for (int i = 0; i < 2; i++) {
    void *same = NULL;
    EXPECT(pthread_join(threads[i], &same) == 0 && same != NULL);
  }
}

/* A small square inside a big one: a warning comes through the getter and through the callback. */
static void warnings(void) {
  const double nested[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  const int32_t squares[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const fmc_cell_block block = {FMC_QUAD4, 4, squares, 2};
  const fmc_coords x = {nested[0], 8, 0, 0};
  fmc_options options;
  OK(fmc_options_init(&options));
  options.law = FMC_LAW_VOLUME;
  options.stiffness = 1;
  options.estimator = FMC_ESTIMATOR_EXACT;
  fmc_context *context;
  fmc_result result;
  int count = 0;
  int32_t code = 0;
  const char *text = "";
  OK(fmc_context_new_from_cells(2, &x, &block, 1, NULL, &options, &context));
  OK(fmc_context_set_log(context, warned, &count));
  OK(fmc_context_evaluate(context, &x, NULL, 0, &result));
  EXPECT(result.warning_count == 1 && count == 1);
  OK(fmc_context_warning(context, 0, &code, &text));
  EXPECT(code == FMC_WARNING_SWALLOWED_BODY && strstr(text, "body 1 lies inside body 0") != NULL);
  OK(fmc_context_set_log(context, NULL, NULL));
  OK(fmc_context_evaluate(context, &x, NULL, 0, &result));
  EXPECT(result.warning_count == 1 && count == 1);
  OK(fmc_context_free(&context));
}

int main(void) {
  run(FMC_ESTIMATOR_EXACT);
  run(FMC_ESTIMATOR_FIBERS);
  two_contexts_at_once();
  warnings();
  printf("%d failures\n", failures);
  return failures > 0;
}
