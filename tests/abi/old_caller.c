/* A program of the time of the baseline: every sort of call, with the structs of its header. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "wrcontact.h"

static int failures = 0;

static void expect(int condition, const char* what) {
  if (!condition) {
    failures += 1;
    fprintf(stderr, "not so: %s\n", what);
  }
}

static void use_patches(wrc_scene* scene) {
  wrc_patch patches[8];
  double value = 0.0;
  int64_t count = 0;
  expect(wrc_scene_patches(scene, patches, sizeof *patches, 8, &count) == WRC_OK && count == 2,
         "patches");
  expect(wrc_scene_number(scene, "left.patches.0.pmax", &value) == WRC_OK &&
             value == patches[0].pmax,
         "a member");
  expect(wrc_scene_number(scene, "left.patches.0.semi_axes.longitudinal", &value) == WRC_OK &&
             value == patches[0].semi_axes_longitudinal,
         "another member");
}

static void use_profiles(void) {
  wrc_profile* profile = NULL;
  wrc_read_options options;
  double lateral[60];
  double height[60];
  double length = 0.0;
  int32_t kind = -1;
  int i = 0;
  memset(&options, 0, sizeof options);
  options.struct_size = sizeof options;
  options.kind = WRC_RAIL;
  options.kind_given = 1;
  for (i = 0; i < 60; ++i) {
    lateral[i] = -30.0 + i;
    height[i] = -lateral[i] * lateral[i] / 600.0;
  }
  expect(wrc_profile_create(&profile) == WRC_OK, "a profile");
  expect(wrc_profile_set_points(profile, "points", lateral, height, 60, &options) == WRC_OK,
         "points");
  expect(wrc_profile_kind(profile, &kind) == WRC_OK && kind == WRC_RAIL, "a rail");
  expect(wrc_profile_length(profile, &length) == WRC_OK && fabs(length - 59.1) < 0.5, "its length");
  wrc_profile_destroy(profile);
}

static void use_scenes(void) {
  wrc_scene* scene = NULL;
  wrc_solver* solver = NULL;
  const double grid[2] = {24.0, 20.0};
  double load = 0.0;
  double force = 0.0;
  double pressure[480];
  int64_t count = 0;
  const char* text = NULL;
  wrc_status status = -1;
  expect(wrc_scene_create(&scene) == WRC_OK, "a scene");
  expect(wrc_solver_create(&solver) == WRC_OK, "a solver");
  expect(wrc_scene_set_numbers(scene, "solve.grid", grid, 2) == WRC_OK, "a grid");
  expect(wrc_scene_set_number(scene, "load.both", 70e3) == WRC_OK, "a load");
  expect(wrc_scene_get_number(scene, "load.both", &load) == WRC_OK && load == 70e3, "its value");
  expect(wrc_solver_solve(solver, scene) == WRC_OK, "a solution");
  expect(wrc_solve_batch(&scene, 1, 1, &status) == WRC_OK && status == WRC_OK, "a batch");
  expect(wrc_scene_number(scene, "left.vertical_force", &force) == WRC_OK, "a number");
  expect(fabs(force - load) < 1e-6 * load, "the load is met");
  use_patches(scene);
  expect(wrc_scene_field(scene, "left.pressure", pressure, 480, &count) == WRC_OK && count == 480,
         "a field");
  expect(wrc_scene_text(scene, "units", &text) == WRC_OK && strstr(text, "MPa") != NULL, "a text");
  expect(wrc_scene_set_number(scene, "no.key", 0.0) == WRC_UNKNOWN_NAME, "a failure");
  expect(strstr(wrc_scene_error(scene), "no.key") != NULL, "and its text");
  wrc_solver_destroy(solver);
  wrc_scene_destroy(scene);
}

static void use_normal_contact(void) {
  wrc_normal* normal = NULL;
  double gap[400];
  double force = 0.0;
  int i = 0;
  for (i = 0; i < 400; ++i) {
    const double x = i % 20 - 9.5;
    const double y = i / 20 - 9.5;
    gap[i] = 1e-4 * (x * x + y * y);
  }
  expect(wrc_normal_create(&normal) == WRC_OK, "a normal contact");
  expect(wrc_normal_set_grid(normal, 20, 20, 0.1, 0.1) == WRC_OK, "its grid");
  expect(wrc_normal_set_distance(normal, gap, 400) == WRC_OK, "its distances");
  expect(wrc_normal_set_number(normal, "normal_load", 300.0) == WRC_OK, "its load");
  expect(wrc_normal_solve(normal) == WRC_OK, "its solution");
  expect(wrc_normal_number(normal, "normal_force", &force) == WRC_OK, "its force");
  expect(fabs(force - 300.0) < 1e-6, "as prescribed");
  wrc_normal_destroy(normal);
}

int main(void) {
  use_profiles();
  use_scenes();
  use_normal_contact();
  return failures;
}
