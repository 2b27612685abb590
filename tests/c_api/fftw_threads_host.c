/* A host whose own plans have four threads, in both precisions: results, threads of the process and
   the host's setting are those of a host without; a child of fork solves, and so does the host
   after it has cleaned up. Built for FFTW's threads and for OpenMP's. */
#include <dirent.h>
#include <fftw3.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wrcontact.h>

enum { host_threads = 4 };

static int fail(const char* what) {
  fprintf(stderr, "%s\n", what);
  return 1;
}

static int thread_count(void) {
  int count = -2; /* . and .. */
  DIR* tasks = opendir("/proc/self/task");
  while (readdir(tasks) != NULL) {
    ++count;
  }
  closedir(tasks);
  return count;
}

/* 17 digits of a scene with creep forces on a grid of its own size, whose lines are planned anew.
 */
static int solve(double rows, char digits[64]) {
  const double grid[2] = {rows, 0.5 * rows};
  const double creepage[3] = {1e-3, 5e-4, 1e-4};
  double force = 0.0;
  wrc_scene* scene = NULL;
  int failed = wrc_scene_create(&scene) != WRC_OK ||
               wrc_scene_set_numbers(scene, "creepage.left", creepage, 3) != WRC_OK ||
               wrc_scene_set_numbers(scene, "solve.grid", grid, 2) != WRC_OK ||
               wrc_scene_set_text(scene, "solve.side", "left") != WRC_OK ||
               wrc_scene_solve(scene) != WRC_OK ||
               wrc_scene_number(scene, "left.total.force.x", &force) != WRC_OK;
  snprintf(digits, 64, "%.17g", force);
  wrc_scene_destroy(scene);
  return failed;
}

static int solves_in_a_child(double rows) {
  const pid_t child = fork();
  if (child == 0) {
    char digits[64];
    alarm(60);
    _exit(solve(rows, digits));
  }
  int status = 1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int main(int count, char** arguments) {
  const int with_threads = count > 2 && strcmp(arguments[2], "threads") == 0;
  if (with_threads) {
    fftw_init_threads();
    fftwf_init_threads();
    fftw_plan_with_nthreads(host_threads);
    fftwf_plan_with_nthreads(host_threads);
  }
  char digits[64];
  const int before = thread_count();
  if (solve(120.0, digits) != 0) {
    return fail("the scene is not solved");
  }
  FILE* file = fopen(arguments[1], with_threads ? "r" : "w");
  if (file == NULL) {
    return fail("the file of digits cannot be opened");
  }
  if (!with_threads) {
    fprintf(file, "%s\n", digits);
  } else {
    char alone[64] = "";
    if (fscanf(file, "%63s", alone) != 1 || strcmp(alone, digits) != 0) {
      return fail("the digits are others than in a host without threads");
    }
  }
  fclose(file);
  if (thread_count() != before) {
    return fail("threads are left");
  }
  if (with_threads &&
      (fftw_planner_nthreads() != host_threads || fftwf_planner_nthreads() != host_threads)) {
    return fail("the host's setting is lost");
  }
  if (!solves_in_a_child(160.0)) {
    return fail("a child of fork does not solve");
  }
  if (with_threads) {
    fftw_cleanup_threads();
    fftwf_cleanup_threads();
    if (solve(200.0, digits) != 0) {
      return fail("the scene is not solved after the host has cleaned up");
    }
  }
  return 0;
}
