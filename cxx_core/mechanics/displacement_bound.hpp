/// Lower bounds of the displacement that pressures cause, cheap at any place.
///
/// The mean of 1/distance over the pressures of a row of elements is at least 1/sqrt of the mean
/// squared distance (Jensen's inequality), so with force F, mean m and variance v of a row
///   u(x, y) >= 1/(pi E*) sum_rows F / sqrt((x - m)^2 + v + dx^2/12 + (y - y_row)^2 + dy^2/12).
/// It lies close to u some rows away from the pressures, and is enough to tell that no contact was
/// left out there. Nearer, the same for every element by itself is closer, and as many times dearer
/// as a row has elements.
/// That is for elements of constant pressure. The second differences of smooth ones take the second
/// moments dx^2/12 and dy^2/12 away again: some elements off they act like forces at their centres,
/// which is more than these bounds. They hold for them from three of their longer sides off, and at
/// any place for aspect ratios up to two (by computation, aspect ratios up to 1000).
/// Units mm, N, MPa; frame of remesh/grid.hpp. Thread rule: immutable.
#pragma once

#include <span>
#include <vector>

#include "remesh/grid.hpp"

namespace wrc {

class DisplacementBound {
public:
  /// The pressures must outlive the bound.
  DisplacementBound(const Grid& grid, std::span<const double> pressure, double combined_modulus);

  /// A lower bound of u in mm, by rows.
  [[nodiscard]] double at(double longitudinal, double lateral) const;
  /// By elements: closer.
  [[nodiscard]] double closer_at(double longitudinal, double lateral) const;

private:
  struct Row {
    double lateral;
    double mean;         ///< longitudinal
    double mean_square;  ///< of the distance from the mean and from the row, with the elements'
    double displacement; ///< F / (pi E*)
  };
  Grid grid_;
  std::span<const double> pressure_;
  double scale_;          ///< from a pressure to F / (pi E*)
  double element_square_; ///< (dx^2 + dy^2) / 12
  std::vector<Row> rows_;
};

} // namespace wrc
