#include "half_space/influence_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "base/constants.hpp"
#include "base/vector_clones.hpp"
#include "half_space/constants.hpp"
#include "half_space/vector_log.hpp"

namespace wrc {

namespace {

WRC_VECTOR_BODY double distance(double x, double y) {
  return std::sqrt(x * x + y * y);
}

/// Integral of 1/distance along a segment as seen from a point at `near` and `far` from its ends.
/// Without cancellation where the foot of the perpendicular is at least half a segment beside it.
WRC_VECTOR_BODY double chord_potential(double span, double near, double far) {
  return vector_log1p(2.0 * span / (near + far - span));
}

/// Likewise of a segment that starts at the foot, `offset` > 0 from the point.
WRC_VECTOR_BODY double foot_potential(double offset, double span, double far) {
  return vector_log1p(span * (1.0 + span / (offset + far)) / offset);
}

/// Likewise of any segment, with the foot at 0: asinh(last/offset) - asinh(first/offset).
WRC_VECTOR_BODY double segment_potential(double offset, double first, double last, double near,
                                         double far) {
  const double span = last - first;
  if (std::fmin(std::abs(first), std::abs(last)) >= 0.5 * span && first * last > 0.0) {
    return chord_potential(span, near, far);
  }
  const double to_first = first == 0.0 ? 0.0 : foot_potential(offset, std::abs(first), near);
  const double to_last = last == 0.0 ? 0.0 : foot_potential(offset, std::abs(last), far);
  return std::copysign(to_last, last) - std::copysign(to_first, first);
}

/// Contribution of one edge: its signed offset times the potential of the edge.
WRC_VECTOR_BODY double edge_term(double offset, double first, double last, double near,
                                 double far) {
  return offset == 0.0 ? 0.0 : offset * segment_potential(std::abs(offset), first, last, near, far);
}

WRC_VECTOR_CLONES double near_field(double x, double y, double half_x, double half_y) {
  const double left = x - half_x;
  const double right = x + half_x;
  const double begin = y - half_y;
  const double end = y + half_y;
  const double left_begin = distance(left, begin);
  const double right_begin = distance(right, begin);
  const double left_end = distance(left, end);
  const double right_end = distance(right, end);
  return (edge_term(right, begin, end, right_begin, right_end) -
          edge_term(left, begin, end, left_begin, left_end)) +
         (edge_term(end, left, right, left_end, right_end) -
          edge_term(begin, left, right, left_begin, right_begin));
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

/// Distances of the corners at (halves[i], y), i < count; halves[i] = i + 1/2.
WRC_VECTOR_CLONES void fill_corners(const double* halves, double y, double* corners,
                                    std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    corners[i] = distance(halves[i], y);
  }
}

/// Offset times potential of the edges between elements i and i + 1 of a row, for i < count, from
/// the corners before and after the row.
WRC_VECTOR_CLONES void fill_terms_across(const double* halves, double step, const double* before,
                                         const double* after, double* terms, std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    terms[i] = halves[i] * chord_potential(step, before[i], after[i]);
  }
}

/// The same of row 0, which reaches from -step/2 to step/2.
WRC_VECTOR_CLONES void fill_first_terms_across(const double* halves, double step,
                                               const double* after, double* terms,
                                               std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    terms[i] = 2.0 * halves[i] * foot_potential(halves[i], 0.5 * step, after[i]);
  }
}

/// Offset times potential of the edges on the line y, one to an element.
WRC_VECTOR_CLONES void fill_terms_along(double y, const double* corners, double* terms,
                                        std::size_t count) {
  terms[0] = 2.0 * y * foot_potential(y, 0.5, corners[0]);
#pragma omp simd
  for (std::size_t i = 1; i < count; ++i) {
    terms[i] = y * chord_potential(1.0, corners[i - 1], corners[i]);
  }
}

/// I from the terms of the edges; `row_before` are those on the line to the row before.
WRC_VECTOR_CLONES void add_edge_terms(const double* across, const double* row_before,
                                      const double* along, double* row, std::size_t count) {
  row[0] = 2.0 * across[0] + (along[0] - row_before[0]);
  for (std::size_t i = 1; i < count; ++i) {
    row[i] = (across[i] - across[i - 1]) + (along[i] - row_before[i]);
  }
}

WRC_VECTOR_CLONES void fill_far_row(const double* halves, double lateral_distance,
                                    double lateral_step, double* row, std::size_t first,
                                    std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    row[i] = far_field(halves[i] - 0.5, lateral_distance, 1.0, lateral_step);
  }
}

