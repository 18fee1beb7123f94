/* Contact of a mesh that the ranks have in parts: each takes the forces and the rows of the tangent that it owns. */
#ifndef PARTS_H
#define PARTS_H
#include "blocks.h"
#include <fmc_contact.h>
#include <petscmat.h>

typedef struct {
  const Blocks *blocks;
  fmc_context *context;
  MPI_Comm ranks;     /* those that share the work of the contact */
  Vec ghosted;        /* displacement of the rank's own nodes, those that it owns first */
  double *own_x;      /* their current places, (nodes, 3) */
  size_t count;       /* nodes gathered, the same on all ranks */
  int32_t *numbers;   /* of these */
  double *x, *force;  /* their places and forces, (nodes, 3) */
  double size;        /* norm of the forces */
} Parts;

typedef struct {
  PetscInt own_cells, received_cells; /* of this rank, and those of others that it has */
  fmc_gathered_counts gathered;       /* facets and cells that every rank has */
  fmc_rank_counts work;               /* calls of the communicator, bytes */
} PartsCounts;

PetscErrorCode parts_create(const Blocks *blocks, double stiffness, Parts *parts);
PetscErrorCode parts_keep_patches(Parts *parts, Vec u);
/* Evaluates at a displacement; subtracts the forces from what this rank owns of a residual. */
PetscErrorCode parts_evaluate(Parts *parts, Vec u, Vec residual);
/* The tangent, without what is held; and the rows of this rank that feel contact. */
PetscErrorCode parts_tangent(Parts *parts, Vec u, PetscBool semidefinite, Mat *tangent, IS *touched);
/* What this rank has of the mesh, and what that took so far. */
PetscErrorCode parts_counts(const Parts *parts, PartsCounts *counts);
PetscErrorCode parts_free(Parts *parts);
#endif
