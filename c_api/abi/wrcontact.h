/**
 * @file
 * wrcontact: where and how hard wheels press on rails.
 *
 * From wheel and rail profiles, track, wheelset position and load this library finds the contact
 * points of both wheels and the patches around them. It samples the undeformed distance on an
 * equally spaced grid in the plane of each patch, and solves the non-Hertzian normal contact of
 * elastic half-spaces for all patches of a wheel together. On request it adds creep forces,
 * stresses and wear.
 *
 * Units:   mm, N, MPa, rad; the key convention.units of a scene selects m, N, Pa, rad.
 * Frame:   track frame, x forward, y to the left, z up, right-handed; origin at the track centre in
 *          the plane of the rail tops. Roll > 0 lifts the left wheel, yaw > 0 is anticlockwise seen
 *          from above. Profile coordinates are positive to the field side. The key
 *          convention.frame of a scene selects y to the right and z down.
 * Errors:  functions return WRC_OK or another wrc_status. The handle keeps the text of its last
 *          failure (wrc_scene_error and so on) until its next call. A failed call leaves the handle
 *          unchanged. No function throws, prints or ends the program; docs/c.md names the one case
 *          in which FFTW may end it for lack of memory, and the rules for memory and fork().
 * Handles: a handle is a number disguised as a pointer and looked up at each call. A handle that
 *          has been destroyed, or is of another kind, is rejected with WRC_INVALID_ARGUMENT.
 * Threads: all functions may be called from any thread. A handle serves one call at a time; a
 *          second call at the same time returns WRC_BUSY. Different handles are independent. A
 *          thread needs a stack of 64 kB.
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

/* A function that has left the interface: compilers that can refuse it name its successor. */
#if defined(__has_attribute)
#if __has_attribute(unavailable)
#define WRC_REMOVED(successor) __attribute__((unavailable(successor)))
#elif __has_attribute(error)
#define WRC_REMOVED(successor) __attribute__((error(successor)))
#endif
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
/** Version of the library, for example "0.4.0". Since 0.1. */
WRC_API const char* wrc_version(void);

/* ---- Scene: the input and its results ------------------------------------------------------ */

typedef struct wrc_scene wrc_scene;

/**
 * wrc_scene_create: a scene with the defaults of the paper's Table 1. On failure *scene is NULL.
 * The symbol names the interface, so that a program compiled with a header before 0.4, some of
 * whose keys are gone, is refused when it is linked or loaded. Since 0.1, this symbol since 0.4.
 */
WRC_API wrc_status wrc_scene_create_0_4(wrc_scene** scene);
#define wrc_scene_create wrc_scene_create_0_4

/** Does nothing with NULL. Since 0.1. */
WRC_API void wrc_scene_destroy(wrc_scene* scene);
/** Text of the last failure, "" if there was none. Since 0.1. */
WRC_API const char* wrc_scene_error(const wrc_scene* scene);

/**
 * Sets a key of the scene, for example "pose.lateral". wrc_scene_key lists all keys with their
 * defaults and permitted values. Keys of one subject replace each other: the last call applies
 * (load.both and load.left, material.poisson and material.wheel.poisson,
 * solve.accuracy and solve.grid). The keys convention.units and convention.frame set the units and
 * frame of numbers passed to and returned by later calls; values set before keep their
 * meaning. The key solve.until stops after one of the three modules. Options of a profile are keys
 * behind that of the profile, "track.rail.smoothing", or part of its text, "worn.txt; smoothing =
 * 5" (docs/profiles.md). WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.1.
 */
WRC_API wrc_status wrc_scene_set_number(wrc_scene* scene, const char* key, double value);
WRC_API wrc_status wrc_scene_set_text(wrc_scene* scene, const char* key, const char* value);
WRC_API wrc_status wrc_scene_set_numbers(wrc_scene* scene, const char* key, const double* values,
                                         int64_t count);

/**
 * The values of keys, in the scene's convention: a text if it is a word ("solve", "none"),
 * otherwise a number or a list, copied as by wrc_scene_field. WRC_INVALID_ARGUMENT if the value is
 * of another type, or if there is no single one (load.both with different loads on the wheels).
 * Since 0.2.
 */
WRC_API wrc_status wrc_scene_get_number(wrc_scene* scene, const char* key, double* value);
WRC_API wrc_status wrc_scene_get_text(wrc_scene* scene, const char* key, const char** value);
WRC_API wrc_status wrc_scene_get_numbers(wrc_scene* scene, const char* key, double* values,
                                         int64_t capacity, int64_t* count);

/** Description of a key; the texts belong to the library and remain valid. Since 0.1. */
WRC_API int64_t wrc_scene_key_count(void);
WRC_API wrc_status wrc_scene_key(int64_t index, const char** name, const char** default_value,
                                 const char** allowed, const char** meaning);

/**
 * Solves geometry, remesh and mechanics of the wheels in solve.side. WRC_NOT_CONVERGED comes with
 * usable results; on any other failure the results of the last success remain. A profile's file is
 * read again if it has changed since the scene's last solution. Since 0.1.
 */
