/* Linear elastic bodies as a search for an equilibrium asks of them: forces, products and solutions, by PETSc. Vectors of the search are
 * whole on every rank, with the same bits; those of PETSc are divided. */
#ifndef BODIES_H
#define BODIES_H
#include "touch.h"
#include <petscksp.h>

typedef struct {
  Mat stiffness;
  KSP ksp;
  Vec divided, found;        /* what goes into a matrix, and what comes out of it */
  Vec all;                   /* that on every rank */
  VecScatter to_all;
  IS held;                   /* rows of this rank that are held */
  double *load;              /* whole */
} Bodies;

/* Takes the matrix and the load. */
PetscErrorCode bodies_create(const Problem *problem, Mat stiffness, Vec load, Bodies *bodies);
/* What a request asks for; `is_there` where there is such. */
PetscErrorCode bodies_answer(Bodies *bodies, Touch *touch, const fmc_equilibrium_request *request, double *found, double *energy,
                             PetscBool *is_there);
PetscErrorCode bodies_free(Bodies *bodies);
#endif
