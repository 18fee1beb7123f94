/* Condensation: a rigid square on springs sinks onto another that is held, as in contact_step.c, but the host has no Schur
 * complements: each of its two springs is two of stiffness 1 in a row, with an equation between them, and the library takes the
 * stiffness of all down to what feels contact.
 *
 *        .-- load 0.8 --.        Equations: 0 and 1 between the springs, 2 and 3 at nodes 4 and 5. Two springs of 1 in a row
 *       7 ------------- 6        are one of 1/2: S = diag(1/2, 1/2). With k = 1000 and a gap of 0.1 the square sinks by
 *       |               |        u = 100.8 / 1001, and what lies between the springs by half of it.
 *       4 ------------- 5
 *     3 ------------- 2
 *     |               |          cc condensation.c $(pkg-config --cflags --libs fmc_contact) -lm                     */
#include <fmc_contact.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check(fmc_status status) {
  if (status != FMC_OK) {
    fprintf(stderr, "%s\n", fmc_last_error());
    exit(1);
  }
}

/* Nodes 7 and 6 above 4 and 5. */
static int32_t follow(void *user, size_t n, const double *displacement, double *coords) {
  if (n != 2 || user != NULL) return 1;
  coords[2 * 7 + 1] += displacement[0];
  coords[2 * 6 + 1] += displacement[1];
  return 0;
}

static fmc_context *two_squares(const double start[8][2]) {
  const int32_t conn[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 2};
  const fmc_coords initial = {start[0], 8, 0, 0};
  double guess[8][2];
  const fmc_coords overlapping = {guess[0], 8, 0, 0};
  fmc_options options;
  fmc_context *context;
  check(fmc_options_init(&options));
  options.law = FMC_LAW_FIBER;
  options.estimator = FMC_ESTIMATOR_EXACT;
  options.stiffness = 1000.0;
  check(fmc_context_new_from_cells(2, &initial, &block, 1, NULL, &options, &context));
  memcpy(guess, start, sizeof guess);
  for (int node = 4; node < 8; node++) guess[node][1] -= 0.12;
  check(fmc_context_keep_patches(context, &overlapping, NULL));
  return context;
}

