#include "mechanics/cascade.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/constants.hpp"

namespace wrc {

namespace {

/// A row of distances, the row after the last one by linear continuation.
double distance_at(std::span<const double> distance, const LevelSize& size, std::size_t row,
                   std::size_t column) {
  const auto value = [&](std::size_t i, std::size_t j) { return distance[i * size.columns + j]; };
  if (row >= size.rows) {
    return 2.0 * distance_at(distance, size, size.rows - 1, column) -
           distance_at(distance, size, size.rows - 2, column);
  }
  if (column >= size.columns) {
    return 2.0 * value(row, size.columns - 1) - value(row, size.columns - 2);
  }
  return value(row, column);
}

/// The two elements next to a position along a side of a grid, and their weights.
struct Neighbours {
  std::size_t before = 0;
  std::size_t after = 0;
  double of_before = 0.0;
  double of_after = 0.0;
};

/// `steps`: from the first element's centre. No weights outside the grid.
Neighbours neighbours_of(double steps, std::size_t count) {
  const auto last = static_cast<double>(count - 1);
  if (steps < -0.5 || steps > last + 0.5) {
    return {};
  }
  const double inside = std::clamp(steps, 0.0, last);
  const auto before = static_cast<std::size_t>(inside);
  const double part = inside - static_cast<double>(before);
  return {before, std::min(before + 1, count - 1), 1.0 - part, part};
}

} // namespace

bool can_coarsen(const LevelSize& size) {
  return std::max(size.rows, size.columns) > max_coarsest_side &&
         std::min(size.rows, size.columns) >= 2 * min_level_side;
}

LevelSize coarser_size(const LevelSize& size) {
  return {(size.rows + 1) / 2, (size.columns + 1) / 2};
}

void coarsen_distance(const LevelSize& fine, std::span<const double> distance,
                      std::vector<double>& coarse) {
  const LevelSize size = coarser_size(fine);
  coarse.resize(size.count());
  const std::size_t whole_rows = fine.rows / 2;
  const std::size_t whole_columns = fine.columns / 2;
  // Half of the mean: the coarser grid's unit of length is twice as long.
  constexpr double share = 0.125;
  for (std::size_t i = 0; i < whole_rows; ++i) {
    const double* upper = distance.data() + 2 * i * fine.columns;
    const double* lower = upper + fine.columns;
    double* values = coarse.data() + i * size.columns;
    for (std::size_t j = 0; j < whole_columns; ++j) {
      values[j] = share * ((upper[2 * j] + upper[2 * j + 1]) + (lower[2 * j] + lower[2 * j + 1]));
    }
  }
  for (std::size_t i = 0; i < size.rows; ++i) {
    for (std::size_t j = i < whole_rows ? whole_columns : 0; j < size.columns; ++j) {
      double sum = 0.0;
      for (const std::size_t row : {2 * i, 2 * i + 1}) {
        for (const std::size_t column : {2 * j, 2 * j + 1}) {
          sum += distance_at(distance, fine, row, column);
        }
      }
      coarse[i * size.columns + j] = share * sum;
    }
  }
}

void coarsen_angles(std::span<const double> angles, std::vector<double>& coarse) {
  coarse.clear();
  for (std::size_t row = 0; row < angles.size(); row += 2) {
    const bool has_partner = row + 1 < angles.size();
    const double partner = has_partner ? angles[row + 1] : 2.0 * angles[row] - angles[row - 1];
    coarse.push_back(0.5 * (angles[row] + partner));
  }
}

void coarsen_pressure(const LevelSize& fine, std::span<const double> pressure,
                      std::vector<double>& coarse) {
  coarsen_distance(fine, pressure, coarse);
  for (double& value : coarse) {
    value = std::max(0.0, 2.0 * value); // not in the coarser grid's unit of length
  }
}

void interpolate(const Grid& coarse, std::span<const double> values, const Grid& fine,
                 std::vector<double>& refined) {
  std::vector<Neighbours> columns(fine.longitudinal_count);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const double steps =
        (fine.longitudinal(j) - coarse.longitudinal_first) / coarse.longitudinal_step;
    columns[j] = neighbours_of(steps, coarse.longitudinal_count);
  }
  refined.resize(fine.element_count());
  for (std::size_t i = 0; i < fine.lateral_count; ++i) {
    const double steps = (fine.lateral(i) - coarse.lateral_first) / coarse.lateral_step;
    const Neighbours row = neighbours_of(steps, coarse.lateral_count);
    const double* before = values.data() + row.before * coarse.longitudinal_count;
    const double* after = values.data() + row.after * coarse.longitudinal_count;
    double* to = refined.data() + i * fine.longitudinal_count;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const Neighbours& column = columns[j];
      to[j] = row.of_before * (column.of_before * before[column.before] +
                               column.of_after * before[column.after]) +
              row.of_after *
                  (column.of_before * after[column.before] + column.of_after * after[column.after]);
    }
  }
}

void refine_pressure(const Grid& coarse, std::span<const double> pressure, const Grid& fine,
                     std::vector<double>& refined) {
  std::vector<double> squares;
  square_and_continue({coarse.lateral_count, coarse.longitudinal_count}, pressure, squares);
  interpolate(coarse, squares, fine, refined);
  for (double& value : refined) {
    value = std::sqrt(std::max(0.0, value));
  }
}

bool find_pressure_box(const LevelSize& size, std::span<const double> pressure, std::size_t margin,
                       ElementBox& box) {
  std::size_t first_row = size.rows;
  std::size_t last_row = 0;
  std::size_t first_column = size.columns;
  std::size_t last_column = 0;
  for (std::size_t i = 0; i < size.rows; ++i) {
    const double* row = pressure.data() + i * size.columns;
    std::size_t j = 0;
    while (j < size.columns && !(row[j] > 0.0)) {
      ++j;
    }
    if (j == size.columns) {
      continue;
    }
    first_row = std::min(first_row, i);
    last_row = i;
    first_column = std::min(first_column, j);
    std::size_t k = size.columns - 1;
    while (!(row[k] > 0.0)) {
      --k;
    }
    last_column = std::max(last_column, k);
  }
  if (first_row == size.rows) {
    return false;
  }
  box = {first_row - std::min(first_row, margin), std::min(last_row + margin, size.rows - 1),
         first_column - std::min(first_column, margin),
         std::min(last_column + margin, size.columns - 1)};
  return true;
}

void copy_box(const LevelSize& size, const ElementBox& box, std::span<const double> field,
              std::span<double> inside) {
  for (std::size_t row = 0; row < box.rows(); ++row) {
    std::copy_n(field.data() + (box.first_row + row) * size.columns + box.first_column,
                box.columns(), inside.data() + row * box.columns());
  }
}

void copy_box(const LevelSize& size, const ElementBox& box, std::span<const double> field,
              std::vector<double>& inside) {
  inside.resize(box.count());
  copy_box(size, box, field, std::span<double>(inside));
}

void put_box(const LevelSize& size, const ElementBox& box, std::span<const double> inside,
             std::span<double> field) {
  for (std::size_t row = 0; row < box.rows(); ++row) {
    std::copy_n(inside.data() + row * box.columns(), box.columns(),
                field.data() + (box.first_row + row) * size.columns + box.first_column);
  }
}

} // namespace wrc
