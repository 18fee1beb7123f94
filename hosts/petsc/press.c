/* Two elastic blocks pressed on each other, by SNES with conjugate gradients, on any number of ranks of which none has the whole
 * mesh.
 *
 *     mpirun -n 4 ./press -cells 14 -ratio 100
 *
 * -cells: along an edge of the lower block. -ratio: k h / E, the stiffness of the contact beside that of a layer of cells.
 * -plain: multigrid without the direct solve on the contact. -direct: a direct solver. -check: solves directly too, and says how far
 * the two are apart, and how far the preconditioner is from symmetric.
 *
 * Prints a row: unknowns, ranks, ratio, unknowns that feel contact, steps of Newton's method, most Krylov iterations of a step, force,
 * seconds; then what each rank has of the mesh. */
#include "newton.h"
#include <petsctime.h>

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
static PetscErrorCode print(Press *h, double ratio, PetscInt steps, double seconds) {
  const int64_t of_lower = (int64_t)(h->blocks.cells[0] + 1) * (h->blocks.cells[0] + 1) * (h->blocks.cells[0] + 1);
  double force = 0;
  PetscInt own, received;
  PetscFunctionBeginUser;
  for (size_t n = 0; n < h->parts.count; n++)
    if (h->parts.numbers[n] >= of_lower) force += h->parts.force[3 * n + 2];
  PetscCall(PetscPrintf(PETSC_COMM_WORLD, "| %" PetscInt_FMT " | %d | %s | %g | %" PetscInt_FMT " | %" PetscInt_FMT
                        " | %" PetscInt_FMT " | %.15g | %.1f |\n", 3 * blocks_count(&h->blocks), h->blocks.ranks,
                        h->is_direct ? "direct" : h->is_plain ? "multigrid" : "filtered", ratio, h->touched, steps, h->krylov,
                        force, seconds));
  PetscCall(parts_counts(&h->parts, &own, &received));
  PetscCall(PetscSynchronizedPrintf(PETSC_COMM_WORLD, "rank %d: %" PetscInt_FMT " own cells, %" PetscInt_FMT " received\n",
                                    h->blocks.rank, own, received));
  PetscCall(PetscSynchronizedFlush(PETSC_COMM_WORLD, PETSC_STDOUT));
  PetscFunctionReturn(PETSC_SUCCESS);
}

int main(int argc, char **argv) {
  Press press;
  Vec u;
  SNES snes;
  PetscInt cells = 14, steps;
  PetscReal ratio = 100.0;
  PetscBool is_plain = PETSC_FALSE, is_direct = PETSC_FALSE, check = PETSC_FALSE;
  PetscLogDouble begin, end;
  PetscCall(PetscInitialize(&argc, &argv, NULL, NULL));
  PetscCall(PetscOptionsGetInt(NULL, NULL, "-cells", &cells, NULL));
  PetscCall(PetscOptionsGetReal(NULL, NULL, "-ratio", &ratio, NULL));
  PetscCall(PetscOptionsGetBool(NULL, NULL, "-plain", &is_plain, NULL));
  PetscCall(PetscOptionsGetBool(NULL, NULL, "-direct", &is_direct, NULL));
  PetscCall(PetscOptionsGetBool(NULL, NULL, "-check", &check, NULL));
  PetscCall(PetscTime(&begin));
  PetscCall(press_create(cells, PetscMax(cells - 2, 2), ratio, &press));
  press.is_plain = is_plain, press.is_direct = is_direct;
  PetscCall(MatCreateVecs(press.stiffness, &u, NULL));
  PetscCall(press_solve(&press, u, &snes));
  PetscCall(SNESGetIterationNumber(snes, &steps));
  PetscCall(PetscTime(&end));
  PetscCall(print(&press, ratio, steps, end - begin));
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
