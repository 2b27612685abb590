/*
 * Solves the scenes of a file and prints their warnings, as a C program reads them. Lines of the
 * file: "scene NAME", "number KEY VALUE", "text KEY VALUE", "list KEY A B", "solve".
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wrcontact.h>

static void stop(const char* text) {
  fprintf(stderr, "%s\n", text);
  exit(1);
}

int main(int count, char** arguments) {
  FILE* file = count == 2 ? fopen(arguments[1], "r") : NULL;
  wrc_scene* scene = NULL;
  char line[1024];
  char name[64] = "";
  if (file == NULL) {
    stop("usage: warnings_c FILE");
  }
  while (fgets(line, sizeof line, file) != NULL) {
    char word[16];
    char key[128] = "";
    char text[900] = "";
    double pair[2];
    wrc_status status = WRC_OK;
    sscanf(line, "%15s %127s %899[^\n]", word, key, text);
    if (strcmp(word, "scene") == 0) {
      wrc_scene_destroy(scene);
      status = wrc_scene_create(&scene);
      snprintf(name, sizeof name, "%.63s", key);
    } else if (strcmp(word, "number") == 0) {
      status = wrc_scene_set_number(scene, key, strtod(text, NULL));
    } else if (strcmp(word, "list") == 0 && sscanf(text, "%lf %lf", pair, pair + 1) == 2) {
      status = wrc_scene_set_numbers(scene, key, pair, 2);
    } else if (strcmp(word, "text") == 0) {
      status = wrc_scene_set_text(scene, key, text);
    } else {
      double told = -1.0;
      int64_t found = 0;
      const char* warning = NULL;
      status = wrc_scene_solve(scene);
      status = status == WRC_NOT_CONVERGED ? WRC_OK : status;
      for (; (warning = wrc_scene_warning(scene, found)) != NULL; ++found) {
        printf("%s\t%s\n", name, warning);
      }
      if (wrc_scene_number(scene, "warning_count", &told) != WRC_OK || told != (double)found) {
        stop("warning_count is another than that of wrc_scene_warning");
      }
    }
    if (status != WRC_OK) {
      stop(wrc_scene_error(scene));
    }
  }
  wrc_scene_destroy(scene);
  fclose(file);
  return 0;
}
