/*
 * Scenes from structs or pairs of key and value, solved, and their results as structs: the name
 * "left.patches.0.grid.lateral" is r.left.patches(1).grid.lateral, counted from 1 as everything
 * here.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "wrc_mex.h"

enum { name_size = 256 };

/* ---- Input ----------------------------------------------------------------------------------- */

static void check(wrc_status status, wrc_scene* scene) {
  if (status != WRC_OK) {
    refuse(status, scene != NULL ? wrc_scene_error(scene) : wrc_status_name(status));
  }
}

/* Points of a profile, lateral and height in two columns, for a key such as "track.left.rail". */
static void set_profile(wrc_scene* scene, const char* key, const double* points, mwSize count) {
  const size_t length = strlen(key);
  const int is_wheel = length >= 6 && strcmp(key + length - 6, ".wheel") == 0;
  const wrc_read_options options = {
      .struct_size = sizeof options, .kind = is_wheel ? WRC_WHEEL : WRC_RAIL, .kind_given = 1};
  check(wrc_profile_create(&open_handles.profile), NULL);
  const wrc_status status = wrc_profile_set_points(open_handles.profile, key, points,
                                                   points + count, (int64_t)count, &options);
  if (status != WRC_OK) {
    refuse(status, wrc_profile_error(open_handles.profile));
  }
  check(wrc_scene_set_profile(scene, key, open_handles.profile), scene);
  wrc_profile_destroy(open_handles.profile);
  open_handles.profile = NULL;
}

static void set_struct(wrc_scene* scene, const char* prefix, const mxArray* value, mwIndex index);

static void set_key(wrc_scene* scene, const char* key, const mxArray* value) {
  if (mxIsStruct(value) && mxGetNumberOfElements(value) == 1) {
    set_struct(scene, key, value, 0);
  } else if (mxIsChar(value)) {
    char* text = text_of(value, key);
    check(wrc_scene_set_text(scene, key, text), scene);
    mxFree(text);
  } else {
    const double* numbers = numbers_of(value, key, 0);
    const mwSize count = mxGetNumberOfElements(value);
    if (mxGetN(value) == 2 && mxGetM(value) > 1) {
      set_profile(scene, key, numbers, mxGetM(value));
    } else {
      check(count == 1 ? wrc_scene_set_number(scene, key, numbers[0])
                       : wrc_scene_set_numbers(scene, key, numbers, (int64_t)count),
            scene);
    }
  }
}

/* Whether a field is an option of the profile that the struct names. */
static int is_option(const char* name) {
  static const char* const options[] = {"smoothing", "smoothing_along", "origin",
                                        "shift",     "rotation",        "align_to"};
  for (size_t k = 0; k < sizeof options / sizeof *options; ++k) {
    if (strcasecmp(name, options[k]) == 0) {
      return 1;
    }
  }
  return 0;
}

/* Fields of a struct, of which values may be structs: scene.pose.lateral. Empty ones are left out;
 * options of profiles come after the profiles.
 */
static void set_struct(wrc_scene* scene, const char* prefix, const mxArray* value, mwIndex index) {
  for (int options = 0; options < 2; ++options) {
    for (int k = 0; k < mxGetNumberOfFields(value); ++k) {
      const mxArray* field = mxGetFieldByNumber(value, index, k);
      const char* name = mxGetFieldNameByNumber(value, k);
      if (field != NULL && !mxIsEmpty(field) && is_option(name) == options) {
        char key[name_size];
        snprintf(key, sizeof key, "%s%s%s", prefix, prefix[0] != '\0' ? "." : "", name);
        set_key(scene, key, field);
      }
    }
  }
}