/// The coefficient of a smooth element, from that of a constant one and those of its neighbours
/// `before` and `after` across the rail and `left` and `right` along it.
WRC_VECTOR_BODY double smoothed(double here, double before, double after, double left,
                                double right) {
  const double others = (before + after) + (left + right);
  return here - mean_excess_over_element * (others - 4.0 * here);
}

WRC_VECTOR_CLONES void fill_smoothed_row(const double* before, const double* here,
                                         const double* after, double* row, std::size_t count) {
  // Even: what comes before the first column is what comes after it.
  row[0] = smoothed(here[0], before[0], after[0], here[1], here[1]);
  for (std::size_t i = 1; i < count; ++i) {
    row[i] = smoothed(here[i], before[i], after[i], here[i - 1], here[i + 1]);
  }
}

/// The rows of a table of constant elements, first to last: row[i] = I(i, row * aspect). Neighbours
/// have corners and edges in common, which are computed once.
class ConstantRows {
public:
  ConstantRows(double aspect, std::size_t length)
      : aspect_(aspect), values_(6 * length), halves_(values_.data(), length),
        across_(halves_.data() + length), before_{across_ + length, across_ + 2 * length},
        after_{across_ + 3 * length, across_ + 4 * length} {
    for (std::size_t i = 0; i < length; ++i) {
      halves_[i] = static_cast<double>(i) + 0.5;
    }
  }

  void fill_next(double* row) {
    const double y = static_cast<double>(next_) * aspect_;
    const double far = far_field_distance * std::fmax(1.0, aspect_);
    std::size_t near_count = 0;
    while (near_count < halves_.size() &&
           static_cast<double>(near_count) * static_cast<double>(near_count) + y * y < far * far) {
      ++near_count;
    }
    if (near_count > 0) {
      fill_near(y - 0.5 * aspect_, y + 0.5 * aspect_, row, near_count);
    }
    fill_far_row(halves_.data(), y, aspect_, row, near_count, halves_.size());
    ++next_;
  }

private:
  /// The corners and edges on the line y, as far as elements are near.
  struct Line {
    double* corners;
    double* terms;
    double y = 0.0;
  };

  void fill_line(Line& line, double y, std::size_t count) {
    fill_corners(halves_.data(), y, line.corners, count);
    fill_terms_along(y, line.corners, line.terms, count);
    line.y = y;
  }

  void fill_near(double begin, double end, double* row, std::size_t count) {
    std::swap(before_, after_);
    fill_line(after_, end, count);
    if (next_ == 0) {
      fill_first_terms_across(halves_.data(), aspect_, after_.corners, across_, count);
      std::transform(after_.terms, after_.terms + count, before_.terms, std::negate<>());
    } else {
      if (before_.y != begin) { // by rounding
        fill_line(before_, begin, count);
      }
      fill_terms_across(halves_.data(), end - begin, before_.corners, after_.corners, across_,
                        count);
    }
    add_edge_terms(across_, before_.terms, after_.terms, row, count);
  }

  double aspect_;
  std::size_t next_ = 0;
  std::vector<double> values_;
  std::span<double> halves_; ///< i + 1/2
  double* across_;
  Line before_;
  Line after_;
};

} // namespace

void fill_influence_table(const InfluenceKernel& kernel, std::size_t rows, std::size_t columns,
                          std::span<double> values) {
  if (kernel.elements == Elements::constant) {
    ConstantRows constant(kernel.aspect, columns);
    for (std::size_t row = 0; row < rows; ++row) {
      constant.fill_next(values.data() + row * columns);
    }
    return;
  }
  // Rows of constant elements before, at and after the current one, one column longer. The kernel
  // is even, so the row before the first equals the one after it.
  const std::size_t length = columns + 1;
  ConstantRows constant(kernel.aspect, length);
  std::vector<double> lines(3 * length);
  const auto line = [&](std::size_t row) { return lines.data() + (row % 3) * length; };
  constant.fill_next(line(0));
  for (std::size_t row = 0; row < rows; ++row) {
    constant.fill_next(line(row + 1));
    fill_smoothed_row(line(row > 0 ? row - 1 : 1), line(row), line(row + 1),
                      values.data() + row * columns, columns);
  }
}

