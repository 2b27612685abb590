#include "geometry/surface_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "geometry/constants.hpp"
#include "geometry/feature_map.hpp"
#include "profile/segments.hpp"

namespace wrc {
namespace {

/// Bound of memory, 400 MB (not a tuning constant).
constexpr std::size_t max_nodes = std::size_t{1} << 21;

constexpr std::size_t most_listed = 10; // folds in a message; not a tuning constant

/// Whether all sections can keep their own polynomials: equal nodes, features at the same places,
/// whole curves.
bool have_equal_nodes(std::span<const SheetSection> sections) {
  const SheetSection& first = sections.front();
  if (first.features.front() != 0.0 || first.features.back() != first.curve->length()) {
    return false;
  }
  return std::all_of(sections.begin(), sections.end(), [&](const SheetSection& section) {
    return section.features == first.features &&
           std::equal(section.curve->starts().begin(), section.curve->starts().end(),
                      first.curve->starts().begin(), first.curve->starts().end());
  });
}

/// Parameters of the features: those of the sections if they are equal, else such that each part is
/// as long as in the section where it is longest.
std::vector<double> parameters_of(std::span<const SheetSection> sections) {
  std::vector<double> parameters = sections.front().features;
  if (std::all_of(sections.begin(), sections.end(),
                  [&](const SheetSection& section) { return section.features == parameters; })) {
    return parameters;
  }
  parameters.front() = 0.0;
  for (std::size_t k = 1; k < parameters.size(); ++k) {
    double longest = 0.0;
    for (const SheetSection& section : sections) {
      longest = std::max(longest, section.features[k] - section.features[k - 1]);
    }
    parameters[k] = parameters[k - 1] + longest;
  }
  return parameters;
}

struct AcrossNodes {
  std::vector<double> parameters;
  std::vector<std::size_t> intervals; ///< of features, of the piece that begins there
};

AcrossNodes nodes_between(const std::vector<double>& features) {
  AcrossNodes nodes{{features.front()}, {}};
  for (std::size_t k = 0; k + 1 < features.size(); ++k) {
    const double length = features[k + 1] - features[k];
    const auto parts = static_cast<std::size_t>(std::ceil(length / max_node_distance));
    for (std::size_t part = 1; part <= parts; ++part) {
      nodes.parameters.push_back(part == parts ? features[k + 1]
                                               : features[k] + length * static_cast<double>(part) /
                                                                   static_cast<double>(parts));
      nodes.intervals.push_back(k);
    }
  }
  return nodes;
}

/// Values of a coordinate by the parameter, of its derivatives by arc length.
QuinticValues by_parameter(double value, double first, double second, const QuinticValues& arc) {
  return {value, first * arc.first, second * arc.first * arc.first + first * arc.second};
}

/// The polynomials of a section on all pieces.
std::vector<Curve::Polynomials> sampled(const SheetSection& section,
                                        const std::vector<double>& features,
                                        const AcrossNodes& nodes) {
  const FeatureMap map(features, section.features);
  struct End {
    QuinticValues lateral;
    QuinticValues height;
  };
  const auto end_at = [&](std::size_t interval, double parameter) {
    const QuinticValues arc = map.at(interval, parameter);
    const CurvePoint p = section.curve->at(arc.value);
    return End{by_parameter(p.lateral, p.tangent_lateral, p.second_lateral, arc),
               by_parameter(p.height, p.tangent_height, p.second_height, arc)};
  };
  std::vector<Curve::Polynomials> pieces;
  pieces.reserve(nodes.intervals.size());
  End begin = end_at(0, nodes.parameters.front());
  for (std::size_t i = 0; i < nodes.intervals.size(); ++i) {
    const End end = end_at(nodes.intervals[i], nodes.parameters[i + 1]);
    const double length = nodes.parameters[i + 1] - nodes.parameters[i];
    pieces.push_back(
        {quintic(begin.lateral, end.lateral, length), quintic(begin.height, end.height, length)});
    begin = end;
  }
  return pieces;
}

/// Factors of the second derivatives at both knots, for a value and its two derivatives along.
struct Weights {
  Weights(const AlongPlace& along, int order) {
    const double h = along.step;
    const double a = 1.0 - along.fraction;
    const double b = along.fraction;
    if (order == 0) {
      before = h * h / 6.0 * (a * a * a - a);
      after = h * h / 6.0 * (b * b * b - b);
    } else if (order == 1) {
      before = -h / 6.0 * (3.0 * a * a - 1.0);
      after = h / 6.0 * (3.0 * b * b - 1.0);
    } else {
      before = a;
      after = b;
    }
    of_change = order == 0 ? b : order == 1 ? 1.0 / h : 0.0;
  }
  double before;
  double after;
  double of_change; ///< of the values
};

/// The polynomial of a section between knots, or its derivative along.
Quintic blended(const Quintic& value, const Quintic& next, const Quintic& second,
                const Quintic& next_second, const Weights& w, bool is_value) {
  Quintic result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = (is_value ? value[i] : 0.0) + (w.of_change * (next[i] - value[i]) +
                                               (w.before * second[i] + w.after * next_second[i]));
  }
  return result;
}

Quintic second_along(const Quintic& second, const Quintic& next_second, const AlongPlace& along) {
  Quintic result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = (1.0 - along.fraction) * second[i] + along.fraction * next_second[i];
  }
  return result;
}

} // namespace