void make_scenes(int count, const mxArray* const* values, struct options* options) {
  const int by_struct = count > 0 && mxIsStruct(values[0]);
  const mwSize scene_count = by_struct ? mxGetNumberOfElements(values[0]) : 1;
  open_handles.scenes = calloc(scene_count + 1, sizeof *open_handles.scenes);
  if (open_handles.scenes == NULL) {
    refuse(WRC_OUT_OF_MEMORY, "out of memory");
  }
  for (; open_handles.scene_count < scene_count; ++open_handles.scene_count) {
    check(wrc_scene_create(&open_handles.scenes[open_handles.scene_count]), NULL);
  }
  for (mwIndex i = 0; by_struct && i < scene_count; ++i) {
    set_struct(open_handles.scenes[i], "", values[0], i);
  }
  for (int k = by_struct; k < count; k += 2) {
    const char* key = text_of(values[k], "key");
    if (k + 1 == count) {
      char message[name_size];
      snprintf(message, sizeof message, "%.100s: a value is missing behind it", key);
      refuse(WRC_INVALID_ARGUMENT, message);
    }
    if (strcmp(key, "fields") == 0) {
      options->fields = text_of(values[k + 1], key);
    } else if (strcmp(key, "threads") == 0) {
      const double threads = *numbers_of(values[k + 1], key, 1);
      if (!(threads >= 1.0 && threads <= 1024.0) || threads != floor(threads)) {
        refuse(WRC_INVALID_ARGUMENT, "threads: must be a whole number from 1 to 1024");
      }
      options->threads = (int32_t)threads;
    } else if (open_handles.solver != NULL &&
               (strcmp(key, "planner") == 0 || strcmp(key, "precision") == 0)) {
      const wrc_status status =
          wrc_solver_set_text(open_handles.solver, key, text_of(values[k + 1], key));
      if (status != WRC_OK) {
        refuse(status, wrc_solver_error(open_handles.solver));
      }
    } else {
      for (mwIndex i = 0; i < scene_count; ++i) {
        set_key(open_handles.scenes[i], key, values[k + 1]);
      }
    }
  }
}

/* ---- Results --------------------------------------------------------------------------------- */

/* A struct array like `old` (NULL: without fields) with `count` elements; takes over its values. */
static mxArray* grown_struct(mxArray* old, mwSize count) {
  mxArray* grown = mxCreateStructMatrix(1, count, 0, NULL);
  for (int k = 0; old != NULL && k < mxGetNumberOfFields(old); ++k) {
    mxAddField(grown, mxGetFieldNameByNumber(old, k));
    for (mwIndex i = 0; i < (mwIndex)mxGetNumberOfElements(old); ++i) {
      mxSetFieldByNumber(grown, i, k, mxGetFieldByNumber(old, i, k));
      mxSetFieldByNumber(old, i, k, NULL);
    }
  }
  if (old != NULL) {
    mxDestroyArray(old);
  }
  return grown;
}

/* Numbers (of a row) or texts (of a cell array) `old` with one more at `index`. */
static mxArray* grown_list(mxArray* old, mwIndex index, mxArray* last) {
  const mwSize before = old != NULL ? mxGetNumberOfElements(old) : 0;
  const mwSize count = index + 1 > before ? index + 1 : before;
  const int texts = mxIsChar(last);
  mxArray* grown = texts ? mxCreateCellMatrix(1, count) : mxCreateDoubleMatrix(1, count, mxREAL);
  for (mwIndex i = 0; i < before; ++i) {
    if (texts) {
      mxSetCell(grown, i, mxGetCell(old, i));
      mxSetCell(old, i, NULL);
    } else {
      mxGetPr(grown)[i] = mxGetPr(old)[i];
    }
  }
  if (texts) {
    mxSetCell(grown, index, last);
  } else {
    mxGetPr(grown)[index] = mxGetScalar(last);
    mxDestroyArray(last);
  }
  if (old != NULL) {
    mxDestroyArray(old);
  }
  return grown;
}

/* Sets element `index` of a struct array by the name of a result. */
static void put(mxArray* node, mwIndex index, const char* name, mxArray* value) {
  char field[name_size];
  const size_t length = strcspn(name, ".");
  if (length >= sizeof field) {
    refuse(WRC_INTERNAL, "name of a result is too long");
  }
  memcpy(field, name, length);
  field[length] = '\0';
  name += length;
  int number = mxGetFieldNumber(node, field);
  if (number < 0) {
    number = mxAddField(node, field);
  }
  if (*name == '\0') {
    mxSetFieldByNumber(node, index, number, value);
    return;
  }
  mxArray* child = mxGetFieldByNumber(node, index, number);
  mwIndex child_index = 0;
  ++name;
  if (*name >= '0' && *name <= '9') {
    char* end = NULL;
    child_index = (mwIndex)strtol(name, &end, 10);
    if (*end == '\0') {
      mxSetFieldByNumber(node, index, number, grown_list(child, child_index, value));
      return;
    }
    name = end + 1;
  }
  if (child == NULL || (mwIndex)mxGetNumberOfElements(child) <= child_index) {
    child = grown_struct(child, child_index + 1);
    mxSetFieldByNumber(node, index, number, child);
  }
  put(child, child_index, name, value);
}

