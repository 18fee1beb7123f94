/* Two blocks in contact and their equilibrium by SNES. */
#ifndef NEWTON_H
#define NEWTON_H
#include "filtered.h"
#include "parts.h"
#include <petscsnes.h>

typedef struct {
  Blocks blocks;
  Parts parts;
  Filtered filtered;
  Mat stiffness, bodies, matrix; /* of the bodies; the same, what is held taken out; that with contact */
  IS held;
  MatNullSpace motions;
  Vec residual;
  PetscReal size; /* its last norm */
  PetscBool is_plain, is_direct; /* multigrid alone, or a direct solver */
  PetscInt touched, krylov; /* unknowns that feel contact, and most iterations */
} Press;

/* Cells along an edge of the lower and of the upper block, width of the upper one, k h / E. */
PetscErrorCode press_create(const PetscInt cells[2], double width, double ratio, Press *press);
/* Solves from the start; the solver, which then can be asked, is the caller's. */
PetscErrorCode press_solve(Press *press, Vec u, SNES *snes);
PetscErrorCode press_free(Press *press);
#endif