WRC_API wrc_status wrc_scene_solve(wrc_scene* scene);

/**
 * Writes the scene as a TOML file. With the same library on the same machine, wrc_case then gives
 * the same bits as wrc_scene_solve. Numbers are in mm, N, MPa, y left, z up, whatever the
 * scene's convention. The points of profiles set by wrc_scene_set_profile are written to files
 * beside it. WRC_FILE_UNREADABLE if it cannot be written. Since 0.2.
 */
WRC_API wrc_status wrc_scene_write(wrc_scene* scene, const char* path);

/**
 * A scalar result by name: "roll", "vertical", "left.pmax", "right.patches.0.angle",
 * "left.patches.1.centroid.y", "time_ms.total" and so on (docs/results.md lists and defines them).
 * Names of a wheel refer to all its patches together; patches are numbered from 0, largest normal
 * force first; "left.patch_count" is their number. Patches that share a plane count as one with
 * parts: "left.patches.0.parts.1.pmax". WRC_UNKNOWN_NAME if there is no patch of that index.
 * Largest pressures and tractions are NaN where the end of a body cuts a contact: they have no
 * bound there (docs/warnings.md, profile_end). Since 0.1.
 */
WRC_API wrc_status wrc_scene_number(wrc_scene* scene, const char* name, double* value);
/**
 * Access by id, for vehicle simulations: the same as wrc_scene_set_number and wrc_scene_number,
 * twenty times as fast. An id stands for a key, or for the name of a result, in every scene, solved
 * or not. "left.patches.3.pmax" has an id even if the scene has fewer patches (indices 0 to 1023,
 * of parts 0 to 254). Ids are valid for one version of the library: look them up whenever the
 * program starts. Options of profiles have none. WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_scene_key_id(wrc_scene* scene, const char* key, int32_t* id);
WRC_API wrc_status wrc_scene_number_id(wrc_scene* scene, const char* name, int32_t* id);
/**
 * Sets the keys of `count` ids (at most 2^20) to numbers, in this order. If one is refused, none is
 * set, and the error text names its key, value and range. WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_scene_set_numbers_by_id(wrc_scene* scene, const int32_t* ids,
                                               const double* values, int64_t count);
/**
 * The results of `count` ids (at most 2^20), from the call that last solved the scene. Results that
 * do not exist, such as those of an absent patch, are NaN. Values are set only if all ids are those
 * of results. WRC_NO_RESULT, WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_scene_numbers_by_id(wrc_scene* scene, const int32_t* ids, double* values,
                                           int64_t count);
/**
 * The unit of the result of that name in any scene with the same convention.units: "MPa",
 * "N mm/s", or "1" for counts and ratios. Valid until the next call for a unit. WRC_UNKNOWN_NAME.
 * Since 0.3.
 */
WRC_API wrc_status wrc_scene_number_unit(wrc_scene* scene, const char* name, const char** unit);
/**
 * Likewise the unit of the number that a key holds: "N", "mm/s", "1"; "" if it holds a text or a
 * list. WRC_UNKNOWN_NAME. Since 0.4.
 */
WRC_API wrc_status wrc_scene_key_unit(wrc_scene* scene, const char* key, const char** unit);
/** A text result by name: "model", "units", "left.stop_reason", "left.warnings.0". Since 0.1. */
WRC_API wrc_status wrc_scene_text(wrc_scene* scene, const char* name, const char** value);
/**
 * All warnings of a solved scene, one line each: of its profiles, then of the left and the right
 * wheel; NULL past the end. Each begins with its subject: "wheel profile worn.prw: ", "left: ",
 * "right: patch 1: ". The result warning_count (wrc_scene_number) is their number, and
 * "warning_classes.0" (wrc_scene_text) the class of the first one (docs/warnings.md). The
 * texts are valid until the scene is solved again. Since 0.3.
 */
WRC_API const char* wrc_scene_warning(const wrc_scene* scene, int64_t index);
/**
 * A field by name: of a patch of the side "left" or "right", one value per element with the
 * longitudinal index fastest: "left.patches.0.x", ".y", ".z" (element centres),
 * ".undeformed_distance", ".pressure", ".displacement"; "left.pressure" and so on is short for
 * "left.patches.0.pressure" and has no values without contact. For a patch with parts these are
 * means over the elements of a grid that spans all parts; "left.patches.0.parts.1.pressure" is
 * the field of a part as it was solved. The outlines of the cross section of a side are
 * "left.rail_y", ".rail_z", ".wheel_y", ".wheel_z". Copies at most `capacity`
 * values into `values` and sets *count to the length; with capacity 0 (values may be NULL) it only
 * returns the length. WRC_TOO_SMALL if the length exceeds a capacity > 0; nothing is copied then.
 * Since 0.1.
 */
WRC_API wrc_status wrc_scene_field(wrc_scene* scene, const char* name, double* values,
                                   int64_t capacity, int64_t* count);
