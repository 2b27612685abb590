#include "accuracy/peak_section.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "accuracy/constants.hpp"
#include "base/constants.hpp"
#include "base/smoothstep.hpp"
#include "mechanics/strip_contact.hpp"

namespace wrc {
namespace {

double second_difference(const std::vector<double>& values, std::size_t i) {
  const double before = i > 0 ? values[i - 1] : 0.0;
  const double after = i + 1 < values.size() ? values[i + 1] : 0.0;
  return before - 2.0 * values[i] + after;
}

/// By how much a parabola through a value and its neighbours is higher than the value.
double above_value(double before, double value, double after) {
  const double difference = before - 2.0 * value + after;
  const double slope = 0.5 * (after - before);
  return difference < 0.0 && std::abs(slope) <= -difference ? -0.5 * slope * slope / difference
                                                            : 0.0;
}

/// Values at positions in ascending order.
struct Samples {
  std::vector<double> places;
  std::vector<double> values;

  void add(double place, double value) {
    places.push_back(place);
    values.push_back(value);
  }
  [[nodiscard]] bool within(double place) const {
    return place >= places.front() && place <= places.back();
  }
  /// Value of the polynomial through the nearest samples.
  [[nodiscard]] double at(double place, std::size_t most) const {
    const auto next = static_cast<std::size_t>(
        std::upper_bound(places.begin(), places.end(), place) - places.begin());
    const std::size_t used = std::min(most, places.size());
    const std::size_t first = std::min(next - std::min(next, used / 2), places.size() - used);
    double sum = 0.0;
    for (std::size_t i = first; i < first + used; ++i) {
      double weight = 1.0;
      for (std::size_t k = first; k < first + used; ++k) {
        weight *= k == i ? 1.0 : (place - places[k]) / (places[i] - places[k]);
      }
      sum += weight * values[i];
    }
    return sum;
  }
  [[nodiscard]] double cubic(double place) const { return at(place, within(place) ? 4 : 2); }
  [[nodiscard]] double linear(double place) const {
    return at(std::clamp(place, places.front(), places.back()), 2);
  }
};

double top_of_row(const Patch& patch, std::size_t row) {
  const std::size_t columns = patch.grid.longitudinal_count;
  const auto begin = patch.pressure.begin() + static_cast<std::ptrdiff_t>(row * columns);
  const auto end = begin + static_cast<std::ptrdiff_t>(columns);
  const auto top = std::max_element(begin, end);
  const bool inside = top != begin && top + 1 != end;
  return *top + (inside ? above_value(*(top - 1), *top, *(top + 1)) : 0.0);
}

/// Elements under pressure, from their positions in the patch's plane to those on the profiles: yaw
/// turns rows across the wheel's profile.
double ridge_under(const Patch& patch, const PosedPair& pair) {
  constexpr double rows = 2.0;
  const Grid& grid = patch.grid;
  const IndexBox& box = patch.contact.box;
  const double across = std::cos(pair.pose.yaw) * patch.frame.lateral.y / std::cos(pair.pose.roll);
  const double along = -std::sin(pair.pose.yaw) / std::cos(pair.pose.roll);
  const auto in_plane = [&frame = patch.frame](double lateral) {
    return frame.curve ? frame.curve->at(lateral).lateral : lateral;
  };
  double s_first = std::numeric_limits<double>::infinity();
  double s_last = -s_first;
  for (std::size_t row = box.lateral_first; row <= box.lateral_last; ++row) {
    for (std::size_t column = box.longitudinal_first; column <= box.longitudinal_last; ++column) {
      if (patch.pressure[row * grid.longitudinal_count + column] > 0.0) {
        const double lateral = in_plane(grid.lateral(row));
        const double s = across * lateral + along * grid.longitudinal(column);
        s_first = std::min(s_first, s);
        s_last = std::max(s_last, s);
      }
    }
  }
  const double room = rows * grid.lateral_step;
  const auto y = [&](double lateral) {
    return patch.frame.origin.y + patch.frame.row_at(lateral).place.y;
  };
  const double s_middle = patch.penetration.mean_s;
  return std::max(
      pair.rail.graph().sharpest_ridge(y(grid.lateral(box.lateral_first) - room),
                                       y(grid.lateral(box.lateral_last) + room)),
      pair.wheel.graph().sharpest_ridge(s_middle + s_first - room, s_middle + s_last + room));
}

/// A largest pressure of strips.
struct Top {
  std::size_t at = 0;
  double pressure = 0.0;
  double difference = 0.0; ///< second, positive
  double bound = 0.0;
  double unresolved = 0.0; ///< what narrower strips may add
};

/// The second difference over two strips is four times that over one where they resolve a top, and
/// less where it is narrower. Next to an edge of contact nothing shows which it is.
double unresolved_at(const std::vector<double>& pressure, std::size_t i) {
  constexpr double at_edge = 0.5; // as of a crest that rises with one slope and falls with another
  const double over_one = -second_difference(pressure, i);
  if (i < 2 || i + 2 >= pressure.size() || !(pressure[i - 2] > 0.0 && pressure[i + 2] > 0.0)) {
    return at_edge * over_one;
  }
  const double over_two = 2.0 * pressure[i] - pressure[i - 2] - pressure[i + 2];
  return std::max(0.0, over_one - 0.25 * over_two);
}

/// Those among the strips from `first` to before `end`.
std::vector<Top> tops_of(const std::vector<double>& pressure, std::size_t first, std::size_t end) {
  const auto at = [&pressure](std::size_t i) { return i < pressure.size() ? pressure[i] : 0.0; };
  std::vector<Top> tops;
  for (std::size_t i = first; i < end; ++i) {
    const double before = i > 0 ? at(i - 1) : 0.0;
    if (at(i) > 0.0 && at(i) >= before && at(i) >= at(i + 1)) {
      Top& top = tops.emplace_back();
      top.at = i;
      top.difference = -second_difference(pressure, i);
      top.pressure =
          at(i) - mean_excess_over_element * top.difference + above_value(before, at(i), at(i + 1));
      top.unresolved = unresolved_at(pressure, i);
      top.bound = top.pressure + error_by_second_difference * top.difference +
                  error_by_unresolved * top.unresolved;
    }
  }
  return tops;
}

/// A line of strips, solved.
struct Strips {
  Grid grid;
  std::vector<double> smooth; ///< what displaces them besides their own pressures, mm
  std::vector<double> pressure;
};

/// Solves strips of a patch on the column of its largest pressure.
class Section {
public:
  Section(const Patch& patch, const PosedPair& pair, StripProblem problem)
      : patch_(patch), pair_(pair), problem_(problem) {}

