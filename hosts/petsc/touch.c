#include "touch.h"
#include <fmc_mpi.h>
#include <time.h>

/* A failure on one rank fails all of them, since one that left alone would keep the others waiting. */
static PetscErrorCode together(fmc_status status) {
  int worst, mine = status;
  PetscFunctionBeginUser;
  PetscCallMPI(MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD));
  PetscCheck(worst == FMC_OK, PETSC_COMM_WORLD, PETSC_ERR_LIB, "%s: %s", fmc_status_name(worst), fmc_last_error());
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_create(const Problem *p, Vec like, Touch *t) {
  const fmc_coords coords = {p->x[0], p->node_count, 0, 0};
  const fmc_cell_block block = {FMC_TRI3, 4, p->triangles[0], p->triangle_count};
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(t, sizeof *t));
  t->problem = p;
  PetscCall(together(fmc_options_init(&t->options)));
  t->options.law = FMC_LAW_FIBER;
  t->options.estimator = FMC_ESTIMATOR_EXACT;
  t->options.stiffness = p->stiffness;
  PetscCall(together(fmc_context_new_from_cells(2, &coords, &block, 1, NULL, &t->options, &t->context)));
  PetscCallMPI(MPI_Comm_dup(PETSC_COMM_WORLD, &t->ranks));
  fmc_communicator ranks;
  PetscCallMPI(fmc_mpi_communicator(&t->ranks, &ranks));
  PetscCall(together(fmc_context_set_communicator(t->context, &ranks)));
  for (int k = 0; k < p->half_space_count; k++) {
    fmc_pose pose;
    PetscCall(together(fmc_pose_along(2, p->half_spaces[k], p->half_spaces[k] + 2, &pose)));
    fmc_shape half_space;
    PetscCall(together(fmc_shape_init(&half_space, FMC_SHAPE_HALF_SPACE)));
    PetscCall(together(fmc_context_add_obstacle(t->context, &half_space, &pose, NULL)));
  }
  PetscCall(VecScatterCreateToAll(like, &t->scatter, &t->all));
  PetscCall(PetscMalloc2(2 * p->node_count, &t->x, 2 * p->node_count, &t->force));
  PetscCall(PetscCalloc1(2 * p->node_count, &t->is_held));
  for (int h = 0; h < p->held_count; h++) t->is_held[p->held[h]] = 1;
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_stiffness(Touch *t, double stiffness) {
  PetscFunctionBeginUser;
  t->options.stiffness = stiffness;
  PetscCall(together(fmc_context_set_options(t->context, &t->options)));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Current coordinates of all nodes. */
static PetscErrorCode gather(Touch *t, Vec u, fmc_coords *coords) {
  const PetscScalar *all;
  PetscFunctionBeginUser;
  PetscCall(VecScatterBegin(t->scatter, u, t->all, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecScatterEnd(t->scatter, u, t->all, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecGetArrayRead(t->all, &all));
  for (int i = 0; i < 2 * t->problem->node_count; i++) t->x[i] = t->problem->x[0][i] + all[i];
  PetscCall(VecRestoreArrayRead(t->all, &all));
  *coords = (fmc_coords){t->x, t->problem->node_count, 0, 0};
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_keep_patches(Touch *t, Vec u) {
  fmc_coords coords;
  PetscFunctionBeginUser;
  PetscCall(gather(t, u, &coords));
  PetscCall(together(fmc_context_keep_patches(t->context, &coords, NULL)));
  PetscFunctionReturn(PETSC_SUCCESS);
}

double processor_seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

PetscErrorCode touch_evaluate(Touch *t, Vec u, Vec residual) {
  const fmc_forces forces = {t->force, t->problem->node_count, 0, 0};
  fmc_coords coords;
  double begin, end;
  PetscScalar *r;
  PetscInt first, last;
  PetscFunctionBeginUser;
  begin = processor_seconds();
  PetscCall(gather(t, u, &coords));
  PetscCall(together(fmc_context_evaluate(t->context, &coords, &forces, 0, NULL)));
  end = processor_seconds();
  t->seconds += end - begin;
  if (residual) {
    PetscCall(VecGetOwnershipRange(residual, &first, &last));
    PetscCall(VecGetArray(residual, &r));
    for (PetscInt row = first; row < last; row++) r[row - first] -= t->force[row];
    PetscCall(VecRestoreArray(residual, &r));
  }
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_add_tangent(Touch *t, Vec u, PetscBool semidefinite, Mat matrix) {
  fmc_coords coords;
  double begin, end;
  PetscInt first, last;
  int32_t *rows, *cols;
  double *values;
  size_t count;
  PetscFunctionBeginUser;
  begin = processor_seconds();
  PetscCall(gather(t, u, &coords));
  PetscCall(together(fmc_context_tangent(t->context, &coords, semidefinite ? FMC_TANGENT_SEMIDEFINITE : 0, NULL)));
  PetscCall(together(fmc_context_tangent_entries(t->context, NULL, NULL, NULL, 0, &count)));
  PetscCall(PetscMalloc3(count, &rows, count, &cols, count, &values));
  PetscCall(together(fmc_context_tangent_entries(t->context, rows, cols, values, count, NULL)));
  PetscCall(MatGetOwnershipRange(matrix, &first, &last));
  const int32_t size = 2 * t->problem->node_count; /* beyond are the half-spaces, which stay where they are */
  for (size_t e = 0; e < count; e++) {
    if (rows[e] < first || rows[e] >= last || cols[e] >= size || t->is_held[rows[e]] || t->is_held[cols[e]]) continue;
    PetscCall(MatSetValue(matrix, rows[e], cols[e], values[e], ADD_VALUES));
  }
  PetscCall(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  PetscCall(PetscFree3(rows, cols, values));
  end = processor_seconds();
  t->seconds += end - begin;
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_free(Touch *t) {
  PetscFunctionBeginUser;
  fmc_context_free(&t->context);
  PetscCallMPI(MPI_Comm_free(&t->ranks));
  PetscCall(VecScatterDestroy(&t->scatter));
  PetscCall(VecDestroy(&t->all));
  PetscCall(PetscFree2(t->x, t->force));
  PetscCall(PetscFree(t->is_held));
  PetscFunctionReturn(PETSC_SUCCESS);
}