/** Names of all available results, in a fixed order. Since 0.1. */
WRC_API int64_t wrc_scene_number_count(const wrc_scene* scene);
WRC_API const char* wrc_scene_number_name(const wrc_scene* scene, int64_t index);
/**
 * Names of all numbers that a result may have, entries of lists as entry 0
 * ("left.patches.0.parts.0.pmax"); NULL past the end. The texts belong to the library and remain
 * valid. Since 0.4.
 */
WRC_API const char* wrc_result_name(int64_t index);
WRC_API int64_t wrc_scene_text_count(const wrc_scene* scene);
WRC_API const char* wrc_scene_text_name(const wrc_scene* scene, int64_t index);

/* ---- Solver: data kept from one scene to the next ------------------------------------------*/

typedef struct wrc_solver wrc_solver;

/**
 * Keeps profiles, surfaces, influence coefficients, transform plans and memory between solutions,
 * which saves time and changes no bit of a result. In vehicle simulations use one solver per
 * wheelset for all time steps, in any order. Since 0.1.
 */
WRC_API wrc_status wrc_solver_create(wrc_solver** solver);
WRC_API void wrc_solver_destroy(wrc_solver* solver);
WRC_API const char* wrc_solver_error(const wrc_solver* solver);

/**
 * Same as wrc_scene_solve, to the last bit by default, whatever was solved before, but faster. The
 * scene's handle holds the results and the error text. Use the same scene repeatedly and change its
 * pose. Since 0.1; the same bits since 0.3.
 */
WRC_API wrc_status wrc_solver_solve(wrc_solver* solver, wrc_scene* scene);
/**
 * Options of the solver; no result changes by more than its tolerance. From the next solution on:
 *   "planner"    "estimate", or "measure": FFTW times its algorithms once for each size
 *   "precision"  "mixed", or "double": of the iteration for pressures
 * WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.4.
 */
WRC_API wrc_status wrc_solver_set_text(wrc_solver* solver, const char* key, const char* value);
/** Drops what the solver keeps but its options, so that profile files are read again. Since 0.3. */
WRC_API wrc_status wrc_solver_clear(wrc_solver* solver);

/**
 * Solves many scenes (at most 2^24) independently, as wrc_scene_solve does, on up to `threads`
 * threads (1 to 1024); the bits are the same for any number of threads. The handles must all be
 * different, or none is solved. statuses (may be NULL) gets the status of each scene, the scene
 * its error text.
 * Returns WRC_OK if all were solved, otherwise the status of the first that was not. Since 0.1.
 */
WRC_API wrc_status wrc_solve_batch(wrc_scene* const* scenes, int64_t count, int32_t threads,
                                   wrc_status* statuses);

/* ---- Vehicle simulations ------------------------------------------------------------------- */

/** Flags of the result left.state (right.state), and of a step. Since 0.3. */
#define WRC_LIFTED 1          /**< no contact */
#define WRC_ON_FLANGE_TIP 2   /**< a patch beyond the steepest point of the flange: derailing */
#define WRC_ON_CHAMFER 4      /**< a patch beyond the tread, on the field side */
#define WRC_BEYOND_YIELD 8    /**< pmax above 1.44 of the smaller material.*.yield_stress */
#define WRC_SOLVED_EXACTLY 16 /**< a table asked the exact solution */
#define WRC_BEYOND_LOAD 64    /**< a table went on beyond its largest load, after Hertz */
#define WRC_AT_PART_END 32    /**< contact that an end or side of a part that varies cuts */

/** Values of the results grade, left.grade and right.grade (docs/warnings.md). Since 0.4. */
#define WRC_FINE 0          /**< as accurate as requested; warnings are notes on the input */
#define WRC_SLIGHTLY_OVER 1 /**< error estimate up to twice the accuracy */
#define WRC_DO_NOT_USE 2    /**< above that, or numbers of other bodies than those meant */

/**
 * Computes the forces on both wheels of a wheelset from its position and velocity. It sets the keys
 * pose.lateral, .vertical, .roll, .yaw (also .longitudinal and .pitch where a rail varies along the
 * track or a wheel around its circumference) and motion.speed, .lateral, .vertical, .roll, .pitch,
 * .yaw (and solve.derivatives) and calls wrc_solver_solve. All other keys of the scene keep their
 * values, and all its results can be read. Numbers are in the scene's convention.
 *
 * position:    x, y, z, roll, pitch angle, yaw of the wheelset's centre, z above the rail tops;
 *              x and the pitch angle count only where a rail or a wheel varies.
 * velocity:    their rates; that of the pitch angle is positive when the axle rolls forward.
 * rails:       irregularities: lateral and vertical displacement and roll of the left rail, then
 *              of the right one (track.left.displacement); they stay in force for later steps.
 *              NULL: unchanged.
 * force:       12 numbers: of the left wheel force x, y, z and moment x, y, z about the wheelset's
 *              centre, then of the right wheel. Zeros without contact.
 * by_position, by_velocity: 72 numbers each, or NULL: derivatives of the left wheel's six numbers
 *              by the first position, by the second, ...; then of the right wheel. Each holds the
 *              other variables fixed. They cost nothing if both are NULL.
 * states:      2 numbers, or NULL: flags of the left and the right wheel.
 *
 * On failure the scene and the arrays keep their values; the scene holds the error text.
 * WRC_INVALID_ARGUMENT, WRC_NO_CONTACT for a wheel beside its rail, WRC_NOT_CONVERGED with results.
 * Since 0.3.
 */
