#include "reports/profile_measures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "support/scene.hpp"

namespace driver {
namespace {

/// Points of each piece; curvature is a low polynomial in between.
constexpr int points_a_piece = 8;
/// Halvings until an arc length of 500 mm is known to rounding.
constexpr int halvings = 60;
constexpr double degree = std::numbers::pi / 180.0;
/// Rounding of the angle of a vertical side, which is no overhang.
constexpr double angle_rounding = 1e-9;
/// Heights and depths at which wheels and rails are measured, mm (EN 13715, EN 13674-1).
constexpr double flange_measuring_height = 10.0;
constexpr double below_flange_tip = 2.0;
constexpr double upper_head_depth = 14.0;
constexpr double lower_head_depth = 16.0;
/// Half chord of the circle that defines the crown radius: inside the crown arc of all rails built
/// in, and long against the noise of a measurement.
constexpr double crown_half_chord = 5.0;

using Quantity = std::function<double(const ProfilePoint&)>;

double lateral_of(const ProfilePoint& point) {
  return point.lateral;
}

double height_of(const ProfilePoint& point) {
  return point.height;
}

/// Arc lengths at which a quantity passes a value, in ascending order.
std::vector<double> crossings(const Profile& profile, const std::vector<ProfilePoint>& points,
                              const Quantity& quantity, double value) {
  std::vector<double> arcs;
  for (std::size_t i = 1; i < points.size(); ++i) {
    double before = points[i - 1].arc;
    double after = points[i].arc;
    const bool rises = quantity(points[i - 1]) < value;
    if (rises == (quantity(points[i]) < value)) {
      continue;
    }
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (before + after);
      ((quantity(point_at(profile, middle)) < value) == rises ? before : after) = middle;
    }
    arcs.push_back(after);
  }
  return arcs;
}

std::optional<ProfilePoint> first_after(const Profile& profile, const std::vector<double>& arcs,
                                        double arc) {
  const auto found = std::upper_bound(arcs.begin(), arcs.end(), arc);
  return found == arcs.end() ? std::nullopt : std::optional(point_at(profile, *found));
}

std::optional<ProfilePoint> last_before(const Profile& profile, const std::vector<double>& arcs,
                                        double arc) {
  const auto found = std::lower_bound(arcs.begin(), arcs.end(), arc);
  return found == arcs.begin() ? std::nullopt : std::optional(point_at(profile, *(found - 1)));
}

/// The point of largest quantity: among the given points, then between the neighbours of the best.
ProfilePoint greatest(const Profile& profile, const std::vector<ProfilePoint>& points,
                      const Quantity& quantity) {
  const auto less = [&quantity](const ProfilePoint& a, const ProfilePoint& b) {
    return quantity(a) < quantity(b);
  };
  const auto best = std::max_element(points.begin(), points.end(), less);
  double first = best == points.begin() ? best->arc : (best - 1)->arc;
  double last = best + 1 == points.end() ? best->arc : (best + 1)->arc;
  for (int k = 0; k < halvings; ++k) {
    const double third = (last - first) / 3.0;
    if (less(point_at(profile, first + third), point_at(profile, last - third))) {
      first += third;
    } else {
      last -= third;
    }
  }
  return std::max(point_at(profile, 0.5 * (first + last)), *best, less);
}

ProfilePoint highest(const Profile& profile, const std::vector<ProfilePoint>& points) {
  return greatest(profile, points, height_of);
}

std::vector<Dimension> wheel_dimensions(const Profile& profile,
                                        const std::vector<ProfilePoint>& points,
                                        double flange_back) {
  const ProfilePoint tip = highest(profile, points);
  const auto at_taping_line = crossings(profile, points, lateral_of, 0.0);
  std::optional<double> flange_height;
  std::optional<double> flange_thickness;
  std::optional<double> steepness;
  std::optional<double> slope;
  if (!at_taping_line.empty()) {
    const ProfilePoint taping = point_at(profile, at_taping_line.back());
    flange_height = tip.height - taping.height;
    slope = std::tan(taping.angle);
    const auto flank = first_after(
        profile, crossings(profile, points, height_of, taping.height + flange_measuring_height),
        tip.arc);
    const auto below_tip = first_after(
        profile, crossings(profile, points, height_of, tip.height - below_flange_tip), tip.arc);
    if (flank) {
      flange_thickness = flank->lateral - flange_back;
    }
    if (flank && below_tip) {
      steepness = flank->lateral - below_tip->lateral;
    }
  }
  const std::optional<double> conicity = slope ? std::optional(-*slope) : std::nullopt;
  return {
      {"flange_height", "flange height", "mm", flange_height, "tip above the taping line"},
      {"flange_thickness", "flange thickness", "mm", flange_thickness,
       "flange back to flank, 10 mm above the taping line"},
      {"qr", "qR", "mm", steepness,
       "across, from 2 mm below the flange tip to the flank 10 mm above the taping line"},
      {"slope", "slope at taping line", "", slope, "height over lateral; a cone falls outwards"},
      {"conicity", "conicity", "", conicity, "of the cone tangent at the taping line"}};
}

std::optional<double> head_width(const Profile& profile, const std::vector<ProfilePoint>& points,
                                 const ProfilePoint& top, double depth) {
  const auto arcs = crossings(profile, points, height_of, top.height - depth);
  const auto gauge = last_before(profile, arcs, top.arc);
  const auto field = first_after(profile, arcs, top.arc);
  return gauge && field ? std::optional(field->lateral - gauge->lateral) : std::nullopt;
}

/// Radius of the circle through the top and the curve on both sides of it.
std::optional<double> crown_radius(const Profile& profile, const std::vector<ProfilePoint>& points,
                                   const ProfilePoint& top) {
  const auto gauge = last_before(
      profile, crossings(profile, points, lateral_of, top.lateral - crown_half_chord), top.arc);
  const auto field = first_after(
      profile, crossings(profile, points, lateral_of, top.lateral + crown_half_chord), top.arc);
  if (!gauge || !field) {
    return std::nullopt;
  }
  const double a = std::hypot(top.lateral - gauge->lateral, top.height - gauge->height);
  const double b = std::hypot(field->lateral - top.lateral, field->height - top.height);
  const double c = std::hypot(field->lateral - gauge->lateral, field->height - gauge->height);
  const double twice_area = (top.lateral - gauge->lateral) * (field->height - gauge->height) -
                            (top.height - gauge->height) * (field->lateral - gauge->lateral);
  return twice_area == 0.0 ? std::nullopt : std::optional(a * b * c / (-2.0 * twice_area));
}

std::vector<Dimension> rail_dimensions(const Profile& profile,
                                       const std::vector<ProfilePoint>& points) {
  const ProfilePoint top = highest(profile, points);
  return {{"head_width_14", "head width at 14 mm", "mm",
           head_width(profile, points, top, upper_head_depth), "14 mm below the top"},
          {"head_width_16", "head width at 16 mm", "mm",
           head_width(profile, points, top, lower_head_depth), "16 mm below the top"},
          {"crown_radius", "crown radius", "mm", crown_radius(profile, points, top),
           "circle through the top and the points 5 mm beside it"}};
}

std::vector<SteepPart> find_steep_parts(const std::vector<ProfilePoint>& points) {
  std::vector<SteepPart> parts;
  bool inside = false;
  for (const ProfilePoint& point : points) {
    if (std::abs(point.angle) <= steep_angle * degree) {
      inside = false;
      continue;
    }
    if (!inside) {
      parts.push_back({point, point, point.angle, false});
    }
    inside = true;
    SteepPart& part = parts.back();
    part.last = point;
    if (std::abs(point.angle) > std::abs(part.steepest_angle)) {
      part.steepest_angle = point.angle;
    }
    part.overhangs =
        part.overhangs || std::abs(point.angle) > 0.5 * std::numbers::pi + angle_rounding;
  }
  return parts;
}

Checks check_curve(const std::vector<ProfilePoint>& points) {
  Checks checks;
  double largest_curvature = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ProfilePoint& point = points[i];
    if (std::abs(point.curvature) > largest_curvature) {
      largest_curvature = std::abs(point.curvature);
      checks.radius_at = point;
    }
    // The last point of a piece is followed by the first of the next one.
    if (i == 0 || i % (points_a_piece + 1) != 0) {
      continue;
    }
    const ProfilePoint& before = points[i - 1];
    const double kink =
        std::abs(std::remainder(point.angle - before.angle, 2.0 * std::numbers::pi));
    const double step = std::hypot(point.lateral - before.lateral, point.height - before.height);
    if (kink > checks.largest_kink) {
      checks.largest_kink = kink;
      checks.kink_at = point;
    }
    if (step > checks.largest_step) {
      checks.largest_step = step;
      checks.step_at = point;
    }
  }
  checks.smallest_radius = largest_curvature > 0.0 ? 1.0 / largest_curvature : 0.0;
  checks.steep_parts = find_steep_parts(points);
  return checks;
}

