/// Grids of a cascade: from an undeformed distance to coarser ones, and pressures back to finer.
///
/// Coarsening takes the mean distance of 2 x 2 elements. Refining interpolates p^2, which is linear
/// at a smooth edge of contact (p ~ sqrt of the distance from it; Johnson, Contact Mechanics, 1985,
/// eq. 4.27), bilinearly between element centres; outside contact p^2 is extrapolated to negative
/// values, so that the zero line of the interpolated p^2 is the new edge.
/// Order of elements: that of base/grid.hpp. Thread rule: pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"
#include "pressure/squared_pressure.hpp"

namespace wrc {

/// Whether one side is longer than that of the coarsest grid and the other not yet too short to
/// halve.
bool can_coarsen(const LevelSize& size);
LevelSize coarser_size(const LevelSize& size);

/// Means over 2 x 2 elements, in the coarser grid's own unit of length (twice the finer one's). A
/// last row or column without partner is paired with its linear continuation.
void coarsen_distance(const LevelSize& fine, std::span<const double> distance,
                      std::vector<double>& coarse);

/// Means of two rows, of two or more; a last one without partner as for distances.
void coarsen_angles(std::span<const double> angles, std::vector<double>& coarse);

/// Means over 2 x 2 elements; none is negative.
void coarsen_pressure(const LevelSize& fine, std::span<const double> pressure,
                      std::vector<double>& coarse);

/// Values on another grid in the same plane, bilinear between element centres.
void interpolate(const Grid& coarse, std::span<const double> values, const Grid& fine,
                 std::vector<double>& refined);

/// Pressures on another grid in the same plane; none outside the one they are given on.
void refine_pressure(const Grid& coarse, std::span<const double> pressure, const Grid& fine,
                     std::vector<double>& refined);

/// A rectangle of elements; last row and column included.
struct ElementBox {
  std::size_t first_row = 0;
  std::size_t last_row = 0;
  std::size_t first_column = 0;
  std::size_t last_column = 0;

  [[nodiscard]] std::size_t rows() const { return last_row - first_row + 1; }
  [[nodiscard]] std::size_t columns() const { return last_column - first_column + 1; }
  [[nodiscard]] std::size_t count() const { return rows() * columns(); }
  [[nodiscard]] bool holds(std::size_t row, std::size_t column) const {
    return row >= first_row && row <= last_row && column >= first_column && column <= last_column;
  }
};

/// The least box around all elements with pressure, `margin` elements wider where the grid allows.
/// False if there is no pressure.
bool find_pressure_box(const LevelSize& size, std::span<const double> pressure, std::size_t margin,
                       ElementBox& box);

/// A field within a box, and back; what is outside the box stays. `inside` has one value for
/// each element of the box, and takes this size where it is a vector.
void copy_box(const LevelSize& size, const ElementBox& box, std::span<const double> field,
              std::span<double> inside);
void copy_box(const LevelSize& size, const ElementBox& box, std::span<const double> field,
              std::vector<double>& inside);
void put_box(const LevelSize& size, const ElementBox& box, std::span<const double> inside,
             std::span<double> field);

} // namespace wrc