/* A field, unless this scene has no values of it, with `rows` values to a column if they are so
   many, under the name `put_name`. */
static void put_field(mxArray* result, mwIndex index, wrc_scene* scene, const char* name,
                      const char* put_name, double rows) {
  int64_t count = 0;
  const wrc_status status = wrc_scene_field(scene, name, NULL, 0, &count);
  const int is_known = strstr(wrc_scene_error(scene), "the name is known") != NULL;
  if (status != WRC_OK && !is_known) {
    check(status, scene);
  }
  if (status != WRC_OK || count == 0) {
    return;
  }
  const mwSize columns = rows > 0.0 && count % (int64_t)rows == 0 ? count / (int64_t)rows : 1;
  mxArray* values = mxCreateDoubleMatrix((mwSize)count / columns, columns, mxREAL);
  check(wrc_scene_field(scene, name, mxGetPr(values), count, &count), scene);
  put(result, index, put_name, values);
}

/* Fields of a patch or part, such as "left.patches.0." */
static void put_patch_fields(mxArray* result, mwIndex index, wrc_scene* scene, const char* patch,
                             const char* fields) {
  static const char on_creep_grid[] = " creep_ traction_ slip_ frictional_ ";
  char name[2 * name_size];
  char put_name[2 * name_size]; /* the number "x" of a patch is not its field "x" */
  double along = 0.0;
  double creep_along = 0.0;
  snprintf(name, sizeof name, "%sgrid.longitudinal", patch);
  wrc_scene_number(scene, name, &along);
  snprintf(name, sizeof name, "%screep_grid.longitudinal", patch);
  wrc_scene_number(scene, name, &creep_along);
  for (const char* field = fields; *field != '\0';) {
    const int length = (int)strcspn(field, " ");
    char kind[name_size] = " ";
    strncat(kind, field, strcspn(field, " _"));
    strcat(kind, "_ ");
    snprintf(name, sizeof name, "%s%.*s", patch, length, field);
    snprintf(put_name, sizeof put_name, "%sfields.%.*s", patch, length, field);
    if (length > 0) {
      put_field(result, index, scene, name, put_name,
                strstr(on_creep_grid, kind) != NULL ? creep_along
                : strcmp(kind, " stress_ ") == 0    ? 100.0 /* places, docs/results.md */
                                                    : along);
    }
    field += (size_t)length + strspn(field + length, " ");
  }
}

void put_results(mxArray* result, mwIndex index, wrc_scene* scene, wrc_status status,
                 const char* fields) {
  static const char* const outlines[] = {"rail_y", "rail_z", "wheel_y", "wheel_z"};
  static const char* const sides[] = {"left", "right"};
  if (fields == NULL) {
    fields = "x y z pressure creep_x creep_y creep_z traction_x traction_y";
  }
  put(result, index, "status", mxCreateString(wrc_status_name(status)));
  put(result, index, "message", mxCreateString(status == WRC_OK ? "" : wrc_scene_error(scene)));
  if (status != WRC_OK && status != WRC_NOT_CONVERGED) {
    return;
  }
  for (int64_t i = 0; i < wrc_scene_number_count(scene); ++i) {
    const char* name = wrc_scene_number_name(scene, i);
    double value = 0.0;
    if (strstr(name, ".sensitivities.") != NULL ||
        wrc_scene_number(scene, name, &value) != WRC_OK) {
      continue;
    }
    char own[name_size];
    snprintf(own, sizeof own, "%s", name);
    char* by = strstr(own, ".by."); /* beside the number itself: spin_moment_by.friction */
    if (by != NULL) {
      *by = '_';
    }
    put(result, index, own, mxCreateDoubleScalar(value));
    const char* last = strrchr(name, '.');
    if (last != NULL && strcmp(last, ".pmax") == 0 && strstr(name, ".patches.") != NULL) {
      char patch[name_size];
      snprintf(patch, sizeof patch, "%.*s", (int)(last + 1 - name), name);
      put_patch_fields(result, index, scene, patch, fields);
    }
  }
  for (int64_t i = 0; i < wrc_scene_text_count(scene); ++i) {
    const char* name = wrc_scene_text_name(scene, i);
    const char* value = NULL;
    check(wrc_scene_text(scene, name, &value), scene);
    put(result, index, name, mxCreateString(value));
  }
  for (int i = 0; i < 8 && *fields != '\0'; ++i) {
    char name[name_size];
    snprintf(name, sizeof name, "%s.%s", sides[i / 4], outlines[i % 4]);
    put_field(result, index, scene, name, name, 0.0);
  }
}

