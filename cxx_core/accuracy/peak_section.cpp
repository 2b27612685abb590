#include "accuracy/peak_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "accuracy/constants.hpp"
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

/// Values at places in ascending order.
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
  /// Of the polynomial through the nearest samples.
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

/// Elements under pressure, from their places in the patch's plane to those on the profiles: yaw
/// turns rows across the wheel's profile.
double ridge_under(const Patch& patch, const PosedPair& pair) {
  constexpr double rows = 2.0;
  const Grid& grid = patch.grid;
  const IndexBox& box = patch.contact.box;
  const double across = std::cos(pair.pose.yaw) * patch.frame.lateral.y / std::cos(pair.pose.roll);
  const double along = -std::sin(pair.pose.yaw) / std::cos(pair.pose.roll);
  double s_first = std::numeric_limits<double>::infinity();
  double s_last = -s_first;
  for (std::size_t row = box.lateral_first; row <= box.lateral_last; ++row) {
    for (std::size_t column = box.longitudinal_first; column <= box.longitudinal_last; ++column) {
      if (patch.pressure[row * grid.longitudinal_count + column] > 0.0) {
        const double s = across * grid.lateral(row) + along * grid.longitudinal(column);
        s_first = std::min(s_first, s);
        s_last = std::max(s_last, s);
      }
    }
  }
  const double room = rows * grid.lateral_step;
  const auto y = [&](double lateral) {
    return patch.frame.origin.y + patch.frame.lateral.y * lateral;
  };
  const double s_middle = patch.penetration.mean_s;
  return std::max(
      pair.rail.graph().sharpest_ridge(y(grid.lateral(box.lateral_first) - room),
                                       y(grid.lateral(box.lateral_last) + room)),
      pair.wheel.graph().sharpest_ridge(s_middle + s_first - room, s_middle + s_last + room));
}

PeakInSection highest_of(const std::vector<double>& pressure) {
  const auto at = [&pressure](std::size_t i) { return i < pressure.size() ? pressure[i] : 0.0; };
  PeakInSection peak;
  double bound = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const double before = i > 0 ? at(i - 1) : 0.0;
    if (at(i) > 0.0 && at(i) >= before && at(i) >= at(i + 1)) {
      const double difference = second_difference(pressure, i);
      const double top =
          at(i) + mean_over_element * difference + above_value(before, at(i), at(i + 1));
      peak.pressure = std::max(peak.pressure, top);
      bound = std::max(bound, top - error_by_second_difference * difference);
    }
  }
  peak.error = bound - peak.pressure;
  return peak;
}

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
      mean[row] -= mean_over_element * second_difference(pressure, row);
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

  Grid strips = grid;
  strips.longitudinal_count = 1;
  strips.longitudinal_first = grid.longitudinal(column);
  strips.lateral_step = grid.lateral_step / strips_in_row(patch);
  const double begin = pressures.places.front() - grid.lateral_step;
  const double width = pressures.places.back() + grid.lateral_step - begin;
  strips.lateral_first = begin + 0.5 * strips.lateral_step;
  strips.lateral_count = static_cast<std::size_t>(std::lround(width / strips.lateral_step));
  std::vector<double> distance = sample_undeformed_distance(pair, patch.frame, strips);
  std::vector<double> fine(distance.size());
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const double lateral = strips.lateral(i);
    distance[i] += smooth.cubic(lateral);
    fine[i] = std::max(0.0, pressures.linear(lateral));
  }
  fine = solve_strips({strips.lateral_step, length, combined_modulus, 0.0, distance, tolerance},
                      std::move(fine));
  const PeakInSection peak = highest_of(fine);
  // No strip in contact: the overlap is lost in rounding.
  return peak.pressure > 0.0 ? peak : PeakInSection{patch.contact.peak_pressure, 0.0};
}

} // namespace wrc
