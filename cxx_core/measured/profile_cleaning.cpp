#include "measured/profile_cleaning.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "measured/constants.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/profile_shape.hpp"
#include "measured/read_options.hpp"
#include "profile/constants.hpp"

namespace wrc::reading {
namespace {

/// Distance of a point from the line between two others, which may coincide.
double distance_from_chord(const Position& point, const Position& a, const Position& b) {
  const Position along{b[0] - a[0], b[1] - a[1]};
  const double square = along[0] * along[0] + along[1] * along[1];
  const double share =
      square > 0.0
          ? std::clamp(((point[0] - a[0]) * along[0] + (point[1] - a[1]) * along[1]) / square, 0.0,
                       1.0)
          : 0.0;
  return distance_between(point, {a[0] + share * along[0], a[1] + share * along[1]});
}

struct Outlier {
  std::size_t first = 0;
  std::size_t count = 0;
  double distance = 0.0;
};

/// How much the line turns back and forth at the points from one before a run to one behind it.
double wiggle(const std::vector<Position>& points, std::size_t first, std::size_t count) {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t i = first - 1; i <= first + count; ++i) {
    if (i == 0 || i + 1 >= points.size()) {
      continue;
    }
    const double angle = angle_between(points[i - 1], points[i], points[i], points[i + 1]);
    sum += angle;
    total += std::abs(angle);
  }
  return total - std::abs(sum);
}

/// The run of few points farthest off the line of its neighbours.
Outlier worst_outlier(const std::vector<Position>& points) {
  Outlier worst;
  for (std::size_t count = 1; count <= steps_of_line; ++count) {
    for (std::size_t first = 1; first + count < points.size(); ++first) {
      double distance = 0.0; // of the nearest: all of a run are off
      for (std::size_t i = first; i < first + count; ++i) {
        const double each =
            distance_from_chord(points[i], points[first - 1], points[first + count]);
        distance = i == first ? each : std::min(distance, each);
      }
      if (distance > least_outlier && distance > worst.distance &&
          wiggle(points, first, count) > least_wiggle) {
        worst = {first, count, distance};
      }
    }
  }
  return worst;
}

void remove(RawProfile& raw, std::size_t first, std::size_t count) {
  const auto begin = raw.points.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  raw.dropped.insert(raw.dropped.end(), begin, end);
  raw.points.erase(begin, end);
}

bool end_is_off(const Position& end, const Position& next, const Position& third, double spacing) {
  const double distance = distance_between(end, next);
  return distance > farthest_neighbour && distance > end_ratio * spacing &&
         std::abs(angle_between(end, next, next, third)) > end_corner;
}

void remove_end(RawProfile& raw, bool last, double spacing, Log& log) {
  const std::size_t n = raw.points.size();
  const auto at = [&](std::size_t i) -> const Position& {
    return raw.points[last ? n - 1 - i : i];
  };
  if (n < 4 || !end_is_off(at(0), at(1), at(2), spacing)) {
    return;
  }
  log.guess("outlier removed: the " + std::string(last ? "last" : "first") + " point " +
                place_text(at(0)) + ", " + fixed_text(distance_between(at(0), at(1))) +
                " mm from the next one",
            "remove it");
  remove(raw, last ? n - 1 : 0, 1);
}

/// The chords that are longer than those of a line of points.
struct LongChords {
  std::vector<std::size_t> ends; ///< of each the point where it begins
  double length = 0.0;           ///< of all
};

LongChords long_chords_of(std::span<const Position> points, double limit) {
  LongChords found;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (const double chord = distance_between(points[i], points[i + 1]); chord > limit) {
      found.ends.push_back(i);
      found.length += chord;
    }
  }
  return found;
}

/// From one point to the nearest that is left, and so on.
std::vector<Position> nearest_from(std::size_t first, std::vector<Position> left) {
  std::vector<Position> ordered;
  ordered.reserve(left.size());
  for (std::size_t next = first; !left.empty();) {
    ordered.push_back(left[next]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(next)); // equal distances: the first
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Position off{left[i][0] - ordered.back()[0], left[i][1] - ordered.back()[1]};
      if (const double square = off[0] * off[0] + off[1] * off[1]; square < least) {
        least = square;
        next = i;
      }
    }
  }
  return ordered;
}

/// Length over which a line lies beside itself: two scans of one profile that do not fit, and not
/// the two sides of a lip.
double length_beside_itself(std::span<const Position> line) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    along.push_back(along.back() + distance_between(line[i - 1], line[i]));
  }
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    for (std::size_t j = 0; j < line.size(); ++j) {
      if (std::abs(along[i] - along[j]) > longest_lip &&
          distance_between(line[i], line[j]) < farthest_beside) {
        length += along[i] - along[i - 1];
        break;
      }
    }
  }
  return length;
}

/// How often a line turns sharply: between two scans beside each other at every point.
std::size_t sharp_turns(std::span<const Position> line) {
  std::size_t count = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const bool apart = distance_between(line[i - 2], line[i - 1]) > negligible_length &&
                       distance_between(line[i - 1], line[i]) > negligible_length;
    count += apart &&
             std::abs(angle_between(line[i - 2], line[i - 1], line[i - 1], line[i])) > end_corner;
  }
  return count;
}

} // namespace

