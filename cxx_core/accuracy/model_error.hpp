/// Error of taking contacts as planes, and of displacements between patches that are left out.
///
/// Measured against curved patches (docs/evidence/curved.md): with the inclination beta of the
/// rail's surface to the plane, delta the mean of its tangent and s its standard deviation, both
/// weighted with the pressures, and the plane's angle alpha, at a given vertical load
///   dF_y / F_z <= (s^3 + 0.4 delta^2) / cos^2(alpha),
/// and over its turn t, from one end of the contact to the other, for the depth and for moments
/// over force and semi-axis
///   ddepth / depth <= 0.03 t^2,  dpmax / pmax <= 0.07 t^2.
/// A contact that turns evenly by t has the standard deviation t/sqrt(20) of beta, one with a kink
/// of alpha in its middle alpha/2, and so an error of 0.15 alpha^2.
/// At a prescribed position the force is off instead of the depth, by 1.5 times as much (Hertz).
/// Along a curve beta is the inclination to its rows, and t by how much the rail turns more or less
/// than they do. The rows' own turn T leaves 0.01 T^2 of the depth and 0.02 T^2 of the pressure,
/// the difference between half-spaces along an arc and bodies (finite elements, CONTACT's example).
/// What inclined rows would add is in the solution (remesh/row_scales.hpp).
/// Units rad. Thread rule: pure functions.
/// An interaction of weight w (patches/contact_patches.hpp) leaves out (1 - w) F / (pi E* r) of the
/// displacement u at a distance r from a patch that carries F. A patch of overlap d then carries
/// too much by 1.5 u / d (Hertz). Patches on one curve leave out nothing by that: their angle is
/// part of T. Not known here: bodies that are no half-spaces.
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
/// What a kink of a profile by the angle `ridge` inside the contact adds to that.
double depth_error_of_kink(const SurfaceTurn& turn, double ridge);
/// Error of the largest pressure of a patch, relative.
double pressure_error_of_plane(const SurfaceTurn& turn);

/// Inclination of the row through a patch's reference: of its plane, or of its curve there.
double angle_of_reference(const ContactFrame& frame);

/// Error of the force from displacements that the interaction of patches leaves out: mean of the
/// patches, weighted with their forces; each 1 at most.
double interaction_error(const GridSolution& solution, double combined_modulus);

/// Fraction of its curve that a contact follows if the rail turns by `turn` over it: 0 while the
/// error of a plane is at most half of the accuracy, 1 from the accuracy on, smooth between.
double curve_share(double turn, double accuracy, AccuracyOf accuracy_of,
                   bool position_is_prescribed);

/// Sets Patch::plane_error, patches of one plane alike: the greatest of those that the accuracy
/// applies to, and Patch::plane_force_error. Returns the error of planes of the wheel.
double estimate_model_error(GridSolution& solution, AccuracyOf accuracy_of,
                            bool position_is_prescribed = false);

} // namespace wrc
