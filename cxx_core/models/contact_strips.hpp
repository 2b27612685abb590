/// Wheel and rail in strips along the rail: where the wheel comes nearest to each, and how both
/// bend there.
///
/// On a strip of constant y of a prismatic rail the least vertical gap lies on the contact locus of
/// a round wheel (geometry/wheel_surface.hpp), yawed wheels included. With the slope m of the wheel
/// profile, m' its derivative, and t the locus' angle, a sin t - b cos t = c(m) gives
/// dt/ds = c'/(a cos t + b sin t), and from it how the locus moves and turns along the profile.
/// Elsewhere the contact search has found the least gaps d of rows 0.5 mm apart
/// (geometry/varying_search.hpp). Strips between them are cubics through four rows, except for
/// their curvature along the rail, which is linear between two and so positive. With the rail's
/// slopes p along and q across, L^2 = 1 + p^2 and N^2 = 1 + p^2 + q^2, a length along the plane
/// across is dY = N/L dy, and the curvature across d''(y) L^2/N^3. Lowering the wheel changes the
/// gap of every strip by as much, so a depth needs no new strips. Units mm and rad; track frame,
/// left-hand side; curvatures in 1/mm. Thread rule: immutable.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "geometry/contact_search.hpp"
#include "models/constants.hpp"

namespace wrc {

struct ContactStrip {
  double s = 0.0;        ///< on the wheel
  Vector3 rail;          ///< the point below the wheel's nearest one
  double distance = 0.0; ///< vertical, with the wheelset's centre at height 0
  double rail_slope = 0.0;
  double rail_rise = 0.0;         ///< along the track
  double lateral_rate = 0.0;      ///< dy/ds
  double longitudinal_rate = 0.0; ///< dX/ds, along the rail
  /// Curvature of the gap along the rail, > 0: that of the wheel on a prismatic rail.
  double longitudinal_curvature = 0.0;
  /// Curvature of wheel and rail together, > 0 where they part: of the wheel's outline, seen along
  /// the rail, against the rail.
  double lateral_curvature = 0.0;
};

class ContactStrips {
public:
  /// All must outlive the strips. `rows`: samples of a scan, which prismatic bodies do not need.
  ContactStrips(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose,
                std::span<const DistanceSample> rows = {})
      : wheel_(wheel), rail_(rail), pose_(pose), locus_(pose), rows_(rows) {}

  /// None beyond the ends of a profile or of the rows, of fewer than four rows, and where the wheel
  /// is no nearer there than beside. Throws Error(invalid_argument) where rows turn back along the
  /// wheel's profile, as they may from a yaw of 0.1 rad on.
  [[nodiscard]] std::optional<ContactStrip> at(double s) const;
  /// The one where the wheel touches. Throws Error(no_contact) with the model's name if there is
  /// none.
  [[nodiscard]] ContactStrip touching_at(double s, std::string_view model) const;
  /// Largest difference of the gap along the rail from the strip's parabola, up to a half length to
  /// both sides, over the parabola there; 1 where a body ends, 0 of prismatic bodies.
  [[nodiscard]] double difference_along(const ContactStrip& strip, double half_length) const;

private:
  /// Whether strips follow the contact locus, that of a round wheel on a prismatic rail.
  [[nodiscard]] bool have_locus() const;
  [[nodiscard]] std::optional<ContactStrip> on_locus(double s) const;
  [[nodiscard]] std::optional<ContactStrip> between_rows(double s) const;

  const WheelSurface& wheel_;
  const RailSurface& rail_;
  Pose pose_;
  LocusPose locus_;
  std::span<const DistanceSample> rows_;
};

} // namespace wrc
