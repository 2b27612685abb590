/* A file system without locks, as NFS and Lustre may be: flock fails, all else works. */
#include <errno.h>

int flock(int file, int operation);
int flock(int file, int operation) {
  (void)file;
  (void)operation;
  errno = ENOLCK;
  return -1;
}
