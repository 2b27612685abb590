#include "measured/tilt.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "measured/alignment.hpp"
#include "measured/profile_shape.hpp"
#include "measured/reader_formats.hpp"
#include "profile/profile.hpp"

namespace wrc::reading {
namespace {

constexpr double tilt_degree = std::numbers::pi / 180.0; // unit, not a tuning constant

/// A face is straight over this length at least, to this distance, mm, and within this angle of the
/// vertical. origin: measured: backs of three measured wheels are straight over 20 mm to 0.03 mm
/// (rms), field faces of two others over 10 and 16 mm.
constexpr double least_face = 10.0;
constexpr double straightness = 0.1;
constexpr double steep = 10.0 * tilt_degree;
/// Points closer than this tell nothing more of it, mm.
constexpr double point_spacing = 0.1; // origin: bound
/// Share of a face from its end that gives its direction: the rest may belong to the next arc.
/// origin: derived: arcs of 12 to 20 mm leave their tangent by 0.1 mm after 1.5 to 2 mm.
constexpr double outer_share = 0.8;
/// Faces that differ by less than this are parallel.
/// origin: reasoned: lines of 10 mm that scatter by 0.03 mm have it.
constexpr double parallel = 0.15 * tilt_degree;
/// A tilt of one face is a warning from here on, one of parallel faces is turned back.
/// origin: measured: on three measured wheels backs are tilted by 0.0, 0.3 and 0.5 degrees, of the
/// last one the field face, too.
constexpr double doubtful_face = 0.7 * tilt_degree;
/// A smaller tilt of parallel faces is said from here on.
/// origin: measured: the least that is surely no scatter; it changes pmax of S1002 by 20 %.
constexpr double notable_tilt = 0.1 * tilt_degree;
/// A wheel lies on a nominal one if this share of its points is within the last bound of
/// alignment.hpp. The turn is clear if it moves the wheel's ends by this many times what is left.
/// origin: measured (tests/core/measured/tilt_test.cpp): built-in wheels on each other, and
/// measured wheels on them, have less.
constexpr double share_on_nominal = 0.9;
constexpr double least_clearness = 5.0;
constexpr double half_width = 65.0; ///< origin: published: EN 13715
constexpr double doubtful_turn = 0.1 * tilt_degree;
/// Less of a wheel may lie anywhere, mm.
/// origin: published: wheels are 105 mm wide or more (EN 13715, EN 14811).
constexpr double least_width = 100.0;
/// Points that are laid on built-in wheels.
/// origin: bound: the turn is known to 0.01 degrees with noise of 0.02 mm.
constexpr std::size_t points_of_search = 120;

std::string degrees_text(double angle) {
  return fixed_text(angle / tilt_degree) + " degrees";
}

struct Line {
  Position middle{};
  Position along{};

