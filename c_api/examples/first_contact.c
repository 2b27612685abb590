/* First contact: S1002 on 60E1, the wheelset 5 mm to the left; both wheels and their patches. */
#include <stdio.h>
#include <wrcontact.h>

int main(void) {
  wrc_scene* scene = NULL;
  wrc_patch patches[8];
  int64_t count = 0;
  wrc_status status = wrc_scene_create(&scene);
  if (status == WRC_OK)
    status = wrc_scene_set_text(scene, "track.rail", "60E1");
  if (status == WRC_OK)
    status = wrc_scene_set_text(scene, "wheelset.wheel", "S1002");
  if (status == WRC_OK)
    status = wrc_scene_set_number(scene, "pose.lateral", 5.0);
  if (status == WRC_OK)
    status = wrc_scene_solve(scene);
  if (status == WRC_OK)
    status = wrc_scene_patches(scene, patches, sizeof *patches, 8, &count);
  if (status != WRC_OK) {
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), wrc_scene_error(scene));
  }
  for (int64_t i = 0; i < count && i < 8; ++i) {
    printf("%s wheel: pmax %.1f MPa, normal force %.0f N, contact angle %.4f rad\n",
           patches[i].wheel == 0.0 ? "left" : "right", patches[i].pmax, patches[i].normal_force,
           patches[i].angle);
  }
  for (int i = 0; status == WRC_OK && wrc_scene_warning(scene, i) != NULL; ++i) {
    printf("warning: %s\n", wrc_scene_warning(scene, i));
  }
  wrc_scene_destroy(scene);
  return status == WRC_OK ? 0 : 1;
}
