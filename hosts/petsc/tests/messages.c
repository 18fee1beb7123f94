/* What fmc_mpi.h moves, whole and in parts of a few bytes, as if messages were larger than MPI counts: rank r has
 * (3 r + 2 to) % 8 bytes for rank `to`, which tell of both. Prints nothing; ends with 1 where a byte is wrong. */
#ifdef IN_PARTS
#define FMC_MPI_LARGEST 3
#endif
#include <fmc_mpi.h>

enum { MOST = 8 };

static uint64_t count(int from, int to) { return (uint64_t)((3 * from + 2 * to) % 8); }

static unsigned char byte(int from, int to, uint64_t at) { return (unsigned char)(31 * from + 7 * to + (int)at); }

static int are_right(const unsigned char *found, int from, int to) {
  for (uint64_t at = 0; at < count(from, to); ++at)
    if (found[at] != byte(from, to, at)) return 0;
  return 1;
}

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  MPI_Comm comm = MPI_COMM_WORLD;
  fmc_communicator ranks;
  int failed = fmc_mpi_communicator(&comm, &ranks) != MPI_SUCCESS || ranks.size > MOST;
  unsigned char send[MOST * 8], received[MOST * 8];
  uint64_t to[MOST], from[MOST], at = 0;
  for (int r = 0; r < ranks.size; ++r) {
    to[r] = count(ranks.rank, r);
    from[r] = count(r, ranks.rank);
    for (uint64_t k = 0; k < to[r]; ++k) send[at++] = byte(ranks.rank, r, k);
  }
  /* Twice: a message too many of the first time would come with the second. */
  for (int time = 0; time < 2; ++time) {
    failed |= ranks.all_to_all(ranks.user, send, to, received, from) != 0;
    at = 0;
    for (int r = 0; r < ranks.size; at += from[r++]) failed |= !are_right(received + at, r, ranks.rank);
  }
  /* What each has for rank 0, to all. */
  for (int r = 0; r < ranks.size; ++r) from[r] = count(r, 0);
  failed |= ranks.all_gather(ranks.user, send, from, received) != 0;
  at = 0;
  for (int r = 0; r < ranks.size; at += from[r++]) failed |= !are_right(received + at, r, 0);
  MPI_Finalize();
  return failed;
}