  [[nodiscard]] double distance_from(const Position& point) const {
    return std::abs(along[0] * (point[1] - middle[1]) - along[1] * (point[0] - middle[0]));
  }
};

/// The line of least squared distances.
Line line_through(std::span<const Position> points) {
  Line line;
  for (const Position& point : points)
    for (std::size_t i = 0; i < 2; ++i)
      line.middle[i] += point[i] / static_cast<double>(points.size());
  double lateral = 0.0;
  double height = 0.0;
  double mixed = 0.0;
  for (const Position& point : points) {
    const Position off{point[0] - line.middle[0], point[1] - line.middle[1]};
    lateral += off[0] * off[0];
    height += off[1] * off[1];
    mixed += off[0] * off[1];
  }
  const double angle = 0.5 * std::atan2(2.0 * mixed, lateral - height);
  line.along = {std::cos(angle), std::sin(angle)};
  return line;
}

/// From vertical, anticlockwise.
double tilt_of(const Line& line) {
  const double side = line.along[1] < 0.0 ? -1.0 : 1.0;
  return std::atan2(-side * line.along[0], side * line.along[1]);
}

/// From an end of the points, given in the order in which they leave it.
std::optional<Face> face_at(std::vector<Position> points_of_end) {
  drop_close_points(points_of_end, point_spacing);
  const std::span<const Position> points(points_of_end);
  for (std::size_t first = 0; first + 2 < points.size(); ++first) {
    if (distance_between(points.front(), points[first]) > least_face) // an edge, and then no face
      return std::nullopt;
    std::size_t end = first + 2;
    while (end < points.size() && distance_between(points[first], points[end - 1]) < least_face)
      ++end;
    Line line = line_through(points.subspan(first, end - first));
    const auto fits = [&](std::size_t i) { return line.distance_from(points[i]) < straightness; };
    bool is_straight = std::abs(tilt_of(line)) < steep;
    for (std::size_t i = first; i < end; ++i)
      is_straight = is_straight && fits(i);
    if (!is_straight)
      continue;
    while (end < points.size() && fits(end)) {
      ++end;
      line = line_through(points.subspan(first, end - first));
    }
    const double length = distance_between(points[first], points[end - 1]);
    const auto sure = static_cast<std::size_t>(outer_share * static_cast<double>(end - first));
    if (length >= least_face && sure > 2)
      return Face{tilt_of(line_through(points.subspan(first, sure))), length};
  }
  return std::nullopt;
}

void warn_of_face(const std::string& name, const std::optional<Face>& face, Log& log) {
  if (face && std::abs(face->tilt) > doubtful_face)
    log.warn(
        WarningClass::profile_tilt,
        "the " + name + " is tilted by " + degrees_text(face->tilt) + " over " +
            fixed_text(face->length, 1) +
            " mm; if the wheel was measured so, state the rotation, otherwise a rotation of 0");
}

/// A nominal wheel that the points lie on once they are turned.
void warn_by_nominal(std::span<const Position> points, Log& log) {
  const Position lateral = extent_of(points, 0);
  if (lateral[1] - lateral[0] < least_width)
    return;
  std::vector<Position> some;
  const std::size_t every = 1 + points.size() / points_of_search;
  for (std::size_t i = 0; i < points.size(); i += every)
    some.push_back(points[i]);
  for (const std::string_view name : standard_profile_names(ProfileKind::wheel)) {
    const std::optional<Alignment> found = alignment_to(standard_profile(name).curve, some);
    if (!found || found->share < share_on_nominal)
      continue;
    const double turn = found->motion.rotation;
    if (std::abs(turn) > doubtful_turn &&
        std::abs(turn) * half_width > least_clearness * found->deviation) {
      log.warn(WarningClass::profile_tilt,
               "turned by " + degrees_text(turn) + ", " + fixed_text(100.0 * found->share, 0) +
                   " % of the points lie on " + std::string(name) + " to " +
                   fixed_text(found->deviation, 3) +
                   " mm (rms): measured with a tilt? State the rotation or align_to; a rotation "
                   "of 0 keeps the points as they are");
      return;
    }
  }
}

} // namespace

std::optional<Face> flange_back_of(std::span<const Position> points) {
  return face_at({points.begin(), points.end()});
}

std::optional<Face> field_face_of(std::span<const Position> points) {
  return face_at({points.rbegin(), points.rend()});
}

double untilting_rotation(std::span<const Position> points, Log& log) {
  const std::optional<Face> back = flange_back_of(points);
  const std::optional<Face> face = field_face_of(points);
  if (back && face && std::abs(back->tilt - face->tilt) < parallel) {
    const double tilt = 0.5 * (back->tilt + face->tilt);
    const std::string text = "flange back and field face are tilted by " +
                             fixed_text(back->tilt / tilt_degree) + " and " +
                             degrees_text(face->tilt);
    if (std::abs(tilt) >= doubtful_face) {
      log.guess("turned by " + degrees_text(-tilt) + ", since " + text, "state the rotation");
      return -tilt;
    }
    if (std::abs(tilt) >= notable_tilt)
      log.note("not turned: " + text +
               ", as some wheels' are; if this one was measured with a tilt, state the rotation");
    return 0.0;
  }
  const std::size_t before = log.warnings().size();
  warn_of_face("flange back", back, log);
  warn_of_face("field face", face, log);
  if (log.warnings().size() == before)
    warn_by_nominal(points, log);
  return 0.0;
}

} // namespace wrc::reading