WRC_API wrc_status wrc_solver_step(wrc_solver* solver, wrc_scene* scene, const double* position,
                                   const double* velocity, const double* rails, double* force,
                                   double* by_position, double* by_velocity, int32_t* states);
/**
 * Steps of `count` wheelsets (at most 2^24), each with its own solver and scene, on up to
 * `threads` threads (1 to 1024); the bits are the same for any number of threads. Arrays hold the
 * arrays of wrc_solver_step, one wheelset after the other; rails, by_positions, by_velocities,
 * states and statuses may be NULL. Returns WRC_OK if all were solved, otherwise the first other
 * status. Since 0.3.
 */
WRC_API wrc_status wrc_step_batch(wrc_solver* const* solvers, wrc_scene* const* scenes,
                                  int64_t count, int32_t threads, const double* positions,
                                  const double* velocities, const double* rails, double* forces,
                                  double* by_positions, double* by_velocities, int32_t* states,
                                  wrc_status* statuses);

/**
 * What the contacts of a wheelset remember from one step of time to the next: the displacements
 * under their tractions. A new one has none. A step with a history (wrc_step_arguments.histories)
 * starts from the state last accepted and keeps the state after it beside that; so it may be
 * repeated, and rejected by not accepting it. It serves one thread at a time.
 */
typedef struct wrc_history wrc_history;

/** Creates a handle without displacements; destroys it; its error text. Since 0.3. */
WRC_API wrc_status wrc_history_create(wrc_history** history);
WRC_API void wrc_history_destroy(wrc_history* history);
WRC_API const char* wrc_history_error(const wrc_history* history);
/**
 * Lets later steps start from the state after the last step that did not fail: once for each step
 * of time that the program keeps. Does nothing if there was none since the last call. Since 0.3.
 */
WRC_API wrc_status wrc_history_accept(wrc_history* history);
/** Back to the state of a new handle. Since 0.3. */
WRC_API wrc_status wrc_history_clear(wrc_history* history);
/** Makes the state of `history` that of another one, for a later return to it. WRC_BUSY,
 * WRC_INVALID_ARGUMENT. Since 0.3. */
WRC_API wrc_status wrc_history_copy(wrc_history* history, wrc_history* from);

/**
 * Further arguments of a step, each NULL if it is not used. Set struct_size to
 * sizeof(wrc_step_arguments) and zero the rest. Inputs stay in force for later steps; NULL: as in
 * the scene. In a batch each array holds the numbers of all wheelsets, one after the other.
 * Since 0.3.
 */
typedef struct wrc_step_arguments {
  uint64_t struct_size;
  const double* rails;           /**< 6 numbers, as in wrc_solver_step */
  const double* rail_velocities; /**< 6, their rates (track.left.velocity) */
  const double* curvature;       /**< of the track (motion.curvature), positive to the left */
  const double* friction;        /**< coefficients of the left and the right wheel */
  double* by_position;           /**< 72, as in wrc_solver_step */
  double* by_velocity;           /**< 72 */
  /** 36: derivatives of the left wheel's six numbers by the left rail's lateral displacement, by
   * its vertical displacement and by its roll; then of the right wheel by the right rail's. */
  double* by_rail;
  double* by_rail_velocity; /**< 36, by their rates */
  int32_t* states;          /**< 2, as in wrc_solver_step */
  /** 1, a handle for each wheelset: creep forces of a step of time from its history, instead of
   * steady rolling. Does not stay in force. Derivatives by velocities then include what adhesion
   * resists over the step. */
  wrc_history* const* histories;
  double time_step; /**< s, from the state accepted last, 1e-9 to 1e9; 0 without histories */
  /** 4, of wrc_table_step only: the error that 99 % of the forces of the left wheel keep, over its
   * load as there; that of the columns of its derivatives, each over itself; then of the right
   * wheel. Since 0.4. */
  double* likely_errors;
  /** 2 x WRC_TABLE_OUTPUTS, of wrc_table_step only: what wrc_table_output_name lists, of the left
   * wheel, then of the right one; and the errors that 99 % of them keep. Since 0.4. */
  double* outputs;
  double* output_errors;
} wrc_step_arguments;

/** wrc_solver_step with further arguments; `arguments` may be NULL. Since 0.3. */
WRC_API wrc_status wrc_solver_step_with(wrc_solver* solver, wrc_scene* scene,
                                        const double* position, const double* velocity,
                                        const wrc_step_arguments* arguments, double* force);