SurfaceSheet::SurfaceSheet(std::span<const SheetSection> sections, double smoothing_length,
                           double period) {
  std::vector<double> places;
  for (const SheetSection& section : sections) {
    places.push_back(section.place);
    const std::vector<double>& features = section.features;
    const std::string name = "features of slice " + std::to_string(section.number);
    if (features.size() < 2 || features.size() != sections.front().features.size()) {
      throw_invalid_argument(name, std::to_string(features.size()),
                             "at least 2, the number of the other slices");
    }
    for (std::size_t k = 0; k + 1 < features.size(); ++k) {
      if (!(features[k + 1] > features[k])) {
        throw_invalid_argument(name, text_of(features[k + 1]) + " after " + text_of(features[k]),
                               "arc lengths in ascending order, none beyond the end of the slice");
      }
    }
  }
  spline_ = AlongSpline(places, smoothing_length, period);
  is_whole_ = std::ranges::all_of(sections, [](const SheetSection& section) {
    return section.features.front() == 0.0 && section.features.back() == section.curve->length();
  });
  fill(sections);
  refuse_folds(sections);
}

void SurfaceSheet::fill(std::span<const SheetSection> sections) {
  const std::size_t knots = spline_.knots().size();
  const bool keeps = have_equal_nodes(sections);
  const std::vector<double> features = parameters_of(sections);
  AcrossNodes nodes;
  if (keeps) {
    const std::span<const double> starts = sections.front().curve->starts();
    nodes.parameters.assign(starts.begin(), starts.end());
    nodes.intervals.resize(starts.size() - 1);
  } else {
    nodes = nodes_between(features);
  }
  const std::size_t pieces = nodes.intervals.size();
  if (pieces > max_nodes / knots) {
    throw_invalid_argument("nodes of the surface, of " + std::to_string(pieces) +
                               " pieces across and " + std::to_string(knots) + " knots along",
                           std::to_string(pieces * knots),
                           "at most " + std::to_string(max_nodes) + "; use fewer slices");
  }
  nodes_.resize(pieces * knots);
  std::vector<std::vector<Curve::Polynomials>> of_sections;
  if (!keeps) {
    for (const SheetSection& section : sections) {
      of_sections.push_back(sampled(section, features, nodes));
    }
  }
  starts_ = std::move(nodes.parameters);
  std::vector<double> lateral(sections.size());
  std::vector<double> height(sections.size());
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    Node* const row = &nodes_[piece * knots];
    for (std::size_t power = 0; power < Quintic{}.size(); ++power) {
      for (std::size_t i = 0; i < sections.size(); ++i) {
        const Curve::Polynomials& p =
            keeps ? sections[i].curve->polynomials(piece) : of_sections[i][piece];
        lateral[i] = p.lateral[power];
        height[i] = p.height[power];
      }
      const AlongSpline::Fit of_lateral = spline_.fit(lateral);
      const AlongSpline::Fit of_height = spline_.fit(height);
      for (std::size_t knot = 0; knot < knots; ++knot) {
        row[knot].lateral[power] = of_lateral.value[knot];
        row[knot].lateral_second[power] = of_lateral.second[knot];
        row[knot].height[power] = of_height.value[knot];
        row[knot].height_second[power] = of_height.second[knot];
      }
    }
  }
  begin_lateral_.resize((pieces + 1) * knots);
  begin_second_.resize(begin_lateral_.size());
  for (std::size_t knot = 0; knot < knots; ++knot) {
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      begin_lateral_[knot * (pieces + 1) + piece] = node(piece, knot).lateral[0];
      begin_second_[knot * (pieces + 1) + piece] = node(piece, knot).lateral_second[0];
    }
    const double length = starts_[pieces] - starts_[pieces - 1];
    const Node& last = node(pieces - 1, knot);
    begin_lateral_[(knot + 1) * (pieces + 1) - 1] = evaluate(last.lateral, length).value;
    begin_second_[(knot + 1) * (pieces + 1) - 1] = evaluate(last.lateral_second, length).value;
  }
  for (std::size_t interval = 0; interval + 1 < knots; ++interval) {
    ascending_.push_back(ascending_run(interval));
  }
}

