#include "models/contact_strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "base/error.hpp"
#include "geometry/gap_field.hpp"
#include "geometry/wheelset_equilibrium.hpp"

namespace wrc {
namespace {

constexpr std::size_t cubic_rows = 4; // not a tuning constant

/// A number on the cubic through four rows, with its derivatives by s.
struct OnCubic {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

/// Lagrange's polynomials of four rows at a place.
class RowCubic {
public:
  RowCubic(std::span<const DistanceSample, cubic_rows> rows, double s) : rows_(rows) {
    for (std::size_t i = 0; i < cubic_rows; ++i) {
      std::array<double, cubic_rows - 1> from{};
      double scale = 1.0;
      for (std::size_t k = 0, other = 0; k < cubic_rows; ++k) {
        if (k != i) {
          from[other++] = s - rows[k].wheel.lateral;
          scale /= rows[i].wheel.lateral - rows[k].wheel.lateral;
        }
      }
      weights_[i] = {scale * from[0] * from[1] * from[2],
                     scale * (from[0] * from[1] + from[1] * from[2] + from[2] * from[0]),
                     2.0 * scale * (from[0] + from[1] + from[2])};
    }
  }

  template <class Number> [[nodiscard]] OnCubic of(Number&& number) const {
    OnCubic sum;
    for (std::size_t i = 0; i < cubic_rows; ++i) {
      const double value = number(rows_[i]);
      sum.value += weights_[i].value * value;
      sum.first += weights_[i].first * value;
      sum.second += weights_[i].second * value;
    }
    return sum;
  }

private:
  std::span<const DistanceSample, cubic_rows> rows_;
  std::array<OnCubic, cubic_rows> weights_;
};

} // namespace

bool ContactStrips::have_locus() const {
  return WheelAndRail{wheel_, rail_}.is_prismatic_along(along_track);
}

std::optional<ContactStrip> ContactStrips::at(double s) const {
  const auto strip = have_locus() ? on_locus(s) : between_rows(s);
  return strip && strip->longitudinal_curvature > 0.0 ? strip : std::nullopt;
}

ContactStrip ContactStrips::touching_at(double s, std::string_view model) const {
  const auto strip = at(s);
  if (!strip) {
    throw Error(ErrorCode::no_contact,
                "solve.model = \"" + std::string(model) +
                    "\": where the wheel touches, at s_wheel = " + short_text_of(s) +
                    " mm, the gap has no curvature along the rail, or is known of fewer than " +
                    std::to_string(cubic_rows) + " rows; solve.model must be \"half-space\" here");
  }
  return *strip;
}

double ContactStrips::difference_along(const ContactStrip& strip, double half_length) const {
  if (have_locus()) {
    return 0.0;
  }
  GapField field(wheel_, rail_, pose_);
  const double along = 1.0 + strip.rail_rise * strip.rail_rise;
  const double curvature =
      strip.longitudinal_curvature * along * std::sqrt(along + strip.rail_slope * strip.rail_slope);
  const auto parabola = [curvature](double x) { return 0.5 * curvature * x * x; };
  double difference = 0.0;
  for (int i = -compared_places; i <= compared_places; ++i) {
    const double x = half_length * i / compared_places;
    const auto point = field.at(strip.rail.x + x, strip.rail.y);
    if (!point) {
      return 1.0;
    }
    difference = std::max(difference, std::abs(point->gap.value - strip.distance - parabola(x)));
  }
  return difference / parabola(half_length);
}

std::optional<ContactStrip> ContactStrips::between_rows(double s) const {
  const auto lateral_of = [](const DistanceSample& row) { return row.wheel.lateral; };
  if (rows_.size() < cubic_rows || !(s >= lateral_of(rows_.front())) ||
      !(s <= lateral_of(rows_.back()))) {
    return std::nullopt;
  }
  const auto after = std::ranges::upper_bound(rows_, s, {}, lateral_of) - rows_.begin();
  const auto first = std::clamp<std::ptrdiff_t>(after - 2, 0, std::ssize(rows_) - 4);
  const auto near = rows_.subspan(static_cast<std::size_t>(first)).first<cubic_rows>();
  if (!std::ranges::is_sorted(near, std::ranges::less_equal{}, lateral_of)) {
    throw Error(ErrorCode::invalid_argument,
                "solve.model: with this yaw the wheel's points nearest to the rail turn back along "
                "its profile, at s_wheel = " +
                    short_text_of(s) + " mm; solve.model must be \"half-space\" here");
  }
  const RowCubic cubic(near, s);
  // Cubics overshoot beside the end of a flat, where curvatures differ by a factor of 40.
  const auto low = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - first - 1, 0, 2));
  const double share =
      (s - lateral_of(near[low])) / (lateral_of(near[low + 1]) - lateral_of(near[low]));
  const double bend =
      std::lerp(near[low].wheel.normal_curvature, near[low + 1].wheel.normal_curvature, share);
  const auto x = cubic.of([](const DistanceSample& row) { return row.wheel.position.x; });
  const auto y = cubic.of([](const DistanceSample& row) { return row.wheel.position.y; });
  const auto z = cubic.of([](const DistanceSample& row) { return row.wheel.position.z; });
  const auto gap = cubic.of([](const DistanceSample& row) { return row.distance; });
  ContactStrip strip;
  strip.s = s;
  strip.rail = {x.value, y.value, z.value - gap.value};
  strip.distance = gap.value;
  strip.rail_slope = cubic.of([](const DistanceSample& row) { return row.rail_slope; }).value;
  strip.rail_rise = cubic.of([](const DistanceSample& row) { return row.rail_rise; }).value;
  const double across = 1.0 + strip.rail_slope * strip.rail_slope;
  const double along = 1.0 + strip.rail_rise * strip.rail_rise; // L^2
  const double normal = std::sqrt(across + along - 1.0);        // N
  strip.lateral_rate = y.first;
  strip.longitudinal_rate =
      std::sqrt(along) * (x.first + strip.rail_rise * strip.rail_slope / along * y.first);
  const double by_y = gap.first / y.first;
  strip.lateral_curvature =
      (gap.second - by_y * y.second) / (y.first * y.first) * along / (normal * normal * normal);
  strip.longitudinal_curvature = bend * std::sqrt(across) / (along * normal);
  return strip;
}

