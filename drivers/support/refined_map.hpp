/// Values of elements on a grid some times as fine, for pictures.
///
/// Pressures are the square roots of p^2 between elements, since p^2 is smooth up to the edge of
/// the contact and passes through 0 there (an ellipse by Hertz is drawn exactly up to rounding).
/// Beyond the last element under pressure p^2 goes on along parabolas, and is 0 at the latest in
/// the middle of the next element.
#pragma once

#include <cstddef>
#include <vector>

namespace driver {

class RefinedMap {
public:
  /// Of a grid with the columns fastest, each at least 2.
  RefinedMap(std::size_t rows, std::size_t columns);

  [[nodiscard]] std::size_t rows() const { return (rows_ - 1) * down_ + 1; }
  [[nodiscard]] std::size_t columns() const { return (columns_ - 1) * on_ + 1; }
  /// Places of the elements, or others that change linearly between them.
  [[nodiscard]] std::vector<double> linear(const std::vector<double>& values) const;
  /// Pressures; 0 outside the contact.
  [[nodiscard]] std::vector<double> pressure(const std::vector<double>& pressure) const;

private:
  template <class WeightsAt>
  [[nodiscard]] std::vector<double> refine(const std::vector<double>& values,
                                           WeightsAt weights) const;

  std::size_t rows_;
  std::size_t columns_;
  std::size_t down_; ///< times as fine from row to row
  std::size_t on_;   ///< from column to column
};

} // namespace driver
