#include "blocks.h"

static PetscInt along(const Blocks *b, int block) { return b->cells[block] + 1; }

static PetscInt layer_size(const Blocks *b, int block) { return along(b, block) * along(b, block); }

static PetscInt first_layer(const Blocks *b, int block, int rank) {
  return (PetscInt)((int64_t)along(b, block) * rank / b->ranks);
}

PetscInt blocks_count(const Blocks *b) {
  return along(b, 0) * layer_size(b, 0) + along(b, 1) * layer_size(b, 1);
}

static int block_of(const Blocks *b, int64_t *number) {
  const int64_t of_lower = (int64_t)along(b, 0) * layer_size(b, 0);
  if (*number < of_lower) return 0;
  *number -= of_lower;
  return 1;
}

PetscInt blocks_node(const Blocks *b, int64_t number) {
  const int block = block_of(b, &number);
  const PetscInt layer = (PetscInt)(number / layer_size(b, block));
  int rank = (int)((int64_t)layer * b->ranks / along(b, block));
  while (layer < first_layer(b, block, rank)) rank--;
  while (layer >= first_layer(b, block, rank + 1)) rank++;
  /* Of the other block, what stands before it: on each rank the lower block is first. */
  return first_layer(b, 1 - block, rank + block) * layer_size(b, 1 - block) + (PetscInt)number;
}

PetscBool blocks_held(const Blocks *b, int64_t number, double displacement[3]) {
  const int block = block_of(b, &number);
  const PetscInt height = (PetscInt)(number % along(b, block));
  displacement[0] = displacement[1] = 0.0;
  displacement[2] = block ? -b->down : 0.0;
  return height == (block ? b->cells[1] : 0) ? PETSC_TRUE : PETSC_FALSE;
}

/* The nodes of the layers from `from` to before `to`, from node `at` on. */
static PetscInt add_layers(Blocks *b, int block, PetscInt from, PetscInt to, PetscInt at) {
  const PetscInt n = along(b, block);
  const int64_t before = block ? (int64_t)along(b, 0) * layer_size(b, 0) : 0;
  for (PetscInt i = from; i < to; i++)
    for (PetscInt j = 0; j < n; j++)
      for (PetscInt k = 0; k < n; k++, at++) {
        const PetscInt place[3] = {i, j, k};
        b->numbers[at] = before + ((int64_t)i * n + j) * n + k;
        for (int axis = 0; axis < 3; axis++)
          b->x[3 * at + axis] =
            b->low[block][axis] + (b->high[block][axis] - b->low[block][axis]) * place[axis] / b->cells[block];
      }
  return at;
}

/* Six tetrahedra around the diagonal of each cuboid. */
static const int PATHS[6][4] = {{0, 3, 1, 7}, {0, 2, 3, 7}, {0, 6, 2, 7}, {0, 4, 6, 7}, {0, 5, 4, 7}, {0, 1, 5, 7}};

/* `start` and `next`: where the first of this rank's layers stands, and the one behind its last. */
static void add_cells(Blocks *b, int block, PetscInt start, PetscInt next) {
  const PetscInt n = along(b, block), size = layer_size(b, block);
  const int64_t before = block ? 6 * (int64_t)b->cells[0] * b->cells[0] * b->cells[0] : 0;
  for (PetscInt i = b->first[block]; i < PetscMin(b->last[block], b->cells[block]); i++)
    for (PetscInt j = 0; j < b->cells[block]; j++)
      for (PetscInt k = 0; k < b->cells[block]; k++)
        for (int path = 0; path < 6; path++) {
          const PetscInt cell = b->cell_count++;
          b->cell_numbers[cell] = before + (((int64_t)i * b->cells[block] + j) * b->cells[block] + k) * 6 + path;
          b->bodies[cell] = block;
          for (int c = 0; c < 4; c++) {
            const int corner = PATHS[path][c]; /* bits: along the third, second and first axis */
            const PetscInt layer = i + (corner >> 2);
            const PetscInt at = layer < b->last[block] ? start + (layer - b->first[block]) * size : next;
            b->conn[4 * cell + c] = (int32_t)(at + (j + (corner >> 1 & 1)) * n + k + (corner & 1));
          }
        }
}

PetscErrorCode blocks_create(const PetscInt of_blocks[2], double width, double down, Blocks *b) {
  PetscInt start[2], next[2], nodes = 0, cells = 0;
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(b, sizeof *b));
  PetscCallMPI(MPI_Comm_rank(PETSC_COMM_WORLD, &b->rank));
  PetscCallMPI(MPI_Comm_size(PETSC_COMM_WORLD, &b->ranks));
  b->cells[0] = of_blocks[0], b->cells[1] = of_blocks[1], b->width = width, b->down = down;
  for (int axis = 0; axis < 3; axis++) {
    b->low[0][axis] = 0.0, b->high[0][axis] = 1.0;
    b->low[1][axis] = axis < 2 ? 0.5 * (1.0 - width) : 1.0 - down, b->high[1][axis] = b->low[1][axis] + width;
  }
  for (int block = 0; block < 2; block++) {
    b->first[block] = first_layer(b, block, b->rank), b->last[block] = first_layer(b, block, b->rank + 1);
    nodes += (b->last[block] - b->first[block] + 1) * layer_size(b, block);
    cells += (b->last[block] - b->first[block]) * 6 * b->cells[block] * b->cells[block];
  }
  PetscCall(PetscMalloc2(nodes, &b->numbers, 3 * nodes, &b->x));
  PetscCall(PetscMalloc3(4 * cells, &b->conn, cells, &b->cell_numbers, cells, &b->bodies));
  for (int block = 0; block < 2; block++) {
    start[block] = b->node_count;
    b->node_count = add_layers(b, block, b->first[block], b->last[block], b->node_count);
  }
  b->owned = b->node_count;
  for (int block = 0; block < 2; block++) {
    next[block] = b->node_count;
    if (b->first[block] < b->last[block] && b->last[block] <= b->cells[block])
      b->node_count = add_layers(b, block, b->last[block], b->last[block] + 1, b->node_count);
  }
  for (int block = 0; block < 2; block++) add_cells(b, block, start[block], next[block]);
  PetscFunctionReturn(PETSC_SUCCESS);
}

void blocks_free(Blocks *b) {
  PetscFree2(b->numbers, b->x);
  PetscFree3(b->conn, b->cell_numbers, b->bodies);
}
