/// What a wheel's contact came to, and by how much it is off.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "support/scene.hpp"

namespace tradeoff {

/// Errors that are measured, each relative:
///   pmax, depth, normal_force, area   to themselves
///   lateral_force                     to the vertical force
///   centre_lateral                    distance of the centres of pressure in the y-z plane, to the
///                                     contact's semi-axis across the rail
///   centre_longitudinal               their distance along x, to the semi-axis along the rail
///   moment                            about one point; of its components the largest error, to the
///                                     normal force times the semi-axis across (about x) or along
///                                     the rail (about y and z)
/// The contact's semi-axes are those of the ellipse that would have the second moments of the
/// pressures of all patches together, if they were Hertz's: five times the variance is the square.
enum class Quantity : std::size_t {
  depth,
  normal_force,
  lateral_force,
  centre_lateral,
  centre_longitudinal,
  moment,
  area,
  pmax
};
inline constexpr std::array quantity_names{
    "depth",  "normal_force", "lateral_force", "centre_lateral", "centre_longitudinal",
    "moment", "area",         "pmax"};

struct WheelError {
  std::array<double, quantity_names.size()> values{};
  std::optional<double> estimate;
  std::optional<double> validity;
  std::string warnings;

  [[nodiscard]] double of(Quantity quantity) const {
    return values[static_cast<std::size_t>(quantity)];
  }
  /// As it counts against an accuracy: a fortieth of the area's, infinite if it is no number.
  [[nodiscard]] double counted(Quantity quantity) const;
  /// The quantity that is furthest off among those that an accuracy of this meaning, "forces" or
  /// another way's, is of: all but pmax, or all.
  [[nodiscard]] Quantity largest(const std::string& label) const;
  /// Its error, as it counts.
  [[nodiscard]] double controlled(const std::string& label) const {
    return counted(largest(label));
  }
};

/// Of a wheel, as solved.
struct Figures {
  double pmax = 0.0, depth = 0.0, area = 0.0, normal_force = 0.0;
  std::array<double, 3> force{};     ///< along x, y, z
  std::array<double, 3> centre{};    ///< of pressure
  std::array<double, 3> reference{}; ///< of the moment
  std::array<double, 3> moment{};
  double semi_axis_along = 0.0, semi_axis_across = 0.0;
};

Figures figures_of(const driver::Scene& scene, const std::string& side);
WheelError error_of(const Figures& found, const Figures& truth);
/// With what the scene tells of its error.
WheelError error_of(const driver::Scene& scene, const std::string& side, const Figures& truth);

} // namespace tradeoff
