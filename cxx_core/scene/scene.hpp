/// A scene: everything that is asked, with the defaults of the paper's Table 1.
///
/// Values are reached by the keys of a scene file (scene/scene_keys.hpp), which also hold their
/// permitted ranges. Units mm, N, MPa, rad; track frame of geometry/frames.hpp.
/// Thread rule: a plain value.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "accuracy/accuracy_of.hpp"
#include "geometry/rail_surface.hpp"
#include "geometry/wheel_surface.hpp"
#include "half_space/material.hpp"
#include "mechanics/normal_solver.hpp"
#include "patches/contact_frame.hpp"
#include "profile/profile.hpp"
#include "scene/convention.hpp"
#include "wheel/module.hpp"

namespace wrc {

enum class SideChoice { both, left, right };

struct Scene {
  Convention convention; ///< of the numbers outside; those here are in mm, y left, z up

  TrackDimensions track;
  std::string rail = "60E1"; ///< name of a built-in profile, or a file
  /// Used instead of `rail` if given, which is then its name.
  std::shared_ptr<const Profile> rail_profile;
  double rail_smoothing = 0.0; ///< wavelength in mm for a rail read from a file; 0: none
  WheelsetDimensions wheelset;
  std::string wheel = "S1002";
  std::shared_ptr<const Profile> wheel_profile; ///< as rail_profile
  double wheel_smoothing = 0.0;

  Material wheel_material{210000.0, 0.3};
  Material rail_material{210000.0, 0.3};

  double lateral = 0.0;
  double yaw = 0.0;
  std::optional<double> roll;     ///< prescribed; solved if not set
  std::optional<double> vertical; ///< prescribed height of the wheelset's centre; solved if not set

  double left_load = 80000.0; ///< vertical force on the left wheel
  double right_load = 80000.0;
  std::optional<double> normal_load; ///< instead: force along the patch's normal, each wheel

  SideChoice side = SideChoice::both;
  Module until = Module::mechanics; ///< the last one to run
  GapConvention gap = GapConvention::tangent;
  std::string model = "auto";
  std::string solver = "default";
  std::optional<Elements> elements; ///< smooth, but constant with the paper's solver, if not set
  AccuracyOf accuracy_of = AccuracyOf::pressures;
  double accuracy = 1e-3;
  std::optional<std::array<std::size_t, 2>> grid; ///< elements [lateral, longitudinal]
  double tolerance = 1e-5;                        ///< of the pressures, relative
  PlannerRigor planner = PlannerRigor::estimate;
  Precision precision = Precision::mixed;
  bool interaction = false; ///< elastic, between patches of a wheel however far apart
  /// Patches closer than twice this share a plane, mm (patches/contact_patches.hpp).
  double joining_distance = 4.0;
  double near_tolerance = 0.1; ///< contacts listed as near: distance at the first touch, mm
  int threads = 1;

  Scene();
};

} // namespace wrc
