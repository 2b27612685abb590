/* Loads the library, solves a scene and closes it, again and again: no round takes memory that the
 * one before has not. Usage: load_again LIBRARY, with GLIBC_TUNABLES that keep freed chunks from
 * counting as in use: glibc.malloc.tcache_count=0:glibc.malloc.mxfast=0 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <malloc.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef int32_t (*handle_function)(void** handle);
typedef int32_t (*solve_function)(void* handle);

/* A function of the library: C has no cast from data to code. */
static void find(void* library, const char* name, void* function, size_t size) {
  void* address = dlsym(library, name);
  memcpy(function, &address, size);
}

static int solve_once(const char* path) {
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  handle_function create = NULL;
  solve_function solve = NULL;
  void (*destroy)(void*) = NULL;
  void* scene = NULL;
  int good = 0;
  if (library == NULL) {
    fprintf(stderr, "%s\n", dlerror());
    return 0;
  }
  find(library, "wrc_scene_create_0_4", &create, sizeof create);
  find(library, "wrc_scene_solve", &solve, sizeof solve);
  find(library, "wrc_scene_destroy", &destroy, sizeof destroy);
  good = create != NULL && solve != NULL && destroy != NULL && create(&scene) == 0 &&
         solve(scene) == 0;
  if (good) {
    destroy(scene);
  }
  return dlclose(library) == 0 && good;
}

int main(int count, char** arguments) {
  enum { rounds = 120 }; /* the first half fills caches of the C library */
  size_t before = 0;
  size_t after = 0;
  for (int round = 0; round < rounds; ++round) {
    if (count != 2 || !solve_once(arguments[1])) {
      return 1;
    }
    if (round == rounds / 2) {
      before = mallinfo2().uordblks;
    }
  }
  after = mallinfo2().uordblks;
  printf("%zu bytes in use after %d rounds, %zu after %d\n", before, rounds / 2, after, rounds);
  return after <= before ? 0 : 1;
}
