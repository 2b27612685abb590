#include "measured/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "base/error.hpp"
#include "measured/constants.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/profile_shape.hpp"
#include "profile/constants.hpp"

namespace wrc::reading {
namespace {

/// The warning of a shape with values in it.
std::string warning_text(const plausible::Shape& shape, std::initializer_list<double> values) {
  const double* value = values.begin();
  std::string text;
  for (const char c : shape.warning) {
    if (c == '<' || c == '>') {
      text += fixed_text(shape.range[c == '>' ? 1 : 0], 0);
    } else if (c == '%' || c == '#') {
      text += fixed_text(*value++, c == '%' ? 2 : 0);
    } else {
      text += c;
    }
  }
  return text;
}

void check(const plausible::Shape& shape, double value, Log& log) {
  if (!shape.holds(value)) {
    log.warn(shape.kind, warning_text(shape, {value}));
  }
}

/// Where a profile can be in contact: of a wheel, what lies to the field side of the flange tip.
struct Part {
  double least_lateral = -HUGE_VAL;
  double least_height = 0.0;

  [[nodiscard]] bool holds(const Position& point) const {
    return point[0] > least_lateral && point[1] > least_height;
  }
  /// Whether the chord between two points can be touched.
  [[nodiscard]] bool holds(const Position& a, const Position& b) const {
    return holds({std::max(a[0], b[0]), std::max(a[1], b[1])});
  }
};

/// A warning where wheel and rail touch, a note elsewhere.
void tell(bool touched, WarningClass kind, const std::string& text, Log& log) {
  if (touched) {
    log.warn(kind, text);
  } else {
    log.note(text + ", where wheel and rail do not touch");
  }
}

Part contact_part(std::span<const Position> points, ProfileKind kind) {
  Part part;
  if (kind == ProfileKind::rail) {
    part.least_height = crown_height_of(points) - plausible::contact_depth;
    return part;
  }
  const std::optional<double> tape = height_at_taping_line(points);
  part.least_height = (tape ? *tape : points.back()[1]) - plausible::chamfer_depth;
  const std::optional<Flange> flange = flange_of(points);
  if (flange && !flange->is_outside && !flange->is_down) {
    part.least_lateral = flange->tip[0];
  }
  return part;
}

/// Offset of the line after a pair of points from the line before it, if both run alike.
double step_at(std::span<const Position> points, std::size_t i) {
  const std::size_t before = i >= steps_of_line ? i - steps_of_line : 0;
  const std::size_t after = std::min(i + 1 + steps_of_line, points.size() - 1);
  if (before == i || after == i + 1 ||
      std::abs(angle_between(points[before], points[i], points[i + 1], points[after])) >
          step_angle) {
    return 0.0;
  }
  const Position along{points[i][0] - points[before][0] + points[after][0] - points[i + 1][0],
                       points[i][1] - points[before][1] + points[after][1] - points[i + 1][1]};
  return std::abs(along[0] * (points[i + 1][1] - points[i][1]) -
                  along[1] * (points[i + 1][0] - points[i][0])) /
         std::hypot(along[0], along[1]);
}

/// Whether the distance of a point from the next one is a gap among the others.
bool is_gap(std::span<const Position> points, std::size_t i, double spacing) {
  const double distance = distance_between(points[i], points[i + 1]);
  const double beside =
      std::max(i > 0 ? distance_between(points[i - 1], points[i]) : 0.0,
               i + 2 < points.size() ? distance_between(points[i + 1], points[i + 2]) : 0.0);
  return distance > farthest_neighbour ||
         (distance > largest_gap &&
          (distance > gap_ratio * spacing || distance > ratio_beside_gap * beside));
}

void check_distances(std::span<const Position> points, const Part& part, Log& log) {
  const double spacing = median_spacing(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double distance = distance_between(points[i], points[i + 1]);
    if (distance <= largest_step) {
      continue;
    }
    const double step = step_at(points, i);
    const bool touched = part.holds(points[i], points[i + 1]);
    const std::string where =
        " between " + place_text(points[i]) + " and " + place_text(points[i + 1]);
    if (step > largest_step && step > std::sin(step_angle) * distance) {
      tell(touched, WarningClass::profile_step, "step of " + fixed_text(step) + " mm" + where, log);
    } else if (is_gap(points, i, spacing)) {
      tell(touched, WarningClass::profile_gap, "gap of " + fixed_text(distance) + " mm" + where,
           log);
    }
  }
}

struct Return {
  double distance = 0.0;
  Position place{};
};

/// How far lateral comes back from where it was farthest to one side, +1 or -1.
Return largest_return_of(std::span<const Position> points, double side) {
  Return worst;
  double farthest = -HUGE_VAL;
  for (const Position& point : points) {
    farthest = std::max(farthest, side * point[0]);
    if (farthest - side * point[0] > worst.distance) {
      worst = {farthest - side * point[0], point};
    }
  }
  return worst;
}

/// On the part that can be in contact lateral ascends from its least to its greatest value; before
/// and behind, on worn gauge faces, it may run the other way.
void check_single_valued(std::span<const Position> points, const Part& part, Log& log) {
  std::vector<Position> surface;
  std::copy_if(points.begin(), points.end(), std::back_inserter(surface),
               [&](const Position& point) { return part.holds(point); });
  if (surface.empty()) {
    return;
  }
  const auto [left, right] =
      std::minmax_element(surface.begin(), surface.end(),
                          [](const Position& a, const Position& b) { return a[0] < b[0]; });
  Return worst{std::max(0.0, right < left ? (*right)[0] - (*left)[0] : 0.0), *left};
  for (const Return& each : {largest_return_of({surface.begin(), left}, -1.0),
                             largest_return_of({left, std::max(left, right)}, 1.0),
                             largest_return_of({right, surface.end()}, -1.0)}) {
    if (each.distance > worst.distance) {
      worst = each;
    }
  }
  if (worst.distance > largest_return) {
    log.warn(WarningClass::profile_overlap,
             "the running surface is not single-valued: lateral runs back by " +
                 fixed_text(worst.distance) + " mm at " + place_text(worst.place));
  }
}

/// Whether the flange is where the taping line, at 0, says.
void check_flange_back(std::span<const Position> points, const Flange& flange, double tape_offset,
                       Log& log) {
  using plausible::back_distance;
  check(plausible::tip_distance, flange.tip[0] + tape_offset, log);
  const double back = extent_of(points, 0)[0];
  const bool measured = points.front()[1] < flange.tip[1] - plausible::back_depth;
  if (back < -tape_offset + back_distance.range[0] ||
      (measured && back > -tape_offset + back_distance.range[1])) {
    log.warn(back_distance.kind, warning_text(back_distance, {back, -tape_offset}));
  }
}

void check_wheel(std::span<const Position> points, double tape_offset, bool is_aligned, Log& log) {
  const Position lateral = extent_of(points, 0);
  if (lateral[0] > plausible::reach.range[0] || lateral[1] < plausible::reach.range[1]) {
    log.warn(plausible::reach.kind, warning_text(plausible::reach, {lateral[0], lateral[1]}));
  }
  const std::optional<Flange> flange = flange_of(points);
  if (!flange) {
    log.warn(WarningClass::profile_flange,
             "no flange found: no part " + fixed_text(plausible::least_flange_width, 0) +
                 " mm wide rises more than " + fixed_text(plausible::off_tread, 0) +
                 " mm above the tread");
    return;
  }
  if (flange->is_down) {
    log.warn(WarningClass::profile_signs, "the flange points to smaller radius, its tip at " +
                                              place_text(flange->tip) +
                                              "; state origin, mirror_height or the scale");
  }
  if (!flange->is_down && extent_of(points, 1)[1] > flange->tip[1]) {
    log.warn(WarningClass::profile_signs, "height up to " + fixed_text(extent_of(points, 1)[1]) +
                                              " mm, above the flange tip at " +
                                              place_text(flange->tip));
  }
  if (flange->is_outside) {
    log.warn(WarningClass::profile_signs, "the flange is on the field side, its tip at " +
                                              place_text(flange->tip) + "; state mirror_lateral");
  }
  const std::optional<double> tape = height_at_taping_line(points);
  if (tape && !is_aligned) {
    check(plausible::tape_height, *tape, log);
  }
  check(plausible::flange_height,
        tape && !flange->is_down ? flange->tip[1] - *tape : flange->height, log);
  if (!flange->is_down && !flange->is_outside) {
    check_flange_back(points, *flange, tape_offset, log);
  }
}

void check_rail(std::span<const Position> points, Log& log) {
  if (const std::optional<Flange> flange = flange_of(points);
      flange && plausible::flange_width.holds(flange->width) &&
      plausible::flange_height.holds(flange->height) &&
      flange->tread_width >= plausible::least_tread_width &&
      flange->beyond_tip <= plausible::most_beyond_tip) {
    log.warn(plausible::flange_width.kind,
             warning_text(plausible::flange_width, {flange->height, flange->tread_width}));
  }
  const std::optional<Head> head = head_of(points);
  if (head && head->is_down) {
    log.warn(WarningClass::profile_signs, "the head points down: " + fixed_text(head->top_width) +
                                              " mm wide at its lower end, " +
                                              fixed_text(head->bottom_width) +
                                              " mm at its upper one; state mirror_height");
  }
  check(plausible::crown_height, crown_height_of(points), log);
}

/// Standard deviation of the points from a smooth line, mm, by the second differences of their
/// curvature, so that neither arcs nor uneven distances count.
double deviation_of(std::span<const Position> points, double spacing) {
  std::vector<double> off(points.size(), 0.0); // from the chord of the neighbours, signed
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Position& before = points[i - 1];
    const Position chord{points[i + 1][0] - before[0], points[i + 1][1] - before[1]};
    const double area =
        chord[0] * (points[i][1] - before[1]) - chord[1] * (points[i][0] - before[0]);
    off[i] = area * spacing * spacing /
             std::max(std::hypot(chord[0], chord[1]) * distance_between(points[i], before) *
                          distance_between(points[i + 1], points[i]),
                      1e-12);
  }
  std::vector<double> rough;
  for (std::size_t i = 2; i + 2 < points.size(); ++i) {
    rough.push_back(std::abs(off[i] - 0.5 * (off[i - 1] + off[i + 1])));
  }
  if (rough.empty()) {
    return 0.0;
  }
  const auto middle = rough.begin() + static_cast<std::ptrdiff_t>(rough.size() / 2);
  std::nth_element(rough.begin(), middle, rough.end());
  return *middle / scatter_of_median;
}

/// The last digit that the points are written with, mm: their differences are multiples of it.
double last_digit_of(std::span<const Position> points) {
  double digit = 1.0;
  for (int i = 0; i <= most_digits; ++i) {
    const auto is_multiple = [digit](double difference) {
      const double ratio = difference / digit;
      return std::abs(ratio - std::round(ratio)) < digit_tolerance;
    };
    if (std::all_of(points.begin(), points.end(), [&](const Position& point) {
          return is_multiple(point[0] - points.front()[0]) &&
                 is_multiple(point[1] - points.front()[1]);
        })) {
      return digit;
    }
    digit *= 0.1;
  }
  return 0.0;
}

} // namespace

