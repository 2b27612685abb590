/**
 * @file
 * wrcontact: where and how hard wheels press on rails.
 *
 * From wheel and rail profiles, track, wheelset position and load this library finds the contact
 * points of both wheels and the patches around them, samples the undeformed distance on an equally
 * spaced grid in the plane of each patch, and solves the non-Hertzian normal contact of elastic
 * half-spaces for all patches of a wheel together.
 *
 * Units:   mm, N, MPa, rad; a scene may ask for m, N, Pa, rad (key convention.units).
 * Frame:   track frame, x forward, y to the left, z up, right-handed; origin at the track centre in
 *          the plane of the rail tops. Roll > 0 lifts the left wheel, yaw > 0 is anticlockwise seen
 *          from above. Profile coordinates are positive to the field side. A scene may ask for
 *          y to the right and z down (key convention.frame).
 * Errors:  functions return WRC_OK or another wrc_status. The text of the last failure of a handle
 *          stays on the handle (wrc_scene_error and so on) until its next call. A failed call
 *          leaves the handle unchanged. Nothing throws, prints or ends the program, with one
 *          exception: FFTW itself aborts it if there is no memory for a plan.
 * Handles: a handle is a number disguised as a pointer and looked up at each call: one that has
 *          been destroyed, or is of another kind, is rejected with WRC_INVALID_ARGUMENT.
 * Threads: all functions may be called from any thread. A handle serves one call at a time; a
 *          second one meanwhile returns WRC_BUSY. Different handles are independent.
 * Floats:  the caller's rounding mode, traps and flags have no effect and are preserved.
 * Text:    UTF-8, null-terminated. Returned text belongs to the handle and is valid until the
 *          handle is changed or destroyed.
 *
 * Every declaration states the version that introduced it.
 */
#ifndef WRCONTACT_H
#define WRCONTACT_H

#include <stdint.h>

#if defined(_WIN32)
#define WRC_API
#elif defined(__GNUC__)
#define WRC_API __attribute__((visibility("default")))
#else
#define WRC_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Status codes; explicit and never reused. Since 0.1. */
typedef int32_t wrc_status;
#define WRC_OK 0
#define WRC_INVALID_ARGUMENT 1 /**< a value outside its permitted range */
#define WRC_UNKNOWN_NAME 2     /**< a key, profile or quantity that does not exist */
#define WRC_FILE_UNREADABLE 3  /**< a file that cannot be opened, read or written */
#define WRC_FILE_MALFORMED 4   /**< a file whose content cannot be understood */
#define WRC_NO_CONTACT 5       /**< wheel and rail do not meet in the scene as posed */
#define WRC_OUT_OF_MEMORY 6    /**< memory could not be allocated */
#define WRC_INTERNAL 7         /**< a fault of the library itself */
#define WRC_NOT_CONVERGED 8    /**< results exist, but miss the tolerance; see stop_reason */
#define WRC_TOO_SMALL 9  /**< the caller's array is too small; the required length is returned */
#define WRC_NO_RESULT 10 /**< the handle has not been solved or loaded yet */
#define WRC_BUSY 11      /**< the handle is in use by another thread; since 0.2 */

/** Name of a status, for example "invalid argument"; never NULL. Since 0.1. */
WRC_API const char* wrc_status_name(wrc_status status);
/** Version of the library, for example "0.1.0". Since 0.1. */
WRC_API const char* wrc_version(void);

/* ---- Scene: the input and its results ------------------------------------------------------ */

typedef struct wrc_scene wrc_scene;

/** A scene with the defaults of the paper's Table 1. On failure *scene is NULL. Since 0.1. */
WRC_API wrc_status wrc_scene_create(wrc_scene** scene);
/** Does nothing with NULL. Since 0.1. */
WRC_API void wrc_scene_destroy(wrc_scene* scene);
/** Text of the last failure, "" if there was none. Since 0.1. */
WRC_API const char* wrc_scene_error(const wrc_scene* scene);