/** wrc_step_batch with further arguments; `arguments` may be NULL. Since 0.3. */
WRC_API wrc_status wrc_step_batch_with(wrc_solver* const* solvers, wrc_scene* const* scenes,
                                       int64_t count, int32_t threads, const double* positions,
                                       const double* velocities,
                                       const wrc_step_arguments* arguments, double* forces,
                                       wrc_status* statuses);

#define WRC_LOADS_OF_WHEELS 0
#define WRC_LOAD_OF_AXLE 1

/**
 * Static equilibrium: the height and the roll at which a wheelset carries given loads, with the
 * forces there.
 *
 * kind, loads: WRC_LOADS_OF_WHEELS: the vertical forces of the rails on the left and the right
 *              wheel, N, each > 0. WRC_LOAD_OF_AXLE: the vertical force with which the vehicle
 *              presses the axle down, > 0, and the moment about x through the wheelset's centre
 *              of the vehicle's forces on it. On a canted track "vertical" is across its plane.
 * velocity:    as in wrc_solver_step; NULL: as in the scene, which by default has no creep forces.
 * arguments:   as in wrc_solver_step_with; may be NULL.
 * position:    6 numbers as in wrc_solver_step. y and yaw are used; z and roll are set.
 * force:       12 numbers as in wrc_solver_step.
 *
 * Sets the keys that wrc_solver_step sets; all results can be read. On failure scene and arrays
 * keep their values; the scene holds the error text. WRC_INVALID_ARGUMENT, WRC_NO_CONTACT,
 * WRC_NOT_CONVERGED with position, force and results where the loads are met only roughly.
 * Since 0.3.
 */
WRC_API wrc_status wrc_solver_equilibrium(wrc_solver* solver, wrc_scene* scene, int32_t kind,
                                          const double* loads, const double* velocity,
                                          const wrc_step_arguments* arguments, double* position,
                                          double* force);

/**
 * A contact patch, in the scene's convention. Members have the names of results, with underscores
 * instead of points. Since 0.3.
 */
typedef struct wrc_patch {
  double wheel; /**< 0: left, 1: right */
  double x;     /**< contact reference, track frame */
  double y;
  double z;
  double normal_x; /**< from the rail to the wheel */
  double normal_y;
  double normal_z;
  double angle; /**< of the plane about x */
  double rolling_radius;
  double s_wheel; /**< position on the wheel's profile, from the taping line to the field side */
  double normal_force;             /**< of the pressures */
  double creep_force_longitudinal; /**< on the wheel */
  double creep_force_lateral;      /**< along the patch's plane */
  double spin_moment;
  double creepage_longitudinal;
  double creepage_lateral;
  double creepage_spin;
  double semi_axes_longitudinal; /**< of the Hertzian ellipse with its second moments of pressure */
  double semi_axes_lateral;
  double approach;
  double pmax; /**< NaN where the end of a body cuts the patch: pressures have no bound there */
  double friction_power;     /**< force times length per time */
  double longitudinal_force; /**< of the rail on the wheel, creep forces included, track frame */
  double lateral_force;
  double vertical_force;
  double pressure_force_x; /**< the part of it that comes from the pressures */
  double pressure_force_y;
  double pressure_force_z;
  double coupling_weight; /**< to its closest neighbour */
} wrc_patch;

/**
 * All patches of a result: those of the left wheel, then of the right one. The patches of a wheel
 * are ordered by position, starting at the flange, so that the order is the same from step to step.
 * Copies at most `capacity` patches and sets *count to their number. struct_size is
 * sizeof(wrc_patch), so that programs compiled with earlier headers get the members they know. With
 * capacity 0 (patches may be NULL) it only returns the number. WRC_TOO_SMALL if that exceeds a
 * capacity > 0; nothing is copied then. WRC_NO_RESULT. Since 0.3.
 */
WRC_API wrc_status wrc_scene_patches(wrc_scene* scene, wrc_patch* patches, int64_t struct_size,
                                     int64_t capacity, int64_t* count);

/**
 * Creep forces of a patch at creepages computed by the caller, for programs with their own
 * kinematics. Friction, model (solve.creep) and accuracy are those of the scene; motion.speed is
 * the speed used by a falling friction law. The scene and its result do not change.
 *
 * patch:       from 0, in the order of wrc_scene_patches.
 * creepages:   longitudinal, lateral, spin, wheel minus rail over the speed, in the patch's plane
 *              at its reference.
 * forces:      3 numbers: longitudinal and lateral force on the wheel, spin moment.
 * by_creepage: 9 numbers, or NULL: derivatives of the first by the three creepages, of the second,
 *              of the third, at a fixed coefficient of friction.
 * The scene holds the error text. WRC_NO_RESULT, WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_solver_creep(wrc_solver* solver, wrc_scene* scene, int64_t patch,
                                    const double* creepages, double* forces, double* by_creepage);

/**
 * A table of results over all combinations of values of some keys, for programs that cannot afford
 * a solution per step. The scene and its result do not change.
 *
 * keys:    names separated by blanks, each once: "pose.lateral pose.yaw load.both".
 * values:  those of the first key, then of the second, ...; counts is the number for each key.
 * results: names separated by blanks, "left.total.force.y left.patches.0.angle".
 * threads: 1 to 1024; the same bits for any number.
 * path:    a text file of columns, keys first, under comments with the scene, units and names; NULL
 *          or "": none.
 * table:   the results of the first combination, of the next, ..., the first key fastest; may be
 *          NULL if there is a file. NaN: no contact, or no such patch. At most 2^28
 *          numbers.
 * On failure the table does not change. WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT,
 * WRC_FILE_UNREADABLE. Since 0.3.
 */