std::optional<double> height_at_taping_line(std::span<const Position> points) {
  for (std::size_t i = points.size(); i-- > 1;) {
    const Position& a = points[i - 1];
    const Position& b = points[i];
    if (std::min(a[0], b[0]) <= 0.0 && std::max(a[0], b[0]) >= 0.0) {
      return a[0] == b[0] ? b[1] : a[1] + (b[1] - a[1]) * (0.0 - a[0]) / (b[0] - a[0]);
    }
  }
  return std::nullopt;
}

void check_points(std::span<const Position> points, ProfileKind kind, double tape_offset, Log& log,
                  bool is_aligned) {
  const Position lateral = extent_of(points, 0);
  const double width = lateral[1] - lateral[0];
  const bool is_crown = kind == ProfileKind::rail && width >= plausible::width.range[0];
  if (const std::optional<double> radius = is_crown ? std::nullopt : disc_radius_of(points)) {
    log.note("a disc without flange or rail head, " + fixed_text(width) + " mm wide" +
             (std::isfinite(*radius) ? ", a circle of radius " + short_text_of(*radius) + " mm"
                                     : ", a cylinder"));
    const Part everything{-HUGE_VAL, -HUGE_VAL};
    check_distances(points, everything, log);
    check_single_valued(points, everything, log);
    return;
  }
  check(plausible::width, width, log);
  if (kind == ProfileKind::wheel) {
    check_wheel(points, tape_offset, is_aligned, log);
  } else {
    check_rail(points, log);
  }
  const Part part = contact_part(points, kind);
  check_distances(points, part, log);
  check_single_valued(points, part, log);
}

