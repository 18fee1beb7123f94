/* What a process takes. */
#ifndef TAKEN_H
#define TAKEN_H
#include <petscsys.h>

#if !defined(PETSC_SUCCESS) && PETSC_VERSION_LT(3, 19, 0)
#define PETSC_SUCCESS ((PetscErrorCode)0)
#endif

typedef struct {
  double seconds;   /* of a processor */
  double megabytes; /* the most that were in memory at once, libraries too */
} Taken;

PetscErrorCode taken_so_far(Taken *taken);
#endif