WRC_API wrc_status wrc_scene_tabulate(wrc_scene* scene, const char* keys, const double* values,
                                      const int64_t* counts, const char* results, int32_t threads,
                                      const char* path, double* table);

/* ---- Tables that state their error ----------------------------------------------------------- */

/**
 * Contact forces of a wheelset from a table, for real time: made by the library for one pair of
 * profiles, it answers in microseconds with all derivatives and says how far it may be off
 * (docs/table.md). Several threads each use a handle of their own to one table
 * (wrc_table_share). Since 0.3.
 */
typedef struct wrc_table wrc_table;

/** What a table has of each wheel beside its forces. Since 0.4. */
#define WRC_TABLE_OUTPUTS 8
/** Their names: wear_number (frictional work over the distance), centre of pressure on the rail and
 * on the wheel, contact angle there (positive on the flange) and rolling radius, normal forces of
 * the tread and of the flange, and whether the wheel is on the flange tip (1 or 0); as results of a
 * wheel where there is one. NULL past the end. Since 0.4. */
WRC_API const char* wrc_table_output_name(int64_t index);

/** What a table reaches and how fine it is. Set struct_size to sizeof(wrc_table_options) and zero
 * the rest: zeros stand for the defaults. Lengths and angles against the rail, in the scene's
 * convention. Since 0.3. */
typedef struct wrc_table_options {
  uint64_t struct_size;
  double lateral; /**< from minus to plus this, of each wheel; 10 mm */
  double roll;    /**< likewise, 0.01 rad */
  double yaw;     /**< likewise, 0.02 rad */
  double load;    /**< largest vertical force of a wheel, 150 kN */
  /** Likely error, over load as in wrc_table_facts, beyond which a step with a solver takes the
   * exact solution; 0: only outside the table. */
  double tolerance;
  double fineness; /**< of the nodes, 0.2 to 4; 1. Time and memory grow with its cube. */
  int64_t threads; /**< 1 to 1024; 1. The same bits for any number. */
  /** File that keeps what is finished, written every 20 s and when the build ends or is stopped,
   * from which the next build with the same scene and options goes on, to the same bits. Remove it
   * once the table is saved. One of another table is WRC_FILE_MALFORMED. NULL: none. Since 0.4. */
  const char* resume_file;
} wrc_table_options;

/** What a table is and what held-out random states say of it: errors of a wheel's force over its
 * vertical force, or over half of `load` if that is more. Since 0.3. */
typedef struct wrc_table_facts {
  uint64_t struct_size; /**< sizeof(wrc_table_facts), set by the caller */
  double lateral;       /**< as in wrc_table_options */
  double roll;
  double yaw;
  double load;
  double tolerance;
  double states;         /**< number of random states after the table was finished */
  double beyond;         /**< of them those that err by more than the error returned with them */
  double beyond_at_most; /**< fraction of all states that do, at most, with 95 % certainty */
  double median_error;
  double error_99; /**< that 99 in 100 do not exceed */
  double worst_error;
  double exact_share; /**< fraction of cells that err by more than the tolerance; steps beside such
                       * cells have a part of the exact solution, too */
  double bytes;       /**< of memory */
  double beyond_likely; /**< of `states`, those that err by more than the likely error returned with
                         * them. Since 0.4. */
  double derivatives_error; /**< median over the table of the likely error of derivatives; since
                             * 0.4 */
} wrc_table_facts;

/** An empty handle, which keeps the error text of its calls. Since 0.3. */
WRC_API wrc_status wrc_table_create(wrc_table** table);
WRC_API void wrc_table_destroy(wrc_table* table);
WRC_API const char* wrc_table_error(const wrc_table* table);

/**
 * Makes a table of a scene's profiles, track and materials, which must be the same for both wheels.
 * The scene's position, loads, motion and accuracy do not matter; its friction and
 * motion.standstill_speed are those of steps. `options` may be NULL. Takes minutes; `progress`, if
 * it is not NULL, is called now and then by the calling thread with `context` and the finished
 * fraction, must not throw, and ends the build by any result but 0. On failure the handle keeps the
 * table that it had. WRC_INVALID_ARGUMENT, WRC_NO_CONTACT where the range of `lateral` reaches
 * beyond the rail, WRC_NO_RESULT if `progress` stops it, WRC_FILE_MALFORMED and
 * WRC_FILE_UNREADABLE of `resume_file`. Since 0.3.
 */
