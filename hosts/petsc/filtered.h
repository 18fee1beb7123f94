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
  PC multigrid, direct;
  Vec rest, step, inner_rest, inner_step;
} Filtered;

/* Makes a preconditioner this one. Multigrid takes options with the prefix `multigrid_`. */
PetscErrorCode filtered_attach(PC pc, MatNullSpace motions, Filtered *filtered);
PetscErrorCode filtered_free(Filtered *filtered);
#endif
