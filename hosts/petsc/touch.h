/* Contact of the whole body on every rank: all find it together, and each takes the rows of the tangent that it owns. */
#ifndef TOUCH_H
#define TOUCH_H
#include "problem.h"
#include <fmc_contact.h>
#include <petscmat.h>

typedef struct {
  const Problem *problem;
  fmc_context *context;
  MPI_Comm ranks;     /* those that share the work of the contact */
  double *x;          /* current coordinates, (nodes, 2) */
  double seconds;     /* spent in the contact */
} Touch;

/* Processor time of this process, s. */
double processor_seconds(void);

/* Makes a failure on one rank one of all of them, since one that left alone would keep the others waiting. */
PetscErrorCode together(fmc_status status);

PetscErrorCode touch_create(const Problem *problem, Touch *touch);
/* Forces at the displacement of all nodes, the same on every rank. */
PetscErrorCode touch_evaluate(Touch *touch, const double *u, double *forces);
/* Adds the tangent there, with flags of `fmc_context_tangent`. */
PetscErrorCode touch_add_tangent(Touch *touch, const double *u, uint32_t flags, Mat matrix);
PetscErrorCode touch_free(Touch *touch);
#endif
