/* One call per time step: position and velocity of a wheelset in, forces on both wheels out. */
#include <stdio.h>
#include <wrcontact.h>

int main(void) {
  wrc_scene* scene = NULL;
  wrc_solver* solver = NULL;
  double force[12], by_position[72], by_velocity[72];
  int32_t states[2];
  wrc_status status = wrc_scene_create(&scene);
  if (status == WRC_OK)
    status = wrc_solver_create(&solver);
  if (status == WRC_OK)
    status = wrc_scene_set_text(scene, "solve.accuracy_of", "forces");
  if (status == WRC_OK)
    status = wrc_scene_set_number(scene, "solve.accuracy", 1e-2);
  for (int step = 0; step < 5 && status == WRC_OK; ++step) {
    /* x, y, z, roll, pitch angle, yaw, in mm and rad; y moves to the left. */
    const double position[6] = {0.0, 0.5 * step, 459.80, 0.0, 0.0, 1e-3};
    const double velocity[6] = {2e4, 15.0, 0.0, 0.0, 2e4 / 460.0, 0.0};
    status = wrc_solver_step(solver, scene, position, velocity, NULL, force, by_position,
                             by_velocity, states);
    if (status == WRC_OK) {
      printf("y %.1f mm: left (%.0f, %.0f, %.0f) N, right (%.0f, %.0f, %.0f) N, dFy/dy of the left "
             "wheel %.3e N/mm\n",
             position[1], force[0], force[1], force[2], force[6], force[7], force[8],
             by_position[7]);
    }
  }
  if (status != WRC_OK)
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), wrc_scene_error(scene));
  wrc_solver_destroy(solver);
  wrc_scene_destroy(scene);
  return status == WRC_OK ? 0 : 1;
}
