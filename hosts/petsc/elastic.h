/* Stiffness and load of linear elastic triangles, in plane strain. */
#ifndef ELASTIC_H
#define ELASTIC_H
#include "problem.h"
#include <petscmat.h>

/* Each rank adds the cells whose first node it owns. */
PetscErrorCode elastic_stiffness(const Problem *problem, Mat *stiffness);
PetscErrorCode elastic_load(const Problem *problem, Vec load);
#endif
