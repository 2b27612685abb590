/* Calls of every kind on a thread with the stack that docs/c.md states. Usage: small_stack FOLDER
 */
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "wrcontact.h"

enum { stated = 64 * 1024, path_size = 4096 };

static char rail_path[path_size];
static char scene_path[path_size];
static int failures = 0;

static void expect(int condition, const char* what) {
  if (!condition) {
    failures += 1;
    fprintf(stderr, "not so: %s\n", what);
  }
}

static void read_and_write_profiles(void) {
  static const char* const endings[] = {".txt", ".prr"};
  wrc_profile* profile = NULL;
  expect(wrc_profile_create(&profile) == WRC_OK, "a profile");
  for (int i = 0; i < 2; ++i) {
    expect(wrc_profile_load_standard(profile, "60E1") == WRC_OK, "a built-in rail");
    strcpy(strrchr(rail_path, '.'), endings[i]);
    expect(wrc_profile_write(profile, rail_path, 0.1) == WRC_OK, "a file");
    wrc_read_options options;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.kind = WRC_RAIL;
    options.kind_given = 1;
    options.smoothing_wavelength = 2.0;
    expect(wrc_profile_load_file(profile, rail_path, &options) == WRC_OK,
           wrc_profile_error(profile));
  }
  wrc_profile_destroy(profile);
}

static void solve(const char* key, const char* value, const char* planner) {
  wrc_scene* scene = NULL;
  wrc_solver* solver = NULL;
  double number = 0.0;
  expect(wrc_scene_create(&scene) == WRC_OK, "a scene");
  wrc_scene_set_text(scene, "track.rail", rail_path);
  wrc_scene_set_number(scene, "pose.lateral", 6.0);
  wrc_scene_set_number(scene, "motion.speed", 2e4);
  wrc_scene_set_number(scene, "solve.accuracy", 1e-2);
  wrc_scene_set_text(scene, "solve.derivatives", "yes");
  wrc_scene_set_text(scene, "solve.results", "stress wear fatigue");
  expect(wrc_scene_set_text(scene, key, value) == WRC_OK, wrc_scene_error(scene));
  expect(wrc_solver_create(&solver) == WRC_OK, "a solver");
  expect(wrc_solver_set_text(solver, "planner", planner) == WRC_OK, wrc_solver_error(solver));
  expect(wrc_solver_solve(solver, scene) == WRC_OK, wrc_scene_error(scene));
  wrc_solver_destroy(solver);
  for (int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
    wrc_scene_number(scene, wrc_scene_number_name(scene, i), &number);
  }
  expect(wrc_scene_write(scene, scene_path) == WRC_OK, wrc_scene_error(scene));
  wrc_scene_destroy(scene);
}

static void make_table(void) {
  wrc_scene* scene = NULL;
  wrc_table* table = NULL;
  wrc_table_options options;
  memset(&options, 0, sizeof options);
  options.struct_size = sizeof options;
  options.lateral = 0.5;
  options.roll = options.yaw = 1e-3;
  options.load = 1e3;
  options.fineness = 0.2;
  expect(wrc_scene_create(&scene) == WRC_OK && wrc_table_create(&table) == WRC_OK, "a table");
  expect(wrc_table_build(table, scene, &options, NULL, NULL) == WRC_OK, wrc_table_error(table));
  wrc_table_destroy(table);
  wrc_scene_destroy(scene);
}

static void* run(void* unused) {
  read_and_write_profiles();
  solve("motion.pitch", "free", "estimate");
  solve("solve.method", "paper", "estimate");
  solve("solve.creep", "fastsim", "estimate");
  solve("solve.creep", "full", "measure");
  make_table();
  return unused;
}

int main(int count, char** arguments) {
  pthread_attr_t attributes;
  pthread_t thread;
  if (count != 2) {
    return 2;
  }
  snprintf(rail_path, sizeof rail_path, "%s/small_stack_rail.txt", arguments[1]);
  snprintf(scene_path, sizeof scene_path, "%s/small_stack.toml", arguments[1]);
  expect(
      pthread_attr_init(&attributes) == 0 && pthread_attr_setstacksize(&attributes, stated) == 0 &&
          pthread_create(&thread, &attributes, run, NULL) == 0 && pthread_join(thread, NULL) == 0,
      "a thread");
  return failures == 0 ? 0 : 1;
}