/**
 * Sets a key of the scene, for example "pose.lateral". wrc_scene_key lists all keys with their
 * defaults and permitted values. Keys of one subject replace each other: the last call applies
 * (load.vertical and load.left, material.poisson and material.wheel.poisson, solve.accuracy and
 * solve.grid). The keys convention.units and convention.frame set the units and frame of numbers
 * passed to and returned by the calls that follow; what was set before keeps its meaning. The key
 * solve.until stops after one of the three modules. WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT.
 * Since 0.1.
 */
WRC_API wrc_status wrc_scene_set_number(wrc_scene* scene, const char* key, double value);
WRC_API wrc_status wrc_scene_set_text(wrc_scene* scene, const char* key, const char* value);
WRC_API wrc_status wrc_scene_set_numbers(wrc_scene* scene, const char* key, const double* values,
                                         int64_t count);

/**
 * The values of keys, in the scene's convention: a text if it is a word ("solve", "none"),
 * otherwise a number or a list, copied as by wrc_scene_field. WRC_INVALID_ARGUMENT if the value is
 * of another type, or if there is no single one (load.vertical with different loads on the wheels).
 * Since 0.2.
 */
WRC_API wrc_status wrc_scene_get_number(wrc_scene* scene, const char* key, double* value);
WRC_API wrc_status wrc_scene_get_text(wrc_scene* scene, const char* key, const char** value);
WRC_API wrc_status wrc_scene_get_numbers(wrc_scene* scene, const char* key, double* values,
                                         int64_t capacity, int64_t* count);

/** Description of a key; the texts belong to the library and stay valid. Since 0.1. */
WRC_API int64_t wrc_scene_key_count(void);
WRC_API wrc_status wrc_scene_key(int64_t index, const char** name, const char** default_value,
                                 const char** allowed, const char** meaning);

/**
 * Solves geometry, remesh and mechanics of the wheels in solve.side. WRC_NOT_CONVERGED comes with
 * usable results; on any other failure the results of the last success remain. Since 0.1.
 */
WRC_API wrc_status wrc_scene_solve(wrc_scene* scene);

/**
 * Writes the scene as a TOML file that wrc_case replays: with the same library on the same machine
 * bit for bit what wrc_scene_solve gives. Numbers are in mm, N, MPa, y left, z up, whatever the
 * scene's convention. Profiles given by wrc_scene_set_profile go into files of their points beside
 * it. WRC_FILE_UNREADABLE if it cannot be written. Since 0.2.
 */
WRC_API wrc_status wrc_scene_write(wrc_scene* scene, const char* path);

/**
 * A scalar result by name: "roll", "vertical", "left.pmax", "right.patches.0.angle",
 * "left.patches.1.centroid.y", "time_ms.total" and so on (docs/results.md lists and defines them).
 * Names of a wheel refer to all its patches together; patches are numbered from 0, largest normal
 * force first, and wrc_scene_number_name shows how many there are. Patches that share a plane are
 * one, with parts: "left.patches.0.parts.1.pmax". WRC_UNKNOWN_NAME for the index of a patch that is
 * not there. Since 0.1.
 */
WRC_API wrc_status wrc_scene_number(wrc_scene* scene, const char* name, double* value);
/** A text result by name: "model", "units", "left.stop_reason", "left.warnings.0". Since 0.1. */
WRC_API wrc_status wrc_scene_text(wrc_scene* scene, const char* name, const char** value);
/**
 * A field by name: of a patch of the side "left" or "right", one value per element with the
 * longitudinal index fastest: "left.patches.0.x", ".y", ".z" (element centres),
 * ".undeformed_distance", ".pressure", ".displacement"; "left.pressure" and so on is short for
 * "left.patches.0.pressure" and has no values without contact. Of a patch with parts these are
 * means over the elements of a grid that spans all of them; "left.patches.0.parts.1.pressure" is
 * that of a part as it was solved. Of a side the outlines
 * "left.rail_y", ".rail_z", ".wheel_y", ".wheel_z" of the cross section. Copies at most `capacity`
 * values into `values` and sets *count to the length; with capacity 0 (values may be NULL) it only
 * returns the length. WRC_TOO_SMALL if the length exceeds a capacity > 0; nothing is copied then.
 * Since 0.1.
 */
