/* A program for the header of 0.3 that ignores statuses: its load is a key no more. */
#include <stdio.h>

/* As that header declared them. */
typedef int status_of_0_3;
typedef struct wrc_scene wrc_scene;
status_of_0_3 wrc_scene_create(wrc_scene** scene);
status_of_0_3 wrc_scene_set_number(wrc_scene* scene, const char* key, double value);
status_of_0_3 wrc_scene_solve(wrc_scene* scene);
status_of_0_3 wrc_scene_number(wrc_scene* scene, const char* name, double* value);

int main(void) {
  wrc_scene* scene = 0;
  double force = 0.0;
  wrc_scene_create(&scene);
  wrc_scene_set_number(scene, "load.vertical", 50e3);
  wrc_scene_solve(scene);
  wrc_scene_number(scene, "left.vertical_force", &force);
  printf("%.0f N\n", force);
  return 0;
}
