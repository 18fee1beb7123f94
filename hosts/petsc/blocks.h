/* Two blocks of tetrahedra, one on the other, of which every rank makes its own layers alone. */
#ifndef BLOCKS_H
#define BLOCKS_H
#include <petscsys.h>
#include <stdint.h>

#if !defined(PETSC_SUCCESS) && PETSC_VERSION_LT(3, 19, 0)
#define PETSC_SUCCESS ((PetscErrorCode)0)
#endif

/* Nodes have numbers that do not depend on the ranks: the lower block's first, and of each layer after layer along the first
 * axis. A rank owns some layers of nodes of each block, and the cells behind them as far as the next layer. PETSc counts the
 * nodes of rank 0 first. */
typedef struct {
  int rank, ranks;
  PetscInt cells[2];            /* along an edge of each block */
  double low[2][3], high[2][3]; /* corners of the blocks */
  double width, down;           /* of the upper block; by which its top is pressed down */
  PetscInt first[2], last[2];   /* layers of nodes of this rank */
  PetscInt owned, node_count;   /* nodes that this rank owns; those of its cells, the others last */
  int32_t *numbers;             /* of these nodes */
  double *x;                    /* and their places, (nodes, 3) */
  PetscInt cell_count;
  int32_t *conn; /* nodes of the cells, as counted here, (cells, 4) */
  int32_t *cell_numbers;
  int32_t *bodies;
} Blocks;

/* The lower block is a cube of edge 1, the upper one a cube of edge `width` on the middle of it, `down` deep in it. */
PetscErrorCode blocks_create(const PetscInt cells[2], double width, double down, Blocks *blocks);
void blocks_free(Blocks *blocks);
/* All nodes. */
PetscInt blocks_count(const Blocks *blocks);
/* The node of a number, as PETSc counts them. */
PetscInt blocks_node(const Blocks *blocks, int64_t number);
/* Whether a node is held, and where: at the bottom of the lower and the top of the upper block. */
PetscBool blocks_held(const Blocks *blocks, int64_t number, double displacement[3]);
#endif
