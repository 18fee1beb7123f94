/* An elastic body that is pressed on rigid half-spaces: its equilibrium by the library's search, on any number of ranks.
 *
 *     mpirun -n 2 ./equilibrium problem.txt solution.txt
 *
 * Every rank makes the whole search, with the same bits. The solution: linear solves, seconds, seconds in contact; then displacement and
 * contact force of every node. */
#include "bodies.h"
#include "elastic.h"
#include <stdio.h>

static PetscErrorCode begin_search(const Problem *p, Touch *touch, fmc_equilibrium **search) {
  const int count = 2 * p->node_count;
  int32_t *unknowns;
  uint8_t *is_free;
  double *start, *end;
  fmc_equilibrium_options options;
  fmc_equilibrium_problem given;
  PetscFunctionBeginUser;
  PetscCall(PetscMalloc2(count, &unknowns, count, &is_free));
  PetscCall(PetscCalloc2(count, &start, count, &end));
  for (int i = 0; i < count; i++) unknowns[i] = i, is_free[i] = 1;
  for (int k = 0; k < p->held_count; k++) is_free[p->held[k]] = 0, end[p->held[k]] = p->held_at[k];
  PetscCall(together(fmc_equilibrium_options_init(&options)));
  options.tolerance = p->tolerance;
  options.find_patches = 1;
  PetscCall(together(fmc_equilibrium_problem_init(&given)));
  given.unknown_count = count, given.row_count = p->node_count;
  given.unknown_of_coordinate = unknowns, given.base = p->x[0], given.free = is_free;
  given.x = start, given.prescribed = end;
  PetscCall(together(fmc_equilibrium_new(touch->context, &given, &options, search)));
  PetscCall(PetscFree2(unknowns, is_free));
  PetscCall(PetscFree2(start, end));
  PetscFunctionReturn(PETSC_SUCCESS);
}

/* Answers until the search has ended. */
static PetscErrorCode run(fmc_equilibrium *search, Bodies *bodies, Touch *touch, double *found, fmc_equilibrium_result *result) {
  fmc_equilibrium_request request;
  fmc_equilibrium_answer answer;
  const fmc_equilibrium_answer *given = NULL;
  double energy;
  PetscBool is_there;
  PetscFunctionBeginUser;
  for (;;) {
    const double begin = processor_seconds();
    PetscCall(together(fmc_equilibrium_next(touch->context, search, given, &request)));
    touch->seconds += processor_seconds() - begin;
    if (request.kind == FMC_REQUEST_FOUND || request.kind == FMC_REQUEST_REFUSED) break;
    PetscCall(bodies_answer(bodies, touch, &request, found, &energy, &is_there));
    PetscCall(together(fmc_equilibrium_answer_init(&answer)));
    answer.vector = is_there ? found : NULL;
    if (request.kind == FMC_REQUEST_FORCES) answer.energy = &energy;
    given = &answer;
  }
  PetscCall(together(fmc_equilibrium_found(search, result)));
  for (size_t k = 0; k < result->text_count; k++)
    PetscCall(PetscPrintf(PETSC_COMM_WORLD, "%s\n", fmc_equilibrium_text(search, k)));
  PetscCheck(result->way != FMC_WAY_NONE, PETSC_COMM_WORLD, PETSC_ERR_NOT_CONVERGED, "no equilibrium");
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode write_solution(const Problem *p, const double *u, const double *force, const char *heading, const char *path) {
  int rank;
  PetscFunctionBeginUser;
  PetscCallMPI(MPI_Comm_rank(PETSC_COMM_WORLD, &rank));
  if (rank == 0) {
    FILE *file = fopen(path, "w");
    PetscCheck(file, PETSC_COMM_SELF, PETSC_ERR_FILE_OPEN, "%s cannot be written", path);
    fprintf(file, "%s\n", heading);
    for (int n = 0; n < p->node_count; n++)
      fprintf(file, "%.17g %.17g %.17g %.17g\n", u[2 * n], u[2 * n + 1], force[2 * n], force[2 * n + 1]);
    fclose(file);
  }
  PetscFunctionReturn(PETSC_SUCCESS);
}

static PetscErrorCode solve(const Problem *problem, const char *path) {
  Touch touch;
  Bodies bodies;
  Mat stiffness;
  Vec load;
  fmc_equilibrium *search = NULL;
  fmc_equilibrium_result result;
  double *found;
  char heading[128];
  PetscFunctionBeginUser;
  const double begin = processor_seconds();
  PetscCall(elastic_stiffness(problem, &stiffness));
  PetscCall(MatCreateVecs(stiffness, NULL, &load));
  PetscCall(elastic_load(problem, load));
  PetscCall(bodies_create(problem, stiffness, load, &bodies));
  PetscCall(touch_create(problem, &touch));
  PetscCall(begin_search(problem, &touch, &search));
  PetscCall(PetscMalloc1(2 * problem->node_count, &found));
  PetscCall(run(search, &bodies, &touch, found, &result));
  PetscCall(touch_evaluate(&touch, result.x, found));
  const double seconds = processor_seconds() - begin;
  PetscCall(PetscSNPrintf(heading, sizeof heading, "%d %.6f %.6f", (int)result.solve_count, seconds, touch.seconds));
  PetscCall(write_solution(problem, result.x, found, heading, path));
  PetscCall(PetscPrintf(PETSC_COMM_WORLD, "%d linear solves, %.2f s, %.2f s of these in contact\n", (int)result.solve_count, seconds,
                        touch.seconds));
  PetscCall(PetscFree(found));
  PetscCall(together(fmc_equilibrium_free(&search)));
  PetscCall(bodies_free(&bodies));
  PetscCall(touch_free(&touch));
  PetscFunctionReturn(PETSC_SUCCESS);
}

int main(int argc, char **argv) {
  Problem problem;
  PetscCall(PetscInitialize(&argc, &argv, NULL, NULL));
  if (argc < 3) {
    PetscCall(PetscPrintf(PETSC_COMM_WORLD, "usage: %s problem.txt solution.txt\n", argv[0]));
    PetscCall(PetscFinalize());
    return 2;
  }
  PetscCall(problem_read(argv[1], &problem));
  PetscCall(solve(&problem, argv[2]));
  problem_free(&problem);
  PetscCall(PetscFinalize());
  return 0;
}
