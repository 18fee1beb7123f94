#include "bodies.h"

/* A vector of the search as one of PETSc, and back. */
static PetscErrorCode divide(const double *whole, Vec divided) {
  PetscInt first, last;
  PetscScalar *part;
  PetscFunctionBeginUser;
  PetscCall(VecGetOwnershipRange(divided, &first, &last));
  PetscCall(VecGetArrayWrite(divided, &part));
  PetscCall(PetscArraycpy(part, whole + first, last - first));
  PetscCall(VecRestoreArrayWrite(divided, &part));
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode gather(Bodies *b, Vec divided, double *whole) {
  const PetscScalar *all;
  PetscInt count;
  PetscFunctionBeginUser;
  PetscCall(VecScatterBegin(b->to_all, divided, b->all, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecScatterEnd(b->to_all, divided, b->all, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecGetSize(b->all, &count));
  PetscCall(VecGetArrayRead(b->all, &all));
  PetscCall(PetscArraycpy(whole, all, count));
  PetscCall(VecRestoreArrayRead(b->all, &all));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode bodies_create(const Problem *p, Mat stiffness, Vec load, Bodies *b) {
  PetscInt first, last, count = 0, *mine;
  PC pc;
  int ranks;
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(b, sizeof *b));
  b->stiffness = stiffness;
  PetscCall(MatCreateVecs(stiffness, &b->divided, &b->found));
  PetscCall(VecScatterCreateToAll(load, &b->to_all, &b->all));
  PetscCall(PetscMalloc1(2 * p->node_count, &b->load));
  PetscCall(gather(b, load, b->load));
  PetscCall(VecDestroy(&load));
  PetscCall(MatGetOwnershipRange(stiffness, &first, &last));
  PetscCall(PetscMalloc1(p->held_count, &mine));
  for (int k = 0; k < p->held_count; k++)
    if (p->held[k] >= first && p->held[k] < last) mine[count++] = p->held[k];
  PetscCall(ISCreateGeneral(PETSC_COMM_WORLD, count, mine, PETSC_OWN_POINTER, &b->held));
  PetscCall(KSPCreate(PETSC_COMM_WORLD, &b->ksp));
  PetscCall(KSPSetType(b->ksp, KSPPREONLY));
  PetscCall(KSPGetPC(b->ksp, &pc));
  PetscCall(PCSetType(pc, PCLU));
  PetscCallMPI(MPI_Comm_size(PETSC_COMM_WORLD, &ranks));
  if (ranks > 1) PetscCall(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  PetscCall(KSPSetFromOptions(b->ksp));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* The sum over a row of magnitudes, times a vector. */
static PetscErrorCode product_of_magnitudes(Bodies *b, const double *vector) {
  PetscInt first, last, count;
  const PetscInt *cols;
  const PetscScalar *values;
  PetscScalar *rows;
  PetscFunctionBeginUser;
  PetscCall(MatGetOwnershipRange(b->stiffness, &first, &last));
  PetscCall(VecGetArrayWrite(b->found, &rows));
  for (PetscInt row = first; row < last; row++) {
    PetscCall(MatGetRow(b->stiffness, row, &count, &cols, &values));
    rows[row - first] = 0;
    for (PetscInt e = 0; e < count; e++) rows[row - first] += PetscAbsScalar(values[e]) * vector[cols[e]];
    PetscCall(MatRestoreRow(b->stiffness, row, &count, &cols, &values));
  }
  PetscCall(VecRestoreArrayWrite(b->found, &rows));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* The linear system with the contact at a state. */
static PetscErrorCode solve(Bodies *b, Touch *touch, const fmc_equilibrium_request *asked, PetscBool *is_there) {
  Mat matrix;
  KSPConvergedReason reason;
  PetscFunctionBeginUser;
  PetscCall(MatDuplicate(b->stiffness, MAT_COPY_VALUES, &matrix));
  PetscCall(MatSetOption(matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
  PetscCall(MatGetDiagonal(matrix, b->found));
  PetscCall(VecScale(b->found, 1.0 + asked->shift));
  PetscCall(MatDiagonalSet(matrix, b->found, INSERT_VALUES));
  PetscCall(touch_add_tangent(touch, asked->x, asked->tangent_flags, matrix));
  PetscCall(VecSet(b->found, 0.0));
  PetscCall(MatZeroRowsColumnsIS(matrix, b->held, 1.0, b->found, b->divided));
  PetscCall(KSPSetOperators(b->ksp, matrix, matrix));
  PetscCall(MatDestroy(&matrix));
  PetscCall(KSPSolve(b->ksp, b->divided, b->found));
  PetscCall(KSPGetConvergedReason(b->ksp, &reason));
  *is_there = reason > 0;
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode bodies_answer(Bodies *b, Touch *touch, const fmc_equilibrium_request *asked, double *found, double *energy,
                             PetscBool *is_there) {
  PetscInt count;
  PetscFunctionBeginUser;
  PetscCall(VecGetSize(b->all, &count));
  const double *given = asked->kind == FMC_REQUEST_FORCES ? asked->x : asked->vector;
  if (given) PetscCall(divide(given, b->divided));
  *is_there = PETSC_TRUE;
  if (asked->kind == FMC_REQUEST_DIAGONAL) PetscCall(MatGetDiagonal(b->stiffness, b->found));
  else if (asked->kind == FMC_REQUEST_SOLVE) PetscCall(solve(b, touch, asked, is_there));
  else if (asked->magnitudes) PetscCall(product_of_magnitudes(b, given));
  else PetscCall(MatMult(b->stiffness, b->divided, b->found));
  PetscCall(gather(b, b->found, found));
  *energy = 0;
  if (asked->kind == FMC_REQUEST_FORCES)
    for (PetscInt i = 0; i < count; i++) {
      *energy += given[i] * (0.5 * found[i] - b->load[i]);
      found[i] -= b->load[i];
    }
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode bodies_free(Bodies *b) {
  PetscFunctionBeginUser;
  PetscCall(KSPDestroy(&b->ksp));
  PetscCall(ISDestroy(&b->held));
  PetscCall(VecScatterDestroy(&b->to_all));
  PetscCall(VecDestroy(&b->all));
  PetscCall(VecDestroy(&b->divided));
  PetscCall(VecDestroy(&b->found));
  PetscCall(MatDestroy(&b->stiffness));
  PetscCall(PetscFree(b->load));
  PetscFunctionReturn(PETSC_SUCCESS);
}
