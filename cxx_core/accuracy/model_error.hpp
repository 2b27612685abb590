/// How far a plane is off for a contact whose surface turns.
///
/// Measured against curved patches (drivers/evidence/curved): with the inclination beta of the
/// rail's surface to the plane, delta the mean of its tangent and s its standard deviation, both
/// weighted with the pressures, and the plane's angle alpha, at a given vertical load
///   dF_y / F_z <= (s^3 + 0.4 delta^2) / cos^2(alpha),
/// and over its turn t, from one end of the contact to the other, for the depth and for moments
/// over force and semi-axis
///   ddepth / depth <= 0.03 t^2,  dpmax / pmax <= 0.07 t^2.
/// At a prescribed position the force is off instead of the depth, by 1.5 times as much (Hertz).
/// What inclined rows would add is in the solution (remesh/row_scales.hpp).
/// Units rad. Thread rule: pure functions.
/// Not known here: bodies that are no half-spaces, and forces of patches on each other.
#pragma once

#include "accuracy/accuracy_of.hpp"
#include "accuracy/grid_solution.hpp"

namespace wrc {

/// Turn of several patches in one plane together.
SurfaceTurn combined_turn(const SurfaceTurn& one, const SurfaceTurn& other);

/// Error of the force of a contact in a plane of an angle, over its amount.
double force_error_of_plane(const SurfaceTurn& turn, double plane_angle);
/// Error of its depth and moments, likewise.
double depth_error_of_plane(const SurfaceTurn& turn);
/// Error of the largest pressure of a patch, relative.
double pressure_error_of_plane(const SurfaceTurn& turn);

/// Sets Patch::plane_error, patches of one plane alike: the greatest of those that the accuracy
/// applies to. Returns the error of the wheel.
double estimate_model_error(GridSolution& solution, AccuracyOf accuracy_of,
                            bool position_is_prescribed = false);

} // namespace wrc
