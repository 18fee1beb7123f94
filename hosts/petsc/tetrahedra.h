/* Stiffness of linear elastic tetrahedra, each rank adding its own. */
#ifndef TETRAHEDRA_H
#define TETRAHEDRA_H
#include "blocks.h"
#include <petscmat.h>

PetscErrorCode tetrahedra_stiffness(const Blocks *blocks, double young, double poisson, Mat *stiffness);
/* The rigid body motions of all nodes, which multigrid is told. */
PetscErrorCode tetrahedra_rigid_motions(const Blocks *blocks, MatNullSpace *motions);
#endif
