/// How far a plane is off for a contact whose surface turns.
///
/// Measured against curved patches (tests/core/wheel/energy_test.cpp): with the inclination beta of
/// the rail's surface to the plane, delta the mean of its tangent and s its standard deviation,
/// both weighted with the pressures, and the plane's angle alpha, at a given vertical load
///   dF_y / F_z <= (s^3 + 0.4 delta^2) / cos^2(alpha),
/// and over its turn t, from one end of the contact to the other,
///   dpmax / pmax <= 0.1 t^2.
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
/// Error of the largest pressure of a patch, relative.
double pressure_error_of_plane(const SurfaceTurn& turn);

/// Sets Patch::plane_error, patches of one plane alike: that of forces or the greater one of both.
/// Returns the error of the wheel.
double estimate_model_error(GridSolution& solution, AccuracyOf accuracy_of);

} // namespace wrc