int main(void) {
  const double start[8][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0.5, 1.1}, {1.5, 1.1}, {1.5, 2}, {0.5, 2}};
  fmc_context *context = two_squares(start);
  int wrong = 0;

  /* Rows of K, all entries: [2 . -1 .], [. 2 . -1], [-1 . 1 .], [. -1 . 1]. */
  const int64_t offsets[5] = {0, 2, 4, 6, 8}, cols[8] = {0, 2, 1, 3, 0, 2, 1, 3}, retained[2] = {2, 3};
  const double values[8] = {2, -1, 2, -1, -1, 1, -1, 1};
  const double load[4] = {0, 0, -0.4, -0.4}; /* external less internal forces */
  double S[4], condensed[2], d[2], all[4];
  size_t count;
  fmc_condensation *bodies = NULL;
  fmc_csr K;
  check(fmc_csr_init(&K));
  K.row_count = 4;
  K.index_size = sizeof offsets[0];
  K.row_offsets = offsets, K.cols = cols, K.values = values;
  check(fmc_condensation_new(&bodies));
  check(fmc_condensation_factorise(bodies, &K, retained, 2));
  check(fmc_condensation_complement(bodies, NULL, 0, &count));
  wrong += count != 4;
  check(fmc_condensation_complement(bodies, S, 4, NULL));
  check(fmc_condensation_condense(bodies, load, 4, condensed, 2, &count));
  wrong += count != 2;

  const int32_t dofs[2] = {2 * 4 + 1, 2 * 5 + 1}, fixed[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const fmc_coords initial = {start[0], 8, 0, 0};
  const double residual[2] = {-condensed[0], -condensed[1]};
  fmc_contact_step_options when;
  fmc_contact_step_result found;
  check(fmc_contact_step_options_init(&when));
  when.tolerance = 1e-12;
  check(fmc_context_contact_step(context, &initial, &when, dofs, 2, fixed, 8, S, residual, follow, NULL, d, &found));
  check(fmc_condensation_expand(bodies, load, 4, d, 2, all, 4, &count));
  wrong += count != 4;
  printf("S %g %g %g %g  u %.9f, expected %.9f, between %.9f\n", S[0], S[1], S[2], S[3], -d[0], 100.8 / 1001, -all[0]);
  wrong += found.state != FMC_STEP_CONVERGED;
  for (int spring = 0; spring < 2; spring++) {
    wrong += fabs(d[spring] + 100.8 / 1001) > 1e-9;
    wrong += all[2 + spring] != d[spring] || fabs(all[spring] - 0.5 * d[spring]) > 1e-15;
  }

  /* The lower triangle alone is the same matrix. */
  const int64_t lower_offsets[5] = {0, 1, 2, 4, 6}, lower_cols[6] = {0, 1, 0, 2, 1, 3};
  const double lower[6] = {2, 2, -1, 1, -1, 1};
  double again[4];
  K.row_offsets = lower_offsets, K.cols = lower_cols, K.values = lower;
  check(fmc_condensation_factorise(bodies, &K, retained, 2));
  check(fmc_condensation_complement(bodies, again, 4, NULL));
  wrong += memcmp(S, again, sizeof S) != 0;

  /* And so is one that counts from 1, with numbers of 32 bits. */
  const int32_t narrow_offsets[5] = {1, 2, 3, 5, 7}, narrow_cols[6] = {1, 2, 1, 3, 2, 4}, narrow_retained[2] = {3, 4};
  K.index_size = 4, K.index_base = 1;
  K.row_offsets = narrow_offsets, K.cols = narrow_cols;
  memset(again, 0, sizeof again);
  check(fmc_condensation_factorise(bodies, &K, narrow_retained, 2));
  check(fmc_condensation_complement(bodies, again, 4, NULL));
  wrong += memcmp(S, again, sizeof S) != 0;
  const int32_t beyond_retained[2] = {3, 5};
  wrong += fmc_condensation_factorise(bodies, &K, beyond_retained, 2) != FMC_ERROR_DOF_OUT_OF_RANGE;
  wrong += strstr(fmc_last_error(), " 5") == NULL;
  K.index_size = 2;
  wrong += fmc_condensation_factorise(bodies, &K, narrow_retained, 2) != FMC_ERROR_INDEX_SIZE;
  K.struct_size = 3;
  wrong += fmc_condensation_factorise(bodies, &K, narrow_retained, 2) != FMC_ERROR_STRUCT_SIZE;
  wrong += fmc_condensation_factorise(bodies, NULL, narrow_retained, 2) != FMC_ERROR_NULL_POINTER;
  check(fmc_csr_init(&K));
  K.row_count = 4, K.index_size = 8;

  /* What is refused leaves outputs and factors as they were. */
  const int64_t beyond[2] = {2, 4}, twice[2] = {2, 2}, negative[2] = {-1, 2}, far_cols[8] = {0, 2, 1, 3, 0, 2, 1, 4};
  const int64_t falling[5] = {0, 2, 1, 6, 8}, below[5] = {0, 2, 4, 6, -8};
  const double lost[8] = {2, -1, 2, NAN, -1, 1, -1, 1}, uneven[8] = {2, -1, 2, -1.5, -1, 1, -1, 1};
  const double wild[4] = {0, INFINITY, 0, 0};
#define FACTORISE(rows, columns, numbers, last) \
  (K.row_offsets = rows, K.cols = columns, K.values = numbers, fmc_condensation_factorise(bodies, &K, last, 2))
  wrong += FACTORISE(NULL, cols, values, retained) != FMC_ERROR_NULL_POINTER;
  wrong += FACTORISE(offsets, NULL, values, retained) != FMC_ERROR_NULL_POINTER;
  wrong += FACTORISE(offsets, cols, NULL, retained) != FMC_ERROR_NULL_POINTER;
  wrong += FACTORISE(offsets, cols, values, NULL) != FMC_ERROR_NULL_POINTER;
  wrong += FACTORISE(falling, cols, values, retained) != FMC_ERROR_LENGTH;
  wrong += FACTORISE(below, cols, values, retained) != FMC_ERROR_LENGTH;
  wrong += FACTORISE(offsets, far_cols, values, retained) != FMC_ERROR_DOF_OUT_OF_RANGE;
  wrong += FACTORISE(offsets, cols, values, beyond) != FMC_ERROR_DOF_OUT_OF_RANGE;
  wrong += FACTORISE(offsets, cols, values, negative) != FMC_ERROR_DOF_OUT_OF_RANGE;
  wrong += FACTORISE(offsets, cols, values, twice) != FMC_ERROR_REPEATED_DOF;
  wrong += FACTORISE(offsets, cols, lost, retained) != FMC_ERROR_NON_FINITE_STIFFNESS;
  wrong += FACTORISE(offsets, cols, uneven, retained) != FMC_ERROR_UNSYMMETRIC;
  memset(again, 0, sizeof again);
  wrong += fmc_condensation_complement(bodies, again, 3, NULL) != FMC_ERROR_BUFFER_TOO_SMALL;
  wrong += fmc_condensation_complement(bodies, NULL, 4, NULL) != FMC_ERROR_NULL_POINTER;
  wrong += fmc_condensation_condense(bodies, load, 3, again, 2, NULL) != FMC_ERROR_LENGTH;
  wrong += fmc_condensation_condense(bodies, wild, 4, again, 2, NULL) != FMC_ERROR_NON_FINITE_STIFFNESS;
  wrong += fmc_condensation_condense(bodies, load, 4, again, 1, NULL) != FMC_ERROR_BUFFER_TOO_SMALL;
  wrong += fmc_condensation_expand(bodies, load, 4, d, 1, again, 4, NULL) != FMC_ERROR_LENGTH;
  wrong += fmc_condensation_expand(bodies, load, 4, d, 2, again, 3, NULL) != FMC_ERROR_BUFFER_TOO_SMALL;
  wrong += again[0] != 0 || again[1] != 0;
  check(fmc_condensation_complement(bodies, again, 4, NULL));
  wrong += memcmp(S, again, sizeof S) != 0;

  /* Springs that nothing holds between their ends: not positive definite, and no factors are left. */
  const double loose[8] = {0, 0, 2, -1, 0, 1, -1, 1};
  wrong += FACTORISE(offsets, cols, loose, retained) != FMC_ERROR_NOT_POSITIVE_DEFINITE;
  wrong += fmc_condensation_complement(bodies, again, 4, NULL) != FMC_ERROR_NOT_FACTORISED;
  wrong += fmc_condensation_condense(bodies, load, 4, again, 2, NULL) != FMC_ERROR_NOT_FACTORISED;
  wrong += fmc_condensation_expand(bodies, load, 4, d, 2, again, 4, NULL) != FMC_ERROR_NOT_FACTORISED;
  wrong += memcmp(S, again, sizeof S) != 0;
  wrong += fmc_condensation_complement(NULL, again, 4, NULL) != FMC_ERROR_NULL_POINTER;
  wrong += fmc_condensation_new(NULL) != FMC_ERROR_NULL_POINTER;

  printf("wrong %d\n", wrong);
  fmc_condensation_free(&bodies);
  fmc_condensation_free(&bodies);
  fmc_condensation_free(NULL);
  fmc_context_free(&context);
  return wrong != 0 || bodies != NULL;
}
