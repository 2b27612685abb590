#include "measured/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "measured/profile_shape.hpp"

namespace wrc::reading {
namespace {

/// What wheels and rails of railways and trams measure, mm.
/// origin: published: wheels are 105 to 150 mm wide, heads of rails 50 to 80 (EN 13715, EN 13674-1,
/// EN 14811), measurements may end earlier; flanges are 20 (trams) to 38 mm (worn) high, their tips
/// 10 to 21 mm from the flange back.
constexpr Position width_range{50.0, 200.0};
constexpr Position flange_range{20.0, 45.0};
constexpr Position tip_range{8.0, 28.0};
/// A flange back that was measured is where the taping line says, by this, mm; it is measured if
/// the points begin so far below the tip. origin: reasoned: backs wear by 2 mm at most; rounded
/// tips are 5 to 8 mm high.
constexpr double back_tolerance = 4.0;
constexpr double back_depth = 10.0;
/// Reach of a wheel beside its taping line, mm: its flange root and the outer tread.
/// origin: published: the flank begins 32 to 40 mm beside the taping line (EN 13715).
constexpr double least_reach = 20.0;
/// A crown farther from height 0 than this is measured from elsewhere, mm.
/// origin: measured: worn rails of the collection have their crown at up to 1.7 mm below 0.
constexpr double crown_tolerance = 5.0;

/// A wheel that is given as a rail: how wide its flange and its tread are, and what may be as high
/// as the tread beyond the tip, mm. origin: measured: flanges of the collection are 28 to 38 mm
/// wide, treads beside them 95 to 111. Of rails a crossing has parts 29 mm wide and 38 mm off the
/// rest, which is 54 mm wide; one with wings a groove 38 mm wide and 49 mm deep, one with a guard
/// rail a groove of 52 and 47 mm.
constexpr Position flange_width_range{20.0, 45.0};
constexpr double least_tread_width = 75.0;
constexpr double most_beyond_tip = 10.0;

/// Depth below the top that a wheel touches, and depth of a chamfer, mm.
/// origin: published: gauge faces are measured 14 mm below the top, chamfers are 5 mm high (EN
/// 13715).
constexpr double contact_depth = 14.0;
constexpr double chamfer_depth = 6.0;

/// Limits of gaps between neighbours and of steps, mm. A gap stands out from all distances or from
/// those beside it.
/// origin: reasoned: a patch is 5 to 20 mm long, approaches are 0.1 mm; coarse points that are
/// equally far apart are no gap up to the size of a patch. A missing point makes twice the distance
/// of those beside it, a flank among points of equal lateral distances at most 1.5 times.
constexpr double largest_gap = 3.0;
constexpr double gap_ratio = 4.0;
constexpr double ratio_beside_gap = 1.75;
constexpr double largest_coarse_gap = 10.0;
constexpr double largest_step = 1.0;
/// Lines on both sides of a step run alike, the chord between them does not.
/// origin: reasoned: more is a corner, less the turn of an arc of 13 mm among points 4 mm apart.
constexpr double step_angle = 20.0 * std::numbers::pi / 180.0;
/// Points on each side of a step that its direction is taken from.
/// origin: reasoned: enough to average scatter of a tenth of their distance.
constexpr std::size_t step_points = 3;
/// Lateral may run back by this, mm.
/// origin: reasoned: scatter on steep flanks is a tenth of this.
constexpr double largest_return = 0.3;

/// Pressure that flattens the scatter of points, MPa, above which they are smoothed, and of points
/// whose scatter is that of their digits, which is sure to be no shape.
/// origin: measured: pmax of S1002 is 5 % too large with 54 (10,000 points of five digits), 0.6 %
/// with 39 (points 0.25 mm apart, four digits); a measured rail whose pmax changes by 0.7 % has 59.
constexpr double notable_pressure = 60.0;
constexpr double notable_pressure_of_digits = 40.0;
/// Scatter up to this share of the last digit is that of the digits.
/// origin: derived: rounding alone makes 0.29 of it.
constexpr double share_of_digit = 0.5;
/// Last digits that are tried, and how exactly points are multiples of one of them.
/// origin: bound: shifts and mirrors of points leave rounding of 1e-12.
constexpr int most_digits = 7;
constexpr double digit_tolerance = 1e-4;
/// Pressure amplitude over amplitude of waves two points long, in mean squares, MPa.
/// origin: published: pi E* / wavelength (Johnson, Contact Mechanics, 13.2), E* of steel 115 GPa.
constexpr double flattening = std::numbers::pi * 115e3 * std::numbers::sqrt2 / 2.0;
/// Of points farther apart, mm, scatter and shape cannot be distinguished.
/// origin: measured: exact standard profiles seem to need 7 MPa at this distance, 50 at 2.5 mm.
constexpr double scatter_spacing = 2.0;
/// The median of |e| in standard deviations of the points.
/// origin: derived: e = n[-2]/4 - n[-1] + 1.5 n[0] - n[1] + n[2]/4 has 2.09 of them, its median
/// 0.6745 of that.
constexpr double scatter_of_median = 1.41;

/// A curve that leaves the chord of two neighbours by more than this, mm and as a fraction of the
/// chord, swings. origin: derived: an arc over a chord leaves it by 0.2 of its length where it
/// turns by 87 degrees.
constexpr double largest_swing = 0.5;
constexpr double swing_share = 0.2;

void check_range(double value, const Position& range, WarningClass kind, const std::string& what,
                 const std::string& remedy, Log& log) {
  if (value < range[0] || value > range[1])
    log.warn(kind, what + " " + fixed_text(value) + " mm, expected " + fixed_text(range[0], 0) +
                       " to " + fixed_text(range[1], 0) + "; " + remedy);
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
  if (touched)
    log.warn(kind, text);
  else
    log.note(text + ", where wheel and rail do not touch");
}

Part contact_part(std::span<const Position> points, ProfileKind kind) {
  Part part;
  if (kind == ProfileKind::rail) {
    part.least_height = extent_of(points, 1)[1] - contact_depth;
    return part;
  }
  const std::optional<double> tape = height_at_taping_line(points);
  part.least_height = (tape ? *tape : points.back()[1]) - chamfer_depth;
  const std::optional<Flange> flange = flange_of(points);
  if (flange && !flange->is_outside && !flange->is_down)
    part.least_lateral = flange->tip[0];
  return part;
}

double angle_between(const Position& a, const Position& b, const Position& c, const Position& d) {
  return std::remainder(std::atan2(d[1] - c[1], d[0] - c[0]) - std::atan2(b[1] - a[1], b[0] - a[0]),
                        2.0 * std::numbers::pi);
}

/// Offset of the line after a pair of points from the line before it, if both run alike.
double step_at(std::span<const Position> points, std::size_t i) {
  const std::size_t before = i >= step_points ? i - step_points : 0;
  const std::size_t after = std::min(i + 1 + step_points, points.size() - 1);
  if (before == i || after == i + 1 ||
      std::abs(angle_between(points[before], points[i], points[i + 1], points[after])) > step_angle)
    return 0.0;
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
  return distance > largest_coarse_gap ||
         (distance > largest_gap &&
          (distance > gap_ratio * spacing || distance > ratio_beside_gap * beside));
}

void check_distances(std::span<const Position> points, const Part& part, Log& log) {
  const double spacing = median_spacing(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double distance = distance_between(points[i], points[i + 1]);
    if (distance <= largest_step)
      continue;
    const double step = step_at(points, i);
    const bool touched = part.holds(points[i], points[i + 1]);
    const std::string where =
        " between " + place_text(points[i]) + " and " + place_text(points[i + 1]);
    if (step > largest_step && step > std::sin(step_angle) * distance)
      tell(touched, WarningClass::profile_step, "step of " + fixed_text(step) + " mm" + where, log);
    else if (is_gap(points, i, spacing))
      tell(touched, WarningClass::profile_gap, "gap of " + fixed_text(distance) + " mm" + where,
           log);
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
    if (farthest - side * point[0] > worst.distance)
      worst = {farthest - side * point[0], point};
  }
  return worst;
}

/// On the part that can be in contact lateral ascends from its least to its greatest value; before
/// and behind, on worn gauge faces, it may run the other way.
void check_single_valued(std::span<const Position> points, const Part& part, Log& log) {
  std::vector<Position> surface;
  std::copy_if(points.begin(), points.end(), std::back_inserter(surface),
               [&](const Position& point) { return part.holds(point); });
  if (surface.empty())
    return;
  const auto [left, right] =
      std::minmax_element(surface.begin(), surface.end(),
                          [](const Position& a, const Position& b) { return a[0] < b[0]; });
  Return worst{std::max(0.0, right < left ? (*right)[0] - (*left)[0] : 0.0), *left};
  for (const Return& each : {largest_return_of({surface.begin(), left}, -1.0),
                             largest_return_of({left, std::max(left, right)}, 1.0),
                             largest_return_of({right, surface.end()}, -1.0)})
    if (each.distance > worst.distance)
      worst = each;
  if (worst.distance > largest_return)
    log.warn(WarningClass::profile_overlap,
             "the running surface is not single-valued: lateral runs back by " +
                 fixed_text(worst.distance) + " mm at " + place_text(worst.place));
}

/// Whether the flange is where the taping line, at 0, says.
void check_flange_back(std::span<const Position> points, const Flange& flange, double tape_offset,
                       Log& log) {
  check_range(flange.tip[0] + tape_offset, tip_range, WarningClass::profile_origin,
              "with the taping line at 0, the flange tip's distance from the flange back is",
              "state profile_origin", log);
  const double back = extent_of(points, 0)[0];
  const bool measured = points.front()[1] < flange.tip[1] - back_depth;
  if (back < -tape_offset - back_tolerance || (measured && back > -tape_offset + back_tolerance))
    log.warn(WarningClass::profile_origin,
             "the flange back is at lateral " + fixed_text(back) + " mm, expected " +
                 fixed_text(-tape_offset) +
                 " by the distance of the taping line; state profile_origin " + "or tape_offset");
}

void check_wheel(std::span<const Position> points, double tape_offset, bool is_aligned, Log& log) {
  const std::string remedy = "state profile_origin, mirror_height or the scale";
  const Position lateral = extent_of(points, 0);
  if (lateral[0] > -least_reach || lateral[1] < least_reach)
    log.warn(WarningClass::profile_origin, "lateral from " + fixed_text(lateral[0]) + " to " +
                                               fixed_text(lateral[1]) +
                                               " mm: the taping line, at 0, is not inside by " +
                                               fixed_text(least_reach, 0) + " mm; " + remedy);
  const std::optional<Flange> flange = flange_of(points);
  if (!flange) {
    log.warn(WarningClass::profile_flange,
             "no flange found: no part 12 mm wide rises more than 8 mm above the tread");
    return;
  }
  if (flange->is_down)
    log.warn(WarningClass::profile_signs, "the flange points to smaller radius, its tip at " +
                                              place_text(flange->tip) + "; " + remedy);
  if (!flange->is_down && extent_of(points, 1)[1] > flange->tip[1])
    log.warn(WarningClass::profile_signs, "height up to " + fixed_text(extent_of(points, 1)[1]) +
                                              " mm, above the flange tip at " +
                                              place_text(flange->tip));
  if (flange->is_outside)
    log.warn(WarningClass::profile_signs, "the flange is on the field side, its tip at " +
                                              place_text(flange->tip) + "; state mirror_lateral");
  const std::optional<double> tape = height_at_taping_line(points);
  if (tape && std::abs(*tape) > tape_height_tolerance && !is_aligned)
    log.warn(WarningClass::profile_origin,
             "height " + fixed_text(*tape) + " mm at the taping line, expected 0; " + remedy);
  check_range(tape && !flange->is_down ? flange->tip[1] - *tape : flange->height, flange_range,
              WarningClass::profile_dimensions, "flange height", remedy, log);
  if (!flange->is_down && !flange->is_outside)
    check_flange_back(points, *flange, tape_offset, log);
}

bool is_inside(double value, const Position& range) {
  return value >= range[0] && value <= range[1];
}

void check_rail(std::span<const Position> points, Log& log) {
  if (const std::optional<Flange> flange = flange_of(points);
      flange && is_inside(flange->width, flange_width_range) &&
      is_inside(flange->height, flange_range) && flange->tread_width >= least_tread_width &&
      flange->beyond_tip <= most_beyond_tip)
    log.warn(WarningClass::profile_dimensions,
             "the shape is that of a wheel, with a flange " + fixed_text(flange->height, 0) +
                 " mm high beside a tread " + fixed_text(flange->tread_width, 0) +
                 " mm wide; expected is a rail");
  const std::optional<Head> head = head_of(points);
  if (head && head->is_down)
    log.warn(WarningClass::profile_signs, "the head points down: " + fixed_text(head->top_width) +
                                              " mm wide at its lower end, " +
                                              fixed_text(head->bottom_width) +
                                              " mm at its upper one; state mirror_height");
  const double crown = extent_of(points, 1)[1];
  if (std::abs(crown) > crown_tolerance)
    log.warn(WarningClass::profile_origin,
             "the crown is at height " + fixed_text(crown) +
                 " mm, expected near 0; a scene puts it to the height of the track");
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
  for (std::size_t i = 2; i + 2 < points.size(); ++i)
    rough.push_back(std::abs(off[i] - 0.5 * (off[i - 1] + off[i + 1])));
  if (rough.empty())
    return 0.0;
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
        }))
      return digit;
    digit *= 0.1;
  }
  return 0.0;
}

} // namespace

