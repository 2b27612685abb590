#include "pressure/contact_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pressure/pressure_runs.hpp"
#include "pressure/squared_pressure.hpp"

namespace wrc {

namespace {

/// Fraction of a triangle where the linear function with these corner values is above 0.
double positive_share(double a, double b, double c) {
  const double low = std::min({a, b, c});
  const double high = std::max({a, b, c});
  if (low > 0.0) {
    return 1.0;
  }
  if (!(high > 0.0)) {
    return 0.0;
  }
  const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
  if (middle > 0.0) {
    return 1.0 - (low / (low - middle)) * (low / (low - high));
  }
  return (high / (high - low)) * (high / (high - middle));
}

/// Fraction of the rectangle between four centres, on four triangles around its middle.
double positive_share(double upper_left, double upper_right, double lower_left,
                      double lower_right) {
  const double mean = 0.25 * ((upper_left + lower_right) + (upper_right + lower_left));
  return 0.25 * ((positive_share(upper_left, upper_right, mean) +
                  positive_share(lower_left, lower_right, mean)) +
                 (positive_share(upper_left, lower_left, mean) +
                  positive_share(upper_right, lower_right, mean)));
}

/// Goes through the cells between the centres of two neighbouring rows and columns. Cell j lies
/// between columns j - 1 and j; the first and the last one, half as wide, reach to the grid's edge,
/// and so do the cells above the first row and below the last one.
class CellWalk {
public:
  CellWalk(const Grid& grid, std::span<const double> pressure, std::span<const Run> runs)
      : size_{grid.lateral_count, grid.longitudinal_count}, pressure_(pressure), runs_(runs) {
    for (std::vector<double>& values : squares_) {
      values.resize(size_.columns);
    }
    // Squares neither overflow nor vanish when the numbers are of the order of 1.
    double largest = 0.0;
    for (const Run& run : runs) {
      const std::size_t middle = run.first + (run.last - run.first) / 2;
      largest = std::max(largest, pressure[run.row * size_.columns + middle]);
    }
    scale_ = 1.0 / largest;
  }

  /// Calls add(run, area) with areas in elements and the index of a run they belong to.
  template <typename Add> void visit(const Add& add) {
    std::size_t upper = 0;
    std::size_t lower = 0;
    for (std::size_t cell_row = 0; cell_row <= size_.rows; ++cell_row) {
      const bool at_edge = cell_row == 0 || cell_row == size_.rows;
      const std::size_t upper_row = cell_row - std::min<std::size_t>(cell_row, 1);
      const std::size_t lower_row = std::min(cell_row, size_.rows - 1);
      const std::size_t upper_end = end_of_row(upper, upper_row);
      lower = lower_row == upper_row ? upper : upper_end;
      const std::size_t lower_end = end_of_row(lower, lower_row);
      load_rows(upper_row, lower_row);
      visit_row(upper, upper_end, lower, lower_end,
                [&](std::size_t run, double area) { add(run, at_edge ? 0.5 * area : area); });
      if (cell_row > 0) {
        upper = upper_end;
      }
    }
  }

private:
  /// The index after the last run of a row, from that of the row's first one.
  [[nodiscard]] std::size_t end_of_row(std::size_t run, std::size_t row) const {
    while (run < runs_.size() && runs_[run].row == row) {
      ++run;
    }
    return run;
  }

  void load_rows(std::size_t upper_row, std::size_t lower_row) {
    for (const std::size_t row : {upper_row, lower_row}) {
      if (row_of_squares_[row % 2] != row) {
        row_of_squares_[row % 2] = row;
        std::fill(squares_[row % 2].begin(), squares_[row % 2].end(), unknown);
      }
    }
    upper_row_ = upper_row;
    lower_row_ = lower_row;
  }

  double square_at(std::size_t row, std::size_t column) {
    double& square = squares_[row % 2][column];
    if (std::isnan(square)) {
      const double p = scale_ * pressure_[row * size_.columns + column];
      square = p > 0.0 ? p * p : edge_square(size_, pressure_, scale_, row, column);
    }
    return square;
  }

  /// Area of one cell that has pressure at some of its corners.
  double cell_area(std::size_t cell) {
    const std::size_t left = cell - std::min<std::size_t>(cell, 1);
    const std::size_t right = std::min(cell, size_.columns - 1);
    return (1.0 - missing_width(cell)) *
           positive_share(square_at(upper_row_, left), square_at(upper_row_, right),
                          square_at(lower_row_, left), square_at(lower_row_, right));
  }

  /// What the first and the last cell of a row are narrower than the others.
  [[nodiscard]] double missing_width(std::size_t cell) const {
    return cell == 0 || cell == size_.columns ? 0.5 : 0.0;
  }

  /// First of the cells with pressure at both ends along this run, and the one after the last.
  [[nodiscard]] std::size_t first_full(const Run& run) const {
    return run.first == 0 ? 0 : run.first + 1;
  }
  [[nodiscard]] std::size_t last_full(const Run& run) const {
    return run.last == size_.columns ? run.last + 1 : run.last;
  }

  template <typename Add>
  void visit_row(std::size_t upper, std::size_t upper_end, std::size_t lower, std::size_t lower_end,
                 const Add& add) {
    std::size_t above = upper; // the runs that may still make full cells together
    std::size_t below = lower;
    std::size_t next = 0; // the first cell not yet done
    while (upper < upper_end || lower < lower_end) {
      const bool take_upper =
          lower == lower_end || (upper < upper_end && runs_[upper].first <= runs_[lower].first);
      const std::size_t index = take_upper ? upper++ : lower++;
      const Run& run = runs_[index];
      double area = 0.0;
      next = std::max(next, run.first);
      while (next <= run.last) {
        while (above < upper_end && last_full(runs_[above]) <= next) {
          ++above;
        }
        while (below < lower_end && last_full(runs_[below]) <= next) {
          ++below;
        }
        if (above < upper_end && below < lower_end) {
          const std::size_t first = std::max(first_full(runs_[above]), first_full(runs_[below]));
          const std::size_t last = std::min(last_full(runs_[above]), last_full(runs_[below]));
          if (first <= next && next < last) {
            area += static_cast<double>(last - next) - missing_width(next) -
                    (last > next + 1 ? missing_width(last - 1) : 0.0);
            next = last;
            continue;
          }
        }
        area += cell_area(next);
        ++next;
      }
      add(index, area);
    }
  }

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  LevelSize size_;
  std::span<const double> pressure_;
  std::span<const Run> runs_;
  double scale_ = 0.0;
  std::array<std::vector<double>, 2> squares_;
  std::array<std::size_t, 2> row_of_squares_{std::numeric_limits<std::size_t>::max(),
                                             std::numeric_limits<std::size_t>::max()};
  std::size_t upper_row_ = 0;
  std::size_t lower_row_ = 0;
};

} // namespace

double contact_area(const Grid& grid, std::span<const double> pressure) {
  check_pressure_size(grid, pressure);
  const std::vector<Run> runs = find_runs(grid, pressure);
  if (runs.empty()) {
    return 0.0;
  }
  double sum = 0.0;
  CellWalk(grid, pressure, runs).visit([&](std::size_t, double area) { sum += area; });
  return sum * grid.element_area();
}

} // namespace wrc
