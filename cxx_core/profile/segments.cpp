#include "profile/segments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace wrc {
namespace {

using Pieces = std::vector<Curve::Piece>;

[[noreturn]] void refuse(const Segment& segment, const std::string& argument,
                         const std::string& value, const std::string& allowed) {
  throw_invalid_argument(argument + " of segment '" + segment.label + "'", value, allowed);
}

double distance(const Position& a, const Position& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

std::size_t count_for(double length, double step) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / step)));
}

Pieces pieces_of(const LineSegment& line, const Segment& segment) {
  const double length = distance(line.start, line.end);
  if (!(length > 0.0) || !std::isfinite(length)) {
    refuse(segment, "length", text_of(length), "a positive finite number, mm");
  }
  const double tangent_lateral = (line.end[0] - line.start[0]) / length;
  const double tangent_height = (line.end[1] - line.start[1]) / length;
  const std::size_t count = count_for(length, max_node_distance);
  const auto node = [&](std::size_t i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    return Curve::End{std::lerp(line.start[0], line.end[0], t),
                      std::lerp(line.start[1], line.end[1], t),
                      tangent_lateral,
                      tangent_height,
                      0.0,
                      0.0};
  };
  Pieces pieces;
  for (std::size_t i = 0; i < count; ++i) {
    pieces.push_back({node(i), node(i + 1), length / static_cast<double>(count)});
  }
  return pieces;
}

Pieces pieces_of(const ArcSegment& arc, const Segment& segment) {
  if (!(arc.radius > 0.0) || !std::isfinite(arc.radius)) {
    refuse(segment, "radius", text_of(arc.radius), "a positive finite number, mm");
  }
  for (const auto& [name, end] : {std::pair{"start", arc.start}, std::pair{"end", arc.end}}) {
    const double off = distance(arc.centre, end) - arc.radius;
    if (!(std::abs(off) <= max_junction_gap)) {
      refuse(segment, std::string("distance of ") + name + " from the circle", text_of(off),
             "at most " + text_of(max_junction_gap) + " mm");
    }
  }
  const double first = std::atan2(arc.start[1] - arc.centre[1], arc.start[0] - arc.centre[0]);
  const double last = std::atan2(arc.end[1] - arc.centre[1], arc.end[0] - arc.centre[0]);
  const double sweep = std::remainder(last - first, 2.0 * std::numbers::pi);
  if (sweep == 0.0) {
    refuse(segment, "angle", "0", "a start and an end that differ");
  }
  const double turn = sweep > 0.0 ? 1.0 : -1.0;
  const double length = arc.radius * std::abs(sweep);
  const std::size_t count =
      std::max(count_for(length, max_node_distance), count_for(std::abs(sweep), max_piece_angle));
  const auto node = [&](std::size_t i) {
    const double angle = first + sweep * (static_cast<double>(i) / static_cast<double>(count));
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    return Curve::End{arc.centre[0] + arc.radius * cosine,
                      arc.centre[1] + arc.radius * sine,
                      -turn * sine,
                      turn * cosine,
                      -cosine / arc.radius,
                      -sine / arc.radius};
  };
  Pieces pieces;
  for (std::size_t i = 0; i < count; ++i) {
    pieces.push_back({node(i), node(i + 1), length / static_cast<double>(count)});
  }
  return pieces;
}

/// A polynomial height(lateral) with the data of its curve.
class Graph {
public:
  explicit Graph(const PolynomialSegment& polynomial) : polynomial_(polynomial) {}

  [[nodiscard]] Curve::End at(double lateral) const {
    const double u = lateral - polynomial_.expansion_point;
    double height = 0.0;
    double slope = 0.0;
    double half_second = 0.0;
    const auto& c = polynomial_.coefficients;
    for (auto coefficient = c.rbegin(); coefficient != c.rend(); ++coefficient) {
      half_second = half_second * u + slope;
      slope = slope * u + height;
      height = height * u + *coefficient;
    }
    const double stretch = std::sqrt(1.0 + slope * slope);
    const double fourth = stretch * stretch * stretch * stretch;
    const double second = 2.0 * half_second;
    return {lateral,        height, 1.0 / stretch, slope / stretch, -slope * second / fourth,
            second / fourth};
  }

  /// Arc length between two laterals, at most about one node distance apart: the 8-point rule of
  /// Gauss and Legendre (Abramowitz and Stegun, 1964, table 25.4).
  [[nodiscard]] double length(double from, double to) const {
    constexpr std::array<double, 4> node = {0.1834346424956498, 0.5255324099163290,
                                            0.7966664774136267, 0.9602898564975363};
    constexpr std::array<double, 4> weight = {0.3626837833783620, 0.3137066458778873,
                                              0.2223810344533745, 0.1012285362903763};
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double sum = 0.0;
    for (std::size_t i = 0; i < node.size(); ++i) {
      sum += weight[i] * (1.0 / at(middle - half * node[i]).tangent_lateral +
                          1.0 / at(middle + half * node[i]).tangent_lateral);
    }
    return half * sum;
  }

  /// The point at an arc distance of less than a node distance from `from`: Newton's method, which
  /// starts within about 1e-2 mm and squares that in each step.
  [[nodiscard]] Curve::End at_distance(double from, double distance_along) const {
    double lateral = from + distance_along * at(from).tangent_lateral;
    for (int step = 0; step < 4; ++step) {
      lateral -= (length(from, lateral) - distance_along) * at(lateral).tangent_lateral;
    }
    return at(lateral);
  }

private:
  const PolynomialSegment& polynomial_;
};

