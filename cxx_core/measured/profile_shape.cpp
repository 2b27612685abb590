#include "measured/profile_shape.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "measured/plausible_shapes.hpp"
#include "profile/crown.hpp"

namespace wrc::reading {
namespace {

/// Height that half of the lateral extent lies above.
double level_of(std::span<const Position> points) {
  struct Part {
    double height;
    double width;
  };
  std::vector<Part> parts;
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double width = std::abs(points[i][0] - points[i - 1][0]);
    parts.push_back({0.5 * (points[i][1] + points[i - 1][1]), width});
    total += width;
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.height < b.height; });
  double passed = 0.0;
  for (const Part& part : parts) {
    passed += part.width;
    if (passed >= 0.5 * total) {
      return part.height;
    }
  }
  return points.front()[1];
}

struct Run {
  double width = 0.0;
  Position extreme{};
};

/// The widest run of points off the level by more than a distance, to one side of it.
Run widest_run(std::span<const Position> points, double level, double side) {
  Run widest;
  Run run;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto off = [&](const Position& p) { return side * (p[1] - level); };
    if (off(points[i]) <= plausible::off_tread) {
      run = {};
      continue;
    }
    if (i > 0 && off(points[i - 1]) > plausible::off_tread) {
      run.width += std::abs(points[i][0] - points[i - 1][0]);
    } else {
      run.extreme = points[i];
    }
    if (off(points[i]) > off(run.extreme)) {
      run.extreme = points[i];
    }
    if (run.width >= widest.width) {
      widest = run;
    }
  }
  return widest;
}

} // namespace

Position extent_of(std::span<const Position> points, std::size_t coordinate) {
  const auto [least, greatest] = std::minmax_element(
      points.begin(), points.end(),
      [coordinate](const Position& a, const Position& b) { return a[coordinate] < b[coordinate]; });
  return {(*least)[coordinate], (*greatest)[coordinate]};
}

double crown_height_of(std::span<const Position> points) {
  std::vector<double> heights;
  for (const Position& point : points) {
    heights.push_back(point[1]);
  }
  return heights[crown_among(heights)];
}

double distance_between(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double chord_length(std::span<const Position> points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += distance_between(points[i], points[i - 1]);
  }
  return length;
}

double median_spacing(std::span<const Position> points) {
  std::vector<double> spacing;
  for (std::size_t i = 1; i < points.size(); ++i) {
    spacing.push_back(distance_between(points[i], points[i - 1]));
  }
  if (spacing.empty()) {
    return 0.0;
  }
  const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2);
  std::nth_element(spacing.begin(), middle, spacing.end());
  return *middle;
}

double angle_between(const Position& a, const Position& b, const Position& c, const Position& d) {
  return std::remainder(std::atan2(d[1] - c[1], d[0] - c[0]) - std::atan2(b[1] - a[1], b[0] - a[0]),
                        2.0 * std::numbers::pi);
}

std::size_t drop_close_points(std::vector<Position>& points, double least) {
  std::vector<Position> kept;
  for (const Position& point : points) {
    if (kept.empty() || distance_between(point, kept.back()) >= least) {
      kept.push_back(point);
    }
  }
  const std::size_t dropped = points.size() - kept.size();
  points = std::move(kept);
  return dropped;
}

std::string fixed_text(double value, int digits) {
  std::array<char, 400> buffer{};
  const auto [end, fault] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::fixed, digits);
  return fault == std::errc{} ? std::string(buffer.data(), end) : "?";
}

std::string place_text(const Position& point) {
  std::string text(1, '(');
  return text.append(fixed_text(point[0], 3)).append(", ").append(fixed_text(point[1], 3)) + ')';
}

std::optional<Flange> flange_of(std::span<const Position> points) {
  const double level = level_of(points);
  const Run above = widest_run(points, level, 1.0);
  const Run below = widest_run(points, level, -1.0);
  const bool is_down = below.width > above.width;
  const Run& flange = is_down ? below : above;
  const Run& other = is_down ? above : below;
  if (flange.width < plausible::least_flange_width ||
      flange.width < plausible::plainly_wider * other.width) {
    return std::nullopt;
  }
  const Position lateral = extent_of(points, 0);
  double left = 0.0;
  double right = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (std::abs(0.5 * (points[i][1] + points[i - 1][1]) - level) <= plausible::off_tread) {
      (points[i][0] < flange.extreme[0] ? left : right) +=
          std::abs(points[i][0] - points[i - 1][0]);
    }
  }
  return Flange{is_down,
                flange.extreme[0] > 0.5 * (lateral[0] + lateral[1]),
                flange.width,
                other.width,
                std::abs(flange.extreme[1] - level),
                std::max(left, right),
                std::min(left, right),
                flange.extreme};
}

std::optional<double> disc_radius_of(std::span<const Position> points) {
  const Position lateral = extent_of(points, 0);
  const Position height = extent_of(points, 1);
  const double middle = 0.5 * (lateral[0] + lateral[1]);
  const double width = lateral[1] - lateral[0];
  if (std::abs(middle) > plausible::disc_eccentricity * width) {
    return std::nullopt;
  }
  if (height[1] - height[0] <= plausible::disc_tolerance) {
    return HUGE_VAL;
  }
  // The circle through both ends and the point closest to the middle.
  const auto central = std::min_element(points.begin(), points.end(),
                                        [middle](const Position& a, const Position& b) {
                                          return std::abs(a[0] - middle) < std::abs(b[0] - middle);
                                        });
  const Position& a = points.front();
  const Position& b = *central;
  const Position& c = points.back();
  const Position ab{b[0] - a[0], b[1] - a[1]};
  const Position ac{c[0] - a[0], c[1] - a[1]};
  const double area = 2.0 * (ab[0] * ac[1] - ab[1] * ac[0]);
  if (area == 0.0) {
    return std::nullopt;
  }
  const double ab_square = ab[0] * ab[0] + ab[1] * ab[1];
  const double ac_square = ac[0] * ac[0] + ac[1] * ac[1];
  const Position centre{a[0] + (ac[1] * ab_square - ab[1] * ac_square) / area,
                        a[1] + (ab[0] * ac_square - ac[0] * ab_square) / area};
  const double radius = distance_between(centre, a);
  if (std::abs(centre[0] - middle) > plausible::disc_eccentricity * width) {
    return std::nullopt;
  }
  const bool is_on_circle = std::all_of(points.begin(), points.end(), [&](const Position& point) {
    return std::abs(distance_between(point, centre) - radius) < plausible::disc_tolerance;
  });
  return is_on_circle ? std::optional(radius) : std::nullopt;
}

std::optional<Head> head_of(std::span<const Position> points) {
  const Position height = extent_of(points, 1);
  const double range = height[1] - height[0];
  const double depth = std::min(plausible::top_depth, plausible::top_share * range);
  Head head;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double width = std::abs(points[i][0] - points[i - 1][0]);
    const double middle = 0.5 * (points[i][1] + points[i - 1][1]);
    if (middle > height[1] - depth) {
      head.top_width += width;
    }
    if (middle < height[0] + depth) {
      head.bottom_width += width;
    }
  }
  if (std::max(head.top_width, head.bottom_width) <
      plausible::plainly_wider * std::min(head.top_width, head.bottom_width)) {
    return std::nullopt;
  }
  head.is_down = head.bottom_width > head.top_width;
  if (range > plausible::greatest_head_height) { // the wide end is the foot
    head.is_down = !head.is_down;
  }
  if (head.is_down) {
    std::swap(head.top_width, head.bottom_width);
  }
  return head;
}

} // namespace wrc::reading
