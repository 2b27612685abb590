#include <stdio.h>
#include <wrcontact.h>

int main(void) {
  wrc_scene* scene = NULL;
  double pmax = 0.0;
  if (wrc_scene_create(&scene) != WRC_OK)
    return 1;
  if (wrc_scene_set_number(scene, "pose.lateral", 3.0) != WRC_OK ||
      wrc_scene_solve(scene) != WRC_OK || wrc_scene_number(scene, "left.pmax", &pmax) != WRC_OK) {
    fprintf(stderr, "%s\n", wrc_scene_error(scene));
    return 1;
  }
  printf("%.17g\n", pmax);
  wrc_scene_destroy(scene);
  return 0;
}
