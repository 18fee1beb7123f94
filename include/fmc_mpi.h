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

static inline int32_t fmc_mpi_all_to_all(void *user, const void *send, const uint64_t *send_counts, void *received,
                                         const uint64_t *received_counts) {
  MPI_Comm comm = *(MPI_Comm *)user;
  int rank, size, code = MPI_Comm_rank(comm, &rank);
  if (code == MPI_SUCCESS) code = MPI_Comm_size(comm, &size);
  if (code != MPI_SUCCESS) return code;
  uint64_t *at = (uint64_t *)calloc((size_t)size + 1, sizeof(uint64_t)), *to = (uint64_t *)calloc((size_t)size + 1, sizeof(uint64_t));
  uint64_t largest = 0;
  int *numbers = (int *)malloc(4 * sizeof(int) * (size_t)size);
  if (!at || !to || !numbers) code = MPI_ERR_NO_MEM;
  for (int r = 0; code == MPI_SUCCESS && r < size; ++r) {
    at[r + 1] = at[r] + send_counts[r];
    to[r + 1] = to[r] + received_counts[r];
  }
  if (code == MPI_SUCCESS) largest = at[size] > to[size] ? at[size] : to[size];
  /* All go the same way. */
  if (code == MPI_SUCCESS) code = MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_UINT64_T, MPI_MAX, comm);
  if (code == MPI_SUCCESS && largest <= FMC_MPI_LARGEST) {
    for (int r = 0; r < size; ++r) {
      numbers[r] = (int)send_counts[r];
      numbers[size + r] = (int)at[r];
      numbers[2 * size + r] = (int)received_counts[r];
      numbers[3 * size + r] = (int)to[r];
    }
    code = MPI_Alltoallv(send, numbers, numbers + size, MPI_BYTE, received, numbers + 2 * size, numbers + 3 * size, MPI_BYTE, comm);
  } else {
    for (int step = 0; step < size; ++step) {
      const int target = (rank + step) % size, source = (rank + size - step) % size;
      const uint64_t more = send_counts[target] > received_counts[source] ? send_counts[target] : received_counts[source];
      for (uint64_t done = 0; code == MPI_SUCCESS && done < more; done += FMC_MPI_LARGEST) {
        const uint64_t out = done < send_counts[target] ? send_counts[target] - done : 0;
        const uint64_t in = done < received_counts[source] ? received_counts[source] - done : 0;
        code = MPI_Sendrecv((const char *)send + at[target] + done, (int)(out < FMC_MPI_LARGEST ? out : FMC_MPI_LARGEST), MPI_BYTE,
                            out ? target : MPI_PROC_NULL, 0, (char *)received + to[source] + done,
                            (int)(in < FMC_MPI_LARGEST ? in : FMC_MPI_LARGEST), MPI_BYTE, in ? source : MPI_PROC_NULL, 0, comm,
                            MPI_STATUS_IGNORE);
      }
    }
  }
  free(at);
  free(to);
  free(numbers);
  return code;
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
  ranks->all_to_all = fmc_mpi_all_to_all;
  ranks->user = comm;
  return MPI_SUCCESS;
}

#endif