WRC_API wrc_status wrc_scene_field(wrc_scene* scene, const char* name, double* values,
                                   int64_t capacity, int64_t* count);
/** Names of all available results, in a fixed order. Since 0.1. */
WRC_API int64_t wrc_scene_number_count(const wrc_scene* scene);
WRC_API const char* wrc_scene_number_name(const wrc_scene* scene, int64_t index);
WRC_API int64_t wrc_scene_text_count(const wrc_scene* scene);
WRC_API const char* wrc_scene_text_name(const wrc_scene* scene, int64_t index);

/* ---- Solver: what is kept from one scene to the next --------------------------------------- */

typedef struct wrc_solver wrc_solver;

/**
 * Keeps profiles, surfaces, influence coefficients, transform plans and memory between solutions:
 * what saves time and changes no bit of a result. For vehicle simulations: one solver per wheelset,
 * solved every time step, in any order of steps. Since 0.1.
 */
WRC_API wrc_status wrc_solver_create(wrc_solver** solver);
WRC_API void wrc_solver_destroy(wrc_solver* solver);
WRC_API const char* wrc_solver_error(const wrc_solver* solver);

/**
 * As wrc_scene_solve, bit for bit, whatever was solved before, with what the solver keeps. Results
 * and the error text are on the scene's handle. A scene's handle may be used
 * repeatedly, with its pose changed. Since 0.1; the same bits since 0.3.
 */
WRC_API wrc_status wrc_solver_solve(wrc_solver* solver, wrc_scene* scene);
/**
 * With `profiles` not 0 drops everything that is kept, so that profile files are read again; with 0
 * does nothing: since 0.3 there are no positions to forget. Since 0.1.
 */
WRC_API wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles);

/**
 * Solves many scenes (at most 2^24), each by itself as wrc_scene_solve does, on up to `threads`
 * threads (1 to 1024); bit for bit the same for any number of them. The handles must all be
 * different. The status of each goes to statuses (may be NULL), its error text to its scene.
 * Returns WRC_OK if all were solved, otherwise the status of the first that was not. Since 0.1.
 */
WRC_API wrc_status wrc_solve_batch(wrc_scene* const* scenes, int64_t count, int32_t threads,
                                   wrc_status* statuses);

/* ---- Normal contact of a gap given by the caller ------------------------------------------- */

/**
 * One problem on an equally spaced grid, and the solver that keeps plans, tables and memory between
 * its calls: pressures p >= 0 and gaps g = h + u - approach >= 0 with p g = 0, where u are the
 * displacements of an elastic half-space. Changing the problem does not touch the results: they
 * are those of the last wrc_normal_solve. Answers do not depend on earlier calls.
 */
typedef struct wrc_normal wrc_normal;

/** An empty problem. On failure *normal is NULL. Since 0.1. */
WRC_API wrc_status wrc_normal_create(wrc_normal** normal);
/** Does nothing with NULL. Since 0.1. */
WRC_API void wrc_normal_destroy(wrc_normal* normal);
/** Text of the last failure, "" if there was none. Since 0.1. */
WRC_API const char* wrc_normal_error(const wrc_normal* normal);

/**
 * The grid: numbers of elements (at least 1, at most 2^26 in all) and their sides in mm (1e-30 to
 * 1e30, neither more than 1e9 times the other). WRC_INVALID_ARGUMENT. Since 0.1.
 */
WRC_API wrc_status wrc_normal_set_grid(wrc_normal* normal, int64_t lateral_count,
                                       int64_t longitudinal_count, double lateral_step,
                                       double longitudinal_step);