constexpr double comparison_spacing = 0.1; // mm
/// Steps of the golden section: the bracket of two spacings shrinks to 1e-9 mm, where the distance,
/// flat at its minimum, is exact to rounding.
constexpr int golden_steps = 40;
constexpr double golden_ratio = 0.61803398874989485;

double distance_between(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(a.lateral - b.lateral, a.height - b.height);
}

struct Foot {
  ProfilePoint point;
  bool at_end = false; ///< the other profile ends before the counterpart of the point
};

Foot find_foot(const Profile& other, const std::vector<ProfilePoint>& coarse,
               const ProfilePoint& point) {
  const auto nearer = [&point](const ProfilePoint& a, const ProfilePoint& b) {
    return distance_between(a, point) < distance_between(b, point);
  };
  const auto nearest = std::min_element(coarse.begin(), coarse.end(), nearer);
  double first = nearest == coarse.begin() ? nearest->arc : (nearest - 1)->arc;
  double last = nearest + 1 == coarse.end() ? nearest->arc : (nearest + 1)->arc;
  for (int k = 0; k < golden_steps; ++k) {
    const double reach = golden_ratio * (last - first);
    if (distance_between(point_at(other, last - reach), point) <
        distance_between(point_at(other, first + reach), point)) {
      last = first + reach;
    } else {
      first = last - reach;
    }
  }
  const ProfilePoint foot = point_at(other, 0.5 * (first + last));
  // At an end of the curve the connecting line need not be normal to it: then there is no
  // counterpart, unless the point lies beside the end.
  const double along = (point.lateral - foot.lateral) * std::cos(foot.angle) +
                       (point.height - foot.height) * std::sin(foot.angle);
  const bool beyond = (foot.arc < 0.5 * comparison_spacing && along < -1e-6) ||
                      (foot.arc > coarse.back().arc - 0.5 * comparison_spacing && along > 1e-6);
  return {foot, beyond};
}

} // namespace

