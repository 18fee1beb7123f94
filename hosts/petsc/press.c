/* Two elastic blocks pressed on each other, by SNES with conjugate gradients, on any number of ranks of which none has the whole
 * mesh.
 *
 *     mpirun -n 4 ./press -cells 14 -ratio 100
 *
 * -cells: along an edge of the lower block; -upper: of the upper one, by itself two less; -width: of the upper block, of a lower
 * one of 1. -ratio: k h / E, the stiffness of the contact beside that of a layer of cells.
 * -plain: multigrid without the direct solve on the contact. -direct: a direct solver. -check: solves directly too, and says how far
 * the two are apart, and how far the preconditioner is from symmetric.
 *
 * Prints a row: unknowns, ranks, ratio, unknowns that feel contact, steps of Newton's method, most Krylov iterations of a step, force,
 * seconds of a processor; then for each rank its cells, those received, the facets that it has near the contact among all of the
 * mesh, calls and bytes of the communicator, and the most memory that it took. */
#include "newton.h"
#include "taken.h"
#include <inttypes.h>

/* How far v.(M w) and w.(M v) are apart, beside the energies of both. */
static PetscErrorCode check_symmetry(SNES snes, Vec like) {
  KSP ksp;
  PC pc;
  PetscRandom random;
  Vec v[2], m[2];
  PetscScalar product[2][2];
  PetscFunctionBeginUser;
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PetscRandomCreate(PETSC_COMM_WORLD, &random));
  for (int k = 0; k < 2; k++) {
    PetscCall(VecDuplicate(like, &v[k]));
    PetscCall(VecDuplicate(like, &m[k]));
    PetscCall(VecSetRandom(v[k], random));
    PetscCall(VecShift(v[k], -0.5));
    PetscCall(PCApply(pc, v[k], m[k]));
  }
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 2; k++) PetscCall(VecDot(v[i], m[k], &product[i][k]));
  const double size = PetscSqrtReal(product[0][0] * product[1][1]);
  PetscCall(PetscPrintf(PETSC_COMM_WORLD, "asymmetry %.1e, least energy %.1e\n",
                        PetscAbsReal(product[0][1] - product[1][0]) / size, PetscMin(product[0][0], product[1][1])));
  for (int k = 0; k < 2; k++) {
    PetscCall(VecDestroy(&v[k]));
    PetscCall(VecDestroy(&m[k]));
  }
  PetscCall(PetscRandomDestroy(&random));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* The displacement by a direct solver, and how far u is from it. */
static PetscErrorCode check_direct(Press *h, Vec u) {
  Vec direct;
  SNES snes;
  PetscReal apart, size;
  PetscFunctionBeginUser;
  PetscCall(VecDuplicate(u, &direct));
  h->is_direct = PETSC_TRUE;
  PetscCall(press_solve(h, direct, &snes));
  PetscCall(SNESDestroy(&snes));
  PetscCall(VecNorm(direct, NORM_INFINITY, &size));
  PetscCall(VecAXPY(direct, -1.0, u));
  PetscCall(VecNorm(direct, NORM_INFINITY, &apart));
  PetscCall(PetscPrintf(PETSC_COMM_WORLD, "apart from the direct solution by %.1e of it\n", apart / size));
  PetscCall(VecDestroy(&direct));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Force on the upper block along the third axis: of the nodes that ranks own, so that each counts once. */
static PetscErrorCode print(Press *h, double ratio, PetscInt steps) {
  const int64_t of_lower = (int64_t)(h->blocks.cells[0] + 1) * (h->blocks.cells[0] + 1) * (h->blocks.cells[0] + 1);
  double force = 0;
  PartsCounts counts;
  Taken taken;
  PetscFunctionBeginUser;
  for (size_t n = 0; n < h->parts.count; n++)
    if (h->parts.numbers[n] >= of_lower) force += h->parts.force[3 * n + 2];
  PetscCall(taken_so_far(&taken));
  double seconds = taken.seconds;
  PetscCallMPI(MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD));
  PetscCall(PetscPrintf(PETSC_COMM_WORLD, "| %" PetscInt_FMT " | %d | %s | %g | %" PetscInt_FMT " | %" PetscInt_FMT
                        " | %" PetscInt_FMT " | %.15g | %.1f |\n", 3 * blocks_count(&h->blocks), h->blocks.ranks,
                        h->is_direct ? "direct" : h->is_plain ? "multigrid" : "filtered", ratio, h->touched, steps, h->krylov,
                        force, seconds));
  PetscCall(parts_counts(&h->parts, &counts));
  PetscCall(PetscSynchronizedPrintf(
    PETSC_COMM_WORLD,
    "rank %d: %" PetscInt_FMT " own cells, %" PetscInt_FMT " received, %" PRIu64 " of %" PRIu64 " facets, %" PRIu64 " calls, %" PRIu64
    " bytes received, %.0f MB\n",
    h->blocks.rank, counts.own_cells, counts.received_cells, counts.gathered.facet_count, counts.gathered.whole_facet_count,
    counts.work.call_count, counts.work.received_bytes, taken.megabytes));
  PetscCall(PetscSynchronizedFlush(PETSC_COMM_WORLD, PETSC_STDOUT));
  PetscFunctionReturn(PETSC_SUCCESS);
}

int main(int argc, char **argv) {
  Press press;
  Vec u;
  SNES snes;
  PetscInt cells[2] = {14, 0}, steps;
  PetscReal ratio = 100.0, width = 0.8;
  PetscBool is_plain = PETSC_FALSE, is_direct = PETSC_FALSE, check = PETSC_FALSE;
  PetscCall(PetscInitialize(&argc, &argv, NULL, NULL));
  PetscCall(PetscOptionsGetInt(NULL, NULL, "-cells", &cells[0], NULL));
  cells[1] = PetscMax(cells[0] - 2, 2);
  PetscCall(PetscOptionsGetInt(NULL, NULL, "-upper", &cells[1], NULL));
  PetscCall(PetscOptionsGetReal(NULL, NULL, "-width", &width, NULL));
  PetscCall(PetscOptionsGetReal(NULL, NULL, "-ratio", &ratio, NULL));
  PetscCall(PetscOptionsGetBool(NULL, NULL, "-plain", &is_plain, NULL));
  PetscCall(PetscOptionsGetBool(NULL, NULL, "-direct", &is_direct, NULL));
  PetscCall(PetscOptionsGetBool(NULL, NULL, "-check", &check, NULL));
  PetscCall(press_create(cells, width, ratio, &press));
  press.is_plain = is_plain, press.is_direct = is_direct;
  PetscCall(MatCreateVecs(press.stiffness, &u, NULL));
  PetscCall(press_solve(&press, u, &snes));
  PetscCall(SNESGetIterationNumber(snes, &steps));
  PetscCall(print(&press, ratio, steps));
  if (check && !is_direct) {
    PetscCall(check_symmetry(snes, u));
    PetscCall(SNESDestroy(&snes));
    PetscCall(check_direct(&press, u));
  } else PetscCall(SNESDestroy(&snes));
  PetscCall(VecDestroy(&u));
  PetscCall(press_free(&press));
  PetscCall(PetscFinalize());
  return 0;
}
