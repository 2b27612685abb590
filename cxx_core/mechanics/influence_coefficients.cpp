#include "mechanics/influence_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vector_clones.hpp"

namespace wrc {

namespace {

/// Integral of 1/distance along the segment from `first` to `last` (first < last) as seen from a
/// point `offset` > 0 beside the axis origin: asinh(last/offset) - asinh(first/offset).
/// A segment on one side of the origin is rewritten as log1p of a sum of positive terms, since the
/// difference of two nearly equal logarithms would lose the digits that matter.
double segment_potential(double offset, double first, double last) {
  if (last <= 0.0) {
    return segment_potential(offset, -last, -first);
  }
  if (first < 0.0) {
    return std::asinh(last / offset) + std::asinh(-first / offset);
  }
  const double first_distance = std::hypot(offset, first);
  const double last_distance = std::hypot(offset, last);
  const double growth = (last - first) * (1.0 + (first + last) / (first_distance + last_distance));
  return std::log1p(growth / (first + first_distance));
}

/// One edge's share: its signed offset times the potential of the edge.
double edge_term(double offset, double first, double last) {
  return offset == 0.0 ? 0.0 : offset * segment_potential(std::abs(offset), first, last);
}

double near_field(double x, double y, double half_x, double half_y) {
  return (edge_term(x + half_x, y - half_y, y + half_y) -
          edge_term(x - half_x, y - half_y, y + half_y)) +
         (edge_term(y + half_y, x - half_x, x + half_x) -
          edge_term(y - half_y, x - half_x, x + half_x));
}

/// Means of r^n P_n(cos) over the rectangle for n = 2, 4, 6, with all lengths in units of the
/// distance. `cx`, `cy`: squared direction cosines; `mij`: mean of xi^i eta^j over the rectangle.
WRC_VECTOR_BODY double far_field(double x, double y, double step_x, double step_y) {
  const double inverse_square = 1.0 / (x * x + y * y);
  const double cx = x * x * inverse_square;
  const double cy = y * y * inverse_square;
  const double side_x = step_x * step_x * inverse_square;
  const double side_y = step_y * step_y * inverse_square;
  const double m20 = side_x / 12.0;
  const double m02 = side_y / 12.0;
  const double m40 = side_x * side_x / 80.0;
  const double m04 = side_y * side_y / 80.0;
  const double m22 = m20 * m02;
  const double m60 = side_x * side_x * side_x / 448.0;
  const double m06 = side_y * side_y * side_y / 448.0;
  const double m42 = m40 * m02;
  const double m24 = m20 * m04;

  // s is the projection on the direction to the point, r the distance from the element's centre.
  const double second = 0.5 * (3.0 * (cx * m20 + cy * m02) - (m20 + m02));
  const double s4 = cx * cx * m40 + 6.0 * cx * cy * m22 + cy * cy * m04;
  const double s2r2 = cx * m40 + m22 + cy * m04;
  const double r4 = m40 + 2.0 * m22 + m04;
  const double fourth = (35.0 * s4 - 30.0 * s2r2 + 3.0 * r4) / 8.0;
  const double s6 =
      cx * cx * cx * m60 + 15.0 * cx * cy * (cx * m42 + cy * m24) + cy * cy * cy * m06;
  const double s4r2 = cx * cx * m60 + (cx * cx + 6.0 * cx * cy) * m42 +
                      (cy * cy + 6.0 * cx * cy) * m24 + cy * cy * m06;
  const double s2r4 = cx * m60 + (2.0 * cx + cy) * m42 + (cx + 2.0 * cy) * m24 + cy * m06;
  const double r6 = m60 + 3.0 * m42 + 3.0 * m24 + m06;
  const double sixth = (231.0 * s6 - 315.0 * s4r2 + 105.0 * s2r4 - 5.0 * r6) / 16.0;
  return step_x * step_y * std::sqrt(inverse_square) * (1.0 + (second + (fourth + sixth)));
}

WRC_VECTOR_CLONES void fill_far_row(double lateral_distance, double lateral_step, double* row,
                                    std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    row[i] = far_field(static_cast<double>(i), lateral_distance, 1.0, lateral_step);
  }
}

/// Weight of the second differences in the coefficients of smooth elements.
constexpr double smoothing = 1.0 / 24.0;

/// The coefficient of a smooth element, from that of a constant one and those of its neighbours
/// `before` and `after` across the rail and `left` and `right` along it.
double smoothed(double here, double before, double after, double left, double right) {
  const double others = (before + after) + (left + right);
  return here - smoothing * (others - 4.0 * here);
}

/// A row of a table of constant elements: row[i] = I(i, lateral_distance) for elements of 1 x
/// lateral_step.
void fill_constant_row(double lateral_distance, double lateral_step, std::span<double> row) {
  const double y = std::abs(lateral_distance);
  const double far = far_field_distance * std::fmax(1.0, lateral_step);
  std::size_t near_count = 0;
  while (near_count < row.size() &&
         static_cast<double>(near_count) * static_cast<double>(near_count) + y * y < far * far) {
    row[near_count] = near_field(static_cast<double>(near_count), y, 0.5, 0.5 * lateral_step);
    ++near_count;
  }
  fill_far_row(y, lateral_step, row.data(), near_count, row.size());
}

} // namespace

