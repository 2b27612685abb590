/* What the F77 layer has to give to the last bit: steps by the C interface itself. */
#include <stddef.h>

#include "wrcontact.h"

/** A scene as f77_table_test.f makes it; NULL if it cannot be. */
static wrc_scene* new_scene(void) {
  wrc_scene* scene = NULL;
  if (wrc_scene_create(&scene) != WRC_OK ||
      wrc_scene_set_number(scene, "solve.accuracy", 1e-2) != WRC_OK ||
      wrc_scene_set_text(scene, "solve.accuracy_of", "forces") != WRC_OK) {
    wrc_scene_destroy(scene);
    return NULL;
  }
  return scene;
}

/** The next step of one history, which is accepted; status of its last call. */
void refhis_(const double* q, const double* v, const double* dt, double* f, double* dfdv,
             double* status) {
  static wrc_scene* scene = NULL;
  static wrc_solver* solver = NULL;
  static wrc_history* history = NULL;
  wrc_step_arguments arguments = {.struct_size = sizeof arguments};
  if (scene == NULL) {
    scene = new_scene();
    (void)wrc_solver_create(&solver);
    (void)wrc_history_create(&history);
  }
  if (*dt > 0.0) {
    wrc_history* histories[1] = {history};
    arguments.by_velocity = dfdv;
    arguments.histories = histories;
    arguments.time_step = *dt;
    *status = wrc_solver_step_with(solver, scene, q, v, &arguments, f);
    if (*status == WRC_OK) {
      *status = wrc_history_accept(history);
    }
  } else {
    wrc_history_destroy(history);
    wrc_solver_destroy(solver);
    wrc_scene_destroy(scene);
    scene = NULL;
  }
}

/** A step by the table of f77.table, with all further arguments; status of its last call. */
void reftab_(const double* q, const double* v, const double* opt, double* f, double* dfdr,
             double* errors, double* likely, double* outputs, double* output_errors,
             double* status) {
  wrc_table* table = NULL;
  wrc_step_arguments arguments = {.struct_size = sizeof arguments};
  arguments.rails = opt;
  arguments.rail_velocities = opt + 6;
  arguments.curvature = opt + 12;
  arguments.friction = opt + 13;
  arguments.by_rail = dfdr;
  arguments.likely_errors = likely;
  arguments.outputs = outputs;
  arguments.output_errors = output_errors;
  *status = wrc_table_create(&table);
  if (*status == WRC_OK) {
    *status = wrc_table_load(table, "f77.table");
  }
  if (*status == WRC_OK) {
    *status = wrc_table_step(table, NULL, NULL, q, v, &arguments, f, errors);
  }
  wrc_table_destroy(table);
}