std::optional<double> height_at_taping_line(std::span<const Position> points) {
  for (std::size_t i = points.size(); i-- > 1;) {
    const Position& a = points[i - 1];
    const Position& b = points[i];
    if (std::min(a[0], b[0]) <= 0.0 && std::max(a[0], b[0]) >= 0.0)
      return a[0] == b[0] ? b[1] : a[1] + (b[1] - a[1]) * (0.0 - a[0]) / (b[0] - a[0]);
  }
  return std::nullopt;
}

void check_points(std::span<const Position> points, ProfileKind kind, double tape_offset, Log& log,
                  bool is_aligned) {
  const Position lateral = extent_of(points, 0);
  const double width = lateral[1] - lateral[0];
  const bool is_crown = kind == ProfileKind::rail && width >= width_range[0];
  if (const std::optional<double> radius = is_crown ? std::nullopt : disc_radius_of(points)) {
    log.note("a disc without flange or rail head, " + fixed_text(width) + " mm wide" +
             (std::isfinite(*radius) ? ", a circle of radius " + short_text_of(*radius) + " mm"
                                     : ", a cylinder"));
    const Part everything{-HUGE_VAL, -HUGE_VAL};
    check_distances(points, everything, log);
    check_single_valued(points, everything, log);
    return;
  }
  check_range(width, width_range, WarningClass::profile_dimensions, "width", "state the scale",
              log);
  if (kind == ProfileKind::wheel)
    check_wheel(points, tape_offset, is_aligned, log);
  else
    check_rail(points, log);
  const Part part = contact_part(points, kind);
  check_distances(points, part, log);
  check_single_valued(points, part, log);
}

