#include "filtered.h"

#if !defined(PETSC_SUCCESS) && PETSC_VERSION_LT(3, 19, 0)
#define PETSC_SUCCESS ((PetscErrorCode)0)
#endif

static PetscErrorCode reset(Filtered *f) {
  PetscFunctionBeginUser;
  PetscCall(PCDestroy(&f->multigrid));
  PetscCall(PCDestroy(&f->direct));
  PetscCall(VecDestroy(&f->rest));
  PetscCall(VecDestroy(&f->step));
  PetscCall(VecDestroy(&f->inner_rest));
  PetscCall(VecDestroy(&f->inner_step));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* A direct solver for the unknowns that feel contact. */
static PetscErrorCode set_up_direct(Filtered *f, Mat matrix) {
  Mat inner;
  PetscFunctionBeginUser;
  PetscCall(MatCreateSubMatrix(matrix, f->touched, f->touched, MAT_INITIAL_MATRIX, &inner));
  PetscCall(MatSetOption(inner, MAT_SYMMETRIC, PETSC_TRUE));
  PetscCall(MatSetOption(inner, MAT_SPD, PETSC_TRUE));
  PetscCall(PCCreate(PetscObjectComm((PetscObject)matrix), &f->direct));
  PetscCall(PCSetOptionsPrefix(f->direct, "direct_"));
  PetscCall(PCSetOperators(f->direct, inner, inner));
  PetscCall(PCSetType(f->direct, PCCHOLESKY));
  PetscCall(PCFactorSetMatSolverType(f->direct, MATSOLVERMUMPS));
  PetscCall(PCSetFromOptions(f->direct));
  PetscCall(PCSetUp(f->direct));
  PetscCall(MatCreateVecs(inner, &f->inner_step, &f->inner_rest));
  PetscCall(MatDestroy(&inner));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Interpolations that GAMG finds for the bodies alone: of aggregates that reach from one body into the other, which move as one, the
 * bodies could not slide on each other. */
static PetscErrorCode find_levels(Filtered *f) {
  PC gamg;
  PetscFunctionBeginUser;
  PetscCall(MatSetNearNullSpace(f->bodies, f->motions));
  PetscCall(PCCreate(PetscObjectComm((PetscObject)f->bodies), &gamg));
  PetscCall(PCSetOptionsPrefix(gamg, "levels_"));
  PetscCall(PCSetOperators(gamg, f->bodies, f->bodies));
  PetscCall(PCSetType(gamg, PCGAMG));
  PetscCall(PCSetFromOptions(gamg));
  PetscCall(PCSetUp(gamg));
  PetscCall(PCGetInterpolations(gamg, &f->level_count, &f->interpolations));
  PetscCall(PCDestroy(&gamg));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* A cycle on these levels, on each with the matrix that follows from the one with contact. */
static PetscErrorCode set_up_multigrid(Filtered *f, Mat matrix) {
  PetscFunctionBeginUser;
  if (!f->level_count) PetscCall(find_levels(f));
  PetscCall(PCCreate(PetscObjectComm((PetscObject)matrix), &f->multigrid));
  PetscCall(PCSetOptionsPrefix(f->multigrid, "multigrid_"));
  PetscCall(PCSetOperators(f->multigrid, matrix, matrix));
  PetscCall(PCSetType(f->multigrid, PCMG));
  PetscCall(PCMGSetLevels(f->multigrid, f->level_count, NULL));
  for (PetscInt level = 1; level < f->level_count; level++)
    PetscCall(PCMGSetInterpolation(f->multigrid, level, f->interpolations[level - 1]));
  PetscCall(PCMGSetGalerkin(f->multigrid, PC_MG_GALERKIN_BOTH));
  /* Sweeps end at the border of a rank: with two of them, PETSc's default, four ranks take up to 1.25 times the iterations of one. */
  PetscCall(PCMGSetNumberSmooth(f->multigrid, 3));
  PetscCall(PCSetFromOptions(f->multigrid));
  PetscCall(PCSetUp(f->multigrid));
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode set_up(PC pc) {
  Filtered *f;
  Mat matrix;
  PetscInt count = 0;
  PetscFunctionBeginUser;
  PetscCall(PCShellGetContext(pc, &f));
  PetscCall(reset(f));
  PetscCall(PCGetOperators(pc, NULL, &matrix));
  PetscCall(set_up_multigrid(f, matrix));
  PetscCall(MatCreateVecs(matrix, &f->step, &f->rest));
  if (f->touched) PetscCall(ISGetSize(f->touched, &count));
  if (count) PetscCall(set_up_direct(f, matrix));
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode residual(Filtered *f, Mat matrix, Vec x, Vec y) {
  PetscFunctionBeginUser;
  PetscCall(MatMult(matrix, y, f->rest));
  PetscCall(VecAYPX(f->rest, -1.0, x));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* y = M x. */
static PetscErrorCode apply(PC pc, Vec x, Vec y) {
  Filtered *f;
  Mat matrix;
  PetscFunctionBeginUser;
  PetscCall(PCShellGetContext(pc, &f));
  PetscCall(PCGetOperators(pc, NULL, &matrix));
  PetscCall(PCApply(f->multigrid, x, y));
  if (!f->direct) PetscFunctionReturn(PETSC_SUCCESS);
  PetscCall(residual(f, matrix, x, y));
  PetscCall(VecISCopy(f->rest, f->touched, SCATTER_REVERSE, f->inner_rest));
  PetscCall(PCApply(f->direct, f->inner_rest, f->inner_step));
  PetscCall(VecISAXPY(y, f->touched, 1.0, f->inner_step));
  PetscCall(residual(f, matrix, x, y));
  PetscCall(PCApply(f->multigrid, f->rest, f->step));
  PetscCall(VecAXPY(y, 1.0, f->step));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode filtered_attach(PC pc, Mat bodies, MatNullSpace motions, Filtered *f) {
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(f, sizeof *f));
  f->motions = motions;
  f->bodies = bodies;
  PetscCall(PCSetType(pc, PCSHELL));
  PetscCall(PCShellSetContext(pc, f));
  PetscCall(PCShellSetSetUp(pc, set_up));
  PetscCall(PCShellSetApply(pc, apply));
  PetscCall(PCShellSetName(pc, "multigrid with the contact solved directly"));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode filtered_free(Filtered *f) {
  PetscFunctionBeginUser;
  PetscCall(reset(f));
  for (PetscInt level = 1; level < f->level_count; level++) PetscCall(MatDestroy(&f->interpolations[level - 1]));
  PetscCall(PetscFree(f->interpolations));
  f->level_count = 0;
  PetscFunctionReturn(PETSC_SUCCESS);
}