bool SurfaceSheet::is_folded(std::size_t piece, std::size_t interval) const {
  const double distance = 0.5 * (starts_[piece + 1] - starts_[piece]);
  const double step = spline_.knots()[interval + 1] - spline_.knots()[interval];
  const Position begin = at(piece, distance, {interval, step, 0.0}).across;
  const Position end = at(piece, distance, {interval, step, 1.0}).across;
  for (int part = 0; part <= interval_parts; ++part) {
    const double fraction = static_cast<double>(part) / interval_parts;
    const Position across = at(piece, distance, {interval, step, fraction}).across;
    const auto follows = [&across](const Position& other) {
      return across[0] * other[0] + across[1] * other[1] > 0.0;
    };
    if (!follows(begin) || !follows(end)) {
      return true;
    }
  }
  return false;
}

void SurfaceSheet::refuse_folds(std::span<const SheetSection> sections) const {
  std::string first; // between which slices and where
  std::string others;
  std::size_t count = 0;
  std::size_t last = sections.size();
  for (std::size_t interval = 0; interval + 1 < spline_.knots().size(); ++interval) {
    const std::size_t before = spline_.place_before(interval);
    for (std::size_t piece = 0; piece + 1 < starts_.size() && last != before; ++piece) {
      if (!is_folded(piece, interval)) {
        continue;
      }
      last = before;
      const std::string pair = std::to_string(sections[before].number) + " and " +
                               std::to_string(sections[(before + 1) % sections.size()].number);
      if (++count == 1) {
        first = pair + ", at lateral " + short_text_of(node(piece, interval).lateral[0]) + " mm";
      } else if (count <= most_listed) {
        others.append(", ").append(pair);
      }
    }
  }
  if (count > most_listed) {
    others += " and more";
  }
  if (count > 0) {
    throw Error(ErrorCode::invalid_argument,
                "the surface folds between slices " + first + others +
                    ": features must join corresponding places of the slices");
  }
}

SheetPoint SurfaceSheet::at(double across, double along) const {
  const double inside = std::clamp(across, starts_.front(), starts_.back());
  const std::size_t piece = piece_at(inside);
  return at(piece, inside - starts_[piece], spline_.locate(along));
}