  /// `count` strips from a position on; `smooth`: displacements besides those of their own
  /// pressures, `guess`: initial pressures.
  Strips solve(double begin, double step, std::size_t count, const Samples& smooth,
               const Samples& guess) {
    Strips strips = strips_from(begin, step, count);
    for (std::size_t i = 0; i < count; ++i) {
      const double lateral = strips.grid.lateral(i);
      strips.smooth.push_back(smooth.cubic(lateral));
      strips.pressure.push_back(std::max(0.0, guess.linear(lateral)));
    }
    solve(strips);
    return strips;
  }

  [[nodiscard]] bool is_resolved(const Top& top) const {
    return top.unresolved <= std::max(problem_.tolerance, least_unresolved) * top.pressure;
  }

  /// The same top on narrower strips around it, again and again until they resolve it.
  Top resolved(Strips strips, Top top) {
    for (int times = 0; times < most_refinements && !is_resolved(top); ++times) {
      const std::size_t first = top.at - std::min(top.at, window_reach);
      const std::size_t end = std::min(top.at + window_reach + 1, strips.pressure.size());
      const std::size_t middle = strip_refinement * (top.at - first);
      strips = finer(strips, top.at, first, end);
      const std::size_t reach = strip_refinement * (window_reach / 2);
      const std::vector<Top> tops =
          tops_of(strips.pressure, middle - std::min(middle, reach),
                  std::min(middle + strip_refinement + reach, strips.pressure.size()));
      if (tops.empty()) {
        break;
      }
      top = *std::max_element(tops.begin(), tops.end(), [](const Top& one, const Top& other) {
        return one.bound < other.bound;
      });
    }
    return top;
  }

private:
  [[nodiscard]] Strips strips_from(double begin, double step, std::size_t count) const {
    Strips strips{patch_.grid, {}, {}};
    strips.grid.longitudinal_count = 1;
    strips.grid.longitudinal_first =
        patch_.grid.longitudinal(patch_.contact.largest_element % patch_.grid.longitudinal_count);
    strips.grid.lateral_step = step;
    strips.grid.lateral_first = begin + 0.5 * step;
    strips.grid.lateral_count = count;
    return strips;
  }

  void solve(Strips& strips) {
    std::vector<double> distance = sample_undeformed_distance(pair_, patch_.frame, strips.grid);
    std::transform(distance.begin(), distance.end(), strips.smooth.begin(), distance.begin(),
                   std::plus<>());
    problem_.step = strips.grid.lateral_step;
    problem_.undeformed_distance = distance;
    strips.pressure = solve_strips(problem_, std::move(strips.pressure));
  }

  [[nodiscard]] std::vector<double> displacements(const Strips& strips,
                                                  const std::vector<double>& pressure) const {
    return displacements_of_strips(strips.grid.lateral_step, problem_.length,
                                   problem_.combined_modulus, pressure);
  }