Scatter scatter_of(std::span<const Position> points) {
  const double spacing = median_spacing(points);
  if (spacing > scatter_spacing)
    return {};
  return scatter_of(points, deviation_of(points, spacing));
}

Scatter scatter_of(std::span<const Position> points, double deviation) {
  return {deviation, flattening * deviation / median_spacing(points),
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
           std::hypot(at.lateral - points[passed + 1][0], at.height - points[passed + 1][1]) < 1e-9)
      ++passed;
    if (passed + 1 >= points.size())
      break;
    const Position& a = points[passed];
    const Position& b = points[passed + 1];
    const double length = distance_between(a, b);
    const double off =
        std::abs((b[0] - a[0]) * (at.height - a[1]) - (b[1] - a[1]) * (at.lateral - a[0])) / length;
    Swing& largest = part.holds(a, b) ? touched : untouched;
    if (off > largest_swing && off > swing_share * length && off > largest.off)
      largest = {off, passed};
  }
  for (const Swing* swing : {&touched, &untouched})
    if (swing->off > 0.0)
      tell(swing == &touched, WarningClass::profile_swing,
           "the curve swings by " + fixed_text(swing->off) + " mm between the points " +
               place_text(points[swing->place]) + " and " + place_text(points[swing->place + 1]),
           log);
}

} // namespace wrc::reading