/* ---- Warnings -------------------------------------------------------------------------------- */

/* Warnings of one class, of all scenes of a call. */
struct kind {
  char name[64];
  char text[2048]; /* of the first scene that has it */
  mwSize scene_count;
  mwIndex last; /* scene counted last */
};
enum { most_kinds = 64 };

/* The identifier of a warning: its class in docs/warnings.md, but one for all that are a little
   over the accuracy. */
static const char* identifier_of_warning(wrc_scene* scene, int64_t i) {
  char name[name_size];
  const char* grade = NULL;
  const char* kind = NULL;
  snprintf(name, sizeof name, "warning_grades.%d", (int)i);
  check(wrc_scene_text(scene, name, &grade), scene);
  if (strcmp(grade, "a little over") == 0) {
    return "a_little_over";
  }
  snprintf(name, sizeof name, "warning_classes.%d", (int)i);
  check(wrc_scene_text(scene, name, &kind), scene);
  return kind;
}

/* One warning of Octave for each of a scene's; of those a little over the first. */
static void warn_of_scene(wrc_scene* scene) {
  const char* text = NULL;
  int is_told = 0;
  for (int64_t i = 0; (text = wrc_scene_warning(scene, i)) != NULL; ++i) {
    const char* kind = identifier_of_warning(scene, i);
    const int is_over = strcmp(kind, "a_little_over") == 0;
    if (!is_over || !is_told) {
      warn_as(kind, text);
    }
    is_told = is_told || is_over;
  }
}

static void count_warnings(wrc_scene* scene, mwIndex index, struct kind* kinds) {
  const char* text = NULL;
  for (int64_t i = 0; (text = wrc_scene_warning(scene, i)) != NULL; ++i) {
    const char* class_name = identifier_of_warning(scene, i);
    struct kind* kind = kinds;
    while (kind < kinds + most_kinds - 1 && kind->scene_count > 0 &&
           strcmp(kind->name, class_name) != 0) {
      ++kind;
    }
    if (kind->scene_count == 0) {
      snprintf(kind->name, sizeof kind->name, "%s", class_name);
      snprintf(kind->text, sizeof kind->text, "%s", text);
    }
    if (kind->scene_count == 0 || kind->last != index) {
      ++kind->scene_count;
      kind->last = index;
    }
  }
}

/* One for each class, with the number of scenes that have it. */
static void warn_of_kinds(const struct kind* kinds, mwSize scene_count) {
  for (const struct kind* kind = kinds; kind < kinds + most_kinds && kind->scene_count > 0;
       ++kind) {
    char text[sizeof kind->text + 64];
    snprintf(text, sizeof text, "%d of %d scenes: %s", (int)kind->scene_count, (int)scene_count,
             kind->text);
    warn_as(kind->name, text);
  }
}

void solve(int result_count, mxArray** result, int count, const mxArray* const* values) {
  struct options options = {NULL, 1};
  (void)result_count;
  make_scenes(count, values, &options);
  const mwSize scene_count = open_handles.scene_count;
  wrc_status* statuses = mxCalloc(scene_count + 1, sizeof *statuses);
  if (scene_count > 0) {
    wrc_solve_batch(open_handles.scenes, (int64_t)scene_count, options.threads, statuses);
  }
  /* One scene fails as an error; of many each says how it went. */
  if (scene_count == 1 && statuses[0] == WRC_NOT_CONVERGED) {
    warn_of(statuses[0], wrc_scene_error(open_handles.scenes[0]));
  } else if (scene_count == 1) {
    check(statuses[0], open_handles.scenes[0]);
  }
  struct kind* kinds = mxCalloc(most_kinds, sizeof *kinds);
  result[0] = mxCreateStructMatrix(1, scene_count, 0, NULL);
  for (mwIndex i = 0; i < scene_count; ++i) {
    put_results(result[0], i, open_handles.scenes[i], statuses[i], options.fields);
    if (scene_count == 1) {
      warn_of_scene(open_handles.scenes[i]);
    } else if (statuses[i] == WRC_OK || statuses[i] == WRC_NOT_CONVERGED) {
      count_warnings(open_handles.scenes[i], i, kinds);
    }
    wrc_scene_destroy(open_handles.scenes[i]);
    open_handles.scenes[i] = NULL;
  }
  warn_of_kinds(kinds, scene_count);
}
