/*
 * The C interface for Octave and MATLAB, as one function of commands; wrc_solve.m and the files
 * beside it call it and say what it does. Written against the C MEX interface of both programs.
 *
 * Handles made in a call are destroyed at its end, also when it fails; those of wrc_step live until
 * they are closed or the function is cleared. Units, frame and signs are those of wrcontact.h.
 */
#include "wrc_mex.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

struct open_handles open_handles;

void release_handles(void) {
  for (mwSize i = 0; i < open_handles.scene_count; ++i) {
    wrc_scene_destroy(open_handles.scenes[i]);
  }
  free(open_handles.scenes);
  wrc_solver_destroy(open_handles.solver);
  wrc_profile_destroy(open_handles.profile);
  wrc_normal_destroy(open_handles.normal);
  wrc_rolling_destroy(open_handles.rolling);
  memset(&open_handles, 0, sizeof open_handles);
}

/* "no contact" as the last part of an identifier: "wrcontact:no_contact". */
static void identifier_of(wrc_status status, char identifier[64]) {
  strcpy(identifier, "wrcontact:");
  strncat(identifier, wrc_status_name(status), 50);
  for (char* c = identifier; *c != '\0'; ++c) {
    if (*c == ' ') {
      *c = '_';
    }
  }
}

void refuse(wrc_status status, const char* text) {
  static char kept[4096]; /* the handle that holds the text is destroyed */
  char identifier[64];
  identifier_of(status, identifier);
  strncpy(kept, text, sizeof kept - 1);
  release_handles();
  mexErrMsgIdAndTxt(identifier, "%s", kept);
}

void warn_as(const char* kind, const char* text) {
  char identifier[80];
  snprintf(identifier, sizeof identifier, "wrcontact:%.60s", kind);
  mexWarnMsgIdAndTxt(identifier, "%s", text);
}

void warn_of(wrc_status status, const char* text) {
  char identifier[64];
  identifier_of(status, identifier);
  mexWarnMsgIdAndTxt(identifier, "%s", text);
}

char* text_of(const mxArray* value, const char* what) {
  char* text = value != NULL && mxIsChar(value) ? mxArrayToString(value) : NULL;
  if (text == NULL) {
    char message[200];
    snprintf(message, sizeof message, "%.100s: must be a text", what);
    refuse(WRC_INVALID_ARGUMENT, message);
  }
  return text;
}

const double* numbers_of(const mxArray* value, const char* what, size_t count) {
  if (value == NULL || !mxIsDouble(value) || mxIsComplex(value) || mxIsSparse(value) ||
      (count > 0 && mxGetNumberOfElements(value) != count)) {
    char message[200];
    snprintf(message, sizeof message,
             count > 0 ? "%.100s: must be %d real numbers (double)"
                       : "%.100s: must be real numbers (double)",
             what, (int)count);
    refuse(WRC_INVALID_ARGUMENT, message);
  }
  return mxGetPr(value);
}

/* ---- Wheelsets of a vehicle simulation (wrc_step) ------------------------------------------- */

/* Users hold numbers, which may lie in arrays of doubles; the list is also there to destroy what
   was left open. */
struct wheelset {
  double number; /* as the user has it: never that of one before, nor before "clear wrc_mex" */
  wrc_solver* solver;
  wrc_scene* scene;
  struct wheelset* next;
};
static struct wheelset* wheelsets;
static double last_number;

static void close_wheelset(struct wheelset** place) {
  struct wheelset* wheelset = *place;
  *place = wheelset->next;
  wrc_solver_destroy(wheelset->solver);
  wrc_scene_destroy(wheelset->scene);
  free(wheelset);
}

static void close_everything(void) {
  release_handles();
  while (wheelsets != NULL) {
    close_wheelset(&wheelsets);
  }
}

static struct wheelset** find_wheelset(int count, const mxArray* const* values) {
  struct wheelset** place = &wheelsets;
  const int is_number = count > 0 && mxIsDouble(values[0]) && mxGetNumberOfElements(values[0]) == 1;
  const double number = is_number ? mxGetScalar(values[0]) : 0.0;
  while (*place != NULL && (*place)->number != number) {
    place = &(*place)->next;
  }
  if (*place == NULL) {
    refuse(WRC_INVALID_ARGUMENT, "wheelset: must be a number that wrc_step('open', ...) gave and "
                                 "that has not been closed");
  }
  return place;
}