std::optional<ContactStrip> ContactStrips::on_locus(double s) const {
  const HeightFunction& profile = wheel_.graph().heights();
  if (!profile.covers(s)) {
    return std::nullopt;
  }
  const HeightPoint wheel = profile.at(s);
  bool exists = false;
  const LocusAngle angle = locus_.angle_at(wheel.slope, exists);
  if (!exists) {
    return std::nullopt;
  }
  const double rho = wheel_.radius() + wheel.height;
  const double turning =
      locus_.along * wheel.second / (locus_.a * angle.cosine + locus_.b * angle.sine);
  const Rotation& rotation = locus_.rotation;
  ContactStrip strip;
  strip.s = s;
  const Vector3 position =
      rotation.to_track({rho * angle.sine, wheel_.taping_line() + s, -rho * angle.cosine});
  const double y = position.y + locus_.lateral;
  const HeightFunction& crown = rail_.graph().heights();
  if (!crown.covers(y)) {
    return std::nullopt;
  }
  const HeightPoint rail = crown.at(y);
  strip.rail = {position.x, y, rail.height};
  strip.distance = position.z - rail.height;
  strip.rail_slope = rail.slope;
  const Vector3 rate =
      rotation.to_track({wheel.slope * angle.sine + rho * angle.cosine * turning, 1.0,
                         rho * angle.sine * turning - wheel.slope * angle.cosine});
  strip.longitudinal_rate = rate.x;
  strip.lateral_rate = rate.y;
  const Vector3 normal = rotation.to_track({angle.sine, -wheel.slope, -angle.cosine});
  const Vector3 normal_rate =
      rotation.to_track({angle.cosine * turning, -wheel.second, angle.sine * turning});
  const double normal_square = normal.y * normal.y + normal.z * normal.z;
  const double outline_curvature = (normal.y * normal_rate.z - normal.z * normal_rate.y) /
                                   (normal_square * std::sqrt(rate.y * rate.y + rate.z * rate.z));
  const double rail_square = 1.0 + rail.slope * rail.slope;
  strip.lateral_curvature =
      outline_curvature - rail.second / (rail_square * std::sqrt(rail_square));
  // Euler: the rail's direction lies between the wheel's rolling direction and its profile's.
  const double profile_square = 1.0 + wheel.slope * wheel.slope;
  const double rolling_curvature = 1.0 / (rho * std::sqrt(profile_square));
  const double profile_curvature = -wheel.second / (profile_square * std::sqrt(profile_square));
  const double cosine = rotation.to_track({angle.cosine, 0.0, angle.sine}).x;
  const double cosine_square = cosine * cosine;
  strip.longitudinal_curvature =
      cosine_square * rolling_curvature + (1.0 - cosine_square) * profile_curvature;
  return strip;
}

} // namespace wrc