/**
 * The undeformed distance h at the element centres, mm, finite, positive when apart; `count` values
 * with the longitudinal index fastest, which are copied. wrc_normal_solve needs as many as the
 * grid has elements. WRC_INVALID_ARGUMENT. Since 0.1.
 */
WRC_API wrc_status wrc_normal_set_distance(wrc_normal* normal, const double* values, int64_t count);
/**
 * Numbers by key:
 *   "combined_modulus"    MPa, 1e-30 to 1e30; 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2; steel on
 *                         steel by default: 210000/(2 (1 - 0.3^2))
 *   "normal_load"         N, 0 or 1e-60 to 1e60; replaces the approach
 *   "approach"            mm, -1e60 to 1e60; replaces the normal load
 *   "tolerance"           1e-13 to 0.1, default 1e-6. Solver "default": largest error of the
 *                         pressures relative to the largest, against the exact solution on this
 *                         grid, as measured. Solver "paper": update of the pressures and
 *                         complementarity
 *   "maximum_iterations"  a whole number, 1 to 1e9, default 5000
 * WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.1.
 */
WRC_API wrc_status wrc_normal_set_number(wrc_normal* normal, const char* key, double value);
/**
 * Texts by key; the first is the default:
 *   "solver"     "default", or "paper" (Polonsky & Keer 1999, always in double precision)
 *   "elements"   "smooth": a pressure is the value at the element's centre of one that is smooth
 *                inside the contact; or "constant": it is that everywhere on the element (Love
 *                1929), at five to ten times the error. Solver "paper": "constant" by default
 *   "precision"  "mixed": directions of the iteration in single precision; or "double"
 *   "planner"    "estimate": plans of transforms at once; or "measure": faster ones after seconds
 * WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.1.
 */
WRC_API wrc_status wrc_normal_set_text(wrc_normal* normal, const char* key, const char* value);

/**
 * Solves the problem. WRC_NOT_CONVERGED comes with usable results; on any other failure the results
 * of the last success remain. Since 0.1.
 */
WRC_API wrc_status wrc_normal_solve(wrc_normal* normal);

/**
 * A scalar result by name:
 *   "approach"      mm; "normal_force" N; "area" mm^2, counted in elements
 *   "pmax"          MPa, peak of a quadratic surface through the elements around the largest
 *   "pmax_element"  MPa, largest element
 *   "fill"          share of the elements under pressure, 0 to 1
 *   "iterations"    of all grids the solver went through
 *   "residuals.load_balance", "residuals.least_gap", "residuals.complementarity"
 *                   how well the problem is solved, recomputed in double precision when first
 *                   requested: |force - load|/load (0 for a given approach), least gap without
 *                   pressure (< 0: overlap) and largest |gap| under pressure, both over the
 *                   largest displacement
 * WRC_NO_RESULT, WRC_UNKNOWN_NAME. Since 0.1.
 */
WRC_API wrc_status wrc_normal_number(wrc_normal* normal, const char* name, double* value);
/** "stop_reason": "tolerance_met", "iteration_limit" or "stagnation". Since 0.1. */
WRC_API wrc_status wrc_normal_text(wrc_normal* normal, const char* name, const char** value);
/**
 * "pressure" (MPa) or "displacement" (mm, both bodies together, computed when first requested), one
 * value per element with the longitudinal index fastest; copied as by wrc_scene_field. Since 0.1.
 */
WRC_API wrc_status wrc_normal_field(wrc_normal* normal, const char* name, double* values,
                                    int64_t capacity, int64_t* count);

/* ---- Tangential contact of pressures given by the caller ------------------------------------ */

/**
 * Tractions and slip of two bodies of like elasticity that press on each other with given pressures
 * p and roll in +x, with Coulomb friction:
 *   s = w - du/dx,  w = (xi - phi y, eta + phi x)       slip and rigid slip, over the speed
 *   |q| <= friction p;  s = 0 where |q| is less;  q against s where s is not 0
 * with q the tractions on the wheel, u the displacements of the wheel relative to the rail, xi, eta
 * and phi the creepages, wheel minus rail (Kalker 1990). Frame: of the contact's plane, x forward,
 * y to the left, origin in the middle of the grid. Forces and moments act on the wheel. Changing
 * the problem does not touch the results: they are those of the last wrc_rolling_solve. Answers do
 * not depend on earlier calls, but for tractions set as previous ones.
 */