static void open_wheelset(mxArray** result, int count, const mxArray* const* values) {
  struct options options = {NULL, 1};
  if (wrc_solver_create(&open_handles.solver) != WRC_OK) {
    refuse(WRC_OUT_OF_MEMORY, "out of memory");
  }
  make_scenes(count, values, &options);
  if (open_handles.scene_count != 1) {
    refuse(WRC_INVALID_ARGUMENT, "scene: must be one scene for each wheelset");
  }
  struct wheelset* wheelset = calloc(1, sizeof *wheelset);
  if (wheelset == NULL) {
    refuse(WRC_OUT_OF_MEMORY, "out of memory");
  }
  wheelset->solver = open_handles.solver;
  open_handles.solver = NULL;
  wheelset->scene = open_handles.scenes[0];
  last_number = last_number > 0.0 ? last_number + 1.0 : 1e3 * (double)time(NULL);
  wheelset->number = last_number;
  wheelset->next = wheelsets;
  wheelsets = wheelset;
  open_handles.scene_count = 0; /* it is the wheelset's now */
  result[0] = mxCreateDoubleScalar(wheelset->number);
}

static void step(int result_count, mxArray** result, int count, const mxArray* const* values) {
  const struct wheelset* wheelset = *find_wheelset(count, values);
  const double* position = numbers_of(count > 1 ? values[1] : NULL, "position", 6);
  const double* velocity = numbers_of(count > 2 ? values[2] : NULL, "velocity", 6);
  const double* rails = count > 3 ? numbers_of(values[3], "rails", 6) : NULL;
  const mwSize cube[] = {6, 6, 2};
  int32_t states[2];
  mxArray* force = mxCreateDoubleMatrix(6, 2, mxREAL);
  double* derivatives[2] = {NULL, NULL};
  for (int i = 0; i < 2 && 2 + i < result_count; ++i) {
    result[2 + i] = mxCreateNumericArray(3, cube, mxDOUBLE_CLASS, mxREAL);
    derivatives[i] = mxGetPr(result[2 + i]);
  }
  const wrc_status status =
      wrc_solver_step(wheelset->solver, wheelset->scene, position, velocity, rails, mxGetPr(force),
                      derivatives[0], derivatives[1], states);
  if (status == WRC_NOT_CONVERGED) {
    warn_of(status, wrc_scene_error(wheelset->scene));
  } else if (status != WRC_OK) {
    refuse(status, wrc_scene_error(wheelset->scene));
  }
  result[0] = force;
  if (result_count > 1) {
    result[1] = mxCreateDoubleMatrix(1, 2, mxREAL);
    mxGetPr(result[1])[0] = states[0];
    mxGetPr(result[1])[1] = states[1];
  }
}

static void close_command(int result_count, mxArray** result, int count,
                          const mxArray* const* values) {
  (void)result_count;
  (void)result;
  close_wheelset(find_wheelset(count, values));
}

static void open_command(int result_count, mxArray** result, int count,
                         const mxArray* const* values) {
  (void)result_count;
  open_wheelset(result, count, values);
}

static void results_command(int result_count, mxArray** result, int count,
                            const mxArray* const* values) {
  (void)result_count;
  const struct wheelset* wheelset = *find_wheelset(count, values);
  result[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  put_results(result[0], 0, wheelset->scene, WRC_OK,
              count > 1 ? text_of(values[1], "fields") : NULL);
}

/* ---- Keys and version ------------------------------------------------------------------------ */

static void keys(int result_count, mxArray** result, int count, const mxArray* const* values) {
  static const char* names[] = {"name", "default", "allowed", "meaning"};
  (void)result_count;
  (void)count;
  (void)values;
  const int64_t key_count = wrc_scene_key_count();
  result[0] = mxCreateStructMatrix((mwSize)key_count, 1, 4, names);
  for (int64_t i = 0; i < key_count; ++i) {
    const char* texts[4];
    wrc_scene_key(i, &texts[0], &texts[1], &texts[2], &texts[3]);
    for (int k = 0; k < 4; ++k) {
      mxSetFieldByNumber(result[0], (mwIndex)i, k, mxCreateString(texts[k]));
    }
  }
}

static void version(int result_count, mxArray** result, int count, const mxArray* const* values) {
  (void)result_count;
  (void)count;
  (void)values;
  result[0] = mxCreateString(wrc_version());
}

/* -------------------------------------------------------------------------------------------- */

void mexFunction(int result_count, mxArray** result, int count, const mxArray** values) {
  static const struct {
    const char* name;
    void (*run)(int result_count, mxArray** result, int count, const mxArray* const* values);
  } commands[] = {{"solve", solve},         {"keys", keys},       {"version", version},
                  {"open", open_command},   {"step", step},       {"results", results_command},
                  {"close", close_command}, {"profile", profile}, {"normal", normal},
                  {"rolling", rolling}};
  mexAtExit(close_everything);
  release_handles(); /* of a call that the program broke off */
  const char* name = text_of(count > 0 ? values[0] : NULL, "command");
  for (size_t i = 0; i < sizeof commands / sizeof commands[0]; ++i) {
    if (strcmp(name, commands[i].name) == 0) {
      commands[i].run(result_count, result, count - 1, values + 1);
      release_handles();
      return;
    }
  }
  refuse(WRC_UNKNOWN_NAME, "command: unknown; use wrc_solve, wrc_keys, wrc_step, wrc_profile, "
                           "wrc_normal or wrc_rolling");
}
