/// Distance of the undeformed wheel and rail on an equally spaced grid.
///
/// For each element centre of the plane a ray runs along the frame's normal; the undeformed
/// distance is the ray's length from the rail to the wheel (negative where they penetrate). The
/// rail is a plane curve, so its ray is solved once a row (once an element if the frame is yawed)
/// on the profile's arc length; the wheel's ray solves sqrt(X^2 + Z^2) = rho(Y) in the wheelset
/// frame, both by Newton's method with the neighbour as start. With the frame of the wheelset this
/// is the paper's remesh, steps a to f of its section 2.2.
/// Where the ray meets no wheel or no rail the distance is `no_material_distance`.
/// Units mm; track frame, left-hand side. Thread rule: pure functions.
#pragma once

#include <vector>

#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "remesh/contact_frame.hpp"
#include "remesh/grid.hpp"

namespace wrc {

/// Larger than any distance at which bodies could meet.
constexpr double no_material_distance = 1e3;

/// Wheel and rail as posed: everything the undeformed distance depends on.
struct PosedPair {
  const WheelSurface& wheel;
  const RailSurface& rail;
  Pose pose;
  double vertical = 0.0; ///< z of the wheelset's centre
};

/// One value per element of the grid, in the grid's order.
std::vector<double> sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame,
                                               const Grid& grid);

/// Where the ray through a place of the plane meets rail and wheel.
struct SurfacePlace {
  bool on_rail = false;
  bool on_wheel = false;
  Vector3 rail;               ///< track frame
  double rail_angle = 0.0;    ///< inclination of the rail there, rad
  Vector3 wheel;              ///< track frame
  double wheel_lateral = 0.0; ///< s on the wheel profile
  double wheel_height = 0.0;  ///< w on the wheel profile
};
SurfacePlace surfaces_at(const PosedPair& pair, const ContactFrame& frame, double longitudinal,
                         double lateral);

} // namespace wrc
