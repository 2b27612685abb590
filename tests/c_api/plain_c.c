/* The header and the library from plain C11: solves a scene, reads results, reads a profile. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "wrcontact.h"

/* The load is met exactly but for rounding. */
static const double load_balance = 1e-9;

static int fail(const char* what, const char* text) {
  fprintf(stderr, "%s: %s\n", what, text);
  return EXIT_FAILURE;
}

static int check_scene(wrc_scene* scene) {
  const double grid[2] = {24.0, 20.0};
  double force = 0.0;
  const char* units = NULL;
  int64_t count = 0;
  double* pressure = NULL;
  wrc_status status = WRC_OK;
  if (wrc_scene_set_number(scene, "load.both", 50000.0) != WRC_OK ||
      wrc_scene_set_text(scene, "solve.side", "left") != WRC_OK ||
      wrc_scene_set_numbers(scene, "solve.grid", grid, 2) != WRC_OK ||
      wrc_scene_solve(scene) != WRC_OK ||
      wrc_scene_number(scene, "left.vertical_force", &force) != WRC_OK ||
      wrc_scene_text(scene, "units", &units) != WRC_OK ||
      wrc_scene_field(scene, "left.pressure", NULL, 0, &count) != WRC_OK) {
    return fail("scene", wrc_scene_error(scene));
  }
  if (!(fabs(force - 50000.0) <= 50000.0 * load_balance) || count != 24 * 20) {
    return fail("scene", "wrong force or length of a field");
  }
  pressure = malloc((size_t)count * sizeof *pressure);
  if (pressure == NULL) {
    return fail("scene", "out of memory");
  }
  status = wrc_scene_field(scene, "left.pressure", pressure, count, &count);
  free(pressure);
  return status == WRC_OK ? EXIT_SUCCESS : fail("field", wrc_scene_error(scene));
}

static int check_profile(wrc_profile* profile) {
  double lateral = 0.0;
  int32_t kind = WRC_RAIL;
  if (wrc_profile_load_standard(profile, "S1002") != WRC_OK ||
      wrc_profile_kind(profile, &kind) != WRC_OK ||
      wrc_profile_at(profile, 0.0, &lateral, NULL, NULL, NULL) != WRC_OK) {
    return fail("profile", wrc_profile_error(profile));
  }
  return kind == WRC_WHEEL && fabs(lateral + 70.0) < 1e-9 ? EXIT_SUCCESS
                                                          : fail("profile", "wrong values");
}

int main(void) {
  wrc_scene* scene = NULL;
  wrc_profile* profile = NULL;
  int result = EXIT_FAILURE;
  if (wrc_scene_create(&scene) == WRC_OK && wrc_profile_create(&profile) == WRC_OK) {
    result = check_scene(scene) == EXIT_SUCCESS ? check_profile(profile) : EXIT_FAILURE;
  }
  wrc_profile_destroy(profile);
  wrc_scene_destroy(scene);
  return result;
}