WRC_API wrc_status wrc_table_build(wrc_table* table, wrc_scene* scene,
                                   const wrc_table_options* options,
                                   int32_t (*progress)(void* context, double fraction),
                                   void* context);
/** A file for other programs of the same version of the format, tens of MB. Files are checked when
 * they are read. WRC_NO_RESULT, WRC_FILE_UNREADABLE, WRC_FILE_MALFORMED. Since 0.3. */
WRC_API wrc_status wrc_table_save(wrc_table* table, const char* path);
WRC_API wrc_status wrc_table_load(wrc_table* table, const char* path);
/** Lets another handle use the same table, in the same memory; does nothing if `other` is `table`.
 * WRC_NO_RESULT. Since 0.3. */
WRC_API wrc_status wrc_table_share(wrc_table* table, wrc_table* other);
/** What a table is of, one line each: profiles, dimensions, materials and friction as keys of a
 * scene, the units and axes of steps without a scene, and how far it reaches; NULL past the end.
 * Since 0.3. */
WRC_API const char* wrc_table_line(const wrc_table* table, int64_t index);
/** WRC_NO_RESULT, WRC_INVALID_ARGUMENT. Since 0.3. */
WRC_API wrc_status wrc_table_get_facts(wrc_table* table, wrc_table_facts* facts);

/**
 * Forces on both wheels as wrc_solver_step_with gives them, from the table. Arguments that are NULL
 * are 0 here, and friction is that of the table. The flags of `states` are WRC_LIFTED,
 * WRC_ON_FLANGE_TIP, WRC_ON_CHAMFER and WRC_SOLVED_EXACTLY, with the others where a wheel was
 * solved.
 *
 * solver, scene: those of wrc_solver_step_with, or both NULL. The scene has the profiles,
 *              dimensions and materials of the table; all numbers are in its units and axes. A step
 *              is solved exactly outside the table and where the table's error exceeds its
 *              tolerance. Forces blend into the exact ones with a continuous slope: near the border
 *              over the last twentieth of each range, elsewhere over one cell of the map of errors.
 *              The scene keeps its keys and results. Without them numbers are in the units and axes
 *              of the scene that the table was made of, a step outside is WRC_INVALID_ARGUMENT, and
 *              the text says which wheel is where.
 *
 * error:       2 numbers, or NULL: how far the force of each wheel may be off, over its vertical
 *              force, or over half of the table's largest load if that is more: a bound, which 1 in
 *              1000 random states with friction of 0.1 to 0.6 exceed at most. It grows with
 *              friction. `arguments` has the likely error.
 *
 * WRC_NOT_CONVERGED, with all results: the exact solution. On other failures the arrays keep their
 * values; the table holds the error text. Since 0.3.
 */
WRC_API wrc_status wrc_table_step(wrc_table* table, wrc_solver* solver, wrc_scene* scene,
                                  const double* position, const double* velocity,
                                  const wrc_step_arguments* arguments, double* force,
                                  double* error);

/**
 * wrc_solver_equilibrium by the table: the height and the roll at which a wheelset carries given
 * loads, of at most the table's largest each, and the step there. Numbers are in the units and axes
 * of the scene that the table was made of.
 *
 * arguments: as in wrc_table_step; may be NULL.
 * error:     as in wrc_table_step, or NULL.
 *
 * WRC_INVALID_ARGUMENT, WRC_NO_RESULT, WRC_NOT_CONVERGED, where a wheel lifts or the table ends;
 * the arrays then keep their values. Since 0.4.
 */
WRC_API wrc_status wrc_table_equilibrium(wrc_table* table, int32_t kind, const double* loads,
                                         const double* velocity,
                                         const wrc_step_arguments* arguments, double* position,
                                         double* force, double* error);

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
  int32_t kind; /**< WRC_WHEEL or WRC_RAIL if kind_given is not 0; otherwise from the file */
  int32_t kind_given;
  int32_t mirror_lateral; /**< 0: as the file needs; 1: mirror; -1: do not mirror */
  int32_t mirror_height;  /**< the same */
  int32_t strict;         /**< not 0: refuse instead of guessing */
  int32_t reserved;
  double scale;                /**< mm per unit of the file; 0: guess from the size */
  double smoothing_wavelength; /**< mm at which a wave is halved; 0: as the noise of the points
                                    needs; WRC_SMOOTHING_... */
  /* Since 0.3: */
  int32_t origin;       /**< lateral 0 of a wheel's file: WRC_ORIGIN_...; 0: from the file */
  int32_t slice;        /**< number of a slice in a slices file (.slcs, .slcw), or of a profile in a
                             project file of MiniProf, from 1 */
  double tape_offset;   /**< flange back to taping line, mm; 0: from the file, or 70 */
  double lateral_shift; /**< instead of origin: mm added to lateral; 0: none */
  double rotation;      /**< if rotation_given is not 0: rad, anticlockwise in (lateral, height),
                             about the taping line or a rail's origin; 0: not tilted */
  int32_t rotation_given; /**< 0: a tilt of a wheel is looked for */
  int32_t reserved_2;
  const char* align_to; /**< built-in profile or file on which the points are laid where they are
                             not worn; NULL or empty: none */
} wrc_read_options;

