/* The scene of scene_test.f90 through the C interface. */
#include <stddef.h>

#include "wrcontact.h"

/* Writes left.pmax, right.pmax, left.approach, roll; returns the first failure. */
wrc_status solve_by_c(double lateral, double values[4]);

wrc_status solve_by_c(double lateral, double values[4]) {
  static const char* const names[4] = {"left.pmax", "right.pmax", "left.approach", "roll"};
  wrc_scene* scene = NULL;
  wrc_status status = wrc_scene_create(&scene);
  int i = 0;
  if (status == WRC_OK) {
    status = wrc_scene_set_number(scene, "pose.lateral", lateral);
  }
  if (status == WRC_OK) {
    status = wrc_scene_solve(scene);
  }
  for (i = 0; i < 4 && status == WRC_OK; ++i) {
    status = wrc_scene_number(scene, names[i], &values[i]);
  }
  wrc_scene_destroy(scene);
  return status;
}
