#include "parts.h"
#include <fmc_mpi.h>

/* A failure on one rank fails all of them, since one that left alone would keep the others waiting. */
static PetscErrorCode together(fmc_status status) {
  int worst, mine = status;
  PetscFunctionBeginUser;
  PetscCallMPI(MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD));
  PetscCheck(worst == FMC_OK, PETSC_COMM_WORLD, PETSC_ERR_LIB, "%s: %s", fmc_status_name(worst), fmc_last_error());
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode read_nodes(Parts *p) {
  PetscFunctionBeginUser;
  PetscCall(PetscFree3(p->numbers, p->x, p->force));
  PetscCall(together(fmc_context_counts(p->context, &p->count, NULL, NULL)));
  PetscCall(PetscMalloc3(p->count, &p->numbers, 3 * p->count, &p->x, 3 * p->count, &p->force));
  PetscCall(together(fmc_context_gathered_nodes(p->context, p->numbers, NULL, p->x, p->count, NULL)));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode parts_create(const Blocks *b, double stiffness, Parts *p) {
  const fmc_cell_block block = {FMC_TET4, 4, b->conn, b->cell_count};
  fmc_mesh_part part;
  fmc_communicator ranks;
  fmc_options options;
  PetscInt *ghosts;
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(p, sizeof *p));
  p->blocks = b;
  PetscCall(together(fmc_mesh_part_init(&part)));
  part.coords = (fmc_coords){b->x, b->node_count, 0, 0};
  part.index_size = sizeof *b->conn;
  part.node_numbers = b->numbers, part.cell_numbers = b->cell_numbers, part.body_ids = b->bodies;
  part.blocks = &block, part.block_count = 1;
  PetscCall(together(fmc_options_init(&options)));
  options.law = FMC_LAW_FIBER;
  options.stiffness = stiffness;
  PetscCallMPI(MPI_Comm_dup(PETSC_COMM_WORLD, &p->ranks));
  PetscCallMPI(fmc_mpi_communicator(&p->ranks, &ranks));
  PetscCall(together(fmc_context_new_from_part(3, &ranks, &part, &options, &p->context)));
  PetscCall(PetscMalloc1(b->node_count - b->owned, &ghosts));
  for (PetscInt n = b->owned; n < b->node_count; n++) ghosts[n - b->owned] = blocks_node(b, b->numbers[n]);
  PetscCall(VecCreateGhostBlock(PETSC_COMM_WORLD, 3, 3 * b->owned, PETSC_DETERMINE, b->node_count - b->owned, ghosts,
                                &p->ghosted));
  PetscCall(PetscFree(ghosts));
  PetscCall(PetscMalloc1(3 * b->node_count, &p->own_x));
  PetscCall(read_nodes(p));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Brings the contact to a displacement. */
static PetscErrorCode bring(Parts *p, Vec u) {
  const PetscInt count = p->blocks->node_count;
  const PetscScalar *at;
  Vec local;
  PetscFunctionBeginUser;
  PetscCall(VecCopy(u, p->ghosted));
  PetscCall(VecGhostUpdateBegin(p->ghosted, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecGhostUpdateEnd(p->ghosted, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecGhostGetLocalForm(p->ghosted, &local));
  PetscCall(VecGetArrayRead(local, &at));
  for (PetscInt i = 0; i < 3 * count; i++) p->own_x[i] = p->blocks->x[i] + at[i];
  PetscCall(VecRestoreArrayRead(local, &at));
  PetscCall(VecGhostRestoreLocalForm(p->ghosted, &local));
  PetscCall(together(fmc_context_set_coords(p->context, &(fmc_coords){p->own_x, count, 0, 0}, NULL)));
  PetscCall(read_nodes(p));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode parts_keep_patches(Parts *p, Vec u) {
  PetscFunctionBeginUser;
  PetscCall(bring(p, u));
  PetscCall(together(fmc_context_keep_patches(p->context, &(fmc_coords){p->x, p->count, 0, 0}, NULL)));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* The first row of a node gathered, counted from this rank's first; -1 where another rank owns it, or it is held. */
static PetscInt own_row(const Parts *p, size_t node, PetscInt first, PetscInt last) {
  double at[3];
  const PetscInt row = 3 * blocks_node(p->blocks, p->numbers[node]);
  return row >= first && row < last && !blocks_held(p->blocks, p->numbers[node], at) ? row - first : -1;
}

PetscErrorCode parts_evaluate(Parts *p, Vec u, Vec residual) {
  PetscInt first, last;
  PetscScalar *r;
  PetscFunctionBeginUser;
  PetscCall(bring(p, u));
  const fmc_forces forces = {p->force, p->count, 0, 0};
  PetscCall(together(fmc_context_evaluate(p->context, &(fmc_coords){p->x, p->count, 0, 0}, &forces, 0, NULL)));
  PetscCall(VecGetOwnershipRange(residual, &first, &last));
  PetscCall(VecGetArray(residual, &r));
  p->size = 0;
  for (size_t n = 0; n < p->count; n++) {
    const PetscInt row = own_row(p, n, first, last);
    for (int axis = 0; axis < 3; axis++) {
      const double force = p->force[3 * n + axis];
      p->size += force * force;
      if (row >= 0) r[row + axis] -= force;
    }
  }
  p->size = PetscSqrtReal(p->size);
  PetscCall(VecRestoreArray(residual, &r));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Adds a row of blocks, of which each stands by itself, those of held nodes left out. */
static PetscErrorCode add_row(const Parts *p, PetscInt node, const int32_t *cols, const double *blocks, int32_t count, Mat to) {
  PetscInt *at, used = 0;
  double *row, held[3];
  PetscFunctionBeginUser;
  PetscCall(PetscMalloc2(count, &at, 9 * count, &row));
  for (int32_t e = 0; e < count; e++)
    if (!blocks_held(p->blocks, p->numbers[cols[e]], held)) at[used++] = e;
  for (PetscInt e = 0; e < used; e++) {
    for (int i = 0; i < 3; i++)
      for (int k = 0; k < 3; k++) row[i * 3 * used + 3 * e + k] = blocks[9 * at[e] + 3 * i + k];
    at[e] = blocks_node(p->blocks, p->numbers[cols[at[e]]]);
  }
  PetscCall(MatSetValuesBlocked(to, 1, &node, used, at, row, INSERT_VALUES));
  PetscCall(PetscFree2(at, row));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode parts_tangent(Parts *p, Vec u, PetscBool semidefinite, Mat *tangent, IS *touched) {
  size_t room, entries;
  int32_t *offsets, *cols;
  double *values;
  PetscInt first, last, *counts, *found, count = 0;
  PetscFunctionBeginUser;
  PetscCall(bring(p, u));
  const fmc_coords coords = {p->x, p->count, 0, 0};
  PetscCall(together(fmc_context_tangent(p->context, &coords, semidefinite ? FMC_TANGENT_SEMIDEFINITE : 0, NULL)));
  PetscCall(together(fmc_context_tangent_csr(p->context, FMC_CSR_BLOCKS, NULL, 0, &room, NULL, NULL, 0, &entries)));
  PetscCall(PetscMalloc3(room, &offsets, entries, &cols, 9 * entries, &values));
  PetscCall(together(fmc_context_tangent_csr(p->context, FMC_CSR_BLOCKS, offsets, room, NULL, cols, values, entries, NULL)));
  const size_t rows = room - 1;
  PetscCall(VecGetOwnershipRange(u, &first, &last));
  PetscCall(PetscCalloc1(last - first, &counts));
  PetscCall(PetscMalloc1(3 * rows, &found));
  for (size_t n = 0; n < rows; n++) {
    const PetscInt row = own_row(p, n, first, last);
    if (row < 0 || offsets[n] == offsets[n + 1]) continue;
    for (int axis = 0; axis < 3; axis++) {
      counts[row + axis] = 3 * (offsets[n + 1] - offsets[n]);
      found[count++] = first + row + axis;
    }
  }
  PetscCall(MatCreate(PETSC_COMM_WORLD, tangent));
  PetscCall(MatSetSizes(*tangent, last - first, last - first, PETSC_DETERMINE, PETSC_DETERMINE));
  PetscCall(MatSetBlockSize(*tangent, 3));
  PetscCall(MatSetType(*tangent, MATAIJ));
  PetscCall(MatSeqAIJSetPreallocation(*tangent, 0, counts));
  PetscCall(MatMPIAIJSetPreallocation(*tangent, 0, counts, 0, counts));
  for (size_t n = 0; n < rows; n++) {
    const PetscInt row = own_row(p, n, first, last);
    const int32_t start = offsets[n], size = offsets[n + 1] - offsets[n];
    if (row >= 0 && size) PetscCall(add_row(p, (first + row) / 3, cols + start, values + 9 * (size_t)start, size, *tangent));
  }
  PetscCall(MatAssemblyBegin(*tangent, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(*tangent, MAT_FINAL_ASSEMBLY));
  PetscCall(PetscSortInt(count, found));
  PetscCall(ISCreateGeneral(PETSC_COMM_WORLD, count, found, PETSC_COPY_VALUES, touched));
  PetscCall(PetscFree3(offsets, cols, values));
  PetscCall(PetscFree(counts));
  PetscCall(PetscFree(found));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode parts_counts(const Parts *p, PartsCounts *counts) {
  int32_t *cells;
  PetscFunctionBeginUser;
  PetscCall(together(fmc_context_rank_counts(p->context, &counts->work)));
  PetscCall(together(fmc_context_gathered_counts(p->context, &counts->gathered)));
  const uint64_t own = counts->gathered.own_cell_count, count = counts->gathered.cell_count;
  PetscCall(PetscMalloc1(count, &cells));
  PetscCall(together(fmc_context_gathered_cells(p->context, cells, count, NULL)));
  counts->own_cells = (PetscInt)own, counts->received_cells = (PetscInt)count;
  /* Both ascend. */
  for (uint64_t at = 0, cell = 0; at < count && cell < own;)
    if (cells[at] == p->blocks->cell_numbers[cell]) at++, cell++, counts->received_cells--;
    else if (cells[at] < p->blocks->cell_numbers[cell]) at++;
    else cell++;
  PetscCall(PetscFree(cells));
  PetscFunctionReturn(PETSC_SUCCESS);
}

PetscErrorCode parts_free(Parts *p) {
  PetscFunctionBeginUser;
  fmc_context_free(&p->context);
  PetscCallMPI(MPI_Comm_free(&p->ranks));
  PetscCall(VecDestroy(&p->ghosted));
  PetscCall(PetscFree(p->own_x));
  PetscCall(PetscFree3(p->numbers, p->x, p->force));
  PetscFunctionReturn(PETSC_SUCCESS);
}
