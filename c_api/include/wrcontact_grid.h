/**
 * @file
 * Contact on the caller's own grid: pressures from a gap (wrc_normal), tractions from pressures and
 * creepages (wrc_rolling).
 *
 * Part of wrcontact.h, which includes it and describes units, errors, handles and threads of all
 * functions.
 */
#ifndef WRCONTACT_GRID_H
#define WRCONTACT_GRID_H

#include "wrcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Normal contact of a gap given by the caller ------------------------------------------- */

/**
 * One problem on an equally spaced grid, and the solver that keeps plans, tables and memory between
 * its calls: pressures p >= 0 and gaps g = h + u - approach >= 0 with p g = 0, where u are the
 * displacements of an elastic half-space. Changing the problem does not change the results, which
 * are those of the last wrc_normal_solve. Results do not depend on earlier calls.
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
 * with the longitudinal index fastest, which are copied. wrc_normal_solve needs one value for each
 * element of the grid. WRC_INVALID_ARGUMENT. Since 0.1.
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
 *   "planner"    "estimate": plans transforms immediately; or "measure": finds faster ones in
 * seconds WRC_UNKNOWN_NAME, WRC_INVALID_ARGUMENT. Since 0.1.
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
 *   "fill"          fraction of the elements under pressure, 0 to 1
 *   "iterations"    of all grids the solver went through
 *   "grade"         the worst grade of the warnings, WRC_FINE to WRC_DO_NOT_USE (wrcontact.h)
 *   "warning_count" how many texts "warnings.0", ... there are (wrc_normal_text)
 *   "residuals.load_balance", "residuals.least_gap", "residuals.complementarity"
 *                   how well the problem is solved, recomputed in double precision when first
 *                   requested: |force - load|/load (0 for a given approach), least gap without
 *                   pressure (< 0: overlap) and largest |gap| under pressure, both over the
 *                   largest displacement
 * WRC_NO_RESULT, WRC_UNKNOWN_NAME. Since 0.1.
 */
WRC_API wrc_status wrc_normal_number(wrc_normal* normal, const char* name, double* value);
/**
 * "stop_reason": "tolerance_met", "iteration_limit" or "stagnation". "warnings.0", "warnings.1",
 * ...: what is doubtful of the result, and "warning_classes.0", ... the class of each, "grid_edge"
 * of a contact that reaches the edge of the grid, "accuracy" of one on too few elements, and
 * "warning_grades.0", ... the grade of each, "fine", "a little over" or "do not use"
 * (docs/warnings.md). Since 0.1, warnings since 0.4. WRC_NO_RESULT, WRC_UNKNOWN_NAME.
 */
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
 * the problem does not change the results, which are those of the last wrc_rolling_solve. Results
 * depend on earlier calls only through the previous tractions.
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
 * wrc_rolling_solve needs one value for each element of the grid. WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_set_pressure(wrc_rolling* rolling, const double* values,
                                            int64_t count);
/**
 * The rigid slip of each element, wheel minus rail over the speed (a shift: mm), -1e30 to 1e30, in
 * addition to that of the creepages; `count` values each on the grid of the pressures, which are
 * copied. With creepages of 0 this is the whole slip. With count 0 there is none, the default.
 * WRC_INVALID_ARGUMENT. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_set_slip(wrc_rolling* rolling, const double* slip_x,
                                        const double* slip_y, int64_t count);
/**
 * The tractions before a step or a shift ("contact" below), -1e30 to 1e30 MPa on the wheel,
 * `count` values each on the grid of the pressures, which moves with the contact; they are copied.
 * They stay in force until they are replaced; steady rolling does not use them. With count 0, the
 * default, the bodies were free of tractions. WRC_INVALID_ARGUMENT. Since 0.3.
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
 *   "maximum_iterations"     on each grid of the cascade: a whole number, 1 to 1e9, default 30
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
 *   "difference"  of rolling: "biased", upstream and of second order; or "first-order", as in
 * CONTACT (Vollebregt), for comparison
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
 *   "creep_force.longitudinal", "creep_force.lateral"  N
 *   "spin_moment"                   N mm, about the origin
 *   "slip_area", "adhesion_area"    mm^2, counted in elements
 *   "friction_power"                lost to friction, over the speed, N: -(force and moment times
 *                                   creepages); exact for steady rolling; of a shift: N mm; for
 *                                   unlike bodies including the slip that pressures cause
 *   "numerical_loss"                the fraction of it missing from the sum of slip times traction
 *                                   over elements of finite size; 0 except in steady rolling
 *   "iterations", "convolutions"    on all grids
 *   "residual"                      reached; see "tolerance"
 *   "converged"                     1, or 0 with WRC_NOT_CONVERGED
 * WRC_NO_RESULT, WRC_UNKNOWN_NAME. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_number(wrc_rolling* rolling, const char* name, double* value);
/**
 * "traction_x", "traction_y" (MPa, on the wheel), "slip_x" or "slip_y" (over the speed; of a shift:
 * mm; 0 outside the contact), "normal_displacement" (mm by which the tractions open the gap of
 * unlike bodies; add it to the undeformed distance of wrc_normal to obtain the changed pressures),
 * one value per element with the longitudinal index fastest; or "creepage_derivatives", 9 values:
 * dFx/dxi, dFx/deta, dFx/dphi, then those of Fy and Mz (N, N mm, phi in 1/mm), 0 if not requested.
 * Copied as by wrc_scene_field. WRC_NO_RESULT, WRC_UNKNOWN_NAME, WRC_TOO_SMALL. Since 0.3.
 */
WRC_API wrc_status wrc_rolling_field(wrc_rolling* rolling, const char* name, double* values,
                                     int64_t capacity, int64_t* count);

#ifdef __cplusplus
}
#endif

#endif
