/* An MPI of one rank, for what the pages show of it. */
#include <string.h>

typedef int MPI_Comm;
enum { MPI_SUCCESS, MPI_ERR_NO_MEM, MPI_BYTE, MPI_COMM_WORLD = 7 };

static inline int MPI_Comm_dup(MPI_Comm from, MPI_Comm *to) { return *to = from, MPI_SUCCESS; }
static inline int MPI_Comm_rank(MPI_Comm comm, int *rank) { return (void)comm, *rank = 0, MPI_SUCCESS; }
static inline int MPI_Comm_size(MPI_Comm comm, int *size) { return (void)comm, *size = 1, MPI_SUCCESS; }
static inline int MPI_Allgatherv(const void *send, int count, int of, void *received, const int *counts, const int *places,
                                 int as, MPI_Comm comm) {
  (void)of, (void)counts, (void)places, (void)as, (void)comm;
  return memcpy(received, send, (size_t)count), MPI_SUCCESS;
}
static inline int MPI_Bcast(void *data, int count, int of, int root, MPI_Comm comm) {
  return (void)data, (void)count, (void)of, (void)root, (void)comm, MPI_SUCCESS;
}
