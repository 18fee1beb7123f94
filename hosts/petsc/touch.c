#include "touch.h"
#include <fmc_mpi.h>
#include <time.h>

PetscErrorCode together(fmc_status status) {
  int worst, mine = status;
  PetscFunctionBeginUser;
  PetscCallMPI(MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD));
  PetscCheck(worst == FMC_OK, PETSC_COMM_WORLD, PETSC_ERR_LIB, "%s: %s", fmc_status_name(worst), fmc_last_error());
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_create(const Problem *p, Touch *t) {
  const fmc_coords coords = {p->x[0], p->node_count, 0, 0};
  const fmc_cell_block block = {FMC_TRI3, 4, p->triangles[0], p->triangle_count};
  fmc_options options;
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(t, sizeof *t));
  t->problem = p;
  PetscCall(together(fmc_options_init(&options)));
  options.law = FMC_LAW_FIBER;
  options.estimator = FMC_ESTIMATOR_EXACT;
  options.stiffness = p->stiffness;
  PetscCall(together(fmc_context_new_from_cells(2, &coords, &block, 1, NULL, &options, &t->context)));
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
  PetscCall(PetscMalloc1(2 * p->node_count, &t->x));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Current coordinates of all nodes. */
static fmc_coords moved(Touch *t, const double *u) {
  for (int i = 0; i < 2 * t->problem->node_count; i++) t->x[i] = t->problem->x[0][i] + u[i];
  return (fmc_coords){t->x, t->problem->node_count, 0, 0};
}

double processor_seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

PetscErrorCode touch_evaluate(Touch *t, const double *u, double *forces) {
  const fmc_forces room = {forces, t->problem->node_count, 0, 0};
  const fmc_coords coords = moved(t, u);
  PetscFunctionBeginUser;
  PetscCall(together(fmc_context_evaluate(t->context, &coords, &room, 0, NULL)));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_add_tangent(Touch *t, const double *u, uint32_t flags, Mat matrix) {
  const fmc_coords coords = moved(t, u);
  const double begin = processor_seconds();
  PetscInt first, last;
  int32_t *rows, *cols;
  double *values;
  size_t count;
  PetscFunctionBeginUser;
  PetscCall(together(fmc_context_tangent(t->context, &coords, flags, NULL)));
  PetscCall(together(fmc_context_tangent_entries(t->context, NULL, NULL, NULL, 0, &count)));
  PetscCall(PetscMalloc3(count, &rows, count, &cols, count, &values));
  PetscCall(together(fmc_context_tangent_entries(t->context, rows, cols, values, count, NULL)));
  PetscCall(MatGetOwnershipRange(matrix, &first, &last));
  const int32_t size = 2 * t->problem->node_count; /* beyond are the half-spaces, which stay where they are */
  for (size_t e = 0; e < count; e++)
    if (rows[e] >= first && rows[e] < last && cols[e] < size)
      PetscCall(MatSetValue(matrix, rows[e], cols[e], values[e], ADD_VALUES));
  PetscCall(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  PetscCall(PetscFree3(rows, cols, values));
  t->seconds += processor_seconds() - begin;
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode touch_free(Touch *t) {
  PetscFunctionBeginUser;
  fmc_context_free(&t->context);
  PetscCallMPI(MPI_Comm_free(&t->ranks));
  PetscCall(PetscFree(t->x));
  PetscFunctionReturn(PETSC_SUCCESS);
}
