/*
 * What the files of the MEX function share.
 */
#ifndef WRC_MEX_H
#define WRC_MEX_H

#include <mex.h>
#include <stdint.h>
#include <stdio.h>
#include <wrcontact.h>

/* Handles of the call that is going on. */
struct open_handles {
  wrc_scene** scenes;
  mwSize scene_count;
  wrc_solver* solver; /* its options are arguments beside the scene's keys */
  wrc_profile* profile;
  wrc_normal* normal;
  wrc_rolling* rolling;
};
extern struct open_handles open_handles;
void release_handles(void);

/* Ends the call: an error with the text, and the status as identifier. */
void refuse(wrc_status status, const char* text);
void warn_of(wrc_status status, const char* text);
/* A warning of a class of docs/warnings.md. */
void warn_as(const char* kind, const char* text);

/* A text, or `count` numbers (0: any), or an error that says what is allowed for `what`; freed by
   Octave or MATLAB. */
char* text_of(const mxArray* value, const char* what);
const double* numbers_of(const mxArray* value, const char* what, size_t count);

/* Arguments of wrc_solve that are no keys of the scene. */
struct options {
  const char* fields; /* names separated by blanks, NULL: those of a picture */
  int32_t threads;
};

/* The scenes that structs and pairs of key and value say, into open_handles.scenes. */
void make_scenes(int count, const mxArray* const* values, struct options* options);
/* All results of a scene, as fields of element `index` of a struct array. */
void put_results(mxArray* result, mwIndex index, wrc_scene* scene, wrc_status status,
                 const char* fields);

/* Commands. */
void solve(int result_count, mxArray** result, int count, const mxArray* const* values);
void profile(int result_count, mxArray** result, int count, const mxArray* const* values);
void normal(int result_count, mxArray** result, int count, const mxArray* const* values);
void rolling(int result_count, mxArray** result, int count, const mxArray* const* values);

#endif
