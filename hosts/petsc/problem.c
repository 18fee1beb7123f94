#include "problem.h"
#include <stdio.h>
#include <string.h>

/* A heading and its count. */
static int heading(FILE *file, const char *name) {
  char found[64];
  int count;
  return fscanf(file, "%63s %d", found, &count) == 2 && !strcmp(found, name) && count >= 0 ? count : -1;
}

static int numbers(FILE *file, double *to, int count) {
  for (int i = 0; i < count; i++)
    if (fscanf(file, "%lf", to + i) != 1) return 0;
  return 1;
}

static int nodes(FILE *file, int *to, int count) {
  for (int i = 0; i < count; i++)
    if (fscanf(file, "%d", to + i) != 1) return 0;
  return 1;
}

static int tables(FILE *file, Problem *p) {
  if (heading(file, "dimension") != 2) return 0;
  if ((p->node_count = heading(file, "nodes")) < 1) return 0;
  if (PetscMalloc1(p->node_count, &p->x) || !numbers(file, p->x[0], 2 * p->node_count)) return 0;
  if ((p->triangle_count = heading(file, "triangles")) < 1) return 0;
  if (PetscMalloc1(p->triangle_count, &p->triangles) || !nodes(file, p->triangles[0], 3 * p->triangle_count)) return 0;
  for (int t = 0; t < p->triangle_count; t++)
    for (int k = 0; k < 3; k++)
      if (p->triangles[t][k] < 0 || p->triangles[t][k] >= p->node_count) return 0;
  if ((p->held_count = heading(file, "held")) < 0) return 0;
  if (PetscMalloc2(p->held_count, &p->held, p->held_count, &p->held_at)) return 0;
  for (int h = 0; h < p->held_count; h++) {
    int at[2];
    if (!nodes(file, at, 2) || !numbers(file, p->held_at + h, 1)) return 0;
    p->held[h] = 2 * at[0] + at[1];
  }
  if ((p->face_count = heading(file, "faces")) < 0) return 0;
  if (PetscMalloc2(p->face_count, &p->faces, p->face_count, &p->traction)) return 0;
  for (int f = 0; f < p->face_count; f++)
    if (!nodes(file, p->faces[f], 2) || !numbers(file, p->traction[f], 2)) return 0;
  double material[2], contact[2];
  if (heading(file, "materials") != 1 || !numbers(file, material, 2)) return 0;
  if (heading(file, "contact") != 1 || !numbers(file, contact, 2)) return 0;
  p->lame = material[0], p->shear = material[1];
  p->stiffness = contact[0], p->tolerance = contact[1];
  if ((p->half_space_count = heading(file, "half_spaces")) < 0) return 0;
  return !PetscMalloc1(p->half_space_count, &p->half_spaces) && numbers(file, p->half_spaces[0], 4 * p->half_space_count);
}

PetscErrorCode problem_read(const char *path, Problem *problem) {
  PetscFunctionBeginUser;
  PetscCall(PetscMemzero(problem, sizeof *problem));
  FILE *file = fopen(path, "r");
  PetscCheck(file, PETSC_COMM_WORLD, PETSC_ERR_FILE_OPEN, "%s cannot be read", path);
  const int whole = tables(file, problem);
  fclose(file);
  PetscCheck(whole, PETSC_COMM_WORLD, PETSC_ERR_FILE_READ, "%s is no problem of triangles on half-spaces", path);
  PetscFunctionReturn(PETSC_SUCCESS);
}

void problem_free(Problem *p) {
  PetscFree(p->x);
  PetscFree(p->triangles);
  PetscFree2(p->held, p->held_at);
  PetscFree2(p->faces, p->traction);
  PetscFree(p->half_spaces);
}
