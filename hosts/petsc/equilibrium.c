/* An elastic body that is pressed on rigid half-spaces, by SNES on any number of ranks.
 *
 *     mpirun -n 2 ./equilibrium problem.txt solution.txt
 *
 * The body first settles on a soft contact, then on the real one; the lines of the contact are then turned into the contact
 * normal of the equilibrium and it is sought anew. The solution: iterations, seconds, seconds in contact; then displacement
 * and contact force of every node. */
#include "elastic.h"
#include "touch.h"
#include <petscsnes.h>
#include <stdio.h>

static const double FAR = 0.1; /* part of the load above which the contact's matrix is semidefinite */
enum { MOST_TURNS = 4 };       /* times that the lines are turned */

typedef struct {
  Problem problem;
  Touch touch;
  Mat stiffness;
  Vec load;
  PetscReal size, residual; /* norm of the load, and of the last residual */
  IS held;                  /* degrees of freedom of this rank that are held */
} Host;

static PetscErrorCode residual(SNES snes, Vec u, Vec r, void *user) {
  Host *h = user;
  PetscFunctionBeginUser;
  (void)snes;
  PetscCall(MatMult(h->stiffness, u, r));
  PetscCall(VecAXPY(r, -1.0, h->load));
  PetscCall(touch_evaluate(&h->touch, u, r));
  PetscInt first, last;
  PetscScalar *rows;
  const PetscScalar *at;
  PetscCall(VecGetOwnershipRange(r, &first, &last));
  PetscCall(VecGetArray(r, &rows));
  PetscCall(VecGetArrayRead(u, &at));
  for (int k = 0; k < h->problem.held_count; k++) {
    const PetscInt row = h->problem.held[k] - first;
    if (row >= 0 && row < last - first) rows[row] = at[row] - h->problem.held_at[k];
  }
  PetscCall(VecRestoreArrayRead(u, &at));
  PetscCall(VecRestoreArray(r, &rows));
  PetscCall(VecNorm(r, NORM_2, &h->residual));
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode derivative(SNES snes, Vec u, Mat a, Mat p, void *user) {
  Host *h = user;
  PetscFunctionBeginUser;
  (void)snes;
  PetscCall(MatCopy(h->stiffness, p, DIFFERENT_NONZERO_PATTERN));
  PetscCall(MatSetOption(p, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
  PetscCall(MatSetOption(p, MAT_KEEP_NONZERO_PATTERN, PETSC_TRUE));
  PetscCall(MatZeroRowsColumnsIS(p, h->held, 1.0, NULL, NULL));
  PetscCall(touch_add_tangent(&h->touch, u, h->residual > FAR * h->size, p));
  if (a != p) {
    PetscCall(MatAssemblyBegin(a, MAT_FINAL_ASSEMBLY));
    PetscCall(MatAssemblyEnd(a, MAT_FINAL_ASSEMBLY));
  }
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Moves the body, undeformed and along its load, to where a contact carries it. */
static PetscErrorCode approach(Host *h, Vec u) {
  double along[2] = {0, 0}, low = 0, high = 1e-6, middle = 0;
  PetscFunctionBeginUser;
  for (int f = 0; f < h->problem.face_count; f++) {
    const double *a = h->problem.x[h->problem.faces[f][0]], *b = h->problem.x[h->problem.faces[f][1]];
    const double length = PetscSqrtReal((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
    for (int axis = 0; axis < 2; axis++) along[axis] += length * h->problem.traction[f][axis];
  }
  for (int k = 0; k < h->problem.held_count; k++) along[h->problem.held[k] % 2] = 0;
  const double size = PetscSqrtReal(along[0] * along[0] + along[1] * along[1]);
  if (size == 0) PetscFunctionReturn(PETSC_SUCCESS);
  for (int trial = 0, is_below = 1; trial < 100; trial++) {
    middle = is_below ? high : 0.5 * (low + high);
    double missing = size;
    PetscCall(VecSet(u, 0.0));
    PetscCall(VecStrideSet(u, 0, middle * along[0] / size));
    PetscCall(VecStrideSet(u, 1, middle * along[1] / size));
    PetscCall(touch_evaluate(&h->touch, u, NULL));
    for (int n = 0; n < h->problem.node_count; n++)
      missing += (h->touch.force[2 * n] * along[0] + h->touch.force[2 * n + 1] * along[1]) / size;
    if (PetscAbsReal(missing) < 0.05 * size) break;
    if (missing > 0) {
      low = middle;
      if (is_below) high = 2 * middle;
    } else {
      high = middle;
      is_below = 0;
    }
  }
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode write_solution(Host *h, Vec u, PetscInt iterations, double seconds, const char *path) {
  int rank;
  PetscFunctionBeginUser;
  PetscCall(touch_evaluate(&h->touch, u, NULL));
  PetscCallMPI(MPI_Comm_rank(PETSC_COMM_WORLD, &rank));
  if (rank == 0) {
    FILE *file = fopen(path, "w");
    PetscCheck(file, PETSC_COMM_SELF, PETSC_ERR_FILE_OPEN, "%s cannot be written", path);
    fprintf(file, "%d %.6f %.6f\n", (int)iterations, seconds, h->touch.seconds);
    for (int n = 0; n < h->problem.node_count; n++) {
      const double *x = h->touch.x + 2 * n, *f = h->touch.force + 2 * n, *start = h->problem.x[n];
      fprintf(file, "%.17g %.17g %.17g %.17g\n", x[0] - start[0], x[1] - start[1], f[0], f[1]);
    }
    fclose(file);
  }
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode solve(Host *h, const char *out) {
  Mat matrix;
  Vec u, r;
  SNES snes;
  KSP ksp;
  PC pc;
  int ranks;
  PetscInt iterations = 0, first, last, count = 0, *mine;
  double begin, end;
  PetscFunctionBeginUser;
  begin = processor_seconds();
  PetscCall(elastic_stiffness(&h->problem, &h->stiffness));
  PetscCall(MatDuplicate(h->stiffness, MAT_COPY_VALUES, &matrix));
  PetscCall(MatCreateVecs(matrix, &u, &r));
  PetscCall(VecSetBlockSize(u, 2));
  PetscCall(VecDuplicate(r, &h->load));
  PetscCall(elastic_load(&h->problem, h->load));
  PetscCall(VecNorm(h->load, NORM_2, &h->size));
  PetscCall(touch_create(&h->problem, u, &h->touch));
  PetscCall(VecGetOwnershipRange(u, &first, &last));
  PetscCall(PetscMalloc1(h->problem.held_count, &mine));
  for (int k = 0; k < h->problem.held_count; k++)
    if (h->problem.held[k] >= first && h->problem.held[k] < last) mine[count++] = h->problem.held[k];
  PetscCall(ISCreateGeneral(PETSC_COMM_WORLD, count, mine, PETSC_OWN_POINTER, &h->held));

  PetscCall(SNESCreate(PETSC_COMM_WORLD, &snes));
  PetscCall(SNESSetFunction(snes, r, residual, h));
  PetscCall(SNESSetJacobian(snes, matrix, matrix, derivative, h));
  PetscCall(SNESGetKSP(snes, &ksp));
  PetscCall(KSPSetType(ksp, KSPPREONLY));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PCSetType(pc, PCLU));
  PetscCallMPI(MPI_Comm_size(PETSC_COMM_WORLD, &ranks));
  if (ranks > 1) PetscCall(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  PetscCall(SNESSetFromOptions(snes));

  const double soft = h->problem.soft, hard = h->problem.stiffness, stages[2] = {soft, PetscSqrtReal(soft * hard)};
  PetscCall(touch_stiffness(&h->touch, soft));
  PetscCall(approach(h, u));
  for (int stage = soft < hard ? 0 : 2; stage < 3 + MOST_TURNS; stage++) {
    PetscInt needed;
    SNESConvergedReason reason;
    PetscCall(touch_stiffness(&h->touch, stage < 2 ? stages[stage] : hard));
    PetscCall(touch_keep_patches(&h->touch, u));
    PetscCall(SNESSetTolerances(snes, (stage < 2 ? FAR : h->problem.tolerance) * h->size, 0, 0, 100, 10000));
    PetscCall(SNESSolve(snes, NULL, u));
    PetscCall(SNESGetConvergedReason(snes, &reason));
    PetscCheck(reason >= 0, PETSC_COMM_WORLD, PETSC_ERR_NOT_CONVERGED, "no equilibrium: %s", SNESConvergedReasons[reason]);
    PetscCall(SNESGetIterationNumber(snes, &needed));
    iterations += needed;
  }
  end = processor_seconds();
  PetscCall(write_solution(h, u, iterations, end - begin, out));
  PetscCall(PetscPrintf(PETSC_COMM_WORLD, "%d iterations, %.2f s, %.2f s of these in contact\n", (int)iterations,
                        end - begin, h->touch.seconds));
  PetscCall(SNESDestroy(&snes));
  PetscCall(ISDestroy(&h->held));
  PetscCall(VecDestroy(&u));
  PetscCall(VecDestroy(&r));
  PetscCall(VecDestroy(&h->load));
  PetscCall(MatDestroy(&matrix));
  PetscCall(MatDestroy(&h->stiffness));
  PetscFunctionReturn(PETSC_SUCCESS);
}

int main(int argc, char **argv) {
  Host host;
  PetscCall(PetscInitialize(&argc, &argv, NULL, NULL));
  if (argc < 3) {
    PetscCall(PetscPrintf(PETSC_COMM_WORLD, "usage: %s problem.txt solution.txt\n", argv[0]));
    PetscCall(PetscFinalize());
    return 2;
  }
  PetscCall(problem_read(argv[1], &host.problem));
  PetscCall(solve(&host, argv[2]));
  PetscCall(touch_free(&host.touch));
  problem_free(&host.problem);
  PetscCall(PetscFinalize());
  return 0;
}
