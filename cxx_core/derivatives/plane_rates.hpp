/// How the planes of the contact patches move with the wheelset.
///
/// The planes are those of patches/contact_patches.hpp: mean normals and positions of the rail,
/// weighted with the squared penetration. When the wheelset moves, a node of the wheel's profile
/// moves on its contact locus (closed form, geometry/wheel_surface.hpp), over another point of the
/// rail, and its distance changes:
///   dd/dq = dz/dq - z_rail'(y) dy/dq   with s fixed;  by height dd/dz = 1, everything else stays.
/// The first contact stays the root of F(s, q) = n_y + z_rail' n_z, n the wheel's normal, and so
/// moves along the profile by ds/dq = -F_q / F_s; with the profile's second derivatives in F_s. The
/// sums over these points, the turning towards neighbours and their coupling weight are
/// differentiated as they are computed (base/value_with_rates.hpp), so the rates are exact for the
/// discrete planes until a patch is born, joined or lost, or a node enters. Units mm and rad (rates
/// per mm or per rad); track frame, left-hand side (geometry/frames.hpp). Thread rule: pure
/// functions. Not known here: at a kink of a profile the first contact is assumed to stay at its
/// point of the wheel; points along a ridge under yaw have the rates of its field side.
#pragma once

#include <cstddef>
#include <vector>

#include "base/by_motion.hpp"
#include "geometry/contact_search.hpp"
#include "patches/contact_patches.hpp"
#include "remesh/surface_rays.hpp"

namespace wrc {

/// Rates of a patch's plane and of its penetration.
struct PlaneRates {
  ByMotion<double> angle;
  ByMotion<double> mean_x; ///< of the weighted mean position
  ByMotion<double> mean_y;
  ByMotion<double> x_first; ///< of the ends of penetration
  ByMotion<double> x_last;
  ByMotion<double> y_first;
  ByMotion<double> y_last;
};

struct MovingPatches {
  ContactPatches found;                     ///< as find_contact_patches finds them
  std::vector<PlaneRates> rates;            ///< in the same order
  std::vector<ByMotion<double>> link_rates; ///< of `found.links`

  /// Rate of found.coupling_weight(i, j, interaction); that of weights along curves is not known.
  [[nodiscard]] ByMotion<double> coupling_weight_rate(std::size_t i, std::size_t j,
                                                      Interaction interaction) const;
};

/// `scan` is that of the pose; `depth` leads from the first touch to the wheelset's height, which
/// stays in the track when the wheelset moves laterally or turns.
MovingPatches find_moving_patches(const WheelSurface& wheel, const RailSurface& rail,
                                  const Pose& pose, const ContactScan& scan, double depth,
                                  const PatchOptions& options);

} // namespace wrc