typedef struct wrc_rolling wrc_rolling;

/** An empty problem. On failure *rolling is NULL. Since 0.3. */
WRC_API wrc_status wrc_rolling_create(wrc_rolling** rolling);
/** Does nothing with NULL. Since 0.3. */
WRC_API void wrc_rolling_destroy(wrc_rolling* rolling);
/** Text of the last failure, "" if there was none. Since 0.3. */
WRC_API const char* wrc_rolling_error(const wrc_rolling* rolling);

/** The grid, around the origin; as wrc_normal_set_grid. Since 0.3. */
WRC_API wrc_status wrc_rolling_set_grid(wrc_rolling* rolling, int64_t lateral_count,
                                        int64_t longitudinal_count, double lateral_step,
                                        double longitudinal_step);
/**
 * The pressures at the element centres, 0 to 1e30 MPa, 0 outside the contact; `count` values with
 * the longitudinal index fastest, x and y growing with the indices, which are copied.
 * wrc_rolling_solve needs as many as the grid has elements. WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_set_pressure(wrc_rolling* rolling, const double* values,
                                            int64_t count);
/**
 * The tractions before a step or a shift ("contact" below), -1e30 to 1e30 MPa on the wheel,
 * `count` values each on the grid of the pressures, which moves with the contact; they are copied.
 * They stay until they are replaced, and steady rolling does not use them. With count 0 there are
 * none, as at first: the bodies were free of tractions. WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_set_previous(wrc_rolling* rolling, const double* traction_x,
                                            const double* traction_y, int64_t count);
/**
 * Numbers by key:
 *   "shear_modulus"          MPa, 1e-30 to 1e30; 1/G = (1/G1 + 1/G2)/2; steel by default:
 *                            210000/(2 (1 + 0.28))
 *   "poisson"                0 to 0.5, default 0.28; nu/G = (nu1/G1 + nu2/G2)/2
 *   "friction"               0 to 1e3, default 0.3
 *   "longitudinal_creepage"  xi, -1e30 to 1e30, default 0; of a shift: mm
 *   "lateral_creepage"       eta, the same
 *   "spin_creepage"          phi, 1/mm, the same, positive turns x to y; of a shift: rad
 *   "tolerance"              1e-10 to 0.1, default 1e-3: sum of the changes of q in one step of the
 *                            natural iteration q - r s, cut to the bound, over the sum of |q|
 *   "difference_parameter"   Kalker's K of unlike bodies, -0.5 to 0.5, default 0:
 *                            K/G = ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4, wheel 1, rail 2; steady
 *                            rolling by the full model only
 *   "derivatives"            1: "creepage_derivatives" are computed, for about the cost of the
 *                            solution; default 0
 *   "maximum_iterations"     of each of the grids gone through: a whole number, 1 to 1e9,
 *                            default 30
 *
 * WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_set_number(wrc_rolling* rolling, const char* key, double value);
/**
 * Texts by key; the first is the default:
 *   "model"       "full": the problem above; or "fastsim": FASTSIM (Kalker 1982) strip by strip on
 *                 these pressures, with flexibilities from solutions without slip on the same
 *                 elements; steady rolling only
 *   "contact"     "rolling": steady rolling; "transient": a step of rolling by the length h of one
 *                 element from the previous tractions, s = w + (u(x) - u'(x + h))/h; or "shift":
 *                 one without rolling, s = w + u - u' in mm
 *   "difference"  of rolling: "biased", upstream and of second order; or "first-order", as CONTACT
 *                 (Vollebregt) takes it, for comparison
 *
 * WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_set_text(wrc_rolling* rolling, const char* key, const char* value);

/**
 * Solves the problem. WRC_NOT_CONVERGED comes with usable results; on any other failure the results
 * of the last success remain. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_solve(wrc_rolling* rolling);
/**
 * Makes the tractions of the results the previous ones, for the next step or shift; solving does
 * not. WRC_NO_RESULT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_advance(wrc_rolling* rolling);

/**
 * A scalar result by name:
 *   "longitudinal_force", "lateral_force"  N
 *   "spin_moment"                   N mm, about the origin
 *   "slip_area", "adhesion_area"    mm^2, counted in elements
 *   "friction_power"                lost to friction, over the speed, N: -(force and moment times
 *                                   creepages); exact for steady rolling; of a shift: N mm; of
 *                                   unlike bodies with what pressures add to the creepages
 *   "numerical_loss"                the share of it that slip times traction does not show, from
 *                                   elements of finite size; 0 but for steady rolling
 *   "iterations", "convolutions"    on all grids
 *   "residual"                      reached; see "tolerance"
 *   "converged"                     1, or 0 with WRC_NOT_CONVERGED
 * WRC_NO_RESULT, WRC_UNKNOWN_NAME. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_number(wrc_rolling* rolling, const char* name, double* value);
/**
 * "traction_x", "traction_y" (MPa, on the wheel), "slip_x" or "slip_y" (over the speed; of a shift:
 * mm; 0 outside the contact), "normal_displacement" (mm: what the tractions open the gap of unlike
 * bodies by; added to the undeformed distance of wrc_normal it changes the pressures in turn), one
 * value per element with the longitudinal index fastest; or "creepage_derivatives", 9 values:
 * dFx/dxi, dFx/deta, dFx/dphi, then those of Fy and Mz (N, N mm, phi in 1/mm), 0 if not requested.
 * Copied as by wrc_scene_field. WRC_NO_RESULT, WRC_UNKNOWN_NAME, WRC_TOO_SMALL. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_field(wrc_rolling* rolling, const char* name, double* values,
                                     int64_t capacity, int64_t* count);

/* ---- Profiles ------------------------------------------------------------------------------ */

