#include "pressure/pressure_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pressure/pressure_runs.hpp"

namespace wrc {

namespace {

/// The fit around one element; the largest value of the surface within its 3 x 3 elements.
double fitted_peak(const Grid& grid, std::span<const double> pressure, std::size_t element) {
  const std::size_t columns = grid.longitudinal_count;
  const std::size_t row = element / columns;
  const std::size_t column = element % columns;
  const double largest = pressure[element];
  if (row == 0 || row + 1 >= grid.lateral_count || column == 0 || column + 1 >= columns) {
    return largest;
  }
  // Values relative to the largest, so that the fit works on small differences.
  std::array<std::array<double, 3>, 3> value{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double neighbour = pressure[(row + i - 1) * columns + (column + j - 1)];
      if (!(neighbour > 0.0)) {
        return largest;
      }
      value[i][j] = neighbour - largest;
    }
  }
  std::array<double, 3> row_sum{};
  std::array<double, 3> column_sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      row_sum[i] += value[i][j];
      column_sum[j] += value[i][j];
    }
  }
  const double total = row_sum[0] + row_sum[1] + row_sum[2];
  // c + f . s + s . H s / 2 in element steps s = (lateral, longitudinal): normal equations of the
  // nine points, solved in closed form.
  const double slope_row = (row_sum[2] - row_sum[0]) / 6.0;
  const double slope_column = (column_sum[2] - column_sum[0]) / 6.0;
  const double curve_row = (row_sum[0] + row_sum[2]) - 2.0 * total / 3.0;
  const double curve_column = (column_sum[0] + column_sum[2]) - 2.0 * total / 3.0;
  const double twist = 0.25 * (value[0][0] + value[2][2] - value[0][2] - value[2][0]);
  const double constant = total / 9.0 - (curve_row + curve_column) / 3.0;
  const double determinant = curve_row * curve_column - twist * twist;
  if (!(curve_row < 0.0 && determinant > 0.0)) {
    return largest;
  }
  const double step_row = (twist * slope_column - curve_column * slope_row) / determinant;
  const double step_column = (twist * slope_row - curve_row * slope_column) / determinant;
  if (std::abs(step_row) > 1.0 || std::abs(step_column) > 1.0) {
    return largest;
  }
  // At the top the quadratic part takes back half of the linear part.
  const double top = constant + 0.5 * (slope_row * step_row + slope_column * step_column);
  return largest + std::max(0.0, top);
}

/// Sums over the elements of one set, in the order of the elements.
class RegionSums {
public:
  void add(const Grid& grid, std::span<const double> pressure, const Run& run);
  [[nodiscard]] PressureRegion finish(const Grid& grid, std::span<const double> pressure) const;

private:
  IndexBox box_;
  std::size_t count_ = 0;
  std::size_t first_row_ = 0;
  std::size_t first_column_ = 0;
  std::size_t largest_element_ = 0;
  double largest_pressure_ = 0.0;
  double sum_ = 0.0;
  // Moments in index units from the first element of the set, where they lose no digits.
  double moment_row_ = 0.0;
  double moment_column_ = 0.0;
  double moment_row_row_ = 0.0;
  double moment_column_column_ = 0.0;
};

void RegionSums::add(const Grid& grid, std::span<const double> pressure, const Run& run) {
  if (count_ == 0) {
    first_row_ = run.row;
    first_column_ = run.first;
    box_ = {run.row, run.row, run.first, run.last - 1};
  }
  box_.lateral_last = run.row;
  box_.longitudinal_first = std::min(box_.longitudinal_first, run.first);
  box_.longitudinal_last = std::max(box_.longitudinal_last, run.last - 1);
  count_ += run.last - run.first;
  const double* values = pressure.data() + run.row * grid.longitudinal_count;
  double sum = 0.0;
  double moment = 0.0;
  double square = 0.0;
  double offset = static_cast<double>(run.first) - static_cast<double>(first_column_);
  for (std::size_t column = run.first; column < run.last; ++column, offset += 1.0) {
    const double value = values[column];
    if (value > largest_pressure_) {
      largest_pressure_ = value;
      largest_element_ = run.row * grid.longitudinal_count + column;
    }
    sum += value;
    moment += value * offset;
    square += value * offset * offset;
  }
  const double row_offset = static_cast<double>(run.row) - static_cast<double>(first_row_);
  sum_ += sum;
  moment_column_ += moment;
  moment_column_column_ += square;
  moment_row_ += sum * row_offset;
  moment_row_row_ += sum * row_offset * row_offset;
}

