/* The contact step: a rigid square on four springs sinks onto another that is held, as in newton.c, but the iterations of the
 * contact are the library's.
 *
 *        .-- load 0.8 --.        The host's bodies are springs, k_s = 1 in all. Condensed on the heights of nodes 4 and 5
 *       7 ------------- 6        they are S = diag(1/2, 1/2), with r = -load / 2 upwards being +0.4 each, and what follows
 *       |               |        is that nodes 7 and 6 stay above them. With k = 1000 and a gap of 0.1 the square sinks by
 *       4 ------------- 5        u = 100.8 / 1001.
 *     3 ------------- 2
 *     |               |          cc contact_step.c $(pkg-config --cflags --libs fmc_contact) -lm                     */
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

static int32_t refuse(void *user, size_t n, const double *displacement, double *coords) {
  (void)user, (void)n, (void)displacement, (void)coords;
  return 7;
}

int main(void) {
  const double start[8][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0.5, 1.1}, {1.5, 1.1}, {1.5, 2}, {0.5, 2}};
  double guess[8][2];
  const int32_t conn[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const fmc_cell_block block = {FMC_QUAD4, 4, conn, 2};
  const fmc_coords initial = {start[0], 8, 0, 0}, overlapping = {guess[0], 8, 0, 0};
  fmc_context *context;

  fmc_options options;
  check(fmc_options_init(&options));
  options.law = FMC_LAW_FIBER;
  options.estimator = FMC_ESTIMATOR_EXACT;
  options.stiffness = 1000.0;
  check(fmc_context_new_from_cells(2, &initial, &block, 1, NULL, &options, &context));
  /* One energy: directions of the contact where the squares overlap. */
  memcpy(guess, start, sizeof start);
  for (int node = 4; node < 8; node++) guess[node][1] -= 0.12;
  check(fmc_context_keep_patches(context, &overlapping, NULL));

  const int32_t dofs[2] = {2 * 4 + 1, 2 * 5 + 1}, fixed[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const double stiffness[4] = {0.5, 0, 0, 0.5}, residual[2] = {0.4, 0.4};
  double d[2];
  fmc_contact_step_options when;
  fmc_contact_step_result found;
  check(fmc_contact_step_options_init(&when));
  when.tolerance = 1e-12;
  check(fmc_context_contact_step(context, &initial, &when, dofs, 2, fixed, 8, stiffness, residual, follow, NULL, d, &found));
  printf("state %d  u %.9f %.9f, expected %.9f\n", (int)found.state, -d[0], -d[1], 100.8 / 1001);
  int wrong = found.state != FMC_STEP_CONVERGED || fabs(d[0] + 100.8 / 1001) > 1e-9 || fabs(d[1] + 100.8 / 1001) > 1e-9;
  wrong += found.iterations < 1 || found.residual > 1e-12 * found.scale || found.struct_size != sizeof found;

  /* The same equilibrium on softer contacts first. */
  when.soft_start = 1;
  check(fmc_context_contact_step(context, &initial, &when, dofs, 2, fixed, 8, stiffness, residual, follow, NULL, d, &found));
  wrong += found.state != FMC_STEP_CONVERGED || fabs(d[0] + 100.8 / 1001) > 1e-9;

  /* Without the fixed nodes, contact acts outside the list as soon as the squares touch. */
  check(fmc_context_contact_step(context, &initial, NULL, dofs, 2, NULL, 0, stiffness, residual, follow, NULL, d, &found));
  wrong += found.state != FMC_STEP_OUTSIDE || found.outside_count == 0;

  /* As little penetration as is wanted, by surfaces that are moved out where a step has led: the lower square, which is held, stops
   * the upper one after 0.1. */
  fmc_augmentation gaps;
  int updates = 0;
  for (;; updates++) {
    memcpy(guess, start, sizeof start);
    for (int node = 4; node < 8; node++) guess[node][1] += updates == 0 ? -100.8 / 1001 : d[node == 4 || node == 7 ? 0 : 1];
    check(fmc_context_augment(context, &overlapping, 0, 1e-7, &gaps));
    if (gaps.is_converged || updates == 20) break;
    check(fmc_context_contact_step(context, &initial, &when, dofs, 2, fixed, 8, stiffness, residual, follow, NULL, d, &found));
    wrong += found.state != FMC_STEP_CONVERGED;
  }
  printf("penetration %g after %d updates, u %.9f\n", gaps.penetration, updates, -d[0]);
  wrong += !gaps.is_converged || gaps.penetration > 1e-7 || updates == 0;
  wrong += fabs(d[0] + 0.1) > 1.01e-7 || fabs(d[1] + 0.1) > 1.01e-7;
  check(fmc_context_set_multipliers(context, NULL, 0));

  /* What is refused leaves the outputs as they were. */
  const int32_t beyond[2] = {9, 16}, again[2] = {9, 9}, negative[2] = {-1, 9};
  const double none[4] = {0, 0, 0, 0}, down[4] = {-1, 0, 0, 1}, lost[4] = {0.5, 0, NAN, 0.5};
  const fmc_coords *x = &initial;
  d[0] = d[1] = 7;
#define STEP(options, list, matrix, place) \
  fmc_context_contact_step(context, x, options, list, 2, fixed, 8, matrix, residual, place, NULL, d, &found)
  wrong += STEP(NULL, beyond, stiffness, follow) != FMC_ERROR_DOF_OUT_OF_RANGE;
  wrong += STEP(NULL, negative, stiffness, follow) != FMC_ERROR_DOF_OUT_OF_RANGE;
  wrong += STEP(NULL, again, stiffness, follow) != FMC_ERROR_REPEATED_DOF;
  wrong += STEP(NULL, fixed, stiffness, follow) != FMC_ERROR_REPEATED_DOF;
  wrong += STEP(NULL, dofs, lost, follow) != FMC_ERROR_NON_FINITE_STIFFNESS;
  wrong += STEP(NULL, dofs, none, follow) != FMC_ERROR_SINGULAR_STIFFNESS;
  wrong += STEP(NULL, dofs, down, follow) != FMC_ERROR_INDEFINITE_STIFFNESS;
  wrong += STEP(NULL, dofs, stiffness, refuse) != FMC_ERROR_PLACE;
  wrong += STEP(NULL, dofs, NULL, follow) != FMC_ERROR_NULL_POINTER;
  when.soft_start = 2;
  wrong += STEP(&when, dofs, stiffness, follow) != FMC_ERROR_BAD_VALUE;
  when.soft_start = 0;
  when.max_trials = 0;
  wrong += STEP(&when, dofs, stiffness, follow) != FMC_ERROR_NOT_POSITIVE;
  when.max_trials = -1;
  wrong += STEP(&when, dofs, stiffness, follow) != FMC_ERROR_NOT_POSITIVE;
  when.max_trials = 12;
  when.reserved[4] = 1;
  wrong += STEP(&when, dofs, stiffness, follow) != FMC_ERROR_RESERVED_FIELD;
  when.struct_size = 1;
  wrong += STEP(&when, dofs, stiffness, follow) != FMC_ERROR_STRUCT_SIZE;
  wrong += d[0] != 7 || d[1] != 7;
  printf("wrong %d\n", wrong);
  fmc_context_free(&context);
  return wrong;
}