SheetPoint SurfaceSheet::at(std::size_t piece, double distance, const AlongPlace& along) const {
  const Node& a = node(piece, along.interval);
  const Node& b = node(piece, along.interval + 1);
  const Weights value(along, 0);
  const Weights first(along, 1);
  SheetPoint point;
  const auto set = [&](std::size_t i, const Quintic& from, const Quintic& to, const Quintic& second,
                       const Quintic& next_second) {
    const QuinticValues v = evaluate(blended(from, to, second, next_second, value, true), distance);
    const QuinticValues d =
        evaluate(blended(from, to, second, next_second, first, false), distance);
    point.at[i] = v.value;
    point.across[i] = v.first;
    point.across2[i] = v.second;
    point.along[i] = d.value;
    point.across_along[i] = d.first;
    point.along2[i] = evaluate(second_along(second, next_second, along), distance).value;
  };
  set(0, a.lateral, b.lateral, a.lateral_second, b.lateral_second);
  set(1, a.height, b.height, a.height_second, b.height_second);
  return point;
}

GraphPoint graph_of(const SheetPoint& p) {
  GraphPoint graph;
  graph.height = p.at[1];
  graph.by_lateral = p.across[1] / p.across[0];
  graph.by_along = p.along[1] - graph.by_lateral * p.along[0];
  graph.by_lateral2 =
      (p.across2[1] - graph.by_lateral * p.across2[0]) / (p.across[0] * p.across[0]);
  graph.by_along_lateral =
      (p.across_along[1] - graph.by_lateral * p.across_along[0]) / p.across[0] -
      graph.by_lateral2 * p.along[0];
  graph.by_along2 = p.along2[1] - graph.by_lateral * p.along2[0] -
                    2.0 * graph.by_along_lateral * p.along[0] -
                    graph.by_lateral2 * p.along[0] * p.along[0];
  return graph;
}

class SurfaceSheet::BeginLaterals {
public:
  BeginLaterals(const SurfaceSheet& sheet, const AlongPlace& place)
      : weights_(place, 0), stride_(sheet.starts_.size()),
        value_(sheet.begin_lateral_.data() + place.interval * stride_),
        second_(sheet.begin_second_.data() + place.interval * stride_) {}

  double operator[](std::size_t piece) const {
    const double here = value_[piece];
    return here + (weights_.of_change * (value_[piece + stride_] - here) +
                   (weights_.before * second_[piece] + weights_.after * second_[piece + stride_]));
  }

private:
  Weights weights_;
  std::size_t stride_;
  const double* value_;
  const double* second_;
};

namespace {

/// Where a polynomial that changes its sign within [0, length] is 0: Newton's method in a bracket.
double root_of(const Quintic& polynomial, double value, double length, bool ascends) {
  double low = 0.0;
  double high = length;
  double distance = 0.5 * length;
  while (true) {
    const QuinticValues v = evaluate(polynomial, distance);
    const double off = v.value - value;
    ((off > 0.0) == ascends ? high : low) = distance;
    double next = distance - off / v.first;
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
    }
    if (off == 0.0 || next <= low || next >= high || next == distance) {
      return distance;
    }
    distance = next;
  }
}

} // namespace

