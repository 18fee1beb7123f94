/* The equilibrium of a block that nothing but a floor holds, without a number that is chosen.
 *
 *     3 ------- 2     A square of four springs, its edges, and two diagonals, above a floor. Each node weighs 1. The search finds
 *     |  \   /  |     the stiffness of the contact from the matrix, lets the square down on the floor, and solves. The host
 *     |  /   \  |     answers what it is asked: forces, products with its matrix, and solutions of linear systems.
 *     0 ------- 1
 *  ===== floor =====  cc equilibrium.c $(pkg-config --cflags --libs fmc_contact) -lm                                  */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 8 };

static fmc_context *context;
static double matrix[N][N];
static const double start[4][2] = {{0, 0.3}, {1, 0.3}, {1, 1.3}, {0, 1.3}};

static void check(fmc_status status) {
  if (status != FMC_OK) {
    fprintf(stderr, "%s\n", fmc_last_error());
    exit(1);
  }
}

static void spring(int a, int b, double k) {
  const double length = hypot(start[b][0] - start[a][0], start[b][1] - start[a][1]);
  const double n[2] = {(start[b][0] - start[a][0]) / length, (start[b][1] - start[a][1]) / length};
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++) {
      const double kij = k * n[i] * n[j];
      matrix[2 * a + i][2 * a + j] += kij, matrix[2 * b + i][2 * b + j] += kij;
      matrix[2 * a + i][2 * b + j] -= kij, matrix[2 * b + i][2 * a + j] -= kij;
    }
}

/* (K + shift diag K + T) d = right, by elimination with pivots; 0 where it is singular. */
static int solve(const fmc_equilibrium_request *request, double *d) {
  double a[N][N + 1], x[4][2];
  for (int i = 0; i < N; i++) {
    memcpy(a[i], matrix[i], sizeof matrix[i]);
    a[i][i] += request->shift * matrix[i][i];
    a[i][N] = request->vector[i];
    x[i / 2][i % 2] = start[i / 2][i % 2] + request->x[i];
  }
  const fmc_coords coords = {x[0], 4, 0, 0};
  size_t count = 0, terms = 0;
  int32_t rows[256], cols[256];
  double values[256];
  check(fmc_context_tangent(context, &coords, request->tangent_flags, &terms));
  check(fmc_context_tangent_entries(context, rows, cols, values, 256, &count));
  for (size_t k = 0; k < count; k++)
    if (rows[k] < N && cols[k] < N) a[rows[k]][cols[k]] += values[k];
  for (int c = 0; c < N; c++) {
    int pivot = c;
    for (int r = c; r < N; r++)
      if (fabs(a[r][c]) > fabs(a[pivot][c])) pivot = r;
    if (a[pivot][c] == 0) return 0;
    for (int j = 0; j <= N; j++) {
      const double kept = a[c][j];
      a[c][j] = a[pivot][j], a[pivot][j] = kept;
    }
    for (int r = 0; r < N; r++) {
      const double part = r == c ? 0 : a[r][c] / a[c][c];
      for (int j = c; j <= N; j++) a[r][j] -= part * a[c][j];
    }
  }
  for (int i = 0; i < N; i++) d[i] = a[i][N] / a[i][i];
  return 1;
}

int main(void) {
  const int32_t conn[4] = {0, 1, 2, 3}, unknowns[N] = {0, 1, 2, 3, 4, 5, 6, 7};
  const uint8_t is_free[N] = {1, 1, 1, 1, 1, 1, 1, 1};
  const double rest[N] = {0};
  for (int a = 0; a < 4; a++)
    for (int b = a + 1; b < 4; b++) spring(a, b, 1e4);

  fmc_options options;
  check(fmc_options_init(&options)); /* stiffness 0: it is found */
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 1};
  const fmc_coords coords = {start[0], 4, 0, 0};
  check(fmc_context_new_from_cells(2, &coords, &block, 1, NULL, &options, &context));
  fmc_shape floor;
  fmc_pose pose;
  check(fmc_shape_init(&floor, FMC_SHAPE_HALF_SPACE));
  check(fmc_pose_init(&pose));
  check(fmc_context_add_obstacle(context, &floor, &pose, NULL));

  fmc_equilibrium_problem problem;
  check(fmc_equilibrium_problem_init(&problem));
  problem.unknown_count = N, problem.row_count = 4;
  problem.unknown_of_coordinate = unknowns;
  problem.base = start[0], problem.free = is_free, problem.x = rest;
  fmc_equilibrium *search = NULL;
  check(fmc_equilibrium_new(context, &problem, NULL, &search));

  fmc_equilibrium_request request;
  fmc_equilibrium_answer answer;
  check(fmc_equilibrium_next(context, search, NULL, &request));
  while (request.kind != FMC_REQUEST_FOUND && request.kind != FMC_REQUEST_REFUSED) {
    double found[N] = {0};
    int is_there = 1;
    for (int i = 0; i < N; i++) {
      if (request.kind == FMC_REQUEST_DIAGONAL) found[i] = matrix[i][i];
      if (request.kind == FMC_REQUEST_FORCES) found[i] = i % 2; /* internal less external: nothing less a weight of -1 */
      for (int j = 0; j < N; j++) {
        const double kij = request.magnitudes ? fabs(matrix[i][j]) : matrix[i][j];
        if (request.kind == FMC_REQUEST_FORCES) found[i] += matrix[i][j] * request.x[j];
        if (request.kind == FMC_REQUEST_PRODUCT) found[i] += kij * request.vector[j];
      }
    }
    if (request.kind == FMC_REQUEST_SOLVE) is_there = solve(&request, found);
    check(fmc_equilibrium_answer_init(&answer));
    answer.vector = is_there ? found : NULL;
    check(fmc_equilibrium_next(context, search, &answer, &request));
  }

  fmc_equilibrium_result result;
  check(fmc_equilibrium_found(search, &result));
  for (size_t k = 0; k < result.text_count; k++) printf("%s\n", fmc_equilibrium_text(search, k));
  if (result.way != FMC_WAY_NONE) {
    double x[4][2];
    for (int i = 0; i < N; i++) x[i / 2][i % 2] = start[i / 2][i % 2] + result.x[i];
    const fmc_coords there = {x[0], 4, 0, 0};
    fmc_resultant on_floor;
    check(fmc_context_evaluate(context, &there, NULL, 0, NULL));
    check(fmc_context_obstacle_resultant(context, 0, &on_floor));
    printf("the floor bears %.9f of 4\n", -on_floor.force[1]);
  }
  check(fmc_equilibrium_free(&search));
  return fmc_context_free(&context) == FMC_OK ? 0 : 1;
}