ProfilePoint point_at(const Profile& profile, double arc) {
  const Profile::Point point = profile.at(arc);
  return {arc, point.lateral, point.height, point.angle, point.curvature};
}

std::vector<ProfilePoint> equal_points(const Profile& profile, double spacing) {
  const double length = profile.length();
  const auto parts = static_cast<std::size_t>(std::ceil(length / spacing));
  std::vector<ProfilePoint> points;
  points.reserve(parts + 1);
  for (std::size_t i = 0; i <= parts; ++i) {
    points.push_back(
        point_at(profile, length * (static_cast<double>(i) / static_cast<double>(parts))));
  }
  return points;
}

std::vector<ProfilePoint> piece_points(const Profile& profile) {
  const std::vector<double> nodes = profile.nodes();
  std::vector<ProfilePoint> points;
  points.reserve(nodes.size() * (points_a_piece + 1));
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    // An arc length on a node counts to the piece that begins there.
    const double end = std::nextafter(nodes[i + 1], nodes[i]);
    for (int k = 0; k <= points_a_piece; ++k) {
      const double share = static_cast<double>(k) / points_a_piece;
      points.push_back(
          point_at(profile, k == points_a_piece ? end : std::lerp(nodes[i], end, share)));
    }
  }
  return points;
}

Measures measure(const Profile& profile, double flange_back) {
  const std::vector<ProfilePoint> points = piece_points(profile);
  Measures measures;
  measures.nodes = profile.nodes();
  measures.length = profile.length();
  const auto most = [&](const Quantity& quantity) {
    return quantity(greatest(profile, points, quantity));
  };
  measures.greatest_lateral = most(lateral_of);
  measures.greatest_height = most(height_of);
  measures.least_lateral = -most([](const ProfilePoint& point) { return -point.lateral; });
  measures.least_height = -most([](const ProfilePoint& point) { return -point.height; });
  measures.dimensions = is_wheel(profile) ? wheel_dimensions(profile, points, flange_back)
                                          : rail_dimensions(profile, points);
  measures.checks = check_curve(points);
  return measures;
}

std::vector<double> distances_to(const Profile& other, const std::vector<ProfilePoint>& points) {
  const auto coarse = equal_points(other, comparison_spacing);
  std::vector<double> distances;
  for (const ProfilePoint& point : points) {
    const Foot foot = find_foot(other, coarse, point);
    // Along the normal that points to larger height, or on overhanging parts to the outside.
    distances.push_back(
        foot.at_end ? std::numeric_limits<double>::quiet_NaN()
                    : (foot.point.height - point.height) * std::cos(foot.point.angle) -
                          (foot.point.lateral - point.lateral) * std::sin(foot.point.angle));
  }
  return distances;
}

std::vector<Dimension> differences(const Measures& measures, const Measures& other) {
  std::vector<Dimension> all = measures.dimensions;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::optional<double>& subtrahend = other.dimensions[i].value;
    all[i].value =
        all[i].value && subtrahend ? std::optional(*all[i].value - *subtrahend) : std::nullopt;
  }
  return all;
}

Comparison compare(const Profile& profile, const Profile& other) {
  if (is_wheel(profile) != is_wheel(other)) {
    throw Failure("--compare " + other.text("name") + ": is a " + kind_name(other) +
                  "; must be a " + kind_name(profile) + " as " + profile.text("name") + " is");
  }
  const auto points = equal_points(profile, comparison_spacing);
  const std::vector<double> distances = distances_to(other, points);
  const double step = profile.length() / static_cast<double>(points.size() - 1);
  Comparison result;
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = distances[i];
    if (std::isnan(distance)) {
      continue;
    }
    squares += distance * distance;
    ++count;
    (distance > 0.0 ? result.missing_area : result.added_area) += std::abs(distance) * step;
    if (std::abs(distance) > std::abs(result.largest)) {
      result.largest = distance;
      result.largest_at = points[i];
    }
  }
  if (count == 0) {
    throw Failure("--compare " + other.text("name") + ": lies nowhere beside " +
                  profile.text("name") + "; both must be in the same frame");
  }
  result.rms = std::sqrt(squares / static_cast<double>(count));
  result.compared =
      profile.length() * static_cast<double>(count) / static_cast<double>(points.size());
  return result;
}

} // namespace driver