#define WRC_SMOOTHING_NONE (-1.0) /**< the points as they are */
#define WRC_SMOOTHING_AUTO (-2.0) /**< as 0, but strict does not refuse noise */
#define WRC_ORIGIN_TAPE 1         /**< taping line; heights are left as they are */
#define WRC_ORIGIN_FLANGE_BACK 2  /**< flange back: moved to the taping line, height 0 there */

/** A built-in profile, by name. WRC_UNKNOWN_NAME. Since 0.1. */
WRC_API wrc_status wrc_profile_load_standard(wrc_profile* profile, const char* name);
/** A file: columns, Simpack .prr/.prw, MiniProf .ban/.whl, a slice of .slcs/.slcw; options may be
 * NULL. Since 0.1. */
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
 * for "track.rail", or those of one side. Setting that key by name removes it again.
 * WRC_INVALID_ARGUMENT, WRC_NO_RESULT for an empty profile. Since 0.2.
 */
WRC_API wrc_status wrc_scene_set_profile(wrc_scene* scene, const char* key, wrc_profile* profile);

/** Kind, and texts: "name", "title", "source", "confidence". Since 0.1. */
WRC_API wrc_status wrc_profile_kind(wrc_profile* profile, int32_t* kind);
WRC_API wrc_status wrc_profile_text(wrc_profile* profile, const char* name, const char** value);
/** Corrections made while reading, one line each; NULL past the end. Since 0.1. */
WRC_API const char* wrc_profile_correction(const wrc_profile* profile, int64_t index);
/** Implausible features of the profile, one line each; NULL past the end. Since 0.3. */
WRC_API const char* wrc_profile_warning(const wrc_profile* profile, int64_t index);
/**
 * Points of a profile that was read: WRC_POINTS_READ, before smoothing, or WRC_POINTS_DROPPED,
 * those that cleaning removed; a built-in profile has none. mm, frame of wrc_profile_at; both
 * arrays hold `capacity` values (as wrc_scene_field copies). Since 0.3.
 */
WRC_API wrc_status wrc_profile_points(wrc_profile* profile, int32_t which, double* lateral,
                                      double* height, int64_t capacity, int64_t* count);
#define WRC_POINTS_READ 0
#define WRC_POINTS_DROPPED 1

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

/**
 * Reads all slices of a .slcs or .slcw file, joins them to the surface of a rail that varies along
 * the track, or of a wheel that varies around its circumference, and stores the number of its
 * separate sheets. It is kept beside the profile of the handle; scenes do not use it yet. Of the
 * options: kind, mirrors, scale, smoothing_wavelength; may be NULL. smoothing_length: waves of this
 * length along are halved, mm, of a wheel rad; 0: through the slices; below 0: as the file says.
 * WRC_FILE_MALFORMED, also for a surface that folds, with the numbers of the slices. Since 0.3.
 */
WRC_API wrc_status wrc_profile_load_surface(wrc_profile* profile, const char* path,
                                            const wrc_read_options* options,
                                            double smoothing_length, int64_t* sheets);
/** What the surface is, one line each; NULL past the end. Since 0.3. */
WRC_API const char* wrc_profile_surface_line(const wrc_profile* profile, int64_t index);
/**
 * A point of a sheet, from 0, at shares of its length across (gauge or flange side to field side)
 * and of the number of its slices along, so that equal shares are close where slices are: place
 * along in mm, of a wheel rad; lateral and height in mm. Pointers may be NULL. WRC_NO_RESULT
 * without a surface. Since 0.3.
 */
WRC_API wrc_status wrc_profile_surface_at(wrc_profile* profile, int64_t sheet, double across,
                                          double along, double* place, double* lateral,
                                          double* height);

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
 * Wisdom: the plans that the planner "measure" has found in this process. Only these calls read or
 * write the file. WRC_INVALID_ARGUMENT, WRC_FILE_UNREADABLE,
 * WRC_FILE_MALFORMED. Since 0.1.
 */
WRC_API wrc_status wrc_load_wisdom(const char* path);
WRC_API wrc_status wrc_save_wisdom(const char* path);

#ifdef WRC_REMOVED
WRC_REMOVED("use wrc_solver_clear")
wrc_status wrc_solver_forget(wrc_solver* solver, int32_t profiles);
WRC_REMOVED("time your own FFTW plans")
wrc_status wrc_measure_transform(int64_t rows, int64_t columns, int32_t repeats, double* median_ms);
#endif

#ifdef __cplusplus
}
#endif

/* Normal and rolling contact on the caller's own grid. */
#include "wrcontact_grid.h"

#endif