namespace {

/// Integrals of x y / r^3 from the distances of the corners on the two lines.
WRC_VECTOR_CLONES void fill_mixed_row(const double* before, const double* after, double* row,
                                      std::size_t count) {
  row[0] = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    row[i] = (before[i] - before[i - 1]) - (after[i] - after[i - 1]);
  }
}

WRC_VECTOR_CLONES void fill_differences(const double* values, double* row, std::size_t count) {
  row[0] = 2.0 * values[0];
  for (std::size_t i = 1; i < count; ++i) {
    row[i] = values[i] - values[i - 1];
  }
}

WRC_VECTOR_CLONES void fill_subtracted(const double* from, const double* values, double* row,
                                       std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    row[i] = from[i] - values[i];
  }
}

} // namespace

TractionTable traction_table(double aspect, std::size_t rows, std::size_t columns) {
  TractionTable table{rows, columns, std::vector<double>(3 * rows * columns)};
  std::vector<double> lines(6 * columns);
  double* halves = lines.data();
  double* across = halves + columns;
  double* corners_before = across + columns;
  double* corners = corners_before + columns;
  double* terms_before = corners + columns;
  double* terms = terms_before + columns;
  for (std::size_t i = 0; i < columns; ++i) {
    halves[i] = static_cast<double>(i) + 0.5;
  }
  for (std::size_t row = 0; row < rows; ++row) {
    const double end = (static_cast<double>(row) + 0.5) * aspect;
    std::swap(corners_before, corners);
    std::swap(terms_before, terms);
    fill_corners(halves, end, corners, columns);
    fill_terms_along(end, corners, terms, columns);
    if (row == 0) {
      std::transform(terms, terms + columns, terms_before, std::negate<>());
      std::copy_n(corners, columns, corners_before);
      fill_first_terms_across(halves, aspect, corners, across, columns);
    } else {
      fill_terms_across(halves, aspect, corners_before, corners, across, columns);
    }
    fill_differences(across, table.lateral(row), columns);
    fill_subtracted(terms, terms_before, table.longitudinal(row), columns);
    fill_mixed_row(corners_before, corners, table.mixed(row), columns);
  }
  return table;
}

// The second difference over the element's corners of x atan(y/x) + y ln r and its counterpart. It
// loses some digits far away, which is of no account beside the accuracy of any solution.
CrossTable cross_table(double aspect, std::size_t rows, std::size_t columns) {
  CrossTable table{rows, columns, std::vector<double>(2 * rows * columns)};
  const auto primitive = [](double x, double y) {
    return x * std::atan2(y, x) + 0.5 * y * std::log(x * x + y * y);
  };
  const auto over_element = [](const auto& corner, double x, double y, double half_x,
                               double half_y) {
    return corner(x + half_x, y + half_y) - corner(x - half_x, y + half_y) -
           corner(x + half_x, y - half_y) + corner(x - half_x, y - half_y);
  };
  for (std::size_t row = 0; row < rows; ++row) {
    const double y = static_cast<double>(row) * aspect;
    for (std::size_t i = 0; i < columns; ++i) {
      const auto x = static_cast<double>(i);
      // Either vanishes on its line of symmetry.
      table.longitudinal(row)[i] = i == 0 ? 0.0 : over_element(primitive, x, y, 0.5, 0.5 * aspect);
      table.lateral(row)[i] = row == 0 ? 0.0 : over_element(primitive, y, x, 0.5 * aspect, 0.5);
    }
  }
  return table;
}

TractionTable cross_rate_table(double aspect, std::size_t rows, std::size_t columns) {
  TractionTable table{rows, columns, std::vector<double>(3 * rows * columns)};
  for (std::size_t row = 0; row < rows; ++row) {
    const double left = aspect * (static_cast<double>(row) + 0.5);
    const double right = aspect * (static_cast<double>(row) - 0.5);
    // Integrals across of x/r^2 and y/r^2.
    const auto along = [=](double x) { return std::atan(left / x) - std::atan(right / x); };
    const auto across = [=](double x) {
      return 0.5 * std::log((x * x + left * left) / (x * x + right * right));
    };
    for (std::size_t i = 0; i < columns; ++i) {
      const double ahead = static_cast<double>(i) + 0.5;
      const double behind = static_cast<double>(i) - 0.5;
      table.longitudinal(row)[i] = along(ahead) - along(behind);
      // It vanishes on the lines of symmetry.
      table.mixed(row)[i] = row == 0 || i == 0 ? 0.0 : across(ahead) - across(behind);
    }
  }
  return table;
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
