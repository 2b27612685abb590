#include "profile/slice_matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "profile/constants.hpp"
#include "profile/limits.hpp"

namespace wrc {
namespace {

constexpr std::size_t most_joints = 10; // joints in a message; not a tuning constant

/// Arc length of the place nearest to a point on the polygon of a curve's nodes, of those where it
/// runs the same way within 90 degrees; `otherwise` if there is none.
double nearest_to(const CurvePoint& point, const Curve& curve, double otherwise) {
  double nearest = otherwise;
  double least = std::numeric_limits<double>::infinity();
  CurvePoint begin = curve.at(0.0);
  for (std::size_t piece = 0; piece < curve.piece_count(); ++piece) {
    const double arc = curve.starts()[piece];
    const double length = curve.starts()[piece + 1] - arc;
    const CurvePoint end = curve.at(piece, length);
    const double lateral = end.lateral - begin.lateral;
    const double height = end.height - begin.height;
    const double share = std::clamp(
        ((point.lateral - begin.lateral) * lateral + (point.height - begin.height) * height) /
            (lateral * lateral + height * height),
        0.0, 1.0);
    const double distance = std::hypot(begin.lateral + share * lateral - point.lateral,
                                       begin.height + share * height - point.height);
    if (distance < least && lateral * point.tangent_lateral + height * point.tangent_height > 0.0) {
      least = distance;
      nearest = arc + share * length;
    }
    begin = end;
  }
  return nearest;
}

/// Whether one of both slices has nothing beyond the other.
bool is_within(const SliceMatch& match, double length, double next_length) {
  return (match.begin == 0.0 && match.end == length) ||
         (match.next_begin == 0.0 && match.next_end == next_length);
}

/// Two slices that follow each other without corresponding as a whole.
struct Joint {
  std::size_t before = 0; ///< index of the first of both
  double length = 0.0;
  double next_length = 0.0;
  SliceMatch match;
};

/// A line along the track, by its share of the lengths of slices between joints.
using Line = std::vector<std::optional<double>>;

std::optional<double> mapped(double arc, double begin, double end, double to_begin, double to_end) {
  if (!(arc >= begin && arc <= end && end > begin && to_end > to_begin)) {
    return std::nullopt;
  }
  return std::lerp(to_begin, to_end, (arc - begin) / (end - begin));
}

std::optional<double> share_after(const Joint& joint, double share) {
  const SliceMatch& m = joint.match;
  const std::optional<double> arc =
      mapped(share * joint.length, m.begin, m.end, m.next_begin, m.next_end);
  return arc ? std::optional(*arc / joint.next_length) : std::nullopt;
}

std::optional<double> share_before(const Joint& joint, double share) {
  const SliceMatch& m = joint.match;
  const std::optional<double> arc =
      mapped(share * joint.next_length, m.next_begin, m.next_end, m.begin, m.end);
  return arc ? std::optional(*arc / joint.length) : std::nullopt;
}

/// Continues all lines through a joint. Of the lines near to an end one becomes that of the end.
void continue_lines(std::vector<Line>& lines, std::size_t run, const Joint& joint) {
  const SliceMatch& m = joint.match;
  if (m.is_empty()) {
    return;
  }
  for (Line& line : lines) {
    if (line[run]) {
      line[run + 1] = share_after(joint, *line[run]);
    }
  }
  const auto set_nearest = [&](double arc, double next_arc) {
    double least = same_line * std::min(joint.length, joint.next_length);
    Line* nearest = nullptr;
    for (Line& line : lines) {
      if (line[run] && std::abs(*line[run] * joint.length - arc) < least) {
        least = std::abs(*line[run] * joint.length - arc);
        nearest = &line;
      }
    }
    if (nearest) {
      (*nearest)[run + 1] = next_arc / joint.next_length;
    }
  };
  set_nearest(m.begin, m.next_begin);
  set_nearest(m.end, m.next_end);
}

/// Lines that are elsewhere only, between two that are here: spread evenly between them, so that
/// the slices have no hole there. Joints keep them, since they keep shares between lines.
void fill_between(std::vector<Line>& lines, std::size_t run) {
  std::optional<std::size_t> last; // that is here
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!lines[k][run]) {
      continue;
    }
    for (std::size_t i = last ? *last + 1 : k; i < k; ++i) {
      lines[i][run] = std::lerp(*lines[*last][run], *lines[k][run],
                                static_cast<double>(i - *last) / static_cast<double>(k - *last));
    }
    last = k;
  }
}