std::optional<GraphPoint> SurfaceSheet::over(double along, double lateral) const {
  if (!holds(along)) {
    return std::nullopt;
  }
  const AlongPlace place = spline_.locate(along);
  const Weights weights(place, 0);
  const BeginLaterals begins(*this, place);
  std::optional<GraphPoint> highest;
  const auto [first, last] = ascending_[place.interval];
  double at_high = begins[0] - lateral;
  for (std::size_t piece = 0; piece + 1 < starts_.size(); ++piece) {
    if (piece == first && last > first) { // on to where the begins pass the place
      std::size_t below = first;
      std::size_t above = last;
      while (above - below > 1) {
        const std::size_t middle = below + (above - below) / 2;
        (begins[middle] - lateral < 0.0 ? below : above) = middle;
      }
      piece = below;
      at_high = begins[piece] - lateral;
    }
    const double at_low = at_high;
    at_high = begins[piece + 1] - lateral;
    if ((at_low > 0.0 && at_high > 0.0) || (at_low < 0.0 && at_high < 0.0)) {
      if (piece >= first && piece < last && at_low > 0.0) { // to the end of the run
        piece = last - 1;
        at_high = begins[last] - lateral;
      }
      continue;
    }
    const Node& a = node(piece, place.interval);
    const Node& b = node(piece, place.interval + 1);
    const Quintic section =
        blended(a.lateral, b.lateral, a.lateral_second, b.lateral_second, weights, true);
    const double distance =
        root_of(section, lateral, starts_[piece + 1] - starts_[piece], at_low < at_high);
    const SheetPoint point = at(piece, distance, place);
    if (std::abs(point.across[0]) <
        min_tangent_lateral * std::hypot(point.across[0], point.across[1])) {
      continue;
    }
    if (!highest || point.at[1] > highest->height) {
      highest = graph_of(point);
      highest->across = starts_[piece] + distance;
    }
  }
  return highest;
}

void SurfaceSheet::raise_to(double along, std::span<const double> laterals,
                            std::span<double> heights) const {
  if (!holds(along)) {
    return;
  }
  const AlongPlace place = spline_.locate(along);
  const Weights weights(place, 0);
  const BeginLaterals begins(*this, place);
  double next = begins[0];
  for (std::size_t piece = 0; piece + 1 < starts_.size(); ++piece) {
    const double begin = next;
    next = begins[piece + 1];
    const auto first = std::ranges::lower_bound(laterals, begin);
    if (!(begin < next) || first == laterals.end() || *first > next) {
      continue;
    }
    const Node& a = node(piece, place.interval);
    const Node& b = node(piece, place.interval + 1);
    const Quintic lateral =
        blended(a.lateral, b.lateral, a.lateral_second, b.lateral_second, weights, true);
    const Quintic height =
        blended(a.height, b.height, a.height_second, b.height_second, weights, true);
    for (auto i = static_cast<std::size_t>(first - laterals.begin());
         i < laterals.size() && laterals[i] <= next; ++i) {
      const double distance =
          root_of(lateral, laterals[i], starts_[piece + 1] - starts_[piece], true);
      heights[i] = std::max(heights[i], evaluate(height, distance).value);
    }
  }
}

Curve SurfaceSheet::section(double along) const {
  const AlongPlace place = spline_.locate(along);
  const auto speed_at = [&](std::size_t piece, double distance) {
    const SheetPoint p = at(piece, distance, place);
    return std::hypot(p.across[0], p.across[1]);
  };
  const auto end_at = [&](std::size_t piece, double distance) {
    const SheetPoint p = at(piece, distance, place);
    const double square = p.across[0] * p.across[0] + p.across[1] * p.across[1];
    const double speed = std::sqrt(square);
    const double stretch = (p.across[0] * p.across2[0] + p.across[1] * p.across2[1]) / square;
    return Curve::End{p.at[0],
                      p.at[1],
                      p.across[0] / speed,
                      p.across[1] / speed,
                      (p.across2[0] - stretch * p.across[0]) / square,
                      (p.across2[1] - stretch * p.across[1]) / square};
  };
  std::vector<Curve::Piece> pieces;
  for (std::size_t piece = 0; piece + 1 < starts_.size(); ++piece) {
    const double length = starts_[piece + 1] - starts_[piece];
    const double arc = length / 6.0 *
                       (speed_at(piece, 0.0) + 4.0 * speed_at(piece, 0.5 * length) +
                        speed_at(piece, length)); // Simpson's rule
    pieces.push_back({end_at(piece, 0.0), end_at(piece, length), arc});
  }
  return Curve(pieces);
}

std::size_t SurfaceSheet::memory() const {
  return nodes_.capacity() * sizeof(Node) +
         (starts_.capacity() + begin_lateral_.capacity() + begin_second_.capacity()) *
             sizeof(double);
}

} // namespace wrc
