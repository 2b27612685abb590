/* Scenes, a step and contacts on grids of octave_test.m through the C interface: every value as a
   line of its name and its bits. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wrcontact.h"

static void check(wrc_status status, const char* text) {
  if (status != WRC_OK) {
    fprintf(stderr, "%s\n", text);
    exit(1);
  }
}

static void print(const char* name, double value) {
  uint64_t bits = 0;
  memcpy(&bits, &value, sizeof bits);
  printf("%s %016" PRIx64 "\n", name, bits);
}

static void print_all(const char* name, const double* values, int64_t count) {
  for (int64_t i = 0; i < count; ++i) {
    print(name, values[i]);
  }
}

static void print_scene(void) {
  wrc_scene* scene = NULL;
  double* pressure = NULL;
  int64_t count = 0;
  check(wrc_scene_create(&scene), "no scene");
  check(wrc_scene_set_number(scene, "pose.lateral", 5.0), wrc_scene_error(scene));
  check(wrc_scene_set_text(scene, "solve.creep", "full"), wrc_scene_error(scene));
  check(wrc_scene_set_numbers(scene, "creepage.left", (const double[]){1e-3, 5e-4, 2e-4}, 3),
        wrc_scene_error(scene));
  check(wrc_scene_solve(scene), wrc_scene_error(scene));
  for (int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
    const char* name = wrc_scene_number_name(scene, i);
    double value = 0.0;
    check(wrc_scene_number(scene, name, &value), wrc_scene_error(scene));
    print(name, value);
  }
  check(wrc_scene_field(scene, "left.pressure", NULL, 0, &count), wrc_scene_error(scene));
  pressure = malloc((size_t)count * sizeof *pressure);
  check(wrc_scene_field(scene, "left.pressure", pressure, count, &count), wrc_scene_error(scene));
  print_all("=pressure", pressure, count);
  free(pressure);
  wrc_scene_destroy(scene);
}

static void print_step(void) {
  const double position[6] = {0.0, 3.0, 459.9, 0.0, 0.0, 1e-3};
  const double velocity[6] = {20000.0, 10.0, 0.0, 0.0, 43.5, 0.0};
  const double rails[6] = {0.1, 0.0, 0.0, -0.1, 0.0, 0.0};
  double force[12];
  double by_position[72];
  double by_velocity[72];
  wrc_scene* scene = NULL;
  wrc_solver* solver = NULL;
  check(wrc_scene_create(&scene), "no scene");
  check(wrc_solver_create(&solver), "no solver");
  check(wrc_scene_set_text(scene, "solve.creep", "fastsim"), wrc_scene_error(scene));
  check(wrc_solver_step(solver, scene, position, velocity, rails, force, by_position, by_velocity,
                        NULL),
        wrc_scene_error(scene));
  print_all("=force", force, 12);
  print_all("=by_position", by_position, 72);
  print_all("=by_velocity", by_velocity, 72);
  wrc_solver_destroy(solver);
  wrc_scene_destroy(scene);
}

enum { along = 24, across = 32 };

static void print_grids(void) {
  double values[along * across];
  double tractions[along * across];
  wrc_normal* normal = NULL;
  wrc_rolling* rolling = NULL;
  int64_t count = 0;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < along; ++i) {
      const double x = (i - 11.5) / 2.0;
      const double y = (j - 15.5) / 2.0;
      values[j * along + i] = (2.0 * x * x + y * y) / 1024.0;
    }
  }
  check(wrc_normal_create(&normal), "no normal contact");
  check(wrc_normal_set_grid(normal, across, along, 0.5, 0.5), wrc_normal_error(normal));
  check(wrc_normal_set_distance(normal, values, along * across), wrc_normal_error(normal));
  check(wrc_normal_set_number(normal, "normal_load", 8e4), wrc_normal_error(normal));
  check(wrc_normal_solve(normal), wrc_normal_error(normal));
  check(wrc_normal_field(normal, "pressure", values, along * across, &count),
        wrc_normal_error(normal));
  print_all("=normal", values, count);
  check(wrc_rolling_create(&rolling), "no rolling contact");
  check(wrc_rolling_set_grid(rolling, across, along, 0.5, 0.5), wrc_rolling_error(rolling));
  check(wrc_rolling_set_pressure(rolling, values, along * across), wrc_rolling_error(rolling));
  check(wrc_rolling_set_text(rolling, "model", "fastsim"), wrc_rolling_error(rolling));
  check(wrc_rolling_set_number(rolling, "longitudinal_creepage", 1e-3), wrc_rolling_error(rolling));
  check(wrc_rolling_solve(rolling), wrc_rolling_error(rolling));
  check(wrc_rolling_field(rolling, "traction_x", tractions, along * across, &count),
        wrc_rolling_error(rolling));
  print_all("=rolling", tractions, count);
  wrc_rolling_destroy(rolling);
  wrc_normal_destroy(normal);
}

int main(void) {
  print_scene();
  print_step();
  print_grids();
  return 0;
}
