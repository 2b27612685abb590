#include "reports/worn_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace driver {
namespace {

/// Rounds of smoothing with 1/4, 1/2, 1/4: a wave of 5 mm keeps half of its height.
constexpr int smoothing_rounds = 8;

} // namespace

WornProfile::WornProfile(const Profile& profile, double spacing)
    : spacing_(spacing), kind_(profile.kind()) {
  const auto count = static_cast<std::size_t>(std::ceil(profile.length() / spacing)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto point =
        profile.at(profile.length() * static_cast<double>(i) / static_cast<double>(count - 1));
    fresh_.lateral.push_back(point.lateral);
    fresh_.height.push_back(point.height);
  }
  now_ = fresh_;
  noted_.assign(count, 0.0);
}

/// The first of the two points beside it.
std::size_t WornProfile::point_before(double s) const {
  // Of several points with this s (the flange's back) the one that touches: farthest to the field
  // side along the curve.
  const std::vector<double>& at = now_.lateral;
  const bool rises = at.back() > at.front();
  std::size_t found = 0;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    if (s >= std::min(at[i], at[i + 1]) && s <= std::max(at[i], at[i + 1])) {
      found = i;
      if (!rises) {
        break;
      }
    }
  }
  return found;
}

void WornProfile::add(double s, double area) {
  const std::vector<double>& at = now_.lateral;
  const std::size_t found = point_before(s);
  const double step = at[found + 1] - at[found];
  const double share = step != 0.0 ? std::clamp((s - at[found]) / step, 0.0, 1.0) : 0.5;
  noted_[found] += (1.0 - share) * area;
  noted_[found + 1] += share * area;
}

void WornProfile::take_off(const std::vector<Groove>& grooves) {
  const std::vector<double>& at = now_.lateral;
  std::vector<double> depths(at.size(), 0.0);
  for (const Groove& groove : grooves) {
    const std::vector<double>& places = groove.lateral;
    const auto deepest = std::ranges::max_element(groove.depth);
    if (places.size() < 2 || !(*deepest > 0.0)) {
      continue;
    }
    const bool rises = places.back() > places.front();
    /// False beyond the groove's ends.
    const auto take = [&](std::size_t point) {
      const auto next = rises ? std::ranges::lower_bound(places, at[point])
                              : std::ranges::lower_bound(places, at[point], std::greater<>());
      if (next == places.begin() || next == places.end()) {
        return false;
      }
      const auto after = static_cast<std::size_t>(next - places.begin());
      const double share = (at[point] - places[after - 1]) / (places[after] - places[after - 1]);
      depths[point] =
          std::max(depths[point], std::lerp(groove.depth[after - 1], groove.depth[after], share));
      return true;
    };
    // To both sides of its middle: the curve may come back to the same lateral positions.
    const std::size_t middle =
        point_before(places[static_cast<std::size_t>(deepest - groove.depth.begin())]);
    for (std::size_t point = middle + 1; point < at.size() && take(point); ++point) {
    }
    for (std::size_t point = middle + 1; point-- > 0 && take(point);) {
    }
  }
  now_ = moved(depths);
}

std::vector<double> WornProfile::smoothed() const {
  std::vector<double> values = noted_;
  for (int round = 0; round < smoothing_rounds; ++round) {
    std::vector<double> next(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t before = i > 0 ? i - 1 : 0;
      const std::size_t after = std::min(i + 1, values.size() - 1);
      next[before] += 0.25 * values[i];
      next[i] += 0.5 * values[i];
      next[after] += 0.25 * values[i];
    }
    values = std::move(next);
  }
  return values;
}

double WornProfile::noted_depth() const {
  const std::vector<double> areas = smoothed();
  return *std::max_element(areas.begin(), areas.end()) / spacing_;
}

WornProfile::Points WornProfile::moved(const std::vector<double>& depth) const {
  Points points = now_;
  const double side = now_.lateral.back() > now_.lateral.front() ? 1.0 : -1.0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, depth.size() - 1);
    const double along = now_.lateral[after] - now_.lateral[before];
    const double up = now_.height[after] - now_.height[before];
    const double length = std::hypot(along, up);
    // Outwards is towards larger radius.
    points.lateral[i] += side * depth[i] * up / length;
    points.height[i] -= side * depth[i] * along / length;
  }
  return points;
}

double WornProfile::area_between(const Points& outer, const Points& inner) {
  double area = 0.0;
  const auto add = [&area](double x, double y, double next_x, double next_y) {
    area += 0.5 * (x * next_y - next_x * y);
  };
  const std::size_t count = outer.lateral.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    // The quadrilateral between both lines.
    const std::array x{outer.lateral[i], outer.lateral[i + 1], inner.lateral[i + 1],
                       inner.lateral[i]};
    const std::array y{outer.height[i], outer.height[i + 1], inner.height[i + 1], inner.height[i]};
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::size_t next = (k + 1) % x.size();
      add(x[k] - x[0], y[k] - y[0], x[next] - x[0], y[next] - y[0]);
    }
  }
  return std::abs(area);
}

void WornProfile::wear(double factor) {
  const std::vector<double> areas = smoothed();
  double wanted = 0.0;
  std::vector<double> depth(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    wanted += factor * areas[i];
    depth[i] = factor * areas[i] / spacing_;
  }
  if (!(wanted > 0.0)) {
    return;
  }
  // The area is nearly proportional to the depth: a few corrections reach rounding.
  Points worn = moved(depth);
  for (int correction = 0; correction < 12; ++correction) {
    const double ratio = wanted / area_between(now_, worn);
    for (double& value : depth) {
      value *= ratio;
    }
    worn = moved(depth);
  }
  now_ = std::move(worn);
}

Profile WornProfile::profile() const {
  Profile profile;
  constexpr double no_smoothing = 0.0; // points of a curve, which has no noise
  profile.set_points(kind_ == WRC_WHEEL ? "worn wheel" : "worn rail", kind_, now_.lateral,
                     now_.height, no_smoothing);
  return profile;
}

double WornProfile::missing_area() const {
  return area_between(fresh_, now_);
}

std::vector<double> WornProfile::depths() const {
  std::vector<double> depths;
  for (std::size_t i = 0; i < now_.lateral.size(); ++i) {
    depths.push_back(
        std::hypot(now_.lateral[i] - fresh_.lateral[i], now_.height[i] - fresh_.height[i]));
  }
  return depths;
}

} // namespace driver