void fill_influence_table(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns,
                          std::span<double> values) {
  const double aspect = kernel.aspect;
  if (kernel.elements == Elements::constant) {
    for (std::size_t row = 0; row < rows; ++row) {
      fill_constant_row(static_cast<double>(row) * aspect, aspect,
                        values.subspan(row * columns, columns));
    }
    return;
  }
  // Rows of constant elements before, at and after the one at hand, one column longer. The kernel
  // is even, so what comes before the first row or column is what comes after it.
  const std::size_t length = columns + 1;
  std::vector<double> lines(3 * length);
  const auto line = [&](std::size_t row) { return lines.data() + (row % 3) * length; };
  const auto fill = [&](std::size_t row) {
    fill_constant_row(static_cast<double>(row) * aspect, aspect, {line(row), length});
  };
  fill(0);
  for (std::size_t row = 0; row < rows; ++row) {
    fill(row + 1);
    const double* here = line(row);
    const double* after = line(row + 1);
    const double* before = row > 0 ? line(row - 1) : after;
    double* out = values.data() + row * columns;
    for (std::size_t column = 0; column < columns; ++column) {
      const double left = here[column > 0 ? column - 1 : 1];
      out[column] = smoothed(here[column], before[column], after[column], left, here[column + 1]);
    }
  }
}

double influence_integral(double longitudinal_distance, double lateral_distance,
                          double longitudinal_step, double lateral_step) {
  const double x = std::abs(longitudinal_distance);
  const double y = std::abs(lateral_distance);
  const double far = far_field_distance * std::fmax(longitudinal_step, lateral_step);
  if (x * x + y * y >= far * far) {
    return far_field(x, y, longitudinal_step, lateral_step);
  }
  return near_field(x, y, 0.5 * longitudinal_step, 0.5 * lateral_step);
}

double influence_coefficient(double longitudinal_distance, double lateral_distance,
                             double longitudinal_step, double lateral_step, double combined_modulus,
                             Elements elements) {
  const auto integral = [=](double columns, double rows) {
    return influence_integral(longitudinal_distance + columns * longitudinal_step,
                              lateral_distance + rows * lateral_step, longitudinal_step,
                              lateral_step);
  };
  double value = integral(0.0, 0.0);
  if (elements == Elements::smooth) {
    value = smoothed(value, integral(0.0, -1.0), integral(0.0, 1.0), integral(-1.0, 0.0),
                     integral(1.0, 0.0));
  }
  return value / (std::numbers::pi * combined_modulus);
}

} // namespace wrc
