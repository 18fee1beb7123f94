#include "newton.h"
#include "tetrahedra.h"

static const double YOUNG = 1.0, POISSON = 0.3, DOWN = 0.002;
static const double FAR = 0.1; /* part of the contact forces above which the contact's matrix is semidefinite */

static PetscErrorCode residual(SNES snes, Vec u, Vec r, void *user) {
  Press *h = user;
  const Blocks *b = &h->blocks;
  const PetscScalar *at;
  PetscScalar *rows;
  double held[3];
  PetscFunctionBeginUser;
  (void)snes;
  PetscCall(MatMult(h->stiffness, u, r));
  PetscCall(parts_evaluate(&h->parts, u, r));
  PetscCall(VecGetArrayRead(u, &at));
  PetscCall(VecGetArray(r, &rows));
  for (PetscInt n = 0; n < b->owned; n++)
    if (blocks_held(b, b->numbers[n], held))
      for (int axis = 0; axis < 3; axis++) rows[3 * n + axis] = at[3 * n + axis] - held[axis];
  PetscCall(VecRestoreArray(r, &rows));
  PetscCall(VecRestoreArrayRead(u, &at));
  PetscCall(VecNorm(r, NORM_2, &h->size));
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode derivative(SNES snes, Vec u, Mat a, Mat p, void *user) {
  Press *h = user;
  Mat matrix, tangent;
  IS touched;
  KSP ksp;
  PC pc;
  PetscFunctionBeginUser;
  (void)a;
  PetscCall(parts_tangent(&h->parts, u, h->size > FAR * h->parts.size, &tangent, &touched));
  PetscCall(MatDuplicate(h->bodies, MAT_COPY_VALUES, &matrix));
  PetscCall(MatAXPY(matrix, 1.0, tangent, DIFFERENT_NONZERO_PATTERN));
  PetscCall(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
  PetscCall(MatDestroy(&tangent));
  PetscCall(MatHeaderReplace(p, &matrix));
  /* It has entries at other places, which a factorisation would not see by itself. */
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PCReset(pc));
  PetscCall(ISGetSize(touched, &h->touched));
  PetscCall(ISDestroy(&h->filtered.touched));
  if (h->is_plain || h->is_direct) PetscCall(ISDestroy(&touched));
  else h->filtered.touched = touched;
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode count_iterations(SNES snes, PetscInt step, PetscReal norm, void *user) {
  Press *h = user;
  KSP ksp;
  PetscInt iterations;
  PetscFunctionBeginUser;
  (void)norm;
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetIterationNumber(ksp, &iterations));
  if (step) h->krylov = PetscMax(h->krylov, iterations);
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode find_held(Press *h) {
  const Blocks *b = &h->blocks;
  PetscInt first, *rows, count = 0;
  double at[3];
  PetscFunctionBeginUser;
  PetscCall(MatGetOwnershipRange(h->stiffness, &first, NULL));
  PetscCall(PetscMalloc1(3 * b->owned, &rows));
  for (PetscInt n = 0; n < b->owned; n++)
    if (blocks_held(b, b->numbers[n], at))
      for (int axis = 0; axis < 3; axis++) rows[count++] = first + 3 * n + axis;
  PetscCall(ISCreateGeneral(PETSC_COMM_WORLD, count, rows, PETSC_OWN_POINTER, &h->held));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Zero, but for what is held, which is where it will be. */
static PetscErrorCode start(const Press *h, Vec u) {
  const Blocks *b = &h->blocks;
  PetscScalar *at;
  double held[3];
  PetscFunctionBeginUser;
  PetscCall(VecSet(u, 0.0));
  PetscCall(VecGetArray(u, &at));
  for (PetscInt n = 0; n < b->owned; n++)
    if (blocks_held(b, b->numbers[n], held)) PetscCall(PetscArraycpy(at + 3 * n, held, 3));
  PetscCall(VecRestoreArray(u, &at));
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode set_solver(Press *h, SNES snes) {
  KSP ksp;
  PC pc;
  PetscFunctionBeginUser;
  PetscCall(SNESSetTolerances(snes, 1e-14, 1e-8, 0.0, 40, 10000));
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(KSPSetErrorIfNotConverged(ksp, PETSC_TRUE));
  if (h->is_direct) {
    PetscCall(KSPSetType(ksp, KSPPREONLY));
    PetscCall(PCSetType(pc, PCCHOLESKY));
    PetscCall(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  } else {
    PetscCall(KSPSetType(ksp, KSPCG));
    PetscCall(KSPSetTolerances(ksp, 1e-8, PETSC_DEFAULT, PETSC_DEFAULT, 500));
    PetscCall(filtered_attach(pc, h->bodies, h->motions, &h->filtered));
  }
  PetscCall(SNESSetFromOptions(snes));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode press_create(const PetscInt cells[2], double width, double ratio, Press *h) {
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(h, sizeof *h));
  PetscCall(blocks_create(cells, width, DOWN, &h->blocks));
  PetscCall(parts_create(&h->blocks, ratio * YOUNG * cells[0], &h->parts));
  PetscCall(tetrahedra_stiffness(&h->blocks, YOUNG, POISSON, &h->stiffness));
  PetscCall(tetrahedra_rigid_motions(&h->blocks, &h->motions));
  PetscCall(find_held(h));
  PetscCall(MatDuplicate(h->stiffness, MAT_COPY_VALUES, &h->bodies));
  PetscCall(MatZeroRowsColumnsIS(h->bodies, h->held, 1.0, NULL, NULL));
  PetscCall(MatDuplicate(h->stiffness, MAT_DO_NOT_COPY_VALUES, &h->matrix));
  PetscCall(MatCreateVecs(h->stiffness, &h->residual, NULL));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode press_solve(Press *h, Vec u, SNES *snes) {
  SNESConvergedReason reason;
  PetscFunctionBeginUser;
  h->krylov = 0;
  PetscCall(start(h, u));
  PetscCall(parts_keep_patches(&h->parts, u));
  PetscCall(SNESCreate(PETSC_COMM_WORLD, snes));
  PetscCall(SNESSetFunction(*snes, h->residual, residual, h));
  PetscCall(SNESSetJacobian(*snes, h->matrix, h->matrix, derivative, h));
  PetscCall(SNESMonitorSet(*snes, count_iterations, h, NULL));
  PetscCall(set_solver(h, *snes));
  PetscCall(SNESSolve(*snes, NULL, u));
  PetscCall(SNESGetConvergedReason(*snes, &reason));
  PetscCheck(reason >= 0, PETSC_COMM_WORLD, PETSC_ERR_NOT_CONVERGED, "no equilibrium: %s", SNESConvergedReasons[reason]);
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode press_free(Press *h) {
  PetscFunctionBeginUser;
  PetscCall(filtered_free(&h->filtered));
  PetscCall(ISDestroy(&h->filtered.touched));
  PetscCall(ISDestroy(&h->held));
  PetscCall(VecDestroy(&h->residual));
  PetscCall(MatDestroy(&h->matrix));
  PetscCall(MatDestroy(&h->stiffness));
  PetscCall(MatDestroy(&h->bodies));
  PetscCall(MatNullSpaceDestroy(&h->motions));
  PetscCall(parts_free(&h->parts));
  blocks_free(&h->blocks);
  PetscFunctionReturn(PETSC_SUCCESS);
}
