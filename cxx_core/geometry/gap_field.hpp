/// The vertical distance of a wheel from a rail, of which either may vary, over places of the
/// track.
///
///   g(x, y) = z_wheel - z_rail,
/// with the wheelset's centre at height 0, and its derivatives. The wheel is that seen from below:
/// a vertical line meets it (wheel_line.hpp), and z_x = -F_x/F_z, z_xx = -(F_xx + 2 F_xz z_x +
/// F_zz z_x^2)/F_z follow from its F = 0, turned into the track frame.
/// Units mm and rad; track frame, left side (frames.hpp). Not covered: overhanging parts. Thread
/// rule: one object, one thread.
#pragma once

#include <optional>
#include <span>

#include "geometry/rail_line.hpp"
#include "geometry/wheel_line.hpp"

namespace wrc {

/// A height over (x, y) with its derivatives.
struct Graph {
  double value = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

struct GapPoint {
  Graph gap;
  Graph rail;
  double wheel_lateral = 0.0; ///< s on the wheel profile
  double wheel_height = 0.0;  ///< w there
  double wheel_angle = 0.0;   ///< about the axle, rad, positive ahead of it
};

class GapField {
public:
  /// Both must outlive the field.
  GapField(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose);

  /// None where the wheel or the rail is not.
  [[nodiscard]] std::optional<GapPoint> at(double x, double y);
  /// Vertical distances over rows across the track in ascending order, for scans
  /// (RailLine::heights); infinite where a body is not.
  void scan(double x, std::span<const double> rows, std::span<double> gaps);
  /// The lines that follow begin afresh, whatever was looked up before.
  void restart();

private:
  /// The wheel's height over a place, and where that is in its frame; none where it is not.
  [[nodiscard]] std::optional<double> wheel_at(double x, double y, Vector3& met,
                                               double enough = 0.0);

  const WheelSurface& wheel_;
  Rotation rotation_;
  double lateral_;
  WheelLine wheel_line_;
  RailLine rail_line_;
};

} // namespace wrc
