/*
 * Ranks of MPI that share the work of a context, for hosts with an MPI of their own: compiled by the host with its mpi.h, so that
 * the library depends on none.
 *
 *   MPI_Comm comm = MPI_COMM_WORLD;
 *   fmc_communicator ranks;
 *   if (fmc_mpi_communicator(&comm, &ranks) == MPI_SUCCESS) fmc_context_set_communicator(context, &ranks);
 *
 * `comm` must live, at this address, as long as the context uses it. A duplicate (MPI_Comm_dup) keeps the messages apart from the
 * host's own. Evaluations are then collective over it.
 */
#ifndef FMC_MPI_H
#define FMC_MPI_H

#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>

#include "fmc_contact.h"

/* Messages of MPI 3 count in int: more than these bytes at once go rank by rank, in parts. */
#ifndef FMC_MPI_LARGEST
#define FMC_MPI_LARGEST INT_MAX
#endif

static inline int32_t fmc_mpi_all_gather(void *user, const void *send, const uint64_t *counts, void *received) {
  MPI_Comm comm = *(MPI_Comm *)user;
  int rank, size, code = MPI_Comm_rank(comm, &rank);
  if (code == MPI_SUCCESS) code = MPI_Comm_size(comm, &size);
  if (code != MPI_SUCCESS) return code;
  uint64_t total = 0;
  for (int r = 0; r < size; ++r) total += counts[r];
  if (total <= FMC_MPI_LARGEST) {
    int *numbers = (int *)malloc(2 * sizeof(int) * (size_t)size), at = 0;
    if (!numbers) return MPI_ERR_NO_MEM;
    for (int r = 0; r < size; at += numbers[r++]) {
      numbers[r] = (int)counts[r];
      numbers[size + r] = at;
    }
    code = MPI_Allgatherv(send, numbers[rank], MPI_BYTE, received, numbers, numbers + size, MPI_BYTE, comm);
    free(numbers);
    return code;
  }
  char *to = (char *)received;
  for (int r = 0; r < size; to += counts[r++]) {
    if (r == rank) memcpy(to, send, counts[r]);
    for (uint64_t done = 0, part; done < counts[r]; done += part) {
      part = counts[r] - done < FMC_MPI_LARGEST ? counts[r] - done : FMC_MPI_LARGEST;
      code = MPI_Bcast(to + done, (int)part, MPI_BYTE, r, comm);
      if (code != MPI_SUCCESS) return code;
    }
  }
  return MPI_SUCCESS;
}

/* Fills `ranks` for a communicator of MPI, and returns what MPI returns. */
static inline int fmc_mpi_communicator(MPI_Comm *comm, fmc_communicator *ranks) {
  int rank, size, code = MPI_Comm_rank(*comm, &rank);
  if (code == MPI_SUCCESS) code = MPI_Comm_size(*comm, &size);
  if (code != MPI_SUCCESS) return code;
  fmc_communicator_init(ranks);
  ranks->rank = rank;
  ranks->size = size;
  ranks->all_gather = fmc_mpi_all_gather;
  ranks->user = comm;
  return MPI_SUCCESS;
}

#endif
