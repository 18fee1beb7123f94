/* Contact of the whole body on every rank: each takes the forces and the rows of the tangent that it owns. */
#ifndef TOUCH_H
#define TOUCH_H
#include "problem.h"
#include <fmc_contact.h>
#include <petscmat.h>

typedef struct {
  const Problem *problem;
  fmc_context *context;
  fmc_options options;
  MPI_Comm ranks;     /* those that share the work of the contact */
  Vec all;            /* displacement of all nodes, on every rank */
  VecScatter scatter; /* to it */
  double *x, *force;  /* current coordinates and forces, (nodes, 2) */
  double seconds;     /* spent in the contact */
  char *is_held;      /* of every degree of freedom */
} Touch;

/* Processor time of this process, s. */
double processor_seconds(void);

PetscErrorCode touch_create(const Problem *problem, Vec like, Touch *touch);
PetscErrorCode touch_stiffness(Touch *touch, double stiffness);
PetscErrorCode touch_keep_patches(Touch *touch, Vec u);
/* Evaluates; subtracts the forces from what this rank owns of a residual, if there is one. */
PetscErrorCode touch_evaluate(Touch *touch, Vec u, Vec residual);
PetscErrorCode touch_add_tangent(Touch *touch, Vec u, PetscBool semidefinite, Mat matrix);
PetscErrorCode touch_free(Touch *touch);
#endif
