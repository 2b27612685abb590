#include "measured/tilt.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "measured/alignment.hpp"
#include "measured/constants.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/profile_shape.hpp"
#include "profile/profile.hpp"

namespace wrc::reading {
namespace {

std::string degrees_text(double angle) {
  return fixed_text(angle / degree) + " degrees";
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
  for (const Position& point : points) {
    for (std::size_t i = 0; i < 2; ++i) {
      line.middle[i] += point[i] / static_cast<double>(points.size());
    }
  }
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
  drop_close_points(points_of_end, face_spacing);
  const std::span<const Position> points(points_of_end);
  for (std::size_t first = 0; first + 2 < points.size(); ++first) {
    if (distance_between(points.front(), points[first]) > least_face) { // an edge, and then no face
      return std::nullopt;
    }
    std::size_t end = first + 2;
    while (end < points.size() && distance_between(points[first], points[end - 1]) < least_face) {
      ++end;
    }
    Line line = line_through(points.subspan(first, end - first));
    const auto fits = [&](std::size_t i) { return line.distance_from(points[i]) < straightness; };
    bool is_straight = std::abs(tilt_of(line)) < steepest_face;
    for (std::size_t i = first; i < end; ++i) {
      is_straight = is_straight && fits(i);
    }
    if (!is_straight) {
      continue;
    }
    while (end < points.size() && fits(end)) {
      ++end;
      line = line_through(points.subspan(first, end - first));
    }
    const double length = distance_between(points[first], points[end - 1]);
    const auto sure = static_cast<std::size_t>(outer_share * static_cast<double>(end - first));
    if (length >= least_face && sure > 2) {
      return Face{tilt_of(line_through(points.subspan(first, sure))), length};
    }
  }
  return std::nullopt;
}

void warn_of_face(const std::string& name, const std::optional<Face>& face, Log& log) {
  if (face && std::abs(face->tilt) > doubtful_face) {
    log.warn(
        WarningClass::profile_tilt,
        "the " + name + " is tilted by " + degrees_text(face->tilt) + " over " +
            fixed_text(face->length, 1) +
            " mm; if the wheel was measured so, state the rotation, otherwise a rotation of 0");
  }
}

/// A nominal wheel that the points lie on once they are turned.
void warn_by_nominal(std::span<const Position> points, Log& log) {
  const Position lateral = extent_of(points, 0);
  if (lateral[1] - lateral[0] < plausible::least_wheel_width) {
    return;
  }
  std::vector<Position> some;
  const std::size_t every = 1 + points.size() / points_of_search;
  for (std::size_t i = 0; i < points.size(); i += every) {
    some.push_back(points[i]);
  }
  for (const std::string_view name : standard_profile_names(ProfileKind::wheel)) {
    const std::optional<Alignment> found = alignment_to(standard_profile(name).curve, some);
    if (!found || found->share < share_on_nominal) {
      continue;
    }
    const double turn = found->motion.rotation;
    if (std::abs(turn) > notable_tilt &&
        std::abs(turn) * plausible::half_width > least_clearness * found->deviation) {
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
  if (back && face && std::abs(back->tilt - face->tilt) < parallel_faces) {
    const double tilt = 0.5 * (back->tilt + face->tilt);
    const std::string text = "flange back and field face are tilted by " +
                             fixed_text(back->tilt / degree) + " and " + degrees_text(face->tilt);
    if (std::abs(tilt) >= doubtful_face) {
      log.guess("turned by " + degrees_text(-tilt) + ", since " + text, "state the rotation");
      return -tilt;
    }
    if (std::abs(tilt) >= notable_tilt) {
      log.note("not turned: " + text +
               ", as some wheels' are; if this one was measured with a tilt, state the rotation");
    }
    return 0.0;
  }
  const std::size_t before = log.warnings().size();
  warn_of_face("flange back", back, log);
  warn_of_face("field face", face, log);
  if (log.warnings().size() == before) {
    warn_by_nominal(points, log);
  }
  return 0.0;
}

} // namespace wrc::reading