typedef struct wrc_profile wrc_profile;

#define WRC_WHEEL 0
#define WRC_RAIL 1

/** Names of the built-in profiles of a kind; NULL past the end. Since 0.1. */
WRC_API const char* wrc_profile_standard_name(int32_t kind, int64_t index);

/** An empty profile handle, which keeps the error text of a failed load. Since 0.1. */
WRC_API wrc_status wrc_profile_create(wrc_profile** profile);
WRC_API void wrc_profile_destroy(wrc_profile* profile);
WRC_API const char* wrc_profile_error(const wrc_profile* profile);

/** How a file is read. Set struct_size to sizeof(wrc_read_options), zero the rest. Since 0.1. */
typedef struct wrc_read_options {
  uint64_t struct_size;
  int32_t kind; /**< WRC_WHEEL or WRC_RAIL if kind_given is not 0; else by the file */
  int32_t kind_given;
  int32_t mirror_lateral; /**< 0: as the file needs; 1: mirror; -1: do not mirror */
  int32_t mirror_height;  /**< the same */
  int32_t strict;         /**< not 0: refuse instead of guessing */
  int32_t reserved;
  double scale;                /**< mm per unit of the file; 0: guess from the size */
  double smoothing_wavelength; /**< mm at which a wave is halved; 0: no smoothing */
} wrc_read_options;

/** A built-in profile, by name. WRC_UNKNOWN_NAME. Since 0.1. */
WRC_API wrc_status wrc_profile_load_standard(wrc_profile* profile, const char* name);
/** A file: two columns, Simpack .prr/.prw, MiniProf .ban/.whl; options may be NULL. Since 0.1. */
WRC_API wrc_status wrc_profile_load_file(wrc_profile* profile, const char* path,
                                         const wrc_read_options* options);
/** Writes a file, two columns or by extension .prr/.prw, with points `spacing` mm apart along the
 * arc; written aside, then renamed. Since 0.1. */