/// True if the pieces reproduce the graph inside, at the quarter points.
bool reproduces(const Pieces& pieces, const Graph& graph) {
  double largest_curvature = 0.0;
  for (const Curve::Piece& piece : pieces) {
    if (piece.length > max_node_distance) {
      return false;
    }
    largest_curvature = std::max(largest_curvature, std::abs(piece.begin.curvature()));
  }
  const Curve curve{pieces};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const double part : {0.25, 0.5, 0.75}) {
      const double s = part * pieces[i].length;
      const Curve::End expected = graph.at_distance(pieces[i].begin.lateral, s);
      const CurvePoint found = curve.at(i, s);
      if (std::hypot(found.lateral - expected.lateral, found.height - expected.height) >
              piece_tolerance ||
          std::abs(found.curvature() - expected.curvature()) >
              piece_curvature_tolerance * largest_curvature + curvature_rounding) {
        return false;
      }
    }
  }
  return true;
}

Pieces pieces_of(const PolynomialSegment& polynomial, const Segment& segment) {
  if (polynomial.coefficients.empty()) {
    refuse(segment, "number of coefficients", "0", "at least 1");
  }
  const double width = polynomial.lateral_end - polynomial.lateral_start;
  if (!(width > 0.0) || !std::isfinite(width)) {
    refuse(segment, "width", text_of(width), "a positive finite number, mm");
  }
  const Graph graph(polynomial);
  for (std::size_t count = count_for(width, max_node_distance); count <= max_pieces;
       count += count / 4 + 1) {
    const auto lateral = [&](std::size_t i) {
      return std::lerp(polynomial.lateral_start, polynomial.lateral_end,
                       static_cast<double>(i) / static_cast<double>(count));
    };
    Pieces pieces;
    for (std::size_t i = 0; i < count; ++i) {
      pieces.push_back({graph.at(lateral(i)), graph.at(lateral(i + 1)),
                        graph.length(lateral(i), lateral(i + 1))});
    }
    if (reproduces(pieces, graph)) {
      return pieces;
    }
  }
  refuse(segment, "polynomial", "too wild for " + std::to_string(max_pieces) + " pieces",
         "one that pieces of quintics reproduce to 1e-11 mm");
}

Pieces pieces_of(const Segment& segment) {
  return std::visit([&](const auto& shape) { return pieces_of(shape, segment); }, segment.shape);
}

Junction junction_between(const Segment& before, const Curve::End& end, const Segment& after,
                          const Curve::End& begin) {
  const double sine =
      end.tangent_lateral * begin.tangent_height - end.tangent_height * begin.tangent_lateral;
  const double cosine =
      end.tangent_lateral * begin.tangent_lateral + end.tangent_height * begin.tangent_height;
  return {before.label,
          after.label,
          end.lateral,
          end.height,
          std::hypot(begin.lateral - end.lateral, begin.height - end.height),
          std::atan2(sine, cosine)};
}

Position mirrored(const Position& position) {
  return {-position[0], position[1]};
}

Segment mirrored(const Segment& segment) {
  Segment result{segment.label + " (gauge side)", segment.shape};
  if (const auto* line = std::get_if<LineSegment>(&segment.shape)) {
    result.shape = LineSegment{mirrored(line->end), mirrored(line->start)};
  } else if (const auto* arc = std::get_if<ArcSegment>(&segment.shape)) {
    result.shape =
        ArcSegment{mirrored(arc->centre), arc->radius, mirrored(arc->end), mirrored(arc->start)};
  } else {
    PolynomialSegment polynomial = std::get<PolynomialSegment>(segment.shape);
    for (std::size_t power = 1; power < polynomial.coefficients.size(); power += 2) {
      polynomial.coefficients[power] = -polynomial.coefficients[power];
    }
    polynomial.expansion_point = -polynomial.expansion_point;
    const double start = polynomial.lateral_start;
    polynomial.lateral_start = -polynomial.lateral_end;
    polynomial.lateral_end = -start;
    result.shape = polynomial;
  }
  return result;
}

} // namespace

std::vector<Junction> junctions_of(std::span<const Segment> segments) {
  std::vector<Junction> junctions;
  Pieces before;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Pieces pieces = pieces_of(segments[i]);
    if (i > 0) {
      junctions.push_back(
          junction_between(segments[i - 1], before.back().end, segments[i], pieces.front().begin));
    }
    before = std::move(pieces);
  }
  return junctions;
}

Curve curve_of(std::span<const Segment> segments) {
  if (segments.empty()) {
    throw_invalid_argument("number of segments", "0", "at least 1");
  }
  Pieces all;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Pieces pieces = pieces_of(segments[i]);
    if (i > 0) {
      const Junction junction =
          junction_between(segments[i - 1], all.back().end, segments[i], pieces.front().begin);
      if (!(junction.gap <= max_junction_gap)) {
        throw_invalid_argument("gap between segments '" + junction.before + "' and '" +
                                   junction.after + "'",
                               junction.gap, "at most " + text_of(max_junction_gap) + " mm");
      }
    }
    all.insert(all.end(), pieces.begin(), pieces.end());
  }
  return Curve{all};
}

std::vector<Segment> with_mirrored_half(std::span<const Segment> right_half) {
  std::vector<Segment> all;
  for (auto segment = right_half.rbegin(); segment != right_half.rend(); ++segment) {
    all.push_back(mirrored(*segment));
  }
  all.insert(all.end(), right_half.begin(), right_half.end());
  return all;
}

} // namespace wrc