  /// Those from `first` to before `end` as narrower strips. A fraction of the pressures stays, all
  /// of them outside and none around the maximum, so that their displacements are smooth.
  Strips finer(const Strips& strips, std::size_t top, std::size_t first, std::size_t end) {
    const double step = strips.grid.lateral_step;
    Strips fine =
        strips_from(strips.grid.lateral(first) - 0.5 * step,
                    step / static_cast<double>(strip_refinement), strip_refinement * (end - first));
    std::vector<double> staying = strips.pressure;
    for (std::size_t i = 0; i < staying.size(); ++i) {
      const std::size_t away = i < top ? top - i : i - top;
      staying[i] *=
          smoothstep(2.0 * static_cast<double>(away) / static_cast<double>(window_reach) - 1.0);
    }
    const std::vector<double> displaced = displacements(strips, staying);
    Samples smooth;
    Samples stays;
    Samples guess;
    for (std::size_t i = first; i < end; ++i) {
      const double lateral = strips.grid.lateral(i);
      smooth.add(lateral, strips.smooth[i] + displaced[i]);
      stays.add(lateral, staying[i]);
      guess.add(lateral, strips.pressure[i]);
    }
    std::vector<double> stays_there;
    for (std::size_t i = 0; i < fine.grid.lateral_count; ++i) {
      const double lateral = fine.grid.lateral(i);
      fine.smooth.push_back(smooth.cubic(lateral));
      fine.pressure.push_back(guess.linear(lateral));
      stays_there.push_back(stays.linear(lateral));
    }
    // The strips' own pressures are to be all that they carry.
    const std::vector<double> twice = displacements(fine, stays_there);
    std::transform(fine.smooth.begin(), fine.smooth.end(), twice.begin(), fine.smooth.begin(),
                   std::minus<>());
    solve(fine);
    return fine;
  }

  const Patch& patch_;
  const PosedPair& pair_;
  StripProblem problem_;
};

} // namespace

double growth_at_ridge(double angle, double combined_modulus) {
  return combined_modulus * angle / (2.0 * std::numbers::pi);
}

void find_ridges(GridSolution& solution, const PosedPair& pair) {
  for (Patch& patch : solution.patches) {
    patch.ridge = patch.no_contact() ? 0.0 : ridge_under(patch, pair);
  }
}

double strips_in_row(const Patch& patch) {
  return std::max(strips_per_row, min_strips / patch.rows());
}

PeakInSection peak_in_section(const Patch& patch, Elements elements, const PosedPair& pair,
                              double combined_modulus, double tolerance) {
  const Grid& grid = patch.grid;
  const std::size_t columns = grid.longitudinal_count;
  const std::size_t column = patch.contact.largest_element % columns;
  const double length = strip_length_share * patch.columns() * grid.longitudinal_step;

  std::vector<double> pressure;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    pressure.push_back(top_of_row(patch, row));
  }
  std::vector<double> mean = pressure;
  if (elements == Elements::smooth) {
    for (std::size_t row = 0; row < mean.size(); ++row) {
      mean[row] -= mean_excess_over_element * second_difference(pressure, row);
    }
  }
  const std::vector<double> displacement =
      displacements_of_strips(grid.lateral_step, length, combined_modulus, mean);
  Samples pressures;
  Samples smooth;
  for (std::size_t row = 0; row < pressure.size(); ++row) {
    if (pressure[row] > 0.0) {
      const double lateral = grid.lateral(row);
      pressures.add(lateral, pressure[row]);
      smooth.add(lateral, -patch.undeformed_distance[row * columns + column] - displacement[row]);
    }
  }

  const double step = grid.lateral_step / strips_in_row(patch);
  const double begin = pressures.places.front() - grid.lateral_step;
  const double width = pressures.places.back() + grid.lateral_step - begin;
  StripProblem problem;
  problem.length = length;
  problem.combined_modulus = combined_modulus;
  problem.tolerance = tolerance;
  Section section(patch, pair, problem);
  const Strips strips = section.solve(
      begin, step, static_cast<std::size_t>(std::lround(width / step)), smooth, pressures);
  std::vector<Top> tops = tops_of(strips.pressure, 0, strips.pressure.size());
  double highest = 0.0;
  for (const Top& top : tops) {
    highest = std::max(highest, top.pressure);
  }
  // At a ridge pressures have no bound, and nothing resolves them.
  const bool bounded = growth_at_ridge(patch.ridge, combined_modulus) <= tolerance * highest;
  PeakInSection peak;
  double bound = 0.0;
  for (const Top& top : tops) {
    const Top found =
        bounded && top.pressure + top.difference > highest ? section.resolved(strips, top) : top;
    peak.pressure = std::max(peak.pressure, found.pressure);
    // Rows as coarse as a crest is narrow are uncertain in it, too.
    bound = std::max(
        {bound, found.bound, found.pressure + error_by_second_difference * top.difference});
  }
  peak.error = bound - peak.pressure;
  // No strip in contact: the overlap is lost in rounding.
  return peak.pressure > 0.0 ? peak : PeakInSection{patch.contact.peak_pressure, 0.0};
}

} // namespace wrc