/// All ends of slices at joints, in their order across, followed along the list. Between joints
/// lines keep their order, so a line belongs before the first that has a greater share.
std::vector<Line> lines_of(const std::vector<Joint>& joints) {
  const std::size_t runs = joints.size() + 1; // of slices that correspond as a whole
  std::vector<Line> lines(2, Line(runs));
  lines[0][0] = 0.0;
  lines[1][0] = 1.0;
  for (std::size_t run = 1; run < runs; ++run) {
    continue_lines(lines, run - 1, joints[run - 1]);
    for (const double end : {0.0, 1.0}) {
      if (std::any_of(lines.begin(), lines.end(),
                      [&](const Line& line) { return line[run] == end; })) {
        continue;
      }
      Line line(runs);
      line[run] = end;
      for (std::size_t i = run; i > 0 && line[i]; --i) {
        line[i - 1] = share_before(joints[i - 1], *line[i]);
      }
      const std::size_t ordered = line[run - 1] ? run - 1 : run;
      const auto next = std::find_if(lines.begin(), lines.end(), [&](const Line& other) {
        return other[ordered] && *other[ordered] > *line[ordered];
      });
      lines.insert(next, std::move(line));
      if (lines.size() > SliceLimits::max_features) {
        throw_invalid_argument("places where slices begin or end within their neighbours",
                               "more than " + std::to_string(SliceLimits::max_features),
                               "fewer; the list needs features");
      }
    }
  }
  for (std::size_t run = 0; run < runs; ++run) {
    fill_between(lines, run);
  }
  return lines;
}

std::string joint_text(const Joint& joint) {
  const SliceMatch& m = joint.match;
  const std::string slice = std::to_string(joint.before + 1);
  const std::string next = std::to_string(joint.before + 2);
  std::string text = "between slices " + slice + " and " + next;
  if (m.is_empty()) {
    return text + " the surface is interrupted: they have nothing in common";
  }
  const char* separator = ": ";
  const auto add = [&](const char* side, double length, const std::string& number,
                       const char* verb) {
    if (!(length > 0.0)) {
      return;
    }
    text += separator + std::string(side) + ' ' + short_text_of(length) + " mm of slice " + number +
            verb;
    separator = ", ";
  };
  add("the first", m.begin, slice, " end");
  add("the last", joint.length - m.end, slice, " end");
  add("the first", m.next_begin, next, " begin");
  add("the last", joint.next_length - m.next_end, next, " begin");
  return text;
}

} // namespace

SliceMatch match_slices(const Curve& slice, const Curve& next) {
  const double length = slice.length();
  const double next_length = next.length();
  SliceMatch match{0.0, length, 0.0, next_length, true};
  const double least = least_excess * std::min(length, next_length);
  const double first = nearest_to(next.at(0.0), slice, 0.0);
  const double next_first = nearest_to(slice.at(0.0), next, 0.0);
  if (std::max(first, next_first) > least) {
    (first > next_first ? match.begin : match.next_begin) = std::max(first, next_first);
    match.is_whole = false;
  }
  const double last = nearest_to(next.at(next_length), slice, length);
  const double next_last = nearest_to(slice.at(length), next, next_length);
  if (std::max(length - last, next_length - next_last) > least) {
    if (length - last > next_length - next_last) {
      match.end = last;
    } else {
      match.next_end = next_last;
    }
    match.is_whole = false;
  }
  if (!(match.end - match.begin > least && match.next_end - match.next_begin > least)) {
    match.end = match.begin; // touching ends are nothing common
  } else if (is_within(match, length, next_length) &&
             std::abs(match.end - match.begin - (match.next_end - match.next_begin)) >
                 std::abs(length - next_length) + same_line * std::min(length, next_length)) {
    return {0.0, length, 0.0, next_length, true};
  }
  return match;
}

FoundFeatures find_features(std::span<const Curve* const> slices) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i + 1 < slices.size(); ++i) {
    if (const SliceMatch match = match_slices(*slices[i], *slices[i + 1]); !match.is_whole) {
      joints.push_back({i, slices[i]->length(), slices[i + 1]->length(), match});
    }
  }
  FoundFeatures found;
  if (joints.empty()) {
    return found;
  }
  const std::vector<Line> lines = lines_of(joints);
  std::size_t run = 0;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    found.of_slices.emplace_back();
    for (const Line& line : lines) {
      found.of_slices.back().push_back(line[run] ? std::optional(*line[run] * slices[i]->length())
                                                 : std::nullopt);
    }
    if (run < joints.size() && joints[run].before == i) {
      ++run;
    }
  }
  found.notes.emplace_back(
      "no features in the list: found from ends of slices that lie within their neighbours");
  for (std::size_t i = 0; i < std::min(joints.size(), most_joints); ++i) {
    found.notes.push_back(joint_text(joints[i]));
  }
  if (joints.size() > most_joints) {
    found.notes.push_back("and so between " + std::to_string(joints.size() - most_joints) +
                          " other pairs of slices");
  }
  return found;
}

} // namespace wrc