WRC_API wrc_status wrc_profile_write(wrc_profile* profile, const char* path, double spacing);

/**
 * A profile through points, `count` of each coordinate in mm in either order, copied; treated as
 * the points of a file (docs of the options above), whose kind must be given. `name` identifies
 * them in messages. WRC_INVALID_ARGUMENT. Since 0.2.
 */
WRC_API wrc_status wrc_profile_set_points(wrc_profile* profile, const char* name,
                                          const double* lateral, const double* height,
                                          int64_t count, const wrc_read_options* options);
/**
 * Lets a scene use a loaded profile, of which it keeps a copy: a wheel for "wheelset.wheel", a rail
 * for "track.rail". Setting that key by name removes it again. WRC_INVALID_ARGUMENT,
 * WRC_NO_RESULT for an empty profile. Since 0.2.
 */
WRC_API wrc_status wrc_scene_set_profile(wrc_scene* scene, const char* key, wrc_profile* profile);

/** Kind, and texts: "name", "title", "source", "confidence". Since 0.1. */
WRC_API wrc_status wrc_profile_kind(wrc_profile* profile, int32_t* kind);
WRC_API wrc_status wrc_profile_text(wrc_profile* profile, const char* name, const char** value);
/** Corrections made while reading, one line each; NULL past the end. Since 0.1. */
WRC_API const char* wrc_profile_correction(const wrc_profile* profile, int64_t index);

/** Arc length of the curve, mm. Since 0.1. */
WRC_API wrc_status wrc_profile_length(wrc_profile* profile, double* length);
/** Arc lengths of the curve's nodes (as wrc_scene_field copies). Since 0.1. */
WRC_API wrc_status wrc_profile_nodes(wrc_profile* profile, double* arcs, int64_t capacity,
                                     int64_t* count);
/**
 * The curve at an arc length, clamped to the curve: lateral and height in mm (height of a wheel
 * positive towards larger radius, of a rail upwards), inclination of the tangent in rad, signed
 * curvature in 1/mm (positive: bends towards larger height). Pointers may be NULL. Since 0.1.
 */
WRC_API wrc_status wrc_profile_at(wrc_profile* profile, double arc, double* lateral, double* height,
                                  double* angle, double* curvature);

/* ---- The whole process --------------------------------------------------------------------- */

/**
 * Fast Fourier transforms are planned one at a time in the whole process, under a lock of the
 * library. A program that plans with FFTW itself sets its own lock here, which is then held around
 * all planning too; both functions are called with `context` and must not throw. A program that
 * calls the library while it holds its lock needs a recursive one. Both NULL removes it again.
 * Must be called while no other thread uses the library. WRC_INVALID_ARGUMENT for one function
 * without the other. Since 0.1.
 */
WRC_API wrc_status wrc_set_planner_lock(void (*lock)(void* context), void (*unlock)(void* context),
                                        void* context);
/**
 * Wisdom: what the planner "measure" has learnt in this process. The file is read or written by
 * these calls only. WRC_INVALID_ARGUMENT, WRC_FILE_UNREADABLE,
 * WRC_FILE_MALFORMED. Since 0.1.
 */
WRC_API wrc_status wrc_load_wisdom(const char* path);
WRC_API wrc_status wrc_save_wisdom(const char* path);
/**
 * The benchmark's yardstick: the median time in ms of `repeats` (1 to 1000) pairs of a real
 * transform of rows x columns values in double precision and its inverse, by FFTW's own
 * two-dimensional transform with estimated plans. Planning and one pair beforehand are not timed.
 * Sizes from 1, at most 2^28 values in all. WRC_INVALID_ARGUMENT, WRC_OUT_OF_MEMORY. Since 0.1.
 */
WRC_API wrc_status wrc_measure_transform(int64_t rows, int64_t columns, int32_t repeats,
                                         double* median_ms);

#ifdef __cplusplus
}
#endif

#endif
