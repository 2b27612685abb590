#include "scene/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wrc {
namespace {

/// Steps of element aspect ratios in an octave: few enough to meet again, with less than a tenth
/// more elements than aimed at.
constexpr double ladder_steps = 4.0;
/// Factor on the estimated discretisation error, for its own uncertainty.
constexpr double estimate_safety = 2.0;
/// Weight of the load per length against pmax and approach: it is there for what they miss by
/// chance, and differs by several times as much as they do where nothing is missed.
constexpr double load_share = 0.25;
/// Rows with more than this share of the largest load per length lie well inside the contact.
constexpr double inner_share = 0.5;
/// Grids count as different in a direction from this ratio of elements on.
constexpr double least_ratio = 1.2;

/// Load per length across the rail, summed up from the first row: values at the rows' edges.
std::vector<double> summed_load(const Trial& trial) {
  const Grid& grid = trial.grid;
  std::vector<double> sums{0.0};
  sums.reserve(grid.lateral_count + 1);
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const double* values = trial.normal.pressure.data() + row * grid.longitudinal_count;
    double sum = 0.0;
    for (std::size_t column = 0; column < grid.longitudinal_count; ++column) {
      sum += values[column];
    }
    sums.push_back(sums.back() + sum * grid.element_area());
  }
  return sums;
}

/// Largest difference of the load per length, averaged over the coarser rows, relative to the
/// largest load per length. Only rows well inside the contact count: at its edges the difference
/// falls more slowly and says nothing about the peak.
double load_difference(const Trial& coarser, const Trial& finer) {
  const std::vector<double> coarse_sums = summed_load(coarser);
  const std::vector<double> fine_sums = summed_load(finer);
  const double shift = dot(finer.frame.origin - coarser.frame.origin, finer.frame.lateral);
  const Grid& grid = finer.grid;
  const double first_edge = grid.lateral_first - 0.5 * grid.lateral_step + shift;
  const auto fine_sum_at = [&](double lateral) {
    const double place = std::clamp((lateral - first_edge) / grid.lateral_step, 0.0,
                                    static_cast<double>(grid.lateral_count));
    const auto row = std::min(static_cast<std::size_t>(place), grid.lateral_count - 1);
    const double share = place - static_cast<double>(row);
    return fine_sums[row] + share * (fine_sums[row + 1] - fine_sums[row]);
  };
  double largest = 0.0;
  for (std::size_t row = 0; row < coarser.grid.lateral_count; ++row) {
    largest = std::max(largest, coarse_sums[row + 1] - coarse_sums[row]);
  }
  double difference = 0.0;
  for (std::size_t row = 0; row < coarser.grid.lateral_count; ++row) {
    const double middle = coarser.grid.lateral(row);
    const double half = 0.5 * coarser.grid.lateral_step;
    const double load = coarse_sums[row + 1] - coarse_sums[row];
    if (load > inner_share * largest) {
      difference = std::max(
          difference, std::abs(fine_sum_at(middle + half) - fine_sum_at(middle - half) - load));
    }
  }
  return difference / largest;
}

} // namespace

Grid mesh_grid(const PlaneArea& area, const Mesh& mesh) {
  if (mesh.counts) {
    return grid_over(area, (*mesh.counts)[0], (*mesh.counts)[1]);
  }
  double lateral_step = mesh.lateral_step;
  double longitudinal_step = mesh.longitudinal_step;
  const double aimed = std::log2(lateral_step / longitudinal_step) * ladder_steps;
  const double aspect = std::exp2(std::round(aimed) / ladder_steps);
  longitudinal_step = std::min(longitudinal_step, lateral_step / aspect);
  lateral_step = longitudinal_step * aspect;
  const auto count_over = [](double length, double step) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length / step)));
  };
  const std::size_t lateral_count = count_over(area.width(), lateral_step);
  const std::size_t longitudinal_count = count_over(area.length(), longitudinal_step);
  const auto half = [](double step, std::size_t count) {
    return 0.5 * step * static_cast<double>(count);
  };
  const double lateral_middle = 0.5 * (area.lateral_first + area.lateral_last);
  const double longitudinal_middle = 0.5 * (area.longitudinal_first + area.longitudinal_last);
  Grid grid = grid_over({lateral_middle - half(lateral_step, lateral_count),
                         lateral_middle + half(lateral_step, lateral_count),
                         longitudinal_middle - half(longitudinal_step, longitudinal_count),
                         longitudinal_middle + half(longitudinal_step, longitudinal_count)},
                        lateral_count, longitudinal_count);
  grid.lateral_step = lateral_step;
  grid.longitudinal_step = longitudinal_step;
  return grid;
}

double estimate_error(const Trial& coarser, const Trial& finer, bool position_is_prescribed) {
  double ratio = std::numeric_limits<double>::infinity();
  for (const double directional :
       {finer.rows() / coarser.rows(), finer.columns() / coarser.columns()}) {
    ratio = directional > least_ratio ? std::min(ratio, directional) : ratio;
  }
  if (!std::isfinite(ratio)) {
    ratio = least_ratio;
  }
  const double peak = std::abs(finer.contact.peak_pressure - coarser.contact.peak_pressure) /
                      finer.contact.peak_pressure;
  const double other = position_is_prescribed
                           ? std::abs(finer.normal.normal_force - coarser.normal.normal_force) /
                                 finer.normal.normal_force
                           : std::abs(finer.next_depth - coarser.next_depth) / finer.next_depth;
  const double difference = std::max({peak, other, load_share * load_difference(coarser, finer)});
  return estimate_safety * difference / (ratio * ratio - 1.0) + finer.normal.pressure_error;
}

} // namespace wrc
