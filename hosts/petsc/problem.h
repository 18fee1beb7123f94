/* A body of linear elastic triangles on rigid half-spaces, as the table that benchmarks/agreement writes (plain.py). */
#ifndef PROBLEM_H
#define PROBLEM_H
#include <petscsys.h>
#include <stdint.h>

#if !defined(PETSC_SUCCESS) && PETSC_VERSION_LT(3, 19, 0)
#define PETSC_SUCCESS ((PetscErrorCode)0)
#endif

typedef struct {
  int node_count, triangle_count, held_count, face_count, half_space_count;
  double (*x)[2];          /* undeformed coordinates */
  int32_t (*triangles)[3]; /* nodes, counter-clockwise */
  int *held;               /* degrees of freedom, node * 2 + axis */
  double *held_at;         /* their displacements */
  int (*faces)[2];
  double (*traction)[2];   /* of every face */
  double lame, shear;      /* Pa */
  double stiffness;        /* of the contact, Pa/m; 0: the search finds it */
  double tolerance;        /* of the residual, by the load */
  double (*half_spaces)[4]; /* a point and the outward normal */
} Problem;

/* Every rank reads the whole file. */
PetscErrorCode problem_read(const char *path, Problem *problem);
void problem_free(Problem *problem);
#endif
