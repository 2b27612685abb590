/// What the report of a wheel/rail pair shows: geometry, conicity, contact over the lateral
/// position.
///
/// Units mm, N, MPa, rad; track frame, left wheel.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "reports/conicity_curves.hpp"
#include "support/scene.hpp"
#include "support/values.hpp"

namespace driver {

/// A wheel, a rail and the keys of their scenes. Profiles are read once.
struct Pair {
  /// Built-in names or files, and "key=value" of other keys. Throws Failure for keys that the
  /// report sets itself.
  Pair(const std::string& wheel_name, const std::string& rail_name,
       std::vector<std::string> assignments);

  /// A scene of the pair, not solved.
  [[nodiscard]] Scene scene() const;

  std::vector<std::string> assignments;
  Profile wheel;
  Profile rail;
  std::string rail_text; ///< with the options of the rail
};

/// Positions go to both sides this far, in such steps, mm.
inline constexpr double position_reach = 6.0;
inline constexpr double position_step = 0.5;

/// Where one patch presses, from its edge nearer to the flange (wheel) or to the gauge face (rail).
struct PressedBand {
  double s_from = 0.0; ///< on the wheel
  double s_to = 0.0;
  double t_from = 0.0; ///< on the rail
  double t_to = 0.0;
};

/// The left contact at one lateral position.
struct Position {
  double lateral = 0.0;
  std::string trouble; ///< why there are no results; empty if there are
  double pmax = std::numeric_limits<double>::quiet_NaN();
  double elastic = std::numeric_limits<double>::quiet_NaN(); ///< pmax if no steel yielded
  double area = std::numeric_limits<double>::quiet_NaN();
  double angle = std::numeric_limits<double>::quiet_NaN();
  double radius = std::numeric_limits<double>::quiet_NaN();
  double s_wheel = std::numeric_limits<double>::quiet_NaN(); ///< where the profiles touch first
  double t_rail = std::numeric_limits<double>::quiet_NaN();
  std::vector<PressedBand> bands;
  std::vector<Warning> warnings;
};

/// From one flange to the other; results do not depend on the number of threads.
std::vector<Position> positions_of(const Pair& pair, int threads);
/// Without roll, as EN 15302 has it.
ConicityCurve conicity_of(const Pair& pair);

} // namespace driver
