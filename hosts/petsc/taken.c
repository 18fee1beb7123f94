#define _XOPEN_SOURCE 700
#include "taken.h"
#include <sys/resource.h>

/* PETSc's own figure is the largest of those at which it looked, the system's is the largest. */
PetscErrorCode taken_so_far(Taken *taken) {
  struct rusage usage;
  PetscFunctionBeginUser;
  PetscCheck(getrusage(RUSAGE_SELF, &usage) == 0, PETSC_COMM_SELF, PETSC_ERR_SYS, "getrusage");
  const struct timeval user = usage.ru_utime, system = usage.ru_stime;
  taken->seconds = (double)(user.tv_sec + system.tv_sec) + 1e-6 * (double)(user.tv_usec + system.tv_usec);
#ifdef __APPLE__
  taken->megabytes = 1e-6 * (double)usage.ru_maxrss;
#else
  taken->megabytes = 1.024e-3 * (double)usage.ru_maxrss;
#endif
  PetscFunctionReturn(PETSC_SUCCESS);
}
