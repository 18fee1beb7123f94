/* The tangent in compressed rows against its entries: of numbers and of blocks, of either width, with and without the
 * obstacle, counted from 0 and from 1; a pattern that is kept; forces and tangent in one call; the stable step; and what
 * is refused.
 *
 *   cc tangent_rows.c $(pkg-config --cflags --libs fmc_contact) -lm */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;
#define EXPECT(condition)                                                      \
  do {                                                                         \
    if (!(condition)) failures++, printf("FAIL line %d: %s\n", __LINE__, #condition); \
  } while (0)
#define OK(call)                                                               \
  do {                                                                         \
    const fmc_status status_ = (call);                                         \
    if (status_ != FMC_OK) failures++, printf("FAIL line %d: %s: %s\n", __LINE__, #call, fmc_last_error()); \
  } while (0)
#define REFUSED(wanted, fragment, call)                                        \
  do {                                                                         \
    EXPECT((call) == wanted);                                                  \
    EXPECT(strstr(fmc_last_error(), fragment) != NULL);                        \
  } while (0)

/* Two unit cubes, the upper one 0.1 deep in the lower, on a half-space that takes 0.05 of the lower. In the plane, two
 * squares. Node 16, and 8 in the plane, belongs to nothing. */
enum { MOST = 18 * 3, ROOM = 100000 };
static double coords[17 * 3];
static size_t nodes, dofs, rooms;
static int dim, base, is_wide;
static fmc_coords x;
static fmc_context *context;

static void begin(int of_dim, int32_t law, double aside) {
  static const double corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  int32_t narrow[16];
  int64_t wide[16];
  for (int k = 0; k < 16; k++) narrow[k] = k + base, wide[k] = k + base;
  dim = of_dim;
  const size_t each = dim == 2 ? 4 : 8;
  nodes = 2 * each + 1, dofs = nodes * dim, rooms = dofs + dim;
  memset(coords, 0, sizeof coords);
  for (size_t node = 0; node < 2 * each; node++)
    for (int axis = 0; axis < dim; axis++)
      coords[node * dim + axis] = corners[node % each][axis] + (node < each ? 0 : axis == dim - 1 ? 0.9 : aside);
  fmc_options options;
  fmc_pose pose;
  fmc_shape half_space;
  const double point[3] = {0, dim == 2 ? 0.05 : 0, dim == 2 ? 0 : 0.05}, up[3] = {0, dim == 2, dim == 3};
  OK(fmc_options_init(&options));
  options.law = law;
  options.exponent = law == FMC_LAW_VOLUME ? 2 : 1;
  options.stiffness = 1000;
  options.index_base = base;
  if (law == FMC_LAW_FIBER) options.estimator = FMC_ESTIMATOR_EXACT;
  const fmc_cell_block block = {dim == 2 ? FMC_QUAD4 : FMC_HEX8, is_wide ? 8 : 4, is_wide ? (const void *)wide : narrow, 2};
  x.data = coords, x.node_count = nodes, x.node_stride = dim, x.axis_stride = 1;
  OK(fmc_context_new_from_cells(dim, &x, &block, 1, NULL, &options, &context));
  OK(fmc_pose_along(dim, point, up, &pose));
  OK(fmc_shape_init(&half_space, FMC_SHAPE_HALF_SPACE));
  OK(fmc_context_add_obstacle(context, &half_space, &pose, NULL));
}

/* The entries, as a full matrix with the obstacle's rows; gives back their number. */
static double full[MOST][MOST];
static size_t gather(void) {
  static int32_t rows[ROOM], cols[ROOM];
  static int64_t wide_rows[ROOM], wide_cols[ROOM];
  static double values[ROOM];
  size_t count = 0, again = 0;
  memset(full, 0, sizeof full);
  OK(fmc_context_tangent_entries(context, NULL, NULL, NULL, 0, &count));
  if (is_wide) {
    OK(fmc_context_tangent_entries(context, wide_rows, wide_cols, values, ROOM, &again));
  } else {
    OK(fmc_context_tangent_entries(context, rows, cols, values, ROOM, &again));
    for (size_t entry = 0; entry < count; entry++) wide_rows[entry] = rows[entry], wide_cols[entry] = cols[entry];
  }
  EXPECT(count == again);
  for (size_t entry = 0; entry < count; entry++) full[wide_rows[entry] - base][wide_cols[entry] - base] = values[entry];
  return count;
}

/* Number of rows and entries. */
static size_t sizes(uint32_t flags, size_t *row_count) {
  size_t offsets = 0, count = 0;
  OK(fmc_context_tangent_csr(context, flags, NULL, 0, &offsets, NULL, NULL, 0, &count));
  if (row_count) *row_count = offsets - 1;
  return count;
}

/* Compressed rows against `full`; gives back the number of entries. */
static size_t compare(uint32_t flags) {
  static int32_t narrow_offsets[MOST + 1], narrow_cols[ROOM];
  static int64_t offsets[MOST + 1], cols[ROOM];
  static double values[ROOM];
  size_t row_count;
  const size_t count = sizes(flags, &row_count), room = row_count + 1;
  const size_t per = flags & FMC_CSR_BLOCKS ? (size_t)dim : 1, size = flags & FMC_CSR_OBSTACLES ? rooms : dofs;
  EXPECT(row_count * per == size && count > 0 && count * per * per < ROOM);
  if (is_wide) {
    OK(fmc_context_tangent_csr(context, flags, offsets, room, NULL, cols, values, count, NULL));
  } else {
    OK(fmc_context_tangent_csr(context, flags, narrow_offsets, room, NULL, narrow_cols, values, count, NULL));
    for (size_t row = 0; row <= row_count; row++) offsets[row] = narrow_offsets[row];
    for (size_t entry = 0; entry < count; entry++) cols[entry] = narrow_cols[entry];
  }
  static double found[MOST][MOST];
  memset(found, 0, sizeof found);
  EXPECT(offsets[0] == base && offsets[row_count] == (int64_t)count + base);
  for (size_t row = 0; row < row_count; row++) {
    EXPECT(offsets[row] <= offsets[row + 1]);
    for (int64_t entry = offsets[row] - base; entry < offsets[row + 1] - base; entry++) {
      const size_t col = (size_t)(cols[entry] - base);
      EXPECT(col < row_count && (entry == offsets[row] - base || cols[entry] > cols[entry - 1]));
      for (size_t i = 0; i < per; i++)
        for (size_t j = 0; j < per; j++)
          found[row * per + i][col * per + j] = values[((size_t)entry * per + i) * per + j];
    }
  }
  int same = 1;
  for (size_t row = 0; row < size; row++)
    for (size_t col = 0; col < size; col++) same = same && found[row][col] == full[row][col];
  EXPECT(same);
  return count;
}

static void rows(void) {
  size_t parts;
  OK(fmc_context_tangent(context, &x, 0, &parts));
  const size_t entries = gather();
  size_t of_mesh = 0;
  for (uint32_t choice = 0; choice < 4; choice++) {
    const uint32_t flags = (choice & 1 ? FMC_CSR_BLOCKS : 0) | (choice & 2 ? FMC_CSR_OBSTACLES : 0);
    const size_t count = compare(flags);
    const size_t numbers = count * (choice & 1 ? (size_t)(dim * dim) : 1);
    if (choice == 0) of_mesh = numbers;
    EXPECT(numbers == (choice & 2 ? entries : of_mesh) && of_mesh < entries);
  }
  /* With the terms of rank one, rows are what the product says. */
  double along[MOST], product[MOST], of_rows[MOST] = {0}, g[MOST], factor;
  for (size_t dof = 0; dof < rooms; dof++) along[dof] = sin(1.0 + (double)dof);
  OK(fmc_context_tangent_product(context, along, product, rooms));
  double size = 0, off = 0;
  for (size_t row = 0; row < rooms; row++)
    for (size_t col = 0; col < rooms; col++) of_rows[row] += full[row][col] * along[col];
  for (size_t part = 0; part < parts; part++) {
    double sum = 0;
    OK(fmc_context_tangent_rank_one(context, part, &factor, g, rooms));
    for (size_t dof = 0; dof < rooms; dof++) sum += g[dof] * along[dof];
    for (size_t dof = 0; dof < rooms; dof++) of_rows[dof] += factor * sum * g[dof];
  }
  for (size_t dof = 0; dof < rooms; dof++) {
    size = fmax(size, fabs(product[dof]));
    off = fmax(off, fabs(product[dof] - of_rows[dof]));
  }
  EXPECT(size > 0 && off <= 1e-12 * size);
}

/* While the upper body slides, the pattern only grows; apart it stays, with zeros. */
static void kept_pattern(void) {
  const size_t first = (nodes - 1) / 2;
  OK(fmc_context_tangent(context, &x, 0, NULL));
  OK(fmc_context_keep_pattern(context, 1));
  const size_t before = sizes(FMC_CSR_BLOCKS, NULL);
  for (size_t node = first; node < nodes - 1; node++) coords[node * dim + dim - 1] += 0.2;
  OK(fmc_context_tangent(context, &x, 0, NULL));
  const size_t entries = gather();
  EXPECT(sizes(FMC_CSR_BLOCKS, NULL) == before && entries < before * (size_t)(dim * dim));
  EXPECT(compare(FMC_CSR_BLOCKS) == before);
  EXPECT(compare(0) == before * (size_t)(dim * dim));
  for (size_t node = first; node < nodes - 1; node++) coords[node * dim + dim - 1] -= 0.2;
  OK(fmc_context_keep_pattern(context, 1));
  OK(fmc_context_evaluate_tangent(context, &x, FMC_TANGENT_SEMIDEFINITE, NULL, NULL, NULL));
  gather();
  EXPECT(compare(FMC_CSR_BLOCKS) == before);
  for (size_t node = first; node < nodes - 1; node++) coords[node * dim + dim - 1] += 0.2;
  OK(fmc_context_tangent(context, &x, 0, NULL));
  OK(fmc_context_keep_pattern(context, 0));
  EXPECT(sizes(FMC_CSR_BLOCKS, NULL) < before);
  for (size_t node = first; node < nodes - 1; node++) coords[node * dim + dim - 1] -= 0.2;
}

/* One call and two. */
static void together(void) {
  static double before[MOST][MOST];
  double apart[MOST] = {0}, forces[MOST] = {0};
  const fmc_forces f = {apart, nodes, dim, 1}, g = {forces, nodes, dim, 1};
  fmc_result one, two;
  size_t parts, same_parts;
  OK(fmc_context_evaluate(context, &x, &f, 0, &two));
  for (uint32_t flags = 0; flags <= FMC_TANGENT_SEMIDEFINITE; flags += FMC_TANGENT_SEMIDEFINITE) {
    OK(fmc_context_tangent(context, &x, flags, &parts));
    const size_t entries = gather();
    memcpy(before, full, sizeof full);
    memset(forces, 0, sizeof forces);
    OK(fmc_context_evaluate_tangent(context, &x, flags | FMC_EVALUATE_ADD, &g, &one, &same_parts));
    const size_t same_entries = gather();
    EXPECT(memcmp(before, full, sizeof full) == 0 && memcmp(forces, apart, sizeof forces) == 0);
    EXPECT(memcmp(&one, &two, sizeof one) == 0 && entries == same_entries && parts == same_parts && one.pair_count == 2);
  }
  OK(fmc_context_evaluate_tangent(context, &x, FMC_EVALUATE_ADD, &g, NULL, NULL));
  int doubled = 1;
  for (size_t dof = 0; dof < dofs; dof++) doubled = doubled && forces[dof] == 2 * apart[dof];
  EXPECT(doubled);
}

/* The step against the spectral norm of the matrix, which is symmetric and at most that of its rows. */
static void steps(void) {
  double masses[17], step = 0, other = 0;
  for (size_t node = 0; node < nodes; node++) masses[node] = 0.5;
  masses[nodes - 1] = 0; /* Not in contact. */
  OK(fmc_context_stable_step(context, &x, masses, &step));
  for (size_t node = 0; node < nodes; node++) masses[node] *= 4;
  OK(fmc_context_stable_step(context, &x, masses, &other));
  EXPECT(step > 0 && fabs(other / step - 2) < 1e-12);
  /* A Rayleigh quotient is a lower bound of the eigenvalue. */
  double along[MOST] = {0}, product[MOST], above = 0, below = 0;
  for (size_t node = (nodes - 1) / 2; node < nodes - 1; node++) along[node * dim + dim - 1] = 1;
  OK(fmc_context_tangent_product(context, along, product, dofs));
  for (size_t dof = 0; dof < dofs; dof++) above += along[dof] * product[dof], below += 0.5 * along[dof] * along[dof];
  EXPECT(above > 0 && step <= 2 / sqrt(above / below));
  masses[1] = 0;
  step = 42;
  REFUSED(FMC_ERROR_NOT_POSITIVE_MASS, base ? "node 2 feels contact, and its mass is 0" : "node 1 feels contact, and its mass is 0", fmc_context_stable_step(context, &x, masses, &step));
  REFUSED(FMC_ERROR_NULL_POINTER, "'masses'", fmc_context_stable_step(context, &x, NULL, &step));
  REFUSED(FMC_ERROR_NULL_POINTER, "'coords'", fmc_context_stable_step(context, NULL, masses, &step));
  REFUSED(FMC_ERROR_NULL_POINTER, "'step'", fmc_context_stable_step(context, &x, masses, NULL));
  const fmc_coords few = {coords, nodes - 1, dim, 1};
  REFUSED(FMC_ERROR_LENGTH, "'coords' has", fmc_context_stable_step(context, &few, masses, &step));
  EXPECT(step == 42);
  for (size_t dof = 0; dof < dofs; dof++) coords[dof] += dof % dim == (size_t)dim - 1 ? (dof < dofs / 2 ? 5 : 10) : 0;
  OK(fmc_context_stable_step(context, &x, masses, &step));
  EXPECT(isinf(step) && step > 0);
}

static void refused(void) {
  int64_t wide[MOST + 1], wide_cols[ROOM / 100];
  int32_t narrow[MOST + 1], narrow_cols[ROOM / 100];
  void *const offsets = is_wide ? (void *)wide : narrow, *const cols = is_wide ? (void *)wide_cols : narrow_cols;
  double values[ROOM / 100];
  size_t row_count = 77, count = 77, parts = 77;
  wide[0] = wide_cols[0] = 77, values[0] = 77, narrow[0] = narrow_cols[0] = 77;
#define CSR(flags, offsets, room, cols, values, capacity) \
  fmc_context_tangent_csr(context, flags, offsets, room, &row_count, cols, values, capacity, &count)
  REFUSED(FMC_ERROR_NULL_POINTER, "'context'", fmc_context_tangent_csr(NULL, 0, NULL, 0, &row_count, NULL, NULL, 0, &count));
  REFUSED(FMC_ERROR_UNKNOWN_FLAG, "flag in 0x2", CSR(FMC_TANGENT_SEMIDEFINITE, NULL, 0, NULL, NULL, 0));
  REFUSED(FMC_ERROR_UNKNOWN_FLAG, "flag in 0x20", CSR(32, offsets, MOST + 1, cols, values, ROOM / 100));
  EXPECT(row_count == 77 && count == 77);
  size_t rows = 0;
  const size_t all = sizes(0, &rows);
  REFUSED(FMC_ERROR_BUFFER_TOO_SMALL, "room for", CSR(0, offsets, rows + 1, cols, values, all - 1));
  REFUSED(FMC_ERROR_BUFFER_TOO_SMALL, "room for", CSR(0, offsets, rows, cols, values, all));
  REFUSED(FMC_ERROR_NULL_POINTER, "'row_offsets'", CSR(0, NULL, rows + 1, cols, values, all));
  REFUSED(FMC_ERROR_NULL_POINTER, "'cols'", CSR(0, offsets, rows + 1, NULL, values, all));
  REFUSED(FMC_ERROR_NULL_POINTER, "'values'", CSR(0, offsets, rows + 1, cols, NULL, all));
  void *const odd = (char *)offsets + (is_wide ? 4 : 2);
  REFUSED(FMC_ERROR_MISALIGNED_POINTER, "'row_offsets'", CSR(0, odd, rows + 1, cols, values, all));
  REFUSED(FMC_ERROR_BAD_VALUE, "'keep' is 2", fmc_context_keep_pattern(context, 2));
  REFUSED(FMC_ERROR_NULL_POINTER, "'context'", fmc_context_keep_pattern(NULL, 1));
  REFUSED(FMC_ERROR_BAD_VALUE, "'on' is 2", fmc_context_set_obstacle_rotations(context, 2));
  REFUSED(FMC_ERROR_UNKNOWN_FLAG, "flag in 0x1", fmc_context_tangent(context, &x, FMC_EVALUATE_ADD, &parts));
  REFUSED(FMC_ERROR_UNKNOWN_FLAG, "flag in 0x4", fmc_context_evaluate_tangent(context, &x, FMC_CSR_BLOCKS, NULL, NULL, &parts));
  REFUSED(FMC_ERROR_NULL_POINTER, "'coords'", fmc_context_evaluate_tangent(context, NULL, 0, NULL, NULL, &parts));
  const fmc_forces small = {values, nodes - 1, dim, 1};
  REFUSED(FMC_ERROR_BUFFER_TOO_SMALL, "room for", fmc_context_evaluate_tangent(context, &x, 0, &small, NULL, &parts));
  EXPECT(wide[0] == 77 && wide_cols[0] == 77 && values[0] == 77 && narrow[0] == 77 && narrow_cols[0] == 77);
  EXPECT(row_count == 77 && count == 77 && parts == 77);
}

int main(void) {
  for (int round = 0; round < 8; round++) {
    const int of_dim = 2 + round % 2;
    is_wide = round / 2 % 2, base = round / 4;
    for (int32_t law = FMC_LAW_VOLUME; law <= FMC_LAW_FIBER; law++) {
      begin(of_dim, law, 0.3);
      size_t row_count = 7;
      int64_t offset = 0;
      EXPECT(sizes(0, &row_count) == 0 && row_count == 0);
      OK(fmc_context_tangent_csr(context, 0, &offset, 1, NULL, NULL, NULL, 0, NULL));
      EXPECT((is_wide ? offset : *(int32_t *)(void *)&offset) == base);
      rows();
      kept_pattern();
      together();
      rows();
      refused();
      steps();
      OK(fmc_context_free(&context));
    }
  }
  printf("%d failures\n", failures);
  return failures > 0;
}
