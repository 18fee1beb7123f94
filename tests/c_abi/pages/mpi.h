/* An MPI of one rank, for what the pages show of it. */
#include <string.h>

typedef int MPI_Comm;
enum { MPI_SUCCESS, MPI_ERR_NO_MEM, MPI_BYTE, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD = 7, MPI_PROC_NULL = -1 };
#define MPI_IN_PLACE ((void *)1)
#define MPI_STATUS_IGNORE ((void *)0)

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
static inline int MPI_Allreduce(const void *send, void *received, int count, int of, int operation, MPI_Comm comm) {
  return (void)send, (void)received, (void)count, (void)of, (void)operation, (void)comm, MPI_SUCCESS;
}
static inline int MPI_Alltoallv(const void *send, const int *counts, const int *places, int of, void *received,
                                const int *received_counts, const int *to, int as, MPI_Comm comm) {
  (void)places, (void)of, (void)received_counts, (void)to, (void)as, (void)comm;
  return memcpy(received, send, (size_t)counts[0]), MPI_SUCCESS;
}
/* Not with messages that MPI counts. */
static inline int MPI_Sendrecv(const void *send, int count, int of, int to, int tag, void *received, int room, int as, int from,
                               int with, MPI_Comm comm, void *status) {
  (void)send, (void)count, (void)of, (void)to, (void)tag, (void)received, (void)room, (void)as, (void)from, (void)with;
  return (void)comm, (void)status, MPI_ERR_NO_MEM;
}