/// sqrt(5 variance), with the moments in steps; 0 for a single row of elements.
double semi_axis(double mean_square, double mean, double step) {
  return step * std::sqrt(5.0 * std::max(0.0, mean_square - mean * mean));
}

PressureRegion RegionSums::finish(const Grid& grid, std::span<const double> pressure) const {
  PressureRegion region;
  if (count_ == 0) {
    return region;
  }
  region.largest_element = largest_element_;
  region.largest_element_pressure = largest_pressure_;
  region.peak_pressure = fitted_peak(grid, pressure, largest_element_);
  region.element_count = count_;
  region.area = static_cast<double>(count_) * grid.element_area();
  region.normal_force = sum_ * grid.element_area();
  const double mean_row = moment_row_ / sum_;
  const double mean_column = moment_column_ / sum_;
  region.centroid_lateral = grid.lateral(first_row_) + mean_row * grid.lateral_step;
  region.centroid_longitudinal =
      grid.longitudinal(first_column_) + mean_column * grid.longitudinal_step;
  region.semi_axis_lateral = semi_axis(moment_row_row_ / sum_, mean_row, grid.lateral_step);
  region.semi_axis_longitudinal =
      semi_axis(moment_column_column_ / sum_, mean_column, grid.longitudinal_step);
  region.first_element = first_row_ * grid.longitudinal_count + first_column_;
  region.box = box_;
  region.touches_edge = {box_.lateral_first == 0, box_.lateral_last + 1 == grid.lateral_count,
                         box_.longitudinal_first == 0,
                         box_.longitudinal_last + 1 == grid.longitudinal_count};
  return region;
}

} // namespace

double peak_pressure(const Grid& grid, std::span<const double> pressure) {
  check_pressure_size(grid, pressure);
  const auto largest = std::max_element(pressure.begin(), pressure.end());
  if (largest == pressure.end() || !(*largest > 0.0)) {
    return 0.0;
  }
  return fitted_peak(grid, pressure, static_cast<std::size_t>(largest - pressure.begin()));
}

std::vector<PressureRegion> pressure_regions(const Grid& grid, std::span<const double> pressure) {
  check_pressure_size(grid, pressure);
  std::vector<Run> runs = find_runs(grid, pressure);
  join_neighbours(runs);
  std::vector<RegionSums> sums;
  std::vector<std::size_t> sums_of_root(runs.size());
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::size_t root = root_of_run(runs, run);
    if (root == run) {
      sums_of_root[run] = sums.size();
      sums.emplace_back();
    }
    sums[sums_of_root[root]].add(grid, pressure, runs[run]);
  }
  std::vector<PressureRegion> regions;
  regions.reserve(sums.size());
  for (const RegionSums& sum : sums) {
    regions.push_back(sum.finish(grid, pressure));
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const PressureRegion& left, const PressureRegion& right) {
                     return left.normal_force > right.normal_force;
                   });
  return regions;
}

PressureRegion summarise_pressure(const Grid& grid, std::span<const double> pressure) {
  check_pressure_size(grid, pressure);
  RegionSums sums;
  for (const Run& run : find_runs(grid, pressure)) {
    sums.add(grid, pressure, run);
  }
  return sums.finish(grid, pressure);
}

EdgeContact edges_in_contact(const Grid& grid, std::span<const double> pressure) {
  check_pressure_size(grid, pressure);
  EdgeContact edges;
  for (std::size_t row = 0; row < grid.lateral_count; ++row) {
    const std::span<const double> values =
        pressure.subspan(row * grid.longitudinal_count, grid.longitudinal_count);
    const bool any = std::any_of(values.begin(), values.end(), [](double p) { return p > 0.0; });
    edges.lateral_first |= row == 0 && any;
    edges.lateral_last |= row + 1 == grid.lateral_count && any;
    if (!values.empty()) {
      edges.longitudinal_first |= values.front() > 0.0;
      edges.longitudinal_last |= values.back() > 0.0;
    }
  }
  return edges;
}

} // namespace wrc
