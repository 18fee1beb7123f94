/* Every kind of bad input has a status of its own and a text that names the culprit; outputs stay untouched, and a
 * context stays as it was. Prints one line for each kind, and ends with 1 if any differs.
 *
 *   cc bad_input.c $(pkg-config --cflags --libs fmc_contact) */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

/* The call must end with `wanted`, and leave a text with `fragment` in it. */
static void expect_text(const char *call, fmc_status found, fmc_status wanted, const char *text, const char *fragment) {
  const int good = found == wanted && strstr(text, fragment) != NULL;
  if (!good) failures++;
  printf("%s %-36s %s\n", good ? "ok  " : "FAIL", fmc_status_name(found), text);
  if (!good) printf("     wanted %s with '%s' from %s\n", fmc_status_name(wanted), fragment, call);
}
#define EXPECT(wanted, fragment, call)                                         \
  do {                                                                         \
    const fmc_status found_ = (call);                                          \
    expect_text(#call, found_, wanted, fmc_last_error(), fragment);            \
  } while (0)
#define EXPECT_TRUE(condition)                                                 \
  do {                                                                         \
    if (!(condition)) failures++, printf("FAIL %s\n", #condition);             \
  } while (0)
#define EXPECT_OK(call) EXPECT_TRUE((call) == FMC_OK)

/* Two unit squares that overlap by 0.1 x 0.8, as in two_squares.c. */
#define NODES 8
static const double coords[2 * NODES] = {0, 0, 1, 0, 1, 1, 0, 1, 0.9, -0.2, 1.9, -0.2, 1.9, 0.8, 0.9, 0.8};
static const int32_t conn[8] = {0, 1, 2, 3, 4, 5, 6, 7};

/* A unit tetrahedron as a surface: its nodes, and its facets seen from outside. */
static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int32_t shell[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

static fmc_options defaults(void) {
  fmc_options options;
  EXPECT_OK(fmc_options_init(&options));
  options.law = FMC_LAW_VOLUME;
  options.stiffness = 1000.0;
  options.estimator = FMC_ESTIMATOR_EXACT;
  return options;
}

/* Outputs that must stay as they are. */
static double forces[2 * NODES], volume;
static void fill(void) {
  for (int i = 0; i < 2 * NODES; i++) forces[i] = -7.5 - i;
  volume = 42;
}
static void expect_untouched(void) {
  for (int i = 0; i < 2 * NODES; i++) EXPECT_TRUE(forces[i] == -7.5 - i);
  EXPECT_TRUE(volume == 42);
}

/* The stateless call with one thing changed. */
static void stateless(void) {
  const fmc_options o = defaults();
  fmc_options p = o;
  double bad[2 * NODES];
  int32_t ids[8];
  fill();
  fmc_cell_block block;
#define FORCE(dim, x, n, type, c, m, options)                                  \
  (block.cell_type = type, block.index_size = 4, block.conn = c, block.cell_count = m, \
   fmc_contact_force(dim, x, n, &block, 1, NULL, options, NULL, forces, &volume))

  EXPECT(FMC_ERROR_DIMENSION, "dimension is 4", FORCE(4, coords, 8, FMC_QUAD4, conn, 2, &o));
  EXPECT(FMC_ERROR_DIMENSION, "block 0 has cells of dimension 3", FORCE(2, coords, 8, FMC_TET4, conn, 2, &o));
  EXPECT(FMC_ERROR_UNKNOWN_CELL_TYPE, "unknown cell type 77", FORCE(2, coords, 8, 77, conn, 2, &o));
  EXPECT(FMC_ERROR_NULL_POINTER, "'coords'", FORCE(2, NULL, 8, FMC_QUAD4, conn, 2, &o));
  EXPECT(FMC_ERROR_NULL_POINTER, "'conn'", FORCE(2, coords, 8, FMC_QUAD4, NULL, 2, &o));
  EXPECT(FMC_ERROR_NULL_POINTER, "'options'", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'forces'",
         fmc_contact_force(2, coords, 8, &block, 1, NULL, &o, NULL, NULL, &volume));
  EXPECT(FMC_ERROR_NULL_POINTER, "'blocks'", fmc_contact_force(2, coords, 8, NULL, 1, NULL, &o, NULL, forces, &volume));
  block.index_size = 2;
  EXPECT(FMC_ERROR_INDEX_SIZE, "cell block 0 is 2, not 4 or 8",
         fmc_contact_force(2, coords, 8, &block, 1, NULL, &o, NULL, forces, &volume));
  const fmc_cell_block unlike[2] = {{FMC_QUAD4, 4, conn, 1}, {FMC_QUAD4, 8, conn, 1}};
  EXPECT(FMC_ERROR_INDEX_SIZE, "cell block 1 has index_size 8",
         fmc_contact_force(2, coords, 8, unlike, 2, NULL, &o, NULL, forces, &volume));
  EXPECT(FMC_ERROR_MISALIGNED_POINTER, "'coords' is not aligned to 8 bytes",
         FORCE(2, (const double *)((const char *)coords + 4), 7, FMC_QUAD4, conn, 1, &o));
  EXPECT(FMC_ERROR_LENGTH, "'conn'", FORCE(2, coords, 8, FMC_QUAD4, conn, SIZE_MAX / 2, &o));
  EXPECT(FMC_ERROR_STRIDE, "'coords' spans more than memory", FORCE(2, coords, SIZE_MAX / 2, FMC_QUAD4, conn, 2, &o));
  EXPECT(FMC_ERROR_EMPTY, "no cells", FORCE(2, coords, 8, FMC_QUAD4, NULL, 0, &o));
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "0 names node 0, but there are 0", FORCE(2, NULL, 0, FMC_QUAD4, conn, 2, &o));

  memcpy(ids, conn, sizeof ids);
  ids[6] = 8;
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "1 names node 8, but there are 8 nodes",
         FORCE(2, coords, 8, FMC_QUAD4, ids, 2, &o));
  ids[6] = -3;
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "1 names node -3", FORCE(2, coords, 8, FMC_QUAD4, ids, 2, &o));
  p.index_base = 1;
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "1 names node 0, but there are 8 nodes, counted from 1",
         FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  const int64_t wide[4] = {0, 1, 2, INT64_C(1) << 40};
  const fmc_cell_block wide_block = {FMC_QUAD4, 8, wide, 1};
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "0 names node 1099511627776",
         fmc_contact_force(2, coords, 8, &wide_block, 1, NULL, &o, NULL, forces, &volume));
  memcpy(ids, conn, sizeof ids);
  ids[6] = 4;
  EXPECT(FMC_ERROR_REPEATED_NODE, "1 names node 4 twice", FORCE(2, coords, 8, FMC_QUAD4, ids, 2, &o));

  for (int k = 0; k < 3; k++) {
    memcpy(bad, coords, sizeof bad);
    bad[11] = k == 0 ? NAN : k == 1 ? INFINITY : -INFINITY;
    EXPECT(FMC_ERROR_NON_FINITE_COORDINATE, "coordinate 1 of node 5", FORCE(2, bad, 8, FMC_QUAD4, conn, 2, &o));
  }
  /* A corner of the second square pushed in over its diagonal. */
  memcpy(bad, coords, sizeof bad);
  bad[12] = 1.1, bad[13] = 0;
  EXPECT(FMC_ERROR_INVERTED_CELL, "cell 1", FORCE(2, bad, 8, FMC_QUAD4, conn, 2, &o));
  /* All nodes of the second square on one line. */
  memcpy(bad, coords, sizeof bad);
  for (int node = 4; node < 8; node++) bad[2 * node] = node, bad[2 * node + 1] = 0;
  EXPECT(FMC_ERROR_ZERO_MEASURE, "1 has zero measure", FORCE(2, bad, 8, FMC_QUAD4, conn, 2, &o));
  /* Three triangles on the edge from node 0 to node 1. */
  const double fan[10] = {0, 0, 1, 0, 0, 1, 0, -1, 1, 1};
  const int32_t triangles[9] = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  EXPECT(FMC_ERROR_NON_MANIFOLD, "2 is the third to meet at nodes", FORCE(2, fan, 5, FMC_TRI3, triangles, 3, &o));

  const double not_positive[] = {0, -1, NAN, INFINITY};
  for (int k = 0; k < 4; k++) {
    p = o, p.stiffness = not_positive[k];
    EXPECT(FMC_ERROR_NOT_POSITIVE, "'stiffness'", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
    p = o, p.exponent = not_positive[k];
    EXPECT(FMC_ERROR_NOT_POSITIVE, "'exponent'", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  }
  p = o, p.exponent = 0.5;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'exponent' is 0.5", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p = o, p.threads = 0;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'threads' is 0", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p = o, p.estimator = FMC_ESTIMATOR_FIBERS, p.spacing = -1;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'spacing' is -1", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p.spacing = 1e-300;
  EXPECT(FMC_ERROR_TOO_MANY_FIBERS, "spacing is too small", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p = o, p.estimator = 9;
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'estimator' has no value 9", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p = o, p.axisymmetric = 1;
  memcpy(bad, coords, sizeof bad);
  for (int node = 0; node < 8; node++) bad[2 * node] -= 10;
  EXPECT(FMC_ERROR_NEGATIVE_RADIUS, "node 0 lies beyond the axis", FORCE(2, bad, 8, FMC_QUAD4, conn, 2, &p));
  p.axisymmetric = 2;
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'axisymmetric' has no value 2", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p = o, p.reserved[0] = 1;
  EXPECT(FMC_ERROR_RESERVED_FIELD, "later version", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  p = o, p.stiffness = 1e308, p.exponent = 1.5;
  bad[0] = 0;
  for (int i = 0; i < 16; i++) bad[i] = 1e3 * coords[i];
  EXPECT(FMC_ERROR_OVERFLOW, "the energy is inf", FORCE(2, bad, 8, FMC_QUAD4, conn, 2, &p));
  memset(&p, 0, sizeof p);
  EXPECT(FMC_ERROR_STRUCT_SIZE, "struct_size 0", FORCE(2, coords, 8, FMC_QUAD4, conn, 2, &p));
  expect_untouched();

  /* What may be left out. */
  block.index_size = 4, block.conn = conn, block.cell_count = 2, block.cell_type = FMC_QUAD4;
  EXPECT_OK(fmc_contact_force(2, coords, 8, &block, 1, NULL, &o, NULL, forces, NULL));
  EXPECT_TRUE(volume == 42);
}

static void options_by_key(void) {
  fmc_options options = defaults();
  const fmc_options before = options;
  EXPECT(FMC_ERROR_NULL_POINTER, "'options'", fmc_options_init(NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'options'", fmc_options_set(NULL, "seed", "1"));
  EXPECT(FMC_ERROR_NULL_POINTER, "'key'", fmc_options_set(&options, NULL, "1"));
  EXPECT(FMC_ERROR_NULL_POINTER, "'value'", fmc_options_set(&options, "seed", NULL));
  EXPECT(FMC_ERROR_UNKNOWN_OPTION, "no option 'stifness'", fmc_options_set(&options, "stifness", "1"));
  EXPECT(FMC_ERROR_BAD_VALUE, "fibers or exact", fmc_options_set(&options, "estimator", "exakt"));
  EXPECT(FMC_ERROR_BAD_VALUE, "'1,5'", fmc_options_set(&options, "exponent", "1,5"));
  EXPECT_TRUE(memcmp(&options, &before, sizeof before) == 0);
  EXPECT_OK(fmc_options_set(&options, "stiffness", " 2.5d3 "));
  EXPECT_TRUE(options.stiffness == 2500);
}

static void surfaces(void) {
  const fmc_options o = defaults();
  const fmc_coords x = {corners, 4, 0, 0};
  fmc_context *context = NULL;
  int32_t facets[15];
  fmc_facet_block block;
#define BLOCK(t, c, n)                                                         \
  (block.facet_type = t, block.index_size = 4, block.conn = c, block.facet_count = n, \
   fmc_context_new_from_facets(3, &x, &block, 1, NULL, &o, &context))
#define FACETS(c, n) BLOCK(FMC_FACET_TRI3, c, n)

  EXPECT(FMC_ERROR_OPEN_SURFACE, "nodes", FACETS(shell, 3));
  EXPECT(FMC_ERROR_EMPTY, "no cells and no facets", FACETS(NULL, 0));
  EXPECT(FMC_ERROR_NULL_POINTER, "'conn'", FACETS(NULL, 4));
  memcpy(facets, shell, sizeof shell);
  for (int f = 0; f < 4; f++) facets[3 * f] = shell[3 * f + 1], facets[3 * f + 1] = shell[3 * f];
  EXPECT(FMC_ERROR_INVERTED_SURFACE, "body 0", FACETS(facets, 4));
  memcpy(facets, shell, sizeof shell);
  facets[0] = shell[1], facets[1] = shell[0];
  EXPECT(FMC_ERROR_INCONSISTENT_ORIENTATION, "oriented against its neighbour", FACETS(facets, 4));
  memcpy(facets, shell, sizeof shell);
  memcpy(facets + 12, shell, 3 * sizeof *shell);
  EXPECT(FMC_ERROR_NON_MANIFOLD, "4 is the third", FACETS(facets, 5));
  memcpy(facets, shell, sizeof shell);
  facets[2] = facets[1];
  EXPECT(FMC_ERROR_REPEATED_NODE, "0 names node 2 twice", FACETS(facets, 4));
  facets[2] = 4;
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "0 names node 4, but there are 4", FACETS(facets, 4));
  EXPECT(FMC_ERROR_NULL_POINTER, "'coords'", fmc_context_new_from_facets(3, NULL, &block, 1, NULL, &o, &context));
  EXPECT(FMC_ERROR_NULL_POINTER, "'context'", fmc_context_new_from_facets(3, &x, &block, 1, NULL, &o, NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'blocks'", fmc_context_new_from_cells(3, &x, NULL, 1, NULL, &o, &context));
  const int64_t wide[12] = {0};
  const int32_t nine[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const fmc_facet_block wide_block = {FMC_FACET_TRI3, 8, wide, 4};
  EXPECT(FMC_ERROR_REPEATED_NODE, "0 names node 0 twice",
         fmc_context_new_from_facets(3, &x, &wide_block, 1, NULL, &o, &context));
  EXPECT(FMC_ERROR_UNKNOWN_CELL_TYPE, "facet block 0 has the unknown facet type 7", BLOCK(7, shell, 4));
  EXPECT(FMC_ERROR_DIMENSION, "block 0 has cells of dimension 2, or facets of such", BLOCK(FMC_FACET_LINE3, shell, 4));
  EXPECT(FMC_ERROR_NULL_POINTER, "'conn'", BLOCK(FMC_FACET_TRI3, NULL, 4));
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "but there are 4", BLOCK(FMC_FACET_QUAD9, nine, 1));
  EXPECT(FMC_ERROR_OPEN_SURFACE, "nodes", BLOCK(FMC_FACET_TRI3, shell, 3));
  EXPECT(FMC_ERROR_EMPTY, "no cells and no facets", BLOCK(FMC_FACET_TRI6, NULL, 0));
  EXPECT(FMC_ERROR_NULL_POINTER, "'blocks'", fmc_context_new_from_facets(3, &x, NULL, 1, NULL, &o, &context));
  EXPECT_TRUE(context == NULL);
  EXPECT_OK(BLOCK(FMC_FACET_TRI3, shell, 4));
  EXPECT_OK(fmc_context_free(&context));
  EXPECT_TRUE(context == NULL);
  EXPECT_OK(FACETS(shell, 4));
  EXPECT_TRUE(context != NULL);
  EXPECT_OK(fmc_context_free(&context));
  EXPECT_TRUE(context == NULL);
  EXPECT_OK(fmc_context_free(&context));
  EXPECT_OK(fmc_context_free(NULL));
}

/* What a signed-distance callback may do wrong. */
typedef struct {
  int kind;
  size_t count;
  fmc_context *context;
  fmc_status inner;
} mischief;
static int32_t distance(void *user, size_t n, const double *x, double *phi, double *grad) {
  mischief *m = (mischief *)user;
  if (m->kind == 0) return (int32_t)(m->count = n);
  if (m->kind == 1) return -1;
  for (size_t i = 0; i < n; i++) {
    phi[i] = x[2 * i + 1];
    grad[2 * i] = 0, grad[2 * i + 1] = 1;
  }
  if (m->kind == 2) phi[0] = NAN;
  if (m->kind == 3) {
    const fmc_coords view = {coords, NODES, 0, 0};
    m->inner = fmc_context_evaluate(m->context, &view, NULL, 0, NULL);
  }
  return 0;
}

static void contexts(void) {
  fmc_options o = defaults();
  const fmc_coords x = {coords, NODES, 2, 1};
  const fmc_forces f = {forces, NODES, 2, 1};
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 2};
  fmc_context *context = NULL;
  fmc_result good, result;
  fmc_resultant body, before;
  fmc_pair_result pair;
  double reference[2 * NODES], bad[2 * NODES];
  EXPECT_OK(fmc_context_new_from_cells(2, &x, &block, 1, NULL, &o, &context));
  EXPECT(FMC_ERROR_INDEX_OUT_OF_RANGE, "no body 0", fmc_context_body_resultant(context, 0, &body));
  EXPECT_OK(fmc_context_evaluate(context, &x, &f, 0, &good));
  EXPECT_OK(fmc_context_body_resultant(context, 0, &before));
  memcpy(reference, forces, sizeof forces);
  fill();
  memset(&result, 7, sizeof result);

  /* Views and lengths. */
  const fmc_coords too_few = {coords, 7, 2, 1}, no_data = {NULL, NODES, 2, 1}, far = {coords, NODES, PTRDIFF_MAX, 1};
  const fmc_forces small = {forces, 7, 2, 1}, overlapping = {forces, NODES, 1, 1}, nowhere = {NULL, NODES, 2, 1};
  const fmc_coords broken = {bad, NODES, 2, 1};
#define EVALUATE(c, g) fmc_context_evaluate(context, c, g, 0, &result)
  EXPECT(FMC_ERROR_LENGTH, "'coords' has 7 nodes, the mesh has 8", EVALUATE(&too_few, &f));
  EXPECT(FMC_ERROR_NULL_POINTER, "'coords' is NULL", EVALUATE(&no_data, &f));
  EXPECT(FMC_ERROR_NULL_POINTER, "'coords' is NULL", EVALUATE(NULL, &f));
  EXPECT(FMC_ERROR_STRIDE, "'coords' spans more than memory", EVALUATE(&far, &f));
  EXPECT(FMC_ERROR_BUFFER_TOO_SMALL, "room for 7 nodes, the mesh has 8", EVALUATE(&x, &small));
  EXPECT(FMC_ERROR_STRIDE, "'forces' overlap", EVALUATE(&x, &overlapping));
  EXPECT(FMC_ERROR_NULL_POINTER, "'forces' is NULL", EVALUATE(&x, &nowhere));
  EXPECT(FMC_ERROR_UNKNOWN_FLAG, "flag", fmc_context_evaluate(context, &x, &f, 2, &result));
  memcpy(bad, coords, sizeof bad);
  bad[7] = NAN;
  EXPECT(FMC_ERROR_NON_FINITE_COORDINATE, "coordinate 1 of node 3", EVALUATE(&broken, &f));
  memcpy(bad, coords, sizeof bad);
  bad[8] = 3;
  EXPECT(FMC_ERROR_INVERTED_CELL, "cell 1", EVALUATE(&broken, &f));
  EXPECT(FMC_ERROR_NULL_POINTER, "'context' is NULL", fmc_context_evaluate(NULL, &x, &f, 0, &result));

  /* Nodes and points of the contact. */
  double pressure[NODES];
  size_t point_count = 99;
  fmc_contact_point points[1];
  fmc_nodal_contact nodal;
  memset(pressure, 7, sizeof pressure);
  memset(&nodal, 0, sizeof nodal);
#define AT_NODES(c) fmc_context_nodal_contact(context, c, &nodal)
  EXPECT(FMC_ERROR_STRUCT_SIZE, "call fmc_nodal_contact_init first", AT_NODES(&x));
  EXPECT(FMC_ERROR_NULL_POINTER, "'nodal' is NULL", fmc_nodal_contact_init(NULL));
  EXPECT_OK(fmc_nodal_contact_init(&nodal));
  EXPECT_OK(AT_NODES(&x));
  nodal.pressure = pressure;
  EXPECT(FMC_ERROR_LENGTH, "'coords' has 7 nodes", AT_NODES(&too_few));
  EXPECT(FMC_ERROR_NULL_POINTER, "'coords' is NULL", AT_NODES(NULL));
  EXPECT(FMC_ERROR_INVERTED_CELL, "cell 1", AT_NODES(&broken));
  EXPECT(FMC_ERROR_NULL_POINTER, "'nodal' is NULL", fmc_context_nodal_contact(context, &x, NULL));
  nodal.gap = (double *)((char *)pressure + 1);
  EXPECT(FMC_ERROR_MISALIGNED_POINTER, "'gap'", AT_NODES(&x));
  const double untouched = pressure[0];
  EXPECT_TRUE(memcmp(&untouched, &pressure[NODES - 1], sizeof untouched) == 0);
#define POINTS(c, rows, room) fmc_context_contact_points(context, c, rows, room, &point_count)
  EXPECT(FMC_ERROR_NULL_POINTER, "'coords' is NULL", POINTS(NULL, NULL, 0));
  EXPECT(FMC_ERROR_INVERTED_CELL, "cell 1", POINTS(&broken, NULL, 0));
  EXPECT_TRUE(point_count == 99);
  EXPECT_OK(POINTS(&x, NULL, 0));
  EXPECT_TRUE(point_count == 0); /* The law "volume" has none. */
  fmc_options by_lines = o;
  by_lines.law = FMC_LAW_FIBER;
  EXPECT_OK(fmc_context_set_options(context, &by_lines));
  EXPECT_OK(POINTS(&x, NULL, 0));
  const size_t there = point_count;
  EXPECT(FMC_ERROR_BUFFER_TOO_SMALL, "room for 1 contact points", POINTS(&x, points, 1));
  EXPECT(FMC_ERROR_NULL_POINTER, "'points'", POINTS(&x, NULL, there));
  EXPECT_TRUE(there > 1 && point_count == there);
  EXPECT_OK(fmc_context_set_options(context, &o));

  /* Boundary facets. */
  fmc_boundary_facet facets[8];
  EXPECT(FMC_ERROR_BUFFER_TOO_SMALL, "room for 7 boundary facets, and there are 8",
         fmc_context_boundary_facets(context, facets, 7, NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'facets'", fmc_context_boundary_facets(context, NULL, 8, NULL));
  EXPECT_OK(fmc_context_boundary_facets(context, facets, 8, NULL));
  EXPECT_TRUE(facets[4].cell == 1 && facets[4].body == 1 && facets[4].local_face == 0 && facets[4].nodes[2] == -1);

  /* Options. */
  o.stiffness = -1;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'stiffness' is -1", fmc_context_set_options(context, &o));
  EXPECT(FMC_ERROR_NULL_POINTER, "'options'", fmc_context_set_options(context, NULL));

  /* Obstacles: none of these may stay behind. */
  fmc_pose pose;
  fmc_shape shape;
  size_t index = 99;
  const double none[2] = {0, 0};
#define ADD(pose) fmc_context_add_obstacle(context, &shape, pose, &index)
  EXPECT(FMC_ERROR_NULL_POINTER, "'pose'", fmc_pose_init(NULL));
  EXPECT(FMC_ERROR_BAD_POSE, "no direction", fmc_pose_along(2, coords, none, &pose));
  EXPECT(FMC_ERROR_DIMENSION, "dimension is 1", fmc_pose_along(1, coords, coords, &pose));
  EXPECT_OK(fmc_pose_init(&pose));
  EXPECT(FMC_ERROR_NULL_POINTER, "'shape'", fmc_shape_init(NULL, FMC_SHAPE_BALL));
  EXPECT(FMC_ERROR_BAD_VALUE, "11 is not a value of fmc_shape_kind", fmc_shape_init(&shape, 11));
  EXPECT(FMC_ERROR_BAD_VALUE, "-1 is not a value", fmc_shape_init(&shape, -1));
  EXPECT(FMC_ERROR_NULL_POINTER, "'shape'", fmc_context_add_obstacle(context, NULL, &pose, &index));
  memset(&shape, 0, sizeof shape);
  EXPECT(FMC_ERROR_STRUCT_SIZE, "call fmc_shape_init first", ADD(&pose));
  EXPECT_OK(fmc_shape_init(&shape, FMC_SHAPE_BALL));
  shape.radius = -2;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'radius' is -2", ADD(&pose));
  shape.kind = 77;
  EXPECT(FMC_ERROR_BAD_VALUE, "77 is not a value of fmc_shape_kind", ADD(&pose));
  shape.kind = FMC_SHAPE_CYLINDER, shape.radius = 1, shape.half_height = NAN;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "is NaN", ADD(&pose));
  shape.kind = FMC_SHAPE_CONE, shape.half_height = 0;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "is 0", ADD(&pose));
  shape.kind = FMC_SHAPE_CAPSULE, shape.radius = 0, shape.half_height = 1;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'radius' is 0", ADD(&pose));
  shape.kind = FMC_SHAPE_CUBOID, shape.half_extents[0] = 1;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "is 0", ADD(&pose));
  shape.kind = FMC_SHAPE_SIGNED_DISTANCE;
  EXPECT(FMC_ERROR_NULL_POINTER, "'signed_distance'", ADD(&pose));
  const int32_t edges[6] = {0, 1, 1, 2, 2, 0};
  EXPECT_OK(fmc_shape_init(&shape, FMC_SHAPE_POLYTOPE));
  shape.points = (fmc_coords){coords, 3, 0, 0}, shape.facets = edges, shape.facet_count = 2;
  EXPECT(FMC_ERROR_OPEN_SURFACE, "node 0", ADD(NULL));
  shape.index_size = 2;
  EXPECT(FMC_ERROR_BAD_VALUE, "'index_size' is 2", ADD(NULL));
  const int64_t wide[4] = {0, 1, 1, 9};
  shape.index_size = 8, shape.facets = wide;
  EXPECT(FMC_ERROR_NODE_OUT_OF_RANGE, "", ADD(NULL));
  shape.points.data = NULL;
  EXPECT(FMC_ERROR_NULL_POINTER, "'points'", ADD(NULL));
  EXPECT_OK(fmc_shape_init(&shape, FMC_SHAPE_COMPOUND));
  EXPECT(FMC_ERROR_EMPTY_COMPOUND, "", ADD(NULL));
  fmc_part part = {NULL, pose};
  shape.parts = &part, shape.part_count = 1;
  EXPECT(FMC_ERROR_NULL_POINTER, "'shape'", ADD(NULL));
  part.shape = &shape; /* Which is its own part. */
  EXPECT(FMC_ERROR_UNSUPPORTED, "more than 8 deep", ADD(NULL));
  EXPECT_OK(fmc_shape_init(&shape, FMC_SHAPE_HALF_SPACE));
  pose.rotation[0] = 2;
  EXPECT(FMC_ERROR_BAD_POSE, "obstacle 0", ADD(&pose));
  EXPECT_OK(fmc_pose_init(&pose));
  pose.scale = 0;
  shape.kind = FMC_SHAPE_BALL, shape.radius = 1;
  EXPECT(FMC_ERROR_BAD_POSE, "obstacle 0", ADD(&pose));
  EXPECT_OK(fmc_pose_init(&pose));
  EXPECT(FMC_ERROR_OBSTACLE_OUT_OF_RANGE, "no obstacle 0", fmc_context_set_pose(context, 0, &pose));
  EXPECT(FMC_ERROR_OBSTACLE_OUT_OF_RANGE, "no obstacle 0", fmc_context_remove_obstacle(context, 0));
  EXPECT(FMC_ERROR_OBSTACLE_OUT_OF_RANGE, "no obstacle 3", fmc_context_obstacle_shape(context, 3, NULL, NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'context'", fmc_context_remove_obstacle(NULL, 0));
  EXPECT_TRUE(index == 99);

  /* Pairs: what was set stays, here what holds for the pair in any case. */
  fmc_pair_options own, wanted, shown;
  EXPECT(FMC_ERROR_NULL_POINTER, "'options'", fmc_pair_options_init(NULL));
  EXPECT_OK(fmc_pair_options_init(&own));
  own.law = FMC_LAW_VOLUME, own.stiffness = 1000;
#define PAIR(ak, a, bk, b) fmc_context_set_pair_options(context, ak, a, bk, b, &wanted)
#define BODIES PAIR(FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 1)
  wanted = own;
  EXPECT_OK(BODIES);
  EXPECT(FMC_ERROR_BODY_OUT_OF_RANGE, "no body 2, only 2", PAIR(FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 2));
  EXPECT(FMC_ERROR_OBSTACLE_OUT_OF_RANGE, "no obstacle 0", PAIR(FMC_PARTNER_OBSTACLE, 0, FMC_PARTNER_BODY, 0));
  EXPECT(FMC_ERROR_BAD_VALUE, "2 is no value of fmc_partner", PAIR(2, 0, FMC_PARTNER_BODY, 0));
  EXPECT(FMC_ERROR_NULL_POINTER, "'context'",
         fmc_context_set_pair_options(NULL, FMC_PARTNER_BODY, 0, FMC_PARTNER_BODY, 1, &wanted));
  for (int k = 0; k < 4; k++) {
    wanted = own, wanted.stiffness = k == 0 ? NAN : k == 1 ? INFINITY : k == 2 ? 0 : -1;
    EXPECT(FMC_ERROR_NOT_POSITIVE, "pair of body 0 and body 1: 'stiffness' is ", BODIES);
  }
  wanted = own, wanted.exponent = 0.5;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'exponent' is 0.5", BODIES);
  wanted = own, wanted.struct_size = 0;
  EXPECT(FMC_ERROR_STRUCT_SIZE, "fmc_pair_options has struct_size 0", BODIES);
  wanted = own, wanted.reserved[2] = 1;
  EXPECT(FMC_ERROR_RESERVED_FIELD, "later version", BODIES);
  wanted = own, wanted.softening = 3;
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'softening' has no value 3", BODIES);
  wanted = own, wanted.softening = FMC_SOFTENING_EXPONENTIAL;
  EXPECT(FMC_ERROR_OPTIONS_CONFLICT, "'softening' of a pair belongs to the interface 'cohesive'", BODIES);
  wanted = own, wanted.normal_strength = 1;
  EXPECT(FMC_ERROR_OPTIONS_CONFLICT, "'normal_strength' of a pair belongs to the interface 'cohesive'", BODIES);
  wanted = own, wanted.interface_kind = 6;
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'interface_kind' has no value 6", BODIES);
  wanted = own, wanted.reach = 1;
  EXPECT(FMC_ERROR_OPTIONS_CONFLICT, "'reach' of a pair belongs to the interface 'tied', 'no_separation', 'cohesive' or 'law'", BODIES);
  wanted = own, wanted.interface_kind = FMC_INTERFACE_ROUGH, wanted.friction_coefficient = 0.3;
  EXPECT(FMC_ERROR_UNSUPPORTED, "friction of a rough pair", BODIES);
  wanted = own, wanted.interface_kind = FMC_INTERFACE_NO_SEPARATION, wanted.friction_coefficient = 0.3;
  EXPECT(FMC_ERROR_UNSUPPORTED, "they slide freely", BODIES);
  wanted = own, wanted.interface_kind = FMC_INTERFACE_TIED;
  EXPECT(FMC_ERROR_UNSUPPORTED, "tied by the law volume", BODIES);
  wanted = own, wanted.law = FMC_LAW_DEPTH, wanted.interface_kind = FMC_INTERFACE_TIED, wanted.reach = -1;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'reach' is -1", BODIES);
  wanted.reach = 1e-9;
  EXPECT(FMC_ERROR_UNTIED, "bodies 0 and 1 are tied", BODIES);
  wanted = own, wanted.law = 9;
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'law' has no value 9", BODIES);
  wanted = own, wanted.excluded = 2;
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'excluded' has no value 2", BODIES);
  wanted = own, wanted.law = FMC_PAIR_LAW_OF_CONTEXT;
  EXPECT(FMC_ERROR_OPTIONS_CONFLICT, "'stiffness' of a pair belongs to a law", BODIES);
  wanted = own, wanted.gap_offset = 0.1;
  EXPECT(FMC_ERROR_UNSUPPORTED, "a positive gap offset between bodies", BODIES);
  wanted = own, wanted.gap_offset = -0.1;
  EXPECT(FMC_ERROR_UNSUPPORTED, "a gap offset between bodies by another law", BODIES);
  wanted = own, wanted.gap_offset = NAN;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'gap_offset' is NaN", BODIES);
  wanted = own, wanted.friction_coefficient = 0.3;
  EXPECT(FMC_ERROR_UNSUPPORTED, "friction with the law volume", BODIES);
  wanted = own, wanted.friction_coefficient = -0.3;
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'friction_coefficient' is -0.3", BODIES);
#define SHOWN(kind, index, output) fmc_context_pair_options(context, kind, index, FMC_PARTNER_BODY, 1, output)
  EXPECT(FMC_ERROR_NULL_POINTER, "'options'", SHOWN(FMC_PARTNER_BODY, 0, NULL));
  EXPECT(FMC_ERROR_BODY_OUT_OF_RANGE, "no body 7", SHOWN(FMC_PARTNER_BODY, 7, &shown));
  EXPECT(FMC_ERROR_BAD_VALUE, "-1 is no value", SHOWN(-1, 0, &shown));
  EXPECT_OK(SHOWN(FMC_PARTNER_BODY, 0, &shown));
  EXPECT_TRUE(memcmp(&shown, &own, sizeof own) == 0);

  /* Getters. */
  EXPECT(FMC_ERROR_INDEX_OUT_OF_RANGE, "no body 2 in the last evaluation, only 2", fmc_context_body_resultant(context, 2, &body));
  EXPECT(FMC_ERROR_INDEX_OUT_OF_RANGE, "no obstacle 0", fmc_context_obstacle_resultant(context, 0, &body));
  EXPECT(FMC_ERROR_INDEX_OUT_OF_RANGE, "no pair 1", fmc_context_pair_result(context, 1, &pair));
  EXPECT(FMC_ERROR_INDEX_OUT_OF_RANGE, "no warning 0", fmc_context_warning(context, 0, NULL, NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'body'", fmc_context_body_resultant(context, 0, NULL));
  EXPECT(FMC_ERROR_NULL_POINTER, "'context'", fmc_context_counts(NULL, NULL, NULL, NULL));

  /* After all that: outputs untouched, the context as it was, to the bit. */
  expect_untouched();
  EXPECT_TRUE(result.volume != good.volume);
  EXPECT_OK(fmc_context_body_resultant(context, 0, &body));
  EXPECT_TRUE(memcmp(&body, &before, sizeof body) == 0);
  EXPECT_OK(fmc_context_evaluate(context, &x, &f, 0, &result));
  EXPECT_TRUE(memcmp(&result, &good, sizeof good) == 0);
  EXPECT_TRUE(memcmp(forces, reference, sizeof forces) == 0);

  /* Callbacks that fail, or call back in. */
  mischief m = {0, 0, context, FMC_OK};
  char last_point[32];
  fill();
  EXPECT_OK(fmc_shape_init(&shape, FMC_SHAPE_SIGNED_DISTANCE));
  shape.signed_distance = distance, shape.user = &m;
  EXPECT_OK(ADD(NULL));
  EXPECT(FMC_ERROR_UNSUPPORTED, "not supported", EVALUATE(&x, &f));
  o = defaults();
  o.estimator = FMC_ESTIMATOR_FIBERS;
  EXPECT_OK(fmc_context_set_options(context, &o));
  const fmc_status failed = EVALUATE(&x, &f);
  snprintf(last_point, sizeof last_point, "at point %zu of", m.count - 1);
  EXPECT(FMC_ERROR_SIGNED_DISTANCE, last_point, failed);
  m.kind = 1;
  EXPECT(FMC_ERROR_SIGNED_DISTANCE, "obstacle 0 failed or is not finite at point 0", EVALUATE(&x, &f));
  m.kind = 2;
  EXPECT(FMC_ERROR_SIGNED_DISTANCE, "at point 0", EVALUATE(&x, &f));
  expect_untouched();
  m.kind = 3;
  EXPECT_OK(EVALUATE(&x, &f));
  EXPECT_TRUE(m.inner == FMC_ERROR_BUSY);

  /* An obstacle that is there, and one that was removed. */
  int32_t kind = -7;
  EXPECT_OK(fmc_context_obstacle_shape(context, 0, &kind, &pose));
  EXPECT_TRUE(kind == FMC_SHAPE_SIGNED_DISTANCE && pose.scale == 1);
  EXPECT_OK(fmc_context_remove_obstacle(context, 0));
  m.kind = 1;
  EXPECT_OK(EVALUATE(&x, &f));
  EXPECT_TRUE(result.obstacle_count == 1);
  kind = -7;
  EXPECT(FMC_ERROR_OBSTACLE_REMOVED, "obstacle 0 was removed", fmc_context_obstacle_shape(context, 0, &kind, &pose));
  EXPECT_TRUE(kind == -7);
  EXPECT(FMC_ERROR_OBSTACLE_REMOVED, "obstacle 0 was removed", fmc_context_remove_obstacle(context, 0));
  EXPECT(FMC_ERROR_OBSTACLE_REMOVED, "obstacle 0 was removed", fmc_context_set_pose(context, 0, &pose));
  wanted = own;
  EXPECT(FMC_ERROR_OBSTACLE_REMOVED, "obstacle 0 was removed",
                    PAIR(FMC_PARTNER_BODY, 0, FMC_PARTNER_OBSTACLE, 0));
  pose.position[0] = 3;
  EXPECT_OK(fmc_shape_init(&shape, FMC_SHAPE_BALL));
  shape.radius = 0.5;
  EXPECT_OK(ADD(&pose));
  EXPECT_TRUE(index == 1);
  memset(&pose, 0, sizeof pose);
  EXPECT_OK(fmc_context_obstacle_shape(context, 1, &kind, &pose));
  EXPECT_TRUE(kind == FMC_SHAPE_BALL && pose.position[0] == 3 && pose.rotation[8] == 1 && pose.scale == 1);
  EXPECT_OK(fmc_context_free(&context));
}

static void stiffness(void) {
  double k = 42;
  EXPECT(FMC_ERROR_NULL_POINTER, "'stiffness'", fmc_suggest_stiffness(FMC_LAW_DEPTH, 2, 1, 1e6, 0.1, NULL));
  EXPECT(FMC_ERROR_BAD_VALUE, "option 'law' has no value 9", fmc_suggest_stiffness(9, 2, 1, 1e6, 0.1, &k));
  EXPECT(FMC_ERROR_DIMENSION, "dimension is 0", fmc_suggest_stiffness(FMC_LAW_VOLUME, 0, 1, 1e6, 0.1, &k));
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'modulus' is -1", fmc_suggest_stiffness(FMC_LAW_VOLUME, 2, 1, -1, 0.1, &k));
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'cell_size' is 0", fmc_suggest_stiffness(FMC_LAW_DEPTH, 2, 1, 1e6, 0, &k));
  EXPECT(FMC_ERROR_NOT_POSITIVE, "'exponent' is 0.5", fmc_suggest_stiffness(FMC_LAW_VOLUME, 2, 0.5, 1e6, 1, &k));
  EXPECT_TRUE(k == 42);
  EXPECT_OK(fmc_suggest_stiffness(FMC_LAW_VOLUME, 2, 1, 1.2e6, 0.1, &k));
  EXPECT_TRUE(k == 1.2e6);
}

int main(void) {
  EXPECT_TRUE(strcmp(fmc_last_error(), "") == 0);
  EXPECT_TRUE(strcmp(fmc_status_name(4711), "FMC_UNKNOWN_STATUS") == 0);
  EXPECT_TRUE(fmc_has_feature(NULL) == 0 && fmc_has_feature("teleport") == 0 && fmc_has_feature("exact") == 0);
  EXPECT_TRUE(fmc_abi_version() == FMC_ABI_VERSION && strlen(fmc_version()) >= 5);
  stateless();
  options_by_key();
  surfaces();
  contexts();
  stiffness();
  printf("%d failures\n", failures);
  return failures > 0;
}