Scatter scatter_of(std::span<const Position> points) {
  const double spacing = median_spacing(points);
  if (spacing > scatter_spacing) {
    return {};
  }
  return scatter_of(points, deviation_of(points, spacing), 0.0);
}

Scatter scatter_of(std::span<const Position> points, double deviation, double distance) {
  return {deviation, flattening * deviation / std::max(median_spacing(points), distance),
          deviation < share_of_digit * last_digit_of(points)};
}

bool Scatter::matters() const {
  return pressure > (is_of_digits ? notable_pressure_of_digits : notable_pressure);
}

void check_curve(const Profile& profile, Log& log) {
  struct Swing {
    double off = 0.0;
    std::size_t place = 0;
  };
  Swing touched;
  Swing untouched;
  const std::vector<Position>& points = profile.points;
  const Part part = contact_part(points, profile.kind);
  std::size_t passed = 0; // the curve has nodes at all points and in between
  for (const double arc : profile.curve.starts()) {
    const CurvePoint at = profile.curve.at(arc);
    while (passed + 1 < points.size() &&
           std::hypot(at.lateral - points[passed + 1][0], at.height - points[passed + 1][1]) <
               negligible_length) {
      ++passed;
    }
    if (passed + 1 >= points.size()) {
      break;
    }
    const Position& a = points[passed];
    const Position& b = points[passed + 1];
    const double length = distance_between(a, b);
    const double off =
        std::abs((b[0] - a[0]) * (at.height - a[1]) - (b[1] - a[1]) * (at.lateral - a[0])) / length;
    Swing& largest = part.holds(a, b) ? touched : untouched;
    if (off > largest_swing && off > swing_share * length && off > largest.off) {
      largest = {off, passed};
    }
  }
  for (const Swing* swing : {&touched, &untouched}) {
    if (swing->off > 0.0) {
      tell(swing == &touched, WarningClass::profile_swing,
           "the curve swings by " + fixed_text(swing->off) + " mm between the points " +
               place_text(points[swing->place]) + " and " + place_text(points[swing->place + 1]),
           log);
    }
  }
}

} // namespace wrc::reading
