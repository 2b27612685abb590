/// Distance of the undeformed wheel and rail on an equally spaced grid.
///
/// For each element centre of the plane a ray runs along the frame's normal; the undeformed
/// distance is the ray's length from the rail to the wheel (negative where they penetrate). The
/// rays of a row are met at once (remesh/ray_rows.hpp; the rail's ray is one for the whole row
/// unless the frame is yawed), single rays decide where that fails (remesh/surface_rays.hpp). With
/// the frame of the wheelset this is the paper's remesh, steps a to f of its section 2.2.
/// Where the ray meets no wheel or no rail the distance is `no_material_distance`.
/// Units mm; track frame, left-hand side. Thread rule: pure functions.
#pragma once

#include <vector>

#include "base/grid.hpp"
#include "patches/contact_frame.hpp"
#include "remesh/constants.hpp"
#include "remesh/rail_normals.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

/// One value per element of the grid, in the grid's order. `rail`: its points, if they are known,
/// those of this frame and grid.
std::vector<double> sample_undeformed_distance(const PosedPair& pair, const ContactFrame& frame,
                                               const Grid& grid, const RailNormals* rail = nullptr);

/// Where the ray through a point of the plane meets rail and wheel.
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
