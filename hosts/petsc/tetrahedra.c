#include "tetrahedra.h"

/* With gradients g_a of the shape functions and volume V, K_ai,bk = V (lame g_ai g_bk + shear (g_ak g_bi + g_a.g_b d_ik)). */
static void cell_matrix(const double *const x[4], double lame, double shear, double matrix[144]) {
  double edge[3][3], gradient[4][3], six_volumes = 0;
  for (int e = 0; e < 3; e++)
    for (int i = 0; i < 3; i++) edge[e][i] = x[e + 1][i] - x[0][i];
  for (int e = 0; e < 3; e++) {
    const double *a = edge[(e + 1) % 3], *b = edge[(e + 2) % 3];
    for (int i = 0; i < 3; i++) gradient[e + 1][i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
  }
  for (int i = 0; i < 3; i++) six_volumes += edge[0][i] * gradient[1][i];
  for (int i = 0; i < 3; i++) {
    gradient[0][i] = 0;
    for (int a = 1; a < 4; a++) gradient[0][i] -= gradient[a][i] /= six_volumes;
  }
  for (int a = 0; a < 4; a++)
    for (int b = 0; b < 4; b++) {
      double dot = 0;
      for (int i = 0; i < 3; i++) dot += gradient[a][i] * gradient[b][i];
      for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
          matrix[(3 * a + i) * 12 + 3 * b + k] =
            six_volumes / 6 * (lame * gradient[a][i] * gradient[b][k] +
                               shear * (gradient[a][k] * gradient[b][i] + (i == k ? dot : 0)));
    }
}

/* A node has itself and 14 neighbours, up to seven of them in the layer before, and seven in the one behind. */
static PetscErrorCode preallocate(const Blocks *b, Mat stiffness) {
  PetscInt *here, *elsewhere, row = 0;
  PetscFunctionBeginUser;
  PetscCall(PetscMalloc2(3 * b->owned, &here, 3 * b->owned, &elsewhere));
  for (int block = 0; block < 2; block++) {
    const PetscInt along = b->cells[block] + 1;
    for (PetscInt layer = b->first[block]; layer < b->last[block]; layer++) {
      const PetscInt outside = (layer == b->first[block] && layer > 0 ? 4 : 0) +
                               (layer == b->last[block] - 1 && layer < along - 1 ? 4 : 0);
      for (PetscInt k = 0; k < 3 * along * along; k++, row++) here[row] = 45, elsewhere[row] = 3 * outside;
    }
  }
  PetscCall(MatSeqAIJSetPreallocation(stiffness, 0, here));
  PetscCall(MatMPIAIJSetPreallocation(stiffness, 0, here, 0, elsewhere));
  PetscCall(PetscFree2(here, elsewhere));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode tetrahedra_stiffness(const Blocks *b, double young, double poisson, Mat *stiffness) {
  const double shear = young / 2 / (1 + poisson), lame = young * poisson / (1 + poisson) / (1 - 2 * poisson);
  PetscInt *node;
  double matrix[144];
  PetscFunctionBeginUser;
  PetscCall(MatCreate(PETSC_COMM_WORLD, stiffness));
  PetscCall(MatSetSizes(*stiffness, 3 * b->owned, 3 * b->owned, PETSC_DETERMINE, PETSC_DETERMINE));
  PetscCall(MatSetBlockSize(*stiffness, 3));
  PetscCall(MatSetType(*stiffness, MATAIJ));
  PetscCall(preallocate(b, *stiffness));
  PetscCall(PetscMalloc1(b->node_count, &node));
  for (PetscInt n = 0; n < b->node_count; n++) node[n] = blocks_node(b, b->numbers[n]);
  for (PetscInt cell = 0; cell < b->cell_count; cell++) {
    const int32_t *n = b->conn + 4 * cell;
    const double *const x[4] = {b->x + 3 * n[0], b->x + 3 * n[1], b->x + 3 * n[2], b->x + 3 * n[3]};
    const PetscInt at[4] = {node[n[0]], node[n[1]], node[n[2]], node[n[3]]};
    cell_matrix(x, lame, shear, matrix);
    PetscCall(MatSetValuesBlocked(*stiffness, 4, at, 4, at, matrix, ADD_VALUES));
  }
  PetscCall(PetscFree(node));
  PetscCall(MatAssemblyBegin(*stiffness, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(*stiffness, MAT_FINAL_ASSEMBLY));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode tetrahedra_rigid_motions(const Blocks *b, MatNullSpace *motions) {
  Vec coords;
  PetscScalar *x;
  PetscFunctionBeginUser;
  PetscCall(VecCreate(PETSC_COMM_WORLD, &coords));
  PetscCall(VecSetSizes(coords, 3 * b->owned, PETSC_DETERMINE));
  PetscCall(VecSetBlockSize(coords, 3));
  PetscCall(VecSetType(coords, VECSTANDARD));
  PetscCall(VecGetArrayWrite(coords, &x));
  PetscCall(PetscArraycpy(x, b->x, 3 * b->owned));
  PetscCall(VecRestoreArrayWrite(coords, &x));
  PetscCall(MatNullSpaceCreateRigidBody(coords, motions));
  PetscCall(VecDestroy(&coords));
  PetscFunctionReturn(PETSC_SUCCESS);
}
