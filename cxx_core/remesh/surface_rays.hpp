/// Where a single ray along a contact frame's normal meets the rail and the wheel; of a frame with
/// a curve, along the normal of the ray's row.
///
/// Rays are the lines of geometry/rail_line.hpp in the track frame and of geometry/wheel_line.hpp
/// in that of the wheelset: Newton's method from the point met last, to 1e-12 mm. Units mm; track
/// frame, left-hand side. Thread rule: one object, one thread.
#pragma once

#include <optional>

#include "geometry/rail_line.hpp"
#include "geometry/rail_surface.hpp"
#include "geometry/wheel_line.hpp"
#include "geometry/wheel_surface.hpp"
#include "patches/contact_frame.hpp"
#include "remesh/constants.hpp"

namespace wrc {

/// Wheel and rail as posed: everything the undeformed distance depends on.
struct PosedPair {
  const WheelSurface& wheel;
  const RailSurface& rail;
  Pose pose;
  double vertical = 0.0; ///< z of the wheelset's centre

  /// As of WheelAndRail.
  [[nodiscard]] bool is_prismatic_along(const Vector3& direction) const {
    return wheel.is_prismatic_along(direction) && rail.is_prismatic_along(direction);
  }
};

class RailRay {
public:
  /// The frame must outlive the ray.
  RailRay(const RailSurface& rail, const ContactFrame& frame)
      : frame_(frame), line_(rail, frame.origin.y) {}

  /// Start from below the frame's origin again.
  void restart() { line_.restart(); }
  /// Position along the normal at which the ray through a point of the plane meets the rail; the
  /// next ray starts from there.
  std::optional<double> solve(double longitudinal, double lateral);
  /// Tangent of the rail's angle there to the row at this position across: to its curve, or the
  /// plane.
  [[nodiscard]] double inclination(double lateral) const;
  /// The line met last.
  [[nodiscard]] const RailLine& line() const { return line_; }

private:
  const ContactFrame& frame_;
  RailLine line_;
};

class WheelRay {
public:
  /// The frame must outlive the ray.
  WheelRay(const PosedPair& pair, const ContactFrame& frame);

  /// Position on the wheel profile where the last ray met it; the next ray starts from its height.
  [[nodiscard]] double lateral() const { return line_.lateral(); }
  [[nodiscard]] double height() const { return line_.height(); }
  void start_from(double height) { line_.start_from(height); }
  /// Position along the normal at which the ray meets the wheel from below.
  std::optional<double> solve(double longitudinal, double lateral);

  /// Tangent of the wheel's angle to the plane across, where the last ray met it.
  [[nodiscard]] double inclination(double longitudinal, double lateral, double position) const;

  /// Normal of the wheel at one of its points, in the wheelset frame with Y from the taping line.
  [[nodiscard]] Vector3 gradient(const Vector3& point) const { return line_.gradient(point); }

  /// A point of the plane in the wheelset frame, with Y from the taping line: that of the profile.
  [[nodiscard]] Vector3 base(double longitudinal, double lateral) const;
  /// Directions of the frame in the wheelset frame.
  [[nodiscard]] Vector3 longitudinal() const { return longitudinal_; }
  /// On a curve that of the row whose ray was met last.
  [[nodiscard]] Vector3 normal() const { return normal_; }

private:
  const WheelSurface& wheel_;
  const Rotation rotation_;
  const ContactFrame& frame_;
  const Vector3 centre_;
  const Vector3 longitudinal_;
  Vector3 normal_;
  WheelLine line_;
};

} // namespace wrc
