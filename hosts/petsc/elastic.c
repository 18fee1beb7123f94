#include "elastic.h"

/* With gradients g_a of the shape functions, K_ai,bk = A (lame g_ai g_bk + shear (g_ak g_bi + g_a.g_b d_ik)). */
static void cell_matrix(const Problem *p, int cell, double matrix[36]) {
  const int32_t *n = p->triangles[cell];
  double gradient[3][2], twice_area = 0;
  for (int a = 0; a < 3; a++) {
    const double *next = p->x[n[(a + 1) % 3]], *last = p->x[n[(a + 2) % 3]];
    gradient[a][0] = next[1] - last[1];
    gradient[a][1] = last[0] - next[0];
    twice_area += p->x[n[a]][0] * gradient[a][0];
  }
  for (int a = 0; a < 3; a++)
    for (int i = 0; i < 2; i++) gradient[a][i] /= twice_area;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      const double dot = gradient[a][0] * gradient[b][0] + gradient[a][1] * gradient[b][1];
      for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
          matrix[(2 * a + i) * 6 + 2 * b + k] =
            0.5 * twice_area * (p->lame * gradient[a][i] * gradient[b][k] +
                                p->shear * (gradient[a][k] * gradient[b][i] + (i == k ? dot : 0)));
    }
}

PetscErrorCode elastic_stiffness(const Problem *p, Mat *stiffness) {
  PetscInt first, last;
  double matrix[36];
  PetscFunctionBeginUser;
  PetscCall(MatCreate(PETSC_COMM_WORLD, stiffness));
  PetscCall(MatSetSizes(*stiffness, PETSC_DECIDE, PETSC_DECIDE, 2 * p->node_count, 2 * p->node_count));
  PetscCall(MatSetBlockSize(*stiffness, 2));
  PetscCall(MatSetType(*stiffness, MATAIJ));
  /* A node of a mesh of triangles has six neighbours, and seldom more than twelve. */
  PetscCall(MatSeqAIJSetPreallocation(*stiffness, 26, NULL));
  PetscCall(MatMPIAIJSetPreallocation(*stiffness, 26, NULL, 26, NULL));
  PetscCall(MatSetOption(*stiffness, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
  PetscCall(MatGetOwnershipRange(*stiffness, &first, &last));
  for (int cell = 0; cell < p->triangle_count; cell++) {
    const int32_t *n = p->triangles[cell];
    if (2 * n[0] < first || 2 * n[0] >= last) continue;
    const PetscInt at[3] = {n[0], n[1], n[2]};
    cell_matrix(p, cell, matrix);
    PetscCall(MatSetValuesBlocked(*stiffness, 3, at, 3, at, matrix, ADD_VALUES));
  }
  PetscCall(MatAssemblyBegin(*stiffness, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(*stiffness, MAT_FINAL_ASSEMBLY));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode elastic_load(const Problem *p, Vec load) {
  PetscInt first, last;
  PetscFunctionBeginUser;
  PetscCall(VecGetOwnershipRange(load, &first, &last));
  for (int f = 0; f < p->face_count; f++) {
    const double *a = p->x[p->faces[f][0]], *b = p->x[p->faces[f][1]];
    const double half = 0.5 * PetscSqrtReal((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
    for (int k = 0; k < 2; k++)
      for (int axis = 0; axis < 2; axis++) {
        const PetscInt row = 2 * p->faces[f][k] + axis;
        if (row >= first && row < last) PetscCall(VecSetValue(load, row, half * p->traction[f][axis], ADD_VALUES));
      }
  }
  PetscCall(VecAssemblyBegin(load));
  PetscCall(VecAssemblyEnd(load));
  PetscFunctionReturn(PETSC_SUCCESS);
}
