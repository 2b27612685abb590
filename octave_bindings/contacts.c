/*
 * Contact on grids of the caller's, and profiles.
 */
#include <stdio.h>
#include <string.h>

#include "wrc_mex.h"

/* ---- Grids: matrices with x, the rolling direction, along the columns ------------------------ */

/* Both kinds of contact are called alike. */
#define CALL(function, ...)                                                                        \
  (open_handles.rolling != NULL ? wrc_rolling_##function(open_handles.rolling, __VA_ARGS__)        \
                                : wrc_normal_##function(open_handles.normal, __VA_ARGS__))

static void check(wrc_status status) {
  if (status != WRC_OK) {
    refuse(status, open_handles.rolling != NULL  ? wrc_rolling_error(open_handles.rolling)
                   : open_handles.normal != NULL ? wrc_normal_error(open_handles.normal)
                                                 : wrc_status_name(status));
  }
}

/* The matrix, the sides of its elements, then pairs of key and value. */
static void pose(int count, const mxArray* const* values, const char* what) {
  const double* matrix = numbers_of(count > 0 ? values[0] : NULL, what, 0);
  const double* steps = numbers_of(count > 1 ? values[1] : NULL, "steps", 2);
  const int64_t along = (int64_t)mxGetM(values[0]);
  const int64_t across = (int64_t)mxGetN(values[0]);
  check(CALL(set_grid, across, along, steps[1], steps[0]));
  check(open_handles.rolling != NULL
            ? wrc_rolling_set_pressure(open_handles.rolling, matrix, along * across)
            : wrc_normal_set_distance(open_handles.normal, matrix, along * across));
  for (int k = 2; k < count; k += 2) {
    const char* key = text_of(values[k], "key");
    const mxArray* value = k + 1 < count ? values[k + 1] : NULL;
    check(value != NULL && mxIsChar(value) ? CALL(set_text, key, text_of(value, key))
                                           : CALL(set_number, key, *numbers_of(value, key, 1)));
  }
}

/* Results by name; lists end in NULL. */
static mxArray* results_of(wrc_status status, const mxArray* matrix, const char* const* numbers,
                           const char* const* fields) {
  if (status == WRC_NOT_CONVERGED) {
    warn_of(status, open_handles.rolling != NULL ? wrc_rolling_error(open_handles.rolling)
                                                 : wrc_normal_error(open_handles.normal));
  } else {
    check(status);
  }
  mxArray* result = mxCreateStructMatrix(1, 1, 0, NULL);
  for (; *numbers != NULL; ++numbers) {
    double value = 0.0;
    char name[64];
    check(CALL(number, *numbers, &value));
    strncpy(name, *numbers, sizeof name - 1);
    name[sizeof name - 1] = '\0';
    char* dot = strchr(name, '.'); /* residuals.least_gap is least_gap here */
    mxArray* group = result;
    if (dot != NULL && strncmp(name, "creep_force.", 12) == 0) {
      *dot = '\0';
      group = mxGetField(result, 0, name);
      if (group == NULL) {
        group = mxCreateStructMatrix(1, 1, 0, NULL);
        mxSetFieldByNumber(result, 0, mxAddField(result, name), group);
      }
    }
    mxSetFieldByNumber(group, 0, mxAddField(group, dot != NULL ? dot + 1 : name),
                       mxCreateDoubleScalar(value));
  }
  for (; *fields != NULL; ++fields) {
    int64_t count = (int64_t)mxGetNumberOfElements(matrix);
    mxArray* values = mxCreateDoubleMatrix(mxGetM(matrix), mxGetN(matrix), mxREAL);
    check(CALL(field, *fields, mxGetPr(values), count, &count));
    mxSetFieldByNumber(result, 0, mxAddField(result, *fields), values);
  }
  return result;
}

void normal(int result_count, mxArray** result, int count, const mxArray* const* values) {
  static const char* const numbers[] = {"approach",
                                        "normal_force",
                                        "area",
                                        "pmax",
                                        "pmax_element",
                                        "fill",
                                        "iterations",
                                        "warning_count",
                                        "residuals.load_balance",
                                        "residuals.least_gap",
                                        "residuals.complementarity",
                                        "grade",
                                        NULL};
  static const char* const fields[] = {"pressure", "displacement", NULL};
  (void)result_count;
  check(wrc_normal_create(&open_handles.normal));
  pose(count, values, "undeformed distance");
  result[0] = results_of(wrc_normal_solve(open_handles.normal), values[0], numbers, fields);
  const char* reason = NULL;
  check(wrc_normal_text(open_handles.normal, "stop_reason", &reason));
  mxSetFieldByNumber(result[0], 0, mxAddField(result[0], "stop_reason"), mxCreateString(reason));
  double count_of_warnings = 0.0;
  check(wrc_normal_number(open_handles.normal, "warning_count", &count_of_warnings));
  static const char* const lists[] = {"warnings", "warning_classes", "warning_grades"};
  mxArray* made[3];
  for (int k = 0; k < 3; ++k) {
    made[k] = mxCreateCellMatrix((mwSize)count_of_warnings, 1);
  }
  for (int i = 0; i < (int)count_of_warnings; ++i) {
    const char* texts[3] = {NULL};
    for (int k = 0; k < 3; ++k) {
      char name[32];
      snprintf(name, sizeof name, "%s.%d", lists[k], i);
      check(wrc_normal_text(open_handles.normal, name, &texts[k]));
      mxSetCell(made[k], (mwIndex)i, mxCreateString(texts[k]));
    }
    warn_as(texts[1], texts[0]);
  }
  for (int k = 0; k < 3; ++k) {
    mxSetFieldByNumber(result[0], 0, mxAddField(result[0], lists[k]), made[k]);
  }
}

void rolling(int result_count, mxArray** result, int count, const mxArray* const* values) {
  static const char* const numbers[] = {"creep_force.longitudinal",
                                        "creep_force.lateral",
                                        "spin_moment",
                                        "slip_area",
                                        "adhesion_area",
                                        "friction_power",
                                        "numerical_loss",
                                        "iterations",
                                        "convolutions",
                                        "residual",
                                        "converged",
                                        NULL};
  static const char* const fields[] = {"traction_x", "traction_y", "slip_x", "slip_y", NULL};
  (void)result_count;
  check(wrc_rolling_create(&open_handles.rolling));
  pose(count, values, "pressure");
  result[0] = results_of(wrc_rolling_solve(open_handles.rolling), values[0], numbers, fields);
}

/* ---- Profiles -------------------------------------------------------------------------------- */

static void check_profile(wrc_status status) {
  if (status != WRC_OK) {
    refuse(status, open_handles.profile != NULL ? wrc_profile_error(open_handles.profile)
                                                : wrc_status_name(status));
  }
}

/* Lines of text that a function gives until NULL, as a cell array. */
static mxArray* lines_of(const char* line(const wrc_profile*, int64_t)) {
  mwSize count = 0;
  while (line(open_handles.profile, (int64_t)count) != NULL) {
    ++count;
  }
  mxArray* lines = mxCreateCellMatrix(1, count);
  for (mwIndex i = 0; i < count; ++i) {
    mxSetCell(lines, i, mxCreateString(line(open_handles.profile, (int64_t)i)));
  }
  return lines;
}

/* A name, or a file; then the number of points. */
void profile(int result_count, mxArray** result, int count, const mxArray* const* values) {
  static const char* const texts[] = {"name", "title", "source", "confidence"};
  static const char* const curve[] = {"arc", "lateral", "height", "angle", "curvature"};
  const char* name = text_of(count > 0 ? values[0] : NULL, "profile");
  const double points = count > 1 ? *numbers_of(values[1], "points", 1) : 1000.0;
  double* columns[5];
  double length = 0.0;
  int32_t kind = 0;
  (void)result_count;
  if (!(points >= 2.0 && points <= 1e7)) {
    refuse(WRC_INVALID_ARGUMENT, "points: must be between 2 and 1e7");
  }
  check_profile(wrc_profile_create(&open_handles.profile));
  if (wrc_profile_load_standard(open_handles.profile, name) != WRC_OK) {
    check_profile(wrc_profile_load_file(open_handles.profile, name, NULL));
  }
  check_profile(wrc_profile_kind(open_handles.profile, &kind));
  check_profile(wrc_profile_length(open_handles.profile, &length));
  mxArray* made = mxCreateStructMatrix(1, 1, 0, NULL);
  mxSetFieldByNumber(made, 0, mxAddField(made, "kind"),
                     mxCreateString(kind == WRC_WHEEL ? "wheel" : "rail"));
  for (int i = 0; i < 4; ++i) {
    const char* value = NULL;
    check_profile(wrc_profile_text(open_handles.profile, texts[i], &value));
    mxSetFieldByNumber(made, 0, mxAddField(made, texts[i]), mxCreateString(value));
  }
  for (int i = 0; i < 5; ++i) {
    mxArray* column = mxCreateDoubleMatrix((mwSize)points, 1, mxREAL);
    columns[i] = mxGetPr(column);
    mxSetFieldByNumber(made, 0, mxAddField(made, curve[i]), column);
  }
  for (mwIndex i = 0; i < (mwSize)points; ++i) {
    columns[0][i] = length * (double)i / ((double)(mwSize)points - 1.0);
    check_profile(wrc_profile_at(open_handles.profile, columns[0][i], &columns[1][i],
                                 &columns[2][i], &columns[3][i], &columns[4][i]));
  }
  mxSetFieldByNumber(made, 0, mxAddField(made, "corrections"), lines_of(wrc_profile_correction));
  mxSetFieldByNumber(made, 0, mxAddField(made, "warnings"), lines_of(wrc_profile_warning));
  result[0] = made;
}