void order_points(RawProfile& raw, Log& log) {
  const double limit =
      std::max(least_long_chord, farthest_in_spacings * median_spacing(raw.points));
  if (raw.points.size() < 4) {
    return;
  }
  // Without single points off the ends.
  const LongChords given =
      long_chords_of(std::span(raw.points).subspan(1, raw.points.size() - 2), limit);
  if (given.ends.empty() || raw.points.size() > most_ordered) {
    return;
  }
  std::vector<std::size_t> begins{0};
  for (std::size_t i = 0; i < std::min(given.ends.size(), most_begins); ++i) {
    begins.push_back(given.ends[i] + 1); // of all points
    begins.push_back(given.ends[i] + 2);
  }
  std::vector<Position> best;
  double least = ordered_share * given.length;
  for (const std::size_t begin : begins) {
    std::vector<Position> ordered = nearest_from(begin, raw.points);
    if (const double length = long_chords_of(ordered, limit).length; length < least) {
      least = length;
      best = std::move(ordered);
    }
  }
  if (!best.empty() && sharp_turns(best) <= sharp_turns(raw.points) &&
      length_beside_itself(best) < longest_lip) {
    raw.points = std::move(best);
    log.guess("points put in order, each the nearest one to that before: " +
                  fixed_text(given.length, 0) + " mm of jumps became " + fixed_text(least, 0),
              "order the points along the profile");
  }
}

void open_outline(RawProfile& raw, std::optional<ProfileKind> kind, Log& log) {
  std::vector<Position>& points = raw.points;
  const double spacing = median_spacing(points);
  const double opening = distance_between(points.front(), points.back());
  if (opening > negligible_length &&
      (opening > opening_ratio * spacing || opening > opening_share * chord_length(points))) {
    return;
  }
  std::size_t after = 0; // the longest side ends here
  double longest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double side = distance_between(points[i], i == 0 ? points.back() : points[i - 1]);
    if (side > longest) {
      longest = side;
      after = i;
    }
  }
  const std::string from = "closed outline opened ";
  std::string where;
  if (longest > std::max(farthest_neighbour, farthest_in_spacings * spacing)) {
    where = "at its longest side, " + fixed_text(longest) + " mm, at " + place_text(points[after]);
  } else {
    const std::optional<Head> head = head_of(points);
    const Position height = extent_of(points, 1);
    if (kind == ProfileKind::wheel || !head ||
        height[1] - height[0] <= 2.0 * plausible::depth_of_rail) {
      log.refuse("a closed outline, whose running surface cannot be determined; leave only "
                 "the running surface");
    }
    const auto lowest =
        std::min_element(points.begin(), points.end(), [&](const Position& a, const Position& b) {
          return head->is_down ? a[1] > b[1] : a[1] < b[1];
        });
    after = static_cast<std::size_t>(lowest - points.begin());
    where = "at the foot, " + place_text(*lowest);
  }
  log.guess(from + where, "leave only the running surface");
  if (opening <= negligible_length) { // one point, twice
    raw.dropped.push_back(points.back());
    points.pop_back();
  }
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(after % points.size()),
              points.end());
}

void remove_doubles(RawProfile& raw, double least, Log& log) {
  if (const std::size_t dropped = drop_close_points(raw.points, least)) {
    log.note(std::to_string(dropped) + " points closer than " + text_of(least) +
             " mm to the previous one dropped");
  }
}

void remove_outliers(RawProfile& raw, Log& log) {
  const double spacing = median_spacing(raw.points);
  remove_end(raw, false, spacing, log);
  remove_end(raw, true, spacing, log);
  const std::size_t most = std::min(most_outliers, 1 + raw.points.size() / points_per_outlier);
  std::size_t removed = 0;
  for (Outlier worst = worst_outlier(raw.points); worst.count > 0;
       worst = worst_outlier(raw.points)) {
    const Position place = raw.points[worst.first];
    if (removed + worst.count > most) {
      log.warn(WarningClass::profile_outliers,
               "more than " + std::to_string(most) +
                   " points are off the line of their neighbours, the next at " +
                   place_text(place) + " by " + fixed_text(worst.distance) + " mm");
      return;
    }
    const std::string text =
        "outlier removed: " +
        (worst.count == 1 ? "point " : std::to_string(worst.count) + " points from ") +
        place_text(place) + ", " + fixed_text(worst.distance) +
        " mm off the line of the neighbours";
    if (worst.distance < least_spike) {
      log.note(text);
    } else {
      log.guess(text, "remove it");
    }
    remove(raw, worst.first, worst.count);
    removed += worst.count;
  }
}

void cut_ends(RawProfile& raw, ProfileKind kind, Log& log) {
  std::vector<Position>& points = raw.points;
  const double depth =
      kind == ProfileKind::rail ? plausible::depth_of_rail : plausible::depth_of_wheel;
  const double least =
      (kind == ProfileKind::rail ? crown_height_of(points) : extent_of(points, 1)[1]) - depth;
  const auto is_deep = [least](const Position& point) { return point[1] < least; };
  const auto first = std::find_if_not(points.begin(), points.end(), is_deep);
  const auto last = std::find_if_not(points.rbegin(), points.rend(), is_deep).base();
  // The groove of a rail with a guard rail is deep, nothing within a wheel.
  if (const auto deep = std::find_if(first, last, is_deep);
      kind == ProfileKind::wheel && deep != last) {
    log.warn(WarningClass::profile_overlap, "point " + place_text(*deep) + ", more than " +
                                                fixed_text(depth, 0) +
                                                " mm below the highest one, is between others");
  }
  const std::size_t cut = points.size() - static_cast<std::size_t>(last - first);
  if (cut == 0) {
    return;
  }
  log.note("ends cut: " + std::to_string(cut) + " points more than " + fixed_text(depth, 0) +
           " mm below the highest one");
  raw.dropped.insert(raw.dropped.end(), points.begin(), first);
  raw.dropped.insert(raw.dropped.end(), last, points.end());
  points.erase(last, points.end());
  points.erase(points.begin(), first);
}

} // namespace wrc::reading
