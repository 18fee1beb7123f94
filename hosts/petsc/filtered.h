/* Multigrid with the contact solved directly, for elastic bodies in contact.
 *
 * With A the matrix, B a cycle of multigrid for it, P the unknowns that feel contact among all, and S = inverse(P^T A P), the
 * preconditioner M has
 *
 *     I - M A = (I - B A) (I - P S P^T A) (I - B A)
 *
 * Symmetric and positive definite where A and B are. Known as AMG with filtering (arXiv 2505.18576). */
#ifndef FILTERED_H
#define FILTERED_H
#include <petscpc.h>

typedef struct {
  IS touched;           /* unknowns of this rank that feel contact; set before every set-up, NULL for multigrid alone */
  MatNullSpace motions; /* rigid body motions */
  Mat bodies;           /* the matrix without contact, from which the levels of multigrid are found, once */
  PetscInt level_count;
  Mat *interpolations;  /* between levels */
  PC multigrid, direct;
  Vec rest, step, inner_rest, inner_step;
} Filtered;

/* Makes a preconditioner this one. Options with the prefix `levels_` are those of GAMG, which finds the levels, with `multigrid_` those of
 * the cycle. */
PetscErrorCode filtered_attach(PC pc, Mat bodies, MatNullSpace motions, Filtered *filtered);
PetscErrorCode filtered_free(Filtered *filtered);
#endif
